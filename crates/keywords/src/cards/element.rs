//! `*ELEMENT`: elements and contact elements.

use slideline_deck::{DataLine, Field, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::Dialect;

use crate::draft;
use crate::draft::Draft;
use crate::draft::ElementKind;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::log::Target;
use crate::reading::Reading;
use crate::sets::Item;

/// `*ELEMENT`.
pub(crate) struct Element;

impl Keyword for Element {
    fn name(&self) -> &'static str {
        "ELEMENT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::required("TYPE"), Rule::value("ELSET"), Rule::value("INPUT")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Elements
    }

    fn page(&self) -> &'static str {
        page!("ELEMENT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(kind) = kind(card, draft) else { return };
        let set = card.name("ELSET");
        if let Some(set) = &set {
            draft.element_sets.open(set, card.span());
        }
        draft.note_spatial(kind);
        if kind.is_dynamic() && draft.log.first_time(&format!("inert {}", kind.name())) {
            let but = if kind.is_mass() { " but their weight" } else { "" };
            let message = format!("{} elements have no effect in a static step{but}", kind.name());
            draft.log.note("SL0257", message, card.span_of("TYPE"));
        }
        let mut lines = card.data().iter();
        while let Some(line) = lines.next() {
            let mut fields: Vec<&Field> = line.fields.iter().collect();
            let mut last = line;
            while continues(last, &fields, kind) {
                let Some(next) = lines.next() else { break };
                fields.extend(&next.fields);
                last = next;
            }
            let Some(element) = element(line, &fields, kind, draft) else { continue };
            if let Some(set) = &set {
                draft.element_sets.join(set, Item::One(element.label), line.span);
            }
            draft.add_element(element);
        }
    }
}

/// Whether the nodes of an element go on in the next line: they are too few, and the line ends
/// with a comma or could not hold them all.
fn continues(line: &DataLine, fields: &[&Field], kind: ElementKind) -> bool {
    let given = fields.iter().filter(|field| !field.text.is_empty()).count();
    given < kind.node_count() + 1
        && (line.text.ends_with(',') || kind.node_count() >= slideline_deck::MAX_VALUES_PER_LINE)
}

/// CalculiX' decks may give its incompatible modes nodes of their own, which it does not read.
fn surplus(line: &DataLine, draft: &mut Draft) {
    if draft.log.first_time("nodes of incompatible modes") {
        let message = "the nodes of a C3D8I behind the eighth are not used";
        draft.log.note("SL0253", message, line.span);
    }
}

fn kind(card: &Reading<'_>, draft: &mut Draft) -> Option<ElementKind> {
    let name = card.name("TYPE")?;
    let own = ElementKind::all().find(|kind| kind.is_called(&name));
    let found = own.or_else(|| by_other_name(card, &name, draft));
    if found.is_none() {
        draft.mark_incomplete(Subject::Elements);
    }
    if found.is_none() && draft.log.first_time(&format!("element type {name}")) {
        let message = format!("elements of type {name} are not supported");
        let known: Vec<&str> = ElementKind::all().map(ElementKind::name).collect();
        let error = Diagnostic::error(Code("SL0220"), message).at(card.span_of("TYPE"));
        let help = format!("supported: {}", known.join(", "));
        draft.log.push(error.help(help));
    }
    found
}

/// A type of another program that is one of these by another name, which a note says.
fn by_other_name(card: &Reading<'_>, name: &str, draft: &mut Draft) -> Option<ElementKind> {
    let (row, why) = slideline_model::read_as(name)?;
    if draft.log.first_time(&format!("element type {name}")) {
        let message = format!("{name} is read as {}: {why}", row.name());
        draft.log.note("SL0253", message, card.span_of("TYPE"));
    }
    Some(ElementKind::Structural(row))
}

fn element(
    line: &DataLine,
    fields: &[&Field],
    kind: ElementKind,
    draft: &mut Draft,
) -> Option<draft::Element> {
    let label = draft.log.label(line, 0, "the element number")?;
    let count = kind.node_count();
    let given = fields.iter().skip(1).filter(|field| !field.text.is_empty());
    let mut given: Vec<&&Field> = given.collect();
    if given.len() > count && kind.name() == "C3D8I" && draft.dialect == Dialect::Calculix {
        surplus(line, draft);
        given.truncate(count);
    }
    let may_point = kind.is_space_beam() && draft.dialect == Dialect::Abaqus;
    let pointing = usize::from(may_point && given.len() == count + 1);
    if given.len() != count + pointing {
        let nodes = if count == 1 { "node" } else { "nodes" };
        let here = given.len();
        let message = format!("a {} element has {count} {nodes}, here are {here}", kind.name());
        draft.log.error("SL0231", message, line.span);
        return None;
    }
    let mut nodes = [0; draft::MOST_NODES];
    for (node, field) in nodes.iter_mut().zip(given) {
        *node = node_in(field, draft)?;
    }
    Some(draft::Element { label, kind, nodes, origin: line.span })
}

/// A node by its number, or by that of an instance: `ARM-1.12`, as springs between parts name it.
fn node_in(field: &Field, draft: &mut Draft) -> Option<u64> {
    if !field.text.contains('.') {
        return draft.log.label_in(field);
    }
    match draft.log.instances.target(normalise(&field.text)) {
        Target::Label(label) => Some(label),
        Target::Set(_) => draft.log.label_in(field),
    }
}
