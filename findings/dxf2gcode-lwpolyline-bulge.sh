#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, dxf2gcode 20191025-2, python3-configobj 5.0.8-1. Install python3-pyqt5 and python3-opengl first.
# Input:    one contour of four vertices 0,0 10,0 10,6 0,6 with a half circle on the right (bulge 1 at the vertex 10,0),
#           closed, as LWPOLYLINE and as POLYLINE with VERTEX entities.
# Expected: Bulge belongs to the segment that starts at its vertex: the arc connects 10,0 and 10,6 and both
#           programs cut the same contour.
# Seen:     LWPOLYLINE has the arc one segment too early: between 0,0 and 10,0, with the radius 5. The right side is a
#           line. If the bulge is at the first vertex, the arc is missing and all sides are lines.
#           POLYLINE is right in both cases. The exit status is 0 and no message about the contour appears.
# Note:     The default drawing area (mode3d = False) stops with a TypeError, so the configuration has mode3d = True.

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
fetch dxf2gcode=20191025-2 python3-configobj=5.0.8-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages HOME=$work QT_QPA_PLATFORM=offscreen
/usr/bin/python3 root/usr/bin/dxf2gcode --help >log 2>&1 # writes the configuration
sed -i 's/mode3d = False/mode3d = True/' .config/dxf2gcode/config/config.cfg

cat >check.py <<'PY'
import re
import subprocess

corners = (0, 0), (10, 0), (10, 6), (0, 6)


def tags(*items):
    return "".join(f"{item}\n" for item in items)


def light(bulges, closed):
    vertices = [item for (x, y), b in zip(corners, bulges) for item in (10, x, 20, y, 42, b)]
    return tags(0, "LWPOLYLINE", 5, "A1", 8, 0, 90, 4, 70, closed, *vertices)


def heavy(bulges, closed):
    vertices = "".join(tags(0, "VERTEX", 5, f"B{b}", 8, 0, 10, x, 20, y, 30, 0, 42, b) for (x, y), b in zip(corners, bulges))
    return tags(0, "POLYLINE", 5, "A1", 8, 0, 66, 1, 70, closed) + vertices + tags(0, "SEQEND", 5, "C1", 8, 0)


def cut(name, entity):
    with open("in.dxf", "w") as dxf:
        dxf.write(tags(0, "SECTION", 2, "HEADER", 9, "$ACADVER", 1, "AC1015", 0, "ENDSEC", 0, "SECTION", 2, "ENTITIES"))
        dxf.write(entity + tags(0, "ENDSEC", 0, "EOF"))
    command = ["/usr/bin/python3", "root/usr/bin/dxf2gcode", "-q", "-e", "out.ngc", "in.dxf"]
    subprocess.run(command, check=True, capture_output=True)
    print(f"{name}:")
    here = None
    shape = open("out.ngc").read().split("SHAPE Nr")[1]
    moves = re.findall(r"^(G[0-3]) X *(\S+) Y *(\S+)", shape, re.M)[:-1]  # the last move goes to the end position
    count = 4 if "closed" in name else 3  # only the first pass in depth
    for code, x, y in moves[: count + 1]:
        there = f"{float(x):g},{float(y):g}"
        if here:
            print(f"  {'arc ' if code in ('G2', 'G3') else 'line'} {' - '.join(sorted((here, there)))}")
        here = there


for name, bulges in ("bulge at 10,0", (0, 1, 0, 0)), ("bulge at 0,0", (1, 0, 0, 0)):
    cut(f"LWPOLYLINE, closed, {name}", light(bulges, 1))
    cut(f"POLYLINE, closed, {name}", heavy(bulges, 1))
    cut(f"LWPOLYLINE, open, {name}", light(bulges, 0))
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
LWPOLYLINE, closed, bulge at 10,0:
  line 0,0 - 0,6
  line 0,6 - 10,6
  line 10,0 - 10,6
  arc  0,0 - 10,0
POLYLINE, closed, bulge at 10,0:
  line 0,0 - 0,6
  line 0,6 - 10,6
  arc  10,0 - 10,6
  line 0,0 - 10,0
LWPOLYLINE, open, bulge at 10,0:
  line 0,6 - 10,6
  line 10,0 - 10,6
  arc  0,0 - 10,0
LWPOLYLINE, closed, bulge at 0,0:
  line 0,0 - 0,6
  line 0,6 - 10,6
  line 10,0 - 10,6
  line 0,0 - 10,0
POLYLINE, closed, bulge at 0,0:
  line 0,0 - 0,6
  line 0,6 - 10,6
  line 10,0 - 10,6
  arc  0,0 - 10,0
LWPOLYLINE, open, bulge at 0,0:
  line 0,6 - 10,6
  line 10,0 - 10,6
  line 0,0 - 10,0
EXPECTED
