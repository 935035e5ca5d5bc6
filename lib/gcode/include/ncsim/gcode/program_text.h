// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides whether a file is an NC program: by its text, whatever its name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ncsim::gcode {

/// Kinds of files in a folder of programs.
enum class TextKind : std::uint8_t {
    Program,   ///< G-code, Klartext, SINUMERIK, or another language of controls.
    Empty,     ///< No bytes.
    Binary,    ///< Pictures, archives, UTF-16.
    Source,    ///< C headers, Python, post-processors.
    Script,    ///< A first line that begins with "#!".
    Markup,    ///< Markdown, HTML, XML.
    Data,      ///< JSON, CSV, Gerber, differences of two texts.
    Table,     ///< Tables of tools and parameters: words or columns without codes.
    Settings,  ///< "NAME = value", "[SECTION]".
    Text,      ///< Any other text.
};

/// "program", "binary file" …
std::string_view name_of(TextKind kind);

/// Bytes at the beginning of a file that `kind_of_text` needs at most.
inline constexpr std::size_t kMostHeadBytes = 65536;

/// Returns the kind of a text of which `head` is the beginning.
/// Guarantees: never reads more than kMostHeadBytes; any bytes give a result.
TextKind kind_of_text(std::string_view head);

/// True if the ending of the file name `name` means NC programs only: ".nc", ".NGC", ".mpf" … A
/// file of such a name is a program even if its text is damaged.
bool names_program(std::string_view name);

/// True if a text, of which `head` and `tail` are the first and the last bytes, only acts when
/// another program calls it: it ends with M99, or has nothing but subroutines.
bool is_subprogram_text(std::string_view head, std::string_view tail);

}  // namespace ncsim::gcode
