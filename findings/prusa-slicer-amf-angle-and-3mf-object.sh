#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, prusa-slicer 2.5.0+dfsg-4 (option --export-stl).
# Input:    AMF: a bar of 4 x 1 x 1 in a constellation, turned by rz 90. 3MF: the bar, and a second object that
#           is not in the build.
# Expected: The AMF specification has angles in degrees: rz 90 gives x -1..0, y 0..4.
#           The 3MF specification permits objects that are not in the build; the bar alone is loaded.
# Seen:     The angle is read in radians: rz 90 turns the bar by 116.6 degrees (90 - 28 pi); rz 1.5707963 gives the
#           expected result of rz 90. The 3MF file is an error: "Unable to find object".

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
fetch prusa-slicer=2.5.0+dfsg-4
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu PATH=$work/root/usr/bin:$PATH HOME=$work

cat >check.py <<'PY'
import os
import re
import struct
import subprocess
import zipfile

corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 4)]
quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
triangles = [(q[0], q[i], q[i + 1]) for q in quads for i in (1, 2)]


def show(name, path):
    if os.path.exists("out.stl"):
        os.remove("out.stl")
    command = ["prusa-slicer", "--export-stl", "--dont-arrange", "-o", "out.stl", path]
    run = subprocess.run(command, capture_output=True, text=True)
    if not os.path.exists("out.stl"):
        print(name + ": " + re.search("Unable to find object", run.stdout + run.stderr)[0])
        return
    data = open("out.stl", "rb").read()
    count = struct.unpack_from("<I", data, 80)[0]
    points = [struct.unpack_from("<3f", data, 96 + 50 * i + 12 * k) for i in range(count) for k in range(3)]
    x, y = [p[0] for p in points], [p[1] for p in points]
    print(f"{name}: x {min(x):.2f}..{max(x):.2f} y {min(y):.2f}..{max(y):.2f}")


vertices = "".join(f"<vertex><coordinates><x>{x}</x><y>{y}</y><z>{z}</z></coordinates></vertex>" for x, y, z in corners)
faces = "".join(f"<triangle><v1>{a}</v1><v2>{b}</v2><v3>{c}</v3></triangle>" for a, b, c in triangles)
for angle in ("0", "90", "1.5707963"):
    with open("in.amf", "w") as amf:
        amf.write('<?xml version="1.0"?><amf unit="millimeter"><object id="1"><mesh>')
        amf.write(f"<vertices>{vertices}</vertices><volume>{faces}</volume></mesh></object>")
        amf.write('<constellation id="2"><instance objectid="1"><deltax>0</deltax><deltay>0</deltay>')
        amf.write(f"<rz>{angle}</rz></instance></constellation></amf>")
    show(f"amf rz {angle}", "in.amf")

vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in corners)
faces = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in triangles)
bar = f'type="model"><mesh><vertices>{vertices}</vertices><triangles>{faces}</triangles></mesh></object>'
package = "http://schemas.openxmlformats.org/package/2006/"
for name, objects in (("one object", (1,)), ("second object, not in the build", (1, 2))):
    with zipfile.ZipFile("in.3mf", "w") as archive:
        archive.writestr(
            "[Content_Types].xml",
            f'<?xml version="1.0" encoding="UTF-8"?><Types xmlns="{package}content-types">'
            f'<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
            f'<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>'
            f"</Types>",
        )
        archive.writestr(
            "_rels/.rels",
            f'<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="{package}relationships">'
            f'<Relationship Target="/3D/3dmodel.model" Id="r" '
            f'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>',
        )
        archive.writestr(
            "3D/3dmodel.model",
            '<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" xml:lang="en-US" '
            'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
            + "".join(f'<object id="{i}" {bar}' for i in objects)
            + '</resources><build><item objectid="1"/></build></model>',
        )
    show("3mf, " + name, "in.3mf")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
amf rz 0: x 0.00..4.00 y 0.00..1.00
amf rz 90: x -2.69..0.00 y -0.45..3.58
amf rz 1.5707963: x -1.00..0.00 y 0.00..4.00
3mf, one object: x 0.00..4.00 y 0.00..1.00
3mf, second object, not in the build: Unable to find object
EXPECTED
