// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position and direction from which a picture is taken.
#pragma once

#include "ncsim/base/vec3.h"

#include <optional>
#include <string_view>

namespace ncsim::exporter {

/// Standard view directions, with z up as at the machine: Front looks along +y, Right along -x, Top
/// along -z with +y up, Iso from the right, the front and above.
enum class View { Iso, Top, Front, Back, Left, Right, Bottom };

/// Returns the view named `name` ("iso", "top", …); nullopt for an unknown name.
std::optional<View> parse_view(std::string_view name);
/// Returns the name of `view`, as parse_view() reads it.
std::string_view name(View view);

/// Kind of projection; see Camera::distance.
enum class Projection { Orthographic, Perspective };

/// Position, direction and size of a picture. `right`, `up` and `back` (towards the eye) are
/// orthogonal unit vectors in the workpiece frame W. Lengths are in mm.
struct Camera {
    Vec3 target;  ///< The centre of the picture.
    Vec3 right{1, 0, 0}, up{0, 0, 1}, back{0, -1, 0};
    double height = 1.0;    ///< Visible height at the target.
    double distance = 0.0;  ///< Distance of the eye from the target; 0: orthographic.
    /// Bound for the depth of visible points relative to the target, to the front and back.
    double depth = 1.0;

    bool operator==(const Camera&) const = default;
    bool is_orthographic() const { return distance == 0.0; }
};

/// Returns the camera that shows all of `box`, with a small margin, in a picture that is `aspect`
/// times as wide as high. The perspective is mild: the eye is four box diagonals away. An empty
/// box, or a box that is a point, counts as a box of 1 mm around that point.
/// Guarantees: the same bits on every machine, because the computation needs no trigonometric
///     function.
Camera fit_camera(const Box& box, View view, double aspect,
                  Projection projection = Projection::Orthographic);

}  // namespace ncsim::exporter
