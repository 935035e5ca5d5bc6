// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values on both sides of a limit: the last value that a block accepts, and the first that it
// refuses. The tool has a diameter of 10 mm.
#include "gcode/klartext_made.h"
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::gcode::value_limits_test {
namespace {

using language_test::Made;

/// `@` in the blocks stands for the value.
struct Limit {
    const char* blocks;
    std::vector<const char*> accepted, refused;
};

const std::string kDepths = " Q207=500 Q351=+1 Q201=-4 Q202=4 Q206=150 Q200=2 Q203=+0 Q204=20";

const std::vector<Limit> kKlartext{
    {"CYCL DEF 258 Q573=0 Q571=40 Q222=300 Q572=@ Q224=0 Q220=0 Q368=0 Q370=1",
     {"3", "1000"},
     {"2", "1001", "3.5"}},
    {"CYCL DEF 258 Q573=0 Q571=40 Q222=@ Q572=6 Q224=0 Q220=0 Q368=0 Q370=1", {"46.2"}, {"46.1"}},
    {"CYCL DEF 252 Q215=0 Q223=30 Q368=0 Q369=0 Q366=0 Q370=@", {"0.1", "1.9999"}, {"0", "2"}},
    {"CYCL DEF 252 Q215=0 Q223=@ Q368=0 Q369=0 Q366=0 Q370=1", {"10.001"}, {"9.999"}},
    {"CYCL DEF 253 Q215=0 Q218=30 Q219=@ Q368=0 Q369=0 Q366=0", {"10"}, {"9.999"}},
    {"CYCL DEF 253 Q215=0 Q218=@ Q219=12 Q368=0 Q369=0 Q366=0", {"12"}, {"11.999"}},
    {"CYCL DEF 256 Q218=40 Q424=@ Q219=24 Q425=44 Q220=0 Q370=1", {"40"}, {"39.999"}},
    {"CYCL DEF 256 Q218=40 Q424=56 Q219=24 Q425=@ Q220=0 Q370=1", {"24"}, {"23.999"}},
    {"CYCL DEF 208 Q334=3 Q335=@", {"10.001"}, {"10", "9"}},
    {"CYCL DEF 200\nCYCL DEF 220 Q216=0 Q217=0 Q244=40 Q245=0 Q246=360 Q247=0 Q241=@",
     {},
     {"0", "10001"}},
    {"APPR CT X+10 Y+10 CCA@ R+8 RL F100\nL Y+50\nL X+50 R0", {"0.1", "360"}, {"0", "360.1"}},
    {"L X+10 F100\nCR X+20 Y+0 R+@ DR+", {"5"}, {"4.9"}},
    {"L X+10 F@", {"1"}, {"-1"}},
    {"TCH PROBE @ TOOL Q340=1\nL X+1 FMAX",
     {"30", "33", "480", "485", "580", "589"},
     {"29", "34", "479", "486", "579", "590"}},
};

const std::vector<Limit> kSinumerik{
    {"F100\nG3 X0 Y0 I5 J0 TURN=@", {"0", "1", "999"}, {"-1", "1000"}},
    {"F100\nG3 X10 Y0 AR=@", {"0.01", "359.99"}, {"0", "360", "-5"}},
    {"F100\nG3 X10 Y0 CR=@", {"5", "-5"}, {"4.9"}},
    {"F100\nCYCLE81(@,0,2,-5)", {"0", "50"}, {"-0.001"}},
    {"F100\nCYCLE81(10,0,2,@)", {"0", "-5"}, {"0.001"}},
    {"F100\nCYCLE83(10,0,2,-5,,,4,@,0,0,1,1)", {"0", "1"}, {"-0.1"}},
    {"F100\nMCALL CYCLE81(10,0,2,-1)\nHOLES1(0,0,0,1,1,@)", {"1", "10000"}, {"0", "10001"}},
    {"F100\nMCALL CYCLE81(10,0,2,-1)\nHOLES2(0,0,9,0,0,@)", {"1", "10000"}, {"0", "10001"}},
    {"F100\nMCALL CYCLE81(10,0,2,-1)\nCYCLE801(0,0,0,1,1,@,100)", {"1", "100"}, {"0", "101"}},
    {"SLOT1(20,0,2,-3,,@,20,14,0,0,8,0,0,150,500,4,2,0,0)", {"1"}, {"0"}},
    {"SLOT1(20,0,2,-3,,1,20,@,0,0,8,0,0,150,500,4,2,0,0)", {"10"}, {"9.999"}},
    {"SLOT1(20,0,2,-3,,1,@,14,0,0,8,0,0,150,500,4,2,0,0)", {"14"}, {"13.999"}},
    {"SLOT1(20,0,2,-3,,1,20,14,0,0,8,0,0,150,500,4,@,0,0)", {"0", "3"}, {"4", "-1"}},
    {"SLOT2(20,0,2,-3,,1,@,14,0,0,25,0,0,150,500,4,2,0,0)", {"0.1"}, {"0", "-1"}},
    {"POCKET4(20,0,2,-3,9,0,0,4,0,0,500,150,@,11)", {"0", "3"}, {"4"}},
    {"POCKET4(20,0,2,-3,9,0,0,4,0,0,500,150,0,@)", {"1", "2", "4"}, {"3", "5"}},
    {"POCKET4(20,0,2,-3,@,0,0,4,0,0,500,150,0,11)", {"5.001"}, {"4.999"}},
    {"CYCLE76(20,0,2,-3,,50,30,5,0,0,0,4,,,500,150,0,1,@,60)", {"50"}, {"49.999"}},
    {"CYCLE76(20,0,2,-3,,50,30,5,0,0,0,4,,,500,150,0,1,70,@)", {"30"}, {"29.999"}},
    {"CYCLE90(20,0,2,-3,,20,18,1,300,@,0,0,0)", {"2", "3"}, {"1", "4"}},
    {"CYCLE90(20,0,2,-3,,20,18,1,300,2,@,0,0)", {"0", "1"}, {"2"}},
    {"CYCLE90(20,0,2,-3,,@,9,1,300,2,0,0,0)", {"10.002"}, {"10"}},
    {"CYCLE90(20,0,2,-3,,20,18,@,300,2,0,0,0)", {"0.1"}, {"0"}},
};

std::string with_value(const char* blocks, const std::string& value) {
    std::string text = blocks;
    return text.replace(text.find('@'), 1, value);
}

TEST(ValueLimits, OfKlartext) {
    for (const Limit& limit : kKlartext) {
        const auto errors = [&](const char* value) {
            std::string text = with_value(limit.blocks, value);
            if (text.starts_with("CYCL")) text += kDepths + "\nL X+0 Y+0 FMAX M99";
            return language_test::run(klartext_test::klartext(text)).errors();
        };
        for (const char* value : limit.accepted)
            EXPECT_EQ(errors(value), "") << with_value(limit.blocks, value);
        for (const char* value : limit.refused)
            EXPECT_NE(errors(value), "") << with_value(limit.blocks, value);
    }
}

TEST(ValueLimits, OfSinumerik) {
    for (const Limit& limit : kSinumerik) {
        const auto errors = [&](const char* value) {
            return sinumerik_test::run(sinumerik_test::sinumerik(with_value(limit.blocks, value)))
                .errors();
        };
        for (const char* value : limit.accepted)
            EXPECT_EQ(errors(value), "") << with_value(limit.blocks, value);
        for (const char* value : limit.refused)
            EXPECT_NE(errors(value), "") << with_value(limit.blocks, value);
    }
}

}  // namespace
}  // namespace ncsim::gcode::value_limits_test
