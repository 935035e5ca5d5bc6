// SPDX-License-Identifier: GPL-3.0-or-later
//
// Execution of blocks, labels and calls.
#include "klartext/klartext_runner.h"

#include "ncsim/base/angles.h"

#include "language/contour_recorder.h"
#include "text/line_end.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ncsim::gcode::klartext {
namespace {

/// True if a line of `file` is BEGIN PGM.
bool has_begin_pgm(const SourceFile& file) {
    Reader reader(file);
    Block block;
    while (reader.next_verb(block)) {
        if (block.verb == Verb::BeginPgm) return true;
    }
    return false;
}

}  // namespace

Runner::Runner(const SourceFile& program, const InterpreterOptions& options, const Rules& rules,
               ArcCentres& centres, const MotionSink& sink, DiagnosticLog& log,
               Interpretation& result)
    : ProgramRunner(program, options, rules, centres, sink, log, result),
      rules_(rules),
      centres_(centres),
      parameters_(log),
      control_(options, machine_, parameters_, log) {
    control_.set_contour_reader(
        [this](const std::string& label, SourceSpan span) { return record_contour(label, span); });
    files_.push_back({&program, nullptr, Reader(program), false, {}});
    control_.add_tool_names(tool_names(program));
    has_begin_ = has_begin_pgm(program);
    for (const auto& [name, value] : options.variables) {
        Scanner scan(name);
        const std::optional<klartext::Value> parameter = scan.parameter();
        if (parameter && scan.is_at_end()) (void)parameters_.set(*parameter, value);
    }
}

bool Runner::refuse(std::string_view what) {
    return fail(Message::KlartextVerb, block_.whole(), {what});
}

/// Executes the next block.
/// Returns: false at the end of the program.
bool Runner::step() {
    const std::size_t faults = log_.errors();
    if (!file().reader.next(block_, &log_)) {
        if (frames_.empty()) return false;
        if (!frames_.back().is_program) {
            ended_ = true;
            return fail(Message::KlartextLabelEnd, {block_.line, 1, 0}, {frames_.back().label});
        }
        finish_subprogram();
        return true;
    }
    ++result_.lines;
    if (!count_block(!frames_.empty(), block_.whole())) return false;
    if (block_.verb == Verb::Empty) return true;
    if (block_.block_delete) note_deletable(current_, block_.whole());
    const bool is_readable = block_.verb != Verb::Unreadable || log_.errors() == faults;
    if (!is_readable || !act()) return stop();
    if (control_.has_ended()) end();
    return !ended_;
}

/// Executes the block.
/// Returns: false after an error at which the program stops.
bool Runner::act() {
    if (!has_begun_ && block_.verb != Verb::BeginPgm) {
        if (block_.verb == Verb::Unreadable && has_begin_) {
            log_.add(Message::KlartextHead, block_.whole());
            return true;
        }
        if (!has_begin_) has_begun_ = true;
    }
    switch (block_.verb) {
        case Verb::Empty:
        case Verb::BlkForm:
        case Verb::Lbl: break;
        case Verb::BeginPgm: return begin_program();
        case Verb::EndPgm:
            if (!frames_.empty()) {
                if (!frames_.back().is_program)
                    return fail(Message::KlartextLabelEnd, block_.whole(), {frames_.back().label});
                finish_subprogram();
                return true;
            }
            control_.end_program(block_.whole());
            end();
            return true;
        case Verb::ToolCall: return control_.tool_call(block_);
        case Verb::ToolDef: return control_.tool_def(block_);
        case Verb::CyclDef: return control_.cycle_def(block_);
        case Verb::CyclCall: return control_.cycle_call(block_);
        case Verb::PatternDef: return control_.pattern_def(block_);
        case Verb::CyclEnd: control_.cycle_end(block_); return true;
        case Verb::CallLbl: return call_label();
        case Verb::CallPgm: return call_program();
        case Verb::Fn: return fn();
        case Verb::If: {
            Scanner scan(block_.code);
            return branch(scan);
        }
        case Verb::Assignment: return assignment();
        case Verb::Plane: return control_.plane(block_);
        case Verb::Function: return control_.function(block_);
        case Verb::Stop: return control_.stop_block(block_);
        case Verb::Error: return fail(Message::KlartextControlError, block_.whole());
        case Verb::Centre: return control_.centre(block_);
        case Verb::Approach: return approach();
        case Verb::Depart: return control_.depart(block_);
        case Verb::Rounding:
        case Verb::Chamfer: return true;  // Part of the block before.
        case Verb::Other: return probes_tool() || refuse(block_.name);
        case Verb::Unreadable: return refuse_text();
        default: return path();
    }
    // "LBL 0" ends a subprogram.
    if (block_.verb != Verb::Lbl) return true;
    Scanner scan(block_.code, block_.rest);
    const std::optional<std::string> label = label_of(scan);
    if (!label) return false;
    if (*label == "0") {
        if (!frames_.empty() && !frames_.back().is_program) finish_subprogram();
        return true;
    }
    // A repeat begins anew; a repeat of this label that a jump left does not count.
    const std::size_t base = frames_.empty() ? 0 : frames_.back().repeats;
    repeats_.erase(
        std::remove_if(repeats_.begin() + static_cast<std::ptrdiff_t>(base), repeats_.end(),
                       [&](const Repeat& repeat) {
                           return repeat.file == current_ && repeat.label == *label;
                       }),
        repeats_.end());
    return true;
}

