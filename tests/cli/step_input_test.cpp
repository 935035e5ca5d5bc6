// SPDX-License-Identifier: GPL-3.0-or-later
//
// STEP as input: designs, stock, fixtures. tests/setup/write_step_cases.cpp writes files as CAD
// systems would.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

// A path far above any stock.
constexpr const char* kAir =
    "(T1 D=10. CR=0. - flat end mill)\n"
    "G21 G90 G17\n"
    "T1 M6\n"
    "S1000 M3\n"
    "G0 X-30. Y0. Z200.\n"
    "G1 X30. F500.\n"
    "M30\n";

// Returns the folder of the cases, which are written once per run of the tests.
std::string cases() {
    static const Folder folder;
    if (folder.files().empty()) {
        const std::string command =
            NCSIM_WRITE_STEP_CASES " '" + folder.path().string() + "' > /dev/null";
        EXPECT_EQ(std::system(command.c_str()), 0);
    }
    return folder.path().string() + "/";
}

std::string read(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// A STEP reader process ends together with the ncsim process that started the reader.
TEST(StepInput, NoReaderOutlivesItsParent) {
    const Folder folder;
    folder.write("air.nc", kAir);
    folder.write("part.step", "ISO-10303-21;\nEND-ISO-10303-21;\n");
    folder.write("ncsim-step",
                 "#!/bin/sh\necho $$ > reader.tmp; mv reader.tmp reader\n"
                 "exec sleep 100000\n");
    // A reader that never ends.
    const Ran ran = folder.shell(
        "cp \"$0\" ncsim; chmod +x ncsim-step\n"
        "./ncsim check air.nc --design part.step & pid=$!\n"
        "while ! test -e reader && kill -0 $pid; do sleep 0.01; done; read -r reader < reader\n"
        "kill -KILL $pid; wait $pid; echo code $?\n"
        "while read -r id name state rest 2>&- < /proc/$reader/stat && test $state != Z; do "
        "sleep 0.01; done");
    EXPECT_EQ(ran.out, "code 137\n") << ran.err;
}

// Returns the volume of the stock in a file, mm³.
double volume_of(const std::string& path) {
    Folder folder;
    folder.write("air.nc", kAir);
    const Ran ran = folder.run({"run", "air.nc", "--stock", path, "--report", "a.json", "-q"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    if (!folder.has("a.json")) return 0.0;
    return json::parse(folder.read("a.json"))["volume_mm3"]["stock"];
}

TEST(StepInput, StockIsWhatTheFileMeans) {
    EXPECT_NEAR(volume_of(cases() + "box.step"), 6000.0, 1e-6);
    EXPECT_NEAR(volume_of(cases() + "shell.step"), 6000.0, 1e-6);
    EXPECT_NEAR(volume_of(cases() + "assembly.step"), 12000.0, 1e-6);
}

// Material closer to a curved surface than the triangles is not checked; verdicts state this limit.
TEST(StepInput, VerdictsTellThatACastingIsItsTriangles) {
    Folder folder;
    folder.write("air.nc", kAir);
    const std::string words = "triangles within 0.01 mm of its surfaces";
    const std::string curved = cases() + "curved.step";
    const Ran text =
        folder.run({"check", "air.nc", "--stock", curved, "--json", "a.json", "--html", "a.html"});
    EXPECT_TRUE(contains(text.out, "stock    curved.step in ")) << text.out;
    EXPECT_TRUE(contains(text.out, words)) << text.out;
    EXPECT_TRUE(contains(folder.read("a.json"), words));
    EXPECT_TRUE(contains(folder.read("a.html"), words));
    folder.run({"run", "air.nc", "--stock", curved, "--report", "a.json", "--stl", "a.stl"});
    EXPECT_EQ(json::parse(folder.read("a.json"))["stock"]["deflection_mm"], 0.01);
    // A mesh is exact as given.
    const Ran mesh = folder.run({"check", "air.nc", "--stock", "a.stl"});
    EXPECT_TRUE(contains(mesh.out, "stock    a.stl in ")) << mesh.out;
    EXPECT_FALSE(contains(mesh.out, words)) << mesh.out;
}

TEST(StepInput, UnitsAreHonoured) {
    ASSERT_TRUE(contains(read(cases() + "inch.step"), "INCH"));
    EXPECT_NEAR(volume_of(cases() + "inch.step"), 6000.0, 1e-3);
    EXPECT_NEAR(volume_of(cases() + "metre.step"), 6000.0, 1e-3);
}

TEST(StepInput, CurvedBodiesAreWithinTheDeflection) {
    using std::numbers::pi;
    const double ball = 4000.0 / 3.0 * pi, ring = 2.0 * pi * pi * 10.0 * 9.0,
                 cone = pi * 12.0 / 3.0 * (64.0 + 24.0 + 9.0), cylinder = pi * 36.0 * 12.0;
    // The volumes of the file are a quarter of the formula; the error is 0.01 mm times about 240
    // mm².
    EXPECT_NEAR(volume_of(cases() + "curved.step"), (ball + ring + cone + cylinder) / 64.0, 2.4);
}

TEST(StepInput, WhatIsNoSolidIsRefusedWithoutAPartialFile) {
    Folder folder;
    folder.write("air.nc", kAir);
    const std::string box = read(cases() + "box.step");
    folder.write("cut.step", box.substr(0, box.size() / 2));
    folder.write("gap.step", box.substr(0, box.size() / 2) + "\nENDSEC;\nEND-ISO-10303-21;\n");
    folder.write("head.step", "ISO-10303-21;\n");
    folder.write("empty.step",
                 "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                 "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\n"
                 "ENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
    std::string noise = "ISO-10303-21;\nHEADER;\n";
    for (int i = 0; i < 5000; ++i)
        noise += static_cast<char>(1 + (i * 7919) % 255);
    folder.write("noise.step", noise + "END-ISO-10303-21;\n");
    const struct {
        std::string file, what;
    } refused[] = {
        {"cut.step", "STEP that does not end"},
        {"gap.step", ""},
        {"head.step", "STEP that does not end"},
        {"empty.step", ""},
        {"noise.step", ""},
        {cases() + "open.step", "not closed"},
        {cases() + "wire.step", "no solid in it"},
    };
    for (const auto& [file, what] : refused) {
        SCOPED_TRACE(file);
        const Ran ran = folder.run({"run", "air.nc", "--stock", file, "--stl", "a.stl"});
        EXPECT_EQ(ran.exit_code, 2) << ran.out << ran.err;
        EXPECT_TRUE(contains(ran.err, what)) << ran.err;
        EXPECT_TRUE(contains(ran.err, "'" + file + "'")) << ran.err;
        EXPECT_FALSE(folder.has("a.stl"));
    }
}

TEST(StepInput, AFileWithoutAUnitIsRefused) {
    Folder folder;
    folder.write("air.nc", kAir);
    std::string box = read(cases() + "box.step");
    // The first unit of the context.
    const std::string units = "GLOBAL_UNIT_ASSIGNED_CONTEXT";
    const std::size_t at = box.find(units);
    ASSERT_NE(at, std::string::npos);
    const std::size_t first = box.find('#', at);
    box.erase(first, box.find(',', first) + 1 - first);
    folder.write("box.step", box);
    const Ran ran = folder.run({"run", "air.nc", "--stock", "box.step"});
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_TRUE(contains(ran.err, "unit")) << ran.err;
}

// Mutations of a valid file are read or refused; no crash, no hang.
TEST(StepInput, DamagedFilesAreReadOrRefused) {
    Folder folder;
    folder.write("air.nc", kAir);
    const std::string good = read(cases() + "assembly.step");
    std::uint64_t state = 12345;
    const auto next = [&] {
        return state = state * 6364136223846793005ULL + 1442695040888963407ULL, state >> 33;
    };
    for (int i = 0; i < 30; ++i) {
        SCOPED_TRACE(i);
        std::string bad = good;
        for (int k = 0; k < 1 + i % 7; ++k) {
            const std::size_t at = 400 + next() % (bad.size() - 500);
            if (next() % 2 == 0) {
                bad[at] = static_cast<char>("0123456789#.,()$*-E'"[next() % 20]);
            } else {
                bad.erase(at, 1 + next() % 40);
            }
        }
        folder.write("bad.step", bad);
        const Ran ran = folder.run(
            {"check", "air.nc", "--stock", "40x40x40", "--design", "bad.step", "--json", "a.json"});
        EXPECT_NE(ran.exit_code, 3) << ran.err;
        EXPECT_LT(ran.exit_code, 128);
        EXPECT_EQ(folder.has("a.json"), ran.exit_code != 2) << ran.err;
        if (folder.has("a.json")) std::filesystem::remove(folder.path() / "a.json");
    }
}

TEST(StepInput, ADesignNamesItsFacesInFindings) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran made = folder.run({"run", "slot.nc", "-q", "--step", "slot.step"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    const Ran same = folder.run({"check", "slot.nc", "--design", "slot.step"});
    EXPECT_TRUE(contains(same.out + same.err, "nothing beyond")) << same.out << same.err;
    std::string deeper = kSlot;
    deeper.replace(deeper.find("G0 Z-2."), 7, "G0 Z-2.5");
    folder.write("deeper.nc", deeper);
    const Ran ran = folder.run({"check", "deeper.nc", "--design", "slot.step"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out + ran.err, "at the face 'LINE_8' of the design")) << ran.out;
    EXPECT_TRUE(contains(ran.out + ran.err, "triangles within 0.01 mm of its surfaces")) << ran.out;
    const Ran finer =
        folder.run({"check", "slot.nc", "--design", "slot.step", "--design-tol", "0.019"});
    EXPECT_EQ(finer.exit_code, 2);
    EXPECT_TRUE(contains(finer.err, "within 0.01 mm of its surfaces; 0.02 or more")) << finer.err;
}

TEST(StepInput, AFixtureMayBeStep) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("machine.toml", "[[fixture]]\nname = \"clamp\"\nstl = \"box.step\"\n");
    folder.write("box.step", read(cases() + "box.step"));
    const Ran ran = folder.run({"check", "slot.nc", "--machine", "machine.toml"});
    // The cutter passes through the clamp.
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_TRUE(contains(ran.out + ran.err, "clamp")) << ran.out << ran.err;
}

// Simulates a build without OpenCASCADE.
TEST(StepInput, WithoutItsReaderSaysWhatIsMissing) {
    Folder folder;
    folder.write("air.nc", kAir);
    std::filesystem::copy_file(NCSIM_PROGRAM, folder.path() / "alone");
    const Ran ran = folder.shell("./alone run air.nc --stock '" + cases() + "box.step'");
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "there is no ncsim-step")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "OpenCASCADE"));
}

}  // namespace
}  // namespace ncsim::cli_test
