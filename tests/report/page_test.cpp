// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the text and the data of the page of a program. tests/cli/page runs its scripts.
#include "ncsim/report/page.h"

#include "page_arrays.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ncsim::report {
namespace {

using nlohmann::json;
using verify::Finding;
using verify::Severity;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string page_of(const Checked& checked, LengthUnit unit = LengthUnit::Millimetre) {
    std::ostringstream out;
    write_page(out, checked, unit);
    return out.str();
}

/// Returns the data that the script of the page reads.
json data_of(const std::string& page) {
    const std::string begin = "<script id=\"data\" type=\"application/json\">";
    const std::size_t at = page.find(begin);
    if (at == std::string::npos) return {};
    const std::size_t from = at + begin.size();
    return json::parse(page.substr(from, page.find("</script>", from) - from));
}

Finding finding(std::string rule, Severity severity, std::uint32_t line, std::string message) {
    Finding f;
    f.rule = std::move(rule);
    f.severity = severity;
    f.place.span.line = f.last.span.line = line;
    f.message = std::move(message);
    return f;
}

/// A program of three lines with an error, a note and a suppressed error in line 2, and a triangle.
Checked cut_program() {
    Checked checked;
    checked.path = "a<b.nc";
    checked.word = "failed";
    verify::Verdict& verdict = checked.verdict;
    verdict.findings.push_back(finding("air-cut", Severity::Note, 2, "a note"));
    verdict.findings.push_back(finding("plunge", Severity::Error, 2, "cut <b> & more"));
    verdict.findings.push_back(finding("feed-limit", Severity::Error, 3, "known"));
    verdict.findings.back().suppressed = true;
    verdict.findings[1].category = verify::Category::Collision;
    verdict.findings[1].last.span.line = 3;
    verdict.findings[1].assumptions = {"stock: derived"};
    checked.lines = {"G1 X1", "G1 Z-4 (</script>)", "M30"};
    verdict.doubts.emplace_back();
    verdict.doubts.back().reason = "stock-guess";
    verdict.doubts.back().message = "stock: 25.4 mm";
    for (const auto& [file, line, volume] :
         std::vector<std::tuple<std::uint32_t, std::uint32_t, double>>{
             {0, 2, 100.0}, {0, 2, 20.5}, {1, 2, 7.0}}) {
        verify::LedgerRow& row = verdict.ledger.rows.emplace_back();
        row.file = file;
        row.line = line;
        row.removed_mm3 = volume;
    }
    simulation::PageData& data = checked.page_data.emplace();
    data.source = "G21\nG1 Z-4 (</script>)\r\nM30";
    data.stock = {{0, 0, -2.5}, {10, 20, 0}};
    data.mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 20, -2.5}};
    data.mesh.triangles = {{0, 1, 2}};
    data.normals = {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}};
    data.lines = {2};
    data.tool_of = {7};
    data.form_of = {0};
    data.pictures = {{"isometric", "PNG"}};
    return checked;
}

TEST(Page, ListsErrorsFirstAndSuppressedFindingsLast) {
    const std::string page = page_of(cut_program());
    EXPECT_TRUE(
        contains(page, "<header class=\"failed\"><h1>a&lt;b.nc: failed (1 error suppressed)</h1>"))
        << page.substr(0, page.find("<script"));
    EXPECT_TRUE(contains(page, "errors 1, warnings 0, notes 1, suppressed 1, doubts 1"));
    EXPECT_TRUE(contains(page, "<h2>Findings (3)</h2>"));
    const std::size_t error = page.find("<div class=\"finding error\"");
    const std::size_t note = page.find("<div class=\"finding note\"");
    const std::size_t suppressed = page.find("<div class=\"finding error suppressed\"");
    EXPECT_LT(error, note);
    EXPECT_LT(note, suppressed);
    EXPECT_LT(suppressed, std::string::npos);
    EXPECT_TRUE(contains(page,
                         "data-finding=\"1\" data-line=\"2\"><b>error</b> cut &lt;b&gt; &amp; "
                         "more <small>a&lt;b.nc:2-3 · plunge</small>"
                         "<code>G1 Z-4 (&lt;/script&gt;)</code>"
                         "<small>assumed stock: derived</small>"))
        << page.substr(0, page.find("<script"));
    EXPECT_TRUE(contains(page, "<b>doubt</b> stock: 25.4 mm"));
    EXPECT_TRUE(
        contains(page, "<figure><img alt=\"isometric\" src=\"data:image/png;base64,UE5H\">"));
    EXPECT_FALSE(contains(page, "src=\"http"));
}

