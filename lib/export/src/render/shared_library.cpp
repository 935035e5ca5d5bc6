// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loading of libraries with dlopen().
#include "render/shared_library.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace ncsim::exporter {

namespace {

[[noreturn]] void fail() {
    const char* reason = dlerror();
    throw std::runtime_error(std::string("cannot render: ") +
                             (reason != nullptr ? reason : "a library cannot be loaded"));
}

}  // namespace

SharedLibrary::SharedLibrary(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) fail();
}

void* SharedLibrary::address_of(const char* name) const {
    void* address = dlsym(handle_, name);
    if (address == nullptr) fail();
    return address;
}

}  // namespace ncsim::exporter
