// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surface of the material that one part has and another part lacks: lines that left the surface,
// and the direction in which most of the surface faces.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/origin.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/export/camera.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/region.h"

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace ncsim::simulation {

/// Views along the axes, in the order of their preference.
inline constexpr std::array<exporter::View, 6> kAxisViews{
    exporter::View::Top,  exporter::View::Front, exporter::View::Right,
    exporter::View::Back, exporter::View::Left,  exporter::View::Bottom};

/// Areas by view of kAxisViews, mm², projected along the view.
using SeenAreas = std::array<double, kAxisViews.size()>;

/// Surface of the material of `part` that `common` lacks.
class DifferenceSurface {
public:
    /// Requires: `boundary` is the surface of `part`, which kept its cuts; `common` is a subset of
    /// `part`; all outlive the object.
    DifferenceSurface(const Simulation& part, const cda::Boundary& boundary,
                      const cda::WorkpieceModel& common);

    /// Surface in a box.
    struct Found {
        /// Lines that left the surface. Lines of small faces may be missing.
        std::vector<verify::LineRange> lines;
        bool has_stock = false;  ///< A surface is uncut stock.
        /// Point of the largest face; empty if no face was found.
        std::optional<Vec3> point;
    };
    /// Adds the area of the surface in `box` to `seen`.
    /// Cost: a few point queries for each triangle in the box, at most kMostQueries altogether.
    Found find_in(const Box& box, SeenAreas& seen);

    static constexpr std::size_t kMostQueries = 1'000'000;

private:
    std::optional<Vec3> exposed_point(std::span<const Vec3> polygon, Vec3 normal);
    void add_lines(const std::set<cda::Origin>& origins, Found& result) const;

    const Simulation& part_;
    const cda::Boundary& boundary_;
    const cda::WorkpieceModel& common_;
    TriangleMesh mesh_;
    std::size_t queries_ = 0;
};

}  // namespace ncsim::simulation
