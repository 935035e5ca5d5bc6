// SPDX-License-Identifier: GPL-3.0-or-later
//
// PATTERN DEF and CYCL CALL PAT: the defined cycle at single places, on lines, in frames, on
// circles.
#include "ncsim/base/angles.h"

#include "klartext/control.h"
#include "klartext/scanner.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::klartext {
namespace {

constexpr double kMostPlaces = 10'000.0;

using Values = std::map<std::string, double, std::less<>>;

double value_of(const Values& values, std::string_view name, double otherwise) {
    const auto found = values.find(name);
    return found == values.end() ? otherwise : found->second;
}

/// Words that a kind of pattern requires; empty for an unknown kind.
std::vector<std::string_view> words_of(std::string_view kind) {
    if (kind == "POS") return {"X", "Y"};
    if (kind == "ROW") return {"X", "Y", "D", "NUM"};
    if (kind == "PAT" || kind == "FRAME") return {"X", "Y", "DX", "DY", "NUMX", "NUMY"};
    if (kind == "CIRC") return {"X", "Y", "D", "NUM"};
    if (kind == "PITCHCIRC") return {"X", "Y", "D", "NUM"};
    return {};
}

/// Returns the places of PAT or FRAME relative to the first one.
std::vector<Vec2> grid(const Values& values, bool is_frame, int columns, int rows) {
    const SinCos direction = sin_cos(value_of(values, "ROT", 0.0));
    std::vector<Vec2> places;
    places.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const bool is_inside = row > 0 && row + 1 < rows && column > 0 && column + 1 < columns;
            if (is_frame && is_inside) continue;
            const double x = column * value_of(values, "DX", 0.0);
            const double y = row * value_of(values, "DY", 0.0);
            places.push_back(
                {x * direction.cos - y * direction.sin, x * direction.sin + y * direction.cos});
        }
    }
    return places;
}

/// Returns the angle between two places of CIRC or PITCHCIRC, degrees.
double step_of(const Values& values, bool is_part, int count) {
    constexpr double kTurn = 360.0;
    if (!is_part) return kTurn / count;
    if (values.contains("STEP")) return value_of(values, "STEP", 0.0);
    const double range = value_of(values, "END", 0.0) - value_of(values, "START", 0.0);
    return range / std::max(1, count - 1);
}

/// Returns the places of a pattern relative to its X and Y.
std::vector<Vec2> pattern_places(std::string_view kind, const Values& values) {
    if (kind == "POS") return {{0.0, 0.0}};
    if (kind == "PAT" || kind == "FRAME") {
        return grid(values, kind == "FRAME", static_cast<int>(value_of(values, "NUMX", 1.0)),
                    static_cast<int>(value_of(values, "NUMY", 1.0)));
    }
    const int count = static_cast<int>(value_of(values, "NUM", 1.0));
    const double d = value_of(values, "D", 0.0);
    std::vector<Vec2> places;
    places.reserve(static_cast<std::size_t>(count));
    const bool is_row = kind == "ROW";
    const double step = is_row ? 0.0 : step_of(values, kind == "PITCHCIRC", count);
    for (int i = 0; i < count; ++i) {
        const SinCos direction = sin_cos(is_row ? value_of(values, "ROT", 0.0)
                                                : value_of(values, "START", 0.0) + i * step);
        const double radius = is_row ? i * d : d / 2.0;
        places.push_back({radius * direction.cos, radius * direction.sin});
    }
    return places;
}

bool is_count(double value) {
    return value >= 1.0 && value <= kMostPlaces && value == std::round(value);
}

}  // namespace

