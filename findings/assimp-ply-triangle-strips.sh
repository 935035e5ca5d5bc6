#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, assimp-utils 5.2.5~ds0-1+b1 (assimp export to STL).
# Input:    PLY with triangle strips (element tristrips, as in the scans of the Stanford repository): a strip of
#           six vertices, and two strips in one list, separated by -1. The same triangles as faces.
# Expected: Six vertices in a strip are four triangles with the area 2; two strips are eight triangles.
# Seen:     One triangle remains: the last triangle of the last strip. The rest of the surface is missing.
#           No message appears and the exit status is 0. The faces are right.

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
fetch assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1=1.1-8+deb12u1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu

cat >check.py <<'PY'
import re
import subprocess

header = "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
row = [(x, y, 0) for x in range(3) for y in (0, 1)]


def convert(points, element, lists):
    with open("in.ply", "w") as ply:
        ply.write(header % len(points))
        ply.write(f"element {element} {len(lists)}\nproperty list int int vertex_indices\nend_header\n")
        for values in [*points, *([len(indices), *indices] for indices in lists)]:
            ply.write(" ".join(map(str, values)) + "\n")
    subprocess.run(["root/usr/bin/assimp", "export", "in.ply", "out.stl"], check=True, stdout=subprocess.DEVNULL)
    found = [tuple(map(float, p)) for p in re.findall(r"vertex (\S+) (\S+) (\S+)", open("out.stl").read())]
    area = 0.0
    for a, b, c in zip(found[0::3], found[1::3], found[2::3]):
        area += abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2
    return f"{len(found) // 3} triangles, area {area:.1f}"


faces = [(i, i + 1, i + 2) if i % 2 else (i + 1, i, i + 2) for i in range(4)]
print("faces:", convert(row, "face", faces))
print("one strip:", convert(row, "tristrips", [range(6)]))
second = [(x + 5, y, z) for x, y, z in row]
print("two strips:", convert(row + second, "tristrips", [[*range(6), -1, *range(6, 12)]]))
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
faces: 4 triangles, area 2.0
one strip: 1 triangles, area 0.5
two strips: 1 triangles, area 0.5
EXPECTED
