// SPDX-License-Identifier: GPL-3.0-or-later
//
// Jumps, branches, loops, repeats.
// Source: SINUMERIK 840D sl, Programming Manual NC Programming, "Program jumps", 06/2019.
#include "sinumerik/sinumerik_runner.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::sinumerik {
namespace {

/// Returns the keyword that ends the structure of `name`.
std::string_view end_name(std::string_view name) {
    if (name == "IF") return "ENDIF";
    if (name == "FOR") return "ENDFOR";
    if (name == "WHILE") return "ENDWHILE";
    if (name == "LOOP") return "ENDLOOP";
    return "UNTIL";
}

/// True if the line `code`, which begins with `name`, begins a structure of several blocks.
bool begins_structure(std::string_view name, std::string_view code) {
    if (name == "FOR" || name == "WHILE" || name == "LOOP") return true;
    if (name == "REPEAT") return CodeScanner(code, name.size()).is_at_end();
    return name == "IF" && upper_of(code).find("GOTO") == std::string::npos;
}

/// Returns the block number without leading zeros, "N10" or ":10".
std::string plain_number(std::string_view number) {
    std::string name(1, upper(number[0]));
    std::size_t at = 1;
    while (at + 1 < number.size() && number[at] == '0')
        ++at;
    return name += number.substr(at);
}

}  // namespace

bool Runner::condition(CodeScanner& scan, bool& is_true) {
    const std::optional<double> value = expressions_.number(scan, line_);
    if (!value) return false;
    is_true = *value != 0.0;
    return true;
}

/// "IF R1==5 GOTOF END", several of them in a block, or IF … ELSE … ENDIF.
bool Runner::if_statement(CodeScanner& scan) {
    while (true) {
        bool is_true = false;
        if (!condition(scan, is_true)) return false;
        if (scan.is_at_end()) return is_true || skip_to_end("IF", true);
        const std::size_t begin = scan.at();
        const std::string_view raw = name_at(scan.remaining());
        const std::string kind = upper_of(raw);
        if (!kind.starts_with("GOTO")) return refuse_text(begin);
        scan.move_to(begin + raw.size());
        const std::optional<std::string> label = jump_target(scan);
        if (!label) return false;
        if (is_true) return go_to(kind, *label);
        if (scan.is_at_end()) return true;
        const std::string_view next = name_at(scan.remaining());
        if (upper_of(next) != "IF") return refuse_text(scan.at());
        scan.move_to(scan.at() + next.size());
    }
}

bool Runner::jump(std::string_view kind, CodeScanner& scan) {
    const std::optional<std::string> label = jump_target(scan);
    if (!label) return false;
    return is_at_end(scan) && go_to(kind, *label);
}

/// CASE R1 OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C
bool Runner::case_statement(CodeScanner& scan) {
    const std::optional<double> value = expressions_.number(scan, line_);
    if (!value) return false;
    if (!scan.take_word("OF")) return refuse_text(scan.at());
    while (!scan.is_at_end()) {
        bool is_this = true;
        if (!scan.take_word("DEFAULT")) {
            const std::optional<double> constant = expressions_.number(scan, line_);
            if (!constant) return false;
            is_this = *constant == *value;
        }
        scan.skip_blanks();
        const std::string_view raw = name_at(scan.remaining());
        const std::string kind = upper_of(raw);
        if (!kind.starts_with("GOTO")) return refuse_text(scan.at());
        scan.move_to(scan.at() + raw.size());
        const std::optional<std::string> label = jump_target(scan);
        if (!label) return false;
        if (is_this) return go_to(kind, *label);
    }
    return true;
}

