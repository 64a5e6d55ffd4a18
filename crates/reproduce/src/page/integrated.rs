//! The section on contact that is integrated along the beam.

use super::{IMMEDIATE, MATFRU, NONE, Page, fixed, kept};
use crate::cases::{FINE, FRICTION, ModelKind};
use crate::figures;
use crate::fine::Errors;
use slideline_theory::FirstProblem;
use std::fmt::Write as _;

impl Page<'_> {
    /// Why nodes make noise and a stretch of beam does not.
    pub(super) fn integrated(&self, text: &mut String) {
        let problem = FirstProblem::diehl();
        let half_element = 0.5e3 * problem.beam.length() / 24.0;
        let half_angle = 2f64.to_radians();
        let [worst_irs, worst_isl] = [ModelKind::IrsCoarse, ModelKind::Isl]
            .map(|model| self.errors(model, 0.0).map_or(f64::NAN, |errors| errors.largest));
        let turns = self.errors(ModelKind::IrsCoarse, 0.0).map_or(0, |errors| errors.reversals);
        let _ = write!(
            text,
            "<h2>4 A third way: contact integrated along the beam</h2>\n\
             <p>Not in the paper. Both of its methods sample contact at nodes, and that is where \
             their noise comes from. In the IRS model a node of the beam carries the force, up to \
             half an element ({} mm) from where the circle touches, and the force points from the \
             centre of the circle to that node. As the circle moves on the direction goes wrong \
             by more and more, until the next node takes over and it jumps back: a saw-tooth of \
             up to {} % of the peak, on which the force changes direction {turns} times in {FINE} \
             increments. The ISL model takes the direction from the beam, but its circle is a \
             polygon: the force acts at a corner, up to half the spacing of the slaves ({} mm) \
             beside the point of tangency, and between corners the polygon lies {} \u{b5}m inside \
             the circle. Each time one slave hands over to the next the error rises and falls \
             again, by up to {} %.</p>\n",
            fixed(half_element, 2),
            fixed(worst_irs, 0),
            fixed(1e3 * problem.radius * half_angle.sin(), 2),
            fixed(1e6 * problem.radius * (1.0 - half_angle.cos()), 1),
            fixed(worst_isl, 1),
        ); // a String takes any text, here and below
        self.why_smooth(text, &problem);
        self.figure(text, "formulations", "Errors of three formulations.");
        self.formulations(text);
        self.second_problem_integrated(text);
    }

    fn errors(&self, model: ModelKind, friction: f64) -> Option<&Errors> {
        let fine = self.study.fine.iter();
        fine.into_iter().find(|errors| errors.model == model && errors.friction == friction)
    }

    fn why_smooth(&self, text: &mut String, problem: &FirstProblem) {
        // contact begins at the clearance c0: h = c0 - s^2/2r of a straight beam
        let closed = 2e3 * (2.0 * problem.radius * problem.law.clearance).sqrt();
        let _ = write!(
            text,
            "<p>Integrated contact (<code>*CONTACT PAIR, TYPE=SURFACE TO SURFACE</code>) has \
             neither. The surface of the beam is a smooth curve through the positions and \
             rotations of its nodes, the circle stays a circle, and pressure is integrated over \
             the part of the beam that is in contact, about {} mm long, wherever in an element it \
             lies. As contact moves on, this part grows a little at one end and shrinks a little \
             at the other, and at both ends the pressure is zero: nothing jumps.",
            fixed(closed, 1),
        ); // as above
        if let (Some(increment), Some([irs, isl, integrated])) =
            (figures::worst_increment(self.study), figures::tilts(self.study))
        {
            let _ = write!(
                text,
                " In increment {increment}, that of Figure 5, the resultant is {} degrees off, \
                 where IRS is {} and ISL {} degrees off.",
                fixed(integrated.abs(), 3),
                fixed(irs.abs(), 1),
                fixed(isl.abs(), 2),
            ); // as above
        }
        text.push_str(
            " What is left is a ripple from element to element, for inside a B21 beam the \
             curvature is constant; it shrinks nearly with the square of the mesh width.</p>\n",
        );
    }

    /// RMS, largest error, roughness and reversals in small increments.
    fn formulations(&self, text: &mut String) {
        let _ = write!(
            text,
            "<div class=\"wide\"><table>\n\
             <caption>Vertical force of the first problem in {FINE} increments, 24 beams, against \
             the shear-flexible beam with pressure spread along it, in percent of the \
             peak.</caption>\n\
             <tr><th>model</th><th>\u{3bc}</th><th>RMS</th><th>largest</th><th>roughness</th><th>reversals</th></tr>\n"
        ); // as above
        for friction in [0.0, FRICTION] {
            for model in crate::fine::MODELS {
                let Some(errors) = self.errors(model, friction) else { continue };
                let _ = writeln!(
                    text,
                    "<tr><td>{}</td><td>{friction}</td><td>{}</td><td>{}</td><td>{}</td>\
                     <td>{}</td></tr>",
                    model.name(),
                    fixed(errors.rms, 3),
                    fixed(errors.largest, 2),
                    fixed(errors.roughness, 4),
                    errors.reversals,
                ); // as above
            }
        }
        text.push_str(
            "</table></div>\n\
             <p>Roughness measures jumps from increment to increment, and separates the IRS model \
             from the two others. The error of the ISL model is a slow wave: the force moves from \
             one slave to the next over several increments.</p>\n",
        );
    }

    fn second_problem_integrated(&self, text: &mut String) {
        let rms = |model, run, decimals| self.say(model, run, |row| row.continuum[0], decimals);
        let part = |model| self.say(model, MATFRU, kept, 0);
        let _ = writeln!(
            text,
            "<p>In 20 increments the integrated model is {} % (RMS, \u{3bc} = 0) and {} % \
             (\u{3bc} = {FRICTION}) off, at {} iterations an increment. In the second problem, \
             against the same kind of reference, the moment is {} % and {} % off, where the ISL \
             model with a slave every 3 degrees is {} % and {} %: there is no polygon whose \
             corners would shift the arm of the force. It needs the modified friction logic all \
             the same: a sliding circle keeps touching new parts of the beam, and the logic of \
             1995 would leave {} % of the work of friction in the first problem and {} % in the \
             second.</p>",
            rms(ModelKind::Integrated, NONE, 3),
            rms(ModelKind::Integrated, IMMEDIATE, 3),
            self.say(ModelKind::Integrated, IMMEDIATE, |row| row.mean_iterations, 1),
            rms(ModelKind::CamIntegrated, NONE, 3),
            rms(ModelKind::CamIntegrated, IMMEDIATE, 3),
            rms(ModelKind::Cam, NONE, 1),
            rms(ModelKind::Cam, IMMEDIATE, 1),
            part(ModelKind::Integrated),
            part(ModelKind::CamIntegrated),
        ); // as above
    }
}
