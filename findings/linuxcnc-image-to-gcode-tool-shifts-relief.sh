#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 (image-to-gcode),
#           python3-numpy 1:1.24.2-1+deb12u1.
# Input:    a depth image of 60 x 40 pixels of 0.25 mm, black with a white ridge in column 30 (X 7.5 to 7.75),
#           milled in rows with flat end mills of 2, 4 and 6 mm, with and without the option "extend image".
# Expected: The tool centre is above the ridge near X 7.6 for each diameter, so that a roughing program for a large
#           tool and a finishing program for a small one fit the same zero point.
# Seen:     The position depends on the tool. Without extension the centre of the ridge is at 7.5 minus the radius.
#           With extension it is at 7.5 plus the radius. From the 6 mm tool to the 2 mm tool the relief moves
#           by 2 mm to the right or to the left. Y is shifted in the same way: the first row is at 10 minus the diameter.

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
fetch linuxcnc-uspace=2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 python3-numpy=1:1.24.2-1+deb12u1 \
  python3-pil # no pin: security updates replace the version
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import contextlib
import importlib.machinery
import importlib.util
import io
import re
import sys

from PIL import Image

image = Image.new("L", (60, 40), 0)
for row in range(40):
    image.putpixel((30, row), 255)
image.save("ridge.png")

loader = importlib.machinery.SourceFileLoader("image_to_gcode", "root/usr/bin/image-to-gcode")
program = importlib.util.module_from_spec(importlib.util.spec_from_loader("image_to_gcode", loader))
loader.exec_module(program)
sys.argv = ["image-to-gcode", "ridge.png"]


def ridge(diameter, extend):
    # The values of the dialog: flat end mill, rows, one direction, G21.
    program.ui = lambda *_: dict(
        tool_type=1, tool_diameter=diameter, pixel_size=0.25, pixelstep=4, depth=4.0, normalize=0, invert=0,
        expand=extend, pattern=0, converter=0, bounded=0, contact_angle=45, units=1, safety_height=2.0,
        tolerance=0.0001, feed_rate=300, plunge_feed_rate=100, spindle_speed=1000, roughing_offset=0, roughing_depth=0)
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        program.main()
    rows = re.findall(r"X\S+ Y(\S+)", output.getvalue())
    # The centre of the level part at Z0 of the first row that crosses the ridge.
    start, end = re.search(r"X(\S+) Z0\.0000\n X(\S+)\n", output.getvalue()).groups()
    return f"centre of the ridge at X {(float(start) + float(end)) / 2:.3f}, first row at Y {float(rows[0]):.2f}"


for extend, name in (0, "image only"), (2, "extended with black"):
    for diameter in 2.0, 4.0, 6.0:
        print(f"{name}, tool {diameter:.0f} mm: {ridge(diameter, extend)}")
PY
/usr/bin/python3 -W ignore check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
image only, tool 2 mm: centre of the ridge at X 6.500, first row at Y 8.00
image only, tool 4 mm: centre of the ridge at X 5.500, first row at Y 6.00
image only, tool 6 mm: centre of the ridge at X 4.500, first row at Y 4.00
extended with black, tool 2 mm: centre of the ridge at X 8.500, first row at Y 12.00
extended with black, tool 4 mm: centre of the ridge at X 9.500, first row at Y 14.00
extended with black, tool 6 mm: centre of the ridge at X 10.500, first row at Y 16.00
EXPECTED
