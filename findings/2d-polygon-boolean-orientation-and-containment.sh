#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, 2d-polygon-boolean 1.0.1 (Boolean operations of polygons).
# Input:    a square of 10 and a second square: across its corner, in both orientations; inside; around it; apart; adjacent to
#           its side. Source: README (the mode is "and" (intersect), "or" (union), "not" (cut), "arbitrary polygons"; no
#           rule for the orientation); geometry.
# Expected: Across the corner: intersection 25, union 175, difference 75, for each orientation of the polygons. A square
#           minus a square around it is empty, and so is the intersection of squares that are apart. Adjacent squares have the
#           union 200.
# Seen:     If the orientations of the two squares differ, the intersection is 75, the union 75 and the difference 25 or 175. The
#           square minus the square around it is 100 with a hole of 16: the operands are swapped. Apart, the intersection is
#           the error "woops", and the difference contains the second square. Adjacent squares are an error for "and" and "or".

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" 2d-polygon-boolean@1.0.1 >/dev/null

cat >check.js <<'JS'
const combine = require('2d-polygon-boolean');

const square = (x, y, size) => [[x, y], [x + size, y], [x + size, y + size], [x, y + size]];
const area = (points) => points.reduce((sum, [x, y], i) => {
  const [u, v] = points[(i + 1) % points.length];
  return sum + (x * v - u * y) / 2;
}, 0);
const pairs = {
  'across, same orientation': [square(0, 0, 10), square(5, 5, 10)],
  'across, second reversed': [square(0, 0, 10), square(5, 5, 10).reverse()],
  'across, first reversed': [square(0, 0, 10).reverse(), square(5, 5, 10)],
  'second inside': [square(0, 0, 10), square(3, 3, 4)],
  'second around': [square(3, 3, 4), square(0, 0, 10)],
  apart: [square(0, 0, 10), square(20, 0, 10)],
  adjacent: [square(0, 0, 10), square(10, 0, 10)],
};
for (const [name, [first, second]] of Object.entries(pairs)) {
  const results = ['and', 'or', 'not'].map((mode) => {
    try {
      return `${mode} ${combine(first.map((p) => [...p]), second.map((p) => [...p]), mode).map(area).join(' and ')}`;
    } catch (error) {
      return `${mode} error`;
    }
  });
  console.log(`${name}: ${results.join(', ')}`);
}
JS
node check.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
across, same orientation: and 25, or -175, not -75
across, second reversed: and -75, or -75, not 25
across, first reversed: and 75, or 75, not 175
second inside: and 16, or 100, not 100 and -16
second around: and 16, or 100, not 100 and -16
apart: and error, or 100 and 100, not 100 and 100
adjacent: and error, or error, not -100 and -100
EXPECTED
