// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools and stock in the comments of programs, which CAM systems write in many forms.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/operation_name.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool_spec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::toolpath {

/// Origin of a value.
enum class ValueSource : std::uint8_t { Comment, Option, Table, Assumption };

/// A tool and the place where it was specified.
struct ToolEntry {
    ToolSpec spec;
    ValueSource specified_by = ValueSource::Comment;
    /// Position of the comment or of the line of a table; line 0 if there is none.
    gcode::SourceSpan span;
    std::string text{};  ///< As written.
    std::string file{};  ///< Name of the tool table; empty for the program.
    Vec3 offset{};       ///< Offset that G43 applies, mm; some tables specify it.
};

/// A stock and the place where it was specified.
struct StockEntry : Stock {
    ValueSource specified_by = ValueSource::Comment;
    gcode::SourceSpan span;
    std::string text{};  ///< Text in the file; for a derived stock the rule.
    std::string file{};  ///< Name of the tool table; empty for the program.
    /// True if only the size is specified. The position is assumed: the zero is at a corner or at
    /// the centre, as usual.
    bool place_assumed = false;
};

/// Tools and stock that the comments of a program specify.
struct ProgramNotes {
    std::vector<ToolEntry> tools;  ///< At most one per number, in the order of the program.
    std::optional<StockEntry> stock;
    std::optional<Vec3> start;  ///< FROM/X,Y,Z, in mm.
    /// Names of operations in the order of lines: none if there are more than 200 different ones,
    /// and none that stands there more than five times.
    std::vector<OperationName> operations;
    gcode::Diagnostics diagnostics;  ///< Warnings about contradictory comments.
};

/// Scans the comments of `program`. Any byte sequence gives a result; text that is not understood
/// is a comment without effect.
///
/// Tools are understood in these forms: Fusion 360 and related programs (`T1 D=10. CR=0.
/// TAPER=118deg - ZMIN=-5. - flat end mill`), CutViewer (`TOOL/MILL,Dia,CornerR,Height,Taper`, also
/// DRILL, CHAMFER, CDRILL), FreeCAD, Makera and Carvera (`@MKR|TOOL|number=7|…`), Kiri:Moto
/// (`tool#=1 flute=6 len=20 unit=metric`), PowerMill (`Tool Number: 3`, `DIAMETER: 6.0`, `TIP
/// RADIUS: 0.5`) and PyCAM (`shape = ToroidalCutter`, `tool_radius = 3.0`), with a value per
/// comment; Estlcam (`Required tools:` with a list in the order of the calls); and any comment with
/// the form of a tool description, as Mastercam, Vectric, SolidCAM and users write it: number,
/// size, kind and further properties, in any order, in English, German, French, Spanish or Italian
/// (`T3 | 1/2 FLAT ENDMILL | H3`, `NO. 7 DRILL`, `Kugelfräser D6`). Prose, names of operations, and
/// comments with more than one possible size are ignored on purpose.
///
/// Stock is understood in these forms: `STOCK/BLOCK,L,W,H,Ox,Oy,Oz` (sizes, and the program zero
/// relative to the block's smallest corner), `stockMin:x, y, z` with `stockMax:x, y, z`, `BLK FORM
/// 0.1 Z X+0 Y+0 Z-10` with `BLK FORM 0.2 X+80 Y+40 Z+0`, Vectric (`X Min = 0. Y Min = 0. Z Min =
/// -10.` with `X Max = …`; `Material Size`, then `X= 76., Y= 5.5, Z= 1.`; `XY Origin for Material =
/// …`, `Z Origin for Material = …`, without which the zero is the lower left corner on top),
/// `Material Size: X76. Y5.5 Z1.`, Kiri:Moto (`Stock X:76 Y:5.5 Z:1`), CNCSimulator
/// (`$SetPartSize(76,5.5,1)`).
///
/// A comment with a tool number describes that tool. A comment without a number describes the tool
/// called next before any move, otherwise the tool called last; without any call, tool 0. A stated
/// diameter (D=, DIA) takes precedence over a size in a name. A length without a unit is in the
/// units of the program at the call of the tool. The first comment about a tool counts; a later
/// comment with a different diameter gives a warning.
///
/// Cost: O(size of the program).
ProgramNotes read_notes(const gcode::SourceFile& program, bool default_inches = false);

/// Returns the entry of tool `number`; null if there is none.
const ToolEntry* find_tool(const std::vector<ToolEntry>& tools, int number);

}  // namespace ncsim::toolpath
