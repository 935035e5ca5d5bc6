// SPDX-License-Identifier: GPL-3.0-or-later
//
// A library that is loaded when it is needed, not with the program. What draws comes with a
// compiler of its own, which takes longer to load than most commands take to run.
#pragma once

namespace ncsim::exporter {

/// Stays loaded until the process ends.
class SharedLibrary {
public:
    /// `name` as the loader knows it, such as libEGL.so.1. Throws std::runtime_error with what the
    /// loader says.
    explicit SharedLibrary(const char* name);

    /// Points `function` to what has this name. Throws std::runtime_error if nothing has.
    template <class Function>
    void find(Function*& function, const char* name) const {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what dlsym() is made for
        function = reinterpret_cast<Function*>(address_of(name));
    }

private:
    void* address_of(const char* name) const;
    void* handle_ = nullptr;
};

}  // namespace ncsim::exporter
