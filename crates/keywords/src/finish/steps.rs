//! Steps: what the lines of `*BOUNDARY` and `*CLOAD` mean for each node, and
//! what a step takes over from the one before.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{
    Controls, Dof, Load, NodalTemperature, NodeIndex, Numbered, NumberedSet, OutputRequests,
    Passage, Prescribed, Static, Step,
};

use super::amplitudes::amplitude;
use super::changed_sections::ChangedSections;
use super::frictions::Frictions;
use super::interferences::interferences;
use super::model_changes::Absent;
use super::pressures::Pressures;
use super::standing::{Curved, InForce, Standing};
use super::{perturbation, requests, resting, temperatures};
use crate::draft::{Boundary, Draft, StepDraft};
use crate::rule::Subject;

/// What passes from step to step.
#[derive(Default)]
struct Carried {
    prescribed: InForce<Prescribed, (NodeIndex, Dof)>,
    loads: Standing<(NodeIndex, Dof), Load>,
    temperatures: InForce<NodalTemperature, NodeIndex>,
    distributed: resting::InForce,
    absent: Absent,
    frictions: Frictions,
    pressures: Pressures,
    sections: ChangedSections,
    controls: Controls,
    output: OutputRequests,
}

impl Carried {
    /// What a further step copies.
    fn size(&self) -> usize {
        let printed = requests::size(&self.output);
        let temperatures = self.temperatures.list.len();
        let loads = self.loads.len() + self.distributed.size();
        let laws = self.frictions.size() + self.pressures.size() + self.sections.size();
        let loads = loads + self.absent.size() + laws;
        self.prescribed.list.len() + loads + temperatures + printed
    }
}

impl Carried {
    /// Values that stand, but for temperatures, with their amplitudes.
    fn values(&mut self) -> impl Iterator<Item = (&mut f64, &mut Option<usize>)> {
        let prescribed = self.prescribed.list.iter_mut();
        let prescribed = prescribed.map(|own| (&mut own.value, &mut own.amplitude));
        let loads = self.loads.iter_mut().map(|own| (&mut own.value, &mut own.amplitude));
        prescribed.chain(loads).chain(self.distributed.values())
    }
}

impl Curved for Load {
    fn amplitude(&self) -> Option<usize> {
        self.amplitude
    }
}

pub(super) fn steps(draft: &mut Draft, doubted: bool) {
    presence(draft, doubted);
    let mut carried = Carried {
        output: OutputRequests { restart: draft.restart, ..OutputRequests::default() },
        ..Carried::default()
    };
    supports_of_all(&mut carried, draft);
    draft.large = draft.steps.iter().any(|step| step.nlgeom);
    let mut was_alone = false;
    for step in std::mem::take(&mut draft.steps) {
        perturbation::check((&step, was_alone), draft);
        was_alone = step.perturbation.is_some();
        let before: f64 = draft.model.steps.iter().map(|step| step.procedure.period).sum();
        over_total_time(before, &mut carried, draft);
        if !draft.expand(carried.size(), step.origin) {
            break;
        }
        let finished = finish(step, &mut carried, draft);
        carried.loads.pass();
        carried.distributed.pass();
        settle(&mut carried, &finished, draft);
        draft.model.steps.push(finished);
    }
}

/// What is prescribed before the first step.
fn supports_of_all(carried: &mut Carried, draft: &mut Draft) {
    for line in draft.initial.clone() {
        prescribe(&line, &mut carried.prescribed, draft);
    }
}

/// There must be a step, and it must be closed.
fn presence(draft: &mut Draft, doubted: bool) {
    let Some(last) = draft.steps.last() else {
        if !doubted && draft.is_complete(Subject::Steps) {
            let error = Diagnostic::error(Code("SL0301"), "the deck has no *STEP: nothing happens");
            let origin = draft.model.nodes.iter().next().map(|node| node.origin);
            let help = "end the deck with *STEP, *STATIC, *BOUNDARY ... *END STEP";
            draft.log.push(error.at(origin).help(help));
        }
        return;
    };
    if draft.earlier_steps == draft.steps.len() && !doubted {
        let message = "the deck has no *STEP: nothing is added to the job it goes on from";
        let error = Diagnostic::error(Code("SL0301"), message).at(last.origin);
        draft.log.push(error.help("end the deck with *STEP, *STATIC, *BOUNDARY ... *END STEP"));
        return;
    }
    if draft.in_step {
        let error = Diagnostic::error(Code("SL0302"), "this step has no *END STEP");
        let error = error.at(last.origin).help("add *END STEP as the last line of the deck");
        draft.log.push(error);
    }
}

/// SL0247: of no weight where nothing touches; whether something turns far the run shows.
fn linear(step: &StepDraft, draft: &mut Draft) {
    if step.nlgeom {
        return;
    }
    let said = if draft.model.contact_pairs.is_empty() {
        Diagnostic::note(Code("SL0247"), "without NLGEOM the kinematics are linear")
    } else {
        let message = "without NLGEOM the kinematics are linear; contact stays nonlinear";
        Diagnostic::warning(Code("SL0247"), message)
    };
    let said = said.at(step.origin).help("write *STEP, NLGEOM for large rotations and sliding");
    draft.log.push(said);
}

