#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libwildmagic-dev and libwildmagic5 5.17+cleaned1-6 (Wild Magic 5, Geometric Tools). g++ is installed.
# Input:    points near the hyperbola (x/2)^2 - y^2 = 1; triangles with corners in steps of 0.5 and a cylinder of radius 2 and height 6
#           about the Z axis; triangles and a cone with its apex at the origin that opens upwards. Source: the headers
#           (Wm5DistPoint2Hyperbola2.h: "'closest' is (x,y). The return value is the distance"; Wm5Cone3.h: "an infinite,
#           single-sided cone", "may be truncated by a plane perpendicular to its axis at a height h from the vertex").
# Expected: The nearest point is on the hyperbola. Test is true if the triangle contains a point of the solid.
# Seen:     The nearest points have (x/2)^2 - y^2 from -12.3 to -0.4, so no distance is right: 3,1 is 0.098 away, not 1.469.
#           A triangle that contains the point 0.05,0.475,1.525 deep inside the cylinder does not intersect it; 329 of 5000
#           triangles are wrong in this way (a point at least 0.3 inside). A triangle below the apex intersects the cone, and 335 of 5000
#           triangles outside do, too. The height of the cone is ignored: triangle and sphere at Z 50 intersect a cone of height 2.

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
fetch libwildmagic-dev=5.17+cleaned1-6 libwildmagic5=5.17+cleaned1-6

cat >check.cpp <<'CPP'
#include <Wm5Mathematics.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
using namespace Wm5;
using V = Vector3d;
using Solid = double (*)(const V&);

const V up(0, 0, 1), origin(0, 0, 0);
const Cylinder3d cylinder(Line3d(origin, up), 2, 6);
const Cone3d infinite(origin, up, std::atan(0.5), 1e30), bounded(origin, up, std::atan(0.5), 2);

// Negative inside of the solid.
double in_cylinder(const V& p) { return std::max(std::hypot(p[0], p[1]) - 2, std::fabs(p[2]) - 3); }
double in_cone(const V& p) { return std::hypot(p[0], p[1]) - p[2] / 2; }

bool hits_cylinder(const Triangle3d& t) { return IntrTriangle3Cylinder3d(t, cylinder).Test(); }
bool hits_cone(const Triangle3d& t) { return IntrTriangle3Cone3d(t, infinite).Test(); }

double least(const Triangle3d& t, Solid solid) {
    double best = 1e9;
    for (int i = 0; i <= 60; ++i)
        for (int j = 0; i + j <= 60; ++j)
            best = std::min(best, solid(t.V[0] + (i / 60.0) * (t.V[1] - t.V[0]) + (j / 60.0) * (t.V[2] - t.V[0])));
    return best;
}

void count(const char* name, Solid solid, bool (*hits)(const Triangle3d&)) {
    std::mt19937 random(1);
    auto number = [&] { return (int(random() % 17) - 8) / 2.0; };
    auto point = [&] { const double x = number(), y = number(); return V(x, y, number()); };
    int missed = 0, invented = 0;
    for (int n = 0; n < 5000;) {
        const V a = point(), b = point(), c = point();
        if ((b - a).Cross(c - a).Length() < 1) continue;
        ++n;
        const Triangle3d t(a, b, c);
        const double depth = least(t, solid);
        missed += depth < -0.3 && !hits(t);
        invented += depth > 0.3 && hits(t);
    }
    std::printf("%s: of 5000 triangles, %d missed, %d invented\n", name, missed, invented);
}

int main() {
    for (const Vector2d p : {Vector2d(3, 2), Vector2d(1, 2), Vector2d(5, 1), Vector2d(3, 1), Vector2d(4, 3)}) {
        Vector2d c;
        const double distance = ComputeDistancePointToHyperbola(p, Vector2d(2, 1), c);
        double best = 1e9;
        for (int i = 0; i <= 400000; ++i) {
            const double u = i * 1e-5;
            best = std::min(best, std::hypot(2 * std::cosh(u) - p[0], std::sinh(u) - p[1]));
        }
        std::printf("point %g,%g: distance %.3f, true %.3f, nearest %.3f,%.3f with %.1f\n", p[0], p[1], distance, best, c[0], c[1],
                    c[0] * c[0] / 4 - c[1] * c[1]);
    }
    const Triangle3d through(V(0.5, -2, 4), V(-0.5, 3.5, -1.5), V(-1, 2.5, 1.5));
    std::printf("triangle, %.3f inside of the cylinder: %d\n", -least(through, in_cylinder), hits_cylinder(through));
    const Triangle3d below(V(2, 1, 0), V(0, 0, -2.5), V(1, 0, -2));
    std::printf("triangle from Z -2.5 to 0, cone upwards from Z 0: %d\n", hits_cone(below));
    count("cylinder", in_cylinder, hits_cylinder);
    count("cone", in_cone, hits_cone);
    const Triangle3d far(V(-1, -1, 50), V(1, -1, 50), V(0, 1, 50));
    const Sphere3d ball(V(0, 0, 50), 1);
    std::printf("at Z 50, cone of height 2: triangle %d, sphere %d\n", IntrTriangle3Cone3d(far, bounded).Test(),
                IntrSphere3Cone3d(ball, bounded).Test());
}
CPP
lib=root/usr/lib/x86_64-linux-gnu
g++ -w -O2 check.cpp -o check -Iroot/usr/include/libwildmagic -L$lib -lWm5Mathematics -lWm5Core -Wl,-rpath-link,$lib -lpthread
LD_LIBRARY_PATH=$lib ./check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
point 3,2: distance 0.668, true 0.742, nearest 2.828,2.645 with -5.0
point 1,2: distance 1.115, true 1.933, nearest 1.380,0.951 with -0.4
point 5,1: distance 3.186, true 1.130, nearest 4.206,4.085 with -12.3
point 3,1: distance 1.469, true 0.098, nearest 2.616,2.418 with -4.1
point 4,3: distance 0.711, true 1.103, nearest 3.822,3.689 with -10.0
triangle, 1.475 inside of the cylinder: 0
triangle from Z -2.5 to 0, cone upwards from Z 0: 1
cylinder: of 5000 triangles, 329 missed, 8 invented
cone: of 5000 triangles, 0 missed, 335 invented
at Z 50, cone of height 2: triangle 1, sphere 1
EXPECTED
