// SPDX-License-Identifier: GPL-3.0-or-later
#include "query/map_segments.h"

#include "geometry/tolerances.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace ncsim::brep {

namespace {

double turn(Vec2 a, Vec2 b, Vec2 c) {
    return cross(b - a, c - a);
}

double squared_distance(Vec2 p, const MapSegment& s) {
    const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
    const double length = dx * dx + dy * dy;
    double t = length > 0.0 ? ((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / length : 0.0;
    t = std::clamp(t, 0.0, 1.0);
    const double x = s.a.x + t * dx - p.x, y = s.a.y + t * dy - p.y;
    return x * x + y * y;
}

bool cross_each_other(const MapSegment& s, const MapSegment& t) {
    return (turn(s.a, s.b, t.a) > 0.0) != (turn(s.a, s.b, t.b) > 0.0) &&
           (turn(t.a, t.b, s.a) > 0.0) != (turn(t.a, t.b, s.b) > 0.0);
}

bool interfere(const MapSegment& s, const MapSegment& t, double clear) {
    const double near = clear * clear;
    // Adjacent segments share a point; the parts beyond that point must not overlap.
    const bool joined = s.to == t.from;
    const bool joined_back = t.to == s.from;
    const bool heads = s.from == t.from;
    const bool tails = s.to == t.to;
    if (joined || joined_back || heads || tails) {
        if (joined && joined_back) return false;
        const Vec2& s_far = joined || tails ? s.a : s.b;
        const Vec2& t_far = joined || heads ? t.b : t.a;
        return squared_distance(s_far, t) < near || squared_distance(t_far, s) < near;
    }
    return cross_each_other(s, t) || squared_distance(s.a, t) < near ||
           squared_distance(s.b, t) < near || squared_distance(t.a, s) < near ||
           squared_distance(t.b, s) < near;
}

double segment_distance(const MapSegment& s, const MapSegment& t) {
    if (cross_each_other(s, t)) return 0.0;
    return std::sqrt(std::min({squared_distance(s.a, t), squared_distance(s.b, t),
                               squared_distance(t.a, s), squared_distance(t.b, s)}));
}

// Splits a segment. For nearly circular curves, each half is off by a quarter of the whole's
// distance.
std::array<MapSegment, 2> halves_of(const FaceMap& map, const MapSegment& s) {
    const double middle = 0.5 * (s.begin + s.end);
    const Vec2 p = map(s.track->at(middle));
    MapSegment first = s, second = s;
    first.b = second.a = p;
    first.end = second.begin = middle;
    first.deviation = second.deviation =
        s.is_straight ? 0.0 : 0.5 * std::sqrt(squared_distance(p, s));
    return {first, second};
}

// Returns the sine of the angle between two chords.
double sine_between(const MapSegment& s, const MapSegment& t) {
    const double sx = s.b.x - s.a.x, sy = s.b.y - s.a.y, tx = t.b.x - t.a.x, ty = t.b.y - t.a.y;
    const double lengths = std::sqrt((sx * sx + sy * sy) * (tx * tx + ty * ty));
    return lengths > 0.0 ? std::abs(sx * ty - sy * tx) / lengths : 0.0;
}

// True if two pieces of curves without a common end come nearer than `clear`. Chords are halved
// until the result is clear; a segment outside the map counts as near. Pieces at an angle below
// `least_sine` may be near each other.
bool curves_interfere(const FaceMap& map, MapSegment s, MapSegment t, double clear, int depth,
                      double least_sine = 0.0) {
    if (!std::isfinite(s.deviation + t.deviation)) return true;
    if (segment_distance(s, t) >= s.deviation + t.deviation + clear) return false;
    if (depth == 0 || s.deviation + t.deviation <= 0.25 * clear)
        return segment_distance(s, t) < clear && sine_between(s, t) >= least_sine;
    if (s.deviation < t.deviation) std::swap(s, t);
    const auto [first, second] = halves_of(map, s);
    return curves_interfere(map, first, t, clear, depth - 1, least_sine) ||
           curves_interfere(map, second, t, clear, depth - 1, least_sine);
}

// Criterion for pieces of curves from a common point that meet again.
struct RepeatedContact {
    double clearance;       // mm: the pieces come nearer than this to each other,
    double least_sine;      // at an angle with at least this sine,
    double least_distance;  // mm: farther than this from the common point.
};
// Angle that CAD readers notice. At smaller angles, curves are tangent in their corner except for
// rounding.
constexpr RepeatedContact kCrossing{kRounding, 0.06, kLeastSizeMm};
// Any angle, far from the corner. Facets may leave a corner that stands for two; curves that miss
// only by rounding cross nearer to the corner.
constexpr RepeatedContact kCrossingElsewhere{kRounding, 0.0, 0.1};

// True if the pieces, which start in a common point, run apart: each stays within an angle about
// the chord, and the angles do not overlap. A circle leaves the chord by an angle of 4 height /
// length; the angle here is twice this value.
bool run_apart(const MapSegment& s, const MapSegment& t, const RepeatedContact& limits) {
    const double widths = 8.0 * (s.deviation / s.length() + t.deviation / t.length());
    return sine_between(s, t) > widths + limits.clearance / limits.least_distance;
}

// True if the pieces, which start in a common point, meet again. Next to facets, curves miss the
// vertices by more than the criterion; the piece left after all halvings is due to this gap.
bool meet_past_common_end(const FaceMap& map, const MapSegment& s, const MapSegment& t,
                          const RepeatedContact& limits, int halvings = 40) {
    if (halvings == 0) return false;
    const double sx = s.b.x - s.a.x, sy = s.b.y - s.a.y, tx = t.b.x - t.a.x, ty = t.b.y - t.a.y;
    const double near = limits.least_distance * limits.least_distance;
    const bool is_acute = sx * tx + sy * ty > 0.0;
    if (!is_acute || sx * sx + sy * sy < near || tx * tx + ty * ty < near) return false;
    if (run_apart(s, t, limits)) return false;
    const auto [s_near, s_far] = halves_of(map, s);
    const auto [t_near, t_far] = halves_of(map, t);
    const auto meet = [&](const MapSegment& one, const MapSegment& other) {
        return curves_interfere(map, one, other, limits.clearance, kMostSteps / 2,
                                limits.least_sine);
    };
    return meet(s_far, t_far) || meet(s_near, t_far) || meet(s_far, t_near) ||
           meet_past_common_end(map, s_near, t_near, limits, halvings - 1);
}

// Reverses the pieces so that both start in the common point.
bool neighbours_meet_again(const FaceMap& map, MapSegment s, MapSegment t,
                           const RepeatedContact& limits) {
    if (s.to == t.from && t.to == s.from) return false;
    const auto reverse = [](MapSegment& piece) {
        std::swap(piece.a, piece.b);
        std::swap(piece.begin, piece.end);
    };
    if (s.to == t.from || s.to == t.to) reverse(s);
    if (t.to == s.from || t.to == s.to) reverse(t);
    return meet_past_common_end(map, s, t, limits);
}

bool have_common_end(const MapSegment& s, const MapSegment& t) {
    return s.to == t.from || t.to == s.from || s.from == t.from || s.to == t.to;
}

// True if both are pieces of lines or circles of a plane. Contact near a common corner is decided
// on the curves of such pieces (arc_crossings.h): short chords of a small and a large circle that
// are tangent may overlap by chance.
bool are_plane_arcs(const FaceMap& map, const MapSegment& s, const MapSegment& t) {
    const auto is_arc = [](const MapSegment& piece) {
        return piece.is_straight || piece.track->circle() != nullptr;
    };
    return map.is_plane() && is_arc(s) && is_arc(t);
}

// Segments by the strips of x in which they lie. A face with a grid of holes has many segments at
// the same height, but few of them are near each other.
class Strips {
public:
    /// Requires: `segments` ascending by low(), with a longer lifetime than the strips.
    Strips(const std::vector<MapSegment>& segments, double clear)
        : segments_(segments), clear_(clear) {
        double right = -std::numeric_limits<double>::infinity();
        left_ = -right;
        for (const MapSegment& s : segments) {
            left_ = std::min(left_, s.left());
            right = std::max(right, s.right());
        }
        std::size_t count = segments.size() / 256 + 1;  // 256 segments in each strip
        const double width = (right - left_) / static_cast<double>(count);
        // A single strip is used if positions are not finite.
        const bool has_width = std::isfinite(width) && width > 0.0 && std::isfinite(1.0 / width);
        if (!has_width) count = 1;
        per_mm_ = has_width ? 1.0 / width : 0.0;
        members_.resize(count);
        first_.resize(count, 0);
        if (count == 1) {
            members_.front().resize(segments.size());
            std::iota(members_.front().begin(), members_.front().end(), 0U);
            return;
        }
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            const auto [first, last] = strips_of(segments[i], 0.0);
            for (std::size_t k = first; k <= last; ++k)
                members_[k].push_back(i);
        }
    }

    /// Writes the segments after `i` whose boxes come within the clearance of the box of `i`,
    /// ascending.
    /// Requires: `i` is not less than in the last call.
    void find(std::uint32_t i, std::vector<std::uint32_t>& others) {
        const MapSegment& s = segments_[i];
        others.clear();
        const auto [first, last] = strips_of(s, clear_);
        for (std::size_t k = first; k <= last; ++k) {
            const auto& members = members_[k];
            std::size_t& next = first_[k];
            while (next < members.size() && members[next] <= i)
                ++next;
            for (std::size_t m = next; m < members.size(); ++m) {
                const MapSegment& t = segments_[members[m]];
                if (t.low() > s.high() + clear_) break;
                if (t.right() < s.left() - clear_ || t.left() > s.right() + clear_) continue;
                others.push_back(members[m]);
            }
        }
        if (first == last) return;
        sort_unique(others);
    }

private:
    // Returns the first and the last strip of a segment; all strips if the segment has no finite
    // position.
    std::pair<std::size_t, std::size_t> strips_of(const MapSegment& s, double more) const {
        const std::size_t last = members_.size() - 1;
        const auto strip = [&](double x, std::size_t least_distance) {
            const double at = (x - left_) * per_mm_;
            if (!std::isfinite(at)) return least_distance;
            return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(last)));
        };
        return {strip(s.left() - more, 0), strip(s.right() + more, last)};
    }

