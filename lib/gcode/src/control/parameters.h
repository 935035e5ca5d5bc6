// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbered and named parameters, the local ones of a call, and those that show the state of
// the machine. Kept apart from MachineState, which is copied often.
#pragma once

#include "ncsim/gcode/state.h"

#include "control/copy_on_write.h"
#include "control/store.h"
#include "text/expression.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// What parameters can show besides what was assigned.
struct MachineView {
    const MachineState* state = nullptr;
    const CopyOnWrite<Store>* store = nullptr;
    std::uint32_t line = 0;
    int call_level = 0;
    double return_value = 0.0;
    bool has_return_value = false;
};

class Parameters final : public ParameterSource {
public:
    static constexpr std::size_t kLocals = 33;  ///< #1 … #33; RS274/NGC calls keep #1 … #30 apart.

    std::optional<double> numbered(double number) const override;
    std::optional<double> named(std::string_view name) const override;

    /// False: there is no such parameter, or it can only be read.
    bool set_numbered(double number, double value);
    bool set_named(std::string_view name, double value);
    static bool is_read_only(double number);

    /// Unset variables are vacant, not 0; the range of numbers is a control's, not RS274's.
    void set_rules(bool vacant, bool strict);

    /// Calls: the local variables and local names of the caller are put away.
    struct Locals {
        std::array<double, kLocals + 1> numbers{};
        std::map<std::string, double, std::less<>> names;
    };
    Locals take_locals(std::size_t count);
    void restore_locals(Locals locals, std::size_t count);

    MachineView view;

private:
    std::optional<double> of_machine(int number) const;
    double empty() const { return vacant_ ? kVacant : 0.0; }

    bool vacant_ = false;
    bool strict_ = false;
    std::array<double, kLocals + 1> locals_{};
    std::vector<double> numbers_;  // by number; as long as needed
    std::map<std::string, double, std::less<>> local_names_;
    std::map<std::string, double, std::less<>> global_names_;
};

}  // namespace ncsim::gcode
