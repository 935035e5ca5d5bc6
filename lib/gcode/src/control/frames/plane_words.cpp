// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forms of the definition of a tilted working plane.
#include "control/frames/plane_words.h"

#include "control/command.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {
namespace {

constexpr int kAboutX = 0, kAboutY = 1, kAboutZ = 2;
// Smallest length of a sum of unit vectors that defines a direction.
constexpr double kNoVector = 1e-9;

Triple minus(const Triple& a, const Triple& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Returns `v` / |v|; nullopt if |v| ≤ `least`.
std::optional<Triple> unit(const Triple& v, double least = kNoVector) {
    const double length = std::sqrt(dot(v, v));
    if (!(length > least)) return std::nullopt;
    return Triple{v[0] / length, v[1] / length, v[2] / length};
}

FeatureFrame with_axes(const Triple& x, const Triple& z) {
    const Triple y = cross(z, x);
    FeatureFrame frame;
    for (std::size_t i = 0; i < 3; ++i)
        frame.rows[i] = {x[i] + 0.0, y[i] + 0.0, z[i] + 0.0};
    return frame;
}

// Returns the axes (0, 1 or 2) of an order of rotations such as 313, first to last; nullopt if `q`
// has other digits or the same axis twice in succession.
std::optional<std::array<int, 3>> order_of(double q) {
    const double whole = std::round(q);
    if (whole != q || whole < 111.0 || whole > 333.0) return std::nullopt;
    const int n = static_cast<int>(whole);
    const std::array<int, 3> axes{n / 100 - 1, n / 10 % 10 - 1, n % 10 - 1};
    for (const int axis : axes) {
        if (axis < 0 || axis > 2) return std::nullopt;
    }
    if (axes[0] == axes[1] || axes[1] == axes[2]) return std::nullopt;
    return axes;
}

bool is_euler(const std::array<int, 3>& order) {
    return order[0] == order[2];
}

Triple xyz_of(const Command& command) {
    return {command.get('X', 0.0), command.get('Y', 0.0), command.get('Z', 0.0)};
}

Triple ijk_of(const Command& command) {
    return {command.get('I', 0.0), command.get('J', 0.0), command.get('K', 0.0)};
}

// Returns a sequence of rotations about axes that turn along (intrinsic rotations).
FeatureFrame intrinsic_rotation(const std::array<int, 3>& order, const Triple& angles) {
    return turn_about(order[0], angles[0]) * turn_about(order[1], angles[1]) *
           turn_about(order[2], angles[2]);
}

// Returns a sequence of rotations about fixed axes; I, J and K belong to X, Y and Z.
FeatureFrame fixed_axis_rotation(const std::array<int, 3>& order, const Triple& angles) {
    const auto by = [&](int axis) {
        return turn_about(axis, angles[static_cast<std::size_t>(axis)]);
    };
    return by(order[2]) * by(order[1]) * by(order[0]);
}

PlaneRead fault(std::string_view wants) {
    return {std::nullopt, wants};
}

PlaneRead plane_by_angles(const Command& command, PlaneDialect dialect, int form) {
    const bool rolls = form == 1;
    const double usual = dialect == PlaneDialect::Haas ? 321.0 : rolls ? 123.0 : 313.0;
    const bool has_order = rolls || dialect == PlaneDialect::LinuxCnc;
    const auto order = order_of(has_order ? command.get('Q', usual) : usual);
    if (!order || is_euler(*order) == rolls)
        return fault("an order of turns that is one (Q, such as 123, 313)");
    const Triple angles = ijk_of(command);
    const bool along = !rolls || dialect == PlaneDialect::LinuxCnc;
    return {along ? intrinsic_rotation(*order, angles) : fixed_axis_rotation(*order, angles), {}};
}

// Returns the plane through three points: X points from the first to the second; the third is on
// the positive side of Y.
PlaneRead plane_through(const Triple& p1, const Triple& p2, const Triple& p3) {
    const auto x = unit(minus(p2, p1));
    const auto aside = unit(minus(p3, p1));
    if (!x || !aside) return fault("three points that differ");
    const auto z = unit(cross(*x, *aside));
    if (!z) return fault("three points that are not on one line");
    return {with_axes(*x, *z), {}};
}

PlaneRead plane_by_vectors(const Triple& along_x, const Triple& along_z) {
    const auto x = unit(along_x), z = unit(along_z);
    if (!x || !z) return fault("two vectors that have a length");
    constexpr double kSkew = 0.087;  // Sine of five degrees.
    const double skew = dot(*x, *z);
    if (std::abs(skew) > kSkew) return fault("two vectors at right angles");
    const Triple level{(*x)[0] - skew * (*z)[0], (*x)[1] - skew * (*z)[1],
                       (*x)[2] - skew * (*z)[2]};
    return {with_axes(*unit(level), *z), {}};
}

// Returns the plane spanned by X turned by I about Y, and Y turned by J about X; K turns the plane
// about the normal.
PlaneRead plane_by_projections(const Triple& angles) {
    const FeatureFrame about_y = turn_about(kAboutY, angles[0]);
    const FeatureFrame about_x = turn_about(kAboutX, angles[1]);
    const Triple a = about_y.direction_to_parent({1, 0, 0});
    const Triple b = about_x.direction_to_parent({0, 1, 0});
    const auto z = unit(cross(a, b));
    if (!z) return fault("angles that span a plane");
    return {with_axes(a, *z) * turn_about(kAboutZ, angles[2]), {}};
}

// Reads a part of a definition in several blocks; Q is the number of the part.
PlaneRead take_part(const Command& command, PlaneDialect dialect, int form, PlaneParts& parts) {
    const bool linuxcnc = dialect == PlaneDialect::LinuxCnc;
    const double q = command.get('Q', linuxcnc ? 0.0 : -1.0);
    const double first = form == 2 || linuxcnc ? 0.0 : 1.0;
    const double last = form == 2 ? 3.0 : first + 1.0;
    if (q != std::round(q) || q < first || q > last)
        return fault(form == 2 ? "the number of a point (Q1, Q2, Q3)"
                               : "the number of a vector (Q)");
    if (parts.form != form) parts = {form, {}};
    parts.parts[static_cast<std::size_t>(q)] =
        PlaneParts::Part{xyz_of(command), ijk_of(command), command.get('R', 0.0)};
    const auto& all = parts.parts;
    PlaneRead read;
    double turn = 0.0;
    Triple origin{};
    if (form == 2) {
        if (!all[1] || !all[2] || !all[3] || (linuxcnc && !all[0])) return {};
        read = plane_through(all[1]->xyz, all[2]->xyz, all[3]->xyz);
        if (!read.frame) return read;
        turn = all[0] ? all[0]->r : 0.0;
        // Fanuc: Q0 is a shift in the plane from the first point. LinuxCNC: Q0 is the origin.
        read.frame->origin = linuxcnc ? Triple{} : all[1]->xyz;
        origin = linuxcnc ? all[0]->xyz : all[0] ? read.frame->to_parent(all[0]->xyz) : all[1]->xyz;
    } else {
        const auto& one = all[linuxcnc ? 0 : 1];
        const auto& two = all[linuxcnc ? 1 : 2];
        if (!one || !two) return {};
        // LinuxCNC gives a point on the X axis, not the direction.
        read = plane_by_vectors(linuxcnc ? minus(one->ijk, one->xyz) : one->ijk, two->ijk);
        if (!read.frame) return read;
        turn = linuxcnc ? one->r : 0.0;
        origin = one->xyz;
    }
    const FeatureFrame about_z = turn_about(kAboutZ, turn);
    read.frame->origin = {};
    read.frame = linuxcnc ? about_z * *read.frame : *read.frame * about_z;
    read.frame->origin = origin;
    parts = {};
    return read;
}

}  // namespace

PlaneRead read_plane(const Command& command, PlaneDialect dialect, PlaneParts& parts) {
    const double p = dialect == PlaneDialect::Haas ? 1.0 : command.get('P', 0.0);
    const double highest = dialect == PlaneDialect::LinuxCnc ? 3.0 : 4.0;
    if (p != std::round(p) || p < 0.0 || p > highest) return fault("a form that is one (P)");
    const int form = static_cast<int>(p);
    const bool linuxcnc = dialect == PlaneDialect::LinuxCnc;
    if (!linuxcnc && form != 2 && command.get('R', 0.0) != 0.0)
        return fault("no R: the angles say it all");
    if (form == 2 || form == 3) return take_part(command, dialect, form, parts);
    parts = {};
    PlaneRead read =
        form == 4 ? plane_by_projections(ijk_of(command)) : plane_by_angles(command, dialect, form);
    if (!read.frame) return read;
    if (linuxcnc) read.frame = turn_about(kAboutZ, command.get('R', 0.0)) * *read.frame;
    read.frame->origin = xyz_of(command);
    return read;
}

FeatureFrame plane_across(const Triple& axis, double degrees) {
    const auto level = unit(cross({0, 0, 1}, axis));
    const FeatureFrame frame = level ? with_axes(*level, axis) : with_axes({1, 0, 0}, axis);
    return frame * turn_about(kAboutZ, degrees);
}

}  // namespace ncsim::gcode
