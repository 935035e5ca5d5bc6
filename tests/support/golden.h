// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares whole pictures with the reviewed pictures in folders named golden.
#pragma once

#include "ncsim/export/image.h"

#include <string>

namespace ncsim::test {

/// Fails if `image` differs from the picture in tests/<file>. A few pixels may differ, because
/// versions of Mesa round edges differently. If NCSIM_UPDATE_GOLDENS is set in the environment, the
/// file is written anew; look at the picture before you commit the file.
void expect_like_golden(const exporter::Image& image, const std::string& file);

}  // namespace ncsim::test
