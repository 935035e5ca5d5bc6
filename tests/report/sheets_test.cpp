// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sheets, listings and drawings: rows of modes, rules with examples, measures, tools, set-ups,
// curves of the ledger, tables of two programs, explanations of blocks.
#include "ncsim/report/assumption_sheet.h"
#include "ncsim/report/cutting_facts.h"
#include "ncsim/report/explain.h"
#include "ncsim/report/explanation.h"
#include "ncsim/report/listing.h"
#include "ncsim/report/measure_sheet.h"
#include "ncsim/report/modal_state.h"
#include "ncsim/report/rule_list.h"
#include "ncsim/report/run_report.h"
#include "ncsim/report/set_up_sheet.h"
#include "ncsim/report/tool_sheet.h"
#include "ncsim/setup/job.h"
#include "ncsim/verify/doubt.h"
#include "ncsim/verify/rule.h"

#include "json.h"
#include "page_ledger.h"
#include "plot.h"
#include "review_table.h"
#include "rule_examples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::report {
namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos;
         at = text.find(part, at + part.size()))
        ++n;
    return n;
}

// --- Modes ---

// Each change of a state. A row whose text changes has other numbers.
const std::vector<std::function<void(gcode::MachineState&)>>& changes() {
    using S = gcode::MachineState;
    static const auto kAll = [] {
        std::vector<std::function<void(S&)>> all{
            [](S& s) { s.incremental = true; },
            [](S& s) { s.absolute_centres = true; },
            [](S& s) { s.retract_to_r = true; },
            [](S& s) { s.constant_surface_speed = true; },
            [](S& s) { s.spindle_in_doubt = true; },
            [](S& s) { s.spindle_oriented = true; },
            [](S& s) { s.spindle = gcode::SpindleTurning::Counterclockwise; },
            [](S& s) { s.spindle_rpm = 250.0; },
            [](S& s) { s.feed = 12.5; },
            [](S& s) { s.feed_mode = gcode::FeedMode::PerRevolution; },
            [](S& s) { s.feed_mode = gcode::FeedMode::InverseTime; },
            [](S& s) { s.coolant.mist = true; },
            [](S& s) { s.coolant.flood = true; },
            [](S& s) { s.tool = 5; },
            [](S& s) { s.selected_tool = 6; },
            [](S& s) { s.length_register = 4; },
            [](S& s) { s.length_register = gcode::kNegatedLength; },
            [](S& s) { s.length_specified = true; },
            [](S& s) { s.cutter_side = gcode::CutterSide::Left; },
            [](S& s) { s.cutter_side = gcode::CutterSide::Right; },
            [](S& s) { s.cutter_radius = 3.0; },
            [](S& s) { s.system = 7; },
            [](S& s) { s.system = 12; },
            [](S& s) { s.frames.rotation = 30.0; },
            [](S& s) { s.coordinates = gcode::Coordinates::Tip; },
            [](S& s) { s.frames.programmed.rotated = true; },
            [](S& s) { s.frames.programmed.angle = 12.0; },
            [](S& s) { s.frames.programmed.scaled = true; },
            [](S& s) { s.frames.programmed.scale[1] = -1.0; },
            [](S& s) { s.frames.programmed.polar = true; },
            [](S& s) { s.polar_interpolation.emplace(); },
            [](S& s) { s.cylinder.emplace().radius = 20.0; },
            [](S& s) { s.cylinder.emplace().radius = 0.0; },
            [](S& s) { s.frames.tilt.emplace(); },
            [](S& s) { s.frames.tilt.emplace().origin[2] = 4.0; },
            [](S& s) {
                s.frames.tilt.emplace().rows = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
            },
            [](S& s) { s.cycle.running = true; },
            [](S& s) { s.cycle.code = gcode::Code{810}; },
            [](S& s) { s.cycle.r = 2.0; },
            [](S& s) { s.cycle.z = -9.0; },
            [](S& s) { s.cycle.q = 1.5; },
            [](S& s) { s.defined_cycle.number = 200; },
            [](S& s) { s.defined_cycle.number = -83; },
            [](S& s) { s.defined_cycle.number = gcode::kModalProgram; },
        };
        for (std::size_t axis = 0; axis < 9; ++axis) {
            all.emplace_back([axis](S& s) { s.frames.work_offset[axis] = 11.0; });
            all.emplace_back([axis](S& s) { s.frames.offset_92[axis] = 12.0; });
            all.emplace_back([axis](S& s) { s.frames.tool_offset[axis] = 13.0; });
            if (axis < 3) all.emplace_back([axis](S& s) { s.frame[axis] = 1; });
        }
        for (int plane = 0; plane < 6; ++plane)
            all.emplace_back([plane](S& s) { s.plane = static_cast<gcode::Plane>(plane); });
        for (const int code : {0, 10, 20, 30, 382, 800, 810})
            all.emplace_back([code](S& s) { s.motion = gcode::Code{static_cast<short>(code)}; });
        return all;
    }();
    return kAll;
}

