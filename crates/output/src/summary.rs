//! `JOB.json`: how the run went, in one object.

use crate::file::{WriteError, replace};
use crate::history::{Column, columns};
use crate::job::JobFiles;
use crate::json::Object;
use crate::ledger::onset_word;
use crate::record::record;
use crate::restart::Earlier;
use crate::understood::{self, Understood};
use crate::verdict;
use crate::vtu::state_is_due;
use slideline_diag::{Diagnostic, Severity, Sources};
use slideline_measures::NoiseSummary;
use slideline_model::{Dialect, NodeIndex, Onset};
use slideline_solve::Checkpoint;
use slideline_solve::bytes::{Packed, Unpacking};
use slideline_solve::observe::{Ending, Event, Frame, StepReport, Stop, Totals};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Version of the layout of `JOB.json`.
pub const SCHEMA: usize = 1;

/// What is known of a job before it runs.
#[derive(Clone, Debug)]
pub struct Facts<'a> {
    /// Version of the program.
    pub version: &'a str,
    /// Hash of the deck's text, included files too.
    pub deck_hash: &'a str,
    /// Texts, to say where something stands.
    pub sources: &'a Sources,
    /// What reading had to say.
    pub diagnostics: &'a [Diagnostic],
    /// Dialect of the deck, where known.
    pub dialect: Option<Dialect>,
    /// Friction onset that rules, where known.
    pub friction_onset: Option<Onset>,
    /// How many of the texts, from the first on, are those of the job's own
    /// deck.
    pub own_texts: usize,
    /// The jobs that this one goes on from.
    pub earlier: Option<&'a Earlier>,
}

/// How a job stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It runs, or its process was killed.
    Running,
    /// Every step was walked to its end.
    Completed,
    /// An increment could not be found; what converged is kept.
    NotConverged,
    /// The deck has errors; nothing was solved.
    InputError,
    /// Results could not be written.
    OutputError,
    /// Stopped on request after a converged increment.
    Interrupted,
    /// Our fault.
    InternalError,
}

impl Status {
    /// The word of `JOB.json`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Running => "running",
            Self::Completed => "completed",
            Self::NotConverged => "not_converged",
            Self::InputError => "input_error",
            Self::OutputError => "output_error",
            Self::Interrupted => "interrupted",
            Self::InternalError => "internal_error",
        }
    }

    /// What an ending amounts to; a diagnosis SL09xx is our fault.
    pub fn of(ending: &Ending) -> Self {
        match ending {
            Ending::Completed(_) => Self::Completed,
            Ending::NotConverged(_, why) if why.code.0.starts_with("SL09") => Self::InternalError,
            Ending::NotConverged(..) => Self::NotConverged,
            Ending::Stopped(_, Stop::Interrupted) => Self::Interrupted,
            Ending::Stopped(_, Stop::OutputFailed(_)) => Self::OutputError,
        }
    }
}

/// Smallest and largest value of a curve, and when.
#[derive(Clone, Copy, Debug)]
struct Peak {
    least: (f64, f64),
    most: (f64, f64),
}

/// What a summary remembers of the events of a run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Memory {
    before: Duration,
    warnings: Vec<String>,
    peaks: Vec<Option<Peak>>,
    strain: Option<(f64, u64, f64)>,
    used: Option<(f64, u64, f64)>,
    normal: Option<(f64, u64, f64)>,
}

impl Memory {
    /// Reads what [`Summary::pack`] has written.
    pub fn unpack(bytes: &mut Unpacking<'_>) -> Option<Self> {
        let before = Duration::try_from_secs_f64(bytes.number()?).ok()?;
        let count = bytes.length(8)?;
        let warnings = (0..count).map(|_| bytes.text()).collect::<Option<_>>()?;
        let count = bytes.length(1)?;
        let peaks = (0..count).map(|_| unpack_peak(bytes)).collect::<Option<_>>()?;
        let strain = unpack_largest(bytes)?;
        let used = unpack_largest(bytes)?;
        let normal = unpack_largest(bytes)?;
        Some(Self { before, warnings, peaks, strain, used, normal })
    }
}

/// A largest value, the number of whom it belongs to, and its time.
fn unpack_largest(bytes: &mut Unpacking<'_>) -> Option<Option<(f64, u64, f64)>> {
    if !bytes.flag()? {
        return Some(None);
    }
    let [value, time] = bytes.numbers()?;
    Some(Some((value, bytes.text()?.parse().ok()?, time)))
}

fn pack_largest(largest: Option<(f64, u64, f64)>, bytes: &mut Packed) {
    bytes.flag(largest.is_some());
    if let Some((value, whose, time)) = largest {
        bytes.numbers(&[value, time]);
        bytes.text(&whose.to_string());
    }
}

