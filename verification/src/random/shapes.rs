//! Outlines of the rigid body that is pressed into the beam, relative to its
//! lowest point. The travel leads from +x to -x, so that the normals look
//! down, to the beam.

use std::fmt::Write as _;

/// What the beam is met by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A circle of that radius [L].
    Circle(f64),
    /// A nose with a flat end and two flanks, its corners rounded.
    Nose {
        /// Half the width of the flat end, fillets included [L].
        half: f64,
        /// Slope of the flanks [rad].
        slope: f64,
        /// Radius of the fillets [L].
        fillet: f64,
    },
}

impl Shape {
    /// Half the width over which it may meet the beam [L].
    pub fn reach(&self) -> f64 {
        match *self {
            Self::Circle(radius) => 0.5 * radius,
            Self::Nose { half, fillet, .. } => half + fillet,
        }
    }

    /// Height of the reference point over the lowest point [L].
    pub fn reference(&self) -> f64 {
        match *self {
            Self::Circle(radius) => radius,
            Self::Nose { half, .. } => half,
        }
    }

    /// The lines of `TYPE=SEGMENTS` with the lowest point at `at`.
    pub fn segments(&self, at: [f64; 2]) -> String {
        let mut text = String::new();
        let mut line = |word: &str, points: &[[f64; 2]]| {
            let _ = write!(text, "{word}"); // a String takes any text
            for [x, y] in points {
                let _ = write!(text, ", {:.9e}, {:.9e}", at[0] + x, at[1] + y);
            }
            text.push('\n');
        };
        match *self {
            Self::Circle(r) => {
                line("START", &[[r, r]]);
                line("CIRCL", &[[0.0, 0.0], [0.0, r]]);
                line("CIRCL", &[[-r, r], [0.0, r]]);
            }
            Self::Nose { half, slope, fillet } => {
                let (s, c) = slope.sin_cos();
                let d = fillet * (0.5 * slope).tan();
                let top = half + 2.0 * fillet;
                line("START", &[[half + top * c, top * s]]);
                line("LINE", &[[half + d * c, d * s]]);
                line("CIRCL", &[[half - d, 0.0], [half - d, fillet]]);
                line("LINE", &[[d - half, 0.0]]);
                line("CIRCL", &[[-half - d * c, d * s], [d - half, fillet]]);
                line("LINE", &[[-half - top * c, top * s]]);
            }
        }
        text
    }
}
