// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proves free distances between bodies.
#include "free_space.h"

#include "ncsim/base/angles.h"
#include "ncsim/cda/separation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::verify {

using machine::Pose;
using machine::Values;

namespace {

// Corners of the pieces of a body on the lattice, computed on demand.
class CornersOfPieces {
public:
    CornersOfPieces(const RigidBody& body, const Pose& X, const cda::Lattice& lattice)
        : body_(body), X_(X), lattice_(lattice), corners_(body.pieces().size()) {}

    const std::vector<cda::LatticePoint>& operator[](std::uint32_t piece) {
        std::vector<cda::LatticePoint>& corners = corners_[piece];
        if (!corners.empty()) return corners;
        for (const Vec3& p : body_.pieces()[piece].outer)
            corners.push_back(lattice_.round(X_ * p));
        return corners;
    }

private:
    const RigidBody& body_;
    Pose X_;
    cda::Lattice lattice_;
    std::vector<std::vector<cda::LatticePoint>> corners_;
};

// Returns a proven lower bound of the distance, at most `most_mm`.
double apart_mm(const Pose& X, const RigidBody& observer, const RigidBody& body,
                const cda::Lattice& lattice, double most_mm) {
    // Corners are rounded to the lattice by half a unit on each axis.
    const double rounding_mm = observer.accuracy_mm() + body.accuracy_mm() + 2.0 * lattice.unit_mm;
    const auto gap = [](const Box& a, const Box& b) {
        Vec3 out;
        for (int i = 0; i < 3; ++i)
            out[i] = std::max({0.0, a.min[i] - b.max[i], b.min[i] - a.max[i]});
        return norm(out);
    };
    CornersOfPieces resting(observer, {}, lattice), moved(body, X, lattice);
    double apart = most_mm + rounding_mm;
    struct Nodes {
        std::uint32_t one = 0, other = 0;
        double gap_mm = 0.0;
    };
    std::vector<Nodes> open;
    const auto add = [&](std::uint32_t one, std::uint32_t other) {
        const double between = gap(observer.nodes()[one].box, placed(X, body.nodes()[other].box));
        if (between < apart) open.push_back({one, other, between});
    };
    add(0, 0);
    while (!open.empty() && apart > rounding_mm) {
        const Nodes at = open.back();
        open.pop_back();
        if (at.gap_mm >= apart) continue;
        const RigidBody::Node& one = observer.nodes()[at.one];
        const RigidBody::Node& other = body.nodes()[at.other];
        if (one.left != 0 || other.left != 0) {
            const std::size_t before = open.size();
            if (other.left == 0 ||
                (one.left != 0 && norm(one.box.size()) > norm(other.box.size()))) {
                add(one.left, at.other);
                add(one.right, at.other);
            } else {
                add(at.one, other.left);
                add(at.one, other.right);
            }
            // The nearer pair first, which lowers the bound for the second pair.
            if (open.size() == before + 2 && open[before].gap_mm < open[before + 1].gap_mm)
                std::swap(open[before], open[before + 1]);
            continue;
        }
        for (std::uint32_t i = one.begin; i < one.end; ++i) {
            for (std::uint32_t k = other.begin; k < other.end; ++k) {
                const std::uint32_t a = observer.order()[i], b = body.order()[k];
                const double between = gap(observer.boxes()[a], placed(X, body.boxes()[b]));
                if (between >= apart) continue;
                const auto width = [&](double mm) {
                    return static_cast<std::int64_t>(mm / lattice.unit_mm);
                };
                const cda::BodyDistance near =
                    cda::body_distance(resting[a], moved[b], width(apart) + 1);
                if (near.is_apart) continue;
                // A value slightly below the true distance can be proven.
                constexpr double kNearly = 0.98;
                const std::int64_t less = width(kNearly * near.distance * lattice.unit_mm);
                const bool is_proven =
                    less > 0 && cda::body_distance(resting[a], moved[b], less, near.way).is_apart;
                const double proven = is_proven ? static_cast<double>(less) * lattice.unit_mm : 0.0;
                apart = std::min(apart, std::max(between, proven));
            }
        }
    }
    return std::max(0.0, apart - rounding_mm);
}

// Returns upper bounds of the distance by which each joint moves a point of the body per unit, as
// long as no point has moved farther than `apart`. Proof: the joints between this joint and the
// body have moved the body by at most `apart`, so the distance of a point from the joint's axis has
// grown by at most `apart`.
JointValues reach_of(const machine::Chain& chain, const Values& at, const RigidBody& body,
                     double apart) {
    JointValues reach{};
    Vec3 centre = body.centre();
    for (auto next = chain.joints.rbegin(); next != chain.joints.rend(); ++next) {
        const machine::Joint& joint = *next;
        const std::size_t letter = *machine::index_of(joint.letter);
        if (joint.turns) {
            const Vec3 out = centre - joint.through;
            const double aside = norm(out - dot(out, joint.direction) * joint.direction);
            reach[letter] = kRadiansPerDegree * (aside + body.radius() + apart);
        } else {
            reach[letter] = 1.0;
        }
        centre = machine::move_by_joint(joint, at[letter], centre);
    }
    return reach;
}

}  // namespace

FreeSpace free_space(const machine::Chain& way, const Values& at, const RigidBody& observer,
                     const RigidBody& body, const cda::Lattice& lattice, double most_mm) {
    FreeSpace space;
    space.at = at;
    space.apart_mm = apart_mm(pose_of(way, at), observer, body, lattice, most_mm);
    space.of_body = reach_of(way, at, body, space.apart_mm);
    space.of_observer = reach_of(machine::seen_from(way, {}), at, observer, space.apart_mm);
    return space;
}

std::optional<JointMotionBounds> joint_motion_bounds(
    const Values& begin, const std::optional<Values>& from,
    const std::optional<machine::JointMotion>& leg) {
    if (!from || !leg) return std::nullopt;
    JointMotionBounds go;
    for (std::size_t i = 0; i < go.ways.size(); ++i) {
        go.ways[i] = std::abs((*from)[i] - begin[i]);
        if (i >= go.straight.size()) go.ways[i] += std::abs(leg->to[i] - leg->from[i]);
    }
    go.straight = leg->speed;
    go.all_straight = leg->all_speed;
    return go;
}

namespace {

double largest_motion(const JointValues& reach, const JointMotionBounds& go) {
    double sum = 0.0, straight = 0.0, count = 0.0;
    for (std::size_t i = 0; i < reach.size(); ++i) {
        sum += go.ways[i] * reach[i];
        if (i >= go.straight.size() || reach[i] == 0.0) continue;
        straight += go.straight[i];
        count += 1.0;
    }
    // Σ|x_i| <= √n |x| for the n of the three coordinates that count.
    return sum + std::min(straight, std::sqrt(count) * go.all_straight);
}

}  // namespace

// Proof by contradiction: let t be the first time at which a point has travelled the free distance.
// Until t every joint has moved the point by at most the joint's reach times its motion; the sum is
// less than the free distance.
bool stays_separated(const FreeSpace& space, const JointMotionBounds& go, double needed_mm) {
    const double most =
        std::min(largest_motion(space.of_body, go), largest_motion(space.of_observer, go));
    return most + needed_mm < space.apart_mm;
}

}  // namespace ncsim::verify
