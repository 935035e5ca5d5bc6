// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reasons why a program is not proven, messages about the reasons, and options that accept or
// resolve doubts.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

json verdict_of(const Folder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "check");
    arguments.insert(arguments.end(), {"-q", "--json", "verdict.json"});
    const Ran ran = folder.run(arguments);
    EXPECT_TRUE(folder.has("verdict.json")) << ran.err;
    return json::parse(folder.read("verdict.json"))["programs"][0];
}

std::set<std::string> open_doubts(const json& program) {
    std::set<std::string> reasons;
    for (const json& d : program["doubts"]) {
        if (!d["accepted"]) reasons.insert(d["reason"]);
    }
    return reasons;
}

const std::string kNoStart = replaced(kSlot, " (FROM/0.,0.,100.)", "");
const std::string kNoStock = replaced(kSlot, "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n", "");

// --- Accepting and requiring -------------------------------------------------------------------

TEST(Doubts, HaveAnExitCodeOfTheirOwnAndSayWhatToTell) {
    Folder folder;
    folder.write("slot.nc", kNoStart);
    const Ran ran = folder.run({"check", "slot.nc"});
    EXPECT_EQ(ran.exit_code, 4);
    EXPECT_TRUE(contains(ran.out, "slot.nc: not proven: 0 errors")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "  fix      start-unknown: specify --start X,Y,Z")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "  or       --accept start-unknown\n")) << ran.out;
    EXPECT_EQ(folder.run({"check", "slot.nc", "--start", "0,0,100"}).exit_code, 0);
    EXPECT_EQ(folder.run({"check", "slot.nc", "--exit-zero"}).exit_code, 0);
}

TEST(Doubts, ThatSomebodyAcceptsAreToldAndDoNotCount) {
    Folder folder;
    folder.write("slot.nc", kNoStart);
    const json program = verdict_of(folder, {"slot.nc", "--accept", "start-unknown"});
    EXPECT_EQ(program["verdict"], "accepted");
    ASSERT_EQ(program["doubts"].size(), 1U);
    EXPECT_EQ(program["doubts"][0]["reason"], "start-unknown");
    EXPECT_TRUE(program["doubts"][0]["accepted"]);
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--accept", "stock-guess"})["verdict"], "not-proven");
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--accept", "all"})["verdict"], "accepted");
    EXPECT_EQ(folder.run({"check", "slot.nc", "--accept", "luck"}).exit_code, 2);
}

// Job files and scripts of 0.1 have the older name of the reason.
TEST(Doubts, AreAcceptedByTheOlderNameOfTheirReason) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const std::vector<std::string> words{"check", "slot.nc", "--compensation", "D2=0"};
    const auto checked = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = words;
        all.insert(all.end(), more.begin(), more.end());
        return folder.run(all);
    };
    EXPECT_TRUE(contains(checked({}).out, "[setting-not-used]"));
    EXPECT_EQ(checked({}).exit_code, 4);
    for (const char* name : {"setting-not-used", "told-not-used"}) {
        const Ran ran = checked({"--accept", name});
        EXPECT_EQ(ran.exit_code, 0) << ran.out;
        EXPECT_TRUE(contains(ran.out, "accepted setting-not-used")) << ran.out;
    }
    folder.write("job.toml", "version = 2\nprogram = \"slot.nc\"\naccept = [\"told-not-used\"]\n");
    EXPECT_EQ(checked({"--job", "job.toml"}).exit_code, 0);
}

TEST(Doubts, NeverHideAnError) {
    Folder folder;
    folder.write("slot.nc", replaced(kNoStart, "S1000 M3\n", ""));
    const json program = verdict_of(folder, {"slot.nc", "--accept", "all"});
    EXPECT_EQ(program["verdict"], "failed");
    EXPECT_EQ(verdict_of(folder, {"slot.nc"})["verdict"], "failed");
}

TEST(Doubts, AnErrorThatRestsOnAGuessIsOneAndIfItIsAcceptedAnErrorAgain) {
    Folder folder;
    folder.write("slot.nc", replaced(kNoStock, "S1000 M3\n", ""));
    const json open = verdict_of(folder, {"slot.nc"});
    EXPECT_EQ(open["verdict"], "not-proven");
    EXPECT_EQ(open["findings"][0]["severity"], "warning");
    EXPECT_TRUE(open_doubts(open).contains("stock-guess"));
    const json decided = verdict_of(folder, {"slot.nc", "--accept", "stock-guess"});
    EXPECT_EQ(decided["verdict"], "failed");
    EXPECT_EQ(decided["findings"][0]["severity"], "error");
}

