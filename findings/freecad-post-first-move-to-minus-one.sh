#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; workbench Path, post-processors).
# Input:    a path that starts at the corner X-1 Y-1: G0 Z5, G0 X-1 Y-1, G1 Z-3, G1 X20.
# Expected: The first rapid move to X-1 Y-1 is written, because the position before it is unknown. X-2 Y-2 is written.
# Seen:     The posts that omit repeated words take X-1 Y-1 Z-1 as the position before the program. So fanuc and
#           uccnc, and linuxcnc and mach3_mach4 with --axis-modal, omit the move to X-1 Y-1.
#           The tool plunges at the position where it is. No message appears.

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
posts = [("linuxcnc", ""), ("linuxcnc", " --axis-modal"), ("mach3_mach4", " --axis-modal")]
posts += [("fanuc", ""), ("uccnc", "")]
with open("seen", "w") as seen:
    for name, option in posts:
        for corner in (-2, -1):
            operation.Path = Path.Path([
                command("G0", {"Z": 5}),
                command("G0", {"X": corner, "Y": corner}),
                command("G1", {"Z": -3, "F": 5}),
                command("G1", {"X": 20, "Y": corner, "F": 5}),
            ])
            post = importlib.import_module(name + "_post")
            post.export([operation], "out.nc", "--no-show-editor --no-header" + option)
            lines = [line.strip() for line in open("out.nc")]
            first = next(i for i, line in enumerate(lines) if line.startswith("G0 Z5"))
            blocks = [line for line in lines[first : first + 4] if line.startswith(("G0", "G1", "X"))]
            seen.write(f"{name}{option}, corner {corner}: " + " | ".join(blocks) + "\n")
PY
freecadcmd check.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
linuxcnc, corner -2: G0 Z5.000 | G0 X-2.000 Y-2.000 | G1 Z-3.000 F300.000 | G1 X20.000 Y-2.000 F300.000
linuxcnc, corner -1: G0 Z5.000 | G0 X-1.000 Y-1.000 | G1 Z-3.000 F300.000 | G1 X20.000 Y-1.000 F300.000
linuxcnc --axis-modal, corner -2: G0 Z5.000 | G0 X-2.000 Y-2.000 | G1 Z-3.000 F300.000 | G1 X20.000
linuxcnc --axis-modal, corner -1: G0 Z5.000 | G0 | G1 Z-3.000 F300.000 | G1 X20.000
mach3_mach4 --axis-modal, corner -2: G0 Z5.000 | G0 X-2.000 Y-2.000 | G1 Z-3.000 F300.000 | G1 X20.000
mach3_mach4 --axis-modal, corner -1: G0 Z5.000 | G0 | G1 Z-3.000 F300.000 | G1 X20.000
fanuc, corner -2: G0 Z5.000 | X-2.000 Y-2.000 | G1 Z-3.000 F300.000 | X20.000
fanuc, corner -1: G0 Z5.000 | G1 Z-3.000 F300.000 | X20.000
uccnc, corner -2: G0 Z5.000 | G0 X-2.000 Y-2.000 | G1 Z-3.000 F300.000 | G1 X20.000
uccnc, corner -1: G0 Z5.000 | G0 | G1 Z-3.000 F300.000 | G1 X20.000
EXPECTED
