// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps the observer of inputs.
#include "ncsim/setup/input_observer.h"

#include <utility>

namespace ncsim::setup {

namespace {

InputObserver& the_observer() {
    static InputObserver observer;
    return observer;
}

}  // namespace

void observe_inputs(InputObserver observer) {
    the_observer() = std::move(observer);
}

void note_input(const std::string& path) {
    if (const InputObserver& observer = the_observer()) observer(path);
}

}  // namespace ncsim::setup
