// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outline:
//  1. A polygon with integer corners around (or in) the circle of integer radius b: `base_polygon`.
//  2. Every ring of the polytope is s times this polygon at an integer height. Strips between two
//  rings are
//     then trapezoids with parallel sides: exactly flat, whatever s and the heights are.
//  3. So the profile needs corners whose radius is a multiple of b: `circumscribed_profile` walks
//  along tangents
//     of the arcs and stops at such radii, which costs nothing, since the heights are free.
//  4. The number of sides, the steps of an arc and b are chosen for the fewest facets within
//     the tolerance.
#include "ncsim/toolpath/tool_polytope.h"

#include "ncsim/toolpath/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ncsim::toolpath {

namespace {

using cda::LatticePoint;

constexpr int kMinSides = 16;
constexpr int kMaxSides = 1024;
// A tool of more corners would take hours to move, and nobody needs it: a ball of 100 mm within 10
// µm.
constexpr std::size_t kMaxCorners = 8192;

// Numbers that are integers but for the rounding of a division or a sine stay what they are.
constexpr double kGuard = 1e-7;
std::int64_t round_up(double v) {
    return static_cast<std::int64_t>(std::ceil(v - kGuard));
}
std::int64_t round_down(double v) {
    return static_cast<std::int64_t>(std::floor(v + kGuard));
}

// A vector of the half-plane in which profiles are drawn: distance from the axis and height.
struct Vec2 {
    double r = 0.0, h = 0.0;
    friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.r + b.r, a.h + b.h}; }
    friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.r - b.r, a.h - b.h}; }
    friend Vec2 operator*(double s, Vec2 a) { return {s * a.r, s * a.h}; }
};

double dot(Vec2 a, Vec2 b) {
    return a.r * b.r + a.h * b.h;
}
double cross(Vec2 a, Vec2 b) {
    return a.r * b.h - a.h * b.r;
}
double norm(Vec2 a) {
    return std::sqrt(dot(a, a));
}
Vec2 left_of(Vec2 a) {
    return {-a.h, a.r};
}
Vec2 unit(Vec2 a) {
    const double n = norm(a);
    return n > 0 ? (1 / n) * a : a;
}

// --- 1. The base polygon -------------------------------------------------------------------

struct BasePolygon {
    std::int64_t b = 1;  // radius of the circle it approximates
    std::vector<std::pair<std::int64_t, std::int64_t>> corners;
    double error = 0.0;  // distance between polygon and circle over b
};

// Corners lie halfway between the side normals 0, 360/k, … degrees. In each quadrant both
// coordinates are rounded away from the axes (circumscribed) or towards them (inscribed), which can
// only enlarge (shrink) the polygon; the sides at ±x and ±y stay at b exactly, when circumscribed.
std::vector<double> corner_cosines(int sides) {
    std::vector<double> cosines(static_cast<std::size_t>(sides / 4));
    for (std::size_t j = 0; j < cosines.size(); ++j) {
        cosines[j] = sin_cos(static_cast<double>(2 * j + 1) * (180.0 / sides)).cos;
    }
    return cosines;
}

BasePolygon base_polygon(std::int64_t b, const std::vector<double>& cosines, Side side) {
    BasePolygon polygon;
    polygon.b = b;
    const std::size_t quadrant = cosines.size();
    const double radius = side == Side::Circumscribed ? 1.0 / cosines[0] : 1.0;
    std::vector<std::pair<std::int64_t, std::int64_t>> first;
    for (std::size_t j = 0; j < quadrant; ++j) {
        // cos(90° - a) for the sine: both diagonals of a quadrant are mirrors, to the last bit.
        const double x = static_cast<double>(b) * (cosines[j] * radius);
        const double y = static_cast<double>(b) * (cosines[quadrant - 1 - j] * radius);
        first.emplace_back(side == Side::Circumscribed ? round_up(x) : round_down(x),
                           side == Side::Circumscribed ? round_up(y) : round_down(y));
    }
    for (int turn = 0; turn < 4; ++turn) {
        for (auto [x, y] : first) {
            for (int t = 0; t < turn; ++t)
                x = std::exchange(y, x) * -1;
            polygon.corners.emplace_back(x, y);
        }
    }
    // The farthest corner when it stands outside, the nearest side when inside.
    const double bd = static_cast<double>(b);
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const auto [x, y] = polygon.corners[i];
        const Vec2 p{static_cast<double>(x), static_cast<double>(y)};
        if (side == Side::Circumscribed) {
            polygon.error = std::max(polygon.error, norm(p) / bd - 1);
        } else {
            const auto [u, v] = polygon.corners[(i + 1) % polygon.corners.size()];
            const Vec2 q{static_cast<double>(u), static_cast<double>(v)};
            const double length = norm(q - p);
            if (length > 0) {
                polygon.error = std::max(polygon.error, 1 - cross(p, q) / (length * bd));
            }
        }
    }
    return polygon;
}

