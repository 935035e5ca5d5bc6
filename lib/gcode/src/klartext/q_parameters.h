// SPDX-License-Identifier: GPL-3.0-or-later
//
// Q parameters of a program and the formulas with Q parameters.
#pragma once

#include "ncsim/gcode/diagnostic.h"

#include "klartext/block.h"
#include "klartext/scanner.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::gcode::klartext {

/// Q, QL, QR and QS parameters.
class Parameters {
public:
    explicit Parameters(DiagnosticLog& log) : log_(log) {}

    /// Returns the value of a word. Reports a parameter that has no value, which counts as 0, and
    /// a number that is too large.
    /// Requires: `value` has a value.
    /// Returns: nullopt after reporting an error.
    std::optional<double> value_of(const Value& value, SourceSpan span);
    /// Reads a value without operators: "+Q5", "-10.5".
    std::optional<double> read_value(Scanner& scan, const Block& block);
    /// Evaluates the formula up to the end of the code.
    std::optional<double> read_formula(Scanner& scan, const Block& block);

    /// Takes over the values of `other`.
    void copy_values(const Parameters& other);

    /// Sets a parameter.
    /// Returns: false if there is no such parameter.
    bool set(const Value& parameter, double value);
    /// Sets a parameter to 0 that the control would read from the machine.
    void set_unknown(const Value& parameter);
    /// Sets a Q parameter of the control: Q108, Q120 …
    void set_system(std::uint32_t index, double value) {
        (void)set({Value::Kind::Parameter, 'Q', index, 1.0}, value);
    }

    /// Returns the text of QS`index`; nullopt if it was never set.
    std::optional<std::string> text(std::uint32_t index) const;
    void set_text(std::uint32_t index, std::string text) { texts_[index] = std::move(text); }

    /// Local parameters (QL) of a program, saved during a call.
    using Locals = std::map<std::uint32_t, double>;
    Locals take_locals() { return std::exchange(locals_, {}); }
    void restore_locals(Locals locals) { locals_ = std::move(locals); }

private:
    std::optional<double> sum(Scanner& scan, const Block& block, int depth);
    std::optional<double> product(Scanner& scan, const Block& block, int depth);
    std::optional<double> power(Scanner& scan, const Block& block, int depth);
    std::optional<double> factor(Scanner& scan, const Block& block, int depth);
    std::optional<double> function(std::string_view name, double x, SourceSpan span);
    std::optional<double> checked(double value, SourceSpan span);
    std::optional<double> fail(const MessageText& message, SourceSpan span,
                               std::string_view argument = {});

    static constexpr std::uint32_t kMost = 2000;
    DiagnosticLog& log_;
    std::array<double, kMost> values_{};
    std::array<bool, kMost> is_set_{};
    Locals locals_, kept_;
    std::map<std::uint32_t, std::string> texts_;
    std::set<std::pair<char, std::uint32_t>> reported_;
};

}  // namespace ncsim::gcode::klartext
