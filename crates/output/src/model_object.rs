//! What the report needs to know of a model, as members of `JOB.json`: what
//! is driven, who touches whom, and which settings ruled.

use crate::echo::{friction_law, normal_law};
use crate::json::{Value, json};
use crate::ledger::onset_word;
use crate::number::general;
use slideline_mech::axes::PLAIN;
use slideline_model::{
    Controls, Dialect, Dof, Driven, FieldControls, Friction, Kinematics, Master, Model, NodeIndex,
    Onset, Section, Step, StickRule, TimeIncrementation,
};
use std::collections::HashSet;

/// Members of `JOB.json`:
///
/// | member | content |
/// |---|---|
/// | `driven` | `[{"node","name","nodes":[..],"motion","reaction","along"}]`: prescribed motions that move; `along`, a direction a node, where nodes have axes of their own |
/// | `loaded` | `[{"node","name","motion"}]`: loads |
/// | `supports` | `[{"node","dofs":[..]}]`: what is held throughout |
/// | `sections` | `[{"height","elements":[first,last,..]}]`: heights of beam sections |
/// | `pairs` | `[{"name","slave":[..],"master","nodes":[..],"normal","friction"}]` |
/// | `instances` | `[{"name","first"}]`: `first` + n is the number of node or element n |
/// | `settings` | `[{"card","name","value","default"}]` |
pub(crate) fn model_object(model: &Model) -> Value {
    let driven = model.driven().into_iter().map(|own| {
        let nodes: Vec<u64> = own.nodes.iter().map(|&node| model.nodes.label(node)).collect();
        let (motion, reaction) = (own.dof.name(), own.dof.reaction_name());
        let mut said = json!({
            "node": nodes.first(),
            "name": own.name,
            "nodes": nodes,
            "motion": motion,
            "reaction": reaction,
        });
        if let Some(along) = own_axes(model, &own) {
            said["along"] = json!(along);
        }
        said
    });
    let loaded = loaded(model).into_iter().map(|(dof, nodes)| {
        let node = nodes.first().map(|&node| model.nodes.label(node));
        json!({"node": node, "name": model.name_of(&nodes), "motion": dof.name()})
    });
    json!({
        "driven": driven.collect::<Value>(),
        "loaded": loaded.collect::<Value>(),
        "supports": supports(model),
        "sections": sections(model),
        "pairs": pairs(model),
        "instances": instances(model),
        "settings": settings(model),
    })
}

/// The directions of a motion, a node each, where one of its nodes has axes of its own [1].
fn own_axes(model: &Model, driven: &Driven) -> Option<Vec<[f64; 3]>> {
    if driven.dof.is_rotation() && !model.is_in_space() {
        return None;
    }
    let axis = driven.dof as usize % 3;
    let has_own = driven.nodes.iter().any(|&node| model.axes_of(node).is_some());
    let of = |&node: &NodeIndex| model.axes_of(node).unwrap_or(PLAIN)[axis];
    has_own.then(|| driven.nodes.iter().map(of).collect())
}

/// Instances of parts, and what their numbers are raised by.
fn instances(model: &Model) -> Value {
    let numbering = model.nodes.numbering();
    let named = numbering.instances().iter().zip(1_u64..);
    named.map(|(name, k)| json!({"name": name, "first": k * numbering.stride()})).collect()
}

/// Nodes that the first step holds and no step moves.
fn supports(model: &Model) -> Value {
    let Some(first) = model.steps.first() else { return json!([]) };
    let moved = |node: NodeIndex, dof: Dof| {
        let mut all = model.steps.iter().flat_map(|step| &step.prescribed);
        all.any(|own| own.node == node && own.dof == dof && own.moves())
    };
    let mut held: Vec<(NodeIndex, Vec<Dof>)> = Vec::new();
    for own in first.prescribed.iter().filter(|own| !moved(own.node, own.dof)) {
        match held.iter_mut().find(|(node, _)| *node == own.node) {
            Some((_, dofs)) if dofs.contains(&own.dof) => {}
            Some((_, dofs)) => dofs.push(own.dof),
            None => held.push((own.node, vec![own.dof])),
        }
    }
    let held = held.into_iter().map(|(node, dofs)| {
        let dofs: Vec<usize> = dofs.into_iter().map(Dof::number).collect();
        json!({"node": model.nodes.label(node), "dofs": dofs})
    });
    held.collect()
}

