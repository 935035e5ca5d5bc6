// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subprograms, parameters, cycles of the control, modal calls.
// Source: SINUMERIK 840D sl, Programming Manual NC Programming, "Subprograms", 06/2019.
#include "sinumerik/sinumerik_runner.h"
#include "text/line_end.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ncsim::gcode::sinumerik {
namespace {

/// Cycles and functions without effect on the path.
constexpr auto kHarmless = std::to_array<std::string_view>(
    {"CYCLE832", "CYCLE_HSC", "SETMS", "WORKPIECE", "GEOAX", "FGROUP", "LFPOS", "SETAL", "SPCON",
     "SPCOF", "GETT", "PROTA", "PROTS", "SIMPLE", "WAITM", "WAITMC", "SETTIA"});

/// Begins of the names of cycles of the control that are not read.
constexpr auto kRefusedCycles = std::to_array<std::string_view>(
    {"CYCLE",      "POCKET",   "SLOT",     "LONGHOLE",    "HOLES",     "TRANSMIT",
     "TRACYL",     "TRAANG",   "TRACON",   "TRAORI",      "TRAILON",   "AXCTSWE",
     "SPLINEPATH", "CONTPRON", "SETINT",   "GROUP_BEGIN", "GROUP_END", "F_",
     "E_",         "ORIRESET", "MEAFRAME", "POLFA",       "PRESETON"});

/// True for the name of a subprogram, or of a macro in the place of an M code ("DEFINE M6 AS L6"):
/// two letters, or L or M and a number.
bool may_name_program(std::string_view upper_name) {
    const auto is_name_letter = [](char c) { return is_letter(c) || c == '_'; };
    if (upper_name.size() < 2 || !is_name_letter(upper_name[0])) return false;
    if (is_name_letter(upper_name[1])) return true;
    return (upper_name[0] == 'L' || upper_name[0] == 'M') &&
           std::ranges::all_of(upper_name.substr(1), is_digit);
}

}  // namespace

std::string program_name(std::string_view path) {
    if (const std::size_t folder = path.find_last_of("\\/:"); folder != std::string_view::npos)
        path.remove_prefix(folder + 1);
    while (!path.empty() && is_blank(path.back()))
        path.remove_suffix(1);
    std::string name(path);
    const std::string upper_name = upper_of(name);
    if (upper_name.starts_with("_N_")) name.erase(0, 3);
    if (upper_name.ends_with("_SPF") || upper_name.ends_with("_MPF")) name.resize(name.size() - 4);
    return name;
}

/// Reads "P3", "P=R1", the number of runs of a call; 1 without a word.
std::optional<double> Runner::take_runs(CodeScanner& scan) {
    scan.skip_blanks();
    if (upper(scan.peek()) != 'P') return 1.0;
    const std::size_t begin = scan.at();
    scan.move_to(begin + 1);
    std::optional<double> runs;
    if (scan.take('=')) {
        runs = expressions_.number(scan, line_);
    } else {
        runs = expressions_.literal(scan, line_);
    }
    if (runs && !(*runs >= 0.0 && *runs == std::round(*runs))) {
        fail(Message::NotWhole, line_.span(begin, scan.at() - begin), {"P"});
        return std::nullopt;
    }
    return runs;
}

/// Reads "(1, R5, , "text")"; no arguments without a bracket.
std::optional<std::vector<Runner::Argument>> Runner::arguments(CodeScanner& scan) {
    constexpr std::size_t kMost = 127;
    std::vector<Argument> found;
    const std::size_t begin = scan.at();
    if (!scan.take('(')) return found;
    if (scan.take(')')) return found;
    while (true) {
        scan.skip_blanks();
        Argument& argument = found.emplace_back();
        if (scan.peek() != ',' && scan.peek() != ')') {
            // A variable alone may be a parameter by reference.
            const std::size_t at = scan.at();
            const std::string name = upper_of(name_at(scan.remaining()));
            if (is_r_parameter(name) || variables_.find(name)) {
                argument.target = expressions_.target(scan, line_);
                if (!argument.target) return std::nullopt;
                if (!scan.is_at_end() && scan.peek() != ',' && scan.peek() != ')')
                    argument.target.reset();
                scan.move_to(at);
            }
            argument.value = expressions_.value(scan, line_);
            if (!argument.value) return std::nullopt;
        }
        if (scan.take(')')) break;
        if (!scan.take(',')) {
            fail(Message::BracketUnclosed, line_.span(begin, 1));
            return std::nullopt;
        }
        if (found.size() >= kMost) {
            fail(Message::CallDepth, line_.whole());
            return std::nullopt;
        }
    }
    return found;
}

