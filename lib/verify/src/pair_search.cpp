// SPDX-License-Identifier: GPL-3.0-or-later
//
// Searches for contacts of moving bodies by halving the motion.
#include "pair_search.h"

#include "ncsim/base/angles.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/separation.h"

#include "body.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ncsim::verify {

using cda::LatticePoint;
using machine::Ball;
using machine::Pose;
using machine::Values;

namespace {

// Deviation (mm) of a path above which hulls are too coarse to be useful.
constexpr double kCoarseMm = 5.0;

// pieces of the observer and of the body
using PiecePair = std::pair<std::uint32_t, std::uint32_t>;

struct Stretch {
    double begin = 0.0, end = 1.0;
    Values from{}, to{};
    std::vector<PiecePair> open;  // pairs that may meet, once listed
    bool is_listed = false;
};

// Positions of a body in a stretch.
struct Span {
    Pose X_0, X_1;         // observer to body, at both ends
    double grow_mm = 0.0;  // largest deviation of a point from the straight path between the ends
};

Box widen_box(const Box& box, double by) {
    return {box.min - Vec3{by, by, by}, box.max + Vec3{by, by, by}};
}

Box swept(const Span& place, const Box& box) {
    Box both = placed(place.X_0, box);
    both.add(placed(place.X_1, box));
    return widen_box(both, place.grow_mm);
}

void add_points(std::vector<LatticePoint>& points, const std::vector<Vec3>& corners, const Pose& X,
                const cda::Lattice& lattice) {
    for (const Vec3& p : corners)
        points.push_back(lattice.round(X * p));
}

std::vector<LatticePoint> points_of(const std::vector<Vec3>& corners, const Span& place,
                                    const cda::Lattice& lattice) {
    std::vector<LatticePoint> points;
    add_points(points, corners, place.X_0, lattice);
    if (place.X_0 != place.X_1) add_points(points, corners, place.X_1, lattice);
    return points;
}

std::int64_t round_up_units(double mm, const cda::Lattice& lattice) {
    return static_cast<std::int64_t>(std::ceil(std::max(0.0, mm) / lattice.unit_mm));
}

// Returns a ball that contains the body during the stretch, with bounds of its motion.
std::optional<Ball> ball_of(const PairOnLeg& pair, const RigidBody& body, const Stretch& s) {
    const auto joint_motion = pair.path.joint_motion(s.begin, s.from, s.end, s.to);
    if (!joint_motion) return std::nullopt;
    Ball ball = move_ball(pair.way, *joint_motion, {body.centre(), body.radius(), 0.0, 0.0});
    const auto tip = pair.of_part_and_tool ? pair.path.tip(s.begin, s.end) : std::nullopt;
    if (!tip) return ball;
    // x = tip(t) + R(t) r, and |R'' r| <= (Σθ)² |r| for any number of axes.
    double turn = 0.0;
    for (std::size_t i = 3; i < 6; ++i)
        turn += kRadiansPerDegree * std::abs(s.to[i] - s.from[i]);
    const double reach = norm(body.centre() - pair.tip) + body.radius();
    ball.speed = std::min(ball.speed, tip->speed + turn * reach);
    ball.bend = std::min(ball.bend, tip->bend + turn * turn * reach);
    return ball;
}

// Returns the same ball for the observer, as seen from the body.
std::optional<Ball> ball_of_observer(const PairOnLeg& pair, const RigidBody& observer,
                                     const Stretch& s) {
    const auto joint_motion = pair.path.joint_motion(s.begin, s.from, s.end, s.to);
    if (!joint_motion) return std::nullopt;
    return move_ball(machine::seen_from(pair.way, {}), *joint_motion,
                     {observer.centre(), observer.radius(), 0.0, 0.0});
}

// Halves a leg until all stretches are decided. `far`: true if all positions in a ball are clear.
// `list`: writes the pairs that are not clear in the stretch into `open`. `find`: true if contact
// is certain at a time.
template <class Far, class List, class Find>
Encounter search(const PairOnLeg& pair, const RigidBody& body, double rounding_mm, const Far& far,
                 const List& list, const Find& find) {
    Encounter result;
    const auto leave_open = [&](double time, const Values& values) {
        if (result.closeness != Closeness::Clear) return;
        result.closeness = Closeness::Open;
        result.time = time;
        result.values = values;
        result.point = pose_of(pair.way, values) * body.centre();
    };
    if (!pair.from || !pair.to) {
        leave_open(0.0, {});
        return result;
    }
    const auto is_certain = [&](double time, const Values& values) {
        Encounter found;
        if (!find(values, found)) return false;
        result = found;
        result.time = time;
        return true;
    };
    if (pair.had_contact && (is_certain(0.0, *pair.from) || is_certain(1.0, *pair.to)))
        return result;
    std::deque<Stretch> waiting;
    waiting.push_back({0.0, 1.0, *pair.from, *pair.to, {}, false});
    for (std::size_t looked = 0; !waiting.empty(); ++looked) {
        Stretch s = std::move(waiting.front());
        waiting.pop_front();
        const auto ball = ball_of(pair, body, s);
        if (!ball) {
            leave_open(s.begin, s.from);
            break;
        }
        if (far(*ball)) continue;
        const double missed_mm = ball->bend / 8.0 + pair.missed_mm;
        const bool is_last = ball->speed <= kUndecidedMm || looked >= pair.most_stretches;
        if (missed_mm <= kCoarseMm || is_last) {
            const Span place{pose_of(pair.way, s.from), pose_of(pair.way, s.to),
                             missed_mm + rounding_mm};
            list(place, s);
            if (s.open.empty()) continue;
        }
        const double middle = 0.5 * (s.begin + s.end);
        const auto between = pair.path.at(middle);
        if (!between) {
            leave_open(s.begin, s.from);
            break;
        }
        const bool is_whole = s.begin == 0.0 && s.end == 1.0;
        if (is_whole && (is_certain(0.0, s.from) || is_certain(1.0, s.to))) return result;
        if (is_certain(middle, *between)) return result;
        if (is_last) {
            leave_open(middle, *between);
            continue;
        }
        waiting.push_back({s.begin, middle, s.from, *between, s.open, s.is_listed});
        waiting.push_back({middle, s.end, *between, s.to, std::move(s.open), s.is_listed});
    }
    return result;
}

// Lists the pairs of pieces whose boxes are near each other.
void list_near(const RigidBody& observer, const RigidBody& body, const Span& place,
               std::vector<PiecePair>& pairs) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}};  // nodes
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        const RigidBody::Node& one = observer.nodes()[a];
        const RigidBody::Node& other = body.nodes()[b];
        if (!one.box.overlaps(swept(place, other.box))) continue;
        if (one.left == 0 && other.left == 0) {
            for (std::uint32_t i = one.begin; i < one.end; ++i) {
                for (std::uint32_t k = other.begin; k < other.end; ++k)
                    pairs.emplace_back(observer.order()[i], body.order()[k]);
            }
        } else if (other.left == 0 ||
                   (one.left != 0 && norm(one.box.size()) > norm(other.box.size()))) {
            open.emplace_back(one.right, b);
            open.emplace_back(one.left, b);
        } else {
            open.emplace_back(a, other.right);
            open.emplace_back(a, other.left);
        }
    }
}

