// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts moves along inclined tools.
#include "ncsim/simulation/plunges.h"

#include "ncsim/base/angles.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/machine/presets.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/trace.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::simulation {

namespace {

/// A possible machine.
struct Candidate {
    std::string name;
    machine::Chain turning;  // rotary joints only
    std::uint64_t moves = 0;
};

machine::Chain rotation_bounds_of(const machine::Chain& chain, bool other_signs) {
    machine::Chain turning;
    for (machine::Joint joint : chain.joints) {
        if (!joint.turns) continue;
        joint.through = {};
        if (other_signs) joint.direction = -joint.direction;
        turning.joints.push_back(joint);
    }
    return turning;
}

std::vector<Candidate> candidates_of(const Plan& plan) {
    std::vector<Candidate> all;
    if (plan.kinematics)
        all.push_back({"this machine", rotation_bounds_of(plan.kinematics->chain, false)});
    for (const machine::Preset& preset : machine::presets()) {
        const machine::Chain chain = *machine::preset(preset.name);
        all.push_back({std::string(preset.name), rotation_bounds_of(chain, false)});
        all.push_back(
            {std::string(preset.name) + " with other signs", rotation_bounds_of(chain, true)});
    }
    return all;
}

bool is_along(Vec3 way, Vec3 direction) {
    return norm(cross(way, direction)) <= sin_cos(kPlungeDegrees).sin * norm(way);
}

// Counts plunges for all candidates.
class PlungeCount {
public:
    explicit PlungeCount(const Plan& plan) : candidates_(candidates_of(plan)) {}

    void take(const gcode::Motion& motion) {
        const auto* line = std::get_if<gcode::Linear>(&motion.action);
        if (!line || !toolpath::has_known_start(motion)) return;
        const machine::Values from = toolpath::values_of(line->from);
        const machine::Values to = toolpath::values_of(line->to);
        for (std::size_t i = 3; i < 6; ++i) {
            turns_[i] |= to[i] != 0.0;
            if (from[i] != to[i]) return;
        }
        const Vec3 way{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        if (norm(way) < kLeastPlunge) return;
        constexpr Vec3 kZ{0, 0, 1};
        bool is_tilted = false, is_along_any = false;
        for (Candidate& candidate : candidates_) {
            if (!has_all(candidate, to)) continue;
            const Vec3 axis = axis_of(candidate.turning.pose(to));
            // With an upright tool, all candidates are equal.
            constexpr double kUpright = 0.02;
            if (norm(cross(axis, kZ)) < kUpright) continue;
            is_tilted = true;
            if (!is_along(way, axis)) continue;
            ++candidate.moves;
            is_along_any = true;
        }
        result_.is_tilted |= is_tilted;
        if (is_tilted && is_along(way, kZ)) {
            ++result_.along_z;
            is_along_any = true;
        }
        if (is_along_any) ++result_.moves;
    }

    Plunges result() && {
        std::vector<const Candidate*> left;
        for (const Candidate& candidate : candidates_) {
            machine::Values turned{};
            for (std::size_t i = 3; i < 6; ++i)
                turned[i] = turns_[i] ? 1.0 : 0.0;
            if (candidate.moves > 0 && has_all(candidate, turned)) left.push_back(&candidate);
        }
        std::ranges::stable_sort(left, std::ranges::greater{}, &Candidate::moves);
        // Candidates with equal rotations, for the axes that the program uses, are combined.
        std::vector<machine::Chain> chains;
        for (const Candidate* candidate : left) {
            machine::Chain chain;
            for (const machine::Joint& joint : candidate->turning.joints) {
                if (turns_[*machine::index_of(joint.letter)]) chain.joints.push_back(joint);
            }
            const auto known = std::ranges::find(chains, chain);
            if (known != chains.end()) {
                result_.tip[static_cast<std::size_t>(known - chains.begin())].machines.push_back(
                    candidate->name);
                continue;
            }
            chains.push_back(std::move(chain));
            result_.tip.push_back({{candidate->name}, candidate->moves});
        }
        return std::move(result_);
    }

private:
    static bool has_all(const Candidate& candidate, const machine::Values& values) {
        for (std::size_t i = 3; i < 6; ++i) {
            if (values[i] != 0.0 && !candidate.turning.find(machine::kLetters[i])) return false;
        }
        return true;
    }

    std::vector<Candidate> candidates_;
    std::array<bool, 9> turns_{};
    Plunges result_;
};

}  // namespace

Plunges plunges_of(const Plan& plan) {
    gcode::InterpreterOptions options = plan.job.interpreter;
    if (!plan.kinematics) {
        for (const int code : {428, 429, 430})
            options.tip_control.m_codes.emplace(code, gcode::Coordinates::Axes);
        options.tip_control.by_length_word = true;
        options.tip_control.frame_at_zero = true;
    }
    PlungeCount count(plan);
    gcode::interpret(plan.job.program, options, [&](const gcode::Motion& m) { count.take(m); });
    return std::move(count).result();
}

}  // namespace ncsim::simulation
