// SPDX-License-Identifier: GPL-3.0-or-later
//
// Candidate surfaces as lines of text, for stock files, and their movement with the stock.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/brep/swept_surfaces.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::brep {

/// Rotation, then translation.
struct RigidMotion {
    std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  ///< Of the rotation.
    Vec3 shift;                                                             ///< mm
};

/// Returns `candidate` as a line: the name of the form, lengths (mm) and directions, then the
/// marks, for example `cylinder 10 20 0 0 0 1 4 hollow`. Numbers are the shortest that read back as
/// the same values.
/// Requires: a form on which faces may lie (kForms).
std::string text_of(const CandidateSurface& candidate);

/// Reads a line of text_of(). Returns: no value if the text has another form, if a number is not
/// finite or a length is out of range, or if directions are not unit or not perpendicular as the
/// form requires.
std::optional<CandidateSurface> candidate_of(std::string_view text);

/// Returns `candidate` after `motion`. Boxes are replaced by boxes around the moved boxes.
CandidateSurface moved(const CandidateSurface& candidate, const RigidMotion& motion);

}  // namespace ncsim::brep
