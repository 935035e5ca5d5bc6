// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares sorted corners and volumes of both models.
#include "nef/agreement.h"

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/tree.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/setup/job.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/walk.h"

#include "support/oracle.h"
#include "support/random_shapes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace ncsim::test {

namespace {

// True if the faces at a place have normals of three directions. Otherwise the place is on an edge,
// or in a face that two motions left.
bool spans_space(const std::vector<Vec3>& normals) {
    for (std::size_t i = 1; i < normals.size(); ++i) {
        const Vec3 along = cross(normals[0], normals[i]);
        if (norm(along) < 1e-9) continue;
        for (std::size_t k = i + 1; k < normals.size(); ++k) {
            if (std::abs(dot(along, normals[k])) > 1e-9 * norm(along)) return true;
        }
        return false;
    }
    return false;
}

auto key(const Vec3& p) {
    return std::tuple{p.x, p.y, p.z};
}

// Returns the vertices of a boundary at which faces of three directions meet, in mm.
std::vector<Vec3> corners_of(const cda::Boundary& boundary) {
    std::vector<std::pair<Vec3, Vec3>> all;  // place, normal of a face there
    for (const cda::BoundaryFace& face : boundary.faces) {
        for (const auto& loop : face.loops) {
            for (const std::uint32_t v : loop)
                all.emplace_back(boundary.vertices[v], face.normal);
        }
    }
    std::ranges::sort(all, {}, [](const auto& at) { return key(at.first); });
    std::vector<Vec3> corners;
    for (std::size_t begin = 0; begin < all.size();) {
        std::size_t end = begin;
        std::vector<Vec3> normals;
        while (end < all.size() && all[end].first == all[begin].first)
            normals.push_back(all[end++].second);
        if (spans_space(normals)) corners.push_back(all[begin].first);
        begin = end;
    }
    return corners;
}

std::string text_of(const Vec3& p) {
    std::ostringstream out;
    out.precision(17);
    out << p.x << ' ' << p.y << ' ' << p.z;
    return out.str();
}

}  // namespace

std::string disagreement(const cda::Cell& stock, const std::vector<cda::Cell>& cells,
                         const std::vector<cda::Cell>& others) {
    NefPart expected(stock);
    for (const cda::Cell& cell : cells)
        expected.subtract(cell);
    cda::TreeCda part(stock, kLattice, {24, 1});
    part.subtract_unmeasured(others);
    // Both models round the exact corner once, in units or in mm, so corners agree up to the last
    // bits.
    const std::vector<Vec3> found = corners_of(part.boundary());
    std::vector<Vec3> corners;
    for (const Vec3& p : expected.corners())
        corners.push_back(kLattice.to_mm(p));
    const auto is_same = [](const Vec3& a, const Vec3& b) { return norm(a - b) < 1e-12; };
    const auto has = [&](const std::vector<Vec3>& all, const Vec3& p) {
        const auto from = std::ranges::lower_bound(all, p.x - 1e-12, {}, &Vec3::x);
        return std::any_of(from, std::ranges::upper_bound(all, p.x + 1e-12, {}, &Vec3::x),
                           [&](const Vec3& q) { return is_same(p, q); });
    };
    for (const Vec3& p : corners) {
        if (!has(found, p)) return "cda has no corner " + text_of(p);
    }
    for (const Vec3& p : found) {
        if (!has(corners, p)) return "boundary evaluation has no corner " + text_of(p);
    }
    if (found.size() != corners.size()) return "the numbers of corners differ";
    const double volume = expected.volume() * kLattice.cubic_unit_mm3();
    if (std::abs(volume - part.volume()) > 1e-12 * std::max(volume, 1.0)) {
        std::ostringstream out;
        out.precision(17);
        out << "the volumes differ: " << volume << " and " << part.volume();
        return out.str();
    }
    return {};
}

std::string disagreement_of_boxes(std::uint64_t seed) {
    Random random(seed);
    std::vector<cda::Cell> cells;
    const std::int64_t count = random.between(1, 10);
    for (std::int64_t i = 0; i < count; ++i) {
        const auto b = random_grid_box(random);
        if (b[0] == b[3] || b[1] == b[4] || b[2] == b[5]) continue;
        cells.push_back(mm_box(b[0], b[1], b[2], b[3], b[4], b[5],
                               cda::Origin{static_cast<std::uint32_t>(i + 1)}));
    }
    constexpr int n = UnitCubes::kSize;
    return disagreement(mm_box(0, 0, 0, n, n, n), cells, cells);
}

std::string disagreement_of_hulls(std::uint64_t seed) {
    Random random(seed);
    std::vector<cda::Cell> cells;
    const std::int64_t count = random.between(1, 6);
    for (std::int64_t i = 0; i < count; ++i) {
        cells.push_back(random_hull(random, random_point(random, 300000),
                                    random.between(100000, 300000),
                                    static_cast<int>(random.between(4, 12)),
                                    cda::Origin{static_cast<std::uint32_t>(i + 1)}));
    }
    return disagreement(mm_box(-3, -3, -3, 3, 3, 3), cells, cells);
}

std::string disagreement_of_program(const std::string& path, std::size_t most) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    simulation::Plan plan;
    plan.job = setup::job_of({path, std::string(std::istreambuf_iterator<char>(file), {})});
    const simulation::Survey survey = simulation::survey(plan);
    if (!survey.is_ready()) throw std::runtime_error(path + " is not simulated");
    const Box box = survey.stock->box;
    toolpath::ToolAccuracy accuracy;
    accuracy.tolerance_mm = plan.tool_tolerance;
    toolpath::Walk walk(kLattice, box, {accuracy});
    for (const auto& [number, used] : survey.tools)
        walk.add_tool(number, used.tool);
    std::vector<cda::Cell> cells;
    gcode::interpret(plan.job.program, plan.job.interpreter, [&](const gcode::Motion& motion) {
        const cda::Origin origin{static_cast<std::uint32_t>(cells.size() + 1)};
        walk.take(motion, origin, [&](const toolpath::Step& step) {
            for (const cda::Cell& cell : step.cells) {
                if (cells.size() < most) cells.push_back(cell);
            }
        });
    });
    const cda::Cell stock =
        cda::box_cell(kLattice.round(box.min), kLattice.round(box.max), kLattice);
    return disagreement(stock, cells, cells);
}

}  // namespace ncsim::test
