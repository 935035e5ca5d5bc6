// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choice of a solution by preference, travel and motion.
#include "ncsim/machine/orient.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::machine {

namespace {

constexpr double kTurn = 360.0;
constexpr double kEqual = 1e-9;  // degrees: rounding error of equal motions

// Returns the values of a joint, `angle` plus whole turns, that the travel allows near `now`.
std::vector<double> places_of(char letter, double angle, double now, const Travels& travels) {
    const auto specified = travels.find(letter);
    double low = now - kTurn, high = now + kTurn;
    if (specified != travels.end()) {
        low = std::max(low, specified->second.min - kEqual);
        high = std::min(high, specified->second.max + kEqual);
    }
    std::vector<double> places;
    for (double turns = std::ceil((low - angle) / kTurn); angle + turns * kTurn <= high; ++turns)
        places.push_back(angle + turns * kTurn);
    // The joint is far outside its travel.
    if (places.empty() && specified != travels.end()) {
        const double turns = std::ceil((specified->second.min - kEqual - angle) / kTurn);
        if (angle + turns * kTurn <= specified->second.max + kEqual)
            places.push_back(angle + turns * kTurn);
    }
    return places;
}

bool is_preferred(SolutionPreference prefer, double way, double place) {
    switch (prefer) {
        case SolutionPreference::Shortest: return true;
        case SolutionPreference::PositiveMotion: return way >= -kEqual;
        case SolutionPreference::NegativeMotion: return way <= kEqual;
        case SolutionPreference::EndPositive: return place >= -kEqual;
        case SolutionPreference::EndNegative: return place <= kEqual;
    }
    return true;
}

// Compares costs lexicographically; values that differ by rounding are equal.
using Cost = std::array<double, 4>;
bool is_less(const Cost& a, const Cost& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(a[i] - b[i]) > kEqual) return a[i] < b[i];
    }
    return false;
}

}  // namespace

const Joint* master_of(const Chain& chain) {
    std::vector<const Joint*> rotary;
    bool has_moved = false;
    std::vector<bool> of_head;
    for (const Joint& joint : chain.joints) {
        if (joint.turns) {
            rotary.push_back(&joint);
            of_head.push_back(has_moved);
        }
        has_moved |= !joint.turns;
    }
    if (rotary.size() != 2) return nullptr;
    const bool two_tables = !of_head[0] && !of_head[1];
    return two_tables ? rotary[1] : rotary[0];
}

std::optional<Turns> orient(const Chain& placed, Vec3 axis, const Values& now,
                            const Travels& travels, SolutionPreference prefer) {
    const Joint* first = master_of(placed);
    const Joint* second = nullptr;
    for (const Joint& joint : placed.joints) {
        if (!joint.turns || &joint == first) continue;
        (first ? second : first) = &joint;
    }
    std::optional<Turns> best;
    Cost least{};
    const auto weigh = [&](const Turns& turns, double q1, double q2) {
        const double way1 = first ? q1 - now[*index_of(first->letter)] : 0.0;
        const double way2 = second ? q2 - now[*index_of(second->letter)] : 0.0;
        if (!is_preferred(prefer, way1, q1)) return;
        const Cost cost{std::abs(way1), std::abs(way2), std::abs(q1), std::abs(q2)};
        if (best && !is_less(cost, least)) return;
        best = turns;
        least = cost;
        if (first) best->values[*index_of(first->letter)] = q1;
        if (second) best->values[*index_of(second->letter)] = q2;
    };
    for (const Turns& turns : orientation_solutions(placed, axis, now)) {
        const auto of = [&](const Joint* joint) {
            if (!joint) return std::vector<double>{0.0};
            const std::size_t i = *index_of(joint->letter);
            return places_of(joint->letter, turns.values[i], now[i], travels);
        };
        const std::vector<double> seconds = of(second);
        for (const double q1 : of(first)) {
            for (const double q2 : seconds)
                weigh(turns, q1, q2);
        }
    }
    return best;
}

}  // namespace ncsim::machine
