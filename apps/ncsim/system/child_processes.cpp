// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs pieces of work in child processes.
#include "system/child_processes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
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
#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

using Clock = std::chrono::steady_clock;

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
        if (n >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(n));
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

// Sets up a child process. The child ends with the parent, is killed first if memory runs out, and
// leaves temporary files and signals of the terminal to the parent.
void set_up_child([[maybe_unused]] pid_t parent) {
    ::signal(SIGTERM, SIG_DFL);
    for (const int by_terminal : {SIGINT, SIGHUP})
        ::signal(by_terminal, SIG_IGN);
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    const int first = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    if (first >= 0) {
        (void)write_all(first, "1000");
        ::close(first);
    }
#endif
}

class Process {
public:
    /// Starts a process; empty if the system has no room for a process.
    static std::optional<Process> start(std::size_t piece, const ProcessWork& pieces) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
        // Unflushed output would be written twice.
        (void)std::fflush(nullptr);
        const pid_t parent = ::getpid();
        const pid_t child = ::fork();
        if (child == 0) {
            set_up_child(parent);
            int code = 1;
            try {
                code = write_all(ends[1], pieces.work(piece)) ? 0 : 1;
            } catch (...) {  // NOLINT(bugprone-empty-catch): the exit code reports the fault
            }
            ::_exit(code);
        }
        const int error = errno;
        ::close(ends[1]);
        if (child < 0) ::close(ends[0]);
        errno = error;
        if (child < 0) return std::nullopt;
        return Process(piece, child, ends[0], pieces.seconds(piece));
    }

    Process(Process&& other) noexcept
        : piece_(other.piece_),
          pid_(std::exchange(other.pid_, -1)),
          descriptor_(std::exchange(other.descriptor_, -1)),
          deadline_(other.deadline_),
          output_(std::move(other.output_)),
          is_late_(other.is_late_) {}
    Process& operator=(Process&& other) noexcept {
        std::swap(piece_, other.piece_);
        std::swap(pid_, other.pid_);
        std::swap(descriptor_, other.descriptor_);
        std::swap(deadline_, other.deadline_);
        std::swap(output_, other.output_);
        std::swap(is_late_, other.is_late_);
        return *this;
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (pid_ < 0) return;
        kill();
        (void)wait();
    }

    std::size_t piece() const { return piece_; }
    int descriptor() const { return descriptor_; }
    std::optional<Clock::time_point> deadline() const { return deadline_; }

    /// Reads from the process; false at the end of its output.
    bool listen() {
        std::array<char, 1 << 16> bytes{};
        const ssize_t n = ::read(descriptor_, bytes.data(), bytes.size());
        if (n > 0) output_.append(bytes.data(), static_cast<std::size_t>(n));
        return n > 0 || (n < 0 && (errno == EINTR || errno == EAGAIN));
    }

    void kill() const { ::kill(pid_, SIGKILL); }
    void kill_late() {
        is_late_ = true;
        deadline_.reset();
        kill();
    }

    /// Waits for the end of the process.
    ProcessEnd wait() {
        int status = 0;
        while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        ::close(std::exchange(descriptor_, -1));
        ProcessEnd end;
        end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        end.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
        // The process may have finished at the same moment.
        end.is_late = is_late_ && end.signal == SIGKILL;
        if (end.has_succeeded()) end.output = std::move(output_);
        return end;
    }

private:
    Process(std::size_t piece, pid_t pid, int descriptor, double seconds)
        : piece_(piece), pid_(pid), descriptor_(descriptor) {
        if (seconds > 0.0) {
            deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(seconds));
        }
    }

    std::size_t piece_;
    pid_t pid_;
    int descriptor_;
    std::optional<Clock::time_point> deadline_;
    std::string output_;
    bool is_late_ = false;
};

// Returns the milliseconds to the first deadline; -1: none.
int milliseconds_to_deadline(const std::vector<Process>& running) {
    std::optional<Clock::time_point> first;
    for (const Process& process : running) {
        if (process.deadline() && (!first || *process.deadline() < *first))
            first = process.deadline();
    }
    if (!first) return -1;
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(*first - Clock::now()).count() + 1;
    constexpr long kMost = 1'000'000;
    return static_cast<int>(std::clamp<long>(left, 0, kMost));
}

}  // namespace

std::size_t run_in_processes(std::size_t count, unsigned jobs, const ProcessWork& pieces) {
    std::vector<Process> running;
    std::map<std::size_t, ProcessEnd> ended;  // and not reported
    std::size_t begun = 0, specified = 0, finished = 0;
    bool is_stopped = false;
    const auto tell = [&] {
        for (auto next = ended.find(specified); next != ended.end(); next = ended.find(specified)) {
            ProcessEnd end = std::move(next->second);
            ended.erase(next);
            pieces.done(specified++, std::move(end));
        }
    };
    const auto finish = [&](std::size_t piece, ProcessEnd end) {
        ended.emplace(piece, std::move(end));
        pieces.noted(++finished);
        tell();
    };
    while (!is_stopped && (begun < count || !running.empty())) {
        bool is_full = false;
        if (begun < count && running.size() < jobs) {
            if (!pieces.is_needed(begun)) {
                finish(begun++, {});
            } else if (std::optional<Process> started = Process::start(begun, pieces)) {
                running.push_back(std::move(*started));
                ++begun;
            } else if (is_full = true; running.empty()) {
                throw std::runtime_error(fmt::format("there can be no process for it: {}",
                                                     std::generic_category().message(errno)));
            }
        }
        is_full = is_full || running.size() >= jobs || begun == count;
        std::vector<pollfd> waiting{{pieces.stop_descriptor, POLLIN, 0}};
        for (const Process& process : running)
            waiting.push_back({process.descriptor(), POLLIN, 0});
        // With room for more processes, poll() does not wait.
        if (::poll(waiting.data(), waiting.size(),
                   is_full ? milliseconds_to_deadline(running) : 0) < 0) {
            if (errno == EINTR) continue;
            throw std::runtime_error(
                fmt::format("cannot wait: {}", std::generic_category().message(errno)));
        }
        is_stopped = waiting[0].revents != 0;
        for (std::size_t i = running.size(); i-- > 0 && !is_stopped;) {
            Process& process = running[i];
            if (waiting[i + 1].revents != 0 && !process.listen()) {
                const std::size_t piece = process.piece();
                ProcessEnd end = process.wait();
                running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
                finish(piece, std::move(end));
            } else if (process.deadline() && *process.deadline() <= Clock::now()) {
                process.kill_late();
            }
        }
    }
    for (Process& process : running) {
        process.kill();
        ProcessEnd end = process.wait();
        end.is_stopped = true;
        ended.emplace(process.piece(), std::move(end));
    }
    tell();
    return begun;
}

}  // namespace ncsim::app
