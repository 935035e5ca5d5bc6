# SPDX-License-Identifier: GPL-3.0-or-later
#
# FILE=part.glb blender -b --factory-startup --python read_blender.py: reads glTF, STL, PLY, VRML or SVG.
import json
import os

import bmesh
import bpy
import mathutils
import numpy

# The importer of glTF in Debian 12 needs a name that its NumPy lacks.
numpy.bool = bool

path = os.path.abspath(os.environ["FILE"])
ending = path.rsplit(".", 1)[1]
for item in list(bpy.data.objects):
    bpy.data.objects.remove(item)
for material in list(bpy.data.materials):
    bpy.data.materials.remove(material)
if ending == "glb":
    bpy.ops.import_scene.gltf(filepath=path)
elif ending == "stl":
    bpy.ops.import_mesh.stl(filepath=path)
elif ending == "ply":
    bpy.ops.import_mesh.ply(filepath=path)
elif ending == "wrl":
    bpy.ops.import_scene.x3d(filepath=path, axis_forward="Y", axis_up="Z")
bpy.context.view_layer.update()
volume, names, low, high = 0.0, set(), [1e9] * 3, [-1e9] * 3
scale = 1000.0 if ending == "glb" else 1.0
whole = bmesh.new()
for item in bpy.data.objects:
    names.add(item.name)
    if item.type != "MESH":
        continue
    mesh = item.data.copy()
    mesh.transform(mathutils.Matrix.Scale(scale, 4) @ item.matrix_world)
    whole.from_mesh(mesh)
    names |= {attribute.name for attribute in mesh.attributes if "LINE" in attribute.name.upper()}
    names |= {layer.name for layer in mesh.polygon_layers_int if "LINE" in layer.name.upper()}
    for vertex in mesh.vertices:
        low = [min(a, b) for a, b in zip(low, vertex.co)]
        high = [max(a, b) for a, b in zip(high, vertex.co)]
colours = set()
for material in bpy.data.materials:
    names.add(material.name)
    node = material.node_tree.nodes.get("Principled BSDF") if material.node_tree else None
    colour = mathutils.Color((node.inputs[0].default_value if node else material.diffuse_color)[:3])
    colours.add("#" + "".join(f"{round(255 * share):02x}" for share in colour.from_scene_linear_to_srgb()))
found = {"version": bpy.app.version_string, "volume": whole.calc_volume(signed=True), "min": low,
         "size": [b - a for a, b in zip(low, high)], "colours": sorted(colours), "names": sorted(names)}
with open(path + ".json", "w", encoding="utf-8") as out:
    json.dump(found, out)
