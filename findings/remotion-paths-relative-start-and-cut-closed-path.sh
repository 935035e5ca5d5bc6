#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @remotion/paths 4.0.529 (SVG paths); svgpath 2.6.0 as a second implementation.
# Input:    a triangle in five notations, moved by 10 in X, moved to the origin and centred; a closed square of 10 cut after 25,
#           35 and 39; a closed triangle with a line after z, reversed. Source: SVG 2, 9.3.3 (a relative moveto at the start of
#           a path is absolute) and 9.3.4 (after closepath, the next part starts at the same point); documentation
#           (translatePath moves a path, resetPath moves its top left corner to 0,0, centerPath its centre, cutPath cuts it at a
#           length).
# Expected: All notations move in the same way, as with svgpath. The cut square has the length of the cut. The reversed path has
#           the same length.
# Seen:     The start m 5 5 stays in place: a relative path does not move at all, and of a mixed one only the absolute parts
#           move, so the triangle gets twice its width. resetPath and centerPath do the same. The square that is cut after 35 is
#           closed, with the length 40. The reversed path has lost the side of z, and 5.40 of its length.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" @remotion/paths@4.0.529 svgpath@2.6.0 >/dev/null

cat >check.cjs <<'JS'
const { centerPath, cutPath, getBoundingBox, getLength, resetPath, reversePath, translatePath } = require('@remotion/paths');
const svgpath = require('svgpath');

const bounds = (path) => {
  const { x1, y1, x2, y2 } = getBoundingBox(path);
  return `${[x1, y1].map((v) => Number(v.toFixed(2)) + 0)} to ${[x2, y2].map((v) => Number(v.toFixed(2)) + 0)}`;
};
const notations = ['M5 5 L15 5 L15 15 Z', 'M5 5 l10 0 l0 10 z', 'm5 5 l10 0 l0 10 z', 'm5 5 L15 5 L15 15 Z', 'm5 5 H15 v10 z'];
for (const path of notations) {
  const moved = translatePath(path, 10, 0);
  console.log(`${path}: moved ${moved}, bounds ${bounds(moved)}, by svgpath ${bounds(svgpath(path).translate(10, 0).toString())}`);
  console.log(`  to the origin: ${bounds(resetPath(path))}, centred: ${bounds(centerPath(path))}`);
}
for (const length of [25, 35, 39]) {
  const cut = cutPath('M0 0 H10 V10 H0 Z', length);
  console.log(`square cut after ${length}: ${cut}, length ${getLength(cut)}`);
}
const tail = 'M0 0 H10 V10 Z L-5 5';
console.log(`${tail}: length ${getLength(tail).toFixed(2)}, reversed ${reversePath(tail)}, length ${getLength(reversePath(tail)).toFixed(2)}`);
JS
node check.cjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
M5 5 L15 5 L15 15 Z: moved M 15 5 L 25 5 L 25 15 Z, bounds 15,5 to 25,15, by svgpath 15,5 to 25,15
  to the origin: 0,0 to 10,10, centred: -5,-5 to 5,5
M5 5 l10 0 l0 10 z: moved M 15 5 l 10 0 l 0 10 Z, bounds 15,5 to 25,15, by svgpath 15,5 to 25,15
  to the origin: 0,0 to 10,10, centred: -5,-5 to 5,5
m5 5 l10 0 l0 10 z: moved m 5 5 l 10 0 l 0 10 Z, bounds 5,5 to 15,15, by svgpath 15,5 to 25,15
  to the origin: 5,5 to 15,15, centred: 5,5 to 15,15
m5 5 L15 5 L15 15 Z: moved m 5 5 L 25 5 L 25 15 Z, bounds 5,5 to 25,15, by svgpath 15,5 to 25,15
  to the origin: 5,0 to 10,10, centred: 5,-5 to 5,5
m5 5 H15 v10 z: moved m 5 5 H 25 v 10 Z, bounds 5,5 to 25,15, by svgpath 15,5 to 25,15
  to the origin: 5,5 to 10,15, centred: 5,5 to 5,15
square cut after 25: M 0 0 L 10 0 L 10 10 L 5 10, length 25
square cut after 35: M 0 0 L 10 0 L 10 10 L 0 10 Z, length 40
square cut after 39: M 0 0 L 10 0 L 10 10 L 0 10 Z, length 40
M0 0 H10 V10 Z L-5 5: length 41.21, reversed M -5 5 L 10 10 L 10 0 L 0 0, length 35.81
EXPECTED