TEST(ModalState, ARowWithAnotherTextHasOtherNumbers) {
    std::vector<gcode::MachineState> bases(1);
    bases.emplace_back().length_register = gcode::kStatedLength;
    bases.emplace_back().cycle.running = true;
    bases.emplace_back().cutter_side = gcode::CutterSide::Left;
    bases.emplace_back().frames.programmed.rotated = bases.back().frames.programmed.scaled = true;
    bases.emplace_back().length_register = 3;
    bases.back().length_specified = true;
    for (std::size_t base = 0; base < bases.size(); ++base) {
        for (std::size_t i = 0; i < changes().size(); ++i) {
            gcode::MachineState state = bases[base];
            changes()[i](state);
            const ModeNumbers before = numbers_of(bases[base]), after = numbers_of(state);
            for (std::size_t g = 0; g < kModeGroups; ++g) {
                const auto group = static_cast<ModeGroup>(g);
                for (const bool codes : {false, true}) {
                    const std::string text = text_of(group, state, codes);
                    EXPECT_FALSE(text.empty());
                    if (text == text_of(group, bases[base], codes)) continue;
                    EXPECT_NE(before[g], after[g])
                        << name_of(group) << ": " << text << ", base " << base << ", change " << i;
                }
            }
        }
    }
}

TEST(ModalState, AChangeOfUnitsChangesTheUnitsAlone) {
    gcode::MachineState mm;
    mm.frames.work_offset = {254, 0, -127, 90, 0, 0, 25.4, 0, 0};
    mm.frames.offset_92 = {25.4, 50.8, 0, 45, 0, 0, 0, 25.4, 0};
    mm.frames.tool_offset = {0, 0, 101.6, 0, 0, 0, 0, 0, 0};
    mm.length_register = 2, mm.length_specified = true;
    mm.cutter_side = gcode::CutterSide::Right, mm.cutter_radius = 12.7;
    mm.cycle.running = true, mm.cycle.r = 2.54, mm.cycle.z = -25.4, mm.cycle.q = 5.08;
    mm.cylinder.emplace().radius = 254.0;
    gcode::MachineState inch = mm;
    inch.inches = true;
    inch.frames.scale_lengths(1 / 25.4);
    for (double* length :
         {&inch.cutter_radius, &inch.cycle.r, &inch.cycle.z, &inch.cycle.q, &inch.cylinder->radius})
        *length /= 25.4;
    const ModeNumbers before = numbers_of(mm), after = numbers_of(inch);
    for (std::size_t g = 0; g < kModeGroups; ++g) {
        const auto group = static_cast<ModeGroup>(g);
        EXPECT_EQ(before[g] == after[g], group != ModeGroup::Units) << name_of(group);
    }
    EXPECT_EQ(text_of(ModeGroup::Length, inch, true), "H2, 4 inch");
    EXPECT_EQ(text_of(ModeGroup::Length, mm, true), "H2, 101.6 mm");
}

// --- Rules ---

TEST(RuleList, TextAndJsonHaveAllRulesAndReasons) {
    const std::string text = rules_text();
    const Json json = Json::parse(rules_json());
    ASSERT_EQ(json["rules"].size(), verify::rules().size());
    ASSERT_EQ(json["reasons"].size(), verify::reasons().size());
    std::size_t at = 0;
    for (std::size_t i = 0; i < verify::rules().size(); ++i) {
        const verify::RuleInfo& rule = verify::rules()[i];
        for (const std::string_view part : {rule.id, rule.what, rule.why, rule.fix}) {
            at = text.find(part, at);
            ASSERT_NE(at, std::string::npos) << rule.id;
        }
        EXPECT_EQ(json["rules"][i], (Json{{"id", rule.id},
                                          {"category", verify::name_of(rule.category)},
                                          {"severity", verify::name_of(rule.severity)},
                                          {"what", rule.what},
                                          {"why", rule.why},
                                          {"fix", rule.fix}}));
    }
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        at = text.find(reason.why, at);
        ASSERT_NE(at, std::string::npos) << reason.id;
    }
}