/// Keeps the larger one; what is no number is the largest.
fn keep_larger(largest: &mut Option<(f64, u64, f64)>, now: (f64, u64, f64)) {
    if largest.is_none_or(|(value, ..)| now.0 > value || now.0.is_nan()) {
        *largest = Some(now);
    }
}

fn unpack_peak(bytes: &mut Unpacking<'_>) -> Option<Option<Peak>> {
    if !bytes.flag()? {
        return Some(None);
    }
    let [low, low_at, high, high_at] = bytes.numbers()?;
    Some(Some(Peak { least: (low, low_at), most: (high, high_at) }))
}

/// Collects what `JOB.json` says and writes it at both ends of a run.
pub(crate) struct Summary<'a> {
    job: JobFiles,
    facts: Facts<'a>,
    began: Instant,
    /// Wall time of the runs that this one goes on from.
    before: Duration,
    warnings: Vec<String>,
    advice: Vec<String>,
    notes: Vec<String>,
    curves: Vec<(String, NodeIndex, Column)>,
    peaks: Vec<Option<Peak>>,
    dropped_work: f64,
    totals: Totals,
    understood: Option<Understood>,
    /// Largest fibre strain of a beam: value, element, total time.
    strain: Option<(f64, u64, f64)>,
    /// Largest strain over the allowable one: value, element, total time.
    used: Option<(f64, u64, f64)>,
    /// Largest normal force of a contact pair: value, pair, total time.
    normal: Option<(f64, u64, f64)>,
    /// Allowable strains of elements.
    allowable: BTreeMap<u64, f64>,
    /// What the deck calls itself, and its pairs.
    names: (String, Vec<String>),
    /// Noise of the run, as JSON.
    noise: Option<String>,
    /// How many states were written, the start among them.
    states: usize,
}

impl<'a> Summary<'a> {
    /// Writes the summary of a job that runs.
    pub fn begin(job: &JobFiles, facts: Facts<'a>) -> Result<Self, WriteError> {
        let summary = Self::new(job, facts);
        summary.write(Status::Running, None)?;
        Ok(summary)
    }

    fn new(job: &JobFiles, facts: Facts<'a>) -> Self {
        let own = |severity| said(severity, facts.diagnostics, facts.sources);
        let warnings = own(Severity::Warning);
        let (advice, notes) = (own(Severity::Advice), own(Severity::Note));
        Self {
            job: job.clone(),
            facts,
            began: Instant::now(),
            before: Duration::ZERO,
            warnings,
            advice,
            notes,
            curves: Vec::new(),
            peaks: Vec::new(),
            dropped_work: 0.0,
            totals: Totals::default(),
            understood: None,
            strain: None,
            used: None,
            normal: None,
            allowable: BTreeMap::new(),
            names: Default::default(),
            noise: None,
            states: 0,
        }
    }

    /// Writes the summary of a job that goes on from a checkpoint.
    pub fn resume(
        job: &JobFiles,
        facts: Facts<'a>,
        memory: Memory,
        from: &Checkpoint<'_>,
    ) -> Result<Self, WriteError> {
        let Memory { before, warnings, peaks, strain, used, normal } = memory;
        let (totals, dropped_work) = (from.totals, from.energy().dropped_friction);
        let states = job.kept().map_or(0, |kept| kept.states.len());
        let new = Self::new(job, facts);
        let largest = Self { strain, used, normal, ..new };
        let summary = Self { before, warnings, peaks, totals, dropped_work, states, ..largest };
        summary.write(Status::Running, None)?;
        Ok(summary)
    }

    /// Appends what only the events of the run so far have told.
    pub fn pack(&self, bytes: &mut Packed) {
        bytes.number(self.elapsed().as_secs_f64());
        bytes.count(self.warnings.len());
        self.warnings.iter().for_each(|warning| bytes.text(warning));
        bytes.count(self.peaks.len());
        for peak in &self.peaks {
            bytes.flag(peak.is_some());
            if let Some(Peak { least, most }) = peak {
                bytes.numbers(&[least.0, least.1, most.0, most.1]);
            }
        }
        for largest in [self.strain, self.used, self.normal] {
            pack_largest(largest, bytes);
        }
    }

    fn elapsed(&self) -> Duration {
        self.before + self.began.elapsed()
    }

