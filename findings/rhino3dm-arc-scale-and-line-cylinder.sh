#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, rhino3dm 8.35.0 (OpenNURBS).
# Input:    arcs and a circle of radius 5 about 0,0,0 with the transform 2,1,1; lines and the finite cylinder of radius 5 between z 0
#           and z 10; PolyCurve with a gap; a sphere of radius 5 as six faces. Source: rhino3dm.d.ts (transform: "true if
#           geometry successfully transformed", lineCylinder: "using exact calculations").
# Expected: The transformed arc from 5,0 to 0,5 goes from 10,0 to 0,5, or transform returns false. The ellipse of 10 x 5 is
#           an ellipse. Each point of lineCylinder is on the line. The second line of the PolyCurve starts at 20,5, or the
#           gap is reported or refused. The box of the sphere is -5..5.
# Seen:     transform returns true and gives an arc of radius 7.07 from 7.07,0 to 0,7.07: sqrt(2) times the radius. isEllipse is
#           false for the exact NURBS ellipse. A line 40 above the cylinder gets "Multiple" with two points at z 10, and
#           an oblique line gets -5,0,0 instead of -5,0,-5. The second line starts at 10,0 and keeps its end, so its
#           direction changes; hasGap is false. The box of the sphere is -11.85..11.85.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" rhino3dm@8.35.0 >/dev/null

cat >check.mjs <<'JS'
import rhino3dm from 'rhino3dm';
const rhino = await rhino3dm();
const text = (values) => values.map((x) => Number(x.toFixed(2)) + 0).join(',');
const stretched = () => {
  const matrix = rhino.Transform.identity();
  matrix.m00 = 2;
  return matrix;
};
const extent = (geometry) => {
  const box = geometry.getBoundingBox(true);
  return `${text(box.min)} to ${text(box.max)}`;
};
const circle = new rhino.Circle([0, 0, 0], 5);

const curves = {
  'arc curve': rhino.ArcCurve.createFromArc(new rhino.Arc(circle, Math.PI / 2)),
  'circle curve': rhino.ArcCurve.createFromCircle(circle),
  'NURBS arc': new rhino.Arc(circle, Math.PI / 2).toNurbsCurve(),
  'NURBS circle': circle.toNurbsCurve(),
};
for (const [name, curve] of Object.entries(curves)) {
  const done = curve.transform(stretched());
  console.log(`${name} times 2,1,1: ${done}, ${text(curve.pointAtStart)} to ${text(curve.pointAtEnd)}, box ${extent(curve)}`);
}
console.log(`NURBS circle times 2,1,1 is an ellipse: ${curves['NURBS circle'].isEllipse()}`);

const cylinder = new rhino.Cylinder(circle, 10);
const kinds = rhino.LineCylinderIntersection;
for (const [from, to] of [[[-10, 0, 5], [10, 0, 5]], [[-10, 0, 50], [10, 0, 50]], [[-10, 0, -10], [10, 0, 10]]]) {
  const [kind, first, second] = rhino.Intersection.lineCylinder(new rhino.Line(from, to), cylinder);
  const name = ['None', 'Single', 'Multiple', 'Overlap'].find((k) => kinds[k].value === kind.value);
  console.log(`line ${text(from)} to ${text(to)}: ${name} at ${text(first)} and ${text(second)}`);
}

const path = new rhino.PolyCurve();
path.appendLine(new rhino.Line([0, 0, 0], [10, 0, 0]));
const appended = path.appendLine(new rhino.Line([20, 5, 0], [30, 5, 0]));
const segment = path.segmentCurve(1);
console.log(`appended 20,5 to 30,5: ${appended}, gap ${path.hasGap}, ${text(segment.pointAtStart)} to ${text(segment.pointAtEnd)}`);

const sphere = rhino.Brep.createQuadSphere(new rhino.Sphere([0, 0, 0], 5));
console.log(`sphere of ${sphere.faces().count} faces: box ${extent(sphere)}`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
arc curve times 2,1,1: true, 7.07,0,0 to 0,7.07,0, box 0,0,0 to 7.07,7.07,0
circle curve times 2,1,1: true, 7.07,0,0 to 7.07,0,0, box -7.07,-7.07,0 to 7.07,7.07,0
NURBS arc times 2,1,1: true, 10,0,0 to 0,5,0, box 0,0,0 to 10,5,0
NURBS circle times 2,1,1: true, 10,0,0 to 10,0,0, box -10,-5,0 to 10,5,0
NURBS circle times 2,1,1 is an ellipse: false
line -10,0,5 to 10,0,5: Multiple at -5,0,5 and 5,0,5
line -10,0,50 to 10,0,50: Multiple at -5,0,10 and 5,0,10
line -10,0,-10 to 10,0,10: Multiple at -5,0,0 and 5,0,5
appended 20,5 to 30,5: true, gap false, 10,0,0 to 30,5,0
sphere of 6 faces: box -11.85,-11.85,-11.85 to 11.85,11.85,11.85
EXPECTED
