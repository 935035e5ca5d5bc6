// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbered set of surfaces. Equal surfaces have the same number, so many lines of a program that
// cut in the same place leave a single face.
#pragma once

#include "ncsim/brep/surface_forms.h"

#include <cstdint>
#include <map>
#include <vector>

namespace ncsim::brep {

class SurfaceSet {
public:
    /// Returns the number of a surface of the set that equals `surface` within 2e-5 mm; adds
    /// `surface` if there is none.
    std::uint32_t add(const Surface& surface);
    /// Adds `surface` with a number of its own.
    std::uint32_t add_alone(const Surface& surface);
    const Surface& operator[](std::uint32_t number) const { return surfaces_[number]; }

private:
    std::vector<Surface> surfaces_;
    std::multimap<double, std::uint32_t> by_key_;
};

}  // namespace ncsim::brep
