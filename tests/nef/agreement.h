// SPDX-License-Identifier: GPL-3.0-or-later
//
// Do the exact model and boundary evaluation make the same part? Each function says in what they
// differ; nothing: they agree.
#pragma once

#include "ncsim/cda/cell.h"

#include "nef/nef_part.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::test {

/// Corners and volume of the stock less `cells`, as NefPart has them, and less `others`, as the
/// model cda has them.
std::string disagreement(const cda::Cell& stock, const std::vector<cda::Cell>& cells,
                         const std::vector<cda::Cell>& others);

/// Random boxes on the grid of the unit cubes; random hulls in a cube of 6 mm.
std::string disagreement_of_boxes(std::uint64_t seed);
std::string disagreement_of_hulls(std::uint64_t seed);

/// The first `most` hulls of a program with a box for a stock.
std::string disagreement_of_program(const std::string& path, std::size_t most);

}  // namespace ncsim::test
