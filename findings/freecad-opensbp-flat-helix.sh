#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; workbench Path, post opensbp for ShopBot).
# Input:    a helix of two turns from Z0 to Z-4, then a full circle at Z-4, then a straight move at Z-4.
# Expected: Each CG command of the helix has the plunge of its turn (the command has a parameter for the plunge).
# Seen:     The Z word of an arc is ignored: all three turns are flat circles at Z0. The straight move is written
#           without Z also, because the post takes the Z of the arc as reached. So the whole path runs at Z0.
#           No message appears.

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
    command("G0", {"X": 10, "Y": 10, "Z": 5}),
    command("G1", {"X": 10, "Y": 10, "Z": 0, "F": 10}),
    command("G3", {"X": 10, "Y": 10, "Z": -2, "I": -5, "J": 0, "F": 10}),
    command("G3", {"X": 10, "Y": 10, "Z": -4, "I": -5, "J": 0, "F": 10}),
    command("G3", {"X": 10, "Y": 10, "Z": -4, "I": -5, "J": 0, "F": 10}),
    command("G1", {"X": 30, "Y": 10, "Z": -4, "F": 10}),
    command("G0", {"X": 30, "Y": 10, "Z": 5}),
])
post = importlib.import_module("opensbp_post")
post.export([operation], "seen", "--no-show-editor --no-header")
PY
freecadcmd check.py </dev/null >log 2>&1 || true
sed -i '/^ *$/d' seen
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
J3,10.0000,10.0000,5.0000
MS,,10.000000
MZ,0.0000
CG,,10.0000,10.0000,-5.0000,0.0000,T,-1
CG,,10.0000,10.0000,-5.0000,0.0000,T,-1
CG,,10.0000,10.0000,-5.0000,0.0000,T,-1
MS,10.000000,
MX,30.0000
JZ,5.0000
EXPECTED
