// SPDX-License-Identifier: GPL-3.0-or-later
//
// Implements commands and options with CLI11.
#include "options/cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace ncsim::app::cli {

namespace {

// Returns the unit of a kind of value: " mm" of "MM".
const char* unit_of(std::string_view type) {
    constexpr std::pair<std::string_view, const char*> kUnits[] = {
        {"MM", " mm"}, {"MM3", " mm3"}, {"GB", " GB"}, {"S", " s"}};
    const auto* const found =
        std::ranges::find(kUnits, type, [](const auto& u) { return u.first; });
    return found == std::end(kUnits) ? "" : found->second;
}

// Accepts numbers of a range. Text that is not a number, and nan, are rejected by name.
CLI::Validator number_range(double least, double most, const char* unit) {
    const auto refused = [=](std::string& text) {
        double number = 0.0;
        const bool is_number = CLI::detail::lexical_cast(text, number);
        if (is_number && number >= least && number <= most) return std::string();
        return fmt::format("expected {} to {}{}, not {}", least, most, unit, text);
    };
    return {refused, ""};
}

}  // namespace

void Option::describe(const char* type, const char* group, Counts counts, const Limits& limits) {
    if (*type != '\0') option_->type_name(type);
    if (!is_positional()) option_->group(group);
    option_->required(limits.is_required);
    if (*limits.needs != '\0') option_->needs(limits.needs);
    if (*limits.excludes != '\0') option_->excludes(limits.excludes);
    if (limits.least != limits.most)
        option_->check(number_range(limits.least, limits.most, unit_of(type)));
    counts_ = counts;
}

Option* Option::accept_one_value() {
    option_->expected(1)->take_all();
    return this;
}

Option* Option::accept_list() {
    option_->delimiter(',');
    return accept_one_value();
}

std::string Option::text() const {
    return option_->get_description();
}
std::string Option::name() const {
    return option_->get_name();
}
std::vector<std::string> Option::long_names() const {
    return option_->get_lnames();
}
std::string Option::type_name() const {
    return option_->get_type_name();
}
bool Option::is_positional() const {
    return option_->get_positional();
}
bool Option::is_flag() const {
    return option_->get_expected_max() == 0;
}
bool Option::is_on() const {
    const std::vector<std::string> results = option_->results();
    return results.empty() || CLI::detail::to_flag_value(results.back()) > 0;
}
std::size_t Option::count() const {
    return option_->count();
}
std::vector<std::string> Option::values() const {
    return option_->results();
}

namespace {

// Help with a line per option: names and type, then the description.
class HelpLines : public CLI::Formatter {
public:
    std::string make_option_opts(const CLI::Option* option) const override {
        const std::string type = option->get_type_name();
        return type.empty() ? "" : " " + type;
    }
};

}  // namespace

App::App(const std::string& description, const std::string& name)
    : owned_(std::make_unique<CLI::App>(description, name)), app_(owned_.get()) {
    app_->formatter(std::make_shared<HelpLines>());  // commands inherit it
    options_.emplace_back(app_->get_help_ptr());
}

App::App(CLI::App* command) : app_(command) {
    options_.emplace_back(app_->get_help_ptr());
}

App::~App() = default;

App* App::add_subcommand(const std::string& name, const std::string& description) {
    commands_.push_back(std::unique_ptr<App>(new App(app_->add_subcommand(name, description))));
    return commands_.back().get();
}

void App::require_subcommand() {
    app_->require_subcommand(1);
}

void App::set_version_flag(const std::string& flag, const std::string& text) {
    add(app_->set_version_flag(flag, text));
}

void App::footer(const std::string& text) {
    app_->footer(text);
}

Option* App::add(CLI::Option* option) {
    return &options_.emplace_back(option);
}

template <class Value>
Option* App::add_option(const std::string& name, Value& value, const std::string& description) {
    return add(app_->add_option(name, value, description));
}
template Option* App::add_option(const std::string&, std::string&, const std::string&);
template Option* App::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template Option* App::add_option(const std::string&, unsigned&, const std::string&);
template Option* App::add_option(const std::string&, std::uint64_t&, const std::string&);
template Option* App::add_option(const std::string&, double&, const std::string&);
template Option* App::add_option(const std::string&, std::optional<std::uint32_t>&,
                                 const std::string&);
template Option* App::add_option(const std::string&, std::optional<int>&, const std::string&);
template Option* App::add_option(const std::string&, std::optional<std::uint64_t>&,
                                 const std::string&);

Option* App::add_flag(const std::string& name, bool& value, const std::string& description) {
    return add(app_->add_flag(name, value, description));
}

Option* App::add_switch(const std::string& name, std::optional<bool>& value,
                        const std::string& description) {
    switches_.push_back(name);
    return add(app_->add_flag_function(
        name, [&value](std::int64_t count) { value = count > 0; }, description));
}

template <class Value>
Option* App::add_option_function(const std::string& name,
                                 const std::function<void(const Value&)>& take,
                                 const std::string& description) {
    return add(app_->add_option_function<Value>(name, take, description));
}
template Option* App::add_option_function(const std::string&,
                                          const std::function<void(const std::string&)>&,
                                          const std::string&);
template Option* App::add_option_function(
    const std::string&, const std::function<void(const std::vector<std::string>&)>&,
    const std::string&);
template Option* App::add_option_function(const std::string&,
                                          const std::function<void(const double&)>&,
                                          const std::string&);

std::string App::name() const {
    return app_->get_name();
}
std::string App::help() const {
    std::string text = app_->help();
    // CLI11 leaves two lines blank between groups.
    for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;)
        text.erase(at, 1);
    return text;
}

std::vector<const Option*> App::options() const {
    std::vector<const Option*> options;
    for (const Option& option : options_)
        options.push_back(&option);
    return options;
}

std::vector<const App*> App::subcommands() const {
    std::vector<const App*> commands;
    for (const auto& command : commands_)
        commands.push_back(command.get());
    return commands;
}

App* App::chosen() {
    for (const auto& command : commands_) {
        if (command->app_->parsed()) return command.get();
    }
    return this;
}

/// True if `word` is a switch of this command or of a subcommand.
bool App::is_switch(const std::string& word) const {
    return std::ranges::find(switches_, word) != switches_.end() ||
           std::ranges::any_of(commands_, [&](const auto& c) { return c->is_switch(word); });
}

App::Outcome App::parse(std::vector<std::string> words) {
    // "--switch off" becomes one word for CLI11, because a file may follow the switch alone.
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const bool has_value = words[i + 1] == "on" || words[i + 1] == "off";
        if (!has_value || !is_switch(words[i])) continue;
        words[i] += "=" + words[i + 1];
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos || !is_switch(word.substr(0, equals))) continue;
        const std::string value = word.substr(equals + 1);
        if (value != "on" && value != "off")
            throw UsageError{word.substr(0, equals) + " '" + value + "': expected on or off"};
    }
    try {
        // CLI11 expects the words in reverse order.
        app_->parse(std::vector<std::string>(words.rbegin(), words.rend()));
        return Outcome::Parsed;
    } catch (const CLI::CallForHelp&) {
        return Outcome::Help;
    } catch (const CLI::CallForVersion&) {
        return Outcome::Version;
    } catch (const CLI::ParseError& e) {
        throw UsageError{e.what()};
    }
}

const char* library_version() {
    return CLI11_VERSION;
}

}  // namespace ncsim::app::cli
