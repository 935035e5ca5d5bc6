// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs at random of what most programs are made of: level lines, flat arcs and holes, by end
// mills, balls, bull noses, V-cutters and drills.
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

/// Always the same for a seed. Tools and stock are in its comments.
std::string random_part(std::uint64_t seed);

}  // namespace ncsim::brep::test
