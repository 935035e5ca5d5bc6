// SPDX-License-Identifier: GPL-3.0-or-later
//
// Commands and their options, as far as the program needs them. The names are those of CLI11. Only
// cli.cpp includes CLI11, whose headers took nearly half of the time of a first build.
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

/// Option of a command. Setters return the option.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option* type_name(const std::string& name);
    Option* required();
    /// Also accepts values separated by `delimiter`.
    Option* delimiter(char delimiter);
    /// Accepts one value for each name; the name may be repeated.
    Option* accept_one_value();
    /// Rejects further values after the first.
    Option* no_extra_values();
    Option* needs(const Option* other);
    Option* needs(const std::string& other);
    Option* excludes(const std::string& other);
    /// Accepts `least` to `most`, both included. Number: int, unsigned, std::uint64_t.
    template <class Number>
    Option* range(Number least, Number most);
    /// Accepts `least` to `most`, both included. Rejects text that is not a number, and nan, by
    /// name.
    Option* number_range(double least, double most);

    /// Returns the name as help shows it.
    std::string name() const;
    /// Returns the names that begin with two dashes, without the dashes.
    std::vector<std::string> long_names() const;
    std::string type_name() const;
    /// True if the option has no name on the command line: the program.
    bool is_positional() const;
    /// True if the option takes no value.
    bool is_flag() const;
    /// False if the last value of the option switches it off.
    bool is_on() const;
    /// Returns the number of occurrences on the command line.
    std::size_t count() const;
    std::vector<std::string> values() const;

private:
    friend class App;
    CLI::Option* option_;
};

/// Command, or the program with its commands.
class App {
public:
    App(const std::string& description, const std::string& name);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    App* add_subcommand(const std::string& name, const std::string& description);
    /// Requires at least one command on the command line.
    void require_subcommand();
    void set_version_flag(const std::string& flag, const std::string& text);
    /// Sets the text at the end of help.
    void footer(const std::string& text);
    /// Calls `done` after all options of the command were read.
    void after_parsing(std::function<void()> done);

    /// Lists the options that are added from here on under the heading `name` in help.
    void begin_group(const std::string& name);

    /// Adds an option that stores its value in `value`. Value: std::string,
    /// std::vector<std::string>, int, unsigned, std::uint64_t, double,
    /// std::optional<std::uint32_t>.
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
    /// Returns the options in the order in which they were added; help is first.
    std::vector<const Option*> options() const;
    /// Returns the commands in the order in which they were added.
    std::vector<const App*> subcommands() const;
    /// Returns the command on the command line; this command if there is none.
    App* chosen();
    /// True if `name`, with its dashes, is a switch of this command or of a subcommand.
    bool is_switch(const std::string& name) const;
    /// Returns the number of occurrences of the option `name` on the command line.
    std::size_t count(const std::string& name) const;

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
