"""Writes corpus/field/hook_in_space.inp: the hook of corpus/field/hook.inp as a body of tetrahedra.

    pip install gmsh
    python3 verification/meshes/hook_in_space.py > corpus/field/hook_in_space.inp

Half of the width is meshed; the plane z = 0 is one of symmetry. The edge of the slot is a skin upon a
plate that does not yield, as in the plane, and of hexahedra.
"""

import argparse
import math

import gmsh

WIDTH = 4.0
"""Half of the width of the hook [mm]."""

FACES = {frozenset((0, 1, 2)): 1, frozenset((0, 3, 1)): 2, frozenset((1, 3, 2)): 3, frozenset((2, 3, 0)): 4}
"""Numbers of the faces of a tetrahedron by its corners."""


def on_circle(centre, radius, degrees):
    angle = math.radians(degrees)
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


def hook(arm, head, order=2):
    """Nodes {tag: place}, tetrahedra {tag: nodes} and faces (tetrahedron, number) of the head.

    `arm` and `head` are the sizes of elements there.
    """
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    occ = gmsh.model.occ
    holds, leads, radius = (17.45711, 2.75), (18.06603, 2.75), 0.5
    places = {
        "root below": (0.0, 0.0),
        "tip below": (21.5, 0.0),
        "tip above": (21.5, 1.34474),
        "lead from": on_circle(leads, radius, 60.0),
        "lead to": on_circle(leads, radius, 90.0),
        "hold from": on_circle(holds, radius, 90.0),
        "hold to": on_circle(holds, radius, 135.0),
        "inner corner": (16.0, 2.0),
        "root above": (0.0, 2.0),
    }
    point = {name: occ.addPoint(x, y, 0.0) for name, (x, y) in places.items()}
    centres = [occ.addPoint(x, y, 0.0) for x, y in (leads, holds)]
    outline = [
        occ.addLine(point["root below"], point["tip below"]),
        occ.addLine(point["tip below"], point["tip above"]),
        occ.addLine(point["tip above"], point["lead from"]),
        occ.addCircleArc(point["lead from"], centres[0], point["lead to"]),
        occ.addLine(point["lead to"], point["hold from"]),
        occ.addCircleArc(point["hold from"], centres[1], point["hold to"]),
        occ.addLine(point["hold to"], point["inner corner"]),
        occ.addLine(point["inner corner"], point["root above"]),
        occ.addLine(point["root above"], point["root below"]),
    ]
    face = occ.addPlaneSurface([occ.addCurveLoop(outline)])
    swept = occ.extrude([(2, face)], 0.0, 0.0, WIDTH)
    occ.remove([(0, tag) for tag in centres])
    occ.synchronize()
    touched = [swept[2 + side][1] for side in (2, 3, 4, 5, 6)]
    size = gmsh.model.mesh.field
    near = size.add("Box")
    for name, value in {
        "VIn": head,
        "VOut": arm,
        "XMin": 16.0,
        "XMax": 22.0,
        "YMin": 1.2,
        "YMax": 4.0,
        "ZMin": 0.0,
        "ZMax": WIDTH,
        "Thickness": 2.0,
    }.items():
        size.setNumber(near, name, value)
    size.setAsBackgroundMesh(near)
    for name in ("MeshSizeExtendFromBoundary", "MeshSizeFromPoints", "MeshSizeFromCurvature"):
        gmsh.option.setNumber(f"Mesh.{name}", 0)
    gmsh.option.setNumber("Mesh.ElementOrder", order)
    gmsh.option.setNumber("Mesh.HighOrderOptimize", 1)
    gmsh.model.mesh.generate(3)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    nodes = {int(tag): coordinates[3 * k : 3 * k + 3] for k, tag in enumerate(tags)}
    _, tags, lists = gmsh.model.mesh.getElements(3)
    count = len(lists[0]) // len(tags[0])
    solids = {
        k + 1: [int(node) for node in lists[0][count * k : count * (k + 1)]] for k in range(len(tags[0]))
    }
    skin = set()
    for surface in touched:
        kinds, tags, lists = gmsh.model.mesh.getElements(2, surface)
        count = len(lists[0]) // len(tags[0])
        skin |= {frozenset(int(n) for n in lists[0][count * k : count * k + 3]) for k in range(len(tags[0]))}
    gmsh.finalize()
    head_faces = []
    for tag, solid in solids.items():
        for corners, number in FACES.items():
            if frozenset(solid[k] for k in corners) in skin:
                head_faces.append((tag, number))
    used = {node for solid in solids.values() for node in solid}
    return {tag: place for tag, place in nodes.items() if tag in used}, solids, head_faces


