// SPDX-License-Identifier: GPL-3.0-or-later
//
// How large faces and solids are, and where their middles are.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>

namespace ncsim::brep {

/// By integrals along the edges, without triangles.
struct Measure {
    double area = 0.0;    ///< mm²
    double length = 0.0;  ///< Of its edges, mm.
    /// mm³: of the cone from `apex` over the face, the sum of which over a shell is its volume.
    double volume = 0.0;
};
enum class Exactness : std::uint8_t {
    Full,
    Rough,  ///< Of envelopes within some 1e-5, at a fraction of the cost.
};
Measure measure(const Part& part, const Face& face, Vec3 apex,
                Exactness exactness = Exactness::Full);

/// Of all solids, mm³.
double volume(const Part& part);

/// Of a body, as CAD programs tell it to each other.
struct Mass {
    double volume = 0.0, area = 0.0;  ///< mm³, mm²
    Vec3 centroid;                    ///< mm
};
/// By integrals along the edges, too. Of what is flat within splines as exact as these are.
Mass mass_of(const Part& part, const Solid& solid);
/// Of all solids; the middle of nothing is the zero.
Mass mass_of(const Part& part);

}  // namespace ncsim::brep