// Lists the pieces whose boxes are near a box.
std::vector<std::uint32_t> pieces_near(const RigidBody& body, const Span& place, const Box& box) {
    std::vector<std::uint32_t> near;
    std::vector<std::uint32_t> open{0};  // nodes
    while (!open.empty()) {
        const RigidBody::Node& node = body.nodes()[open.back()];
        open.pop_back();
        if (!box.overlaps(swept(place, node.box))) continue;
        if (node.left != 0) {
            open.push_back(node.right);
            open.push_back(node.left);
            continue;
        }
        near.insert(near.end(), body.order().begin() + node.begin, body.order().begin() + node.end);
    }
    return near;
}

// Corners of the pieces of a body on the lattice, computed on demand.
class PointsOfPieces {
public:
    PointsOfPieces(const RigidBody& body, const Span& place, const cda::Lattice& lattice)
        : body_(body), place_(place), lattice_(lattice), points_(body.pieces().size()) {}

    const std::vector<LatticePoint>& operator[](std::uint32_t piece) {
        std::vector<LatticePoint>& points = points_[piece];
        if (points.empty()) points = points_of(body_.pieces()[piece].outer, place_, lattice_);
        return points;
    }

private:
    const RigidBody& body_;
    Span place_;
    cda::Lattice lattice_;
    std::vector<std::vector<LatticePoint>> points_;
};

