#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, svg-path-properties 1.3.0.
# Input:    a quarter circle as an arc (A) and as a cubic curve (C), a quarter ellipse, and a line that ends in an arc.
# Expected: getTangentAtLength is the direction of travel: the difference of getPointAtLength along the path.
# Seen:     The tangent of each arc points backwards, and it is 0.3 degrees off. At a smooth joint of a line and an arc,
#           the direction turns by 180 degrees: a tangential knife would turn around. Lines and curves are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  svg-path-properties@1.3.0 >/dev/null

cat >check.mjs <<'JS'
import { svgPathProperties } from 'svg-path-properties';
const degrees = (x, y) => ((Math.atan2(y, x) * 180) / Math.PI).toFixed(1);
const show = (name, text, length) => {
  const path = new svgPathProperties(text);
  const [before, after] = [path.getPointAtLength(length - 1e-4), path.getPointAtLength(length + 1e-4)];
  const tangent = path.getTangentAtLength(length);
  const travel = degrees(after.x - before.x, after.y - before.y);
  console.log(`${name}: travel ${travel}, tangent ${degrees(tangent.x, tangent.y)}`);
};
show('curve C, middle', 'M5 0C5 2.7614 2.7614 5 0 5', 3.9274);
show('circle, start', 'M5 0A5 5 0 0 1 0 5', 0.01);
show('circle, middle', 'M5 0A5 5 0 0 1 0 5', 3.927);
show('circle, other direction', 'M0 5A5 5 0 0 0 5 0', 3.927);
show('ellipse', 'M5 0A5 3 0 0 1 0 3', 3);
show('line before the joint', 'M0 0H10A5 5 0 0 1 15 5', 9.99);
show('arc after the joint', 'M0 0H10A5 5 0 0 1 15 5', 10.01);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
curve C, middle: travel 135.0, tangent 135.0
circle, start: travel 90.1, tangent -89.6
circle, middle: travel 135.0, tangent -44.7
circle, other direction: travel -45.0, tangent 134.7
ellipse: travel 146.6, tangent -33.1
line before the joint: travel 0.0, tangent 0.0
arc after the joint: travel 0.1, tangent -179.6
EXPECTED
