//! Halved meshes by hand.

#![allow(clippy::unwrap_used, clippy::cast_precision_loss)] // a test may fail where it stands

use super::*;
use crate::{
    BeamSection, ContactPair, ElementBlock, ElementType, Extrapolation, Formulation, Friction,
    Interaction, Lumping, NodalTemperature, NodeSet, NormalLaw, Passage, RigidSurface, Section,
    ShearRule, SlideLine, SolidSection, Static, Temperature, types,
};
use slideline_mech::material::{Elastic, LargeStrain, Material};

fn node(model: &mut Model, label: u64, x: f64, y: f64) -> NodeIndex {
    model.nodes.insert(Node { label, position: [x, y, 0.0], origin: Span::default() })
}

/// Elements by label and nodes.
fn block<const N: usize>(
    kind: &'static ElementType,
    elements: &[(u64, [NodeIndex; N])],
) -> ElementBlock {
    let material = Elastic { modulus: 1.0, poisson: 0.0 };
    let shear = ShearRule::default();
    let section = match kind.is_beam() {
        true => {
            let shape = slideline_mech::section::Shape::Rectangle { width: 1.0, height: 1.0 };
            let (poisson, heat, first_axis) = (0.0, None, BeamSection::FIRST_AXIS);
            Section::Beam(BeamSection { shape, poisson, material, heat, shear, first_axis })
        }
        false => Section::Solid(SolidSection {
            thickness: 1.0,
            material: Material::Elastic(material, LargeStrain::Logarithmic),
            orientation: None,
        }),
    };
    let elements = elements.iter().copied();
    ElementBlock::new(kind, "BEAM", section, Span::default()).with(elements)
}

fn pair(nodes: &[NodeIndex], master: Master) -> ContactPair {
    let elements = (1..).zip(nodes.windows(2)).map(|(label, ends)| ContactElement {
        label,
        nodes: [ends[0], ends[1]],
        lumping: Lumping::Halves,
        origin: Span::default(),
    });
    ContactPair {
        of_solids: false,
        name: "C".into(),
        is_piece: false,
        formulation: Formulation::NodeToSurface,
        vocabulary: crate::Vocabulary::Elements,
        elements: elements.collect(),
        adjust: crate::Adjust::Nothing,
        axes: [None; 2],
        left_out: Vec::new(),
        corners: Vec::new(),
        profile: None,
        offset: crate::Offset::NONE,
        slaves: Vec::new(),
        counts_sides: false,
        faces: Vec::new(),
        master,
        interaction: Interaction {
            width: 1.0,
            normal: NormalLaw::Hard,
            friction: Friction::Frictionless,
            origin: Span::default(),
            no_separation: false,
            normal_origin: None,
            friction_origin: None,
        },
        origin: Span::default(),
    }
}

/// Two beams from (0, 0) to (2, 0), labels 10 and 11, nodes 1 to 3.
fn two_beams() -> Model {
    let mut model = Model::default();
    let n: Vec<_> = (0..3).map(|k| node(&mut model, k + 1, k as f64, 0.0)).collect();
    model.blocks.push(block(&types::B21, &[(10, [n[0], n[1]]), (11, [n[1], n[2]])]));
    let members = vec![n[0], n[1]];
    model.node_sets.push(NodeSet { name: "LEFT".into(), members, origin: Span::default() });
    model
}

fn slide_line(nodes: Vec<NodeIndex>) -> Master {
    Master::SlideLine(SlideLine {
        nodes,
        middles: Vec::new(),
        smooth: Some(0.2),
        extension: 0.1,
        origin: Span::default(),
    })
}

