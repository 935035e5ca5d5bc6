// SPDX-License-Identifier: GPL-3.0-or-later
//
// From what is written to what is meant: values are computed, codes sorted into their groups,
// words that nobody knows reported.
#pragma once

#include "ncsim/gcode/interpretation.h"

#include "control/command.h"
#include "control/parameters.h"
#include "control/rules.h"
#include "text/expression.h"

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::gcode {

class Resolver {
public:
    Resolver(const Rules& rules, const Parameters& parameters, DiagnosticLog& log,
             const InterpreterOptions& options);

    /// Fills `command` from `block`. False after reporting an error.
    bool resolve(const Block& block, Command& command);

    /// The value of one word; nullopt after reporting an error. Vacant values come as kVacant.
    std::optional<double> value_of(const Word& word);
    /// The value of an expression of a block, of which `span` is the place. The value decides what
    /// the program does, so an unknown variable in it is reported.
    std::optional<double> value_of(std::string_view text, SourceSpan span, bool open);
    /// The same for a value that is only kept. `unknown` becomes the name of an unknown variable it
    /// depends on, or empty.
    std::optional<double> value_to_keep(std::string_view text, SourceSpan span, bool open,
                                        std::string& unknown);
    std::optional<double> value_to_keep(const Word& word, std::string& unknown);
    /// True for words that are declared harmless: "G187", and "O9023", a program of the control.
    bool is_allowed(char letter, double value) const;
    /// Reports that the program depends on the variable `name`, unless that is empty.
    void report_unknown(std::string_view name, SourceSpan span);

private:
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
    std::set<std::string, std::less<>> named_;  // unknown variables that were reported
};

}  // namespace ncsim::gcode
