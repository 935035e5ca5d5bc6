// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of the part with the design, as numbers and as text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace ncsim::report {

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

/// Returns a line such as "part.stl within 0.1 mm: nothing beyond; farthest apart 0.03 mm".
std::string text_of(const DesignFacts& facts);

}  // namespace ncsim::report
