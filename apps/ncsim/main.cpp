// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ncsim program: argv in, an exit code out, and the one place that catches exceptions.
#include "check.h"
#include "diff.h"
#include "options.h"
#include "run.h"

#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

int run(const ncsim::app::Farewell& farewell) {
    std::fputs(farewell.text.c_str(), farewell.exit_code == ncsim::app::kClean ? stdout : stderr);
    return farewell.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace ncsim::app;
    try {
        Command command =
            parse_options(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
        return std::visit([](auto& chosen) { return run(std::move(chosen)); }, command);
    } catch (const std::bad_alloc&) {
        std::fputs("ncsim: out of memory\n", stderr);
        return kEnvironment;
    } catch (const std::logic_error& e) {
        std::fprintf(stderr, "ncsim: a bug of ours, please report it: %s\n", e.what());
        return kBug;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "ncsim: %s\n", e.what());
        return kEnvironment;
    }
}
