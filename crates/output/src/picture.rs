//! The undeformed model as a drawing: what `check --picture` shows.
//!
//! ```text
//!   |/======== beam, as thick as it is      ^  outward normal of a master
//!   |/     o   slave node                  -+-
//!          :   gap, from the point to its master
//!        -----
//! ```

use crate::number::general;
use crate::outline;
use crate::report::STYLE;
use slideline_figures::{
    Anchor, CURVES, Colour, Dash, INK, Pen, Rectangle, Scene, Text, Unit, View, escaped, grey,
};
use slideline_model::{Dof, Master, Model, NodeIndex};
use slideline_solve::observe::ContactRow;

const WIDTH: f64 = 960.0;
/// Room for arrows and words around the model.
const MARGIN: f64 = 70.0;
/// Length of an arrow.
const ARROW: f64 = 24.0;
/// Arrows of one master.
const NORMALS: usize = 10;

const MASTER: Colour = CURVES[2];
const SLAVE: Colour = CURVES[3];
const OVERLAP: Colour = CURVES[1];
const MOTION: Colour = CURVES[0];

/// Drawings as a page that needs no network, light or dark as the reader has
/// it; `words` stand below.
pub fn picture_page(scenes: &[Scene], title: &str, words: &str) -> String {
    let title = escaped(title);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n{}<pre>{}</pre>\n\
         </body>\n</html>\n",
        scenes.iter().map(Scene::inline).collect::<String>(),
        escaped(words)
    )
}

/// Draws a model with the contact points of its start.
pub fn picture(model: &Model, points: &[ContactRow]) -> Scene {
    let mut drawing = Drawing::of(model);
    drawing.solids(model);
    drawing.beams(model);
    drawing.masters(model);
    drawing.slaves(model);
    drawing.gaps(model, points);
    drawing.supports(model);
    drawing.motions(model);
    drawing.legend();
    drawing.scene
}

/// Lines of the masters of a model, undeformed, in their direction of travel.
fn master_lines(model: &Model) -> Vec<Vec<[f64; 3]>> {
    let chains = model.contact_pairs.iter().flat_map(|pair| match &pair.master {
        Master::SlideLine(chain) => vec![&chain.nodes],
        Master::Itself(surface) => surface.runs.iter().map(|run| &run.nodes).collect(),
        Master::RigidSurface(_) | Master::Faces(_) => Vec::new(),
    });
    let chains = chains.map(|nodes| nodes.iter().map(|&node| model.nodes.position(node)).collect());
    let profiles = outline::chains(model);
    let profiles = profiles.map(|line| line.iter().map(|&[x, y]| [x, y, 0.0]).collect());
    profiles.chain(chains).collect()
}

struct Drawing {
    scene: Scene,
    view: View,
}

impl Drawing {
    fn of(model: &Model) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let nodes = (0..model.nodes.len()).map(|node| model.nodes.position(node));
        for point in nodes.chain(master_lines(model).into_iter().flatten()) {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let finite = |value: f64, otherwise: f64| if value.is_finite() { value } else { otherwise };
        let size = [0, 1].map(|axis| (high[axis] - low[axis]).max(0.0));
        let inside = WIDTH - 2.0 * MARGIN;
        let height = finite((inside * size[1] / size[0]).clamp(160.0, 640.0), 320.0);
        let scale = finite((inside / size[0]).min(height / size[1]), 1.0);
        let middle = [0, 1].map(|axis| finite(0.5 * (low[axis] + high[axis]), 0.0));
        let height = height + 2.0 * MARGIN;
        let scene = Scene::new(Unit::Pixel, [WIDTH, height], "The undeformed model");
        let window = Rectangle { left: 0.0, top: 0.0, width: WIDTH, height };
        Self { scene, view: View { window, middle, scale } }
    }

    fn at(&self, [x, y, _]: [f64; 3]) -> [f64; 2] {
        self.view.at([x, y])
    }

    /// The edges of solids.
    fn solids(&mut self, model: &Model) {
        for piece in outline::Drawing::of(model).pieces {
            let (kind, points) = &piece.vtk;
            if piece.kind != outline::Kind::Solid {
                continue;
            }
            for edge in outline::edges(*kind) {
                let at = |end: &usize| self.at(model.nodes.position(points[*end]));
                let line: Vec<[f64; 2]> = edge.iter().map(at).collect();
                self.scene.line(line, Pen::solid(1.0).colour(INK));
            }
        }
    }

    /// Beams as thick as they are, two pixels at least.
    fn beams(&mut self, model: &Model) {
        for block in model.blocks.iter().filter_map(|block| block.beams()) {
            let half = (0.5 * block.section.shape.height() * self.view.scale).max(1.0);
            for element in block.elements {
                for ends in element.nodes.windows(2) {
                    let [a, b] = [0, 1].map(|end| self.at(model.nodes.position(ends[end])));
                    let Some([x, y]) = direction(a, b) else { continue };
                    let corner = |p: [f64; 2], s: f64| [p[0] - s * half * y, p[1] + s * half * x];
                    let corners =
                        vec![corner(a, 1.0), corner(b, 1.0), corner(b, -1.0), corner(a, -1.0)];
                    self.scene.polygon(corners, Some(grey(170)), None);
                    self.scene.line(vec![a, b], Pen::solid(1.0).colour(INK));
                }
            }
        }
    }

