"""Blocks and strips of solids: processor time and memory beside CalculiX.

    python3 benches/calculix/solids.py --short     5,000 dofs, one pair of runs each
    python3 benches/calculix/solids.py             5,000 and 20,000 dofs, three pairs
    python3 benches/calculix/solids.py --full      80,000 dofs too (CalculiX takes its time)
    python3 benches/calculix/solids.py --large     250,000 dofs in space, slideline alone, two threads
    python3 benches/calculix/solids.py --only C3D8,CPS4 --keep DIR

Needs the program `ccx` (Debian: apt-get install calculix-ccx), or --ccx PATH.  It is
run as it is and is no part of this project.

          moves sideways and down                  fixed          moves down
            o--o--o--o                               |o--o--o--o--o--o--o|
           /  /  /  /|   cube of bricks              |o--o--o--o--o--o--o|   strip,
          o--o--o--o o   or of tetrahedra            |o--o--o--o--o--o--o|   four times as
          |  |  |  |/|                               |o--o--o--o--o--o--o|   long as high
          o--o--o--o o
            fixed

Large displacements, linear elastic, three increments.  Runs of both programs take
turns; the ratio is that of the processor times, user and system, of one thread, files
written.  Both solved the same problem if the force on the side that moves and the
displacements of some nodes inside agree: the column `off %`, of the largest value.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from published import tables

SIZES = {"5k": 5_000, "20k": 20_000, "80k": 80_000, "250k": 250_000}
SPACE = ["C3D8", "C3D8I", "C3D20R", "C3D10"]
PLANE = ["CPS4", "CPS8"]
LONG = 4  # length of a strip over its height
AGREES = 2.0  # per cent: the elements of one name are not quite the same in both programs

# Where the nodes of an element stand in the two cells of the fine grid that it covers.
CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
# Six tetrahedra of a brick about its diagonal 0-6, and the edges of one.
TETRAHEDRA = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
TETRAHEDRON_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]


def middle(a, b):
    return tuple((p + q) // 2 for p, q in zip(a, b))


def elements_of(kind, cell):
    """Places of the nodes of the elements that fill a cell of the coarse grid."""
    corners = [tuple(2 * c + o for c, o in zip(cell, offset)) for offset in CORNERS]
    if kind == "C3D10":
        for tetrahedron in TETRAHEDRA:
            own = [corners[k] for k in tetrahedron]
            yield own + [middle(own[a], own[b]) for a, b in TETRAHEDRON_EDGES]
    elif kind in PLANE:
        yield corners[:4] + ([middle(corners[a], corners[b]) for a, b in EDGES[:4]] if kind == "CPS8" else [])
    else:
        edges = [middle(corners[a], corners[b]) for a, b in EDGES] if kind == "C3D20R" else []
        yield corners + edges


def mesh(kind, cells):
    """Elements as lists of node numbers, and the places of the nodes by number."""
    numbers, elements = {}, []
    for i in range(cells[0]):
        for j in range(cells[1]):
            for k in range(cells[2]):
                for places in elements_of(kind, (i, j, k)):
                    elements.append([numbers.setdefault(place, len(numbers) + 1) for place in places])
    return elements, {number: place for place, number in numbers.items()}


def cells_for(kind, dofs):
    """Elements along each side that give about so many dofs."""

    def count(n):
        if kind in PLANE:
            a, b = LONG * n, n
            return 2 * ((a + 1) * (b + 1) + (a * (b + 1) + b * (a + 1) if kind == "CPS8" else 0))
        corners, edges = (n + 1) ** 3, 3 * n * (n + 1) ** 2
        inside = {"C3D20R": edges, "C3D10": edges + 3 * n * n * (n + 1) + n**3}
        return 3 * (corners + inside.get(kind, 0))

    n = min(range(1, 400), key=lambda n: abs(count(n) - dofs))
    return ((LONG * n, n, 1) if kind in PLANE else (n, n, n)), count(n)


def lines(numbers, per_line=10):
    numbers = [str(number) for number in numbers]
    return [", ".join(numbers[k : k + per_line]) for k in range(0, len(numbers), per_line)]


def deck(kind, cells, increments):
    """The deck, which both programs read."""
    elements, places = mesh(kind, cells)
    plane = kind in PLANE
    length = 2.0 * cells[1] / 10.0  # a side of ten
    text = ["*HEADING", f"{kind}, {len(elements)} elements", "*NODE, NSET=ALL"]
    for number, place in places.items():
        coordinates = [repr(p / length) for p in place[: 2 if plane else 3]]
        text.append(f"{number}, " + ", ".join(coordinates))
    text.append(f"*ELEMENT, TYPE={kind}, ELSET=BODY")
    for number, nodes in enumerate(elements, 1):
        text += [row + ("," if at else "") for at, row in zip(range(len(nodes) // 15, -1, -1), lines([number] + nodes, 16))]
    axis, last = (0, 2 * cells[0]) if plane else (2, 2 * cells[2])
    held = [number for number, place in places.items() if place[axis] == 0]
    moved = [number for number, place in places.items() if place[axis] == last]
    inside = [number for number, place in places.items() if 0 < place[axis] < last]
    inside = inside[:: max(1, len(inside) // 20)]
    for name, numbers in (("HELD", held), ("MOVED", moved), ("PROBE", inside)):
        text += [f"*NSET, NSET={name}"] + lines(numbers)
    text += ["*MATERIAL, NAME=STEEL", "*ELASTIC", "2.1E5, 0.3"]
    text += ["*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL"] + (["1."] if plane else [])
    motion = [(1, 0.0), (2, -8.0)] if plane else [(1, 0.5), (2, 0.0), (3, -0.8)]
    text += ["*BOUNDARY", f"HELD, 1, {2 if plane else 3}"]
    text += ["*STEP, NLGEOM, INC=100", "*STATIC, DIRECT", f"{1.0 / increments!r}, 1."]
    text += ["*BOUNDARY"] + [f"MOVED, {dof}, {dof}, {value}" for dof, value in motion]
    text += ["*NODE FILE, FREQUENCY=100", "U", "*EL FILE, FREQUENCY=100", "S"]
    text += ["*NODE PRINT, NSET=MOVED, FREQUENCY=100", "RF"]
    text += ["*NODE PRINT, NSET=PROBE, FREQUENCY=100", "U", "*END STEP"]
    return "\n".join(text) + "\n"


def timed(command, folder, log):
    """Processor time, wall time [s] and largest memory [MB] of a run."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_RESULTS="1", CCX_NPROC_STIFFNESS="1")
    begin = time.monotonic()
    with open(log, "w") as out:
        child = subprocess.Popen(command, cwd=folder, stdout=out, stderr=out, env=environment)
        _, status, used = os.wait4(child.pid, 0)
    child.returncode = status
    if status != 0:
        sys.exit(f"error: {' '.join(map(str, command))} failed; see {log}")
    return used.ru_utime + used.ru_stime, time.monotonic() - begin, used.ru_maxrss / 1024.0


