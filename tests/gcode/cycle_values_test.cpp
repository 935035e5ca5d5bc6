// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of cycles, one changed at a time (cycle_values.txt): the changed value changes the listed
// properties of the path to the listed values, and no others.
#include "gcode/language_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::gcode::cycle_values_test {
namespace {

using language_test::Made;

/// Properties of a path by name, as text.
using Properties = std::map<std::string, std::string>;

std::string number(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.4f", std::round(value * 1e4) / 1e4 + 0.0);
    std::string out = text.data();
    out.erase(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
    return out;
}

std::string list(const auto& values) {
    std::string out;
    for (const double value : values)
        out += (out.empty() ? "" : ",") + number(value);
    return out.empty() ? "-" : out;
}

struct Range {
    double least = 1e9, most = -1e9;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    std::string text() const { return least > most ? "-" : number(least) + ".." + number(most); }
};

double speed_of(const Motion& motion) {
    if (motion.spindle_oriented) return 0.5;  // Neither a speed nor at rest.
    if (motion.spindle == SpindleTurning::Stopped) return 0.0;
    return motion.spindle == SpindleTurning::Clockwise ? motion.spindle_rpm : -motion.spindle_rpm;
}

/// Returns the length of a line or of the circle through the ends of an arc, with its height.
double length_of(const Motion& motion) {
    const Position& a = *start_of(motion);
    const Position& b = *end_of(motion);
    const double dz = b.z.mm() - a.z.mm();
    double flat = std::hypot(b.x.mm() - a.x.mm(), b.y.mm() - a.y.mm());
    if (const auto* const arc = std::get_if<Arc>(&motion.action)) {
        const double x = arc->centre_1.mm();
        const double y = arc->centre_2.mm();
        const double radius = std::hypot(a.x.mm() - x, a.y.mm() - y);
        constexpr double kTurn = 6.283185307179586;
        double angle =
            std::atan2(b.y.mm() - y, b.x.mm() - x) - std::atan2(a.y.mm() - y, a.x.mm() - x);
        if (arc->turns < 0) angle = -angle;
        while (angle <= 1e-9)
            angle += kTurn;
        flat = radius * (angle + kTurn * (std::abs(arc->turns) - 1));
    }
    return std::hypot(flat, dz);
}

/// Properties of the moves at or after line `line`:
/// low, last: the lowest height and the last; x, y: ranges of the ends of feed moves;
/// feeds: mm/min; holes: places in X and Y where the tool goes deepest; dips: feed moves down;
/// arcs: signed number of turns; dwell: s; speeds: rpm in order, negative counter-clockwise, 0 at
/// rest, 0.5 oriented; way, rapid: lengths of all feed moves and of all rapids; said: codes of
/// warnings and errors.
Properties properties_of(const std::string& text, std::uint32_t line, Dialect dialect,
                         const std::string& name) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.tools = {
        {.number = 1, .offset = {}, .length_specified = false, .diameter = Length::from_mm(10.0)}};
    options.work_offsets_specified.fill(true);
    options.peck_clearance = 0.2;
    Range x, y, z;
    std::set<double> feeds;
    std::vector<double> speeds;
    std::set<std::pair<double, double>> holes;
    int dips = 0;
    int arcs = 0;
    double dwell = 0.0;
    double way = 0.0;
    double rapid = 0.0;
    double last = 0.0;
    const Interpretation result = interpret({name, text}, options, [&](const Motion& motion) {
        if (motion.span.line < line) return;
        if (const auto* const stop = std::get_if<Dwell>(&motion.action)) dwell += stop->seconds;
        if (!start_of(motion)) return;
        const Position& a = *start_of(motion);
        const Position& b = *end_of(motion);
        z.add(b.z.mm());
        last = b.z.mm();
        if (speeds.empty() || speeds.back() != speed_of(motion)) speeds.push_back(speed_of(motion));
        if (motion.kind == MoveKind::Rapid) {
            rapid += length_of(motion);
            return;
        }
        way += length_of(motion);
        x.add(b.x.mm());
        y.add(b.y.mm());
        feeds.insert(motion.feed);
        if (const auto* const arc = std::get_if<Arc>(&motion.action)) arcs += arc->turns;
        if (b.z.mm() < a.z.mm() - 1e-9) {
            ++dips;
            holes.insert({std::round(b.x.mm() * 1e3), std::round(b.y.mm() * 1e3)});
        }
    });
    std::set<std::string> said;
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity != Severity::Note) said.insert(std::string(d.code));
    }
    std::string codes;
    for (const std::string& code : said)
        codes += (codes.empty() ? "" : ",") + code;
    return {{"low", z.least > z.most ? "-" : number(z.least)},
            {"last", number(last)},
            {"x", x.text()},
            {"y", y.text()},
            {"feeds", list(feeds)},
            {"speeds", list(speeds)},
            {"holes", std::to_string(holes.size())},
            {"dips", std::to_string(dips)},
            {"arcs", std::to_string(arcs)},
            {"dwell", number(dwell)},
            {"way", number(way)},
            {"rapid", number(rapid)},
            {"said", codes.empty() ? "-" : codes}};
}

