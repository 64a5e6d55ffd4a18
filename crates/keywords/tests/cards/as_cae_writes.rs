//! Decks in the words of the programs that write them: parts and instances, internal sets, springs
//! between parts, node surfaces with areas, controls of a pair.

use slideline_diag::Severity;
use slideline_keywords::{Interpreted, interpret};
use slideline_model::{Dialect, Model};

fn read(deck: &str, dialect: Dialect) -> Interpreted {
    let mut sources = slideline_diag::Sources::default();
    let parsed =
        slideline_deck::parse(&mut sources, "a.inp", deck.as_bytes(), &slideline_deck::NoFiles);
    interpret(&parsed, dialect)
}

fn errors(deck: &str, dialect: Dialect) -> Vec<String> {
    let said = read(deck, dialect).diagnostics;
    let errors = said.into_iter().filter(|said| said.severity == Severity::Error);
    errors.map(|said| format!("{} {}", said.code, said.message)).collect()
}

fn model(deck: &str) -> Model {
    assert_eq!(errors(deck, Dialect::Abaqus), [""; 0], "{deck}");
    read(deck, Dialect::Abaqus).model
}

/// A ring under a tool; `assembly` stands at the end of the assembly, `history` in the step.
fn seal(assembly: &str, history: &str) -> String {
    format!(
        "*Heading\n** Job name: seal Model name: Model-1\n*Preprint, echo=NO, model=NO, history=NO, \
         contact=NO\n*Part, name=RING\n*Node\n1, 10., 0.\n2, 12., 0.\n3, 12., 2.\n4, 10., 2.\n\
         *Element, type=CAX4RH\n1, 1, 2, 3, 4\n*Nset, nset=\"all of it\", generate\n 1,  4,  1\n\
         *Elset, elset=Set-1\n 1,\n*Solid Section, elset=Set-1, material=RUBBER\n,\n*End Part\n\
         *Part, name=TOOL\n*Node\n1, 0., 0., 0.\n*Nset, nset=TOOL-RefPt_, internal\n1, \n\
         *Surface, type=SEGMENTS, name=RigidSurface_, internal\nSTART, 20., 0.\nLINE, 0., 0.\n\
         *Rigid Body, ref node=TOOL-RefPt_, analytical surface=RigidSurface_\n*End Part\n\
         *Assembly, name=Assembly\n*Instance, name=RING-1, part=RING\n*End Instance\n\
         *Instance, name=TOOL-1, part=TOOL\n0., 2.2, 0.\n*End Instance\n\
         *Nset, nset=bot, instance=RING-1\n1, 2\n*Nset, nset=rp, instance=TOOL-1\n1,\n\
         *Elset, elset=_top_S3, internal, instance=RING-1\n1,\n*Surface, type=ELEMENT, name=top\n\
         _top_S3, S3\n{assembly}*End Assembly\n*Material, name=RUBBER\n*Hyperelastic, n=1, neo hooke\n\
         0.5, 0.04\n*Surface Interaction, name=IntProp-1\n1.,\n*Friction, slip tolerance=0.005\n\
         0.1,\n*Surface Behavior, pressure-overclosure=HARD\n*Boundary\nbot, 1, 2\nrp, 1, 1\nrp, 6, 6\n\
         *Contact Pair, interaction=IntProp-1, type=SURFACE TO SURFACE, adjust=0.0\n\
         top, TOOL-1.RigidSurface_\n*Step, name=Step-1, nlgeom=YES, inc=1000\n*Static\n\
         0.1, 1., 1e-05, 0.1\n*Boundary\nrp, 2, 2, -0.6\n{history}*Restart, write, frequency=0\n\
         *Output, field, variable=PRESELECT\n*Output, history, variable=PRESELECT\n*End Step\n"
    )
}

/// Requirement: springs of the assembly name nodes of instances, in both orders of the cards.
#[test]
fn springs_between_parts() {
    let spring = "*Element, type=SPRINGA, elset=Springs/Dashpots-1-spring\n1, RING-1.3, TOOL-1.1\n\
                  *Spring, elset=Springs/Dashpots-1-spring\n\n1.\n";
    let made = model(&seal(spring, ""));
    let ends = |model: &Model| {
        let springs = model.blocks.iter().filter(|block| block.kind.name() == "SPRINGA");
        let nodes =
            springs.flat_map(|block| block.elements.iter().flat_map(|own| own.nodes.to_vec()));
        nodes.map(|node| model.nodes.name(node).to_string()).collect::<Vec<_>>()
    };
    assert_eq!(ends(&made), ["RING-1.3", "TOOL-1.1"]);
    let unknown = errors(&seal(&spring.replace("RING-1.3", "RIM-1.3"), ""), Dialect::Abaqus);
    assert!(unknown.iter().any(|said| said.starts_with("SL0117")), "{unknown:?}");
}

