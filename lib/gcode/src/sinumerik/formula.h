// SPDX-License-Identifier: GPL-3.0-or-later
//
// Evaluates expressions and the targets of assignments. Angles are in degrees.
// Source: SINUMERIK 840D sl, Programming Manual NC Programming, "Operators", 06/2019.
#pragma once

#include "ncsim/gcode/diagnostic.h"

#include "sinumerik/line_reader.h"
#include "sinumerik/variables.h"
#include "text/code_scanner.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::gcode::sinumerik {

/// Values of the control that programs read: $P_TOOLR, $AA_IW[X].
class SystemValues {
public:
    /// Returns the value of `name` (upper case) with the axis `axis` in brackets, if any; nullopt
    /// if the value is unknown.
    virtual std::optional<double> system_value(std::string_view name,
                                               std::string_view axis) const = 0;

protected:
    ~SystemValues() = default;
};

/// An expression with the state of its evaluation.
class Expressions {
public:
    Expressions(Variables& variables, const SystemValues& system, DiagnosticLog& log)
        : variables_(variables), system_(system), log_(log) {}

    /// Evaluates the expression at `scan`.
    /// Returns: nullopt after reporting an error.
    std::optional<Value> value(CodeScanner& scan, const Line& line);
    std::optional<double> number(CodeScanner& scan, const Line& line);
    /// Reads an optional sign and digits: the value of a word, "X-10.5".
    std::optional<double> literal(CodeScanner& scan, const Line& line);
    /// Reads "R5", "R[R1]", "NAME", "NAME[2]".
    /// Returns: nullopt after reporting an error.
    std::optional<Target> target(CodeScanner& scan, const Line& line);
    /// Reads the indices "[1,2]".
    std::optional<std::vector<std::uint32_t>> indices(CodeScanner& scan, const Line& line);

    Variables& variables() { return variables_; }

private:
    using Operand = std::optional<Value> (Expressions::*)(CodeScanner&, const Line&);
    std::optional<Value> comparison(CodeScanner& scan, const Line& line);
    std::optional<Value> concatenation(CodeScanner& scan, const Line& line);
    std::optional<Value> logic(CodeScanner& scan, const Line& line, std::size_t level);
    std::optional<Value> sum(CodeScanner& scan, const Line& line);
    std::optional<Value> product(CodeScanner& scan, const Line& line);
    std::optional<Value> factor(CodeScanner& scan, const Line& line);
    std::optional<Value> named(CodeScanner& scan, const Line& line);
    std::optional<Value> system(CodeScanner& scan, const Line& line);
    std::optional<Value> function(std::string_view name, CodeScanner& scan, const Line& line);
    std::optional<Value> coded(CodeScanner& scan, const Line& line);
    std::optional<Value> checked(double value, SourceSpan span);
    std::optional<Value> fail(const MessageText& message, SourceSpan span,
                              std::initializer_list<std::string_view> arguments = {});

    Variables& variables_;
    const SystemValues& system_;
    DiagnosticLog& log_;
    int depth_ = 0;
};

/// Returns true if `name` is R and digits.
bool is_r_parameter(std::string_view name);
/// Returns the shortest decimal form of `value`, as texts show it.
std::string text_of(double value);

}  // namespace ncsim::gcode::sinumerik
