// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seidel's linear programming in one, two and three dimensions.
#include "polytope/linear_program.h"

#include "ncsim/base/mix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ncsim::cda {

namespace {

// The random generator splitmix64. The sequence of a seed is the same everywhere, unlike
// std::shuffle.
class SplitMix {
public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        const std::uint64_t result = mix(0, state_);
        state_ += 0x9e3779b97f4a7c15U;
        return result;
    }

private:
    std::uint64_t state_;
};

// The half-plane a·s + b·t <= c in the coordinates (s, t) of a plane.
struct Halfplane {
    double a = 0.0, b = 0.0, c = 0.0;
};

// Tolerance of a point beyond a halfspace, relative to the size of the coordinates. Callers verify
// every result, so the tolerance affects only the speed.
constexpr double kRelativeSlack = 1e-12;

// Returns the best point of the line p + r·(dx, dy) in the half-planes; empty if there is none.
std::optional<std::pair<double, double>> best_on_line(double px, double py, double dx, double dy,
                                                      std::span<const Halfplane> halfplanes,
                                                      double reach, bool forward, double slack) {
    double low = -reach;
    double high = reach;
    for (const Halfplane& h : halfplanes) {
        const double along = h.a * dx + h.b * dy;
        const double room = h.c - (h.a * px + h.b * py);
        if (std::abs(along) < 1e-14) {
            if (room < -slack) return std::nullopt;
        } else if (along > 0.0) {
            high = std::min(high, room / along);
        } else {
            low = std::max(low, room / along);
        }
    }
    if (low > high + slack) return std::nullopt;
    const double r = forward ? std::max(low, high) : std::min(low, high);
    return std::pair{px + r * dx, py + r * dy};
}

// Solves the two-dimensional program by the same algorithm, one dimension lower.
std::optional<std::pair<double, double>> farthest_in_plane(std::span<const Halfplane> halfplanes,
                                                           double cs, double ct, double reach,
                                                           double slack) {
    std::pair<double, double> best{cs >= 0.0 ? reach : -reach, ct >= 0.0 ? reach : -reach};
    for (std::size_t i = 0; i < halfplanes.size(); ++i) {
        const Halfplane& h = halfplanes[i];
        if (h.a * best.first + h.b * best.second <= h.c + slack) continue;
        // The optimum is on the boundary of h.
        const double dx = -h.b;
        const double dy = h.a;
        const auto next = best_on_line(h.a * h.c, h.b * h.c, dx, dy, halfplanes.first(i),
                                       2.0 * reach, cs * dx + ct * dy > 0.0, slack);
        if (!next) return std::nullopt;
        best = *next;
    }
    return best;
}

}  // namespace

std::optional<Vec3> farthest_point(std::span<const Halfspace> halfspaces, const Box& start,
                                   Vec3 objective, std::uint64_t seed) {
    if (start.is_empty()) return std::nullopt;
    const double size =
        std::max({std::abs(start.min.x), std::abs(start.min.y), std::abs(start.min.z),
                  std::abs(start.max.x), std::abs(start.max.y), std::abs(start.max.z), 1.0});
    const double slack = kRelativeSlack * size;

    // The bounding planes are first, so the program is bounded from the start.
    std::vector<Halfspace> order{{{1, 0, 0}, start.max.x},   {{0, 1, 0}, start.max.y},
                                 {{0, 0, 1}, start.max.z},   {{-1, 0, 0}, -start.min.x},
                                 {{0, -1, 0}, -start.min.y}, {{0, 0, -1}, -start.min.z}};
    const auto bounding = static_cast<std::ptrdiff_t>(order.size());
    order.insert(order.end(), halfspaces.begin(), halfspaces.end());
    SplitMix random(seed);
    for (auto i = static_cast<std::ptrdiff_t>(order.size()) - 1; i > bounding; --i) {
        const auto span = static_cast<std::uint64_t>(i - bounding + 1);
        std::swap(order[static_cast<std::size_t>(i)],
                  order[static_cast<std::size_t>(bounding) + random.next() % span]);
    }

    Vec3 best = start.max;
    std::vector<Halfplane> projected;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Halfspace& h = order[i];
        if (dot(h.normal, best) <= h.distance + slack) continue;
        // The optimum is on the boundary of h: coordinates (s, t) about the foot point of h.
        const Vec3 origin = h.distance * h.normal;
        const Vec3 n = h.normal;
        const Vec3 helper = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 u = normalized(cross(n, helper));
        const Vec3 v = cross(n, u);
        projected.clear();
        for (std::size_t k = 0; k < i; ++k) {
            const double a = dot(order[k].normal, u);
            const double b = dot(order[k].normal, v);
            const double c = order[k].distance - dot(order[k].normal, origin);
            const double length = std::sqrt(a * a + b * b);
            if (length < 1e-12) {
                if (c < -slack) return std::nullopt;
                continue;
            }
            projected.push_back({a / length, b / length, c / length});
        }
        const auto st = farthest_in_plane(projected, dot(objective, u), dot(objective, v),
                                          4.0 * (size + norm(origin)), slack);
        if (!st) return std::nullopt;
        best = origin + st->first * u + st->second * v;
    }
    return best;
}

