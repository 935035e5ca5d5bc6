// SPDX-License-Identifier: GPL-3.0-or-later
//
// Assigns diagnostics of the interpreter to rules and to reasons for doubt.
#include "finding_log.h"
#include "rule_table.h"

#include <array>
#include <utility>

namespace ncsim::verify {

namespace {

using Entry = std::pair<std::string_view, std::string_view>;

}  // namespace

std::string_view rule_of_diagnostic(std::string_view code) {
    static constexpr auto kTable = std::to_array<Entry>({
        {"unknown-g", "unsupported-word"},
        {"not-simulated", "unsupported-word"},
        {"corner-word", "unsupported-word"},
        {"unknown-m", "unsupported-word"},
        {"macro-missing", "unsupported-word"},
        {"program-not-found", "unsupported-word"},
        {"unknown-word", "unsupported-word"},
        {"o-word-unknown", "unsupported-word"},
        {"function-unknown", "unsupported-word"},
        {"console-command", "unsupported-word"},
        {"g10-form", "unsupported-word"},
        {"tilted-plane", "unsupported-word"},
        {"kinematics", "unsupported-word"},
        {"lathe-cycle", "unsupported-word"},
        {"unreachable-orientation", "unreachable-orientation"},
        {"left-on", "mode-left-on"},
        {"change-without-retract", "change-without-retract"},
        {"tool-unknown", "tool-undefined"},
        {"offset-unknown", "offset-undefined"},
        {"compensation-radius-unknown", "offset-undefined"},
        // Rules report these codes motion by motion.
        {"start-unknown", ""},
        {"feed-missing", ""},
        // Reported as doubts only.
        {"variable-unknown", ""},
        {"control-alarm", ""},
    });
    for (const auto& [known, rule] : kTable) {
        if (known == code) return rule;
    }
    return "program-fault";
}

std::string_view doubt_of_diagnostic(std::string_view code) {
    static constexpr auto kTable = std::to_array<Entry>({
        {"unknown-m", "left-out"},
        {"unknown-word", "left-out"},
        {"console-command", "left-out"},
        {"g10-form", "left-out"},
        {"data-line", "left-out"},
        {"parameter-shown", "left-out"},
        {"variable-not-applied", "left-out"},
        {"macro-missing", "left-out"},
        {"program-not-found", "left-out"},
        {"variable-timing", "reading-guess"},
        {"variable-unknown", "variable-unknown"},
        {"control-alarm", "not-simulated"},
        {"word-unused", "reading-guess"},
        {"word-twice", "reading-guess"},
        {"codes-exclude", "reading-guess"},
        {"axes-before-motion", "reading-guess"},
        {"axes-after-g80", "reading-guess"},
        {"g53-incremental", "reading-guess"},
        {"g53-motion", "reading-guess"},
        {"arc-centre-mode", "reading-guess"},
        {"arc-two-forms", "reading-guess"},
        {"centre-outside-plane", "reading-guess"},
        {"arc-turns", "reading-guess"},
        {"arc-long-way", "reading-guess"},
        {"polar-increment", "reading-guess"},
        {"slash-after-value", "reading-guess"},
        {"language-switch", "reading-guess"},
        {"power-operator", "reading-guess"},
        {"cycle-without-place", "reading-guess"},
        {"cycle-words-lost", "reading-guess"},
        {"one-sided-feed", "reading-guess"},
        {"cycle-scaled", "reading-guess"},
        {"forbidden-with-compensation", "reading-guess"},
        {"compensation-entry", "reading-guess"},
        {"arc-spiral", "reading-guess"},
        {"cycle-word-missing", "reading-guess"},
        {"word-missing", "reading-guess"},
        {"cycle-upside-down", "reading-guess"},
        {"compensation-twice", "reading-guess"},
        {"compensation-exit", "reading-guess"},
        {"comment-unclosed", "reading-guess"},
        {"tool-change-in-comment", "reading-guess"},
        {"foreign-kind", "reading-guess"},
        {"tool-conflict", "contradiction"},
        {"compensation-radius-unknown", "radius-guess"},
        {"tool-unknown", "tool-guess"},
        {"tool-edge", "length-offset"},
        {"tool-change", "reading-guess"},
        {"machine-point", "reading-guess"},
        {"feed-unit", "units-guess"},
        {"preset-missing", "reading-guess"},
        {"pocket-size", "reading-guess"},
        {"mills-outside", "reading-guess"},
        {"corner-direction", "reading-guess"},
        {"countersink", "reading-guess"},
        {"slot-position", "reading-guess"},
        {"contour-lead", "reading-guess"},
        {"turn-fraction", "reading-guess"},
        {"tool-probe", "not-simulated"},
        {"inner-radius", "reading-guess"},
        {"cycle-parameter-left-out", "reading-guess"},
        {"turn-by-vector", "reading-guess"},
        {"moves-after-end", "not-simulated"},
        {"never-called", "not-simulated"},
        {"other-programs", "not-simulated"},
    });
    for (const auto& [known, reason] : kTable) {
        if (known == code) return reason;
    }
    return "";
}

}  // namespace ncsim::verify
