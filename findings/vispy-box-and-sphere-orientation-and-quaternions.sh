#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-vispy 0.6.6-3 with python3-numpy (vispy.geometry, vispy.util.quaternion and
#           vispy.visuals.transforms). Python 3.11.
# Input:    the solids of vispy.geometry: a box 2 x 3 x 4, a cube, spheres of radius 2 by three methods, a tube and a cone;
#           planes of six directions; turns by 90 degrees. Source: docstrings (create_box: "Generate vertices & indices for a
#           filled and outlined box"; create_plane: direction of the plane; create_from_euler_angles(rx, ry, rz);
#           create_from_axis_angle; get_matrix: "4x4 homography matrix that represents the rotation").
# Expected: All faces of a solid have one orientation and agree with their normals: the volume of the box is 24, of a sphere
#           about 33. Normals of a tube point outwards. rx turns about X, rz about Z. A turn about 0,0,2 is a turn about 0,0,1.
#           A matrix of a quaternion turns a point like the quaternion.
# Seen:     Half of the faces of the box point inwards and disagree with their normals, and half of the sphere of the method
#           cube: both volumes are 0. Tube and cone are inside out. Planes of the directions -x, -y and -z have faces against
#           their normals. create_from_euler_angles turns rx about Z and rz about X. The length of an axis changes the angle: 90
#           degrees about 0,0,2 are 127. The matrix turns in the opposite direction. Cube, the other spheres and the direction
#           of rotate_point are right.

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
fetch python3-vispy=0.6.6-3 python3-numpy=1:1.24.2-1+deb12u1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/lapack:$libraries/blas PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import numpy
from vispy.geometry import generation
from vispy.util.quaternion import Quaternion
from vispy.visuals.transforms import MatrixTransform


def cross(vertices, faces):
    a, b, c = (vertices[faces[:, i]].astype(float) for i in range(3))
    return a, numpy.cross(b - a, c - a) / 2


def solid(name, mesh):
    if isinstance(mesh, tuple):
        vertices, faces, normals = mesh[0]["position"], mesh[1], mesh[0]["normal"]
    else:
        vertices, faces, normals = mesh.get_vertices(), mesh.get_faces(), mesh.get_vertex_normals()
    a, areas = cross(vertices, faces)
    agree = (areas * normals[faces[:, 0]]).sum(1) > 0
    middle = (vertices.max(0) + vertices.min(0)) / 2
    outwards = (areas * (vertices[faces].mean(1) - middle)).sum(1) > 1e-9
    print("%s: volume %.2f, %d of %d faces outwards, %d agree with their normals"
          % (name, (a * areas).sum() / 3, outwards.sum(), len(faces), agree.sum()))


solid("cube", generation.create_cube())
solid("box 2 x 3 x 4", generation.create_box(2, 3, 4))
for method in ["latitude", "ico", "cube"]:
    solid("sphere, method " + method, generation.create_sphere(20, 20, radius=2, method=method))
solid("tube", generation.create_cylinder(4, 32, [2, 2], 5))
solid("cone", generation.create_cone(32, 2, 5))
for direction in ["+x", "-x", "+y", "-y", "+z", "-z"]:
    data, faces, _ = generation.create_plane(2, 3, direction=direction)
    up, area = data["normal"][0], cross(data["position"], faces)[1].sum(0)
    print("plane %s: normal %s, area of the faces %s" % (direction, *(numpy.array2string(v + 0, precision=0) for v in (up, area))))


def text(point):
    return ",".join("%.2f" % (round(value, 6) + 0) for value in tuple(point)[:3])


for angles in [(90, 0, 0), (0, 90, 0), (0, 0, 90)]:
    print("angles %s: 1,2,3 to %s" % (angles, text(Quaternion.create_from_euler_angles(*angles, degrees=True).rotate_point((1, 2, 3)))))
for length in [1, 2]:
    turn = Quaternion.create_from_axis_angle(90, 0, 0, length, degrees=True)
    print("90 degrees about 0,0,%d: 1,0,0 to %s, by the matrix %s"
          % (length, text(turn.rotate_point((1, 0, 0))), text(MatrixTransform(turn.get_matrix()).map([1, 0, 0]))))
PY
/usr/bin/python3 check.py 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
cube: volume 8.00, 12 of 12 faces outwards, 12 agree with their normals
box 2 x 3 x 4: volume 0.00, 6 of 12 faces outwards, 6 agree with their normals
sphere, method latitude: volume 32.89, 760 of 760 faces outwards, 760 agree with their normals
sphere, method ico: volume 33.22, 1280 of 1280 faces outwards, 1280 agree with their normals
sphere, method cube: volume 0.00, 1600 of 3200 faces outwards, 3200 agree with their normals
tube: volume -41.60, 0 of 256 faces outwards, 256 agree with their normals
cone: volume -20.81, 0 of 32 faces outwards, 32 agree with their normals
plane +x: normal [1. 0. 0.], area of the faces [6. 0. 0.]
plane -x: normal [-1.  0.  0.], area of the faces [6. 0. 0.]
plane +y: normal [0. 1. 0.], area of the faces [0. 6. 0.]
plane -y: normal [ 0. -1.  0.], area of the faces [0. 6. 0.]
plane +z: normal [0. 0. 1.], area of the faces [0. 0. 6.]
plane -z: normal [ 0.  0. -1.], area of the faces [0. 0. 6.]
angles (90, 0, 0): 1,2,3 to -2.00,1.00,3.00
angles (0, 90, 0): 1,2,3 to 3.00,2.00,-1.00
angles (0, 0, 90): 1,2,3 to 1.00,-3.00,2.00
90 degrees about 0,0,1: 1,0,0 to 0.00,1.00,0.00, by the matrix 0.00,-1.00,0.00
90 degrees about 0,0,2: 1,0,0 to -0.60,0.80,0.00, by the matrix -0.60,-0.80,0.00
EXPECTED
