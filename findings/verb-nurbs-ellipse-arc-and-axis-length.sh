#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, verb-nurbs-web 2.1.3 (classes EllipseArc, Arc, RevolvedSurface and CylindricalSurface).
# Input:    arcs of an ellipse with the semi-axes 10 and 5; arcs of a circle of radius 5; a line of 10 at the distance 5,
#           revolved by 90 degrees about the axis 0,0,1 and the axis 0,0,2; a cylinder of height 10 and radius 5 with both
#           axes. Source: src/verb/geom, comments of the constructors ("minimum angle of the EllipseArc", "the direction of
#           the axis of revolution", "height of the cylinder").
# Expected: Each point of an arc is on the ellipse, so (x/10)^2 + (y/5)^2 is 1. The length of an axis has no effect.
# Seen:     Only arcs that start on an axis of the ellipse and have 90, 180 or 360 degrees are on the ellipse. From 45 to 135
#           degrees the value rises to 1.67, from 30 to 60 degrees it falls to 0.90. With the axis 0,0,2, the end of the
#           revolved line is 0,10,0 to 0,10,40 instead of 0,5,0 to 0,5,10, and the cylinder has the height 20. No error is
#           raised. Arcs of circles are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" verb-nurbs-web@2.1.3 >/dev/null

cat >check.cjs <<'JS'
const { geom } = require('verb-nurbs-web');
const degree = Math.PI / 180;
const text = (point) => point.map((v) => (Math.round(v * 100) / 100 + 0).toFixed(2)).join(',');
for (const [start, end] of [[0, 90], [0, 180], [0, 360], [30, 60], [45, 135], [0, 120], [45, 225]]) {
  const arc = new geom.EllipseArc([0, 0, 0], [10, 0, 0], [0, 5, 0], start * degree, end * degree);
  const values = [];
  for (let i = 0; i <= 100; i++) values.push(Math.hypot(arc.point(i / 100)[0] / 10, arc.point(i / 100)[1] / 5) ** 2);
  console.log(`ellipse ${start}..${end}: ${Math.min(...values).toFixed(2)} to ${Math.max(...values).toFixed(2)}`);
}
for (const [start, end] of [[0, 90], [-90, 90], [270, 450]]) {
  const arc = new geom.Arc([0, 0, 0], [1, 0, 0], [0, 1, 0], 5, start * degree, end * degree);
  console.log(`circle ${start}..${end}: length ${arc.length().toFixed(2)}, from ${text(arc.point(0))} to ${text(arc.point(1))}`);
}
for (const length of [1, 2]) {
  const line = new geom.Line([5, 0, 0], [5, 0, 10]);
  const turned = new geom.RevolvedSurface(line, [0, 0, 0], [0, 0, length], Math.PI / 2);
  const cylinder = new geom.CylindricalSurface([0, 0, length], [1, 0, 0], [0, 0, 0], 10, 5);
  console.log(`axis of length ${length}: line from ${text(turned.point(0, 0))} ${text(turned.point(0, 1))} ` +
    `to ${text(turned.point(1, 0))} ${text(turned.point(1, 1))}, cylinder from ${text(cylinder.point(1, 0))} ` +
    `to ${text(cylinder.point(0, 0))}`);
}
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
verb 2.1.0
ellipse 0..90: 1.00 to 1.00
ellipse 0..180: 1.00 to 1.00
ellipse 0..360: 1.00 to 1.00
ellipse 30..60: 0.90 to 1.00
ellipse 45..135: 1.00 to 1.67
ellipse 0..120: 0.86 to 1.29
ellipse 45..225: 0.73 to 1.67
circle 0..90: length 7.85, from 5.00,0.00,0.00 to 0.00,5.00,0.00
circle -90..90: length 15.71, from 0.00,-5.00,0.00 to 0.00,5.00,0.00
circle 270..450: length 15.71, from 0.00,-5.00,0.00 to 0.00,5.00,0.00
axis of length 1: line from 5.00,0.00,0.00 5.00,0.00,10.00 to 0.00,5.00,0.00 0.00,5.00,10.00, cylinder from 5.00,0.00,0.00 to 5.00,0.00,10.00
axis of length 2: line from 5.00,0.00,0.00 5.00,0.00,10.00 to 0.00,10.00,0.00 0.00,10.00,40.00, cylinder from 5.00,0.00,0.00 to 5.00,0.00,20.00
EXPECTED
