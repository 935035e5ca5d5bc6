#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; module Mesh, Nastran reader).
# Input:    one triangle in the usual forms of the Nastran bulk data: fixed fields, free fields with
#           commas, and "1.5-2" (0.015: an exponent without the letter E).
# Expected: All forms are standard and give one triangle.
# Seen:     Fixed fields are read. The file with one number of the form "1.5-2" and the file with commas give an empty
#           mesh. No error is raised, and isSolid() is True.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
export HOME=$work

grid() { printf '%-8s%-8s%-8s%-8s%-8s%-8s\n' GRID "$1" '' "$2" "$3" "$4"; }
triangle() { printf '%-8s%-8s%-8s%-8s%-8s%-8s\n' CTRIA3 1 1 1 2 3; }
{ grid 1 0.0 0.0 0.0; grid 2 1.5 0.0 0.0; grid 3 0.0 1.0 0.0; triangle; } >fixed.nas
{ grid 1 0.0 0.0 0.0; grid 2 1.5-2 0.0 0.0; grid 3 0.0 1.0 0.0; triangle; } >exponent.nas
printf 'GRID,1,,0.0,0.0,0.0\nGRID,2,,1.5,0.0,0.0\nGRID,3,,0.0,1.0,0.0\nCTRIA3,1,1,1,2,3\n' >free.nas
cat >read.py <<'PY'
import Mesh

with open("seen", "w") as seen:
    for name in ("fixed", "exponent", "free"):
        mesh = Mesh.Mesh(name + ".nas")
        seen.write(f"{name}: {mesh.CountPoints} points, {mesh.CountFacets} triangles, solid {mesh.isSolid()}\n")
PY
freecadcmd read.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
fixed: 3 points, 1 triangles, solid False
exponent: 0 points, 0 triangles, solid True
free: 0 points, 0 triangles, solid True
EXPECTED