TEST(Page, HasTheDataOfItsScript) {
    const json data = data_of(page_of(cut_program()));
    EXPECT_EQ(data["source"], (json{"G21", "G1 Z-4 (</script>)", "M30"}));
    EXPECT_EQ(data["marks"], (json{{"2", "error"}})) << "a suppressed finding has no mark";
    EXPECT_EQ(data["removed"], (json{{"2", 120.5}})) << "of the program, not of its subprograms";
    EXPECT_EQ(data["stock"], (json{0, 0, -2.5, 10, 20, 0}));
    EXPECT_EQ(data["inches"], false);
    ASSERT_EQ(data["findings"].size(), 3U);
    EXPECT_EQ(data["findings"][0], (json{2, "note", json::array(), false, json::array()}));
    EXPECT_EQ(data["findings"][1], (json{2, "error", json::array(), true, json::array()}));
    EXPECT_TRUE(data["fixtures"].empty());
    EXPECT_FALSE(data.contains("play"));
    EXPECT_FALSE(data.contains("machine"));
}

TEST(Page, HasThePartInTenthsOfMicrometres) {
    const json mesh = data_of(page_of(cut_program()))["mesh"];
    const auto text = [](const std::vector<std::uint32_t>& numbers, std::size_t stride) {
        return packed(numbers, stride);
    };
    const std::uint32_t down = 0U - 25'000U;
    EXPECT_EQ(mesh["vertices"], text({0, 0, 0, 100'000, 0, 0, 0, 200'000, down}, 3));
    EXPECT_EQ(mesh["triangles"], text({0, 1, 2}, 3));
    EXPECT_EQ(mesh["normals"], text({0, 0, 32767, 32767, 0, 0}, 3)) << "each normal once";
    EXPECT_EQ(mesh["normalOf"], text({0, 0, 1}, 1));
    EXPECT_EQ(mesh["lines"], text({2}, 1));
    EXPECT_EQ(mesh["tools"], text({7}, 1));
}

TEST(Page, OfInchesHasTextsInInches) {
    const std::string page = page_of(cut_program(), LengthUnit::Inch);
    EXPECT_TRUE(contains(page, "<b>doubt</b> stock: 1 in")) << page.substr(0, page.find("<script"));
    EXPECT_EQ(data_of(page)["inches"], true);
}

TEST(Page, WithoutAPartSaysSo) {
    Checked checked = cut_program();
    checked.page_data->mesh = {};
    checked.not_simulated = "T1 <is> unknown";
    const std::string page = page_of(checked);
    EXPECT_TRUE(contains(page, "<p>not simulated: T1 &lt;is&gt; unknown</p>"));
    EXPECT_TRUE(contains(page, "<p>The program was not simulated.</p>"));
    EXPECT_FALSE(data_of(page).contains("mesh"));
}

TEST(Page, OfAProgramThatWasNotVerifiedHasNoScript) {
    Checked checked;
    checked.path = "a.nc";
    checked.failure = "no <tool>";
    const std::string page = page_of(checked);
    EXPECT_TRUE(contains(page, "<p>not verified: no &lt;tool&gt;</p>"));
    EXPECT_FALSE(contains(page, "<script"));
    EXPECT_TRUE(page.ends_with("</body></html>\n"));
}

TEST(Page, OfARunHasTheSummary) {
    std::ostringstream out;
    write_run_page(out, "a.nc", "volume < 3", *cut_program().page_data, LengthUnit::Millimetre);
    const std::string page = out.str();
    EXPECT_TRUE(contains(page, "<title>a.nc · ncsim run</title>"));
    EXPECT_TRUE(contains(page, "<pre>volume &lt; 3</pre>"));
    EXPECT_FALSE(contains(page, "<h2>Findings"));
    EXPECT_TRUE(data_of(page).contains("mesh"));
}

}  // namespace
}  // namespace ncsim::report