/// Reads "POS1 (X+10 Y+20 Z+0)" and the other kinds, several in a block.
bool Control::pattern_def(const Block& block) {
    Scanner scan(block.code, block.rest);
    pattern_.clear();
    const auto refuse = [&](std::size_t begin) {
        return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                    {block.code.substr(begin)});
    };
    while (!scan.is_at_end()) {
        scan.skip_blanks();
        const std::size_t begin = scan.at();
        const std::string kind = upper_of(scan.letters());
        const std::vector<std::string_view> required = words_of(kind);
        (void)scan.whole();
        scan.skip_blanks();
        if (required.empty() || scan.peek() != '(') return refuse(begin);
        scan.move_to(scan.at() + 1);
        Values values;
        for (scan.skip_blanks(); scan.peek() != ')'; scan.skip_blanks()) {
            const std::size_t word = scan.at();
            const std::string name = upper_of(scan.letters());
            const klartext::Value value = scan.value();
            const SourceSpan span = block.span(word, scan.at() - word);
            if (name.empty() || value.kind == klartext::Value::Kind::None) return refuse(word);
            const std::optional<double> number = parameters_.value_of(value, span);
            if (!number) return false;
            if (!values.emplace(name, *number).second) return refuse(word);
        }
        scan.move_to(scan.at() + 1);
        const SourceSpan whole = block.span(begin, scan.at() - begin);
        if (!add_places(kind, values, required, whole)) return false;
    }
    return true;
}

/// Checks the words of a pattern and adds its places.
bool Control::add_places(std::string_view kind, const PatternValues& values,
                         const std::vector<std::string_view>& required, SourceSpan span) {
    for (const std::string_view word : required) {
        if (!values.contains(word))
            return fail(Message::BlockNeeds, span, {"PATTERN DEF " + std::string(kind), word});
    }
    for (const auto& [name, value] : values) {
        const bool is_number = name.starts_with("NUM");
        if (is_number && !is_count(value))
            return fail(Message::BlockNeeds, span,
                        {"PATTERN DEF", "a number of places from 1 to 10000"});
        const bool is_known = is_number || name == "Z" || name == "ROT" || name == "START" ||
                              name == "STEP" || name == "END" ||
                              std::ranges::find(required, name) != required.end();
        const bool is_skew = (name == "ROTX" || name == "ROTY") && value == 0.0;
        if (!is_known && !is_skew)
            return fail(Message::KlartextVerb, span, {"PATTERN DEF with " + name});
    }
    if (value_of(values, "NUMX", 1.0) * value_of(values, "NUMY", 1.0) > kMostPlaces)
        return fail(Message::BlockNeeds, span,
                    {"PATTERN DEF", "a number of places from 1 to 10000"});
    if (kind == "PITCHCIRC" && !values.contains("STEP") && !values.contains("END"))
        return fail(Message::BlockNeeds, span, {"PATTERN DEF PITCHCIRC", "STEP or END"});
    const Vec2 first{value_of(values, "X", 0.0), value_of(values, "Y", 0.0)};
    for (const Vec2& place : pattern_places(kind, values)) {
        pattern_.push_back(
            {{first[0] + place[0], first[1] + place[1]}, value_of(values, "Z", 0.0)});
    }
    return true;
}

/// CYCL CALL PAT: runs the defined cycle at all places. Between the places the tool is at the
/// height of the call, or at Q204 above the surface if that is higher.
bool Control::call_at_places(bool is_rapid, SourceSpan span) {
    if (pattern_.empty())
        return fail(Message::BlockNeeds, span, {"CYCL CALL PAT", "PATTERN DEF before it"});
    if (cycle_.number < 200) {
        log_.add(Message::KlartextCycleUndefined, span);
        return true;
    }
    const std::size_t axis = axes_of(plane_).third;
    const auto bit = static_cast<AxisMask>(1U << axis);
    const std::optional<double> at_call = is_unknown(bit) ? std::nullopt : std::optional(at_[axis]);
    cycle_span_ = span;
    for (const PatternPlace& place : pattern_) {
        surface_shift_ = place.surface;
        const double surface = value(203, 0.0) + surface_shift_;
        const double clearance = surface + std::max(value(204, 0.0), value(200, 0.0));
        const double safe = std::max(clearance, at_call.value_or(clearance));
        if ((at_[axis] < safe || is_unknown(bit)) && !move_to(safe, std::nullopt)) return false;
        if (!go_to(place.at, is_rapid, span) || !call_cycle(span)) return false;
    }
    surface_shift_ = 0.0;
    return true;
}

}  // namespace ncsim::gcode::klartext
