// SPDX-License-Identifier: GPL-3.0-or-later
//
// Search for the cheapest stack of rings that approximates a profile.
#include "polytope/ring_walk.h"

#include "ncsim/base/vec2.h"
#include "ncsim/cda/lattice.h"

#include "polytope/integer_rounding.h"
#include "polytope/profile_fillet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ncsim::toolpath {

namespace {

// A point of the half-plane of profiles, in lattice units: x is the distance from the axis, y the
// height.
using Vec = Vec2;

constexpr double kUpright = 1e-9;
// A unit, by which heights are rounded, plus the rounding of doubles.
constexpr double kAlmost = 1 + 1e-6;
constexpr int kMaxRings = 512;  // per rounded corner

// A walk up to a ring.
struct Step {
    Ring ring;
    int before = -1;    // index of the step below
    double cost = 0.0;  // as in RingStack
    int corners = 0;
    std::size_t rings = 0;
    double error = 0.0;
    // Circumscribed: current point, and tangent to continue on. Inscribed: `turned` is the angle
    // reached on the arc.
    Vec at, d;
    double turned_degrees = 0.0;
    bool has_ring = false;
    bool is_divisible = false;  // the scale is a multiple of kDivisors
};

// Scales of coarser rings are also tried at multiples of this number, with many divisors that the
// scale of the next ring may share.
constexpr std::int64_t kDivisors = 12;
constexpr std::int64_t kLeastShared = 16;  // least common factor worth trying

// Search for the cheapest stack of rings along a profile.
//
// Circumscribed: the polygon of a ring holds the round section if the polygon's inner circle does,
// so the radii of the inner circles, over the heights, have to lie on or outside the profile.
// Around a rounded corner the radii lead from tangent to tangent of the arc. How far a ring may lie
// along a tangent is limited by the corners of the polygon, which lie farther out. A radius has to
// be a multiple of the polygon's radius; this costs nothing, because the height is free. Inscribed:
// the tangents touch a smaller arc about the same centre, and the corners do not lie outside the
// arc.
//
// The polygon of the next ring is a choice: fine polygons reach farther, coarse polygons have fewer
// facets. A walk is kept for the next ring unless a second walk is at least equal in both the cost
// and the angle reached.
//
// Edges between two rings have short directions if heights and scales have a large common factor:
// (X, Y, h/k) between equal polygons with the corner (X, Y) whose scales differ by k, if the height
// h is a multiple of k. So heights are moved outwards to such multiples, by less than k units, and
// the tangent from the moved corner continues the walk. Between different polygons both scales and
// the height need a common factor; such scales are tried, too.
class Walks {
public:
    Walks(const std::vector<RingPolygon>& family, Side side, const ToleranceBand& band,
          const StackLimits& limits)
        : family_(family),
          side_(side),
          seeks_short_directions_(side != Side::Inscribed && !limits.turns),
          costs_(family, side, seeks_short_directions_),
          limits_(limits),
          tolerance_(std::max(band.inside, band.outside)),
          inset_(band.inside > 0 ? band.inside - 1 - kAlmost : 0.0),
          excess_(band.outside > 0 ? band.outside - 1 - kAlmost : 0.0),
          most_common_(std::max<std::int64_t>(1, round_down(tolerance_ / 4))),
          most_moved_(std::max<std::int64_t>(1, round_down(tolerance_ / 8))) {
        const auto& corners = family[0].corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto& [x, y] = corners[i];
            const auto& [u, v] = corners[(i + 1) % corners.size()];
            longest_ = std::max({longest_, std::abs(u - x), std::abs(v - y)});
            widest_ = std::max(widest_, std::abs(x * v - y * u));
        }
        steps_.emplace_back();
        current_walks_ = {0};
    }

