// SPDX-License-Identifier: GPL-3.0-or-later
//
// Commands and their options, as far as the program needs them. The names are those of CLI11, which
// cli.cpp alone includes: its headers took nearly half of the time of a first build.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
class Option;
}  // namespace CLI

namespace ncsim::app::cli {

/// Option of a command. Functions that change it return it.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option* type_name(const std::string& name);
    Option* required();
    /// Values may be separated by `delimiter`, too.
    Option* delimiter(char delimiter);
    /// Takes one value where it is named, and may be named several times.
    Option* one_value_at_a_time();
    /// Does not take further values that follow the first.
    Option* no_extra_values();
    Option* needs(const Option* other);
    Option* needs(const std::string& other);
    Option* excludes(const std::string& other);
    /// Accepts `least` to `most`, both included. Number: int, unsigned, std::uint64_t.
    template <class Number>
    Option* range(Number least, Number most);
    /// Accepts `least` to `most`, both included; refuses text that is not a number, and nan, by
    /// name.
    Option* number_range(double least, double most);

    /// Name as help shows it.
    std::string name() const;
    /// Names that begin with two dashes, without these.
    std::vector<std::string> long_names() const;
    std::string type_name() const;
    /// True if it has no name on the command line: the program.
    bool is_positional() const;
    /// True if it takes no value.
    bool is_flag() const;
    /// How often it was on the command line.
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
    /// At least one command has to be on the command line.
    void require_subcommand();
    void set_version_flag(const std::string& flag, const std::string& text);
    /// Text at the end of help.
    void footer(const std::string& text);
    /// Calls `done` when all options of the command were read.
    void after_parsing(std::function<void()> done);

    /// `value` must outlive the command. Value: std::string, std::vector<std::string>, int,
    /// unsigned, std::uint64_t, double, std::optional<std::uint32_t>.
    template <class Value>
    Option* add_option(const std::string& name, Value& value, const std::string& description);
    Option* add_flag(const std::string& name, bool& value, const std::string& description);
    /// Flag that may be followed by "on" or "off"; alone it means "on".
    Option* add_switch(const std::string& name, std::optional<bool>& value,
                       const std::string& description);
    /// Hands the value to `take`, which may throw. Value: std::string, std::vector<std::string>,
    /// double.
    template <class Value>
    Option* add_option_function(const std::string& name,
                                const std::function<void(const Value&)>& take,
                                const std::string& description);

    std::string name() const;
    std::string help() const;
    /// Options in the order in which they were added, that of help first.
    std::vector<const Option*> options() const;
    /// Commands in the order in which they were added.
    std::vector<const App*> subcommands() const;
    /// Command on the command line; this one if there is none.
    App* chosen();
    /// How often the option `name` was on the command line.
    std::size_t count(const std::string& name) const;

    enum class Outcome : std::uint8_t { Parsed, Help, Version };
    /// Reads `words`, the command line without the name of the program.
    /// Throws: UsageError, and what functions of options throw.
    Outcome parse(std::vector<std::string> words);

private:
    explicit App(CLI::App* command);
    Option* add(CLI::Option* option);
    bool is_switch(const std::string& word) const;

    std::unique_ptr<CLI::App> owned_;  // of the program; commands belong to it
    CLI::App* app_;
    std::deque<Option> options_;
    std::vector<std::string> switches_;  // names
    std::vector<std::unique_ptr<App>> commands_;
};

/// Command line that does not fit the options: what is wrong with it.
struct UsageError {
    std::string text;
};

}  // namespace ncsim::app::cli