def edge(along, first):
    """The skin of the slot: nodes, hexahedra of twenty nodes, nodes upon the plate.

    Its outside runs down, round the corner, along, round the other one and up; `along` faces over the
    width.
    """
    near, far, outside, inside = (20.5, 2.65), (22.3, 2.65), 0.6, 0.2
    line = []
    for k in range(4):
        line.append(((19.9, 5.0 - 2.35 * k / 4), (20.3, 5.0 - 2.35 * k / 4)))
    for k in range(8):
        line.append(tuple(on_circle(near, r, 180.0 + 90.0 * k / 8) for r in (outside, inside)))
    for k in range(6):
        line.append(((20.5 + 1.8 * k / 6, 2.05), (20.5 + 1.8 * k / 6, 2.45)))
    for k in range(8):
        line.append(tuple(on_circle(far, r, 270.0 + 90.0 * k / 8) for r in (outside, inside)))
    for k in range(5):
        line.append(((22.9, 2.65 + 2.35 * k / 4), (22.5, 2.65 + 2.35 * k / 4)))
    layers = 2 * along
    wide = WIDTH * 1.125
    nodes, number = {}, {}

    def node(i, j, k):
        """Station i along the outline, j = 0, 1, 2 from outside to inside, k over the width."""
        if (i, j, k) not in number:
            (ax, ay), (bx, by) = line[i]
            number[i, j, k] = first + len(number)
            nodes[number[i, j, k]] = (ax + (bx - ax) * j / 2, ay + (by - ay) * j / 2, wide * k / layers)
        return number[i, j, k]

    solids = {}
    for i in range(0, len(line) - 1, 2):
        for k in range(0, layers, 2):
            near_side = [node(i, 0, k), node(i + 2, 0, k), node(i + 2, 2, k), node(i, 2, k)]
            far_side = [node(i, 0, k + 2), node(i + 2, 0, k + 2), node(i + 2, 2, k + 2), node(i, 2, k + 2)]
            near_middles = [node(i + 1, 0, k), node(i + 2, 1, k), node(i + 1, 2, k), node(i, 1, k)]
            far_middles = [node(i + 1, 0, k + 2), node(i + 2, 1, k + 2), node(i + 1, 2, k + 2), node(i, 1, k + 2)]
            between = [node(i, 0, k + 1), node(i + 2, 0, k + 1), node(i + 2, 2, k + 1), node(i, 2, k + 1)]
            solids[first + len(solids)] = near_side + far_side + near_middles + far_middles + between
    held = sorted(tag for (_, j, _), tag in number.items() if j == 2)
    return nodes, solids, held


def lines(numbers, a_line=12):
    numbers = [str(number) for number in numbers]
    return [", ".join(numbers[k : k + a_line]) for k in range(0, len(numbers), a_line)]