/// A call with named values: "CYCLE81(RTP=10,RFP=0)" or "CYCL DEF 200 Q200=2 Q201=-10".
struct Call {
    std::string head;
    std::vector<std::pair<std::string, std::string>> values;
};

Call call_of(const std::string& text) {
    Call call;
    std::string words = text;
    const bool has_places = text.find('(') != std::string::npos;
    if (has_places) {
        call.head = text.substr(0, text.find('(') + 1);
        words = text.substr(call.head.size(), text.rfind(')') - call.head.size());
        std::ranges::replace(words, ',', ' ');
    }
    std::istringstream in(words);
    for (std::string word; in >> word;) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos) {
            call.head += word + ' ';
        } else {
            call.values.emplace_back(word.substr(0, equals), word.substr(equals + 1));
        }
    }
    return call;
}

/// Replaces or adds the value `name`; "none" is left out of the text.
void change(Call& call, const std::string& name, const std::string& value) {
    const auto found =
        std::ranges::find(call.values, name, &std::pair<std::string, std::string>::first);
    if (found == call.values.end()) {
        call.values.emplace_back(name, value);
    } else {
        found->second = value;
    }
}

enum class Language { Klartext, Sinumerik, Iso };

std::string text_of(const Call& call, Language language) {
    std::string text = call.head;
    for (std::size_t i = 0; i < call.values.size(); ++i) {
        const auto& [name, value] = call.values[i];
        if (language == Language::Sinumerik) {
            text += (i == 0 ? "" : ",") + (value == "none" ? "" : value);
        } else if (value != "none") {
            text += name + (language == Language::Klartext ? "=" : "") + value + ' ';
        }
    }
    return text + (language == Language::Sinumerik ? ")" : "");
}

Properties properties_of(const Call& call, Language language) {
    const std::string cycle = text_of(call, language);
    switch (language) {
        case Language::Klartext:
            return properties_of(
                "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+3 Y+4 Z+60 R0 FMAX M3\n"
                "L F77\n" +
                    cycle + "\nL X+3 Y+4 FMAX M99\nM30\nEND PGM T MM\n",
                5, Dialect::Auto, "test.h");
        case Language::Sinumerik:
            return properties_of(
                "G710 G90 G17 G40 G94\nT1 M6\nS1000 D1\nG0 X3 Y4 Z60 M3\nF77\n" + cycle + "\nM30\n",
                6, Dialect::Sinumerik, "test.mpf");
        case Language::Iso: break;
    }
    return properties_of("%\nO0001\nG21 G90 G17 G40 G80\nT1 M6\nS1000 G0 X3. Y4. Z60. M3\nF77\n" +
                             cycle + "\nG80\nM30\n%\n",
                         7, Dialect::Fanuc, "test.nc");
}

/// Reads "Q201=-12 Q202=4", in this order.
std::vector<std::pair<std::string, std::string>> named_values(const std::string& text) {
    std::vector<std::pair<std::string, std::string>> all;
    std::istringstream in(text);
    for (std::string word; in >> word;) {
        const std::size_t equals = word.find('=');
        all.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    }
    return all;
}

/// Reads "low=-12 way=24".
Properties listed(const std::string& text) {
    Properties all;
    for (const auto& [name, value] : named_values(text))
        all[name] = value;
    return all;
}

std::string text_of(const Properties& properties) {
    std::string text;
    for (const auto& [name, value] : properties)
        text += (text.empty() ? "" : " ") + name + "=" + value;
    return text;
}

/// Returns the properties of `all` that differ from `base`.
Properties differences(const Properties& all, const Properties& base) {
    Properties changed;
    for (const auto& [name, value] : all) {
        if (base.at(name) != value) changed[name] = value;
    }
    return changed;
}

/// A call of the table, and its lines with changed values.
struct CallRows {
    std::string text;
    Language language = Language::Klartext;
    Call call;
    Properties properties;
    struct Row {
        std::vector<std::pair<std::string, std::string>> values;
        Properties changed;
    };
    std::vector<Row> rows;
    std::set<std::string> without_effect;
};