    std::optional<RingStack> operator()(const std::vector<ProfilePoint>& profile, double unit_mm) {
        const std::vector<Vec> points = corners_of(profile, unit_mm);
        // Parts show the floors of flat ends, not their rims. Balls that are round above, too, cut
        // few surfaces.
        if (profile.front().fillet < profile.front().radius) costs_.ignore_slopes();
        if (profile.back().fillet > 0) costs_.count_facets_only();
        for (std::size_t i = 0; i < profile.size(); ++i) {
            const Vec from = previous_point(points, i);
            const Vec to = next_point(points, i);
            const Fillet f = fillet_of(from, points[i], to, profile[i].fillet / unit_mm);
            // Rounding a straight corner leaves it straight.
            constexpr double kLeastTurn = 1e-6;  // degrees
            if (f.rho <= 0 || !(f.turn_degrees > kLeastTurn)) {
                add_corner(points[i], from, to, i + 1 == points.size());
            } else if (outside()) {
                walk_arc(f);
            } else {
                walk_inside_arc(f);
            }
            if (current_walks_.empty()) return std::nullopt;
        }
        const int best = *std::ranges::min_element(current_walks_, [this](int a, int b) {
            return std::pair(at(a).cost, at(a).error) < std::pair(at(b).cost, at(b).error);
        });
        RingStack stack;
        stack.cost = at(best).cost;
        stack.corners = at(best).corners;
        stack.error = at(best).error;
        for (int i = best; at(i).has_ring; i = at(i).before)
            stack.rings.push_back(at(i).ring);
        std::ranges::reverse(stack.rings);
        return stack;
    }

private:
    const Step& at(int i) const { return steps_[static_cast<std::size_t>(i)]; }
    bool outside() const { return side_ != Side::Inscribed; }

    // Returns the radius of the circle that must be correct: outside, the polygon's inner circle;
    // inside, the outer circle.
    double radius_of(std::size_t polygon) const {
        return outside() ? family_[polygon].inner : family_[polygon].outer;
    }
    std::int64_t scale_of(double radius, std::size_t polygon) const {
        const double b = radius_of(polygon);
        return outside() ? round_up(radius / b) : std::max<std::int64_t>(0, round_down(radius / b));
    }

    // Returns the height of a ring on top of a narrower ring, moved down (up) by less than the
    // second returned number, so that the normals of the facets between both rings have
    // kNormalBits. Let (x, y) be a side of the polygon and A twice the area of the side's triangle
    // about the axis. A strip k multiples wide and h high has the normal (y h, -x h, A k), divided
    // by the common factor of h and k.
    std::pair<std::int64_t, std::int64_t> exact_height(const Step& under, std::int64_t scale,
                                                       std::int64_t height, bool up) const {
        const std::int64_t wide = scale - under.ring.scale;
        const std::int64_t high = height - under.ring.height;
        if (!under.has_ring || (under.ring.scale > 0 && under.ring.polygon != 0))
            return {height, 1};
        if (wide <= 0 || high <= 0) return {height, 1};
        constexpr std::int64_t kMost = std::int64_t{1} << cda::kNormalBits;
        for (std::int64_t common = 1; common <= std::min(most_common_, wide); ++common) {
            if (wide % common != 0) continue;
            const std::int64_t times = high / common + (up && high % common != 0 ? 1 : 0);
            if (times < 1) break;
            if (times <= kMost / longest_ && wide / common <= kMost / widest_)
                return {under.ring.height + times * common, common};
        }
        return {height, 1};
    }

    // Returns `height` for a ring on the line along d, moved outwards to a multiple of the step of
    // the scales, or of a divisor of this step, above the ring below.
    double snap_height(const Step& under, std::size_t polygon, std::int64_t scale, double height,
                       Vec d) const {
        if (!seeks_short_directions_ || !under.has_ring || std::abs(d.x) <= kUpright) return height;
        const std::int64_t step = StripCosts::scale_step(under.ring, {polygon, scale, 0});
        if (step <= 1) return height;
        std::int64_t factor = std::min(step, most_moved_);
        while (step % factor != 0)
            --factor;
        const double times =
            (height - static_cast<double>(under.ring.height)) / static_cast<double>(factor);
        return static_cast<double>(under.ring.height +
                                   factor * (d.x > 0 ? round_down(times) : round_up(times)));
    }

