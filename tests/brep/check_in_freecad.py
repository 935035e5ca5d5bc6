# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks FreeCAD what its users ask of solids.

Usage:     FOLDER=solids freecadcmd tests/brep/check_in_freecad.py
Requires:  FreeCAD 0.20 (Debian 12: package freecad-python3).
Checks:    each STEP file of the folder is one valid closed solid that passes the check before Booleans
           (Part.Shape.check), has triangles on each face at four deflections, and falls into two parts whose
           volumes add up. Solids without splines have an offset of 0.1 mm.
Prints:    a line per fault, and the counts.
Exit code: 1 if a solid has a fault, or if there is no solid; 2 if FreeCAD fails.
"""
import os
import traceback

import FreeCAD
import Part

DEFLECTIONS = (0.1, 0.02, 0.01, 0.003)  # mm
OFFSET = 0.1  # mm


def faults_of(shape):
    """Yields the faults of a solid, as text."""
    if not shape.isValid() or not shape.isClosed() or len(shape.Solids) != 1:
        yield "not one valid closed solid"
    try:
        shape.check(True)
    except ValueError as error:
        yield "check before Booleans: " + "; ".join(str(error).split("\n")[:3])
    for deflection in DEFLECTIONS:
        bare = sum(1 for face in shape.Faces if not face.tessellate(deflection, True)[1])
        if bare:
            yield f"{bare} faces without triangles at {deflection} mm"
    yield from faults_of_halves(shape)
    if is_offset_possible(shape):
        yield from faults_of_offset(shape)


def is_offset_possible(shape):
    """False for splines, and for the tip of a cone on the solid. OpenCASCADE 7.6 has no offset of its own solids
    with a tip."""
    elementary = (Part.Plane, Part.Cylinder, Part.Cone, Part.Sphere, Part.Toroid)
    if not all(isinstance(face.Surface, elementary) for face in shape.Faces):
        return False
    if not all(isinstance(edge.Curve, (Part.Line, Part.Circle)) for edge in shape.Edges if not edge.Degenerated):
        return False
    return not any(isinstance(face.Surface, Part.Cone)
                   and any(vertex.Point.distanceToPoint(face.Surface.Apex) < 1e-6 for vertex in face.Vertexes)
                   for face in shape.Faces)


def faults_of_halves(shape):
    box = shape.BoundBox
    block = Part.makeBox(0.47 * box.XLength + 1, box.YLength + 2, box.ZLength + 2,
                         FreeCAD.Vector(box.XMin - 1, box.YMin - 1, box.ZMin - 1))
    one, other = shape.cut(block).Volume, shape.common(block).Volume
    # FreeCAD integrates faces with splines to 1e-5.
    if abs(one + other - shape.Volume) > 1e-5 * shape.Volume or min(one, other) <= 0:
        yield f"two parts: {one:.4f} + {other:.4f} of {shape.Volume:.4f} mm3"


def faults_of_offset(shape):
    try:
        larger = shape.makeOffsetShape(OFFSET, 1e-3)
    except Exception as error:  # OpenCASCADE raises several types.
        yield f"offset of {OFFSET} mm: {error}"
        return
    if not larger.isValid() or larger.Volume <= shape.Volume:
        yield f"offset of {OFFSET} mm: {larger.Volume:.4f} of {shape.Volume:.4f} mm3"


def main():
    folder = os.environ["FOLDER"]
    files = sorted(name for name in os.listdir(folder) if name.endswith(".step"))
    faulty = 0
    for name in files:
        shape = Part.Shape()
        shape.read(os.path.join(folder, name))
        faults = list(faults_of(shape.Solids[0] if len(shape.Solids) == 1 else shape))
        faulty += bool(faults)
        for fault in faults:
            print(f"{name}: {fault}", flush=True)
    print(f"{len(files)} solids, {faulty} with faults", flush=True)
    return 1 if faulty or not files else 0


# freecadcmd does not pass on the exit code of a script.
try:
    status = main()
except Exception:
    traceback.print_exc()
    status = 2
os._exit(status)
