// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text from outside (programs, file names, set-up files) on its way to a terminal or into the log
// of a CI service: shown, never obeyed.
#pragma once

#include <string>
#include <string_view>

namespace ncsim::report {

/// `text` without what a terminal or a CI service would obey. Control characters other than line
/// ends become '?', blanks for tabs, and so do characters that turn the direction of writing.
/// "##[error]", "##vso[…]" and "##teamcity[…]", which services look for anywhere in a line, become
/// "#?[error]"; "::" and "##" at the beginning of a line, behind blanks, lose their first character
/// to a '?'. As many bytes as before.
std::string printable(std::string_view text);

/// The same without line ends, which become '?': one thing of many in a text that we compose.
std::string one_line(std::string_view text);

/// The path of a file at the beginning of a line, or in a cell of a table: in one line, with "./"
/// before a name that begins with what could be taken for a command or a formula. It leads to the
/// same file.
std::string shown_path(std::string_view path);

/// JSON that says the same, without what CI services look for anywhere in a line.
std::string shown_json(std::string text);

}  // namespace ncsim::report
