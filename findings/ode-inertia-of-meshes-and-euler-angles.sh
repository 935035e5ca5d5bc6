#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libode-dev 2:0.16.2-1 (Open Dynamics Engine). g++ is installed.
# Input:    a block of 2 x 4 x 6 with the density 1: as a box that is moved by 1,2,3, and as a triangle mesh of 12 triangles, centred, with
#           a corner at the origin, and far away; rotations by 90 degrees about X, Y and Z from Euler angles and from an axis. Source:
#           mass.h (dMassSetTrimesh, dMassTranslate), rotation.h (dRFromEulerAngles, dRFromAxisAndAngle).
# Expected: The mass of the mesh equals the mass of the moved box: 48 at 1,2,3 with the inertia 832,640,320 about the origin. Moved back
#           to its centre, its inertia is 208,160,80 without products. Both functions turn in the same direction.
# Seen:     dMassSetTrimesh adds the parallel axis term twice: the inertia is 1456,1120,560, the products are doubled. After the move
#           to the centre, the inertia is 832,640,320 with the products -96,-144,-288. 100 away, the inertia of the block about
#           its own axis along Z is 489920 instead of 80. dMassCheck accepts all of them. Only a centred mesh is right.
#           dRFromEulerAngles turns clockwise, dRFromAxisAndAngle counter-clockwise.

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
fetch libode-dev=2:0.16.2-1

cat >check.cpp <<'CPP'
#include <cmath>
#include <cstdio>
#include <ode/ode.h>

void print(const char* name, const dMass& m) {
    std::printf("%s: mass %.0f at %.0f,%.0f,%.0f, inertia %.0f,%.0f,%.0f, products %.0f,%.0f,%.0f, accepted %d\n", name, m.mass,
                m.c[0], m.c[1], m.c[2], m.I[0], m.I[5], m.I[10], m.I[1] + 0.0, m.I[2] + 0.0, m.I[6] + 0.0, dMassCheck(&m));
}

// Block of 2 x 4 x 6 with its lowest corner at x, y, z.
void mesh(const char* name, float x, float y, float z) {
    float corners[8][3];
    for (int i = 0; i < 8; ++i) {
        corners[i][0] = x + 2 * (i & 1);
        corners[i][1] = y + 4 * (i >> 1 & 1);
        corners[i][2] = z + 6 * (i >> 2);
    }
    dTriIndex triangles[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(data, corners, sizeof corners[0], 8, triangles, 36, sizeof triangles[0]);
    dMass m;
    dMassSetTrimesh(&m, 1, dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr));
    print(name, m);
    dMassTranslate(&m, -m.c[0], -m.c[1], -m.c[2]);
    print("  moved to the centre", m);
}

int main() {
    dInitODE();
    dMass box;
    dMassSetBox(&box, 1, 2, 4, 6);
    print("box", box);
    dMassTranslate(&box, 1, 2, 3);
    print("box, moved", box);
    mesh("mesh, centred", -1, -2, -3);
    mesh("mesh, corner at 0,0,0", 0, 0, 0);
    mesh("mesh, corner at 100,0,0", 100, 0, 0);
    for (int axis = 0; axis < 3; ++axis) {
        const double e[3] = {axis == 0 ? M_PI / 2 : 0, axis == 1 ? M_PI / 2 : 0, axis == 2 ? M_PI / 2 : 0};
        dMatrix3 euler, turn;
        dRFromEulerAngles(euler, e[0], e[1], e[2]);
        dRFromAxisAndAngle(turn, axis == 0, axis == 1, axis == 2, M_PI / 2);
        const int next = (axis + 1) % 3, last = (axis + 2) % 3;
        std::printf("90 degrees about %c, %c becomes: Euler %+.0f %c, axis %+.0f %c\n", 'X' + axis, 'X' + next,
                    euler[4 * last + next], 'X' + last, turn[4 * last + next], 'X' + last);
    }
}
CPP
lib=root/usr/lib/x86_64-linux-gnu
g++ -w check.cpp -o check -Iroot/usr/include -L$lib -lode
LD_LIBRARY_PATH=$lib ./check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
box: mass 48 at 0,0,0, inertia 208,160,80, products 0,0,0, accepted 1
box, moved: mass 48 at 1,2,3, inertia 832,640,320, products -96,-144,-288, accepted 1
mesh, centred: mass 48 at 0,0,0, inertia 208,160,80, products 0,0,0, accepted 1
  moved to the centre: mass 48 at 0,0,0, inertia 208,160,80, products 0,0,0, accepted 1
mesh, corner at 0,0,0: mass 48 at 1,2,3, inertia 1456,1120,560, products -192,-288,-576, accepted 1
  moved to the centre: mass 48 at 0,0,0, inertia 832,640,320, products -96,-144,-288, accepted 1
mesh, corner at 100,0,0: mass 48 at 101,2,3, inertia 1456,980320,979760, products -19392,-29088,-576, accepted 1
  moved to the centre: mass 48 at 0,0,0, inertia 832,490240,489920, products -9696,-14544,-288, accepted 1
90 degrees about X, Y becomes: Euler -1 Z, axis +1 Z
90 degrees about Y, Z becomes: Euler -1 X, axis +1 X
90 degrees about Z, X becomes: Euler -1 Y, axis +1 Y
EXPECTED
