#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @mlightcad/geometry-engine 3.14.3 with @mlightcad/common 1.14.3 (geometry of a CAD viewer, after
#           AcGe).
# Input:    closed counter-clockwise polylines with bulges: a square, a slot of 10 x 4 with round ends, a circle of
#           two vertices, two squares joined by a neck of width 2; a quarter circle. Source: AcGePolyline2d.offset
#           ("signed offset distance"), area and AcGeCircArc3d.nearestPoint of the type declarations; DXF reference,
#           LWPOLYLINE (42, bulge).
# Expected: A positive distance is inwards for each of them, as for the square. The slot by 1 has the area 23.14, the
#           circle 50.27, the squares two outlines. A distance beyond half the width gives no outline. The area of the
#           circle is 78.54. The nearest point is in the direction of the query.
# Seen:     The side lines of the slot move inwards and the round ends outwards: 31.77, not 23.14. The circle moves
#           outwards. The neck turns over instead of splitting the outline; the square by 6 becomes 2 x 2. The area of
#           the circle is 0, like that of each closed polyline with two vertices. The nearest point of the 3D arc is
#           always one of its ends.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @mlightcad/geometry-engine@3.14.3 @mlightcad/common@1.14.3 esbuild@0.21.5 >/dev/null

cat >check.mjs <<'JS'
import { AcGeCircArc2d, AcGeCircArc3d, AcGePoint3d, AcGePolyline2d, AcGeVector3d } from '@mlightcad/geometry-engine';
const closed = (corners) => new AcGePolyline2d(corners.map(([x, y, bulge]) => ({ x, y, bulge })), true);
const outlines = {
  square: closed([[0, 0], [10, 0], [10, 10], [0, 10]]),
  slot: closed([[0, 0], [10, 0, 1], [10, 4], [0, 4, 1]]),
  circle: closed([[0, 0, 1], [10, 0, 1]]),
  'squares with neck': closed([[0, 0], [10, 0], [10, 4], [20, 4], [20, 0], [30, 0], [30, 10], [20, 10], [20, 6], [10, 6],
    [10, 10], [0, 10]]),
};
const show = (name, ...distances) => {
  const outline = outlines[name];
  const areas = distances.map((d) => `by ${d}: ${outline.offset(d).map((o) => o.area.toFixed(2)).join(' and ') || 'none'}`);
  console.log(`${name}: area ${outline.area.toFixed(2)}, ${areas.join(', ')}`);
};
show('square', 1, -1, 6);
show('slot', 1, -1, 3);
show('circle', 1, -1);
show('squares with neck', 1.5);
const sides = outlines.slot.offset(1)[0].calculateBoundingBox();
console.log(`slot by 1: x ${sides.min.x.toFixed(2)} to ${sides.max.x.toFixed(2)}, y ${sides.min.y.toFixed(2)} to ${sides.max.y.toFixed(2)}`);

const at = (x, y) => new AcGePoint3d(x, y, 0);
const arc3d = new AcGeCircArc3d(at(0, 0), 5, 0, Math.PI / 2, new AcGeVector3d(0, 0, 1), new AcGeVector3d(1, 0, 0));
const arc2d = new AcGeCircArc2d(at(0, 0), 5, 0, Math.PI / 2, false);
for (const [x, y] of [[5, 5], [3, 1], [1, 3]]) {
  const points = [arc2d, arc3d].map((arc) => arc.nearestPoint(at(x, y)));
  console.log(`nearest to ${x},${y}: ${points.map((p) => `${p.x.toFixed(2)},${p.y.toFixed(2)}`).join(' in 2D, ')} in 3D`);
}
JS
# Node.js does not find the folders that the package imports; a bundler does.
node_modules/.bin/esbuild check.mjs --bundle --format=esm --platform=node --outfile=bundle.mjs --log-level=error
node bundle.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
square: area 100.00, by 1: 64.00, by -1: 144.00, by 6: 4.00
slot: area 52.57, by 1: 31.77, by -1: 67.73, by 3: 116.39
circle: area 0.00, by 1: 112.92, by -1: 50.18
squares with neck: area 220.00, by 1.5: 85.00
slot by 1: x -3.00 to 13.00, y 1.00 to 3.00
nearest to 5,5: 3.54,3.54 in 2D, 0.00,5.00 in 3D
nearest to 3,1: 4.74,1.58 in 2D, 5.00,0.00 in 3D
nearest to 1,3: 1.58,4.74 in 2D, 0.00,5.00 in 3D
EXPECTED
