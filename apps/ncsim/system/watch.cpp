// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a command in child processes, each of which reports the files that it reads through a pipe.
#include "system/watch.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/setup/input_observer.h"
#include "ncsim/setup/program_folder.h"

#include "system/console.h"
#include "system/interruption.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Paths = std::set<std::string>;

/// State of a file or a folder; equal states mean that no run is necessary.
struct Stamp {
    std::int64_t seconds = 0, nanoseconds = 0,
                 size = -1;  ///< Time and size of a file; -1: no file.
    std::uint64_t inode = 0;
    std::vector<std::string> programs;  ///< Of a folder.

    bool operator==(const Stamp&) const = default;
};
using Stamps = std::map<std::string, Stamp>;

Stamp stamp_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    Stamp stamp;
    if (!S_ISDIR(status.st_mode)) {
        stamp.seconds = status.st_mtim.tv_sec;
        stamp.nanoseconds = status.st_mtim.tv_nsec;
        stamp.size = status.st_size;
        stamp.inode = status.st_ino;
        return stamp;
    }
    try {
        stamp.programs = setup::programs_in_folder(path).programs;
    } catch (const std::runtime_error&) {
        return {};  // The folder disappears while it is read.
    }
    return stamp;
}

Stamps stamps_of(const Paths& paths) {
    Stamps stamps;
    for (const std::string& path : paths)
        stamps.emplace(path, stamp_of(path));
    return stamps;
}

// Returns the first path of both that differs; empty if there is none.
std::string first_change(const Stamps& before, const Stamps& now) {
    for (const auto& [path, stamp] : now) {
        const auto old = before.find(path);
        if (old != before.end() && old->second != stamp) return path;
    }
    return {};
}

Paths without(Paths paths, const std::vector<std::string>& outputs) {
    const auto whole = [](const std::string& path) {
        std::error_code ignored;
        return fs::weakly_canonical(path, ignored);
    };
    std::set<fs::path> written;
    for (const std::string& output : outputs)
        written.insert(whole(output));
    std::erase_if(paths, [&](const std::string& path) { return written.contains(whole(path)); });
    return paths;
}

// Sets up a child process: signals have the effect of a program without --watch, and the child
// ends with the parent.
void set_up_repeated_run([[maybe_unused]] pid_t parent) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        ::sigaction(number, nullptr, &now);
        if (now.sa_handler != SIG_IGN) ::signal(number, SIG_DFL);
    }
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1);
#endif
}

// Returns an observer that writes each path with a zero byte to `descriptor`, in one piece.
setup::InputObserver reporter(int descriptor) {
    return [descriptor](const std::string& path) {
        if (path != "-" && path.size() < PIPE_BUF)
            (void)!::write(descriptor, path.c_str(), path.size() + 1);
    };
}

/// End of a run.
struct Run {
    std::optional<int> exit_code;  ///< Empty if a signal ended the run.
    int signal = 0;
    Paths read;  ///< Files and folders that were read or searched for.
};

Run run_in_child(const std::function<int()>& work) {
    std::array<int, 2> ends{};
    const auto fail = [] {
        throw std::runtime_error(fmt::format("--watch: cannot create a process: {}",
                                             std::generic_category().message(errno)));
    };
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail();
    (void)std::fflush(nullptr);  // Unflushed output would be written twice.
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child == 0) {
        set_up_repeated_run(parent);
        ::close(ends[0]);
        setup::observe_inputs(reporter(ends[1]));
        const int code = work();
        (void)std::fflush(nullptr);
        ::_exit(code);
    }
    ::close(ends[1]);
    if (child < 0) {
        ::close(ends[0]);
        fail();
    }
    std::string names;
    bool is_passed_on = false;
    for (bool is_open = true; is_open;) {
        pollfd waiting[2] = {{ends[0], POLLIN, 0}, {Interruption::descriptor(), POLLIN, 0}};
        (void)::poll(waiting, is_passed_on ? 1 : 2, -1);
        if (waiting[1].revents != 0) {
            ::kill(child, Interruption::signal());
            is_passed_on = true;
        }
        if (waiting[0].revents == 0) continue;
        std::array<char, 1 << 16> bytes{};
        const ssize_t n = ::read(ends[0], bytes.data(), bytes.size());
        if (n > 0) names.append(bytes.data(), static_cast<std::size_t>(n));
        is_open = n > 0 || (n < 0 && errno == EINTR);
    }
    ::close(ends[0]);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    Run run;
    if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
    for (std::size_t at = 0, end = 0; (end = names.find('\0', at)) != std::string::npos;
         at = end + 1)
        run.read.insert(names.substr(at, end - at));
    return run;
}

// Waits until files differ from `known` and do not change for one look. Returns the first changed
// path; empty after a signal.
std::string wait_for_change(const Paths& paths, const Stamps& known) {
    constexpr std::chrono::milliseconds kPause{200};
    constexpr int kShare = 20;  // Looks take at most 1 / kShare of the time.
    Stamps last = known;
    for (;;) {
        const Clock::time_point start = Clock::now();
        Stamps now = stamps_of(paths);
        const auto look =
            std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
        if (now == last) {
            if (std::string changed = first_change(known, now); !changed.empty()) return changed;
        }
        last = std::move(now);
        pollfd waiting{Interruption::descriptor(), POLLIN, 0};
        (void)::poll(&waiting, 1, static_cast<int>(std::max(kPause, kShare * look).count()));
        if (Interruption::signal() != 0) return {};
    }
}

std::string line_of(unsigned number, const std::string& changed, const Run& run,
                    std::size_t files) {
    const std::string why =
        changed.empty() ? std::string() : printable_path(changed) + " changed, ";
    const std::string end = run.exit_code ? fmt::format("exit code {}", *run.exit_code)
                                          : fmt::format("ended by signal {}", run.signal);
    return fmt::format("watch     run {}: {}{}; {} files are watched, Ctrl+C ends\n", number, why,
                       end, files);
}

}  // namespace

int watch(const WatchedCommand& command) {
    const Interruption interruption;
    const Paths named(command.inputs.begin(), command.inputs.end());
    Paths paths = without(named, command.outputs);
    Stamps known = stamps_of(paths);
    std::optional<int> last;
    std::string changed;
    for (unsigned number = 1; Interruption::signal() == 0; ++number) {
        Run run = run_in_child(command.run);
        if (Interruption::signal() != 0) break;
        last = run.exit_code.value_or(128 + run.signal);
        run.read.insert(named.begin(), named.end());
        paths = without(std::move(run.read), command.outputs);
        const Stamps now = stamps_of(paths);
        if (!command.is_quiet) print_error(line_of(number, changed, run, paths.size()));
        // A change during the run counts; files of this run alone are known from here on.
        changed = first_change(known, now);
        known = now;
        if (changed.empty()) changed = wait_for_change(paths, known);
        known = stamps_of(paths);
    }
    if (Interruption::signal() == SIGINT && last) return *last;
    Interruption::raise_again();
    return last.value_or(128 + Interruption::signal());
}

}  // namespace ncsim::app