/// Requirement: node surfaces carry the areas that CAE programs write, in couplings; names of sets
/// with blanks are found behind the name of their instance.
#[test]
fn node_surfaces_with_areas_and_quoted_names() {
    let coupling = "*Node\n50, 11., 5.\n*Nset, nset=RP2\n50\n*Nset, nset=tt, instance=RING-1\n3, 4\n\
                    *Surface, type=NODE, name=tt_CNS_, internal\ntt, 1.\n*Coupling, constraint \
                    name=C1, ref node=RP2, surface=tt_CNS_\n*Distributing, weighting method=UNIFORM\n";
    assert!(!model(&seal(coupling, "")).linear_constraints.is_empty());
    let quoted =
        model(&seal("*Nset, nset=every\nRING-1.\"all of it\"\n", "*Cload\nevery, 2, -1.\n"));
    assert_eq!(quoted.steps[0].loads.len(), 4);
}

/// Requirement: controls of one pair are read: what they stabilise vanishes by the end of the step.
#[test]
fn controls_of_a_pair() {
    let controls = "*Contact Controls, master=TOOL-1.RigidSurface_, slave=top, reset\n\
                    *Contact Controls, master=TOOL-1.RigidSurface_, slave=top, stabilize=1.\n";
    assert!(model(&seal("", controls)).steps[0].stabilisation.is_some());
}

/// Requirement: one message a cause: where the material of solids in space is refused, nobody hears
/// that a load leaves the plane.
#[test]
fn a_refused_material_is_said_alone() {
    let deck = "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 1., 0.\n4, 0., 0., 1.\n*ELEMENT, \
                TYPE=C3D4, ELSET=E\n1, 1, 2, 3, 4\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, \
                NAME=M\n*ELASTIC\n1000., .3\n*PLASTIC, HARDENING=JOHNSON COOK\n1., 2.\n*STEP\n*STATIC\n\
                *BOUNDARY\n1, 1, 3\n2, 2, 3\n3, 3\n*CLOAD\n4, 3, 1.\n*END STEP\n";
    let said = errors(deck, Dialect::Abaqus);
    assert_eq!(said.len(), 1, "{said:?}");
    assert!(said[0].starts_with("SL0207"), "{said:?}");
}

/// Requirement: a total time that does not run on is refused beside a curve that runs over it.
#[test]
fn a_total_time_that_begins_anew() {
    let deck = |time: &str| {
        format!(
            "*NODE\n1, 0., 0.\n2, 1., 0.\n*ELEMENT, TYPE=T2D2, ELSET=E\n1, 1, 2\n*SOLID SECTION, \
             ELSET=E, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*AMPLITUDE, NAME=A{time}\n\
             0., 0., 9., 9.\n*STEP\n*STATIC, TOTAL TIME AT START=1.\n1., 1.\n*BOUNDARY\n1, 1, 2\n2, 2\n\
             *CLOAD, AMPLITUDE=A\n2, 1, 1.\n*END STEP\n"
        )
    };
    assert_eq!(errors(&deck(""), Dialect::Calculix), [""; 0]);
    let said = errors(&deck(", TIME=TOTAL TIME"), Dialect::Calculix);
    assert!(said.len() == 1 && said[0].starts_with("SL0221"), "{said:?}");
}

/// Requirement: mass that is added and would weigh is not passed over; without gravity it is.
#[test]
fn added_mass_that_weighs() {
    let deck = |load: &str| {
        format!(
            "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 1., 0.\n4, 0., 0., 1.\n*ELEMENT, TYPE=C3D4, \
             ELSET=E\n1, 1, 2, 3, 4\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n\
             1000., .3\n*DENSITY\n1.\n*NONSTRUCTURAL MASS, ELSET=E, UNITS=TOTAL MASS\n1.\n*STEP\n*STATIC\n\
             *SOLVER CONTROLS\n1e-3\n*BOUNDARY\n1, 1, 3\n2, 2, 3\n3, 3\n*DLOAD\n{load}\n*END STEP\n"
        )
    };
    assert_eq!(errors(&deck("E, P1, 1."), Dialect::Abaqus), [""; 0]);
    let said = errors(&deck("E, GRAV, 1., 0., 0., -1."), Dialect::Abaqus);
    assert!(said.len() == 1 && said[0].starts_with("SL0221"), "{said:?}");
}

/// Requirement: field variables, on which nothing depends here, are noted and change nothing, as initial
/// conditions and in steps; constants that depend on them are refused.
#[test]
fn fields_have_no_effect() {
    let field = "*Field, variable=1\nRING-1.\"all of it\", 1.\n";
    let said = read(&seal("", field), Dialect::Abaqus).diagnostics;
    let notes = said.iter().filter(|own| own.code.0 == "SL0257" && own.message.contains("FIELD"));
    assert_eq!(notes.count(), 1, "{said:#?}");
    assert_eq!(errors(&seal("", field), Dialect::Abaqus), [""; 0]);
    let begun = seal("", "").replace(
        "*Step,",
        "*Initial Conditions, type=FIELD, variable=1\nRING-1.\"all of it\", 1.\n*Step,",
    );
    assert_eq!(errors(&begun, Dialect::Abaqus), [""; 0]);
    let depends = begun.replace("*Hyperelastic, n=1, neo hooke", "*Elastic, dependencies=1");
    assert!(errors(&depends, Dialect::Abaqus).iter().any(|own| own.contains("dependencies")));
}
