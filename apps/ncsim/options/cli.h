// SPDX-License-Identifier: GPL-3.0-or-later
//
// Commands and options, as far as the program needs both. Names are taken from CLI11. Only cli.cpp
// includes CLI11, because the headers take nearly half of the time of a first build.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): namespace of CLI11
class App;
class Option;
}  // namespace CLI

namespace ncsim::app::cli {

/// Uses of the value of an option, apart from its effect in the command.
struct Counts {
    bool cache = false;    ///< Part of the key of cached verdicts and shards.
    bool tile = false;     ///< Kept in tiles, for the command that merges the tiles.
    bool project = false;  ///< Permitted in ncsim.toml.
    bool merge = false;    ///< Option of ncsim merge for tiles of a part, too.
};
inline constexpr Counts kResult{true, true, true};   ///< Determines the part or the verdict.
inline constexpr Counts kText{true, false, false};   ///< Changes only texts of a result.
inline constexpr Counts kLook{false, true, false};   ///< Changes only files made of a part.
inline constexpr Counts kLimit{false, false, true};  ///< Stops a program, and changes no result.
inline constexpr Counts kWork{};                     ///< Division of the work, and files to write.
inline constexpr Counts kInTiles{.tile = true};      ///< Kept in tiles, without effect on results.
inline constexpr Counts kOfTiles{.tile = true, .merge = true};  ///< Look of files made of tiles.
inline constexpr Counts kOfPart{.merge = true};                 ///< File that is made of a part.

/// Restrictions of an option.
struct Limits {
    double least = 0.0, most = 0.0;  ///< Permitted numbers; no limits if both are equal.
    const char* needs = "";          ///< Name of an option that this option requires.
    const char* excludes = "";       ///< Name of an option that must not occur with this option.
    bool is_required = false;
};
inline constexpr Limits kRequired{.is_required = true};
/// Permits numbers from `least` to `most`; requires the option `needs` unless empty.
constexpr Limits within(double least, double most, const char* needs = "") {
    return {.least = least, .most = most, .needs = needs};
}
/// Permits the option only with, or only without, the option `name`.
constexpr Limits with(const char* name) {
    return {.needs = name};
}
constexpr Limits without(const char* name) {
    return {.excludes = name};
}

/// Option of a command.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}

    /// Sets the properties of a row of a table of options. `type`: kind of value in help; `group`:
    /// heading in help, unless the option is positional.
    void describe(const char* type, const char* group, Counts counts, const Limits& limits);
    /// Accepts a value for each name; the name may be repeated.
    Option* accept_one_value();
    /// Accepts values separated by commas, too.
    Option* accept_list();

    Counts counts() const { return counts_; }
    std::string text() const;
    /// Returns the name as help shows it.
    std::string name() const;
    /// Returns the names that begin with two dashes, without the dashes.
    std::vector<std::string> long_names() const;
    std::string type_name() const;
    /// True if the option has no name on the command line: the program.
    bool is_positional() const;
    /// True if the option takes no value.
    bool is_flag() const;
    /// False if the last value switches the option off.
    bool is_on() const;
    /// Returns the number of occurrences on the command line.
    std::size_t count() const;
    std::vector<std::string> values() const;

private:
    CLI::Option* option_;
    Counts counts_;
};

/// Command, or the program with its commands.
class App {
public:
    App(const std::string& description, const std::string& name);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    App* add_subcommand(const std::string& name, const std::string& description);
    /// Requires a command on the command line.
    void require_subcommand();
    void set_version_flag(const std::string& flag, const std::string& text);
    /// Sets the text at the end of help.
    void footer(const std::string& text);

    /// Adds an option that stores its value in `value`. Value: std::string,
    /// std::vector<std::string>, unsigned, std::uint64_t, double, and optional numbers.
    /// Requires: `value` outlives the command.
    template <class Value>
    Option* add_option(const std::string& name, Value& value, const std::string& description);
    Option* add_flag(const std::string& name, bool& value, const std::string& description);
    /// Adds a flag with an optional value "on" or "off"; alone it means "on".
    Option* add_switch(const std::string& name, std::optional<bool>& value,
                       const std::string& description);
    /// Adds an option that passes its value to `take`, which may throw. Value: std::string,
    /// std::vector<std::string>, double.
    template <class Value>
    Option* add_option_function(const std::string& name,
                                const std::function<void(const Value&)>& take,
                                const std::string& description);

    std::string name() const;
    std::string help() const;
    /// Returns the options in the order of addition; help is first.
    std::vector<const Option*> options() const;
    /// Returns the commands in the order of addition.
    std::vector<const App*> subcommands() const;
    /// Returns the command on the command line; this command if there is none.
    App* chosen();
    /// True if `name`, with dashes, is a switch of this command or of a subcommand.
    bool is_switch(const std::string& name) const;

    enum class Outcome : std::uint8_t { Parsed, Help, Version };
    /// Parses `words`, the command line without the name of the program.
    /// Throws: UsageError, and exceptions of functions of options.
    Outcome parse(std::vector<std::string> words);

private:
    explicit App(CLI::App* command);
    Option* add(CLI::Option* option);

    std::unique_ptr<CLI::App> owned_;  // the program; owns the commands
    CLI::App* app_;
    std::deque<Option> options_;
    std::vector<std::string> switches_;  // names
    std::vector<std::unique_ptr<App>> commands_;
};

/// Returns the version of CLI11.
const char* library_version();

/// Description of a command line that does not fit the options.
struct UsageError {
    std::string text;
};

}  // namespace ncsim::app::cli
