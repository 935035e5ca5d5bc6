#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, open3d 0.2.4 (3D geometry in JavaScript with the names of RhinoCommon).
# Input:    the segment from 0,0,0 to 10,0,0 and five other segments; segments and a plane at z 5; turns from the direction
#           1,0,0; points on the surface of a box. Source: documentation of the package (DistanceTo: "If true, the distance is
#           limited to the finite line segment", the shortest distance; VectorToVector: "A rotation matrix which rotates
#           fromVector to toVector"; ContainsPoint: "If true, the point needs to be fully on the inside").
# Expected: The distances are those of the closest of 401 x 401 pairs of points. The distance to a plane is not negative, and 0
#           for a segment through it. The turn to the same direction is the identity, the turn to the opposite one a half turn.
#           A point on the surface is inside if strict is false.
# Seen:     The closest points of the infinite lines are limited to the segments one by one, so a segment at a distance of 5
#           gets 0.42, and parallel segments one after the other get the distance of their lines, 4 instead of 10.77. A segment
#           from z 1 to 3 is at -4 from the plane at z 5, and its reverse, too. The turn to the same and to the opposite
#           direction is an error. strict has the opposite meaning.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" open3d@0.2.4 >/dev/null

cat >check.cjs <<'JS'
const { BoundingBox, Line, Plane, Point3d, Transform, Vector3d } = require('open3d');

const point = (x, y, z) => new Point3d(x, y, z);
const line = (a, b) => new Line(point(...a), point(...b));
const sampled = (first, second) => {
  const points = ({ From, To }) => [...Array(401).keys()].map((i) => i / 400)
    .map((t) => ['X', 'Y', 'Z'].map((c) => From[c] + t * (To[c] - From[c])));
  const others = points(second);
  return Math.min(...points(first).map((p) => Math.min(...others.map((q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2])))));
};
const first = line([0, 0, 0], [10, 0, 0]);
const others = [[[5, 3, 0], [5, 8, 0]], [[13, 4, 0], [23, 20, 0]], [[13, 4, 2], [14, 12, 2]], [[0, 4, 0], [10, 4, 0]], [[20, 4, 0], [30, 4, 0]]];
for (const ends of others) {
  const second = line(...ends);
  console.log(`to the segment ${ends.join(' to ')}: ${first.DistanceTo(second, true).toFixed(2)}, sampled ${sampled(first, second).toFixed(2)}`);
}
const plane = Plane.CreateFromNormal(point(0, 0, 5), new Vector3d(0, 0, 1));
for (const heights of [[1, 1], [1, 3], [3, 1], [1, 9], [9, 7]]) {
  const [low, high] = heights.map((z) => Math.abs(z - 5));
  const crosses = Math.min(...heights) < 5 && Math.max(...heights) > 5;
  const segment = line([0, 0, heights[0]], [3, 0, heights[1]]);
  console.log(`z ${heights.join(' to ')} and a plane at z 5: ${segment.DistanceTo(plane, true).toFixed(2)}, expected ${
    (crosses ? 0 : Math.min(low, high)).toFixed(2)}`);
}
for (const to of [[0, 1, 0], [1, 0, 0], [2, 0, 0], [-1, 0, 0]]) {
  let text;
  try {
    const { X, Y, Z } = new Vector3d(1, 0, 0).Transform(Transform.VectorToVector(new Vector3d(1, 0, 0), new Vector3d(...to)));
    text = [X, Y, Z].map((v) => Number(v.toFixed(2)) + 0).join();
  } catch (error) {
    text = error.message;
  }
  console.log(`1,0,0 turned to ${to}: ${text}`);
}
const box = BoundingBox.CreateFromMinMax(0, 0, 0, 10, 10, 10);
for (const strict of [false, true])
  console.log(`strict ${strict}: 5,5,5 ${box.ContainsPoint(point(5, 5, 5), strict)}, 10,5,5 ${box.ContainsPoint(point(10, 5, 5), strict)}`);
JS
node check.cjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
to the segment 5,3,0 to 5,8,0: 3.00, sampled 3.00
to the segment 13,4,0 to 23,20,0: 0.42, sampled 5.00
to the segment 13,4,2 to 14,12,2: 3.19, sampled 5.39
to the segment 0,4,0 to 10,4,0: 4.00, sampled 4.00
to the segment 20,4,0 to 30,4,0: 4.00, sampled 10.77
z 1 to 1 and a plane at z 5: -4.00, expected 4.00
z 1 to 3 and a plane at z 5: -4.00, expected 2.00
z 3 to 1 and a plane at z 5: -4.00, expected 2.00
z 1 to 9 and a plane at z 5: 0.00, expected 0.00
z 9 to 7 and a plane at z 5: 2.00, expected 2.00
1,0,0 turned to 0,1,0: 0,1,0
1,0,0 turned to 1,0,0: Rotation axis should not be zero vector.
1,0,0 turned to 2,0,0: Rotation axis should not be zero vector.
1,0,0 turned to -1,0,0: Rotation axis should not be zero vector.
strict false: 5,5,5 true, 10,5,5 false
strict true: 5,5,5 true, 10,5,5 true
EXPECTED
