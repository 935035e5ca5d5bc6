// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tool libraries of FreeCAD and HSMWorks.
#include "ncsim/setup/tool_library.h"

#include "support/messages.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zip.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace ncsim::setup {
namespace {

namespace fs = std::filesystem;

class ToolLibrary : public testing::Test {
protected:
    ToolLibrary()
        : folder_(fs::temp_directory_path() / ("ncsim_library_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~ToolLibrary() override { fs::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) const {
        const fs::path path = folder_ / name;
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }

    static std::string tools_in(const std::string& path) {
        InputSet inputs;
        const toolpath::ToolFile file = read_tool_library(path, inputs);
        std::string out = file.format + "\n";
        for (const toolpath::ToolEntry& entry : file.tools) {
            out +=
                "T" + std::to_string(entry.spec.number) + " " + describe(make_tool(entry.spec, 50));
            if (entry.spec.angle) out += " A" + std::to_string(std::lround(*entry.spec.angle));
            if (entry.spec.pitch) out += " K" + std::to_string(*entry.spec.pitch).substr(0, 4);
            out += "; " + entry.spec.description + "\n";
        }
        for (const gcode::Diagnostic& d : file.diagnostics)
            out += test::said(d) + "\n";
        return out;
    }

    static std::string refusal(const std::string& path) {
        try {
            (void)tools_in(path);
        } catch (const std::runtime_error& e) {
            const std::string text = e.what();
            return text.substr(text.find(fs::path(path).filename().string()));
        }
        return "accepted";
    }

    fs::path folder_;
};

std::string bit(const std::string& name, const std::string& shape, const std::string& parameters) {
    return R"({"version": 2, "name": ")" + name + R"(", "shape": ")" + shape +
           R"(", "parameter": {)" + parameters + R"(}, "attribute": {}})";
}

TEST_F(ToolLibrary, OfFreeCadHasItsBitsInAFolderNextToIt) {
    write(
        "Bit/mill.fctb",
        bit("5 mm", "endmill.fcstd",
            R"("CuttingEdgeHeight": "30.0000 mm", "Diameter": "5.0000 mm", "ShankDiameter": "3 mm")"));
    write("Bit/ball.fctb",
          bit("1/4", "ballend.fcstd", R"("CuttingEdgeHeight": "1 in", "Diameter": "0.25 in")"));
    write("Bit/old.fctb",
          bit("bull", "bullnose.fcstd",
              R"("CuttingEdgeHeight": "40 mm", "Diameter": "6 mm", "FlatRadius": "1 mm")"));
    write("Bit/new.fctb",
          bit("bull", "bullnose.fcstd",
              R"("CuttingEdgeHeight": 40, "Diameter": 6, "CornerRadius": "1.5 mm")"));
    write(
        "Library/v.fctb",
        bit("vee", "v-bit.fcstd",
            R"("CuttingEdgeAngle": "60.0000 °", "Diameter": "10 mm", "CuttingEdgeHeight": "1 mm", "TipDiameter": "0.1 mm")"));
    write("Library/Bit/drill.fctb",
          bit("drill", "/home/me/Shape/drill.fcstd", R"("Diameter": "5 mm", "TipAngle": "119 °")"));
    write("Bit/tap.fctb",
          bit("M8", "tap.fcstd",
              R"("CuttingEdgeLength": "24 mm", "Diameter": "8 mm", "Pitch": "1.25 mm")"));
    write("Bit/saw.fctb",
          bit("saw", "slittingsaw.fcstd",
              R"("BladeThickness": "3 mm", "Diameter": "76.2 mm", "ShankDiameter": "19.05 mm")"));
    write("Bit/probe.fctb", bit("probe", "probe.fcstd", R"("Diameter": "6 mm")"));
    write("Bit/own.fctb", bit("own", "mine.fcstd", R"("Diameter": "6 mm")"));
    const std::string path = write(
        "Library/mine.fctl",
        R"({"version": 1, "tools": [{"nr": 1, "path": "mill.fctb"}, {"nr": 2, "path": "ball.fctb"},
            {"nr": 3, "path": "old.fctb"}, {"nr": 4, "path": "new.fctb"}, {"nr": 5, "path": "v.fctb"},
            {"nr": 6, "path": "drill.fctb"}, {"nr": 7, "path": "tap.fctb"}, {"nr": 8, "path": "saw.fctb"},
            {"nr": 9, "path": "probe.fctb"}, {"nr": 10, "path": "own.fctb"}, {"nr": 11, "path": "gone.fctb"}]})");
    EXPECT_EQ(tools_in(path),
              "FreeCAD tool library\n"
              "T1 flat end mill D5 L30, D3 to 39; 5 mm\n"
              "T2 ball end mill D6.35 L25.4; 1/4\n"
              "T3 bull nose end mill D6 R2 L40; bull\n"
              "T4 bull nose end mill D6 R1.5 L40; bull\n"
              "T5 v-cutter D10 L50 A60; vee\n"
              "T6 drill D5 L50 A119; drill\n"
              "T7 tap D8 L24 K1.25; M8\n"
              "T8 slot mill D76.2 L3, D19.05 to 60.15; saw\n"
              "tool-unknown: tool 10: the shape 'mine.fcstd' is not read; it is left out\n"
              "tool-unknown: tool 11: there is no tool bit 'gone.fctb'; it is left out\n");
}

