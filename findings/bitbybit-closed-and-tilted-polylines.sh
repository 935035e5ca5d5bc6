#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @bitbybit-dev/base 0.20.11 (geometry of the CAD platform Bitbybit).
# Input:    a closed square of 10 x 10; the same square and a line across it, both turned about X.
# Expected: The length of the closed square is 40. Rotation and reversal keep it closed, and reversal keeps its input. The
#           line meets the square at two points in each plane.
# Seen:     The length is 30, although the conversion to lines gives four lines of 10. transformPolyline and reverse
#           return open polylines; reverse changes its input. Turned by 30 or 60 degrees, the line has no point: the
#           tolerance of coplanar lines is the cube of the given one, less than rounding. By 0 and 90 degrees it is right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @bitbybit-dev/base@0.20.11 esbuild@0.21.5 >/dev/null

cat >check.mjs <<'JS'
import { GeometryHelper, Line, Lists, MathBitByBit, Point, Polyline, Transforms, Vector } from '@bitbybit-dev/base';
const helper = new GeometryHelper();
const math = new MathBitByBit();
const vector = new Vector(math, helper);
const transforms = new Transforms(vector, math);
const point = new Point(helper, transforms, vector, new Lists());
const line = new Line(vector, point, helper);
const polyline = new Polyline(vector, point, line, helper);

const square = () => ({ points: [[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]], isClosed: true });
const lengths = polyline.polylineToLines({ polyline: square() }).map((l) => line.length({ line: l }));
console.log(`closed square: length ${polyline.length({ polyline: square() })}, lines ${lengths.join(' ')}`);

const turn = (angle) => transforms.rotationCenterX({ center: [0, 0, 0], angle });
const turned = polyline.transformPolyline({ polyline: square(), transformation: turn(0) });
console.log(`transformed: closed ${turned.isClosed}, lines ${polyline.polylineToLines({ polyline: turned }).length}`);
const input = square();
const reversed = polyline.reverse({ polyline: input });
console.log(`reversed: closed ${reversed.isClosed}, input starts at ${input.points[0]}`);

const crossings = (angle) => {
  const outline = { ...polyline.transformPolyline({ polyline: square(), transformation: turn(angle) }), isClosed: true };
  const cut = { points: [[1, -3, 0], [7, 14, 0]] };
  const diagonal = polyline.transformPolyline({ polyline: cut, transformation: turn(angle) });
  return polyline.twoPolylineIntersection({ polyline1: outline, polyline2: diagonal, tolerance: 1e-6 }).length;
};
for (const angle of [0, 30, 60, 90]) console.log(`square and line, turned by ${angle}: ${crossings(angle)} points`);
JS
# Node.js does not find the folders that the package imports; a bundler does.
node_modules/.bin/esbuild check.mjs --bundle --format=esm --platform=node --outfile=bundle.mjs --log-level=error
node bundle.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
closed square: length 30, lines 10 10 10 10
transformed: closed undefined, lines 3
reversed: closed undefined, input starts at 0,10,0
square and line, turned by 0: 2 points
square and line, turned by 30: 0 points
square and line, turned by 60: 0 points
square and line, turned by 90: 2 points
EXPECTED
