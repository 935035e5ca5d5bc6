#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, web-ifc 0.0.78 (StreamAllMeshes).
# Input:    IFC4: a rectangle of 4 x 2, extruded by 3 along the direction (0,0,1) and (0,0,5); a rounded rectangle of
#           4 x 2 with the radius 0.5, extruded by 3; a tetrahedron as IfcTriangulatedFaceSet, plain and with PnIndex.
# Expected: An IfcDirection has no length: the volume is 24 for both directions. Rounded: 3 (8 - 0.25 (4 - pi)) = 23.36.
#           PnIndex maps the indices of the faces to the points: both tetrahedra have the volume 1/6.
# Seen:     The direction (0,0,5) makes the solid five times as long: volume 120. The rounded rectangle has sharp
#           corners: volume 24. PnIndex is ignored: here the tetrahedron is turned inside out, -1/6. No error is raised.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" web-ifc@0.0.78 >/dev/null

cat >check.mjs <<'JS'
import { IfcAPI } from 'web-ifc';
const api = new IfcAPI();
await api.Init();
const common = `ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('ViewDefinition [CoordinationView]'),'2;1');
FILE_NAME('in.ifc','2020-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('IFC4'));
ENDSEC;
DATA;
#1=IFCPROJECT('0000000000000000000001',$,'P',$,$,$,$,(#10),#20);
#10=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-05,#11,$);
#11=IFCAXIS2PLACEMENT3D(#12,$,$);
#12=IFCCARTESIANPOINT((0.,0.,0.));
#20=IFCUNITASSIGNMENT((#21,#22));
#21=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);
#22=IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.);
#30=IFCLOCALPLACEMENT($,#11);
#31=IFCSITE('0000000000000000000002',$,'S',$,$,#30,$,$,.ELEMENT.,$,$,$,$,$);
#32=IFCRELAGGREGATES('0000000000000000000003',$,$,$,#1,(#31));
#33=IFCRELCONTAINEDINSPATIALSTRUCTURE('0000000000000000000004',$,$,$,(#40),#31);
#40=IFCBUILDINGELEMENTPROXY('0000000000000000000005',$,'X',$,$,#30,#41,$,$);
#41=IFCPRODUCTDEFINITIONSHAPE($,$,(#42));
#51=IFCAXIS2PLACEMENT2D(#52,$);
#52=IFCCARTESIANPOINT((0.,0.));
`;
function show(name, kind, body) {
  const text = `${common}${body}#42=IFCSHAPEREPRESENTATION(#10,'Body','${kind}',(#60));\nENDSEC;\nEND-ISO-10303-21;\n`;
  const model = api.OpenModel(new TextEncoder().encode(text));
  let volume = 0;
  api.StreamAllMeshes(model, (mesh) => {
    const geometry = api.GetGeometry(model, mesh.geometries.get(0).geometryExpressID);
    const points = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
    const indices = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => points.slice(6 * indices[i + k], 6 * indices[i + k] + 3));
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])) / 6;
      volume += (a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    }
  });
  console.log(`${name}: volume ${volume.toFixed(3)}`);
  api.CloseModel(model);
}
const extrusion = (profile, z) =>
  `#50=${profile};\n#53=IFCDIRECTION((0.,0.,${z}.));\n#60=IFCEXTRUDEDAREASOLID(#50,#11,#53,3.);\n`;
const faces = (list, map) =>
  `#61=IFCCARTESIANPOINTLIST3D(((0.,0.,0.),(1.,0.,0.),(0.,1.,0.),(0.,0.,1.)));\n` +
  `#60=IFCTRIANGULATEDFACESET(#61,$,.T.,${list},${map});\n`;
const rectangle = 'IFCRECTANGLEPROFILEDEF(.AREA.,$,#51,4.,2.)';
show('direction (0,0,1)', 'SweptSolid', extrusion(rectangle, 1));
show('direction (0,0,5)', 'SweptSolid', extrusion(rectangle, 5));
show('rounded rectangle', 'SweptSolid', extrusion('IFCROUNDEDRECTANGLEPROFILEDEF(.AREA.,$,#51,4.,2.,0.5)', 1));
show('tetrahedron', 'Tessellation', faces('((1,3,2),(1,2,4),(2,3,4),(3,1,4))', '$'));
show('tetrahedron, PnIndex', 'Tessellation', faces('((1,2,3),(1,3,4),(3,2,4),(2,1,4))', '(1,3,2,4)'));
JS
node check.mjs 2>/dev/null | grep ': volume' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
direction (0,0,1): volume 24.000
direction (0,0,5): volume 120.000
rounded rectangle: volume 24.000
tetrahedron: volume 0.167
tetrahedron, PnIndex: volume -0.167
EXPECTED
