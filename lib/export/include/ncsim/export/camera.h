// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a picture is taken from.
#pragma once

#include "ncsim/cda/vec.h"

#include <optional>
#include <string_view>

namespace ncsim::exporter {

/// As at the machine, z up: Front looks along +y, Right along -x, Top along -z with +y up, Iso from
/// the right, the front and above.
enum class View { Iso, Top, Front, Back, Left, Right, Bottom };

/// "iso", "top", … as users write it; nothing for other names.
std::optional<View> parse_view(std::string_view name);
std::string_view name(View view);

enum class Projection { Orthographic, Perspective };

/// `right`, `up` and `back` (towards the eye) are unit vectors in the workpiece frame W, at right
/// angles to each other. Lengths are in mm.
struct Camera {
    cda::Vec3 target;  ///< Seen in the middle of the picture.
    cda::Vec3 right{1, 0, 0}, up{0, 0, 1}, back{0, -1, 0};
    double height = 1.0;    ///< Seen from the bottom to the top of the picture, at the target.
    double distance = 0.0;  ///< From the target to the eye; 0: orthographic.
    double depth = 1.0;     ///< Farthest that a visible point lies before or behind the target.

    bool operator==(const Camera&) const = default;
    bool is_orthographic() const { return distance == 0.0; }
};

/// The camera from which all of `box` is seen, with a small margin, in a picture `aspect` times as
/// wide as high. Perspective is mild: the eye is four box diagonals away. An empty box, or one
/// that is a point, is taken for a box of 1 mm about it. Depends on the arguments only (no sine is
/// taken): the same on every machine.
Camera fit_camera(const cda::Box& box, View view, double aspect,
                  Projection projection = Projection::Orthographic);

}  // namespace ncsim::exporter