TEST(Doubts, TheWorstVerdictOfSeveralProgramsCounts) {
    Folder folder;
    folder.write("clean.nc", kSlot);
    folder.write("doubtful.nc", kNoStart);
    folder.write("faulty.nc", replaced(kSlot, "S1000 M3\n", ""));
    EXPECT_EQ(folder.run({"check", "clean.nc", "doubtful.nc", "-q"}).exit_code, 4);
    EXPECT_EQ(folder.run({"check", "doubtful.nc", "faulty.nc", "clean.nc", "-q"}).exit_code, 1);
    EXPECT_EQ(folder.run({"check", "faulty.nc", "nowhere.nc", "-q"}).exit_code, 2);
}

TEST(Requirements, MakeADoubtOfWhatNobodyTold) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    for (const char* thing : {"holder", "fixtures", "travels", "offsets"}) {
        SCOPED_TRACE(thing);
        const json program = verdict_of(folder, {"slot.nc", "--require", thing});
        EXPECT_EQ(program["verdict"], "not-proven");
        EXPECT_EQ(open_doubts(program), std::set<std::string>{"required"});
    }
    folder.write("m.toml",
                 "[travel]\nx = [-500, 0]\ny = [-500, 0]\nz = [-500, 0]\n[position]\nwork_zero = "
                 "[-250, -250, -300]\n[[fixture]]\nname = 'vice'\nbox = [[-20, 16, -20], [20, 30, "
                 "-5]]\n");
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--machine", "m.toml", "--tool",
                                  "T1=flat:D10:L20:S10x10:H40x30", "--require",
                                  "holder,fixtures,travels,offsets"})["verdict"],
              "clean");
    EXPECT_EQ(folder.run({"check", "slot.nc", "--require", "luck"}).exit_code, 2);
}

// --- Job files ---------------------------------------------------------------------------------

TEST(JobFile, TellsStartOffsetsWhatIsAcceptedAndWhatIsRequired) {
    Folder folder;
    const std::string second =
        replaced(kNoStart, "M30\n", "G55\nG0 X-30. Y0. Z5.\nG0 Z-2.\nG1 X30. F500.\nG0 Z5.\nM30\n");
    folder.write("two.nc", second);
    EXPECT_EQ(open_doubts(verdict_of(folder, {"two.nc"})),
              (std::set<std::string>{"offset-guess", "start-unknown"}));
    folder.write("job.toml",
                 "version = 2\nstart = [0, 0, 100]\n[offsets]\nG54 = [-200, -100, "
                 "-300]\nG55 = [-200, -94, -300]\n");
    const json specified = verdict_of(folder, {"two.nc", "--job", "job.toml"});
    EXPECT_EQ(specified["verdict"], "clean") << specified.dump(1);
    folder.write("job.toml", "version = 2\naccept = ['offset-guess', 'start-unknown']\n");
    EXPECT_EQ(verdict_of(folder, {"two.nc", "--job", "job.toml"})["verdict"], "accepted");
    folder.write("job.toml", "version = 2\naccept = ['all']\nrequire = ['travels']\n");
    const json required = verdict_of(folder, {"two.nc", "--job", "job.toml"});
    ASSERT_FALSE(required["doubts"].empty());
    folder.write("job.toml", "version = 2\nstart = [0, 0, 100]\nrequire = ['travels']\n");
    folder.write("slot.nc", kNoStart);
    EXPECT_EQ(open_doubts(verdict_of(folder, {"slot.nc", "--job", "job.toml"})),
              std::set<std::string>{"required"});
}

TEST(JobFile, KeepsWhatWasToldForTheNextRun) {
    Folder folder;
    folder.write("slot.nc", kNoStart);
    const Ran saved =
        folder.run({"run", "slot.nc", "--start", "1,2,100", "--tool",
                    "T1=flat:D10:L22:S12x30:H28x15,40x25", "--save-job", "job.toml", "-q"});
    EXPECT_EQ(saved.exit_code, 0) << saved.out << saved.err;
    const std::string job = folder.read("job.toml");
    EXPECT_TRUE(contains(job, "start = [1.0, 2.0, 100.0]")) << job;
    EXPECT_TRUE(contains(job, "holder = [[28.0, 28.0, 15.0], [40.0, 40.0, 25.0]]")) << job;
    EXPECT_EQ(
        verdict_of(folder, {"slot.nc", "--job", "job.toml", "--require", "holder"})["verdict"],
        "clean");
}

