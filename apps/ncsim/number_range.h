// SPDX-License-Identifier: GPL-3.0-or-later
//
// What numbers of options may be.
#pragma once

#include <CLI/CLI.hpp>

namespace ncsim::app {

/// From `least` to `most`, both allowed. Refuses what is no number by name, too: compared with nan,
/// nothing is too much.
CLI::Validator number_range(double least, double most);

}  // namespace ncsim::app
