// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides a file into sections at O numbers and decides which sections are programs.
#include "ncsim/gcode/file_programs.h"

#include "ncsim/base/ascii.h"
#include "ncsim/gcode/parser.h"

#include "program/program_index.h"
#include "text/line_end.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

namespace {

constexpr std::string_view kAxes = "XYZABCUVW";

/// Returns the position of the first 'M' or 'm' of M2, M02 or M30 in `text`, from `from` on; npos:
/// none.
std::size_t find_end(std::string_view text, std::size_t from) {
    constexpr auto kNone = std::string_view::npos;
    std::size_t upper = text.find('M', from);
    std::size_t lower = text.find('m', from);
    while (upper != kNone || lower != kNone) {
        const std::size_t at = std::min(upper, lower);
        // Digits, possibly separated by blanks.
        int number = 0;
        for (std::size_t i = at + 1; i < text.size() && number < 100; ++i) {
            if (text[i] == ' ' || text[i] == '\t') continue;
            if (text[i] < '0' || text[i] > '9') break;
            number = 10 * number + (text[i] - '0');
        }
        if (number == 2 || number == 30) return at;
        (at == upper ? upper : lower) = text.find(text[at], at + 1);
    }
    return kNone;
}

/// Returns the number of lines that begin with O or a colon after blanks and '/'; at most `enough`.
std::size_t count_heads(std::string_view text, std::size_t enough) {
    std::size_t heads = 0;
    for (const char letter : {'O', 'o', ':'}) {
        for (std::size_t at = text.find(letter); at != std::string_view::npos && heads < enough;
             at = text.find(letter, at + 1)) {
            const std::size_t before = text.find_last_not_of(std::string_view(" \t\0/", 4), at - 1);
            const bool is_first = at == 0 || before == std::string_view::npos ||
                                  text[before] == '\n' || text[before] == '\r';
            if (is_first) ++heads;
        }
    }
    return heads;
}

/// True if the file must be read block by block: it has two O numbers, or words after an end.
bool may_hold_more(std::string_view text) {
    text = after_byte_order_mark(text);
    if (count_heads(text, 2) > 1) return true;
    // End: M2, M30, or the second '%'.
    std::size_t end = find_end(text, 0);
    std::size_t closings = 0;
    for (std::size_t at = text.find('%'); at < end && at != std::string_view::npos;
         at = text.find('%', at + 1)) {
        if (++closings > 1) end = at;
    }
    if (end == std::string_view::npos) return false;
    text.remove_prefix(end);
    text.remove_prefix(find_line_end(text).next);
    while (!text.empty()) {
        const LineEnd line_end = find_line_end(text);
        const std::string_view line = text.substr(0, line_end.length);
        text.remove_prefix(line_end.next);
        const std::size_t at = line.find_first_not_of(std::string_view(" \t\0/", 4));
        if (at == std::string_view::npos || line[at] == '%') continue;
        if (line.find_first_of("0123456789", at) != std::string_view::npos) return true;
    }
    return false;
}

bool is_literal(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool has_code(const Block& block, char letter, double number) {
    return std::ranges::any_of(block.words, [&](const Word& word) {
        return word.letter == letter && word.literal && word.number == number;
    });
}

/// Returns the numbers of programs of which `block` calls the first that exists: "101"; for P30101
/// also "101", with three runs. Empty if there is no call. Sets `any` if the number is computed.
std::vector<std::string> called_programs(const Block& block, bool& any) {
    const bool calls = has_code(block, 'M', 98) || has_code(block, 'G', 65) ||
                       has_code(block, 'G', 66) || has_code(block, 'G', 150);
    if (!block.program_name.empty()) return {lowercase(block.program_name)};
    const Word* p = calls ? find_word(block, 'P') : nullptr;
    if (!p) return {};
    if (!p->literal || !(p->number >= 0.0 && p->number < 1e9)) {
        any = true;
        return {};
    }
    constexpr long kNumbers = 10'000;
    const long number = std::lround(p->number);
    std::vector<std::string> numbers{std::to_string(number)};
    if (number >= kNumbers && has_code(block, 'M', 98) && !find_word(block, 'L'))
        numbers.push_back(std::to_string(number % kNumbers));
    return numbers;
}

bool is_join(ControlWord word) {
    return word != ControlWord::None && word != ControlWord::ProgramNumber &&
           word != ControlWord::Goto && word != ControlWord::If;
}

}  // namespace

/// Numbers of lines that blocks name.
struct NamedLines {
    std::set<std::uint32_t> lines;
    bool any = false;  ///< The number of a line is computed.

    bool operator==(const NamedLines&) const = default;

    bool contains(std::uint32_t number) const { return any || lines.contains(number); }

