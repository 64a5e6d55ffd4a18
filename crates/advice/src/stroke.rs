//! Where prescribed motions lead the contact point.

use crate::finding::{Finding, Place};
use crate::moments::{Carrier, Rehearsal};
use crate::sides::SurfacePoints;
use crate::start::{Start, arc_of, circle_of, length, less, spacing};
use slideline_diag::{Code, Diagnostic, Severity};
use slideline_model::{
    ContactPair, Master, NodeIndex, Onset, RigidSurface, SlideLine, Step, SurfaceSegment,
};

/// SL0405, SL0406 and SL0408.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for (place, pair) in start.model.contact_pairs.iter().enumerate() {
        match start.rehearsals.get(place) {
            Some(Some(rehearsal)) => rehearsed(start, pair, rehearsal, findings),
            _ => estimated(start, place, pair, findings),
        }
    }
}

/// Where all motions are prescribed, the pair was walked through them.
fn rehearsed(
    start: &Start<'_>,
    pair: &ContactPair,
    rehearsal: &Rehearsal,
    findings: &mut Vec<Finding>,
) {
    let on_master = matches!(pair.master, Master::SlideLine(_));
    let mut lost = None;
    for (number, step) in start.model.steps.iter().enumerate() {
        let slides: Vec<(Carrier, Carrier)> = rehearsal
            .slides()
            .filter_map(|(at, from, to)| (at == number).then_some((from, to)))
            .collect();
        if slides.is_empty() {
            continue;
        }
        let passed = |(from, to): &(Carrier, Carrier)| match on_master {
            true => (to.along - from.along).abs(),
            false => (to.slave - from.slave).abs(),
        };
        let each = slides.iter().map(passed).sum::<f64>() / slides.len() as f64;
        findings.extend(too_far(start, pair, step, each));
        let changed = slides.iter().filter(|(from, to)| from.node != to.node).count();
        let share = changed as f64 / slides.len() as f64;
        if lost.is_none_or(|(worst, _)| share > worst) {
            let wander = slides.iter().map(|(from, to)| (to.slave - from.slave).abs());
            lost = Some((share, wander.sum::<f64>() / slides.len() as f64));
        }
    }
    if let Some((share, wander)) = lost.filter(|(share, _)| *share >= 0.5) {
        findings.extend(loses_friction(start, pair, wander, share));
    }
    let lost = rehearsal.moments.iter().find_map(|moment| Some((moment.step, moment.off?)));
    if let Some((number, (beyond, at_start))) = lost {
        let said = off_the_end(pair, number, beyond);
        findings.push(match &pair.master {
            Master::RigidSurface(surface) => {
                let text = prolonged(surface, at_start, start.size());
                Finding::with(said, Place::Data(surface.origin), text)
            }
            _ => Finding::said(said),
        });
    } else if rehearsal.moments.first().is_some_and(|moment| moment.carrier.is_some()) {
        findings.extend(drifts_off(start, pair));
    }
}

/// SL0408 as advice: what touches at first is led past the end of the slide
/// line, although a rigid body would lift off before.
fn drifts_off(start: &Start<'_>, pair: &ContactPair) -> Option<Finding> {
    let Master::SlideLine(line) = &pair.master else { return None };
    let place = start.model.contact_pairs.iter().position(|own| own == pair)?;
    let nearest = start.nearest(place)?;
    let tangent = [nearest.normal[1], -nearest.normal[0]];
    let mut passed = 0.0;
    (0..start.model.steps.len()).find_map(|number| {
        let travel = start.travel(number, pair, nearest);
        passed += travel[0] * tangent[0] + travel[1] * tangent[1];
        let mut finding = too_short(start, (place, pair), line, passed)?;
        finding.diagnostic.severity = Severity::Advice;
        Some(finding)
    })
}

