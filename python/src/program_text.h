// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs with a program in memory.
#pragma once

#include "ncsim/setup/input.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace ncsim::python {

/// Input files, and the text of a program as the file `name`.
class ProgramText : public setup::InputSet {
public:
    /// Makes the set without a text if `text` is empty (nullopt).
    ProgramText(std::string name, std::optional<std::string> text)
        : name_(std::move(name)), text_(std::move(text)) {}

    std::string read(const std::string& path, std::uintmax_t most = setup::kMostBytes) override {
        return text_ && path == name_ ? *text_ : InputSet::read(path, most);
    }
    bool is_there(const std::string& path) override {
        return (text_ && path == name_) || InputSet::is_there(path);
    }

private:
    std::string name_;
    std::optional<std::string> text_;
};

}  // namespace ncsim::python
