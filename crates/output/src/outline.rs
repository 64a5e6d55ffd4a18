//! Rigid surfaces as chains of points that move with their bodies.
//!
//! ```text
//!      .---.
//!     (  x  )   chords; x: the node that carries them
//! ```

use slideline_model::{Dof, Master, Model, NodeIndex, ProfilePoint, RigidSurface, SurfaceSegment};
use slideline_solve::observe::Frame;

/// Chords of an arc or parabola per segment; at most 7.5 degrees of arc.
const CHORDS: u32 = 24;

/// A rigid surface as a chain of points, undeformed.
pub(crate) struct Outline {
    /// The node that carries it.
    pub reference: NodeIndex,
    pub points: Vec<ProfilePoint>,
}

/// The outlines of a model, in the order of its contact pairs.
pub(crate) fn outlines(model: &Model) -> Vec<Outline> {
    let masters = model.contact_pairs.iter().filter_map(|pair| match &pair.master {
        Master::RigidSurface(surface) => Some(surface),
        Master::SlideLine(_) => None,
    });
    masters.map(outline).collect()
}

impl Outline {
    /// Where one of its points is: x = x_ref + R(phi) (X - X_ref).
    /// [semantics: segments of a rigid surface]
    pub fn carried(&self, frame: &Frame<'_>, point: ProfilePoint) -> ProfilePoint {
        let reference = self.reference;
        let origin = frame.model.nodes.position(reference);
        let moved = |dof| frame.nodal.displacement(reference, dof);
        let (sine, cosine) = moved(Dof::UR3).sin_cos();
        let arm = [point[0] - origin[0], point[1] - origin[1]];
        [
            origin[0] + moved(Dof::U1) + cosine * arm[0] - sine * arm[1],
            origin[1] + moved(Dof::U2) + sine * arm[0] + cosine * arm[1],
        ]
    }
}

fn outline(surface: &RigidSurface) -> Outline {
    let mut points = vec![surface.start];
    let mut at = surface.start;
    for segment in &surface.segments {
        at = match *segment {
            SurfaceSegment::Line { end } => {
                points.push(end);
                end
            }
            SurfaceSegment::Circle { end, centre } => {
                push_arc(&mut points, at, end, centre);
                end
            }
            SurfaceSegment::Parabola { middle, end } => {
                push_parabola(&mut points, [at, middle, end]);
                end
            }
        };
    }
    Outline { reference: surface.reference, points }
}

/// The shorter arc from `from` to `end`.
fn push_arc(
    points: &mut Vec<ProfilePoint>,
    from: ProfilePoint,
    end: ProfilePoint,
    centre: ProfilePoint,
) {
    let arm = [from[0] - centre[0], from[1] - centre[1]];
    let last = [end[0] - centre[0], end[1] - centre[1]];
    let turn = (arm[0] * last[1] - arm[1] * last[0]).atan2(arm[0] * last[0] + arm[1] * last[1]);
    for chord in 1..CHORDS {
        let (sine, cosine) = (turn * f64::from(chord) / f64::from(CHORDS)).sin_cos();
        points.push([
            centre[0] + cosine * arm[0] - sine * arm[1],
            centre[1] + sine * arm[0] + cosine * arm[1],
        ]);
    }
    points.push(end);
}

/// The quadratic through three points, the second at half the parameter.
fn push_parabola(points: &mut Vec<ProfilePoint>, [from, middle, end]: [ProfilePoint; 3]) {
    for chord in 1..CHORDS {
        let s = f64::from(chord) / f64::from(CHORDS);
        let weights = [(1.0 - s) * (1.0 - 2.0 * s), 4.0 * s * (1.0 - s), s * (2.0 * s - 1.0)];
        points.push([0, 1].map(|axis| {
            weights[0] * from[axis] + weights[1] * middle[axis] + weights[2] * end[axis]
        }));
    }
    points.push(end);
}
