#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, bezier-js 6.1.4.
# Input:    cubic and quadratic curves with x, y and z: an arch over the plane XZ, a quarter circle of radius 5 in the
#           three coordinate planes, two curves at a distance of 50 in z. Source: src/bezier.js and src/utils.js (points
#           with z, the comment "corresponding 3D counterpart" of the curvature).
# Expected: project returns the nearest point and its distance in space. The curvature of the quarter circle is 0.199 at
#           0.5 in each plane. raise keeps the curve. The two curves do not meet. The arch is not linear.
# Seen:     project ignores z: for the point 2,0,100 it returns 2,0,6.14 with the distance 0.00; the apex is 92.5 away.
#           The curvature is NaN. raise drops z and returns an end point without y and z. The two curves have two
#           intersections. The arch counts as linear. No error is raised. Points, derivatives, length, bounds and split
#           use z and are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" bezier-js@6.1.4 >/dev/null

cat >check.mjs <<'JS'
import { Bezier } from 'bezier-js';
const text = (point) => [point.x, point.y, point.z].map((v) => (v === undefined ? 'none' : (v + 0).toFixed(2))).join(',');
const arch = new Bezier({ x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 10 }, { x: 10, y: 0, z: 10 }, { x: 10, y: 0, z: 0 });
console.log(`arch: length ${arch.length().toFixed(2)}, z up to ${arch.bbox().z.max}, middle ${text(arch.get(0.5))}`);
console.log(`arch: linear ${arch._linear}, left half ends at ${text(arch.split(0.5).left.points[3])}`);
const query = { x: 2, y: 0, z: 100 };
const near = arch.project(query);
let distance = Infinity;
for (let i = 0; i <= 1000; i++) {
  const point = arch.get(i / 1000);
  distance = Math.min(distance, Math.hypot(point.x - query.x, point.y - query.y, point.z - query.z));
}
console.log(`project: ${text(near)} at ${near.d.toFixed(2)}, nearest of 1001 points at ${distance.toFixed(2)}`);
const k = 5 * 0.5522847498;
const ring = [[5, 0], [5, k], [k, 5], [0, 5]];
const curvature = (place) => new Bezier(ring.map(place)).curvature(0.5).k.toFixed(3);
console.log(`curvature in the plane: ${curvature(([x, y]) => ({ x, y }))}`);
console.log(`curvature XY: ${curvature(([x, y]) => ({ x, y, z: 0 }))}, XZ: ${curvature(([x, z]) => ({ x, y: 0, z }))}, ` +
  `YZ: ${curvature(([y, z]) => ({ x: 0, y, z }))}`);
const parabola = new Bezier(0, 0, 0, 5, 5, 5, 10, 0, 0);
console.log(`raise: ${parabola.raise().points.map(text).join(' ')}`);
const low = new Bezier(0, 0, 0, 5, 5, 0, 10, 0, 0);
const high = new Bezier(0, 2, 50, 5, 2, 50, 10, 2.1, 50);
console.log(`overlaps ${low.overlaps(high)}, intersections ${low.intersects(high).length}`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
arch: length 20.00, z up to 7.5, middle 5.00,0.00,7.50
arch: linear true, left half ends at 5.00,0.00,7.50
project: 2.00,0.00,6.14 at 0.00, nearest of 1001 points at 92.55
curvature in the plane: 0.199
curvature XY: NaN, XZ: NaN, YZ: NaN
raise: 0.00,0.00,0.00 3.33,3.33,6.67 3.33,10.00,0.00 0.00,none,none
overlaps true, intersections 2
EXPECTED
