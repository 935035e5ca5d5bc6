#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, python3-ezdxf 0.18.1-1 writes; assimp-utils 5.2.5~ds0-1+b1 reads (assimp export to STL).
# Input:    a block with one 3DFACE of 4 x 2, inserted at 10,20,5: plain, turned by 90 degrees, with the x scale 2,
#           and as an array of three columns.
# Expected: The turned face spans x 8..10 and y 20..24, the scaled face x 10..18, the array x 10..34 (area 24).
#           ezdxf gives these values.
# Seen:     The angle is ignored (x 10..14). The scale multiplies the insertion point also (x 20..28).
#           The array has one column (area 8). No message appears.

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
fetch assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1=1.1-8+deb12u1 \
  python3-ezdxf=0.18.1-1 python3-pyparsing=3.0.9-1 python3-typing-extensions=4.4.0-1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import re
import subprocess

import ezdxf


def spans(points):
    return " ".join(f"{min(axis):.0f}..{max(axis):.0f}" for axis in zip(*points))


def show(name, **attributes):
    document = ezdxf.new("R2000")
    block = document.blocks.new("plate")
    block.add_3dface([(0, 0, 0), (4, 0, 0), (4, 2, 0), (0, 2, 0)])
    insert = document.modelspace().add_blockref("plate", (10, 20, 5), dxfattribs=attributes)
    document.saveas("in.dxf")
    inserts = list(insert.multi_insert()) if insert.mcount > 1 else [insert]
    expected = [v for one in inserts for face in one.virtual_entities() for v in face.wcs_vertices()]
    subprocess.run(["root/usr/bin/assimp", "export", "in.dxf", "out.stl"], check=True, stdout=subprocess.DEVNULL)
    found = [tuple(map(float, p)) for p in re.findall(r"vertex (\S+) (\S+) (\S+)", open("out.stl").read())]
    seen = [(x, -z, y) for x, y, z in found]  # assimp turns +Z of DXF to +Y
    area = sum(
        abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2
        for a, b, c in zip(seen[0::3], seen[1::3], seen[2::3])
    )
    print(f"{name}: ezdxf {spans(expected)}; assimp {spans(seen)}, area {area:.0f}")


show("plain")
show("turned", rotation=90)
show("scaled", xscale=2)
show("array", column_count=3, column_spacing=10)
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
plain: ezdxf 10..14 20..22 5..5; assimp 10..14 20..22 5..5, area 8
turned: ezdxf 8..10 20..24 5..5; assimp 10..14 20..22 5..5, area 8
scaled: ezdxf 10..18 20..22 5..5; assimp 20..28 20..22 5..5, area 16
array: ezdxf 10..34 20..22 5..5; assimp 10..14 20..22 5..5, area 8
EXPECTED
