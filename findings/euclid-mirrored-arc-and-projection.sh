#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @mathigon/euclid 1.2.4 (2D geometry: arcs, ellipses, polygons, intersections).
# Input:    circles of radius 3 and 1 that touch, outside and inside; a quarter arc from 2,0 to 0,2, mirrored in the y
#           axis; the projection of points on this arc and on an ellipse with radii 5 and 3; an L-shaped polygon.
#           Source: readme.md ("API"), the types of GeoShape.
# Expected: One point of contact at 3,0. The mirrored arc runs from -2,0 to 0,2. The projection of 5,-1 on the arc is
#           2,0. The projection on an ellipse is its nearest point, as for lines, polygons and circles. The centroid
#           is 3.22,3.22.
# Seen:     The touching point is the middle of the centres, 2,0, inside the large circle; from inside, 3,0 is
#           returned twice. The mirrored arc ends at 0,-2, outside the mirror image. The point below the arc is
#           projected on its far end, 0,2. The ellipse returns the point with the same parameter angle: 1.48 away
#           instead of 0.81. The centroid is the mean of the corners, 4,4, outside the polygon.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @mathigon/euclid@1.2.4 >/dev/null

cat >check.mjs <<'JS'
import { Arc, Circle, Ellipse, Line, Point, Polygon, intersections } from '@mathigon/euclid';
const at = (x, y) => new Point(x, y);
const show = (p) => `${p.x.toFixed(2)},${p.y.toFixed(2)}`.replace(/-0\.00/g, '0.00');
const large = new Circle(at(0, 0), 3);
for (const [name, x] of [['outside', 4], ['inside', 2]]) {
  console.log(`touching from ${name}: ${intersections(large, new Circle(at(x, 0), 1)).map(show).join(' ')}`);
}
const quarter = new Arc(at(0, 0), at(2, 0), Math.PI / 2);
const mirrored = quarter.reflect(new Line(at(0, 0), at(0, 1)));
console.log(`arc: ${show(quarter.start)} to ${show(quarter.end)}, mirrored: ${show(mirrored.start)} to ${show(mirrored.end)}`);
console.log(`arc, projection of 5,1: ${show(quarter.project(at(5, 1)))}, of 5,-1: ${show(quarter.project(at(5, -1)))}`);

const ellipse = new Ellipse(at(0, 0), 5, 3);
const point = at(3, 1.5);
const nearest = Math.min(...Array.from({ length: 3600 }, (_, i) => Point.distance(point, ellipse.at(i / 3600))));
const projected = ellipse.project(point);
console.log(`ellipse: nearest point at ${nearest.toFixed(2)}, projection at ${Point.distance(point, projected).toFixed(2)}`);

const outline = new Polygon(...[[0, 0], [10, 0], [10, 2], [2, 2], [2, 10], [0, 10]].map(([x, y]) => at(x, y)));
console.log(`L: area ${outline.area}, centroid ${show(outline.centroid)}, inside: ${outline.contains(outline.centroid)}`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
touching from outside: 2.00,0.00
touching from inside: 3.00,0.00 3.00,0.00
arc: 2.00,0.00 to 0.00,2.00, mirrored: -2.00,0.00 to 0.00,-2.00
arc, projection of 5,1: 1.96,0.39, of 5,-1: 0.00,2.00
ellipse: nearest point at 0.81, projection at 1.48
L: area 36, centroid 4.00,4.00, inside: false
EXPECTED
