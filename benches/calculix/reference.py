"""The exact force on a rigid circle that is pushed along a cantilever strip.

            strip, clamped at the bottom
             |#|
        __   |#|        The circle moves down.  It touches the left face of the
      /    \ |#|        strip, t/2 from the mid-line, so its centre is at the
     |  c   ||#|        distance r + t/2 from the mid-line.  Friction acts at the
      \ __ / |#|        face too: about the mid-line it has the moment mu N t/2,
             |#|        counter-clockwise, against the bending by N.
          ___|#|___

The strip is a Reissner beam: it bends, stretches and shears.  With the section
angle f, the force n in the beam (constant up to the contact) and its parts n1
along and n2 across the section,

    x' = (1 + n1/EA) cos f - n2/kGA sin f        n1 =  nx cos f + ny sin f
    y' = (1 + n1/EA) sin f + n2/kGA cos f        n2 = -nx sin f + ny cos f
    EI f' = M        M' = -(x' ny - y' nx)

At the contact n = N (m + mu w) and M = mu N t/2, where m is the unit normal of
the mid-line that points away from the circle and w the direction in which the
circle drags.  The mid-line has a kink there, because the shear force jumps to
nothing; m is normal to the mean of both slopes.

The equations are integrated from the contact back to the clamp; the three
unknowns N, section angle and arc length at the contact follow from the three
conditions at the clamp by Newton's method.  Nothing here is shared with the
solver.  Units: m, N, Pa.
"""

from dataclasses import dataclass
from math import atan2, cos, hypot, sin

INCREMENTS = 20


@dataclass(frozen=True)
class Strip:
    """Problem 1 of Diehl (1995) as a strip with faces."""

    base: tuple = (7.0e-3, 0.0)
    tip: tuple = (9.222e-3, 50.0e-3)
    width: float = 25.0e-3
    thickness: float = 1.5e-3
    modulus: float = 6.9e9
    poisson: float = 0.0
    shear_factor: float = 5.0 / 6.0
    distance: float = 9.0e-3  # of the centre from the mid-line
    friction_lever: float = 0.75e-3  # of the face from the mid-line
    first_height: float = 45.0e-3
    last_height: float = 15.0e-3

    @property
    def length(self):
        return hypot(self.tip[0] - self.base[0], self.tip[1] - self.base[1])

    @property
    def angle(self):
        return atan2(self.tip[1] - self.base[1], self.tip[0] - self.base[0])

    @property
    def circle_radius(self):
        return self.distance - self.friction_lever

    def height(self, k, increments=INCREMENTS):
        return self.first_height + (self.last_height - self.first_height) * k / increments


class NotFound(Exception):
    """Newton's method did not converge."""


def stiffnesses(strip):
    area = strip.width * strip.thickness
    shear_modulus = strip.modulus / (2.0 * (1.0 + strip.poisson))
    return (
        strip.modulus * area,
        strip.shear_factor * shear_modulus * area,
        strip.modulus * strip.width * strip.thickness**3 / 12.0,
    )


def contact_state(strip, friction, height, unknowns):
    """Force n and state (x, y, f, M) at the contact."""
    normal_force, angle, _ = unknowns
    axial, shear, _ = stiffnesses(strip)
    kink = 0.0
    for _ in range(50):  # the mean slope depends on the force, weakly
        slope = angle + 0.5 * kink
        m = (sin(slope), -cos(slope))
        w = (m[1], -m[0])
        n = tuple(normal_force * (m[i] + friction * w[i]) for i in (0, 1))
        n1 = n[0] * cos(angle) + n[1] * sin(angle)
        n2 = -n[0] * sin(angle) + n[1] * cos(angle)
        last, kink = kink, atan2(n2 / shear, 1.0 + n1 / axial)
        if abs(kink - last) < 1e-16:
            break
    x = strip.distance * m[0]
    y = height + strip.distance * m[1]
    moment = friction * normal_force * strip.friction_lever
    return n, [x, y, angle, moment]


