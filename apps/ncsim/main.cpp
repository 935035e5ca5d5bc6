// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ncsim program: reads argv, runs a command and turns uncaught exceptions into exit codes.
#include "ncsim/report/plain_text.h"

#include "check/check_command.h"
#include "commands/diff.h"
#include "commands/machine_command.h"
#include "commands/measure_command.h"
#include "commands/options.h"
#include "commands/project.h"
#include "merge/merge.h"
#include "run/run.h"
#include "system/console.h"
#include "system/large_pages.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

int run(const ncsim::app::EarlyExit& early_exit) {
    if (early_exit.exit_code == ncsim::app::kClean) {
        ncsim::app::put_text(early_exit.text);
    } else {
        ncsim::app::print_error(early_exit.text);
    }
    return early_exit.exit_code;
}

// Opens /dev/null for each standard stream that the caller has closed, so no opened file takes its
// place.
void keep_closed_streams_closed() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) != -1) continue;
        // Opened in the wrong direction, so reads and writes still fail.
        (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

}  // namespace

int main(int argc, char** argv) {
    using namespace ncsim::app;
    prefer_large_pages(argv);
    try {
        keep_closed_streams_closed();
        std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
        const std::string when = take_colour(words);
        const auto colour = colour_mode(when);
        if (!colour) {
            print_error("ncsim: --color '" + ncsim::report::one_line(when) +
                        "': expected auto, always or never\n");
            return kEnvironment;
        }
        set_colour_mode(*colour);
        Command command = options_with_project(words);
        return std::visit([](auto& chosen) { return run(std::move(chosen)); }, command);
    } catch (const std::bad_alloc&) {
        std::fputs("ncsim: out of memory\n", stderr);
        return kEnvironment;
    } catch (const std::logic_error& e) {
        print_error("ncsim: a bug of ours, please report it: " + ncsim::report::one_line(e.what()) +
                    '\n');
        return kInternalError;
    } catch (const std::exception& e) {
        print_error("ncsim: " + ncsim::report::one_line(e.what()) + '\n');
        return kEnvironment;
    }
}
