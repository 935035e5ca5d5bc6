#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: occt-import-js 0.0.23 (npm), gmsh 4.8.4+ds2-3 (Debian 12). Both read STEP with OpenCASCADE.
# Input:    STEP AP214: a tetrahedron with one orange face (COLOUR_RGB 1, 0.5, 0) and three blue ones (0, 0.5, 1), as a
#           product, and as the single component of an assembly.
# Expected: Both files give the face colours 1, 0.5, 0 and 0, 0.5, 1.
# Seen:     Both programs give 0.214 instead of 0.5, the linear share of light, so that a display with the numbers as
#           written is too dark. occt-import-js has no colour at all for the component of the assembly, neither for its
#           faces nor for the mesh; gmsh has them. No message appears.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund --prefix "$work" occt-import-js@0.0.23 >/dev/null
# Extracts Debian 12 packages into ./root, without installation: all that this machine has not installed.
mkdir -p deb root
apt-get install -s --no-install-recommends gmsh=4.8.4+ds2-3 2>log | sed -n 's/^Inst \([^ ]*\) .*(\([^ ]*\) .*/\1=\2/p' >list
[ -s list ] || cat log >&2
(cd deb && xargs apt-get download <../list >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
for package in deb/*.deb; do dpkg -x "$package" root; done
libraries=$(find root -name '*.so*' -printf '%h\n' | sort -u | sed "s|^|$work/|" | paste -sd:)

cat >write.py <<'PY'
import math

NO = "''"


def step(path, is_assembly):
    lines, last = [], 0

    def add(text):
        nonlocal last
        last += 1
        lines.append(f"#{last}={text};")
        return f"#{last}"

    def many(items):
        return "(" + ",".join(items) + ")"

    def point(p):
        return add("CARTESIAN_POINT('',(" + ",".join(f"{float(x)}" for x in p) + "))")

    def direction(d):
        return add("DIRECTION('',(" + ",".join(f"{float(x)}" for x in d) + "))")

    def place(p=(0, 0, 0), z=(0, 0, 1), x=(1, 0, 0)):
        return add(f"AXIS2_PLACEMENT_3D('',{point(p)},{direction(z)},{direction(x)})")

    length = add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))")
    angle = add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))")
    solid = add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())")
    near = add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),{length},'distance_accuracy_value','')")
    context = add("(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" + near +
                  f")) GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid})) REPRESENTATION_CONTEXT('',''))")
    application = add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')")
    add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
    mechanical = add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    design = add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")

    def product(name):
        made = add(f"PRODUCT('{name}','{name}','',({mechanical}))")
        add(f"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({made}))")
        definition = add(f"PRODUCT_DEFINITION('design','',{add(f'PRODUCT_DEFINITION_FORMATION({NO},{NO},{made})')},{design})")
        return definition, add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")

    corners = [(0, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10)]
    vertices = [add(f"VERTEX_POINT('',{point(p)})") for p in corners]
    edges = {}
    faces, styled = [], []
    for colour, loop in zip(("1.,0.5,0.", "0.,0.5,1.", "0.,0.5,1.", "0.,0.5,1."), ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))):
        oriented = []
        for a, b in zip(loop, loop[1:] + loop[:1]):
            key = (min(a, b), max(a, b))
            if key not in edges:
                p, q = corners[key[0]], corners[key[1]]
                d = [y - x for x, y in zip(p, q)]
                n = math.sqrt(sum(x * x for x in d))
                vector = add(f"VECTOR('',{direction([x / n for x in d])},1.)")
                edges[key] = add(f"EDGE_CURVE('',{vertices[key[0]]},{vertices[key[1]]},{add(f'LINE({NO},{point(p)},{vector})')},.T.)")
            oriented.append(add(f"ORIENTED_EDGE('',*,*,{edges[key]},{'.T.' if (a, b) == key else '.F.'})"))
        p, q, r = (corners[i] for i in loop)
        u, v = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        unit = lambda w: [x / math.sqrt(sum(y * y for y in w)) for x in w]
        plane = add(f"PLANE('',{place(p, unit(n), unit(u))})")
        outline = add(f"FACE_OUTER_BOUND('',{add('EDGE_LOOP(' + NO + ',' + many(oriented) + ')')},.T.)")
        faces.append(add(f"ADVANCED_FACE('',({outline}),{plane},.T.)"))
        rgb = add(f"COLOUR_RGB('',{colour})")
        fill = add(f"FILL_AREA_STYLE('',({add(f'FILL_AREA_STYLE_COLOUR({NO},{rgb})')}))")
        side = add(f"SURFACE_SIDE_STYLE('',({add(f'SURFACE_STYLE_FILL_AREA({fill})')}))")
        style = add(f"PRESENTATION_STYLE_ASSIGNMENT(({add(f'SURFACE_STYLE_USAGE(.BOTH.,{side})')}))")
        styled.append(add(f"STYLED_ITEM('',({style}),{faces[-1]})"))
    body = add(f"MANIFOLD_SOLID_BREP('body',{add('CLOSED_SHELL(' + NO + ',' + many(faces) + ')')})")
    definition, shape = product("part")
    own = place()
    representation = add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({own},{body}),{context})")
    add(f"SHAPE_DEFINITION_REPRESENTATION({shape},{representation})")
    if is_assembly:
        whole, whole_shape = product("assembly")
        origin, there = place(), place()
        group = add(f"SHAPE_REPRESENTATION('',({origin},{there}),{context})")
        add(f"SHAPE_DEFINITION_REPRESENTATION({whole_shape},{group})")
        use = add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','part','',{whole},{definition},$)")
        use_shape = add(f"PRODUCT_DEFINITION_SHAPE('','',{use})")
        same = add(f"ITEM_DEFINED_TRANSFORMATION('','',{own},{there})")
        relation = add(f"(REPRESENTATION_RELATIONSHIP('','',{representation},{group})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({same})SHAPE_REPRESENTATION_RELATIONSHIP())")
        add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{use_shape})")
    add(f"MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',{many(styled)},{context})")
    with open(path, "w") as file:
        file.write("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
                   "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" + "\n".join(lines) +
                   "\nENDSEC;\nEND-ISO-10303-21;\n")


step("single.step", False)
step("assembly.step", True)
PY
/usr/bin/python3 write.py

cat >read.cjs <<'JS'
const { readFileSync } = require("fs");
require("occt-import-js")().then((occt) => {
  for (const name of ["single", "assembly"]) {
    const { meshes } = occt.ReadStepFile(readFileSync(name + ".step"), null);
    for (const { color, brep_faces: faces } of meshes) {
      const words = [color, ...faces.map((face) => face.color)].filter(Boolean).map((c) => c.map((x) => x.toFixed(3)).join(" "));
      console.log(`occt-import-js, ${name}: ${words.sort().join(" | ") || "no colour"}`);
    }
  }
});
JS
{
  node read.cjs
  for name in single assembly; do
    LD_LIBRARY_PATH=$libraries root/usr/bin/gmsh -0 $name.step |
      sed -n "s/.*Color (\(.*\)) (.*/gmsh, $name: \1/p" | sort
  done
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
occt-import-js, single: 0.000 0.214 1.000 | 0.000 0.214 1.000 | 0.000 0.214 1.000 | 1.000 0.214 0.000
occt-import-js, assembly: no colour
gmsh, single: 0, 0.214041, 1
gmsh, single: 0, 0.214041, 1
gmsh, single: 0, 0.214041, 1
gmsh, single: 1, 0.214041, 0
gmsh, assembly: 0, 0.214041, 1
gmsh, assembly: 0, 0.214041, 1
gmsh, assembly: 0, 0.214041, 1
gmsh, assembly: 1, 0.214041, 0
EXPECTED
