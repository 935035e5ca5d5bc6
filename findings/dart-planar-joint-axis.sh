#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-dartpy 6.12.1+dfsg4-12+b2 (DartLoader, the URDF reader of DART).
# Input:    URDF: a link "table" on a link "base" with one joint; the joints prismatic, revolute and planar with the axis
#           along X, Y and Z, and with an oblique axis. Source: URDF specification, joint ("planar: this joint allows motion
#           in a plane perpendicular to the axis"; axis: "the surface normal for planar joints").
# Expected: The three positions of a planar joint move the table perpendicular to its axis and turn it about its axis, as
#           the axes of prismatic and revolute joints are used.
# Seen:     A planar joint ignores its axis: it always moves in X and Y and turns about Z. With the axis X, the
#           table moves along its normal. No message appears. Prismatic and revolute joints use the axis; the axis Z
#           is right.

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
fetch python3-dartpy=6.12.1+dfsg4-12+b2 python3-numpy=1:1.24.2-1+deb12u1
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import os

import dartpy
import numpy

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'


def text(values):
    return ",".join(f"{round(float(v), 2) + 0:g}" for v in values)


def rotation_axis(matrix):
    axis = numpy.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]])
    return axis / numpy.linalg.norm(axis)


def pose(kind, axis, positions):
    with open("robot.urdf", "w") as file:
        file.write(f'<robot name="r"><link name="base">{INERTIAL}</link><link name="table">{INERTIAL}</link>'
                   f'<joint name="j" type="{kind}"><parent link="base"/><child link="table"/><axis xyz="{axis}"/>'
                   f'<limit lower="-9" upper="9" effort="1" velocity="1"/></joint></robot>')
    robot = dartpy.utils.DartLoader().parseSkeleton(os.path.abspath("robot.urdf"))
    joint = robot.getJoint("j")
    for i, value in enumerate(positions):
        joint.setPosition(i, value)
    return robot.getBodyNode("table").getTransform().matrix()


for axis in ("1 0 0", "0 1 0", "0 0 1", "0 0.6 0.8"):
    normal = numpy.array([float(v) for v in axis.split()])
    print(f"axis {axis}:")
    print(f"  prismatic: moves by {text(pose('prismatic', axis, [2.0])[:3, 3])}")
    print(f"  revolute: turns about {text(rotation_axis(pose('revolute', axis, [0.5])))}")
    first, second = [pose("planar", axis, positions)[:3, 3] for positions in ([2.0, 0.0, 0.0], [0.0, 3.0, 0.0])]
    print(f"  planar: moves by {text(first)} and {text(second)}, "
          f"along the axis by {abs(first @ normal):.1f} and {abs(second @ normal):.1f}; "
          f"turns about {text(rotation_axis(pose('planar', axis, [0.0, 0.0, 0.5])))}")
PY
/usr/bin/python3 check.py 2>&1 | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
axis 1 0 0:
  prismatic: moves by 2,0,0
  revolute: turns about 1,0,0
  planar: moves by 2,0,0 and 0,3,0, along the axis by 2.0 and 0.0; turns about 0,0,1
axis 0 1 0:
  prismatic: moves by 0,2,0
  revolute: turns about 0,1,0
  planar: moves by 2,0,0 and 0,3,0, along the axis by 0.0 and 3.0; turns about 0,0,1
axis 0 0 1:
  prismatic: moves by 0,0,2
  revolute: turns about 0,0,1
  planar: moves by 2,0,0 and 0,3,0, along the axis by 0.0 and 0.0; turns about 0,0,1
axis 0 0.6 0.8:
  prismatic: moves by 0,1.2,1.6
  revolute: turns about 0,0.6,0.8
  planar: moves by 2,0,0 and 0,3,0, along the axis by 0.0 and 1.8; turns about 0,0,1
EXPECTED