/// Runs the subprogram `label` with a machine of its own, and returns its moves in the plane; the
/// first move leads to the contour and is left out.
std::optional<Control::Contour> Runner::record_contour(const std::string& label, SourceSpan span) {
    language::ContourRecorder recorder(control_.plane(), machine_.state().unit_mm());
    const MotionSink take = recorder.sink();
    Control::Contour contour;
    Interpretation ignored;
    {
        Runner contour_runner(*file().source, options_, rules_, centres_, take, log_, ignored);
        contour_runner.parameters_.copy_values(parameters_);
        contour_runner.control_.begin_contour(control_);
        // Reading the file for its labels counts as running its lines.
        contour_runner.repeated_ = repeated_ + line_count(file().source->text);
        const bool done = contour_runner.run_contour(label, span);
        repeated_ = std::max<std::uint64_t>(1, contour_runner.repeated_);
        log_.set_file(current_ == 0 ? std::string() : file().source->name);
        if (!done) return std::nullopt;
        contour.side = contour_runner.control_.contour_side();
    }
    if (!recorder.is_complete()) {
        fail(Message::BlockNeeds, span,
             {"LBL " + label, "a contour that begins with a line to a point"});
        return std::nullopt;
    }
    contour.moves = recorder.contour();
    return contour;
}

/// Runs the subprogram `label` up to LBL 0.
bool Runner::run_contour(const std::string& label, SourceSpan span) {
    has_begun_ = true;
    frames_.push_back({});
    frames_.back().label = label;
    if (!jump_to(label, span)) return false;
    while (!frames_.empty()) {
        if (!step() || ended_) return false;
    }
    machine_.flush();
    path_.finish();
    return !machine_.stopped();
}

/// True for a touch probe cycle that measures the tool, after reporting the cycle: its moves do not
/// touch the part.
bool Runner::probes_tool() {
    if (block_.name != "TCH PROBE") return false;
    Scanner scan(block_.code, block_.rest);
    scan.skip_blanks();
    const std::uint32_t number = scan.whole().value_or(0);
    // Cycles 30 to 33 and 480 to 485; 580 to 589 of machine builders.
    const bool is_known = (number >= 30 && number <= 33) || (number >= 480 && number <= 485) ||
                          (number >= 580 && number <= 589);
    if (is_known) log_.add(Message::KlartextToolProbe, block_.whole(), {std::to_string(number)});
    return is_known;
}

bool Runner::refuse_text() {
    constexpr std::size_t kMost = 40;
    return fail(Message::KlartextText, block_.whole(), {block_.code.substr(0, kMost)});
}

/// BEGIN PGM name MM | INCH.
bool Runner::begin_program() {
    has_begun_ = true;
    const std::string words = upper_of(block_.code);
    const std::size_t last = words.find_last_of(" \t");
    const std::string unit = last == std::string::npos ? "" : words.substr(last + 1);
    const bool inches = unit == "INCH" || unit == "IN";
    // Called programs have the unit of their own BEGIN PGM; mixed units are rare and refused.
    const bool is_called = !frames_.empty();
    if (is_called && inches != machine_.state().inches)
        return refuse("a called program with other units");
    if (!is_called) control_.set_units(inches);
    return true;
}

