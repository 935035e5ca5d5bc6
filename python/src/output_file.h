// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output files that are complete or absent.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace ncsim::python {

/// Writes the file `path` by `write`. An existing file is replaced when the new file is complete.
/// Throws: std::runtime_error with the path if the file cannot be written; the exception of
/// `write`. After an exception, `path` is unchanged.
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace ncsim::python
