// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tool tables of other programs, in files next to an NC program.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool_table.h"

#include <optional>
#include <string>
#include <vector>

namespace ncsim::toolpath {

/// Content of a tool file.
struct ToolFile {
    std::string format;            ///< "LinuxCNC tool table" …; empty if the format is unknown.
    std::vector<ToolEntry> tools;  ///< At most one per number, with ValueSource::Table.
    std::optional<StockEntry> stock;  ///< Stock of a CAMotics project.
    std::optional<bool> inches;  ///< Unit of programs without G20 and G21, in CAMotics projects.
    /// An error if the file cannot be used; a warning for each tool that cannot be used.
    gcode::Diagnostics diagnostics;
};

/// Reads the tools of
///
/// - LinuxCNC's tool.tbl: diameters and offsets are in the units of the machine, inches if
///   `machine_inches`; the kind of a tool is in its remark, if given;
/// - CSV with a line of column names (tool number, diameter …), as spreadsheets and Carbide Create
///   write it; lengths without a unit as in tool.tbl;
/// - CAMotics projects (.camotics, JSON) with their workpiece, whose bounds are in mm;
/// - tool libraries of Fusion 360 and related programs (JSON): the tools that have a number
///   (post-process.number);
/// - tools of Kiri:Moto (JSON).
///
/// The content decides the format, not the file name. Any byte sequence gives a result. A tool
/// without diameter or with an unsupported shape is left out with a warning. The first tool of a
/// number counts.
///
/// Source: LinuxCNC, *Tool Compensation*.
ToolFile read_tool_file(const gcode::SourceFile& file, bool machine_inches = false);

}  // namespace ncsim::toolpath
