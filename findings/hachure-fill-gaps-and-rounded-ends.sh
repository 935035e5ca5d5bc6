#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, hachure-fill 0.5.2 (lines that fill a polygon, used by Rough.js).
# Input:    a triangle with the corners 0,0 10,0 5.4,9.6, also from its second corner, a turned hexagon of radius 10, the same
#           hexagon in inches, and a square from 0.5 to 20.5, with gaps between 1 and 2.5. Source: README of the package (lines
#           that fill a polygon; the gap "sets the distance between each hachure line").
# Expected: Both ends of each line lie on the outline. The distance of adjacent lines is the gap. The sum of the lengths times
#           the gap is about the area.
# Seen:     The gaps 1.5 and 2.5 are drawn as 3 and 5, so only half of the area is filled: the scan has steps of 1 and draws
#           only multiples of the gap. All X are rounded to whole numbers, so ends are up to 0.76 away from the outline. A
#           hexagon in inches has a single line of length 0 instead of 7. A polygon whose first X is 0 is not filled at all.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" hachure-fill@0.5.2 >/dev/null

cat >check.mjs <<'JS'
import { hachureLines } from 'hachure-fill';

const toSegment = ([x, y], [ax, ay], [bx, by]) => {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
};
const toOutline = (point, outline) =>
  Math.min(...outline.map((corner, i) => toSegment(point, corner, outline[(i + 1) % outline.length])));
const area = (outline) => Math.abs(outline.reduce((sum, [x, y], i) => {
  const [nx, ny] = outline[(i + 1) % outline.length];
  return sum + x * ny - nx * y;
}, 0)) / 2;
const ring = (count, radius, start) => [...Array(count).keys()].map((i) => start + 2 * Math.PI * i / count)
  .map((angle) => [radius * Math.cos(angle), radius * Math.sin(angle)]);
const shapes = {
  triangle: [[0, 0], [10, 0], [5.4, 9.6]],
  'triangle from 10,0': [[10, 0], [5.4, 9.6], [0, 0]],
  hexagon: ring(6, 10, 0.3),
  'hexagon in inches': ring(6, 10 / 25.4, 0.3),
  square: [[0.5, 0.5], [20.5, 0.5], [20.5, 20.5], [0.5, 20.5]],
};
const runs = [['square', 1, 0], ['square', 1.5, 0], ['square', 2.5, 0], ['triangle', 1, 0], ['triangle from 10,0', 1, 0],
  ['hexagon', 1, 0], ['hexagon', 1, 45],
  ['hexagon in inches', 0.1, 0]];
for (const [name, gap, degrees] of runs) {
  const outline = shapes[name];
  const lines = hachureLines(outline.map((corner) => [...corner]), gap, degrees);
  if (lines.length === 0) {
    console.log(`${name}, gap ${gap}: no lines`);
    continue;
  }
  const error = Math.max(...lines.flat().map((end) => toOutline(end, outline)));
  const angle = degrees * Math.PI / 180;
  const heights = lines.map(([[x, y]]) => x * Math.sin(angle) + y * Math.cos(angle)).sort((a, b) => a - b);
  const steps = new Set(heights.slice(1).map((height, i) => (height - heights[i]).toFixed(2)));
  const filled = gap * lines.reduce((sum, [[ax, ay], [bx, by]]) => sum + Math.hypot(bx - ax, by - ay), 0);
  console.log(`${name}, gap ${gap}, ${degrees} degrees: ${lines.length} lines, distances ${[...steps].join()}, ends off by ${
    error.toFixed(2)}, length by gap ${filled.toFixed(1)}, area ${area(outline).toFixed(1)}`);
}
JS
node check.mjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
square, gap 1, 0 degrees: 20 lines, distances 1.00, ends off by 0.50, length by gap 400.0, area 400.0
square, gap 1.5, 0 degrees: 7 lines, distances 3.00, ends off by 0.50, length by gap 210.0, area 400.0
square, gap 2.5, 0 degrees: 4 lines, distances 5.00, ends off by 0.50, length by gap 200.0, area 400.0
triangle, gap 1: no lines
triangle from 10,0, gap 1, 0 degrees: 10 lines, distances 1.00, ends off by 0.44, length by gap 54.0, area 48.0
hexagon, gap 1, 0 degrees: 20 lines, distances 1.00, ends off by 0.53, length by gap 265.0, area 259.8
hexagon, gap 1, 45 degrees: 18 lines, distances 1.00, ends off by 0.76, length by gap 258.0, area 259.8
hexagon in inches, gap 0.1, 0 degrees: 1 lines, distances , ends off by 0.03, length by gap 0.0, area 0.4
EXPECTED
