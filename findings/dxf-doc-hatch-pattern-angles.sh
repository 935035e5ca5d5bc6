#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, dxf-doc 0.1.6 (writes DXF). The reader is Debian 12, python3-ezdxf 0.18.1-1, which has its own table of
#           patterns.
# Input:    the patterns ANSI31, NET and NET3 of the hatches of AutoCAD, in the text form of files .pat, with the distance
#           3.175; a square as the boundary. Source: README of the package (HatchPattern.parse reads acad.pat); DXF reference
#           (HATCH: groups 43 to 46 are base point and offset of a pattern line in the coordinates of the drawing; in a file
#           .pat, they are along and across the line).
# Expected: The parallel lines of each family are 3.175 apart in the file, 3.17 or 3.18 as printed, as in the hatches that ezdxf
#           writes with the same names.
# Seen:     Only lines at 0 degrees are right, because the offsets are copied without the angle. ANSI31 has lines 2.25 apart,
#           NET3 half of the distance. The vertical lines of NET have the distance 0: all lie on one line. ezdxf writes the same
#           distance for each angle.

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
npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" dxf-doc@0.1.6 >/dev/null
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >write.cjs <<'JS'
const fs = require('fs');
const { DxfDocument } = require('dxf-doc');
const { Hatch } = require('dxf-doc/entities');
const { HatchPattern, PolylineBoundaryPath } = require('dxf-doc/entities/hatch');
const pattern = `*ANSI31,lines at 45 degrees
45, 0,0, 0,3.175
*NET,horizontal and vertical lines
0, 0,0, 0,3.175
90, 0,0, 0,3.175
*NET3,lines at 0, 60 and 120 degrees
0, 0,0, 0,3.175
60, 0,0, 0,3.175
120, 0,0, 0,3.175`;
const square = [[0, 0], [20, 0], [20, 20], [0, 20]];
const drawing = new DxfDocument();
for (const entry of HatchPattern.parse(pattern.split('\n')))
  drawing.addEntity(new Hatch(drawing, [new PolylineBoundaryPath(square)], entry));
fs.writeFileSync('drawing.dxf', drawing.dxf());
JS
node write.cjs

cat >read.py <<'PY'
import math

import ezdxf


def show(source, hatch):
    for line in hatch.pattern.lines:
        angle, offset = math.radians(line.angle), line.offset
        across = abs(offset[1] * math.cos(angle) - offset[0] * math.sin(angle))
        print("%s, %s: lines at %.0f degrees, %.2f apart" % (source, hatch.dxf.pattern_name, line.angle, across + 0))


for entity in ezdxf.readfile("drawing.dxf").modelspace():
    show("dxf-doc", entity)
space = ezdxf.new("R2007", units=4).modelspace()
for name in ["ANSI31", "NET", "NET3"]:
    hatch = space.add_hatch()
    hatch.set_pattern_fill(name)
    show("ezdxf", hatch)
PY
/usr/bin/python3 read.py 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
dxf-doc, ANSI31: lines at 45 degrees, 2.25 apart
dxf-doc, NET: lines at 0 degrees, 3.17 apart
dxf-doc, NET: lines at 90 degrees, 0.00 apart
dxf-doc, NET3: lines at 0 degrees, 3.17 apart
dxf-doc, NET3: lines at 60 degrees, 1.59 apart
dxf-doc, NET3: lines at 120 degrees, 1.59 apart
ezdxf, ANSI31: lines at 45 degrees, 3.18 apart
ezdxf, NET: lines at 0 degrees, 3.17 apart
ezdxf, NET: lines at 90 degrees, 3.17 apart
ezdxf, NET3: lines at 0 degrees, 3.17 apart
ezdxf, NET3: lines at 60 degrees, 3.17 apart
ezdxf, NET3: lines at 120 degrees, 3.17 apart
EXPECTED
