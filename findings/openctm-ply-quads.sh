#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, openctm-tools 1.0.3+dfsg1-2.1+b3 (ctmconv).
# Input:    one unit cube with 6 quadrilateral faces, as ASCII PLY and as OBJ.
# Expected: Each PLY quadrilateral becomes 2 triangles (12 triangles in total), as OBJ does.
# Seen:     The OBJ gives 12 triangles. The PLY gives 6 triangles: the first 3 vertices of each face.
#           Half of the surface is missing. No message appears and the exit status is 0.

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
fetch openctm-tools=1.0.3+dfsg1-2.1+b3 libopenctm1=1.0.3+dfsg1-2.1+b3 libtinyxml2.6.2v5=2.6.2-6+deb12u1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu

vertices='0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1'
faces='0 3 2 1
4 5 6 7
0 1 5 4
1 2 6 5
2 3 7 6
3 0 4 7'
{
  printf 'ply\nformat ascii 1.0\nelement vertex 8\n'
  printf 'property float x\nproperty float y\nproperty float z\n'
  printf 'element face 6\nproperty list uchar int vertex_indices\nend_header\n'
  echo "$vertices"
  sed 's/^/4 /' <<<"$faces"
} >cube.ply
{
  sed 's/^/v /' <<<"$vertices"
  awk '{ print "f", $1 + 1, $2 + 1, $3 + 1, $4 + 1 }' <<<"$faces"
} >cube.obj

for format in ply obj; do
  root/usr/bin/ctmconv cube.$format $format.off >/dev/null
  awk -v format=$format '
    NF == 3 && !counts { counts = $0; vertices = $1; next }
    NF == 3 { x[n] = $1; y[n] = $2; z[n] = $3; n++ }
    NF == 4 && $1 == 3 {
      a = $2; b = $3; c = $4; triangles++
      ux = x[b] - x[a]; uy = y[b] - y[a]; uz = z[b] - z[a]
      vx = x[c] - x[a]; vy = y[c] - y[a]; vz = z[c] - z[a]
      area += sqrt((uy * vz - uz * vy) ^ 2 + (uz * vx - ux * vz) ^ 2 + (ux * vy - uy * vx) ^ 2) / 2
    }
    END { printf "%s: %d vertices, %d triangles, area %.3f\n", format, n, triangles, area }
  ' $format.off
done | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
ply: 8 vertices, 6 triangles, area 3.000
obj: 8 vertices, 12 triangles, area 6.000
EXPECTED