/// Returns the name of the label, or the block number, at `scan`.
std::optional<std::string> Runner::jump_target(CodeScanner& scan) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    const std::string_view raw = name_at(scan.remaining());
    const std::string name = upper_of(raw);
    const std::shared_ptr<Variable> variable = variables_.find(name);
    if (scan.peek() == '"' || (variable && variable->type == Type::String)) {
        const std::optional<Value> value = expressions_.value(scan, line_);
        if (!value) return std::nullopt;
        return upper_of(value->text);
    }
    if (scan.peek() == ':') {
        std::size_t end = 1;
        while (is_digit(scan.peek(end)))
            ++end;
        scan.move_to(begin + end);
        return plain_number(line_.code.substr(begin, end));
    }
    if (raw.empty()) {
        refuse_text(begin);
        return std::nullopt;
    }
    scan.move_to(begin + raw.size());
    const bool is_number =
        raw.size() > 1 && name[0] == 'N' && std::ranges::all_of(raw.substr(1), is_digit);
    return is_number ? plain_number(name) : name;
}

const std::vector<Runner::Label>& Runner::labels() {
    Program& current = program();
    if (current.has_labels) return current.labels;
    current.has_labels = true;
    const SourceFile& file = *files_[current.file].source;
    Reader reader(file, current.section.begin, current.section.end);
    Place before = reader.place();
    while (reader.next(ahead_)) {
        if (!ahead_.number.empty()) current.labels.push_back({plain_number(ahead_.number), before});
        if (!ahead_.label.empty()) current.labels.push_back({upper_of(ahead_.label), before});
        before = reader.place();
    }
    return current.labels;
}

/// GOTOF: the next label; GOTOB: the label before; GOTO: the next one, else the one before; GOTOC:
/// as GOTO, or nothing if there is none.
bool Runner::go_to(std::string_view kind, const std::string& label) {
    const Label* forward = nullptr;
    const Label* backward = nullptr;
    for (const Label& candidate : labels()) {
        if (candidate.name != label) continue;
        if (candidate.place.offset > line_.offset) {
            if (!forward) forward = &candidate;
        } else {
            backward = &candidate;
        }
    }
    const Label* found = kind == "GOTOF"   ? forward
                         : kind == "GOTOB" ? backward
                         : forward         ? forward
                                           : backward;
    if (!found) {
        if (kind == "GOTOC") return true;
        return fail(Message::LabelMissing, line_.whole(),
                    {label, kind == "GOTOF"   ? " behind this block"
                            : kind == "GOTOB" ? " before this block"
                                              : ""});
    }
    leave_structures(found->place.offset);
    seek(found->place);
    return true;
}

// --- Structures ---

/// Returns the place behind the end of the structure `name` whose blocks begin at `after`. The end
/// is ELSE, too, if `stops_at_else`.
std::optional<Place> Runner::end_of_structure(Place after, std::string_view name,
                                              bool stops_at_else) {
    Program& current = program();
    const std::pair key{after.offset, stops_at_else};
    if (const auto known = current.ends.find(key); known != current.ends.end())
        return known->second;
    const SourceFile& file = *files_[current.file].source;
    Reader reader(file, after, current.section.end);
    std::vector<std::string> open{std::string(name)};
    std::optional<Place> found;
    constexpr std::size_t kDeepest = 1000;
    while (!found && open.size() < kDeepest && reader.next(ahead_)) {
        const std::string first = upper_of(name_at(ahead_.code));
        if (begins_structure(first, ahead_.code)) {
            open.push_back(first);
        } else if (first == end_name(open.back())) {
            open.pop_back();
            if (open.empty()) found = reader.place();
        } else if (first == "ELSE" && stops_at_else && open.size() == 1) {
            found = reader.place();
        }
    }
    current.ends[key] = found;
    return found;
}

/// Continues behind the end of the structure `name` that begins with this block.
bool Runner::skip_to_end(std::string_view name, bool stops_at_else) {
    const std::optional<Place> end = end_of_structure(reader_->place(), name, stops_at_else);
    if (!end) return fail(Message::StructureEnd, line_.whole(), {name, end_name(name)});
    reader_->seek(*end);
    return true;
}

