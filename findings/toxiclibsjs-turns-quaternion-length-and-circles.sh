#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, toxiclibsjs 0.3.3 (computational design: geometry, the JavaScript form of toxiclibs).
# Input:    turns by 90 degrees about X, Y and Z by five functions; the quaternion of 90 degrees about Z; circles through three
#           points; a ray that leaves a plane; a counter-clockwise triangle in the plane XY. Source: comments of the package
#           (rotateAroundAxis: "Rotates the vector around the giving axis"; Circle.from3Points: "circle which has the three
#           given points lying on its perimeter", null only if they are collinear).
# Expected: All functions turn in the same direction, and no turn changes a length. Three corners of a triangle have a
#           circumcircle. A ray does not meet a plane behind its origin. The normal of a counter-clockwise triangle in XY is
#           0,0,1, as in the right-handed product of its sides.
# Seen:     rotateX and rotateY of a vector turn clockwise, rotateZ and all three of a matrix counter-clockwise,
#           rotateAroundAxis of a matrix clockwise. The length of an axis scales the result. A quaternion enlarges by 0.1
#           percent, because mathUtils.sin is an approximation. The circle depends on the order of the points: the right
#           triangle 0,0 0,10 5,5 has the radius 0, 5 or 7.07, and 0,0 10,0 5,5 has none or 5. The ray that leaves the plane
#           meets it behind its origin. The normal of the triangle is 0,0,-1.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" toxiclibsjs@0.3.3 >/dev/null

cat >check.cjs <<'JS'
const { Circle, Matrix4x4, Plane, Quaternion, Ray3D, Triangle3D, Vec2D, Vec3D } = require('toxiclibsjs').geom;

const text = (v) => [v.x, v.y, v.z].map((c) => (Math.abs(c) < 5e-4 ? 0 : c).toFixed(3)).join();
const quarter = Math.PI / 2;
const axes = { X: [1, 0, 0], Y: [0, 1, 0], Z: [0, 0, 1] };
for (const [name, axis] of Object.entries(axes)) {
  const [from, around] = [() => new Vec3D(1, 2, 3), new Vec3D(...axis)];
  const results = {
    expected: name === 'X' ? new Vec3D(1, -3, 2) : name === 'Y' ? new Vec3D(3, 2, -1) : new Vec3D(-2, 1, 3),
    'vector, rotate': from()[`rotate${name}`](quarter),
    'vector, rotateAroundAxis': from().rotateAroundAxis(around, quarter),
    'vector, axis of length 2': from().rotateAroundAxis(around.scale(2), quarter),
    'matrix, rotate': new Matrix4x4()[`rotate${name}`](quarter).applyTo(from()),
    'matrix, rotateAroundAxis': new Matrix4x4().rotateAroundAxis(around, quarter).applyTo(from()),
    quaternion: Quaternion.createFromAxisAngle(around, quarter).toMatrix4x4().applyTo(from()),
  };
  console.log(`90 degrees about ${name}:`);
  for (const [way, result] of Object.entries(results))
    console.log(`  ${way}: ${text(result)}`);
}
const read = Quaternion.createFromAxisAngle(new Vec3D(0, 0, 1), quarter).toAxisAngle();
console.log(`axis of the quaternion: ${read.slice(1).map((v) => v.toFixed(3))}`);

for (const corners of [[[1, 1], [10, 2], [3, 9]], [[0, 0], [10, 0], [5, 5]], [[10, 0], [5, 5], [0, 0]], [[0, 0], [0, 10], [5, 5]],
  [[0, 10], [5, 5], [0, 0]], [[5, 5], [0, 0], [0, 10]]]) {
  const circle = Circle.from3Points(...corners.map(([x, y]) => new Vec2D(x, y)));
  const distances = circle && corners.map(([x, y]) => Math.hypot(x - circle.x, y - circle.y).toFixed(3));
  console.log(`circle through ${corners.join(' ')}: ${circle ? `radius ${circle.getRadius().toFixed(3)}, distances ${distances}` : circle}`);
}
const plane = new Plane(new Vec3D(0, 0, 5), new Vec3D(0, 0, 1));
for (const z of [0, 9])
  console.log(`ray upwards from z ${z}, plane at z 5: ${text(plane.getIntersectionWithRay(new Ray3D(0, 0, z, new Vec3D(0, 0, 1))))}`);
const triangle = new Triangle3D(new Vec3D(0, 0, 0), new Vec3D(10, 0, 0), new Vec3D(0, 10, 0));
console.log(`normal of a counter-clockwise triangle: ${text(triangle.computeNormal())}`);
JS
node check.cjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
90 degrees about X:
  expected: 1.000,-3.000,2.000
  vector, rotate: 1.000,3.000,-2.000
  vector, rotateAroundAxis: 1.000,-3.000,2.000
  vector, axis of length 2: 4.000,-6.000,4.000
  matrix, rotate: 1.000,-3.000,2.000
  matrix, rotateAroundAxis: 1.000,3.000,-2.000
  quaternion: 1.000,-3.007,1.996
90 degrees about Y:
  expected: 3.000,2.000,-1.000
  vector, rotate: -3.000,2.000,1.000
  vector, rotateAroundAxis: 3.000,2.000,-1.000
  vector, axis of length 2: 6.000,8.000,-2.000
  matrix, rotate: 3.000,2.000,-1.000
  matrix, rotateAroundAxis: -3.000,2.000,1.000
  quaternion: 3.001,2.000,-1.007
90 degrees about Z:
  expected: -2.000,1.000,3.000
  vector, rotate: -2.000,1.000,3.000
  vector, rotateAroundAxis: -2.000,1.000,3.000
  vector, axis of length 2: -4.000,2.000,12.000
  matrix, rotate: -2.000,1.000,3.000
  matrix, rotateAroundAxis: 2.000,-1.000,3.000
  quaternion: -2.004,0.997,3.000
axis of the quaternion: 0.000,0.000,1.001
circle through 1,1 10,2 3,9: radius 5.280, distances 5.280,5.280,5.280
circle through 0,0 10,0 5,5: undefined
circle through 10,0 5,5 0,0: radius 5.000, distances 5.000,5.000,5.000
circle through 0,0 0,10 5,5: radius 0.000, distances 0.000,10.000,7.071
circle through 0,10 5,5 0,0: radius 5.000, distances 5.000,5.000,5.000
circle through 5,5 0,0 0,10: radius 7.071, distances 7.071,0.000,10.000
ray upwards from z 0, plane at z 5: 0.000,0.000,5.000
ray upwards from z 9, plane at z 5: 0.000,0.000,5.000
normal of a counter-clockwise triangle: 0.000,0.000,-1.000
EXPECTED
