#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @jscad/modeling 2.13.0 (expansions.offset of a 2D region).
# Input:    two squares of 10 x 10, joined by a neck of width 4 and length 10; offset inwards.
# Expected: By 1: one region with the area 152. By 3: the neck vanishes, two separate regions remain,
#           each with an area of about 16 (32 in total). A square of 10 x 10 by 6: empty.
# Seen:     By 1: right. By 3: one outline that crosses itself at the neck, signed area 0.001.
#           Square by 6: a square of 2 x 2 with the area +4, because both directions turn over.
#           No error is raised, and the result is a valid input for an extrusion.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" @jscad/modeling@2.13.0 >/dev/null

cat >check.js <<'JS'
const { primitives, booleans, measurements, expansions, geometries } = require('@jscad/modeling');
const box = (w, h, x) => primitives.rectangle({ size: [w, h], center: [x, 0] });
const neck = booleans.union(box(10, 10, -10), box(10, 10, 10), box(12, 4, 0));
function show(name, region, delta) {
  const result = expansions.offset({ delta, corners: 'edge' }, region);
  const outlines = geometries.geom2.toOutlines(result).length;
  console.log(`${name} ${delta}: ${outlines} outline, area ${measurements.measureArea(result).toFixed(2)}`);
}
show('two squares with neck', neck, -1);
show('two squares with neck', neck, -3);
show('square', box(10, 10, 0), -1);
show('square', box(10, 10, 0), -6);
JS
node check.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
two squares with neck -1: 1 outline, area 152.00
two squares with neck -3: 1 outline, area 0.00
square -1: 1 outline, area 64.00
square -6: 1 outline, area 4.00
EXPECTED
