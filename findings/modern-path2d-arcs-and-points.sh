#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, modern-path2d 1.6.0 (paths for canvas and SVG: transforms, lengths, export as SVG data).
# Input:    arcs of 270 degrees as SVG data, a full circle, a quarter of an ellipse, a rectangle of 10 x 6 with the corner radius 2,
#           a half circle that is scaled, a polyline 0,0 10,0 10,5. Source: README ("Compatible Web Path2D", "export SVG path data");
#           HTML standard, CanvasPath: ellipse is clockwise unless counterclockwise is true; SVG 2, elliptical arc commands.
# Expected: toData returns the same path: 270 degrees remain. The circle of radius 5 has the length 31.4; the quarter of the ellipse
#           6.38. The rounded rectangle has the length 28.57 and ten points in its data. The scaled half circle has
#           double length and starts at 0,0. The middle of the polyline is 7.5,0.
# Seen:     toData always writes the large-arc flag 0: 270 degrees become 90. A full circle has the length 0. ellipse goes
#           counter-clockwise by default: 19.14. The rounded rectangle becomes a circle of radius 2 in its middle, with the length
#           12.57. scale moves the ends of an arc and keeps its radius; the length of the scaled polyline stays 15. The points
#           at 0.25 and 0.5 of the polyline are its start.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  modern-path2d@1.6.0 >/dev/null

cat >check.mjs <<'JS'
import { Path2D } from 'modern-path2d';
const number = (x) => Math.round(x * 100) / 100 + 0;
const data = (path) => path.toData().replace(/-?[\d.]+(e-?\d+)?/g, (x) => String(number(x)));
const at = (path, t) => { const p = path.getPoint(t); return `${number(p.x)},${number(p.y)}`; };
const draw = (task) => { const path = new Path2D(); task(path); return path; };

for (const text of ['M0 0A5 5 0 1 1 5 5', 'M0 0A5 5 0 1 0 5 5', 'M0 0A5 5 0 0 1 5 5']) {
  const path = new Path2D(text);
  const copy = new Path2D(path.toData());
  console.log(`${text}: length ${number(path.getLength())}, written ${data(path)}, length ${number(copy.getLength())}`);
}
const circle = draw((path) => path.arc(5, 5, 5, 0, 2 * Math.PI));
console.log(`circle: length ${number(circle.getLength())}, written ${data(circle)}`);
for (const flag of [undefined, false, true]) {
  const quarter = draw((path) => path.ellipse(5, 5, 5, 3, 0, 0, Math.PI / 2, flag));
  const round = draw((path) => path.arc(5, 5, 5, 0, Math.PI / 2, flag));
  console.log(`counterclockwise ${flag}: arc ${number(round.getLength())}, ellipse ${number(quarter.getLength())}, ${data(quarter)}`);
}
for (const [name, path] of [['rectangle', draw((p) => p.rect(0, 0, 10, 6))], ['rounded', draw((p) => p.roundRect(0, 0, 10, 6, 2))]]) {
  const box = path.getBoundingBox();
  console.log(`${name}: length ${number(path.getLength())}, box ${box.width} x ${box.height}, written ${data(path)}`);
}
for (const text of ['M0 0L10 0L10 5', 'M0 0A5 5 0 0 1 10 0']) {
  const path = new Path2D(text);
  const before = path.getLength();
  path.scale(2, 2);
  console.log(`${text}, scaled by 2: ${data(path)}, length ${number(before)} to ${number(path.getLength())}`);
}
const polyline = new Path2D('M0 0L10 0L10 5');
console.log(`polyline of length ${number(polyline.getLength())}: ${[0, 0.25, 0.5, 0.75, 1].map((t) => at(polyline, t)).join(' ')}`);
const line = new Path2D('M0 0L10 0');
console.log(`line: ${[0, 0.25, 0.5, 0.75, 1].map((t) => at(line, t)).join(' ')}`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
M0 0A5 5 0 1 1 5 5: length 23.56, written M 0 0 A 5 5 0 0 1 5 5, length 7.85
M0 0A5 5 0 1 0 5 5: length 23.56, written M 0 0 A 5 5 0 0 0 5 5, length 7.85
M0 0A5 5 0 0 1 5 5: length 7.85, written M 0 0 A 5 5 0 0 1 5 5, length 7.85
circle: length 0, written M 10 5 A 5 5 0 0 1 0 5 A 5 5 0 0 1 10 5
counterclockwise undefined: arc 7.85, ellipse 19.14, M 10 5 A 5 3 0 0 0 5 8
counterclockwise false: arc 7.85, ellipse 6.38, M 10 5 A 5 3 0 0 1 5 8
counterclockwise true: arc 23.56, ellipse 19.14, M 10 5 A 5 3 0 0 0 5 8
rectangle: length 32, box 10 x 6, written M 0 0 L 10 0 L 10 6 L 0 6 L 0 0
rounded: length 12.57, box 10 x 6, written M 7 3 A 2 2 0 0 0 3 3 A 2 2 0 0 0 7 3
M0 0L10 0L10 5, scaled by 2: M 0 0 L 20 0 L 20 10, length 15 to 15
M0 0A5 5 0 0 1 10 0, scaled by 2: M 5 0 A 5 5 0 0 1 15 0, length 15.71 to 15.71
polyline of length 15: 0,0 0,0 0,0 3.75,0 10,5
line: 0,0 2.5,0 5,0 7.5,0 10,0
EXPECTED
