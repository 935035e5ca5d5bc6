// SPDX-License-Identifier: GPL-3.0-or-later
//
// Execution of blocks: statements, assignments, words.
#include "sinumerik/sinumerik_runner.h"

#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ncsim::gcode::sinumerik {
namespace {

/// True if a block of `file` has M6.
bool has_tool_change(const SourceFile& file) {
    Reader reader(file);
    Line line;
    while (reader.next(line)) {
        const std::string_view code = line.code;
        for (std::size_t at = 0; at + 1 < code.size(); ++at) {
            if (upper(code[at]) != 'M' || (at > 0 && is_letter(code[at - 1]))) continue;
            std::size_t end = at + 1;
            while (end < code.size() &&
                   (code[end] == '0' || code[end] == '=' || is_blank(code[end])))
                ++end;
            const bool is_six = end < code.size() && code[end] == '6' &&
                                (end + 1 == code.size() || !is_digit(code[end + 1]));
            if (is_six) return true;
        }
    }
    return false;
}

/// True if `text` begins with a letter and a number, "X10", "G1", "Z-3.5", that begin no assignment
/// and no call.
bool begins_plain_word(std::string_view text) {
    if (text.size() < 2 || !is_letter(text[0])) return false;
    std::size_t at = 1;
    while (at < text.size() && is_digit(text[at]))
        ++at;
    if (at == 1) return text[1] == '-' || text[1] == '+' || text[1] == '.';
    if (at < text.size() && (is_letter(text[at]) || text[at] == '_')) return false;
    while (at < text.size() && is_blank(text[at]))
        ++at;
    return at == text.size() || (text[at] != '=' && text[at] != '[' && text[at] != '(');
}

constexpr auto kFrames = std::to_array<std::string_view>(
    {"TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR"});

}  // namespace

std::vector<std::string> tool_names(const SourceFile& program) {
    constexpr std::size_t kMostNames = 1000;
    std::vector<std::string> names;
    if (program.text.find('"') == std::string::npos) return names;
    Reader reader(program);
    Line line;
    while (names.size() < kMostNames && reader.next(line)) {
        CodeScanner scan(line.code);
        for (std::size_t at = 0; at < line.code.size(); ++at) {
            const bool begins =
                upper(line.code[at]) == 'T' && (at == 0 || !is_letter(line.code[at - 1]));
            if (!begins) continue;
            scan.move_to(at + 1);
            if (scan.peek() == '1') scan.move_to(at + 2);
            if (!scan.take('=')) continue;
            const std::optional<std::string_view> name = scan.quoted();
            if (name && std::ranges::find(names, *name) == names.end()) names.emplace_back(*name);
        }
    }
    return names;
}

Runner::Runner(const SourceFile& program, const InterpreterOptions& options,
               const std::array<RotaryWay, 3>& ways, const Rules& rules, ArcCentres& centres,
               const MotionSink& sink, DiagnosticLog& log, Interpretation& result)
    : ProgramRunner(program, options, rules, centres, sink, log, result),
      ways_(ways),
      rules_(rules),
      centres_(centres),
      control_(options, ways, machine_, log, !has_tool_change(program)),
      expressions_(variables_, control_, log),
      words_(expressions_, log) {
    files_.push_back({&program, nullptr, sections_of(program)});
    for (const Section& section : files_[0].sections) {
        Program& added = programs_.emplace_back();
        added.section = section;
    }
    control_.add_tool_names(tool_names(program));
    control_.set_contour_reader(
        [this](const std::string& name, SourceSpan span) { return record_contour(name, span); });
    // The first main program of an archive runs.
    const auto main = std::ranges::find_if(
        programs_, [](const Program& candidate) { return candidate.section.is_main; });
    Frame& first = frames_.emplace_back();
    if (main != programs_.end()) first.program = static_cast<std::size_t>(main - programs_.begin());
    const Section& section = programs_[first.program].section;
    reader_.emplace(program, section.begin, section.end);
    for (const auto& [name, value] : options.variables) {
        if (is_r_parameter(name))
            variables_.set_r(static_cast<std::uint32_t>(std::stoul(name.substr(1))), value);
    }
}

bool Runner::refuse_text(std::size_t at) {
    constexpr std::size_t kMost = 40;
    const std::string_view text = line_.code.substr(std::min(at, line_.code.size()));
    return fail(Message::NotSinumerik, line_.span(at, text.size()),
                {(text.empty() ? line_.code : text).substr(0, kMost)});
}

