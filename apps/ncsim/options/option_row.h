// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables of options. A row is the only place that names an option: help, ncsim.toml, the keys of
// the cache and of tiles, messages and docs/reference/cli.md follow from the row.
#pragma once

#include "options/cli.h"
#include "options/refusal.h"

#include <fmt/format.h>

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ncsim::app {

using cli::kInTiles;
using cli::kLimit;
using cli::kLook;
using cli::kOfPart;
using cli::kOfTiles;
using cli::kRequired;
using cli::kResult;
using cli::kText;
using cli::kWork;
using cli::with;
using cli::within;
using cli::without;

/// Option of commands whose options are in an object of type Of.
template <class Of>
struct OptionRow {
    const char* names;  ///< "--jobs,-j"; without dashes: the words that are no option.
    const char* type;   ///< Kind of value in help; empty: the option takes no value.
    cli::Counts counts;
    const char* text;
    /// Adds the option, which stores its value in the object.
    cli::Option* (*add)(cli::App&, const OptionRow&, Of&);
    cli::Limits limits{};
};

/// Adds the options of a table to `command`, which reads into `options`. `group`: heading in help.
/// Requires: `options` outlives `command`.
template <class Of>
void add_rows(cli::App& command, const char* group,
              std::span<const OptionRow<std::type_identity_t<Of>>> rows, Of& options) {
    for (const OptionRow<Of>& row : rows)
        row.add(command, row, options)->describe(row.type, group, row.counts, row.limits);
}

/// Word of the command line, and the value that it denotes.
template <class Value>
struct Choice {
    std::string_view word;
    Value value;
};

/// Returns "a, b or c".
std::string any_of(const std::vector<std::string>& words);

/// Returns the value of a word.
/// Throws: Refusal with the known words.
template <class Choices>
auto chosen(const char* option, const std::string& text, const Choices& choices) {
    std::vector<std::string> known;
    for (const auto& choice : choices) {
        if (text == choice.word) return choice.value;
        known.emplace_back(choice.word);
    }
    throw Refusal{fmt::format("{} '{}': expected {}", option, text, any_of(known))};
}

// The functions below are for OptionRow::add.

/// Stores the value in a member: a text, a number, a flag, a switch, or a list of texts, each with
/// the name of the option.
template <auto Member, class Of>
cli::Option* store(cli::App& command, const OptionRow<Of>& row, Of& options) {
    auto& value = options.*Member;
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::same_as<Value, bool>) {
        return command.add_flag(row.names, value, row.text);
    } else if constexpr (std::same_as<Value, std::optional<bool>>) {
        return command.add_switch(row.names, value, row.text);
    } else {
        cli::Option* const option = command.add_option(row.names, value, row.text);
        const bool is_repeated = std::same_as<Value, std::vector<std::string>> && *row.names == '-';
        return is_repeated ? option->accept_one_value() : option;
    }
}

/// Stores a list of texts, which commas separate, too.
template <auto Member, class Of>
cli::Option* store_list(cli::App& command, const OptionRow<Of>& row, Of& options) {
    return command.add_option(row.names, options.*Member, row.text)->accept_list();
}

/// Calls Act(option, value, options). Value: a text, a number, or a list of texts, each with the
/// name of the option.
template <auto Act, class Of, class Base, class Value>
cli::Option* add_action(cli::App& command, const OptionRow<Of>& row, Of& options,
                        void (*)(const char*, const Value&, Base&)) {
    const auto take = [&options, name = row.names](const Value& value) {
        Act(name, value, options);
    };
    cli::Option* const option = command.add_option_function<Value>(row.names, take, row.text);
    return std::same_as<Value, std::vector<std::string>> ? option->accept_one_value() : option;
}
template <auto Act, class Of>
cli::Option* act(cli::App& command, const OptionRow<Of>& row, Of& options) {
    return add_action<Act>(command, row, options, Act);
}
/// Does the same as act(); commas also separate texts.
template <auto Act, class Of>
cli::Option* act_on_list(cli::App& command, const OptionRow<Of>& row, Of& options) {
    return act<Act>(command, row, options)->accept_list();
}

/// Stores Read(option, text) in a member.
template <auto Member, auto Read, class Of>
cli::Option* read(cli::App& command, const OptionRow<Of>& row, Of& options) {
    const auto take = [&options, name = row.names](const std::string& text) {
        options.*Member = Read(name, text);
    };
    return command.add_option_function<std::string>(row.names, take, row.text);
}

/// Stores the value of a word of Choices in a member.
template <auto Member, const auto& Choices, class Of>
cli::Option* choose(cli::App& command, const OptionRow<Of>& row, Of& options) {
    const auto take = [&options, name = row.names](const std::string& text) {
        options.*Member = chosen(name, text, Choices);
    };
    return command.add_option_function<std::string>(row.names, take, row.text);
}

}  // namespace ncsim::app
