#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, stlcmd 1.1-1 (stl_boolean).
# Input:    two boxes of 10 x 10 x 10 that share one complete face and no volume.
# Expected: A - B is A. The volume is 1000 and the mesh is closed.
# Seen:     The union (2000) and the intersection (empty) are right. The difference has 14 facets,
#           8 unmatched edge directions and a signed volume of 1333.33: the shared face is missing.
#           The exit status is 0 and no message appears.
# Contrast: A box that overlaps A and is flush with one of its faces gives the exact difference.

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
fetch stlcmd=1.1-1

cat >check.py <<'PY'
import struct
import subprocess
from collections import Counter


def box(lo, hi):
    (a, b, c), (d, e, f) = lo, hi
    v = [(a, b, c), (d, b, c), (d, e, c), (a, e, c), (a, b, f), (d, b, f), (d, e, f), (a, e, f)]
    quads = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    return [[v[q[0]], v[q[i]], v[q[i + 1]]] for q in quads for i in (1, 2)]


def write(path, facets):
    with open(path, "wb") as f:
        f.write(bytes(80) + struct.pack("<I", len(facets)))
        for a, b, c in facets:
            f.write(struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0))


def read(path):
    data = open(path, "rb").read()
    count = struct.unpack_from("<I", data, 80)[0]
    rows = [struct.unpack_from("<12f", data, 84 + 50 * i) for i in range(count)]
    return [(r[3:6], r[6:9], r[9:12]) for r in rows]


def volume(facets):
    return sum(
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        for a, b, c in facets
    ) / 6


def unmatched(facets):
    edges = Counter((t[i], t[(i + 1) % 3]) for t in facets for i in range(3))
    return sum(1 for a, b in edges if edges[a, b] != edges.get((b, a), 0))


def boolean(option, second):
    write("a.stl", box((0, 0, 0), (10, 10, 10)))
    write("b.stl", second)
    subprocess.run(["root/usr/bin/stl_boolean", "-a", "a.stl", "-b", "b.stl", option, "out.stl"], check=True)
    facets = read("out.stl")
    return len(facets), round(volume(facets), 2), unmatched(facets)


touching = box((10, 0, 0), (20, 10, 10))
flush = box((2, 2, 5), (8, 8, 10))
seen = {
    "union": boolean("-u", touching),
    "intersection": boolean("-i", touching),
    "difference": boolean("-d", touching),
    "flush difference": boolean("-d", flush),
}
for name, value in seen.items():
    print(f"{name}: facets, volume, unmatched edges = {value}")
assert seen["union"][1:] == (2000.0, 0)
assert seen["intersection"][0] == 0
assert seen["difference"] == (14, 1333.33, 8), "behaviour changed"
assert seen["flush difference"][1:] == (820.0, 0)
PY
/usr/bin/python3 check.py