bool Runner::is_at_end(CodeScanner& scan) {
    return scan.is_at_end() || refuse_text(scan.at());
}

void Runner::seek(Place place) {
    if (place.offset <= line_.offset) count_repeats();
    reader_->seek(place);
}

/// Executes the next block.
/// Returns: false at the end of the program.
bool Runner::step() {
    // The modal subprogram runs at each position of a pattern.
    if (!frame().places.empty()) {
        const HolePlace place = frame().places.front();
        frame().places.pop_front();
        if (!control_.move_over(place, frame().places_span) || !call_modal()) return stop();
        return true;
    }
    if (next_pass()) return true;
    if (!reader_->next(line_)) {
        if (!is_in_subprogram()) return false;
        return finish_program() || stop();
    }
    ++result_.lines;
    if (!count_block(is_in_subprogram(), line_.whole())) return false;
    if (line_.is_head || line_.code.empty()) return true;
    if (line_.block_delete) note_deletable(program().file, line_.whole());
    if (!act()) return stop();
    return !ended_;
}

/// Executes the block.
/// Returns: false after an error at which the program stops.
bool Runner::act() {
    CodeScanner scan(line_.code);
    scan.skip_blanks();
    // "G1", "X10": most blocks begin with a word.
    if (!is_letter(scan.peek(1)) && scan.peek(1) != '_') return items(scan);
    const std::string_view raw = name_at(scan.remaining());
    if (raw.empty()) return items(scan);
    bool is_done = true;
    return statement(upper_of(raw), scan, is_done) && (is_done || items(scan));
}

/// Executes a block that begins with the keyword `name`. `is_done`: false for another block.
bool Runner::statement(std::string_view name, CodeScanner& scan, bool& is_done) {
    const std::size_t begin = scan.at();
    scan.move_to(begin + name.size());
    bool is_flow = true;
    if (!flow_statement(name, scan, is_flow)) return false;
    if (is_flow) return true;
    const SourceSpan span = line_.span(begin, name.size());
    if (name == "DEF") return define(scan);
    if (name == "PROC") return proc(scan);
    if (name == "EXTERN") return true;  // A declaration; the file of the program decides.
    if (name == "MSG" || name == "SETAL") return skip_call(scan);
    if (name == "RET") return return_statement(scan, span);
    if (name == "MCALL") return modal(scan);
    if (std::ranges::find(kFrames, name) != kFrames.end()) return frame_statement(name, scan);
    if (name == "CALL" || name == "PCALL" || name == "EXTCALL")
        return call_statement(name, scan, span);
    scan.move_to(begin);
    is_done = false;
    return true;
}

/// IF, GOTO, CASE, loops. `is_flow`: false for another statement.
bool Runner::flow_statement(std::string_view name, CodeScanner& scan, bool& is_flow) {
    if (name == "IF") return if_statement(scan);
    if (name == "ELSE") return is_at_end(scan) && skip_to_end("IF", false);
    if (name == "ENDIF") return is_at_end(scan);
    if (name.starts_with("GOTO")) {
        if (name == "GOTO" || name == "GOTOF" || name == "GOTOB" || name == "GOTOC")
            return jump(name, scan);
        return fail(Message::NotRead, line_.span(scan.at() - name.size(), name.size()), {name});
    }
    if (name == "CASE") return case_statement(scan);
    if (name == "FOR" || name == "WHILE" || name == "LOOP" || name == "REPEAT" || name == "REPEATB")
        return loop_statement(name, scan);
    if (name == "ENDFOR" || name == "ENDWHILE" || name == "ENDLOOP" || name == "UNTIL")
        return end_loop(name, scan);
    is_flow = false;
    return true;
}

bool Runner::return_statement(CodeScanner& scan, SourceSpan span) {
    if (scan.take('(')) return fail(Message::NotRead, span, {"RET with values"});
    if (!is_at_end(scan)) return false;
    if (is_in_subprogram()) return finish_program();
    return end_main_program();
}

/// Ends the main program: reports a modal call that is still active.
bool Runner::end_main_program() {
    const SourceSpan span = line_.whole();
    if (frame().modal.is_active) log_.add(Message::LeftOnAtEnd, span, {"MCALL", "MCALL alone"});
    control_.end_program(span);
    end();
    return true;
}