    /// Takes note of everything but the end.
    pub fn watch(&mut self, event: &Event<'_>) {
        match event {
            Event::StepBegin(step) if self.curves.is_empty() => {
                let any = step.model.steps.iter().any(|step| step.output.has_states());
                self.states += usize::from(any && !step.resumed);
                self.list_curves(step);
            }
            Event::Iteration(_) => self.totals.iterations += 1,
            Event::AttemptFailed(_) => self.totals.cutbacks += 1,
            Event::Committed(frame) => self.follow(frame),
            Event::Diagnosed(said) => {
                let list = match said.severity {
                    Severity::Warning => &mut self.warnings,
                    Severity::Advice => &mut self.advice,
                    _ => return,
                };
                list.push(record(said, self.facts.sources).finish());
            }
            _ => {}
        }
    }

    /// Takes in the noise of the run.
    pub fn measured(&mut self, noise: &NoiseSummary) {
        let reactions = noise.reactions.iter().fold(Object::new(), |all, reaction| {
            let object = optional(Object::new(), "roughness", reaction.roughness);
            let object = optional(object, "roughness_of_fourth", reaction.roughness_of_fourth);
            let object = object.count("reversals", reaction.reversals);
            let of_mesh = reaction.of_mesh.map(|noise| noise.roughness);
            all.raw(&reaction.name, &optional(object, "of_mesh", of_mesh).finish())
        });
        let pairs = noise.pairs.iter().map(|pair| {
            let object = Object::new()
                .text("name", &pair.name)
                .count("contact_changes", pair.changes)
                .number("changes_per_increment", pair.changes_per_increment)
                .number("penetration", pair.penetration);
            optional(object, "penetration_over_c0", pair.penetration_over_c0)
                .number("force_imbalance", pair.force_imbalance)
                .number("moment_imbalance", pair.moment_imbalance)
                .finish()
        });
        let object = Object::new().count("increments", noise.increments);
        let object = object.raw("reactions", &reactions.finish()).array("pairs", pairs);
        self.noise = Some(object.finish());
    }

    /// Writes the summary of a run that is over.
    pub fn end(&mut self, status: Status, ending: &Ending) -> Result<(), WriteError> {
        let (totals, diagnosis) = match ending {
            Ending::Completed(totals) | Ending::Stopped(totals, _) => (totals, None),
            Ending::NotConverged(totals, diagnosis) => (totals, Some(diagnosis)),
        };
        self.totals = *totals;
        self.write(status, diagnosis)
    }

    /// Writes the summary of a run that came to a bad end on our side.
    pub fn give_up(&self) -> Result<(), WriteError> {
        self.write(Status::InternalError, None)
    }

    fn list_curves(&mut self, step: &StepReport<'_>) {
        self.understood.get_or_insert_with(|| understood::understood(step.model));
        let pairs = step.model.contact_pairs.iter().map(|pair| pair.name.clone());
        self.names = (step.model.heading.clone(), pairs.collect());
        for allowable in &step.model.allowables {
            let block = step.model.blocks.get(allowable.block);
            let elements = block.into_iter().flat_map(|block| &block.elements);
            self.allowable.extend(elements.map(|own| (own.label, allowable.strain)));
        }
        let columns = columns(step.start.nodal.dofs());
        for node in step.model.history_nodes() {
            let label = step.model.nodes.label(node);
            self.curves.extend(
                columns.iter().map(|&column| (format!("{label}.{}", column.name()), node, column)),
            );
        }
        if self.peaks.len() != self.curves.len() {
            self.peaks = vec![None; self.curves.len()]; // else they were recalled
        }
    }

    fn follow(&mut self, frame: &Frame<'_>) {
        self.totals.increments += 1;
        self.states += usize::from(state_is_due(frame));
        self.dropped_work = frame.energy.dropped_friction;
        let time = frame.total_time;
        for beam in frame.beams {
            keep_larger(&mut self.strain, (beam.fibre_strain, beam.label, time));
            if let Some(allowable) = self.allowable.get(&beam.label) {
                keep_larger(&mut self.used, (beam.fibre_strain / allowable, beam.label, time));
            }
        }
        let mut normal = vec![0.0; self.names.1.len()];
        for row in frame.contact {
            if let Some(sum) = normal.get_mut(row.pair) {
                *sum += row.pressure * row.area;
            }
        }
        for (pair, force) in normal.into_iter().enumerate() {
            keep_larger(&mut self.normal, (force, pair as u64, time));
        }
        for ((_, node, column), peak) in self.curves.iter().zip(&mut self.peaks) {
            let value = column.value(&frame.nodal, *node);
            let peak = peak.get_or_insert(Peak { least: (value, time), most: (value, time) });
            if value < peak.least.0 {
                peak.least = (value, time);
            }
            if value > peak.most.0 {
                peak.most = (value, time);
            }
        }
    }

    fn write(&self, status: Status, diagnosis: Option<&Diagnostic>) -> Result<(), WriteError> {
        let mut text = self.object(status, diagnosis);
        text.push('\n');
        if status != Status::Running {
            text = verdict::attached(&self.job, &text);
        }
        replace(&self.job.path(".json"), text.as_bytes())
    }

