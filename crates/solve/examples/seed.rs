//! Scratch.
use slideline_diag::Span;
use slideline_mech::material::Elastic;
use slideline_model::*;
use slideline_solve::observe::*;
use slideline_solve::{Options, run};
use std::ops::ControlFlow;

fn base(elements: usize, increments: usize) -> Model {
    let mut model = Model::default();
    let o = Span::default();
    for k in 0..=elements {
        let t = k as f64 / elements as f64;
        model.nodes.insert(Node { label: k as u64 + 1, position: [7e-3 + t * (9.222e-3 - 7e-3), t * 50e-3, 0.0], origin: o });
    }
    model.blocks.push(ElementBlock::B21(BeamBlock {
        name: "BEAM".into(),
        section: BeamSection { width: 25e-3, height: 1.5e-3, poisson: 0.3, material: Elastic { modulus: 6.9e9, poisson: 0.3 }, shear: ShearRule::default() },
        elements: (0..elements).map(|k| BeamElement { label: 101 + k as u64, nodes: [k, k + 1], origin: o }).collect(),
        origin: o,
    }));
    let center = model.nodes.insert(Node { label: 9999, position: [0.0, 45e-3, 0.0], origin: o });
    let p = |node, dof, value| Prescribed { node, dof, value, amplitude: None, origin: o };
    let dt = 1.0 / increments as f64;
    model.steps.push(Step {
        title: "MOVE".into(), nlgeom: true, max_increments: 10000, unsymmetric: None, extrapolation: Extrapolation::Linear, at_once: false,
        procedure: Static { initial: dt, period: 1.0, minimum: 1e-6, maximum: dt, direct: false, origin: None },
        prescribed: vec![p(0, Dof::U1, 0.), p(0, Dof::U2, 0.), p(0, Dof::UR3, 0.), p(center, Dof::U1, 0.), p(center, Dof::UR3, 0.), p(center, Dof::U2, -30e-3)],
        loads: vec![], controls: Controls { discontinuous: true, ..Controls::default() }, output: OutputRequests::default(), origin: o,
    });
    model
}
fn interaction(mu: f64, lagrange: bool, hard: bool) -> Interaction {
    let o = Span::default();
    Interaction { width: 25e-3, normal: if hard { NormalLaw::Hard } else { NormalLaw::Exponential { clearance: 1e-5, pressure: 4.8e6 } },
        friction: if mu == 0.0 { Friction::Frictionless } else { Friction::Coulomb { coefficient: mu, limit: None, decay: None, stick: if lagrange { StickRule::Lagrange } else { StickRule::default() } } },
        origin: o, normal_origin: None, friction_origin: None }
}
fn irs(elements: usize, increments: usize, mu: f64, lagrange: bool, hard: bool) -> Model {
    let mut m = base(elements, increments);
    let o = Span::default();
    let center = m.nodes.find(9999).unwrap();
    m.contact_pairs.push(ContactPair { name: "IRS".into(),
        elements: (1..elements).map(|k| ContactElement { label: 9900 + k as u64, nodes: [k, k + 1], origin: o }).collect(),
        master: Master::RigidSurface(RigidSurface { reference: center, start: [0., 54e-3],
            segments: vec![SurfaceSegment::Circle { end: [9e-3, 45e-3], centre: [0., 45e-3] }, SurfaceSegment::Circle { end: [0., 36e-3], centre: [0., 45e-3] }], origin: o }),
        interaction: interaction(mu, lagrange, hard), origin: o });
    m
}
fn isl(elements: usize, increments: usize, mu: f64, lagrange: bool, hard: bool, smooth: f64) -> Model {
    let mut m = base(elements, increments);
    let o = Span::default();
    let center = m.nodes.find(9999).unwrap();
    let mut ids = vec![];
    for k in 0..=30 {
        let th: f64 = if k <= 10 { 6.0 * k as f64 } else if k <= 20 { 60.0 + 4.0 * (k - 10) as f64 } else { 100. + 8. * (k - 20) as f64 };
        let (s, c) = th.to_radians().sin_cos();
        ids.push(m.nodes.insert(Node { label: 9000 + k as u64, position: [9e-3 * s, 45e-3 - 9e-3 * c, 0.0], origin: o }));
    }
    for &d in &ids { m.rigid_links.push(RigidLink { dependent: d, master: center, origin: o }); }
    m.contact_pairs.push(ContactPair { name: "ISL".into(),
        elements: (0..20).map(|k| ContactElement { label: 9900 + k as u64, nodes: [ids[k], ids[k + 1]], origin: o }).collect(),
        master: Master::SlideLine(SlideLine { nodes: (1..=elements).collect(), smooth, extension: 0.1, origin: o }),
        interaction: interaction(mu, lagrange, hard), origin: o });
    m
}
struct Watch { verbose: u8, center: usize, rf: Vec<[f64; 2]>, its: usize, severe: usize, energy: Energies, drops: usize }
impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Iteration(r) if self.verbose > 1 => println!("   {}{} r {:.3e} allowed {:.3e} c {:.3e} m {:.3e}/{:.3e} closed {} {}", r.iteration, if r.severe { " SDI" } else { "" }, r.force.residual, r.force.allowed, r.force.correction, r.moment.residual, r.moment.allowed, r.closed, r.converged),
            Event::Committed(f) => {
                self.rf.push([f.nodal.reaction(self.center, Dof::U1), f.nodal.reaction(self.center, Dof::U2)]);
                self.its += f.equilibrium_iterations + f.severe_iterations; self.severe += f.severe_iterations;
                self.energy = f.energy;
                self.drops += f.contact.iter().filter(|c| c.friction == FrictionCall::Dropped).count();
                if self.verbose > 0 { println!("inc {} its {} sdi {} RF1 {:.9} RF2 {:.9}", f.increment, f.equilibrium_iterations + f.severe_iterations, f.severe_iterations, self.rf.last().unwrap()[0], self.rf.last().unwrap()[1]); }
            }
            Event::AttemptFailed(a) => println!("  FAILED inc {} attempt {} sdi {} eq {} {}", a.increment, a.attempt, a.severe_iterations, a.equilibrium_iterations, a.reason),
            Event::StepBegin(s) if self.verbose > 0 => println!("{} equations, {}", s.equations, s.linear_solver),
            Event::End(e) => println!("{e:?}"),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let n: usize = a[2].parse().unwrap();
    let inc: usize = a[3].parse().unwrap();
    let mu: f64 = a[4].parse().unwrap();
    let has = |w: &str| a.iter().any(|x| x == w);
    let mut m = if a[1] == "irs" { irs(n, inc, mu, has("lagrange"), has("hard")) } else { isl(n, inc, mu, has("lagrange"), has("hard"), if has("nosmooth") { 0.0 } else { 0.25 }) };
    if has("matfru") { m.friction_onset = Onset::Matfru; }
    if has("noextra") { m.steps[0].extrapolation = Extrapolation::None; }
    if has("para") { m.steps[0].extrapolation = Extrapolation::Parabolic; }
    if has("5e-3") { m.steps[0].controls.field.r_n = 5e-3; m.steps[0].controls.field.r_p = 2e-2; }
    let center = m.nodes.find(9999).unwrap();
    let mut w = Watch { verbose: if has("vv") { 2 } else if has("v") { 1 } else { 0 }, center, rf: vec![], its: 0, severe: 0, energy: Energies::default(), drops: 0 };
    let t = std::time::Instant::now();
    run(&m, &Options::default(), &mut w);
    let t = t.elapsed();
    println!("{:?} iterations/inc {:.2} severe {} last {:?} {:?} energy {:?} drops {}", t, w.its as f64 / w.rf.len() as f64, w.severe, w.rf.last(), w.rf.len(), w.energy, w.drops);
}
