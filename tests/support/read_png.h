// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures back from their files.
#pragma once

#include "ncsim/export/image.h"

#include <string>

namespace ncsim::exporter::test {

/// The picture in a PNG file's bytes; throws std::runtime_error if there is none.
Image read_png(const std::string& bytes);

}  // namespace ncsim::exporter::test
