#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @awayjs/core 0.9.60 (classes Box and Matrix3D). The script defines empty objects for what a browser has.
# Input:    the box from -5,-5,-5 to 5,5,5 with points inside and outside; turns by 90 degrees about axes of the lengths 1, 2 and 5;
#           a matrix of a scale, three turns and a translation in the three styles of orientation. Source: names of the methods
#           (closestPointToPoint, containsPoint, appendRotation(degrees, axis), decompose(orientationStyle), recompose(components)).
# Expected: The closest point of a point inside is that point, as containsPoint says. The length of an axis does not matter, and a
#           point of the axis stays in its place. recompose returns the matrix from the parts of decompose.
# Seen:     The closest point always has y -5, also of points inside. A turn about 0,0,2 makes 1,0,0 to 0,2,0, and 0,0,2, a point of
#           the axis, to 0,0,8. From the parts of the styles axisAngle and quaternion, recompose returns a different matrix; it has
#           no parameter for the style. With the style eulerAngles, it is right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --legacy-peer-deps --prefix "$work" @awayjs/core@0.9.60 >/dev/null

cat >check.cjs <<'JS'
globalThis.self = globalThis.window = globalThis;
globalThis.document = { createElement: () => ({ getContext: () => null }) };
if (!globalThis.navigator) globalThis.navigator = { userAgent: '', platform: '' };
const { Box, Matrix3D, Orientation3D, Vector3D } = require('@awayjs/core/bundle/awayjs-core.umd.js');
const text = ({ x, y, z }) => [x, y, z].map((v) => v.toFixed(3).replace(/^-(0\.0*)$/, '$1')).join(',');
const box = new Box(-5, -5, -5, 10, 10, 10);
for (const point of [[0, 0, 0], [1, 2, 3], [10, 0, 0], [0, 10, 0], [0, -10, 0], [10, 4, -20]].map((p) => new Vector3D(...p)))
  console.log(`point ${text(point)}: inside ${box.containsPoint(point)}, closest point ${text(box.closestPointToPoint(point))}`);
for (const axis of [[0, 0, 1], [0, 0, 2], [0.6, 0, 0.8], [3, 0, 4]]) {
  const vector = new Vector3D(...axis);
  const matrix = new Matrix3D();
  matrix.appendRotation(90, vector.clone());
  console.log(`turn by 90 degrees about ${axis}: 1,0,0 to ${text(matrix.transformVector(new Vector3D(1, 0, 0)))}, ` +
    `the axis to ${text(matrix.transformVector(vector))}`);
}
for (const style of [Orientation3D.EULER_ANGLES, Orientation3D.AXIS_ANGLE, Orientation3D.QUATERNION]) {
  const matrix = new Matrix3D();
  matrix.appendScale(2, 3, 4);
  matrix.appendRotation(20, new Vector3D(1, 0, 0));
  matrix.appendRotation(30, new Vector3D(0, 1, 0));
  matrix.appendRotation(40, new Vector3D(0, 0, 1));
  matrix.appendTranslation(1, 2, 3);
  const parts = matrix.decompose(style).map((part) => part.clone());
  const again = new Matrix3D();
  again.recompose(parts);
  const point = new Vector3D(1, 2, 3);
  console.log(`${style}: 1,2,3 by the matrix ${text(matrix.transformVector(point))}, by its parts ${text(again.transformVector(point))}`);
}
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
AwayJS - Core - 0.9.60
point 0.000,0.000,0.000: inside true, closest point 0.000,-5.000,0.000
point 1.000,2.000,3.000: inside true, closest point 1.000,-5.000,3.000
point 10.000,0.000,0.000: inside false, closest point 5.000,-5.000,0.000
point 0.000,10.000,0.000: inside false, closest point 0.000,-5.000,0.000
point 0.000,-10.000,0.000: inside false, closest point 0.000,-5.000,0.000
point 10.000,4.000,-20.000: inside false, closest point 5.000,-5.000,-5.000
turn by 90 degrees about 0,0,1: 1,0,0 to 0.000,1.000,0.000, the axis to 0.000,0.000,1.000
turn by 90 degrees about 0,0,2: 1,0,0 to 0.000,2.000,0.000, the axis to 0.000,0.000,8.000
turn by 90 degrees about 0.6,0,0.8: 1,0,0 to 0.360,0.800,0.480, the axis to 0.600,0.000,0.800
turn by 90 degrees about 3,0,4: 1,0,0 to 9.000,4.000,12.000, the axis to 75.000,0.000,100.000
eulerAngles: 1,2,3 by the matrix 6.446,8.572,13.543, by its parts 6.446,8.572,13.543
axisAngle: 1,2,3 by the matrix 6.446,8.572,13.543, by its parts 3.078,7.990,14.992
quaternion: 1,2,3 by the matrix 6.446,8.572,13.543, by its parts 3.033,7.995,14.997
EXPECTED
