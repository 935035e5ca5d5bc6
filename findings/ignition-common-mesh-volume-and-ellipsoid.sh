#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libignition-common-graphics-dev 4.5.1+ds-2+b1 (meshes of the simulator Gazebo). g++ is installed.
# Input:    meshes that the MeshManager creates: tube, extruded squares with and without a hole, ellipsoids with the radii 1, 2 and 3,
#           a plane with the normal 0,0,1 at the distance 5. The script compares Mesh::Volume with the sum of the signed tetrahedra
#           over the same triangles. Source: Mesh.hh ("Get the volume of the mesh", "The formula does not check for a closed
#           (water tight) mesh"), MeshManager.hh ("the number of circles along the height", "the number of segment per circle",
#           "distance from the origin along normal").
# Expected: The meshes are closed and oriented, so the volume is the signed sum. The area of the ellipsoid is 48.9 for each fineness.
#           The plane is at Z 5.
# Seen:     Volume adds absolute values: a tube of 56.5 has 81.6, a plate of 168 with a hole has 242.7, two separate blocks of 232 have
#           354.7. A block of 200 is right at the origin; moved by 100, it has 1533.3. Each ellipsoid consists of about 60 layers of
#           triangles: its area is 3101, 2885 and 3061 with 8, 16 and 64 rings, its signed volume 144.6, 2.9 and 1578.6 instead of
#           25.1. The plane is at Z -5.

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
fetch libignition-common-graphics-dev=4.5.1+ds-2+b1

cat >check.cpp <<'CPP'
#include <cmath>
#include <cstdio>
#include <ignition/common/Mesh.hh>
#include <ignition/common/MeshManager.hh>
#include <ignition/common/SubMesh.hh>
using namespace ignition;
using V2 = math::Vector2d;
using V3 = math::Vector3d;

void print(const char* name, const common::Mesh& mesh) {
    double volume = 0, area = 0;
    unsigned triangles = 0;
    for (unsigned s = 0; s < mesh.SubMeshCount(); ++s) {
        const auto part = mesh.SubMeshByIndex(s).lock();
        for (unsigned i = 0; i + 2 < part->IndexCount(); i += 3) {
            const V3 a = part->Vertex(part->Index(i)), b = part->Vertex(part->Index(i + 1)), c = part->Vertex(part->Index(i + 2));
            volume += a.Dot(b.Cross(c)) / 6;
            area += (b - a).Cross(c - a).Length() / 2;
            ++triangles;
        }
    }
    std::printf("%s: Volume %.2f, signed %.2f, area %.2f, triangles %u\n", name, mesh.Volume(), volume, area, triangles);
}

std::vector<V2> square(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}, {x, y}};
}

int main() {
    auto& all = *common::MeshManager::Instance();
    all.CreateCylinder("cylinder", 2, 6, 4, 64);
    print("cylinder", *all.MeshByName("cylinder"));
    all.CreateTube("tube", 1, 2, 6, 2, 64);
    print("tube", *all.MeshByName("tube"));
    all.CreateExtrudedPolyline("block", {square(0, 0, 10)}, 2);
    print("block", *all.MeshByName("block"));
    all.CreateExtrudedPolyline("moved", {square(100, 0, 10)}, 2);
    print("block moved by 100", *all.MeshByName("moved"));
    all.CreateExtrudedPolyline("hole", {square(0, 0, 10), square(3, 3, 4)}, 2);
    print("block with a hole", *all.MeshByName("hole"));
    all.CreateExtrudedPolyline("two", {square(0, 0, 10), square(20, 3, 4)}, 2);
    print("two blocks", *all.MeshByName("two"));
    for (const unsigned rings : {8u, 16u, 64u}) {
        const std::string name = "ellipsoid with " + std::to_string(rings) + " rings";
        all.CreateEllipsoid(name, V3(1, 2, 3), rings, 64);
        print(name.c_str(), *all.MeshByName(name));
    }
    all.CreatePlane("plane", V3(0, 0, 1), 5, V2(2, 4), V2(1, 1), V2(1, 1));
    const auto plane = all.MeshByName("plane")->SubMeshByIndex(0).lock();
    std::printf("plane: Z %g\n", plane->Vertex(0).Z());
}
CPP
lib=root/usr/lib/x86_64-linux-gnu
include=root/usr/include/ignition
g++ -w -std=c++17 check.cpp -o check -I$include/common4 -I$include/math6 -I$include/utils1 -Iroot/usr/include -L$lib \
  -lignition-common4-graphics -lignition-common4 -lignition-math6 -Wl,-rpath-link,$lib
HOME=$work LD_LIBRARY_PATH=$lib ./check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
cylinder: Volume 75.28, signed 75.28, area 100.46, triangles 648
tube: Volume 81.55, signed 56.46, area 131.87, triangles 768
block: Volume 200.00, signed 200.00, area 280.00, triangles 12
block moved by 100: Volume 1533.33, signed 200.00, area 280.00, triangles 12
block with a hole: Volume 242.67, signed 168.00, area 280.00, triangles 32
two blocks: Volume 354.67, signed 232.00, area 344.00, triangles 24
ellipsoid with 8 rings: Volume 1301.46, signed 144.61, area 3100.97, triangles 48896
ellipsoid with 16 rings: Volume 1473.04, signed 2.88, area 2885.36, triangles 114432
ellipsoid with 64 rings: Volume 1578.56, signed 1578.56, area 3060.97, triangles 507648
plane: Z -5
EXPECTED