TEST(RuleList, TextOfOneNameAndOfACategory) {
    for (const char* none : {"", "no-such-rule", "Plunge", "all"})
        EXPECT_EQ(rule_text(none), "") << none;
    for (const verify::RuleInfo& rule : verify::rules()) {
        const std::string id(rule.id), text = rule_text(id);
        for (const std::string& part :
             {std::string(rule.why), std::string(rule.fix), "--ignore " + id,
              "(ncsim: ignore " + id + ")", "--severity " + id + "=note"})
            EXPECT_TRUE(contains(text, part)) << id;
        EXPECT_EQ(contains(text, ": a reason for doubt"), verify::find_reason(id) != nullptr);
        // A category is the list of its rules, without the examples.
        const std::string category = rule_text(std::string(verify::name_of(rule.category)));
        EXPECT_TRUE(contains(category, id + ": "));
        EXPECT_FALSE(contains(category, "A program that fails"));
    }
    for (const verify::ReasonInfo& reason : verify::reasons())
        EXPECT_TRUE(
            contains(rule_text(std::string(reason.id)), "--accept " + std::string(reason.id)));
}

TEST(RuleExamples, AreTheFilesOfTheirFolder) {
    const std::filesystem::path root = std::filesystem::path(NCSIM_SOURCE_DIR) / "examples/rules";
    for (const verify::RuleInfo& rule : verify::rules()) {
        const std::filesystem::path folder = root / rule.id;
        std::map<std::string, std::string> expected;
        if (std::filesystem::exists(folder)) {
            for (const auto& entry : std::filesystem::directory_iterator(folder)) {
                std::ostringstream text;
                text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
                const std::string kind = entry.path().extension().string();
                const bool is_text = kind == ".nc" || kind == ".toml";
                expected[entry.path().filename().string()] = is_text ? text.str() : "";
            }
        }
        std::vector<std::pair<std::string, std::string>> found;
        for (const ExampleFile& file : rule_example(rule.id))
            found.emplace_back(file.name, file.text);
        EXPECT_EQ(found, (decltype(found)(expected.begin(), expected.end()))) << rule.id;
    }
    EXPECT_TRUE(rule_example("").empty());
    EXPECT_TRUE(rule_example("rapid").empty()) << "a part of a name";
}

// --- Curves of the ledger ---

verify::Ledger ledger_of(const std::vector<verify::LedgerRow>& rows) {
    verify::Ledger ledger;
    ledger.rows = rows;
    for (const verify::LedgerRow& row : rows)
        ledger.removed_mm3 += row.removed_mm3;
    ledger.measured = true;
    return ledger;
}

verify::LedgerRow row(double removed, double length, std::optional<double> seconds) {
    verify::LedgerRow made;
    made.removed_mm3 = removed;
    made.length_mm = length;
    made.seconds = seconds;
    return made;
}

/// Returns the heights of the curve of an SVG, from 0 to 1, from left to right.
std::vector<double> curve_of(const std::string& svg) {
    const std::size_t last = svg.rfind("<path d=\"");
    std::istringstream path(svg.substr(last + 9, svg.find('"', last + 9) - last - 9));
    std::vector<double> heights;
    double x = 0.0, y = 0.0;
    char command = 0;
    while (path >> command && (command == 'M' || command == 'L') && path >> x >> y)
        heights.push_back((154.0 - y) / 130.0);
    return heights;
}

TEST(Plot, IsEmptyIfNothingWasRemoved) {
    for (const auto& ledger :
         {ledger_of({}), ledger_of({row(0, 10, 1)}), ledger_of({row(0, 10, {})})}) {
        EXPECT_EQ(removed_plot(ledger, LengthUnit::Millimetre), "");
        EXPECT_EQ(rate_plot(ledger, LengthUnit::Millimetre), "");
    }
}

TEST(Plot, RemovedVolumeRisesToTheTop) {
    // 2 s of air, then all of the material at a constant rate in 6 s.
    const std::string svg =
        removed_plot(ledger_of({row(0, 50, 2), row(300, 10, 6)}), LengthUnit::Millimetre);
    const std::vector<double> heights = curve_of(svg);
    ASSERT_EQ(heights.size(), 401U);
    EXPECT_TRUE(std::ranges::is_sorted(heights));
    EXPECT_NEAR(heights[100], 0.0, 0.005);
    EXPECT_NEAR(heights[250], 0.5, 0.005);
    EXPECT_NEAR(heights[400], 1.0, 0.001);
    EXPECT_TRUE(contains(svg, "removed, mm³ over time, s"));
}

