#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, kld-intersections 0.7.0.
# Input:    half an ellipse with radii 5 and 3, turned by 0, 30, 90 and 180 degrees, and a ray along its minor axis; a
#           quarter circle with the rotation 90; an ellipse and a circle; two parallel horizontal or collinear lines.
# Expected: The ray meets the half ellipse at the distance 3. The rotation of a circle has no effect. An ellipse and a
#           circle have at most 4 points. Collinear segments with a gap do not meet.
# Seen:     The rotation turns the limits of the arc, but not its axes: the distance is 3.27 and 5, or no point at all.
#           The circle loses its point. The ellipse and a concentric circle have 8 points, each twice; a shifted circle
#           is right. Segments with a gap of 1 are "Coincident", as are two that overlap.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  kld-intersections@0.7.0 >/dev/null

cat >check.mjs <<'JS'
import { Intersection, ShapeInfo } from 'kld-intersections';
const show = (name, a, b) => {
  const { status, points } = Intersection.intersect(a, b);
  const distances = points.length > 2 ? '' : points.map((p) => ` at distance ${Math.hypot(p.x, p.y).toFixed(2)}`).join('');
  console.log(`${name}: ${status}, points: ${points.length}${distances}`);
};
for (const angle of [0, 30, 90, 180]) {
  const [c, s] = [Math.cos((angle * Math.PI) / 180), Math.sin((angle * Math.PI) / 180)];
  const half = ShapeInfo.path(`M${5 * c} ${5 * s}A5 3 ${angle} 0 1 ${-5 * c} ${-5 * s}`);
  show(`half ellipse, ${angle} degrees`, half, ShapeInfo.line(0, 0, -10 * s, 10 * c));
}
for (const angle of [0, 90]) {
  const quarter = ShapeInfo.path(`M5 0A5 5 ${angle} 0 1 0 5`);
  show(`quarter circle, ${angle} degrees`, quarter, ShapeInfo.line(0, 0, 10, 10));
}
const ellipse = ShapeInfo.ellipse(0, 0, 5, 3);
show('ellipse and shifted circle', ellipse, ShapeInfo.circle(1, 0.5, 4));
show('ellipse and concentric circle', ellipse, ShapeInfo.circle(0, 0, 4));
const line = ShapeInfo.line(0, 0, 10, 0);
show('parallel segments', line, ShapeInfo.line(0, 1, 10, 1));
show('collinear segments, overlap', line, ShapeInfo.line(5, 0, 20, 0));
show('collinear segments, gap', line, ShapeInfo.line(11, 0, 20, 0));
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
half ellipse, 0 degrees: Intersection, points: 1 at distance 3.00
half ellipse, 30 degrees: Intersection, points: 1 at distance 3.27
half ellipse, 90 degrees: Intersection, points: 1 at distance 5.00
half ellipse, 180 degrees: No Intersection, points: 0
quarter circle, 0 degrees: Intersection, points: 1 at distance 5.00
quarter circle, 90 degrees: No Intersection, points: 0
ellipse and shifted circle: Intersection, points: 4
ellipse and concentric circle: Intersection, points: 8
parallel segments: Parallel, points: 0
collinear segments, overlap: Coincident, points: 0
collinear segments, gap: Coincident, points: 0
EXPECTED