def shortest(value):
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def deck(arm, head, along, increment):
    own, tetrahedra, faces = hook(arm, head)
    numbers = {tag: k + 1 for k, tag in enumerate(sorted(own))}
    skin, hexahedra, held = edge(along, 20001)
    text = [
        "*HEADING",
        "A cantilever hook of glass-filled polyamide in space, through a slot and out again, N and mm",
        "** Written by verification/meshes/hook_in_space.py. Half of the width; symmetric about z = 0.",
        "*NODE, NSET=HOOK",
    ]
    for tag, number in numbers.items():
        text.append(f"{number}, " + ", ".join(shortest(value) for value in own[tag]))
    text.append("*ELEMENT, TYPE=C3D10, ELSET=HOOK")
    for tag, solid in tetrahedra.items():
        # gmsh counts the last two edges the other way round
        order = solid[:8] + [solid[9], solid[8]]
        text.append(f"{tag}, " + ", ".join(str(numbers[node]) for node in order))
    text.append("*NODE, NSET=EDGE")
    text += [f"{tag}, " + ", ".join(shortest(value) for value in place) for tag, place in skin.items()]
    text.append("*ELEMENT, TYPE=C3D20R, ELSET=EDGE")
    for tag, solid in hexahedra.items():
        text.append(f"{tag}, " + ", ".join(map(str, solid[:15])) + ",")
        text.append(", ".join(map(str, solid[15:])))
    text += ["*NODE", "30000, 21.4, 5, 0", "*NSET, NSET=HELD", *lines(held)]
    text += ["*RIGID BODY, REF NODE=30000, TIE NSET=HELD"]
    text += ["*MATERIAL, NAME=PA66GF", "*ELASTIC", "7000.0, 0.35", "*PLASTIC"]
    text += ["60.0, 0.0", "85.0, 0.004", "105.0, 0.012", "120.0, 0.03"]
    text += ["*SOLID SECTION, ELSET=HOOK, MATERIAL=PA66GF", "*SOLID SECTION, ELSET=EDGE, MATERIAL=PA66GF"]
    text.append("*SURFACE, NAME=HEAD")
    text += [f"{tag}, S{number}" for tag, number in faces]
    # the face of nodes 1, 2, 6, 5 looks outward
    text += ["*SURFACE, NAME=SLOT", "EDGE, S3"]
    text += ["*SURFACE INTERACTION, NAME=SLIDING", "*FRICTION", "0.3"]
    text += ["*CONTACT PAIR, INTERACTION=SLIDING, TYPE=SURFACE TO SURFACE", "SLOT, HEAD"]
    root = [numbers[tag] for tag, place in own.items() if abs(place[0]) < 1e-9]
    middle = [numbers[tag] for tag, place in own.items() if abs(place[2]) < 1e-9]
    middle += [tag for tag, place in skin.items() if place[2] == 0.0 and tag not in held]
    text += ["*NSET, NSET=ROOT", *lines(sorted(root)), "*NSET, NSET=MIDDLE", *lines(sorted(middle))]
    text += ["*BOUNDARY", "ROOT, 1, 3", "MIDDLE, 3", "30000, 2, 6"]
    for name, way in (("IN", -6.6), ("OUT", 0.0)):
        text += ["*STEP, NLGEOM, INC=1000", name, "*STATIC", f"{increment}, 1.0, 1.0E-6, {increment}"]
        text += ["*BOUNDARY", f"30000, 1, 1, {way}"]
        if name == "IN":
            text += ["*NODE PRINT, NSET=ROOT, FREQUENCY=0", "RF", "*EL FILE, FREQUENCY=10", "S, PEEQ, LE"]
        text.append("*END STEP")
    return "\n".join(text) + "\n"


def main():
    reading = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    reading.add_argument("--arm", type=float, default=1.5, help="size of elements of the arm [mm]")
    reading.add_argument("--head", type=float, default=0.9, help="size of elements of the head [mm]")
    reading.add_argument("--along", type=int, default=8, help="faces of the slot over half of the width")
    reading.add_argument("--increment", type=float, default=0.02, help="part of a step")
    given = reading.parse_args()
    print(deck(given.arm, given.head, given.along, given.increment), end="")


if __name__ == "__main__":
    main()
