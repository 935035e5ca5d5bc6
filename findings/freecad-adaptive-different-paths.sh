#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; workbench Path, operation Adaptive).
# Input:    a rectangular pocket of 40 x 20 x 10, with the standard tool; the same script in four processes.
# Expected: The same program each time, as with the operation Pocket.
# Seen:     Adaptive gives different paths: the number of commands differs by less than 1 %, and so do the coordinates.
#           So a program that is posted again differs from the program that was simulated. Pocket gives one path.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
export HOME=$work

cat >make.py <<'PY'
import FreeCAD
import PathScripts.PathAdaptive as PathAdaptive
import PathScripts.PathJob as PathJob
import PathScripts.PathPocketShape as PathPocketShape

document = FreeCAD.newDocument()
block = document.addObject("Part::Box", "Block")
block.Length, block.Width, block.Height = 60, 40, 20
pocket = document.addObject("Part::Box", "Pocket")
pocket.Length, pocket.Width, pocket.Height = 40, 20, 10
pocket.Placement.Base = FreeCAD.Vector(10, 10, 10)
part = document.addObject("Part::Cut", "Part")
part.Base, part.Tool = block, pocket
document.recompute()
job = PathJob.Create("Job", [part], None)
model = job.Model.Group[0]
floor = [f"Face{i + 1}" for i, face in enumerate(model.Shape.Faces) if face.BoundBox.ZMin == face.BoundBox.ZMax == 10]
for name, module in (("adaptive", PathAdaptive), ("pocket", PathPocketShape)):
    operation = module.Create("Operation_" + name)
    operation.Base = [(model, floor)]
    operation.ToolController = job.Tools.Group[0]
    document.recompute()
    with open(name + ".nc", "w") as program:
        program.write(operation.Path.toGCode())
PY
for run in 1 2 3 4; do
  freecadcmd make.py </dev/null >log 2>&1 || true
  for name in adaptive pocket; do mv $name.nc $name-$run.nc; done
done
wc -l ./*.nc | head -n -1
# Counts the different programs of one operation.
different() { sha256sum "$1"-?.nc | cut -d ' ' -f 1 | sort -u | wc -l; }
[ "$(different pocket)" = 1 ] || { echo 'pocket: behaviour changed' >&2; exit 1; }
[ "$(different adaptive)" -gt 1 ] || { echo 'adaptive: behaviour changed' >&2; exit 1; }
