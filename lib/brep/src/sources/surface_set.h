// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces, each once: what many lines cut in one place is one face.
#pragma once

#include "ncsim/brep/surface.h"

#include <cstdint>
#include <map>
#include <vector>

namespace ncsim::brep {

class SurfaceSet {
public:
    /// The number of one that is the same within 2e-5 mm, whoever came first; or a new one.
    std::uint32_t add(const Surface& surface);
    /// One of its own.
    std::uint32_t add_alone(const Surface& surface);
    const Surface& operator[](std::uint32_t number) const { return surfaces_[number]; }

private:
    std::vector<Surface> surfaces_;
    std::multimap<double, std::uint32_t> by_key_;
};

}  // namespace ncsim::brep
