// SPDX-License-Identifier: GPL-3.0-or-later
//
// Approximation of round tools by polytopes. Each ring of a polytope is a multiple of a polygon
// with integer corners around (or in) the circle of integer radius b, at an integer height; so the
// strips between two rings are exactly planar trapezoids with parallel sides, and triangles.
// Polygons: ring_polygon.h; sequence of rings: ring_walk.h. This file chooses the number of sides
// and b for the least cost within the tolerance.
#include "ncsim/toolpath/tool_polytope.h"

#include "polytope/integer_rounding.h"
#include "polytope/mean_excess.h"
#include "polytope/ring_polygon.h"
#include "polytope/ring_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

namespace ncsim::toolpath {

namespace {

using cda::LatticePoint;

constexpr int kMinSides = 16;
constexpr int kMaxSides = 1024;
// A tool with more corners would take hours to move. Finer tools are not needed: a ball of 100 mm
// is within 10 µm.
constexpr int kMaxCorners = 8192;

double largest_radius(const ToolPiece& piece) {
    double r = 0.0;
    for (const ProfilePoint& p : piece.profile)
        r = std::max(r, p.radius);
    return r;
}

bool has_fillet(const ToolPiece& piece) {
    return std::any_of(piece.profile.begin(), piece.profile.end(),
                       [](const ProfilePoint& p) { return p.fillet > 0; });
}

// Radii worth trying for the base polygon, for a tool of `radius` units. If all rings are equal (or
// points), the radius itself. Otherwise its divisors of a size at which both the rounding of the
// polygon and the coarse steps of radii are small; without such divisors, numbers that nearly
// divide the radius.
struct BaseCandidates {
    std::vector<std::int64_t> first;
    std::vector<std::int64_t> more;  // near divisors of all sizes
};

// Returns the base radius for a piece with a cone and a single radius besides tips: the largest
// divisor of the radius for which facets of cones have normals of kNormalBits (exact_height in
// ring_walk.cpp) and so meet exactly in their corners. If no divisor is fine enough, a number that
// divides the radius up to a rest of at most nine units; failing that, the radius itself.
std::int64_t base_of_cone(const ToolPiece& piece, std::int64_t radius, Side side) {
    bool has_cone = false;
    double slope = 1.0;  // height over width of a cone, at least 1
    for (std::size_t i = 1; i < piece.profile.size(); ++i) {
        const double wide = piece.profile[i].radius - piece.profile[i - 1].radius;
        const double high = piece.profile[i].height - piece.profile[i - 1].height;
        if (!(wide > 0) || !(high > 0)) continue;
        has_cone = true;
        slope = std::max(slope, high / wide);
    }
    if (!has_cone) return radius;
    constexpr double kLongestSide = 0.4;  // for kMinSides, in radii
    constexpr std::int64_t kFineEnough = 1000;
    const auto most = static_cast<std::int64_t>(
        std::sqrt(std::ldexp(1.0, cda::kNormalBits) / (kLongestSide * slope)));
    constexpr std::int64_t kMostOff = 9;
    std::pair<std::int64_t, std::int64_t> best{kMostOff + 1, radius};
    for (std::int64_t b = std::min(most, radius - 1); b >= kFineEnough && best.first > 0; --b) {
        const std::int64_t rest = radius % b;
        const std::int64_t off = side != Side::Inscribed ? (b - rest) % b : rest;
        if (off < best.first) best = {off, b};
    }
    return best.second;
}

BaseCandidates base_candidates(const ToolPiece& piece, std::int64_t radius, double unit_mm,
                               Side side) {
    bool one_ring = !has_fillet(piece);
    for (const ProfilePoint& p : piece.profile) {
        const double r = p.radius / unit_mm;
        const std::int64_t rounded = side != Side::Inscribed ? round_up(r) : round_down(r);
        one_ring = one_ring && (rounded == 0 || rounded == radius);
    }
    if (one_ring) {
        const std::int64_t b = base_of_cone(piece, radius, side);
        return b < radius ? BaseCandidates{{b}, {radius}} : BaseCandidates{{radius}, {}};
    }
    const double root = std::sqrt(static_cast<double>(radius));
    const auto low = std::max<std::int64_t>(1, static_cast<std::int64_t>(root / 2));
    const auto high = std::max(static_cast<std::int64_t>(root * 2), radius / 200);
    constexpr std::int64_t kFarthest = std::numeric_limits<std::int64_t>::max();
    BaseCandidates candidates;
    std::pair<std::int64_t, std::int64_t> nearest{kFarthest, 1};
    // A single candidate per size class, from `begin` to a third more, is enough.
    std::pair<std::int64_t, std::int64_t> nearest_here{kFarthest, 1};
    std::int64_t begin = low;
    const auto end_size = [&] {
        if (static_cast<double>(nearest_here.first) < root / 2)
            candidates.more.push_back(nearest_here.second);
        nearest_here.first = kFarthest;
    };
    for (std::int64_t b = low; b <= high; ++b) {
        if (3 * b >= 4 * begin) {
            end_size();
            begin = b;
        }
        const std::int64_t rest = radius % b;
        std::vector<std::int64_t>& exact = candidates.first;
        if (rest == 0 && (exact.empty() || 3 * b >= 4 * exact.back())) exact.push_back(b);
        const std::int64_t off = side != Side::Inscribed ? (b - rest) % b : rest;
        nearest = std::min(nearest, {off, b});
        nearest_here = std::min(nearest_here, {off, b});
    }
    end_size();
    if (candidates.first.empty()) candidates.first.push_back(nearest.second);
    return candidates;
}

std::vector<LatticePoint> points_of(const std::vector<RingPolygon>& family,
                                    const std::vector<Ring>& rings) {
    std::vector<LatticePoint> points;
    for (const Ring& ring : rings) {
        for (const auto& [x, y] : family[ring.polygon].corners) {
            points.push_back({ring.scale * x, ring.scale * y, ring.height});
            if (ring.scale == 0) break;  // a tip is a single point
        }
    }
    return points;
}

// The cheapest known stack of rings.
struct Choice {
    std::vector<RingPolygon> family;
    RingStack stack;