// --- Paths ---

/// Reads the feed of the RND or CHF block `next_`, which is the feed of the corner only.
bool Runner::read_corner_feed(Corner& corner) {
    const auto word = std::ranges::find(next_.words, Address::F, &Word::address);
    if (word == next_.words.end()) return true;
    corner.feed = parameters_.value_of(word->value, word->span);
    if (corner.feed && *corner.feed < 0.0)
        return fail(Message::NegativeValue, next_.whole(), {"F"});
    return corner.feed.has_value();
}

/// Returns the corner of a RND or CHF block after the present block, which stays next.
std::optional<Corner> Runner::corner_after(bool& is_refused) {
    is_refused = false;
    const Reader::Place place = file().reader.place();
    std::optional<Corner> corner;
    SourceSpan span;
    while (file().reader.next(next_, nullptr)) {
        if (next_.verb == Verb::Empty) continue;
        if (!corner) {
            const bool rounds = next_.verb == Verb::Rounding;
            if (!rounds && next_.verb != Verb::Chamfer) break;
            span = next_.whole();
            const auto word = std::ranges::find(next_.words, Address::Radius, &Word::address);
            if (word == next_.words.end()) {
                fail(Message::BlockNeeds, span, {next_.name, "a length"});
                is_refused = true;
                break;
            }
            const std::optional<double> size = parameters_.value_of(word->value, word->span);
            if (!size) {
                is_refused = true;
                break;
            }
            corner = Corner{rounds ? 'R' : 'C', *size, false, {}, span};
            if (!read_corner_feed(*corner)) is_refused = true;
            continue;
        }
        const bool is_line = next_.verb == Verb::Straight || next_.verb == Verb::StraightPolar;
        const bool is_arc = next_.verb >= Verb::Arc && next_.verb <= Verb::ArcTangentPolar;
        const bool rounds = corner->letter == 'R';
        if (is_arc && !rounds) {
            fail(Message::KlartextVerb, span, {"CHF next to an arc"});
            is_refused = true;
        } else if (!is_arc && !is_line && next_.verb != Verb::Centre) {
            fail(Message::KlartextVerb, span,
                 {rounds ? "RND without a path block after it" : "CHF without a line after it"});
            is_refused = true;
        }
        if (next_.verb == Verb::Centre) continue;
        break;
    }
    file().reader.seek(place);
    return corner;
}

/// APPR: the first element of the contour is the next path block.
bool Runner::approach() {
    const Reader::Place place = file().reader.place();
    std::optional<Block> centre;
    bool is_found = false;
    while (!is_found && file().reader.next(next_, nullptr)) {
        if (next_.verb == Verb::Empty || next_.verb == Verb::Lbl) continue;
        if (next_.verb == Verb::Centre) {
            centre = next_;
            continue;
        }
        if (next_.verb < Verb::Straight || next_.verb > Verb::ArcTangentPolar) break;
        is_found = true;
    }
    file().reader.seek(place);
    if (!is_found) return refuse("APPR without a path block after it");
    return control_.approach(block_, next_, centre ? &*centre : nullptr);
}

bool Runner::path() {
    bool is_refused = false;
    std::optional<Corner> corner;
    if (file().reader.is_corner_next()) corner = corner_after(is_refused);
    if (is_refused) return false;
    const bool is_line = block_.verb == Verb::Straight || block_.verb == Verb::StraightPolar;
    if (corner && !is_line && corner->letter != 'R')
        return fail(Message::KlartextVerb, corner->span, {"CHF next to an arc"});
    return control_.path(block_, corner ? &*corner : nullptr);
}

// --- Q parameters ---

bool Runner::assign_text(Scanner& scan) {
    scan.move_to(scan.at() + 2);
    const std::uint32_t index = scan.whole().value_or(0);
    if (!scan.take('=')) return refuse_text();
    std::string text;
    do {
        scan.skip_blanks();
        if (const auto quoted = scan.quoted()) {
            text += *quoted;
        } else if (upper(scan.peek()) == 'Q' && upper(scan.peek(1)) == 'S') {
            scan.move_to(scan.at() + 2);
            text += parameters_.text(scan.whole().value_or(0)).value_or("");
        } else {
            return refuse("a formula of texts (QS)");
        }
        if (text.size() > 1000) return refuse("a long text (QS)");
    } while (scan.take('|') && scan.take('|'));
    if (!scan.is_at_end()) return refuse("a formula of texts (QS)");
    parameters_.set_text(index, std::move(text));
    return true;
}