std::optional<Vec3> interior_point(std::span<const Halfspace> halfspaces, const Box& start,
                                   std::uint64_t seed) {
    SplitMix random(seed);
    const auto component = [&] { return 0.25 + 1e-3 * static_cast<double>(random.next() % 1000); };
    const double cx = component();
    const double cy = component();
    const double cz = component();
    const auto corner = farthest_point(halfspaces, start, {cx, cy, cz}, random.next());
    if (!corner) return std::nullopt;

    // The three planes nearest to the corner with independent normals span the cone.
    const std::array<Halfspace, 6> box{{{{1, 0, 0}, start.max.x},
                                        {{0, 1, 0}, start.max.y},
                                        {{0, 0, 1}, start.max.z},
                                        {{-1, 0, 0}, -start.min.x},
                                        {{0, -1, 0}, -start.min.y},
                                        {{0, 0, -1}, -start.min.z}}};
    std::vector<std::pair<double, Vec3>> tight;
    const auto consider = [&](const Halfspace& h) {
        tight.emplace_back(h.distance - dot(h.normal, *corner), h.normal);
    };
    std::for_each(halfspaces.begin(), halfspaces.end(), consider);
    std::for_each(box.begin(), box.end(), consider);
    std::stable_sort(tight.begin(), tight.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    const Vec3 n1 = tight[0].second;
    std::size_t k = 1;
    while (k < tight.size() && norm(cross(n1, tight[k].second)) < 1e-6)
        ++k;
    if (k == tight.size()) return std::nullopt;
    const Vec3 n2 = tight[k].second;
    const Vec3 n12 = cross(n1, n2);
    std::size_t m = k + 1;
    while (m < tight.size() && std::abs(dot(n12, tight[m].second)) < 1e-6)
        ++m;
    if (m == tight.size()) return std::nullopt;
    const Vec3 n3 = tight[m].second;

    // Axis of the cone: the direction that leaves all three planes at the same speed.
    const Vec3 axis = normalized((-1.0 / dot(n12, n3)) * (n12 + cross(n2, n3) + cross(n3, n1)));
    double low = 0.0;
    double high = std::numeric_limits<double>::infinity();
    const auto bound = [&](const Halfspace& h) {
        const double along = dot(h.normal, axis);
        const double room = h.distance - dot(h.normal, *corner);
        if (along > 0.0) {
            high = std::min(high, room / along);
        } else if (along < 0.0) {
            low = std::max(low, room / along);
        } else if (room < 0.0) {
            high = low;
        }
    };
    std::for_each(halfspaces.begin(), halfspaces.end(), bound);
    std::for_each(box.begin(), box.end(), bound);
    if (!(high > low)) return std::nullopt;
    return *corner + 0.5 * (low + high) * axis;
}

}  // namespace ncsim::cda