def iterations(sta):
    """Number of iterations that a `.sta` tells: the column of each attempt's own."""
    rows = [row.split() for row in open(sta, errors="replace")]
    rows = [row for row in rows if len(row) > 5 and row[0].isdigit()]
    ours = [row for row in rows if len(row) > 7]  # severe, equilibrium, all
    return sum(int(row[5]) for row in ours) if ours else sum(int(row[3]) for row in rows)


def off(theirs, ours):
    """Largest difference of force and displacements, % of the largest value."""
    worst = 0.0
    for name in ("forces", "displacements"):
        if name == "forces":
            total = [[sum(column) for column in zip(*table[name].values())] for table in (theirs, ours)]
            pairs = list(zip(*total))
        else:
            pairs = [p for node, row in theirs[name].items() for p in zip(row, ours[name][node])]
        largest = max(abs(a) for a, _ in pairs)
        worst = max(worst, max(abs(a - b) for a, b in pairs) / largest)
    return 100.0 * worst


def beside(kind, dofs, arguments, folder):
    """Runs the deck of a folder in both programs in turns and prints its line of the table; the
    last tables of CalculiX and of Slideline."""
    own = folder / "own"
    ours = [os.path.abspath(arguments.program), "run", "job.inp", "--dialect", "calculix", "--no-html", "--quiet"]
    ours += ["--threads", "1", "--out", str(own)]
    pairs = []
    for _ in range(arguments.pairs):
        theirs = timed([arguments.ccx, "job"], folder, folder / "ccx.log")
        pairs.append((timed(ours, folder, folder / "slideline.log"), theirs))
    found = tables(str(folder / "job.dat")), tables(str(own / "job.dat"))
    middle_of = lambda values: statistics.median(list(values))
    own_time, their_time = middle_of(p[0][0] for p in pairs), middle_of(p[1][0] for p in pairs)
    own_memory, their_memory = middle_of(p[0][2] for p in pairs), middle_of(p[1][2] for p in pairs)
    counts = f"{iterations(own / 'job.sta')}/{iterations(folder / 'job.sta')}"
    ratio = middle_of(theirs[0] / own[0] for own, theirs in pairs)
    print(
        f"{kind},{dofs},{counts},{own_time:.2f},{their_time:.2f},{ratio:.1f},"
        f"{own_memory:.0f},{their_memory:.0f},{their_memory / own_memory:.1f},{off(*found):.2f}",
        flush=True,
    )
    return found


