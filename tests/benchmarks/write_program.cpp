// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_program NAME: prints a program of programs.h.
#include "programs.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    try {
        const std::string text = ncsim::bench::program_named(argc > 1 ? argv[1] : "");
        return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 2;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "write_program: %s\n", e.what());
        return 2;
    }
}