std::optional<Arguments> Runner::cycle_arguments(CodeScanner& scan) {
    const std::optional<std::vector<Argument>> read = arguments(scan);
    if (!read) return std::nullopt;
    Arguments values;
    for (const Argument& argument : *read)
        values.push_back(argument.value);
    return values;
}

/// Executes a cycle of the control, or stores it for MCALL. `is_known`: false for other names.
bool Runner::built_in(const std::string& name, CodeScanner& scan, bool is_modal, bool& is_known) {
    is_known = true;
    const SourceSpan span = line_.whole();
    if (std::ranges::find(kHarmless, name) != kHarmless.end() && !is_modal) {
        return scan.is_at_end() || skip_call(scan);
    }
    if (name == "TRAORI" && !is_modal) {
        // "TRAORI(1)": the first transformation.
        const auto arguments = cycle_arguments(scan);
        if (!arguments) return false;
        const bool is_first = arguments->empty() || (arguments->size() == 1 && (*arguments)[0] &&
                                                     (*arguments)[0]->number == 1.0);
        if (!is_first || !is_at_end(scan)) return fail(Message::NotRead, span, {"TRAORI(n)"});
        Words words;
        words.code[static_cast<std::size_t>(CodeGroup::Transform)] = kTraori;
        return control_.block(words, span);
    }
    const bool is_hole = Control::is_hole_cycle(name);
    const bool is_pattern = Control::is_pattern(name);
    const bool mills = Control::is_milling_cycle(name);
    if (mills && is_modal) return fail(Message::NotRead, span, {"MCALL " + name});
    const bool swivels = name == "CYCLE800";
    if (is_hole || mills || ((is_pattern || swivels) && !is_modal)) {
        const auto values = cycle_arguments(scan);
        if (!values || !is_at_end(scan)) return false;
        const CycleCall call{name, *values, span};
        if (is_modal) {
            frame().modal = {};
            frame().modal.is_active = frame().modal.is_cycle = true;
            frame().modal.cycle = call;
            frame().modal.span = span;
            show_modal();
            return true;
        }
        if (swivels) return control_.swivel(call);
        if (is_hole) return control_.cycle(call);
        if (mills) return control_.mill_cycle(call);
        const auto places = control_.pattern(call);
        if (!places) return false;
        if (frame().modal.is_active && !frame().modal.is_cycle) {
            frame().places.assign(places->begin(), places->end());
            frame().places_span = span;
            return true;
        }
        for (const HolePlace& place : *places) {
            if (!control_.move_over(place, span)) return false;
            if (frame().modal.is_active && !call_modal()) return false;
        }
        return true;
    }
    is_known = false;
    return true;
}

/// Executes the call of the cycle or program `raw`. `is_first`: the call begins the block.
bool Runner::named_call(std::string_view raw, CodeScanner& scan, bool is_first) {
    const std::string name = upper_of(raw);
    const std::size_t begin = scan.at();
    const SourceSpan span = line_.span(begin, raw.size());
    // The user's program replaces a cycle of the control only in its own folder; ncsim does not.
    CodeScanner behind(line_.code, begin + raw.size());
    bool is_known = false;
    if (!built_in(name, behind, false, is_known)) return false;
    scan.move_to(behind.at());
    if (is_known) {
        scan.move_to(line_.code.size());
        return true;
    }
    if (!is_first) return fail(Message::CallWithWords, line_.whole());
    Words ignored;
    if (words_.keyword(name, span, ignored) == WordReader::Found::Error) return false;
    scan.move_to(begin + raw.size());
    scan.skip_blanks();
    const std::optional<double> before = take_runs(scan);
    if (!before) return false;
    std::optional<std::vector<Argument>> passed = arguments(scan);
    if (!passed) return false;
    const std::optional<double> after = take_runs(scan);
    if (!after || !is_at_end(scan)) return false;
    return call(std::string(raw), std::move(*passed), *before * *after, line_.whole());
}

/// MCALL CYCLE81(…), MCALL L10, MCALL.
bool Runner::modal(CodeScanner& scan) {
    if (scan.is_at_end()) {
        frame().modal = {};
        show_modal();
        return true;
    }
    const std::size_t begin = scan.at();
    const std::string_view raw = name_at(scan.remaining());
    if (raw.empty()) return refuse_text(begin);
    scan.move_to(begin + raw.size());
    bool is_known = false;
    if (!built_in(upper_of(raw), scan, true, is_known)) return false;
    if (is_known) return true;
    std::optional<std::vector<Argument>> passed = arguments(scan);
    if (!passed || !is_at_end(scan)) return false;
    frame().modal = {};
    if (!find_program(std::string(raw))) {
        show_modal();
        // Reports the program.
        return call(std::string(raw), {}, 1.0, line_.whole());
    }
    frame().modal.is_active = true;
    frame().modal.program = std::string(raw);
    frame().modal.arguments = std::move(*passed);
    frame().modal.span = line_.whole();
    show_modal();
    return true;
}

