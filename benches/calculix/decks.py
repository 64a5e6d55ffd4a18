"""Decks of problem 1 as a solid strip, for CalculiX.

      slaves on the circle ("circle")          slaves on the strip ("strip")

              |__|                                     |__|
         .---o|__|   nodes of the circle          .----o__|   nodes of the face
        /    o|__|   against the faces           /    |o__|   against the faces
       |  c  o|__|   of the strip               |  c  |o__|   of the circle
        \    o|__|                               \    |o__|
         '---o|__|                                '----o__|

CalculiX has no contact faces on beams, so the beam is a strip of incompatible
mode bricks, `elements` along and two across, one over the width, with nu = 0.
The circle is one layer of bricks on an arc, all nodes of which are prescribed.
Units: mm, N, MPa.

The second number of the linear law is the tension at a large gap.  Node to
surface, friction acts with it on open points too; left to its default it costs
a factor of six in accuracy.
"""

from dataclasses import dataclass, replace
from math import cos, pi, radians, sin

from reference import INCREMENTS, Strip

MM = 1000.0
ARC = (-40.0, 10.0)  # degrees from +x: where the strip can touch the circle
ACROSS = 2  # elements over the thickness


@dataclass(frozen=True)
class Variant:
    """One way to set the problem up."""

    name: str
    friction: float = 0.0
    slaves: str = "circle"
    kind: str = "NODE TO SURFACE"
    law: str = "LINEAR, 1e3, 1e-3"  # N/mm3, N/mm2; or "EXPONENTIAL, c0, p0"
    elements: int = 24
    degrees: float = 2.0
    increments: int = INCREMENTS

    def with_friction(self, friction):
        return replace(self, friction=friction)


def nodes_of(grid, first):
    """Numbers of a structured grid, and its lines of *NODE."""
    lines = [f"{first + i}, {x:.12g}, {y:.12g}, {z:.12g}" for i, (x, y, z) in enumerate(grid)]
    return lines


def bricks(along, across, first_node, first_element):
    """*ELEMENT lines of a grid of bricks: node (i, j, k), k over the width fastest."""

    def node(i, j, k):
        return first_node + (i * (across + 1) + j) * 2 + k

    lines = []
    for i in range(along):
        for j in range(across):
            # across, then along, then over the width: a right-handed order of corners
            corners = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
            numbers = [node(*corner, 0) for corner in corners]
            numbers += [node(*corner, 1) for corner in corners]
            number = first_element + i * across + j
            lines.append(", ".join(map(str, [number] + numbers)))
    return lines


def strip_nodes(strip, elements):
    """Grid of the strip: along the mid-line, from its left face to the right, width."""
    direction = (cos(strip.angle), sin(strip.angle))
    right = (direction[1], -direction[0])
    grid = []
    for i in range(elements + 1):
        s = strip.length * i / elements
        for j in range(ACROSS + 1):
            off = strip.thickness * (j / ACROSS - 0.5)
            x = strip.base[0] + s * direction[0] + off * right[0]
            y = strip.base[1] + s * direction[1] + off * right[1]
            grid += [(MM * x, MM * y, 0.0), (MM * x, MM * y, MM * strip.width)]
    return grid


def circle_nodes(strip, degrees):
    """Grid of the arc: along the arc, from inside to the contact face, width."""
    count = round((ARC[1] - ARC[0]) / degrees)
    outer = MM * strip.circle_radius
    grid = []
    for i in range(count + 1):
        angle = radians(ARC[0] + (ARC[1] - ARC[0]) * i / count)
        for radius in (outer - 1.0, outer):
            x = radius * cos(angle)
            y = MM * strip.first_height + radius * sin(angle)
            grid += [(x, y, 0.0), (x, y, MM * strip.width)]
    return grid, count


def deck(variant, strip=Strip()):
    """The deck as text; the first increment ends at t = 1/20."""
    strip_grid = strip_nodes(strip, variant.elements)
    circle_grid, count = circle_nodes(strip, variant.degrees)
    first_circle = len(strip_grid) + 1
    strip_bricks = bricks(variant.elements, ACROSS, 1, 1)
    first_brick = len(strip_bricks) + 1
    circle_bricks = bricks(count, 1, first_circle, first_brick)
    clamp = range(1, 2 * (ACROSS + 1) + 1)
    # Faces of a brick whose corners 1 2 3 4 are (i,j) (i,j+1) (i+1,j+1) (i+1,j) below and
    # 5 6 7 8 above: S6 holds corners 4 1 5 8, at j; S4 holds 2 3 7 6, at j + 1.
    faces = {
        "STRIP": [f"{1 + i * ACROSS}, S6" for i in range(variant.elements)],
        "CIRCLE": [f"{first_brick + i}, S4" for i in range(count)],
    }
    slave, master = ("CIRCLE", "STRIP") if variant.slaves == "circle" else ("STRIP", "CIRCLE")
    law, *numbers = variant.law.split(",")
    step = 1.0 / variant.increments
    times = [f"{k / INCREMENTS:.12g}" for k in range(1, INCREMENTS + 1)]
    drop = MM * (strip.last_height - strip.first_height)
    lines = ["*NODE, NSET=NSTRIP"]
    lines += nodes_of(strip_grid, 1)
    lines += ["*NODE, NSET=NCIRCLE"]
    lines += nodes_of(circle_grid, first_circle)
    lines += ["*ELEMENT, TYPE=C3D8I, ELSET=ESTRIP"] + strip_bricks
    lines += ["*ELEMENT, TYPE=C3D8, ELSET=ECIRCLE"] + circle_bricks
    lines += ["*NSET, NSET=CLAMP"] + [str(number) for number in clamp]
    for name in ("STRIP", "CIRCLE"):
        lines += [f"*SURFACE, NAME={name}, TYPE=ELEMENT"] + faces[name]
    lines += [
        "*MATERIAL, NAME=STUFF",
        "*ELASTIC",
        f"{strip.modulus / 1e6:g}, {strip.poisson:g}",
        "*SOLID SECTION, ELSET=ESTRIP, MATERIAL=STUFF",
        "*SOLID SECTION, ELSET=ECIRCLE, MATERIAL=STUFF",
        "*SURFACE INTERACTION, NAME=TOUCH",
        f"*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={law.strip()}",
        ",".join(numbers).strip(),
    ]
    if variant.friction:
        lines += ["*FRICTION", f"{variant.friction:g}, {STICK:g}"]
    lines += [
        f"*CONTACT PAIR, INTERACTION=TOUCH, TYPE={variant.kind}",
        f"{slave}, {master}",
        "*TIME POINTS, NAME=COMMON",
        *[", ".join(times[i : i + 8]) for i in range(0, len(times), 8)],
        "*STEP, NLGEOM, INC=10000",
        "*STATIC",
        f"{step:.12g}, 1., 1e-8, {step:.12g}",
        "*BOUNDARY",
        "CLAMP, 1, 3",
        "NSTRIP, 3, 3",
        "NCIRCLE, 1, 1",
        "NCIRCLE, 3, 3",
        f"NCIRCLE, 2, 2, {drop:g}",
        "*NODE PRINT, NSET=CLAMP, TOTALS=ONLY, TIME POINTS=COMMON",
        "RF",
        "*NODE PRINT, NSET=NCIRCLE, TOTALS=ONLY, TIME POINTS=COMMON",
        "RF",
        "*END STEP",
    ]
    return "\n".join(lines) + "\n"


STICK = 1.0e4  # N/mm3, slope of the friction law of CalculiX below the limit
