// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nesting of shells by signed volumes and winding numbers.
#include "topology/nesting.h"

#include "ncsim/base/angles.h"

#include <cstddef>
#include <optional>
#include <span>

namespace ncsim::brep {

namespace {

// Returns six times the volume inside the faces, negative for a void.
double sixfold_volume(const cda::Boundary& boundary, std::span<const std::uint32_t> faces) {
    double sum = 0.0;
    const Vec3 apex = boundary.vertices[boundary.faces[faces[0]].loops[0][0]];
    for (const std::uint32_t f : faces) {
        for (const auto& loop : boundary.faces[f].loops) {
            const Vec3 a = boundary.vertices[loop[0]] - apex;
            for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
                sum += dot(a, cross(boundary.vertices[loop[i]] - apex,
                                    boundary.vertices[loop[i + 1]] - apex));
            }
        }
    }
    return sum;
}

// Returns how often the faces wind around `p`: ±1 inside, 0 outside, by the signed solid angles of
// triangles.
// Source: van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983.
double winding_number(const cda::Boundary& boundary, std::span<const std::uint32_t> faces, Vec3 p) {
    double sum = 0.0;
    for (const std::uint32_t f : faces) {
        for (const auto& loop : boundary.faces[f].loops) {
            const Vec3 a = normalized(boundary.vertices[loop[0]] - p);
            for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
                const Vec3 b = normalized(boundary.vertices[loop[i]] - p);
                const Vec3 c = normalized(boundary.vertices[loop[i + 1]] - p);
                sum += 2.0 * angle_of(1.0 + dot(a, b) + dot(b, c) + dot(c, a), dot(a, cross(b, c)));
            }
        }
    }
    return sum / 720.0;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> shells_of(const cda::Boundary& boundary) {
    std::vector<std::vector<std::uint32_t>> shells(boundary.shells);
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        const std::uint32_t shell = boundary.faces[f].shell;
        if (shell >= shells.size()) shells.resize(std::size_t{shell} + 1);
        shells[shell].push_back(f);
    }
    return shells;
}

std::vector<Nesting> nesting_of(const cda::Boundary& boundary) {
    const auto shells = shells_of(boundary);
    std::vector<Nesting> solids;
    std::vector<double> volumes;  // of solids, sixfold
    std::vector<std::uint32_t> voids;
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
        if (shells[s].empty()) continue;
        const double volume = sixfold_volume(boundary, shells[s]);
        if (volume > 0.0) {
            solids.push_back({s, {}});
            volumes.push_back(volume);
        } else {
            voids.push_back(s);
        }
    }
    if (solids.empty() && voids.size() == 1) return {{voids.front(), {}}};
    for (const std::uint32_t s : voids) {
        const Vec3 point = boundary.vertices[boundary.faces[shells[s][0]].loops[0][0]];
        // A single solid, the usual case, needs no test. If a solid is in a void of another solid,
        // the innermost solid around the point has the void.
        const auto encloses = [&](std::size_t i) {
            return solids.size() == 1 ||
                   winding_number(boundary, shells[solids[i].outside], point) > 0.5;
        };
        std::optional<std::size_t> innermost;
        for (std::size_t i = 0; i < solids.size(); ++i) {
            if (encloses(i) && (!innermost || volumes[i] < volumes[*innermost])) innermost = i;
        }
        if (innermost) solids[*innermost].voids.push_back(s);
    }
    return solids;
}

}  // namespace ncsim::brep