/// Q1 = formula.
bool Runner::assignment() {
    Scanner scan(block_.code);
    if (upper(scan.peek(1)) == 'S') return assign_text(scan);
    const std::optional<klartext::Value> target = scan.parameter();
    if (!target || !scan.take('=')) return refuse_text();
    const SourceSpan span = block_.span(0, scan.at());
    const std::optional<double> value = parameters_.read_formula(scan, block_);
    if (!value) return false;
    if (!parameters_.set(*target, *value))
        return fail(Message::KlartextParameterRange, span, {block_.code.substr(0, span.length)});
    return true;
}

/// FN 0: Q1 = +5 … FN 38.
bool Runner::fn() {
    Scanner scan(block_.code, block_.rest);
    scan.skip_blanks();
    const std::optional<std::uint32_t> number = scan.whole();
    if (!number) return refuse_text();
    (void)scan.take(':');
    switch (*number) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
        case 5:
        case 6:
        case 7:
        case 8:
        case 13: return arithmetic(scan, *number);
        case 9:
        case 10:
        case 11:
        case 12: return branch(scan);
        case 14:
            log_.add(Message::KlartextProgramError, block_.whole());
            ended_ = true;
            return true;
        // Output, PLC, waiting: move nothing.
        case 16:
        case 19:
        case 20:
        case 29:
        case 37:
        case 38: return true;
        case 17: log_.add(Message::KlartextSystemWrite, block_.whole()); return true;
        case 18: return system_read(scan);
        default: {
            std::string name = "FN ";
            name += std::to_string(*number);
            return refuse(name);
        }
    }
}

bool Runner::arithmetic(Scanner& scan, std::uint32_t number) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    const std::optional<klartext::Value> target = scan.parameter();
    const SourceSpan span = block_.span(begin, scan.at() - begin);
    if (!target || !scan.take('=')) return refuse_text();
    const auto set = [&](double value) {
        if (!(std::abs(value) <= 1e12)) return fail(Message::NotANumber, block_.whole());
        return parameters_.set(*target, value) || fail(Message::KlartextParameterRange, span,
                                                       {block_.code.substr(begin, span.length)});
    };
    if (number == 5) (void)scan.take_word("SQRT");
    if (number == 6) (void)scan.take_word("SIN");
    if (number == 7) (void)scan.take_word("COS");
    const std::optional<double> a = parameters_.read_value(scan, block_);
    if (!a) return false;
    std::optional<double> b = 0.0;
    const bool has_two = (number >= 1 && number <= 4) || number == 8 || number == 13;
    if (has_two) {
        const bool is_there = number == 1   ? scan.take('+')
                              : number == 2 ? scan.take('-')
                              : number == 3 ? scan.take('*')
                              : number == 4 ? scan.take_word("DIV") || scan.take('/')
                              : number == 8 ? scan.take_word("LEN")
                                            : scan.take_word("ANG");
        if (!is_there) return refuse_text();
        b = parameters_.read_value(scan, block_);
        if (!b) return false;
    }
    if (!scan.is_at_end()) return refuse_text();
    switch (number) {
        case 0: return set(*a);
        case 1: return set(*a + *b);
        case 2: return set(*a - *b);
        case 3: return set(*a * *b);
        case 4:
            if (*b == 0.0) return fail(Message::DivisionByZero, block_.whole());
            return set(*a / *b);
        case 5:
            if (*a < 0.0) return fail(Message::FunctionRange, block_.whole(), {"SQRT"});
            return set(std::sqrt(*a));
        case 6: return set(sin_cos(*a).sin);
        case 7: return set(sin_cos(*a).cos);
        case 8: return set(hypotenuse(*a, *b));
        default: {
            // a is the side opposite to the angle, or its sine; b is the adjacent side.
            const double angle = angle_of(*b, *a);
            return set(angle < 0.0 ? angle + 360.0 : angle);
        }
    }
}

