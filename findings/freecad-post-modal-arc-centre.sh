#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; workbench Path, posts fanuc and uccnc).
# Input:    a path with two half circles that have the same centre offset I5 J0, then a circle with I-5 J0.
# Expected: Each G2 and G3 block has its centre words. On Fanuc controls, I and J are not modal.
# Seen:     Both posts omit words that repeat the value of the earlier block, I and J included. The second half circle
#           becomes "X21.000" (fanuc) and "G2 X21.000" (uccnc): an arc without a centre.
#           The post linuxcnc writes the words.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
export HOME=$work POSTS=/usr/share/freecad/Mod/Path/PathScripts/post

cat >check.py <<'PY'
import importlib
import os
import sys

import FreeCAD
import Path

sys.path.append(os.environ["POSTS"])
document = FreeCAD.newDocument()
operation = document.addObject("Path::FeaturePython", "operation")
command = Path.Command
operation.Path = Path.Path([
    command("G0", {"Z": 5}),
    command("G1", {"X": 1, "Y": 0, "Z": -2, "F": 10}),
    command("G2", {"X": 11, "Y": 0, "Z": -2, "I": 5, "J": 0, "F": 10}),
    command("G2", {"X": 21, "Y": 0, "Z": -2, "I": 5, "J": 0, "F": 10}),
    command("G3", {"X": 21, "Y": 0, "Z": -2, "I": -5, "J": 0, "F": 10}),
])
with open("seen", "w") as seen:
    for name in ("linuxcnc", "fanuc", "uccnc"):
        post = importlib.import_module(name + "_post")
        post.export([operation], "out.nc", "--no-show-editor --no-header")
        lines = [line.strip() for line in open("out.nc")]
        first = next(i for i, line in enumerate(lines) if line.startswith("G1 "))
        seen.write(name + ": " + " | ".join(lines[first : first + 4]) + "\n")
PY
freecadcmd check.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
linuxcnc: G1 X1.000 Y0.000 Z-2.000 F600.000 | G2 X11.000 Y0.000 Z-2.000 I5.000 J0.000 F600.000 | G2 X21.000 Y0.000 Z-2.000 I5.000 J0.000 F600.000 | G3 X21.000 Y0.000 Z-2.000 I-5.000 J0.000 F600.000
fanuc: G1 X1.000 Y0.000 Z-2.000 F600.000 | G2 X11.000 I5.000 J0.000 | X21.000 | G3 I-5.000
uccnc: G1 X1.000 Y0.000 Z-2.000 F600.000 | G2 X11.000 I5.000 J0.000 | G2 X21.000 | G3 I-5.000
EXPECTED
