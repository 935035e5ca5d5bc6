// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounds a closed mesh to floats in four steps:
//  1. Split each vertex at which the surface touches itself into one vertex per fan of triangles.
//  2. Round the coordinates. Contract edges of zero length and flip triangles of zero height, if
//     the topology does not change (remove_slivers).
//  3. Move corners that share a position with another corner, or that are collinear with the other
//     two corners of a triangle (Places).
//  4. Check what steps 2 and 3 changed. If the check fails, repeat without step 2. That attempt
//     always succeeds: step 1 gives a manifold, and step 3 gives each vertex a position of its own.
//
// Step 3 terminates: a cube of (2r + 1)³ positions around a corner has 2r + 1 coordinates per axis.
// A line has one point for each coordinate along an axis in which the line is not constant, so the
// line meets at most 2r + 1 positions of the cube. A position is refused if it is occupied, or if
// it is on the line through the other two corners of a triangle at the corner. Let t be the number
// of occupied positions in the cube and d the number of triangles at the corner. At most t + d
// (2r + 1) positions are refused, which is less than (2r + 1)³ for some r.
//
// One pass over the corners is enough: a corner moves to a free position, so no two corners come to
// share a position. The move makes no triangle flat whose other two corners differ in position. If
// the other two corners share a position, one of the two is not the first at this position and
// moves later; then the other two corners of the triangle differ, or the triangle contains a
// further corner that has yet to move.
#include "ncsim/mesh/float_mesh.h"

#include "ncsim/base/mix.h"
#include "ncsim/base/parallel.h"
#include "ncsim/cda/predicates.h"

#include "slivers.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace ncsim::mesh {

namespace {

using Vertex = std::uint32_t;
using Triangle = std::array<Vertex, 3>;

constexpr float kMost = 0x1p100F;

// Smallest extent in mm; parts are larger. Steps of a smaller extent would leave the range of
// floats.
constexpr double kLeastSize = 0x1p-40;

// A step is the distance between floats in the binade of the largest coordinate.
constexpr int kBits = 23;

// Coordinates near zero are rounded to 2^-24 of a step, because finer floats would exceed the 128
// bits of exact products.
constexpr int kFineBits = 24;

// Edges shorter and triangles lower than this share of a step have no extent. The rounding error of
// a height in doubles is at most 2^-24 of a step.
constexpr double kLow = 0x1p-20;

// The triangles around each vertex, in order of rotation.
class Fans {
public:
    Fans(const std::vector<Triangle>& triangles, std::size_t vertices)
        : first_(vertices + 1, 0), corners_(3 * triangles.size()) {
        for (const Triangle& t : triangles) {
            for (const Vertex v : t)
                ++first_[v + 1];
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                corners_[next[triangles[t][i]]++] = {triangles[t][(i + 1) % 3],
                                                     triangles[t][(i + 2) % 3], 3 * t + i, false};
            }
        }
    }

    /// Returns the vertices with more than one fan, ascending; nullopt if the triangles at a vertex
    /// do not form closed fans.
    std::optional<std::vector<Vertex>> vertices_with_several_fans(std::size_t threads) {
        std::atomic<bool> is_closed = true;
        const auto vertices = static_cast<Vertex>(first_.size() - 1);
        std::vector<Vertex> several = filter_indices(threads, vertices, [&](Vertex v) {
            int count = 0;
            if (!visit(v, [&](const auto&) { ++count; })) is_closed = false;
            return count > 1;
        });
        if (!is_closed) return std::nullopt;
        return several;
    }

    /// Calls `fan` for each fan around `v` with its corners, in order of rotation; a corner is 3 ×
    /// triangle + position in the triangle. Returns false if the fans are not closed: some edge
    /// does not occur exactly once in each direction.
    template <typename Action>
    bool visit(Vertex v, const Action& fan) {
        const auto begin = first_corner(v);
        const auto end = first_corner(v + 1);
        std::sort(begin, end, [](const Corner& a, const Corner& b) { return a.from < b.from; });
        for (auto corner = begin; corner != end; ++corner)
            corner->is_done = false;
        thread_local std::vector<std::uint32_t> turn;
        for (auto start = begin; start != end; ++start) {
            if (start->to == v || start->from == v || start->from == start->to) return false;
            if (start + 1 != end && start->from == (start + 1)->from) return false;
        }
        for (auto start = begin; start != end; ++start) {
            if (start->is_done) continue;
            turn.clear();
            for (auto at = start; !at->is_done;) {
                at->is_done = true;
                turn.push_back(at->number);
                const Vertex next = at->to;
                at = std::lower_bound(begin, end, next,
                                      [](const Corner& c, Vertex w) { return c.from < w; });
                if (at == end || at->from != next) return false;
                if (at->is_done && at != start) return false;
            }
            fan(turn);
        }
        return true;
    }

private:
    struct Corner {
        Vertex from, to;  // of the opposite edge
        std::uint32_t number;
        bool is_done;
    };
    std::vector<Corner>::iterator first_corner(Vertex v) {
        return corners_.begin() + static_cast<std::ptrdiff_t>(first_[v]);
    }
    std::vector<std::size_t> first_;  // for each vertex, start of the corners in `corners_`
    std::vector<Corner> corners_;
};

