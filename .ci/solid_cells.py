"""States with every cell of solids, read by VTK and meshio.

Requirement: both readers open them; a cell has the type and the volume that it should, so that its
nodes stand in the order of the readers; stresses at nodes, means over elements and rows of
JOB.element.csv are those of one strain everywhere. Source: a single element whose nodes all move
with u = A x has the strain A; with nu = 0 and small strain the stress is E times that. Tolerance:
rounding.
"""

import csv
import subprocess

import meshio
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

E, STRAIN = 1000.0, numpy.array([0.01, -0.02, 0.005])
TRIANGLE = [(0, 0, 0), (2, 0, 0), (0, 3, 0)]
SQUARE = [(0, 0, 0), (2, 0, 0), (2, 3, 0), (0, 3, 0)]
TETRAHEDRON = TRIANGLE + [(0, 0, 4)]
WEDGE = TRIANGLE + [(x, y, 4) for x, y, _ in TRIANGLE]
BRICK = SQUARE + [(x, y, 4) for x, y, _ in SQUARE]
AROUND = lambda n: [(k, (k + 1) % n) for k in range(n)]
UPPER = lambda n: [(n + a, n + b) for a, b in AROUND(n)]
UPRIGHT = lambda n: [(k, n + k) for k in range(n)]
# type in decks: corners, edges with middle nodes in the deck's order, VTK type, meshio's name (none:
# meshio 5.3.5 stops at quadratic wedges, whose dimension it does not know), content
CELLS = {
    "CPS3": (TRIANGLE, [], 5, "triangle", 3.0),
    "CPS4": (SQUARE, [], 9, "quad", 6.0),
    "CPS6": (TRIANGLE, AROUND(3), 22, "triangle6", 3.0),
    "CPS8": (SQUARE, AROUND(4), 23, "quad8", 6.0),
    "C3D4": (TETRAHEDRON, [], 10, "tetra", 4.0),
    "C3D10": (TETRAHEDRON, AROUND(3) + [(0, 3), (1, 3), (2, 3)], 24, "tetra10", 4.0),
    "C3D6": (WEDGE, [], 13, "wedge", 12.0),
    "C3D15": (WEDGE, AROUND(3) + UPPER(3) + UPRIGHT(3), 26, None, 12.0),
    "C3D8": (BRICK, [], 12, "hexahedron", 24.0),
    "C3D20": (BRICK, AROUND(4) + UPPER(4) + UPRIGHT(4), 25, "hexahedron20", 24.0),
}


def deck(kind, nodes):
    """One element, each of its nodes driven."""
    axes = 3 if kind.startswith("C3D") else 2
    lines = ["*NODE"] + [f"{k + 1}, {x}, {y}, {z}" for k, (x, y, z) in enumerate(nodes)]
    labels = [str(k + 1) for k in range(len(nodes))]
    rows = [", ".join(["1"] + labels[:15])] + ([", ".join(labels[15:])] if labels[15:] else [])
    lines += [f"*ELEMENT, TYPE={kind}, ELSET=SOLID", ",\n".join(rows)]
    lines += ["*SOLID SECTION, ELSET=SOLID, MATERIAL=M", "1.0", "*MATERIAL, NAME=M", "*ELASTIC"]
    lines += [f"{E}, 0.0", "*STEP", "*STATIC", "1.0, 1.0", "*BOUNDARY"]
    for k, place in enumerate(nodes):
        for axis in range(axes):
            lines.append(f"{k + 1}, {axis + 1}, {axis + 1}, {float(STRAIN[axis] * place[axis])!r}")
    return "\n".join(lines + ["*EL FILE", "S, E", "*END STEP", ""])


def check_solid(program, kind, folder):
    corners, edges, shape, name, content = CELLS[kind]
    middles = [tuple((a + b) / 2 for a, b in zip(corners[i], corners[j])) for i, j in edges]
    job = folder / f"cell_{kind}"
    job.with_suffix(".inp").write_text(deck(kind, corners + middles), encoding="utf-8")
    command = [program, "run", f"{job}.inp", "--quiet", "--no-html"]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    axes = 3 if kind.startswith("C3D") else 2
    exact = numpy.zeros(6)
    exact[:axes] = E * STRAIN[:axes]

    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(f"{job}_0001.vtu")
    reader.Update()
    grid = reader.GetOutput()
    assert grid.GetNumberOfCells() == 1 and grid.GetCellType(0) == shape, f"{kind}: type"
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    size = sizes.GetOutput().GetCellData().GetArray("Volume" if axes == 3 else "Area").GetValue(0)
    grown = content * numpy.prod(1.0 + STRAIN[:axes])
    assert abs(size - grown) <= 1e-12 * grown, f"{kind}: {size} against {grown}"
    stress = vtk_to_numpy(grid.GetPointData().GetArray("stress"))
    assert numpy.abs(stress - exact).max() <= 1e-9 * E, f"{kind}: {stress}"

    check_rows(kind, job, exact)
    print(f"{kind}: VTK type {shape}, {name}")
    if name is None:
        return
    mesh = meshio.read(f"{job}_0001.vtu")
    assert [block.type for block in mesh.cells] == [name], f"{kind}: {mesh.cells}"
    assert numpy.array_equal(mesh.point_data["stress"], stress), f"{kind}: meshio's stress"
    # middle nodes stand half way between the corners that the readers take them to join
    cell = mesh.cells[0].data[0]
    known = numpy.array(corners + middles)[cell]
    moved = mesh.points[cell] - mesh.point_data["displacement"][cell]
    assert numpy.abs(moved - known).max() <= 1e-12, f"{kind}: points"
    assert abs(mesh.cell_data["S11"][0][0] - exact[0]) <= 1e-9 * E, f"{kind}: mean S11"


def check_rows(kind, job, exact):
    with open(f"{job}.element.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    names = ["S11", "S22", "S33", "S12", "S13", "S23"]
    for row in rows:
        for column, value in zip(names, exact):
            assert abs(float(row[column]) - value) <= 1e-9 * E, f"{kind}: {row}"
    assert [int(row["point"]) for row in rows] == list(range(1, len(rows) + 1)), f"{kind}: points"


def check_solids(program, folder):
    for kind in CELLS:
        check_solid(program, kind, folder)
