//! `diehl1995.html`: the paper's argument with our numbers, on one page.

mod integrated;

use crate::cases::{FRICTION, INCREMENTS, ModelKind, Stick};
use crate::figures::{self, Figure};
use crate::study::Study;
use crate::table::Row;
use crate::theory::{THEORIES, Theory};
use slideline::Onset;
use slideline_figures::escaped;
use std::fmt::Write as _;

const STYLE: &str = "body{max-width:46rem;margin:2rem auto;padding:0 1rem;font:16px/1.5 Georgia,\
serif;color:#111;background:#fff}h1{font-size:1.6rem;line-height:1.25}h2{font-size:1.25rem;\
margin-top:2.2rem}figure{margin:1.6rem 0;break-inside:avoid}figure svg{width:100%;height:auto}\
figcaption{font-size:.9rem;margin-top:.3rem}table{border-collapse:collapse;font:13px/1.35 \
system-ui,sans-serif;width:100%}.wide{overflow-x:auto}caption{text-align:left;padding:.4rem 0;\
font:.9rem Georgia,serif}th,td{padding:.2rem .45rem;text-align:right;border-bottom:1px solid #ccc;\
white-space:nowrap}th{border-bottom:1px solid #111;vertical-align:bottom;white-space:normal}\
td:first-child,th:first-child,td.t,th.t{text-align:left}code{font-size:.9em}\
.runs table{font-size:10.5px}.runs th,.runs td{padding:.15rem .18rem}\
@media (prefers-color-scheme:dark){body{color:#e6e9ed;background:#141414}\
th,td{border-color:#3a4048}th{border-bottom-color:#e6e9ed}a{color:#6cb6ff}\
figure svg,figure img{filter:invert(.92) hue-rotate(180deg)}}\
@media print{figure svg,figure img{filter:none}body{color:#111;background:#fff;max-width:none;margin:0;font-size:11pt}}";

/// The whole page.
pub(crate) fn page(study: &Study, rows: &[Row], figures: &[Figure]) -> String {
    let page = Page { study, rows, figures };
    let mut text = String::with_capacity(1 << 19);
    // a String takes any text, here and below
    let _ = write!(
        text,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>Sliding contact: the study of Diehl (1995), repeated</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n"
    );
    page.head(&mut text);
    page.first_problem(&mut text);
    page.friction(&mut text);
    page.second_problem(&mut text);
    page.integrated(&mut text);
    page.theory(&mut text);
    page.table(&mut text);
    page.end(&mut text);
    text.push_str("</body>\n</html>\n");
    text
}

struct Page<'a> {
    study: &'a Study,
    rows: &'a [Row],
    figures: &'a [Figure],
}