// Step 1: gives each further fan of a vertex a new vertex. Appends the original of each new vertex
// to `vertex`.
void part_fans(std::vector<Triangle>& triangles, std::vector<std::uint32_t>& vertex,
               std::size_t threads) {
    Fans fans(triangles, vertex.size());
    const auto several = fans.vertices_with_several_fans(threads);
    if (!several) throw std::invalid_argument("the mesh is not closed");
    for (const Vertex v : *several) {
        bool is_first = true;
        fans.visit(v, [&](const std::vector<std::uint32_t>& corners) {
            if (std::exchange(is_first, false)) return;
            for (const std::uint32_t c : corners)
                triangles[c / 3][c % 3] = static_cast<Vertex>(vertex.size());
            vertex.push_back(v);
        });
    }
}

bool is_manifold(const std::vector<Triangle>& triangles, std::size_t vertices,
                 std::size_t threads) {
    const auto several = Fans(triangles, vertices).vertices_with_several_fans(threads);
    return several && several->empty();
}

// The grid of a mesh: the size of a step, and whole numbers for coordinates.
class Steps {
public:
    explicit Steps(double largest)
        : step_(std::ldexp(1.0, std::ilogb(std::max(largest, kLeastSize)) - kBits)),
          fine_(std::ldexp(step_, -kFineBits)) {}

    double step() const { return step_; }

    FloatPoint round(Vec3 p) const {
        FloatPoint point = to_floats(p);
        for (float& x : point) {
            // Larger coordinates have no bits finer than that.
            if (std::abs(static_cast<double>(x)) < step_)
                x = static_cast<float>(fine_ * std::round(static_cast<double>(x) / fine_)) + 0.0F;
        }
        return point;
    }

    /// Returns the float that is `count` steps from `x`; a step is the next float if floats are
    /// coarser.
    float moved(float x, int count) const {
        const auto far = static_cast<float>(count < 0 ? -step_ : step_);
        for (int i = 0; i < std::abs(count); ++i) {
            const float next = x + far;
            x = next != x ? next : std::nextafter(x, std::copysign(kMost, far));
        }
        return x;
    }

    /// True if the corners are collinear, computed exactly: coordinates have 48 bits, or a few more
    /// if a corner was moved beyond the largest coordinate, so products fit in 128 bits.
    bool are_collinear(const FloatPoint& a, const FloatPoint& b, const FloatPoint& c) const {
        std::array<Int128, 3> ab{}, ac{};
        for (std::size_t i = 0; i < 3; ++i) {
            ab[i] = whole(b[i]) - whole(a[i]);
            ac[i] = whole(c[i]) - whole(a[i]);
        }
        return ab[1] * ac[2] == ab[2] * ac[1] && ab[2] * ac[0] == ab[0] * ac[2] &&
               ab[0] * ac[1] == ab[1] * ac[0];
    }

private:
    std::int64_t whole(float x) const {
        return static_cast<std::int64_t>(static_cast<double>(x) / fine_);
    }
    double step_, fine_;
};

// Occupied positions and the vertex at each: a hash table with open addressing, at most half full.
class PlaceTable {
public:
    explicit PlaceTable(std::size_t places) { resize(2 * places); }

    /// Returns the vertex at `place`; puts `v` there if the place is free.
    Vertex take(const FloatPoint& place, Vertex v) {
        if (2 * (taken_ + 1) > slots_.size()) resize(2 * slots_.size());
        Slot& slot = slots_[find(place)];
        if (slot.vertex == kNone) {
            slot = {place, v};
            ++taken_;
        }
        return slot.vertex;
    }
    bool is_taken(const FloatPoint& place) const { return slots_[find(place)].vertex != kNone; }
    /// Requires: `place` is occupied.
    Vertex at(const FloatPoint& place) const { return slots_[find(place)].vertex; }

private:
    static constexpr Vertex kNone = ~Vertex{0};
    struct Slot {
        FloatPoint place{};
        Vertex vertex = kNone;
    };

