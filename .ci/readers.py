"""Reads states with VTK and meshio and compares them with the CSV files.

Requirement: both readers open every state that JOB.pvd lists; times, motions,
rotations, reactions, pressure, gap, shear and slip are those of
JOB.history.csv and JOB.contact.csv, section forces and stresses those of
JOB.element.csv. Tolerance: none; both hold the same double. A .frd file holds
six digits of the same; its stresses are means over the beams of a node, its
outlines of rigid surfaces move with their bodies.
"""

import csv
import math
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import meshio
import numpy
import vtk
from ccx2paraview.common import FRD
from solid_cells import check_solids
from vtk.util.numpy_support import vtk_to_numpy

ROOT = Path(__file__).resolve().parent.parent
DECKS = [
    "corpus/diehl1995/isl_coarse_mu03.inp",
    "corpus/diehl1995/irs_coarse_mu03.inp",
    "corpus/diehl1995/cam_isl_mu03.inp",
    "corpus/diehl1995/surface_coarse_mu03.inp",
    "corpus/diehl1995/isl_coarse_push_pull_mu03.inp",
    "corpus/keywords/element_b22.inp",
    "corpus/keywords/EL-FILE.inp",
]
FRD_DECKS = [
    "corpus/keywords/NODE-FILE.inp",
    "corpus/keywords/CONTACT-FILE.inp",
    "corpus/keywords/element_b22.inp",
    "corpus/diehl1995/isl_coarse_mu03.inp",
    "corpus/diehl1995/irs_coarse_mu03.inp",
    "corpus/diehl1995/isl_coarse_push_pull_mu03.inp",
]
SECTIONS = {
    "axial_force": "SF1",
    "shear_force": "SF2",
    "bending_moment": "SM1",
    "S11_1": "S11_1",
    "S11_5": "S11_5",
    "mises": "MISES",
    "fibre_strain": None,
}
STATUS = {"open": 0, "stick": 1, "slip": 2}


def rows(path):
    """Rows of a CSV file by time, as the program wrote it."""
    found = {}
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            found.setdefault(float(row["time"]), []).append(row)
    return found


