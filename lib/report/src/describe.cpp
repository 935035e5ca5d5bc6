// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of volumes.
#include "ncsim/report/describe.h"

#include <fmt/format.h>

namespace ncsim::report {

std::string volume_text(double mm3) {
    return fmt::format("{:.3f} cm3", mm3 / 1000);
}

}  // namespace ncsim::report
