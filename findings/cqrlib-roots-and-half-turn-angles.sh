#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libcqrlib-dev 1.1.4-3 (quaternions in C).
# Input:    cube and square roots of -8, 8 and -4; Euler angles with RotY 90 and -90, converted to a quaternion and back, with three
#           contents of the variables for the result. Source: cqrlib.h (CQRIntegerRoot: "For reals the cycle runs through first the
#           i-based roots, then the j-based roots and then the k-based roots", CQRQuaternion2Angles).
# Expected: The power of each root is the number. The angles are those of the same rotation, whatever the variables contained.
# Seen:     The cube of the j-based and k-based roots of -8 is 7.73,0.34,2.03,0 to 7.96,0.05,0,0.78; those of 8 are right. If the
#           variable for RotZ contains 180 degrees before the call, RotY -90 becomes 90 and RotY 90 becomes 270: the
#           rotation is different by a half turn. With 0 in the variables, all angles are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

apt-get download libcqrlib-dev=1.1.4-3 >/dev/null 2>log || { cat log >&2; exit 2; }
dpkg -x ./*.deb root

cat >check.c <<'C'
#include <cqrlib.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double degree = M_PI / 180;

static void root(double number, int degree_of_root, int index) {
  CQRQuaternion value = {number, 0, 0, 0}, root, power;
  CQRIntegerRoot(&root, &value, degree_of_root, index);
  CQRIntegerPower(&power, &root, degree_of_root);
  printf("root %d of %g, %d: power %.2f,%.2f,%.2f,%.2f\n", degree_of_root, number, index, power.w + 0.0, fabs(power.x),
         fabs(power.y), fabs(power.z));
}

static void angles(double x, double y, double z, double before_x, double before_z) {
  CQRQuaternion turn, back;
  double rx = before_x * degree, ry = 0, rz = before_z * degree, dot;
  CQRAngles2Quaternion(&turn, x * degree, y * degree, z * degree);
  CQRQuaternion2Angles(&rx, &ry, &rz, &turn);
  CQRAngles2Quaternion(&back, rx, ry, rz);
  CQRDot(&dot, &turn, &back);
  printf("%g,%g,%g, variables %g,0,%g: %.0f,%.0f,%.0f, difference %.0f degrees\n", x, y, z, before_x, before_z,
         rx / degree, ry / degree, rz / degree, 2 * acos(fmin(1, fabs(dot))) / degree);
}

int main(void) {
  for (int index = 0; index < 9; ++index) root(-8, 3, index);
  for (int index = 3; index < 9; ++index) root(8, 3, index);
  for (int index = 0; index < 6; ++index) root(-4, 2, index);
  for (int index = 0; index < 3; ++index) {
    double before_z = index == 1 ? 180 : 0, before_x = index == 2 ? 180 : 0;
    angles(20, -90, 50, before_x, before_z);
    angles(20, 90, 50, before_x, before_z);
    angles(0, 90, 0, before_x, before_z);
    angles(20, 40, 50, before_x, before_z);
  }
}
C
gcc -Iroot/usr/include check.c root/usr/lib/x86_64-linux-gnu/libCQRlib.a -o check -lm
./check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
root 3 of -8, 0: power -8.00,0.00,0.00,0.00
root 3 of -8, 1: power -8.00,0.00,0.00,0.00
root 3 of -8, 2: power -8.00,0.00,0.00,0.00
root 3 of -8, 3: power 7.73,0.34,2.03,0.00
root 3 of -8, 4: power 7.85,0.19,1.54,0.00
root 3 of -8, 5: power 7.90,0.12,1.24,0.00
root 3 of -8, 6: power 7.93,0.09,0.00,1.04
root 3 of -8, 7: power 7.95,0.06,0.00,0.89
root 3 of -8, 8: power 7.96,0.05,0.00,0.78
root 3 of 8, 3: power 8.00,0.00,0.00,0.00
root 3 of 8, 4: power 8.00,0.00,0.00,0.00
root 3 of 8, 5: power 8.00,0.00,0.00,0.00
root 3 of 8, 6: power 8.00,0.00,0.00,0.00
root 3 of 8, 7: power 8.00,0.00,0.00,0.00
root 3 of 8, 8: power 8.00,0.00,0.00,0.00
root 2 of -4, 0: power -4.00,0.00,0.00,0.00
root 2 of -4, 1: power -4.00,0.00,0.00,0.00
root 2 of -4, 2: power 3.70,0.37,1.46,0.00
root 2 of -4, 3: power 3.87,0.17,1.01,0.00
root 2 of -4, 4: power 3.92,0.10,0.00,0.77
root 2 of -4, 5: power 3.95,0.06,0.00,0.62
20,-90,50, variables 0,0,0: 70,-90,0, difference 0 degrees
20,90,50, variables 0,0,0: -30,90,0, difference 0 degrees
0,90,0, variables 0,0,0: 0,90,0, difference 0 degrees
20,40,50, variables 0,0,0: 20,40,50, difference 0 degrees
20,-90,50, variables 0,0,180: 250,90,180, difference 180 degrees
20,90,50, variables 0,0,180: 150,270,180, difference 180 degrees
0,90,0, variables 0,0,180: 180,270,180, difference 180 degrees
20,40,50, variables 0,0,180: 20,40,50, difference 0 degrees
20,-90,50, variables 180,0,0: 70,-90,0, difference 0 degrees
20,90,50, variables 180,0,0: -30,90,0, difference 0 degrees
0,90,0, variables 180,0,0: 180,270,180, difference 180 degrees
20,40,50, variables 180,0,0: 20,40,50, difference 0 degrees
EXPECTED