/// What a step prescribes beside what stands.
fn supports(step: &StepDraft, carried: &mut Carried, draft: &mut Draft) {
    let alone = step.perturbation.is_some() && !draft.model.steps.is_empty();
    if step.new_boundary || alone {
        carried.prescribed = InForce::default();
    }
    if alone && !step.new_boundary {
        supports_of_all(carried, draft);
    }
    for line in &step.boundary {
        prescribe(line, &mut carried.prescribed, draft);
    }
}

fn finish(step: StepDraft, carried: &mut Carried, draft: &mut Draft) -> Step {
    linear(&step, draft);
    // what passes time has its loads at once unless it says otherwise, in both dialects
    let passes = step.procedure.is_some_and(|own| own.passage == Passage::Passing);
    let at_once = step.at_once.unwrap_or(passes);
    supports(&step, carried, draft);
    if step.new_loads {
        carried.loads.remove(|_| true);
    }
    carried.loads.take(loads(&step.loads, draft));
    let presence = carried.absent.change(&step, draft);
    let sections = carried.sections.change(&step, draft);
    let pressures = carried.pressures.change(&step, &mut carried.frictions, draft);
    let frictions = carried.frictions.change(&step, draft);
    let interferences = interferences(&step, draft);
    heat(&step, carried, draft);
    distribute(&step, carried, draft);
    carried.controls = step.controls.unwrap_or(carried.controls);
    requests::renew(&mut carried.output, &step, draft);
    let default = Static {
        initial: 1.0,
        period: 1.0,
        minimum: 1e-5,
        maximum: 1.0,
        direct: false,
        passage: Passage::default(),
        creep_tolerance: None,
        origin: None,
    };
    let loads = concentrated(&mut carried.loads, at_once, draft);
    carried.absent.loads(&presence, &loads, draft);
    Step {
        title: step.title,
        nlgeom: step.nlgeom,
        max_increments: step.max_increments,
        unsymmetric: step.unsymmetric,
        extrapolation: step.extrapolation,
        at_once,
        procedure: step.procedure.unwrap_or(default),
        prescribed: carried.prescribed.list.clone(),
        loads,
        temperatures: carried.temperatures.list.clone(),
        controls: carried.controls,
        distributed: carried.distributed.loads(at_once, draft),
        presence,
        frictions,
        pressures,
        sections,
        interferences,
        stabilisation: step.stabilisation,
        output: carried.output.clone(),
        origin: step.origin,
    }
}

/// Temperatures that a step gives, beside those that stand.
fn heat(step: &StepDraft, carried: &mut Carried, draft: &mut Draft) {
    if step.new_temperatures {
        carried.temperatures = InForce::default();
    }
    for line in &step.temperatures {
        let amplitude = line.amplitude.as_ref().and_then(|name| amplitude(name, draft));
        temperatures::heat((line, amplitude), &mut carried.temperatures, draft);
    }
}

/// Puts the distributed loads of a step into force.
fn distribute(step: &StepDraft, carried: &mut Carried, draft: &mut Draft) {
    carried.distributed.renew(step.new_distributed, draft.dialect);
    let lines = step.distributed.iter().map(|line| {
        let amplitude = line.amplitude.as_ref().and_then(|name| amplitude(name, draft));
        (line, amplitude)
    });
    let lines: Vec<_> = lines.collect();
    carried.distributed.take(&lines, draft);
    carried.distributed.wait(|element| carried.absent.contains(element));
}

/// The concentrated loads of a step, with those that ramp off where they do not vanish `at_once`.
fn concentrated(
    standing: &mut Standing<(NodeIndex, Dof), Load>,
    at_once: bool,
    draft: &Draft,
) -> Vec<Load> {
    let leaving = standing.succeed(|old, new| draft.same_curve(old, new));
    let stay = standing.iter().map(|(load, before)| Load {
        continues: before.map(|before| before.place),
        ..load.clone()
    });
    let leaving = leaving.into_iter().filter(|_| !at_once).map(|before| {
        let (value, amplitude, continues) = (0.0, None, Some(before.place));
        Load { value, amplitude, continues, ..before.load }
    });
    stay.chain(leaving).collect()
}

/// A value that followed an amplitude keeps what it had at the end, but for a curve over the total
/// time, which goes on.
fn settle(carried: &mut Carried, step: &Step, draft: &Draft) {
    let end = step.procedure.period;
    let factor = |amplitude: &mut Option<usize>| {
        let curve = amplitude.and_then(|index| draft.model.amplitudes.get(index));
        let Some(curve) = curve.filter(|curve| !curve.total) else { return 1.0 };
        *amplitude = None;
        curve.at(end)
    };
    for (value, amplitude) in carried.values() {
        *value *= factor(amplitude);
    }
    for own in &mut carried.temperatures.list {
        let factor = factor(&mut own.amplitude);
        own.temperature.value *= factor;
        own.temperature.slopes.iter_mut().for_each(|slope| *slope *= factor);
    }
}

