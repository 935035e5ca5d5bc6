#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, python3-ezdxf 0.18.1-1 writes; openscad 2021.01-6 reads (import) and exports SVG.
# Input:    a plate of 4 x 2 in model space, with a rectangle of a title block in a paper space layout;
#           the plate as a block with the base point 1,1, inserted at 10,20.
# Expected: The import has the plate alone. The block spans x 9..13, y 19..21: its base point is at 10,20.
# Seen:     The title block is a part of the imported shape (x 10..14), because paper space is not separated.
#           The base point is ignored: the block spans x 10..14, y 20..22. No message appears.

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
fetch openscad=2021.01-6 python3-ezdxf=0.18.1-1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu:$work/root/usr/lib QT_QPA_PLATFORM=offscreen

export PYTHONPATH=$work/root/usr/lib/python3/dist-packages PATH=$work/root/usr/bin:$PATH HOME=$work

cat >check.py <<'PY'
import re
import subprocess

import ezdxf

plate = [(0, 0), (4, 0), (4, 2), (0, 2)]


def show(name, document):
    document.saveas("in.dxf")
    with open("in.scad", "w") as program:
        program.write('import("in.dxf");')
    subprocess.run(["openscad", "-o", "out.svg", "in.scad"], check=True, stderr=subprocess.DEVNULL)
    outlines = re.findall(r"M [^z]*z", " ".join(re.findall(r' d="([^"]*)"', open("out.svg").read().replace("\n", " "))))
    result = []
    for outline in outlines:
        points = [tuple(map(float, p)) for p in re.findall(r"(-?[\d.]+),(-?[\d.]+)", outline)]
        x, y = [p[0] for p in points], [-p[1] for p in points]
        result.append(f"x {min(x):.0f}..{max(x):.0f} y {min(y):.0f}..{max(y):.0f}")
    print(name + ": " + " | ".join(result))


document = ezdxf.new("R2000")
document.modelspace().add_lwpolyline(plate, close=True)
document.layout("Layout1").add_lwpolyline([(x + 10, y) for x, y in plate], close=True)
show("paper space", document)
document = ezdxf.new("R2000")
document.blocks.new("plate", base_point=(1, 1)).add_lwpolyline(plate, close=True)
document.modelspace().add_blockref("plate", (10, 20))
show("base point", document)
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
paper space: x 0..4 y 0..2 | x 10..14 y 0..2
base point: x 10..14 y 20..22
EXPECTED
