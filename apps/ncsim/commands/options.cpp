// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses the command line.
#include "commands/options.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"

#include "commands/help_topics.h"
#include "commands/libraries.h"
#include "options/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace ncsim::app {

namespace {

std::string footer(const char* example) {
    return fmt::format("{}{}{}{}Example: {}", help_section("tool notation"),
                       help_section("stock notation"), help_section("files notation"),
                       help_section("exit codes"), example);
}

// Translates common forms such as `ncsim version` into options.
std::vector<std::string> as_options(std::vector<std::string> words) {
    if (words.empty()) return words;
    if (words[0] == "version" || words[0] == "-V") words[0] = "--version";
    if (words[0] == "help" && words.size() == 1) words[0] = "--help";
    return words;
}

// Returns the first unknown word and the nearest known word; empty if all words are known.
std::string mistyped(const cli::App& app, const std::vector<std::string>& words) {
    if (words.empty()) return {};
    std::vector<std::string> commands;
    const cli::App* command = nullptr;
    for (const cli::App* c : app.subcommands()) {
        commands.push_back(c->name());
        if (words[0] == c->name()) command = c;
    }
    const auto meant = [](const std::string& nearest) {
        return nearest.empty() ? std::string() : fmt::format("; did you mean {}?", nearest);
    };
    if (!command) {
        if (words[0].starts_with("-")) return {};
        std::string list;
        for (const std::string& name : commands)
            list += (list.empty() ? "" : ", ") + name;
        return fmt::format("there is no command '{}'{} ({})", words[0],
                           meant(nearest(words[0], commands)), list);
    }
    std::vector<std::string> options;
    for (const cli::Option* option : command->options()) {
        for (const std::string& name : option->long_names())
            options.push_back("--" + name);
    }
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (!name.starts_with("--") || name.size() == 2) continue;
        if (std::ranges::find(options, name) == options.end())
            return fmt::format("there is no option {}{}", name, meant(nearest(name, options)));
    }
    return {};
}

// Answers `ncsim help NAME`: a topic, or the help of a command.
EarlyExit help_of(const std::string& name, const cli::App& app) {
    if (std::string text = topic_text(name); !text.empty()) return {kClean, std::move(text)};
    std::vector<std::string> known = topic_names();
    for (const cli::App* command : app.subcommands()) {
        if (command->name() == name) return {kClean, command->help()};
        known.push_back(command->name());
    }
    if (name.starts_with("-")) return {kClean, app.help()};
    const std::string meant = nearest(name, known);
    return {kEnvironment,
            fmt::format("ncsim: there is no help topic '{}'{}\nTry: ncsim help\n", one_line(name),
                        meant.empty() ? "" : fmt::format("; did you mean {}?", meant))};
}

// Throws Refusal for an empty file name, which results from an unset variable in a script.
void refuse_empty_names(const cli::App& command) {
    for (const cli::Option* option : command.options()) {
        const std::string type = option->type_name();
        if (!type.starts_with("FILE") && !type.starts_with("DIR")) continue;
        for (const std::string& value : option->values()) {
            if (value.empty()) throw Refusal{fmt::format("{}: the name is empty", option->name())};
        }
    }
}

// Name, summary and example of a command.
struct About {
    std::string_view name;
    const char* summary;
    const char* example;
};

constexpr const char* kRunExample =
    "ncsim run samples/simple.nc --png simple.png --gltf simple.glb";

// All commands, in the order of help, which is that of Command.
constexpr About kCommands[] = {
    {"run", "Simulate a program; write pictures, meshes and reports", kRunExample},
    {"parse", "Show how a program is read: blocks or motions",
     "ncsim parse samples/simple.nc --canonical"},
    {"tools", "List the tools of a program: shape, source, use, conflicts",
     "ncsim tools samples/complex.nc --save-job complex.toml"},
    {"check", "Verify that programs are safe; exit code 1 if not",
     "ncsim check samples/simple.nc samples/complex.nc"},
    {"merge", "Combine results of --shard or --tile into those of one run",
     "ncsim merge results/ --sarif all.sarif"},
    {"diff", "Compare the parts of two programs: exit code 1 if they differ",
     "ncsim diff old.nc new.nc --tol 0.01"},
    {"machine", "Show how a machine is built and turns",
     "ncsim machine samples/machines/trt.toml --pose A-30,C45"},
    {"measure", "List bores, floors and distances of walls",
     "ncsim measure samples/simple.nc --json simple.json"},
    {"init", "Write a first job file for programs, with all assumptions",
     "ncsim init top.nc back.nc"},
    {"sheet", "Write the set-up sheet of a job: tools, stock, zero, fixtures",
     "ncsim sheet samples/two-sides/job.toml --html sheet.html"},
    {"explain", "Explain a block: modes and their lines, moves, volume",
     "ncsim explain samples/simple.nc:14"},
    {"rules", "Explain the rules of ncsim check", nullptr}};

