// SPDX-License-Identifier: GPL-3.0-or-later
//
// Repeated simulation with finer tools, if the accuracy of the tools leaves a contact open: the
// program is run up to that motion, but only in the small open boxes.
#pragma once

#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/setup.h"

#include <cstdint>

namespace ncsim::simulation {

/// Decides contacts that the accuracy of the tools leaves open.
class Refiner {
public:
    /// Keeps references. `setup` is the set-up of the verification. Requires: all arguments outlive
    /// this object.
    Refiner(const Plan& plan, const Survey& survey, const verify::Setup& setup);

    /// Decides a contact with tools 16 times, then 256 times as fine. Certain as soon as a box is
    /// certain; empty if no box is open any more. After kMaxRefinements simulations, or after about
    /// as much work as the simulation of the program, all contacts stay open. The result depends on
    /// the preceding calls. Cost: a simulation per box and accuracy.
    verify::ContactDecision decide(const verify::OpenContact& contact);

private:
    static constexpr int kMaxRefinements = 64;
    // A step without contact costs a hundredth of a cutting step.
    static constexpr std::uint64_t kStepsPerMove = 64;
    static constexpr std::uint64_t kLeastSteps = 20'000;

    verify::ContactDecision refine_once(const verify::OpenContact& contact, const Box& box,
                                        double factor);

    const Plan* plan_;
    const Survey* survey_;
    const verify::Setup* setup_;
    int refinements_ = 0;
    std::uint64_t steps_left_;
};

}  // namespace ncsim::simulation
