// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs for a fourth axis as senders of hobby machines receive them: wraps without Y, flutes
// over many turns. Formulas give the volume left of the bar.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

constexpr double kPi = 3.14159265358979;

json report_of(const Folder& folder, const std::vector<std::string>& options) {
    std::vector<std::string> command{"run", "a.nc", "--report", "r.json"};
    command.insert(command.end(), options.begin(), options.end());
    const Ran ran = folder.run(command);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(folder.read("r.json"));
}

/// Style of the Fusion posts for Carvera: A increases without limit, here to 1735 degrees.
TEST(Rotary, FluteOverManyTurnsLeavesAThinnerBar) {
    Folder folder;
    folder.write("a.nc",
                 "%\n(1001)\n(T1 D=12. CR=0. - ZMIN=18. - flat end mill)\nG90 G94\nG17\nG21\n"
                 "(Rotary)\nT1 M6\nS12000 M3\nG54\nG0 A0.\nG0 X-19. Y0.\nZ40.\nZ24.\n"
                 "G1 Z18. F600.\nX19. A1735. F3000.\nG0 Z40.\nM5\nG0 A0.\nM30\n%\n");
    const json report = report_of(folder, {"--stock", "DX40x24", "--tolerance", "0.1"});
    const double bar = kPi * 20 * 20 * 24;
    const double left = kPi * 18 * 18 * 24;
    EXPECT_NEAR(report["volume_mm3"]["stock"], bar, 0.01 * bar);
    // Rotary moves remove up to 0.1 mm too little and 1 mm too much.
    EXPECT_LT(report["volume_mm3"]["part"], 1.012 * left);
    EXPECT_GT(report["volume_mm3"]["part"], 0.89 * left);
    EXPECT_LT(report["part"]["extents"]["max"][2], 18.1);
    EXPECT_GT(report["part"]["extents"]["max"][2], 17.0);
}

/// Style of Vectric's wraps for gSender: Y is wrapped around A and does not occur. Four flats, each
/// several turns further.
TEST(Rotary, WrapWithoutYMillsFlats) {
    Folder folder;
    std::string program =
        "( wrap )\n( Material Size)\n( Wrapped around X, diameter 40. )\nG21\nG90\nG17\n"
        "T1 M6\nS16000M3\nG0Z45.000\nG0X0.000A0.000\n";
    for (const char* angle : {"0.000", "450.000", "900.000", "1710.000"}) {
        program.append("G0X-50.000A").append(angle).append("\nG0Z16.000\nG1Z15.000F800.0\n");
        program.append("G1X50.000F2000.0\nG0Z45.000\n");
    }
    folder.write("a.nc", program + "G0X0.000A0.000\nM30\n");
    const json report = report_of(folder, {"--stock", "DX40x24", "--tool", "T1=flat:D50:L40"});
    const double r = 20;
    const double d = 15;
    const double segment = r * r * std::acos(d / r) - d * std::sqrt(r * r - d * d);
    const double left = (kPi * r * r - 4 * segment) * 24;
    EXPECT_NEAR(report["volume_mm3"]["part"], left, 0.006 * left);
    for (const std::size_t axis : {1U, 2U}) {
        EXPECT_NEAR(report["part"]["extents"]["max"][axis], 15.0, 1e-3);
        EXPECT_NEAR(report["part"]["extents"]["min"][axis], -15.0, 1e-3);
    }
    // The bar is not specified, so ncsim derives the bar about the rotary axis.
    const Ran derived = folder.run({"run", "a.nc", "--tool", "T1=flat:D50:L40"});
    EXPECT_NE(derived.err.find("a round bar along X"), std::string::npos) << derived.err;
    EXPECT_NE(derived.err.find("never sets Y; taken as 0"), std::string::npos) << derived.err;
}

/// Rings around a bar of 40 mm, 2 mm deep: of an O-ring by a ball, of a seat by a bull nose. By
/// Pappus' theorem.
TEST(Rotary, RingsAreTori) {
    Folder folder;
    const auto ring_of = [&](const std::string& tool, const std::string& move) {
        folder.write("a.nc", "(T1 " + tool + ")\nG21 G90 G17 G54\nT1 M6\nS5000 M3\nG0 X20 Y0 A0\n" +
                                 "G1 Z18 F300\n" + move + "\nG0 Z40\nM30\n");
        return report_of(folder, {"--stock", "DX40x60@0,0,0", "--step", "a.step"})["step"];
    };
    const double bar = kPi * 20 * 20 * 60;
    const json ball = ring_of("D=6. CR=3. - ball end mill", "G1 A360 F3000");
    EXPECT_EQ(ball["faces"], 5);
    EXPECT_EQ(ball["surfaces"]["torus"], 1);
    const double segment = 9.0 * std::acos(1.0 / 3.0) - std::sqrt(8.0);
    const double moment = 21.0 * segment - 2.0 / 3.0 * std::pow(8.0, 1.5);
    EXPECT_NEAR(ball["volume_mm3"], bar - 2.0 * kPi * moment, 1e-6 * bar);

    const json bull = ring_of("D=6. CR=1. - bull nose end mill", "G1 A-360 F3000");
    EXPECT_EQ(bull["faces"], 9);
    EXPECT_EQ(bull["surfaces"]["torus"], 2);
    const double corner = 18.5 + 1.0 / 3.0 - 19.0 * kPi / 4.0;
    EXPECT_NEAR(bull["volume_mm3"], bar - 2.0 * kPi * (228.0 - 2.0 * corner), 1e-6 * bar);

    // Part of a ring: at its ends the tool leaves its own torus and its flat end.
    const json part = ring_of("D=6. CR=1. - bull nose end mill", "G1 A100 F3000");
    EXPECT_EQ(part["faces"], 14);
    EXPECT_EQ(part["facets_kept"], 0);
    EXPECT_EQ(part["surfaces"]["torus"], 4);
}

}  // namespace
}  // namespace ncsim::cli_test
