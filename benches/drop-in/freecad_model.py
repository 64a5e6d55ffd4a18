"""A cantilever built with FreeCAD's own interface, solved by the given solver, read back by
FreeCAD's own reader. Run inside FreeCAD: freecad.sh does it, without a screen.

Arguments are environment variables, because FreeCAD takes those of the command line for files:
FOLDER (its work folder) and KIND (solid, contact, tied). FreeCAD starts the first `ccx` of PATH.
The last line of standard output that begins with RESULT is what FreeCAD holds after reading.
"""

import os
import sys
import traceback

import FreeCAD
import Fem
import ObjectsFem
from femtools import ccxtools

LENGTH, HEIGHT, WIDTH = 100.0, 10.0, 10.0

# Between arm and block: FreeCAD finds the nodes of a face by their places.
GAP = 0.01


def block(document, name, corner, size):
    box = document.addObject("Part::Box", name)
    box.Length, box.Width, box.Height = size
    box.Placement.Base = FreeCAD.Vector(*corner)
    return box


def bricks(mesh, corner, size, counts, first_node, first_element):
    """Bricks of eight nodes in a box; the numbers behind the last ones."""
    columns, rows, layers = (count + 1 for count in counts)
    number = {}
    node = first_node
    for layer in range(layers):
        for row in range(rows):
            for column in range(columns):
                place = [
                    corner[axis] + size[axis] * step / counts[axis]
                    for axis, step in enumerate((column, row, layer))
                ]
                mesh.addNode(*place, node)
                number[column, row, layer] = node
                node += 1
    element = first_element
    for layer in range(counts[2]):
        for row in range(counts[1]):
            for column in range(counts[0]):
                ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
                nodes = [
                    number[column + x, row + y, layer + z] for z in (0, 1) for x, y in ring
                ]
                # FreeCAD numbers the ring the other way round (SMESH)
                order = [0, 3, 2, 1, 4, 7, 6, 5]
                mesh.addVolume([nodes[place] for place in order], element)
                element += 1
    return node, element


def steel(document, analysis):
    material = ObjectsFem.makeMaterialSolid(document, "Steel")
    material.Material = {
        "Name": "Steel",
        "YoungsModulus": "210000 MPa",
        "PoissonRatio": "0.30",
        "Density": "7900 kg/m^3",
        "ThermalExpansionCoefficient": "0.012 mm/m/K",
    }
    analysis.addObject(material)


def model(kind):
    document = FreeCAD.newDocument("cantilever")
    arm = block(document, "Arm", (0, 0, 0), (LENGTH, WIDTH, HEIGHT))
    mesh = Fem.FemMesh()
    node, element = bricks(mesh, (0, 0, 0), (LENGTH, WIDTH, HEIGHT), (20, 2, 2), 1, 1)
    parts = [arm]
    if kind in ("contact", "tied"):
        # a block that lies on the end of the arm and is pressed down
        corner, size = (80.0, 2.0, HEIGHT + GAP), (15.0, 6.0, 5.0)
        parts.append(block(document, "Block", corner, size))
        bricks(mesh, corner, size, (3, 2, 1), node, element)
    both = document.addObject("Part::Compound", "Parts")
    both.Links = parts
    document.recompute()
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    solver = ObjectsFem.makeSolverCalculixCcxTools(document, "Solver")
    solver.AnalysisType = "static"
    solver.GeometricalNonlinearity = "nonlinear"
    solver.IterationsUserDefinedTimeStepLength = True
    solver.TimeInitialStep = 0.25
    solver.TimeEnd = 1.0
    analysis.addObject(solver)
    steel(document, analysis)
    faces = faces_by_place(both)
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(both, faces(lambda c: abs(c.x) < 1e-6))]
    analysis.addObject(fixed)
    if kind == "solid":
        force = ObjectsFem.makeConstraintForce(document, "Force")
        force.References = [(both, faces(lambda c: abs(c.x - LENGTH) < 1e-6))]
        force.Force = 1000.0
        force.Direction = (both, [upright_edge(both)])
        force.Reversed = False
        analysis.addObject(force)
    else:
        top = faces(lambda c: abs(c.z - HEIGHT - GAP - 5.0) < 1e-6)
        down = ObjectsFem.makeConstraintDisplacement(document, "Down")
        down.References = [(both, top)]
        down.xFree = down.yFree = down.zFree = False
        down.xFix = down.yFix = True
        down.zDisplacement = -2.0
        analysis.addObject(down)
        lower = faces(lambda c: abs(c.z - HEIGHT) < 1e-6 and abs(c.x - LENGTH / 2) < 1e-6)
        upper = faces(lambda c: abs(c.z - HEIGHT - GAP) < 1e-6 and abs(c.x - 87.5) < 1e-6)
        if kind == "contact":
            touch = ObjectsFem.makeConstraintContact(document, "Contact")
            touch.Slope = 1.0e6
            touch.Friction = 0.1
        else:
            touch = ObjectsFem.makeConstraintTie(document, "Tie")
            touch.Tolerance = 0.1
        touch.References = [(both, upper), (both, lower)]
        analysis.addObject(touch)
    holder = document.addObject("Fem::FemMeshObject", "Mesh")
    holder.FemMesh = mesh
    if hasattr(holder, "Part"):
        holder.Part = both
    analysis.addObject(holder)
    document.recompute()
    return document, analysis, solver


def faces_by_place(shape):
    def find(is_meant):
        all_faces = enumerate(shape.Shape.Faces)
        names = [f"Face{n + 1}" for n, face in all_faces if is_meant(face.CenterOfMass)]
        assert len(names) == 1, names
        return names[0]

    return find


def upright_edge(shape):
    for place, edge in enumerate(shape.Shape.Edges):
        first, last = (vertex.Point for vertex in edge.Vertexes)
        if abs(first.x - last.x) + abs(first.y - last.y) < 1e-9:
            return f"Edge{place + 1}"
    raise AssertionError("no upright edge")


def solved(analysis, solver, folder):
    tools = ccxtools.FemToolsCcx(analysis, solver, test_mode=False)
    tools.update_objects()
    tools.setup_working_dir(folder)
    tools.setup_ccx()
    message = tools.check_prerequisites()
    assert not message, message
    tools.purge_results()
    tools.write_inp_file()
    assert tools.inp_file_name and os.path.exists(tools.inp_file_name), "no deck"
    print("VERSION", tools.get_ccx_version())
    code = tools.ccx_run()
    print("EXIT", code)
    tools.load_results()
    return tools


def main():
    kind, folder = (os.environ[name] for name in ("KIND", "FOLDER"))
    document, analysis, solver = model(kind)
    tools = solved(analysis, solver, folder)
    found = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemResultObject")]
    assert found, "FreeCAD has no result object"
    last = found[-1]
    print("STDERR", repr(tools.ccx_stderr))
    lowest = min(vector.z for vector in last.DisplacementVectors)
    highest = max(vector.z for vector in last.DisplacementVectors)
    print(
        "RESULT",
        len(found),
        len(last.NodeNumbers),
        f"{lowest:.6e}",
        f"{highest:.6e}",
        f"{max(last.vonMises):.6e}",
    )


try:
    main()
except BaseException:
    traceback.print_exc(file=sys.stdout)
    sys.stdout.flush()
    os._exit(1)
sys.stdout.flush()
os._exit(0)