    // Adds a ring. Its height is rounded outwards: down on the lower side of the tool, up at the
    // upper end.
    int add(int before, std::size_t polygon, std::int64_t scale, double height, bool upper_end,
            double error) {
        const Step& under = at(before);
        const bool up = upper_end == outside();
        Step step;
        step.ring = {scale == 0 ? 0 : polygon, scale, up ? round_up(height) : round_down(height)};
        step.before = before;
        step.has_ring = true;
        step.error = std::max(under.error, error);
        const int sides = family_[polygon].sides;
        step.corners = under.corners + (scale == 0 ? 1 : sides);
        step.rings = under.rings + 1;
        step.is_divisible = seeks_short_directions_ && polygon != 0 && scale % kDivisors == 0;
        step.cost = under.cost + (under.has_ring ? costs_.strip(under.ring, step.ring) : 0.0);
        steps_.push_back(step);
        return static_cast<int>(steps_.size()) - 1;
    }

    // True if the polygon may follow. An upright part keeps its polygon, so that it is a cylinder.
    bool may_follow(int before, std::size_t polygon, bool upright) const {
        const Step& under = at(before);
        return !upright || !under.has_ring || under.ring.scale == 0 ||
               under.ring.polygon == polygon;
    }

    // True if the ring after `step` may have the polygon.
    bool is_in_pattern(int step, std::size_t polygon) const {
        if (!limits_.pattern) return true;
        const std::size_t ring = at(step).rings;
        return ring < limits_.pattern->size() && (*limits_.pattern)[ring].polygon == polygon;
    }

    bool is_within_limits(const Step& step) const {
        return step.corners <= limits_.corners && step.cost <= limits_.cost;
    }

    // Keeps the cheapest walk of all walks that end here with the same polygon.
    void keep_cheapest(std::vector<int>& there, int step) const {
        if (!is_within_limits(at(step))) return;
        for (int& other : there) {
            if (at(other).ring.polygon != at(step).ring.polygon) continue;
            if (std::pair(at(step).cost, at(step).error) <
                std::pair(at(other).cost, at(other).error)) {
                other = step;
            }
            return;
        }
        there.push_back(step);
    }

    // Adds a corner without rounding. A rim between a cone and a disc gets two rings: rounding the
    // rim for the disc would move the cone inwards, so the cone leads to the height rounded the
    // opposite way. The same holds where two cones meet.
    void add_corner(Vec p, Vec before, Vec after, bool upper_end) {
        constexpr std::size_t kFinest = 0;
        const std::int64_t scale = scale_of(p.x, kFinest);
        const auto multiple = static_cast<double>(scale);
        const double error = 2 + (outside() ? multiple * family_[kFinest].outer - p.x
                                            : p.x - multiple * family_[kFinest].inner);
        const bool ends_a_cone = before.x < p.x && before.y < p.y;
        const bool begins_a_cone = after.x < p.x && after.y > p.y;
        const bool is_both = upper_end ? ends_a_cone : begins_a_cone;
        const bool upright = std::abs(p.x - before.x) <= kUpright;
        std::vector<int> there;
        for (const int under : current_walks_) {
            if (scale != 0 && !may_follow(under, kFinest, upright)) continue;
            const bool is_rim = outside() && is_both;
            const bool is_upper = upper_end && !is_rim;
            // Inscribed, an upper end that is rounded down would let the cone protrude.
            const bool up = is_upper == outside();
            const auto [height, step] =
                is_upper ? std::pair{up ? round_up(p.y) : round_down(p.y), std::int64_t{1}}
                         : exact_height(at(under), scale, up ? round_up(p.y) : round_down(p.y), up);
            const double off = error + static_cast<double>(step - 1);
            const int ring = add(under, kFinest, scale, static_cast<double>(height), is_upper, off);
            const bool is_beyond = is_rim && height < round_up(p.y);
            keep_cheapest(there, is_beyond ? add(ring, kFinest, scale, p.y, true, off) : ring);
        }
        current_walks_ = std::move(there);
    }

