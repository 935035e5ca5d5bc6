// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of the bodies that meet at a finding.
#pragma once

#include "ncsim/export/image.h"

namespace ncsim::app {

inline constexpr exporter::Rgba8 kMarkedTool{226, 48, 40};        ///< Cutter.
inline constexpr exporter::Rgba8 kMarkedHolder{186, 62, 58};      ///< Shank and holder.
inline constexpr exporter::Rgba8 kFirstMarkedBody{240, 150, 40};  ///< Fixture or link.
inline constexpr exporter::Rgba8 kSecondMarkedBody{214, 84, 40};  ///< Second link.

}  // namespace ncsim::app
