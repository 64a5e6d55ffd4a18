//! `*CONTACT`: contact between all parts of a model becomes pairs.
//!
//! ```text
//!    inclusions      A with B, A with C, B with C       part by part, each once
//!    - exclusions    A with C                           and what is tied or a pair already: some
//!                                                    faces of both, which still hide what is behind
//!    x properties    A with B: OIL, B with C: DRY       the last that fits, and so where slaves
//!                                                    begin
//! ```

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::Formulation;

use super::lines_left_out::note_lines;
use super::loops::within_reach;
use super::meetings::{Meeting, Parted, Side, outside, part, sides};
use super::own_contact::Alone;
use super::skin::{Patch, Skin};
use crate::draft::Draft;
use crate::log::Target;
use crate::rule::Subject;
use crate::surfaces::{
    Adjusted, Extent, GeneralContact, Named, NamedInteraction, NamedSurface, Pairing, Stretch, Two,
};

/// Ratio of stiffnesses from which on the stiffer part is the master, whatever the meshes [1].
const STIFFER: f64 = 10.0;
/// Difference of distances, a part of them, below which two meshes are as fine: rounding decides
/// no role.
const SAME: f64 = 1e-6;
/// `EXTENSION ZONE` of the pairs, as of `*CONTACT PAIR` [1].
const EXTENSION: f64 = 0.1;

/// Makes pairs of general contact.
pub(super) fn pairings(draft: &mut Draft) {
    let Some(general) = draft.general.take() else { return };
    draft.general_made = Some(general.origin);
    let skin = Skin::of(general.origin, draft);
    note_lines(&general, draft);
    let mut alone = Alone::default();
    let mut meetings: Vec<Meeting> = Vec::new();
    for two in &general.inclusions {
        for meeting in include(two, &skin, &mut alone, draft) {
            let known = meetings.clone();
            meetings.extend(known.iter().fold(vec![meeting], outside));
        }
    }
    let mut meetings: Vec<Parted> = meetings.into_iter().map(Parted::whole).collect();
    for two in general.exclusions.iter().chain(&elsewhere(draft)) {
        let Some(excluded) = sides(two, &skin, draft) else { continue };
        for [first, second] in excluded {
            alone.exclude(&first, &second);
            let by = [first, second];
            meetings = meetings.into_iter().flat_map(|own| own.without(&by)).collect();
        }
    }
    let mut made = Made { general: &general, names: Vec::new(), pairs: HashSet::new(), count: 0 };
    for (interaction, data, meeting) in with_properties(&general, meetings, &skin, draft) {
        let adjust = data.and_then(|named| initialization(&named, draft));
        made.pair((interaction, adjust), meeting, &skin, draft);
    }
    for (interaction, patch) in alone.patches(&general, &skin, draft) {
        made.own_pair(interaction, Side::Faces(patch), &skin, draft);
    }
    if made.count == 0 {
        let message = "this general contact has nothing that could touch";
        let warning = Diagnostic::warning(Code("SL0394"), message).at(general.origin);
        let help = "it is between parts that share no node, and of parts with themselves; *CONTACT \
                    INCLUSIONS names which, ALL EXTERIOR takes all";
        draft.consequence(Subject::Contact, warning.help(help));
    }
}

/// Meetings of an inclusion between parts; what would meet itself is collected.
fn include(two: &Two, skin: &Skin, alone: &mut Alone, draft: &mut Draft) -> Vec<Meeting> {
    let all = sides(two, skin, draft).unwrap_or_default();
    let mut kept: Vec<Meeting> = Vec::new();
    for [first, second] in all {
        match (&first, &second) {
            (Side::Analytical(_), Side::Analytical(_)) => {}
            (Side::Faces(a), Side::Faces(b)) if alone.include((a, b), skin) => {}
            (Side::Faces(a), Side::Faces(b)) if are_one_body(a, b, skin) => {}
            _ if kept.contains(&[second.clone(), first.clone()]) => {}
            _ => kept.push([first, second]),
        }
    }
    kept
}

/// Whether both parts are rigid: nothing can give way.
fn are_one_body(a: &Patch, b: &Patch, skin: &Skin) -> bool {
    let rigid = |patch| part(patch, skin).is_some_and(|part| skin.parts[part].body.is_some());
    rigid(a) && rigid(b)
}

/// Surfaces that are tied, or a pair of their own: general contact leaves them to that.
fn elsewhere(draft: &Draft) -> Vec<Two> {
    let ties = draft.ties.iter().map(|tie| (&tie.slave, &tie.master));
    let pairs = draft.pairings.iter().map(|pair| (&pair.slave, &pair.master));
    let of_faces = |named: &Named| {
        let same = |surface: &&NamedSurface| surface.named.name == named.name;
        let found = draft.named_surfaces.iter().find(same);
        found.is_some_and(|surface| !matches!(surface.extent, Extent::Nodes(_)))
    };
    ties.chain(pairs)
        .filter(|(slave, master)| of_faces(slave) && of_faces(master))
        .map(|(slave, master)| Two { first: Some(slave.clone()), second: Some(master.clone()) })
        .collect()
}