class Pair {
public:
    Pair(const PairOnLeg& pair, const RigidBody& observer, const RigidBody& body,
         const cda::Lattice& lattice)
        : pair_(pair),
          observer_(observer),
          body_(body),
          lattice_(lattice),
          // Corners are rounded to the lattice by half a unit on each axis.
          rounding_mm_(observer.accuracy_mm() + body.accuracy_mm() + 2.0 * lattice.unit_mm) {}

    double rounding_mm() const { return rounding_mm_; }
    const PairOnLeg& pair_on_leg() const { return pair_; }
    const RigidBody& body() const { return body_; }

    bool is_far(const Ball& ball, double clearance_mm) const {
        return norm(ball.centre - observer_.centre()) >
               observer_.radius() + ball.radius + pair_.missed_mm + rounding_mm_ + clearance_mm;
    }

    void list(const Span& tight, double clearance_mm, Stretch& s) const {
        Span place = tight;
        place.grow_mm += clearance_mm;
        if (!s.is_listed) list_near(observer_, body_, place, s.open);
        s.is_listed = true;
        const std::int64_t width = round_up_units(place.grow_mm, lattice_);
        PointsOfPieces resting(observer_, {}, lattice_), joint_motion(body_, place, lattice_);
        // Motion of the observer, computed on demand.
        std::optional<Span> other_way;
        std::optional<PointsOfPieces> observer_going, body_resting;
        std::erase_if(s.open, [&](const PiecePair& p) {
            const Box& box = observer_.boxes()[p.first];
            if (!box.overlaps(swept(place, body_.boxes()[p.second]))) return true;
            if (cda::body_distance(resting[p.first], joint_motion[p.second], width).is_apart)
                return true;
            // A hull of two rotated positions also contains the region between the ends of a long
            // piece. The hull is smaller if the shorter body moves, so the roles are swapped.
            if (place.X_0.rows == place.X_1.rows) return false;
            if (!other_way) {
                other_way = to_body_frame(place, clearance_mm, s);
                observer_going.emplace(observer_, *other_way, lattice_);
                body_resting.emplace(body_, Span{}, lattice_);
            }
            return cda::body_distance((*body_resting)[p.second], (*observer_going)[p.first],
                                      round_up_units(other_way->grow_mm, lattice_))
                .is_apart;
        });
    }

    // Finds two pieces that meet at a time; `measured`: finds the pair with the largest
    // penetration, and the penetration.
    bool find_overlap(const Values& values, bool measured, Encounter& found) const {
        return for_each_near(values, 0.0, [&](const PiecePair& p, const Pose& X) {
            const ConvexPiece& one = observer_.pieces()[p.first];
            const ConvexPiece& other = body_.pieces()[p.second];
            const bool is_known = found.closeness == Closeness::Certain;
            if (one.inner.empty() || other.inner.empty() || (is_known && !measured)) return false;
            const auto a = points_of(one.inner, {}, lattice_);
            const auto b = points_of(other.inner, {X, X, 0.0}, lattice_);
            if (cda::body_distance(a, b, 0).is_apart) return false;
            const auto point = cda::common_point(a, b, round_up_units(rounding_mm_, lattice_));
            if (!point) return false;
            const double amount_mm = measured ? depth_mm(one, other, X) : 0.0;
            if (is_known && amount_mm <= found.amount_mm) return false;
            found = {Closeness::Certain,     0.0,       values,
                     lattice_.to_mm(*point), amount_mm, one.assumed || other.assumed};
            return true;
        });
    }

