//! A point against a curve x_c(xi) = sum_k N_k(xi) X_k of K control points.
//!
//! ```text
//!                 x slave            straight segment   K = 2
//!                 | g                smoothed corner    K = 3   quadratic Bezier, middle point X_k
//!      X_0 -------+------- X_1       rigid parabola     K = 3
//!                 xi                 through nodes      K = 4   cubic with a tangent at either end
//! ```
//!
//! Variables: N = 2 + 2 K, ordered (slave x, y, X_0 x, y, X_1 x, y, ...).

use super::{Gap, Order, Second};

/// Weights N_k of the control points at one parameter with their derivatives by xi.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weights<const K: usize> {
    /// N_k.
    pub value: [f64; K],
    /// dN_k/dxi.
    pub first: [f64; K],
    /// d2N_k/dxi2.
    pub second: [f64; K],
    /// d3N_k/dxi3.
    pub third: [f64; K],
}

impl Weights<2> {
    /// Straight segment, xi from 0 at the first to 1 at the second control point.
    pub fn straight(xi: f64) -> Self {
        Self { value: [1.0 - xi, xi], first: [-1.0, 1.0], second: [0.0; 2], third: [0.0; 2] }
    }
}

impl Weights<3> {
    /// Quadratic Bezier curve.
    pub fn quadratic(xi: f64) -> Self {
        let rest = 1.0 - xi;
        Self {
            value: [rest * rest, 2.0 * xi * rest, xi * xi],
            first: [-2.0 * rest, 2.0 - 4.0 * xi, 2.0 * xi],
            second: [2.0, -4.0, 2.0],
            third: [0.0; 3],
        }
    }

    /// Smoothed corner on the nodes (k-1, k, k+1) with smoothing fraction f: weights
    /// f s0, (1-f)(s0+s2)+s1, f s2 of the Bezier weights. [semantics: smoothed corner]
    pub fn corner(xi: f64, fraction: f64) -> Self {
        let bezier = Self::quadratic(xi);
        let blend = |s: [f64; 3]| {
            [fraction * s[0], (1.0 - fraction) * (s[0] + s[2]) + s[1], fraction * s[2]]
        };
        Self {
            value: blend(bezier.value),
            first: blend(bezier.first),
            second: blend(bezier.second),
            third: [0.0; 3],
        }
    }
}

impl Weights<3> {
    /// Nose beyond the sharp edge at the middle one of the nodes (k-1, k, k+1). It begins where the
    /// segment before the edge, prolonged by the fraction `before` of it, ends; it goes on by the same
    /// and down by the fraction `behind` of the one behind. Not `ahead`: the same before the segment
    /// behind the edge.
    pub fn nose(xi: f64, [before, behind]: [f64; 2], ahead: bool) -> Self {
        let control = match ahead {
            true => [
                [-before, 1.0 + before, 0.0],
                [-2.0 * before, 1.0 + 2.0 * before, 0.0],
                [-2.0 * before, 1.0 + 2.0 * before - behind, behind],
            ],
            false => [
                [before, 1.0 + 2.0 * behind - before, -2.0 * behind],
                [0.0, 1.0 + 2.0 * behind, -2.0 * behind],
                [0.0, 1.0 + behind, -behind],
            ],
        };
        let bezier = Self::quadratic(xi);
        let blend = |s: [f64; 3]| {
            let of_node = |node: usize| (0..3).map(|k| s[k] * control[k][node]).sum::<f64>();
            [of_node(0), of_node(1), of_node(2)]
        };
        Self {
            value: blend(bezier.value),
            first: blend(bezier.first),
            second: blend(bezier.second),
            third: [0.0; 3],
        }
    }
}

impl Weights<4> {
    /// Cubic Bezier curve.
    pub fn cubic(xi: f64) -> Self {
        let rest = 1.0 - xi;
        Self {
            value: [rest.powi(3), 3.0 * xi * rest * rest, 3.0 * xi * xi * rest, xi.powi(3)],
            first: [
                -3.0 * rest * rest,
                3.0 * rest * rest - 6.0 * xi * rest,
                6.0 * xi * rest - 3.0 * xi * xi,
                3.0 * xi * xi,
            ],
            second: [6.0 * rest, 6.0 * xi - 12.0 * rest, 6.0 * rest - 12.0 * xi, 6.0 * xi],
            third: [-6.0, 18.0, -18.0, 6.0],
        }
    }