/// Leaves the loops and repeats that do not contain the place `offset`.
void Runner::leave_structures(std::size_t offset) {
    std::vector<Loop>& loops = frame().loops;
    while (!loops.empty()) {
        const Loop& loop = loops.back();
        const std::string_view name = loop.kind == LoopKind::For     ? "FOR"
                                      : loop.kind == LoopKind::While ? "WHILE"
                                      : loop.kind == LoopKind::Loop  ? "LOOP"
                                                                     : "REPEAT";
        const std::optional<Place> end = end_of_structure(loop.body, name, false);
        if (offset > loop.header.offset && (!end || offset < end->offset)) break;
        loops.pop_back();
    }
    std::vector<Passage>& repeats = frame().repeats;
    while (!repeats.empty() &&
           (offset < repeats.back().begin.offset || offset >= repeats.back().stop))
        repeats.pop_back();
}

bool Runner::loop_statement(std::string_view name, CodeScanner& scan) {
    constexpr std::size_t kDeepest = 1000;
    if (frame().loops.size() >= kDeepest) return fail(Message::CallDepth, line_.whole());
    if (name == "FOR") return for_loop(scan);
    if (name == "REPEATB" || (name == "REPEAT" && !scan.is_at_end()))
        return repeat_section(name, scan);
    Loop loop;
    loop.header = {line_.offset, line_.line - 1};
    loop.body = reader_->place();
    if (name == "WHILE") {
        loop.kind = LoopKind::While;
        bool is_true = false;
        if (!condition(scan, is_true) || !is_at_end(scan)) return false;
        const bool is_again = !frame().loops.empty() && frame().loops.back().header == loop.header;
        if (!is_true) {
            if (is_again) frame().loops.pop_back();
            return skip_to_end("WHILE", false);
        }
        if (is_again) return true;
    } else {
        loop.kind = name == "LOOP" ? LoopKind::Loop : LoopKind::Repeat;
        if (!is_at_end(scan)) return false;
    }
    frame().loops.push_back(std::move(loop));
    return true;
}

/// FOR I = 1 TO 10
bool Runner::for_loop(CodeScanner& scan) {
    Loop loop;
    loop.kind = LoopKind::For;
    const std::optional<Target> counter = expressions_.target(scan, line_);
    if (!counter) return false;
    if (!scan.take('=')) return refuse_text(scan.at());
    const std::optional<double> first = expressions_.number(scan, line_);
    if (!first) return false;
    if (!scan.take_word("TO")) return refuse_text(scan.at());
    const std::optional<double> last = expressions_.number(scan, line_);
    if (!last || !is_at_end(scan)) return false;
    if (!variables_.set(*counter, Value::of(*first), line_.whole(), log_)) return false;
    if (*first > *last) return skip_to_end("FOR", false);
    loop.header = {line_.offset, line_.line - 1};
    loop.body = reader_->place();
    loop.counter = *counter;
    loop.last = *last;
    frame().loops.push_back(std::move(loop));
    return true;
}

bool Runner::end_loop(std::string_view name, CodeScanner& scan) {
    const LoopKind kind = name == "ENDFOR"     ? LoopKind::For
                          : name == "ENDWHILE" ? LoopKind::While
                          : name == "ENDLOOP"  ? LoopKind::Loop
                                               : LoopKind::Repeat;
    std::vector<Loop>& loops = frame().loops;
    if (loops.empty() || loops.back().kind != kind)
        return fail(Message::StructureBegin, line_.whole(), {name});
    Loop& loop = loops.back();
    switch (kind) {
        case LoopKind::For: {
            const double next = variables_.get(loop.counter, line_.whole(), log_).number + 1.0;
            if (!variables_.set(loop.counter, Value::of(next), line_.whole(), log_)) return false;
            if (next > loop.last) {
                loops.pop_back();
            } else {
                seek(loop.body);
            }
            break;
        }
        case LoopKind::While: seek(loop.header); break;
        case LoopKind::Loop: seek(loop.body); break;
        case LoopKind::Repeat: {
            bool is_true = false;
            if (!condition(scan, is_true)) return false;
            if (is_true) {
                loops.pop_back();
            } else {
                seek(loop.body);
            }
            break;
        }
    }
    return is_at_end(scan);
}