def at_clamp(strip, friction, height, unknowns, steps):
    """x, y and section angle at the clamp, and the force."""
    axial, shear, bending = stiffnesses(strip)
    n, state = contact_state(strip, friction, height, unknowns)

    def slope(state):
        _, _, f, moment = state
        c, s = cos(f), sin(f)
        stretch = 1.0 + (n[0] * c + n[1] * s) / axial
        gamma = (-n[0] * s + n[1] * c) / shear
        dx = stretch * c - gamma * s
        dy = stretch * s + gamma * c
        return [dx, dy, moment / bending, -(dx * n[1] - dy * n[0])]

    h = -unknowns[2] / steps
    for _ in range(steps):  # classical Runge-Kutta, order 4
        k1 = slope(state)
        k2 = slope([a + 0.5 * h * b for a, b in zip(state, k1)])
        k3 = slope([a + 0.5 * h * b for a, b in zip(state, k2)])
        k4 = slope([a + h * b for a, b in zip(state, k3)])
        state = [
            a + h / 6.0 * (p + 2.0 * q + 2.0 * r + s)
            for a, p, q, r, s in zip(state, k1, k2, k3, k4)
        ]
    return state[:3], n


def solve_3(matrix, right):
    """Gaussian elimination with pivoting."""
    rows = [list(row) + [b] for row, b in zip(matrix, right)]
    for i in range(3):
        pivot = max(range(i, 3), key=lambda j: abs(rows[j][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for j in range(i + 1, 3):
            factor = rows[j][i] / rows[i][i]
            rows[j] = [a - factor * b for a, b in zip(rows[j], rows[i])]
    result = [0.0] * 3
    for i in (2, 1, 0):
        known = sum(rows[i][j] * result[j] for j in range(i + 1, 3))
        result[i] = (rows[i][3] - known) / rows[i][i]
    return result


def touch(strip, friction, height, start, steps=200):
    """Unknowns and force at one height of the circle, from a near guess."""
    axial, _, bending = stiffnesses(strip)
    scales = (bending / strip.length**2, 1.0, strip.length)
    unknowns = list(start)

    def residual(unknowns):
        (x, y, f), n = at_clamp(strip, friction, height, unknowns, steps)
        off = [
            (x - strip.base[0]) / strip.length,
            (y - strip.base[1]) / strip.length,
            f - strip.angle,
        ]
        return off, n

    for _ in range(60):
        off, n = residual(unknowns)
        if max(abs(value) for value in off) < 1e-13:
            return unknowns, n
        columns = []
        for i in range(3):
            moved = list(unknowns)
            step = 1e-6 * scales[i]
            moved[i] += step
            forward, _ = residual(moved)
            moved[i] -= 2.0 * step
            backward, _ = residual(moved)
            columns.append([(a - b) / (2.0 * step) for a, b in zip(forward, backward)])
        matrix = [[columns[j][i] for j in range(3)] for i in range(3)]
        change = solve_3(matrix, [-value for value in off])
        unknowns = [value + delta for value, delta in zip(unknowns, change)]
    raise NotFound(f"no solution at height {height}")


def forces(strip=Strip(), friction=0.0, increments=INCREMENTS, steps=200):
    """Force that pushes the circle down, N, at increment ends 0 to the last."""
    height = strip.height(0, increments)
    # The straight strip: where the circle is nearest to its axis.
    along = (height - strip.base[1]) * sin(strip.angle) - strip.base[0] * cos(strip.angle)
    unknowns = [0.0, strip.angle, along]
    result = []
    for k in range(increments + 1):
        unknowns, n = touch(strip, friction, strip.height(k, increments), unknowns, steps)
        result.append(-n[1])
    return result


if __name__ == "__main__":
    print("k,height_mm,force_mu_0_N,force_mu_0.3_N")
    pairs = zip(forces(friction=0.0), forces(friction=0.3))
    for k, (smooth, rough) in enumerate(pairs):
        print(f"{k},{1e3 * Strip().height(k):g},{smooth:.8g},{rough:.8g}")
