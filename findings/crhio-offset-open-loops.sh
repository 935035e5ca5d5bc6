#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @crhio/offset 0.0.13 (JavaScript version of CavalierContours).
# Input:    two closed counter-clockwise outlines: squares of 10 x 10 joined by a neck of width 2, and a rectangle of
#           12 x 6 with a tab of width 2. Inward passes for a pocket: by 1.5, then by 1. The parameter sharpCorners is
#           true (the default) or false. Source: test/offset.spec.js (closed outlines; a positive distance is
#           inwards).
# Expected: The first pass of the squares gives two closed outlines of 7 x 7, the second pass 5 x 5 each; the tab
#           vanishes.
# Seen:     With the default, each outline whose neck vanishes is open, and its last segment repeats the first:
#           isClosed is false. The second pass is a line of length 1, so that 5 x 5 of each square is not milled. With
#           sharpCorners false, all outlines are closed. A plain square is right in both modes.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @crhio/offset@0.0.13 >/dev/null

cat >check.cjs <<'JS'
const offset = require('@crhio/offset').default;
const outline = (corners) => ({ vertexes: corners.map(([x, y]) => ({ x, y, bulge: 0 })), isClosed: true });
const size = (values) => (Math.max(...values) - Math.min(...values)).toFixed(2);
const show = (loops) => loops.map((loop) => `${loop.isClosed ? 'closed' : 'open'}, ${loop.vertexes.length} vertices, ` +
  `${size(loop.vertexes.map((v) => v.x))} x ${size(loop.vertexes.map((v) => v.y))}`).join('; ');
const outlines = {
  square: outline([[0, 0], [10, 0], [10, 10], [0, 10]]),
  'squares with neck': outline([[0, 0], [10, 0], [10, 4], [20, 4], [20, 0], [30, 0], [30, 10], [20, 10], [20, 6], [10, 6],
    [10, 10], [0, 10]]),
  'rectangle with tab': outline([[0, 0], [12, 0], [12, 6], [7, 6], [7, 9], [5, 9], [5, 6], [0, 6]]),
};
for (const [name, shape] of Object.entries(outlines)) {
  for (const sharp of [true, false]) {
    const first = offset(shape, 1.5, sharp);
    console.log(`${name}, sharpCorners ${sharp}`);
    console.log(`  by 1.5: ${show(first)}`);
    console.log(`  then 1: ${show(first.flatMap((loop) => offset(loop, 1, sharp)))}`);
  }
}
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
square, sharpCorners true
  by 1.5: closed, 4 vertices, 7.00 x 7.00
  then 1: closed, 4 vertices, 5.00 x 5.00
square, sharpCorners false
  by 1.5: closed, 4 vertices, 7.00 x 7.00
  then 1: closed, 4 vertices, 5.00 x 5.00
squares with neck, sharpCorners true
  by 1.5: open, 8 vertices, 7.00 x 7.00; open, 8 vertices, 7.00 x 7.00
  then 1: open, 2 vertices, 0.00 x 1.00; open, 2 vertices, 0.00 x 1.00
squares with neck, sharpCorners false
  by 1.5: closed, 7 vertices, 7.38 x 7.00; closed, 7 vertices, 7.38 x 7.00
  then 1: closed, 7 vertices, 5.21 x 5.00; closed, 7 vertices, 5.21 x 5.00
rectangle with tab, sharpCorners true
  by 1.5: open, 8 vertices, 9.00 x 3.00
  then 1: open, 2 vertices, 1.00 x 0.00
rectangle with tab, sharpCorners false
  by 1.5: closed, 7 vertices, 9.00 x 3.38
  then 1: closed, 7 vertices, 7.00 x 1.21
EXPECTED