def read_vtk(path):
    """Points, point data, cell data and cells as VTK shows them."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    complaints = []
    reader.AddObserver("ErrorEvent", lambda *_: complaints.append("error"))
    reader.AddObserver("WarningEvent", lambda *_: complaints.append("warning"))
    reader.SetFileName(str(path))
    reader.Update()
    assert not complaints, f"VTK complains about {path}"
    grid = reader.GetOutput()
    assert grid.GetNumberOfPoints() > 0, f"VTK reads no points from {path}"

    def arrays(data):
        names = [data.GetArrayName(k) for k in range(data.GetNumberOfArrays())]
        return {name: vtk_to_numpy(data.GetArray(name)) for name in names}

    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 2)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    return points, arrays(grid.GetPointData()), arrays(grid.GetCellData()), cells


def read_meshio(path):
    """The same as meshio shows it."""
    mesh = meshio.read(path)
    assert [block.type for block in mesh.cells] == ["line"], f"{path}: cells are not one block of lines"
    cell_data = {name: blocks[0] for name, blocks in mesh.cell_data.items()}
    return mesh.points, mesh.point_data, cell_data, mesh.cells[0].data


def agree(path, first, second):
    """Both readers show the same file."""
    assert numpy.array_equal(first[0], second[0]), f"{path}: points differ"
    assert numpy.array_equal(first[3], second[3]), f"{path}: cells differ"
    for one, other in zip(first[1:3], second[1:3]):
        assert set(one) == set(other), f"{path}: arrays differ: {set(one) ^ set(other)}"
        for name in one:
            other_values = numpy.asarray(other[name]).reshape(one[name].shape)
            same = numpy.array_equal(one[name], other_values, equal_nan=one[name].dtype.kind == "f")
            assert same, f"{path}: {name} differs between VTK and meshio"


def same(what, shown, written):
    """One value of a state against the text of a CSV file."""
    value = float(written)
    equal = shown == value or (math.isinf(value) and math.isinf(shown))
    assert equal, f"{what}: the state shows {shown!r}, the table {written}"


def check_state(path, state, history, contact):
    points, nodal, cell, _ = state
    place = {}
    for index, label in enumerate(nodal["node"]):
        if label:
            place[int(label)] = index
    for row in history:
        at, label = place[int(row["node"])], row["node"]
        for axis, name in enumerate(["U1", "U2"]):
            same(f"{path} {label} {name}", nodal["displacement"][at][axis], row[name])
        for axis, name in enumerate(["RF1", "RF2"]):
            same(f"{path} {label} {name}", nodal["reaction_force"][at][axis], row[name])
        same(f"{path} {label} UR3", nodal["rotation"][at][2], row["UR3"])
        same(f"{path} {label} RM3", nodal["reaction_moment"][at][2], row["RM3"])
    of_node = {}
    for row in contact:
        of_node.setdefault(int(row["node"]), []).append(row)
    for label, own in of_node.items():
        if len(own) > 1:
            continue  # a node of several pairs shows one of them
        row, at = own[0], place[label]
        columns = [
            ("contact_pressure", "CPRESS"),
            ("contact_opening", "COPEN"),
            ("contact_shear", "CSHEAR1"),
            ("contact_slip", "CSLIP1"),
        ]
        for name, column in columns:
            same(f"{path} {label} {column}", nodal[name][at], row[column])
        assert nodal["contact_status"][at] == STATUS[row["status"]], f"{path} {label} status"
    beams = cell["kind"] == 0
    for name in SECTIONS:
        assert name in cell and numpy.isfinite(cell[name]).all(), f"{path}: {name}"
        assert (cell[name][~beams] == 0.0).all(), f"{path}: {name} away from beams"
    return sum(1 for label in of_node if nodal["contact_pressure"][place[label]] > 0.0)


def check_sections(path, cell, elements):
    """Section forces and stresses are those of JOB.element.csv."""
    for row in elements:
        for at in numpy.flatnonzero((cell["element"] == int(row["element"])) & (cell["kind"] == 0)):
            for name, column in SECTIONS.items():
                if column:
                    same(f"{path} element {row['element']} {name}", cell[name][at], row[column])
    return len(elements)


def check_job(program, deck, folder):
    command = [program, "run", str(ROOT / deck), "--out", str(folder), "--quiet", "--no-html"]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    job = folder / Path(deck).stem
    history, contact = rows(f"{job}.history.csv"), rows(f"{job}.contact.csv")
    listed = [
        (float(entry.get("timestep")), folder / entry.get("file"))
        for entry in xml.parse(f"{job}.pvd").getroot().iter("DataSet")
    ]
    times = [time for time, _ in listed]
    assert times[0] == 0.0 and times[1:] == list(history), f"{deck}: times of the list are {times}"
    pressed, sections, bent = 0, 0, 0.0
    elements = rows(f"{job}.element.csv") if Path(f"{job}.element.csv").exists() else {}
    for time, path in listed:
        shown = read_vtk(path)
        agree(path, shown, read_meshio(path))
        if time in history:
            sections += check_sections(path, shown[2], elements.get(time, []))
            pressed += check_state(path, shown, history[time], contact.get(time, []))
        bent = max(bent, numpy.abs(shown[2]["bending_moment"]).max())
    assert bent > 0.0, f"{deck}: no beam is bent"
    assert pressed > 0 or not contact, f"{deck}: no pressure was compared"
    assert ("EL-FILE" in deck) == bool(sections), f"{deck}: section forces were compared"
    print(f"{Path(deck).stem}: {len(listed)} states, {pressed} pressed points")


def check_failed(program, deck, folder):
    """Where a run gave up: the state opens and shows what is not balanced."""
    command = [program, "run", str(ROOT / deck), "--out", str(folder), "--quiet", "--no-html"]
    ended = subprocess.run(command, stderr=subprocess.DEVNULL)
    assert ended.returncode == 2, f"{deck} ends with {ended.returncode}"
    path = folder / f"{Path(deck).stem}.failed.vtu"
    shown = read_vtk(path)
    agree(path, shown, read_meshio(path))
    nodal = shown[1]
    residual = numpy.linalg.norm(nodal["residual_force"], axis=1)
    assert numpy.isfinite(residual).all() and residual.max() > 0.0, f"{deck}: no residual"
    assert "residual_moment" in nodal and "contact_pressure" in nodal
    listed = (folder / f"{Path(deck).stem}.pvd").read_text(encoding="utf-8")
    assert "failed" not in listed, f"{deck}: the list names what is no result"
    print(f"{path.name}: largest residual force {residual.max():.3e}")


def near(what, shown, written):
    """Six digits stand in a .frd file."""
    value = float(written)
    assert abs(shown - value) <= 6e-6 * abs(value) + 1e-99, f"{what}: {shown} against {written}"


def beams_at_nodes(job):
    """Which beams meet at a node, taken from the first state."""
    _, nodal, cell, cells = read_meshio(f"{job}_0000.vtu")
    found = {}
    for ends, element, kind in zip(cells, cell["element"], cell["kind"]):
        for end in ends if kind == 0 else []:
            found.setdefault(int(nodal["node"][end]), set()).add(str(element))
    return found


def mean(values):
    return sum(values) / len(values)


def check_nodal_stresses(what, blocks, elements, meeting):
    """Means over the beams of a node; the tensor is a pull of that size. A
    mean of numbers of both signs keeps fewer digits than its parts."""
    of = {row["element"]: row for row in elements}
    for node, labels in meeting.items():
        labels = [label for label in labels if label in of]
        if not labels:
            continue  # beams that only draw a rigid body have no results
        points = []
        for place in range(5):
            parts = [float(of[label][f"S11_{place + 1}"]) for label in labels]
            shown = blocks["S11"].results[node][place]
            slack = 6e-6 * max(abs(part) for part in parts) + 1e-99
            assert abs(shown - mean(parts)) <= slack, f"{what} node {node} S11_{place + 1}"
            points.append(shown)
        for place, column in enumerate(["SF1", "SF2", "SM1"]):
            parts = [float(of[label][column]) for label in labels]
            slack = 6e-6 * max(abs(part) for part in parts) + 1e-99
            shown = blocks["SECTION"].results[node][place]
            assert abs(shown - mean(parts)) <= slack, f"{what} node {node} {column}"
        outer = max(abs(points[0]), abs(points[4]))
        stress, mises = blocks["S"].results[node], blocks["S_Mises"].results[node][0]
        # in pure bending both fibres are the outer one
        misfit = min(abs(sum(stress[:3]) - points[0]), abs(sum(stress[:3]) - points[4]))
        assert misfit <= 3e-5 * outer, f"{what} node {node}: trace"
        assert abs(mises - outer) <= 3e-5 * outer, f"{what} node {node}: Mises"
    return len(meeting)


def check_outlines(what, frd, blocks, known):
    """Points of rigid surfaces are numbered behind the deck's nodes; they keep
    their distance from the node that carries them, and some of them move."""
    numbers = list(frd.node_block.get_node_numbers())
    places = [frd.node_block.points.GetPoint(k) for k in range(len(numbers))]
    place = {number: numpy.array(at) for number, at in zip(numbers, places)}
    moved = {number: place[number] + numpy.array(blocks["U"].results[number]) for number in numbers}
    outline = [number for number in numbers if number not in known]
    if not outline:
        return 0.0
    assert min(outline) == max(known) + 1, f"{what}: numbers of the outline"
    # the centre of the circle carries it: all points are equally far from it
    def spread(node, of):
        distances = [numpy.linalg.norm(of[point] - of[node]) for point in outline]
        return max(distances) - min(distances)
    size = max(numpy.linalg.norm(place[a] - place[b]) for a in outline for b in outline[:1])
    carrier = min(known, key=lambda node: spread(node, place))
    assert spread(carrier, place) < 2e-5 * size, f"{what}: no node carries the outline"
    assert spread(carrier, moved) < 2e-4 * size, f"{what}: the outline is left behind"
    return max(numpy.linalg.norm(moved[point] - place[point]) for point in outline)


def check_frd(program, deck, folder):
    job = folder / f"{Path(deck).stem}_frd"
    text = (ROOT / deck).read_text(encoding="utf-8")
    text = text.replace("*END STEP", "*EL FILE\nS\n*END STEP", 1)
    Path(f"{job}.inp").write_text(text, encoding="utf-8")
    command = [program, "run", f"{job}.inp", "--quiet", "--no-html"]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    history, contact = rows(f"{job}.history.csv"), rows(f"{job}.contact.csv")
    elements, meeting = rows(f"{job}.element.csv"), beams_at_nodes(job)
    known = {int(label) for label in read_meshio(f"{job}_0000.vtu")[1]["node"] if label}
    rigid = "RIGID SURFACE" in text
    compared, stressed, travel = 0, 0, 0.0
    with open(f"{job}.frd", encoding="ascii") as file:
        frd = FRD(file)
        frd.parse_mesh()
        frd.count_increments()
        assert len(frd.steps_increments) == len(history), f"{deck}: {frd.steps_increments}"
        for (step, shown), time in zip(frd.steps_increments, history):
            near(f"{deck} time", shown, time)
            blocks = {block.name: block for block in frd.parse_results(step, shown)}
            what = f"{deck} at {time}"
            stressed += check_nodal_stresses(what, blocks, elements[time], meeting)
            travel = max(travel, check_outlines(what, frd, blocks, known))
            for row in history[time]:
                for name, columns in {"U": ["U1", "U2"], "RF": ["RF1", "RF2"]}.items():
                    values = blocks[name].results[int(row["node"])]
                    for value, column in zip(values, columns):
                        near(f"{deck} {row['node']} {column}", value, row[column])
                        compared += 1
            for row in contact.get(time, []):
                if math.isfinite(float(row["COPEN"])):
                    values = blocks["CONTACT"].results[int(row["node"])]
                    for place, column in [(0, "COPEN"), (1, "CSLIP1"), (3, "CPRESS"), (4, "CSHEAR1")]:
                        near(f"{deck} {row['node']} {column}", values[place], row[column])
                        compared += 1
    assert compared > 0 and (contact or "keywords" in deck), f"{deck}: nothing was compared"
    assert stressed > 0 and (travel > 0.0) == rigid, f"{deck}: {stressed} stresses, outline {travel}"
    print(f"{Path(deck).stem}.frd: {compared} values, {stressed} nodes with stresses, outline moved {travel:.3g}")


def check_thinned(program, folder):
    """With FREQUENCY=6 the readers find the start, increments 6, 12, 18 and
    the last one, each with the values of its increment."""
    job = folder / "thinned"
    text = (ROOT / "corpus/diehl1995/isl_coarse_mu03.inp").read_text(encoding="utf-8")
    asked = "*OUTPUT, FIELD, FREQUENCY=6\n*NODE OUTPUT\nU\n*END STEP"
    Path(f"{job}.inp").write_text(text.replace("*END STEP", asked), encoding="utf-8")
    command = [program, "run", f"{job}.inp", "--quiet", "--no-html"]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    history, contact = rows(f"{job}.history.csv"), rows(f"{job}.contact.csv")
    times = [0.0] + list(history)
    expected = [(times[number], f"thinned_{number:04}.vtu") for number in (0, 6, 12, 18, 20)]
    listed = [
        (float(entry.get("timestep")), entry.get("file"))
        for entry in xml.parse(f"{job}.pvd").getroot().iter("DataSet")
    ]
    assert listed == expected, f"thinned: {listed}"
    for time, name in listed[1:]:
        check_state(name, read_vtk(folder / name), history[time], contact[time])
    with open(f"{job}.frd", encoding="ascii") as file:
        frd = FRD(file)
        frd.parse_mesh()
        frd.count_increments()
        shown = [time for _, time in frd.steps_increments]
    assert len(shown) == 4, f"thinned: .frd shows {shown}"
    for value, (time, _) in zip(shown, expected[1:]):
        near("thinned time", value, time)
    print(f"thinned: {len(listed)} of {len(times)} states")


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    print(f"VTK {vtk.vtkVersion.GetVTKVersion()}, meshio {meshio.__version__}")
    for deck in DECKS:
        check_job(program, deck, folder)
    check_failed(program, "corpus/bad/SL0511-toggle.inp", folder)
    for deck in FRD_DECKS:
        check_frd(program, deck, folder)
    check_thinned(program, folder)
    check_solids(program, folder)


main()
