//! The paper's linear theory: small deflections of an Euler beam under a point load.
//!
//! ```text
//!     eta        .--.
//!      |        ( O  )   circle (xi_c, eta_c), r
//!  |===+=====__  `--'
//!  |           ``--x__          contact at (xi_L, u), slope theta < 0
//!       |<- xi_L ->|  ``--__
//! ```

use super::equilibrium::Local;
use super::section::Section;
use crate::error::TheoryError;
use crate::frame::Circle;
use crate::numerics::root;

/// What linear theory says about one position of the circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearContact {
    /// Contact length xi_L [L].
    pub contact_length: f64,
    /// Deflection u of the beam at the contact, negative away from the circle [L].
    pub deflection: f64,
    /// Slope theta at the contact, negative [-].
    pub slope: f64,
    /// Contact force F [F].
    pub force: f64,
}

/// Deflection [L] and slope [-] of a cantilever at its point load. Diehl (1995) eq. (1).
pub fn deflection_and_slope(force: f64, xi_l: f64, bending_stiffness: f64) -> (f64, f64) {
    (
        -force * xi_l.powi(3) / (3.0 * bending_stiffness),
        -force * xi_l * xi_l / (2.0 * bending_stiffness),
    )
}

/// Residual of the circle's equation [L2]. Diehl (1995) eq. (2).
pub fn circle_residual(point: [f64; 2], centre: [f64; 2], radius: f64) -> f64 {
    (point[0] - centre[0]).powi(2) + (point[1] - centre[1]).powi(2) - radius * radius
}

/// Height [L] of the side of the circle that faces the beam. Diehl (1995) eq. (3).
pub fn circle_height(xi: f64, centre: [f64; 2], radius: f64) -> f64 {
    centre[1] - root_of_circle(xi, centre, radius)
}

/// Slope [-] of the side of the circle that faces the beam. Diehl (1995) eq. (4).
pub fn circle_slope(xi: f64, centre: [f64; 2], radius: f64) -> f64 {
    (xi - centre[0]) / root_of_circle(xi, centre, radius)
}

fn root_of_circle(xi: f64, centre: [f64; 2], radius: f64) -> f64 {
    let d = xi - centre[0];
    ((radius - d) * (radius + d)).sqrt()
}

/// Contact length xi_L [L]: the root of Diehl (1995) eq. (6) nearest the circle's
/// centre, for a centre given in beam axes.
///
/// Multiplied by the root S and written in d = xi_c - xi_L, eq. (6) is
/// g(d) = eta_c S - r^2 + d^2/3 + 2 xi_c d/3 = 0. g rises from d = 0 to one
/// maximum, so that its first root is bracketed by 0 and that maximum (derived).
///
/// # Errors
/// [`TheoryError::NoContact`] if the circle clears the undeflected beam;
/// [`TheoryError::PastClamp`] if no root leaves a contact length above zero.
pub fn contact_length(centre: [f64; 2], radius: f64) -> Result<f64, TheoryError> {
    let [xi_c, eta_c] = centre;
    if eta_c >= radius {
        return Err(TheoryError::NoContact { gap: eta_c - radius });
    }
    if xi_c <= 0.0 {
        return Err(TheoryError::PastClamp);
    }
    let s = |d: f64| ((radius - d) * (radius + d)).sqrt();
    let g = |d: f64| {
        radius * (eta_c - radius) + d * (d + 2.0 * xi_c) / 3.0 - eta_c * d * d / (radius + s(d))
    };
    let rise = |d: f64| (2.0 / 3.0) * (d + xi_c) * s(d) - eta_c * d;
    let top = if eta_c > 0.0 { root::bracketed(rise, 0.0, radius)? } else { radius };
    if g(top) <= 0.0 {
        return Err(TheoryError::PastClamp);
    }
    let xi_l = xi_c - root::bracketed(g, 0.0, top)?;
    if xi_l > 0.0 { Ok(xi_l) } else { Err(TheoryError::PastClamp) }
}

/// Deflection and load of the beam, and slope, once the contact length is known.
/// Diehl (1995) eq. (7).
pub fn deflection_and_force(
    xi_l: f64,
    centre: [f64; 2],
    radius: f64,
    bending_stiffness: f64,
) -> LinearContact {
    let deflection = circle_height(xi_l, centre, radius);
    LinearContact {
        contact_length: xi_l,
        deflection,
        slope: circle_slope(xi_l, centre, radius),
        force: -3.0 * bending_stiffness * deflection / xi_l.powi(3),
    }
}

