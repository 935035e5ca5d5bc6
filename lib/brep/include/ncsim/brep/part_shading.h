// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shading of parts that were milled by round tools, by the normals of the surfaces that the facets
// approximate. A bore looks round, not like a prism. No vertex is moved.
#pragma once

#include "ncsim/brep/candidate_filter.h"
#include "ncsim/brep/surface_forms.h"
#include "ncsim/brep/swept_surfaces.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/origin.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Cosine of the largest angle between a normal and the normal of its facet, 60°. For round tools
/// with 16 sides, the angle is at most 12°.
inline constexpr double kLeastShadingCosine = 0.5;

/// Normals for the corners of the faces of a boundary.
class Shading {
public:
    /// State of recognition of a face.
    enum class Recognition : std::uint8_t {
        Unknown,  ///< The surface is unknown.
        Planar,   ///< The surface is a plane.
        Curved,   ///< The surface is no plane.
    };

    /// Constructs a shading in which all faces are unknown.
    Shading() = default;

    /// Returns the state of `face`; Unknown for faces that the boundary does not have.
    Recognition recognition(std::uint32_t face) const;

    /// Returns the surface of `face`; null if the surface is unknown.
    const Surface* surface_of(std::uint32_t face) const;

    /// Returns the unit normal, out of the material, in the corner `vertex` of a face with the
    /// normal `own`. The result is the normal of the face's surface if the surface is round and
    /// deviates from `own` by at most 60°, otherwise `own`.
    ///
    /// Because polygons stand for round tools, tangent walls (a slot and its round end) meet up to
    /// half a side from the line of tangency. Surfaces that meet in a corner at 1° to 60° therefore
    /// get the normals of the point that lies on both. Sharper edges have a normal for each face.
    /// `point` is the position of the corner, mm; it is used for vertices that the boundary does
    /// not have.
    Vec3 normal(std::uint32_t face, Vec3 own, std::uint32_t vertex, Vec3 point) const;
    /// Returns the same, but zero where a surface has no normal, in the tip of a cone. The normals
    /// of the other corners of the face then determine the shading.
    Vec3 normal_or_none(std::uint32_t face, Vec3 own, std::uint32_t vertex, Vec3 point) const;

private:
    friend class ShadingMaker;
    /// Normal of a surface in a corner.
    struct Corner {
        std::uint32_t surface = 0;  ///< Index into surfaces_.
        Vec3 normal;
    };

    std::vector<Surface> surfaces_;
    std::vector<std::uint32_t> of_face_;  // Index into surfaces_, or kNone.
    std::vector<std::uint32_t> first_;    // For each vertex, index of its first corner in corners_.
    std::vector<Corner> corners_;         // Of round surfaces.
};

/// Makes the shading of a boundary from sources that are passed singly, so the caller need not keep
/// all of them.
class ShadingMaker {
public:
    /// `boundary` must outlive the maker.
    explicit ShadingMaker(const cda::Boundary& boundary);

    /// Assigns to each face of `origin` the surface of `source` from which the face deviates least
    /// in direction, if all corners of the face are within three times the error of the source
    /// (four times for coils, six times for flanks and peaks).
    /// Cost: O(n m) for n corners and m surfaces.
    void take(cda::Origin origin, const SweptSurfaces& source);
    /// Returns the shading. No member function may be called afterwards. Cost: O(n log n) for n
    /// corners.
    Shading finish();

private:
    const cda::Boundary& boundary_;
    FacesByOrigin by_origin_;
    std::vector<double> errors_;  // Error of each surface of shading_, mm.
    Shading shading_;
};

}  // namespace ncsim::brep