TEST(Plot, ScalesDivisionsAndOrder) {
    const std::vector<verify::LedgerRow> rows{row(0, 50, 2), row(300, 10, 6), row(50, 10, 1),
                                              row(0, 5, 0.5)};
    const auto rates = [](const std::vector<verify::LedgerRow>& of) {
        auto heights = curve_of(rate_plot(ledger_of(of), LengthUnit::Millimetre));
        heights.erase(heights.begin());  // the foot on the left
        heights.pop_back();              // and on the right
        return heights;
    };
    const auto whole = rates(rows);
    ASSERT_EQ(whole.size(), 400U);
    EXPECT_NEAR(*std::ranges::max_element(whole), 1.0, 0.001);
    std::vector<verify::LedgerRow> larger = rows, divided, reversed(rows.rbegin(), rows.rend());
    for (verify::LedgerRow& r : larger)
        r.removed_mm3 *= 1000.0;
    EXPECT_EQ(rates(larger), whole);
    for (const verify::LedgerRow& r : rows) {
        for (int i = 0; i < 4; ++i)
            divided.push_back(row(r.removed_mm3 / 4, r.length_mm / 4, *r.seconds / 4));
    }
    const auto of_divided = rates(divided);
    auto mirrored = rates(reversed);
    std::ranges::reverse(mirrored);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_NEAR(of_divided[i], whole[i], 0.002);
        EXPECT_NEAR(mirrored[i], whole[i], 0.002);
    }
}

TEST(Plot, IsOverThePathIfATimeIsUnknown) {
    const auto ledger = ledger_of({row(300, 10, 6), row(100, 30, {})});
    EXPECT_TRUE(contains(rate_plot(ledger, LengthUnit::Inch), "per path, in³/in over path, in"));
    const auto heights = curve_of(removed_plot(ledger, LengthUnit::Inch));
    EXPECT_NEAR(heights.at(100), 0.75, 0.005) << "after a quarter of the path";
    // A row without a length has no time, and does not count.
    const auto start = ledger_of({row(0, 0, {}), row(300, 10, 6)});
    EXPECT_TRUE(contains(rate_plot(start, LengthUnit::Millimetre), "rate, mm³/min over time, s"));
}

TEST(LedgerPage, ShowsWhatIsKnown) {
    Checked checked;
    checked.verdict.ledger = ledger_of({row(300, 10, 6)});
    checked.verdict.ledger.stock_mm3 = 1000;
    checked.verdict.ledger.rest_mm3 = 700;
    checked.verdict.ledger.feed_mm = 200;
    checked.verdict.ledger.air_mm = 50;
    checked.verdict.ledger.feed_seconds = 3725.4;
    const std::string bare = ledger_html(checked, LengthUnit::Millimetre);
    EXPECT_FALSE(contains(bare, "<th>stock</th>")) << "not simulated";
    checked.simulated = true;
    std::string html = ledger_html(checked, LengthUnit::Millimetre);
    EXPECT_TRUE(contains(html, "<th>rest</th><td>700 mm³</td>"));
    EXPECT_TRUE(contains(html, "<th>feed</th><td>200 mm, 1:02:05</td>"));
    EXPECT_TRUE(contains(html, "<th>rapid</th><td>0 mm, unknown"));
    EXPECT_TRUE(contains(html, "= 0 of the stock"));
    EXPECT_FALSE(contains(html, "<th>air</th>"));
    checked.verdict.ledger.air_known = true;
    EXPECT_TRUE(contains(ledger_html(checked, LengthUnit::Millimetre), "25 % of the feed path"));
    checked.verdict.ledger.measured = false;
    html = ledger_html(checked, LengthUnit::Millimetre);
    EXPECT_FALSE(contains(html, "<th>removed</th>") || contains(html, "self-check"));
}

// --- Measures ---

TEST(MeasureSheet, ListsAtMostFortyRowsOfAKindAndAllInJson) {
    for (const std::size_t n : {0U, 1U, 40U, 41U, 100U}) {
        MeasureSheet sheet;
        sheet.extents = {{0, 0, 0}, {10, 10, 10}};
        for (std::size_t i = 0; i < n; ++i) {
            MeasuredBore bore;
            bore.diameter = static_cast<double>(i + 1);
            bore.axis = {0, 0, 1};
            sheet.bores.push_back(bore);
        }
        const std::string text = text_of(sheet);
        EXPECT_EQ(count(text, "deep"), std::min<std::size_t>(n, 40));
        EXPECT_EQ(contains(text, "bores"), n > 0);
        EXPECT_EQ(contains(text, "and " + std::to_string(n - 40) + " more"), n > 40);
        std::ostringstream out;
        write_measures(out, sheet);
        EXPECT_EQ(Json::parse(out.str())["bores"].size(), n);
    }
}

