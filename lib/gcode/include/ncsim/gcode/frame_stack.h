// SPDX-License-Identifier: GPL-3.0-or-later
//
// The levels between a programmed position and the machine, as one value. Numbers that a program
// can write are stored as written, in the active units, so the numbers stay exact until motions are
// made:
//
//     position = programmed(words)
//     machine = rotate_z(rotation) * (tilt * (position + offset_92) + outer_92) + work_offset +
//               tool_offset + dynamic_offset
//
// The frames of Klartext and SINUMERIK are values of the same levels: a datum shift is offset_92, a
// rotation, a scale and a mirror image are `programmed`, and a plane is `tilt`.
#pragma once

#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/motion.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ncsim::gcode {

/// Values of X Y Z A B C U V W: lengths in active units (or mm, where stated), angles in degrees.
using Axes = std::array<double, 9>;

/// Index of an axis in Axes.
enum Axis : std::uint8_t { kX, kY, kZ, kA, kB, kC, kU, kV, kW };

constexpr bool is_rotary(std::size_t axis) {
    return axis >= kA && axis <= kC;
}

/// Multiplies the lengths of `axes` by `factor`; rotary axes stay.
void scale_lengths(Axes& axes, double factor);

/// G68, G51 and G16 of Fanuc and similar controls: transformation of programmed coordinates,
/// applied first.
struct ProgrammedTransform {
    bool rotated = false, scaled = false, polar = false;
    Plane plane = Plane::XY;  ///< Plane of G68 and G16.
    double angle = 0.0;       ///< Degrees, G68.
    double centre_1 = 0.0, centre_2 = 0.0;
    double pole_1 = 0.0, pole_2 = 0.0;           ///< Pole of G16, in programmed coordinates.
    std::array<double, 3> scale{1.0, 1.0, 1.0};  ///< G51; a negative factor mirrors.
    std::array<double, 3> scale_centre{};
    bool operator==(const ProgrammedTransform&) const = default;

    /// Sets a rotation by `degrees` about the origin of `in_plane`, and then the factors `factors`
    /// about `about`.
    void set(Plane in_plane, double degrees, const std::array<double, 3>& factors,
             const std::array<double, 3>& about);
    /// True if programmed positions differ from positions in the active system.
    bool changes_places() const { return rotated || scaled; }
    /// Applies G51, then G68, to a programmed position.
    Axes apply(const Axes& words) const;
    /// Removes G68 and G51 from a position in the active system.
    Axes remove(const Axes& position) const;
};

/// The levels between programmed positions and the machine. See the head of the file.
struct FrameStack {
    ProgrammedTransform programmed;
    Axes offset_92{};  ///< G92 and G52.
    /// Part of offset_92 by which G92 set the position of an axis whose position was unknown. This
    /// part defines the program zero; it is not a shift of the zero.
    Axes zero_92{};
    std::array<bool, 3> is_zero_by_hand{};  ///< X, Y, Z of zero_92 are set, to 0 or another value.
    std::optional<FeatureFrame> tilt;       ///< Tilted working plane.
    std::array<double, 3> outer_92{};       ///< Value of offset_92 outside of the plane; X, Y, Z.
    double rotation = 0.0;                  ///< Rotation of the active system, degrees.
    Axes work_offset{};                     ///< Origin of the active system.
    Axes tool_offset{};                     ///< G43.
    /// G254, G54.2, G54.4: displacement of the zero of the system with the table, in machine
    /// coordinates.
    std::optional<std::array<double, 3>> dynamic_offset;
    /// G54.2 and G54.4: `dynamic_offset` with all rotary axes at 0.
    std::array<double, 3> dynamic_offset_home{};
    bool operator==(const FrameStack&) const = default;

    /// Returns `position` in the axes of the machine, relative to the origin of the active system.
    Axes to_system(const Axes& position) const;
    /// Returns `position` in machine coordinates, of X, Y and Z along axes with frame 0 only.
    Axes to_machine(const Axes& position) const;
    /// Transforms a position in machine coordinates to the active system.
    Axes from_machine(const Axes& machine) const;
    /// Sets the tilted plane, or ends the plane. G92 and G52 set before the plane shift the whole
    /// plane; G92 and G52 in the plane end with the plane.
    void set_tilt(const std::optional<FeatureFrame>& frame);
    /// Multiplies all lengths by `factor`, for a change of units.
    void scale_lengths(double factor);
};

}  // namespace ncsim::gcode