/// Heights of beam sections with their elements, first and last of each run.
fn sections(model: &Model) -> Value {
    let blocks = model.blocks.iter().filter_map(|block| block.beams());
    let sections = blocks.map(|block| {
        let mut runs: Vec<[u64; 2]> = Vec::new();
        for element in block.elements {
            match runs.last_mut().filter(|run| run[1].checked_add(1) == Some(element.label)) {
                Some(run) => run[1] = element.label,
                None => runs.push([element.label; 2]),
            }
        }
        json!({"height": block.section.shape.height(), "elements": runs.concat()})
    });
    sections.collect()
}

/// Loaded dofs, nodes that a card loads alike taken together, in the order of the deck.
fn loaded(model: &Model) -> Vec<(Dof, Vec<NodeIndex>)> {
    let mut seen: HashSet<(NodeIndex, Dof)> = HashSet::new();
    let mut groups: Vec<(Dof, Vec<NodeIndex>)> = Vec::new();
    for step in &model.steps {
        let mut last = None;
        for load in step.loads.iter().filter(|load| seen.insert((load.node, load.dof))) {
            let card = Some((load.dof, load.origin, load.value.to_bits(), load.amplitude));
            match groups.last_mut().filter(|_| card == last && !load.dof.is_rotation()) {
                Some((_, nodes)) => nodes.push(load.node),
                None => groups.push((load.dof, vec![load.node])),
            }
            last = card;
        }
    }
    groups
}

fn pairs(model: &Model) -> Value {
    let labels = |nodes: &[NodeIndex]| -> Vec<u64> {
        nodes.iter().map(|&node| model.nodes.label(node)).collect()
    };
    let pairs = model.contact_pairs.iter().map(|pair| {
        let (master, nodes) = match &pair.master {
            Master::RigidSurface(surface) => ("rigid surface", labels(&[surface.reference])),
            Master::SlideLine(chain) => ("slide line", labels(&chain.nodes)),
            Master::Faces(faces) if faces.meets_itself => ("itself", labels(&faces.nodes())),
            Master::Faces(faces) => ("faces", labels(&faces.nodes())),
            Master::Itself(surface) => ("itself", labels(&surface.nodes().collect::<Vec<_>>())),
        };
        json!({
            "name": pair.name,
            "slave": labels(&pair.slave_nodes()),
            "master": master,
            "nodes": nodes,
            "normal": normal_law(&pair.interaction.normal),
            "friction": friction_law(&pair.interaction.friction),
        })
    });
    pairs.collect()
}

/// Settings that a deck may leave out, each with what ruled and whether that
/// is the default.
struct Settings(Vec<Value>);

impl Settings {
    fn say(&mut self, card: &str, name: &str, value: &str, default: bool) {
        self.0.push(json!({"card": card, "name": name, "value": value, "default": default}));
    }

    fn number(&mut self, card: &str, name: &str, value: f64, default: f64) {
        self.say(card, name, &general(value, 9), value.to_bits() == default.to_bits());
    }
}

fn settings(model: &Model) -> Value {
    let mut list = Settings(Vec::new());
    let dialect = model.dialect;
    list.say("program", "dialect", dialect.word(), dialect == Dialect::default());
    let onset = model.friction_onset;
    list.say("*CONTACT CONTROLS", "FRICTION ONSET", onset_word(onset), onset == Onset::Immediate);
    for block in &model.blocks {
        if let (Kinematics::Beam { sheared: true }, Section::Beam(section)) =
            (block.kind.kinematics, &block.section)
        {
            let shear = &section.shear;
            let card = format!("*BEAM SECTION {}", block.name);
            list.number(&card, "SCF", shear.slenderness_compensation, 0.25);
            match shear.stiffness {
                Some(given) => list.say(&card, "K23", &general(given, 9), false),
                None => list.say(&card, "K23", "k G A with k = 0.85", true),
            }
        }
    }
    for pair in &model.contact_pairs {
        if let Master::SlideLine(chain) = &pair.master {
            let card = format!("*SLIDE LINE {}", pair.name);
            match chain.smooth {
                Some(smooth) => list.number(&card, "SMOOTH", smooth, 0.0),
                None => list.say(&card, "SMOOTH", "through the nodes where it is round", true),
            }
            list.number(&card, "EXTENSION ZONE", chain.extension, 0.1);
        }
        let interaction = &pair.interaction;
        let card = format!("*INTERFACE {}", pair.name);
        let given = interaction.normal_origin.is_some();
        list.say(&card, "pressure-overclosure", &normal_law(&interaction.normal), !given);
        friction(&mut list, &card, &interaction.friction, interaction.friction_origin.is_some());
    }
    for (place, step) in model.steps.iter().enumerate() {
        controls(&mut list, place + 1, step);
    }
    list.0.into()
}

