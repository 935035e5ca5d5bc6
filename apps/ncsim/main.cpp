// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ncsim program: reads argv, runs a command and turns uncaught exceptions into exit codes.
#include "ncsim/base/plain_text.h"

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
#include "system/watch.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
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

// Runs `work`, and reports an exception as a message and an exit code.
int guarded(const std::function<int()>& work) {
    using namespace ncsim::app;
    try {
        return work();
    } catch (const std::bad_alloc&) {
        std::fputs("ncsim: out of memory\n", stderr);
        return kEnvironment;
    } catch (const std::logic_error& e) {
        print_error("ncsim: a bug of ours, please report it: " + ncsim::one_line(e.what()) + '\n');
        return kInternalError;
    } catch (const std::exception& e) {
        print_error("ncsim: " + ncsim::one_line(e.what()) + '\n');
        return kEnvironment;
    }
}

int run_command(ncsim::app::Command command) {
    return std::visit([](auto& chosen) { return run(std::move(chosen)); }, command);
}

// Returns the command to repeat; empty if the command runs once.
std::optional<ncsim::app::WatchedCommand> watched(const ncsim::app::Command& command,
                                                  const std::vector<std::string>& words) {
    using namespace ncsim::app;
    return std::visit(
        [&](const auto& options) -> std::optional<WatchedCommand> {
            using Of = std::remove_cvref_t<decltype(options)>;
            if constexpr (std::is_same_v<Of, Options> || std::is_same_v<Of, CheckOptions>) {
                if (!options.watch) return std::nullopt;
                // Each run reads the options again, because ncsim.toml may change.
                const auto again = [words] {
                    return guarded([&] { return run_command(options_with_project(words)); });
                };
                return WatchedCommand{again, inputs_of(options), outputs_of(options),
                                      options.quiet};
            } else {
                return std::nullopt;
            }
        },
        command);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace ncsim::app;
    prefer_large_pages(argv);
    return guarded([&] {
        keep_closed_streams_closed();
        std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
        const std::string when = take_colour(words);
        const auto colour = colour_mode(when);
        if (!colour) {
            print_error("ncsim: --color '" + ncsim::one_line(when) +
                        "': expected auto, always or never\n");
            return static_cast<int>(kEnvironment);
        }
        set_colour_mode(*colour);
        Command command = options_with_project(words);
        if (const auto repeated = watched(command, words)) return watch(*repeated);
        return run_command(std::move(command));
    });
}
