#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, gdal-bin 3.6.2+dfsg-1+b2 (ogrinfo) and python3-ezdxf 0.18.1-1 (for comparison), both readers of DXF.
# Input:    SPLINE entities: clamped knots; degree 2 with the uniform knots 0 to 6; a closed curve of degree 3 with the
#           uniform knots -3 to 7, whose first three control points are repeated (flags 1, closed, and 2, periodic).
#           Source: DXF reference, SPLINE (40: knot value, one entry per knot; 70; 71; 72; 73); a B-spline of degree p with
#           n control points is defined from knot p to knot n.
# Expected: Uniform knots do not touch the end points: the curve of degree 2 goes from 2.5,5 to 12.5,5. The closed curve
#           starts and ends at 8.33,1.67 and stays within 0.42 to 9.58.
# Seen:     GDAL evaluates from the first to the last knot, outside of the definition, with weights that it divides by
#           their sum. Both curves get a tail at each end, to the first and the last control point: from 0,0 to 15,10
#           and from 0,0 to 10,10. The closed curve is open and crosses itself. No message appears. ezdxf gives the
#           expected points; clamped knots are right in both programs.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts Debian 12 packages into ./root, without installation: all that this machine has not installed.
fetch() {
  mkdir -p deb root
  apt-get install -s --no-install-recommends "$@" 2>log | sed -n 's/^Inst \([^ ]*\) .*(\([^ ]*\) .*/\1=\2/p' >list
  [ -s list ] || cat log >&2
  (cd deb && xargs apt-get download <../list >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch gdal-bin=3.6.2+dfsg-1+b2 python3-ezdxf=0.18.1-1
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH GDAL_DATA=$work/root/usr/share/gdal PYTHONPATH=$work/root/usr/lib/python3/dist-packages HOME=$work

cat >check.py <<'PY'
import re
import subprocess

import ezdxf


def write(name, degree, knots, points, flags):
    groups = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES"),
              (0, "SPLINE"), (5, "A1"), (100, "AcDbEntity"), (8, "0"), (100, "AcDbSpline"), (70, flags), (71, degree),
              (72, len(knots)), (73, len(points)), (74, 0)]
    groups += [(40, float(knot)) for knot in knots]
    for x, y in points:
        groups += [(10, float(x)), (20, float(y)), (30, 0.0)]
    groups += [(0, "ENDSEC"), (0, "EOF")]
    with open(name, "w") as file:
        file.write("".join(f"{code}\n{value}\n" for code, value in groups))


def show(name, points):
    (x0, y0), (x1, y1) = points[0], points[-1]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    print(f"  {name}: from {x0:.2f},{y0:.2f} to {x1:.2f},{y1:.2f}, "
          f"x {min(xs):.2f}..{max(xs):.2f}, y {min(ys):.2f}..{max(ys):.2f}")


square = [(0, 0), (10, 0), (10, 10), (0, 10)]
for label, degree, knots, points, flags in (
    ("clamped", 3, [0, 0, 0, 0, 1, 1, 1, 1], square, 8),
    ("uniform", 2, range(7), [(0, 0), (5, 10), (10, 0), (15, 10)], 8),
    ("closed", 3, range(-3, 8), square + square[:3], 11),
):
    print(f"{label}:")
    write("curve.dxf", degree, list(knots), points, flags)
    output = subprocess.run(["root/usr/bin/ogrinfo", "-al", "-q", "curve.dxf"], capture_output=True, text=True, check=True)
    text = re.search(r"LINESTRING[ Z]*\((.*)\)", output.stdout).group(1)
    show("GDAL", [tuple(float(v) for v in pair.split()[:2]) for pair in text.split(",")])
    curve = ezdxf.readfile("curve.dxf").modelspace()[0].construction_tool()
    show("ezdxf", [(p.x, p.y) for p in curve.approximate(200)])
    if output.stderr:
        print(output.stderr)
PY
/usr/bin/python3 -W ignore check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
clamped:
  GDAL: from 0.00,0.00 to 0.00,10.00, x 0.00..7.49, y 0.00..10.00
  ezdxf: from 0.00,0.00 to 0.00,10.00, x 0.00..7.50, y 0.00..10.00
uniform:
  GDAL: from 0.00,0.00 to 15.00,10.00, x 0.00..15.00, y 0.00..10.00
  ezdxf: from 2.50,5.00 to 12.50,5.00, x 2.50..12.50, y 2.50..7.50
closed:
  GDAL: from 0.00,0.00 to 10.00,10.00, x 0.00..10.00, y 0.00..10.00
  ezdxf: from 8.33,1.67 to 8.33,1.67, x 0.42..9.58, y 0.42..9.58
EXPECTED
