// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes messages and results.
#include "system/console.h"

#include "ncsim/report/plain_text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

void print_error(std::string_view text) {
    const std::string shown = report::printable(text);
    std::fwrite(shown.data(), 1, shown.size(), stderr);
}

void write_stdout(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() ||
        std::fflush(stdout) != 0) {
        throw std::runtime_error(fmt::format("cannot write to the standard output: {}",
                                             std::generic_category().message(errno)));
    }
}

void put_text(std::string_view text, bool aside) {
    if (aside) {
        print_error(text);
    } else {
        write_stdout(report::printable(text));
    }
}

void print_findings(const gcode::SourceFile& program, const gcode::Diagnostics& diagnostics) {
    for (const gcode::Diagnostic& d : diagnostics) {
        print_error(gcode::render(d, program));
    }
}

}  // namespace ncsim::app