    /// Cubic between the nodes `begin` and `begin` + 1 of four whose derivatives at these are the given weights of
    /// the nodes, docs/theory.md section 5.3.
    pub fn through(xi: f64, begin: usize, [from, to]: &[[f64; 4]; 2]) -> Self {
        let blend = |[a, b, t0, t1]: [f64; 4]| {
            let mut weights: [f64; 4] = std::array::from_fn(|k| t0 * from[k] + t1 * to[k]);
            weights[begin] += a;
            weights[begin + 1] += b;
            weights
        };
        let (square, cube) = (xi * xi, xi * xi * xi);
        let rise = 3.0 * square - 2.0 * cube;
        Self {
            value: blend([1.0 - rise, rise, xi - 2.0 * square + cube, cube - square]),
            first: blend([
                6.0 * (square - xi),
                6.0 * (xi - square),
                1.0 - 4.0 * xi + 3.0 * square,
                3.0 * square - 2.0 * xi,
            ]),
            second: blend([12.0 * xi - 6.0, 6.0 - 12.0 * xi, 6.0 * xi - 4.0, 6.0 * xi - 2.0]),
            third: blend([12.0, -12.0, 6.0, 6.0]),
        }
    }
}

/// The coordinate sigma along the master as a given function of xi at one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Along {
    /// sigma [L].
    pub value: f64,
    /// d sigma/dxi [L].
    pub first: f64,
    /// d2 sigma/dxi2 [L].
    pub second: f64,
}

impl Along {
    /// Straight segment: sigma = start + reference_length xi.
    pub fn straight(start: f64, reference_length: f64, xi: f64) -> Self {
        Self { value: start + reference_length * xi, first: reference_length, second: 0.0 }
    }

    /// Smoothed corner: sigma = node - a1 + 2 a1 s + (a2 - a1) s^2, with the coordinate of the
    /// corner's node and the reference lengths a1, a2 cut off. [semantics: slip measure]
    pub fn corner(node: f64, a1: f64, a2: f64, s: f64) -> Self {
        Self {
            value: node - a1 + 2.0 * a1 * s + (a2 - a1) * s * s,
            first: 2.0 * a1 + 2.0 * (a2 - a1) * s,
            second: 2.0 * (a2 - a1),
        }
    }
}

/// The curve and its parameter derivatives at one parameter.
struct Local {
    position: [f64; 2],
    first: [f64; 2],
    second: [f64; 2],
    third: [f64; 2],
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn local<const K: usize>(control: &[[f64; 2]; K], weights: &Weights<K>) -> Local {
    let sum = |w: &[f64; K]| {
        let mut total = [0.0; 2];
        for k in 0..K {
            total[0] += w[k] * control[k][0];
            total[1] += w[k] * control[k][1];
        }
        total
    };
    Local {
        position: sum(&weights.value),
        first: sum(&weights.first),
        second: sum(&weights.second),
        third: sum(&weights.third),
    }
}

/// Weights of a variable in x_s - x_c, in the tangent and in its derivative by xi.
struct Variable {
    component: usize,
    relative: f64,
    tangent: f64,
    curvature: f64,
}

fn variable<const K: usize>(weights: &Weights<K>, index: usize) -> Variable {
    let component = index % 2;
    if index < 2 {
        return Variable { component, relative: 1.0, tangent: 0.0, curvature: 0.0 };
    }
    let k = index / 2 - 1;
    Variable {
        component,
        relative: -weights.value[k],
        tangent: weights.first[k],
        curvature: weights.second[k],
    }
}

/// Gap of a point against the curve at the parameter `xi` of its projection, which must satisfy
/// (x_s - x_c).a = 0 to round-off (the search sees to that).
///
/// With F(xi, q) = (x_s - x_c).a = 0: xi_i = -F_i/F_xi,
/// xi_ij = -(F_ij + F_i,xi xi_j + F_j,xi xi_i + F_xixi xi_i xi_j)/F_xi; dg = n.(dx_s - v);
/// The direction is d sigma/|d sigma/dx_s|; |d sigma/dx_s| = sigma' |a|/|F_xi|.
/// D dg = -(n.v1) Dxi - (n.V1) dxi - b dxi Dxi + (g/m)(n.v1 + b dxi)(n.V1 + b Dxi).
/// `None` for a degenerate curve or a point on its centre of curvature. [semantics: closest point]
pub fn point_to_curve<const K: usize, const N: usize, O: Order>(
    point: [f64; 2],
    control: &[[f64; 2]; K],
    weights: &Weights<K>,
    along: &Along,
    xi: f64,
) -> Option<Gap<N, O>> {
    const { assert!(N == 2 + 2 * K) }
    let curve = local(control, weights);
    let a = curve.first;
    let metric = dot(a, a);
    if !(metric > 0.0 && metric.is_finite()) {
        return None;
    }
    let size = metric.sqrt();
    let tangent = [a[0] / size, a[1] / size];
    let normal = [-tangent[1], tangent[0]];
    let apart = [point[0] - curve.position[0], point[1] - curve.position[1]];
    let slope = dot(apart, curve.second) - metric;
    if slope.abs() <= 1e-9 * metric {
        return None;
    }
    let variables: [Variable; N] = std::array::from_fn(|i| variable(weights, i));
    let (mut gradient, mut slip_gradient) = ([0.0; N], [0.0; N]);
    let mut by = [0.0; N]; // xi_i
    for (i, v) in variables.iter().enumerate() {
        let c = v.component;
        by[i] = -(v.relative * curve.first[c] + v.tangent * apart[c]) / slope;
        gradient[i] = -v.relative * normal[c];
        slip_gradient[i] = along.first * by[i];
    }
    // Length of d sigma/dx_s.
    let length = slip_gradient[0].hypot(slip_gradient[1]);
    let scale = if length > 0.0 { 1.0 / length } else { 0.0 };
    let direction = slip_gradient.map(|slip| scale * slip);
    let overclosure = -dot(normal, apart);
    let bent = Bent { curve: &curve, normal, apart, open: -overclosure, slope, metric };
    let gap = Gap {
        overclosure,
        along: along.value,
        gradient,
        slip_gradient,
        direction,
        second: O::second(|| bent.second((&variables, &by), along, (scale, &direction))),
        normal,
        tangent,
        position: curve.position,
        parameter: xi,
        bend: -dot(normal, curve.second) / slope,
    };
    gap.is_finite().then_some(gap)
}

/// Overclosure of a point against the curve at the parameter of its projection [L], without
/// derivatives. `None` for a degenerate curve.
pub fn overclosure<const K: usize>(
    point: [f64; 2],
    control: &[[f64; 2]; K],
    weights: &Weights<K>,
) -> Option<f64> {
    let curve = local(control, weights);
    let size = dot(curve.first, curve.first).sqrt();
    let normal = [-curve.first[1] / size, curve.first[0] / size];
    let apart = [point[0] - curve.position[0], point[1] - curve.position[1]];
    (size > 0.0 && size.is_finite()).then(|| -dot(normal, apart))
}

/// A point against a curve, as second derivatives ask for it.
struct Bent<'a> {
    curve: &'a Local,
    normal: [f64; 2],
    apart: [f64; 2],
    /// g.
    open: f64,
    /// F_xi.
    slope: f64,
    /// m.
    metric: f64,
}

