// SPDX-License-Identifier: GPL-3.0-or-later
//
// SL cycles: 14 (contours), 20 (data), 22 (roughing), 23 and 24 (finishing of floor and side), 25
// (contour train). The contours are subprograms that are recorded, not executed.
// Source: HEIDENHAIN TNC 640, User's Manual for Cycle Programming, 892903, "SL cycles".
#include "ncsim/base/angles.h"

#include "klartext/control.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ncsim::gcode::klartext {
namespace {

constexpr double kChord = 0.002;          // Chord tolerance of arcs of contours, mm.
constexpr double kMaxClosingGap = 0.005;  // Between the ends of a closed contour, mm.
constexpr double kMostStrokes = 20'000.0;
constexpr double kMostWork = 2e7;  // Strokes times sides.
constexpr double kMostSides = 2000.0;
constexpr double kWidestStroke = 1.8;  // Distance of strokes, radii of the tool.
constexpr std::size_t kMostContours = 100;

bool crosses(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto side = [](Vec2 o, Vec2 p, Vec2 q) {
        return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x) > 0.0;
    };
    return side(c, d, a) != side(c, d, b) && side(a, b, c) != side(a, b, d);
}

bool cross(const std::vector<Vec2>& one, const std::vector<Vec2>& other) {
    for (std::size_t i = 0; i < one.size(); ++i) {
        for (std::size_t k = 0; k < other.size(); ++k) {
            if (crosses(one[i], one[(i + 1) % one.size()], other[k], other[(k + 1) % other.size()]))
                return true;
        }
    }
    return false;
}

}  // namespace

/// A contour of cycle 14, in the direction in which the tool moves.
struct Control::MilledContour {
    language::Pass outline;
    bool is_island = false;
    CutterSide side = CutterSide::Left;
    std::vector<Vec2> polygon;
};

/// The region that an SL cycle mills at each level.
struct Control::ContourMilling {
    std::vector<MilledContour> contours;
    double tool_radius = 0.0;
    double surface = 0.0, bottom = 0.0, clear = 0.0;
    double infeed = 0.0;
    double inset = 0.0;  ///< Distance between the tool centre and the contours.
    double step = 0.0;   ///< Distance between strokes.
    double feed = 0.0, plunge_feed = 0.0;
    bool has_strokes = true;
};

/// Reads "CYCL DEF 14.1 CONTOUR LABEL 1 /2 /3".
bool Control::contour_labels(const Block& block, Scanner& scan) {
    while (!scan.is_at_end() && !is_digit(scan.peek()))
        scan.move_to(scan.at() + 1);
    contour_labels_.clear();
    do {
        scan.skip_blanks();
        const std::size_t begin = scan.at();
        const std::optional<std::uint32_t> label = scan.whole();
        if (!label || contour_labels_.size() >= kMostContours)
            return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                        {block.code.substr(begin)});
        contour_labels_.push_back(std::to_string(*label));
    } while (scan.take('/'));
    return true;
}

/// Reads the contours of cycle 14, and turns each into the direction of the cut.
bool Control::read_contours(SourceSpan span, bool is_climb, ContourMilling& m) {
    const std::string name = "cycle " + std::to_string(cycle_.number);
    const auto needs = [&](std::string_view what) {
        return fail(Message::BlockNeeds, span, {name, what});
    };
    const double unit = machine_.state().unit_mm();
    const bool turns_left = machine_.state().spindle == SpindleTurning::Counterclockwise;
    for (const std::string& label : contour_labels_) {
        std::optional<Contour> read = read_contour_(label, span);
        if (!read) return false;
        MilledContour contour;
        contour.outline = std::move(read->moves);
        if (contour.outline.empty()) return needs("contours of lines and arcs in the plane");
        const Vec2 begin = contour.outline.front().from;
        const Vec2 end = contour.outline.back().to;
        if (hypotenuse(end.x - begin.x, end.y - begin.y) > kMaxClosingGap / unit)
            return needs("contours that end where they begin");
        contour.outline.back().to = begin;
        if (read->side == CutterSide::Off) return needs("contours with RL or RR");
        contour.polygon = polygon_of(contour.outline, kChord / unit);
        const bool is_left = signed_area(contour.polygon) > 0.0;
        contour.is_island = (read->side == CutterSide::Left) != is_left;
        // Climb milling: counter-clockwise in a pocket, clockwise around an island.
        const bool goes_left = (is_climb != turns_left) != contour.is_island;
        if (goes_left != is_left) language::reverse(contour.outline);
        contour.side = goes_left != contour.is_island ? CutterSide::Left : CutterSide::Right;
        m.contours.push_back(std::move(contour));
    }
    return check_contours(span, m.contours);
}

