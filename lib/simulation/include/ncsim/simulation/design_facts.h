// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of the part with the design, as numbers.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace ncsim::simulation {

/// Results of the comparison in addition to the findings; see verify/design.h. mm, mm³.
struct DesignFacts {
    std::string path;
    double tolerance_mm = 0.0, resolution_mm = 0.0, deviation_mm = 0.0;
    /// Deviation in one direction.
    struct Side {
        double largest_mm = 0.0;  ///< Largest deviation; 0: none beyond the tolerance.
        std::optional<double> volume_mm3;
        std::size_t regions = 0;
    };
    Side gouge, excess;
};

/// A place where the part deviates from the design.
struct DesignPlace {
    bool is_gouge = false;   ///< Otherwise material is left.
    double depth_mm = 0.0;   ///< Largest deviation.
    Vec3 point;              ///< Point of the largest deviation; mm, W.
    std::uint32_t line = 0;  ///< Line that cut the part there; 0: none, or in a called file.
};

}  // namespace ncsim::simulation