/// Reads cycle_values.txt. " Q336 has no effect: REASON" is a line of its own.
std::vector<CallRows> table() {
    constexpr std::string_view kNoEffect = " has no effect: ";
    std::ifstream in(std::string(NCSIM_SOURCE_DIR) + "/tests/gcode/cycle_values.txt");
    std::vector<CallRows> calls;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (const std::size_t at = line.find(kNoEffect); at != std::string::npos) {
            std::istringstream names(line.substr(0, at));
            for (std::string name; names >> name;)
                calls.back().without_effect.insert(name);
            continue;
        }
        const std::size_t arrow = line.find(" -> ");
        const std::string left = line.substr(0, arrow);
        Properties right = listed(arrow == std::string::npos ? "" : line.substr(arrow + 4));
        if (left[0] == ' ') {
            calls.back().rows.push_back({named_values(left), std::move(right)});
            continue;
        }
        CallRows& call = calls.emplace_back();
        call.text = left;
        call.language = left.starts_with("CYCL ")             ? Language::Klartext
                        : left.find('(') != std::string::npos ? Language::Sinumerik
                                                              : Language::Iso;
        call.call = call_of(left);
        call.properties = std::move(right);
    }
    return calls;
}

TEST(CycleValues, ChangeTheListedPropertiesOfThePath) {
    std::size_t rows = 0;
    const std::vector<CallRows> calls = table();
    for (const CallRows& call : calls) {
        const Properties of_base = properties_of(call.call, call.language);
        EXPECT_EQ(text_of(of_base), text_of(call.properties)) << call.text;
        for (const CallRows::Row& row : call.rows) {
            Call changed = call.call;
            for (const auto& [name, value] : row.values)
                change(changed, name, value);
            const Properties now = differences(properties_of(changed, call.language), of_base);
            EXPECT_EQ(text_of(now), text_of(row.changed)) << text_of(changed, call.language);
            ++rows;
        }
    }
    EXPECT_GT(calls.size(), 40U);
    EXPECT_GT(rows, 300U);
}

/// True if a line of the table shows that `name` changes the path.
bool is_shown(const CallRows& call, const std::string& name) {
    return std::ranges::any_of(call.rows, [&](const CallRows::Row& row) {
        return !row.changed.empty() &&
               std::ranges::find(row.values, name, &std::pair<std::string, std::string>::first) !=
                   row.values.end();
    });
}

/// True if another value of `name` changes the path of the call without a message.
bool acts(const CallRows& call, const std::string& name) {
    if (is_shown(call, name)) return true;
    for (const char* value :
         {"1", "2", "0", "7", "0.37", "-3", "3", "45", "none", "1.", "0.5", "77."}) {
        Call changed = call.call;
        change(changed, name, value);
        const Properties now = differences(properties_of(changed, call.language), call.properties);
        if (!now.empty() && !now.contains("said")) return true;
    }
    return false;
}

/// Each value of a call has an effect, or the table says why it has none.
TEST(CycleValues, HaveAnEffectOrAReason) {
    for (const CallRows& call : table()) {
        for (const auto& [name, value] : call.call.values) {
            EXPECT_NE(acts(call, name), call.without_effect.contains(name))
                << call.text << ": " << name;
        }
    }
}

/// A parameter that a Klartext cycle does not apply is a doubt, unless the table says why it has no
/// effect.
TEST(CycleValues, OfUnknownParametersAreADoubt) {
    std::set<std::string> names;
    for (const CallRows& call : table()) {
        if (call.language != Language::Klartext) continue;
        for (const auto& [name, value] : call.call.values)
            names.insert(name);
        names.insert(call.without_effect.begin(), call.without_effect.end());
    }
    names.insert({"Q395", "Q439", "Q512", "Q599"});
    std::size_t doubts = 0;
    for (const CallRows& call : table()) {
        if (call.language != Language::Klartext) continue;
        for (const std::string& name : names) {
            const bool is_own = std::ranges::find(call.call.values, name,
                                                  &std::pair<std::string, std::string>::first) !=
                                call.call.values.end();
            if (is_own || is_shown(call, name)) continue;
            Call changed = call.call;
            change(changed, name, "2");
            const Properties now =
                differences(properties_of(changed, call.language), call.properties);
            const bool is_doubt =
                now.contains("said") &&
                now.at("said").find("cycle-parameter-left-out") != std::string::npos;
            EXPECT_NE(!now.empty(), call.without_effect.contains(name))
                << call.text << ": " << name;
            doubts += is_doubt ? 1 : 0;
        }
    }
    EXPECT_GT(doubts, 500U);
}

}  // namespace
}  // namespace ncsim::gcode::cycle_values_test