impl Page<'_> {
    fn row(&self, model: ModelKind, stick: Stick, onset: Onset) -> Option<&Row> {
        self.rows.iter().find(|row| {
            row.case.model == model && row.case.stick == stick && row.case.onset == onset
        })
    }

    /// A number of a row, or a dash.
    fn say(
        &self,
        model: ModelKind,
        (stick, onset): (Stick, Onset),
        number: impl Fn(&Row) -> f64,
        decimals: usize,
    ) -> String {
        self.row(model, stick, onset)
            .map_or_else(|| "\u{2013}".to_owned(), |row| fixed(number(row), decimals))
    }

    fn figure(&self, text: &mut String, name: &str, title: &str) {
        let Some(figure) = self.figures.iter().find(|figure| figure.name == name) else { return };
        let _ = write!(
            text,
            "<figure id=\"{name}\">\n{}<figcaption><b>{title}</b> {}</figcaption>\n</figure>\n",
            figure.scene.svg(),
            escaped(&figure.caption),
        ); // as above
    }

    fn head(&self, text: &mut String) {
        let isl = |number: fn(&Row) -> f64, decimals| {
            self.say(ModelKind::Isl, IMMEDIATE, number, decimals)
        };
        let kept = |model| self.say(model, MATFRU, kept, 0);
        let _ = write!(
            text,
            "<h1>Sliding contact: the study of Diehl (1995), repeated</h1>\n\
             <p>T. Diehl, <i>Methods of Improving ABAQUS/Standard Predictions for Problems \
             Involving Sliding Contact</i>, ABAQUS Users' Conference, Paris, 1995, asked two \
             questions about a circle that slides along a flexible beam: which side should carry \
             the contact points, and in which increments should friction act? This page repeats \
             the study with slideline {version}; every number and figure on it was computed when \
             it was made, from {runs} runs of {INCREMENTS} increments.</p>\n\
             <p><b>In short.</b> With the contact points on the circle (ISL) instead of the beam \
             (IRS) the noise (roughness, section 6) falls from {noise} % to {smooth} % of the \
             peak on the same mesh. The friction logic of 1995, with no friction in an increment \
             in which a node closes, keeps {coarse} % of the work of friction in the coarse IRS \
             model, {fine} % in the fine one and {cam} % in the cam model. If friction acts \
             whenever a node is closed, none of it is lost: the ISL model is within {rms} % (RMS) \
             of linear theory, with {iterations} iterations an increment and no cutback. Contact \
             that is integrated along the beam, which the paper did not have, is within {spread} \
             % of the exact reference on the same mesh (section 4).</p>\n\
             <h2>1 Two problems</h2>\n\
             <p>Snap-fits, latches and cam-driven switches are made of such contacts. A rigid \
             circle of radius 9 mm is pushed down along a slightly inclined cantilever of 50 mm; \
             or it sits on an arm and is turned into a straight one. The paper does not give the \
             dimensions of the second problem; ours are in the deck. The force is that of the \
             support on the circle, <i>F</i><sub>y</sub> of the paper's equation (8) and RF2 of \
             the program: negative, because the circle is pushed down. The axes of the figures \
             run towards negative values, in the direction of the motion.</p>\n",
            version = slideline::VERSION,
            runs = self.rows.len(),
            noise = self.say(ModelKind::IrsCoarse, NONE, |row| row.roughness, 1),
            smooth = self.say(ModelKind::Isl, NONE, |row| row.roughness, 2),
            coarse = kept(ModelKind::IrsCoarse),
            fine = kept(ModelKind::IrsFine),
            cam = kept(ModelKind::Cam),
            rms = isl(|row| row.linear[0], 1),
            iterations = isl(|row| row.mean_iterations, 1),
            spread = self.say(ModelKind::Integrated, IMMEDIATE, |row| row.continuum[0], 2),
        ); // as above
        self.figure(text, "fig1", "Figure 1.");
    }

    fn first_problem(&self, text: &mut String) {
        text.push_str(
            "<h2>2 The first problem</h2>\n\
             <p>Three models: contact elements on the beam against an analytic circle, with a \
             coarse and a fine mesh (IRS), and contact elements on the circle, now a chain of \
             nodes on a rigid body, against a slide line on the beam (ISL). All have softened \
             contact. Without it the ISL model would be overconstrained: three nodes of a circle \
             cannot lie on one straight segment.</p>\n",
        );
        self.figure(text, "fig2", "Figure 2.");
        self.figure(text, "fig3", "Figure 3.");
        let rms = |model| self.say(model, NONE, |row| row.linear[0], 2);
        let most = |model| self.say(model, NONE, |row| row.linear[1], 1);
        let turns = |model| self.say(model, NONE, |row| row.reversals as f64, 0);
        let _ = writeln!(
            text,
            "<p>Without friction (Figure 4) the coarse IRS model differs from linear theory by {} \
             % of the peak (RMS) and by {} % at most; the slope of its force changes sign {} \
             times, that of theory never. With four times as many beams the difference is {} % \
             and {} %. The ISL model has {} % and {} % on the coarse mesh. The larger part of \
             this is the error of linear theory (section 5): against the exact reference it is {} \
             % and {} %.</p>",
            rms(ModelKind::IrsCoarse),
            most(ModelKind::IrsCoarse),
            turns(ModelKind::IrsCoarse),
            rms(ModelKind::IrsFine),
            most(ModelKind::IrsFine),
            rms(ModelKind::Isl),
            most(ModelKind::Isl),
            self.say(ModelKind::Isl, NONE, |row| row.softened[0], 2),
            self.say(ModelKind::Isl, NONE, |row| row.softened[1], 2),
        ); // as above
        self.figure(text, "fig4", "Figure 4.");
        if let (Some(increment), Some([irs, isl, _])) =
            (figures::worst_increment(self.study), figures::tilts(self.study))
        {
            let _ = writeln!(
                text,
                "<p>Figure 5 shows why. A slave node of the beam touches the circle up to half an \
                 element away from the point of tangency, where the normal of the circle has \
                 another direction: in increment {increment} by {} degrees, which is much for a \
                 force that is nearly horizontal. With the slaves on the circle the normal is \
                 that of the beam, {} degrees off.</p>",
                fixed(irs.abs(), 1),
                fixed(isl.abs(), 2),
            ); // as above
        }
        self.figure(text, "fig5", "Figure 5.");
    }

    fn friction(&self, text: &mut String) {
        let part = |model| self.say(model, MATFRU, kept, 1);
        let points = |model| self.say(model, MATFRU, |row| row.dropped_points as f64, 0);
        let _ = write!(
            text,
            "<h2>2.1 With friction</h2>\n\
             <p>In 1995 friction was not called for a slave node in the increment in which its \
             contact was made, made again, or lost (subroutine MATFRU). In an IRS model the \
             circle touches another node in nearly every increment, and friction disappears \
             (Figure 6a, \u{3bc} = {FRICTION}): the coarse model keeps {} % of the work of \
             friction, in the few increments in which a node stays in contact, the fine one {} %. \
             The ISL model keeps {} %, because the contact point hardly moves along the circle; \
             where a new slave node closes beside the old one, a part is lost. The program counts \
             what is dropped and says so: {}, {} and {} point-increments.</p>\n",
            part(ModelKind::IrsCoarse),
            part(ModelKind::IrsFine),
            part(ModelKind::Isl),
            points(ModelKind::IrsCoarse),
            points(ModelKind::IrsFine),
            points(ModelKind::Isl),
        ); // as above
        self.figure(text, "fig6a", "Figure 6.");
        let rms = |model| self.say(model, IMMEDIATE, |row| row.linear[0], 2);
        let _ = writeln!(
            text,
            "<p>If friction acts whenever a node is closed, it acts in every increment (Figure \
             6b): RMS {} %, {} % and {} % against linear theory. Sticking imposed by elastic slip \
             and by multipliers gives the same curves ({}), and neither costs more: {} and {} \
             iterations an increment in the ISL model, {} with the old logic.</p>",
            rms(ModelKind::IrsCoarse),
            rms(ModelKind::IrsFine),
            rms(ModelKind::Isl),
            self.algorithms_apart(),
            self.say(ModelKind::Isl, IMMEDIATE, |row| row.mean_iterations, 2),
            self.say(ModelKind::Isl, LAGRANGE, |row| row.mean_iterations, 2),
            self.say(ModelKind::Isl, MATFRU, |row| row.mean_iterations, 2),
        ); // as above
        self.figure(text, "fig6b", "Figure 6.");
    }

    /// How far penalty and Lagrange are apart in the first problem, in words.
    fn algorithms_apart(&self) -> String {
        let mut most: f64 = 0.0;
        for model in [ModelKind::IrsCoarse, ModelKind::IrsFine, ModelKind::Isl] {
            let of = |stick| self.study.curve(model, stick, Onset::Immediate);
            if let (Some(a), Some(b)) = (of(Stick::Penalty), of(Stick::Lagrange)) {
                for (a, b) in a.reactions().iter().zip(b.reactions()) {
                    most = most.max((a - b).abs());
                }
            }
        }
        if most == 0.0 {
            "to the last digit, for every point slides in every increment".to_owned()
        } else {
            format!("at most {most:.0e} N apart")
        }
    }

    fn second_problem(&self, text: &mut String) {
        let part = |model| self.say(model, MATFRU, kept, 0);
        let _ = write!(
            text,
            "<h2>3 The second problem</h2>\n\
             <p>ISL alone is not enough. As the cam turns, the contact point moves along its rim, \
             and new slave nodes close all the time (Figure 7). The old logic keeps {} % of the \
             work of friction with a slave node every 3 degrees, as large as the increment, and \
             {} % with one every 4 degrees: it depends on the spacing which increments keep their \
             friction (Figure 8a).</p>\n",
            part(ModelKind::Cam),
            part(ModelKind::CamWide),
        ); // as above
        self.figure(text, "fig7", "Figure 7.");
        self.figure(text, "fig8a", "Figure 8.");
        let rms = |model| self.say(model, IMMEDIATE, |row| row.linear[0], 1);
        let _ = writeln!(
            text,
            "<p>With the modified logic (Figure 8b) the moment follows theory, to {} % and {} % \
             of the peak (RMS). The rest comes from the polygon of slave nodes: the force acts at \
             a node, up to half the spacing beside the point of tangency, and that shifts its arm \
             about the pivot. Without friction the moment is small and the same shift is {} % and \
             {} % of its peak.</p>",
            rms(ModelKind::Cam),
            rms(ModelKind::CamWide),
            self.say(ModelKind::Cam, NONE, |row| row.linear[0], 1),
            self.say(ModelKind::CamWide, NONE, |row| row.linear[0], 1),
        ); // as above
        self.figure(text, "fig8b", "Figure 8.");
    }

    fn theory(&self, text: &mut String) {
        text.push_str(
            "<h2>5 What linear theory itself leaves out</h2>\n\
             <p>The paper compares with small deflections of an Euler beam touched at one point. \
             Late in the stroke, where force and slope are large, that is no longer exact. Three \
             things are missing, each with a reference of its own: large deflections (elastica), \
             shear and stretching of the beam (Reissner), and the softened contact of the decks, \
             which acts before the surfaces touch, at one point of the area of a slave node or \
             spread along the beam. None of these references shares code with the solver.</p>\n",
        );
        self.figure(text, "linear_theory", "Linear theory against exact references.");
        text.push_str(
            "<div class=\"wide\"><table>\n\
             <caption>Force at the end of the stroke of the first problem, by theory.</caption>\n\
             <tr><th>theory</th><th><i>F</i><sub>y</sub>, no friction (N)</th><th>linear is off \
             by (%)</th><th><i>F</i><sub>y</sub>, with friction (N)</th><th>linear is off by \
             (%)</th></tr>\n",
        );
        for theory in THEORIES {
            let _ = write!(text, "<tr><td>{}</td>", words(theory)); // as above
            for friction in [0.0, FRICTION] {
                let last = |theory| {
                    let values = self.study.references.get(ModelKind::Isl, theory, friction);
                    values.last().copied().unwrap_or(f64::NAN)
                };
                let (linear, exact) = (last(Theory::Linear), last(theory));
                let off = 100.0 * (linear / exact - 1.0);
                let _ = write!(text, "<td>{}</td><td>{}</td>", fixed(exact, 3), fixed(off, 2)); // as above
            }
            text.push_str("</tr>\n");
        }
        text.push_str("</table></div>\n");
    }

    fn table(&self, text: &mut String) {
        text.push_str(
            "<h2>6 All runs</h2>\n\
             <p>Differences are in percent of the peak of the reference: linear theory, and the \
             shear-flexible beam with softened contact at one point or spread along it. Roughness \
             is the noise without the smooth part of the error, in percent of the peak. Work is \
             that of the driver over that of the exact reference, spread for integrated contact \
             and at one point for the others; friction kept is the share of the work of friction. \
             The same table with more columns and digits is <code>errors.csv</code>.</p>\n\
             <div class=\"wide runs\"><table>\n\
             <tr><th>model</th><th class=\"t\">stick</th><th class=\"t\">friction \
             called</th><th>RMS, linear</th><th>max, linear</th><th>RMS, point</th><th>max, \
             point</th><th>RMS, spread</th><th>max, \
             spread</th><th>rough&shy;ness</th><th>rever&shy;sals</th><th>work</th><th>friction \
             kept (%)</th><th>itera&shy;tions</th><th>points dropped</th></tr>\n",
        );
        for row in self.rows {
            let case = &row.case;
            let called = match case.stick {
                Stick::Frictionless => "\u{2013}",
                _ => slideline::output::onset_word(case.onset),
            };
            let _ = write!(
                text,
                "<tr><td>{}</td><td class=\"t\">{}</td><td class=\"t\">{called}</td>",
                case.model.name(),
                case.stick.word(),
            ); // as above
            let errors = [row.linear, row.softened, row.continuum];
            for value in errors.into_iter().flatten().chain([row.roughness]) {
                let _ = write!(text, "<td>{}</td>", fixed(value, 2)); // as above
            }
            let kept = row.friction_kept.map_or_else(|| "\u{2013}".to_owned(), |k| fixed(k, 1));
            let _ = writeln!(
                text,
                "<td>{}</td><td>{}</td><td>{kept}</td><td>{}</td><td>{}</td></tr>",
                row.reversals,
                fixed(row.work_ratio, 3),
                fixed(row.mean_iterations, 2),
                row.dropped_points,
            ); // as above
        }
        text.push_str("</table></div>\n");
    }

    fn end(&self, text: &mut String) {
        let worst = self.rows.iter().map(|row| row.mean_iterations).fold(0.0, f64::max);
        let cutbacks: usize = self.rows.iter().map(|row| row.cutbacks).sum();
        let _ = write!(
            text,
            "<h2>7 Conclusions</h2>\n\
             <p>Where contact is sampled at nodes, they belong on the curved, rigid side; \
             integrated along the beam it makes no noise on either. Friction belongs to every \
             increment in which a node is closed, the one in which it closes included. Neither \
             costs anything: no run took more than {} iterations an increment on average, and {} \
             was cut back. Softened contact keeps rigidly linked slave nodes from \
             overconstraining a straight segment.</p>\n\
             <h2>How to repeat a run</h2>\n\
             <p>The decks are in <code>decks/</code>. <code>slideline run \
             decks/isl_coarse_mu03.inp</code> runs one with friction called whenever a node is \
             closed; <code>--friction-onset matfru</code> uses the logic of 1995. <code>slideline \
             theory diehl-1 --mu 0.3</code> prints theory. Every point of every curve is in \
             <code>curves.csv</code>.</p>\n",
            fixed(worst, 1),
            if cutbacks == 0 { "none".to_owned() } else { format!("{cutbacks}") },
        ); // as above
    }
}

const NONE: (Stick, Onset) = (Stick::Frictionless, Onset::Immediate);
const IMMEDIATE: (Stick, Onset) = (Stick::Penalty, Onset::Immediate);
const LAGRANGE: (Stick, Onset) = (Stick::Lagrange, Onset::Immediate);
const MATFRU: (Stick, Onset) = (Stick::Penalty, Onset::Matfru);

fn kept(row: &Row) -> f64 {
    row.friction_kept.unwrap_or(f64::NAN)
}

fn words(theory: Theory) -> &'static str {
    match theory {
        Theory::Linear => "linear (the paper's)",
        Theory::Elastica => "large deflections",
        Theory::Reissner => "and shear and stretching",
        Theory::Softened => "and softened contact at one point",
        Theory::Continuum => "and pressure along the beam",
    }
}

/// A number with so many decimals and a proper minus; never minus zero.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits.to_owned(),
        Some(digits) => format!("\u{2212}{digits}"),
        None => text,
    }
}
