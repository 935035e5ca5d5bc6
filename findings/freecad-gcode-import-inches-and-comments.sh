#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; workbench Path, G-code import gcode_pre).
# Input:    three programs for one tool: G20 with two moves; a block "G90 G1 X5 Y5"; a move with a comment at its end.
# Expected: Inches become millimetres: X25.4 and X50.8. Each block with X or Y gives a move.
# Seen:     G20 is dropped and the numbers are kept: X1 and X2 are millimetres. "G90 G1 X5 Y5" becomes the command G90
#           with the word G1, which is not a move (path length 0). "G1 Y10 (end)" becomes the comment "(10end)".
#           No error is raised.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
export HOME=$work POSTS=/usr/share/freecad/Mod/Path/PathScripts/post

cat >check.py <<'PY'
import os
import sys

import FreeCAD
import PathScripts.PathJob as PathJob

sys.path.append(os.environ["POSTS"])
import gcode_pre

programs = ["G20|M6 T1|G1 X1 F10|G1 X2", "G21|M6 T1|G90 G1 X5 Y5 F100", "G21|M6 T1|G1 X5 F100|G1 Y10 (end)"]
with open("seen", "w") as seen:
    for program in programs:
        document = FreeCAD.newDocument()
        box = document.addObject("Part::Box", "Box")
        document.recompute()
        job = PathJob.Create("Job", [box], None)
        with open("in.nc", "w") as file:
            file.write(program.replace("|", "\n") + "\n")
        gcode_pre.insert("in.nc", document.Name)
        for operation in job.Operations.Group:
            commands = []
            for command in operation.Path.Commands:
                words = [f"{letter}{value:g}" for letter, value in command.Parameters.items()]
                commands.append(" ".join([command.Name, *words]))
            seen.write(f"{program} -> {'|'.join(commands[2:-1])}; length {operation.Path.Length:.2f}\n")
        FreeCAD.closeDocument(document.Name)
PY
freecadcmd check.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
G20|M6 T1|G1 X1 F10|G1 X2 -> G1 F10 X1|G1 X2; length 2.00
G21|M6 T1|G90 G1 X5 Y5 F100 -> G90 F100 G1 X5 Y5; length 0.00
G21|M6 T1|G1 X5 F100|G1 Y10 (end) -> G1 F100 X5|(10end); length 5.00
EXPECTED
