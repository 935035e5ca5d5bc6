// SPDX-License-Identifier: GPL-3.0-or-later
//
// A second look with finer tools where the accuracy of the tools leaves open whether something
// touches: the program once more up to that motion, but only in the small boxes that are open.
#pragma once

#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/setup.h"

#include <cstdint>
#include <optional>

namespace ncsim::simulation {

class Refiner {
public:
    /// `setup` is what is verified against; all three must outlive it.
    Refiner(const Plan& plan, const Survey& survey, const verify::Setup& setup);

    /// Tools sixteen times as fine, then once more so. Certain as soon as one of the boxes is,
    /// nothing if none of them is open any more. Costs a simulation of the boxes each; after
    /// kMostLooks of them, or about as much work as the simulation of the program, everything
    /// stays open. The result depends on what was asked so far.
    std::optional<verify::Certainty> decide(const verify::OpenContact& contact);

private:
    static constexpr int kMostLooks = 64;
    // A step that meets no box costs a hundredth of one that cuts.
    static constexpr std::uint64_t kStepsPerMove = 64;
    static constexpr std::uint64_t kLeastSteps = 20'000;

    std::optional<verify::Certainty> look(const verify::OpenContact& contact, const cda::Box& box,
                                          double factor);

    const Plan* plan_;
    const Survey* survey_;
    const verify::Setup* setup_;
    int looks_ = 0;
    std::uint64_t steps_left_;
};

}  // namespace ncsim::simulation
