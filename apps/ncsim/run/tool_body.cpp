// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes bodies of tools.
#include "run/tool_body.h"

#include "ncsim/cda/flat.h"
#include "ncsim/cda/hull.h"
#include "ncsim/toolpath/tool_polytope.h"

#include "run/finding_colours.h"

namespace ncsim::app {

namespace {

// Coarse enough for tools up to three metres long.
constexpr cda::Lattice kLattice{1e-4};
constexpr toolpath::ToolAccuracy kAccuracy{0.02, toolpath::Side::Circumscribed};

constexpr exporter::Rgba8 kCutting{226, 186, 92};
constexpr exporter::Rgba8 kHolder{118, 124, 134};

}  // namespace

std::vector<exporter::Body> tool_bodies(const toolpath::Tool& tool, const toolpath::Pose& X_WT,
                                        bool is_marked) {
    const exporter::Rgba8 cutting = is_marked ? kMarkedTool : kCutting;
    const exporter::Rgba8 holder = is_marked ? kMarkedHolder : kHolder;
    const toolpath::Pose R_WT{X_WT.rows, {}};
    std::vector<exporter::Body> bodies;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        const auto polytope = toolpath::approximate(piece, kLattice, kAccuracy);
        const auto cell = cda::convex_hull(polytope.points_T, kLattice, cda::kStockOrigin);
        if (!cell) continue;
        exporter::Body body{cda::FlatCda().create(*cell, kLattice)->boundary(),
                            piece.cutting ? cutting : holder};
        for (Vec3& p : body.surface.vertices)
            p = X_WT * p;
        for (cda::BoundaryFace& face : body.surface.faces) {
            face.normal = R_WT * face.normal;
            face.offset = dot(face.normal, body.surface.vertices[face.loops[0][0]]);
        }
        bodies.push_back(std::move(body));
    }
    return bodies;
}

}  // namespace ncsim::app
