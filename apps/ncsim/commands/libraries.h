// SPDX-License-Identifier: GPL-3.0-or-later
//
// Libraries of the program, with versions and licences.
#pragma once

#include <string>
#include <vector>

namespace ncsim::app {

struct Library {
    std::string name, version, licence, use;
};

/// Returns the libraries that the program contains or loads. A shared library has the version that
/// is loaded, any other library the version of the build.
std::vector<Library> libraries();

/// Formats version, licence and libraries, a line each, for `ncsim --version --verbose`.
std::string version_text();

}  // namespace ncsim::app
