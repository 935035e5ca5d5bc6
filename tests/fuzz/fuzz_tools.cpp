// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads any bytes as comments about tools, or as a tool table. Reading must end, and every
// resulting tool must be possible to make. The first byte selects the kind and the units.
#include "ncsim/toolpath/tool_file.h"
#include "ncsim/toolpath/tool_table.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

void check(const std::vector<ncsim::toolpath::ToolEntry>& tools) {
    using namespace ncsim::toolpath;
    for (const ToolEntry& entry : tools) {
        if (!is_complete(entry.spec)) std::abort();
        const Tool tool = make_tool(entry.spec, 50.0);
        if (tool.pieces.empty() || !std::isfinite(height_of(tool))) std::abort();
        if (describe(tool).empty()) std::abort();
        if (make_tool(filled(entry.spec, 50.0), 7.0).pieces != tool.pieces) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ncsim;
    if (size == 0) return 0;
    const gcode::SourceFile file{"fuzz",
                                 std::string(reinterpret_cast<const char*>(data + 1), size - 1)};
    const bool inches = (data[0] & 2U) != 0;
    if ((data[0] & 1U) == 0) {
        const toolpath::ProgramNotes notes = toolpath::read_notes(file, inches);
        check(notes.tools);
        if (notes.stock && notes.stock->box.is_empty()) std::abort();
    } else {
        const toolpath::ToolFile table = toolpath::read_tool_file(file, inches);
        check(table.tools);
        if (table.stock && table.stock->box.is_empty()) std::abort();
    }
    return 0;
}
