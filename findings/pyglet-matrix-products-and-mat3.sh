#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-pyglet 1.5.27+ds-2 (pyglet.math). Python 3.11.
# Input:    a translation by 1,2,3 and a turn by 90 degrees about Z, applied to 1,0,0 one after the other and as a product; the
#           methods of Mat3 and Mat4; the view from 0,0,5 to the origin. Source: docstrings (Mat3 and Mat4: "Matrix multiplication
#           must be performed using the @ operator"; methods scale(sx, sy), translate(tx, ty), look_at(position, target, up)).
# Expected: The product of matrices is associative with the product by a vector: (T @ R) @ v is T @ (R @ v), 1,3,3. Mat3.scale(2, 4)
#           makes 1,1 to 2,4, and Mat3.translate(3, 4) moves 1,1 to 4,5. look_at returns a matrix.
# Seen:     T @ (R @ v) is 1,3,3, but (T @ R) @ v is -2,2,3, the product in the opposite order. Mat3.scale divides: 1,1 becomes
#           0.5,0.25. Mat3.translate moves X in the opposite direction, to -2,5. Of the methods of Mat4, rotate and translate are
#           applied after the matrix, scale before it. look_at and look_at_direction are an AttributeError.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts pinned Debian 12 packages into ./root, without installation.
fetch() {
  mkdir -p deb root
  (cd deb && apt-get download "$@" >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch python3-pyglet=1.5.27+ds-2
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import math

from pyglet.math import Mat3, Mat4, Vec3, Vec4


def show(name, compute, size=3):
    try:
        text = ",".join("%g" % (round(value, 6) + 0) for value in compute()[:size])
    except AttributeError as error:
        text = "AttributeError: %s" % error
    print("%s: %s" % (name, text))


quarter, z = math.pi / 2, Vec3(0, 0, 1)
t, r = Mat4.from_translation(Vec3(1, 2, 3)), Mat4.from_rotation(quarter, z)
v = Vec4(1, 0, 0, 1)
show("T @ v", lambda: t @ v)
show("R @ v", lambda: r @ v)
show("T @ (R @ v)", lambda: t @ (r @ v))
show("(T @ R) @ v", lambda: (t @ r) @ v)
show("R @ (T @ v)", lambda: r @ (t @ v))
show("(R @ T) @ v", lambda: (r @ t) @ v)
show("T.rotate @ v", lambda: t.rotate(quarter, z) @ v)
show("R.translate @ v", lambda: r.translate(Vec3(1, 2, 3)) @ v)
show("T.scale by 2 @ v", lambda: t.scale(Vec3(2, 2, 2)) @ v)
show("look_at", lambda: Mat4.look_at(Vec3(0, 0, 5), Vec3(0, 0, 0), Vec3(0, 1, 0)) @ v)
show("look_at_direction", lambda: Mat4.look_at_direction(Vec3(0, 0, -1), Vec3(0, 1, 0)) @ v)
one = Vec3(1, 1, 1)
show("Mat3 scale by 2,4", lambda: Mat3().scale(2, 4) @ one, 2)
show("Mat3 translate by 3,4", lambda: Mat3().translate(3, 4) @ one, 2)
show("Mat3 rotate by 90", lambda: Mat3().rotate(90) @ one, 2)
show("Mat3 shear by 2,0", lambda: Mat3().shear(2, 0) @ one, 2)
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
T @ v: 2,2,3
R @ v: 0,1,0
T @ (R @ v): 1,3,3
(T @ R) @ v: -2,2,3
R @ (T @ v): -2,2,3
(R @ T) @ v: 1,3,3
T.rotate @ v: -2,2,3
R.translate @ v: 1,3,3
T.scale by 2 @ v: 3,2,3
look_at: AttributeError: 'Vec3' object has no attribute 'cross_product'
look_at_direction: AttributeError: 'Vec3' object has no attribute 'cross_product'
Mat3 scale by 2,4: 0.5,0.25
Mat3 translate by 3,4: -2,5
Mat3 rotate by 90: -1,1
Mat3 shear by 2,0: 3,1
EXPECTED
