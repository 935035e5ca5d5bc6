#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, lib3ds-dev and lib3ds-1-3 1.3.0-10 (reads and writes 3DS files, in C). The script calls gcc.
# Input:    a tetrahedron of volume 4 with a corner at 1,0,0, moved to positive and negative places; the same mesh with the
#           matrix diag(-1, 1, 1), written and read again; turns by 90 degrees about Z by three functions. Source: headers of
#           the library (lib3ds_mesh_bounding_box, normal of a face, "Transformation matrix for mesh data",
#           lib3ds_matrix_rotate_z, lib3ds_matrix_rotate_axis, lib3ds_quat_axis_angle).
# Expected: The bounding box contains all points and touches them on each side. The normal of each face agrees with the order of
#           its points, before and after the file. A turn about the axis 0,0,1 is the turn of rotate_z.
# Seen:     The box of a part with negative coordinates ends at 0,0,0 instead of -5,-7,-8: the search of the maximum starts with
#           the smallest positive number. After a file, three of four faces of a mesh with a mirrored matrix, and their corners,
#           have normals against the order of their points. rotate_axis and quaternions turn clockwise, rotate_z
#           counter-clockwise.

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
fetch lib3ds-dev=1.3.0-10 lib3ds-1-3=1.3.0-10
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries

cat >check.c <<'C'
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <lib3ds/file.h>
#include <lib3ds/matrix.h>
#include <lib3ds/mesh.h>
#include <lib3ds/quat.h>
#include <lib3ds/vector.h>

static Lib3dsMesh* tetrahedron(float x, float y, float z)
{
    static const float points[4][3] = {{1, 0, 0}, {5, 0, 0}, {1, 3, 0}, {1, 0, 2}};
    static const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const float shift[3] = {x, y, z};
    Lib3dsMesh* mesh = lib3ds_mesh_new("part");
    lib3ds_mesh_new_point_list(mesh, 4);
    lib3ds_mesh_new_face_list(mesh, 4);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j) {
            mesh->pointL[i].pos[j] = points[i][j] + shift[j];
            mesh->faceL[i].points[j] = faces[i][j];
        }
    lib3ds_matrix_identity(mesh->matrix);
    return mesh;
}

static void box(const char* name, Lib3dsMesh* mesh)
{
    Lib3dsVector low, high;
    lib3ds_mesh_bounding_box(mesh, low, high);
    printf("bounding box, %s: %.2f,%.2f,%.2f to %.2f,%.2f,%.2f\n", name, low[0], low[1], low[2], high[0], high[1], high[2]);
}

// Volume by the order of the points, and the number of normals that agree with this order.
static void faces(const char* name, Lib3dsMesh* mesh)
{
    double volume = 0;
    int agree = 0, corners = 0;
    Lib3dsVector* at_corners = malloc(3 * mesh->faces * sizeof *at_corners);
    lib3ds_mesh_calculate_normals(mesh, at_corners);
    for (unsigned i = 0; i < mesh->faces; ++i) {
        Lib3dsVector u, v, across;
        const float *a = mesh->pointL[mesh->faceL[i].points[0]].pos, *b = mesh->pointL[mesh->faceL[i].points[1]].pos,
                    *c = mesh->pointL[mesh->faceL[i].points[2]].pos;
        for (int j = 0; j < 3; ++j) {
            u[j] = b[j] - a[j];
            v[j] = c[j] - a[j];
        }
        for (int j = 0; j < 3; ++j)
            across[j] = u[(j + 1) % 3] * v[(j + 2) % 3] - u[(j + 2) % 3] * v[(j + 1) % 3];
        for (int j = 0; j < 3; ++j)
            volume += a[j] * across[j] / 6;
        agree += lib3ds_vector_dot(across, mesh->faceL[i].normal) > 0;
        for (int k = 0; k < 3; ++k)
            corners += lib3ds_vector_dot(across, at_corners[3 * i + k]) > 0;
    }
    free(at_corners);
    printf("%s: volume %.2f, normals in agreement: %d of 4 faces, %d of 12 corners\n", name, volume, agree, corners);
}

static void point(const char* name, Lib3dsMatrix matrix)
{
    Lib3dsVector from = {1, 0, 0}, to;
    lib3ds_vector_transform(to, matrix, from);
    printf("%s: 1,0,0 to %ld,%ld,%ld\n", name, lroundf(to[0]), lroundf(to[1]), lroundf(to[2]));
}

int main(void)
{
    box("at the origin", tetrahedron(0, 0, 0));
    box("moved by 10", tetrahedron(10, 10, 10));
    box("moved by -10", tetrahedron(-10, -10, -10));

    for (int mirrored = 0; mirrored < 2; ++mirrored) {
        Lib3dsFile* file = lib3ds_file_new();
        Lib3dsMesh* mesh = tetrahedron(0, 0, 0);
        if (mirrored)
            lib3ds_matrix_scale_xyz(mesh->matrix, -1, 1, 1);
        lib3ds_file_insert_mesh(file, mesh);
        if (!lib3ds_file_save(file, "part.3ds"))
            return 1;
        faces(mirrored ? "read again, mirrored" : "read again", lib3ds_file_mesh_by_name(lib3ds_file_load("part.3ds"), "part"));
    }

    const float quarter = acosf(0);
    Lib3dsVector z = {0, 0, 1};
    Lib3dsQuat quaternion;
    Lib3dsMatrix matrix;
    lib3ds_matrix_identity(matrix);
    lib3ds_matrix_rotate_z(matrix, quarter);
    point("rotate_z", matrix);
    lib3ds_matrix_identity(matrix);
    lib3ds_matrix_rotate_axis(matrix, z, quarter);
    point("rotate_axis 0,0,1", matrix);
    lib3ds_quat_axis_angle(quaternion, z, quarter);
    lib3ds_matrix_identity(matrix);
    lib3ds_matrix_rotate(matrix, quaternion);
    point("quaternion about 0,0,1", matrix);
}
C
gcc -w -Iroot/usr/include check.c "$libraries/lib3ds-1.so.3" -lm -o check
./check 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
bounding box, at the origin: 1.00,0.00,0.00 to 5.00,3.00,2.00
bounding box, moved by 10: 11.00,10.00,10.00 to 15.00,13.00,12.00
bounding box, moved by -10: -9.00,-10.00,-10.00 to 0.00,0.00,0.00
read again: volume 4.00, normals in agreement: 4 of 4 faces, 12 of 12 corners
read again, mirrored: volume 4.00, normals in agreement: 1 of 4 faces, 3 of 12 corners
rotate_z: 1,0,0 to 0,1,0
rotate_axis 0,0,1: 1,0,0 to 0,-1,0
quaternion about 0,0,1: 1,0,0 to 0,-1,0
EXPECTED
