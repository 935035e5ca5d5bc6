// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time, path and volume of the operations of a program.
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace ncsim::simulation {
namespace {

const std::string kHead =
    "(T1 D=6. CR=0. - flat end mill)\n(T2 D=6. CR=0. - flat end mill)\n"
    "(STOCK/BLOCK,40.,40.,10.,0.,0.,10.)\nG21 G90\n";
const std::string kEnd = "M30\n";

std::string slot(const std::string& y, const std::string& z) {
    return "G0 X-5. Y" + y + " Z5.\nG0 Z-" + z + "\nG1 X45. F300.\nG0 Z5.\n";
}

struct Operations {
    std::vector<std::string> rows;  // "T1 POCKET 50 mm 480 mm3"
    std::vector<double> seconds;
};

Operations operations_of(const std::string& text, double join_tolerance = 0.0) {
    setup::JobOptions options;
    options.start = Vec3{0, 0, 50};
    Plan plan;
    plan.job = setup::job_of({"part.nc", text}, options);
    plan.join_tolerance = join_tolerance;
    const Survey seen = survey(plan);
    EXPECT_TRUE(seen.is_ready());
    const Simulation part = simulate(plan, seen, {}, {});
    EXPECT_EQ(part.removed_by_operation.size(), seen.operations.size());
    double removed = 0.0, feed_mm = 0.0;
    Operations result;
    for (std::size_t i = 0; i < seen.operations.size(); ++i) {
        const auto& operation = seen.operations[i];
        removed += part.removed_by_operation.at(i);
        feed_mm += operation.distances.feed_mm;
        result.rows.push_back("T" + std::to_string(operation.tool) + " " + operation.name + " " +
                              std::to_string(std::lround(operation.distances.feed_mm)) + " mm " +
                              std::to_string(std::lround(part.removed_by_operation[i])) + " mm3");
    }
    EXPECT_NEAR(removed, part.stock_volume - part.part_volume, 1e-9);
    EXPECT_NEAR(feed_mm, verify::total(seen.distances).feed_mm, 1e-9);
    return result;
}

using Rows = std::vector<std::string>;

TEST(Operations, BeginAtNamesAndAtToolChanges) {
    EXPECT_EQ(
        operations_of(kHead + "T1 M6\nS8000 M3\n(SLOT1)\n" + slot("10.", "2.") + "(SLOT2)\n" +
                      slot("20.", "5.") + "(SLOT3)\nG28 G91 Z0\nG90\nT2 M6\nM3\n" +
                      slot("30.", "1.") + kEnd)
            .rows,
        (Rows{"T1 SLOT1 50 mm 480 mm3", "T1 SLOT2 50 mm 1200 mm3", "T2 SLOT3 50 mm 240 mm3"}));
    // The name may stand before or behind the tool change.
    for (const char* change : {"(SLOT2)\nT2 M6\nM3\n", "T2 M6\nM3\n(SLOT2)\n",
                               "T2 (SLOT2)\nM6\nM3\n"
                               "(SLOT2)\n"})
        EXPECT_EQ(operations_of(kHead + "(SLOT1)\nT1 M6\nM3\n" + slot("10.", "2.") + change +
                                slot("20.", "5.") + kEnd)
                      .rows,
                  (Rows{"T1 SLOT1 50 mm 480 mm3", "T2 SLOT2 50 mm 1200 mm3"}))
            << change;
}

TEST(Operations, DoNotBeginBetweenCuts) {
    const std::string cuts = "G1 X20. F300.\n(CORNER)\nG1 Y30.\n(RAMP)\nG0 Z5.\n";
    EXPECT_EQ(operations_of(kHead + "(T1 M6)\nT1 M6\nM3\n(CONTOUR)\nG0 X-5. Y10. Z5.\nG0 Z-2.\n" +
                            cuts + kEnd)
                  .rows.size(),
              1U);
}

// Posts for hobby licences write rapid moves as feed moves.
TEST(Operations, BeginAtFeedMovesAboveThePart) {
    const std::string second = "(SLOT2)\nG1 X-5. Y20. Z5. F2000.\nG1 Z-5.\nG1 X45. F300.\nG1 Z5.\n";
    const Rows rows =
        operations_of(kHead + "T1 M6\nM3\n(SLOT1)\n" + slot("10.", "2.") + second + kEnd).rows;
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_TRUE(rows[1].starts_with("T1 SLOT2 ")) << rows[1];
}

TEST(Operations, OfDraftsAreTheSame) {
    const std::string text = kHead +
                             "T1 M6\nM3\n(SLOT1)\nG0 X-5. Y10. Z5.\nG0 Z-2.\nG1 X20. F300.\n"
                             "X30.\nX45.\n(SLOT2)\nX50.\nX55.\nG0 Z5.\n(SLOT3)\n" +
                             slot("20.", "5.") + kEnd;
    EXPECT_EQ(operations_of(text, 0.01).rows, operations_of(text).rows);
}

// Each operation costs an evaluation of the part: a loop over two names must not cost two a turn.
TEST(Operations, OfALoopAreAsManyAsItsNames) {
    std::string loop = "#1=0\nO100 WHILE [#1 LT 30]\n(FIRST)\n" + slot("10.", "2.") + "(SECOND)\n" +
                       slot("20.", "5.") + "#1=[#1+1]\nO100 ENDWHILE\n";
    EXPECT_EQ(
        operations_of(kHead + "T1 M6\nM3\n" + loop + "(THIRD)\n" + slot("30.", "1.") + kEnd).rows,
        (Rows{"T1 FIRST 50 mm 480 mm3", "T1 SECOND 2950 mm 1200 mm3", "T1 THIRD 50 mm 240 mm3"}));
}

// A second call of a subprogram continues the operation.
TEST(Operations, HoldTheSubprogramsTheyCall) {
    EXPECT_EQ(operations_of("O100 SUB\n(INSIDE)\n" + slot("10.", "2.") + "O100 ENDSUB\n" + kHead +
                            "T1 M6\nM3\n(CALLS)\nO100 CALL\nO100 CALL\n(SLOT2)\n" +
                            slot("20.", "5.") + kEnd)
                  .rows,
              (Rows{"T1 INSIDE 100 mm 480 mm3", "T1 SLOT2 50 mm 1200 mm3"}));
}

}  // namespace
}  // namespace ncsim::simulation