    // Walks that continue around the same arc and that no second walk beats.
    struct Front {
        std::vector<int> steps;
        static bool beats(const Step& a, const Step& b) {
            return a.ring.polygon == b.ring.polygon && a.has_ring == b.has_ring &&
                   a.cost <= b.cost && a.is_divisible >= b.is_divisible &&
                   a.turned_degrees >= b.turned_degrees;
        }
        bool admit(const Walks& walks, int step) {
            const Step& a = walks.at(step);
            if (!walks.is_within_limits(a)) return false;
            if (std::ranges::any_of(steps, [&](int other) { return beats(walks.at(other), a); })) {
                return false;
            }
            std::erase_if(steps, [&](int other) { return beats(a, walks.at(other)); });
            steps.push_back(step);
            return true;
        }
    };

    // Walks around a rounded corner, with rings of all polygons at each place. A copy of the step
    // below is the start.
    template <class Next>
    void walk(const Fillet& f, const Next& next) {
        std::vector<int> there;
        std::vector<int> now;
        for (const int under : current_walks_) {
            Step start = at(under);
            start.at = f.start;
            start.d = f.d1;
            start.turned_degrees = 0.0;
            steps_.push_back(start);
            now.push_back(static_cast<int>(steps_.size()) - 1);
        }
        Front front;
        for (int ring = 0; ring < kMaxRings && !now.empty(); ++ring) {
            Front coming;
            for (const int step : now) {
                for (std::size_t polygon = 0; polygon < family_.size(); ++polygon) {
                    if (is_in_pattern(step, polygon)) next(step, polygon, coming, there);
                }
            }
            now.clear();
            for (const int step : coming.steps) {
                if (front.admit(*this, step)) now.push_back(step);
            }
        }
        current_walks_ = std::move(there);
    }

    // Returns how far the farthest corners of a ring lie outside the arc.
    double excess_of(const Fillet& f, Vec p, std::size_t polygon) const {
        const double stretched = p.x * (family_[polygon].outer / family_[polygon].inner);
        return norm(Vec{stretched, p.y} - f.centre) - f.rho;
    }

    // Adds rings on the tangent, as far along as their corners may lie outside, but not beyond the
    // end.
    void follow_tangent(const Fillet& f, int step, std::size_t polygon, Front& coming) {
        const Vec from = at(step).at;
        const Vec d = at(step).d;
        const bool upright = std::abs(d.x) <= kUpright;
        if (!may_follow(step, polygon, upright) || !is_worth_following(step, polygon, d)) return;
        const double b = family_[polygon].inner;
        const double stretch = family_[polygon].outer / b;
        const double reach = f.rho + excess_;
        if (upright) {
            // There is a single radius only, so the height is free.
            const std::int64_t scale = scale_of(from.x, polygon);
            Vec p;
            p.x = static_cast<double>(scale) * b;
            const double x = p.x * stretch - f.centre.x;
            if (x >= reach) return;
            p.y = f.centre.y + std::sqrt(reach * reach - x * x);
            // The end line, which is not upright, also limits the height.
            p.y = std::min(p.y, f.end.y + (p.x - f.end.x) / f.d2.x * f.d2.y);
            add_on_tangent(f, step, polygon, scale, p, coming);
            return;
        }
        // The point from + t d, stretched, is at the distance `reach` from the centre.
        const Vec u{from.x * stretch - f.centre.x, from.y - f.centre.y};
        const Vec v{d.x * stretch, d.y};
        const double half = dot(u, v) / dot(v, v);
        const double under = half * half - (dot(u, u) - reach * reach) / dot(v, v);
        if (under <= 0) return;
        const double t = -half + std::sqrt(under);
        const double end = f.meet_end_line(from, d).x;
        const double radius =
            d.x > 0 ? std::min(from.x + t * d.x, end) : std::max(from.x + t * d.x, end);
        if (radius <= 0) return;
        const std::int64_t scale = d.x > 0 ? round_down(radius / b) : round_up(radius / b);
        if (!seeks_short_directions_) {
            add_on_tangent(f, step, polygon, scale, coming);
            return;
        }
        // Moving the height may move the corners too far out, so that the ring must be nearer.
        constexpr int kTries = 3;
        const auto add_nearer = [&](std::int64_t first, std::int64_t nearer) {
            for (int i = 0; i < kTries; ++i) {
                const std::int64_t s = d.x > 0 ? first - i * nearer : first + i * nearer;
                if (add_on_tangent(f, step, polygon, s, coming)) return;
            }
        };
        add_nearer(scale, 1);
        const std::int64_t divisible = nearer_multiple(scale, kDivisors, d);
        if (polygon != 0 && scale >= 10 * kDivisors && divisible != scale)
            add_nearer(divisible, kDivisors);
        const std::int64_t shared = shared_scale(step, polygon, scale);
        if (shared > 0 && shared != scale) add_on_tangent(f, step, polygon, shared, coming);
    }