// --- 2., 3. Profiles whose radii are multiples of b -----------------------------------------

struct ProfileCorner {
    std::int64_t scale = 0;  // radius / b
    std::int64_t height = 0;
};

struct LatticeProfile {
    std::vector<ProfileCorner> corners;
    double error = 0.0;  // in lattice units, in the half-plane of the profile
};

// A rounded corner: the disc of radius rho about `centre` touches the line along d1 in `start` and
// the line along d2 in `end`.
struct Fillet {
    Vec2 centre, start, end, d1, d2;
    double rho = 0.0;
    double turn_degrees = 0.0;
};

Fillet fillet_of(Vec2 before, Vec2 corner, Vec2 after, double rho) {
    Fillet f;
    f.d1 = unit(corner - before);
    f.d2 = unit(after - corner);
    f.rho = rho;
    f.turn_degrees = angle_of(dot(f.d1, f.d2), cross(f.d1, f.d2));
    const double leg = rho * cross(f.d1, f.d2) / (1 + dot(f.d1, f.d2));
    f.start = corner - leg * f.d1;
    f.end = corner + leg * f.d2;
    f.centre = f.start + rho * left_of(f.d1);
    return f;
}

class ProfileBuilder {
public:
    ProfileBuilder(std::int64_t b, Side side, int steps)
        : b_(static_cast<double>(b)), side_(side), steps_(steps) {}

    LatticeProfile operator()(const std::vector<ProfilePoint>& profile, double unit_mm) {
        std::vector<Vec2> points;
        points.reserve(profile.size());
        for (const ProfilePoint& p : profile) {
            points.push_back({p.radius / unit_mm, p.height / unit_mm});
        }
        for (std::size_t i = 0; i < profile.size(); ++i) {
            const Vec2 before = i > 0 ? points[i - 1] : Vec2{0, points[i].h};
            const Vec2 after = i + 1 < points.size() ? points[i + 1] : Vec2{0, points[i].h};
            const double rho = profile[i].fillet / unit_mm;
            if (rho > 0) {
                add_fillet(fillet_of(before, points[i], after, rho));
            } else {
                add_corner(points[i], before, after, i + 1 == points.size());
            }
        }
        return std::move(result_);
    }

private:
    bool outside() const { return side_ == Side::Circumscribed; }

    std::int64_t scale_of(double radius) const {
        return outside() ? round_up(radius / b_)
                         : std::max<std::int64_t>(0, round_down(radius / b_));
    }

    // Heights go outwards: down on the lower side of the tool, up at its upper end.
    void add(std::int64_t scale, double height, bool upper_end) {
        const bool up = upper_end == outside();
        result_.corners.push_back({scale, up ? round_up(height) : round_down(height)});
    }

    // A rim between a cone and a disc: moved to the lattice for the disc, it would draw the cone
    // in, so that is led to where it is moved the other way. The same where two cones meet.
    void add_corner(Vec2 p, Vec2 before, Vec2 after, bool upper_end) {
        const std::int64_t scale = scale_of(p.r);
        result_.error =
            std::max(result_.error, std::abs(static_cast<double>(scale) * b_ - p.r) + 1);
        const bool ends_a_cone = before.r < p.r && before.h < p.h;
        const bool begins_a_cone = after.r < p.r && after.h > p.h;
        const bool is_both = upper_end ? ends_a_cone : begins_a_cone;
        if (outside() && is_both && round_down(p.h) < round_up(p.h)) {
            add(scale, p.h, false);
            add(scale, p.h, true);
        } else {
            add(scale, p.h, upper_end);
        }
    }

    void add_fillet(const Fillet& f) {
        if (outside()) {
            walk_tangents(f);
        } else {
            walk_arc(f);
        }
    }