/// Refuses contours that cross, pockets in pockets and islands outside of pockets.
bool Control::check_contours(SourceSpan span, const std::vector<MilledContour>& contours) {
    double sides = 0.0;
    for (const MilledContour& contour : contours)
        sides += static_cast<double>(contour.polygon.size());
    if (sides > kMostSides) return fail(Message::KlartextVerb, span, {"a contour of so many arcs"});
    for (const MilledContour& contour : contours) {
        int pockets = 0;
        for (const MilledContour& other : contours) {
            if (&other == &contour) continue;
            const bool is_inside = Area({other.polygon}, 0.0).contains(contour.polygon.front());
            if (!other.is_island && is_inside) ++pockets;
            const bool overlaps = other.is_island == contour.is_island && is_inside;
            if (overlaps || cross(contour.polygon, other.polygon))
                return fail(Message::KlartextVerb, span, {"cycle 14 with contours that overlap"});
        }
        if (contour.is_island && pockets != 1)
            return fail(Message::BlockNeeds, span, {"cycle 14", "islands inside of pockets"});
    }
    return true;
}

/// 22, 23, 24: mills the contours of cycle 14 with the data of cycle 20.
bool Control::mill_contours(SourceSpan span) {
    const int number = cycle_.number;
    const std::string name = "cycle " + std::to_string(number);
    if (contour_labels_.empty())
        return fail(Message::BlockNeeds, span, {name, "cycle 14 (contours) before"});
    if (contour_data_.number != 20)
        return fail(Message::BlockNeeds, span, {name, "cycle 20 (contour data) before"});
    if (!(radius_of_tool().value_or(0.0) > 0.0)) {
        report_unknown_radius(name);
        return true;
    }
    const auto data = [&](std::uint32_t q) {
        const auto found = contour_data_.values.find(q);
        return found == contour_data_.values.end() ? 0.0 : found->second.number;
    };
    const double depth = data(1);
    if (depth >= 0.0) {
        log_.add(depth > 0.0 ? Message::KlartextDepthPositive : Message::KlartextDepthZero, span,
                 {"20"});
        return true;
    }
    if (!needs({11, 12}, span) || (number != 23 && !needs({10}, span))) return false;
    if (data(8) > 0.0) log_.add(Message::KlartextInnerRadius, span);
    ContourMilling m;
    m.tool_radius = *radius_of_tool();
    m.surface = data(5);
    m.bottom = m.surface + depth + (number == 22 ? std::abs(data(4)) : 0.0);
    m.clear = m.surface + data(6);
    m.infeed = number == 23 ? 0.0 : std::abs(value(10, 0.0));
    m.inset = m.tool_radius + (number == 24 ? std::abs(value(14, 0.0)) : std::abs(data(3)));
    const double overlap = data(2) > 0.0 ? data(2) : 1.0;
    m.step = std::min(overlap, kWidestStroke) * m.tool_radius;
    m.plunge_feed = feed_of(feed_value(11).value_or(0.0));
    m.feed = feed_of(feed_value(12).value_or(0.0));
    m.has_strokes = number != 24;
    const double direction = number == 24 ? value(9, data(9)) : data(9);
    if (m.bottom >= m.surface)
        return fail(Message::BlockNeeds, span, {name, "a depth below the allowance"});
    if (!read_contours(span, direction >= 0.0, m)) return false;
    const double safe = std::max(m.clear, data(7));
    return move_to(safe, std::nullopt) && mill_levels(span, m) && move_to(safe, std::nullopt);
}

/// 25: mills along the contour of cycle 14, which may be open.
bool Control::mill_contour_train(SourceSpan span) {
    const std::string name = "cycle 25";
    if (contour_labels_.size() != 1)
        return fail(Message::BlockNeeds, span, {name, "cycle 14 with one contour before"});
    if (!needs({1, 5, 7, 12}, span)) return false;
    const double depth = value(1, 0.0);
    if (depth >= 0.0) {
        log_.add(depth > 0.0 ? Message::KlartextDepthPositive : Message::KlartextDepthZero, span,
                 {"25"});
        return true;
    }
    if (value(18, 0.0) != 0.0)
        return fail(Message::KlartextVerb, span, {name + " with a coarse tool (Q18)"});
    std::optional<Contour> read = read_contour_(contour_labels_.front(), span);
    if (!read) return false;
    language::ContourPath m;
    m.contour = std::move(read->moves);
    m.side = read->side;
    if (m.side != CutterSide::Off && !(radius_of_tool().value_or(0.0) > 0.0)) {
        report_unknown_radius(name);
        return true;
    }
    const PlaneAxes axes = axes_of(plane_);
    const Transformation& t = transformation_;
    m.is_mirrored = t.is_mirrored[axes.first] != t.is_mirrored[axes.second];
    if (m.side != CutterSide::Off) m.offset = *radius_of_tool() + std::abs(value(3, 0.0));
    m.surface = value(5, 0.0);
    m.bottom = m.surface + depth;
    m.clear = value(7, 0.0);
    m.lift_to = m.clear;
    m.infeed = std::abs(value(10, 0.0));
    m.plunge_feed = feed_of(feed_value(11).value_or(feed_value(12).value_or(0.0)));
    m.feed = feed_of(feed_value(12).value_or(0.0));
    const double direction = value(15, 1.0);
    m.is_alternating = direction == 0.0;
    const bool turns_left = machine_.state().spindle == SpindleTurning::Counterclockwise;
    const bool is_climb = (m.side == CutterSide::Left) != turns_left;
    if (direction != 0.0 && m.side != CutterSide::Off && is_climb != (direction > 0.0)) {
        language::reverse(m.contour);
        m.side = m.side == CutterSide::Left ? CutterSide::Right : CutterSide::Left;
    }
    return move_to(m.clear, std::nullopt) && mill_along(m, name) && move_to(m.clear, std::nullopt);
}

