// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a program, and prints for each tool how far it goes at feed and at rapid.
//     read_program part.nc
#include "ncsim/gcode/interpreter.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

namespace {

struct Ways {
    double feed_mm = 0.0, rapid_mm = 0.0;
};

double straight_length(const ncsim::gcode::Position& a, const ncsim::gcode::Position& b) {
    return std::hypot((b.x - a.x).mm(), (b.y - a.y).mm(), (b.z - a.z).mm());
}

}  // namespace

int main(int argc, char** argv) {
    using namespace ncsim;
    if (argc != 2) return std::cerr << "usage: read_program PROGRAM\n", 2;
    std::ifstream in(argv[1], std::ios::binary);
    if (!in) return std::cerr << argv[1] << ": cannot be read\n", 2;
    const gcode::SourceFile program{argv[1], {std::istreambuf_iterator<char>(in), {}}};

    std::map<int, Ways> tools;
    const gcode::Interpretation read =
        gcode::interpret(program, {}, [&](const gcode::Motion& motion) {
            const gcode::Position* const start = gcode::start_of(motion);
            // Dwells and tool changes have no start; the start of the first moves is unknown.
            if (!start || !motion.known_start.all()) return;
            // Arcs and splines count as straight here.
            const double length = straight_length(*start, *gcode::end_of(motion));
            Ways& ways = tools[motion.tool];
            (motion.kind == gcode::MoveKind::Rapid ? ways.rapid_mm : ways.feed_mm) += length;
        });
    for (const gcode::Diagnostic& diagnostic : read.diagnostics)
        std::cerr << gcode::render(diagnostic, program);
    for (const auto& [tool, ways] : tools)
        std::cout << 'T' << tool << ": " << ways.feed_mm << " mm at feed, " << ways.rapid_mm
                  << " mm at rapid\n";
    return gcode::has_errors(read.diagnostics) ? 1 : 0;
}