TEST_F(ToolLibrary, OfHsmWorksMayBeUtf16AndInInches) {
    const std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-16\"?>\n"
        "<tool-library xmlns=\"http://www.hsmworks.com/xml/2004/cnc/tool-library\" "
        "version=\"14\">\n"
        "<tool type=\"flat end mill\" unit=\"inches\"><description>3/16 mill</description>"
        "<nc number=\"5\"/><body diameter=\"0.1875\" flute-length=\"0.94\" corner-radius=\"0\" "
        "shaft-diameter=\"0.1875\" shoulder-length=\"0.94\" body-length=\"1.5\"/></tool>\n"
        "<tool type=\"drill\" unit=\"millimeters\"><nc number=\"6\"/>"
        "<body diameter=\"8\" flute-length=\"40\" tip-angle=\"140\"/></tool>\n"
        "<tool type=\"turning\" unit=\"millimeters\"><nc number=\"7\"/><body "
        "diameter=\"8\"/></tool>\n"
        "</tool-library>\n";
    std::string wide = "\xff\xfe";
    for (const char c : text)
        wide += {c, '\0'};
    const std::string expected =
        "HSMWorks tool library\n"
        "T5 flat end mill D4.7625 L23.876, D4.7625 to 38.1; 3/16 mill\n"
        "T6 drill D8 L40 A140; \n"
        "tool-unknown: ";
    EXPECT_EQ(tools_in(write("a.hsmlib", text)).substr(0, expected.size()), expected);
    EXPECT_EQ(tools_in(write("b.hsmlib", wide)).substr(0, expected.size()), expected);
}

// A section of a holder ends at its diameter; one without length is a step. Angles of drills are
// included angles, of chamfer mills those of one side.
TEST_F(ToolLibrary, OfHsmWorksHasHolders) {
    const std::string path = write(
        "a.hsmlib",
        "<tool-table xmlns=\"http://www.hsmworks.com/xml/2004/cnc/tool-library\">"
        "<tool type=\"flat end mill\" unit=\"inches\"><nc number=\"1\"/>"
        "<body diameter=\"0.5\" flute-length=\"1\" body-length=\"2\" shaft-diameter=\"0.5\"/>"
        "<holder><section diameter=\"1\" length=\"0\"/><section diameter=\"1.5\" length=\"0.1\"/>"
        "<section diameter=\"1.5\" length=\"0.5\"/><section diameter=\"1.2\" length=\"0\"/>"
        "<section diameter=\"1.2\" length=\"1\"/></holder></tool>"
        "<tool type=\"spot drill\" unit=\"millimeters\"><nc number=\"2\"/>"
        "<body diameter=\"6\" taper-angle=\"90\"/></tool>"
        "<tool type=\"drill\" unit=\"millimeters\"><nc number=\"3\"/>"
        "<body diameter=\"6\" taper-angle=\"135\"/></tool>"
        "<tool type=\"chamfer mill\" unit=\"millimeters\"><nc number=\"4\"/>"
        "<body diameter=\"6\" taper-angle=\"45\"/></tool></tool-table>");
    InputSet inputs;
    const toolpath::ToolFile file = read_tool_library(path, inputs);
    ASSERT_EQ(file.tools.size(), 4U);
    const auto& holder = file.tools[0].spec.holder;
    ASSERT_EQ(holder.size(), 3U);
    const double expected[3][3] = {{25.4, 38.1, 2.54}, {38.1, 38.1, 12.7}, {30.48, 30.48, 25.4}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(holder[i].lower_diameter, expected[i][0], 1e-9);
        EXPECT_NEAR(holder[i].upper_diameter, expected[i][1], 1e-9);
        EXPECT_NEAR(holder[i].height, expected[i][2], 1e-9);
    }
    EXPECT_EQ(file.tools[1].spec.angle, 90.0);
    EXPECT_EQ(file.tools[2].spec.angle, 135.0);
    EXPECT_EQ(file.tools[3].spec.angle, 90.0);
    EXPECT_TRUE(file.tools[1].spec.holder.empty());
}

