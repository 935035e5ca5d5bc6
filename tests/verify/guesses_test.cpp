// SPDX-License-Identifier: GPL-3.0-or-later
//
// Doubts about unspecified values, each on both sides of its limit.
#include "guesses.h"

#include "ncsim/gcode/state.h"

#include "unknown_length.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace ncsim::verify {
namespace {

using gcode::Length;

gcode::Position at(double x, double y, double z) {
    gcode::Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    return p;
}

gcode::Motion line(const gcode::Position& from, const gcode::Position& to) {
    gcode::Motion motion;
    motion.action = gcode::Linear{from, to};
    motion.tool = 1;
    return motion;
}

Setup with_tool() {
    verify::Setup setup;
    ToolFacts facts;
    facts.tool = toolpath::flat_end_mill(10.0, 20.0);
    facts.tool.number = 1;
    setup.tools.emplace(1, facts);
    return setup;
}

/// Reasons and messages of the doubts that `take` logs, one a line.
template <class Take>
std::string doubts(const Setup& setup, Take take) {
    FindingLog log(setup);
    take(log);
    Verdict verdict;
    log.finish(verdict);
    std::string all;
    for (const Doubt& doubt : verdict.doubts)
        all += doubt.reason + ": " + doubt.message + '\n';
    return all;
}

std::string of_move(const Setup& setup, const gcode::Motion& motion, bool is_watched = true,
                    bool needs_part = true, bool passes_above = false, bool after_probe = false) {
    Move move;
    move.motion = &motion;
    move.is_move = true;
    move.passes_above = passes_above;
    move.after_probe = after_probe;
    return doubts(setup, [&](FindingLog& log) {
        doubt_guesses_of_move(setup, move, is_watched, needs_part, log);
    });
}

TEST(Guesses, OfAMoveThatIsWhollySpecifiedAreNone) {
    const verify::Setup setup = with_tool();
    EXPECT_EQ(of_move(setup, line(at(0, 0, 0), at(1, 0, 0))), "");
}

TEST(Guesses, OfStartsAndOffsets) {
    verify::Setup setup = with_tool();
    const gcode::Motion good = line(at(0, 0, 0), at(1, 0, 0));
    gcode::Motion motion = good;
    motion.known_start.x = false;
    EXPECT_EQ(of_move(setup, motion), "start-unknown: the start of the move is unknown\n");
    EXPECT_EQ(of_move(setup, motion, true, true, true), "") << "above all bodies";
    motion = good;
    motion.start_assumed = true;
    EXPECT_EQ(of_move(setup, motion),
              "start-unknown: the program continues by increments from an unknown position; taken "
              "as 0\n");
    motion = good;
    motion.offset_unknown = true;
    EXPECT_EQ(of_move(setup, motion),
              "offset-guess: the place of a coordinate system is not specified; its zero was taken "
              "to be that of the system before it\n");
    motion = good;
    motion.machine_coordinates = true;
    EXPECT_EQ(of_move(setup, motion), "");
    setup.home_assumption = "assumed";
    EXPECT_EQ(of_move(setup, motion),
              "offset-guess: a move goes to a place of the machine (G28, G30, G53), and where the "
              "workpiece lies in it is not specified\n");
}

TEST(Guesses, OfToolsAndProbes) {
    verify::Setup setup = with_tool();
    gcode::Motion motion = line(at(0, 0, 0), at(1, 0, 0));
    motion.tool = 5;
    EXPECT_EQ(of_move(setup, motion, false), "not-simulated: T5 moves and is not described\n");
    EXPECT_EQ(of_move(setup, motion, false, false), "") << "no rule needs the part";
    motion.tool = 0;
    EXPECT_EQ(of_move(setup, motion, false),
              "not-simulated: moves before the first tool change were not simulated\n");
    motion.known_start.z = false;
    EXPECT_EQ(of_move(setup, motion, false), "start-unknown: the start of the move is unknown\n");
    setup.not_simulated = "a reason";
    motion.known_start.z = true;
    EXPECT_EQ(of_move(setup, motion, false), "") << "said once, of the set-up";
    setup.not_simulated.reset();
    motion.tool = 1;
    EXPECT_EQ(of_move(setup, motion, true, true, false, true),
              "probe-guess: moves after a probe stand on what it met\n");
    EXPECT_EQ(of_move(setup, motion, true, false, false, true), "");
}

TEST(Guesses, OfRotaryAxes) {
    const verify::Setup setup = with_tool();
    gcode::Motion motion = line(at(0, 0, 0), at(1, 0, 0));
    std::get<gcode::Linear>(motion.action).to.b = gcode::Angle::from_degrees(1);
    EXPECT_EQ(of_move(setup, motion),
              "kinematics-guess: rotary axes turn; taken to turn the tool about the program zero "
              "(ISO 841)\n");
    EXPECT_EQ(of_move(setup, motion, true, false), "");
}

/// Doubts of a path next to the fixture from (20, 20, -10) to (40, 40, 5).
std::string blend(const Box& path, double blend_mm, bool machine_coordinates = false,
                  int tool = 1) {
    verify::Setup setup = with_tool();
    setup.blend_mm = blend_mm;
    Fixture jaw;
    jaw.name = "jaw";
    jaw.box = {{20, 20, -10}, {40, 40, 5}};
    setup.machine.fixtures.push_back(jaw);
    gcode::Motion motion = line(at(0, 0, 0), at(1, 0, 0));
    motion.machine_coordinates = machine_coordinates;
    motion.tool = tool;
    Move move;
    move.motion = &motion;
    move.path = path;
    return doubts(setup, [&](FindingLog& log) { doubt_blend(setup, move, log); });
}

TEST(Guesses, OfCornersNearAFixture) {
    // The radius of 5 mm and 0.5 mm of G64 sideways; 0.5 mm downwards.
    const auto is_near = [](const Vec3& p) { return !blend({p, p}, 0.5).empty(); };
    EXPECT_EQ(blend({{30, 30, 0}, {30, 30, 0}}, 0.5),
              "path-blending: the control may miss corners by 0.5 mm (G64 P), and 'jaw' is "
              "nearer\n");
    EXPECT_FALSE(is_near({14.5, 30, 0}));
    EXPECT_TRUE(is_near({14.501, 30, 0}));
    EXPECT_TRUE(is_near({45.499, 30, 0}));
    EXPECT_FALSE(is_near({45.5, 30, 0}));
    EXPECT_FALSE(is_near({30, 14.5, 0}));
    EXPECT_TRUE(is_near({30, 14.501, 0}));
    EXPECT_TRUE(is_near({30, 45.499, 0}));
    EXPECT_FALSE(is_near({30, 45.5, 0}));
    EXPECT_TRUE(is_near({30, 30, 5.499}));
    EXPECT_FALSE(is_near({30, 30, 5.5}));
    EXPECT_TRUE(is_near({30, 30, -50})) << "the tool reaches up";
    const Box over{{30, 30, 0}, {30, 30, 0}};
    EXPECT_EQ(blend(over, 0.0), "");
    EXPECT_EQ(blend({}, 0.5), "");
    EXPECT_EQ(blend(over, 0.5, true), "");
    // A tool that is not described has no radius.
    EXPECT_EQ(blend({{19.5, 30, 0}, {19.5, 30, 0}}, 0.5, false, 7), "");
    EXPECT_NE(blend({{19.501, 30, 0}, {19.501, 30, 0}}, 0.5, false, 7), "");
}

std::string of_setup(const Setup& setup, bool needs_part = true) {
    return doubts(setup,
                  [&](FindingLog& log) { doubt_guesses_of_setup(setup, {}, needs_part, log); });
}

TEST(Guesses, OfASetUp) {
    verify::Setup setup = with_tool();
    EXPECT_EQ(of_setup(setup), "");
    setup.units_assumption = "millimetres";
    EXPECT_EQ(of_setup(setup, false), "units-guess: units: millimetres\n");
    setup.units_assumption.clear();
    setup.stock_assumption = "derived";
    EXPECT_EQ(of_setup(setup), "stock-guess: stock: derived\n");
    EXPECT_EQ(of_setup(setup, false), "");
    setup.not_simulated = "T7 is not described";
    EXPECT_EQ(of_setup(setup),
              "not-simulated: the program was not simulated: T7 is not described\n");
    EXPECT_EQ(of_setup(setup, false), "");
    setup = with_tool();
    setup.setting_askew = 0.25;
    EXPECT_NE(of_setup(setup).find("kinematics-guess: the part is turned by 0.25 degrees"),
              std::string::npos);
    setup = with_tool();
    setup.tools.at(1).is_guess = true;
    setup.tools.at(1).assumption = "a flat end mill";
    EXPECT_EQ(of_setup(setup), "tool-guess: T1: a flat end mill\n");
}

TEST(Guesses, OfFlutesNeedsAPlaceWhereTheyWouldCut) {
    verify::Setup setup = with_tool();
    setup.tools.at(1).certain_flutes = 12.0;
    std::map<int, ToolMonitors> tools;
    const auto said = [&] {
        return doubts(setup,
                      [&](FindingLog& log) { doubt_guesses_of_setup(setup, tools, true, log); });
    };
    tools[1].uncertain_mm = 0.0;
    EXPECT_EQ(said(), "");
    tools[1].uncertain_mm = 2.5;
    EXPECT_EQ(said(),
              "flutes-guess: T1 would have to cut 14.5 mm high, and its flutes are not known to be "
              "longer than 12 mm\n");
}

// --- Unknown lengths ---

/// T1 has flutes of 20 mm and an unknown holder of up to 60 mm.
Setup with_unknown_length() {
    verify::Setup setup = with_tool();
    setup.uses_length_offsets = true;
    setup.machine.work_zero = Vec3{0, 0, -500};
    setup.stock = Box{{-20, -15, -10}, {20, 15, 0}};
    return setup;
}

std::string of_length(const Setup& setup, const gcode::Motion& motion, bool nose,
                      int length_register = 1) {
    Move move;
    move.motion = &motion;
    move.is_move = true;
    move.length_register = length_register;
    move.starts_at_nose = move.ends_at_nose = nose;
    move.path.add(Vec3{gcode::start_of(motion)->x.mm(), gcode::start_of(motion)->y.mm(), 0});
    move.path.add(Vec3{gcode::end_of(motion)->x.mm(), gcode::end_of(motion)->y.mm(), 0});
    return doubts(setup, [&](FindingLog& log) { doubt_unknown_length(setup, move, log); });
}

TEST(UnknownLength, MayTakeZBeyondItsTravel) {
    verify::Setup setup = with_unknown_length();
    setup.machine.travel[2] = AxisRange{-400, 0};
    const auto above = [&](double z) { return line(at(0, 0, 0), at(0, 0, z)); };
    // Z of the machine is z - 500 + 80 at most.
    EXPECT_EQ(of_length(setup, above(420.0), false), "");
    EXPECT_EQ(of_length(setup, above(420.001), false),
              "length-offset: the length of T1 is not specified; between 20 and 80 mm Z runs "
              "beyond its upper end\n");
    EXPECT_EQ(of_length(setup, line(at(0, 0, 420.001), at(0, 0, 0)), false).empty(), false)
        << "at the start";
    EXPECT_EQ(of_length(setup, above(420.001), false, gcode::kNoLength), "") << "no offset";
    setup.tools.at(1).holder_specified = true;
    EXPECT_EQ(of_length(setup, above(480.0), false), "");
    EXPECT_NE(of_length(setup, above(480.001), false), "");
    setup.tools.at(1).certain_flutes = 12.0;
    EXPECT_EQ(of_length(setup, above(488.0), false), "");
    EXPECT_NE(of_length(setup, above(488.001), false), "");
    setup.machine.travel[2].reset();
    EXPECT_EQ(of_length(setup, above(999.0), false), "");
}

TEST(UnknownLength, MayTakeTheTipIntoABody) {
    verify::Setup setup = with_unknown_length();
    // The nose at Z80 has the tip at Z0, on top of the stock.
    const auto over = [&](double x, double y, double z) {
        return of_length(setup, line(at(x, y, z), at(x, y, z)), true);
    };
    EXPECT_EQ(over(0, 0, 80.0), "");
    EXPECT_EQ(over(0, 0, 79.999),
              "length-offset: the length of T1 is not specified; between 20 and 80 mm it meets the "
              "stock in machine coordinates\n");
    // The radius of 5 mm.
    EXPECT_EQ(over(25, 0, 50), "");
    EXPECT_NE(over(24.999, 0, 50), "");
    EXPECT_EQ(over(-25, 0, 50), "");
    EXPECT_NE(over(-24.999, 0, 50), "");
    EXPECT_EQ(over(0, 20, 50), "");
    EXPECT_NE(over(0, 19.999, 50), "");
    EXPECT_EQ(over(0, -20, 50), "");
    EXPECT_NE(over(0, -19.999, 50), "");
    Fixture jaw;
    jaw.name = "jaw";
    jaw.box = {{50, 0, -10}, {60, 10, 40}};
    setup.machine.fixtures.push_back(jaw);
    EXPECT_EQ(over(55, 5, 120.0), "");
    EXPECT_NE(over(55, 5, 119.999).find("it meets the fixture 'jaw' in machine coordinates"),
              std::string::npos);
    setup.stock.reset();
    EXPECT_EQ(over(0, 0, 50), "");
}

TEST(UnknownLength, IsOfToolsWithoutAnyLength) {
    verify::Setup setup = with_unknown_length();
    const gcode::Motion motion = line(at(0, 0, 50), at(0, 0, 50));
    EXPECT_NE(of_length(setup, motion, true), "");
    Move move;
    move.motion = &motion;
    EXPECT_TRUE(has_unknown_length(setup, move));
    move.tool_length = 80.0;
    EXPECT_FALSE(has_unknown_length(setup, move));
    move.tool_length.reset();
    move.length_specified = true;
    EXPECT_FALSE(has_unknown_length(setup, move));
    move.length_specified = false;
    gcode::Motion other = motion;
    for (const int tool : {0, 7}) {
        other.tool = tool;
        move.motion = &other;
        EXPECT_FALSE(has_unknown_length(setup, move)) << tool;
    }
    move.motion = &motion;
    setup.uses_length_offsets = false;
    EXPECT_FALSE(has_unknown_length(setup, move));
    setup = with_unknown_length();
    setup.machine.work_zero.reset();
    EXPECT_EQ(of_length(setup, motion, true), "");
}

}  // namespace
}  // namespace ncsim::verify
