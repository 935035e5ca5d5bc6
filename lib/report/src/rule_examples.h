// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs that fail and pass a rule: the files of examples/rules, which are part of the program.
#pragma once

#include <string_view>
#include <vector>

namespace ncsim::report {

struct ExampleFile {
    std::string_view name;  ///< Without the folder: "fails.nc".
    std::string_view text;  ///< Empty for a mesh.
};

/// Returns the files of the folder `rule`, sorted by name: fails.nc, passes.nc, ncsim.toml, and the
/// files that ncsim.toml names. Empty if there is no such folder.
std::vector<ExampleFile> rule_example(std::string_view rule);

}  // namespace ncsim::report