    // Returns the slot of `place`, or the free slot for it.
    std::size_t find(const FloatPoint& place) const {
        std::uint64_t h = 0;
        for (const float x : place)
            h = mix(h, std::bit_cast<std::uint32_t>(x));
        std::size_t i = h & (slots_.size() - 1);
        while (slots_[i].vertex != kNone && slots_[i].place != place)
            i = (i + 1) & (slots_.size() - 1);
        return i;
    }
    void resize(std::size_t least) {
        const std::vector<Slot> before = std::exchange(
            slots_, std::vector<Slot>(std::bit_ceil(std::max<std::size_t>(least, 16))));
        for (const Slot& slot : before) {
            if (slot.vertex != kNone) slots_[find(slot.place)] = slot;
        }
    }

    std::vector<Slot> slots_;
    std::size_t taken_ = 0;
};

// Step 3: gives each corner a position of its own.
class Places {
public:
    Places(const std::vector<Vec3>& exact, const std::vector<Triangle>& triangles,
           const Steps& steps, std::vector<FloatPoint>& points, std::size_t threads)
        : exact_(exact),
          triangles_(triangles),
          steps_(steps),
          points_(points),
          threads_(threads),
          taken_(points.size()) {}

    /// Moves corners as needed. Returns false if no corner had to move.
    bool run() {
        // The first corner at a position stays, and so do the first two corners of a flat triangle.
        std::vector<bool> is_used(points_.size(), false);
        for (const Triangle& t : triangles_) {
            for (const Vertex v : t)
                is_used[v] = true;
        }
        std::vector<Vertex> suspects;
        for (const std::uint32_t t : filter_indices(
                 threads_, static_cast<std::uint32_t>(triangles_.size()), [&](std::uint32_t i) {
                     const auto& [a, b, c] = triangles_[i];
                     return steps_.are_collinear(points_[a], points_[b], points_[c]);
                 })) {
            suspects.push_back(std::ranges::max(triangles_[t]));
        }
        for (Vertex v = 0; v < points_.size(); ++v) {
            if (is_used[v] && taken_.take(points_[v], v) != v) suspects.push_back(v);
        }
        if (suspects.empty()) return false;
        std::sort(suspects.begin(), suspects.end());
        suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
        find_opposites();
        for (const Vertex v : suspects) {
            if (taken_.at(points_[v]) != v || is_flat_at(v, points_[v])) move(v);
        }
        return true;
    }

private:
    using Edge = std::array<Vertex, 2>;

    void find_opposites() {
        first_.assign(points_.size() + 1, 0);
        for (const Triangle& t : triangles_) {
            for (const Vertex v : t)
                ++first_[v + 1];
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        opposite_.resize(first_.back());
        std::vector<std::size_t> next(first_);
        for (const auto& [a, b, c] : triangles_) {
            opposite_[next[a]++] = {b, c};
            opposite_[next[b]++] = {c, a};
            opposite_[next[c]++] = {a, b};
        }
    }

    // True if a triangle at `v` would be flat with `v` at `place`. Triangles whose other two
    // corners share a position are ignored.
    bool is_flat_at(Vertex v, const FloatPoint& place) const {
        return std::any_of(opposite_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
                           opposite_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]),
                           [&](const Edge& edge) {
                               const FloatPoint& a = points_[edge[0]];
                               const FloatPoint& b = points_[edge[1]];
                               return a != b && steps_.are_collinear(place, a, b);
                           });
    }

    // Moves `v` to the nearest allowed position, with the fewest steps per axis.
    void move(Vertex v) {
        struct Candidate {
            double distance;
            FloatPoint place;
        };
        std::vector<Candidate> shell;
        for (int r = 1;; ++r) {
            shell.clear();
            for (int x = -r; x <= r; ++x) {
                for (int y = -r; y <= r; ++y) {
                    const bool is_side = std::abs(x) == r || std::abs(y) == r;
                    for (int z = -r; z <= r; z += is_side ? 1 : 2 * r) {
                        const FloatPoint place{steps_.moved(points_[v][0], x),
                                               steps_.moved(points_[v][1], y),
                                               steps_.moved(points_[v][2], z)};
                        const Vec3 off{static_cast<double>(place[0]) - exact_[v].x,
                                       static_cast<double>(place[1]) - exact_[v].y,
                                       static_cast<double>(place[2]) - exact_[v].z};
                        shell.push_back({dot(off, off), place});
                    }
                }
            }
            std::sort(shell.begin(), shell.end(), [](const Candidate& a, const Candidate& b) {
                return std::tie(a.distance, a.place) < std::tie(b.distance, b.place);
            });
            for (const auto& [distance, place] : shell) {
                if (taken_.is_taken(place) || is_flat_at(v, place)) continue;
                // The old position stays occupied because it may belong to another corner.
                taken_.take(place, v);
                points_[v] = place;
                return;
            }
        }
    }

    const std::vector<Vec3>& exact_;
    const std::vector<Triangle>& triangles_;
    const Steps& steps_;
    std::vector<FloatPoint>& points_;
    std::size_t threads_;
    PlaceTable taken_;                // first vertex at each position
    std::vector<std::size_t> first_;  // for each vertex, start of the edges in `opposite_`
    std::vector<Edge> opposite_;  // for each vertex, the opposite edges of the adjacent triangles
};

