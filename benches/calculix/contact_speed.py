"""A block slid on a foundation with friction: processor time and memory beside CalculiX.

    python3 benches/calculix/contact_speed.py --short    the smallest of each, one pair of runs
    python3 benches/calculix/contact_speed.py            5,000 and 20,000 dofs, three pairs
    python3 benches/calculix/contact_speed.py --full     79,000 dofs in space too (CalculiX takes its time)
    python3 benches/calculix/contact_speed.py --stiffness 10 --keep DIR

Needs the program `ccx` (Debian: apt-get install calculix-ccx), or --ccx PATH.  It is
run as it is and is no part of this project.

              moves down, then along
               o--o--o--o--o--o                mu = 0.2; the meshes do not match;
               |  |  |  |  |  |                slave nodes on the block, which
               o--o--o--o--o--o                face the faces of the foundation
        o-o-o-o-o-o-o-o-o-o-o-o-o-o-o-o
        | | | | | | | | | | | | | | | |
        o-o-o-o-o-o-o-o-o-o-o-o-o-o-o-o
                    fixed

Large displacements, linear elastic, two increments down and four along.  Both programs
read the same deck: linear contact of a stiffness at which the forces are within 1.3 % of
those of ten times as much (`--stiffness 10` multiplies it and `--forces` prints them; in the
plane ccx does not converge with twice as much and these increments).  Runs of both take turns; the ratio is that of the processor times, user and system, of one
thread, files written.  Both solved the same problem if the force on the block and the
displacements of some nodes inside agree: the column `off %`, of the largest value.
"""

import sys

from solids import AGREES, CORNERS, beside, cases_of, lines, off, options, table

SIZES = {"5k": 5_000, "20k": 20_000, "79k": 79_000}
SPACE_SIZES = {"5k": 4_700, "20k": 20_000, "79k": 79_000}
PLANE = ["CPE4", "CPS4"]
KINDS = ["CPE4", "C3D8"]
MODULUS = 2.1e5
# Length, width and height of the foundation and of the block, and the size of their elements.
FOUNDATION, BLOCK = (24.0, 14.0, 6.0), (10.0, 8.0, 6.0)
FINER = 0.83  # elements of the block over those of the foundation
DOWN, ALONG = 0.02, 2.0
PLACE = (5.0, 3.0, 6.0)  # of the block's first corner
STIFF = 50.0  # stiffness of contact [modulus over the height of the block]
STICK = 0.2  # slope of sticking friction over that stiffness


def grid(kind, box, size):
    """Elements of such a size along the sides of a box."""
    cells = [max(1, round(side / size)) for side in box]
    return (cells[0], cells[2], 0) if kind in PLANE else tuple(cells)


def nodes_of(cells):
    return [(i, j, k) for k in range(cells[2] + 1) for j in range(cells[1] + 1) for i in range(cells[0] + 1)]


def parts(kind, size):
    """The two grids."""
    return grid(kind, FOUNDATION, size), grid(kind, BLOCK, FINER * size)


def dofs_of(kind, size):
    nodes = sum((a + 1) * (b + 1) * (c + 1) for a, b, c in parts(kind, size))
    return nodes * (2 if kind in PLANE else 3)


def size_for(kind, dofs):
    """Size of the elements that gives about so many dofs."""
    return min((0.05 * 1.005**k for k in range(900)), key=lambda size: abs(dofs_of(kind, size) - dofs))


