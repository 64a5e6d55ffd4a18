//! `*SURFACE`: a named surface.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::Dialect;

use super::{rigid_surface, swept_surface};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::{Extent, NamedSurface, Side, Stretch};

/// `*SURFACE`.
pub(crate) struct Surface;

impl Keyword for Surface {
    fn name(&self) -> &'static str {
        "SURFACE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("NAME"),
            Rule::value("TYPE"),
            Rule::value("FILLET RADIUS"),
            Rule::value("COMBINE"),
            Rule::flag("INTERNAL"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("SURFACE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(named) = card.named("NAME") else { return };
        let kinds = &["ELEMENT", "NODE", "SEGMENTS", "CYLINDER", "REVOLUTION"];
        let kind = card.choice("TYPE", kinds, &mut draft.log);
        let is_nodal = kind == Some("NODE");
        let own = |old: &NamedSurface| old.named.name == named.name;
        let old = draft.named_surfaces.iter().position(own);
        if let Some(old) = old.filter(|&old| is_twin(is_nodal, old, draft)) {
            if is_nodal {
                return;
            }
            draft.named_surfaces.remove(old);
        } else if let Some(old) = old.filter(|&old| is_extended(kind, old, draft)) {
            extend(old, card, draft);
            return;
        } else if let Some(old) = old.and_then(|old| draft.named_surfaces.get(old)) {
            let message = format!("the surface {} is defined twice", named.name);
            let error = Diagnostic::error(Code("SL0250"), message).at(named.span);
            draft.log.push(error.label(old.origin, "defined here first"));
        }
        if card.has("TYPE") && kind.is_none() {
            return;
        }
        let extent = match kind {
            _ if card.has("COMBINE") => combined(card, draft),
            Some("SEGMENTS") => rigid_surface::segments(card, draft)
                .map(|(start, segments)| Extent::Rigid { start, segments }),
            Some("CYLINDER") => swept_surface::drawn_along(card, draft),
            Some("REVOLUTION") => swept_surface::turned_about(card, draft),
            Some("NODE") => nodes(card, draft),
            _ => elements(card, draft),
        };
        if let Some(extent) = extent {
            let areas = matches!(extent, Extent::Nodes(_)).then(|| areas(card, draft)).flatten();
            draft.named_surfaces.push(NamedSurface { named, extent, areas, origin: card.span() });
        }
    }
}

/// Whether a surface is the same as an earlier one of its name, once of nodes and once of faces: in
/// CalculiX both have names of their own, and what faces say holds for their nodes.
fn is_twin(is_nodal: bool, old: usize, draft: &Draft) -> bool {
    let other = draft.named_surfaces.get(old).map(|old| matches!(old.extent, Extent::Nodes(_)));
    draft.dialect == Dialect::Calculix && other == Some(!is_nodal)
}

/// Whether a second card adds faces to a surface, as it does in CalculiX (measured with ccx 2.20).
fn is_extended(kind: Option<&str>, old: usize, draft: &Draft) -> bool {
    let old = draft.named_surfaces.get(old);
    draft.dialect == Dialect::Calculix
        && matches!(kind, None | Some("ELEMENT"))
        && old.is_some_and(|old| matches!(old.extent, Extent::Elements(_)))
}

fn extend(old: usize, card: &Reading<'_>, draft: &mut Draft) {
    let Some(Extent::Elements(further)) = elements(card, draft) else { return };
    let old = draft.named_surfaces.get_mut(old);
    if let Some(NamedSurface { extent: Extent::Elements(stretches), .. }) = old {
        stretches.extend(further);
    }
}

fn without_fillets(card: &Reading<'_>, draft: &mut Draft) {
    if card.has("FILLET RADIUS") {
        let message = "FILLET RADIUS belongs to TYPE=SEGMENTS, CYLINDER and REVOLUTION";
        draft.log.error("SL0215", message, card.span_of("FILLET RADIUS"));
    }
}

/// A surface of nothing harms nobody until a contact names it.
fn note_empty(card: &Reading<'_>, draft: &mut Draft) {
    if card.data().is_empty() {
        draft.log.note("SL0257", "this *SURFACE is empty and is ignored", card.span());
    }
}

/// Lines of `element set or element, face`.
fn elements(card: &Reading<'_>, draft: &mut Draft) -> Option<Extent> {
    without_fillets(card, draft);
    note_empty(card, draft);
    let mut stretches = Vec::new();
    for line in card.data() {
        draft.log.at_most(line, 2);
        let elements = draft.log.target(line, 0, "the element set");
        let (side, face) = match face(line) {
            Some(face) => (Some(None), Some(face)),
            None => (side(card, line, draft), None),
        };
        let Some((elements, side)) = elements.zip(side) else { continue };
        stretches.push(Stretch { elements, span: line.fields[0].span, side, face });
    }
    Some(Extent::Elements(stretches))
}

/// The face named by a line: `Some(None)` where there is no label, `None`
/// after an error.
fn side(card: &Reading<'_>, line: &DataLine, draft: &mut Draft) -> Option<Option<Side>> {
    let Some(field) = line.field(1) else { return Some(None) };
    match normalise(&field.text).as_str() {
        "SPOS" => Some(Some(Side::Positive)),
        "SNEG" => Some(Some(Side::Negative)),
        _ => {
            let key = format!("face {} {}", card.span().start, normalise(&field.text));
            if !draft.log.first_time(&key) {
                return None;
            }
            let message = format!("`{}` is not a face", field.text);
            let error = Diagnostic::error(Code("SL0256"), message).at(field.span);
            draft.log.push(error.help(
                "S1 to S6 are faces of solids; of a beam SPOS is the face 90 degrees \
                 counter-clockwise of the element's direction, SNEG the other one",
            ));
            None
        }
    }
}

/// The face of a solid, `S1` to `S6`, from 0.
pub(super) fn face(line: &DataLine) -> Option<usize> {
    let name = normalise(&line.field(1)?.text);
    let number: usize = name.strip_prefix('S')?.parse().ok()?;
    (1..=6).contains(&number).then(|| number - 1)
}

/// Lines of `node set or node`.
fn nodes(card: &Reading<'_>, draft: &mut Draft) -> Option<Extent> {
    without_fillets(card, draft);
    note_empty(card, draft);
    let mut nodes = Vec::new();
    for line in card.data() {
        draft.log.at_most(line, 2);
        let target = draft.log.target(line, 0, "the node set");
        nodes.extend(target.map(|target| (target, line.fields[0].span)));
    }
    Some(Extent::Nodes(nodes))
}

/// Surfaces that were defined before, taken together.
fn combined(card: &Reading<'_>, draft: &mut Draft) -> Option<Extent> {
    without_fillets(card, draft);
    if card.choice("COMBINE", &["UNION", "DIFFERENCE", "INTERSECTION"], &mut draft.log)? != "UNION"
    {
        let message = "COMBINE of *SURFACE other than UNION is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of("COMBINE"));
        let help = "name the faces themselves, with S1 to S6 or a set of elements";
        draft.consequence(Subject::Contact, error.help(help));
        return None;
    }
    let mut whole: Option<Extent> = None;
    for field in card.data().iter().flat_map(|line| &line.fields) {
        let name = normalise(&field.text);
        if name.is_empty() {
            continue;
        }
        let Some(part) = draft.named_surfaces.iter().find(|old| old.named.name == name) else {
            let message = format!("there is no surface {} in front of this card", field.text);
            let error = Diagnostic::error(Code("SL0327"), message).at(field.span);
            draft.consequence(Subject::Contact, error.help("define it by a *SURFACE before"));
            return None;
        };
        match (&mut whole, part.extent.clone()) {
            (None, part @ (Extent::Elements(_) | Extent::Nodes(_))) => whole = Some(part),
            (Some(Extent::Elements(all)), Extent::Elements(part)) => all.extend(part),
            (Some(Extent::Nodes(all)), Extent::Nodes(part)) => all.extend(part),
            _ => {
                let message =
                    format!("the surface {} is of another kind than the first", field.text);
                let error = Diagnostic::error(Code("SL0332"), message).at(field.span);
                let help = "a union is of faces alone or of nodes alone";
                draft.consequence(Subject::Contact, error.help(help));
                return None;
            }
        }
    }
    note_empty(card, draft);
    Some(whole.unwrap_or_else(|| Extent::Elements(Vec::new())))
}

/// Where a card gives areas of nodes: CAE programs write 1 wherever a set of nodes is made a
/// surface. They mean something in contact alone, and there with laws of pressure alone.
fn areas(card: &Reading<'_>, draft: &mut Draft) -> Option<Span> {
    let mut first = None;
    for line in card.data() {
        let Some(field) = line.field(1) else { continue };
        if draft.log.number_or(line, 1, 1.0)? <= 0.0 {
            draft.log.error("SL0210", "the area of a node must be positive", field.span);
            return None;
        }
        first = first.or(Some(field.span));
    }
    first
}
