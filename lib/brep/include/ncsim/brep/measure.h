// SPDX-License-Identifier: GPL-3.0-or-later
//
// Areas, volumes and centroids of faces and solids.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>

namespace ncsim::brep {

/// Measures of a face, from integrals along the edges, without triangles.
struct Measure {
    double area = 0.0;    ///< mm²
    double length = 0.0;  ///< Total length of the edges, mm.
    /// Signed volume of the cone from `apex` over the face, mm³. The sum over a shell is the volume
    /// of the shell.
    double volume = 0.0;
};
/// Accuracy of a measurement.
enum class Exactness : std::uint8_t {
    Full,
    Rough,  ///< Envelopes to a relative error of about 1e-5, at a fraction of the cost.
};
/// Returns the measures of `face`, with the volume of the cone from `apex` over the face.
Measure measure(const Part& part, const Face& face, Vec3 apex,
                Exactness exactness = Exactness::Full);

/// Returns the total volume of all solids, mm³.
double volume(const Part& part);

/// Mass properties of a body of density 1, as CAD systems report them.
struct Mass {
    double volume = 0.0, area = 0.0;  ///< mm³, mm²
    Vec3 centroid;                    ///< mm
};
/// Returns the mass properties of `solid`, from integrals along the edges. Planar faces that are
/// bounded by splines are as exact as the splines.
Mass mass_of(const Part& part, const Solid& solid);
/// Returns the mass properties of all solids together; the centroid is zero if `part` has no solid.
Mass mass_of(const Part& part);

}  // namespace ncsim::brep