    // True unless the polygon gets coarser where the tool gets wider or vice versa, or the limit of
    // cost is exceeded. Applies to walks with short directions.
    bool is_worth_following(int step, std::size_t polygon, Vec d) const {
        const Ring& under = at(step).ring;
        if (!seeks_short_directions_ || !at(step).has_ring || under.scale == 0) return true;
        const int below = family_[under.polygon].sides, above = family_[polygon].sides;
        const bool is_gradual = d.x > 0 ? above % below == 0 : below % above == 0;
        return is_gradual && at(step).cost + std::max(below, above) <= limits_.cost;
    }

    // Returns the multiple of `factor` next to `scale` that is nearer along d.
    static std::int64_t nearer_multiple(std::int64_t scale, std::int64_t factor, Vec d) {
        return (d.x > 0 ? scale : scale + factor - 1) / factor * factor;
    }

    // Returns the farthest scale, at most `scale`, with which the edges from a ring of a different
    // polygon have short directions, or 0.
    std::int64_t shared_scale(int step, std::size_t polygon, std::int64_t scale) const {
        const Ring& under = at(step).ring;
        if (!at(step).has_ring || under.scale == 0 || under.polygon == polygon) return 0;
        const Vec d = at(step).d;
        std::int64_t best = 0;
        for (std::int64_t parts = 1; parts * kLeastShared <= under.scale; ++parts) {
            if (under.scale % parts != 0) continue;
            const std::int64_t s = nearer_multiple(scale, under.scale / parts, d);
            if (s <= 0 || (best > 0 && (d.x > 0 ? s <= best : s >= best))) continue;
            const auto height = static_cast<std::int64_t>(point_on_tangent(step, polygon, s).y);
            if (costs_.has_short_directions(under, {polygon, s, height})) best = s;
        }
        return best;
    }

    // Returns the point with a scale on the tangent, with the height of a ring.
    Vec point_on_tangent(int step, std::size_t polygon, std::int64_t scale) const {
        const Vec from = at(step).at;
        const Vec d = at(step).d;
        Vec p;
        p.x = static_cast<double>(scale) * family_[polygon].inner;
        p.y = from.y + (p.x - from.x) / d.x * d.y;
        if (outside()) p.y = snap_height(at(step), polygon, scale, round_outward(p.y, d), d);
        return p;
    }

    bool add_on_tangent(const Fillet& f, int step, std::size_t polygon, std::int64_t scale,
                        Front& coming) {
        return scale > 0 && add_on_tangent(f, step, polygon, scale,
                                           point_on_tangent(step, polygon, scale), coming);
    }

    // Adds a ring at the point `p` of the tangent unless it makes no progress or is too far out.
    bool add_on_tangent(const Fillet& f, int step, std::size_t polygon, std::int64_t scale, Vec p,
                        Front& coming) {
        const Vec d = at(step).d;
        p.y = outside() ? round_outward(p.y, d) : round_inward(p.y, f);
        // A ring that is not beyond the tangent's contact with the arc makes no progress.
        if (dot(p - f.centre, d) <= 0) return false;
        Vec next = tangent_from(f, p);
        // The end is nearer.
        if (inset_ > 0 && f.angle_to(next) >= f.turn_degrees) next = normalized(f.end - p);
        const double degrees = f.angle_to(next);
        if (degrees <= at(step).turned_degrees || degrees >= f.turn_degrees) return false;
        const double error = std::max(f.rho - contact_radius(f), excess_of(f, p, polygon)) + 1;
        if (error > tolerance_) return false;
        const bool is_upper = outside() ? d.x <= kUpright : p.y > f.centre.y;
        const int ring = add(step, polygon, scale, p.y, is_upper, error);
        walk_line(ring, p, next, degrees);
        coming.admit(*this, ring);
        return true;
    }

