#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, cloudcompare 2.11.3-7.1 (reader of legacy VTK files; export to STL).
#           Install the dependencies of cloudcompare first.
# Input:    VTK polydata: a tetrahedron (volume 1/6) as one strip of four triangles and as four polygons; a prism with
#           pentagonal ends (volume 1000) as two pentagons and five quadrilaterals; the same prism as OFF.
# Expected: The orientation alternates in a strip, so all four triangles point outwards. The pentagons are
#           triangulated, or the log has a warning, as the reader of OFF does.
# Seen:     Each second triangle of the strip points inwards: the volume is -1/6 and four edges have no opposite.
#           Both pentagons are missing: the volume is 666.67 and the prism is open. The reader of OFF drops
#           them, too, and warns; the log for VTK has no warning.

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
fetch cloudcompare=2.11.3-7.1 lib3ds-1-3=1.3.0-10 libmuparser2v5=2.3.3-0.1 \
  libqt5concurrent5 # no pin: security updates replace the version
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/cloudcompare QT_QPA_PLATFORM=offscreen HOME=$work

cat >check.py <<'PY'
import struct
import subprocess
from collections import Counter


def show(name, path):
    command = ["root/usr/bin/CloudCompare", "-SILENT", "-NO_TIMESTAMP", "-O", path, "-M_EXPORT_FMT", "STL"]
    result = subprocess.run([*command, "-SAVE_MESHES"], check=True, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    warned = "ignored" in result.stdout + result.stderr
    data = open("in.stl", "rb").read()
    count = struct.unpack_from("<I", data, 80)[0]
    volume = 0.0
    edges = Counter()
    for i in range(count):
        row = struct.unpack_from("<12f", data, 84 + 50 * i)
        a, b, c = row[3:6], row[6:9], row[9:12]
        edges.update([(a, b), (b, c), (c, a)])
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) / 6
        volume += a[1] * (b[2] * c[0] - b[0] * c[2]) / 6
        volume += a[2] * (b[0] * c[1] - b[1] * c[0]) / 6
    unmatched = sum(edges[a, b] != edges.get((b, a), 0) for a, b in edges)
    print(f"{name}: {count} triangles, volume {volume:.3f}, {unmatched} unmatched edges, warning: {warned}")


def vtk(points, section, cells):
    with open("in.vtk", "w") as file:
        file.write("# vtk DataFile Version 3.0\nshape\nASCII\nDATASET POLYDATA\n")
        file.write(f"POINTS {len(points)} float\n" + "".join(f"{x} {y} {z}\n" for x, y, z in points))
        file.write(f"{section} {len(cells)} {sum(len(cell) + 1 for cell in cells)}\n")
        file.write("".join(f"{len(cell)} {' '.join(map(str, cell))}\n" for cell in cells))
    return "in.vtk"


def off(points, cells):
    with open("in.off", "w") as file:
        file.write(f"OFF\n{len(points)} {len(cells)} 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in points))
        file.write("".join(f"{len(cell)} {' '.join(map(str, cell))}\n" for cell in cells))
    return "in.off"


corner = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
show("VTK, tetrahedron, polygons", vtk(corner, "POLYGONS", [(0, 2, 1), (1, 2, 3), (1, 3, 0), (0, 3, 2)]))
show("VTK, tetrahedron, strip", vtk(corner, "TRIANGLE_STRIPS", [(0, 2, 1, 3, 0, 2)]))
base = [(0, 0), (10, 0), (12, 6), (5, 10), (-2, 6)]
prism = [(x, y, z) for z in (0, 10) for x, y in base]
faces = [(4, 3, 2, 1, 0), (5, 6, 7, 8, 9)] + [(i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5) for i in range(5)]
show("VTK, prism, polygons", vtk(prism, "POLYGONS", faces))
show("OFF, prism, polygons", off(prism, faces))
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
VTK, tetrahedron, polygons: 4 triangles, volume 0.167, 0 unmatched edges, warning: False
VTK, tetrahedron, strip: 4 triangles, volume -0.167, 4 unmatched edges, warning: False
VTK, prism, polygons: 10 triangles, volume 666.667, 10 unmatched edges, warning: False
OFF, prism, polygons: 10 triangles, volume 666.667, 10 unmatched edges, warning: True
EXPECTED
