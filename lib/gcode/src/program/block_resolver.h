// SPDX-License-Identifier: GPL-3.0-or-later
//
// Resolves blocks to commands: evaluates values, sorts codes into groups, reports unknown words.
#pragma once

#include "ncsim/gcode/interpretation.h"

#include "control/command.h"
#include "control/control_rules.h"
#include "control/parameters.h"
#include "text/expression.h"

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::gcode {

/// Resolves blocks to commands.
class Resolver {
public:
    Resolver(const Rules& rules, const Parameters& parameters, DiagnosticLog& log,
             const InterpreterOptions& options);

    /// Fills `command` from `block`.
    /// Returns: false after reporting an error.
    bool resolve(const Block& block, Command& command);

    /// Returns the value of `word`, kVacant for a vacant value; nullopt after reporting an error.
    std::optional<double> value_of(const Word& word);
    /// Returns the value of the expression `text` at `span`; nullopt after reporting an error. The
    /// value controls the program, so an unknown variable in `text` is reported.
    std::optional<double> value_of(std::string_view text, SourceSpan span, bool open);
    /// Returns a value that is only stored. `unknown` becomes the name of an unknown variable on
    /// which the value depends, or empty.
    std::optional<double> value_to_keep(std::string_view text, SourceSpan span, bool open,
                                        std::string& unknown);
    std::optional<double> value_to_keep(const Word& word, std::string& unknown);
    /// True for words declared harmless: "G187", and "O9023", a program of the control.
    bool is_allowed(char letter, double value) const;
    /// Reports that the program depends on the variable `name`, unless `name` is empty.
    void report_unknown(std::string_view name, SourceSpan span);

private:
    std::optional<double> evaluated(std::string_view text, SourceSpan span, bool open,
                                    const Arithmetic& arithmetic, std::string& unknown);
    double round_scale_of(char letter) const;
    void report_power(std::string_view text, SourceSpan span);
    bool take_g(const Block& block, const Word& word, double value, Command& command);
    bool take_m(const Word& word, double value, Command& command);
    std::string text_of(const Word& word, double value) const;
    bool tolerate(const MessageText& message, SourceSpan span,
                  std::initializer_list<std::string_view> arguments);

    const Rules& rules_;
    const Parameters& parameters_;
    DiagnosticLog& log_;
    const TipControl& tip_control_;
    const std::vector<RotaryClamp>& clamps_;
    bool knows_joints_ = false;
    std::vector<std::pair<char, double>> allow_;
    bool unknown_g_ = false;
    std::set<std::string, std::less<>> named_;  // Unknown variables that were reported.
};

}  // namespace ncsim::gcode
