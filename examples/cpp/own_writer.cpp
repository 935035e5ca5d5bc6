// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simulates a program, and writes the part in a format that ncsim lacks: Wavefront OBJ, with a
// group for each line of the program.
//     own_writer part.nc > part.obj
#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/simulation/simulate.h"

#include <exception>
#include <iostream>
#include <map>
#include <vector>

int main(int argc, char** argv) {
    using namespace ncsim;
    if (argc != 2) return std::cerr << "usage: own_writer PROGRAM > FILE\n", 2;
    try {
        setup::InputSet inputs;
        setup::JobOptions options;
        options.program = argv[1];
        simulation::Plan plan;
        plan.job = setup::read_job(options, inputs);
        plan.keep_boundary = true;
        const simulation::Simulation part = simulation::simulate(plan);
        const TriangleMesh mesh = cda::triangulate(*part.boundary);

        std::map<std::uint32_t, std::vector<std::size_t>> triangles_of_line;  // 0: stock
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const cda::BoundaryFace& face = part.boundary->faces[mesh.face[i]];
            triangles_of_line[part.provenance.of(face.origin).nc_line].push_back(i);
        }
        std::cout.precision(17);  // every double comes back as it is
        for (const Vec3& corner : mesh.vertices)
            std::cout << "v " << corner.x << ' ' << corner.y << ' ' << corner.z << '\n';
        for (const auto& [line, triangles] : triangles_of_line) {
            std::cout << "g line_" << line << '\n';
            for (const std::size_t i : triangles) {
                const auto& [a, b, c] = mesh.triangles[i];
                std::cout << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
            }
        }
    } catch (const std::exception& e) {
        return std::cerr << e.what() << '\n', 2;
    }
}
