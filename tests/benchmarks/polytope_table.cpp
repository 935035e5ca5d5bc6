// SPDX-License-Identifier: GPL-3.0-or-later
//
// polytope_table [PROGRAM…]: compares methods to intersect two convex polytopes: a space sweep
// (thesis 4.1), the method of the thesis (4.2 to 4.4), cutting plane by plane, and CGAL. The pairs
// are hulls of programs that overlap, clipped to the stock, as an aggregate intersects hulls. The
// first table has the share of pairs in special position, clipped and not clipped. The second table
// has the cost of a pair, and whether volume, corners and facets are those of the exact
// intersection. The same pairs follow with the second polytope moved by up to 0.1 mm: polytopes as
// in programs, but in general position. An exact method that differs from cutting plane by plane is
// an error.
#include "ncsim/cda/intersect.h"
#include "ncsim/cda/polytope.h"

#include "cgal_intersection.h"
#include "hulls.h"
#include "measure.h"
#include "space_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace ncsim;
using bench::SpaceSweep;
using cda::ConvexPolytope;

constexpr std::size_t kMostHulls = 2000, kMostPairs = 3000, kMostForCgal = 200;

struct Pair {
    ConvexPolytope a, b;
    std::optional<ConvexPolytope> common;  ///< The exact intersection.
    bool is_special = false;
};

// Result of an intersection.
struct Answer {
    bool is_refused = false;
    double volume = 0.0;
    std::size_t corners = 0, facets = 0;
};

Answer answer_of(const std::optional<ConvexPolytope>& body) {
    if (!body) return {};
    return {false, body->volume(), body->vertices().size(), body->facets().size()};
}

std::vector<cda::Plane> planes_of(const Pair& pair) {
    std::vector<cda::Plane> planes;
    for (const ConvexPolytope* body : {&pair.a, &pair.b}) {
        for (const auto& facet : body->facets())
            planes.push_back(facet.plane);
    }
    std::ranges::sort(planes);
    const auto twice = std::ranges::unique(planes);
    planes.erase(twice.begin(), twice.end());
    return planes;
}

struct Pairs {
    std::size_t all = 0;  ///< Pairs whose boxes overlap; `taken` is a sample.
    std::vector<Pair> taken;
};

Pairs pairs_of(const std::vector<ConvexPolytope>& bodies) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> numbers;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        for (std::uint32_t k = 0; k < i; ++k) {
            if (bodies[k].bounds().overlaps(bodies[i].bounds())) numbers.emplace_back(k, i);
        }
    }
    Pairs pairs;
    pairs.all = numbers.size();
    if (numbers.size() > kMostPairs) {
        std::shuffle(numbers.begin(), numbers.end(), std::mt19937_64(2001));
        numbers.resize(kMostPairs);
    }
    for (const auto& [k, i] : numbers)
        pairs.taken.push_back({bodies[k], bodies[i], cda::intersect_exact(bodies[k], bodies[i])});
    return pairs;
}

// Returns the body, moved by whole units.
std::optional<ConvexPolytope> moved(const ConvexPolytope& body, cda::LatticePoint by,
                                    const cda::Lattice& lattice) {
    cda::Cell cell;
    for (const auto& facet : body.facets()) {
        cda::Plane plane = facet.plane;
        plane.d += plane.nx * by.x + plane.ny * by.y + plane.nz * by.z;
        cell.planes.push_back(cda::canonical(plane.nx, plane.ny, plane.nz, plane.d));
    }
    const Vec3 mm = lattice.to_mm(by);
    cell.bounds = {lattice.to_mm(body.bounds().min) + mm, lattice.to_mm(body.bounds().max) + mm};
    return ConvexPolytope::of(cell, lattice);
}

void move_second(std::vector<Pair>& pairs, const cda::Lattice& lattice) {
    std::mt19937_64 random(4101);
    const auto most = static_cast<std::int64_t>(0.1 / lattice.unit_mm);
    const auto some = [&] {
        return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) -
               most;
    };
    for (Pair& pair : pairs) {
        const std::int64_t x = some(), y = some(), z = some();
        pair.b = moved(pair.b, {x, y, z}, lattice).value();
        pair.common = cda::intersect_exact(pair.a, pair.b);
    }
}

double share(std::size_t part, std::size_t all) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(all, 1));
}

void print_positions(const std::string& title, std::size_t all, std::vector<Pair>& pairs) {
    std::size_t special = 0, meeting = 0, equal = 0, one_side = 0, face_to_face = 0, corner = 0,
                edge = 0, touching = 0;
    for (Pair& pair : pairs) {
        const bench::SpecialPosition p = bench::special_position(pair.a, pair.b);
        pair.is_special = p.any();
        special += p.any();
        // In general position, a pair with a common point has a common volume.
        meeting += p.any() || pair.common;
        equal += p.equal;
        one_side += p.facets_one_side;
        face_to_face += p.facets_face_to_face;
        corner += p.corner_on_surface;
        edge += p.edge_on_edge;
        touching += p.any() && !pair.common;
    }
    const std::size_t n = pairs.size();
    fmt::print(
        "| {} | {} | {} | {} | {:.1f} % | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n",
        title, all, n, meeting, share(special, meeting), share(one_side, meeting),
        share(face_to_face, meeting), share(corner, meeting), share(edge, meeting),
        share(touching, meeting), share(equal, meeting));
    std::fflush(stdout);
}

// Answers of a method, compared with the exact answers.
class Row {
public:
    Row(std::string title, std::string& table, std::string method)
        : title_(std::move(title)), table_(table), method_(std::move(method)) {}

