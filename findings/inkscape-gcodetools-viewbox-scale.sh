#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, inkscape 1.2.2-2+deb12u1 (extension gcodetools.py), python3-lxml, python3-cssselect 1.2.0-2,
#           python3-numpy 1:1.24.2-1+deb12u1.
# Input:    a sheet of 100 x 100 mm with a square of 20 mm, 10 mm from the left and top edges. The same drawing with
#           four values of viewBox: one user unit is 1 mm, 1/96 inch (a CSS pixel), 0.5 mm and 2 mm. The steps of the
#           user: orientation points in mm, tools library, path to G-code.
# Expected: All four programs are equal: G21, X 10 to 30, Y 70 to 90.
# Seen:     Only the sheet with 1 mm as the unit is right. The other programs contain user units as millimetres: the
#           square has 75.6, 40 and 10 mm in spite of G21. Y is wrong, too: the bottom of these sheets is
#           at 377.95 units (100 mm in CSS pixels), whatever the unit is. No message appears.

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
fetch inkscape=1.2.2-2+deb12u1 python3-cssselect=1.2.0-2 python3-numpy=1:1.24.2-1+deb12u1 \
  python3-lxml libxslt1.1 # no pin: security updates replace the version
extensions=$work/root/usr/share/inkscape/extensions
export PYTHONPATH=$extensions:$work/root/usr/lib/python3/dist-packages
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu

cat >check.py <<'PY'
import re
import subprocess
import sys


def gcodetools(source, target, *options):
    command = ["/usr/bin/python3", f"{sys.argv[1]}/other/gcodetools/gcodetools.py", *options]
    result = subprocess.run([*command, "--unit=G21 (All units in mm)", source], check=True, capture_output=True)
    open(target, "wb").write(result.stdout)


def program(units):
    a, b = 10 * units, 20 * units
    with open("sheet.svg", "w") as svg:
        svg.write(
            '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
            f'width="100mm" height="100mm" viewBox="0 0 {100 * units} {100 * units}">'
            '<g inkscape:groupmode="layer" id="layer" inkscape:label="layer">'
            f'<path id="square" d="M {a} {a} h {b} v {b} h {-b} Z"/></g></svg>')
    gcodetools("sheet.svg", "a.svg", "--active-tab=orientation", "--orientation-points-count=2", "--Zdepth=-1",
               "--Zsurface=0", "--id=layer")
    gcodetools("a.svg", "b.svg", "--active-tab=tools_library", "--tools-library-type=cylinder cutter", "--id=layer")
    gcodetools("b.svg", "c.svg", "--active-tab=path-to-gcode", "--directory=.", "--filename=out.ngc",
               "--biarc-tolerance=0.05", "--biarc-max-split-depth=4", "--min-arc-radius=0.05", "--Zsafe=5",
               "--create-log=false", "--postprocessor= ", "--path-to-gcode-order=subpath by subpath",
               "--path-to-gcode-depth-function=d", "--add-numeric-suffix-to-filename=false",
               "--auto_select_paths=true", "--id=square")
    text = open("out.ngc").read()
    x, y = zip(*re.findall(r"^G01 X(\S+) Y(\S+)", text, re.M))
    unit = re.search(r"^G2[01]", text, re.M).group()
    return f"{unit}, X {min(map(float, x)):.2f} to {max(map(float, x)):.2f}, Y {min(map(float, y)):.2f} to {max(map(float, y)):.2f}"


for name, units in ("1 mm", 1), ("1/96 inch", 96 / 25.4), ("0.5 mm", 2), ("2 mm", 0.5):
    print(f"user unit {name}: {program(units)}")
PY
/usr/bin/python3 check.py "$extensions" | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
user unit 1 mm: G21, X 10.00 to 30.00, Y 70.00 to 90.00
user unit 1/96 inch: G21, X 37.80 to 113.39, Y 264.57 to 340.16
user unit 0.5 mm: G21, X 20.00 to 60.00, Y 317.95 to 357.95
user unit 2 mm: G21, X 5.00 to 15.00, Y 362.95 to 372.95
EXPECTED
