// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a value is worth: numbers, parameters, functions, expressions in brackets.
//
// RS274/NGC: Kramer, Proctor, Messina, 2000, section 3.3.2; Fanuc Macro B differs where
// `Arithmetic` says so.
#pragma once

#include "text/message.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::gcode {

/// A Fanuc variable that was never set; differs from 0, and a word with it is no word. No other
/// value is ever NaN.
constexpr double kVacant = std::numeric_limits<double>::quiet_NaN();

/// Where controls calculate differently.
struct Arithmetic {
    bool strict = false;         ///< Only what RS274/NGC allows.
    bool fix_truncates = false;  ///< FIX[-2.8] is -2 (Fanuc), not -3 (RS274/NGC).
    bool bitwise = false;        ///< AND, OR, XOR work on bits (Fanuc).
    bool vacant = false;         ///< Unset variables are vacant (Fanuc), not 0.
    /// EQ and NE regard numbers within 1e-4 as equal, GE and LE are exact (LinuxCNC).
    bool compares_loosely = false;
};

/// Where parameters come from.
class ParameterSource {
public:
    /// The value of #number; nullopt if there is no such parameter.
    virtual std::optional<double> numbered(double number) const = 0;
    /// True if #`number` exists and the control does not let it be read now.
    virtual bool is_hidden(double) const { return false; }
    /// The value of #<name>; nullopt if it was never set.
    virtual std::optional<double> named(std::string_view name) const = 0;

protected:
    ~ParameterSource() = default;
};

struct ExpressionFault {
    MessageText message = Message::UnreadableText;
    std::string argument;
};

/// Evaluates one value ("[1+#2]", "-#3", "sin[30]"), or with `open` an expression without
/// brackets ("#1+2"), all of `text`: lower case, without blanks. nullopt: `fault` says why.
std::optional<double> evaluate(std::string_view text, const ParameterSource& parameters,
                               const Arithmetic& arithmetic, ExpressionFault& fault,
                               bool open = false);

/// The same for the value at the start of `text`, which is taken off it.
std::optional<double> evaluate_first(std::string_view& text, const ParameterSource& parameters,
                                     const Arithmetic& arithmetic, ExpressionFault& fault);

}  // namespace ncsim::gcode