class Part:
    """A grid of elements with its numbers."""

    def __init__(self, kind, cells, box, corner, first):
        self.kind, self.cells = kind, cells
        plane = kind in PLANE
        axes = (0, 2) if plane else (0, 1, 2)
        places = nodes_of(cells)
        self.number = {place: first[0] + at for at, place in enumerate(places)}
        self.coordinates = {
            self.number[place]: [
                corner[axis] * (not (plane and axis == 1)) + box[axis] * place[at] / cells[at]
                for at, axis in enumerate(axes)
            ]
            for place in places
        }
        self.elements, self.at_bottom, self.at_top = {}, [], []
        corners = [c for c in CORNERS if c[2] == 0] if plane else CORNERS
        up = 1 if plane else 2
        number = first[1]
        for k in range(max(1, cells[2])):
            for j in range(cells[1]):
                for i in range(cells[0]):
                    cell = (i, j, k)
                    nodes = [tuple(c + o // 2 for c, o in zip(cell, offset)) for offset in corners]
                    self.elements[number] = [self.number[node] for node in nodes]
                    if cell[up] == 0:
                        self.at_bottom.append(number)
                    if cell[up] == cells[up] - 1:
                        self.at_top.append(number)
                    number += 1
        layer = lambda at: [n for place, n in self.number.items() if place[up] == at]
        self.bottom, self.top = layer(0), layer(cells[up])


def deck(kind, size, stiffness, mu):
    """The deck, which both programs read."""
    plane = kind in PLANE
    below, above = parts(kind, size)
    foundation = Part(kind, below, FOUNDATION, (0.0, 0.0, 0.0), (1, 1))
    next_ones = (len(foundation.number) + 1, len(foundation.elements) + 1)
    block = Part(kind, above, BLOCK, PLACE, next_ones)
    text = ["*HEADING", f"{kind}, block on a foundation", "*NODE, NSET=ALL"]
    for part in (foundation, block):
        text += [f"{n}, " + ", ".join(map(repr, at)) for n, at in part.coordinates.items()]
    for part, name in ((foundation, "FOUNDATION"), (block, "BLOCK")):
        text.append(f"*ELEMENT, TYPE={kind}, ELSET={name}")
        text += [", ".join(map(str, [number] + nodes)) for number, nodes in part.elements.items()]
    probe = [n for n in block.number.values() if n not in set(block.top)]
    probe = probe[:: max(1, len(probe) // 20)]
    for name, numbers in (("FIXED", foundation.bottom), ("MOVED", block.top), ("PROBE", probe)):
        text += [f"*NSET, NSET={name}"] + lines(numbers)
    lower, upper = ("S1", "S3") if plane else ("S1", "S2")
    text += ["*SURFACE, NAME=SLAVE, TYPE=ELEMENT"] + [f"{e}, {lower}" for e in block.at_bottom]
    text += ["*SURFACE, NAME=MASTER, TYPE=ELEMENT"] + [f"{e}, {upper}" for e in foundation.at_top]
    text += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{MODULUS}, 0.3"]
    for name in ("FOUNDATION", "BLOCK"):
        text += [f"*SOLID SECTION, ELSET={name}, MATERIAL=STEEL"] + (["1."] if plane else [])
    slope = stiffness * MODULUS / BLOCK[2]
    text += ["*SURFACE INTERACTION, NAME=SLIDING"]
    text += ["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{slope!r}, {1e-6 * MODULUS!r}"]
    text += ["*FRICTION", f"{mu}, {STICK * slope!r}"]
    text += ["*CONTACT PAIR, INTERACTION=SLIDING, TYPE=NODE TO SURFACE", "SLAVE, MASTER"]
    down, others = (2, [1]) if plane else (3, [1, 2])
    text += ["*BOUNDARY", f"FIXED, 1, {down}"]
    for increments, motion in (
        (2, [(dof, 0.0) for dof in others] + [(down, -DOWN)]),
        (4, [(1, ALONG)] + [(dof, 0.0) for dof in others[1:]] + [(down, -DOWN)]),
    ):
        text += ["*STEP, NLGEOM, INC=100", "*STATIC, DIRECT", f"{1.0 / increments!r}, 1."]
        text += ["*BOUNDARY"] + [f"MOVED, {dof}, {dof}, {value}" for dof, value in motion]
        text += ["*NODE FILE, FREQUENCY=100", "U", "*EL FILE, FREQUENCY=100", "S"]
        text += ["*NODE PRINT, NSET=MOVED, FREQUENCY=100", "RF"]
        text += ["*NODE PRINT, NSET=PROBE, FREQUENCY=100", "U", "*END STEP"]
    return "\n".join(text) + "\n"


def force(table):
    return [sum(column) for column in zip(*table["forces"].values())]


def compare(kind, size, arguments, folder):
    """One line of the table; whether both programs agree."""
    wanted = (SIZES if kind in PLANE else SPACE_SIZES)[size]
    element = size_for(kind, wanted)
    (folder / "job.inp").write_text(deck(kind, element, STIFF * arguments.stiffness, arguments.mu))
    found = beside(kind, dofs_of(kind, element), arguments, folder)
    if arguments.forces:
        for name, last in zip(("ccx", "slideline"), found):
            print(f"#   {name}: " + ", ".join(f"{value:.6g}" for value in force(last)), flush=True)
    return off(*found) <= AGREES


def main():
    parser = options(__doc__, ["5k", "20k", "79k"])
    parser.add_argument("--stiffness", type=float, default=1.0, help="of contact, times the usual one")
    parser.add_argument("--mu", type=float, default=0.2, help="coefficient of friction")
    parser.add_argument("--forces", action="store_true", help="print the forces on the block")
    arguments = parser.parse_args()
    if arguments.short:
        arguments.pairs = 1
    space = [kind for kind in KINDS if kind not in PLANE]
    return table(cases_of(arguments, KINDS, (space, "79k")), arguments, compare)


if __name__ == "__main__":
    sys.exit(main())
