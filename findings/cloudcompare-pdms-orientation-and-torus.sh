#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, cloudcompare 2.11.3-7.1 (reader of PDMS macros, a CAD format of plant design; export to STL).
#           Install the dependencies of cloudcompare first.
# Input:    macros with one primitive each: a box of 10 x 20 x 30 at E 100 without and with ORI, CTORUS and RTORUS (a quarter
#           ring with circular and with rectangular section, radii 8 and 12, height 6), DISH with a knuckle radius.
# Expected: Y IS N AND Z IS U is the default orientation, so ORI changes nothing. X IS N AND Z IS U exchanges the
#           extents in X and Y. The volumes of the tori are 197.4 and 377.0. A dish is round: 20 x 20.
# Seen:     Each ORI with plain directions collapses the box to the single point 100,0,0; its volume is 0. RTORUS has the
#           circular section of CTORUS, and its height is ignored. The knuckle radius 2 becomes the half axis in Y: the
#           dish is 20 x 4. The exit status is 0 and the log says "loaded successfully".

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
fetch cloudcompare=2.11.3-7.1 lib3ds-1-3=1.3.0-10 libmuparser2v5=2.3.3-0.1 \
  libqt5concurrent5 # no pin: security updates replace the version
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/cloudcompare QT_QPA_PLATFORM=offscreen HOME=$work

cat >check.py <<'PY'
import struct
import subprocess


def show(name, *lines):
    with open("in.mac", "w") as macro:
        macro.write("\n".join(["NEW SITE /SITE", "NEW ZONE /ZONE", *lines, "END", "END", "END", ""]))
    command = ["root/usr/bin/CloudCompare", "-SILENT", "-NO_TIMESTAMP", "-O", "in.mac", "-M_EXPORT_FMT", "STL"]
    subprocess.run([*command, "-SAVE_MESHES"], check=True, capture_output=True, stdin=subprocess.DEVNULL)
    data = open("in.stl", "rb").read()
    rows = [struct.unpack_from("<12f", data, 84 + 50 * i) for i in range(struct.unpack_from("<I", data, 80)[0])]
    volume = 0.0
    points = []
    for row in rows:
        a, b, c = row[3:6], row[6:9], row[9:12]
        points += [a, b, c]
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) / 6
        volume += a[1] * (b[2] * c[0] - b[0] * c[2]) / 6
        volume += a[2] * (b[0] * c[1] - b[1] * c[0]) / 6
    low, high = [min(p[k] for p in points) for k in range(3)], [max(p[k] for p in points) for k in range(3)]
    size = " x ".join(f"{h - l:.1f}" for l, h in zip(low, high))
    print(f"{name}: {size}, volume {volume:.0f}, X from {round(low[0])}")


box = ["NEW BOX", "XLENGTH 10mm", "YLENGTH 20mm", "ZLENGTH 30mm", "POSITION E 100mm N 0mm U 0mm"]
show("box", *box)
show("box, ORI Y IS N AND Z IS U", *box, "ORI Y IS N AND Z IS U")
show("box, ORI X IS N AND Z IS U", *box, "ORI X IS N AND Z IS U")
show("CTORUS", "NEW CTORUS", "RINSIDE 8mm", "ROUTSIDE 12mm", "ANGLE 90")
show("RTORUS", "NEW RTORUS", "RINSIDE 8mm", "ROUTSIDE 12mm", "HEIGHT 6mm", "ANGLE 90")
show("DISH, radius 0", "NEW DISH", "DIAMETER 20mm", "HEIGHT 5mm", "RADIUS 0mm")
show("DISH, radius 2", "NEW DISH", "DIAMETER 20mm", "HEIGHT 5mm", "RADIUS 2mm")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
box: 10.0 x 20.0 x 30.0, volume 6000, X from 95
box, ORI Y IS N AND Z IS U: 0.0 x 0.0 x 0.0, volume 0, X from 100
box, ORI X IS N AND Z IS U: 0.0 x 0.0 x 0.0, volume 0, X from 100
CTORUS: 12.0 x 12.0 x 4.0, volume 195, X from 0
RTORUS: 12.0 x 12.0 x 4.0, volume 195, X from 0
DISH, radius 0: 20.0 x 20.0 x 5.0, volume 820, X from -10
DISH, radius 2: 20.0 x 4.0 x 5.0, volume 204, X from -10
EXPECTED
