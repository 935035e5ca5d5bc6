#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, claygl 1.3.0 (class Plane).
# Input:    the plane 0,0,4 * p = 8, which is z = 2, and the plane z = 2 with turns about X, a movement and a scale; rays from z 5
#           in both directions. The script transforms three points of the plane by the same matrices and measures their distances
#           from the transformed plane. Source: comments of the library (normalize: "Normalize the plane's normal and calculate the
#           distance"; applyTransform: "Apply an affine transform matrix to plane"; Ray.intersectPlane returns the intersection of a
#           ray and a plane).
# Expected: The normalized plane has the normal 0,0,1 and the distance 2. Transformed points of the plane have the distance 0 from
#           the transformed plane. The ray that leaves the plane does not meet it.
# Seen:     normalize makes each normal NaN, also one of length 1. After a turn by 90 degrees, the plane passes through the origin,
#           and its points are 2 away; by 30 degrees, 0.27. With a scale of 2, the normal has the length 0.5, and the points are 2
#           away. Only movements and turns about the normal are right. The ray that leaves the plane meets it behind its origin.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" claygl@1.3.0 >/dev/null

cat >check.cjs <<'JS'
const { Matrix4, Plane, Ray, Vector3 } = require('claygl/dist/claygl.js');
const vector = (...values) => new Vector3(...values);
const text = (v) => (v ? [...v.array].map((x) => x.toFixed(3).replace(/^-(0\.0*)$/, '$1')).join(',') : `${v}`);
for (const [normal, distance] of [[[0, 0, 4], 8], [[0, 0, 1], 2]]) {
  const plane = new Plane(vector(...normal), distance);
  plane.normalize();
  console.log(`normalized ${normal} and ${distance}: normal ${text(plane.normal)}, distance ${plane.distance.toFixed(3)}`);
}
const motions = {
  'moved by 1,2,3': new Matrix4().translate(vector(1, 2, 3)),
  'turned about Z by 30 degrees': new Matrix4().rotateZ(Math.PI / 6),
  'turned about X by 30 degrees': new Matrix4().rotateX(Math.PI / 6),
  'turned about X by 90 degrees': new Matrix4().rotateX(Math.PI / 2),
  'scaled by 2': new Matrix4().scale(vector(2, 2, 2)),
};
for (const [name, motion] of Object.entries(motions)) {
  const plane = new Plane(vector(0, 0, 1), 2);
  plane.applyTransform(motion);
  const distances = [[0, 0, 2], [5, 0, 2], [0, 5, 2]].map((p) => plane.distanceToPoint(vector(...p).transformMat4(motion)));
  console.log(`${name}: normal ${text(plane.normal)}, distance ${(plane.distance + 0).toFixed(3)}, ` +
    `points of the plane ${distances.map((d) => Math.abs(d).toFixed(3))} away`);
}
for (const direction of [-1, 1])
  console.log(`ray from z 5 in direction ${direction}: ${text(new Ray(vector(0, 0, 5), vector(0, 0, direction)).intersectPlane(
    new Plane(vector(0, 0, 1), 2)))}`);
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
normalized 0,0,4 and 8: normal NaN,NaN,NaN, distance 2.000
normalized 0,0,1 and 2: normal NaN,NaN,NaN, distance 2.000
moved by 1,2,3: normal 0.000,0.000,1.000, distance 5.000, points of the plane 0.000,0.000,0.000 away
turned about Z by 30 degrees: normal 0.000,0.000,1.000, distance 2.000, points of the plane 0.000,0.000,0.000 away
turned about X by 30 degrees: normal 0.000,-0.500,0.866, distance 1.732, points of the plane 0.268,0.268,0.268 away
turned about X by 90 degrees: normal 0.000,-1.000,0.000, distance 0.000, points of the plane 2.000,2.000,2.000 away
scaled by 2: normal 0.000,0.000,0.500, distance 4.000, points of the plane 2.000,2.000,2.000 away
ray from z 5 in direction -1: 0.000,0.000,2.000
ray from z 5 in direction 1: 0.000,0.000,2.000
EXPECTED
