#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; workbench Path, post-processors).
# Input:    a path in millimetres and degrees: G1 X25.4 A180, a dwell G4 P2, a cycle G82 P1.5; option --inches.
# Expected: --inches converts lengths and feeds only: X1 A180, P2, P1.5, as the post grbl does for A and P.
# Seen:     linuxcnc, mach3_mach4 and KineticNCBeamicon2 divide the angle and the dwell by 25.4 also:
#           A7.0866 instead of A180 and P0.0787 instead of P2. No message appears.

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
    command("G1", {"X": 25.4, "A": 180, "F": 5}),
    command("G4", {"P": 2}),
    command("G82", {"X": 50.8, "Z": -5.08, "R": 2.54, "P": 1.5, "F": 5}),
])
with open("seen", "w") as seen:
    for name in ("grbl", "linuxcnc", "mach3_mach4", "KineticNCBeamicon2"):
        post = importlib.import_module(name + "_post")
        post.export([operation], "out.nc", "--no-show-editor --no-header --inches")
        blocks = [line.strip() for line in open("out.nc") if line.startswith(("G1 ", "G4 ", "G82 "))]
        seen.write(name + ": " + " | ".join(blocks) + "\n")
PY
freecadcmd check.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
grbl: G1 X1.0000 A180.0000 F11.8110 | G4 P2.0 | G82 X2.0000 Z-0.2000 F11.8110 R0.1000 P1.5
linuxcnc: G1 X1.0000 A7.0866 F11.8110 | G4 P0.0787 | G82 X2.0000 Z-0.2000 F11.8110 R0.1000 P0.0591
mach3_mach4: G1 X1.0000 A7.0866 F11.8110 | G4 P0.0787 | G82 X2.0000 Z-0.2000 F11.8110 R0.1000 P0.0591
KineticNCBeamicon2: G1 X1.0000 A7.0866 F11.8110 | G4 P0.0787 | G82 X2.0000 Z-0.2000 F11.8110 R0.1000 P0.0591
EXPECTED