    // Finds the nearest two pieces at a time, if nearer than `clearance_mm`.
    bool find_near(const Values& values, double clearance_mm, Encounter& found) const {
        const double limit = clearance_mm - rounding_mm_;
        return for_each_near(values, clearance_mm, [&](const PiecePair& p, const Pose& X) {
            const auto a = points_of(observer_.pieces()[p.first].outer, {}, lattice_);
            const auto b = points_of(body_.pieces()[p.second].outer, {X, X, 0.0}, lattice_);
            const cda::BodyDistance near =
                cda::body_distance(a, b, round_up_units(limit, lattice_));
            const double apart = near.distance * lattice_.unit_mm;
            if (near.is_apart || apart > limit) return false;
            if (found.closeness == Closeness::Certain && apart >= found.amount_mm) return false;
            const bool assumed =
                observer_.pieces()[p.first].assumed || body_.pieces()[p.second].assumed;
            found = {Closeness::Certain,
                     0.0,
                     values,
                     X * body_.boxes()[p.second].centre(),
                     apart,
                     assumed};
            return true;
        });
    }

private:
    Span to_body_frame(const Span& place, double clearance_mm, const Stretch& s) const {
        // Bound without a known motion: larger than any distance between pieces.
        constexpr double kFar = 1e5;
        const auto ball = ball_of_observer(pair_, observer_, s);
        const double missed_mm = ball ? ball->bend / 8.0 + pair_.missed_mm : kFar;
        return {inverse(place.X_0), inverse(place.X_1), missed_mm + rounding_mm_ + clearance_mm};
    }

    static double depth_mm(const ConvexPiece& one, const ConvexPiece& other, const Pose& X) {
        std::vector<Vec3> corners;
        for (const Vec3& p : other.inner)
            corners.push_back(X * p);
        const auto turned = [&X](const std::vector<Vec3>& directions) {
            std::vector<Vec3> result;
            result.reserve(directions.size());
            for (const Vec3& d : directions)
                result.push_back({dot(X.rows[0], d), dot(X.rows[1], d), dot(X.rows[2], d)});
            return result;
        };
        const cda::Directions of_other{turned(other.directions.normals),
                                       turned(other.directions.edges)};
        return cda::depth(one.inner, one.directions, corners, of_other);
    }

    template <class Ask>
    bool for_each_near(const Values& values, double clearance_mm, const Ask& ask) const {
        const Pose X = pose_of(pair_.way, values);
        std::vector<PiecePair> near;
        list_near(observer_, body_, {X, X, rounding_mm_ + clearance_mm}, near);
        bool found = false;
        for (const PiecePair& pieces : near)
            found |= ask(pieces, X);
        return found;
    }

    const PairOnLeg& pair_;
    const RigidBody& observer_;
    const RigidBody& body_;
    cda::Lattice lattice_;
    double rounding_mm_;
};

// Finds the largest penetration: samples times of the leg, then refines around the worst time.
template <class Find>
void find_worst(const PairOnLeg& pair, const Find& find, Encounter& worst) {
    constexpr int kTimes = 16, kCloser = 40;
    const auto ask = [&](double t) {
        const auto values = pair.path.at(t);
        Encounter found;
        if (!values || !find(*values, found) || found.amount_mm <= worst.amount_mm) return false;
        worst = found;
        worst.time = t;
        return true;
    };
    for (int i = 0; i <= kTimes; ++i)
        ask(static_cast<double>(i) / kTimes);
    double width = 1.0 / kTimes;
    for (int i = 0; i < kCloser; ++i) {
        const double middle = worst.time;
        const bool is_deeper =
            ask(std::max(0.0, middle - width)) || ask(std::min(1.0, middle + width));
        if (!is_deeper) width *= 0.5;
    }
}

}  // namespace

Encounter find_contact(const PairOnLeg& pair, const RigidBody& observer, const RigidBody& body,
                       const cda::Lattice& lattice, bool measured) {
    const Pair both(pair, observer, body, lattice);
    Encounter result = search(
        pair, body, both.rounding_mm(), [&](const Ball& ball) { return both.is_far(ball, 0.0); },
        [&](const Span& place, Stretch& s) { both.list(place, 0.0, s); },
        [&](const Values& values, Encounter& found) {
            return both.find_overlap(values, false, found);
        });
    if (measured && result.closeness == Closeness::Certain) {
        find_worst(
            pair,
            [&](const Values& values, Encounter& found) {
                return both.find_overlap(values, true, found);
            },
            result);
    }
    return result;
}

