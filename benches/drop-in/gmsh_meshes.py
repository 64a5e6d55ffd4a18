#!/usr/bin/env python3
"""Writes the meshes of crates/mesh/tests/meshes with gmsh (PyPI: gmsh 4.15), of every shape that is
read and in every format: a plate of 4 x 2 and a block of 4 x 1 x 1 with the groups part, held (x = 0)
and pulled (x = 4), and a line with the groups arm, root and tip.

Usage: benches/drop-in/gmsh_meshes.py FOLDER
"""

import sys
from pathlib import Path

import gmsh

FORMATS = {"22.msh": 2.2, "41.msh": 4.1, ".inp": None}


def write(folder, name, formats):
    for ending in formats:
        version = FORMATS[ending]
        if version:
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
        path = folder / f"{name}{ending}"
        gmsh.write(str(path))
        # gmsh names its folder in the heading
        text = path.read_text().replace(f"{folder}/", "")
        path.write_text(text)


def options(order, size, complete=False):
    gmsh.clear()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.ElementOrder", order)
    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 0 if complete else 1)
    gmsh.option.setNumber("Mesh.MeshSizeMin", size)
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)


def plate(order, quadrilaterals, complete=False):
    options(order, 1.5, complete)
    gmsh.model.occ.addRectangle(0, 0, 0, 4, 2)
    gmsh.model.occ.synchronize()
    gmsh.model.addPhysicalGroup(2, [1], name="part")
    gmsh.model.addPhysicalGroup(1, [4], name="held")
    gmsh.model.addPhysicalGroup(1, [2], name="pulled end")
    if quadrilaterals:
        gmsh.model.mesh.setRecombine(2, 1)
    gmsh.model.mesh.generate(2)


def block(order, shape, complete=False):
    options(order, 1.0, complete)
    base = gmsh.model.occ.addRectangle(0, 0, 0, 4, 1)
    recombine = shape == "hex"
    if shape == "tet":
        gmsh.model.occ.remove([(2, base)], recursive=True)
        gmsh.model.occ.addBox(0, 0, 0, 4, 1, 1)
    else:
        gmsh.model.occ.extrude([(2, base)], 0, 0, 1, numElements=[1], recombine=True)
    gmsh.model.occ.synchronize()
    faces = gmsh.model.getEntities(2)

    def at(x):
        middles = [(tag, gmsh.model.occ.getCenterOfMass(2, tag)) for _, tag in faces]
        return [tag for tag, middle in middles if abs(middle[0] - x) < 1e-6]

    gmsh.model.addPhysicalGroup(3, [tag for _, tag in gmsh.model.getEntities(3)], name="part")
    gmsh.model.addPhysicalGroup(2, at(0.0), name="held")
    gmsh.model.addPhysicalGroup(2, at(4.0), name="pulled end")
    if recombine:
        gmsh.model.mesh.setRecombine(2, base)
    gmsh.model.mesh.generate(3)


def line(order):
    options(order, 1.0)
    ends = [gmsh.model.occ.addPoint(x, 0, 0) for x in (0.0, 4.0)]
    gmsh.model.occ.addLine(*ends)
    gmsh.model.occ.synchronize()
    gmsh.model.addPhysicalGroup(1, [1], name="arm")
    gmsh.model.addPhysicalGroup(0, [ends[0]], name="root")
    gmsh.model.addPhysicalGroup(0, [ends[1]], name="tip")
    gmsh.model.mesh.generate(1)


def main():
    folder = Path(sys.argv[1]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    gmsh.initialize()
    for order in (1, 2):
        formats = list(FORMATS) if order == 2 else ["41.msh"]
        plate(order, False)
        write(folder, f"tri{3 * order}_", formats)
        plate(order, True)
        write(folder, f"quad{4 * order}_", formats)
        for shape, nodes in (("tet", (4, 10)), ("wedge", (6, 15)), ("hex", (8, 20))):
            block(order, shape)
            write(folder, f"{shape}{nodes[order - 1]}_", formats)
        line(order)
        write(folder, f"line{order + 1}_", list(FORMATS))
    # the second order as gmsh makes it of itself: nodes in the middle of faces and volumes, too
    plate(2, True, True)
    write(folder, "quad9_", ["41.msh", ".inp"])
    block(2, "hex", True)
    write(folder, "hex27_", ["41.msh", ".inp"])
    # in .inp gmsh calls wedges of 18 nodes C3D6
    block(2, "wedge", True)
    write(folder, "wedge18_", ["41.msh", ".inp"])
    gmsh.finalize()


main()
