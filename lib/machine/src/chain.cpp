// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forward kinematics of a chain.
#include "ncsim/machine/chain.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace ncsim::machine {

namespace {

using Rows = std::array<Vec3, 3>;

constexpr std::size_t kFirstSecond = 6;  // Index of U.

// Returns the rotation about `u`. About X, Y or Z, the entries 0 and 1 are exact, and a product
// with the matrix equals that of a plane rotation.
Rows rotation(Vec3 u, double degrees) {
    const SinCos q = sin_cos(degrees);
    const double c = q.cos;
    const double s = u.x + u.y + u.z < 0.0 ? -q.sin : q.sin;
    if (u.y == 0.0 && u.z == 0.0) return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
    if (u.x == 0.0 && u.z == 0.0) return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
    if (u.x == 0.0 && u.y == 0.0) return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
    const double k = 1.0 - c;
    const Vec3 w = q.sin * u;
    return {{{c + k * u.x * u.x, k * u.x * u.y - w.z, k * u.x * u.z + w.y},
             {k * u.x * u.y + w.z, c + k * u.y * u.y, k * u.y * u.z - w.x},
             {k * u.x * u.z - w.y, k * u.y * u.z + w.x, c + k * u.z * u.z}}};
}

// Returns a + v, or v itself for a = 0: v keeps the sign of a zero, so equal positions have equal
// bits.
double sum(double a, double v) {
    return a == 0.0 ? v : a + v;
}

Vec3 shifted(Vec3 p, Vec3 u, double by) {
    if (u.y == 0.0 && u.z == 0.0) return {sum(p.x, u.x * by), p.y, p.z};
    if (u.x == 0.0 && u.z == 0.0) return {p.x, sum(p.y, u.y * by), p.z};
    if (u.x == 0.0 && u.y == 0.0) return {p.x, p.y, sum(p.z, u.z * by)};
    return p + by * u;
}

Vec3 times(const Rows& rows, Vec3 v) {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}

}  // namespace

// The table is fast, because pose() calls the function for each joint.
std::optional<std::size_t> index_of(char letter) {
    constexpr auto table = [] {
        std::array<std::uint8_t, 256> places{};
        places.fill(kLetters.size());
        for (std::size_t i = 0; i < kLetters.size(); ++i)
            places[static_cast<unsigned char>(kLetters[i])] = static_cast<std::uint8_t>(i);
        return places;
    }();
    const std::size_t i = table[static_cast<unsigned char>(letter)];
    return i == kLetters.size() ? std::nullopt : std::optional(i);
}

Joint joint_of(char letter, bool turns, Vec3 direction, Vec3 through, Positive positive) {
    const Vec3 u = normalized(direction);
    return {letter, turns, positive == Positive::Part ? -u : u, through};
}

Vec3 move_by_joint(const Joint& joint, double value, Vec3 p) {
    if (!joint.turns) return shifted(p, joint.direction, value);
    if (value == 0.0) return p;
    return times(rotation(joint.direction, value), p - joint.through) + joint.through;
}

Pose pose_of(const Joint& joint, double value) {
    Pose X;
    if (joint.turns && value != 0.0) X.rows = rotation(joint.direction, value);
    X.translation = move_by_joint(joint, value, {});
    return X;
}

Vec3 rotate_by_joint(const Joint& joint, double value, Vec3 direction) {
    if (!joint.turns || value == 0.0) return direction;
    return times(rotation(joint.direction, value), direction);
}

const Joint* Chain::find(char letter) const {
    const auto found = std::ranges::find(joints, letter, &Joint::letter);
    return found == joints.end() ? nullptr : &*found;
}

bool Chain::has_second_axes() const {
    return std::ranges::any_of(
        joints, [](const Joint& joint) { return *index_of(joint.letter) >= kFirstSecond; });
}

bool Chain::has_head() const {
    bool has_moved = false;
    for (const Joint& joint : joints) {
        if (joint.turns && has_moved) return true;
        has_moved |= !joint.turns;
    }
    return false;
}

Chain Chain::placed(Vec3 zero, double length) const {
    // Values of X, Y and Z at which the tip is at the program zero. The joints behind a linear
    // joint move with that joint.
    const Vec3 stand{zero.x, zero.y, zero.z + length};
    Vec3 shift = -zero;
    Chain chain = *this;
    for (Joint& joint : chain.joints) {
        if (joint.turns) {
            joint.through = joint.through + shift;
        } else if (joint.letter >= 'X' && joint.letter <= 'Z') {
            shift = shift + stand[joint.letter - 'X'] * joint.direction;
        }
    }
    return chain;
}

Pose Chain::pose(const Values& values) const {
    Pose X_WT;
    int count = 0;
    bool is_least = true;
    // A reverse iterator, because clang 14 does not accept the views of this standard library.
    for (auto next = joints.rbegin(); next != joints.rend(); ++next) {
        const Joint& joint = *next;
        const std::size_t i = *index_of(joint.letter);
        double value = values[i];
        if (!joint.turns) {
            if (i < 3 && !find(kLetters[i + kFirstSecond])) value += values[i + kFirstSecond];
            X_WT.translation = shifted(X_WT.translation, joint.direction, value);
            continue;
        }
        // A joint at 0 is skipped: a product with the identity is exact, except for -0.0.
        if (value == 0.0) continue;
        const Rows rows = rotation(joint.direction, value);
        X_WT.translation = X_WT.translation - joint.through;
        X_WT = Pose{rows, {}} * X_WT;
        X_WT.translation = X_WT.translation + joint.through;
        // A single rotation about an axis perpendicular to z is the least rotation.
        is_least = ++count == 1 && joint.direction.z == 0.0;
    }
    if (!is_least) X_WT.rows = least_rotation_to(axis_of(X_WT));
    return X_WT;
}

Vec3 Chain::shift_of_second_axes(const Values& values) const {
    Vec3 shift;
    if (values[6] == 0.0 && values[7] == 0.0 && values[8] == 0.0) return shift;
    for (auto next = joints.rbegin(); next != joints.rend(); ++next) {
        const std::size_t i = *index_of(next->letter);
        if (next->turns) {
            shift = rotate_by_joint(*next, values[i], shift);
        } else if (i >= kFirstSecond) {
            shift = shifted(shift, next->direction, values[i]);
        } else if (!find(kLetters[i + kFirstSecond])) {
            shift = shifted(shift, next->direction, values[i + kFirstSecond]);
        }
    }
    return shift;
}

Joint along_tool(char letter) {
    return joint_of(letter, false, {0, 0, 1});
}

}  // namespace ncsim::machine