/// Force [F] that the support exerts on the circle along Y, for a beam inclined by
/// `alpha` to Y and a circle pushed along -Y. Diehl (1995) eq. (8); the slope
/// stands for the angle, as printed. `mu` < 0 reverses friction: the return stroke.
pub fn drive_force(force: f64, alpha: f64, theta: f64, mu: f64) -> f64 {
    -force * ((alpha - theta).sin() + mu * (alpha - theta).cos())
}

/// Force [F] across the direction of travel that belongs to [`drive_force`]
/// (derived from the same figure; not printed in the paper).
pub fn side_force(force: f64, alpha: f64, theta: f64, mu: f64) -> f64 {
    force * ((alpha - theta).cos() - mu * (alpha - theta).sin())
}

/// Arm R [L] and angle phi [rad] of the cam. Diehl (1995) eq. (9).
pub fn arm_and_angle(centre: [f64; 2], pivot: [f64; 2]) -> (f64, f64) {
    let (dx, dy) = (centre[0] - pivot[0], centre[1] - pivot[1]);
    // sin(phi) alone leaves the branch open; the cosine is that of eq. (10)
    (dx.hypot(dy), dx.atan2(-dy))
}

/// Drive moment [F L] about the pivot. Diehl (1995) eq. (11); `force` = (F_x, F_y) of eq. (12).
pub fn drive_moment(force: [f64; 2], xi_l: f64, deflection: f64, pivot: [f64; 2]) -> f64 {
    -force[0] * (xi_l - pivot[0]) + force[1] * (-deflection + pivot[1])
}

/// Components (F_x, F_y) [F] of the contact force of the second problem, F_x along
/// -eta and F_y along +xi. Diehl (1995) eq. (12). `mu` < 0 reverses friction.
pub fn cam_force(force: f64, theta: f64, mu: f64) -> [f64; 2] {
    [
        force * ((-theta).cos() - mu * (-theta).sin()),
        -force * ((-theta).sin() + mu * (-theta).cos()),
    ]
}