impl Bent<'_> {
    /// Second derivatives, of the derivatives `xi` of the parameter and the direction, which is
    /// `scale` d sigma/dq.
    fn second<const N: usize>(
        &self,
        (variables, xi): (&[Variable; N], &[f64; N]),
        along: &Along,
        (scale, direction): (f64, &[f64; N]),
    ) -> Second<N> {
        let Self { curve, normal, apart, open, slope, metric } = *self;
        let bend = dot(normal, curve.second);
        let slope_xi = dot(apart, curve.third) - 3.0 * dot(curve.first, curve.second);
        let mut change = [0.0; N]; // F_i,xi
        let mut turn = [0.0; N]; // n.v1_i
        let mut tilt = [0.0; N]; // n.v1_i + b xi_i
        let mut growth = [0.0; N]; // of the logarithm of |d sigma/dx_s|
        for (i, v) in variables.iter().enumerate() {
            let c = v.component;
            change[i] = v.relative * curve.second[c] + v.curvature * apart[c]
                - 2.0 * v.tangent * curve.first[c];
            turn[i] = v.tangent * normal[c];
            tilt[i] = turn[i] + bend * xi[i];
            let stretch =
                (v.tangent * curve.first[c] + dot(curve.first, curve.second) * xi[i]) / metric;
            let turning = (change[i] + slope_xi * xi[i]) / slope;
            growth[i] = along.second / along.first * xi[i] + stretch - turning;
        }
        let mut second = Second::ZERO;
        for i in 0..N {
            for j in i..N {
                let (p, q) = (&variables[i], &variables[j]);
                let mixed = if p.component == q.component {
                    p.relative * q.tangent + p.tangent * q.relative
                } else {
                    0.0
                };
                let xi_ij =
                    -(mixed + change[i] * xi[j] + change[j] * xi[i] + slope_xi * xi[i] * xi[j])
                        / slope;
                let g_ij = -turn[i] * xi[j] - turn[j] * xi[i] - bend * xi[i] * xi[j]
                    + open / metric * tilt[i] * tilt[j];
                let s_ij = along.first * xi_ij + along.second * xi[i] * xi[j];
                second.hessian[i][j] = -g_ij;
                second.hessian[j][i] = -g_ij;
                second.direction_derivative[i][j] = scale * s_ij - direction[i] * growth[j];
                second.direction_derivative[j][i] = scale * s_ij - direction[j] * growth[i];
            }
        }
        second
    }
}
