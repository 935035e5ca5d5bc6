// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slot, from text to glTF, without setup and simulation: motions, poses, hulls, boundary.
#include "ncsim/cda/tree.h"
#include "ncsim/export/gltf.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/trace.h"

#include <fstream>
#include <iostream>

int main() {
    using namespace ncsim;
    const gcode::SourceFile program{"slot.nc", "G21 G90\nG0 X-5 Y20 Z-5\nG1 X45 F300\nM30\n"};
    const cda::Lattice lattice;  // 10 nm
    cda::TreeCda part(
        cda::box_cell(lattice.round({0, 0, -10}), lattice.round({40, 40, 0}), lattice), lattice);
    const toolpath::Tool tool = toolpath::flat_end_mill(6.0, 20.0);
    toolpath::Cutter cutter(tool, lattice, {});
    mesh::Provenance lines{{{}}, program.name};

    gcode::interpret(program, {}, [&](const gcode::Motion& motion) {
        if (!toolpath::has_known_start(motion)) return;
        const cda::Origin origin{static_cast<std::uint32_t>(lines.entries.size())};
        lines.entries.push_back({motion.span.line, 1});
        const auto path = toolpath::sample(motion, cutter.extent(), {});
        std::vector<cda::Cell> hulls;
        for (std::size_t i = 1; i < path.poses.size(); ++i) {
            cutter.trace(path.poses[i - 1], path.poses[i], origin, hulls);
        }
        for (const cda::Cell& hull : hulls)
            part.subtract(hull);
    });

    std::cout << part.volume() << " mm3 are left\n";
    std::ofstream file("slot.glb", std::ios::binary);
    exporter::write_gltf(file, part.boundary(), lines);
}
