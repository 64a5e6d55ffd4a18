//! What cards name, looked up among all that the deck defines; what is missing is said once.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::NodeIndex;

use super::unknown::{nodes_of_elements, unknown_set};
use crate::draft::{Draft, Element};
use crate::log::Target;
use crate::rule::Subject;

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
    pub(super) fn nodes_of(&mut self, target: &Target, span: Span) -> Vec<NodeIndex> {
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
                    let error = unknown_set("node", set, span, names);
                    if self.element_sets.contains(set) {
                        error.help(nodes_of_elements(set))
                    } else {
                        error
                    }
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
    pub(super) fn elements_of(&mut self, set: &str, span: Span) -> Option<Vec<usize>> {
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

    /// The elements of a set, or the one of that number, by their places; none where undefined, which
    /// is reported.
    pub(super) fn elements_at(&mut self, target: &Target, span: Span) -> Vec<usize> {
        match target {
            Target::Set(set) => self.elements_of(set, span).unwrap_or_default(),
            Target::Label(label) => self.element_at(*label, span).into_iter().collect(),
        }
    }

    /// The element of that number, by its place; `None` where undefined, which is reported.
    pub(super) fn element_at(&mut self, label: u64, span: Span) -> Option<usize> {
        let found = self.element_by_label.get(&label).copied();
        if found.is_none() {
            let message = format!("element {label} is not defined");
            let error = Diagnostic::error(Code("SL0308"), message).at(span);
            self.consequence(Subject::Elements, error);
        }
        found
    }

    /// Places of the first two nodes of an element; `None` where undefined,
    /// which has been reported.
    pub(super) fn ends_of(&self, element: &Element) -> Option<[NodeIndex; 2]> {
        let [a, b, ..] = element.nodes;
        Some([self.model.nodes.find(a)?, self.model.nodes.find(b)?])
    }

    /// Complains about an element whose two nodes coincide; true if so.
    pub(super) fn has_no_length(&mut self, element: &Element, [a, b]: [NodeIndex; 2]) -> bool {
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

    /// Whether both follow one curve, or none; a curve over the total time is known by its name.
    pub(super) fn same_curve(&self, one: Option<usize>, other: Option<usize>) -> bool {
        let name = |place: Option<usize>| {
            place.and_then(|place| self.model.amplitudes.get(place)).map(|own| &own.name)
        };
        name(one) == name(other)
    }
}
