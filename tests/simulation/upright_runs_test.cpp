// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of inclined moves in a vertical plane.
#include "upright_runs.h"

#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::simulation {
namespace {

using gcode::Linear;
using gcode::Motion;

struct Taken {
    std::vector<Motion> specified;
    std::vector<std::pair<std::size_t, Linear>> moved;  // number of the motion, and its line
    double most_moved_mm = 0.0;
};

Taken take(const std::string& moves) {
    Taken taken;
    UprightRuns runs([&](std::size_t cut, const Linear& line, double moved_mm) {
        taken.moved.emplace_back(cut, line);
        taken.most_moved_mm = std::max(taken.most_moved_mm, moved_mm);
    });
    gcode::interpret({"runs.nc", "G21 G90 G17 F300\n" + moves}, {}, [&](const Motion& motion) {
        runs.take(motion, taken.specified.size());
        taken.specified.push_back(motion);
    });
    runs.flush();
    return taken;
}

const Linear& line(const Motion& motion) {
    return std::get<Linear>(motion.action);
}

// Returns the distance of the end of `move` from the vertical plane through `from` and `to`.
double off_plane(const Linear& move, const gcode::Position& from, const gcode::Position& to) {
    const double x = to.x.mm() - from.x.mm(), y = to.y.mm() - from.y.mm();
    return std::abs(x * (move.to.y.mm() - from.y.mm()) - y * (move.to.x.mm() - from.x.mm())) /
           std::hypot(x, y);
}

// A neighbour of a line moved onto the plane is on the plane, too; Z and both ends of the run stay.
TEST(UprightRuns, PutRoundedLinesIntoOnePlane) {
    const Taken taken = take(
        "G0 X0 Y0 Z5\nG1 Z0\nG1 X0.051 Y-0.041 Z-0.1\nG1 X0.11 Y-0.088 Z-0.15\n"
        "G1 X0.176 Y-0.142 Z-0.2\nG1 X10 Y-8\n");
    // The last move is level.
    const std::size_t first = taken.specified.size() - 4;
    ASSERT_EQ(taken.moved.size(), 3U);
    const gcode::Position& from = line(taken.specified[first]).from;
    const gcode::Position& to = line(taken.specified[first + 2]).to;
    EXPECT_GT(off_plane(line(taken.specified[first]), from, to), 1e-5);
    EXPECT_GT(taken.most_moved_mm, 1e-5);
    EXPECT_LE(taken.most_moved_mm, UprightRuns::kRoundedMm);
    EXPECT_EQ(taken.moved.front().second.from, from);
    EXPECT_EQ(taken.moved.back().second.to, to);
    for (std::size_t i = 0; i < taken.moved.size(); ++i) {
        const auto& [number, moved] = taken.moved[i];
        EXPECT_EQ(number, first + i);
        EXPECT_LT(off_plane(moved, from, to), 1e-12);
        EXPECT_EQ(moved.to.z, line(taken.specified[number]).to.z);
        if (i > 0) {
            EXPECT_EQ(moved.from, taken.moved[i - 1].second.to);
        }
    }
}

// A move that meets no stock belongs to the run, and has no record.
TEST(UprightRuns, PassOnOnlyCuts) {
    std::vector<std::size_t> cuts;
    UprightRuns runs([&](std::size_t cut, const Linear&, double) { cuts.push_back(cut); });
    std::size_t count = 0;
    gcode::interpret(
        {"runs.nc", "G21 G90 G17 F300\nG0 X0 Y0 Z5\nG1 Z0\nG1 X1 Y1 Z-1\nG1 X2 Y2 Z-3\n"}, {},
        [&](const Motion& motion) {
            ++count;
            runs.take(motion, count == 4 ? std::optional(count) : std::nullopt);
        });
    runs.flush();
    EXPECT_EQ(cuts, std::vector<std::size_t>{4});
}

TEST(UprightRuns, LeaveOthersAsTheyAre) {
    for (const std::string moves : {
             "G1 X1 Y0.01 Z-1\nG1 X2 Y0 Z-3\nG1 X3 Y0.01 Z-4\n",   // bends
             "G1 X1 Y0.002 Z-1\nG1 X0.5 Y0 Z-3\n",                 // comes back
             "G1 X1 Y0.002\nG1 X2 Y0\n",                           // level
             "G1 Z-1\nG1 Z-2\n",                                   // upright
             "G1 X1 Y0.002 Z-1\nG2 X2 Y0 R5\nG1 X3 Y0.002 Z0\n",   // an arc between
             "G1 X1 Y0.002 Z-1\nG0 X2 Y0 Z0\nG1 X3 Y0.002 Z-1\n",  // a rapid between
         }) {
        SCOPED_TRACE(moves);
        const Taken taken = take("G0 X0 Y0 Z5\nG1 Z0\n" + moves);
        EXPECT_TRUE(taken.moved.empty());
    }
}

}  // namespace
}  // namespace ncsim::simulation
