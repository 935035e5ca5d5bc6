// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a part is shaded that was milled by round tools: by the normals of the surfaces that its
// facets approximate, so that a bore looks round and not like a prism. Nothing is moved.
#pragma once

#include "ncsim/brep/surface.h"
#include "ncsim/brep/swept.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/origin.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// No normal turns away from that of its facet by more than 60° (this is the cosine). Of round
/// tools of 16 sides it is 12° and less.
inline constexpr double kLeastShadingCosine = 0.5;

/// A normal for each corner of each face of a boundary.
class Shading {
public:
    /// What is known of a face.
    enum class Known : std::uint8_t {
        Nothing,  ///< Not which surface it is of.
        Flat,     ///< It is of a plane.
        Round,    ///< It is of something else.
    };

    /// Of nothing anything is known.
    Shading() = default;

    Known known(std::uint32_t face) const;

    /// Unit, out of the material, in the corner `vertex` of a face whose own normal is `own`: that
    /// of its surface, if that is round, else `own`, and so where the two differ by more than 60°.
    ///
    /// Where round tools are polygons, walls that touch (a slot and its round end) meet beside the
    /// line in which the surfaces do, by half a side: those that meet there at 1° to 60° have
    /// the normals of the point that is on both. Edges that are sharper have a normal for each
    /// face. `point` is where the corner is, mm; it decides for corners that the boundary does
    /// not have.
    Vec3 normal(std::uint32_t face, Vec3 own, std::uint32_t vertex, Vec3 point) const;
    /// The same, but zero where a surface has no normal: in the tip of a cone. From there to the
    /// other corners it is theirs alone.
    Vec3 normal_or_none(std::uint32_t face, Vec3 own, std::uint32_t vertex, Vec3 point) const;

private:
    friend class ShadingMaker;
    struct Corner {
        std::uint32_t surface = 0;  ///< Index into surfaces_.
        Vec3 normal;
    };

    std::vector<Surface> surfaces_;
    std::vector<std::uint32_t> of_face_;  // index into surfaces_, or kNone
    std::vector<std::uint32_t> first_;    // for each vertex, where in corners_ its own begin
    std::vector<Corner> corners_;         // of round surfaces
};

/// Makes the shading of a boundary from the sources of those who cut it, which come one by one, so
/// that nobody has to keep all of them.
class ShadingMaker {
public:
    /// `boundary` must outlive it.
    explicit ShadingMaker(const cda::Boundary& boundary);

    /// Each face of `origin` is of the surface, among those of `source`, that it turns away from
    /// least, if all its corners are within three times the error of that. O(n m) for n
    /// corners and m surfaces.
    void take(cda::Origin origin, const Source& source);
    /// The last that is asked. O(n log n) for n corners.
    Shading finish();

private:
    const cda::Boundary& boundary_;
    std::vector<std::uint32_t> by_origin_;  // faces
    std::vector<double> errors_;            // of the surfaces of shading_, mm
    Shading shading_;
};

}  // namespace ncsim::brep