/// CALL "NAME"(1,2), PCALL /DIR/NAME(1,2), EXTCALL("NAME").
bool Runner::call_statement(std::string_view name, CodeScanner& scan, SourceSpan span) {
    std::string called;
    if (name == "PCALL") {
        scan.skip_blanks();
        const std::size_t end = std::min(scan.remaining().find('('), scan.remaining().size());
        called = std::string(scan.remaining().substr(0, end));
        scan.move_to(scan.at() + end);
    } else {
        const bool has_bracket = name == "EXTCALL" && scan.take('(');
        scan.skip_blanks();
        if (name == "CALL" && upper_of(name_at(scan.remaining())) == "BLOCK")
            return fail(Message::NotRead, span, {"CALL BLOCK"});
        const std::optional<Value> value = expressions_.value(scan, line_);
        if (!value) return false;
        if (!value->is_text) return fail(Message::ValueType, span, {"the name of a program"});
        if (has_bracket && !scan.take(')')) return refuse_text(scan.at());
        called = value->text;
    }
    std::optional<std::vector<Argument>> passed = arguments(scan);
    if (!passed || !is_at_end(scan)) return false;
    return call(called, std::move(*passed), 1.0, line_.whole());
}

/// Skips the arguments of a call that moves nothing: MSG("text").
bool Runner::skip_call(CodeScanner& scan) {
    if (!scan.take('(')) return refuse_text(scan.at());
    int depth = 1;
    bool is_quoted = false;
    std::size_t at = scan.at();
    for (; at < line_.code.size() && depth > 0; ++at) {
        const char c = line_.code[at];
        if (c == '"') is_quoted = !is_quoted;
        if (!is_quoted && c == '(') ++depth;
        if (!is_quoted && c == ')') --depth;
    }
    if (depth > 0) return fail(Message::BracketUnclosed, line_.whole());
    scan.move_to(at);
    return is_at_end(scan);
}

/// TRANS X10, in a block of its own.
bool Runner::frame_statement(std::string_view name, CodeScanner& scan) {
    Words words;
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        const WordReader::Found found = words_.word(scan, line_, words);
        if (found == WordReader::Found::Error) return false;
        if (found == WordReader::Found::No) return refuse_text(begin);
    }
    Words others = words;
    others.axis = {};
    if (!others.is_empty()) return fail(Message::FrameBlock, line_.whole(), {name});
    return control_.frame(name, words, line_.whole());
}

// --- Words, assignments, calls ---

/// Executes the words, assignments and calls of the block.
bool Runner::items(CodeScanner& scan) {
    Words words;
    bool has_words = false;
    while (!scan.is_at_end()) {
        if (begins_plain_word(scan.remaining())) {
            const WordReader::Found found = words_.plain_word(scan, line_, words);
            if (found == WordReader::Found::Error) return false;
            if (found == WordReader::Found::Yes) {
                has_words = true;
                continue;
            }
        }
        const std::size_t frames = frames_.size();
        const Place place = reader_->place();
        if (!item(scan, words, has_words)) return false;
        // A call ends the block.
        if (frames_.size() != frames || !(reader_->place() == place)) {
            if (has_words) return fail(Message::CallWithWords, line_.whole());
            return true;
        }
    }
    return !has_words || finish_block(words, line_.whole());
}

/// Reads an item that is no plain word: an assignment, a call, a keyword, a word with a sign.
bool Runner::item(CodeScanner& scan, Words& words, bool& has_words) {
    const std::size_t begin = scan.at();
    const std::string_view raw = name_at(scan.remaining());
    if (raw.empty()) return refuse_text(begin);
    const std::string name = upper_of(raw);
    const SourceSpan span = line_.span(begin, raw.size());
    CodeScanner behind(line_.code, begin + raw.size());
    behind.skip_blanks();
    const bool has_sign = behind.peek() == '=' && behind.peek(1) != '=';
    const bool has_bracket = behind.peek() == '[';
    if (name[0] == '$') return fail(Message::NotRead, span, {"an assignment to " + name});
    const bool is_variable = variables_.find(name) != nullptr;
    if ((has_sign || has_bracket) && (is_variable || is_r_parameter(name) || name == "R"))
        return assign(scan);
    if (has_sign && name.size() > 1 && !is_long_address(name))
        return fail(Message::VariableMissing, span, {raw});
    if (behind.peek() == '(') return named_call(raw, scan, begin == 0 && !has_words);
    if (!has_sign && raw.size() > 1 && !is_digit(raw[1])) {
        switch (words_.keyword(name, span, words)) {
            case WordReader::Found::Error: return false;
            case WordReader::Found::Yes:
                scan.move_to(begin + raw.size());
                has_words = true;
                return true;
            case WordReader::Found::No: break;
        }
    }
    switch (words_.word(scan, line_, words)) {
        case WordReader::Found::Error: return false;
        case WordReader::Found::Yes: has_words = true; return true;
        case WordReader::Found::No: break;
    }
    if (has_sign || has_bracket) return refuse_text(begin);
    return named_call(raw, scan, !has_words);
}

