// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions behind ncsim run, check and diff, called without a command line.
#include "ncsim/cda/triangulate.h"
#include "ncsim/simulation/compare_parts.h"
#include "ncsim/simulation/design_check.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>

namespace ncsim::simulation {
namespace {

const std::string kTool = "(T1 D=6. CR=0. - flat end mill)\n";
const std::string kStock = "(STOCK/BLOCK,40.,40.,10.,0.,0.,10.)\n";
const std::string kSlot =
    "G21 G90 T1 M6 S8000 M3\nG0 X-5. Y20. Z5.\nG0 Z-5.\nG1 X45. F300.\nG0 Z5.\nM30\n";

Plan plan_of(const std::string& text, setup::JobOptions options = {}) {
    options.start = Vec3{0, 0, 50};
    Plan plan;
    plan.job = setup::job_of({"slot.nc", text}, std::move(options));
    return plan;
}

TEST(Simulation, OfAStringLeavesThePart) {
    const Simulation part = simulate(plan_of(kTool + kStock + kSlot));
    EXPECT_DOUBLE_EQ(part.stock_volume, 16000.0);
    EXPECT_DOUBLE_EQ(part.part_volume, 16000.0 - 6 * 40 * 5);
    EXPECT_FALSE(part.boundary);
}

TEST(Simulation, StopsAfterTheLastMoveToo) {
    Plan plan = plan_of(kTool + kStock + kSlot);
    plan.keep_boundary = true;
    const Survey seen = survey(plan);
    std::stop_source stop;
    plan.budget.stop_with(stop.get_token());
    const auto after = [&](std::uint64_t last) {
        return [&stop, last](std::uint64_t moves) {
            if (moves == last) stop.request_stop();
        };
    };
    // The work that is left after the last move is the evaluation of the part.
    const Simulation done = simulate(plan, seen, {}, after(seen.moves + 1));
    EXPECT_THROW(simulate(plan, seen, {}, after(seen.moves)), std::runtime_error);
    // A finished part answers after the time is over.
    EXPECT_DOUBLE_EQ(done.part->volume(), done.part_volume);
    EXPECT_FALSE(done.part->boundary().faces.empty());
}

// Returns: the guessed block of a contour around a part of 80 x 50 mm, D10, that begins at `start`.
toolpath::Stock block_of_contour(const std::string& start) {
    Plan plan = plan_of("(T1 D=10. CR=0. - flat end mill)\nG21 G90 T1 M6 S8000 M3\n" + start +
                        "G1 X85. F300.\nY55.\nX-5.\nY-25.\nG0 Z5.\nM30\n");
    const Survey seen = survey(plan);
    EXPECT_TRUE(seen.stock);
    return *seen.stock;
}

TEST(GuessedBlock, EndsAtThePartNotAtLeadIns) {
    const Box far = block_of_contour("G0 X-25. Y-5. Z5.\nG0 Z-5.\n").box;
    EXPECT_EQ(far.min.x, -15.0);
    EXPECT_EQ(far.max.x, 95.0);
    EXPECT_EQ(far.min.y, -14.0);
    EXPECT_EQ(far.max.y, 64.0);
    // The tool goes down at rapid, so the block ends there.
    EXPECT_EQ(block_of_contour("G0 X-12. Y-5. Z5.\nG0 Z-5.\n").box.min.x, -7.0);
    // A plunge at feed may be in the block.
    EXPECT_EQ(block_of_contour("G0 X-25. Y-5. Z5.\nG1 Z-5. F100.\n").box.min.x, -36.0);
}

TEST(GuessedBlock, OfOneSlotKeepsItsLength) {
    Plan plan = plan_of(kTool + kSlot);
    const Survey seen = survey(plan);
    ASSERT_TRUE(seen.stock);
    EXPECT_EQ(seen.stock->box.min.x, -2.0);
    EXPECT_EQ(seen.stock->box.max.x, 51.0);
    EXPECT_NE(seen.stock->text.find("lead-ins"), std::string::npos) << seen.stock->text;
}

// In a pocket that is cleared before, tools go down at rapid, too.
TEST(GuessedBlock, KeepsPockets) {
    const std::string pocket =
        "G21 G90 T1 M6 S8000 M3\nG0 X20. Y20. Z5.\nG1 Z-2. F100.\nG1 X40. F300.\nY40.\nX20.\n"
        "Y20.\nG0 Z5.\n";
    const std::string again = "G0 X21. Y21.\nG0 Z-2.\nG1 X39.\nY39.\nX21.\nY21.\nG0 Z5.\n";
    Plan once = plan_of(kTool + pocket + "M30\n");
    Plan twice = plan_of(kTool + pocket + again + "M30\n");
    EXPECT_EQ(survey(once).stock->box, survey(twice).stock->box);
}

TEST(Simulation, KeepsWhatItIsAskedFor) {
    Plan plan = plan_of(kTool + kStock + kSlot);
    plan.keep_boundary = plan.keep_paths = plan.keep_removed_cells = plan.block_volumes = true;
    const Simulation part = simulate(plan);
    ASSERT_TRUE(part.boundary);
    EXPECT_FALSE(part.boundary->faces.empty());
    EXPECT_FALSE(part.paths.empty());
    EXPECT_FALSE(part.carved.empty());
    ASSERT_EQ(part.removed_by_block.size(), 1U);
    EXPECT_NEAR(part.removed_by_block.at({0, 6}), 6 * 40 * 5, 1e-9);
}

// Volumes by tool cost an evaluation of the part at each tool change, so they are measured only on
// request.
TEST(Simulation, VolumesByToolAreMeasuredOnRequest) {
    const std::string tools = "(T1 D=6. CR=0. - flat end mill)\n(T2 D=6. CR=0. - flat end mill)\n";
    Plan plan = plan_of(tools + kStock +
                        "G21 G90 T1 M6 S8000 M3\nG0 X-5. Y20. Z5.\nG0 Z-2.\nG1 X45. F300.\nG0 Z5.\n"
                        "T2 M6 S8000 M3\nG0 X-5. Y20. Z5.\nG0 Z-5.\nG1 X45. F300.\nG0 Z5.\nM30\n");
    const Simulation shown = simulate(plan);
    ASSERT_EQ(shown.removed_by_tool.size(), 2U);
    EXPECT_NEAR(shown.removed_by_tool.at(1), 6 * 40 * 2, 1e-9);
    EXPECT_NEAR(shown.removed_by_tool.at(2), 6 * 40 * 3, 1e-9);
    plan.tool_volumes = false;
    const Simulation hidden = simulate(plan);
    EXPECT_TRUE(hidden.removed_by_tool.empty());
    EXPECT_NEAR(hidden.part_volume, shown.part_volume, 1e-12 * shown.part_volume);
}

// A slot in several passes of increasing depth: the walls belong to the last pass, and the part
// equals the part of a single pass. The removed volume of each pass is reported.
TEST(Simulation, AWallIsWhoseToolWentDeepest) {
    const auto milled = [](const std::string& depths) {
        Plan plan = plan_of(kTool + kStock + depths);
        plan.keep_boundary = plan.block_volumes = true;
        return simulate(plan);
    };
    const std::string start = "G21 G90 T1 M6 S8000 M3\nG0 X-5. Y20. Z5.\n";
    const Simulation once = milled(start + "\n\n\n\nG0 Z-5.\nG1 X45. F300.\nM30\n");
    const Simulation thrice =
        milled(start + "G0 Z-1.\nG1 X45. F300.\nG0 Z-3.\nG1 X-5.\nG0 Z-5.\nG1 X45.\nM30\n");
    EXPECT_TRUE(thrice.boundary->vertices == once.boundary->vertices);
    ASSERT_EQ(thrice.boundary->faces.size(), once.boundary->faces.size());
    for (std::size_t i = 0; i < once.boundary->faces.size(); ++i) {
        SCOPED_TRACE(i);
        const auto line = [i](const Simulation& part) {
            return part.provenance.of(part.boundary->faces[i].origin).nc_line;
        };
        EXPECT_EQ(thrice.boundary->faces[i].loops, once.boundary->faces[i].loops);
        EXPECT_EQ(line(thrice), line(once));
    }
    EXPECT_EQ(thrice.removed_by_block.size(), 3U);
}

// Three turns of a helix and a final circle: walls and floor of the bore belong to the circle, and
// the volume of each line is reported.
TEST(Simulation, ABoreIsOfTheCircleAtItsEnd) {
    const auto milled = [](const std::string& text, std::string model = "cda") {
        Plan plan = plan_of(kTool + kStock + text);
        plan.model = std::move(model);
        plan.keep_boundary = true;
        plan.block_volumes = plan.model == "cda";
        return simulate(plan);
    };
    const std::string bore =
        "G21 G90 T1 M6 S8000 M3 F300\nG0 X22. Y20. Z0.\nG3 Z-2. I-2.\nZ-4. I-2.\nZ-6. I-2.\n"
        "G3 I-2.\nG0 Z5.\nM30\n";
    const Simulation part = milled(bore);
    for (const cda::BoundaryFace& face : part.boundary->faces) {
        const auto line = part.provenance.of(face.origin).nc_line;
        EXPECT_TRUE(line == 0 || line == 8) << line;
    }
    EXPECT_EQ(part.removed_by_block.size(), 4U);
    const Simulation flat = milled(bore, "cda-flat");
    EXPECT_TRUE(flat.boundary->vertices == part.boundary->vertices);
    ASSERT_EQ(flat.boundary->faces.size(), part.boundary->faces.size());
    for (std::size_t i = 0; i < flat.boundary->faces.size(); ++i)
        EXPECT_EQ(flat.boundary->faces[i].origin, part.boundary->faces[i].origin);
}

// Rows in short moves, some inclined: the volume of each line equals the volume from subtracting
// the moves one by one.
TEST(Simulation, EachLineOfAStraightWayIsToldWhatItTook) {
    std::string text = "G21 G90 T1 M6 S8000 M3 F300\nG0 X-5. Y18. Z5.\nG1 Z-2.\n";
    for (int row = 0; row < 3; ++row) {
        text += "G91\n";
        for (int i = 0; i < 40; ++i) {
            const int slope = i / 10 % 2 == 0 ? 0 : row - 2;
            text += "G1 X" + std::to_string(row % 2 == 0 ? 1.25 : -1.25) + " Z" +
                    std::to_string(0.125 * slope) + "\n";
        }
        text += "G1 Y2.5\nG90\nG1 Z-2.5\n";
    }
    text += "G0 Z5.\nM30\n";
    for (const std::string& tool : {kTool, std::string("(T1 D=6. CR=3. - ball end mill)\n"),
                                    std::string("(T1 D=6. CR=1. - bullnose end mill)\n")}) {
        SCOPED_TRACE(tool);
        Plan plan = plan_of(tool + kStock + text);
        plan.block_volumes = true;
        const Simulation booked = simulate(plan);
        plan.model = "cda-flat";
        const Simulation measured = simulate(plan);
        EXPECT_GT(measured.removed_by_block.size(), 100U);
        for (const auto& [place, volume] : measured.removed_by_block) {
            const auto found = booked.removed_by_block.find(place);
            const double specified = found == booked.removed_by_block.end() ? 0.0 : found->second;
            EXPECT_NEAR(specified, volume, 1e-9) << place.second;
        }
    }
}

// A slot in fifty short moves: floor and walls belong to a line at most a tool width away, and the
// number of faces is small, not fifty times as large.
TEST(Simulation, AStraightWayInPiecesIsOfALineNearBy) {
    std::string text = "G21 G90 T1 M6 S8000 M3 F300\nG0 X-5. Y20. Z5.\nG1 Z-5.\n";
    for (int x = -4; x <= 45; ++x)
        text += "G1 X" + std::to_string(x) + ".\n";  // line 6 moves to X-4
    const auto milled = [&](std::string model) {
        Plan plan = plan_of(kTool + kStock + text + "G0 Z5.\nM30\n");
        plan.model = std::move(model);
        plan.keep_boundary = true;
        return simulate(plan);
    };
    const Simulation part = milled("cda");
    EXPECT_DOUBLE_EQ(part.part_volume, 16000.0 - 6 * 40 * 5);
    EXPECT_LT(part.boundary->faces.size(), 60U);
    for (const cda::BoundaryFace& face : part.boundary->faces) {
        const auto line = static_cast<double>(part.provenance.of(face.origin).nc_line);
        for (const std::uint32_t corner : face.loops[0]) {
            if (line == 0.0) continue;
            EXPECT_LE(std::abs(part.boundary->vertices[corner].x - (line - 10.0)), 6.0 + 3.0);
        }
    }
    const Simulation flat = milled("cda-flat");
    EXPECT_TRUE(flat.boundary->vertices == part.boundary->vertices);
    ASSERT_EQ(flat.boundary->faces.size(), part.boundary->faces.size());
    for (std::size_t i = 0; i < flat.boundary->faces.size(); ++i)
        EXPECT_EQ(flat.boundary->faces[i].origin, part.boundary->faces[i].origin);
}

// A turn next to the stock whose second half does not meet the stock: the following motion has a
// separate number.
TEST(Simulation, ATurnThatEndsOutsideIsOfItsOwnLine) {
    Plan plan = plan_of(kTool + kStock +
                        "G21 G90 T1 M6 S8000 M3 F300\nG0 X-3.5 Y18. Z5.\nG1 Z-4.\nG3 Y22. J2.\n"
                        "G3 Y18. J-2.\nG0 Z5.\nX30. Y30.\nG1 Z-1.\nG0 Z5.\nM30\n");
    plan.keep_boundary = true;
    const Simulation part = simulate(plan);
    int beside = 0;
    for (const cda::BoundaryFace& face : part.boundary->faces) {
        const auto line = part.provenance.of(face.origin).nc_line;
        if (line == 0) continue;
        const Vec3 corner = part.boundary->vertices[face.loops[0][0]];
        EXPECT_EQ(line, corner.x < 20 ? 7U : 10U);
        beside += corner.x < 20 ? 1 : 0;
    }
    EXPECT_GT(beside, 2);
}

TEST(Simulation, SaysWhyItCannotBe) {
    try {
        simulate(plan_of(kStock + kSlot));
        FAIL() << "nobody described the tool";
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find("tool 1 is not described"), std::string::npos)
            << e.what();
    }
}

TEST(Simulation, TakesToolsAndLanguageFromTheJob) {
    setup::JobOptions options;
    options.tools.emplace_back();
    options.tools.back().number = 1;
    options.tools.back().kind = toolpath::ToolKind::FlatEndMill;
    options.tools.back().diameter = 4.0;
    EXPECT_DOUBLE_EQ(simulate(plan_of(kStock + kSlot, options)).part_volume, 16000.0 - 4 * 40 * 5);
}

TEST(Check, OfAStringIsAVerdict) {
    const Checked clean = check(plan_of(kTool + kStock + kSlot));
    EXPECT_EQ(clean.word, "clean");
    EXPECT_EQ(clean.outcome, verify::Outcome::Clean);
    EXPECT_EQ(clean.path, "slot.nc");
    EXPECT_TRUE(clean.simulated);

    const Checked failed = check(
        plan_of(kTool + kStock + "G21 G90 T1 M6 S8000 M3\nG0 X-5. Y20. Z-5.\nG0 X45.\nM30\n"));
    EXPECT_EQ(failed.outcome, verify::Outcome::Failed);
    ASSERT_FALSE(failed.verdict.findings.empty());
    EXPECT_EQ(failed.verdict.findings.front().rule, "rapid-in-material");
    EXPECT_EQ(failed.lines.front(), "G0 X45.");
}

TEST(Check, OfALoopWithoutEndJudgesItsBeginning) {
    VerificationOptions verification_options;
    verification_options.machine.machine.travel[1] = verify::AxisRange{-100.0, 100.0};
    Plan plan = plan_of(kTool + kStock +
                        "G21 G90 T1 M6 S8000 M3\nG0 X-5. Y120. Z5.\nWHILE [1 EQ 1] DO1\n"
                        "G0 X-6.\nX-5.\nEND1\nM30\n");
    plan.job.interpreter.work_offsets_specified[0] = true;
    plan.job.interpreter.limits.repeated_blocks = 4000;
    const Checked checked = check(std::move(plan), verification_options);
    EXPECT_EQ(checked.outcome, verify::Outcome::Failed);
    EXPECT_FALSE(checked.simulated);
    const auto has = [&](std::string_view rule) {
        return std::ranges::any_of(checked.verdict.findings,
                                   [&](const verify::Finding& f) { return f.rule == rule; });
    };
    EXPECT_TRUE(has("program-fault"));
    EXPECT_TRUE(has("over-travel"));
}

TEST(Check, AsksOnlyWhatIsSelected) {
    VerificationOptions verification_options;
    for (const verify::RuleInfo& rule : verify::rules())
        verification_options.selection.ignored.emplace(rule.id, "");
    const Checked checked = check(plan_of(kTool + kStock + kSlot), verification_options);
    EXPECT_FALSE(checked.simulated);
    EXPECT_TRUE(checked.verdict.findings.empty());
}

// The slot is 80 µm deeper than the triangles of the design, whose deviation is up to 30 µm.
TEST(Check, FindsWhatTheTrianglesOfADesignMayHide) {
    Plan made = plan_of(kTool + kStock + kSlot);
    made.keep_boundary = true;
    Design design{"part.step", cda::triangulate(*simulate(made).boundary), 0.1};
    std::string deeper = kTool + kStock + kSlot;
    deeper.replace(deeper.find("Z-5."), 4, "Z-5.08");
    VerificationOptions verification_options;
    verification_options.design = &design;
    const auto gouges = [&] {
        return std::ranges::count(check(plan_of(deeper), verification_options).verdict.findings,
                                  "gouge", &verify::Finding::rule);
    };
    EXPECT_EQ(gouges(), 0);
    design.deflection_mm = 0.03;
    EXPECT_EQ(gouges(), 1);
    const Checked checked = check(plan_of(deeper), verification_options);
    EXPECT_NE(checked.verdict.outcome(), verify::Outcome::Clean);
}

TEST(CompareParts, TellsWhatOnlyOneOfThemHas) {
    const auto surveyed = [](const std::string& text) {
        SurveyedPlan side{plan_of(text), {}};
        side.survey = survey(side.plan);
        return side;
    };
    const SurveyedPlan a = surveyed(kTool + kStock + kSlot);
    std::string deeper = kSlot;
    deeper.replace(deeper.find("Z-5."), 4, "Z-6.");
    const Difference d = compare_parts(a, surveyed(kTool + kStock + deeper));
    EXPECT_FALSE(d.same_motions);
    EXPECT_NEAR(d.only_old.volume_mm3, 6 * 40 * 1, 1e-9);
    EXPECT_DOUBLE_EQ(d.only_new.volume_mm3, 0.0);
    EXPECT_TRUE(compare_parts(a, a).same_motions);
}

}  // namespace
}  // namespace ncsim::simulation
