// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads pictures back from PNG files.
#pragma once

#include "ncsim/export/image.h"

#include <string>

namespace ncsim::test {

/// Returns the picture in the bytes of a PNG file.
/// Throws: std::runtime_error if `bytes` holds no picture.
exporter::Image read_png(const std::string& bytes);

}  // namespace ncsim::test
