// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeded programs with all that has to be told of them: block, tools, vice, clamp, table, travels.
// Each is right, though often by nothing: flutes exactly as long as a pass is deep, a traverse that
// slides on a clamp, the end of a travel reached. And each of them with one fault put in, of which
// the construction knows what has to be told, and where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace ncsim::test {

/// A program, its set-up, and the verdict that is right.
struct Judged {
    std::string text;
    std::string machine;               ///< TOML.
    std::vector<std::string> options;  ///< Of `ncsim check`, but for the machine.
    std::string fault;                 ///< Name; empty: none.
    std::string verdict = "clean";     ///< As in the JSON report.
    std::string tells;                 ///< Rule or reason for doubt; empty: none.
    std::size_t line = 0;              ///< Where; 0: the construction does not know.
    std::set<std::string> may_tell;    ///< What may follow from the fault besides.
};

/// Without a fault. The same in every run, on every machine.
Judged right_set_up(std::uint64_t seed);
/// The same with a fault; `name` chooses which, if the program has room for it. Without a name any.
Judged wrong_set_up(std::uint64_t seed, const std::string& name = {});
/// The faults that the program of this seed has room for.
std::set<std::string> faults_of(std::uint64_t seed);

}  // namespace ncsim::test
