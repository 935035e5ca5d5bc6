#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1 (vtkVRMLImporter; no window is opened).
# Input:    VRML97 files with a box of 4 x 2 x 1 in a Transform with rotation, with center and scale, and with a nested
#           Transform; a cone; primitives without fields; a Switch with whichChoice 0 (ISO/IEC 14772-1, nodes
#           Transform, Box, Sphere, Cone, Switch).
# Expected: A rotation by 90 degrees about Z gives X -1 to 1, Y -2 to 2. The nested box is around 0,10. The scale by 2
#           about 2,1,0 gives X -6 to 2, Y -3 to 1. The axis of a cone is Y. By default, a Box has the size 2 and a
#           Sphere the radius 1. A Switch shows one child.
# Seen:     rotation and center are ignored: the rotated box is as without rotation, the nested box is around 10,0. The
#           axis of the cone is X. Default primitives have half the size. The Switch shows both children. The importer
#           prints no warning. Translation and scale are right.

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
fetch python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1 python3-numpy=1:1.24.2-1+deb12u1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/lapack:$libraries/blas HOME=$work
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, required by the importer
from vtkmodules.vtkIOImport import vtkVRMLImporter


def show(name, text):
    with open("in.wrl", "w") as file:
        file.write("#VRML V2.0 utf8\n" + text + "\n")
    importer = vtkVRMLImporter()
    importer.SetFileName("in.wrl")
    importer.Update()
    actors = importer.GetRenderer().GetActors()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextActor()
        actor.GetMapper().Update()
        low_x, high_x, low_y, high_y = (round(value, 2) + 0.0 for value in actor.GetBounds()[:4])
        print(f"{name}: X {low_x:g} to {high_x:g}, Y {low_y:g} to {high_y:g}")


box = "Shape { geometry Box { size 4 2 1 } }"
turn = "rotation 0 0 1 1.5707963"
moved = f"Transform {{ translation 10 0 0 children [ {box} ] }}"
show("translation", moved)
show("scale", f"Transform {{ scale 2 2 2 children [ {box} ] }}")
show("rotation", f"Transform {{ {turn} children [ {box} ] }}")
show("translation in rotation", f"Transform {{ {turn} children [ {moved} ] }}")
show("scale about center", f"Transform {{ center 2 1 0 scale 2 2 2 children [ {box} ] }}")
show("cone of height 6", "Shape { geometry Cone { bottomRadius 1 height 6 } }")
show("default box", "Shape { geometry Box { } }")
small, large = "Shape { geometry Box { size 2 2 2 } }", "Shape { geometry Box { size 8 8 8 } }"
show("switch, choice 0", f"Switch {{ whichChoice 0 choice [ {small} {large} ] }}")
PY
/usr/bin/python3 check.py 2>&1 | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
translation: X 8 to 12, Y -1 to 1
scale: X -4 to 4, Y -2 to 2
rotation: X -2 to 2, Y -1 to 1
translation in rotation: X 8 to 12, Y -1 to 1
scale about center: X -4 to 4, Y -2 to 2
cone of height 6: X -3 to 3, Y -1 to 1
default box: X -0.5 to 0.5, Y -0.5 to 0.5
switch, choice 0: X -1 to 1, Y -1 to 1
switch, choice 0: X -4 to 4, Y -4 to 4
EXPECTED