TEST(MeasureSheet, LengthsAreToAMicrometre) {
    struct Row {
        double mm;
        std::string shown, inch;
    };
    for (const Row& r :
         {Row{10.0, "10", "0.3937"}, Row{10.0004, "10", "0.3937"}, Row{10.0006, "10.001", "0.3937"},
          Row{25.4, "25.4", "1"}, Row{1000.0, "1000", "39.3701"}, Row{-0.0001, "0", "0"},
          Row{0.12345, "0.123", "0.0049"}, Row{100.5, "100.5", "3.9567"}}) {
        MeasureSheet sheet;
        MeasuredBore bore;
        bore.mouth = {r.mm, -r.mm, 0.0};
        bore.axis = {0, 0, 1};
        sheet.bores = {bore};
        const auto place = [](const std::string& x) {
            return "X" + x + " Y" + (x == "0" ? "" : "-") + x + ", from Z0";
        };
        EXPECT_TRUE(contains(text_of(sheet), place(r.shown))) << text_of(sheet);
        EXPECT_TRUE(contains(text_of(sheet, LengthUnit::Inch), place(r.inch)))
            << text_of(sheet, LengthUnit::Inch);
    }
}

TEST(MeasureSheet, EqualFeaturesShareARow) {
    MeasureSheet sheet;
    sheet.extents = {{0, 0, -10}, {50, 50, 0}};
    for (const double z : {0.0, 0.0, -2.0}) {
        MeasuredFloor floor;
        floor.z = z, floor.area = 100;
        floor.box = {{0, 0, z}, {10, 10, z}};
        sheet.floors.push_back(floor);
    }
    MeasuredFloor cut = sheet.floors[0];
    cut.by = {{3}, {1}, {}};
    sheet.floors.push_back(cut);
    for (const std::uint32_t line : {9U, 4U, 9U})
        sheet.corners.push_back({5.0, true, 90.0, {}, {0, 0, 1}, {{line}, {1}, {}}});
    sheet.corners.push_back({5.0, false, 90.0, {}, {0, 0, 1}, {}});
    const std::string text = text_of(sheet);
    EXPECT_EQ(count(text, " below the top"), 3U) << text;
    EXPECT_TRUE(contains(text, "2 of them, 200 mm2"));
    EXPECT_TRUE(contains(text, "inside, 3 of them; T1, line 4, 9\n")) << text;
    EXPECT_TRUE(contains(text, "outside, 1 of them; stock\n"));
    sheet.has_too_many_walls = true;
    std::ostringstream out;
    write_measures(out, sheet);
    const Json json = Json::parse(out.str());
    EXPECT_TRUE(json["distances"].is_null());
    EXPECT_EQ(json["floors"].size(), 4U);
    EXPECT_EQ(json["floors"][2]["below_top_mm"], 2.0);
    EXPECT_EQ(json["floors"][2]["above_bottom_mm"], 8.0);
    EXPECT_TRUE(contains(text_of(MeasureSheet{}), "nothing is left"));
}

// --- Sheets of a program ---

simulation::Plan plan_of(const std::string& moves) {
    simulation::Plan plan;
    plan.job = setup::job_of({"slot.nc",
                              "(T1 D=6. CR=0. - flat end mill)\n"
                              "(T2 D=8. CR=4. - ball end mill)\n"
                              "(STOCK/BLOCK,60.,40.,10.,0.,0.,10.)\n"
                              "G21 G90 G17 T1 M6 S8000 M3 F300\nG0 X-10. Y20. Z5.\n" +
                                  moves},
                             {});
    return plan;
}

const std::string kSlot = "G0 Z-2.\nG1 X70.\nG0 Z5.\nM30\n";