/// Curves over the total time, as the next step and what still follows them see them.
fn over_total_time(before: f64, carried: &mut Carried, draft: &mut Draft) {
    let first = draft.model.amplitudes.iter().take_while(|own| own.begins == 0.0).count();
    let own: Vec<_> =
        draft.model.amplitudes[..first].iter().filter(|own| own.total).cloned().collect();
    if before > 0.0 {
        let moved = own.into_iter().map(|own| slideline_model::Amplitude { begins: before, ..own });
        draft.model.amplitudes.extend(moved);
    }
    let all = &draft.model.amplitudes;
    let latest = |index: usize| all.iter().rposition(|own| own.name == all[index].name);
    for (_, amplitude) in carried.values() {
        *amplitude = amplitude.and_then(latest);
    }
    for own in &mut carried.temperatures.list {
        own.amplitude = own.amplitude.and_then(latest);
    }
}

/// Dofs that the model does not have are passed over: `1, 1, 6` is common.
fn prescribe(line: &Boundary, into: &mut InForce<Prescribed, (NodeIndex, Dof)>, draft: &mut Draft) {
    let amplitude = line.amplitude.as_ref().and_then(|name| amplitude(name, draft));
    for node in draft.nodes_of(&line.target, line.target_span) {
        for &dof in &line.dofs {
            if !draft.has_motion(node, dof) {
                // what is held there anyhow asks for nothing
                if line.value != 0.0 && !line.fixed {
                    no_motion("motion", dof, line.target_span, draft);
                }
                continue;
            }
            if draft.implied.contains(&(node, dof)) {
                continue;
            }
            if let Some(&link) = draft.dependents.get(&(node, dof)) {
                let label = draft.model.nodes.label(node);
                let message =
                    format!("dof {} of node {label} follows others: not prescribed", dof.number());
                let error = Diagnostic::error(Code("SL0315"), message).at(line.target_span);
                let error = error.label(link, "it follows here");
                let help = "prescribe what it follows; an equation eliminates its first dof";
                draft.consequence(Subject::Links, error.help(help));
            }
            let (value, fixed, origin) = (line.value, line.fixed, line.origin);
            into.set((node, dof), Prescribed { node, dof, value, amplitude, fixed, origin });
        }
    }
}

impl Draft {
    /// Whether the model moves a node that way: rotation nodes of bodies keep the displacements
    /// that are rotations.
    fn has_motion(&self, node: NodeIndex, dof: Dof) -> bool {
        let is_turn = || self.model.rigid_links.iter().any(|link| link.turn == Some(node));
        self.model.directions().contains(&dof) || (!dof.is_rotation() && is_turn())
    }
}

/// Every dof that some step, or the deck before the first one, prescribes.
pub(super) fn prescribed(draft: &mut Draft) -> NumberedSet<(NodeIndex, Dof)> {
    let steps = draft.steps.iter().flat_map(|step| &step.boundary);
    let lines: Vec<Boundary> = draft.initial.iter().chain(steps).cloned().collect();
    let mut all = NumberedSet::default();
    for line in lines {
        for node in draft.nodes_of(&line.target, line.target_span) {
            all.extend(line.dofs.iter().map(|&dof| (node, dof)));
        }
    }
    all
}

/// The loads of a step: several lines on one dof add up.
fn loads(lines: &[Boundary], draft: &mut Draft) -> Vec<((NodeIndex, Dof), Load)> {
    let mut loads: Vec<((NodeIndex, Dof), Load)> = Vec::new();
    let mut place: Numbered<(NodeIndex, Dof, Option<usize>), usize> = Numbered::default();
    for line in lines {
        let amplitude = line.amplitude.as_ref().and_then(|name| amplitude(name, draft));
        for node in draft.nodes_of(&line.target, line.target_span) {
            for &dof in &line.dofs {
                if !draft.has_motion(node, dof) {
                    no_motion("load", dof, line.target_span, draft);
                    continue;
                }
                let (value, origin) = (line.value, line.origin);
                match place.get(&(node, dof, amplitude)) {
                    Some(&at) => loads[at].1.value += value,
                    None => {
                        place.insert((node, dof, amplitude), loads.len());
                        let continues = None;
                        let load = Load { node, dof, value, amplitude, continues, origin };
                        loads.push(((node, dof), load));
                    }
                }
            }
        }
    }
    loads
}

/// SL0251: a load or a motion on a dof that the plane has not.
fn no_motion(what: &str, dof: Dof, span: Span, draft: &mut Draft) {
    if draft.is_spatial() {
        return; // elements in space that are not made, of which the reason has been said
    }
    let message = format!("a {what} on dof {} has no effect in a plane model", dof.number());
    let error = Diagnostic::error(Code("SL0251"), message).at(span);
    draft.consequence(Subject::Elements, error.help("the plane has the dofs 1, 2 and 6"));
}