    bool is_there() const { return !family.empty(); }
    int sides() const { return family.front().sides; }
};

// Search over the numbers of sides and over some radii of the base polygon.
class Search {
public:
    Search(const ToolPiece& piece, std::int64_t radius, double unit_mm, Side side, bool turns)
        : piece_(piece),
          radius_(static_cast<double>(radius)),
          unit_mm_(unit_mm),
          side_(side),
          is_rounded_(has_fillet(piece)),
          is_fair_(is_rounded_ && side == Side::Fair),
          turns_(turns),
          candidates_(base_candidates(piece, radius, unit_mm, side)) {
        if (!is_rounded_) return;
        constexpr std::size_t kEnough = 12;
        thin_out(candidates_.first, kEnough);
        thin_out(candidates_.more, kEnough);
    }

    // Returns the best choice within `tolerance` (lattice units), or as near to it as possible.
    Choice operator()(double tolerance) {
        tolerance_ = std::max(tolerance, least_tolerance());
        // A tolerance too fine for the lattice, or for the number of corners, is increased.
        constexpr double kCoarser = 1.2;
        constexpr std::size_t kFew = 4;
        for (;; tolerance_ *= kCoarser) {
            if (is_rounded_ && tolerance_ > tolerance) {
                thin_out(candidates_.first, kFew);
                thin_out(candidates_.more, kFew);
            }
            try_all(candidates_.first);
            // All divisors of the largest radius may be too coarse for the remaining radii.
            if (!is_met()) try_all(candidates_.more);
            if (best_.choice.is_there() && (is_met() || !is_rounded_)) break;
            if (tolerance_ > radius_) break;
        }
        if (!is_rounded_ || !best_.choice.is_there()) return std::move(best_.choice);
        if (!is_fair_ || turns_) equalise_strips();
        if (is_fair_) turns_ ? balance_by_depth() : balance();
        return std::move(best_.choice);
    }

private:
    // Keeps some of the radii; this is enough because heights are free.
    static void thin_out(std::vector<std::int64_t>& radii, std::size_t enough) {
        while (radii.size() > enough) {
            std::size_t kept = 0;
            for (std::size_t i = 1; i < radii.size(); i += 2)
                radii[kept++] = radii[i];
            radii.resize(kept);
        }
    }