TEST(AssumptionSheet, NamesSourcesAndAssumptions) {
    const simulation::Plan plan = plan_of(kSlot);
    simulation::Plan surveyed = plan;
    simulation::ProgramFacts facts = survey(surveyed);
    CuttingFacts cutting = cutting_facts(plan);
    EXPECT_EQ(cutting.tolerance, plan.tolerance);
    EXPECT_EQ(cutting.tool_tolerance, plan.tool_tolerance);
    EXPECT_FALSE(cutting.has_rays_along_z_alone);
    const std::string sheet = assumption_sheet("slot.nc", facts, cutting);
    for (const char* part :
         {"slot.nc, 9 lines, 4 moves\n", "units      millimetres, as the program says\n",
          "tool T1    flat end mill D6 L", "; line 1: (T1 D=6. CR=0. - flat end mill)",
          "line 3: (STOCK/BLOCK,60.,40.,10.,0.,0.,10.)"})
        EXPECT_TRUE(contains(sheet, part)) << part << '\n' << sheet;
    EXPECT_FALSE(contains(sheet, "tool T2")) << "not used";
    EXPECT_TRUE(std::ranges::all_of(sheet, [](char c) { return c != '\r'; }));
    EXPECT_EQ(sheet.back(), '\n');
    EXPECT_EQ(contains(sheet, "draft"), false);
    for (const std::uint64_t moves : {0U, 1U, 2U}) {
        facts.moves_without_start = moves;
        EXPECT_TRUE(contains(assumption_sheet("slot.nc", facts, cutting),
                             moves == 0   ? "start      known\n"
                             : moves == 1 ? "the first move cuts nothing"
                                          : "the first 2 moves cut nothing"));
    }
    facts.unspecified = {false, true, false};
    EXPECT_TRUE(contains(assumption_sheet("slot.nc", facts, cutting), "assumed: Y 0, "));
    cutting.join_tolerance = 0.5;
    EXPECT_TRUE(contains(assumption_sheet("slot.nc", facts, cutting), "within 0.5 mm of a line"));
    cutting.unit = LengthUnit::Inch;
    EXPECT_FALSE(contains(assumption_sheet("slot.nc", facts, cutting), " mm"));
}

TEST(ToolSheet, HasEachCalledOrDescribedToolOnce) {
    simulation::Plan plan = plan_of(kSlot);
    const simulation::ProgramFacts facts = survey(plan);
    std::vector<toolpath::ToolEntry> described(2);
    described[0].spec.number = 7;
    described[0].spec.kind = toolpath::ToolKind::Drill;
    described[0].spec.diameter = 5.0;
    described[0].specified_by = toolpath::ValueSource::Option;
    described[1].spec.number = 1;
    described[1].spec.kind = toolpath::ToolKind::FlatEndMill;
    described[1].spec.diameter = 6.0;
    const std::string text = tool_sheet(facts, described);
    EXPECT_EQ(count(text, "\nT"), 1U) << text;  // T1 is the first line
    EXPECT_TRUE(text.starts_with("T1        flat end mill D6 L")) << text;
    EXPECT_TRUE(contains(text, "T7        drill D5\n  source  from --tool\n  used    no\n"));
    EXPECT_TRUE(contains(text, "80.0 mm cutting")) << text;
    const Json json = Json::parse(tool_sheet_json("folder/slot.nc", "back", facts, described));
    EXPECT_EQ(json["program"], "slot.nc");
    EXPECT_EQ(json["set_up"], "back");
    ASSERT_EQ(json["tools"].size(), 2U);
    EXPECT_EQ(json["tools"][0]["number"], 1);
    EXPECT_EQ(json["tools"][0]["used"], true);
    EXPECT_EQ(json["tools"][0]["feed_mm"], 80.0);
    EXPECT_EQ(json["tools"][1]["used"], false);
    EXPECT_EQ(json["tools"][1]["diameter_mm"], 5.0);
    EXPECT_FALSE(json["tools"][1].contains("length_mm")) << "unspecified";
    EXPECT_EQ(tool_sheet({}, {}),
              "no tool   none is called, and none is described\nstock     not specified\n");
    EXPECT_EQ(Json::parse(tool_sheet_json("a.nc", "", {}, {})).contains("set_up"), false);
    Plunges plunges;
    plunges.is_tilted = true;
    EXPECT_TRUE(contains(tool_sheet({}, {}, plunges), "plunges   none at tilted angles"));
}

