// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeded programs with complete set-ups: block, tools, vice, clamp, table, travels. Each is
// correct, often with zero margin: flutes exactly as long as a pass is deep, a traverse that slides
// on a clamp, a move to the end of a travel. Each program also exists with a single inserted fault,
// for which the construction specifies the expected finding and its line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace ncsim::test {

/// Program with set-up and the correct verdict.
struct Judged {
    std::string text;
    std::string machine;               ///< TOML.
    std::vector<std::string> options;  ///< Options of `ncsim check`, without --machine.
    std::string fault;                 ///< Name of the inserted fault; empty: no fault.
    std::string verdict = "clean";     ///< Verdict as in the JSON report.
    std::string tells;                 ///< Expected rule or reason for doubt; empty: none.
    std::size_t line = 0;              ///< Expected line; 0: the construction does not determine
                                       ///< the line.
    std::set<std::string> may_tell;    ///< Further findings that the fault may cause.
};

/// Returns a set-up without faults, identical in each run and on each machine.
Judged right_set_up(std::uint64_t seed);
/// Returns the set-up of `seed` with a fault. `name` selects the fault, if the program has room for
/// it; an empty `name` permits any fault.
Judged wrong_set_up(std::uint64_t seed, const std::string& name = {});
/// Returns the names of the faults for which the program of `seed` has room.
std::set<std::string> faults_of(std::uint64_t seed);

}  // namespace ncsim::test
