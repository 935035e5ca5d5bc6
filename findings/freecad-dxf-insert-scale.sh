#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, python3-ezdxf 0.18.1-1 writes; freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed) reads.
# Input:    a block with a square of 10 x 10, inserted at 0,0 with different scales in X, Y and Z; units: millimetres.
# Expected: Scale 2,2,1 gives 20 x 20; 2,3,1 gives 20 x 30; 4,1,1 gives 40 x 10.
# Seen:     The importer uses the cube root of the product of all three scales for all axes. Scale 2,2,1 gives
#           15.87 x 15.87, although the drawing is flat. 2,3,1 gives 18.17 x 18.17; 4,1,1 gives 15.87 x 15.87.
#           Only equal scales (2,2,2) are right. No message appears.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
# Extracts pinned Debian 12 packages into ./root, without installation.
fetch() {
  mkdir -p deb root
  (cd deb && apt-get download "$@" >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch python3-ezdxf=0.18.1-1 python3-pyparsing=3.0.9-1 python3-typing-extensions=4.4.0-1
export HOME=$work

cat >write.py <<'PY'
import ezdxf

for scale in ((2, 2, 2), (2, 2, 1), (2, 3, 1), (4, 1, 1)):
    document = ezdxf.new("R2000")
    document.header["$INSUNITS"] = 4
    block = document.blocks.new("square")
    block.add_lwpolyline([(0, 0), (10, 0), (10, 10), (0, 10)], close=True)
    attributes = dict(zip(("xscale", "yscale", "zscale"), scale))
    document.modelspace().add_blockref("square", (0, 0), dxfattribs=attributes)
    document.saveas("scale-%d-%d-%d.dxf" % scale)
PY
PYTHONPATH=$work/root/usr/lib/python3/dist-packages /usr/bin/python3 write.py
cat >read.py <<'PY'
import glob

import FreeCAD
import Import

with open("seen", "w") as seen:
    for name in sorted(glob.glob("*.dxf")):
        document = FreeCAD.newDocument("d")
        Import.readDXF(name, "d")
        box = document.Objects[0].Shape.BoundBox
        seen.write(f"{name}: {box.XLength:.2f} x {box.YLength:.2f}\n")
        FreeCAD.closeDocument("d")
PY
freecadcmd read.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
scale-2-2-1.dxf: 15.87 x 15.87
scale-2-2-2.dxf: 20.00 x 20.00
scale-2-3-1.dxf: 18.17 x 18.17
scale-4-1-1.dxf: 15.87 x 15.87
EXPECTED
