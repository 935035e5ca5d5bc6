#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @thi.ng/matrices 3.0.26 (matrices and quaternions).
# Input:    the quaternion from one direction to another for angles from 0 to 180 degrees; quaternions for 0 and 90 degrees about Z,
#           the second with both signs, which is the same rotation. Source: types of the package: alignmentQuat ("Returns
#           quaternion describing the rotation from direction vector `from` to `to`"), mixQ ("using SLERP").
# Expected: Each alignment has the length 1 and takes `from` to `to`; for opposite directions, each perpendicular axis is right. The
#           middle between 0 and 90 degrees is at 45 degrees, for both signs.
# Seen:     For opposite directions, the quaternion is 0,0,0,0, and the point collapses to the origin: a tool axis that turns over
#           loses its part. At 179.9 degrees, all is right. With the negative sign, mixQ goes the long way: its middle is at
#           -135 degrees, 180 degrees from the right one. No error appears. All other rotations turn in the same direction.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @thi.ng/matrices@3.0.26 >/dev/null

cat >check.mjs <<'JS'
import { alignmentQuat, mixQ, mulV33, mulVQ, quatFromAxisAngle, quatToMat33, rotationZ33 } from '@thi.ng/matrices';
const show = (v) => Array.from(v, (x) => Math.round(x * 1000) / 1000 + 0).join(',');
const rad = (degrees) => (degrees * Math.PI) / 180;
const turned = (q, v) => show(mulVQ([], q, v));

for (const degrees of [0, 90, 179.9, 180]) {
  const to = [Math.cos(rad(degrees)), Math.sin(rad(degrees)), 0];
  const q = alignmentQuat([1, 0, 0], to);
  console.log(`to ${degrees} degrees: length ${Math.hypot(...q).toFixed(3)}, 1,0,0 to ${turned(q, [1, 0, 0])}`);
}
for (const from of [[0, 1, 0], [0, 0, 1], [1, 2, 3]]) {
  const q = alignmentQuat(from, from.map((x) => -x));
  console.log(`${show(from)} to the opposite: ${show(q)}, point to ${turned(q, from)}, matrix of 7,8,9 ${show(mulV33([], quatToMat33([], q), [7, 8, 9]))}`);
}

const start = quatFromAxisAngle([0, 0, 1], 0);
const end = quatFromAxisAngle([0, 0, 1], rad(90));
const negative = Array.from(end, (x) => -x);
for (const [name, q] of [['positive', end], ['negative', negative]]) {
  const path = [0, 0.25, 0.5, 0.75, 1].map((t) => {
    const [x, y] = mulVQ([], mixQ([], start, q, t), [1, 0, 0]);
    return (Math.atan2(y, x) * 180 / Math.PI).toFixed(1).replace('-0.0', '0.0');
  });
  console.log(`${name}: end takes 1,0,0 to ${turned(q, [1, 0, 0])}, angles ${path.join(' ')}`);
}
console.log(`rotationZ33, 90 degrees: 1,0,0 to ${show(mulV33([], rotationZ33([], rad(90)), [1, 0, 0]))}`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
to 0 degrees: length 1.000, 1,0,0 to 1,0,0
to 90 degrees: length 1.000, 1,0,0 to 0,1,0
to 179.9 degrees: length 1.000, 1,0,0 to -1,0.002,0
to 180 degrees: length 0.000, 1,0,0 to 0,0,0
0,1,0 to the opposite: 0,0,0,0, point to 0,0,0, matrix of 7,8,9 7,8,9
0,0,1 to the opposite: 0,0,0,0, point to 0,0,0, matrix of 7,8,9 7,8,9
1,2,3 to the opposite: 0,0,0,0, point to 0,0,0, matrix of 7,8,9 7,8,9
positive: end takes 1,0,0 to 0,1,0, angles 0.0 22.5 45.0 67.5 90.0
negative: end takes 1,0,0 to 0,1,0, angles 0.0 -67.5 -135.0 157.5 90.0
rotationZ33, 90 degrees: 1,0,0 to 0,1,0
EXPECTED
