// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of the part with the design, as text.
#pragma once

#include "ncsim/simulation/design_facts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ncsim::report {

using simulation::DesignFacts;
using simulation::DesignPlace;

/// Returns the largest places, up to `most`.
std::vector<DesignPlace> largest(std::vector<DesignPlace> places, std::size_t most);
/// Returns a text like "gouge 1 mm, line 7, at X-40 Y-20 Z-2".
std::string text_of(const DesignPlace& place);

/// Returns a line like "part.stl within 0.1 mm: nothing beyond; farthest apart 0.03 mm".
std::string text_of(const DesignFacts& facts);

}  // namespace ncsim::report