/// A meeting with the names that the last lines that fit give it: interaction and initialization;
/// `None` without.
type Assigned = (Option<Named>, Option<Named>, Parted);

fn with_properties(
    general: &GeneralContact,
    meetings: Vec<Parted>,
    skin: &Skin,
    draft: &mut Draft,
) -> Vec<Assigned> {
    let meetings = meetings.into_iter().map(|own| ((), own)).collect();
    let with = cut_by(&general.properties, meetings, skin, draft);
    let with = with.into_iter().map(|((), interaction, meeting)| (interaction, meeting)).collect();
    cut_by(&general.initializations, with, skin, draft)
}

/// Meetings cut by the lines that fit them, the last line first; each with what it had and with the
/// name of its line.
fn cut_by<K: Clone>(
    lines: &[(Two, Named)],
    meetings: Vec<(K, Parted)>,
    skin: &Skin,
    draft: &mut Draft,
) -> Vec<(K, Option<Named>, Parted)> {
    let (mut found, mut left) = (Vec::new(), meetings);
    for (two, named) in lines.iter().rev() {
        let everywhere = two.first.is_none() && two.second.is_none();
        if everywhere {
            found.extend(left.drain(..).map(|(own, meeting)| (own, Some(named.clone()), meeting)));
            break;
        }
        for by in sides(two, skin, draft).unwrap_or_default() {
            let turned = [by[1].clone(), by[0].clone()];
            for by in [by, turned] {
                let mut rest = Vec::new();
                for (own, meeting) in left {
                    let (inside, others) = meeting.cut(&by);
                    let inside = inside.map(|inside| (own.clone(), Some(named.clone()), inside));
                    found.extend(inside);
                    rest.extend(others.into_iter().map(|other| (own.clone(), other)));
                }
                left = rest;
            }
        }
    }
    found.extend(left.into_iter().map(|(own, meeting)| (own, None, meeting)));
    found
}

/// The `*CONTACT INITIALIZATION DATA` of that name; complains where there is none.
fn initialization(named: &Named, draft: &mut Draft) -> Option<(Adjusted, Span)> {
    let found = draft.initializations.iter().find(|data| data.named.name == named.name);
    let found = found.map(|data| (data.adjusted.clone(), named.span));
    if found.is_none() {
        let message =
            format!("there is no *CONTACT INITIALIZATION DATA of the name {}", named.name);
        let error = Diagnostic::error(Code("SL0328"), message).at(named.span);
        let names = draft.initializations.iter().map(|data| data.named.name.as_str());
        let help = match slideline_deck::nearest(&named.name, names) {
            Some(near) => format!("did you mean {near}?"),
            None => format!("define it: *CONTACT INITIALIZATION DATA, NAME={}", named.name),
        };
        draft.consequence(Subject::Contact, error.help(help));
    }
    found
}

/// The surfaces and pairs that are made.
struct Made<'a> {
    general: &'a GeneralContact,
    names: Vec<(Side, String)>,
    /// Names of slave and master of the pairs between parts.
    pairs: HashSet<[String; 2]>,
    count: usize,
}