/// Where something floats, the nearest slave is led along straight.
fn estimated(start: &Start<'_>, place: usize, pair: &ContactPair, findings: &mut Vec<Finding>) {
    if matches!(pair.master, Master::Faces(_) | Master::Itself(_)) {
        return; // there is no one way along
    }
    let Some(nearest) = start.nearest(place) else { return };
    // tangent: 90 degrees clockwise of the master's outward normal
    let tangent = [nearest.normal[1], -nearest.normal[0]];
    let mut along = 0.0;
    for (number, step) in start.model.steps.iter().enumerate() {
        let travel = start.travel(number, pair, nearest);
        let slide = travel[0] * tangent[0] + travel[1] * tangent[1];
        along += slide;
        let each = slide.abs() * fraction(step);
        let slave_side = circle_of(pair).is_some() || matches!(pair.master, Master::SlideLine(_));
        if slave_side {
            findings.extend(too_far(start, pair, step, each));
        }
        let turn = start.rotation(number, nearest.node) * fraction(step);
        let wander = match &pair.master {
            Master::RigidSurface(_) if slave_side => each,
            Master::RigidSurface(_) | Master::Faces(_) | Master::Itself(_) => 0.0,
            Master::SlideLine(_) => arc_of(start.model, pair, nearest.node)
                .map_or(0.0, |(_, radius)| radius * turn.abs()),
        };
        let share = (wander / spacing(start.model, pair)).min(1.0);
        if share >= 0.5 {
            findings.extend(loses_friction(start, pair, wander, share));
        }
        if let Master::SlideLine(line) = &pair.master {
            let mut said = too_short(start, (place, pair), line, along);
            let mut sides = std::iter::once(nearest.node).chain(line.nodes.first().copied());
            if let Some(said) = &mut said
                && sides.any(|node| goes_along(start, step, node))
            {
                said.diagnostic.severity = Severity::Advice;
            }
            findings.extend(said);
        }
    }
}

/// Whether no support holds the body of a node in a step: a roller goes along with what it touches, by how much is not
/// known before.
fn goes_along(start: &Start<'_>, step: &Step, node: NodeIndex) -> bool {
    let body = start.bodies.of_node(node);
    !step.prescribed.iter().any(|own| start.bodies.of_node(own.node) == body)
}

/// The first increment as a fraction of its step [1].
fn fraction(step: &Step) -> f64 {
    let procedure = &step.procedure;
    (procedure.initial.min(procedure.maximum) / procedure.period).clamp(0.0, 1.0)
}

/// Length of the pieces that the contact point passes [L].
fn pieces(start: &Start<'_>, pair: &ContactPair) -> f64 {
    match &pair.master {
        Master::RigidSurface(_) | Master::Faces(_) | Master::Itself(_) => {
            spacing(start.model, pair)
        }
        Master::SlideLine(line) => line_length(start, line) / (line.nodes.len().max(2) - 1) as f64,
    }
}

fn line_length(start: &Start<'_>, line: &SlideLine) -> f64 {
    let at = |node| start.model.nodes.position(node);
    line.nodes.windows(2).map(|w| length(less(at(w[1]), at(w[0])))).sum()
}

/// SL0405: more than one segment passes in an increment.
fn too_far(start: &Start<'_>, pair: &ContactPair, step: &Step, each: f64) -> Option<Finding> {
    let piece = pieces(start, pair);
    if each <= piece || piece <= 0.0 {
        return None;
    }
    let message = format!(
        "an increment moves the contact point of {} by about {each:.3e}, {:.1} segments of \
         {piece:.3e}: what happens in between is missed, and mesh noise is aliased",
        pair.name,
        each / piece
    );
    let procedure = &step.procedure;
    let initial = procedure.initial.min(procedure.maximum) * piece / each;
    let card = format!(
        "*STATIC\n{initial:.4E}, {:?}, {:.4E}, {initial:.4E}\n",
        procedure.period,
        procedure.minimum.min(initial)
    );
    let said = Diagnostic::advice(Code("SL0405"), message)
        .at(procedure.origin.unwrap_or(step.origin))
        .help(format!("for a smooth history use increments of {initial:.3e} or less on *STATIC"));
    Some(match procedure.origin {
        Some(origin)
            if !procedure.direct && step.max_increments as f64 > procedure.period / initial =>
        {
            Finding::with(said, Place::Instead(origin), card)
        }
        _ => Finding::said(said),
    })
}

/// SL0406: a new slave in every increment, whose friction the onset drops.
/// Diehl (1995), sections 2.0 and 3.0.
fn loses_friction(
    start: &Start<'_>,
    pair: &ContactPair,
    wander: f64,
    share: f64,
) -> Option<Finding> {
    let model = start.model;
    if model.friction_onset == Onset::Immediate || !pair.interaction.has_friction() {
        return None;
    }
    let spacing = spacing(model, pair);
    let message = format!(
        "contact of {} moves by about {wander:.3e} in an increment over slaves {spacing:.3e} \
         apart: about {:.0} of 100 increments close a new node, and the friction onset of this \
         run drops friction at nodes that have just closed",
        pair.name,
        100.0 * share
    );
    let said = Diagnostic::warning(Code("SL0406"), message)
        .at(pair.interaction.friction_origin.unwrap_or(pair.origin))
        .help(
            "let friction act from the first contact on: *CONTACT CONTROLS, FRICTION \
             ONSET=IMMEDIATE",
        );
    let first = model.steps.first()?.origin;
    let card = "*CONTACT CONTROLS, FRICTION ONSET=IMMEDIATE\n";
    Some(Finding::with(said, Place::Before(first), card))
}

