// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed-form inverse kinematics for at most two rotary joints.
#include "ncsim/machine/inverse.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>

namespace ncsim::machine {

namespace {

constexpr double kNothing = 1e-12;  // Rounding error of unit vectors.
constexpr Vec3 kTool{0, 0, 1};

double wrap_degrees(double degrees) {
    if (degrees > 180.0) return degrees - 360.0;
    return degrees <= -180.0 ? degrees + 360.0 : degrees;
}

// Returns the right-handed angle about n from `from` to `to`, in degrees; no value if either is
// parallel to n.
std::optional<double> turn_between(Vec3 n, Vec3 from, Vec3 to) {
    from = from - dot(n, from) * n;
    to = to - dot(n, to) * n;
    if (norm(from) <= kNothing || norm(to) <= kNothing) return std::nullopt;
    return angle_of(dot(from, to), dot(n, cross(from, to)));
}

void set(Values& values, const Joint& joint, double degrees) {
    values[*index_of(joint.letter)] = degrees;
}

double of(const Values& values, const Joint& joint) {
    return values[*index_of(joint.letter)];
}

}  // namespace

std::vector<Turns> orientation_solutions(const Chain& placed, Vec3 axis, const Values& now) {
    std::vector<const Joint*> rotary;
    for (const Joint& joint : placed.joints) {
        if (joint.turns) rotary.push_back(&joint);
    }
    if (rotary.size() > 2) return {};
    std::vector<Turns> found;
    // `v` is the direction after the joint next to the tool; the first joint must rotate `v` to
    // `axis`.
    const auto add = [&](Vec3 v, Turns turns) {
        if (!rotary.empty()) {
            const Joint& first = *rotary.front();
            const Vec3 n = first.direction;
            if (std::abs(dot(n, v) - dot(n, axis)) > 1e-9) return;
            const auto turn = turn_between(n, v, axis);
            turns.singular |= !turn;
            set(turns.values, first, turn.value_or(of(now, first)));
        } else if (norm(v - axis) > 1e-9) {
            return;
        }
        found.push_back(turns);
    };
    if (rotary.size() < 2) {
        add(kTool, {now, false});
        return found;
    }
    const Joint& second = *rotary.back();
    const Vec3 n1 = rotary.front()->direction, n2 = second.direction;
    const double c = dot(n1, n2) * dot(n2, kTool);
    const double a = dot(n1, kTool) - c;
    const double b = dot(n1, cross(n2, kTool));
    const double size = hypotenuse(a, b);
    const double rest = dot(n1, axis) - c;
    if (size <= kNothing) {  // The second joint does not change the angle to n1.
        add(rotate_by_joint(second, of(now, second), kTool), {now, true});
        return found;
    }
    double cosine = rest / size;
    if (std::abs(cosine) > 1.0 + kNothing) return {};
    cosine = std::clamp(cosine, -1.0, 1.0);
    const double middle = angle_of(a, b);
    const double aside = angle_of(cosine, std::sqrt((1.0 - cosine) * (1.0 + cosine)));
    for (const double side : {1.0, -1.0}) {
        if (side < 0.0 && (aside == 0.0 || aside == 180.0)) break;
        const double q2 = wrap_degrees(middle + side * aside);
        Turns turns{now, false};
        set(turns.values, second, q2);
        add(rotate_by_joint(second, q2, kTool), turns);
    }
    return found;
}

std::optional<Values> values_for(const Chain& placed, Vec3 tip, const Values& turned) {
    Values values = turned;
    values[0] = values[1] = values[2] = 0.0;
    const Vec3 origin = placed.pose(values).translation;
    std::array<Vec3, 3> along;
    for (std::size_t i = 0; i < 3; ++i) {
        Values unit = values;
        unit[i] = 1.0;
        along[i] = placed.pose(unit).translation - origin;
    }
    const double det = dot(along[0], cross(along[1], along[2]));
    constexpr double kFlat = 1e-4;
    if (!(std::abs(det) > kFlat)) return std::nullopt;
    const Vec3 way = tip - origin;
    for (std::size_t i = 0; i < 3; ++i)
        values[i] = dot(way, cross(along[(i + 1) % 3], along[(i + 2) % 3])) / det;
    return values;
}

}  // namespace ncsim::machine