// --- Holders -----------------------------------------------------------------------------------

TEST(Holders, OfAFileAreVerified) {
    Folder folder;
    folder.write("slot.nc", replaced(kSlot, "G0 Z-2.", "G0 Z-9."));
    const std::string holders =
        "[[holder]]\nname = 'ER16'\nsegments = [[28, 28, 30], [28, 40, 5]]\n"
        "[[tool]]\nnumber = 1\nholder = 'ER16'\nflutes = 20\n";
    folder.write("holders.toml", holders + "stick_out = 8.5\n");
    const json low = verdict_of(folder, {"slot.nc", "--holders", "holders.toml"});
    EXPECT_EQ(low["verdict"], "failed") << low.dump(1);
    EXPECT_EQ(low["findings"][0]["rule"], "non-cutting-contact");
    EXPECT_NEAR(low["findings"][0]["quantity"]["value"].get<double>(), 0.5, 0.0101);
    folder.write("holders.toml", holders + "stick_out = 9\n");
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--holders", "holders.toml"})["verdict"], "clean")
        << "touching is not cutting";
    folder.write("holders.toml", holders + "stick_out = 9\n[[tool]]\nnumber = 1\n");
    const Ran twice = folder.run({"check", "slot.nc", "--holders", "holders.toml"});
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_TRUE(contains(twice.out, "holders.toml:9:1: tool 1 is described twice")) << twice.out;
}

// --- Doubts from accuracy -----------------------------------------------------------------------

TEST(ContactRefiner, DecidesWhatTheToolsLeaveOpen) {
    // A rapid move downwards next to the corner of the block at 20, 15: on the diagonal, where the
    // polygon of the cutter extends beyond the circle.
    const auto program = [](double distance) {
        const double aside = (5.0 + distance) / std::sqrt(2.0);
        std::string text(kSlot);
        const std::string at =
            "G0 X" + std::to_string(20.0 + aside) + " Y" + std::to_string(15.0 + aside) + "\n";
        return replaced(text, "G0 Z5.\nM30", "G0 Z5.\n" + at + "G0 Z-2.\nG0 Z5.\nM30");
    };
    Folder folder;
    const auto check = [&](double distance) {
        folder.write("near.nc", program(distance));
        return verdict_of(folder, {"near.nc", "--tool-tolerance", "0.2"});
    };
    EXPECT_EQ(check(0.010)["verdict"], "clean");
    EXPECT_TRUE(check(0.010)["findings"].empty());
    const json in = check(-0.010);
    EXPECT_EQ(in["verdict"], "failed");
    EXPECT_EQ(in["findings"][0]["rule"], "rapid-in-material");
    EXPECT_TRUE(in["findings"][0]["certain"]);
}

// --- Limits that end the simulation --------------------------------------------------------------

TEST(Limits, OfTimeEndARunAndSayWhere) {
    Folder folder;
    std::string raster = replaced(kSlot, "G0 Z5.\nM30\n", "");
    for (int i = 0; i < 20000; ++i)
        raster += "G1 X" + std::to_string(-25 + i % 50) + " Y" + std::to_string(-10 + i % 19) +
                  " Z-" + std::to_string(1 + i % 7) + "\n";
    folder.write("long.nc", raster + "M30\n");
    const Ran ran = folder.run({"run", "long.nc", "-q", "--max-time", "0.001"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "longer than --max-time 0.001: given up")) << ran.err;
    EXPECT_EQ(folder.run({"check", "long.nc", "-q", "--max-time", "0.001"}).exit_code, 2);
}