Encounter search_near(const PairOnLeg& pair, const RigidBody& observer, const RigidBody& body,
                      const cda::Lattice& lattice, double clearance_mm) {
    const Pair both(pair, observer, body, lattice);
    return search(
        pair, body, both.rounding_mm(),
        [&](const Ball& ball) { return both.is_far(ball, clearance_mm); },
        [&](const Span& place, Stretch& s) { both.list(place, clearance_mm, s); },
        [&](const Values& values, Encounter& found) {
            return both.find_near(values, clearance_mm, found);
        });
}

Encounter search_part(const PairOnLeg& pair, const cda::VerifyingModel& part, const Box& stock,
                      Vec3 zero, const RigidBody& body, double clearance_mm, bool measured) {
    const cda::Lattice& lattice = part.lattice();
    // Corners, and planes of hulls of rotated corners.
    const double rounding_mm = body.accuracy_mm() + 4.0 * lattice.unit_mm;
    const Box place_of_part = widen_box(stock, clearance_mm);
    const auto to_W = [zero](Pose X) {
        X.translation = X.translation - zero;
        return X;
    };
    const auto far = [&](const Ball& ball) {
        const Vec3 centre = ball.centre - zero;
        Vec3 nearest;
        for (int i = 0; i < 3; ++i)
            nearest[i] = std::clamp(centre[i], place_of_part.min[i], place_of_part.max[i]);
        return norm(centre - nearest) > ball.radius + pair.missed_mm + rounding_mm;
    };
    const auto list = [&](const Span& specified, Stretch& s) {
        const Span place{to_W(specified.X_0), to_W(specified.X_1), specified.grow_mm};
        if (!s.is_listed) {
            for (const std::uint32_t i : pieces_near(body, place, place_of_part))
                s.open.emplace_back(0, i);
        }
        s.is_listed = true;
        std::erase_if(s.open, [&](const PiecePair& pieces) {
            if (!place_of_part.overlaps(swept(place, body.boxes()[pieces.second]))) return true;
            const auto points = points_of(body.pieces()[pieces.second].outer, place, lattice);
            const auto cell = cda::convex_hull(points, lattice, cda::kStockOrigin);
            const double grow_mm = place.grow_mm + clearance_mm;
            return !cell || !part.contact(shrink_cell(*cell, -grow_mm, lattice));
        });
    };
    const auto find = [&](const Values& values, Encounter& found) {
        const Pose X = to_W(pose_of(pair.way, values));
        bool is_found = false;
        for (const std::uint32_t i : pieces_near(body, {X, X, 0.0}, place_of_part)) {
            const ConvexPiece& piece = body.pieces()[i];
            if (piece.inner.empty() || (is_found && !measured)) continue;
            const auto points = points_of(piece.inner, {X, X, 0.0}, lattice);
            const auto cell =
                cda::convex_hull(points, lattice, cda::kStockOrigin, cda::Rounding::Inward);
            if (!cell) continue;
            // The cell shrunk by `less` on all sides; grown if `less` is negative.
            const auto contact = [&](double less) {
                return part.contact(shrink_cell(*cell, less, lattice));
            };
            double low = rounding_mm - clearance_mm;
            const auto point = contact(low);
            if (!point) continue;
            is_found = true;
            double high = clearance_mm > 0.0 ? 0.0 : 2.0 * low;
            while (measured && clearance_mm == 0.0 && high < body.longest() && contact(high)) {
                low = high;
                high *= 2.0;
            }
            while (measured && high - low > kUndecidedMm) {
                const double middle = 0.5 * (low + high);
                (contact(middle) ? low : high) = middle;
            }
            // Penetration, or distance.
            const double amount_mm = measured ? std::abs(low) : 0.0;
            const bool is_known = found.closeness == Closeness::Certain;
            const bool is_worse =
                clearance_mm > 0.0 ? amount_mm < found.amount_mm : amount_mm > found.amount_mm;
            if (is_known && !is_worse) continue;
            found = {Closeness::Certain, 0.0, values, *point + zero, amount_mm, piece.assumed};
        }
        return is_found;
    };
    return search(pair, body, rounding_mm, far, list, find);
}

}  // namespace ncsim::verify
