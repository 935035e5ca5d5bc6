#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, gcanvas 0.0.37 (Canvas API that writes G-code).
# Input:    programs of a few calls: lines with ctx.feed = 100; a stroke of depth 2 and peckDrill to depth 5; arcs and
#           fillets; the thread mill example of readme.md. Source: readme.md ("Properties", "Methods"), Canvas 2D for
#           arc and arcTo.
# Expected: G93 means that F is 1 / minutes: 100 mm/min for 10 mm is F10, for 50 mm F2. Strokes and holes go to the
#           same side of Z 0. arc(0, 0, 5, 0, pi/2) is the short quarter. An arcTo with radius 2 at a corner has this
#           radius. A mirrored arc is a mirror image. The example cuts a thread.
# Seen:     F is length times feed: F1000 for 10 mm, that is 10000 mm/min. The stroke is at Z-2, and the drill cycle
#           feeds upwards to Z5 after a rapid to Z-1. Each arc has the reverse direction: three quarters instead of
#           one. At an obtuse corner, the radius is 10.66. The mirrored arc keeps G2. The thread mill has no motion
#           and no error.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  gcanvas@0.0.37 >/dev/null

cat >check.cjs <<'JS'
const GCanvas = require('gcanvas');
const show = (name, draw) => {
  const blocks = [];
  const ctx = new GCanvas(new GCanvas.GcodeDriver({ write: (block) => blocks.push(block.trim()) }));
  ctx.toolDiameter = 2;
  draw(ctx);
  console.log(`${name}: ${blocks.filter((b) => !/^G90|tooldiameter/.test(b)).join(' | ')}`);
};
show('feed', (ctx) => { ctx.feed = 100; ctx.moveTo(0, 0); ctx.lineTo(10, 0); ctx.lineTo(10, 50); ctx.stroke(); });
show('stroke of depth 2', (ctx) => { ctx.depth = 2; ctx.moveTo(0, 0); ctx.lineTo(5, 0); ctx.stroke(); });
show('peckDrill of depth 5', (ctx) => ctx.peckDrill(10, 20, 5, 2));
show('quarter arc', (ctx) => { ctx.arc(0, 0, 5, 0, Math.PI / 2, false); ctx.stroke(); });
show('fillet of a square corner', (ctx) => { ctx.moveTo(0, 0); ctx.arcTo(10, 0, 10, 10, 2); ctx.stroke(); });
show('fillet of an obtuse corner', (ctx) => { ctx.moveTo(0, 0); ctx.arcTo(10, 0, 20, 5, 2); ctx.stroke(); });
show('mirrored quarter arc', (ctx) => { ctx.scale(-1, 1); ctx.arc(0, 0, 5, 0, Math.PI / 2, false); ctx.stroke(); });
show('thread mill M8', (ctx) => {
  const dmin = 8 - ((2 * 5) / 8) * (Math.sqrt(3) / 2) * 1.25;
  ctx.toolDiameter = (1 / 4) * 25.4;
  ctx.threadMill(0, 0, 'inner', dmin - 0.1, 8, 1.25, 0, 10);
});
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
feed: G93 | G1 X10 Y0 Z0 F1000 | G1 X10 Y50 Z0 F5000
stroke of depth 2: G1 Z-2 | G1 X5 Y0 Z-2 | G0 Z0
peckDrill of depth 5: G0 X10 Y20 | G0 Z-1 | G1 Z2 | G0 Z0 | G0 Z1 | G1 Z4 | G0 Z0 | G0 Z3 | G1 Z5 | G0 Z0
quarter arc: G0 X5 Y0 | G2 X0 Y5 Z0 I-5 J0
fillet of a square corner: G1 X8 Y0 Z0 | G2 X10 Y2 Z0 I0 J2
fillet of an obtuse corner: G1 X1.52786 Y0 Z0 | G2 X17.57771 Y3.78885 Z0 I6.47214 J8.47214
mirrored quarter arc: G0 X-5 Y0 | G2 X0 Y5 Z0 I5 J0
thread mill M8: G28.3 A0
EXPECTED