// Options of all commands.
template <class... Of>
std::tuple<Of...> options_of(const std::variant<Of...>&);
using Commands = decltype(options_of(Command()));
static_assert(std::tuple_size_v<Commands> == std::size(kCommands) + 1);

// Calls visit(about, options) for each command.
template <class Visit>
void each(Commands& commands, const Visit& visit) {
    const auto visit_all = [&]<std::size_t... I>(std::index_sequence<I...>) {
        (visit(kCommands[I], std::get<I>(commands)), ...);
    };
    visit_all(std::make_index_sequence<std::size(kCommands)>());
}

// Adds the command `name`; all commands if none has this name, because adding the options of all
// commands takes longer than a small program.
void add_commands(cli::App& app, Commands& commands, std::string_view name) {
    bool is_named = false;
    each(commands, [&](const About& about, const auto&) { is_named |= about.name == name; });
    each(commands, [&](const About& about, auto& options) {
        if (is_named && about.name != name) return;
        cli::App* const command = app.add_subcommand(std::string(about.name), about.summary);
        add_options(*command, options);
        if (about.example) command->footer(footer(about.example));
    });
}

// Checks and completes the options of the command on the command line, `words`.
void finish(Options& o, const cli::App& command, const std::vector<std::string>&) {
    complete(o);
    o.words = words_of_tile(command);
}
void finish(CheckOptions& o, const cli::App& command, const std::vector<std::string>& words) {
    complete(o);
    o.words = words;
    o.given = specified_options(command);
    o.specified = settings_of(command);
    o.tile_words = words_of_tile(command);
}
void finish(DiffOptions& o, const cli::App& command, const std::vector<std::string>&) {
    complete(o);
    o.words = words_of(command, [](const cli::Option&) { return true; });
    o.words.erase(std::ranges::find(o.words, "--"), o.words.end());
}
template <class Of>
void finish(Of& o, const cli::App&, const std::vector<std::string>&) {
    if constexpr (requires { complete(o); }) complete(o);
}

}  // namespace

std::set<std::string> option_names(const std::string& command) {
    cli::App app("", "");
    Commands commands;
    add_commands(app, commands, command);
    std::set<std::string> names;
    for (const cli::Option* option : app.subcommands().front()->options()) {
        for (const std::string& name : option->long_names())
            names.insert(name);
    }
    return names;
}

Command parse_options(const std::vector<std::string>& arguments) {
    cli::App app{"ncsim simulates and verifies NC milling programs.", "ncsim"};
    app.set_version_flag("--version", fmt::format("ncsim {}", kVersion));
    bool verbose = false;
    app.add_flag("--verbose", verbose, "With --version: libraries and licences");
    app.require_subcommand();
    app.footer(fmt::format("\nTopics:\n{}{}Example: {}", topic_list(), help_section("exit codes"),
                           kRunExample));

    const std::vector<std::string> words = as_options(arguments);
    Commands commands;
    add_commands(app, commands, words.empty() ? "" : words[0]);
    if (!words.empty() && words[0] == "help") return help_of(words[1], app);
    try {
        const cli::App::Outcome outcome = app.parse(words);
        const cli::App* const chosen = app.chosen();
        if (outcome == cli::App::Outcome::Help) {
            // `ncsim rnu --help` asks for a command that does not exist.
            if (chosen == &app && !mistyped(app, words).empty()) throw cli::UsageError{};
            return EarlyExit{kClean, chosen->help()};
        }
        if (outcome == cli::App::Outcome::Version) {
            const bool all = std::ranges::find(words, "--verbose") != words.end();
            return EarlyExit{kClean, all ? version_text() : fmt::format("ncsim {}\n", kVersion)};
        }
        if (verbose) throw Refusal{"--verbose stands with --version, or behind a command"};
        refuse_empty_names(*chosen);
        Command result;
        each(commands, [&](const About& about, auto& options) {
            if (about.name != chosen->name()) return;
            finish(options, *chosen, words);
            result = std::move(options);
        });
        return result;
    } catch (const cli::UsageError& e) {
        const std::string of = app.chosen() == &app ? "" : app.chosen()->name() + " ";
        std::string what = mistyped(app, words);
        if (what.empty()) what = e.text;
        return EarlyExit{kEnvironment,
                         fmt::format("ncsim: {}\nTry: ncsim {}--help\n", one_line(what), of)};
    } catch (const Refusal& e) {
        return EarlyExit{kEnvironment, fmt::format("ncsim: {}\n", one_line(e.text))};
    }
}

}  // namespace ncsim::app