// --- REPEAT of labels ---

/// REPEAT A P=3: from the label A to this block. REPEAT A B: from A to the block of B. REPEATB A:
/// the block of A.
bool Runner::repeat_section(std::string_view name, CodeScanner& scan) {
    const auto take_label = [&]() -> std::optional<std::string> {
        scan.skip_blanks();
        const std::string_view raw = name_at(scan.remaining());
        if (raw.empty() || (raw.size() == 1 && upper(raw[0]) == 'P')) return std::string();
        if (upper(raw[0]) == 'P' && std::ranges::all_of(raw.substr(1), is_digit))
            return std::string();
        return jump_target(scan);
    };
    const std::optional<std::string> first = take_label();
    if (!first) return false;
    const std::optional<std::string> second = name == "REPEAT" ? take_label() : std::string();
    if (!second) return false;
    const std::optional<double> runs = take_runs(scan);
    if (!runs || !is_at_end(scan)) return false;
    // The nearest label before this block; otherwise the first label behind it.
    const auto find = [&](const std::string& label) {
        const Label* nearest = nullptr;
        for (const Label& candidate : labels()) {
            if (candidate.name != label) continue;
            if (candidate.place.offset < line_.offset || !nearest) nearest = &candidate;
        }
        return nearest;
    };
    const Label* begin = find(*first);
    const Label* end = second->empty() ? nullptr : find(*second);
    if (!begin || (!second->empty() && !end))
        return fail(Message::LabelMissing, line_.whole(), {begin ? *second : *first, ""});
    Passage section;
    section.begin = begin->place;
    section.back = reader_->place();
    section.stop = line_.offset;
    const SourceFile& file = *files_[program().file].source;
    const auto behind = [&](Place place) {
        Reader reader(file, place, program().section.end);
        (void)reader.next(ahead_);
        return reader.place().offset;
    };
    if (end) {
        section.stop = behind(end->place);
    } else if (name == "REPEATB") {
        section.stop = behind(begin->place);
    } else {
        const auto& all = labels();
        const auto closing = std::ranges::find_if(all, [&](const Label& label) {
            return label.name == "ENDLABEL" && label.place.offset > begin->place.offset;
        });
        if (closing != all.end() &&
            (closing->place.offset < line_.offset || begin->place.offset > line_.offset))
            section.stop = behind(closing->place);
    }
    constexpr std::size_t kDeepest = 1000;
    if (section.stop <= section.begin.offset || frame().repeats.size() >= kDeepest)
        return fail(Message::LabelMissing, line_.whole(), {*first, " before this block"});
    if (*runs < 1.0) return true;
    section.remaining = static_cast<std::uint64_t>(std::min(*runs, 1e9)) - 1;
    count_repeats();
    const Place start = section.begin;
    frame().repeats.push_back(section);
    reader_->seek(start);
    return true;
}

/// Begins the next pass of REPEAT, or returns behind it.
/// Returns: true if the program continues at another place.
bool Runner::next_pass() {
    std::vector<Passage>& repeats = frame().repeats;
    if (repeats.empty() || reader_->place().offset != repeats.back().stop) return false;
    if (++repeated_ > most_blocks_) return false;  // The next block reports the limit.
    Passage& section = repeats.back();
    if (section.remaining > 0) {
        --section.remaining;
        reader_->seek(section.begin);
    } else {
        reader_->seek(section.back);
        repeats.pop_back();
    }
    return true;
}

}  // namespace ncsim::gcode::sinumerik
