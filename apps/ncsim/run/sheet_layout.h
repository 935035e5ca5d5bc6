// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places of views on a sheet.
#pragma once

#include "ncsim/export/camera.h"
#include "ncsim/export/contact_sheet.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::app {

/// Returns a cell for each view, as on a drawing in third angle: the view from above is above the
/// front view, the view from the right is on the right. The isometric view is at the upper right.
/// Empty if the front view is missing, or a view is there twice.
std::vector<exporter::SheetCell> third_angle(std::span<const exporter::View> views);

/// Returns the number of columns of a sheet of these views.
std::uint32_t columns_of(std::span<const exporter::View> views);

}  // namespace ncsim::app