def compare(kind, size, arguments, folder):
    """One line of the table; whether both programs agree."""
    cells, dofs = cells_for(kind, SIZES[size])
    (folder / "job.inp").write_text(deck(kind, cells, arguments.increments))
    return off(*beside(kind, dofs, arguments, folder)) <= AGREES


def table(cases, arguments, compare):
    """All lines; the exit code."""
    same = True
    with tempfile.TemporaryDirectory() as temporary:
        base = arguments.keep or Path(temporary)
        print("element,dofs,iterations ours/ccx,CPU s,ccx CPU s,ratio,MB,ccx MB,ratio,off %")
        for size, kind in cases:
            folder = base / f"{kind}_{size}"
            folder.mkdir(parents=True, exist_ok=True)
            same &= compare(kind, size, arguments, folder)
    if not same:
        print(f"error: results differ by more than {AGREES} %", file=sys.stderr)
    return 0 if same else 1


def options(description, sizes):
    """The options that comparisons share; `sizes`: what --full adds."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("--ccx", default="ccx", help="the program to compare with")
    parser.add_argument("--program", default="target/release/slideline")
    parser.add_argument("--short", action="store_true", help="5,000 dofs, one pair")
    parser.add_argument("--full", action="store_true", help=f"{sizes[-1]} too")
    parser.add_argument("--only", help="elements, separated by commas")
    parser.add_argument("--sizes", help=f"{', '.join(sizes)}, separated by commas")
    parser.add_argument("--pairs", type=int, default=3, help="pairs of runs")
    parser.add_argument("--keep", type=Path, help="folder for decks and results")
    return parser


def cases_of(arguments, kinds, large):
    """Sizes and elements that are asked for; `large`: the elements and the size that --full adds."""
    kinds = arguments.only.split(",") if arguments.only else kinds
    if arguments.sizes:
        return [(size, kind) for size in arguments.sizes.split(",") for kind in kinds]
    cases = [("5k", kind) for kind in kinds]
    if not arguments.short:
        cases += [("20k", kind) for kind in kinds]
    if arguments.full:
        cases += [(large[1], kind) for kind in kinds if kind in large[0]]
    return cases


def large(arguments, folder):
    """A block of 250,000 dofs, slideline alone."""
    kind = "C3D8"
    cells, dofs = cells_for(kind, SIZES["250k"])
    (folder / "job.inp").write_text(deck(kind, cells, arguments.increments))
    own = folder / "own"
    command = [os.path.abspath(arguments.program), "run", "job.inp", "--dialect", "calculix", "--no-html", "--quiet"]
    command += ["--threads", "2", "--out", str(own)]
    spent, wall, memory = timed(command, folder, folder / "slideline.log")
    count = iterations(own / "job.sta")
    print("element,dofs,iterations,wall s,CPU s,wall s of ten iterations,MB")
    print(f"{kind},{dofs},{count},{wall:.1f},{spent:.1f},{10.0 * wall / count:.1f},{memory:.0f}")


def main():
    parser = options(__doc__, ["5k", "20k", "80k"])
    parser.add_argument("--large", action="store_true", help="250,000 dofs, slideline alone")
    parser.add_argument("--increments", type=int, default=3)
    arguments = parser.parse_args()
    if arguments.large:
        with tempfile.TemporaryDirectory() as temporary:
            folder = (arguments.keep or Path(temporary)) / "large"
            folder.mkdir(parents=True, exist_ok=True)
            large(arguments, folder)
        return 0
    if arguments.short:
        arguments.pairs = 1
    return table(cases_of(arguments, PLANE + SPACE, (PLANE + SPACE, "80k")), arguments, compare)


if __name__ == "__main__":
    sys.exit(main())
