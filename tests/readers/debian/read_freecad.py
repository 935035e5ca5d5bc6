# SPDX-License-Identifier: GPL-3.0-or-later
#
# freecadcmd read_freecad.py: reads part.step, part.stl, part.ply or part.dxf of the current folder, as
# the environment variable FILE says. A line of JSON has what FreeCAD found.
import json
import os

import FreeCAD

# pylint: disable=import-error
path = os.path.abspath(os.environ["FILE"])
found = {"version": ".".join(FreeCAD.Version()[:3])}


def size_of(box):
    found["min"] = [box.XMin, box.YMin, box.ZMin]
    found["size"] = [box.XLength, box.YLength, box.ZLength]


if path.endswith((".stl", ".ply")):
    import Mesh

    mesh = Mesh.Mesh(path)
    found["volume"] = mesh.Volume
    size_of(mesh.BoundBox)
elif path.endswith(".dxf"):
    import Import

    draft = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Draft")
    draft.SetBool("groupLayers", True)
    Import.readDXF(path)
    box = FreeCAD.BoundBox()
    for item in FreeCAD.ActiveDocument.Objects:
        box.add(item.Shape.BoundBox)
    found["names"] = [item.Label for item in FreeCAD.ActiveDocument.Objects]
    size_of(box)
elif "gui" in os.environ:
    import ImportGui

    step = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Import/hSTEP")
    step.SetBool("ReadShapeCompoundMode", False)
    document = FreeCAD.newDocument("part")
    ImportGui.insert(path, document.Name)
    solids = [item for item in document.Objects if item.TypeId == "Part::Feature"]
    found["names"] = [item.Label for item in solids]
    found["volume"] = sum(item.Shape.Volume for item in solids)
    box = FreeCAD.BoundBox()
    for item in solids:
        box.add(item.Shape.BoundBox)
    size_of(box)
    colours = {colour[:3] for item in solids for colour in item.ViewObject.DiffuseColor}
    found["colours"] = ["#" + "".join(f"{round(255 * share):02x}" for share in colour) for colour in sorted(colours)]
else:
    import Part

    shape = Part.Shape()
    shape.read(path)
    assert shape.isValid()
    found["volume"] = shape.Volume
    size_of(shape.BoundBox)
with open(path + ".json", "w", encoding="utf-8") as out:
    json.dump(found, out)
os._exit(0)
