// SPDX-License-Identifier: GPL-3.0-or-later
//
// nightly_programs [COUNT [FIRST]]: COUNT (10,000) random NC programs from number FIRST (0), each
// run from the text to the part and checked with round tools on their exact paths (examine.h). Exit
// code 1 at the first error, with the text and the command of the program. nightly_programs --show
// N: text and command of program N. nightly_programs --turning …: the same with programs of long
// tools with rotary moves.
#include "nightly/examine.h"
#include "nightly/program_generator.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>

namespace {

using namespace ncsim::nightly;

void show(const Program& program) {
    std::printf("%s\nwith these lines as program.nc:\n\n    ncsim run program.nc",
                program.text.c_str());
    for (const std::string& argument : program.arguments)
        std::printf(" '%s'", argument.c_str());
    std::printf("\n");
}

// Message with the number of the current program, for crashes and signals.
std::array<char, 64> under_way{};

void set_under_way(long number) {
    std::snprintf(under_way.data(), under_way.size(), "\nunder way: program %ld\n", number);
}

void tell_and_die(int signal) {
    // Only async-signal-safe functions are permitted here. An error of write() cannot be reported.
    const auto written = ::write(STDOUT_FILENO, under_way.data(), std::strlen(under_way.data()));
    static_cast<void>(written);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

class Progress {
public:
    explicit Progress(long count) : count_(count) {}

    void add(const Tally& tally) {
        ++done_;
        sum_ += tally;
        if (done_ % std::max(1L, count_ / 20) != 0) return;
        std::printf("programs: %ld of %ld, %.0f CPU s\n", done_, count_,
                    static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
        std::fflush(stdout);
    }

    void finish() const {
        const auto percent = [](std::uint64_t part, std::uint64_t whole) {
            return 100.0 * static_cast<double>(part) /
                   static_cast<double>(std::max<std::uint64_t>(1, whole));
        };
        std::printf("programs: %ld of %ld clean\n", done_, count_);
        std::printf("  %llu hulls; %llu programs compared with cda-flat\n",
                    static_cast<unsigned long long>(sum_.hulls),
                    static_cast<unsigned long long>(sum_.flat));
        std::printf(
            "  %llu points, %.0f %% of them certain (%.0f %% of those material), %llu asked of "
            "meshes\n",
            static_cast<unsigned long long>(sum_.points), percent(sum_.certain, sum_.points),
            percent(sum_.material, sum_.certain),
            static_cast<unsigned long long>(sum_.asked_of_mesh));
        std::printf("  %llu places of surfaces whose line was there\n",
                    static_cast<unsigned long long>(sum_.lines));
    }

private:
    long count_;
    long done_ = 0;
    Tally sum_;
};

}  // namespace

int main(int argc, char** argv) {
    const bool turning = argc > 1 && std::strcmp(argv[1], "--turning") == 0;
    const auto program_of = turning ? random_turning_program : random_program;
    if (turning) --argc, ++argv;
    if (argc == 3 && std::strcmp(argv[1], "--show") == 0) {
        show(program_of(std::strtoull(argv[2], nullptr, 10)));
        return 0;
    }
    const long count = argc > 1 ? std::atol(argv[1]) : 10000;
    const long first = argc > 2 ? std::atol(argv[2]) : 0;
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGINT, SIGTERM})
        std::signal(signal, tell_and_die);
    const ProgramFile file;
    Progress progress(count);
    int wrong = 0;
    for (long number = first; number < first + count; ++number) {
        set_under_way(number);
        const Program program = program_of(static_cast<std::uint64_t>(number));
        try {
            progress.add(examine(program, file));
        } catch (const std::exception& e) {
            std::printf("program %ld: %s\n\n", number, e.what());
            show(program);
            std::printf("\nto examine it again:\n\n    nightly_programs%s 1 %ld\n",
                        turning ? " --turning" : "", number);
            if (++wrong == 10) return 1;
        }
    }
    progress.finish();
    return wrong > 0 ? 1 : 0;
}