#[test]
fn beams_sets_and_contact_elements_share_the_new_nodes() {
    let mut model = two_beams();
    let reference = node(&mut model, 99, 0.0, 5.0);
    let surface = RigidSurface {
        reference,
        start: [0.0; 2],
        segments: Vec::new(),
        extension: 0.0,
        origin: Span::default(),
    };
    model.contact_pairs.push(pair(&[0, 1, 2], Master::RigidSurface(surface)));
    let fine = refine(&model).unwrap();
    let beams = &fine.blocks[0].elements;
    let ends: Vec<_> = beams.iter().map(|b| b.ends().map(|n| fine.nodes.label(n))).collect();
    assert_eq!(ends, [[1, 100], [100, 2], [2, 101], [101, 3]]);
    assert_eq!(beams.iter().map(|b| b.label).collect::<Vec<_>>(), [10, 12, 11, 13]);
    let contact = &fine.contact_pairs[0].elements;
    let of = |k: usize| contact[k].nodes.map(|n| fine.nodes.label(n));
    assert_eq!([of(0), of(1), of(2), of(3)], ends[..]);
    assert_eq!(fine.node_sets[0].members, [0, 1, 4]); // 100 joins, 101 does not
    assert_eq!(fine.nodes.position(4), [0.5, 0.0, 0.0]);
    // again: four times as many
    assert_eq!(refine(&fine).unwrap().contact_pairs[0].elements.len(), 8);
}

#[test]
fn three_node_beams_keep_their_parabola() {
    let mut model = Model::default();
    let n = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)];
    let n: Vec<_> = (1..).zip(n).map(|(l, (x, y))| node(&mut model, l, x, y)).collect();
    model.blocks.push(block(&types::B22, &[(1, [n[0], n[1], n[2]])]));
    let fine = refine(&model).unwrap();
    let halves = &fine.blocks[0].elements;
    assert_eq!([halves.get(0).nodes, halves.get(1).nodes], [[0, 3, 1], [1, 4, 2]]);
    // y = 1 - (x - 1)2 at the quarters
    assert_eq!(
        [fine.nodes.position(3), fine.nodes.position(4)],
        [[0.5, 0.75, 0.0], [1.5, 0.75, 0.0]]
    );
}

/// Slave nodes on the rim of a body: unequal steps, one circle.
#[test]
fn rims_are_halved_on_their_circle() {
    let mut model = two_beams();
    let reference = node(&mut model, 99, 1.0, 3.0);
    let slaves: Vec<_> = (200..)
        .zip([-20.0_f64, -6.0, 0.0, 4.0])
        .map(|(label, degrees)| {
            let (s, c) = degrees.to_radians().sin_cos();
            node(&mut model, label, 1.0 + 2.0 * s, 3.0 - 2.0 * c)
        })
        .collect();
    for &dependent in &slaves {
        model.rigid_links.push(RigidLink::welded(dependent, reference, Span::default()));
    }
    model.contact_pairs.push(pair(&slaves, slide_line(vec![0, 1, 2])));
    let fine = refine(&model).unwrap();
    let contact = &fine.contact_pairs[0];
    assert_eq!(contact.elements.len(), 6);
    for node in contact.slave_nodes() {
        let [x, y, _] = fine.nodes.position(node);
        assert!(((x - 1.0).hypot(y - 3.0) - 2.0).abs() < 1e-12);
        assert!(fine.rigid_links.iter().any(|l| l.dependent == node && l.master == reference));
    }
    let Master::SlideLine(line) = &contact.master else { unreachable!("a slide line") };
    assert_eq!((line.nodes.len(), line.extension), (5, 0.2));
}

#[test]
fn what_cannot_be_halved_says_so() {
    // a corner on a body
    let mut model = two_beams();
    let reference = node(&mut model, 99, 1.0, 3.0);
    let corner = [(0.0, 1.0), (1.0, 1.0), (1.1, 1.5), (1.1, 3.0)];
    let slaves: Vec<_> =
        (200..).zip(corner).map(|(label, (x, y))| node(&mut model, label, x, y)).collect();
    for &dependent in &slaves {
        model.rigid_links.push(RigidLink::welded(dependent, reference, Span::default()));
    }
    model.contact_pairs.push(pair(&slaves, slide_line(vec![0, 1, 2])));
    let said = refine(&model).unwrap_err();
    assert_eq!(said.code.0, "SL0602");
    assert!(said.message.contains("circle"), "{}", said.message);
    // free points that no beam joins
    model.rigid_links.clear();
    assert!(refine(&model).unwrap_err().message.contains("no beam"));
}

