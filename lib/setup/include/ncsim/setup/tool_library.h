// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tool libraries of CAM systems that consist of several files or of XML, and all tables of
// toolpath::read_tool_file().
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/toolpath/tool_file.h"

#include <string>

namespace ncsim::setup {

/// Reads the tools of the file `path`:
///
/// - libraries of FreeCAD (.fctl, JSON) with their tool bits (.fctb), which are in the folder of
/// the
///   library or in the folder Bit next to it;
/// - libraries of HSMWorks, HSM Express and Inventor CAM (.hsmlib, XML in UTF-8 or UTF-16);
/// - libraries of Fusion as ZIP archives (.tools);
/// - all formats of toolpath::read_tool_file(), with `machine_inches` as the unit of LinuxCNC.
///
/// The content decides the format, except for .fctb. A tool that cannot be used is left out with a
/// warning. Probes are left out without a warning.
/// Throws: std::runtime_error with the file if it cannot be read, is not XML, JSON or ZIP, or is a
/// single tool bit, which has no number.
toolpath::ToolFile read_tool_library(const std::string& path, InputSet& inputs,
                                     bool machine_inches = false);

}  // namespace ncsim::setup
