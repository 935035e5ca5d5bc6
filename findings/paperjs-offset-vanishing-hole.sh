#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, paperjs-offset 2.2.1, paper 0.12.18 (function offset, joins miter and round).
# Input:    a square of 200 with a hole, as a compound path: a square hole of 40, a hole of 40 x 20, a round hole of radius 20;
#           outward offsets smaller and larger than half the width of the hole; inward offsets of 30, 39 and 41. Source:
#           README ("offset expands or contracts a path", join "miter").
# Expected: A hole of 40 has the width 2 for the offset 19 and vanishes for offsets above 20, a hole of 40 x 20 above 10. The
#           inward offset with mitred corners makes the hole 100, 118 and 122 wide; the outer side is 140, 122
#           and 118. So the areas are 9600 and 960, and the last result is empty.
# Seen:     A hole with corners does not vanish: the offset 21 leaves a hole of the area 437, the offset 25 one of 525, and
#           50 one of 200, with both joins. The round hole vanishes. Inwards, the mitred corners of the hole are
#           round for 39 and 41, not for 30: the area is 2264 instead of 960, and four pieces of 234 each remain instead of
#           an empty result. No error is raised; only the separate function analyze warns about the first case.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" paperjs-offset@2.2.1 paper@0.12.18 >/dev/null

cat >check.cjs <<'JS'
const paper = require('paper');
const { analyze, offset } = require('paperjs-offset');
paper.setup(new paper.Size(400, 400));
const outer = 'M0,0L200,0L200,200L0,200Z';
const holes = {
  'hole 40 x 40': new paper.CompoundPath(`${outer}M80,80L80,120L120,120L120,80Z`),
  'hole 40 x 20': new paper.CompoundPath(`${outer}M80,80L80,100L120,100L120,80Z`),
  'round hole': new paper.CompoundPath(`${outer}M80,100A20,20,0,0,0,120,100A20,20,0,0,0,80,100Z`),
};
const show = (name, distance, join) => {
  const result = offset(holes[name], distance, { join, insert: false });
  const parts = (result.children || [result]).map((path) => Math.round(path.area) + 0).join(' ');
  const warnings = analyze(holes[name], result, distance, { join }).warnings.join(' ') || 'none';
  console.log(`${name}, ${join} ${distance}: parts ${parts}, total ${Math.round(result.area)}, warnings of analyze: ${warnings}`);
};
for (const join of ['miter', 'round']) for (const distance of [19, 21, 25, 50]) show('hole 40 x 40', distance, join);
for (const distance of [9, 12, 14]) show('hole 40 x 20', distance, 'miter');
for (const distance of [19, 21, 25, 50]) show('round hole', distance, 'miter');
for (const distance of [-30, -39, -41]) show('hole 40 x 40', distance, 'miter');
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
hole 40 x 40, miter 19: parts 56644 -4, total 56640, warnings of analyze: none
hole 40 x 40, miter 21: parts 58564 -437, total 58127, warnings of analyze: offset-distance-collapse
hole 40 x 40, miter 25: parts 62500 -525, total 61975, warnings of analyze: offset-distance-collapse
hole 40 x 40, miter 50: parts 90000 -200, total 89800, warnings of analyze: offset-distance-collapse
hole 40 x 40, round 19: parts 56334 -4, total 56330, warnings of analyze: none
hole 40 x 40, round 21: parts 58186 -437, total 57749, warnings of analyze: offset-distance-collapse
hole 40 x 40, round 25: parts 61964 -525, total 61439, warnings of analyze: offset-distance-collapse
hole 40 x 40, round 50: parts 87856 -200, total 87656, warnings of analyze: offset-distance-collapse
hole 40 x 20, miter 9: parts 47524 -44, total 47480, warnings of analyze: none
hole 40 x 20, miter 12: parts 50176 -136, total 50040, warnings of analyze: offset-distance-collapse
hole 40 x 20, miter 14: parts 51984 -194, total 51790, warnings of analyze: offset-distance-collapse
round hole, miter 19: parts 56644 -3, total 56641, warnings of analyze: none
round hole, miter 21: parts 58564, total 58564, warnings of analyze: none
round hole, miter 25: parts 62500, total 62500, warnings of analyze: none
round hole, miter 50: parts 90000, total 90000, warnings of analyze: none
hole 40 x 40, miter -30: parts 19600 -10000, total 9600, warnings of analyze: none
hole 40 x 40, miter -39: parts 14884 -12620, total 2264, warnings of analyze: none
hole 40 x 40, miter -41: parts 234 234 234 234, total 938, warnings of analyze: none
EXPECTED
