#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, dxf-writer 1.18.4 (writes DXF). The reader is Debian 12, python3-ezdxf 0.18.1-1.
# Input:    a 3D polyline that rises from z 0 to 20; a cylinder with the centre 10,20,30 along X; a square turned by 10 degrees
#           and a text turned by 10 degrees; a spline with four fit points. Source: DXF reference (POLYLINE, group 70: 8 is a 3D
#           polyline; CIRCLE: the centre is in the coordinate system of the object; SPLINE, group 74: number of fit points,
#           groups 11, 21, 31: fit points) and comments of the package ("Center x", "rotation angle (in Degrees) of the
#           polygon").
# Expected: The polyline is read with its heights. The centre of the cylinder is at 10,20,30. Polygon and text turn in the same
#           direction. The file contains as many fit points as group 74 states.
# Seen:     The 3D polyline has the flag of a 2D polyline, so ezdxf reads lines in the plane z 0. The centre of the cylinder is
#           written as it is and lies at 30,10,20. The polygon starts at the top and turns clockwise, to 80 degrees, the text
#           counter-clockwise. The spline states 4 fit points and contains none.

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
npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" dxf-writer@1.18.4 >/dev/null
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >write.cjs <<'JS'
const Drawing = require('dxf-writer');
const drawing = new Drawing();
drawing.drawPolyline3d([[0, 0, 0], [10, 0, 10], [10, 10, 20]]);
drawing.drawCylinder(10, 20, 30, 5, 40, 1, 0, 0);
drawing.drawPolygon(0, 0, 4, 10, 10);
drawing.drawText(0, 0, 5, 10, 'text');
drawing.drawSpline([[0, 0], [5, 10], [10, -10], [15, 0]], 3, null, null, [[0, 0], [4, 3], [11, -3], [15, 0]]);
require('fs').writeFileSync('drawing.dxf', drawing.toDxfString());
JS
node write.cjs

cat >read.py <<'PY'
import math

import ezdxf


def text(point):
    return ",".join("%.2f" % (round(value, 6) + 0) for value in tuple(point))


for entity in ezdxf.readfile("drawing.dxf").modelspace():
    kind = entity.dxftype()
    if kind == "POLYLINE":
        print("%s: mode %s, 3D: %s, points %s" % (kind, entity.get_mode(), entity.is_3d_polyline, " ".join(map(text, entity.points()))))
        print("  as lines: %s" % " ".join("%s-%s" % (text(line.dxf.start), text(line.dxf.end)) for line in entity.virtual_entities()))
    elif kind == "CIRCLE":
        print("%s: centre in the world %s, axis %s" % (kind, text(entity.ocs().to_wcs(entity.dxf.center)), text(entity.dxf.extrusion)))
    elif kind == "LWPOLYLINE":
        x, y = entity.get_points("xy")[0]
        print("%s: first corner at %.0f degrees, counter-clockwise" % (kind, math.degrees(math.atan2(y, x))))
    elif kind == "TEXT":
        print("%s: turned by %.0f degrees, counter-clockwise" % (kind, entity.dxf.rotation))
    elif kind == "SPLINE":
        print("%s: %d fit points read" % (kind, len(entity.fit_points)))
with open("drawing.dxf") as file:
    lines = file.read().split("\n")
start = lines.index("SPLINE")
groups = list(zip(lines[start - 1::2], lines[start::2]))
spline = groups[:next(i for i, group in enumerate(groups) if i and group[0] == "0")]
print("SPLINE in the file: group 74 is %s, %d groups 11" % (dict(spline)["74"], sum(code == "11" for code, _ in spline)))
PY
/usr/bin/python3 read.py 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
POLYLINE: mode AcDb2dPolyline, 3D: False, points 0.00,0.00,0.00 10.00,0.00,10.00 10.00,10.00,20.00
  as lines: 0.00,0.00,0.00-10.00,0.00,0.00 10.00,0.00,0.00-10.00,10.00,0.00
CIRCLE: centre in the world 30.00,10.00,20.00, axis 1.00,0.00,0.00
LWPOLYLINE: first corner at 80 degrees, counter-clockwise
TEXT: turned by 10 degrees, counter-clockwise
SPLINE: 0 fit points read
SPLINE in the file: group 74 is 4, 0 groups 11
EXPECTED
