// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moving nodes as VRML97.
// Source: ISO/IEC 14772-1:1997, 6.29 and 6.39 (interpolators).
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/moving_scene.h"

#include <cstddef>
#include <string>

namespace ncsim::exporter {

/// Appends "1 2 3".
void append_point(std::string& text, Vec3 p);
/// Appends an Appearance with little gloss.
void append_appearance(std::string& text, Rgba8 colour);

/// Writer of the nodes and interpolators of a scene.
class VrmlScene {
public:
    explicit VrmlScene(const MovingScene& scene) : scene_(scene) {}

    /// Appends the start of a Transform, up to "children [" and the bodies of the node; the child
    /// nodes follow.
    void begin_node(std::string& text, std::size_t number) const;
    /// Appends the clock, the interpolators and their routes.
    void append_interpolators(std::string& text) const;

private:
    std::string name_of(std::size_t number) const;
    Vec3 place_of(std::size_t number, double value) const;

    const MovingScene& scene_;
};

}  // namespace ncsim::exporter
