// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which control a program was written for.
#pragma once

#include "ncsim/gcode/source.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

enum class Dialect : std::uint8_t { Auto, Rs274, Fanuc, Haas, Grbl, Mach3 };

/// Direction of the offset at the end of the first move with cutter compensation: square to the
/// move itself (LinuxCNC, Mach3), or square to the start of the next move (Fanuc, Haas: type A).
/// Source: LinuxCNC 2.9, "Cutter Compensation"; Fanuc 15i/150i-MA manual B-63324EN/03, II-14.4.1;
/// Haas Mill Operator's Manual, "Entry and Exit from Cutter Compensation".
enum class CompensationStart : std::uint8_t { SquareToItself, SquareToNext };

/// "rs274", "fanuc" …
std::string_view name_of(Dialect dialect);

/// Programs for other machines, and in other languages.
enum class Kind : std::uint8_t {
    Milling,
    Heidenhain,
    HeidenhainIso,
    Siemens,
    Okuma,
    Isg,
    Lathe,
    Laser,
    Plasma,
    Printer,
    NotAProgram,
};
std::string_view name_of(Kind kind);

/// One thing that speaks for a conclusion, with the place where it was seen first.
struct Evidence {
    std::string text;
    std::uint32_t line = 0;
};

struct DialectFindings {
    Dialect dialect = Dialect::Rs274;  ///< Never Auto.
    bool stated = false;               ///< Given by the user, not concluded.
    Kind kind = Kind::Milling;
    std::vector<Evidence> evidence;       ///< For `dialect`.
    std::vector<Evidence> kind_evidence;  ///< For `kind`.
    /// C stands only beside X or Y of straight lines, and is small and above 0: the size of a
    /// chamfer, as lathes have it, rather than a turn of an axis.
    bool c_may_be_corner = false;
};

/// Looks at the program and concludes. Without any sign: Rs274, the common core. Every line of the
/// first 128 kB counts; behind them, lines of plain words (G1 X1.5 Y2) are passed by, since they
/// look alike on all controls.
DialectFindings detect_dialect(const SourceFile& program);

}  // namespace ncsim::gcode
