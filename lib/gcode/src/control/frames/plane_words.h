// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frame of a tilted working plane from the words of G68.2, G68.4 and G268.
#pragma once

#include "ncsim/gcode/feature_frame.h"

#include <array>
#include <optional>
#include <string_view>

namespace ncsim::gcode {

struct Command;

/// Control whose words are read.
enum class PlaneDialect : unsigned char {
    Fanuc,     ///< Also Mitsubishi and Mazak.
    LinuxCnc,  ///< Remaps of LinuxCNC's five-axis configurations.
    Haas,
};

/// Parts of a definition by points or vectors, collected over several blocks.
struct PlaneParts {
    struct Part {
        Triple xyz{}, ijk{};
        double r = 0.0;
        bool operator==(const Part&) const = default;
    };
    int form = 0;  ///< P: form of the definition.
    std::array<std::optional<Part>, 4> parts;
    bool operator==(const PlaneParts&) const = default;
};

/// Result of read_plane().
struct PlaneRead {
    std::optional<FeatureFrame> frame;  ///< Origin in program units.
    /// Missing or wrong words; empty if correct. Without `frame` and `wants`, further blocks
    /// follow.
    std::string_view wants;
};

/// Returns the frame that `command` defines, or collects a part in `parts`. P absent or 0: Euler
/// angles I J K about Z, X', Z''. P1: roll, pitch and yaw. Fanuc: I about X, J about Y, K about Z,
/// fixed axes, in the order of Q. Haas (without P): angles about fixed axes, Z first. LinuxCNC: I,
/// J, K about the axes named by Q, turning along; other orders of P0 are possible. P2: three points
/// Q1 to Q3; Q0: shift and rotation. P3: two vectors. P4: projection angles.
PlaneRead read_plane(const Command& command, PlaneDialect dialect, PlaneParts& parts);

/// Returns the frame with Z along `axis` and X horizontal, turned by `degrees` about Z.
FeatureFrame plane_across(const Triple& axis, double degrees);

}  // namespace ncsim::gcode