/// IF +Q1 EQU|NE|GT|LT +Q2 GOTO LBL n.
bool Runner::branch(Scanner& scan) {
    if (!scan.take_word("IF")) return refuse_text();
    const std::optional<double> a = parameters_.read_value(scan, block_);
    if (!a) return false;
    scan.skip_blanks();
    const std::string relation = upper_of(scan.letters());
    const std::optional<double> b = parameters_.read_value(scan, block_);
    if (!b) return false;
    if (!scan.take_word("GOTO") || !scan.take_word("LBL")) return refuse_text();
    const std::optional<std::string> label = label_of(scan);
    if (!label) return false;
    bool jumps = false;
    if (relation == "EQU") {
        jumps = *a == *b;
    } else if (relation == "NE") {
        jumps = *a != *b;
    } else if (relation == "GT") {
        jumps = *a > *b;
    } else if (relation == "LT") {
        jumps = *a < *b;
    } else {
        return refuse_text();
    }
    return !jumps || jump_to(*label, block_.whole());
}

/// FN 18: SYSREAD Q1 = ID20 NR1: data of the control.
bool Runner::system_read(Scanner& scan) {
    if (!scan.take_word("SYSREAD")) return refuse_text();
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    const std::optional<klartext::Value> target = scan.parameter();
    if (!target) return refuse_text();
    const std::string_view name = scan.text(begin);
    log_.add(Message::KlartextSystemData, block_.whole(), {"FN 18", name});
    parameters_.set_unknown(*target);
    return true;
}

// --- Labels and calls ---

/// Returns the label at `scan`: "5" without leading zeros, or the text of a name after a quote.
std::optional<std::string> Runner::label_of(Scanner& scan) {
    scan.skip_blanks();
    if (const auto name = scan.quoted()) return "\"" + std::string(*name);
    if (upper(scan.peek()) == 'Q' && upper(scan.peek(1)) == 'S') {
        scan.move_to(scan.at() + 2);
        if (const auto text = parameters_.text(scan.whole().value_or(0))) return "\"" + *text;
        refuse("a label by a text that is not known (QS)");
        return std::nullopt;
    }
    const std::size_t begin = scan.at();
    const klartext::Value value = scan.value();
    if (value.kind == klartext::Value::Kind::None) {
        refuse_text();
        return std::nullopt;
    }
    const std::optional<double> number =
        parameters_.value_of(value, block_.span(begin, scan.at() - begin));
    if (!number) return std::nullopt;
    if (!(std::abs(*number) < 1e9) || *number != std::floor(*number)) {
        refuse_text();
        return std::nullopt;
    }
    return std::to_string(static_cast<long long>(*number));
}

std::optional<Reader::Place> Runner::find_label(const std::string& label) {
    OpenFile& open = file();
    if (!open.has_labels) {
        open.has_labels = true;
        Reader reader(*open.source);
        while (reader.next_verb(next_)) {
            if (next_.verb != Verb::Lbl) continue;
            Scanner scan(next_.code, next_.rest);
            scan.skip_blanks();
            std::string name;
            if (const auto quoted = scan.quoted()) {
                name = "\"" + std::string(*quoted);
            } else if (const auto number = scan.whole()) {
                name = std::to_string(*number);
            } else {
                continue;
            }
            if (name != "0") open.labels.try_emplace(std::move(name), reader.place());
        }
    }
    const auto found = open.labels.find(label);
    if (found == open.labels.end()) return std::nullopt;
    return found->second;
}

void Runner::go(std::size_t file_number, Reader::Place place) {
    if (file_number == current_ && place.line <= file().reader.place().line) count_repeats();
    current_ = file_number;
    file().reader.seek(place);
    control_.set_file(static_cast<std::uint32_t>(current_));
    log_.set_file(current_ == 0 ? std::string() : file().source->name);
}

bool Runner::jump_to(const std::string& label, SourceSpan span) {
    const std::optional<Reader::Place> place = find_label(label);
    if (!place) {
        const bool is_name = label.starts_with('"');
        return fail(Message::KlartextLabelMissing, span, {is_name ? label + '"' : label});
    }
    go(current_, *place);
    return true;
}

bool Runner::enter(Frame frame, std::size_t file_number, Reader::Place place, SourceSpan span) {
    if (frames_.size() >= options_.limits.call_depth) return fail(Message::CallDepth, span);
    frame.file = current_;
    frame.back = file().reader.place();
    frame.repeats = repeats_.size();
    frames_.push_back(std::move(frame));
    count_repeats();
    go(file_number, place);
    return true;
}