    template <class Intersect>
    void measure(const std::vector<Pair>& pairs, std::size_t most, bool is_exact,
                 const Intersect& intersect) {
        const std::size_t n = std::min(pairs.size(), most);
        std::vector<Answer> answers(n);
        const double start = bench::cpu_seconds();
        for (std::size_t i = 0; i < n; ++i) {
            try {
                answers[i] = intersect(pairs[i]);
            } catch (const std::exception&) {
                answers[i].is_refused = true;
                ++thrown_;
            }
        }
        const double seconds = bench::cpu_seconds() - start;
        for (std::size_t i = 0; i < n; ++i)
            judge(pairs[i], answers[i], is_exact);
        table_ += fmt::format("| {} | {} | {} | {:.1f} | {} | {} | {} | {} |\n", title_, method_, n,
                              1e6 * seconds / static_cast<double>(std::max<std::size_t>(n, 1)),
                              right_, refused_ - thrown_, thrown_, wrong_);
    }

private:
    void judge(const Pair& pair, const Answer& answer, bool is_exact) {
        if (answer.is_refused) {
            ++refused_;
            return;
        }
        const Answer expected = answer_of(pair.common);
        const Vec3 size = pair.a.bounds().max - pair.a.bounds().min;
        // Corners are rounded to doubles.
        const double rounding = 1e-9 * expected.volume + 1e-12 * size.x * size.y * size.z;
        const bool is_right =
            std::abs(answer.volume - expected.volume) <= rounding &&
            (!is_exact || (answer.corners == expected.corners && answer.facets == expected.facets));
        ++(is_right ? right_ : wrong_);
        if (is_exact && !is_right)
            throw std::logic_error(title_ + ", " + method_ + ": another body than the exact one");
    }

    std::string title_;
    std::string& table_;
    std::string method_;
    std::size_t right_ = 0, refused_ = 0, thrown_ = 0, wrong_ = 0;
};

void compare(const std::string& title, const std::vector<Pair>& pairs, std::string& table) {
    std::size_t disagreements = 0;
    Row(title, table, "space sweep").measure(pairs, pairs.size(), true, [&](const Pair& pair) {
        const SpaceSweep sweep = bench::sweep_intersection(pair.a, pair.b);
        const bool is_special = sweep.outcome == SpaceSweep::Outcome::Special;
        disagreements += is_special != pair.is_special;
        Answer answer = answer_of(sweep.body);
        answer.is_refused = is_special;
        return answer;
    });
    cda::IntersectionCosts costs;
    Row(title, table, "linear program, dual, Quickhull; proved")
        .measure(pairs, pairs.size(), true, [&](const Pair& pair) {
            return answer_of(cda::intersect(pair.a, pair.b, costs));
        });
    Row(title, table, "plane by plane, integers")
        .measure(pairs, pairs.size(), true,
                 [](const Pair& pair) { return answer_of(cda::intersect_exact(pair.a, pair.b)); });
    const auto of_cgal = [](const bench::CgalBody& body) {
        return Answer{false, body.volume, body.corners, body.facets};
    };
    Row(title, table, "CGAL, halfspaces, doubles")
        .measure(pairs, kMostForCgal, false, [&](const Pair& pair) {
            return of_cgal(bench::cgal_intersection_in_doubles(planes_of(pair)));
        });
    Row(title, table, "CGAL, halfspaces, exact")
        .measure(pairs, kMostForCgal, false, [&](const Pair& pair) {
            return of_cgal(bench::cgal_intersection_exact(planes_of(pair)));
        });
    // Two tests for special position must agree: of both whole surfaces, and of the features that
    // the sweep plane meets.
    if (disagreements != 0)
        throw std::logic_error(fmt::format("{}: {} pairs are special to one and not to the other",
                                           title, disagreements));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::string> names(argv + 1, argv + argc);
        if (names.empty()) {
            names = {NCSIM_SOURCE_DIR "/samples/simple.nc",
                     NCSIM_SOURCE_DIR "/samples/complex.nc",
                     NCSIM_SOURCE_DIR "/samples/wave.nc",
                     "wave-10000",
                     "finish-35000",
                     "pocket-10000",
                     "drill-10000",
                     "contour-1000",
                     "bores-10",
                     "rotary-1000"};
        }
        std::string costs;  // the second table
        fmt::print(
            "| program | boxes overlap | looked at | meet | of them special | facets in one "
            "plane, % | face to face, % | corner on surface, % | edge on edge, % | "
            "only touching, % | equal, % |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
        for (const std::string& name : names) {
            const bench::Hulls hulls = bench::hulls_of(name, kMostHulls);
            Pairs uncut = pairs_of(bench::bodies_of(hulls, bench::Within::Lattice));
            print_positions(hulls.name + ", not cut out of the stock", uncut.all, uncut.taken);
            uncut.taken.clear();
            Pairs pairs = pairs_of(bench::bodies_of(hulls, bench::Within::Stock));
            print_positions(hulls.name, pairs.all, pairs.taken);
            compare(hulls.name, pairs.taken, costs);
            move_second(pairs.taken, hulls.lattice);
            print_positions(hulls.name + ", moved", pairs.all, pairs.taken);
            compare(hulls.name + ", moved", pairs.taken, costs);
        }
        fmt::print(
            "\n| program | method | pairs | µs a pair | right | handed back | thrown | "
            "wrong |\n|---|---|---|---|---|---|---|---|\n{}",
            costs);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "polytope_table: %s\n", e.what());
        return 2;
    }
    return 0;
}
