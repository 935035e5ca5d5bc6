// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the exact model with boundary evaluation. Each function returns the difference, or an
// empty string if both models agree.
#pragma once

#include "ncsim/cda/cell.h"

#include "nef/nef_part.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::test {

/// Compares corners and volume: NefPart for the stock less `cells`, the model cda for the stock
/// less `others`.
std::string disagreement(const cda::Cell& stock, const std::vector<cda::Cell>& cells,
                         const std::vector<cda::Cell>& others);

/// Compares random boxes on the grid of the unit cubes. `disagreement_of_hulls` compares random
/// hulls in a cube of 6 mm.
std::string disagreement_of_boxes(std::uint64_t seed);
std::string disagreement_of_hulls(std::uint64_t seed);

/// Compares the first `most` hulls of a program.
/// Requires: the stock is a box.
std::string disagreement_of_program(const std::string& path, std::size_t most);

}  // namespace ncsim::test
