#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @jscad/openscad-openjscad-translator 0.0.11, @kaosat-dev/sylvester 0.0.21 (OpenSCAD programs to JSCAD).
# Input:    OpenSCAD programs of one line each. Source: OpenSCAD language reference (square(size): a number is the length of
#           both sides, with a corner at the origin; pow(2, 3) is 8; the product of a vector and a number; a range with a
#           negative step counts down; README of the package: written for OpenSCAD 2011.06, hull, minkowski and assign are
#           not implemented).
# Expected: square(2) has the centre 1,1 as square([2, 2]) has; pow(2, 3) is 8; [1, 2, 3] * 2 is [2, 4, 6]; the falling
#           range gives 3 cubes as the rising one. After an error, the next program is translated.
# Seen:     square(2) gets the centre NaN,NaN, with center = true the right one. pow is NaN, sqrt is right. The product of a
#           vector and a number is an error, a sum is right; after the error each later program of the process is the same
#           error, even cube(1). A falling range gives an empty program, and rotate_extrude too.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @jscad/openscad-openjscad-translator@0.0.11 @kaosat-dev/sylvester@0.0.21 >/dev/null

cat >check.js <<'JS'
const parser = require('@jscad/openscad-openjscad-translator');

console.warn = console.log = () => {};
const translate = (program) => {
  let text;
  try {
    text = parser.parse(program);
  } catch (error) {
    return `error: ${error.message.split('\n')[0]}`;
  }
  const centre = /center: \[([^\]]*)\],\s*radius/.exec(text);
  const moves = [...text.matchAll(/translate\(\[([^\]]*)\]\)/g)].map((match) => match[1]);
  if (moves.length > 0) return `moved by ${moves.join(' and ')}`;
  if (centre) return `centre ${centre[1]}`;
  return text.replace(/\s+/g, '') === 'functionmain(){};' ? 'empty program' : text.trim();
};
for (const program of [
  'square([2, 2]);', 'square(2, center = true);', 'square(2);',
  'translate([sqrt(16), 0, 0]) cube(1);', 'translate([pow(2, 3), 0, 0]) cube(1);',
  'for (i = [1:1:3]) translate([i, 0, 0]) cube(1);', 'for (i = [3:-1:1]) translate([i, 0, 0]) cube(1);',
  'rotate_extrude() translate([5, 0, 0]) square([1, 2]);',
  'cube(1);', 'translate([1, 2, 3] + [1, 1, 1]) cube(1);', 'translate([1, 2, 3] * 2) cube(1);', 'cube(1);',
]) {
  process.stdout.write(`${program} ${translate(program)}\n`);
}
JS
node check.js 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
square([2, 2]); centre 1,1
square(2, center = true); centre 0,0
square(2); centre NaN,NaN
translate([sqrt(16), 0, 0]) cube(1); moved by 4,0,0
translate([pow(2, 3), 0, 0]) cube(1); moved by NaN,0,0
for (i = [1:1:3]) translate([i, 0, 0]) cube(1); moved by 1,0,0 and 2,0,0 and 3,0,0
for (i = [3:-1:1]) translate([i, 0, 0]) cube(1); empty program
rotate_extrude() translate([5, 0, 0]) square([1, 2]); empty program
cube(1); centre 0.5,0.5,0.5
translate([1, 2, 3] + [1, 1, 1]) cube(1); moved by 2,3,4
translate([1, 2, 3] * 2) cube(1); error: Sylvester.$V is not a function
cube(1); error: Sylvester.$V is not a function
EXPECTED
