#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, gmsh 4.8.4+ds2-3 (reader of Nastran bulk data) and python3-meshio 7.0.0-3 (writer).
# Input:    two quadrilaterals and four triangles, as meshio writes the cards CQUAD4 and CTRIA3: fixed fields with an
#           empty PID; the same cards by hand with PID 1, and with an empty PID between commas. Also a tetrahedron of
#           ten nodes, written by meshio.
# Expected: all elements. PID of CQUAD4 and CTRIA3 may be empty (MSC Nastran Quick Reference Guide: "Default = EID").
#           The card of the tetrahedron is CTETRA with a PID, because CTETRA has no default for it.
# Seen:     gmsh skips an empty field of the fixed format and takes the next field instead: a node number becomes the
#           PID, and numbers of the next card become nodes. Two quadrilaterals become one with a repeated node, four
#           triangles become two wrong triangles. No message appears; the comma form and PID 1 are right.
#           meshio writes the card name "CTETRA_", which Nastran does not have; "_" is internal to meshio.

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
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu:$work/root/usr/lib/x86_64-linux-gnu/lapack
export LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$work/root/usr/lib/x86_64-linux-gnu/blas HOME=$work
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >write.py <<'PY'
import meshio

points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0), (2, 1, 0)]
meshio.write("quads.bdf", meshio.Mesh(points, [("quad", [(0, 1, 2, 3), (1, 4, 5, 2)])]))
meshio.write("triangles.bdf", meshio.Mesh(points, [("triangle", [(0, 1, 2), (0, 2, 3), (1, 4, 5), (1, 5, 2)])]))
corners = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2)]
middles = [(1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]
meshio.write("tetrahedron.bdf", meshio.Mesh(corners + middles, [("tetra10", [tuple(range(10))])]))
PY
/usr/bin/python3 write.py
nodes() { grep -E '^(GRID|\*|BEGIN|\$)' quads.bdf; }
{ nodes; printf 'CQUAD4  %-8s%-8s%-8s%-8s%-8s%-8s\n' 1 1 1 2 3 4 2 1 2 5 6 3; echo ENDDATA; } >quads-pid.bdf
{ nodes; printf 'CQUAD4,%s,,%s,%s,%s,%s\n' 1 1 2 3 4 2 2 5 6 3; echo ENDDATA; } >quads-comma.bdf

show() {
  echo "$1: $(grep -cE '^C(QUAD4|TRIA3)' "$1") cards"
  root/usr/bin/gmsh -0 "$1" -o out.msh -format msh2 >log 2>&1
  grep -iE 'error|warning' log || true
  sed -n '/^\$Elements/,/^\$End/p' out.msh | awk 'NF > 5 { $1 = $2 = $3 = $4 = $5 = ""; print "nodes" $0 }' | tr -s ' '
}
{
  show quads-pid.bdf
  show quads-comma.bdf
  show quads.bdf
  show triangles.bdf
  echo "tetrahedron.bdf: $(grep '^CT' tetrahedron.bdf)"
} | sed 's/ *$//' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
quads-pid.bdf: 2 cards
nodes 1 2 3 4
nodes 2 5 6 3
quads-comma.bdf: 2 cards
nodes 1 2 3 4
nodes 2 5 6 3
quads.bdf: 2 cards
nodes 1 2 3 1
triangles.bdf: 4 cards
nodes 1 2 1
nodes 4 5 3
tetrahedron.bdf: CTETRA_ 1               1       2       3       4       5       6       +11
EXPECTED
