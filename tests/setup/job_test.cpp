// SPDX-License-Identifier: GPL-3.0-or-later
//
// A job of a program that is given as text.
#include "ncsim/setup/job.h"

#include "ncsim/setup/coordinate_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ncsim::setup {
namespace {

const std::string kText =
    "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,30.,10.,0.,0.,10.)\nG21\nM30\n";

TEST(Job, OfATextHasWhatItsCommentsTell) {
    const Job job = job_of({"a.nc", kText});
    EXPECT_EQ(job.program.name, "a.nc");
    ASSERT_EQ(job.tools.size(), 1U);
    EXPECT_EQ(job.tools[0].specified_by, toolpath::ValueSource::Comment);
    EXPECT_EQ(job.tools[0].spec.diameter, 6.0);
    ASSERT_TRUE(job.stock);
    EXPECT_EQ(job.stock->box.size(), (Vec3{40, 30, 10}));
    EXPECT_FALSE(job.start);
    EXPECT_FALSE(job.interpreter.read_file);
}

TEST(Job, OptionsComeBeforeComments) {
    JobOptions options;
    options.inches = true;
    options.start = Vec3{1, 2, 3};
    options.offsets[1] = Vec3{-100, -50, -300};
    options.tools.emplace_back();
    options.tools[0].number = 1;
    options.tools[0].kind = toolpath::ToolKind::BallEndMill;
    options.tools[0].diameter = 4.0;
    const Job job = job_of({"a.nc", kText}, options);
    ASSERT_EQ(job.tools.size(), 1U);
    EXPECT_EQ(job.tools[0].specified_by, toolpath::ValueSource::Option);
    EXPECT_EQ(job.tools[0].spec.diameter, 4.0);
    EXPECT_EQ(job.start, (Vec3{1, 2, 3}));
    EXPECT_EQ(job.interpreter.default_units, gcode::DefaultUnits::Inches);
    EXPECT_EQ(origin_of(job.interpreter, 1), (Vec3{-100, -50, -300}));
    EXPECT_FALSE(origin_of(job.interpreter, 2));
}

// Drills, spot drills, chamfer mills and countersinks of one angle have one shape.
TEST(Job, KindsOfOneShapeAreNoContradiction) {
    using enum toolpath::ToolKind;
    const auto contradicts = [](toolpath::ToolKind kind, double angle, const std::string& comment) {
        JobOptions options;
        options.tools.emplace_back();
        options.tools[0].number = 1;
        options.tools[0].kind = kind;
        options.tools[0].diameter = 10.0;
        if (angle > 0.0) options.tools[0].angle = angle;
        const Job job = job_of({"a.nc", "(T1 " + comment + ")\nG21\nT1 M6\nG0 X1\nM30\n"}, options);
        return std::ranges::any_of(
            job.doubts, [](const auto& doubt) { return doubt.reason == "contradiction"; });
    };
    const std::string spot = "D=10. CR=0. TAPER=90deg - spot drill";
    for (const auto kind : {Drill, VCutter, ChamferMill, Countersink}) {
        EXPECT_FALSE(contradicts(kind, 90.0, spot));
        EXPECT_TRUE(contradicts(kind, 60.0, spot));
    }
    EXPECT_TRUE(contradicts(Drill, 0.0, spot)) << "118 degrees";
    EXPECT_FALSE(contradicts(VCutter, 0.0, spot)) << "90 degrees";
    EXPECT_TRUE(contradicts(FlatEndMill, 0.0, spot));
    EXPECT_TRUE(contradicts(Tap, 0.0, "D=10. - drill"));
}

TEST(Job, IsInInchesWhereToolsAndNumbersAgree) {
    const auto units = [](const std::string& tools, const std::string& moves) {
        const Job job = job_of({"a.nc", tools + "\nT1 M6\n" + moves + "\nM30\n"});
        EXPECT_TRUE(job.units_assumed);
        return job.interpreter.default_units;
    };
    using enum gcode::DefaultUnits;
    const std::string small = "G0 X-.5 Y2.25 Z.1\nG1 Z-.25 F22.";
    for (const char* tools : {"(T1 3/4\" FLAT END MILL)", "(T1 1/2 FLAT ENDMILL)",
                              "(T1 .5 INCH ENDMILL)", "(T1 D=0.5IN - flat end mill)"}) {
        EXPECT_EQ(units(tools, small), Inches) << tools;
        // Numbers of this size are millimetres, and units in the program have priority.
        EXPECT_EQ(units(tools, "G0 X120. Y2.25\nG1 Z-.25 F22."), Millimetres);
        EXPECT_EQ(units(tools, "G0 X1. Y2.25\nG1 Z-.25 F800."), Millimetres);
        EXPECT_EQ(units(tools, "G21\n" + small), Millimetres);
    }
    for (const char* tools : {"(T1 D=6. CR=0. - flat end mill)", "(T1 6MM FLAT ENDMILL)",
                              "(T1 1/4 IN (6.35 MM) FLAT ENDMILL)", "(3/4/26 T1 6 ENDMILL)"})
        EXPECT_EQ(units(tools, small), Millimetres) << tools;
}

TEST(Job, CompensationIsARadiusOfARegister) {
    JobOptions options;
    options.compensation = {{1, 0.25}, {2, 0.0}};
    const Job job = job_of({"a.nc", kText}, options);
    EXPECT_EQ(job.interpreter.compensation.at(1).mm(), 0.25);
    EXPECT_EQ(job.interpreter.compensation.at(2).mm(), 0.0);
}

TEST(Job, OfBinaryDataIsRefused) {
    EXPECT_THROW(job_of({"a.nc", std::string("G0\0X1", 5)}), std::runtime_error);
}

TEST(CoordinateSystems, AreNamedAsPeopleNameThem) {
    for (const char* name : {"G54", "G59", "G59.1", "G59.3", "G54.1 P1", "G54.1 P300"}) {
        const auto system = system_named(name);
        ASSERT_TRUE(system) << name;
        EXPECT_EQ(name_of_system(*system), name);
    }
    for (const char* name : {"G53", "G60", "G59.4", "G54.1", "G54.1 P0", "G54.1 P301", "g54"})
        EXPECT_FALSE(system_named(name)) << name;
}

}  // namespace
}  // namespace ncsim::setup