    // From corner to corner, each edge tangent to the arc. All corners but the last may stand at
    // any radius near the ideal one; the last one must not lie inside the line along d2: where the
    // tool gets narrower it stands on that line, farther out, else on the tangent, farther on.
    void walk_tangents(const Fillet& f) {
        const double step = f.turn_degrees / steps_;
        const double reach = f.rho / sin_cos(step / 2).cos;
        const Vec2 out = -1.0 * left_of(f.d1);
        Vec2 at = f.start;
        Vec2 d = f.d1;
        const bool upper = f.d2.r < 0 && f.d1.r <= 0;
        for (int i = 1; i <= steps_; ++i) {
            const SinCos a = sin_cos((i - 0.5) * step);
            const Vec2 ideal = f.centre + reach * (a.cos * out + a.sin * left_of(out));
            const bool is_last = i == steps_;
            const auto at_the_end = [&] {
                return at + (cross(f.end - at, f.d2) / cross(d, f.d2)) * d;
            };
            double radius = at.r;
            if (is_last && d.r <= 1e-9 && f.d2.r < -1e-9) {
                if (cross(f.d2, at - f.end) <= 0) break;  // is beyond that line
                const double end = std::clamp(at_the_end().r, 0.0, at.r);
                radius = static_cast<double>(scale_of(end)) * b_;
                at = f.end + ((radius - f.end.r) / f.d2.r) * f.d2;
            } else if (std::abs(d.r) <= 1e-9) {
                if (is_last) break;
                // There is one radius only, so the height is free.
                radius = static_cast<double>(scale_of(at.r)) * b_;
                at = {radius, ideal.h};
            } else {
                if (is_last) {
                    radius = static_cast<double>(scale_of(at_the_end().r)) * b_;
                } else {
                    radius = std::round(ideal.r / b_) * b_;
                    if (d.r > 0 && radius < at.r) radius += b_;
                    if (d.r < 0 && radius > at.r) radius -= b_;
                }
                at = at + ((radius - at.r) / d.r) * d;
            }
            add(static_cast<std::int64_t>(std::round(radius / b_)), at.h, upper);
            const Vec2 w = at - f.centre;
            const double squared = dot(w, w);
            result_.error = std::max(result_.error, std::sqrt(squared) - f.rho + 1);
            const double length = std::sqrt(std::max(0.0, squared - f.rho * f.rho));
            d = (1 / squared) * (-length * w + f.rho * left_of(w));
        }
    }

    // Corners on the arc, moved along it to radii that are multiples of b; the first one back along
    // d1, so that the lower end stays where it is.
    void walk_arc(const Fillet& f) {
        const double step = f.turn_degrees / steps_;
        const Vec2 out = -1.0 * left_of(f.d1);
        Vec2 before{};
        for (int i = 0; i <= steps_; ++i) {
            const SinCos a = sin_cos(i * step);
            const Vec2 ideal = f.centre + f.rho * (a.cos * out + a.sin * left_of(out));
            const double radius = static_cast<double>(scale_of(ideal.r)) * b_;
            const double x = radius - f.centre.r;
            const double rise = std::sqrt(std::max(0.0, f.rho * f.rho - x * x));
            const bool upper = ideal.h > f.centre.h;
            Vec2 at{radius, f.centre.h + (upper ? rise : -rise)};
            if (i == steps_ && std::abs(f.d2.r) < 1e-9) at.h = f.end.h;
            if (i == 0) {
                const bool moves = f.d1.r > 1e-9;
                at.h = f.start.h - (moves ? (f.start.r - radius) / f.d1.r * f.d1.h : 0.0);
            } else {
                // How far the chord is from the arc over it.
                const Vec2 chord = unit(at - before);
                const double depth = std::abs(cross(before - f.centre, chord));
                result_.error = std::max(result_.error, f.rho - depth + 1);
            }
            if (i == steps_) {
                result_.error = std::max(result_.error, std::abs(f.end.r - radius) + 1);
            }
            add(static_cast<std::int64_t>(std::round(radius / b_)), at.h, upper);
            before = at;
        }
    }

    double b_;
    Side side_;
    int steps_;
    LatticeProfile result_;
};

// --- 4. The cheapest polytope within the tolerance ------------------------------------------

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

// Radii worth trying for the base polygon, for a tool of `radius` units. Where all rings are
// equal (or points) the radius itself; else its divisors of a size at which neither the rounding of
// the polygon nor the coarse radii weigh much; where it has none, those that nearly divide it.
struct BaseCandidates {
    std::vector<std::int64_t> first;
    std::vector<std::int64_t> more;  // near divisors of all sizes
};

BaseCandidates base_candidates(const ToolPiece& piece, std::int64_t radius, double unit_mm,
                               Side side) {
    bool one_ring = !has_fillet(piece);
    for (const ProfilePoint& p : piece.profile) {
        const double r = p.radius / unit_mm;
        const std::int64_t rounded = side == Side::Circumscribed ? round_up(r) : round_down(r);
        one_ring = one_ring && (rounded == 0 || rounded == radius);
    }
    if (one_ring) return {{radius}, {}};
    const double root = std::sqrt(static_cast<double>(radius));
    const auto low = std::max<std::int64_t>(1, static_cast<std::int64_t>(root / 2));
    const auto high = std::max(static_cast<std::int64_t>(root * 2), radius / 200);
    constexpr std::int64_t kFarthest = std::numeric_limits<std::int64_t>::max();
    BaseCandidates candidates;
    std::pair<std::int64_t, std::int64_t> nearest{kFarthest, 1};
    // Of each size, from `begin` to a third more, one is enough to choose from.
    std::pair<std::int64_t, std::int64_t> nearest_here{kFarthest, 1};
    std::int64_t begin = low;
    const auto end_size = [&] {
        if (nearest_here.first < low) candidates.more.push_back(nearest_here.second);
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
        const std::int64_t off = side == Side::Circumscribed ? (b - rest) % b : rest;
        nearest = std::min(nearest, {off, b});
        nearest_here = std::min(nearest_here, {off, b});
    }
    end_size();
    if (candidates.first.empty()) candidates.first.push_back(nearest.second);
    return candidates;
}

