// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures as PNG files.
#pragma once

#include "ncsim/export/image.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `image` as PNG, without an alpha channel if every pixel is opaque.
/// Guarantees: equal images give equal bytes; the file has no time stamp and no program name.
/// Throws: std::runtime_error if the image has no pixels, is too large for the format, or the
///     stream fails.
void write_png(std::ostream& out, const Image& image);

}  // namespace ncsim::exporter
