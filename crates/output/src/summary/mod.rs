//! `JOB.json`: how the run went, in one object.

mod memory;

use crate::clock::Clock;
use crate::dat::heading;
use crate::facts::{Earlier, Facts, Status};
use crate::file::{WriteError, replace};
use crate::job::JobFiles;
use crate::json::{Map, Value, joined, json, text};
use crate::ledger::onset_word;
use crate::model_object::model_object;
use crate::reading::history::{Energies, History, NodeHistory};
use crate::reading::summary::{SCHEMA, driven, loaded};
use crate::record::record;
use crate::verdict;
use crate::vtu::state_is_due;
use crate::{energy, history};
pub(crate) use memory::Memory;
use memory::{Peak, keep_larger};
use slideline_diag::{Diagnostic, Severity, Sources};
use slideline_measures::{Colour, NoiseSummary};
use slideline_model::{Dialect, Limit, NodeIndex, Section};
use slideline_results::NodeComponent;
use slideline_solve::Checkpoint;
use slideline_solve::observe::{Ending, Event, Frame, StepReport, Totals};
use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

/// Collects what `JOB.json` says and writes it at both ends of a run.
pub(crate) struct Summary<'a> {
    job: JobFiles,
    facts: Facts<'a>,
    began: Clock,
    memory: Memory,
    /// Warnings, advice and notes.
    said: [Vec<Value>; 3],
    curves: Vec<(String, NodeIndex, NodeComponent)>,
    /// Columns of the curves, and what the driven nodes did so far.
    history: (Vec<NodeComponent>, History),
    /// Columns of the energies, and all of them so far.
    energies: (Vec<energy::Column>, Energies),
    dropped_work: f64,
    totals: Totals,
    model_object: Option<Value>,
    /// Allowable strains of beams.
    allowable: BTreeMap<u64, f64>,
    /// What the deck calls itself, and its pairs.
    names: (String, Vec<String>),
    /// Noise of the run.
    noise: Option<Value>,
    /// How many states were written, the start among them.
    states: usize,
    /// Whether a step has begun.
    begun: bool,
}

/// Counts of a run that is over, and what ended it early.
fn counted(ending: &Ending) -> (Totals, Option<&Diagnostic>) {
    match ending {
        Ending::Completed(totals) | Ending::Stopped(totals, _) => (*totals, None),
        Ending::NotConverged(totals, diagnosis) => (*totals, Some(diagnosis)),
    }
}

impl<'a> Summary<'a> {
    /// Writes the summary of a job that runs.
    pub fn begin(job: &JobFiles, facts: Facts<'a>) -> Result<Self, WriteError> {
        let summary = Self::new(job, facts);
        summary.write(Status::Running, None)?;
        Ok(summary)
    }

    /// One that was written nowhere yet.
    pub fn new(job: &JobFiles, facts: Facts<'a>) -> Self {
        let severities = [Severity::Warning, Severity::Advice, Severity::Note];
        let said = severities.map(|own| said(own, facts.diagnostics, facts.sources));
        Self {
            job: job.clone(),
            facts,
            began: Clock::started(),
            memory: Memory::default(),
            said,
            curves: Vec::new(),
            history: Default::default(),
            energies: Default::default(),
            dropped_work: 0.0,
            totals: Totals::default(),
            model_object: None,
            allowable: BTreeMap::new(),
            names: Default::default(),
            noise: None,
            states: 0,
            begun: false,
        }
    }

    /// Writes the summary of a job that goes on from a checkpoint.
    pub fn resume(
        job: &JobFiles,
        facts: Facts<'a>,
        memory: Memory,
        from: &Checkpoint<'_>,
    ) -> Result<Self, WriteError> {
        let mut summary = Self::new(job, facts);
        let warnings = memory.warnings.iter().flat_map(|said| serde_json::from_str(said));
        summary.said[0] = warnings.collect();
        summary.memory = memory;
        summary.totals = from.totals;
        summary.dropped_work = from.energy().dropped_friction;
        let length = from.totals.increments;
        let history = History::read(&job.path(".history.csv"), |_| true);
        summary.history.1 = history.unwrap_or_default();
        summary.history.1.shorten(length);
        summary.energies.1 = Energies::read(&job.path(".energy.csv")).unwrap_or_default();
        summary.energies.1.shorten(length);
        summary.states = job.kept().map_or(0, |kept| kept.states.len());
        summary.write(Status::Running, None)?;
        Ok(summary)
    }

    /// What only the events of the run so far have told.
    pub fn memory(&self) -> Memory {
        let warnings = self.said[0].iter().map(text).collect();
        Memory { before: self.elapsed(), warnings, ..self.memory.clone() }
    }

    fn elapsed(&self) -> Duration {
        self.memory.before + self.began.elapsed()
    }

