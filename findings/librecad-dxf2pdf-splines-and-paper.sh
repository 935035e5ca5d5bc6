#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, librecad 2.2.0-1 (command dxf2pdf).
# Input:    DXF files with one SPLINE each: degree 2, 3 and 4, clamped and uniform knots, weights 1 3 3 1; a RAY from 50,50 along X;
#           an INSERT at -100,50 with the extrusion 0,0,-1. Output at the scale 1 with the paper sizes 100 x 50 and 420 x 297.
#           Source: DXF reference (SPLINE, RAY: "Unit direction vector", INSERT), help of dxf2pdf ("-p: Paper size").
# Expected: The curves of degree 2 and 4 are drawn from their first to their last point. With the weights 1 3 3 1, the curve reaches
#           Y 86, without weights 80. The uniform cubic goes from 57,83 to 97,57. A ray reaches the edge of the paper. The
#           mirrored INSERT goes from 100,50 to 70,50. The page is 100 x 50 or 420 x 297 mm.
# Seen:     Of the curve of degree 2, a point remains, of the degree 4, nothing. Weights are ignored: Y 80. The uniform cubic has tails:
#           it starts at 0,0 and ends at 130,50. The ray is 1 mm long. The INSERT goes from -100,50 to -70,50, outside
#           the page. Each page is A4. The exit status is 0 and no message appears.

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
fetch librecad=2.2.0-1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries QT_PLUGIN_PATH=$libraries/qt5/plugins QT_QPA_PLATFORM=offscreen HOME=$work XDG_RUNTIME_DIR=$work

cat >check.py <<'PY'
import re
import subprocess
import zlib


def tags(*items):
    return "".join(f"{item}\n" for item in items)


def section(name, content):
    return tags(0, "SECTION", 2, name) + content + tags(0, "ENDSEC")


layer = tags(0, "TABLE", 2, "LAYER", 70, 1, 0, "LAYER", 2, 0, 70, 0, 62, 7, 6, "CONTINUOUS", 0, "ENDTAB")


def show(name, entity, block="", paper="420x297"):
    header = section("HEADER", tags(9, "$ACADVER", 1, "AC1015", 9, "$INSUNITS", 70, 4)) + section("TABLES", layer)
    with open("in.dxf", "w") as dxf:
        dxf.write(header + section("BLOCKS", block) + section("ENTITIES", entity) + tags(0, "EOF"))
    subprocess.run(["root/usr/bin/librecad", "dxf2pdf", "-p", paper, "-s", "1", "in.dxf"], check=True, capture_output=True)
    pdf = open("in.pdf", "rb").read()
    page = [float(x) * 25.4 / 72 for x in re.search(rb"/MediaBox \[([^\]]*)\]", pdf).group(1).split()[2:]]
    points = []
    for stream in re.findall(rb"stream\r?\n(.*?)\r?\nendstream", pdf, re.S):
        text = zlib.decompress(stream) if stream[:1] == b"\x78" else b""
        scale = re.search(rb"([\d.]+) 0 0 -\S+ 0 (\d+) cm\n", text)
        if scale:
            drawn = re.findall(rb"(?m)^(-?[\d.]+) (-?[\d.]+) [ml]$", text)[5:]
            points += [(float(x) * float(scale[1]) * 25.4 / 72, (float(scale[2]) - float(y) * float(scale[1])) * 25.4 / 72)
                       for x, y in drawn]
    ends = [f"{x:.0f},{y:.0f}" for x, y in points[:1] + points[-1:]]
    height = f", highest Y {max(y for _, y in points):.0f}" if points else ""
    print(f"{name}: page {page[0]:.0f} x {page[1]:.0f}, from {' to '.join(ends) or 'nothing'}{height}")


def spline(degree, knots, points, weights=()):
    content = [0, "SPLINE", 8, 0, 70, 12 if weights else 8, 71, degree, 72, len(knots), 73, len(points)]
    for code, values in ((40, knots), (41, weights)):
        for value in values:
            content += [code, value]
    for x, y in points:
        content += [10, x, 20, y, 30, 0]
    return tags(*content)


points = [(50, 50), (50, 90), (90, 90), (90, 50), (130, 50)]
for degree in (1, 2, 3, 4):
    show(f"degree {degree}", spline(degree, [0] * (degree + 1) + [1] * (degree + 1), points[:degree + 1]))
show("degree 3, weights 1 3 3 1", spline(3, [0] * 4 + [1] * 4, points[:4], (1, 3, 3, 1)))
show("degree 3, uniform knots", spline(3, range(9), points))
show("RAY", tags(0, "RAY", 8, 0, 10, 50, 20, 50, 30, 0, 11, 1, 21, 0, 31, 0))
block = tags(0, "BLOCK", 8, 0, 2, "B", 70, 0, 10, 0, 20, 0, 30, 0, 0, "LINE", 8, 0, 10, 0, 20, 0, 30, 0, 11, 30, 21, 0, 31, 0,
             0, "ENDBLK", 8, 0)
show("INSERT", tags(0, "INSERT", 8, 0, 2, "B", 10, -100, 20, 50, 30, 0, 210, 0, 220, 0, 230, -1), block)
show("paper 100 x 50", tags(0, "LINE", 8, 0, 10, 10, 20, 10, 30, 0, 11, 60, 21, 10, 31, 0), paper="100x50")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
degree 1: page 210 x 297, from 50,50 to 50,90, highest Y 90
degree 2: page 210 x 297, from 50,50 to 50,50, highest Y 50
degree 3: page 210 x 297, from 50,50 to 90,50, highest Y 80
degree 4: page 210 x 297, from nothing
degree 3, weights 1 3 3 1: page 210 x 297, from 50,50 to 90,50, highest Y 80
degree 3, uniform knots: page 210 x 297, from 0,0 to 130,50, highest Y 88
RAY: page 210 x 297, from 50,50 to 51,50, highest Y 50
INSERT: page 210 x 297, from -100,50 to -70,50, highest Y 50
paper 100 x 50: page 210 x 297, from 10,10 to 60,10, highest Y 10
EXPECTED
