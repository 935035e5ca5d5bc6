#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; workbench Path, dressup "Ramp entry").
# Input:    a profile around a box of 60 x 40 x 20 with the dressup; property Angle ("Angle of ramp"): 5, 60 and 85.
# Expected: A ramp angle is the angle between the ramp and the plane XY: Angle 5 descends at 5 degrees at most.
# Seen:     The angle is measured from the tool axis: Angle 5 descends at 85 degrees (almost a plunge), and Angle 85
#           at about 5 degrees. The method "Helix" ignores the property: the three paths are equal.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
export HOME=$work

cat >check.py <<'PY'
import math

import FreeCAD
import PathScripts.PathDressupRampEntry as PathDressupRampEntry
import PathScripts.PathJob as PathJob
import PathScripts.PathProfile as PathProfile

document = FreeCAD.newDocument()
box = document.addObject("Part::Box", "Box")
box.Length, box.Width, box.Height = 60, 40, 20
document.recompute()
job = PathJob.Create("Job", [box], None)
profile = PathProfile.Create("Profile")
profile.ToolController = job.Tools.Group[0]
profile.setExpression("StepDown", None)
profile.StepDown = 5
profile.setExpression("FinalDepth", None)
profile.FinalDepth = 10
document.recompute()


# Returns the steepest slope of the straight descents and the word text of the path.
def ramp(method, angle):
    dressup = document.addObject("Path::FeaturePython", "RampEntryDressup")
    proxy = PathDressupRampEntry.ObjectDressup(dressup)
    dressup.Base = profile
    job.Proxy.addOperation(dressup, profile)
    proxy.setup(dressup)
    dressup.Method, dressup.Angle = method, angle
    document.recompute()
    at, steepest = None, 0.0
    for command in dressup.Path.Commands:
        words = command.Parameters
        if at and command.Name == "G1" and words.get("Z", at["Z"]) < at["Z"] - 1e-6:
            to = {**at, **words}
            length = math.hypot(to["X"] - at["X"], to["Y"] - at["Y"])
            steepest = max(steepest, math.degrees(math.atan2(at["Z"] - to["Z"], length)))
        at = {"X": 0, "Y": 0, "Z": 0, **(at or {}), **words}
    text = dressup.Path.toGCode()
    document.removeObject(dressup.Name)
    return steepest, text


with open("seen", "w") as seen:
    for angle in (5, 60, 85):
        seen.write(f"RampMethod3, Angle {angle}: steepest descent {ramp('RampMethod3', angle)[0]:.0f} degrees\n")
    helices = {ramp("Helix", angle)[1] for angle in (5, 60, 85)}
    seen.write(f"Helix, three angles: {len(helices)} different paths\n")
PY
freecadcmd check.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
RampMethod3, Angle 5: steepest descent 85 degrees
RampMethod3, Angle 60: steepest descent 31 degrees
RampMethod3, Angle 85: steepest descent 6 degrees
Helix, three angles: 1 different paths
EXPECTED