/// SL0408: everything that was in contact ends beyond the master.
fn off_the_end(pair: &ContactPair, number: usize, beyond: f64) -> Diagnostic {
    let (what, help, origin) = match &pair.master {
        Master::Faces(faces) => (
            "surface",
            "name the faces beyond its edge too, or end the motion earlier on *BOUNDARY".to_owned(),
            faces.origin,
        ),
        Master::Itself(surface) => (
            "surface",
            "name the faces beyond its end too, or end the motion earlier on *BOUNDARY".to_owned(),
            surface.origin,
        ),
        Master::SlideLine(line) => (
            pair.vocabulary.chain(),
            format!(
                "{} on that side, or end the motion earlier on *BOUNDARY",
                pair.vocabulary.lengthen_chain()
            ),
            line.origin,
        ),
        Master::RigidSurface(surface) => (
            "rigid surface",
            format!(
                "extend {} on that side by a LINE, or end the motion earlier on *BOUNDARY",
                pair.vocabulary.rigid_surface()
            ),
            surface.origin,
        ),
    };
    let message = format!(
        "the {what} of {} is too short for the stroke: in step {} all slaves that were in contact \
         go beyond its end, by {beyond:.3e} in the first increment in which none is left, and \
         contact is lost there although the parts still overlap",
        pair.name,
        number + 1
    );
    Diagnostic::warning(Code("SL0408"), message).at(origin).help(help)
}

/// The points of a rigid surface with a line more at one end, as long as the
/// model.
fn prolonged(surface: &RigidSurface, at_start: bool, by: f64) -> String {
    let way = slideline_solve::rigid_surface(surface).and_then(|placed| {
        let segments = placed.segments();
        let end = if at_start { segments.first() } else { segments.last() };
        end.map(|segment| segment.tangent(at_start))
    });
    let [tx, ty] = way.unwrap_or([0.0; 2]);
    let mut points = SurfacePoints::of(surface);
    if at_start {
        let [x, y] = points.start;
        points.segments.insert(0, SurfaceSegment::Line { end: [x, y] });
        points.start = [x - by * tx, y - by * ty];
    } else {
        let [x, y] = surface.segments.last().map_or(surface.start, SurfaceSegment::end);
        points.segments.push(SurfaceSegment::Line { end: [x + by * tx, y + by * ty] });
    }
    points.lines()
}

/// SL0408: a way that leads all slaves that are about as near as the nearest beyond an end of the slide line.
fn too_short(
    start: &Start<'_>,
    (place, pair): (usize, &ContactPair),
    line: &SlideLine,
    passed: f64,
) -> Option<Finding> {
    let near = start.nearest(place)?.opening + spacing(start.model, pair);
    let places: Option<Vec<(f64, NodeIndex)>> = start
        .facing(place)
        .filter(|row| row.opening <= near)
        .map(|row| beyond_end(start, line, row.along + passed))
        .collect();
    let (beyond, node) = places?.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let message = format!(
        "the {} of {} is too short for the stroke: the contact point would end about \
         {beyond:.3e} beyond node {}, and contact is lost there",
        pair.vocabulary.chain(),
        pair.name,
        start.model.nodes.name(node)
    );
    Some(Finding::said(Diagnostic::warning(Code("SL0408"), message).at(line.origin).help(format!(
        "{} on that side, or end the motion earlier on *BOUNDARY",
        pair.vocabulary.lengthen_chain()
    ))))
}

/// How far a place is beyond an end of a slide line [L], and that end.
fn beyond_end(start: &Start<'_>, line: &SlideLine, reached: f64) -> Option<(f64, NodeIndex)> {
    let at = |node| start.model.nodes.position(node);
    let whole = line_length(start, line);
    let ends = [
        line.nodes.first()?,
        line.nodes.get(1)?,
        line.nodes.iter().rev().nth(1)?,
        line.nodes.last()?,
    ];
    let before = line.extension * length(less(at(*ends[1]), at(*ends[0])));
    let after = line.extension * length(less(at(*ends[3]), at(*ends[2])));
    if reached < -before {
        Some((-before - reached, *ends[0]))
    } else if reached > whole + after {
        Some((reached - whole - after, *ends[3]))
    } else {
        None
    }
}
