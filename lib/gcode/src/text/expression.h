// SPDX-License-Identifier: GPL-3.0-or-later
//
// Evaluates values: numbers, parameters, functions, expressions in brackets.
// Source: RS274/NGC: Kramer, Proctor, Messina, 2000, section 3.3.2. Fanuc Macro B differs by
// `Arithmetic`.
#pragma once

#include "text/message.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::gcode {

/// Value of a Fanuc variable that was never set, different from 0. A word with a vacant value is
/// ignored. No other value is NaN.
constexpr double kVacant = std::numeric_limits<double>::quiet_NaN();

/// Differences in arithmetic between controls.
struct Arithmetic {
    bool strict = false;         ///< Accepts only RS274/NGC.
    bool fix_truncates = false;  ///< FIX[-2.8] is -2 (Fanuc), not -3 (RS274/NGC).
    bool bitwise = false;        ///< AND, OR, XOR work on bits (Fanuc).
    bool vacant = false;         ///< Unset variables are vacant (Fanuc), not 0.
    /// EQ and NE treat numbers within 1e-4 as equal, GE and LE are exact (LinuxCNC).
    bool compares_loosely = false;
    /// ROUND rounds to multiples of 1 / `round_scale`.
    double round_scale = 1.0;
};

/// Interface to the parameters of a program.
class ParameterSource {
public:
    /// Returns the value of #`number`; nullopt if there is no such parameter.
    virtual std::optional<double> numbered(double number) const = 0;
    /// True if #`number` exists but must not be read in the present state.
    virtual bool is_hidden(double) const { return false; }
    /// Returns the value of #<`name`>; nullopt if never set.
    virtual std::optional<double> named(std::string_view name) const = 0;

protected:
    ~ParameterSource() = default;
};

/// Message about an expression that cannot be evaluated.
struct ExpressionFault {
    MessageText message = Message::UnreadableText;
    std::string argument;
};

/// Evaluates the whole of `text` as a single value ("[1+#2]", "-#3", "sin[30]"), or, if `open`, as
/// an expression without brackets ("#1+2").
/// Requires: `text` is lower case, without blanks.
/// Returns: nullopt with `fault` set if this fails.
std::optional<double> evaluate(std::string_view text, const ParameterSource& parameters,
                               const Arithmetic& arithmetic, ExpressionFault& fault,
                               bool open = false);

/// Evaluates the value at the start of `text` and removes the value from `text`.
std::optional<double> evaluate_first(std::string_view& text, const ParameterSource& parameters,
                                     const Arithmetic& arithmetic, ExpressionFault& fault);

}  // namespace ncsim::gcode