    const std::vector<MapSegment>& segments_;
    double clear_, left_ = 0.0, per_mm_ = 0.0;
    std::vector<std::vector<std::uint32_t>> members_;
    std::vector<std::size_t> first_;  // For each strip: first member after `i`.
};

double distance_of(Vec2 p, Vec2 q) {
    return std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
}

// True if no point of the segment comes within `clear` of the circle.
bool is_clear_of(const FaceMap::Round& round, const MapSegment& s, double clear) {
    const double off = s.deviation + clear;
    return std::sqrt(squared_distance(round.centre, s)) > round.radius + off ||
           std::max(distance_of(round.centre, s.a), distance_of(round.centre, s.b)) + off <
               round.radius;
}

bool are_clear(const FaceMap::Round& a, const FaceMap::Round& b, double clear) {
    const double between = distance_of(a.centre, b.centre);
    return between > a.radius + b.radius + clear || between + clear < std::abs(a.radius - b.radius);
}

}  // namespace

std::optional<std::array<std::uint32_t, 2>> any_interfere(const FaceMap& map,
                                                          std::vector<MapSegment> segments,
                                                          double clear) {
    std::sort(segments.begin(), segments.end(),
              [](const MapSegment& s, const MapSegment& t) { return s.low() < t.low(); });
    const auto do_interfere = [&](const MapSegment& s, const MapSegment& t) {
        const bool both_straight = s.is_straight && t.is_straight;
        if (both_straight) return interfere(s, t, clear);
        // Chords of curves that are tangent in a common end may lie on each other. On cones, CAD
        // readers report a crossing.
        const RepeatedContact near_end{clear, 0.0, 0.05};
        const auto is_near = [&] {
            return interfere(s, t, clear) &&
                   (map.is_cone() ||
                    (std::min(s.length(), t.length()) < near_end.least_distance &&
                     !are_plane_arcs(map, s, t)) ||
                    neighbours_meet_again(map, s, t, near_end));
        };
        return have_common_end(s, t) ? is_near() || neighbours_meet_again(map, s, t, kCrossing) ||
                                           neighbours_meet_again(map, s, t, kCrossingElsewhere)
                                     : curves_interfere(map, s, t, clear, 40);
    };
    Strips strips(segments, clear);
    std::vector<std::uint32_t> others;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        const MapSegment& s = segments[i];
        strips.find(i, others);
        for (const std::uint32_t j : others) {
            if (do_interfere(s, segments[j])) return {{s.edge, segments[j].edge}};
        }
    }
    return std::nullopt;
}

