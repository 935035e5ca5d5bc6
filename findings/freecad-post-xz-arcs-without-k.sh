#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; workbench Path) writes;
#           linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 (rs274) reads.
# Input:    a path with two quarter arcs in the plane XZ (G18) with the centre words I and K.
# Expected: The post-processor for LinuxCNC writes I and K, as the posts grbl, marlin and uccnc do.
#           LinuxCNC reads two arcs.
# Seen:     The posts linuxcnc, mach3_mach4, smoothie, KineticNCBeamicon2 and dynapath omit K. No message appears.
#           LinuxCNC stops at the first arc: "Zero-radius arc".

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
export HOME=$work POSTS=/usr/share/freecad/Mod/Path/PathScripts/post

# Extracts pinned Debian 12 packages into ./root, without installation.
fetch() {
  mkdir -p deb root
  (cd deb && apt-get download "$@" >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch linuxcnc-uspace=2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 libboost-python1.74.0=1.74.0+ds1-21 \
  libpython3.11 # no pin: security updates replace the version

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
    command("G1", {"X": 0, "Y": 0, "Z": 0, "F": 5}),
    command("G18"),
    command("G2", {"X": 10, "Y": 0, "Z": -10, "I": 0, "K": -10, "F": 5}),
    command("G3", {"X": 20, "Y": 0, "Z": -20, "I": 10, "K": 0, "F": 5}),
    command("G17"),
])
with open("seen", "w") as seen:
    for name in ("grbl", "marlin", "uccnc", "linuxcnc", "mach3_mach4", "smoothie", "KineticNCBeamicon2", "dynapath"):
        post = importlib.import_module(name + "_post")
        post.export([operation], name + ".nc", "--no-show-editor --no-header")
        arcs = [line.strip() for line in open(name + ".nc") if line.startswith(("G2 ", "G3 "))]
        seen.write(name + ": " + " | ".join(arcs) + "\n")
PY
freecadcmd check.py </dev/null >log 2>&1 || true
export LD_LIBRARY_PATH=$work/root/usr/lib:$work/root/usr/lib/x86_64-linux-gnu
for name in grbl linuxcnc; do
  { root/usr/bin/rs274 -g $name.nc 2>&1 || true; } | grep -oE '(ARC_FEED|Zero-radius arc).*' |
    sed "s/^/rs274 reads $name.nc: /"
done >>seen
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
grbl: G2 X10.000 Y0.000 Z-10.000 I0.000 K-10.000 F300.000 | G3 X20.000 Y0.000 Z-20.000 I10.000 K0.000 F300.000
marlin: G2 X10.000 Y0.000 Z-10.000 I0.000 K-10.000 F300.000 | G3 X20.000 Y0.000 Z-20.000 I10.000 K0.000 F300.000
uccnc: G2 X10.000 Z-10.000 I0.000 K-10.000 | G3 X20.000 Z-20.000 I10.000 K0.000
linuxcnc: G2 X10.000 Y0.000 Z-10.000 I0.000 F300.000 | G3 X20.000 Y0.000 Z-20.000 I10.000 F300.000
mach3_mach4: G2 X10.000 Y0.000 Z-10.000 I0.000 F300.000 | G3 X20.000 Y0.000 Z-20.000 I10.000 F300.000
smoothie: G2 X10.0000 Y0.0000 Z-10.0000 I0.0000 F300.0000 S0.0 | G3 X20.0000 Y0.0000 Z-20.0000 I10.0000 F300.0000 S0.0
KineticNCBeamicon2: G2 X10.000 Y0.000 Z-10.000 I0.000 F300.000 | G3 X20.000 Y0.000 Z-20.000 I10.000 F300.000
dynapath: G2 X10.000 Y0.000 Z-10.000 I0.000 F300.000 | G3 X20.000 Y0.000 Z-20.000 I10.000 F300.000
rs274 reads grbl.nc: ARC_FEED(-10.0000, 10.0000, -10.0000, 0.0000, -1, 0.0000, 0.0000, 0.0000, 0.0000)
rs274 reads grbl.nc: ARC_FEED(-20.0000, 20.0000, -10.0000, 20.0000, 1, 0.0000, 0.0000, 0.0000, 0.0000)
rs274 reads linuxcnc.nc: Zero-radius arc: start=(Z0.0000,X0.0000) center=(Z0.0000,X0.0000) end=(Z-10.0000,X10.0000) r1=0.0000 r2=14.1421
EXPECTED