// Step 4 for positions: true if no two corners share a position and no triangle is flat.
bool are_places_right(const FloatMesh& mesh, const Steps& steps) {
    std::vector<bool> is_used(mesh.points.size(), false);
    for (const Triangle& t : mesh.triangles) {
        const auto& [a, b, c] = t;
        if (steps.are_collinear(mesh.points[a], mesh.points[b], mesh.points[c])) return false;
        for (const Vertex v : t)
            is_used[v] = true;
    }
    PlaceTable taken(mesh.points.size());
    for (Vertex v = 0; v < mesh.points.size(); ++v) {
        if (is_used[v] && taken.take(mesh.points[v], v) != v) return false;
    }
    return true;
}

// Restores the order by faces, because flips give triangles to other faces.
void sort_by_face(TriangleMesh& mesh) {
    if (std::is_sorted(mesh.face.begin(), mesh.face.end())) return;
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return mesh.face[a] < mesh.face[b]; });
    TriangleMesh sorted;
    for (const std::uint32_t t : order) {
        sorted.triangles.push_back(mesh.triangles[t]);
        sorted.face.push_back(mesh.face[t]);
    }
    mesh.triangles = std::move(sorted.triangles);
    mesh.face = std::move(sorted.face);
}

// Steps 2 to 4; nullopt if the check fails.
std::optional<FloatMesh> rounded(const std::vector<Vec3>& exact, const Steps& steps,
                                 TriangleMesh mesh, bool contracts, std::size_t threads) {
    FloatMesh result;
    result.points.resize(exact.size());
    mesh.vertices.resize(exact.size());
    const Runs runs(exact.size(), std::size_t{1} << 14);
    in_parallel(threads, runs.tasks(), [&](std::size_t task) {
        for (std::size_t i = runs.begin(task); i < runs.end(task); ++i) {
            const FloatPoint q = steps.round(exact[i]);
            result.points[i] = q;
            mesh.vertices[i] = {static_cast<double>(q[0]), static_cast<double>(q[1]),
                                static_cast<double>(q[2])};
        }
    });
    const bool are_other_triangles =
        contracts && remove_slivers(mesh, kLow * steps.step(), threads);
    sort_by_face(mesh);
    result.triangles = std::move(mesh.triangles);
    result.face = std::move(mesh.face);
    const bool are_other_places =
        Places(exact, result.triangles, steps, result.points, threads).run();
    // Unchanged triangles are a manifold (step 1), and unchanged positions are valid (step 3).
    if (are_other_triangles && !is_manifold(result.triangles, result.points.size(), threads))
        return std::nullopt;
    if (are_other_places && !are_places_right(result, steps)) return std::nullopt;
    return result;
}

}  // namespace

FloatPoint to_floats(Vec3 p) {
    FloatPoint point{};
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(p[axis]) < static_cast<double>(kMost)))
            throw std::runtime_error("the part is too large for floats");
        // Adding zero turns -0 into 0, because some readers compare corners byte by byte.
        point[static_cast<std::size_t>(axis)] = static_cast<float>(p[axis]) + 0.0F;
    }
    return point;
}

FloatMesh round_to_floats(const TriangleMesh& mesh, Vec3 origin, std::size_t threads) {
    TriangleMesh parted;
    parted.triangles = mesh.triangles;
    parted.face = mesh.face;
    std::vector<std::uint32_t> vertex(mesh.vertices.size());
    std::iota(vertex.begin(), vertex.end(), 0U);
    part_fans(parted.triangles, vertex, threads);

    std::vector<Vec3> exact;
    exact.reserve(vertex.size());
    double largest = 0.0;
    for (const std::uint32_t v : vertex) {
        exact.push_back(mesh.vertices[v] - origin);
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::abs(exact.back()[axis]));
    }
    const Steps steps(largest);
    std::optional<FloatMesh> result = rounded(exact, steps, parted, true, threads);
    if (!result) result = rounded(exact, steps, parted, false, threads);
    if (!result) throw std::logic_error("a surface that floats do not keep closed");
    result->vertex = std::move(vertex);
    return *std::move(result);
}

}  // namespace ncsim::mesh
