#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-meshio 7.0.0-3 (meshio 5.0.0: conversion between formats of finite elements).
# Input:    one cell of each kind with known nodes: a wedge, a pyramid, a tetrahedron, a hexahedron, and the second-order forms with
#           their nodes in the middle of the edges; written to PERMAS and FLAC3D, read again and written as VTK. Source: the
#           order of nodes in the VTK file formats, which meshio uses for its cells.
# Expected: Each cell has the same nodes after the round trip: the volume 0.5 for the wedge; 6 of 6 middle nodes of a tetrahedron and
#           3 of 3 of a triangle between the ends of their edges. The formats Abaqus, Nastran and VTK show this.
# Seen:     FLAC3D turns the wedge inside out: its volume is -0.5. The writer of PERMAS changes the order of second-order nodes
#           (1 5 2 6 3 7 8 9 10 4), and the reader keeps the order of the file: of the tetrahedron, no middle node remains at its
#           edge, and its corners are in one plane with a volume of 0. No warning appears. Other cells are right.

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
fetch python3-meshio=7.0.0-3 python3-numpy=1:1.24.2-1+deb12u1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/lapack:$libraries/blas PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import meshio
import numpy

edges = {"tetra10": [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)], "triangle6": [(0, 1), (1, 2), (2, 0)],
         "quad8": [(0, 1), (1, 2), (2, 3), (3, 0)]}
tetrahedron = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
corners = {"tetra": tetrahedron, "wedge": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]],
           "pyramid": square + [[0.5, 0.5, 1]], "hexahedron": square + [[x, y, 1] for x, y, _ in square],
           "tetra10": tetrahedron, "triangle6": tetrahedron[:3], "quad8": square}
across = {"tetra": (1, 2, 3, 6), "tetra10": (1, 2, 3, 6), "wedge": (1, 2, 3, 2), "pyramid": (1, 3, 4, 3),
          "hexahedron": (1, 3, 4, 1)}


def trip(kind, suffix):
    points = numpy.array(corners[kind], float)
    if kind in edges:
        points = numpy.vstack([points, [(points[a] + points[b]) / 2 for a, b in edges[kind]]])
    meshio.write("cell" + suffix, meshio.Mesh(points, [(kind, [list(range(len(points)))])]))
    meshio.write("copy.vtk", meshio.read("cell" + suffix))
    copy = meshio.read("copy.vtk")
    nodes = copy.points[copy.cells_dict[kind][0]]
    text = f"{kind}, {suffix}:"
    if kind in across:
        a, b, c, divisor = across[kind]
        text += f" volume {numpy.linalg.det(nodes[[a, b, c]] - nodes[0]) / divisor + 0:.2f}"
    if kind in edges:
        count = len(nodes) - len(edges[kind])
        hits = [numpy.allclose(nodes[count + i], (nodes[a] + nodes[b]) / 2) for i, (a, b) in enumerate(edges[kind])]
        text += f" {sum(hits)} of {len(hits)} middle nodes"
    print(text)


for kind in ("tetra", "wedge", "pyramid", "hexahedron"):
    trip(kind, ".f3grid")
trip("wedge", ".inp")
for kind in ("tetra", "tetra10", "triangle6", "quad8"):
    trip(kind, ".post")
    if kind == "tetra10":
        print("  TET10:", open("cell.post").read().split("TYPE=TET10\n")[1].split("\n")[0])
for suffix in (".inp", ".bdf"):
    trip("tetra10", suffix)
    trip("triangle6", suffix)
PY
/usr/bin/python3 check.py 2>&1 | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
tetra, .f3grid: volume 0.17
wedge, .f3grid: volume -0.50
pyramid, .f3grid: volume 0.33
hexahedron, .f3grid: volume 1.00
wedge, .inp: volume 0.50
tetra, .post: volume 0.17
tetra10, .post: volume 0.00 0 of 6 middle nodes
  TET10: 1 1 5 2 6 3 7 8 9 10 4
triangle6, .post: 0 of 3 middle nodes
quad8, .post: 4 of 4 middle nodes
tetra10, .inp: volume 0.17 6 of 6 middle nodes
triangle6, .inp: 3 of 3 middle nodes
tetra10, .bdf: volume 0.17 6 of 6 middle nodes
triangle6, .bdf: 3 of 3 middle nodes
EXPECTED
