// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools and stock as programs tell them: in comments, which CAM systems write in many forms.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool_spec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::toolpath {

/// Who said it.
enum class ToldBy : std::uint8_t { Comment, Option, Table, Assumption };

struct ToolEntry {
    ToolSpec spec;
    ToldBy told_by = ToldBy::Comment;
    gcode::SourceSpan span;  ///< Of the comment or the line of a table; line 0: none.
    std::string text{};      ///< As written.
    std::string file{};      ///< Of a table; empty: the program.
    cda::Vec3 offset{};      ///< What G43 applies, mm; known to some tables.
};

struct StockEntry : Stock {
    ToldBy told_by = ToldBy::Comment;
    gcode::SourceSpan span;
    std::string text{};  ///< As written; for a derived stock the rule.
    std::string file{};  ///< Of a table; empty: the program.
    /// Only the size is told: it lies at the zero, where its corner or its middle is as a rule.
    bool place_assumed = false;
};

/// What the comments of a program tell.
struct ProgramNotes {
    std::vector<ToolEntry> tools;  ///< One per number, in the order of the program.
    std::optional<StockEntry> stock;
    std::optional<cda::Vec3> start;  ///< FROM/X,Y,Z, in mm.
    gcode::Diagnostics diagnostics;  ///< Comments that contradict each other.
};

/// Scans the comments of `program`. Total: any byte sequence gives a result; what is not understood
/// is a comment. O(size of the program).
///
/// Understood for tools: Fusion 360 and its relatives (`T1 D=10. CR=0. TAPER=118deg - ZMIN=-5. -
/// flat end mill`), CutViewer (`TOOL/MILL,Dia,CornerR,Height,Taper`, also DRILL, CHAMFER, CDRILL),
/// FreeCAD, Makera and Carvera (`@MKR|TOOL|number=7|…`), Kiri:Moto (`tool#=1 flute=6 len=20
/// unit=metric`), PowerMill (`Tool Number: 3`, `DIAMETER: 6.0`, `TIP RADIUS: 0.5`) and PyCAM
/// (`shape = ToroidalCutter`, `tool_radius = 3.0`), each thing in a comment; Estlcam (`Required
/// tools:` with a list in the order of the calls); and whatever is shaped like the description of a
/// tool, as Mastercam, Vectric, SolidCAM and people write it: number, size, kind and what else
/// belongs to one, in any order, in English, German, French, Spanish or Italian (`T3 | 1/2 FLAT
/// ENDMILL | H3`, `NO. 7 DRILL`, `Kugelfräser D6`). Not understood on purpose: prose, names of
/// operations, and comments where more than one number could be the size.
///
/// For the stock: `STOCK/BLOCK,L,W,H,Ox,Oy,Oz` (sizes, and the program's zero seen from the block's
/// smallest corner), `stockMin:x, y, z` with `stockMax:x, y, z`, `BLK FORM 0.1 Z X+0 Y+0 Z-10` with
/// `BLK FORM 0.2 X+80 Y+40 Z+0`, Vectric (`X Min = 0. Y Min = 0. Z Min = -10.` with `X Max = …`;
/// `Material Size`, then `X= 76., Y= 5.5, Z= 1.`; `XY Origin for Material = …`, `Z Origin for
/// Material = …`, without which the zero is the lower left corner on top), `Material Size: X76.
/// Y5.5 Z1.`, Kiri:Moto (`Stock X:76 Y:5.5 Z:1`), CNCSimulator (`$SetPartSize(76,5.5,1)`).
///
/// A comment that names a number speaks of that tool; one that does not, of the tool called next
/// before any move, else of the tool called last; without any call, of tool 0. A stated diameter
/// (D=, DIA) beats a size in a name. A length without a unit is in the units of the program where
/// the tool is called. The first comment about a tool wins; a later one of another diameter is a
/// warning.
ProgramNotes read_notes(const gcode::SourceFile& program, bool default_inches = false);

/// The entry of a tool number, null if there is none.
const ToolEntry* find_tool(const std::vector<ToolEntry>& tools, int number);

}  // namespace ncsim::toolpath
