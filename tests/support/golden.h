// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole pictures against those in folders named golden, which somebody has looked at.
#pragma once

#include "ncsim/export/image.h"

#include <string>

namespace ncsim::exporter::test {

/// Fails where the picture is not as in tests/<file>. Other versions of Mesa may round an edge
/// differently, so a few pixels may differ. With NCSIM_UPDATE_GOLDENS set in the environment the
/// file is written anew: look at it before you commit it.
void expect_like_golden(const Image& image, const std::string& file);

}  // namespace ncsim::exporter::test