    fn object(&self, status: Status, diagnosis: Option<&Diagnostic>) -> String {
        let facts = &self.facts;
        let mut object = Object::new()
            .text("job", &self.job.name())
            .text("title", &self.names.0)
            .text("status", status.word())
            .count("increments", self.totals.increments)
            .count("cutbacks", self.totals.cutbacks)
            .count("iterations", self.totals.iterations)
            .number("wall_seconds", self.elapsed().as_secs_f64())
            .array("warnings", self.warnings.iter().cloned())
            .array("advice", self.advice.iter().cloned())
            .array("notes", self.notes.iter().cloned())
            .raw("peaks", &self.peaks())
            .raw("dropped_friction", &self.dropped())
            .count("states", self.states)
            .count("schema", SCHEMA)
            .text("program_version", facts.version)
            .text("deck_hash", facts.deck_hash)
            .optional_text("dialect", facts.dialect.map(Dialect::word))
            .optional_text("friction_onset", facts.friction_onset.map(onset_word));
        if let Some(Earlier { origin, .. }) = facts.earlier {
            let origin = Object::new()
                .text("job", &origin.job)
                .count("step", origin.step)
                .count("increment", origin.increment);
            object = object.raw("goes_on_from", &origin.finish());
        }
        object = self.largest(object);
        if let Some(noise) = &self.noise {
            object = object.raw("noise", noise);
        }
        if let Some(understood) = &self.understood {
            object = object
                .raw("driven", &understood.driven)
                .raw("loaded", &understood.loaded)
                .raw("supports", &understood.supports)
                .raw("sections", &understood.sections)
                .raw("pairs", &understood.pairs)
                .raw("settings", &understood.settings);
        }
        if status == Status::InputError {
            let errors = facts.diagnostics.iter().filter(|said| said.severity == Severity::Error);
            object = object.array("errors", errors.map(|e| record(e, facts.sources).finish()));
        }
        if let Some(diagnosis) = diagnosis {
            object = object.raw("diagnosis", &record(diagnosis, facts.sources).finish());
        }
        object.finish()
    }

    /// Largest strain, its share of the allowable one, largest normal force.
    fn largest(&self, mut object: Object) -> Object {
        let element = |object: Object, element: u64, time: f64| {
            object.raw("element", &element.to_string()).number("time", time).finish()
        };
        if let Some((value, own, time)) = self.strain {
            let strain = Object::new().number("max", value);
            object = object.raw("fibre_strain", &element(strain, own, time));
        }
        if let Some((value, own, time)) = self.used {
            let used = Object::new()
                .number("utilisation", value)
                .number("margin", 1.0 / value - 1.0)
                .flag("pass", value <= 1.0);
            object = object.raw("allowable", &element(used, own, time));
        }
        if let Some((value, pair, time)) = self.normal {
            let pair = usize::try_from(pair).ok().and_then(|pair| self.names.1.get(pair));
            let normal = Object::new()
                .number("max", value)
                .text("pair", pair.map_or("?", String::as_str))
                .number("time", time);
            object = object.raw("normal_force", &normal.finish());
        }
        object
    }

    fn peaks(&self) -> String {
        let mut object = Object::new();
        for ((name, _, _), peak) in self.curves.iter().zip(&self.peaks) {
            if let Some(peak) = peak {
                let peak = Object::new()
                    .number("min", peak.least.0)
                    .number("max", peak.most.0)
                    .number("time_min", peak.least.1)
                    .number("time_max", peak.most.1);
                object = object.raw(name, &peak.finish());
            }
        }
        object.finish()
    }

    fn dropped(&self) -> String {
        Object::new()
            .count("point_increments", self.totals.dropped_points)
            .number("work", self.dropped_work)
            .finish()
    }
}

/// A number, or null where there is none.
fn optional(object: Object, key: &str, value: Option<f64>) -> Object {
    match value {
        Some(value) => object.number(key, value),
        None => object.raw(key, "null"),
    }
}

/// What was said with that severity.
fn said(severity: Severity, diagnostics: &[Diagnostic], sources: &Sources) -> Vec<String> {
    let own = diagnostics.iter().filter(|said| said.severity == severity);
    own.map(|said| record(said, sources).finish()).collect()
}

/// Writes `JOB.json` of a deck with errors; the files of an earlier run go.
///
/// # Errors
/// When the folder cannot be made, or a file not be removed or written.
pub fn write_input_error(job: &JobFiles, facts: Facts<'_>) -> Result<(), WriteError> {
    job.clear()?;
    Summary::new(job, facts).write(Status::InputError, None)
}