TEST(SetUpSheet, HasASectionForEachSetUpAndEscapesTexts) {
    simulation::Plan plan = plan_of(kSlot);
    const simulation::ProgramFacts facts = survey(plan);
    const std::string any = "<b>&\"\x01 50 mm";
    SheetSetUp set_up;
    set_up.title = set_up.program = any;
    set_up.values = {{any, any}};
    set_up.fixtures = {any};
    set_up.assumed = {any, any};
    set_up.facts = &facts;
    const auto sheet = [&](LengthUnit unit) {
        std::ostringstream out;
        write_set_up_sheet(out, any, {set_up, set_up, set_up}, unit);
        return out.str();
    };
    const std::string mm = sheet(LengthUnit::Millimetre), inch = sheet(LengthUnit::Inch);
    EXPECT_EQ(count(mm, "<section>"), 3U);
    EXPECT_EQ(count(mm, "</section>"), 3U);
    EXPECT_EQ(count(mm, "<li>"), 9U);
    EXPECT_FALSE(contains(mm, "<b>") || contains(mm, "\x01"));
    EXPECT_EQ(mm, sheet(LengthUnit::Millimetre));
    EXPECT_TRUE(contains(mm, "50 mm</li>"));
    EXPECT_TRUE(contains(inch, "1.9685 in</li>"));
    EXPECT_EQ(count(mm, "<td>T1</td>"), 3U);
    std::ostringstream none;
    write_set_up_sheet(none, "job", {});
    EXPECT_EQ(count(none.str(), "<section>"), 0U);
    EXPECT_TRUE(none.str().ends_with("</body>\n</html>\n"));
}

TEST(RunReport, OfAProgramThatIsNotSimulated) {
    simulation::Plan plan = plan_of(kSlot);
    const simulation::ProgramFacts facts = survey(plan);
    RunFacts run;
    run.name = "slot.nc";
    run.program = &facts;
    run.cutting = cutting_facts(plan);
    std::ostringstream first, second;
    write_report(first, run);
    write_report(second, run);
    EXPECT_EQ(first.str(), second.str());
    EXPECT_TRUE(Json::parse(first.str()).is_object());
}

// --- Listings ---