    /// Masters with arrows along their outward normals, 90 degrees
    /// counter-clockwise of travel.
    fn masters(&mut self, model: &Model) {
        for line in master_lines(model) {
            let line: Vec<[f64; 2]> = line.into_iter().map(|point| self.at(point)).collect();
            self.scene.line(line.clone(), Pen::solid(2.4).colour(MASTER));
            let lengths = line.windows(2).map(|ends| distance(ends[0], ends[1]));
            let whole: f64 = lengths.sum();
            let step = whole / NORMALS as f64;
            let mut next = 0.5 * step;
            let mut passed = 0.0;
            for ends in line.windows(2) {
                let length = distance(ends[0], ends[1]);
                let Some([x, y]) = direction(ends[0], ends[1]) else { continue };
                while next <= passed + length && step > 0.0 {
                    let along = next - passed;
                    let foot = [ends[0][0] + along * x, ends[0][1] + along * y];
                    // counter-clockwise in the plane is clockwise where y points down
                    let tip = [foot[0] + ARROW * y, foot[1] - ARROW * x];
                    self.scene.arrow(foot, tip, Pen::solid(1.2).colour(MASTER));
                    next += step;
                }
                passed += length;
            }
        }
    }

    fn slaves(&mut self, model: &Model) {
        for node in model.contact_pairs.iter().flat_map(|pair| pair.slave_nodes()) {
            let at = self.at(model.nodes.position(node));
            self.scene.circle(at, 3.0, Some(SLAVE), None);
        }
    }

    /// The gap of every point that faces its master; the smallest one of each
    /// pair has its number.
    fn gaps(&mut self, model: &Model, points: &[ContactRow]) {
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            let own = points.iter().filter(|row| row.pair == place && row.opening.is_finite());
            let mut smallest: Option<&ContactRow> = None;
            for row in own {
                let foot =
                    [0, 1, 2].map(|axis| row.position[axis] - row.opening * row.normal[axis]);
                let colour = if row.opening < 0.0 { OVERLAP } else { SLAVE };
                let ends = [row.position, foot].map(|point| self.at(point));
                let pen = Pen::solid(1.0).colour(colour).dash(Dash::Short);
                self.scene.line(ends.to_vec(), pen);
                if smallest.is_none_or(|least| row.opening < least.opening) {
                    smallest = Some(row);
                }
            }
            if let Some(row) = smallest {
                let at = self.at(row.position);
                let label = model.nodes.label(row.node);
                let words =
                    format!("{}: gap {} at node {label}", pair.name, general(row.opening, 4));
                let anchor = if at[0] > 0.5 * WIDTH { Anchor::End } else { Anchor::Start };
                let text = Text::new([at[0], at[1] - 12.0], words).plain().size(12.0);
                self.scene.text(text.anchor(anchor));
            }
        }
    }

    /// What the first step holds: a square where a node can neither move nor
    /// turn, a triangle elsewhere.
    fn supports(&mut self, model: &Model) {
        let Some(step) = model.steps.first() else { return };
        let mut held: Vec<(NodeIndex, Vec<Dof>)> = Vec::new();
        for own in step.prescribed.iter().filter(|own| !own.moves()) {
            match held.iter_mut().find(|(node, _)| *node == own.node) {
                Some((_, dofs)) => dofs.push(own.dof),
                None => held.push((own.node, vec![own.dof])),
            }
        }
        let moved = |node| step.prescribed.iter().any(|own| own.node == node && own.moves());
        for (node, dofs) in held.into_iter().filter(|(node, _)| !moved(*node)) {
            let [x, y] = self.at(model.nodes.position(node));
            let clamped = [Dof::U1, Dof::U2, Dof::UR3].iter().all(|dof| dofs.contains(dof));
            let corners = match clamped {
                true => vec![
                    [x - 6.0, y - 6.0],
                    [x + 6.0, y - 6.0],
                    [x + 6.0, y + 6.0],
                    [x - 6.0, y + 6.0],
                ],
                false => vec![[x, y], [x - 7.0, y + 12.0], [x + 7.0, y + 12.0]],
            };
            self.scene.polygon(corners, None, Some(Pen::solid(1.8).colour(INK)));
        }
    }

    /// Where the driven nodes go in the first step that moves them.
    fn motions(&mut self, model: &Model) {
        let mut seen: Vec<(NodeIndex, Dof)> = Vec::new();
        for own in model.steps.iter().flat_map(|step| &step.prescribed).filter(|own| own.moves()) {
            let axis = match own.dof {
                Dof::U1 => [1.0, 0.0],
                Dof::U2 => [0.0, -1.0],
                _ => continue,
            };
            if seen.contains(&(own.node, own.dof)) || own.value == 0.0 {
                continue;
            }
            seen.push((own.node, own.dof));
            let from = self.at(model.nodes.position(own.node));
            let length = 2.0 * ARROW * own.value.signum();
            let tip = [from[0] + length * axis[0], from[1] + length * axis[1]];
            self.scene.circle(from, 3.0, Some(MOTION), None);
            self.scene.arrow(from, tip, Pen::solid(2.4).colour(MOTION));
        }
    }

    fn legend(&mut self) {
        let words = [
            ("beam", grey(120)),
            ("master, arrows along its outward normal", MASTER),
            ("slave node, with its gap", SLAVE),
            ("overlap", OVERLAP),
            ("motion of the first step", MOTION),
        ];
        let mut x = 14.0;
        let y = self.scene.height - 14.0;
        for (words, colour) in words {
            self.scene.circle([x, y - 4.0], 4.5, Some(colour), None);
            self.scene.text(Text::new([x + 9.0, y], words).plain().size(12.0));
            x += 26.0 + 6.3 * words.len() as f64;
        }
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// From one point to another, length 1; none where they are one.
fn direction(a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
    let length = distance(a, b);
    (length > 0.0).then(|| [(b[0] - a[0]) / length, (b[1] - a[1]) / length])
}
