// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes messages and results.
#include "system/console.h"

#include "ncsim/base/plain_text.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

namespace {

ColourMode mode_of_all = ColourMode::Auto;

std::string shown_on(int descriptor, std::string_view text) {
    const std::string plain = printable(text);
    return has_colours(mode_of_all, descriptor) ? coloured(plain) : plain;
}

}  // namespace

void set_colour_mode(ColourMode mode) {
    mode_of_all = mode;
}

void print_error(std::string_view text) {
    const std::string shown = shown_on(STDERR_FILENO, text);
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
        write_stdout(shown_on(STDOUT_FILENO, text));
    }
}

void print_findings(const gcode::SourceFile& program, const gcode::Diagnostics& diagnostics) {
    for (const gcode::Diagnostic& d : diagnostics) {
        print_error(gcode::render(d, program));
    }
}

}  // namespace ncsim::app