    void add(const Block& block, char letter) {
        const Word* word = find_word(block, letter);
        if (!word) return;
        if (!word->literal) any = true;
        if (word->literal && word->number >= 0.0 && word->number < 4e9)
            lines.insert(static_cast<std::uint32_t>(word->number));
    }
};

/// Lines at which execution can continue: a jump names a line of its own section, M99 P a line of
/// any section.
struct NamedTargets {
    std::vector<NamedLines> of_sections;
    NamedLines of_returns;

    bool operator==(const NamedTargets&) const = default;

    bool contain(std::size_t section, std::uint32_t number) const {
        return of_returns.contains(number) ||
               (section < of_sections.size() && of_sections[section].contains(number));
    }

    void read(std::size_t section, const Block& block) {
        if (of_sections.size() <= section) of_sections.resize(section + 1);
        NamedLines& own = of_sections[section];
        const ControlWord control = block.control.word;
        const std::string_view label = block.control.label;
        if ((control == ControlWord::Goto || control == ControlWord::If) && !label.empty()) {
            if (is_literal(label)) {
                own.lines.insert(
                    static_cast<std::uint32_t>(std::stoull(std::string(label.substr(0, 9)))));
            } else {
                own.any = true;
            }
        }
        if (has_code(block, 'M', 97) || has_code(block, 'G', 150)) own.add(block, 'P');
        if (has_code(block, 'M', 99)) of_returns.add(block, 'P');
    }
};

/// Reads the blocks of a file into sections.
class FileReaderPass {
public:
    FileReaderPass(FilePrograms& programs, const SourceFile& file)
        : programs_(programs), file_(file) {}

    /// Reads the file until all targets of reached blocks count: a jump makes its target reached,
    /// which may contain further jumps.
    /// Returns: true if a call has a computed number.
    bool run() {
        constexpr int kMostPasses = 10;
        for (int i = 0; i < kMostPasses; ++i) {
            scan();
            if (named_ == targets_) break;
            targets_ = named_;
            takes_all_ = takes_all_ || i + 3 == kMostPasses;
        }
        for (const Call& call : calls_)
            programs_.sections_[call.section].calls.push_back(number_of(call));
        return calls_any_;
    }

private:
    /// A call in a section, with the possible numbers of the program.
    struct Call {
        std::size_t section;
        std::vector<std::string> numbers;
    };

    /// Returns the first number of `call` that is in the file; otherwise the first one.
    std::string number_of(const Call& call) const {
        const auto found = std::ranges::find_if(call.numbers, [&](const std::string& number) {
            return std::ranges::find(programs_.sections_, number, &FilePrograms::Section::number) !=
                   programs_.sections_.end();
        });
        return found == call.numbers.end() ? call.numbers.front() : *found;
    }

    FilePrograms::Section& last() { return programs_.sections_.back(); }

    /// Reads the file once, with the targets of the pass before.
    void scan() {
        programs_.sections_.assign(1, {});
        programs_.unreached_.clear();
        calls_.clear();
        named_ = {};
        subs_ = 0;
        has_stopped_ = false;
        end_line_ = 0;
        is_reached_ = true;
        is_reported_ = is_opened_ = has_words_ = calls_any_ = false;
        BlockReader reader(file_);
        Block block;
        std::size_t begin = reader.place().offset;
        while (reader.next(block)) {
            take(block, begin);
            begin = reader.place().offset;
        }
        last().end = file_.text.size();
    }

    void begin_section(const Block& block, std::size_t begin) {
        last().end = begin;
        last().runs_on = is_reached_;
        FilePrograms::Section& next = programs_.sections_.emplace_back();
        next.number = plain_label(block.control.label);
        const bool is_name = block.control.label.starts_with('<');
        next.label = (is_name ? "" : "O") + std::string(block.control.label);
        next.span = block.control.span;
        next.begin = begin;
        has_stopped_ = false;
        is_reached_ = true;
    }

    void take(const Block& block, std::size_t begin) {
        if (block.kind == BlockKind::Percent) return percent(block);
        if (block.kind != BlockKind::Words) return;
        const ControlWord control = block.control.word;
        if (control == ControlWord::Sub) ++subs_;
        if (control == ControlWord::EndSub && subs_ > 0) --subs_;
        if (control == ControlWord::ProgramNumber && subs_ == 0) begin_section(block, begin);
        const std::size_t section = programs_.sections_.size() - 1;
        const bool is_target = block.has_number && (targets_.contain(section, block.number) ||
                                                    named_.contain(section, block.number));
        if (is_target || is_join(control)) is_reached_ = true;
        if (is_reached_ || takes_all_) named_.read(section, block);
        if (subs_ > 0) return;
        has_words_ = has_words_ || !block.words.empty();
        act(block, control);
    }

