// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides from the text of a file whether the file is an NC program.
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

/// Returns the name of `kind`: "program", "binary file" …
std::string_view name_of(TextKind kind);

/// Largest number of bytes at the beginning of a file that `kind_of_text` needs.
inline constexpr std::size_t kMostHeadBytes = 65536;

/// Returns the kind of a text that begins with `head`.
/// Guarantees: reads at most kMostHeadBytes; any bytes give a result.
TextKind kind_of_text(std::string_view head);

/// True if the extension of the file name `name` is used for NC programs only: ".nc", ".NGC",
/// ".mpf" … A file with such a name is a program even if the text is damaged.
bool names_program(std::string_view name);

/// True if a text with the first bytes `head` and the last bytes `tail` acts only when another
/// program calls it: the text ends with M99, or contains only subroutines.
bool is_subprogram_text(std::string_view head, std::string_view tail);

}  // namespace ncsim::gcode