fn friction(list: &mut Settings, card: &str, friction: &Friction, given: bool) {
    list.say(card, "friction", &friction_law(friction), !given);
    if let Friction::Coulomb { limit, stick, .. } = friction {
        let (word, default) = match stick {
            StickRule::SlipTolerance(fraction) => (
                format!("SLIP TOLERANCE = {}", general(*fraction, 9)),
                StickRule::default() == *stick,
            ),
            StickRule::ElasticSlip(slip) => {
                (format!("ELASTIC SLIP = {}", general(*slip, 9)), false)
            }
            StickRule::Slope(slope) => (format!("slope = {}", general(*slope, 9)), false),
            StickRule::Lagrange => ("LAGRANGE".to_owned(), false),
        };
        list.say(card, "stick", &word, default);
        let limit = limit.map_or_else(|| "none".to_owned(), |limit| general(limit, 9).to_string());
        list.say(card, "TAUMAX", &limit, limit == "none");
    }
}

fn controls(list: &mut Settings, number: usize, step: &Step) {
    let Controls { field, discontinuous, .. } = &step.controls;
    let card = format!("*CONTROLS, step {number}");
    let default = FieldControls::default();
    list.number(&card, "R_n, residual tolerance", field.r_n, default.r_n);
    list.number(&card, "C_n, correction tolerance", field.c_n, default.c_n);
    list.number(&card, "R_p, residual tolerance after I_P", field.r_p, default.r_p);
    let (time, usual) = (step.controls.effective_time(), TimeIncrementation::default());
    let limits = [
        ("I_0", time.i_0, usual.i_0),
        ("I_R", time.i_r, usual.i_r),
        ("I_P", time.i_p, usual.i_p),
        ("I_C", time.i_c, usual.i_c),
        ("I_S", time.i_s, usual.i_s),
        ("I_A", time.i_a, usual.i_a),
    ];
    for (name, value, default) in limits {
        list.say(&card, name, &value.to_string(), value == default);
    }
    let kind = if *discontinuous { "DISCONTINUOUS" } else { "continuous" };
    list.say(&card, "ANALYSIS", kind, !discontinuous);
    let card = format!("*STEP {number}");
    list.say(&card, "NLGEOM", if step.nlgeom { "YES" } else { "NO" }, !step.nlgeom);
    list.say(&card, "INC", &step.max_increments.to_string(), step.max_increments == 100);
    let unsymmetric = match step.unsymmetric {
        Some(true) => "YES",
        Some(false) => "NO",
        None => "as the friction asks",
    };
    list.say(&card, "UNSYMM", unsymmetric, step.unsymmetric.is_none());
    let states = &step.output.states_every;
    let every: Vec<String> = states.iter().map(usize::to_string).collect();
    let every = if states.is_empty() { "1".to_owned() } else { every.join(" and ") };
    list.say(&card, "FREQUENCY of states", &every, states.is_empty());
    let extrapolation = format!("{:?}", step.extrapolation).to_ascii_uppercase();
    list.say(&card, "EXTRAPOLATION", &extrapolation, extrapolation == "LINEAR");
    if let Some(stabilisation) = &step.stabilisation {
        let card = format!("*CONTACT CONTROLS, step {number}");
        match stabilisation.coefficient {
            Some(coefficient) => list.say(&card, "damping", &general(coefficient, 9), false),
            None => list.number(&card, "STABILIZE", stabilisation.factor, 1.0),
        }
        list.number(&card, "TANGENT FRACTION", stabilisation.tangent_fraction, 1.0);
    }
}