    void act(const Block& block, ControlWord control) {
        FilePrograms::Section& section = last();
        section.has_words = section.has_words || !block.words.empty();
        if (std::vector<std::string> numbers = called_programs(block, calls_any_); !numbers.empty())
            calls_.push_back({programs_.sections_.size() - 1, std::move(numbers)});
        const bool moves = std::ranges::any_of(block.words, [](const Word& word) {
            return !word.comma && kAxes.find(word.letter) != std::string_view::npos;
        });
        if (moves) {
            const SourceSpan span = block.words.front().span;
            if (!section.first_move) section.first_move = span;
            if (!is_reached_ && !is_reported_) {
                programs_.unreached_.push_back({span, {}, end_line_});
                is_reported_ = true;
            }
        }
        const bool is_conditional = control == ControlWord::If;
        const bool ends = has_code(block, 'M', 2) || has_code(block, 'M', 30);
        const bool returns = has_code(block, 'M', 99);
        if (is_reached_) {
            section.ends = section.ends || ends;
            // M99 behind an end returns from lines that M97 calls.
            section.returns = section.returns || (returns && !has_stopped_);
        }
        has_stopped_ = has_stopped_ || (ends && !is_conditional && is_reached_);
        if ((ends || returns) && !is_conditional) stop(block.line);
    }

    /// Same rule as Runner::percent: the first '%' opens, a later '%' without text closes.
    void percent(const Block& block) {
        if (!has_words_ && !is_opened_) {
            is_opened_ = true;
            return;
        }
        const bool is_bare = block.text.find_first_not_of(" \t%") == std::string_view::npos;
        if (is_opened_ && is_bare && has_words_ && is_reached_) {
            last().ends = true;
            stop(block.line);
        }
    }

    void stop(std::uint32_t line) {
        if (!is_reached_) return;
        is_reached_ = false;
        is_reported_ = false;
        end_line_ = line;
    }

    FilePrograms& programs_;
    const SourceFile& file_;
    NamedTargets targets_;  // Targets of reached blocks, by the pass before.
    NamedTargets named_;    // Targets of reached blocks, by this pass.
    bool takes_all_ = false;
    bool has_stopped_ = false;  // The section has an end without a condition.
    bool calls_any_ = false;
    std::vector<Call> calls_;
    std::size_t subs_ = 0;
    bool is_reached_ = true;
    bool is_reported_ = false;
    bool is_opened_ = false;
    bool has_words_ = false;
    std::uint32_t end_line_ = 0;
};

FilePrograms::FilePrograms(const SourceFile& file) {
    if (may_hold_more(file.text)) {
        FileReaderPass pass(*this, file);
        divide(pass.run());
    }
    if (programs_.empty()) programs_.push_back({"program 1", {}});
}

/// Decides which sections are programs. A section whose execution continues includes the next
/// section.
void FilePrograms::divide(bool calls_anything) {
    std::set<std::string> called;
    for (const Section& section : sections_)
        called.insert(section.calls.begin(), section.calls.end());
    bool has_first = false;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        Section& section = sections_[i];
        const bool is_joined =
            i > 0 && sections_[i - 1].program != kNone && sections_[i - 1].runs_on;
        if (is_joined) {
            section.program = sections_[i - 1].program;
            // "%", comments, then the first O number.
            if (!sections_[i - 1].has_words && i == 1)
                programs_.back() = {section.label, section.span};
            continue;
        }
        const bool is_called = called.contains(section.number) && !section.number.empty();
        if (!has_first || (section.ends && !section.returns && !is_called)) {
            has_first = true;
            section.program = programs_.size();
            programs_.push_back(
                {section.label.empty() ? "program 1" : section.label, section.span});
        } else if (section.first_move && !is_called && !calls_anything) {
            unreached_.push_back({*section.first_move, section.label, 0});
        }
    }
}

std::string FilePrograms::text_of(std::size_t program, std::string text) const {
    if (programs_.size() < 2) return text;
    std::set<std::size_t> kept;
    std::set<std::string> called;
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t i = 0; i < sections_.size(); ++i) {
            const Section& section = sections_[i];
            const bool is_kept = section.program == program || section.program == kNone ||
                                 called.contains(section.number);
            if (!is_kept || !kept.insert(i).second) continue;
            called.insert(section.calls.begin(), section.calls.end());
            grows = true;
        }
    }
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        const std::string_view piece = std::string_view(text).substr(
            sections_[i].begin, sections_[i].end - sections_[i].begin);
        if (kept.contains(i) || (i == 0 && !sections_[0].has_words)) {
            result += piece;
        } else {
            std::ranges::copy_if(piece, std::back_inserter(result),
                                 [](char c) { return c == '\n' || c == '\r'; });
        }
    }
    return result;
}

}  // namespace ncsim::gcode
