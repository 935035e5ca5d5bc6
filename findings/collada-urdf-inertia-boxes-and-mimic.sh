#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, collada-urdf-tools 1.12.13-8+b2 (urdf_to_collada, collada_to_urdf).
# Input:    URDF of a machine: a base with the inertia tensor ixx 1, iyy 4, izz 4.5, ixy 0.1, ixz 0.2, iyz 0.3; a table on a
#           prismatic joint at 10,0,0, turned by 90 degrees about z, with a box of 0.2 x 0.4 x 0.6 at 0,0,2 and the damping 0.7;
#           a head whose joint mimics the table. The file is converted to COLLADA and back. Source: help of collada_to_urdf
#           ("-V: use bounding box for visual").
# Expected: The tensor in COLLADA (mass_frame and principal moments) and in the second URDF is that of the input. With -V, the
#           centre of the bounding box in the frame of the table is 0,0,2. The head keeps its mimic element, the table
#           its damping.
# Seen:     The principal moments are right, but urdf_to_collada writes the transpose of the principal axes: the tensor has
#           ixy -0.184, ixz 0.026 and iyz -0.305. With -V, the box of the table is at 10,10,2, because the rotation of the
#           joint is not applied to its centre; the box of the head is right. The mimic element is missing, and each damping is
#           0.2. No message about this appears. Axes, limits and joint positions are right.

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
fetch collada-urdf-tools=1.12.13-8+b2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work

cat >mill.urdf <<'URDF'
<?xml version="1.0"?>
<robot name="mill">
  <link name="base">
    <inertial>
      <origin xyz="0 0 0" rpy="0 0 0"/>
      <mass value="2"/>
      <inertia ixx="1" iyy="4" izz="4.5" ixy="0.1" ixz="0.2" iyz="0.3"/>
    </inertial>
    <visual><origin xyz="0 0 0.5" rpy="0 0 0"/><geometry><box size="1 2 3"/></geometry></visual>
  </link>
  <link name="table">
    <visual><origin xyz="0 0 2" rpy="0 0 0"/><geometry><box size="0.2 0.4 0.6"/></geometry></visual>
  </link>
  <link name="head">
    <visual><origin xyz="0 0 2" rpy="0 0 0"/><geometry><box size="0.2 0.4 0.6"/></geometry></visual>
  </link>
  <joint name="x" type="prismatic">
    <parent link="base"/><child link="table"/>
    <origin xyz="10 0 0" rpy="0 0 1.5707963267948966"/><axis xyz="1 0 0"/>
    <limit lower="-0.25" upper="0.75" effort="10" velocity="2"/><dynamics damping="0.7" friction="0"/>
  </joint>
  <joint name="z" type="prismatic">
    <parent link="base"/><child link="head"/>
    <origin xyz="5 0 0" rpy="0 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-0.25" upper="0.75" effort="10" velocity="2"/><mimic joint="x" multiplier="2" offset="0.1"/>
  </joint>
</robot>
URDF
root/usr/lib/collada_urdf/urdf_to_collada mill.urdf mill.dae >/dev/null 2>&1
root/usr/lib/collada_urdf/collada_to_urdf --input_file mill.dae -O back.urdf -V --mesh_output_dir "$work" \
  --mesh_prefix "file://$work" >/dev/null 2>&1

cat >check.py <<'PY'
import math
import re
import xml.etree.ElementTree as ElementTree


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def rotation(x, y, z, degrees):
    n, c, s = math.hypot(x, y, z), math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    x, y, z, t = x / n, y / n, z / n, 1 - c
    return [[t * x * x + c, t * x * y - s * z, t * x * z + s * y],
            [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c]]


def show(name, t):
    print(f"{name}: ixx {t[0][0]:.3f}, iyy {t[1][1]:.3f}, izz {t[2][2]:.3f}, "
          f"ixy {t[0][1]:.3f}, ixz {t[0][2]:.3f}, iyz {t[1][2]:.3f}")


def tensor(axes, moments):
    diagonal = [[moments[i] * (i == j) for j in range(3)] for i in range(3)]
    return product(product(axes, diagonal), [list(row) for row in zip(*axes)])


text = open("mill.dae").read()
turn, moments = re.search(r"<mass_frame>.*?<rotate>(.*?)</rotate>.*?</mass_frame>\s*<inertia>(.*?)</inertia>", text, re.S).groups()
axes = rotation(*map(float, turn.split()))
moments = [float(v) for v in moments.split()]
print(f"principal moments: {' '.join(f'{v:.3f}' for v in sorted(moments))}")
show("COLLADA", tensor(axes, moments))
show("COLLADA, axes transposed", tensor([list(row) for row in zip(*axes)], moments))
robot = ElementTree.parse("back.urdf").getroot()
inertia = robot.find("link[@name='base']/inertial/inertia").attrib
show("URDF", [[float(inertia["i" + "".join(sorted(a + b))]) for b in "xyz"] for a in "xyz"])
for name in ("table", "head"):
    visual = robot.find(f"link[@name='{name}']/visual")
    print(f"box of the {name}: centre {visual.find('origin').get('xyz')}, rpy {visual.find('origin').get('rpy')}")
for name in ("x", "z"):
    joint = robot.find(f"joint[@name='{name}']")
    print(f"joint {name}: origin {joint.find('origin').get('xyz')}, axis {joint.find('axis').get('xyz')}, limits "
          f"{joint.find('limit').get('lower')} {joint.find('limit').get('upper')}, damping "
          f"{joint.find('dynamics').get('damping')}, mimic {joint.find('mimic') is not None}")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
principal moments: 0.986 3.859 4.654
COLLADA: ixx 0.998, iyy 3.991, izz 4.511, ixy -0.184, ixz 0.026, iyz -0.305
COLLADA, axes transposed: ixx 1.000, iyy 4.000, izz 4.500, ixy 0.100, ixz 0.200, iyz 0.300
URDF: ixx 0.998, iyy 3.991, izz 4.511, ixy -0.184, ixz 0.026, iyz -0.305
box of the table: centre 10 10 2, rpy 0 -0 1.5708
box of the head: centre 0 0 2, rpy 0 -0 0
joint x: origin 10 0 0, axis 1 0 0, limits -0.25 0.75, damping 0.2, mimic False
joint z: origin 5 0 0, axis 0 0 1, limits -0.25 0.75, damping 0.2, mimic False
EXPECTED
