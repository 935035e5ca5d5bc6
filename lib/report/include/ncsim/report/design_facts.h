// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is the part what it was meant to be? In numbers and in words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace ncsim::report {

/// What came out of the comparison, beside the findings; see verify/design.h. mm, mm³.
struct DesignFacts {
    std::string path;
    double tolerance_mm = 0.0, resolution_mm = 0.0, deviation_mm = 0.0;
    struct Side {
        double largest_mm = 0.0;  ///< 0: nothing beyond the tolerance.
        std::optional<double> volume_mm3;
        std::size_t regions = 0;
    };
    Side gouge, excess;
};

/// "part.stl within 0.1 mm: nothing beyond; farthest apart 0.03 mm": a line for people.
std::string text_of(const DesignFacts& facts);

}  // namespace ncsim::report
