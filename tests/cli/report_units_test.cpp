// SPDX-License-Identifier: GPL-3.0-or-later
//
// --report-units inch: no text has a length in mm, and all other outputs stay the same.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

std::string sample(const std::string& name) {
    return std::string(NCSIM_SOURCE_DIR).append("/samples/").append(name);
}

// Returns the first length in mm in `text`.
std::string length_in_mm(const std::string& text) {
    static const std::regex kLength("[0-9] ?(mm|mm[23]|cm3|m/min)\\b");
    std::smatch found;
    if (!std::regex_search(text, found, kLength)) return {};
    const auto at = static_cast<std::size_t>(found.position());
    const std::size_t begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find('\n', at) - begin);
}

void expect_inches(const Folder& folder, std::vector<std::string> words) {
    const Ran before = folder.run(words);
    words.insert(words.end(), {"--report-units", "inch"});
    const Ran ran = folder.run(words);
    EXPECT_EQ(ran.exit_code, before.exit_code) << ran.err;
    // Without lengths in the texts in mm, the test would prove nothing.
    EXPECT_NE(length_in_mm(before.out + before.err), "") << words.front() << ' ' << words[1];
    EXPECT_EQ(length_in_mm(ran.out + ran.err), "") << words.front() << ' ' << words[1];
}

TEST(ReportUnits, AreInNoTextMixed) {
    const Folder folder;
    for (const char* name : {"simple.nc", "complex.nc", "five-axis.nc"}) {
        expect_inches(folder, {"run", sample(name)});
        expect_inches(folder, {"tools", sample(name)});
    }
    expect_inches(folder, {"measure", sample("simple.nc")});
    expect_inches(folder, {"measure", sample("two-sides/job.toml")});
    expect_inches(folder, {"diff", sample("simple.nc"), sample("complex.nc"), "--process"});
    expect_inches(folder, {"run", sample("two-sides/job.toml")});
    expect_inches(folder, {"run", sample("simple.nc"), "--section", "z=-2", "--dxf", "a.dxf",
                           "--step", "a.step", "--simplify", "0.01"});
    expect_inches(folder, {"run", sample("simple.nc"), "--model", "dexel", "--resolution", "1"});
}

// Findings with a place, a quantity and a limit.
TEST(ReportUnits, AreInFindings) {
    Folder folder;
    folder.write("a.nc",
                 "(T1 D=25.4 CR=0. - flat end mill)\n(STOCK/BLOCK,76.2,50.8,25.4,38.1,25.4,25.4)\n"
                 "G21 G90 G17 (FROM/0.,0.,101.6)\nT1 M6\nS1000 M3\nG0 X-63.5 Y0. Z25.4\n"
                 "G0 Z-12.7\nG0 X63.5\nG0 Z25.4\nG0 Z-30\nM30\n");
    expect_inches(folder, {"check", "a.nc"});
    const Ran ran = folder.run({"check", "a.nc", "--report-units", "inch"});
    // A slot of 3 x 1 x 0.5 inches.
    EXPECT_TRUE(contains(ran.out, "rapid move through material: removed 1.5 in3")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "within 3 x 1 x 0.5 in")) << ran.out;
    const Ran annotated = folder.run({"check", "a.nc", "--report-units", "inch", "--github"});
    EXPECT_TRUE(contains(annotated.out, "::error")) << annotated.out;
    EXPECT_EQ(length_in_mm(annotated.out), "");
    // JSON has the unit in its keys, and stays in mm.
    folder.run({"check", "a.nc", "-q", "--json", "mm.json"});
    folder.run({"check", "a.nc", "-q", "--json", "inch.json", "--report-units", "inch"});
    const json program = json::parse(folder.read("mm.json"))["programs"][0];
    EXPECT_EQ(program["stock_mm"],
              json::parse(R"({"min": [-38.1, -25.4, -25.4], "max": [38.1, 25.4, 0]})"));
    EXPECT_GT(program["seconds"], 0.5) << program["time"];
    EXPECT_EQ(folder.read("mm.json"), folder.read("inch.json"));
}

