// SPDX-License-Identifier: GPL-3.0-or-later
//
// Set-ups in job files, rotations of stock, and suggestions for keys.
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/nearest_word.h"
#include "ncsim/setup/stock_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::setup {
namespace {

std::string refusal(const std::string& text) {
    try {
        (void)parse_job_file({"job.toml", text});
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "accepted";
}

TEST(JobFile, RefusesAnOptionWithHyphens) {
    const std::string text = refusal("version = 2\ncut-free = true\n");
    EXPECT_TRUE(text.starts_with("job.toml:2:12: 'cut-free' is not known; expected "));
    EXPECT_TRUE(text.ends_with(" (did you mean cut_free?)"));
}

TEST(SetUpsOfAJob, AreStepsInTheOrderOfMachining) {
    const JobFile file = parse_job_file(
        {"job.toml",
         "[[setup]]\nname = \"top\"\nprograms = [\"a.nc\", \"b.nc\"]\n"
         "[[setup]]\nprogram = \"sub/c.nc\"\nturn = \"X180\"\nmove = [0, 0, -20]\n"});
    const std::vector<JobStep> steps = steps_of(file, "jobs");
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[1].program, "jobs/b.nc");
    EXPECT_EQ(steps[1].label, "set-up 1, top, program 2 of 2");
    EXPECT_FALSE(steps[1].begins_set_up);
    EXPECT_EQ(steps[2].set_up, 2U);
    EXPECT_EQ(steps[2].program, "jobs/sub/c.nc");
    EXPECT_EQ(steps[2].label, "set-up 2");
    EXPECT_TRUE(steps[2].begins_set_up);
    const std::vector<JobStep> alone =
        steps_of(parse_job_file({"job.toml", "program = \"a.nc\"\n"}), {});
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_EQ(alone[0].label, "");
    EXPECT_TRUE(steps_of(parse_job_file({"job.toml", "version = 2\n"}), {}).empty());
}

TEST(SetUpsOfAJob, HaveFixturesInTheFrameOfTheirZero) {
    const JobFile file = parse_job_file(
        {"job.toml",
         "[[setup]]\nprogram = \"a.nc\"\nzero = [10, 0, 5]\n"
         "[[setup.fixture]]\nname = \"v\"\nvise = { at = [0, 0, -30], opening = 50, jaw_width = "
         "100, jaw_height = 40, jaw_depth = 20, base_height = 60, parallels = [5, 30] }\n"
         "[[setup.fixture]]\nclamp = { at = [0, 20, 0], toward = \"+Y\", length = 60, width = 20, "
         "height = 12, table = -25, heel = 15, bolt = [30, 16, 8] }\n"
         "[[setup.fixture]]\noffset = \"G55\"\nbox = [[0, 0, 0], [1, 1, 1]]\n"});
    const auto& fixtures = file.set_ups.at(0).fixtures;
    ASSERT_EQ(fixtures.size(), 9U);
    EXPECT_EQ(fixtures[0].name, "v: fixed jaw");
    EXPECT_EQ(fixtures[0].box.min, (Vec3{-60, -45, -35}));
    EXPECT_EQ(fixtures[0].box.max, (Vec3{40, -25, 5}));
    EXPECT_EQ(fixtures[1].box.min, (Vec3{-60, 25, -35}));
    EXPECT_EQ(fixtures[2].name, "v: base");
    EXPECT_EQ(fixtures[2].box.min, (Vec3{-60, -45, -95}));
    EXPECT_EQ(fixtures[3].name, "v: parallel");
    EXPECT_EQ(fixtures[3].box.max, (Vec3{40, -20, -5}));
    EXPECT_EQ(fixtures[5].name, "clamp: arm");
    EXPECT_EQ(fixtures[5].box.min, (Vec3{-20, 20, -5}));
    EXPECT_EQ(fixtures[5].box.max, (Vec3{0, 80, 7}));
    EXPECT_EQ(fixtures[6].box.min, (Vec3{-20, 65, -30}));
    EXPECT_EQ(fixtures[7].box.max, (Vec3{-2, 58, 15}));
    // A fixture in a system of its own does not follow the zero.
    EXPECT_EQ(fixtures[8].box.min, (Vec3{0, 0, 0}));
}

TEST(SetUpsOfAJob, AreRefusedWithLineAndColumn) {
    EXPECT_EQ(refusal("[[setup]]\nname = \"a\"\n"), "job.toml:1:1: a set-up needs a program");
    EXPECT_EQ(refusal("[[setup]]\nprogram = \"b.toml\"\n"),
              "job.toml:2:11: 'setup.program': a job cannot contain a job; name NC programs");
    EXPECT_EQ(refusal("[[setup]]\nprogram = \"\"\n"),
              "job.toml:2:11: 'setup.program': the name is empty");
    EXPECT_TRUE(refusal("[[setup]]\nprogrma = \"a\"\n").ends_with("(did you mean program?)"));
    EXPECT_TRUE(refusal("setup = 3\n").ends_with("write [[setup]]"));
    std::string many;
    for (int i = 0; i < 101; ++i)
        many += "[[setup]]\nprogram = \"a.nc\"\n";
    EXPECT_TRUE(refusal(many).ends_with("101 set-ups; at most 100"));
}

TEST(TurnsOfStock, AreExactForRightAnglesOnly) {
    for (const char* text : {"", "X180", "X90,Z-90", "y-270", "Z360.0"})
        EXPECT_TRUE(parse_any_turn(text).placement) << text;
    const Turn turn = parse_any_turn("X90,Z-90");
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(turn.rows[i][k], turn.placement->rows[i][k]);
    }
    const Turn free = parse_any_turn("Z30,X45.5");
    EXPECT_FALSE(free.placement);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            double product = 0.0;
            for (std::size_t j = 0; j < 3; ++j)
                product += free.rows[i][j] * free.rows[k][j];
            EXPECT_NEAR(product, i == k ? 1.0 : 0.0, 1e-15);
        }
    }
    // Z30 turns X towards Y.
    const Turn z = parse_any_turn("Z30");
    EXPECT_EQ(z.rows[1][0], 0.5);
    EXPECT_EQ(z.rows[0][1], -0.5);
    for (const char* text : {"30", "X", "Q1", "X90,", ",X90", "X1e9", "Xnan", "X90 Z90", "X90;Z90"})
        EXPECT_THROW(parse_any_turn(text), std::invalid_argument) << text;
}

TEST(OutputsOfAJob, AreBelowItsFolder) {
    EXPECT_EQ(output_below("jobs", "a/b.png", "job.toml:1:1"), "jobs/a/b.png");
    for (const char* name : {"../a.png", "a/../../b.png", "/tmp/a.png", ""})
        EXPECT_THROW(output_below("jobs", name, "job.toml:1:1"), std::runtime_error) << name;
}

TEST(NearestWord, IsAFewLettersAway) {
    const std::vector<std::string> known{"stock", "start", "units"};
    EXPECT_EQ(nearest_word("stokc", known), "stock");
    EXPECT_EQ(nearest_word("colour", known), "");
}

}  // namespace
}  // namespace ncsim::setup