/// Shows the modal call of the program that runs.
void Runner::show_modal() {
    constexpr std::size_t kName = 5;  // "CYCLE"
    const Modal& modal = frame().modal;
    int number = 0;
    if (modal.is_active) {
        number = modal.is_cycle ? -std::stoi(modal.cycle.name.substr(kName)) : kModalProgram;
    }
    control_.show_defined_cycle(number, modal.span);
}

/// Executes the modal call at the position of the tool.
bool Runner::call_modal() {
    const Modal& modal = frame().modal;
    if (modal.is_cycle) {
        CycleCall cycle = modal.cycle;
        cycle.span = line_.whole();
        return control_.cycle(cycle);
    }
    const SourceSpan definition = modal.span;
    const bool done = call(modal.program, modal.arguments, 1.0, line_.whole());
    // The subprogram runs because of the modal call.
    control_.show_defined_cycle(kModalProgram, definition);
    return done;
}

std::optional<std::size_t> Runner::program_of(std::size_t file, const std::string& name) {
    for (std::size_t i = 0; i < programs_.size(); ++i) {
        const Program& candidate = programs_[i];
        if (candidate.file == file && candidate.section.name == name) return i;
    }
    return std::nullopt;
}

/// Returns the program `name`: of the file, of another file.
std::optional<std::size_t> Runner::find_program(const std::string& name) {
    const std::string upper_name = upper_of(name);
    if (const auto own = program_of(program().file, upper_name)) return own;
    if (!options_.read_file) return std::nullopt;
    std::string lower_name = name;
    for (char& c : lower_name)
        c = lower(c);
    std::optional<SourceFile> source;
    for (const char* ending : {".spf", ".SPF", ".mpf", ".MPF", ""}) {
        for (const std::string& spelled : {name, upper_name, lower_name}) {
            if (!source) source = options_.read_file(spelled + ending);
        }
    }
    if (!source) return std::nullopt;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (files_[i].source->name != source->name) continue;
        for (std::size_t p = 0; p < programs_.size(); ++p) {
            if (programs_[p].file == i) return p;
        }
    }
    File file;
    file.owned = keep_file(std::move(*source), files_.size());
    if (!file.owned) return std::nullopt;
    file.source = file.owned.get();
    file.sections = sections_of(*file.source);
    control_.add_tool_names(tool_names(*file.source));
    const std::size_t first = programs_.size();
    for (const Section& section : file.sections) {
        Program& added = programs_.emplace_back();
        added.file = files_.size();
        added.section = section;
    }
    files_.push_back(std::move(file));
    return program_of(files_.size() - 1, upper_name).value_or(first);
}

/// Calls the program `called`, `runs` times.
bool Runner::call(const std::string& called, std::vector<Argument> passed, double runs,
                  SourceSpan span) {
    const std::string name = program_name(called);
    if (name.empty()) return refuse_text(0);
    const std::optional<std::size_t> found = find_program(name);
    if (!found) {
        const std::string upper_name = upper_of(name);
        const bool is_of_control = std::ranges::any_of(
            kRefusedCycles, [&](std::string_view head) { return upper_name.starts_with(head); });
        if (is_of_control) return fail(Message::NotRead, span, {upper_name});
        // Programs of the machine builder and of the shop are often not at hand.
        if (!may_name_program(upper_name)) return refuse_text(0);
        report_missing_program(name, span);
        return true;
    }
    if (frames_.size() > options_.limits.call_depth) return fail(Message::CallDepth, span);
    if (runs < 1.0) return true;
    count_repeats();
    Frame entered;
    entered.program = *found;
    entered.name = name;
    entered.back = reader_->place();
    entered.arguments = std::move(passed);
    entered.runs_left = static_cast<std::uint64_t>(std::min(runs, 1e9)) - 1;
    frames_.push_back(std::move(entered));
    show_modal();
    variables_.begin_program();
    const Program& target = program();
    const SourceFile& file = *files_[target.file].source;
    reader_.emplace(file, target.section.begin, target.section.end);
    control_.set_file(static_cast<std::uint32_t>(target.file));
    log_.set_file(target.file == 0 ? std::string() : file.name);
    return true;
}

