// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tool tables of other programs: what stands in files beside an NC program.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool_table.h"

#include <optional>
#include <string>
#include <vector>

namespace ncsim::toolpath {

/// What such a file tells.
struct ToolFile {
    std::string format;               ///< "LinuxCNC tool table" …; empty: none that is known.
    std::vector<ToolEntry> tools;     ///< One per number, told by ToldBy::Table.
    std::optional<StockEntry> stock;  ///< CAMotics projects tell it.
    std::optional<bool> inches;       ///< CAMotics: the unit of programs without G20 and G21.
    /// An error where the file cannot be used, a warning for each tool that cannot.
    gcode::Diagnostics diagnostics;
};

/// Reads the tools of
///
/// - LinuxCNC's tool.tbl (LinuxCNC, *Tool Compensation*): diameters and offsets are in the units of
///   the machine, inches if `machine_inches`; the kind of a tool stands in its remark, if anywhere;
/// - CAMotics projects (.camotics, JSON) with their workpiece, whose bounds are in mm;
/// - tool libraries of Fusion 360 and its relatives (JSON): the tools that have a number
///   (post-process.number);
/// - tools of Kiri:Moto (JSON).
///
/// The content decides, not the name. Total: any byte sequence gives a result. A tool that has no
/// diameter or a shape we do not have is left out with a warning; the first of a number counts.
ToolFile read_tool_file(const gcode::SourceFile& file, bool machine_inches = false);

}  // namespace ncsim::toolpath