std::vector<std::size_t> rounds_near_others(const std::vector<FaceMap::Round>& rounds,
                                            const std::vector<MapSegment>& segments, double clear) {
    if (rounds.empty()) return {};
    // A round is a point with a large deviation.
    std::vector<MapSegment> all = segments;
    for (std::uint32_t i = 0; i < rounds.size(); ++i) {
        const auto& [centre, radius, deviation] = rounds[i];
        all.push_back({centre, centre, 0, 0, nullptr, 0.0, 0.0, false, i, radius});
    }
    std::ranges::sort(all, {}, &MapSegment::low);
    std::vector<bool> is_near(rounds.size(), false);
    Strips strips(all, clear);
    std::vector<std::uint32_t> others;
    const auto is_round = [](const MapSegment& s) { return s.track == nullptr; };
    const auto mark = [&](const MapSegment& s) {
        if (is_round(s)) is_near[s.edge] = true;
    };
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        strips.find(i, others);
        for (const std::uint32_t j : others) {
            const MapSegment &s = all[i], &t = all[j];
            const bool both = is_round(s) && is_round(t);
            const bool any = is_round(s) || is_round(t);
            if (!any || (both          ? are_clear(rounds[s.edge], rounds[t.edge], clear)
                         : is_round(s) ? is_clear_of(rounds[s.edge], t, clear)
                                       : is_clear_of(rounds[t.edge], s, clear)))
                continue;
            mark(s);
            mark(t);
        }
    }
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        if (is_near[i]) near.push_back(i);
    }
    return near;
}

}  // namespace ncsim::brep