    // A choice with the share of its depth by which corners lie outside, and its bias.
    struct Candidate {
        Choice choice;
        double share = 0.0;
        double bias = 0.0;
    };

    bool is_met() const {
        return best_.choice.is_there() && best_.choice.stack.error <= tolerance_;
    }
    // True if only cheaper choices are better.
    bool is_met_without_bias() const { return is_met() && is_nearly_balanced(best_.bias); }

    double cost(const RingStack& stack) const { return is_rounded_ ? stack.cost : stack.corners; }

    void try_all(const std::vector<std::int64_t>& radii) {
        // With many more sides than necessary, strips become too narrow.
        const int most =
            is_rounded_ ? std::min(kMaxSides, 2 * least_sides() + kMinSides) : kMaxSides;
        for (int sides = kMinSides; sides <= most; sides += step_after(sides)) {
            // With so many sides, even a single ring besides the tips costs more than the best
            // stack.
            if (is_met_without_bias() && (is_rounded_ ? 1 : 2) * sides > cost(best_.choice.stack))
                break;
            const std::vector<double> cosines = corner_cosines(sides);
            for (const std::int64_t b : radii) {
                const RingPolygon finest = ring_polygon(b, cosines, side_);
                const double azimuth = side_ != Side::Inscribed
                                           ? finest.outer / static_cast<double>(b) - 1
                                           : 1 - finest.inner / static_cast<double>(b);
                const bool is_last = sides == kMaxSides && !is_rounded_;
                if (azimuth * radius_ > tolerance_ && !is_last) continue;
                std::vector<RingPolygon> family{finest};
                if (is_rounded_) family = add_coarser(finest);
                for (const double share : shares()) {
                    StackLimits limits = widest_limits();
                    if (is_rounded_ && is_met_without_bias()) limits.cost = best_.choice.stack.cost;
                    auto stack = ring_stack(piece_, family, side_, unit_mm_,
                                            band(tolerance_, share), limits);
                    if (stack) consider(family, std::move(*stack), share);
                }
            }
        }
    }

    // Large numbers of sides: those that can be halved several times are enough.
    int step_after(int sides) const {
        if (!is_rounded_ || sides < 64) return 4;
        return sides < 128 ? 8 : 16;
    }

    // Returns the tolerance that would need all corners if each ring had the largest distance and
    // the fewest sides that it may have alone.
    double least_tolerance() const {
        double tolerance = 1.0;
        for (const ProfilePoint& p : piece_.profile) {
            constexpr double kTurn = std::numbers::pi / 2;
            const double mean = std::sqrt(p.fillet / unit_mm_ * radius_);
            tolerance = std::max(tolerance, std::numbers::pi / 4 * kTurn * mean / kMaxCorners);
        }
        return tolerance;
    }

    // Returns the least number of sides, from r(1/cos x - 1) ~ r x²/2 with x = 180°/k.
    int least_sides() const {
        const double sides = std::numbers::pi / std::sqrt(2 * tolerance_ / radius_);
        return static_cast<int>(std::min<double>(kMaxSides, std::ceil(sides)));
    }

    void consider(const std::vector<RingPolygon>& family, RingStack stack, double share) {
        const bool meets = stack.error <= tolerance_;
        const double bias =
            meets && !turns_ ? std::abs(bias_of(family, stack, depth_of(tolerance_, share))) : 0.0;
        const RingStack& best = best_.choice.stack;
        const bool is_better =
            meets ? !is_met() ||
                        std::tuple(!is_nearly_balanced(bias), cost(stack), stack.error) <
                            std::tuple(!is_nearly_balanced(best_.bias), cost(best), best.error)
                  : !best_.choice.is_there() || stack.error < best.error;
        if (is_better) best_ = {{family, std::move(stack)}, share, bias};
    }

    // Makes the strips equally wide: searches the smallest error at the same cost.
    void equalise_strips() {
        constexpr int kHalvings = 8;
        RingStack& best = best_.choice.stack;
        double low = 0.0;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = (low + best.error) / 2;
            const std::vector<Ring> pattern = best.rings;
            StackLimits limits = widest_limits();
            limits.cost = best.cost;
            if (side_ == Side::Circumscribed && !turns_) limits.pattern = &pattern;
            auto stack = ring_stack(piece_, best_.choice.family, side_, unit_mm_,
                                    band(middle, best_.share), limits);
            if (stack && stack->error < best.error) {
                best = std::move(*stack);
            } else {
                low = middle;
            }
        }
    }