bool Control::mill_levels(SourceSpan span, const ContourMilling& m) {
    std::vector<std::vector<Vec2>> polygons;
    double sides = 0.0;
    for (const MilledContour& contour : m.contours) {
        polygons.push_back(contour.polygon);
        sides += static_cast<double>(contour.polygon.size());
    }
    const Area area(polygons, m.inset);
    // Chords of islands are inside of their arcs.
    const Area room(polygons, m.inset + kChord / machine_.state().unit_mm());
    const double height = room.highest() - room.lowest();
    const double levels =
        m.infeed > 0.0 ? std::ceil((m.surface - m.bottom) / m.infeed - 1e-9) : 1.0;
    const double strokes = m.has_strokes ? std::max(0.0, std::ceil(height / m.step - 1e-9)) : 0.0;
    if (!(area.highest() >= area.lowest()))
        return fail(Message::BlockNeeds, span,
                    {"cycle " + std::to_string(cycle_.number), "a contour with room for the tool"});
    const double work = (strokes + static_cast<double>(m.contours.size())) * std::max(levels, 1.0);
    if (!(work <= kMostStrokes && work * sides <= kMostWork))
        return fail(Message::CycleRepeats, span);
    for (int i = 1; i <= static_cast<int>(std::max(levels, 1.0)); ++i) {
        const double level = i < levels ? m.surface - i * m.infeed : m.bottom;
        for (int s = 0; m.has_strokes && s <= static_cast<int>(strokes); ++s) {
            const double at = s < strokes ? room.lowest() + s * m.step : room.highest();
            std::vector<Stroke> pieces = room.strokes_at(at);
            const bool is_back = s % 2 == 1;
            if (is_back) std::ranges::reverse(pieces);
            for (const Stroke& piece : pieces) {
                const Vec2 from{is_back ? piece.to : piece.from, at};
                const Vec2 to{is_back ? piece.from : piece.to, at};
                if (!reach(m, area, from, level) || !move_in_plane(to, m.feed)) return false;
            }
        }
        for (const MilledContour& contour : m.contours) {
            if (!mill_contour(m, area, contour, level)) return false;
        }
        if (!move_to(m.clear, std::nullopt)) return false;
    }
    return true;
}

/// Moves the tool to `to` at the height `level`: straight inside the area, otherwise above the
/// part.
bool Control::reach(const ContourMilling& m, const Area& area, Vec2 to, double level) {
    const bool is_down = at_[axes_of(plane_).third] == level;
    if (is_down && area.contains(point_in_plane(), to)) return move_in_plane(to, m.feed);
    return move_to(m.clear, std::nullopt) && move_in_plane(to, std::nullopt) &&
           move_to(level, m.plunge_feed);
}

/// Mills along `contour` from the middle of its first move.
bool Control::mill_contour(const ContourMilling& m, const Area& area, const MilledContour& contour,
                           double level) {
    const OutlineMove& first = contour.outline.front();
    const Vec2 middle = point_at(first, 0.5);
    const Vec2 ahead = direction_in_middle(first);
    const double length = hypotenuse(ahead.x, ahead.y);
    if (length == 0.0) return true;
    const bool is_left = contour.side == CutterSide::Left;
    const double in = is_left ? m.inset / length : -m.inset / length;
    if (!reach(m, area, {middle.x - in * ahead.y, middle.y + in * ahead.x}, level)) return false;
    const PlaneAxes axes = axes_of(plane_);
    const Transformation& t = transformation_;
    const bool is_mirrored = t.is_mirrored[axes.first] != t.is_mirrored[axes.second];
    at_[axes.first] = middle.x;
    at_[axes.second] = middle.y;
    machine_.begin_compensation_at(is_left != is_mirrored ? CutterSide::Left : CutterSide::Right,
                                   m.inset, at_);
    const auto follow = [&](OutlineMove move) { return cut(move, level, m.feed); };
    bool done = follow({middle, first.to, first.centre, first.turns});
    for (std::size_t i = 1; i < contour.outline.size() && done; ++i)
        done = follow(contour.outline[i]);
    done = done && follow({first.from, middle, first.centre, first.turns});
    Command command = make(cycle_span_);
    put(command, Code::G40);
    done = done && run(command);
    refresh();
    return done;
}

}  // namespace ncsim::gcode::klartext
