#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, python3-ezdxf 0.18.1-1 writes; npm, @jscad/dxf-deserializer 2.3.30 reads.
# Input:    ELLIPSE with the centre 10,0 and the half axes 4 and 2: major axis along X, along Y, and the half
#           ellipse from 0 to pi. LWPOLYLINE and POLYLINE of a 4 x 2 slot with one bulge of 1 (a half circle).
# Expected: The major axis along Y spans x 8..12, y -4..4. The half ellipse has y 0..2. Both polylines span x 0..5.
# Seen:     The ellipse is turned about the origin together with its centre: x -2..2, y 6..14.
#           The half ellipse is a complete ellipse. POLYLINE has no bulge (x 0..4); LWPOLYLINE is right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts pinned Debian 12 packages into ./root, without installation.
fetch() {
  mkdir -p deb root
  (cd deb && apt-get download "$@" >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch python3-ezdxf=0.18.1-1 python3-pyparsing=3.0.9-1 python3-typing-extensions=4.4.0-1
npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @jscad/dxf-deserializer@2.3.30 @jscad/modeling@2.13.0 >/dev/null
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >write.py <<'PY'
import math

import ezdxf

slot = [(0, 0, 0), (4, 0, 1), (4, 2, 0), (0, 2, 0)]
for name in ("ellipse-x", "ellipse-y", "ellipse-half", "lwpolyline", "polyline"):
    document = ezdxf.new("R2000")
    space = document.modelspace()
    if name == "ellipse-x":
        space.add_ellipse((10, 0), (4, 0), 0.5)
    elif name == "ellipse-y":
        space.add_ellipse((10, 0), (0, 4), 0.5)
    elif name == "ellipse-half":
        space.add_ellipse((10, 0), (4, 0), 0.5, 0, math.pi)
    elif name == "lwpolyline":
        space.add_lwpolyline(slot, format="xyb", close=True)
    else:
        space.add_polyline2d(slot, format="xyb", close=True)
    document.saveas(name + ".dxf")
PY
/usr/bin/python3 write.py
cat >read.js <<'JS'
const fs = require('fs');
const { deserialize } = require('@jscad/dxf-deserializer');
const { measureBoundingBox } = require('@jscad/modeling').measurements;
for (const name of ['ellipse-x', 'ellipse-y', 'ellipse-half', 'lwpolyline', 'polyline']) {
  const text = fs.readFileSync(`${name}.dxf`, 'utf8');
  const [shape] = [].concat(deserialize({ output: 'geometry', filename: name }, text));
  const [low, high] = measureBoundingBox(shape).map((p) => p.map((v) => Math.round(v) + 0));
  console.log(`${name}: x ${low[0]}..${high[0]} y ${low[1]}..${high[1]}`);
}
JS
node read.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
ellipse-x: x 6..14 y -2..2
ellipse-y: x -2..2 y 6..14
ellipse-half: x 6..14 y -2..2
lwpolyline: x 0..5 y 0..2
polyline: x 0..4 y 0..2
EXPECTED