TEST(Limits, AProgramThatNeverEndsIsAnErrorAndNotSimulated) {
    Folder folder;
    folder.write("loop.nc", replaced(kSlot, "G1 X30. F500.\n",
                                     "O1 WHILE [1 GT 0]\nG1 X30. F500.\nX-30.\nO1 ENDWHILE\n"));
    const Ran ran = folder.run({"run", "loop.nc", "--png", "p.png"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_FALSE(folder.has("p.png"));
    EXPECT_EQ(verdict_of(folder, {"loop.nc"})["verdict"], "failed");
}

TEST(Limits, AnArcThatIsNotFollowedIsAnErrorInBothCommands) {
    Folder folder;
    folder.write("turns.nc",
                 replaced(kSlot, "G1 X30. F500.\n", "G1 X0. F500.\nG2 X0 Y0 I10 P200000\n"));
    const Ran ran = folder.run({"run", "turns.nc", "--png", "p.png"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out;
    EXPECT_TRUE(contains(ran.err, "turns.nc:9:")) << ran.err;
    const json program = verdict_of(folder, {"turns.nc"});
    EXPECT_EQ(program["verdict"], "failed");
    EXPECT_EQ(program["findings"][0]["rule"], "path-accuracy");
}

TEST(Limits, TooSteepATaperIsRefusedAtOnce) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    for (const char* angle : {"60", "85", "180"}) {
        const Ran ran = folder.run({"run", "slot.nc", "-q", "--max-time", "60", "--tool",
                                    std::string("T1=taper:D10:L20:A").append(angle)});
        EXPECT_NE(ran.exit_code, 3) << angle;
        EXPECT_LT(ran.exit_code, 4) << angle;
        EXPECT_FALSE(contains(ran.err, "max-time")) << angle << ran.err;
    }
}

// --- Two readings ------------------------------------------------------------------------------

const std::string kSkips = replaced(kSlot, "M30\n", "/G0 Z-1\nG0 X0 Y10\nG0 Z20\nM30\n");

TEST(Readings, OfBlocksWithASlashAreSettledByTheSwitch) {
    Folder folder;
    folder.write("slot.nc", kSkips);
    folder.write("fine.nc", replaced(kSlot, "M30\n", "/M9\nM30\n"));
    EXPECT_EQ(verdict_of(folder, {"fine.nc"})["verdict"], "clean");
    const json both = verdict_of(folder, {"slot.nc", "--block-delete", "on"});
    EXPECT_EQ(both["verdict"], "clean") << both.dump(1);
    EXPECT_EQ(verdict_of(folder, {"--block-delete", "slot.nc"})["verdict"], "clean");
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--block-delete", "off"})["verdict"], "failed");
    EXPECT_EQ(verdict_of(folder, {"slot.nc"})["verdict"], "failed");
}

TEST(Readings, ThatFailAreNamed) {
    Folder folder;
    folder.write("slot.nc", replaced(kSlot, "G0 Z5.\nM30", "/G0 Z5.\nG0 X0 Y10\nG0 Z20\nM30"));
    const json program = verdict_of(folder, {"slot.nc"});
    EXPECT_EQ(open_doubts(program), std::set<std::string>{"block-delete"});
    EXPECT_TRUE(contains(program["doubts"][0]["message"], "rapid-in-material in line 10"))
        << program.dump(1);
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--accept", "block-delete"})["verdict"], "accepted");
    // "off" in the project file decides, too.
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--block-delete", "off"})["verdict"], "clean");
    folder.write("ncsim.toml", "version = 1\nblock-delete = false\n");
    EXPECT_EQ(verdict_of(folder, {"slot.nc"})["verdict"], "clean");
}

// "/1" is the retract, "/2" the traverse at the height of the cut: switch 1 alone is a collision.
TEST(Readings, OfSeveralSwitchesOfBlockDelete) {
    Folder folder;
    const auto program = [](const std::string& first, const std::string& second) {
        return replaced(kSlot, "G0 Z5.\nM30",
                        first + "G0 Z5.\n" + second + "G0 X0 Y10\nG0 Z20\nM30");
    };
    // One switch for both: neither reading collides.
    folder.write("one.nc", program("/", "/1"));
    EXPECT_EQ(verdict_of(folder, {"one.nc"})["verdict"], "clean");
    for (const char* const second : {"/2", "/ 2 ", "/2/3"}) {
        folder.write("two.nc", program("/1", second));
        const json two = verdict_of(folder, {"two.nc"});
        EXPECT_EQ(open_doubts(two), std::set<std::string>{"block-delete"}) << second;
        ASSERT_FALSE(two["doubts"].empty());
        EXPECT_TRUE(contains(two["doubts"][0]["message"], "/1")) << two.dump(1);
    }
    EXPECT_EQ(verdict_of(folder, {"two.nc", "--block-delete", "on"})["verdict"], "clean");
}

// A forgotten point changes the part, although neither reading is a fault.
TEST(Readings, OfAForgottenPointDifferByThePart) {
    Folder folder;
    folder.write("short.nc", replaced(kSlot, "G1 X30. F500.", "G1 X30 F500."));
    folder.write("same.nc", replaced(kSlot, "G0 Z5.\nM30", "G0 Z5\nM30"));
    for (const char* const control : {"fanuc", "haas"}) {
        const json program = verdict_of(folder, {"short.nc", "--dialect", control});
        EXPECT_EQ(open_doubts(program), std::set<std::string>{"decimal-point"}) << control;
        EXPECT_EQ(verdict_of(folder, {"same.nc", "--dialect", control})["verdict"], "clean");
        for (const char* const points : {"on", "off"})
            EXPECT_EQ(verdict_of(folder, {"short.nc", "--dialect", control, "--increments",
                                          points})["verdict"],
                      "clean");
    }
    EXPECT_EQ(verdict_of(folder, {"short.nc", "--dialect", "rs274"})["verdict"], "clean");
}

// --- Values of the control ---------------------------------------------------------------------

TEST(Variables, AreSpecifiedByTheJobOrTheCommandLine) {
    Folder folder;
    folder.write("slot.nc", replaced(kSlot, "M30\n", "IF [#500 EQ 1] GOTO 10\nN10 M30\n"));
    const std::vector<std::string> slot{"slot.nc", "--dialect", "fanuc"};
    EXPECT_EQ(open_doubts(verdict_of(folder, slot)), std::set<std::string>{"variable-unknown"});
    std::vector<std::string> more = slot;
    more.insert(more.end(), {"--variable", "#500=0"});
    EXPECT_EQ(verdict_of(folder, more)["verdict"], "clean");
    folder.write("job.toml", "version = 2\n[variables]\n\"#500\" = 0\n");
    more = slot;
    more.insert(more.end(), {"--job", "job.toml"});
    EXPECT_EQ(verdict_of(folder, more)["verdict"], "clean");
    folder.write("job.toml", "version = 2\n[variables]\nx = 0\n");
    const Ran ran = folder.run({"check", "slot.nc", "--job", "job.toml"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.out + ran.err, "job.toml:3:5: ")) << ran.out;
    EXPECT_EQ(folder.run({"check", "slot.nc", "--variable", "500"}).exit_code, 2);
}

TEST(Variables, ThatDecideNothingAreNoDoubt) {
    Folder folder;
    folder.write("slot.nc", replaced(kSlot, "M30\n", "#100=#500+1\nM30\n"));
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--dialect", "fanuc"})["verdict"], "clean");
}

TEST(Variables, ThatAreComputedFromUnknownOnesAreUnknown) {
    Folder folder;
    folder.write("slot.nc", replaced(kSlot, "M30\n", "#100=#500+20\nG0 Z#100\nM30\n"));
    const json program = verdict_of(folder, {"slot.nc", "--dialect", "fanuc"});
    EXPECT_EQ(open_doubts(program), std::set<std::string>{"variable-unknown"});
    EXPECT_TRUE(contains(program["doubts"][0]["message"], "#500")) << program.dump(1);
}

// --- Rotary axes -------------------------------------------------------------------------------

TEST(DerivedStock, OfAProgramThatTurnsAIsABarAboutIt) {
    Folder folder;
    folder.write(
        "wrap.nc",
        "G21 G90 T1 M6 S1000 M3\nG0 X0 Y0 Z30\nG0 A0\nG1 Z20 F500\nX40\nZ18\nX0 A20\nG0 Z30\n"
        "M30\n");
    const Ran ran =
        folder.run({"run", "wrap.nc", "--assume-tool", "flat:D6", "--report", "r.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const json stock = json::parse(folder.read("r.json"))["stock"];
    EXPECT_TRUE(contains(stock["source"]["text"], "derived: a bar about the axis that turns"));
    EXPECT_EQ(stock["min"][2], -20.0) << stock.dump();
    EXPECT_EQ(stock["max"][2], 20.0) << stock.dump();
    EXPECT_EQ(stock["min"][1], -20.0) << stock.dump();
}

}  // namespace
}  // namespace ncsim::cli_test
