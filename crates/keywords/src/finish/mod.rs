//! What can be said only when the whole deck is known: references by name,
//! and whether the parts make a model.

mod axes;
mod chain;
mod contact;
mod distributed;
mod distributing;
mod equations;
mod faces;
mod line_loads;
mod links;
mod master_chain;
mod materials;
mod nodes;
mod orientations;
mod pre_tension;
mod resting;
mod rubber;
mod sections;
mod shape_mpc;
mod space_beams;
mod springs;
mod standing;
mod steps;
mod surface_pairs;
mod surfaces;
mod temperatures;
mod ties;
mod unknown;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Model, NodeIndex};
pub(crate) use unknown::unknown_set;

use crate::draft::{Draft, Element};
use crate::log::Target;
use crate::parts::renumber;
use crate::rule::Subject;

/// Completes the model. `steps_doubted`: a step has been asked for already,
/// or there are no cards at all.
pub(crate) fn finish(draft: &mut Draft, steps_doubted: bool) -> Model {
    draft.end_parts();
    nodes::sets(draft);
    nodes::elements(draft);
    let parted = pre_tension::cut(draft);
    rubber::rubbers(draft);
    sections::sections(draft);
    springs::springs(draft);
    faces::check(draft);
    axes::transforms(draft);
    contact::pairs(draft);
    surface_pairs::pairs(draft);
    pre_tension::tie(&parted, draft);
    links::links(draft);
    temperatures::initial(draft);
    steps::steps(draft, steps_doubted);
    temperatures::beams_in_space(draft);
    renumber(&mut draft.model);
    std::mem::take(&mut draft.model)
}

impl Draft {
    /// Reports an error unless the subject it rests on is known to be
    /// incomplete, and once for each place.
    pub(crate) fn consequence(&mut self, subject: Subject, error: Diagnostic) {
        let at = error.span.unwrap_or_default();
        let key = format!("{} {} {}", error.code, at.file.0, at.start);
        if self.is_complete(subject) && self.log.first_time(&key) {
            self.log.push(error);
        }
    }

    /// The nodes a number or set stands for; complains where there are none.
    fn nodes_of(&mut self, target: &Target, span: Span) -> Vec<NodeIndex> {
        if self.has_expanded_all() {
            return Vec::new();
        }
        let labels = match target {
            Target::Label(label) => {
                if self.model.nodes.find(*label).is_none() {
                    let message = format!("node {label} is not defined");
                    let error = Diagnostic::error(Code("SL0304"), message).at(span);
                    self.consequence(Subject::Nodes, error);
                }
                vec![*label]
            }
            Target::Set(set) => self.node_sets.labels(set).unwrap_or_else(|| {
                let error = {
                    let names = self.node_sets.names().take(self.log.names_to_compare());
                    unknown_set("node", set, span, names)
                };
                self.consequence(Subject::Nodes, error);
                Vec::new()
            }),
        };
        if !self.expand(labels.len(), span) {
            return Vec::new();
        }
        labels.into_iter().filter_map(|label| self.model.nodes.find(label)).collect()
    }

    /// The elements of a set that exist; complains about an unknown set.
    fn elements_of(&mut self, set: &str, span: Span) -> Option<Vec<usize>> {
        if self.has_expanded_all() {
            return None;
        }
        let Some(labels) = self.element_sets.labels(set) else {
            let names = self.element_sets.names().take(self.log.names_to_compare());
            let error = unknown_set("element", set, span, names);
            self.consequence(Subject::Elements, error);
            return None;
        };
        if !self.expand(labels.len(), span) {
            return None;
        }
        Some(labels.iter().filter_map(|label| self.element_by_label.get(label).copied()).collect())
    }

    /// Places of the first two nodes of an element; `None` where undefined,
    /// which has been reported.
    fn ends_of(&self, element: &Element) -> Option<[NodeIndex; 2]> {
        let [a, b, ..] = element.nodes;
        Some([self.model.nodes.find(a)?, self.model.nodes.find(b)?])
    }

    /// Complains about an element whose two nodes coincide; true if so.
    fn has_no_length(&mut self, element: &Element, [a, b]: [NodeIndex; 2]) -> bool {
        let zero = self.model.nodes.position(a) == self.model.nodes.position(b);
        if zero {
            let message = format!(
                "element {} has no length: nodes {} and {} coincide",
                element.label,
                self.model.nodes.label(a),
                self.model.nodes.label(b)
            );
            let error = Diagnostic::error(Code("SL0306"), message).at(element.origin);
            self.consequence(Subject::Nodes, error);
        }
        zero
    }
}
