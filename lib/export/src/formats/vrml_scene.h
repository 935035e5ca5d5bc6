// SPDX-License-Identifier: GPL-3.0-or-later
//
// What moves, as VRML97: ISO/IEC 14772-1:1997, 6.29 and 6.39 (interpolators).
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/moving_scene.h"

#include <cstddef>
#include <string>

namespace ncsim::exporter {

/// "1 2 3"
void append_point(std::string& text, cda::Vec3 p);
/// An Appearance with little gloss.
void append_appearance(std::string& text, Rgba8 colour);

class VrmlScene {
public:
    explicit VrmlScene(const MovingScene& scene) : scene_(scene) {}

    /// A Transform up to where those begin that the node carries: "children [" and its own bodies.
    void begin_node(std::string& text, std::size_t number) const;
    /// The clock, and what it drives.
    void append_interpolators(std::string& text) const;

private:
    std::string name_of(std::size_t number) const;
    cda::Vec3 place_of(std::size_t number, double value) const;

    const MovingScene& scene_;
};

}  // namespace ncsim::exporter