/// Equilibrium by linear theory, eqs. (6), (7) and (12), in beam axes; `drag` is
/// the coefficient of friction, negative where the circle drags towards the clamp.
pub(super) fn solve(section: &Section, circle: Circle, drag: f64) -> Result<Local, TheoryError> {
    let xi_l = contact_length(circle.centre, circle.radius)?;
    section.check_inside(xi_l)?;
    let found = deflection_and_force(xi_l, circle.centre, circle.radius, section.bending);
    let [f_x, f_y] = cam_force(found.force, found.slope, -drag);
    if f_x <= 0.0 {
        return Err(TheoryError::Jamming { transverse: f_x / found.force });
    }
    Ok(Local {
        contact_length: xi_l,
        force: found.force,
        reaction: [f_y, -f_x],
        point: [xi_l, found.deflection],
        angle: found.slope,
        overclosure: 0.0,
        strain_energy: -0.5 * found.force * found.deflection,
        contact_energy: 0.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FirstProblem;
    use crate::frame::Frame;

    const EI: f64 = 0.048515625;

    /// Diehl (1995) eq. (1): u = (2/3) xi_L theta.
    #[test]
    fn equation_1_deflection_against_slope() {
        let (u, theta) = deflection_and_slope(3.0, 0.02, EI);
        assert!((u - 2.0 / 3.0 * 0.02 * theta).abs() < 1e-18 && u < 0.0);
    }

    /// Diehl (1995) eqs. (2), (3), (4): the point lies on the circle, and the slope
    /// is the derivative of the height (central difference, error of order d^2).
    #[test]
    fn equations_2_3_4_circle() {
        let (centre, r) = ([0.03, 0.008], 0.009);
        for xi in [0.022, 0.027, 0.03, 0.034] {
            assert!(circle_residual([xi, circle_height(xi, centre, r)], centre, r).abs() < 1e-18);
            let d = 1e-7;
            let slope =
                (circle_height(xi + d, centre, r) - circle_height(xi - d, centre, r)) / (2.0 * d);
            assert!((slope - circle_slope(xi, centre, r)).abs() < 1e-7);
        }
    }

    /// Diehl (1995) eq. (5): centre in beam axes; the centreline starts 8.9909262 mm
    /// from the centre, an overclosure of 9.0737722 um (semantics section 1).
    #[test]
    fn equation_5_beam_axes() {
        let problem = FirstProblem::diehl();
        let frame = Frame::facing(&problem.beam, [0.0, 45e-3]);
        let [xi_c, eta_c] = frame.local([0.0, 45e-3]);
        let alpha = 2.54455023f64.to_radians();
        assert!((xi_c - (45e-3 * alpha.cos() - 7e-3 * alpha.sin())).abs() < 1e-11);
        assert!((eta_c - (45e-3 * alpha.sin() + 7e-3 * alpha.cos())).abs() < 1e-11);
        assert!((9e-3 - eta_c - 9.0737722e-6).abs() < 6e-14);
        assert!((xi_c - 44.644857e-3).abs() < 6e-10);
    }

    /// Diehl (1995) eqs. (6), (7): the root fulfils the equation as printed, and
    /// deflection, slope and force those of the cantilever.
    #[test]
    fn equations_6_7_contact() {
        for (centre, r) in
            [([0.0447, 0.008991], 0.009), ([0.0147, 0.0077], 0.009), ([0.2, -0.05], 0.1)]
        {
            let xi_l = contact_length(centre, r).unwrap();
            let s = (r * r - (xi_l - centre[0]).powi(2)).sqrt();
            let sides = (centre[1] - s, 2.0 / 3.0 * xi_l * (xi_l - centre[0]) / s);
            assert!((sides.0 / sides.1 - 1.0).abs() < 1e-10);
            let found = deflection_and_force(xi_l, centre, r, EI);
            let (u, theta) = deflection_and_slope(found.force, xi_l, EI);
            assert!(
                (u / found.deflection - 1.0).abs() < 1e-12
                    && (theta / found.slope - 1.0).abs() < 1e-10
            );
        }
        assert_eq!(
            contact_length([0.02, 0.0091], 0.009),
            Err(TheoryError::NoContact { gap: 0.0091 - 0.009 })
        );
        assert_eq!(contact_length([-0.01, 0.008], 0.009), Err(TheoryError::PastClamp));
        assert_eq!(contact_length([0.001, 0.006], 0.009), Err(TheoryError::PastClamp));
    }

    /// Diehl (1995) eq. (8): last row of the table, F_y from F.
    #[test]
    fn equation_8_drive_force() {
        let problem = FirstProblem::diehl();
        let centre = Frame::facing(&problem.beam, [0.0, 45e-3]).local([0.0, 15e-3]);
        let found = deflection_and_force(contact_length(centre, 9e-3).unwrap(), centre, 9e-3, EI);
        let alpha = (2.222e-3f64).atan2(50e-3);
        assert!((drive_force(found.force, alpha, found.slope, 0.3) + 36.07584).abs() < 6e-6);
        let rows = problem.rows(0.3, 20, crate::Reference::Linear).unwrap();
        assert!(
            (rows[20].rf2 / drive_force(found.force, alpha, found.slope, 0.3) - 1.0).abs() < 1e-13
        );
        assert!(
            (rows[20].rf1 / side_force(found.force, alpha, found.slope, 0.3) - 1.0).abs() < 1e-13
        );
    }

    /// Diehl (1995) eqs. (9), (10): arm and angle, and back to the centre.
    #[test]
    fn equations_9_10_cam() {
        let cam = crate::SecondProblem::project();
        for phi in [0.7, 0.0, -0.3, 2.0] {
            let (arm, angle) = arm_and_angle(cam.centre(phi), cam.pivot);
            assert!((arm - cam.arm).abs() < 1e-16 && (angle - phi).abs() < 1e-14);
        }
    }

    /// Diehl (1995) eqs. (11), (12): the moment as printed is that of the rows.
    #[test]
    fn equations_11_12_drive_moment() {
        let cam = crate::SecondProblem::project();
        let row = cam.rows(0.3, 20, crate::Reference::Linear).unwrap()[14];
        let centre = cam.centre(cam.start_angle + row.ur3);
        let found = deflection_and_force(contact_length(centre, 9e-3).unwrap(), centre, 9e-3, EI);
        let force = cam_force(found.force, found.slope, 0.3);
        let moment = drive_moment(force, found.contact_length, found.deflection, cam.pivot);
        assert!((moment / row.rm3 - 1.0).abs() < 1e-12);
    }
}