impl Made<'_> {
    /// Makes the pairs of a meeting; its roles follow from stiffness and mesh.
    fn pair(
        &mut self,
        (interaction, adjust): (Option<Named>, Option<(Adjusted, Span)>),
        meeting: Parted,
        skin: &Skin,
        draft: &mut Draft,
    ) {
        let (turned, why) = roles(&meeting.whole, skin, draft);
        let ([slave, master], left_out) = meeting.between(turned, skin);
        let both = match (slave, master) {
            (Side::Faces(slave), Side::Faces(master)) if !draft.model.is_in_space() => {
                let both = within_reach((&slave, &master), skin, draft).into_iter();
                both.map(|(slave, master)| (Side::Faces(slave), Side::Faces(master))).collect()
            }
            both => vec![both],
        };
        let interaction = interaction.unwrap_or_else(|| self.plain(draft));
        for (slave, master) in both {
            let known = self.surface(slave.clone(), skin, draft);
            let master = self.surface(master, skin, draft);
            // lines of properties give the same slaves and the same whole master more than once
            let is_new = self.pairs.insert([known.name.clone(), master.name.clone()]);
            let slave = match &slave {
                Side::Faces(patch) if !is_new => self.another(patch, skin, draft),
                _ => known.clone(),
            };
            let message = format!("general contact: {} on {}, {why}", slave.name, master.name);
            let note = Diagnostic::note(Code("SL0395"), message).at(self.general.origin);
            draft.log.push(note);
            self.count += 1;
            let names = (slave.clone(), master);
            let own = self.pairing(names, (interaction.clone(), adjust.clone()), draft);
            draft.pairings.push(Pairing { left_out: left_out.clone(), ..own });
        }
    }

    /// Makes the pair of a part that meets itself.
    fn own_pair(&mut self, interaction: Option<Named>, side: Side, skin: &Skin, draft: &mut Draft) {
        let interaction = interaction.unwrap_or_else(|| self.plain(draft));
        let own = self.surface(side, skin, draft);
        let own = self.pairing((own.clone(), own), (interaction, None), draft);
        draft.pairings.push(Pairing { alone: true, ..own });
        self.count += 1;
    }

    /// A pair of these names.
    fn pairing(
        &self,
        (slave, master): (Named, Named),
        (interaction, adjust): (Named, Option<(Adjusted, Span)>),
        draft: &Draft,
    ) -> Pairing {
        let formulation = match draft.model.is_in_space() || slave.name == master.name {
            true => Formulation::NodeToSurface,
            false => Formulation::SurfaceToSurface,
        };
        Pairing {
            slave,
            master,
            interaction,
            formulation,
            smooth: None,
            extension: EXTENSION,
            chain_parameter: None,
            adjust,
            no_thickness: true,
            is_tied: false,
            axes: [None, None],
            left_out: Vec::new(),
            alone: false,
            origin: self.general.origin,
        }
    }

    /// Hard contact without friction, where no property is given.
    fn plain(&self, draft: &mut Draft) -> Named {
        let named = Named { name: "GENERAL CONTACT".to_owned(), span: self.general.origin };
        let known = draft.interactions.iter().any(|entry| entry.named.name == named.name);
        if !known {
            let own = NamedInteraction::plain(named.clone());
            draft.interactions.push(own);
        }
        named
    }

    /// The surface of a side, by the name of its part.
    fn surface(&mut self, side: Side, skin: &Skin, draft: &mut Draft) -> Named {
        let span = self.general.origin;
        let patch = match &side {
            Side::Analytical(name) => return Named { name: name.clone(), span },
            Side::Faces(patch) => patch,
        };
        if let Some((_, name)) = self.names.iter().find(|(known, _)| *known == side) {
            return Named { name: name.clone(), span };
        }
        let named = self.another(patch, skin, draft);
        self.names.push((side, named.name.clone()));
        named
    }

    /// A surface of these faces with a name of its own.
    fn another(&self, patch: &Patch, skin: &Skin, draft: &mut Draft) -> Named {
        let span = self.general.origin;
        let own = part(patch, skin).map_or("", |part| skin.parts[part].name.as_str());
        let taken =
            |name: &str| draft.named_surfaces.iter().any(|surface| surface.named.name == name);
        let mut names = (1..).map(|number| match number {
            1 => own.to_owned(),
            _ => format!("{own}:{number}"),
        });
        let name = names.find(|name| !taken(name)).unwrap_or_default();
        let stretches = patch.iter().map(|&face| stretch(&skin.faces[face], span, draft)).collect();
        let named = Named { name: name.clone(), span };
        let extent = Extent::Elements(stretches);
        let surface = NamedSurface { named: named.clone(), extent, areas: None, origin: span };
        draft.named_surfaces.push(surface);
        named
    }
}

fn stretch(face: &super::faces::SolidFace, span: Span, draft: &Draft) -> Stretch {
    let elements = Target::Label(draft.elements[face.element].label);
    Stretch { elements, span, side: None, face: face.face }
}

/// Whether the second side is the slave, and why.
fn roles([first, second]: &Meeting, skin: &Skin, draft: &Draft) -> (bool, &'static str) {
    let (on_a, on_b) = match (first, second) {
        (Side::Analytical(_), _) => return (true, "which is analytical"),
        (_, Side::Analytical(_)) => return (false, "which is analytical"),
        (Side::Faces(a), Side::Faces(b)) => (a, b),
    };
    let (Some(a), Some(b)) = (part(on_a, skin), part(on_b, skin)) else {
        return (false, "as they come");
    };
    let (a, b) = (&skin.parts[a], &skin.parts[b]);
    match (a.body.is_some(), b.body.is_some()) {
        (true, false) => (true, "which is rigid"),
        (false, true) => (false, "which is rigid"),
        _ if a.stiffness > STIFFER * b.stiffness => (true, "which is stiffer"),
        _ if b.stiffness > STIFFER * a.stiffness => (false, "which is stiffer"),
        _ => {
            let [own, other] = [on_a, on_b].map(|patch| skin.spacing(patch, draft));
            (other < own * (1.0 - SAME), "whose mesh is no finer")
        }
    }
}