TEST(Listing, BlocksAndMotionsAreTheSameInTextAndJson) {
    std::string text = "G21 G90 (first)\n\nG0 X1 Y2 Z3\n";
    for (int i = 0; i < 5000; ++i)
        text += "G1 X" + std::to_string(i) + " F100\n";
    const gcode::SourceFile program{"folder/a.nc", text + "G9999\nM30\n"};
    for (const bool motions : {false, true}) {
        const auto list = [&](bool as_json) {
            std::string all;
            std::size_t largest = 0;
            const TextSink sink = [&](std::string_view chunk) {
                all += chunk;
                largest = std::max(largest, chunk.size());
            };
            const gcode::Diagnostics found = motions ? list_motions(program, {}, as_json, sink)
                                                     : list_blocks(program, {}, as_json, sink);
            EXPECT_LT(largest, 100'000U) << "in chunks";
            return std::pair(all, found.size());
        };
        const auto [lines, faults] = list(false);
        const auto [whole, faults_of_json] = list(true);
        const Json json = Json::parse(whole);
        EXPECT_EQ(json["program"], "a.nc");
        EXPECT_EQ(json[motions ? "motions" : "blocks"].size(),
                  static_cast<std::size_t>(std::ranges::count(lines, '\n')));
        EXPECT_EQ(faults, faults_of_json);
        EXPECT_EQ(json["findings"].size(), faults);
    }
    std::string empty;
    list_blocks({"e.nc", ""}, {}, true, [&](std::string_view chunk) { empty += chunk; });
    EXPECT_TRUE(Json::parse(empty)["blocks"].empty());
}

// --- Tables of two programs ---

std::string differing_rows(const std::string& table) {
    std::string names;
    const std::string mark = "<tr class=\"differs\"><th scope=\"row\">";
    for (std::size_t at = table.find(mark); at != std::string::npos;
         at = table.find(mark, at + 1)) {
        const std::size_t name = at + mark.size();
        names += table.substr(name, table.find('<', name) - name) + ";";
    }
    return names;
}

TEST(ReviewTable, MarksRowsThatDiffer) {
    simulation::Review same;
    simulation::ReviewTool tool;
    tool.shape = "flat end mill D10";
    tool.feed = "300";
    tool.distances.feed_mm = 100;
    same.old_side.tools[1] = same.new_side.tools[1] = tool;
    same.difference.old_mm3 = same.difference.new_mm3 = 5000;
    const auto rows_of = [](const simulation::Review& review) {
        return differing_rows(review_table(review, LengthUnit::Millimetre));
    };
    EXPECT_EQ(rows_of(same), "");
    simulation::Review review = same;
    review.difference.new_mm3 *= 1 + 1e-12;
    EXPECT_EQ(rows_of(review), "") << "rounding";
    review.difference.new_mm3 = 4000;
    EXPECT_EQ(rows_of(review), "volume of the part;");
    EXPECT_TRUE(contains(review_table(review, LengthUnit::Millimetre), "-1000 mm3 (-20.0 %)"));
    std::swap(review.difference.old_mm3, review.difference.new_mm3);
    EXPECT_TRUE(contains(review_table(review, LengthUnit::Millimetre), "+1000 mm3 (+25.0 %)"));
    review = same;
    review.new_side.tools[1].feed = "400";
    EXPECT_EQ(rows_of(review), "feed;");
    review = same;
    review.new_side.tools[1].distances.feed_mm = 110;
    EXPECT_EQ(rows_of(review), "feed path;feed path;") << "of the program and of the tool";
    review = same;
    review.new_side.tools[1].distances.feed_seconds.reset();
    EXPECT_EQ(rows_of(review), "time;time;");
    EXPECT_TRUE(contains(review_table(review, LengthUnit::Millimetre), "<td>unknown</td>"));
    review = same;
    review.new_side.tools.clear();
    review.new_side.tools[2] = tool;
    const std::string moved = review_table(review, LengthUnit::Millimetre);
    EXPECT_EQ(count(moved, "not used"), 2U);
    EXPECT_EQ(count(moved, "class=\"tool\""), 2U);
}

// --- Explanations ---

TEST(Explain, CollectsWhatABlockDoes) {
    simulation::Plan plan = plan_of(
        "G0 Z-2.\n#1=0\nWHILE [#1 LT 3] DO1\nG91 G1 X10.\n"
        "#1=[#1+1]\nEND1\nG90 G0 Z5.\nM30\nG1 X99.\n");
    const simulation::Survey seen = survey(plan);
    const Explanation loop = explain(plan, seen, 9);
    EXPECT_EQ(loop.text, "G91 G1 X10.");
    EXPECT_EQ(loop.executions, 3U);
    EXPECT_EQ(loop.motion_count, 3U);
    EXPECT_EQ(loop.motions.size(), 3U);
    EXPECT_NEAR(loop.distances.feed_mm, 30.0, 1e-9);
    ASSERT_TRUE(loop.removed_mm3);
    // A slot from X-10 to X20: 20 mm in the stock, 6 mm wide and 2 mm deep, and half a disc.
    EXPECT_NEAR(*loop.removed_mm3, 2 * (6 * 20 + 4.5 * 3.14159265), 0.5);
    EXPECT_TRUE(loop.is_changed[static_cast<std::size_t>(ModeGroup::Distance)]);
    EXPECT_FALSE(loop.is_changed[static_cast<std::size_t>(ModeGroup::Units)]);
    EXPECT_EQ(loop.set_by[static_cast<std::size_t>(ModeGroup::Units)].line, 0U)
        << "millimetres from the start";
    EXPECT_EQ(loop.set_by[static_cast<std::size_t>(ModeGroup::Feed)].line, 4U);
    EXPECT_FALSE(explain(plan, seen, 9, {}, false).removed_mm3);
    const Explanation after = explain(plan, seen, 12);
    EXPECT_EQ(after.set_by[static_cast<std::size_t>(ModeGroup::Motion)].line, 12U);
    const Explanation never = explain(plan, seen, 14);
    EXPECT_EQ(never.executions, 0U);
    EXPECT_EQ(text_of(never), "slot.nc:14: G1 X99.\n  not executed\n");
    EXPECT_EQ(Json::parse(json_of(never))["executions"], 0);
    EXPECT_THROW(explain(plan, seen, 15), std::runtime_error) << "no such line";
    EXPECT_THROW(explain(plan, seen, 1, "sub.nc"), std::runtime_error) << "no such file";
}

TEST(Explanation, TextAndJsonHaveTheSameModes) {
    simulation::Plan plan = plan_of(kSlot);
    const simulation::Survey seen = survey(plan);
    const Explanation made = explain(plan, seen, 7);
    const std::string text = text_of(made);
    const Json json = Json::parse(json_of(made));
    ASSERT_EQ(json["modes"].size(), kModeGroups);
    for (const Json& mode : json["modes"])
        EXPECT_TRUE(contains(text, mode["value"].get<std::string>())) << mode;
    EXPECT_EQ(json["position"]["before"]["x"], -10.0);
    EXPECT_EQ(json["position"]["after"]["x"], 70.0);
    EXPECT_EQ(json["feed_mm"], 80.0);
    EXPECT_EQ(json["motion_count"], 1);
    EXPECT_NEAR(json["removed_mm3"].get<double>(), 6 * 60 * 2, 1.0);
}

}  // namespace
}  // namespace ncsim::report