void Runner::finish_subprogram() {
    Frame frame = std::move(frames_.back());
    frames_.pop_back();
    repeats_.resize(std::min(repeats_.size(), frame.repeats));
    if (frame.is_program) parameters_.restore_locals(std::move(frame.locals));
    go(frame.file, frame.back);
}

/// CALL LBL n: runs the subprogram up to LBL 0. CALL LBL n REP m: runs the blocks from LBL n to the
/// call m more times.
bool Runner::call_label() {
    Scanner scan(block_.code, block_.rest);
    const std::optional<std::string> label = label_of(scan);
    if (!label) return false;
    const SourceSpan span = block_.whole();
    // "REP6", "REP 6", "REP 3/3", "REPQ5"
    scan.skip_blanks();
    if (upper_of(block_.code.substr(scan.at(), 3)) == "REP") {
        scan.move_to(scan.at() + 3);
        const std::optional<double> count = parameters_.read_value(scan, block_);
        if (!count) return false;
        if (scan.take('/')) (void)scan.unsigned_number();
        if (!scan.is_at_end()) return refuse_text();
        const Reader::Place call = file().reader.place();
        const std::size_t base = frames_.empty() ? 0 : frames_.back().repeats;
        auto own = std::find_if(
            repeats_.begin() + static_cast<std::ptrdiff_t>(base), repeats_.end(),
            [&](const Repeat& repeat) { return repeat.file == current_ && repeat.call == call; });
        if (own == repeats_.end()) {
            if (*count < 1.0) return true;
            if (repeats_.size() >= 1000) return fail(Message::CallDepth, span);
            repeats_.push_back(
                {current_, call, *label, static_cast<std::uint64_t>(std::min(*count, 1e9))});
            own = repeats_.end() - 1;
        }
        if (own->remaining == 0) {
            repeats_.erase(own);
            return true;
        }
        --own->remaining;
        return jump_to(*label, span);
    }
    if (!scan.is_at_end()) return refuse_text();
    if (*label == "0") return refuse("CALL LBL 0");
    const std::optional<Reader::Place> place = find_label(*label);
    if (!place) return jump_to(*label, span);  // Reports the label.
    Frame frame;
    frame.label = *label;
    return enter(std::move(frame), current_, *place, span);
}

std::optional<std::size_t> Runner::open_file(const std::string& name) {
    if (!options_.read_file) return std::nullopt;
    std::optional<SourceFile> source;
    // Last, the ending of the main program.
    const std::string& main = files_.front().source->name;
    const std::size_t point = std::min(main.find_last_of('.'), main.size());
    for (const std::string& ending :
         {std::string(), std::string(".h"), std::string(".H"), main.substr(point)}) {
        source = options_.read_file(name + ending);
        if (source) break;
    }
    if (!source) return std::nullopt;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (files_[i].source->name == source->name) return i;
    }
    auto owned = keep_file(std::move(*source), files_.size());
    if (!owned) return std::nullopt;
    const SourceFile* kept = owned.get();
    control_.add_tool_names(tool_names(*kept));
    files_.push_back({kept, std::move(owned), Reader(*kept), false, {}});
    return files_.size() - 1;
}

/// CALL PGM TNC:\DIR\NAME.H: the name without the folder.
bool Runner::call_program() {
    Scanner scan(block_.code, block_.rest);
    scan.skip_blanks();
    std::string name;
    if (const auto quoted = scan.quoted()) {
        name = std::string(*quoted);
    } else {
        name = std::string(scan.remaining());
    }
    if (const std::size_t folder = name.find_last_of("\\/:"); folder != std::string::npos)
        name.erase(0, folder + 1);
    if (name.empty()) return refuse_text();
    const SourceSpan span = block_.whole();
    if (!control_.end_compensation(span)) return false;
    const std::optional<std::size_t> opened = open_file(name);
    if (!opened) {
        report_missing_program(name, span);
        return true;
    }
    Frame frame;
    frame.is_program = true;
    frame.label = name;
    frame.locals = parameters_.take_locals();
    return enter(std::move(frame), *opened, Reader(*files_[*opened].source).place(), span);
}

}  // namespace ncsim::gcode::klartext
