#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, python3-ezdxf 0.18.1-1 writes; npm, dxf 5.3.1 reads (Helper.toPolylines).
# Input:    entities with extrusion 0,0,-1. The DXF reference stores ARC and LWPOLYLINE in object coordinates (x is
#           mirrored), and ELLIPSE in world coordinates (x is not mirrored; the curve runs clockwise).
# Expected: dxf agrees with ezdxf: LWPOLYLINE 0,0 -> -10,0; ELLIPSE 10,0 -> 0,-5; ARC -35,0 -> -30,5.
# Seen:     ARC is right. ELLIPSE and LWPOLYLINE are interchanged: dxf mirrors the ELLIPSE (-10,0 -> 0,5) and does not
#           mirror the LWPOLYLINE (0,0 -> 10,0). No message appears.

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
npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" dxf@5.3.1 >/dev/null
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >write.py <<'PY'
import math

import ezdxf
from ezdxf import path

document = ezdxf.new("R2000")
space = document.modelspace()
below = {"extrusion": (0, 0, -1)}
space.add_arc((30, 0), 5, 0, 90, dxfattribs=below)
space.add_ellipse((0, 0, 0), (10, 0, 0), 0.5, 0, math.pi / 2, dxfattribs=below)
space.add_lwpolyline([(0, 0, 1), (10, 0, 0)], format="xyb", dxfattribs=below)
document.saveas("below.dxf")
for entity in space:
    curve = path.make_path(entity)
    ends = [round(v) + 0 for p in (curve.start, curve.end) for v in (p.x, p.y)]
    print(entity.dxftype(), "%d,%d -> %d,%d" % tuple(ends))
PY
cat >read.js <<'JS'
const fs = require('fs');
const { Helper } = require('dxf');
const helper = new Helper(fs.readFileSync('below.dxf', 'utf8'));
const types = helper.denormalised.map((entity) => entity.type);
helper.toPolylines().polylines.forEach((line, i) => {
  const ends = [line.vertices[0], line.vertices[line.vertices.length - 1]];
  console.log(types[i], ends.map((p) => p.map((v) => Math.round(v) + 0).join()).join(' -> '));
});
JS
{
  echo 'ezdxf:'
  /usr/bin/python3 write.py
  echo 'dxf:'
  node read.js
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
ezdxf:
ARC -35,0 -> -30,5
ELLIPSE 10,0 -> 0,-5
LWPOLYLINE 0,0 -> -10,0
dxf:
ARC -35,0 -> -30,5
ELLIPSE -10,0 -> 0,5
LWPOLYLINE 0,0 -> 10,0
EXPECTED