TEST(ReportUnits, OfTheLedgerAreInItsHeading) {
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.run({"check", "a.nc", "-q", "--csv", "mm.csv"});
    folder.run({"check", "a.nc", "-q", "--csv", "in.csv", "--report-units", "inch"});
    const auto sum = [&](const char* file, const std::string& column) {
        std::istringstream lines(folder.read(file));
        std::string line, cell;
        std::getline(lines, line);
        std::istringstream names(line);
        int at = 0;
        for (; std::getline(names, cell, ',') && cell != column; ++at) {
        }
        double total = 0.0;
        while (std::getline(lines, line)) {
            std::istringstream cells(line);
            for (int i = 0; i <= at; ++i)
                std::getline(cells, cell, ',');
            total += std::stod(cell);
        }
        return total;
    };
    EXPECT_NEAR(sum("mm.csv", "removed_mm3"), 800.0, 1e-6);
    EXPECT_NEAR(sum("in.csv", "removed_in3"), 800.0 / (25.4 * 25.4 * 25.4), 1e-9);
    EXPECT_NEAR(sum("in.csv", "length_in") * 25.4, sum("mm.csv", "length_mm"), 1e-6);
}

// All texts of a page, and the unit of its viewer when it opens. The source of the program stays.
TEST(ReportUnits, OfPagesAreThoseOfTheirTexts) {
    Folder folder;
    folder.write("a.nc",
                 "G21 G90 G17 (FROM/0.,0.,101.6)\nT1 M6\nS1000 M3\nG0 X-63.5 Y0. Z25.4\n"
                 "G0 Z-12.7\nG0 X63.5\nG1 X0 F300\nG0 Z25.4\nM30\n");
    for (const char* const command : {"run", "check"}) {
        folder.run({command, "a.nc", "--tool", "T1=flat:D25.4", "--stock", "76.2x50.8x25.4",
                    "--html", "a.html", "--report-units", "inch"});
        std::string page = folder.read("a.html");
        page.erase(0, page.find("</style>"));
        const std::size_t data = page.find("<script id=\"data\"");
        ASSERT_NE(data, std::string::npos);
        EXPECT_TRUE(contains(page, "\"inches\":true"));
        page.erase(data);
        EXPECT_EQ(length_in_mm(page), "") << command;
        EXPECT_TRUE(contains(page, " in³") || contains(page, " in3")) << page;
        EXPECT_FALSE(contains(page, "mm³")) << page;
    }
}

TEST(ReportUnits, ArePutInTheSheetThePictureAndTheProject) {
    Folder folder;
    const std::string job = sample("two-sides/job.toml");
    folder.run({"sheet", job, "--html", "in.html", "--report-units", "inch"});
    std::string sheet = folder.read("in.html");
    sheet.erase(0, sheet.find("</style>"));
    EXPECT_EQ(length_in_mm(sheet), "");
    EXPECT_TRUE(contains(sheet, "lengths in inches")) << sheet;
    EXPECT_TRUE(contains(sheet, "turned X180")) << sheet;
    folder.write("a.nc", kSlot);
    folder.run({"run", "a.nc", "-q", "--png", "mm.png", "--size", "320x240"});
    folder.run(
        {"run", "a.nc", "-q", "--png", "in.png", "--size", "320x240", "--report-units", "inch"});
    EXPECT_FALSE(folder.read("mm.png") == folder.read("in.png"));
    folder.write("ncsim.toml", "version = 1\nreport-units = \"inch\"\n");
    EXPECT_EQ(length_in_mm(folder.run({"run", "a.nc"}).out), "");
    folder.write("ncsim.toml", "version = 1\nreport-units = \"foot\"\n");
    const Ran ran = folder.run({"run", "a.nc"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "--report-units 'foot': expected mm or inch")) << ran.err;
}

}  // namespace
}  // namespace ncsim::cli_test
