// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes two programs side by side.
#include "program_diff.h"

#include "append.h"
#include "line_diff.h"
#include "markup.h"
#include "source_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace ncsim::report {

namespace {

constexpr std::size_t kContext = 3;      // equal lines next to lines that differ
constexpr std::size_t kLeastFolded = 6;  // shorter stretches stay open
// Limits of a page, in rows: text in folds, and rows in the open.
constexpr std::size_t kMostFolded = 5000;
constexpr std::size_t kMostShown = 20000;
constexpr std::size_t kMostLength = 400;  // longer lines are cut, bytes
constexpr std::size_t kMostMarks = 3;     // marks of a line

bool begins_character(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
}

// Returns the number of bytes of whole characters, at most `most`.
std::size_t whole_characters(std::string_view text, std::size_t most) {
    if (text.size() <= most) return text.size();
    while (most > 0 && !begins_character(text[most]))
        --most;
    return most;
}

std::string line_html(std::string_view line) {
    const std::size_t shown = whole_characters(line, kMostLength);
    return escaped(line.substr(0, shown)) + (shown < line.size() ? "…" : "");
}

// Returns the line with the part marked that differs from `other`.
std::string changed_html(std::string_view line, std::string_view other) {
    if (line.size() > kMostLength || other.size() > kMostLength) return line_html(line);
    std::size_t front =
        static_cast<std::size_t>(std::ranges::mismatch(line, other).in1 - line.begin());
    front = whole_characters(line, front);
    const std::size_t most = std::min(line.size(), other.size()) - front;
    std::size_t back = 0;
    while (back < most && line[line.size() - 1 - back] == other[other.size() - 1 - back])
        ++back;
    while (back > 0 && !begins_character(line[line.size() - back]))
        --back;
    const std::string_view middle = line.substr(front, line.size() - front - back);
    // Lines with little in common differ as a whole.
    if (3 * (front + back) < std::max(line.size(), other.size()) || middle.empty())
        return line_html(line);
    return escaped(line.substr(0, front)) + "<mark>" + escaped(middle) + "</mark>" +
           escaped(line.substr(line.size() - back));
}

// One of the programs, with the state of its lines.
struct Side {
    Side(const MarkedProgram& program, char id)
        : lines(lines_of(program.source)),
          marks(program.marks),
          open(program.open_lines.begin(), program.open_lines.end()),
          shown(lines.size() + 1),
          letter(id) {}

    std::vector<std::string_view> lines;
    const std::vector<LineMark>& marks;
    std::set<std::uint32_t> open;
    std::vector<bool> shown;
    char letter;
};

class Writer {
public:
    Writer(const MarkedProgram& old_program, const MarkedProgram& new_program,
           const std::string& prefix)
        : old_(old_program, 'o'), new_(new_program, 'n'), prefix_(prefix) {}

    ProgramDiff write() {
        const std::vector<LineStretch> stretches = compare_lines(old_.lines, new_.lines);
        ProgramDiff diff;
        for (const LineStretch& stretch : stretches) {
            if (!stretch.equal) {
                diff.removed += stretch.old_count;
                diff.added += stretch.new_count;
            }
            if (is_cut_) continue;
            if (stretch.equal) {
                put_equal(stretch);
            } else {
                put_different(stretch);
            }
        }
        close_table();
        if (is_cut_) text_ += "<p class=\"fold\">The following lines are not shown.</p>\n";
        diff.html = std::move(text_);
        diff.shown_old = std::move(old_.shown);
        diff.shown_new = std::move(new_.shown);
        return diff;
    }

private:
    using Place = std::optional<std::size_t>;  // line from 0; empty: no line

    void open_table() {
        if (is_open_) return;
        text_ +=
            "<table class=\"diff\"><colgroup><col class=\"no\"><col><col class=\"no\"><col>"
            "</colgroup>\n";
        is_open_ = true;
    }
    void close_table() {
        if (is_open_) text_ += "</table>\n";
        is_open_ = false;
    }

    // Writes the number of a line, with links to the regions that the line made.
    void put_number(Side& side, Place place) {
        if (!place) {
            text_ += "<td class=\"no\"></td>";
            return;
        }
        const auto number = static_cast<std::uint32_t>(*place + 1);
        side.shown[number] = true;
        append(text_, "<td class=\"no\" id=\"{}{}-{}\">", prefix_, side.letter, number);
        std::size_t count = 0;
        for (const LineMark& mark : side.marks) {
            if (number < mark.first || number > mark.last || count == kMostMarks) continue;
            append(text_, "<a class=\"region\" href=\"#{}r-{}\" title=\"difference {}\">{}</a>",
                   prefix_, mark.region, mark.region, mark.region);
            ++count;
        }
        append(text_, "{}</td>", number);
    }

