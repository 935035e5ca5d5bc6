#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, openscad 2021.01-6 (import of SVG, export as SVG).
# Input:    drawings of 20 x 10 mm: a line from 5,5 to 15,5 with stroke widths of 0.01 and 0.001; a square of 4 mm with
#           fill "none" and a stroke of 0.5, and with display "none"; the square 2..6 in view boxes that begin at -10,0
#           and 0,-10; the square by <use>.
# Expected: The line is 0.01 and 0.001 wide and ends at 5 and 15. fill "none" gives a ring, display "none" nothing. The
#           view box at -10,0 moves the square 10 to the right, the one at 0,-10 moves it 10 down. <use> shows it.
# Seen:     A stroke of 0.001 is 1 wide, and all strokes are longer by half their width at both ends. fill "none" and
#           display "none" give the full square. The view box at 0,-10 moves 10 up instead of down; x is right. The square
#           of <use> is missing. No message appears.

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
fetch openscad=2021.01-6
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu:$work/root/usr/lib QT_QPA_PLATFORM=offscreen
export PATH=$work/root/usr/bin:$PATH HOME=$work

cat >check.py <<'PY'
import os
import re
import subprocess

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="20mm" height="10mm" viewBox="%s">'
SQUARE = '<path %s d="M2 2L6 2L6 6L2 6Z"/>'


def show(name, content, box="0 0 20 10"):
    with open("in.svg", "w") as file:
        file.write(HEAD % box + content + "</svg>")
    with open("in.scad", "w") as program:
        program.write('import("in.svg");')
    # An empty drawing is not exported.
    subprocess.run(["openscad", "-o", "out.svg", "in.scad"], check=False, stderr=subprocess.DEVNULL)
    text = open("out.svg").read().replace("\n", " ") if os.path.exists("out.svg") else ""
    points = [tuple(map(float, p)) for p in re.findall(r"(-?[\d.]+),(-?[\d.]+)", " ".join(re.findall(r' d="([^"]*)"', text)))]
    loops = text.count(" z")
    if not points:
        print(name + ": nothing")
        return
    os.remove("out.svg")
    x, y = [p[0] for p in points], [-p[1] for p in points]
    print(f"{name}: x {min(x):g}..{max(x):g} y {min(y):g}..{max(y):g}, {loops} loops")


for width in ("0.01", "0.001"):
    show(f"stroke {width}", f'<path fill="none" stroke="red" stroke-width="{width}" d="M5 5L15 5"/>')
show("fill none", SQUARE % 'fill="none" stroke="red" stroke-width="0.5"')
show("display none", SQUARE % 'display="none"')
show("view box at 0,0", SQUARE % "")
show("view box at -10,0", SQUARE % "", "-10 0 20 10")
show("view box at 0,-10", SQUARE % "", "0 -10 20 10")
show("use", "<defs>" + SQUARE % 'id="a"' + '</defs><use xlink:href="#a"/>')
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
stroke 0.01: x 4.995..15.005 y 4.995..5.00499, 1 loops
stroke 0.001: x 4.5..15.5 y 4.5..5.5, 1 loops
fill none: x 2..6 y 4..8, 1 loops
display none: x 2..6 y 4..8, 1 loops
view box at 0,0: x 2..6 y 4..8, 1 loops
view box at -10,0: x 12..16 y 4..8, 1 loops
view box at 0,-10: x 2..6 y 14..18, 1 loops
use: nothing
EXPECTED