/// Returns from a subprogram, or begins its next run.
bool Runner::finish_program() {
    Frame& leaving = frame();
    std::vector<std::pair<std::string, Value>> copies;
    for (const auto& [name, target] : leaving.copies) {
        const std::shared_ptr<Variable> variable = variables_.find(name);
        if (variable) copies.emplace_back(name, variable->elements.front());
    }
    const auto targets = leaving.copies;
    if (leaving.runs_left > 0) {
        --leaving.runs_left;
        if (!count_block(true, line_.whole())) return true;
        variables_.end_program();
        variables_.begin_program();
        leaving.loops.clear();
        leaving.repeats.clear();
        leaving.copies.clear();
        leaving.modal = {};
        reader_->seek(program().section.begin);
        return true;
    }
    const std::optional<SavedModes> saved = leaving.saved;
    const Place back = leaving.back;
    frames_.pop_back();
    show_modal();
    variables_.end_program();
    const Program& target = program();
    const SourceFile& file = *files_[target.file].source;
    reader_.emplace(file, back, target.section.end);
    control_.set_file(static_cast<std::uint32_t>(target.file));
    log_.set_file(target.file == 0 ? std::string() : file.name);
    for (std::size_t i = 0; i < copies.size(); ++i) {
        if (!variables_.set(targets[i].second, copies[i].second, line_.whole(), log_)) return false;
    }
    return !saved || control_.restore(*saved, line_.whole());
}

/// PROC NAME(REAL A, VAR INT B=1) SAVE DISPLOF
bool Runner::proc(CodeScanner& scan) {
    scan.skip_blanks();
    const std::string_view raw = name_at(scan.remaining());
    scan.move_to(scan.at() + raw.size());
    const std::vector<Argument> passed = frame().arguments;
    std::size_t index = 0;
    if (scan.take('(') && !scan.take(')')) {
        do {
            const bool by_reference = scan.take_word("VAR");
            scan.skip_blanks();
            const std::string type_name = upper_of(name_at(scan.remaining()));
            constexpr std::array<std::pair<std::string_view, Type>, 5> kTypes{
                {{"REAL", Type::Real},
                 {"INT", Type::Int},
                 {"BOOL", Type::Bool},
                 {"CHAR", Type::Char},
                 {"STRING", Type::String}}};
            const auto* const type =
                std::ranges::find(kTypes, type_name, &std::pair<std::string_view, Type>::first);
            if (type == kTypes.end())
                return fail(Message::NotRead, line_.whole(),
                            {"a parameter of the type " + type_name});
            scan.move_to(scan.at() + type_name.size());
            if (type->second == Type::String && scan.peek() == '[') {
                if (!expressions_.indices(scan, line_)) return false;
            }
            scan.skip_blanks();
            const std::string name = upper_of(name_at(scan.remaining()));
            if (name.empty()) return refuse_text(scan.at());
            scan.move_to(scan.at() + name.size());
            if (scan.peek() == '[')
                return fail(Message::NotRead, line_.whole(), {"an array as a parameter"});
            std::optional<Value> value;
            if (scan.take('=')) {
                value = expressions_.value(scan, line_);
                if (!value) return false;
            }
            const Argument* argument = index < passed.size() ? &passed[index] : nullptr;
            ++index;
            if (argument && argument->value) value = argument->value;
            if (!value && !is_in_subprogram())
                log_.add(Message::ParameterWithoutValue, line_.whole(), {name});
            auto variable = std::make_shared<Variable>();
            variable->type = type->second;
            if (type->second == Type::String) variable->elements = {Value::of(std::string())};
            if (value && !variables_.set({variable, 0}, *value, line_.whole(), log_)) return false;
            variables_.define(name, variable);
            if (by_reference && argument && argument->target)
                frame().copies.emplace_back(name, *argument->target);
        } while (scan.take(','));
        if (!scan.take(')')) return fail(Message::BracketUnclosed, line_.whole());
    }
    if (index < passed.size()) return fail(Message::TooManyArguments, line_.whole());
    while (!scan.is_at_end()) {
        const std::string_view word = name_at(scan.remaining());
        if (word.empty()) return refuse_text(scan.at());
        const std::string name = upper_of(word);
        if (name == "SAVE" && is_in_subprogram() && !frame().saved) frame().saved = control_.save();
        const bool is_known = name == "SAVE" || name == "DISPLOF" || name == "DISPLON" ||
                              name == "SBLOF" || name == "SBLON" || name == "ACTBLOCNO" ||
                              name == "IPTRLOCK" || name == "PREPRO";
        if (!is_known) return fail(Message::NotRead, line_.whole(), {"PROC with " + name});
        scan.move_to(scan.at() + word.size());
    }
    return true;
}

}  // namespace ncsim::gcode::sinumerik
