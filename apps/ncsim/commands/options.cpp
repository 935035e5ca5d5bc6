// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses the command line.
#include "commands/options.h"

#include "ncsim/report/plain_text.h"
#include "ncsim/report/version.h"

#include "commands/help_topics.h"
#include "commands/libraries.h"
#include "options/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ncsim::app {

namespace {

std::string footer(const char* example) {
    return fmt::format("{}{}{}{}Example: {}", kToolNotation, kStockNotation, kFileNotes, kExitCodes,
                       example);
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
            fmt::format("ncsim: there is no help topic '{}'{}\nTry: ncsim help\n",
                        report::one_line(name),
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

}  // namespace

Command parse_options(const std::vector<std::string>& arguments) {
    cli::App app{"ncsim simulates and verifies NC milling programs.", "ncsim"};
    app.set_version_flag("--version", fmt::format("ncsim {}", report::kVersion));
    bool verbose = false;
    app.add_flag("--verbose", verbose, "With --version: libraries and licences");
    app.require_subcommand();
    const char* const run_example =
        "ncsim run samples/simple.nc --png simple.png --gltf simple.glb";
    app.footer(fmt::format("\nTopics:\n{}{}Example: {}", topic_list(), kExitCodes, run_example));

    const std::vector<std::string> words = as_options(arguments);
    // Adding the options of all commands would take longer than a small program.
    constexpr std::string_view kCommands[] = {"run",   "parse", "tools",   "check",
                                              "merge", "diff",  "machine", "measure",
                                              "rules", "init",  "sheet",   "explain"};
    const bool is_named =
        !words.empty() && std::ranges::find(kCommands, words[0]) != std::ranges::end(kCommands);
    const auto add = [&](std::string_view name, auto add_command, auto& options,
                         const char* example) -> cli::App* {
        if (is_named && words[0] != name) return nullptr;
        cli::App* command = add_command(app, options);
        if (example) command->footer(footer(example));
        return command;
    };
    Options run_options;
    ParseOptions parse_options;
    ToolsOptions tools_options;
    CheckOptions check_options;
    MergeOptions merge_options;
    DiffOptions diff_options;
    MachineOptions machine_options;
    MeasureOptions measure_options;
    RulesOptions rules_options;
    InitOptions init_options;
    SheetOptions sheet_options;
    ExplainOptions explain_options;
    cli::App* run = add("run", add_run, run_options, run_example);
    add("parse", add_parse, parse_options, "ncsim parse samples/simple.nc --canonical");
    cli::App* tools = add("tools", add_tools, tools_options,
                          "ncsim tools samples/complex.nc --save-job complex.toml");
    cli::App* check =
        add("check", add_check, check_options, "ncsim check samples/simple.nc samples/complex.nc");
    cli::App* merge =
        add("merge", add_merge, merge_options, "ncsim merge results/ --sarif all.sarif");
    cli::App* diff = add("diff", add_diff, diff_options, "ncsim diff old.nc new.nc --tol 0.01");
    cli::App* machine = add("machine", add_machine, machine_options,
                            "ncsim machine samples/machines/trt.toml --pose A-30,C45");
    cli::App* measure = add("measure", add_measure, measure_options,
                            "ncsim measure samples/simple.nc --json simple.json");
    cli::App* init = add("init", add_init, init_options, "ncsim init top.nc back.nc");
    cli::App* sheet = add("sheet", add_sheet, sheet_options,
                          "ncsim sheet samples/two-sides/job.toml --html sheet.html");
    cli::App* explain =
        add("explain", add_explain, explain_options, "ncsim explain samples/simple.nc:14");
    cli::App* rules = add("rules", add_rules, rules_options, nullptr);

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
            return EarlyExit{kClean,
                             all ? version_text() : fmt::format("ncsim {}\n", report::kVersion)};
        }
        if (verbose) throw Refusal{"--verbose stands with --version, or behind a command"};
        refuse_empty_names(*chosen);
        if (chosen == run) {
            complete(run_options);
            run_options.words = words_of_part(*run);
            return run_options;
        }
        if (chosen == tools) {
            complete(tools_options);
            return tools_options;
        }
        if (chosen == check) {
            complete(check_options);
            check_options.words = words;
            check_options.given = specified_options(*check);
            check_options.specified = settings_of(*check);
            check_options.tile_words = words_of_check(*check);
            return check_options;
        }
        if (chosen == merge) return merge_options;
        if (chosen == diff) {
            complete(diff_options);
            diff_options.words = words_of(*diff, [](const std::string&) { return true; });
            diff_options.words.erase(std::ranges::find(diff_options.words, "--"),
                                     diff_options.words.end());
            return diff_options;
        }
        if (chosen == machine) return machine_options;
        if (chosen == measure) {
            complete(measure_options);
            return measure_options;
        }
        if (chosen == rules) return rules_options;
        if (chosen == sheet) {
            complete(sheet_options);
            return sheet_options;
        }
        if (chosen == explain) {
            complete(explain_options);
            return explain_options;
        }
        if (chosen == init) {
            complete(init_options);
            return init_options;
        }
        complete(parse_options);
        return parse_options;
    } catch (const cli::UsageError& e) {
        const std::string of = app.chosen() == &app ? "" : app.chosen()->name() + " ";
        std::string what = mistyped(app, words);
        if (what.empty()) what = e.text;
        return EarlyExit{kEnvironment, fmt::format("ncsim: {}\nTry: ncsim {}--help\n",
                                                   report::one_line(what), of)};
    } catch (const Refusal& e) {
        return EarlyExit{kEnvironment, fmt::format("ncsim: {}\n", report::one_line(e.text))};
    }
}

}  // namespace ncsim::app
