// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbered and named parameters, local parameters of calls, and parameters that show the state of
// the machine. Separate from MachineState because MachineState is copied often.
#pragma once

#include "ncsim/gcode/state.h"

#include "control/control_rules.h"
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

/// State shown by parameters that the program does not assign.
struct MachineView {
    const MachineState* state = nullptr;
    const CopyOnWrite<Store>* store = nullptr;
    std::uint32_t line = 0;
    int call_level = 0;
    double return_value = 0.0;
    bool has_return_value = false;
};

/// The parameters of a program.
class Parameters final : public ParameterSource {
public:
    static constexpr std::size_t kLocals = 33;  ///< #1 … #33; RS274/NGC calls save #1 … #30.

    std::optional<double> numbered(double number) const override;
    bool is_hidden(double number) const override;
    std::optional<double> named(std::string_view name) const override;

    /// Sets #`number`. `unknown`: name of the unknown variable on which `value` depends, if any.
    /// Returns: false if the parameter does not exist or is read-only.
    bool set_numbered(double number, double value, std::string_view unknown = {});
    bool set_named(std::string_view name, double value, std::string_view unknown = {});
    static bool is_read_only(double number);
    /// Sets "#500" or "#<_depth>" to the value that the job specifies.
    /// Returns: false if there is no such parameter.
    bool specify(std::string_view name, double value);
    /// Makes #`number` show the state of the machine again, and discards the assigned value.
    void show_machine(int number);

    /// Returns the first variable read since the last call whose value neither the program nor the
    /// job specifies; empty if there is none. A computed value keeps the name of the variable on
    /// which the value depends.
    std::string take_unknown() const;

    void set_rules(const Rules& rules);

    /// Local variables and local names of a caller, saved during a call.
    struct Locals {
        std::array<double, kLocals + 1> numbers{};
        std::array<bool, kLocals + 1> is_set{};
        std::map<std::string, double, std::less<>> names;
        std::map<std::string, std::string, std::less<>> computed_from;
    };
    Locals take_locals(std::size_t count);
    void restore_locals(Locals locals, std::size_t count);

    MachineView view;

private:
    /// A value of the machine; `is_known`: the program or the job determines the value.
    struct MachineValue {
        double value = 0.0;
        bool is_known = true;
    };
    std::optional<MachineValue> machine_value(int number) const;
    std::optional<MachineValue> offset_value(int number) const;
    std::optional<MachineValue> fanuc_variable(int number) const;
    std::optional<MachineValue> predefined(std::string_view name) const;
    double empty() const { return rules_.arithmetic.vacant ? kVacant : 0.0; }
    void note_read(std::string_view key, bool is_set) const;
    void keep_origin(std::string_view key, std::string_view unknown);

    Rules rules_;
    std::array<double, kLocals + 1> locals_{};
    std::array<bool, kLocals + 1> locals_set_{};
    std::vector<double> numbers_;       // By number; grows on demand.
    std::vector<std::uint8_t> is_set_;  // Size of numbers_.
    /// Name of the unknown variable on which each variable depends. Keys: "#500", "#<_name>".
    std::map<std::string, std::string, std::less<>> computed_from_;
    mutable std::string unknown_;  // See take_unknown().
    std::map<std::string, double, std::less<>> local_names_;
    std::map<std::string, double, std::less<>> global_names_;
};

}  // namespace ncsim::gcode
