#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libirrlicht-dev 1.8.5+ds2-1 (headers of Irrlicht). g++ is installed.
# Input:    the triangle 0,0,0 10,0,0 0,10,0 with points in its plane; the line from 0,0,0 to 10,0,0 and spheres; vectors, turned by 90
#           degrees with rotateXYBy, rotateYZBy, rotateXZBy and with matrices. Source: triangle3d.h (closestPointOnTriangle: "Get the
#           closest point on a triangle to a point on the same plane"), line3d.h (getIntersectionWithSphere; the line has a start
#           and an end), vector3d.h (rotateXZBy: "around the Y axis and the specified center").
# Expected: A point inside of the triangle is its own closest point. A sphere beyond the end of the line does not intersect it. The
#           three functions turn in the same direction as the matrices.
# Seen:     The closest point is always on a side: for 2,3,0 inside it is 0,3,0, and for all of the 36 inner points with whole
#           coordinates it is another point. Spheres 38 beyond the end and 7 before the start intersect the line. rotateXYBy and
#           rotateYZBy turn like the matrices, rotateXZBy in the opposite direction.

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
fetch libirrlicht-dev=1.8.5+ds2-1

cat >check.cpp <<'CPP'
#include <cstdio>
#include <irrlicht/irrlicht.h>
using namespace irr::core;
using V = vector3d<double>;

void print(const char* name, const V& p) { std::printf("%s %.1f,%.1f,%.1f", name, p.X + 0.0, p.Y + 0.0, p.Z + 0.0); }

// Turns `v` by 90 degrees about the axis with a matrix.
V turned(const V& v, double x, double y, double z) {
    CMatrix4<double> matrix;
    matrix.setRotationDegrees(V(90 * x, 90 * y, 90 * z));
    double in[3] = {v.X, v.Y, v.Z}, out[3];
    for (int i = 0; i < 3; ++i) out[i] = in[0] * matrix[i] + in[1] * matrix[4 + i] + in[2] * matrix[8 + i];
    return V(out[0], out[1], out[2]);
}

int main() {
    const triangle3d<double> triangle(V(0, 0, 0), V(10, 0, 0), V(0, 10, 0));
    for (const V& p : {V(2, 3, 0), V(3, 3, 0), V(1, 8, 0), V(9, 9, 0), V(-3, 4, 0)}) {
        print("point", p);
        std::printf(" (inside %d)", triangle.isPointInside(p));
        print(": closest", triangle.closestPointOnTriangle(p));
        std::puts("");
    }
    int inner = 0, wrong = 0;
    for (int x = 1; x < 10; ++x) {
        for (int y = 1; x + y < 10; ++y) {
            ++inner;
            wrong += !triangle.closestPointOnTriangle(V(x, y, 0)).equals(V(x, y, 0));
        }
    }
    std::printf("inner points: %d, moved: %d\n", inner, wrong);
    const line3d<double> line(0, 0, 0, 10, 0, 0);
    for (const double x : {5.0, 50.0, -9.0}) {
        double distance = 0;
        const bool hit = line.getIntersectionWithSphere(V(x, 0, 0), 2, distance);
        std::printf("line 0..10, sphere %g..%g: %d, distance %g\n", x - 2, x + 2, hit, distance);
    }
    V x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    x.rotateXYBy(90);
    y.rotateYZBy(90);
    z.rotateXZBy(90);
    print("about Z: vector", x);
    print(", matrix", turned(V(1, 0, 0), 0, 0, 1));
    print("\nabout X: vector", y);
    print(", matrix", turned(V(0, 1, 0), 1, 0, 0));
    print("\nabout Y: vector", z);
    print(", matrix", turned(V(0, 0, 1), 0, 1, 0));
    std::puts("");
}
CPP
g++ -w -include initializer_list check.cpp -o check -Iroot/usr/include -Iroot/usr/include/irrlicht
./check | sed 's/-0\.0/0.0/g' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
point 2.0,3.0,0.0 (inside 1): closest 0.0,3.0,0.0
point 3.0,3.0,0.0 (inside 1): closest 5.0,5.0,0.0
point 1.0,8.0,0.0 (inside 1): closest 1.5,8.5,0.0
point 9.0,9.0,0.0 (inside 0): closest 5.0,5.0,0.0
point -3.0,4.0,0.0 (inside 0): closest 0.0,4.0,0.0
inner points: 36, moved: 36
line 0..10, sphere 3..7: 1, distance 3
line 0..10, sphere 48..52: 1, distance 48
line 0..10, sphere -11..-7: 1, distance -11
about Z: vector 0.0,1.0,0.0, matrix 0.0,1.0,0.0
about X: vector 0.0,0.0,1.0, matrix 0.0,0.0,1.0
about Y: vector -1.0,0.0,0.0, matrix 1.0,0.0,0.0
EXPECTED