// The steps in which an arc over a right angle stays within `rest` of its tangents or chords: with
// x half of a step's angle, ρ(1/cos x - 1) ~ ρ x²/2.
int steps_for(const ToolPiece& piece, double unit_mm, double rest) {
    constexpr double kMaxSteps = 256;
    double rho = 0.0;
    for (const ProfilePoint& p : piece.profile)
        rho = std::max(rho, p.fillet / unit_mm);
    const double x = std::sqrt(2 * std::max(rest, 1.0) / rho);
    return static_cast<int>(std::clamp(std::ceil(std::numbers::pi / 4 / x), 2.0, kMaxSteps));
}

std::vector<LatticePoint> points_of(const BasePolygon& base, const LatticeProfile& profile) {
    std::vector<LatticePoint> points;
    for (const ProfileCorner& ring : profile.corners) {
        for (const auto& [x, y] : base.corners) {
            points.push_back({ring.scale * x, ring.scale * y, ring.height});
            if (ring.scale == 0) break;  // a tip is one point
        }
    }
    return points;
}

}  // namespace

PiecePolytope approximate(const ToolPiece& piece, const cda::Lattice& lattice,
                          const ToolAccuracy& accuracy) {
    PiecePolytope best;
    best.cutting = piece.cutting;
    const double u = lattice.unit_mm;
    const double exact_radius = largest_radius(piece) / u;
    const std::int64_t radius =
        accuracy.side == Side::Circumscribed ? round_up(exact_radius) : round_down(exact_radius);
    if (piece.profile.empty() || radius < 1) return best;

    const double tolerance = accuracy.tolerance_mm / u;
    const bool round = has_fillet(piece);
    const BaseCandidates candidates = base_candidates(piece, radius, u, accuracy.side);
    std::size_t best_corners = std::numeric_limits<std::size_t>::max();
    double best_error = std::numeric_limits<double>::infinity();

    const auto consider = [&](const BasePolygon& base, const LatticeProfile& profile) {
        const double error = base.error * static_cast<double>(radius) + profile.error + 1;
        const std::size_t corners = base.corners.size() * profile.corners.size();
        if (corners > kMaxCorners) return false;
        const bool better = error <= tolerance ? best_error > tolerance || corners < best_corners
                                               : error < best_error;
        if (better) {
            best_corners = corners;
            best_error = error;
            best.sides = static_cast<int>(base.corners.size());
            best.error_mm = error * u;
            best.points_T = points_of(base, profile);
        }
        return error <= tolerance;
    };

    const auto search = [&](const std::vector<std::int64_t>& radii) {
        for (int sides = kMinSides; sides <= kMaxSides; sides += 4) {
            // With that many sides, even one ring more than the tips is dearer than the best.
            if (best_error <= tolerance && 2 * static_cast<std::size_t>(sides) > best_corners)
                break;
            const std::vector<double> cosines = corner_cosines(sides);
            for (const std::int64_t b : radii) {
                const BasePolygon base = base_polygon(b, cosines, accuracy.side);
                const double azimuth = base.error * static_cast<double>(radius);
                if (azimuth > tolerance && sides < kMaxSides) continue;
                const int least = round ? steps_for(piece, u, tolerance - azimuth) : 1;
                for (int steps = least; steps <= least + (round ? 4 : 0); ++steps) {
                    const LatticeProfile profile =
                        ProfileBuilder(b, accuracy.side, steps)(piece.profile, u);
                    if (consider(base, profile)) break;
                }
            }
        }
    };
    search(candidates.first);
    // All divisors of the largest radius may be too coarse for the others.
    if (best_error > tolerance) search(candidates.more);
    if (!best.points_T.empty()) return best;
    // More corners than there may be: as near as that allows.
    for (int sides = kMinSides; sides <= kMaxSides; sides += 4) {
        const int steps = std::min(256, static_cast<int>(kMaxCorners) / sides - 4);
        if (steps < 2) break;
        const std::vector<double> cosines = corner_cosines(sides);
        for (const std::int64_t b : candidates.first) {
            consider(base_polygon(b, cosines, accuracy.side),
                     ProfileBuilder(b, accuracy.side, steps)(piece.profile, u));
        }
    }
    return best;
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
    const bool outside = accuracy.side == Side::Circumscribed;
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