    void walk_line(int ring, Vec p, Vec d, double degrees) {
        Step& made = steps_[static_cast<std::size_t>(ring)];
        made.at = p;
        made.d = d;
        made.turned_degrees = degrees;
        if (!seeks_short_directions_) return;
        const double turn = (degrees - at(made.before).turned_degrees) * (std::numbers::pi / 180);
        made.cost += costs_.visible(d, family_[made.ring.polygon].sides * turn);
    }

    static double round_inward(double height, const Fillet& f) {
        return static_cast<double>(height > f.centre.y ? round_down(height) : round_up(height));
    }

    // Returns the radius of the arc that the facets touch.
    double contact_radius(const Fillet& f) const { return std::max(f.rho - inset_, 0.5 * f.rho); }

    // Returns the tangent direction at `p` of the arc to touch. Requires: `p` is not within the
    // arc's circle.
    Vec tangent_from(const Fillet& f, Vec p) const {
        const double rho = contact_radius(f);
        const Vec w = p - f.centre;
        const double squared = dot(w, w);
        const double length = std::sqrt(std::max(0.0, squared - rho * rho));
        return (1 / squared) * (-length * w + rho * left_normal(w));
    }

    // Rounds a height to the lattice, outwards of the line that the point lies on.
    static double round_outward(double height, Vec line) {
        return static_cast<double>(line.x > kUpright ? round_down(height) : round_up(height));
    }

    // --- Circumscribed ---

    void walk_arc(const Fillet& f) {
        walk(f, [&](int step, std::size_t polygon, Front& coming, std::vector<int>& there) {
            end_tangents(f, step, polygon, there);
            follow_tangent(f, step, polygon, coming);
        });
    }

    // Ends the arc. The last corner must not lie inside the line along d2: where the tool gets
    // narrower, the corner lies on that line, farther out; otherwise on the tangent, farther on.
    void end_tangents(const Fillet& f, int step, std::size_t polygon, std::vector<int>& there) {
        const Vec from = at(step).at;
        Vec d = at(step).d;
        Vec meeting = f.meet_end_line(from, d);
        // The tangent of a smaller arc may lie inside the line that follows. The start of that line
        // is then the limit.
        if (inset_ > 0 && dot(meeting - f.end, f.d2) > 0) {
            meeting = f.end;
            d = normalized(f.end - from);
        }
        const bool upright = std::abs(f.d2.x) <= kUpright || std::abs(d.x) <= kUpright;
        if (upright && polygon != 0) return;
        const double b = family_[polygon].inner;
        std::int64_t scale = 0;
        Vec p;
        if (d.x <= kUpright && f.d2.x < -kUpright) {
            scale = scale_of(std::clamp(meeting.x, 0.0, from.x), polygon);
            p.x = static_cast<double>(scale) * b;
            p.y = f.end.y + (p.x - f.end.x) / f.d2.x * f.d2.y;
        } else if (std::abs(d.x) <= kUpright) {
            return;
        } else {
            // Repeated while the height, rounded outwards for the first line, is inside the second
            // line.
            scale = scale_of(meeting.x, polygon) - 1;
            do {
                p.x = static_cast<double>(++scale) * b;
                p.y = round_outward(from.y + (p.x - from.x) / d.x * d.y, d);
                p.y = snap_height(at(step), polygon, scale, p.y, d);
            } while (f.d2.x < -kUpright && cross(f.d2, p - f.end) > 0);
            // A ring as wide as an upright part that follows may end at the start of that part,
            // because the upper end of that part may be the upper end of the tool.
            if (std::abs(f.d2.x) <= kUpright) p.y = std::min(p.y, f.end.y);
        }
        if (!may_follow(step, polygon, std::abs(d.x) <= kUpright)) return;
        const double error = std::max(f.rho - contact_radius(f), excess_of(f, p, polygon)) + 1;
        if (error > tolerance_) return;
        keep_cheapest(there, add(step, polygon, scale, p.y, d.x <= kUpright, error));
    }

