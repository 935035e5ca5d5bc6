// SPDX-License-Identifier: GPL-3.0-or-later
//
// The frame of a tilted plane out of the words of G68.2, G68.4 and G268.
#pragma once

#include "ncsim/gcode/feature_frame.h"

#include <array>
#include <optional>
#include <string_view>

namespace ncsim::gcode {

struct Command;

/// Whose words they are.
enum class PlaneDialect : unsigned char {
    Fanuc,     ///< And Mitsubishi, Mazak.
    LinuxCnc,  ///< The remaps of its five-axis configurations.
    Haas,
};

/// What the blocks of a definition by points or vectors told so far.
struct PlaneParts {
    struct Part {
        Triple xyz{}, ijk{};
        double r = 0.0;
        bool operator==(const Part&) const = default;
    };
    int form = 0;  ///< P
    std::array<std::optional<Part>, 4> parts;
    bool operator==(const PlaneParts&) const = default;
};

struct PlaneRead {
    std::optional<FeatureFrame> frame;  ///< Origin in the units of the program.
    std::string_view wants;  ///< Not empty: what is wrong. Neither: there are blocks to come.
};

/// P absent or 0: Euler angles I J K about Z, X', Z''. P1: roll, pitch and yaw in the order of Q:
/// I about X, J about Y, K about Z, about axes that stay (Fanuc; Haas without P, first about Z), or
/// I, J, K as Q names them, about axes that turn along (LinuxCNC, which has other orders of P0,
/// too). P2: three points, Q1 to Q3, with Q0 a shift and a turn. P3: two vectors. P4: angles of
/// projections.
PlaneRead read_plane(const Command& command, PlaneDialect dialect, PlaneParts& parts);

/// Z along `axis`, X level, turned by `degrees` about Z.
FeatureFrame plane_across(const Triple& axis, double degrees);

}  // namespace ncsim::gcode
