#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, gmsh 4.8.4+ds2-3 writes Nastran (BDF); python3-meshio 7.0.0-3 reads.
# Input:    a triangle with the corners -999.9996,0,0 and 0,-12345.678,0 and 0,0,0.00098765.
# Expected: A field of 8 characters has the nearest number: -1000.00 or -1000., -12345.7 and 9.8765-4.
#           meshio reads the file that gmsh writes.
# Seen:     The default format cuts the text after 8 characters: -999.999 and -12345.6 (an error of 0.078).
#           0.00098765 has three digits: 9.88E-04. The format with large fields (Mesh.BdfFieldFormat=2) is right.
#           meshio refuses all three formats: gmsh writes no "BEGIN BULK".

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
fetch gmsh=4.8.4+ds2-3 python3-meshio=7.0.0-3 python3-numpy=1:1.24.2-1+deb12u1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu PATH=$work/root/usr/bin:$PATH HOME=$work
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

for format in 0 1 2; do
  cat >in.geo <<GEO
Point(1) = {-999.9996, 0, 0};
Point(2) = {0, -12345.678, 0};
Point(3) = {0, 0, 0.00098765};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Mesh.MeshSizeMax = 100000;
Mesh.BdfFieldFormat = $format;
GEO
  gmsh -2 in.geo -o out.bdf -v 0 </dev/null >log 2>&1
  echo "format $format:"
  grep -A1 '^GRID' out.bdf | grep -E '^(GRID|\*)' | head -$((format == 2 ? 6 : 3)) | sed 's/ *$//'
  { /usr/bin/python3 -c 'import meshio; meshio.nastran.read("out.bdf")' 2>&1 || true; } | tail -1
done | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
format 0:
GRID,1,0,-999.999,0.00E+00,0.00E+00
GRID,2,0,0.00E+00,-12345.6,0.00E+00
GRID,3,0,0.00E+00,0.00E+00,9.88E-04
RuntimeError: "BEGIN BULK" statement not found
format 1:
GRID    1       0       -999.9990.00E+000.00E+00
GRID    2       0       0.00E+00-12345.60.00E+00
GRID    3       0       0.00E+000.00E+009.88E-04
RuntimeError: "BEGIN BULK" statement not found
format 2:
GRID*   1               0               -999.9996       0
*       0
GRID*   2               0               0               -12345.678
*       0
GRID*   3               0               0               0
*       0.00098765
RuntimeError: "BEGIN BULK" statement not found
EXPECTED