    void put_row(Place x, Place y, bool equal) {
        open_table();
        text_ += equal ? "<tr>" : "<tr class=\"changed\">";
        put_number(old_, x);
        const std::string_view a = x ? old_.lines[*x] : std::string_view();
        const std::string_view b = y ? new_.lines[*y] : std::string_view();
        const bool is_pair = !equal && x && y;
        if (equal) {
            append(text_, "<td>{}</td>", line_html(a));
        } else if (x) {
            append(text_, "<td class=\"old\"><del>{}</del></td>",
                   is_pair ? changed_html(a, b) : line_html(a));
        } else {
            text_ += "<td class=\"none\"></td>";
        }
        put_number(new_, y);
        if (equal) {
            append(text_, "<td>{}</td>", line_html(b));
        } else if (y) {
            append(text_, "<td class=\"new\"><ins>{}</ins></td>",
                   is_pair ? changed_html(b, a) : line_html(b));
        } else {
            text_ += "<td class=\"none\"></td>";
        }
        text_ += "</tr>\n";
    }

    // Counts a row in the open; false if the page has no room for the row.
    bool has_room() {
        is_cut_ = rows_ == kMostShown;
        if (!is_cut_) ++rows_;
        return !is_cut_;
    }

    void put_different(const LineStretch& s) {
        for (std::size_t i = 0; i < std::max(s.old_count, s.new_count); ++i) {
            if (!has_room()) return;
            put_row(i < s.old_count ? Place(s.old_first + i) : std::nullopt,
                    i < s.new_count ? Place(s.new_first + i) : std::nullopt, false);
        }
    }

    // Writes `count` equal lines from line `first` of the stretch, folded or in the open.
    void put_lines(const LineStretch& s, std::size_t first, std::size_t count, bool is_folded) {
        is_folded &= count >= kLeastFolded;
        const bool has_text = !is_folded || folded_ + count <= kMostFolded;
        if (is_folded) {
            close_table();
            const char* const tag = has_text ? "summary" : "p";
            append(text_, "{}<{} class=\"fold\">{} equal lines</{}>\n", has_text ? "<details>" : "",
                   tag, count, tag);
            if (has_text) folded_ += count;
        }
        for (std::size_t i = first; has_text && i < first + count; ++i) {
            if (!is_folded && !has_room()) return;
            put_row(s.old_first + i, s.new_first + i, true);
        }
        if (is_folded && has_text) {
            close_table();
            text_ += "</details>\n";
        }
    }

    void put_equal(const LineStretch& s) {
        const std::size_t count = s.old_count;
        std::vector<bool> is_open(count);
        const auto open_around = [&](std::size_t i, std::size_t reach) {
            for (std::size_t j = i - std::min(i, reach); j < std::min(i + reach + 1, count); ++j)
                is_open[j] = true;
        };
        const bool is_begin = s.old_first + s.new_first == 0;
        const bool is_end =
            s.old_first + count == old_.lines.size() && s.new_first + count == new_.lines.size();
        if (!is_begin) open_around(0, kContext - 1);
        if (!is_end) open_around(count - 1, kContext - 1);
        open_marked(old_.open, s.old_first, count, open_around);
        open_marked(new_.open, s.new_first, count, open_around);
        for (std::size_t first = 0; first < count && !is_cut_;) {
            std::size_t end = first;
            while (end < count && is_open[end] == is_open[first])
                ++end;
            put_lines(s, first, end - first, !is_open[first]);
            first = end;
        }
    }

    // Opens the lines of the stretch that must not be folded.
    template <class Open>
    static void open_marked(const std::set<std::uint32_t>& lines, std::size_t first,
                            std::size_t count, const Open& open_around) {
        for (auto line = lines.upper_bound(static_cast<std::uint32_t>(first));
             line != lines.end() && *line <= first + count; ++line)
            open_around(*line - 1 - first, 1);
    }

    Side old_, new_;
    const std::string& prefix_;
    std::string text_;
    bool is_open_ = false;
    bool is_cut_ = false;  // The following lines are not shown.
    std::size_t rows_ = 0, folded_ = 0;
};

}  // namespace

ProgramDiff program_diff(const MarkedProgram& old_program, const MarkedProgram& new_program,
                         const std::string& prefix) {
    return Writer(old_program, new_program, prefix).write();
}

}  // namespace ncsim::report