/// "R1=5", "NAME[2]=R3*2".
bool Runner::assign(CodeScanner& scan) {
    const std::size_t begin = scan.at();
    const std::optional<Target> target = expressions_.target(scan, line_);
    if (!target) return false;
    if (!scan.take('=')) return refuse_text(begin);
    scan.skip_blanks();
    const std::string next = upper_of(name_at(scan.remaining()));
    if (next == "SET" || next == "REP")
        return fail(Message::NotRead, line_.span(scan.at(), 3), {next + " of an array"});
    const std::optional<Value> value = expressions_.value(scan, line_);
    if (!value) return false;
    return variables_.set(*target, *value, line_.span(begin, scan.at() - begin), log_);
}

/// Executes the words of a block, then the end of the program and the modal call.
bool Runner::finish_block(const Words& words, SourceSpan span) {
    if (words.has_m(6) && frame().modal.is_active)
        log_.add(Message::LeftOnAtChange, span, {"MCALL", "MCALL alone"});
    if (!control_.block(words, span)) return false;
    const bool ends = words.has_m(2) || words.has_m(30);
    const bool returns = words.has_m(17);
    if (ends || returns) {
        if (is_in_subprogram()) return finish_program();
        return end_main_program();
    }
    const std::optional<int> once = words.of(CodeGroup::OneShot);
    const bool moves = words.has_axes() && !once && !words.of(CodeGroup::Suppress);
    return !moves || !frame().modal.is_active || call_modal();
}

// --- Definitions ---

/// DEF REAL A=1, B[3]
bool Runner::define(CodeScanner& scan) {
    struct TypeName {
        std::string_view name;
        Type type;
    };
    constexpr std::array<TypeName, 5> kTypes{{{"REAL", Type::Real},
                                              {"INT", Type::Int},
                                              {"BOOL", Type::Bool},
                                              {"CHAR", Type::Char},
                                              {"STRING", Type::String}}};
    scan.skip_blanks();
    const std::string_view raw = name_at(scan.remaining());
    const std::string name = upper_of(raw);
    const auto* const found = std::ranges::find(kTypes, name, &TypeName::name);
    if (found == kTypes.end()) {
        return fail(Message::NotRead, line_.whole(),
                    {raw.empty() ? std::string("DEF") : "DEF " + name});
    }
    scan.move_to(scan.at() + raw.size());
    std::uint32_t length = 0;
    if (found->type == Type::String && scan.peek() == '[') {
        const auto size = expressions_.indices(scan, line_);
        if (!size) return false;
        length = size->front();
    }
    do {
        if (!define_one(found->type, length, scan)) return false;
    } while (scan.take(','));
    return is_at_end(scan);
}

bool Runner::define_one(Type type, std::uint32_t length, CodeScanner& scan) {
    scan.skip_blanks();
    const std::string_view raw = name_at(scan.remaining());
    if (raw.empty() || raw[0] == '$') return refuse_text(scan.at());
    scan.move_to(scan.at() + raw.size());
    auto variable = std::make_shared<Variable>();
    variable->type = type;
    (void)length;
    const Value zero = type == Type::String ? Value::of(std::string()) : Value::of(0.0);
    variable->elements = {zero};
    if (scan.peek() == '[') {
        const auto size = expressions_.indices(scan, line_);
        if (!size) return false;
        double count = 1.0;
        for (std::size_t i = 0; i < size->size(); ++i) {
            variable->size[i] = (*size)[i];
            count *= (*size)[i];
        }
        if (!(count >= 1.0 && count <= static_cast<double>(Variables::kMostElements)))
            return fail(Message::IndexRange, line_.whole());
        variable->elements.assign(static_cast<std::size_t>(count), zero);
    }
    if (scan.take('=')) {
        const std::string next = upper_of(name_at(scan.remaining()));
        if (variable->is_array() || next == "SET" || next == "REP")
            return fail(Message::NotRead, line_.whole(), {"a value of an array in DEF"});
        const std::optional<Value> value = expressions_.value(scan, line_);
        if (!value || !variables_.set({variable, 0}, *value, line_.whole(), log_)) return false;
    }
    variables_.define(upper_of(raw), std::move(variable));
    return true;
}

}  // namespace ncsim::gcode::sinumerik
