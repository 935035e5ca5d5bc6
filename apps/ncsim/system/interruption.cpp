// SPDX-License-Identifier: GPL-3.0-or-later
//
// Notes signals.
#include "system/interruption.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::app {

namespace {

constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};

// The handler may neither allocate nor lock.
volatile sig_atomic_t received_signal = 0;
int pipe_ends[2] = {-1, -1};
struct sigaction earlier_actions[kSignals.size()];

void open_pipe(int (&pipe)[2]) {
    if (::pipe2(pipe, O_CLOEXEC | O_NONBLOCK) != 0) {
        throw std::runtime_error(
            fmt::format("there can be no pipe: {}", std::generic_category().message(errno)));
    }
}

void close_pipe(int (&pipe)[2]) {
    for (int& end : pipe)
        ::close(std::exchange(end, -1));
}

void restore_handlers() {
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        ::sigaction(kSignals[i], &earlier_actions[i], nullptr);
}

extern "C" void note_signal(int number) {
    const int error = errno;
    received_signal = number;
    restore_handlers();
    const char byte = 0;
    (void)!::write(pipe_ends[1], &byte, 1);
    errno = error;
}

}  // namespace

Interruption::Interruption() {
    open_pipe(pipe_ends);
    received_signal = 0;
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        ::sigaction(kSignals[i], nullptr, &earlier_actions[i]);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        if (earlier_actions[i].sa_handler == SIG_IGN) continue;
        struct sigaction handler {};
        handler.sa_handler = note_signal;
        ::sigemptyset(&handler.sa_mask);
        for (const int other : kSignals)
            ::sigaddset(&handler.sa_mask, other);
        ::sigaction(kSignals[i], &handler, nullptr);
    }
}

Interruption::~Interruption() {
    restore_handlers();
    close_pipe(pipe_ends);
}

int Interruption::signal() {
    return received_signal;
}

std::string Interruption::name() {
    const int number = received_signal;
    return number == SIGINT ? "SIGINT" : number == SIGTERM ? "SIGTERM" : "SIGHUP";
}

int Interruption::descriptor() {
    return pipe_ends[0];
}

void Interruption::raise_again() {
    const int number = received_signal;
    if (number == 0) return;
    ::signal(number, SIG_DFL);
    ::raise(number);
}

InterruptionScope::InterruptionScope(std::function<void()> act) {
    open_pipe(stop_);
    thread_ = std::thread([this, act = std::move(act)] {
        pollfd waiting[2] = {{Interruption::descriptor(), POLLIN, 0}, {stop_[0], POLLIN, 0}};
        while (::poll(waiting, 2, -1) < 0 && errno == EINTR) {
        }
        if (waiting[0].revents != 0) act();
    });
}

InterruptionScope::~InterruptionScope() {
    const char byte = 0;
    (void)!::write(stop_[1], &byte, 1);
    thread_.join();
    close_pipe(stop_);
}

}  // namespace ncsim::app
