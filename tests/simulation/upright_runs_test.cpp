// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of inclined moves in a vertical plane.
#include "upright_runs.h"

#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace ncsim::simulation {
namespace {

using gcode::Linear;
using gcode::Motion;

struct Taken {
    std::vector<Motion> specified, handed_on;
    double most_moved_mm = 0.0;
};

Taken take(const std::string& moves) {
    Taken taken;
    UprightRuns runs([&](const Motion& motion, double moved_mm) {
        taken.handed_on.push_back(motion);
        taken.most_moved_mm = std::max(taken.most_moved_mm, moved_mm);
    });
    gcode::interpret({"runs.nc", "G21 G90 G17 F300\n" + moves}, {}, [&](const Motion& motion) {
        taken.specified.push_back(motion);
        runs.take(motion);
    });
    runs.flush();
    return taken;
}

const Linear& line(const Motion& motion) {
    return std::get<Linear>(motion.action);
}

// Returns the distance of the end of move `first` from the vertical plane through the start of
// `first` and the end of `last`.
double off_plane(const std::vector<Motion>& motions, std::size_t first, std::size_t last) {
    const auto& from = line(motions[first]).from;
    const auto& to = line(motions[last]).to;
    const double x = to.x.mm() - from.x.mm(), y = to.y.mm() - from.y.mm();
    const auto& p = line(motions[first]).to;
    return std::abs(x * (p.y.mm() - from.y.mm()) - y * (p.x.mm() - from.x.mm())) / std::hypot(x, y);
}

// A neighbour of a line moved onto the plane is on the plane, too; Z and both ends of the run stay.
TEST(UprightRuns, PutRoundedLinesIntoOnePlane) {
    const Taken taken = take(
        "G0 X0 Y0 Z5\nG1 Z0\nG1 X0.051 Y-0.041 Z-0.1\nG1 X0.11 Y-0.088 Z-0.15\n"
        "G1 X0.176 Y-0.142 Z-0.2\nG1 X10 Y-8\n");
    ASSERT_EQ(taken.handed_on.size(), taken.specified.size());
    const std::size_t first = taken.specified.size() - 4, last = first + 2;
    EXPECT_GT(off_plane(taken.specified, first, last), 1e-5);
    EXPECT_LT(off_plane(taken.handed_on, first, last), 1e-12);
    EXPECT_GT(taken.most_moved_mm, 1e-5);
    EXPECT_LE(taken.most_moved_mm, UprightRuns::kRoundedMm);
    EXPECT_EQ(line(taken.handed_on[first]).from, line(taken.specified[first]).from);
    EXPECT_EQ(line(taken.handed_on[last]).to, line(taken.specified[last]).to);
    for (std::size_t i = first; i < last; ++i) {
        EXPECT_EQ(line(taken.handed_on[i]).to, line(taken.handed_on[i + 1]).from);
        EXPECT_EQ(line(taken.handed_on[i]).to.z, line(taken.specified[i]).to.z);
    }
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
        ASSERT_EQ(taken.handed_on.size(), taken.specified.size());
        EXPECT_EQ(taken.most_moved_mm, 0.0);
        for (std::size_t i = 0; i < taken.specified.size(); ++i)
            EXPECT_EQ(gcode::end_of(taken.specified[i])->y, gcode::end_of(taken.handed_on[i])->y);
    }
}

}  // namespace
}  // namespace ncsim::simulation
