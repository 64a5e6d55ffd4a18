//! Drawing in the coordinates of a model, inside a window of the paper.

use crate::colour::Colour;
use crate::scene::{Anchor, Pen, Scene, Text};

/// A rectangle of the paper [point].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

impl Rectangle {
    /// Its corners.
    pub fn corners(&self) -> Vec<[f64; 2]> {
        let (right, bottom) = (self.left + self.width, self.top + self.height);
        vec![[self.left, self.top], [right, self.top], [right, bottom], [self.left, bottom]]
    }

    /// Whether a point lies in it.
    pub fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let inside = |value, from, length| value >= from && value <= from + length;
        inside(x, self.left, self.width) && inside(y, self.top, self.height)
    }

    /// What of the piece from `a` to `b` lies in it.
    fn clip(&self, a: [f64; 2], b: [f64; 2]) -> Option<([f64; 2], [f64; 2])> {
        let d = [b[0] - a[0], b[1] - a[1]];
        let sides = [
            (-d[0], a[0] - self.left),
            (d[0], self.left + self.width - a[0]),
            (-d[1], a[1] - self.top),
            (d[1], self.top + self.height - a[1]),
        ];
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for (slope, room) in sides {
            if slope == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if slope < 0.0 {
                enters = enters.max(room / slope);
            } else {
                leaves = leaves.min(room / slope);
            }
        }
        // the ends themselves, not what rounding makes of them
        let at = |t: f64| if t == 1.0 { b } else { [a[0] + t * d[0], a[1] + t * d[1]] };
        (enters <= leaves).then(|| (at(enters), at(leaves)))
    }

    /// The parts of a line that lie in it.
    pub fn parts(&self, line: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
        let mut parts: Vec<Vec<[f64; 2]>> = Vec::new();
        for pair in line.windows(2) {
            let Some((a, b)) = self.clip(pair[0], pair[1]) else { continue };
            match parts.last_mut() {
                Some(part) if part.last() == Some(&a) => part.push(b),
                _ => parts.push(vec![a, b]),
            }
        }
        parts
    }
}

/// A window through which a piece of the model is seen, true to scale.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The window.
    pub window: Rectangle,
    /// Point of the model in its middle [L].
    pub middle: [f64; 2],
    /// Points of paper per unit of length [1/L].
    pub scale: f64,
}

impl View {
    /// Where a point of the model lies on the paper.
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let w = &self.window;
        [
            w.left + 0.5 * w.width + self.scale * (x - self.middle[0]),
            w.top + 0.5 * w.height - self.scale * (y - self.middle[1]),
        ]
    }

    /// Whether a point of the model is seen.
    pub fn sees(&self, p: [f64; 2]) -> bool {
        self.window.contains(self.at(p))
    }

    /// A line through points of the model.
    pub fn line(&self, scene: &mut Scene, points: &[[f64; 2]], pen: Pen) {
        let placed: Vec<[f64; 2]> = points.iter().map(|&p| self.at(p)).collect();
        for part in self.window.parts(&placed) {
            scene.line(part, pen);
        }
    }

    /// A circle of the model.
    pub fn circle(&self, scene: &mut Scene, centre: [f64; 2], radius: f64, pen: Pen) {
        self.arc(scene, centre, radius, [0.0, std::f64::consts::TAU], pen);
    }

    /// An arc of the model between two angles from x, counter-clockwise [rad].
    pub fn arc(
        &self,
        scene: &mut Scene,
        centre: [f64; 2],
        radius: f64,
        [from, to]: [f64; 2],
        pen: Pen,
    ) {
        let pieces = 360;
        let points: Vec<[f64; 2]> = (0..=pieces)
            .map(|i| {
                let (s, c) = (from + (to - from) * f64::from(i) / f64::from(pieces)).sin_cos();
                [centre[0] + radius * c, centre[1] + radius * s]
            })
            .collect();
        let placed: Vec<[f64; 2]> = points.iter().map(|&p| self.at(p)).collect();
        let whole = placed.iter().all(|&p| self.window.contains(p));
        if whole && (to - from - std::f64::consts::TAU).abs() < 1e-9 {
            scene.circle(self.at(centre), radius * self.scale, None, Some(pen));
        } else {
            self.line(scene, &points, pen);
        }
    }

    /// A dot at a point of the model, `radius` in points of paper.
    pub fn dot(
        &self,
        scene: &mut Scene,
        p: [f64; 2],
        radius: f64,
        fill: Option<Colour>,
        pen: Option<Pen>,
    ) {
        if self.sees(p) {
            scene.circle(self.at(p), radius, fill, pen);
        }
    }

    /// An arrow between two points of the model.
    pub fn arrow(&self, scene: &mut Scene, from: [f64; 2], to: [f64; 2], pen: Pen) {
        scene.arrow(self.at(from), self.at(to), pen);
    }

    /// Words at a point of the model, moved by `shift` points of paper.
    pub fn label(&self, scene: &mut Scene, p: [f64; 2], shift: [f64; 2], words: &str) {
        let [x, y] = self.at(p);
        scene.text(Text::new([x + shift[0], y + shift[1]], words).anchor(Anchor::Middle));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_at_the_window() {
        let window = Rectangle { left: 0.0, top: 0.0, width: 10.0, height: 10.0 };
        let parts = window.parts(&[[-5.0, 5.0], [5.0, 5.0], [5.0, 20.0], [8.0, 20.0], [8.0, 9.0]]);
        assert_eq!(
            parts,
            vec![vec![[0.0, 5.0], [5.0, 5.0], [5.0, 10.0]], vec![[8.0, 10.0], [8.0, 9.0]]]
        );
        assert!(window.parts(&[[-1.0, -1.0], [11.0, -1.0]]).is_empty());
    }
}