    /// Takes note of everything but the end.
    pub fn watch(&mut self, event: &Event<'_>) {
        match event {
            Event::StepBegin(step) if !self.begun => {
                self.begun = true;
                let any = step.model.steps.iter().any(|step| step.output.has_states());
                self.states += usize::from(any && !step.resumed);
                self.list_curves(step);
            }
            Event::Iteration(_) => self.totals.iterations += 1,
            Event::AttemptFailed(_) => self.totals.cutbacks += 1,
            Event::Committed(frame) => self.follow(frame),
            Event::Diagnosed(said) => {
                let list = match said.severity {
                    Severity::Warning => 0,
                    Severity::Advice => 1,
                    _ => return,
                };
                self.said[list].push(record(said, self.facts.sources));
            }
            _ => {}
        }
    }

    /// Takes in the noise of the run.
    pub fn measured(&mut self, noise: &NoiseSummary) {
        let reactions = noise.reactions.iter().map(|reaction| {
            let own = json!({
                "roughness": reaction.roughness,
                "roughness_of_fourth": reaction.roughness_of_fourth,
                "reversals": reaction.reversals,
                "of_mesh": reaction.of_mesh.map(|noise| noise.roughness),
            });
            (reaction.name.clone(), own)
        });
        let pairs = noise.pairs.iter().map(|pair| {
            json!({
                "name": pair.name,
                "contact_changes": pair.changes,
                "changes_per_increment": pair.changes_per_increment,
                "penetration": pair.penetration,
                "penetration_over_c0": pair.penetration_over_c0,
                "force_imbalance": pair.force_imbalance,
                "moment_imbalance": pair.moment_imbalance,
            })
        });
        self.noise = Some(json!({
            "increments": noise.increments,
            "reactions": reactions.collect::<Map<String, Value>>(),
            "pairs": pairs.collect::<Value>(),
        }));
    }

    /// Writes the summary of a run that is over.
    pub fn end(&mut self, status: Status, ending: &Ending) -> Result<(), WriteError> {
        let (totals, diagnosis) = counted(ending);
        self.totals = totals;
        self.write(status, diagnosis)
    }

    /// What is written of a run that is over, without its verdict; nothing is written.
    pub fn ended(&mut self, status: Status, ending: &Ending) -> Value {
        let (totals, diagnosis) = counted(ending);
        self.totals = totals;
        self.object(status, diagnosis)
    }

    /// What is written of a run that goes on.
    pub fn running(&self) -> Value {
        self.object(Status::Running, None)
    }

    /// The first line of `JOB.dat`.
    pub fn heading(&self) -> String {
        heading(self.facts.version, &self.job.name())
    }

    /// Energies and histories so far.
    pub fn curves(&self) -> (&Energies, &History) {
        (&self.energies.1, &self.history.1)
    }

    /// The verdict of a run that is over; nothing is written.
    pub fn judged(&mut self, status: Status, ending: &Ending) -> Colour {
        let object = self.ended(status, ending);
        let (energies, history) = self.curves();
        verdict::judge(&object, Some(energies), |driven| history.stroke(driven)).verdict.colour
    }

    /// Largest strain or stress over the allowable one so far [1].
    pub fn utilisation(&self) -> Option<f64> {
        self.memory.used.map(|(used, ..)| used)
    }

    /// Writes the summary of a run that came to a bad end on our side.
    pub fn give_up(&self) -> Result<(), WriteError> {
        self.write(Status::InternalError, None)
    }

    fn list_curves(&mut self, step: &StepReport<'_>) {
        self.model_object.get_or_insert_with(|| model_object(step.model));
        let pairs = step.model.contact_pairs.iter().map(|pair| pair.name.clone());
        self.names = (step.model.heading.clone(), pairs.collect());
        for allowable in &step.model.allowables {
            let block = step.model.blocks.get(allowable.block);
            let Some(block) = block else { continue };
            let Section::Beam(section) = &block.section else { continue };
            let strain = match allowable.limit {
                Limit::Strain(strain) => strain,
                Limit::Stress(stress) => stress / section.material.modulus,
            };
            self.allowable.extend(block.elements.iter().map(|own| (own.label, strain)));
        }
        let columns = history::columns(step.start.nodal.dofs());
        for node in step.model.history_nodes() {
            let label = step.model.nodes.label(node);
            self.curves.extend(
                columns.iter().map(|&column| (format!("{label}.{}", column.name()), node, column)),
            );
        }
        self.energies.0 = energy::columns(step);
        // else they were recalled
        if self.memory.peaks.len() != self.curves.len() {
            self.memory.peaks = vec![None; self.curves.len()];
        }
        if self.energies.1.columns.is_empty() {
            let names = columns.iter().map(|column| column.name().to_owned()).collect();
            let driven = self.model_object.as_ref().map(driven).unwrap_or_default();
            let nodes = driven.into_iter().flat_map(|own| own.nodes);
            let loaded = self.model_object.as_ref().map(loaded).unwrap_or_default();
            let nodes: BTreeSet<u64> = nodes.chain(loaded.into_iter().map(|own| own.0)).collect();
            let nodes = nodes.into_iter().map(|node| NodeHistory::new(node, columns.len()));
            self.history.1 = History { columns: names, nodes: nodes.collect() };
            let names = self.energies.0.iter().map(|(name, _)| (*name).to_owned());
            self.energies.1 = Energies::of(names.collect());
        }
        self.history.0 = columns;
    }

