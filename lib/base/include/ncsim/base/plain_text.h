// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text from outside (programs, file names, set-up files) for terminals and logs of CI services: the
// text is shown, but commands in it have no effect.
#pragma once

#include <string>
#include <string_view>

namespace ncsim {

/// Returns `text` without sequences that a terminal or a CI service interprets. The number of bytes
/// stays the same.
/// - Control characters except line ends, and characters that change the writing direction, become
///   '?'; tabs become blanks.
/// - "##[error]", "##vso[…]" and "##teamcity[…]", which services recognise anywhere in a line,
///   become "#?[error]" etc.
/// - "::" and "##" at the start of a line, also after blanks, get '?' as their first character.
std::string printable(std::string_view text);

/// Returns printable(text) with '?' in place of line ends, for use inside a line.
std::string one_line(std::string_view text);

/// Returns `path` in one line, for the start of a line or a cell of a table. A name that looks like
/// a command or a formula gets the prefix "./", which leads to the same file.
std::string printable_path(std::string_view path);

/// Returns equivalent JSON without markers that CI services recognise anywhere in a line.
std::string printable_json(std::string text);

}  // namespace ncsim