#[test]
fn a_straight_rim_is_halved_on_its_line() {
    assert_eq!(sagitta([0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]), 0.0);
    // quarter circle about (0, 0) of radius 1: sagitta 1 - cos 45 degrees, outwards
    let s = sagitta([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]);
    assert!((s + (1.0 - 0.5f64.sqrt())).abs() < 1e-15, "{s}");
}

/// Two quadrilaterals side by side: eight, with the middle of the common side once.
#[test]
fn quadrilaterals_share_the_nodes_of_their_sides() {
    let mut model = Model::default();
    let places = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (0.0, 1.0)];
    let n: Vec<_> = (1..).zip(places).map(|(l, (x, y))| node(&mut model, l, x, y)).collect();
    let quads = [(7, [n[0], n[1], n[4], n[5]]), (8, [n[1], n[2], n[3], n[4]])];
    model.blocks.push(block(&types::CPE4, &quads));
    let fine = refine(&model).unwrap();
    assert_eq!(fine.nodes.len(), 15);
    let parts = &fine.blocks[0].elements;
    let labels: Vec<u64> = parts.iter().map(|part| part.label).collect();
    assert_eq!(labels, [7, 9, 10, 11, 8, 12, 13, 14]);
    let area = |nodes: &[NodeIndex]| {
        let at = |k: usize| fine.nodes.position(nodes[k % 4]);
        (0..4).map(|k| 0.5 * (at(k)[0] * at(k + 1)[1] - at(k)[1] * at(k + 1)[0])).sum::<f64>()
    };
    assert!(parts.iter().all(|part| (area(part.nodes) - 0.25).abs() < 1e-15));
    assert_eq!(refine(&fine).unwrap().blocks[0].elements.len(), 32);
}

/// Requirement: a new node has the mean temperatures of the two between which it stands, before the
/// first step and in a step, where one of them may be named by initial conditions alone; where they
/// follow different curves the mesh is not halved.
#[test]
fn new_nodes_have_the_mean_of_temperatures() {
    let mut model = two_beams();
    let at = |value: f64, slope: f64| Temperature { value, slopes: [slope, 0.5 * slope] };
    model.initial_temperatures = vec![at(10.0, 0.0), at(20.0, 2.0), at(40.0, 0.0)];
    let own = |node, temperature, amplitude| NodalTemperature {
        node,
        temperature,
        amplitude,
        origin: Span::default(),
    };
    let temperatures = vec![own(0, at(100.0, 4.0), None), own(1, at(200.0, 8.0), None)];
    model.steps.push(Step {
        title: String::new(),
        nlgeom: true,
        max_increments: 100,
        unsymmetric: None,
        extrapolation: Extrapolation::Linear,
        at_once: false,
        procedure: Static {
            initial: 1.0,
            period: 1.0,
            minimum: 1e-5,
            maximum: 1.0,
            direct: false,
            passage: Passage::Still,
            creep_tolerance: None,
            origin: None,
        },
        prescribed: Vec::new(),
        loads: Vec::new(),
        distributed: crate::Distributed::default(),
        temperatures,
        controls: crate::Controls::default(),
        presence: Presence::default(),
        frictions: vec![],
        pressures: vec![],
        sections: vec![],
        interferences: vec![],
        stabilisation: None,
        output: crate::OutputRequests::default(),
        origin: Span::default(),
    });
    let halved = refine(&model).unwrap();
    let initial = [at(10.0, 0.0), at(20.0, 2.0), at(40.0, 0.0), at(15.0, 1.0), at(30.0, 1.0)];
    assert_eq!(halved.initial_temperatures, initial);
    let named: Vec<_> =
        halved.steps[0].temperatures.iter().map(|own| (own.node, own.temperature)).collect();
    let exact =
        [(0, at(100.0, 4.0)), (1, at(200.0, 8.0)), (3, at(150.0, 6.0)), (4, at(120.0, 4.0))];
    assert_eq!(named, exact);
    model.steps[0].temperatures[1].amplitude = Some(0);
    assert_eq!(refine(&model).unwrap_err().code.0, "SL0602");
}
