// SPDX-License-Identifier: GPL-3.0-or-later
//
// Length and Angle: quantities with a fixed unit. A number in a program has the active unit of the
// program; a Length or an Angle is independent of the active unit.
#pragma once

#include <compare>
#include <numbers>

namespace ncsim::gcode {

/// A length.
class Length {
public:
    constexpr Length() = default;

    static constexpr Length from_mm(double mm) { return Length(mm); }

    constexpr double mm() const { return mm_; }

    constexpr auto operator<=>(const Length&) const = default;
    constexpr Length operator-() const { return Length(-mm_); }
    constexpr Length& operator+=(Length o) { return mm_ += o.mm_, *this; }
    constexpr Length& operator-=(Length o) { return mm_ -= o.mm_, *this; }
    friend constexpr Length operator+(Length a, Length b) { return a += b; }
    friend constexpr Length operator-(Length a, Length b) { return a -= b; }
    friend constexpr Length operator*(double s, Length a) { return Length(s * a.mm_); }

private:
    explicit constexpr Length(double mm) : mm_(mm) {}
    double mm_ = 0.0;
};

/// An angle, stored in degrees because rotary axes are programmed in degrees. A value is never
/// wrapped because rotary axes may turn far beyond a full turn.
class Angle {
public:
    constexpr Angle() = default;

    static constexpr Angle from_degrees(double degrees) { return Angle(degrees); }

    constexpr double degrees() const { return degrees_; }
    constexpr double radians() const { return degrees_ * (std::numbers::pi / 180.0); }

    constexpr auto operator<=>(const Angle&) const = default;
    constexpr Angle operator-() const { return Angle(-degrees_); }
    constexpr Angle& operator+=(Angle o) { return degrees_ += o.degrees_, *this; }
    constexpr Angle& operator-=(Angle o) { return degrees_ -= o.degrees_, *this; }
    friend constexpr Angle operator+(Angle a, Angle b) { return a += b; }
    friend constexpr Angle operator-(Angle a, Angle b) { return a -= b; }

private:
    explicit constexpr Angle(double degrees) : degrees_(degrees) {}
    double degrees_ = 0.0;
};

}  // namespace ncsim::gcode