    // --- Inscribed ---

    void walk_inside_arc(const Fillet& f) {
        walk(f, [&](int step, std::size_t polygon, Front& coming, std::vector<int>& there) {
            if (at(step).turned_degrees == 0.0) {
                begin_arc(f, step, polygon, coming);
                return;
            }
            end_arc(f, step, polygon, there);
            follow_tangent(f, step, polygon, coming);
        });
    }

    // Starts the arc back along d1, so that the lower end keeps its height.
    void begin_arc(const Fillet& f, int step, std::size_t polygon, Front& coming) {
        constexpr double kBegun = 1e-12;
        const std::int64_t scale = scale_of(f.start.x, polygon);
        if (scale == 0 && polygon != 0) return;
        const bool upright = std::abs(f.d1.x) <= kUpright;
        if (!may_follow(step, polygon, upright)) return;
        const double radius = static_cast<double>(scale) * family_[polygon].outer;
        const bool moves = f.d1.x > kUpright;
        const double back = moves ? (f.start.x - radius) / f.d1.x * f.d1.y : 0.0;
        const double height = round_inward(f.start.y - back, f);
        const Vec side{static_cast<double>(scale) * family_[polygon].inner, height};
        const double within = cross(f.d1, side - f.start);
        if (within + 2 > tolerance_) return;
        const int ring = add(step, polygon, scale, height, f.start.y > f.centre.y, within + 2);
        // Small arcs may be skipped completely.
        const bool is_near = within <= f.rho - contact_radius(f);
        const Vec d = is_near ? tangent_from(f, side) : normalized(f.end - side);
        walk_line(ring, side, d, std::max(kBegun, f.angle_to(d)));
        coming.admit(*this, ring);
    }

    void end_arc(const Fillet& f, int step, std::size_t polygon, std::vector<int>& there) {
        const bool upright = std::abs(f.d2.x) <= kUpright;
        if (upright && polygon != 0) return;
        const std::int64_t scale = scale_of(f.end.x, polygon);
        if (scale == 0 && polygon != 0) return;
        const double radius = static_cast<double>(scale) * family_[polygon].outer;
        const double x = radius - f.centre.x;
        const double rise = std::sqrt(std::max(0.0, f.rho * f.rho - x * x));
        const bool upper = f.end.y > f.centre.y;
        const double height =
            round_inward(upright ? f.end.y : f.centre.y + (upper ? rise : -rise), f);
        const Vec from = at(step).at;
        const Vec side{static_cast<double>(scale) * family_[polygon].inner, height};
        // Distance of the facets between both rings from the arc.
        const double depth = f.rho - cross(from - f.centre, normalized(side - from));
        const double error = std::max(depth, std::abs(f.end.x - side.x)) + 2;
        if (error > tolerance_) return;
        const double all = std::max(error, f.rho - contact_radius(f) + 2);
        keep_cheapest(there, add(step, polygon, scale, height, upper, all));
    }

    const std::vector<RingPolygon>& family_;
    Side side_;
    bool seeks_short_directions_;
    StripCosts costs_;
    StackLimits limits_;
    double tolerance_;
    double inset_;              // largest depth of facets within the arc
    double excess_;             // largest distance of corners outside the arc
    std::int64_t most_common_;  // heights are moved by less to get normals that fit
    std::int64_t most_moved_;   // heights are moved by less to get short directions
    // For the finest polygon: largest component of a side; largest doubled area of a side's
    // triangle about the centre.
    std::int64_t longest_ = 1, widest_ = 1;
    std::vector<Step> steps_;
    std::vector<int> current_walks_;  // walks to continue
};

}  // namespace

std::optional<RingStack> ring_stack(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                                    Side side, double unit_mm, const ToleranceBand& band,
                                    const StackLimits& limits) {
    return Walks(family, side, band, limits)(piece.profile, unit_mm);
}

}  // namespace ncsim::toolpath
