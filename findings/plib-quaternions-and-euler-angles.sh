#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libplib-dev and libplib1 1.8.5-14+b1 (PLIB, library sg: vectors, matrices, quaternions). The script calls
#           g++.
# Input:    turns by heading, pitch and roll as a matrix and as a quaternion; a turn by 120 degrees about Z as a quaternion; the
#           angles 0,90,0 as a matrix and back; two skew lines. Source: sg.h (sgMakeRotMat4 and sgEulerToQuat take "hpr";
#           "Convert a set of eulers to/from a quat"; sgHPRToQuat takes degrees; "Make an angle and axis of rotation from a
#           Quaternion"; sgRotateVecQuat: "components of a ROTATED vector in a STATIONARY coordinate system").
# Expected: sgEulerToQuat and sgHPRToQuat give the rotation of sgMakeRotMat4 with the same angles, and sgQuatToEuler returns the
#           angles. Angle and axis return from a quaternion. sgRotateVecQuat turns like sgQuatToMatrix. Angles that are read
#           from a matrix give the same matrix. Skew lines have no point of intersection.
# Seen:     sgEulerToQuat takes the angles in the order roll, pitch, heading and turns clockwise, so 90,0,0 is a turn of
#           sgQuatToEuler by 0,0,90. sgHPRToQuat converts to radians twice: 90 degrees become 1.6. The axis of a quaternion
#           returns with the opposite sign, and sgRotateVecQuat turns against sgQuatToMatrix. At a pitch of 90, a roll of 90
#           appears that the matrix does not have. Skew lines intersect at a point of the second line.

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
fetch libplib-dev=1.8.5-14+b1 libplib1=1.8.5-14+b1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries

cat >check.cpp <<'CPP'
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include <plib/sg.h>

static double rounded(float value)
{
    return std::fabs(value) < 5e-3 ? 0 : value;
}

static void show(const char* name, const float* v)
{
    std::printf("%s %.1f,%.1f,%.1f", name, rounded(v[0]), rounded(v[1]), rounded(v[2]));
}

static void turned(const char* name, sgMat4 matrix)
{
    sgVec3 from = {1, 2, 3}, to;
    sgXformPnt3(to, from, matrix);
    show(name, to);
}

int main()
{
    const sgVec3 all[] = {{90, 0, 0}, {0, 90, 0}, {0, 0, 90}, {20, 30, 40}};
    sgMat4 matrix;
    sgQuat q;
    for (const sgVec3& hpr : all) {
        sgVec3 back;
        show("angles", hpr);
        sgMakeRotMat4(matrix, hpr);
        turned(": 1,2,3 by the matrix", matrix);
        sgEulerToQuat(q, hpr);
        sgQuatToEuler(back, q);
        sgQuatToMatrix(matrix, q);
        turned(", sgEulerToQuat", matrix);
        show(" with the angles", back);
        sgHPRToQuat(q, hpr);
        sgQuatToMatrix(matrix, q);
        turned(", sgHPRToQuat", matrix);
        std::printf("\n");
    }

    const sgVec3 z = {0, 0, 1};
    sgVec3 axis, vector = {1, 2, 3};
    float angle;
    sgAngleAxisToQuat(q, 120, z);
    sgQuatToAngleAxis(&angle, axis, q);
    std::printf("120 degrees about Z: angle %.1f", angle);
    show(", axis", axis);
    sgQuatToMatrix(matrix, q);
    turned(", 1,2,3 by sgQuatToMatrix", matrix);
    sgRotateVecQuat(vector, q);
    show(", sgRotateVecQuat", vector);
    std::printf("\n");

    for (float pitch : {89.0f, 90.0f}) {
        sgCoord coordinates;
        sgMakeRotMat4(matrix, 0, pitch, 0);
        sgSetCoord(&coordinates, matrix);
        show("angles of the matrix", coordinates.hpr);
        turned(": 1,2,3 before", matrix);
        sgMakeRotMat4(matrix, coordinates.hpr);
        turned(", after", matrix);
        std::printf("\n");
    }

    sgVec3 origin = {0, 0, 0}, along = {1, 1, 0}, other = {0, 10, 5}, across = {1, -1, 0}, point;
    const int found = sgIsectInfLineInfLine(point, origin, along, other, across);
    std::printf("lines at the heights 0 and 5: %d", found);
    show(", point", point);
    std::printf("\n");
}
CPP
g++ -std=c++17 -w -Iroot/usr/include check.cpp "$libraries/libplibsg.so.1" "$libraries/libplibul.so.1" -o check
./check 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
angles 90.0,0.0,0.0: 1,2,3 by the matrix -2.0,1.0,3.0, sgEulerToQuat 2.0,-1.0,3.0 with the angles 0.0,0.0,90.0, sgHPRToQuat 1.1,2.0,3.0
angles 0.0,90.0,0.0: 1,2,3 by the matrix 1.0,-3.0,2.0, sgEulerToQuat -3.0,2.0,1.0 with the angles 0.0,90.0,0.0, sgHPRToQuat 0.9,2.0,3.0
angles 0.0,0.0,90.0: 1,2,3 by the matrix 3.0,2.0,-1.0, sgEulerToQuat 1.0,3.0,-2.0 with the angles 90.0,0.0,0.0, sgHPRToQuat 1.0,2.1,2.9
angles 20.0,30.0,40.0: 1,2,3 by the matrix 2.2,1.8,2.4, sgEulerToQuat -0.1,3.4,1.6 with the angles 40.0,30.0,20.0, sgHPRToQuat 1.0,2.0,3.0
120 degrees about Z: angle 120.0, axis 0.0,0.0,-1.0, 1,2,3 by sgQuatToMatrix -2.2,-0.1,3.0, sgRotateVecQuat 1.2,-1.9,3.0
angles of the matrix 0.0,89.0,0.0: 1,2,3 before 1.0,-3.0,2.1, after 1.0,-3.0,2.1
angles of the matrix 0.0,90.0,90.0: 1,2,3 before 1.0,-3.0,2.0, after 3.0,1.0,2.0
lines at the heights 0 and 5: 1, point 5.0,5.0,5.0
EXPECTED