    fn follow(&mut self, frame: &Frame<'_>) {
        self.totals.increments += 1;
        self.states += usize::from(state_is_due(frame));
        self.dropped_work = frame.energy.dropped_friction;
        let (time, memory) = (frame.total_time, &mut self.memory);
        memory.energy_rounding = memory.energy_rounding.max(frame.energy_rounding);
        memory.energy_unsure = frame.energy_unsure;
        memory.follow_beams(frame, &self.allowable);
        memory.follow_solids(frame);
        memory.follow_turns(frame);
        for pair in 0..self.names.1.len() {
            let own = frame.contact.iter().filter(|row| row.pair == pair);
            let force = own.fold(0.0, |sum, row| sum + row.pressure * row.area);
            keep_larger(&mut memory.normal, (force, pair as u64, time));
        }
        self.energies.1.numbers.push([frame.step, frame.increment]);
        self.energies.1.times.push(time);
        for (list, (_, value)) in self.energies.1.values.iter_mut().zip(&self.energies.0) {
            list.push(value(&frame.energy));
        }
        for own in &mut self.history.1.nodes {
            let Some(node) = frame.model.nodes.find(own.node) else { continue };
            for (list, column) in own.values.iter_mut().zip(&self.history.0) {
                list.push(column.value(frame, node));
            }
        }
        for ((_, node, column), peak) in self.curves.iter().zip(&mut memory.peaks) {
            let now = (column.value(frame, *node), time);
            let peak = peak.get_or_insert(Peak { least: now, most: now });
            if now.0 < peak.least.0 {
                peak.least = now;
            }
            if now.0 > peak.most.0 {
                peak.most = now;
            }
        }
    }

    fn write(&self, status: Status, diagnosis: Option<&Diagnostic>) -> Result<(), WriteError> {
        let mut object = self.object(status, diagnosis);
        if status != Status::Running {
            object = verdict::attached(object, &self.energies.1, &self.history.1);
        }
        replace(&self.job.path(".json"), (text(&object) + "\n").as_bytes())
    }

    fn object(&self, status: Status, diagnosis: Option<&Diagnostic>) -> Value {
        let (facts, totals) = (&self.facts, &self.totals);
        let mut object = json!({
            "job": self.job.name(),
            "title": self.names.0,
            "status": status.word(),
            "increments": totals.increments,
            "cutbacks": totals.cutbacks,
            "iterations": totals.iterations,
            "wall_seconds": self.elapsed().as_secs_f64(),
            "warnings": self.said[0],
            "advice": self.said[1],
            "notes": self.said[2],
            "peaks": self.peaks(),
            "dropped_friction":
                {"point_increments": totals.dropped_points, "work": self.dropped_work},
            "states": self.states,
            "schema": SCHEMA,
            "program_version": facts.version,
            "deck_hash": facts.deck_hash,
            "dialect": facts.dialect.map(Dialect::word),
            "friction_onset": facts.friction_onset.map(onset_word),
        });
        if let Some(Earlier { origin, .. }) = facts.earlier {
            object["goes_on_from"] = json!({
                "job": origin.job, "step": origin.step, "increment": origin.increment,
            });
        }
        if !facts.parameters.is_empty() {
            let set = facts.parameters.iter();
            let set = set.map(|(name, value)| (name.clone(), Value::from(value.as_str())));
            object["parameters"] = Value::Object(set.collect());
        }
        self.memory.say(&mut object, &self.names.1);
        if let Some(noise) = &self.noise {
            object["noise"] = noise.clone();
        }
        if let Some(model_object) = &self.model_object {
            object = joined(object, model_object.clone());
        }
        if status == Status::InputError {
            object["errors"] = said(Severity::Error, facts.diagnostics, facts.sources).into();
        }
        if let Some(diagnosis) = diagnosis {
            object["diagnosis"] = record(diagnosis, facts.sources);
        }
        object
    }

    fn peaks(&self) -> Map<String, Value> {
        let curves = self.curves.iter().zip(&self.memory.peaks);
        let peaks = curves.filter_map(|((name, ..), peak)| Some((name, (*peak)?)));
        let own = |(name, Peak { least, most }): (&String, Peak)| {
            let own = json!(
                {"min": least.0, "max": most.0, "time_min": least.1, "time_max": most.1}
            );
            (name.clone(), own)
        };
        peaks.map(own).collect()
    }
}

/// What was said with that severity.
fn said(severity: Severity, diagnostics: &[Diagnostic], sources: &Sources) -> Vec<Value> {
    let own = diagnostics.iter().filter(|said| said.severity == severity);
    own.map(|said| record(said, sources)).collect()
}

/// Writes `JOB.json` of a deck with errors; the files of an earlier run go.
///
/// # Errors
/// When the folder cannot be made, or a file not be removed or written.
pub fn write_input_error(job: &JobFiles, facts: Facts<'_>) -> Result<(), WriteError> {
    job.clear()?;
    Summary::new(job, facts).write(Status::InputError, None)
}