    // Shares of the facets' depth by which the corners of fair tools lie outside. With about a
    // half, finished parts have the volume that the round tool leaves. Radii and heights come in
    // steps, so that several shares are tried.
    std::vector<double> shares() const {
        if (!is_fair_) return {1.0};
        if (turns_) return {1.0 / 3};  // balance_by_depth() changes the share
        return {0.50, 0.53, 0.56};
    }

    // Returns the depth of the facets from corner to middle. With all the depth that the tolerance
    // allows, the recognition of surfaces has no play left. Facets that are deep compared with the
    // tool are balanced at the tip, but cut too little at steep slopes.
    double depth_of(double tolerance, double share) const {
        constexpr double kDeepest = 1.7, kOfRadius = 0.115;
        if (turns_) return 1.5 * tolerance;
        const double most = std::min(kDeepest * tolerance, kOfRadius * radius_);
        return std::min(most, tolerance / std::max(share, 1 - share));
    }

    // Returns the play for `tolerance`.
    ToleranceBand band(double tolerance, double share) const {
        switch (side_) {
            case Side::Circumscribed: return {0.0, tolerance};
            case Side::Inscribed: return {tolerance, 0.0};
            case Side::Fair: break;
        }
        const double depth = depth_of(tolerance, share);
        return {(1 - share) * depth, share * depth};
    }

    // Balances a fair tool: searches the share without bias near the best share. The bias grows
    // with the share.
    void balance() {
        constexpr int kHalvings = 10;
        constexpr double kAround = 0.05;
        constexpr double kDearer = 1.03;
        const std::vector<Ring> pattern = best_.choice.stack.rings;
        const StackLimits limits{kMaxCorners, kDearer * best_.choice.stack.cost, &pattern};
        const double first = best_.share;
        double low = first - kAround, high = first + kAround;
        for (int i = 0; i < kHalvings && !is_balanced(best_.bias); ++i) {
            const double share = (low + high) / 2;
            auto stack = ring_stack(piece_, best_.choice.family, side_, unit_mm_,
                                    band(tolerance_, share), limits);
            if (!stack) {
                (share > first ? high : low) = share;
                continue;
            }
            const double bias = bias_of(best_.choice.family, *stack, depth_of(tolerance_, share));
            (bias > 0 ? high : low) = share;
            if (stack->error > tolerance_ || std::abs(bias) >= best_.bias) continue;
            best_.bias = std::abs(bias);
            best_.share = share;
            best_.choice.stack = std::move(*stack);
        }
    }

    StackLimits widest_limits() const {
        StackLimits limits{kMaxCorners};
        limits.turns = turns_;
        return limits;
    }

    // Balances a fair tool that turns, with all stacks of the best family. Radii and heights come
    // in steps, so further depths are tried, which may need more facets.
    void balance_by_depth() {
        constexpr double kShallower = 0.97;
        constexpr int kDepths = 8;
        const RingStack& best = best_.choice.stack;
        const double few = best.cost;
        double depth = 1.5 * best.error;
        best_.bias = std::abs(bias_of(best_.choice.family, best, depth));
        for (int i = 0; i < kDepths; ++i, depth *= kShallower) {
            // A thirtieth more facets counts as equal.
            if (is_balanced(best_.bias) && best.cost <= std::floor(few + few / 32)) break;
            balance_at_depth(depth, std::floor(few + few / 4));
        }
    }

    bool is_balanced(double bias) const { return bias <= 0.01 * tolerance_; }

    void balance_at_depth(double depth, double most) {
        constexpr int kHalvings = 10;
        double low = 0.1, high = 0.9;
        for (int i = 0; i < kHalvings; ++i) {
            const double share = (low + high) / 2;
            auto stack = ring_stack(piece_, best_.choice.family, side_, unit_mm_,
                                    {(1 - share) * depth, share * depth}, widest_limits());
            if (!stack) {
                low = share;
                continue;
            }
            const double bias = bias_of(best_.choice.family, *stack, depth);
            (bias > 0 ? high : low) = share;
            if (stack->error > tolerance_ || stack->cost > most) continue;
            const bool is_better =
                is_balanced(best_.bias)
                    ? is_balanced(std::abs(bias)) && stack->cost < best_.choice.stack.cost
                    : std::abs(bias) < best_.bias;
            if (!is_better) continue;
            best_.bias = std::abs(bias);
            best_.choice.stack = std::move(*stack);
        }
    }

