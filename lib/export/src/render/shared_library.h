// SPDX-License-Identifier: GPL-3.0-or-later
//
// A library that is loaded at run time.
#pragma once

namespace ncsim::exporter {

/// Loaded library; unloaded when the process ends.
class SharedLibrary {
public:
    /// Loads the library `name`, for instance libEGL.so.1.
    /// Throws: std::runtime_error with the message of the loader.
    explicit SharedLibrary(const char* name);

    /// Points `function` to the symbol `name`.
    /// Throws: std::runtime_error if the library lacks the symbol.
    template <class Function>
    void find(Function*& function, const char* name) const {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): of dlsym()
        function = reinterpret_cast<Function*>(address_of(name));
    }

private:
    void* address_of(const char* name) const;
    void* handle_ = nullptr;
};

}  // namespace ncsim::exporter
