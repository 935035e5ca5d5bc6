// SPDX-License-Identifier: GPL-3.0-or-later
//
// Detection of the control for which a program was written.
#pragma once

#include "ncsim/gcode/source.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// A dialect: the rules by which a family of controls reads blocks. Heidenhain (Klartext) and
/// Sinumerik are languages other than G-code. SinumerikIso: ISO mode of SINUMERIK, read as Fanuc.
enum class Dialect : std::uint8_t {
    Auto,
    Rs274,
    Fanuc,
    Haas,
    Grbl,
    Mach3,
    Heidenhain,
    Sinumerik,
    SinumerikIso
};
/// All dialects, in the order of messages.
inline constexpr std::array kDialectList{
    Dialect::Auto,  Dialect::Rs274,      Dialect::Fanuc,     Dialect::Haas,        Dialect::Grbl,
    Dialect::Mach3, Dialect::Heidenhain, Dialect::Sinumerik, Dialect::SinumerikIso};

/// Direction of the offset at the end of the first move with cutter compensation: square to the
/// move itself (LinuxCNC, Mach3), or square to the start of the next move (Fanuc, Haas: type A).
/// Source: LinuxCNC 2.9, "Cutter Compensation"; Fanuc 15i/150i-MA manual B-63324EN/03, II-14.4.1;
/// Haas Mill Operator's Manual, "Entry and Exit from Cutter Compensation".
enum class CompensationStart : std::uint8_t { SquareToItself, SquareToNext };

/// Returns the name of `dialect`: "rs274", "fanuc" …
std::string_view name_of(Dialect dialect);

/// Kinds of programs by machine and language. Milling programs in G-code are `Milling`.
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
/// Returns the name of `kind` for messages: "Siemens controls", "a lathe" …
std::string_view name_of(Kind kind);

/// A sign that supports a conclusion, with the first line that has the sign.
struct Evidence {
    std::string text;
    std::uint32_t line = 0;
};

/// Dialect and kind of a program, with the evidence.
struct DialectFindings {
    Dialect dialect = Dialect::Rs274;  ///< Never Auto.
    bool stated = false;               ///< Specified by the user, not concluded.
    Kind kind = Kind::Milling;
    std::vector<Evidence> evidence;       ///< For `dialect`.
    std::vector<Evidence> kind_evidence;  ///< For `kind`.
    /// C words occur only with X or Y of straight lines and have small positive values. Such words
    /// may be sizes of chamfers, as on lathes, instead of positions of a rotary axis.
    bool c_may_be_corner = false;
};

/// Concludes the dialect and the kind of `program` from signs in the text. Without a sign the
/// dialect is Rs274, the common core. After the first 128 kB, lines of plain words such as G2 X1.5
/// I2 are not searched for signs because plain words look alike on all controls.
DialectFindings detect_dialect(const SourceFile& program);

}  // namespace ncsim::gcode