    // Returns the bias of a stack. Passes without a distance between them would cut the part where
    // the corners reach. Real passes leave ridges between them, because facets meet in edges. For
    // passes at a distance of 0.1 to 2 tool radii, the measured effect is about a fifth of the
    // depth. Zero if the tool has no rounded corner on the lower side.
    double bias_of(const std::vector<RingPolygon>& family, const RingStack& stack,
                   double depth) const {
        if (!is_fair_) return 0.0;
        constexpr double kRidges = 0.2;
        const double excess = mean_excess(piece_, family, stack.rings, unit_mm_);
        return excess == 0.0 ? 0.0 : excess - kRidges * depth;
    }

    bool is_nearly_balanced(double bias) const { return bias <= 0.05 * tolerance_; }

    const ToolPiece& piece_;
    double radius_;
    double unit_mm_;
    Side side_;
    bool is_rounded_;
    bool is_fair_;
    bool turns_;
    BaseCandidates candidates_;
    double tolerance_ = 0.0;
    Candidate best_;
};

}  // namespace

PiecePolytope approximate(const ToolPiece& piece, const cda::Lattice& lattice,
                          const ToolAccuracy& accuracy) {
    PiecePolytope polytope;
    polytope.cutting = piece.cutting;
    const double u = lattice.unit_mm;
    const double exact_radius = largest_radius(piece) / u;
    const std::int64_t radius =
        accuracy.side != Side::Inscribed ? round_up(exact_radius) : round_down(exact_radius);
    if (piece.profile.empty() || radius < 1) return polytope;
    const double tolerance = accuracy.tolerance_mm / u;
    Choice best = Search(piece, radius, u, accuracy.side, accuracy.turns)(tolerance);
    // On tools of a few units, no stack has short directions within the depth that fair tools may
    // have. Then edges with any directions are better than a coarse stack or none.
    if (!accuracy.turns && (!best.is_there() || best.stack.error > tolerance)) {
        Choice other = Search(piece, radius, u, accuracy.side, true)(tolerance);
        const bool is_better =
            other.is_there() && (!best.is_there() || other.stack.error < best.stack.error);
        if (is_better) best = std::move(other);
    }
    if (!best.is_there()) return polytope;
    polytope.sides = best.sides();
    polytope.error_mm = best.stack.error * u;
    polytope.points_T = points_of(best.family, best.stack.rings);
    return polytope;
}

PiecePolytope approximate_above(const ToolPiece& below, const ToolPiece& piece,
                                const cda::Lattice& lattice, const ToolAccuracy& accuracy) {
    const auto as_thick = [&](const ProfilePoint& p) {
        return p.fillet == 0.0 && !below.profile.empty() && p.radius == below.profile.back().radius;
    };
    const bool goes_on = !piece.profile.empty() && std::ranges::all_of(piece.profile, as_thick) &&
                         below.profile.back().fillet == 0.0;
    PiecePolytope polytope = approximate(goes_on ? below : piece, lattice, accuracy);
    if (!goes_on || polytope.points_T.empty()) return polytope;
    const std::int64_t top =
        std::ranges::max(polytope.points_T, {}, [](const LatticePoint& p) { return p.z; }).z;
    std::erase_if(polytope.points_T, [top](const LatticePoint& p) { return p.z != top; });
    const bool outside = accuracy.side != Side::Inscribed;
    const double low = piece.profile.front().height / lattice.unit_mm;
    const double high = piece.profile.back().height / lattice.unit_mm;
    const std::vector<LatticePoint> ring = polytope.points_T;
    for (LatticePoint& p : polytope.points_T)
        p.z = outside ? round_down(low) : round_up(low);
    for (LatticePoint p : ring) {
        p.z = outside ? round_up(high) : round_down(high);
        polytope.points_T.push_back(p);
    }
    polytope.cutting = piece.cutting;
    return polytope;
}

}  // namespace ncsim::toolpath
