// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces that a motion can leave behind: the surfaces swept by the elements of the tool's
// profile, and those of the tool at rest at the start and the end.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/brep/surface_forms.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool.h"

#include <array>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// Surface that a motion may have left.
struct CandidateSurface {
    Surface surface;
    bool is_at_rest = false;  ///< True for surfaces of the tool in its first or last pose.
    /// Box around the part of the surface that the motion left, nearly, for surfaces that extend
    /// beyond that part. A face outside the box does not belong to this candidate.
    std::optional<Box> place{};
    /// Planes across the path at the start and the end of a piece of the path, with normals along
    /// the path. A facet belongs to the piece that contains its centroid.
    std::optional<std::array<Plane, 2>> ends{};
    /// Axis of the tool, if the surface is that of a rounded element below an upright side. A facet
    /// parallel to the axis is left by the side.
    std::optional<Vec3> below_side{};
};

/// Candidate surfaces of the facets that a motion left. No vertex of a facet is farther than
/// `error_mm` from the candidate that the facet approximates.
struct SweptSurfaces {
    std::vector<CandidateSurface> candidates;
    double error_mm = 0.0;
    /// Additional deviation of facets, as a multiple of the chord error of the path; 0 for straight
    /// moves.
    double chords = 1.0;
    /// Largest distance between the candidates and the true surfaces, mm; splines are replaced by
    /// arcs.
    double deviation_mm = 0.0;
    /// True if the motion may leave surfaces that are not listed. A facet that matches no candidate
    /// stays a facet, whatever its size.
    bool may_leave_other_surfaces = false;
};

/// Returns the surfaces that `motion` can leave.
///
/// A tool that keeps its direction leaves, by element of its profile:
///
/// | element | line | line along the axis | arc about an axis parallel to the tool's |
/// | --- | --- | --- | --- |
/// | disc | plane, if level | plane | plane, if level |
/// | upright | 2 planes | cylinder | 2 cylinders, also on helices |
/// | sloping | 2 planes | cone | 2 cones, if level |
/// | rounded | 2 cylinders, if level | torus | 2 tori, if level |
/// | ball | cylinder | sphere | torus, in any plane |
/// | corner | extrusion, if not level | | coil, if a helix; dome, in upright planes |
///
/// Rounded elements and balls leave envelopes on all remaining lines and arcs: helices, spirals,
/// arcs in oblique planes. A rounded element must rise or fall along the whole path. A path of more
/// than 0.7 turns leaves an envelope per half turn.
///
/// Arcs whose radius changes by more than 4 µm leave planes below flat ends and spirals along
/// upright sides. No surface is returned for:
/// - corners on lines that rise by less than 1 µm per mm,
/// - arcs whose radius changes by more than a fifth of the radius per radian.
///
/// A tool that changes its direction leaves envelopes on lines: of sides and balls, and of corner
/// radii and rims unless the flat end is level somewhere; also the surfaces at rest. On a circle
/// around a fixed line, balls and corner radii leave tori, and flat ends a cylinder.
///
/// A null machine stands for the default machine; the machine may hold the tool or the part at any
/// angle. SweptSurfaces::may_leave_other_surfaces is true if any surface is missing. The caller
/// sets SweptSurfaces::error_mm.
SweptSurfaces surfaces_of(const gcode::Motion& motion, const toolpath::Tool& tool,
                          const toolpath::Kinematics* specified);

/// Returns the surfaces of the stock: six planes, or a cylinder and two planes. Empty for stock
/// from a file, whose facets stay facets.
std::vector<CandidateSurface> surfaces_of(const toolpath::Stock& stock);

}  // namespace ncsim::brep
