#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-pyrr 0.10.3-5 (3D geometry: matrices, quaternions, rays, boxes).
# Input:    rotations by +90 degrees about X, Y and Z from five functions, applied to the next axis; Euler angles about one axis;
#           quaternions of length 2 and 1; rays along +X. Source: the docstrings of create_from_x_rotation ("a matrix with the
#           specified rotation about the X axis"), create_from_axis_rotation, quaternion.inverse, point_closest_point_on_ray ("The
#           point on a ray that is closest to a point"), ray_intersect_aabb.
# Expected: All functions turn in the same direction about the same axis. A quaternion times its inverse is 1. The point of
#           a ray that is nearest to a point behind its start is the start. A ray in a side of a box meets the box.
# Seen:     create_from_z_rotation of a matrix turns 1,0,0 to 0,-1,0, create_from_axis_rotation about 0,0,1 to 0,1,0. A matrix
#           from a quaternion turns opposite to the quaternion. Euler angles about Y turn a quaternion about Y and a matrix about
#           Z. A quaternion of length 2 times its inverse is 2. The nearest point of the ray is 5 behind its start. A ray in
#           the side y = 1 misses the box, with a NaN warning. The power 2 of the identity is an AssertionError.

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
fetch python3-pyrr=0.10.3-5
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/lapack:$libraries/blas PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import numpy
from pyrr import euler, geometric_tests, matrix33, quaternion


def text(vector):
    return ",".join(f"{round(float(x), 3) + 0:g}" for x in vector)


def turned(rotation, vector):
    module = quaternion if len(rotation) == 4 else matrix33
    return text(module.apply_to_vector(rotation, vector))


axes = numpy.identity(3)
right = numpy.pi / 2
for i, name in enumerate("xyz"):
    axis, vector = axes[i], axes[(i + 1) % 3]
    angles = getattr(euler, f"create_from_{name}_rotation")(right)
    turns = [getattr(quaternion, f"create_from_{name}_rotation")(right), quaternion.create_from_eulers(angles),
             matrix33.create_from_axis_rotation(axis, right), getattr(matrix33, f"create_from_{name}_rotation")(right),
             matrix33.create_from_quaternion(quaternion.create_from_axis_rotation(axis, right)),
             matrix33.create_from_eulers(angles)]
    print(f"90 about {name}, {text(vector)}: quaternion {turned(turns[0], vector)}, of Euler angles {turned(turns[1], vector)}")
    print(f"  matrix of axis {turned(turns[2], vector)}, of {name} rotation {turned(turns[3], vector)},"
          f" of quaternion {turned(turns[4], vector)}, of Euler angles {turned(turns[5], vector)}")

for length in (1.0, 2.0):
    q = quaternion.create_from_z_rotation(right) * length
    print(f"length {length:g}: times its inverse {text(quaternion.cross(q, quaternion.inverse(q)))}")
try:
    print("identity, power 2:", text(quaternion.power(quaternion.create(), 2)))
except AssertionError:
    print("identity, power 2: AssertionError")

ray = numpy.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
print("nearest point of the ray to -5,3,0:", text(geometric_tests.point_closest_point_on_ray([-5.0, 3.0, 0.0], ray)))
box = numpy.array([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]])
for y in (0.5, 0.999, 1.0):
    point = geometric_tests.ray_intersect_aabb(numpy.array([[-5.0, y, 0.5], [1.0, 0.0, 0.0]]), box)
    print(f"ray at y {y:g} meets the box:", "no" if point is None else text(point))
PY
/usr/bin/python3 -W ignore check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
90 about x, 0,1,0: quaternion 0,0,1, of Euler angles 0,0,1
  matrix of axis 0,0,1, of x rotation 0,0,-1, of quaternion 0,0,-1, of Euler angles 0,0,-1
90 about y, 0,0,1: quaternion 1,0,0, of Euler angles 1,0,0
  matrix of axis 1,0,0, of y rotation -1,0,0, of quaternion -1,0,0, of Euler angles 0,0,1
90 about z, 1,0,0: quaternion 0,1,0, of Euler angles 0,1,0
  matrix of axis 0,1,0, of z rotation 0,-1,0, of quaternion 0,-1,0, of Euler angles 0,0,1
length 1: times its inverse 0,0,0,1
length 2: times its inverse 0,0,0,2
identity, power 2: AssertionError
nearest point of the ray to -5,3,0: -5,0,0
ray at y 0.5 meets the box: 0,0.5,0.5
ray at y 0.999 meets the box: 0,0.999,0.5
ray at y 1 meets the box: no
EXPECTED
