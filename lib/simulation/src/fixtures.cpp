// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position of fixtures relative to the part.
#include "ncsim/simulation/fixtures.h"

#include "ncsim/setup/coordinate_systems.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace ncsim::simulation {

namespace {

// Corners of the faces of a box, counter-clockwise as seen from outside.
constexpr std::array<std::array<std::uint32_t, 4>, 6> kFacesOfBox{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

}  // namespace

std::vector<std::string> place_fixtures(verify::MachineDescription& machine, const Plan& plan,
                                        const Survey& survey) {
    std::vector<std::string> lost;
    std::erase_if(machine.fixtures, [&](verify::Fixture& fixture) {
        const int here = survey.interpretation.workpiece_system;
        if (fixture.system == 0 || fixture.system == here) return false;
        const auto origin = setup::origin_of(plan.job.interpreter, fixture.system);
        if (!origin || !machine.work_zero) {
            lost.push_back(fmt::format(
                "position of the fixture '{}': it is specified in {}, and the distance "
                "from there to {} is not",
                fixture.name, setup::name_of_system(fixture.system), setup::name_of_system(here)));
            return true;
        }
        const Vec3 shift = *origin - *machine.work_zero;
        fixture.box.min = fixture.box.min + shift;
        fixture.box.max = fixture.box.max + shift;
        for (Vec3& p : fixture.mesh.vertices)
            p = p + shift;
        return false;
    });
    return lost;
}

std::vector<std::string> fixtures_in_stock(const Survey& survey,
                                           const verify::MachineDescription& machine) {
    constexpr double kDeep = 0.01;  // mm
    std::vector<std::string> found;
    const bool is_block = survey.stock && !survey.stock->shape && !survey.stock->is_round &&
                          survey.stock->specified_by != toolpath::ValueSource::Assumption &&
                          !survey.stock->place_assumed;
    if (!is_block) return found;
    const Box& block = survey.stock->box;
    const auto is_inside = [&](const Vec3& p) {
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] < block.min[axis] + kDeep || p[axis] > block.max[axis] - kDeep)
                return false;
        }
        return true;
    };
    for (const verify::Fixture& fixture : machine.fixtures) {
        if (fixture.system != 0 && fixture.system != survey.interpretation.workpiece_system)
            continue;
        bool overlaps = std::ranges::any_of(fixture.mesh.vertices, is_inside);
        if (fixture.mesh.triangles.empty()) {
            overlaps = true;
            for (int axis = 0; axis < 3; ++axis) {
                overlaps &= std::min(block.max[axis], fixture.box.max[axis]) -
                                std::max(block.min[axis], fixture.box.min[axis]) >
                            kDeep;
            }
        }
        if (overlaps) found.push_back(name_of(fixture) + " is inside the stock");
    }
    return found;
}

exporter::Body body_of(const verify::Fixture& fixture) {
    exporter::Body body;
    body.colour = {112, 130, 152};
    const auto add_face = [&body](std::vector<std::uint32_t> loop) {
        const auto& v = body.surface.vertices;
        const Vec3 across = cross(v[loop[1]] - v[loop[0]], v[loop[2]] - v[loop[0]]);
        if (norm(across) == 0.0) return;
        cda::BoundaryFace face;
        face.normal = normalized(across);
        face.offset = dot(face.normal, v[loop[0]]);
        face.loops = {std::move(loop)};
        body.surface.faces.push_back(std::move(face));
    };
    body.surface.shells = 1;
    if (!fixture.mesh.triangles.empty()) {
        body.surface.vertices = fixture.mesh.vertices;
        for (const auto& t : fixture.mesh.triangles)
            add_face({t[0], t[1], t[2]});
        return body;
    }
    const Box& box = fixture.box;
    // Bits 0, 1 and 2 of a corner's number: the upper end of x, y and z.
    for (unsigned corner = 0; corner < 8; ++corner) {
        body.surface.vertices.push_back({(corner & 1U) != 0 ? box.max.x : box.min.x,
                                         (corner & 2U) != 0 ? box.max.y : box.min.y,
                                         (corner & 4U) != 0 ? box.max.z : box.min.z});
    }
    for (const std::array<std::uint32_t, 4>& c : kFacesOfBox)
        add_face({c.begin(), c.end()});
    return body;
}

Box box_with_fixtures(const Box& stock, std::span<const verify::Fixture> fixtures) {
    Box all = stock;
    const double reach = 0.5 * norm(stock.size());
    for (const verify::Fixture& fixture : fixtures) {
        for (Vec3 p : {fixture.box.min, fixture.box.max}) {
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = std::clamp(p[axis], stock.min[axis] - reach, stock.max[axis] + reach);
            all.add(p);
        }
    }
    return all;
}

double reach_of(std::span<const verify::Fixture> fixtures) {
    Box all;
    all.add(Vec3{});
    for (const verify::Fixture& fixture : fixtures) {
        all.add(fixture.box.min);
        all.add(fixture.box.max);
    }
    return norm(all.size());
}

bool add_fixtures(setup::MachineFile& machine, const setup::Job& job) {
    if (job.below_stock) machine.machine.below_stock = *job.below_stock;
    if (!job.fixtures_specified) return false;
    machine.machine.fixtures_specified = true;
    auto& fixtures = machine.machine.fixtures;
    fixtures.insert(fixtures.end(), job.fixtures.begin(), job.fixtures.end());
    return true;
}

}  // namespace ncsim::simulation