// An archive with "notes.txt" and "tools.json".
std::string archive(const std::string& json, zip_uint64_t least_files = 2) {
    zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    zip_source_keep(target);
    zip_t* const made = zip_open_from_source(target, ZIP_TRUNCATE, nullptr);
    const std::string notes = "none";
    const auto add = [&](const char* name, const std::string& text) {
        zip_file_add(made, name, zip_source_buffer(made, text.data(), text.size(), 0), 0);
    };
    add("notes.txt", notes);
    if (least_files > 1) add("tools.json", json);
    EXPECT_EQ(zip_close(made), 0);
    zip_source_open(target);
    std::string bytes(1 << 20, '\0');
    bytes.resize(static_cast<std::size_t>(zip_source_read(target, bytes.data(), bytes.size())));
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

TEST_F(ToolLibrary, OfFusionMayBeAnArchive) {
    const std::string json =
        R"({"data": [{"type": "drill", "unit": "millimeters", "description": "8 mm",
            "post-process": {"number": 4}, "geometry": {"DC": 8, "SIG": 140, "LCF": 40}}]})";
    const std::string bytes = archive(json);
    EXPECT_EQ(tools_in(write("a.tools", bytes)),
              "Fusion tool library\nT4 drill D8 L40 A140; 8 mm\n");
    EXPECT_EQ(refusal(write("b.tools", archive(json, 1))), "b.tools: the archive has no JSON file");
    EXPECT_EQ(refusal(write("c.tools", bytes.substr(0, bytes.size() / 2))),
              "c.tools: this is no ZIP archive that can be read");
    // Each broken byte gives tools, a message or a refusal.
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string broken = bytes;
        broken[i] = static_cast<char>(broken[i] ^ 0x55);
        (void)refusal(write("d.tools", broken));
    }
    // 100 MB of blanks in 100 kB.
    EXPECT_EQ(refusal(write("e.tools", archive(std::string(100'000'000, ' ')))),
              "e.tools: its JSON file is larger than 64 MB");
}

TEST_F(ToolLibrary, RefusesWhatIsNone) {
    EXPECT_EQ(refusal(write("a.fctb", bit("a", "endmill.fcstd", ""))),
              "a.fctb: a tool bit of FreeCAD has no number; expected its library, .fctl");
    EXPECT_EQ(refusal(write("a.fctl", "{")), "a.fctl: this is no JSON that can be read");
    EXPECT_EQ(refusal(write("b.fctl", R"({"tools": 5})")),
              "b.fctl: expected a list 'tools' with 'nr' and 'path'");
    EXPECT_EQ(refusal(write("a.hsmlib", "<tools/>")),
              "a.hsmlib:1: expected <tool-library>, a library of HSMWorks");
    EXPECT_EQ(refusal(write("b.hsmlib", "<tool-library><tool>")).substr(0, 10), "b.hsmlib:1");
    EXPECT_EQ(refusal(write("c.hsmlib", std::string("\xff\xfe\x00\xd8\x00", 5))),
              "c.hsmlib: this is no UTF-16");
    // Hostile values are no tools.
    write("wrong.fctb",
          bit("x", "endmill.fcstd", R"("Diameter": "-5 mm", "CuttingEdgeHeight": 1e308)"));
    EXPECT_EQ(
        tools_in(write("c.fctl", R"({"tools": [{"nr": 1, "path": "wrong.fctb"}]})")).substr(0, 33),
        "FreeCAD tool library\ntool-unknown");
    write("broken.fctb", "{");
    EXPECT_THROW(tools_in(write("e.fctl", R"({"tools": [{"nr": 1, "path": "broken.fctb"}]})")),
                 std::runtime_error);
    write("good.fctb", bit("x", "endmill.fcstd", R"("Diameter": "5 mm")"));
    EXPECT_EQ(tools_in(write("f.fctl",
                             R"({"tools": [{"nr": 4294967297, "path": "good.fctb"},
                                           {"nr": -1, "path": "good.fctb"}]})")),
              "FreeCAD tool library\n");
    EXPECT_EQ(tools_in(write("d.fctl", R"({"tools": []})")), "FreeCAD tool library\n");
}

}  // namespace
}  // namespace ncsim::setup
