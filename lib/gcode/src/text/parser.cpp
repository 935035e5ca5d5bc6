// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads lines, and keeps parsed lines of loops.
#include "ncsim/gcode/parser.h"

#include "text/line_end.h"
#include "text/line_parser.h"

#include <unordered_map>

namespace ncsim::gcode {

namespace {

void reset(Block& block, std::uint32_t line, std::string_view text) {
    block.kind = BlockKind::Words;
    block.line = line;
    block.block_delete = false;
    block.program_name = {};
    block.deletable = {};
    block.has_number = false;
    block.number = 0;
    block.control = {};
    block.words.clear();
    block.assignments.clear();
    block.comments.clear();
    block.text = text;
}

}  // namespace

BlockReader::BlockReader(const SourceFile& file, ParserOptions options)
    : file_(&file), options_(options) {
    place_.offset = file.text.size() - after_byte_order_mark(file.text).size();
}

std::string_view BlockReader::take_line() {
    const std::string_view rest = std::string_view(file_->text).substr(place_.offset);
    const LineEnd end = find_line_end(rest);
    place_.offset += end.next;
    ++place_.line;
    return rest.substr(0, end.length);
}

/// Parsed lines. The text of a program is constant, so a parsed line stays valid.
struct BlockReader::LineCache {
    /// Largest total size of kept lines, above the size of loops in real programs.
    static constexpr std::size_t kMostBytes = 131'072;
    struct Line {
        std::string clean;
        bool is_kept = false;  ///< False: the line is parsed again, into `clean`.
        Block block;
        Place after;
    };
    std::unordered_map<std::size_t, Line> lines;
    std::size_t bytes = 0;

    /// Returns the entry of the line that begins at `start`; nullptr if there is no room.
    Line* at(std::size_t start, std::size_t size) {
        if (const auto known = lines.find(start); known != lines.end()) return &known->second;
        if (lines.size() >= kMostKept || bytes + size > kMostBytes) return nullptr;
        bytes += size;
        return &lines[start];
    }
};

void BlockReader::keep_lines() {
    if (!kept_) kept_ = std::make_shared<LineCache>();
}

bool BlockReader::next(Block& block, DiagnosticLog* log) {
    if (place_.offset >= file_->text.size()) return false;
    const std::size_t start = place_.offset;
    if (kept_) {
        const auto known = kept_->lines.find(start);
        if (known != kept_->lines.end() && known->second.is_kept) {
            block = known->second.block;
            place_ = known->second.after;
            return true;
        }
    }
    const std::string_view line = take_line();
    reset(block, place_.line, line);
    LineParser parser(options_, columns_, line, block, log);
    if (parser.read_plain()) return true;
    LineCache::Line* const kept = kept_ ? kept_->at(start, line.size()) : nullptr;
    parser.read_general(kept ? kept->clean : clean_);
    if (kept && !parser.has_fault()) {
        kept->is_kept = true;
        kept->block = block;
        kept->after = place_;
    }
    return true;
}

int tool_called_in(const Comment& comment) {
    constexpr std::size_t kLongest = 20;
    if (comment.text.size() > kLongest ||
        comment.text.find_first_of("Mm") == std::string_view::npos)
        return -1;
    const SourceFile inside{{}, std::string(comment.text)};
    Block block;
    if (!BlockReader(inside).next(block) || block.words.size() != 2) return -1;
    const Word* change = find_word(block, 'M');
    const Word* tool = find_word(block, 'T');
    const bool is_change = change && tool && change->number == 6.0 && tool->literal &&
                           tool->number >= 0.0 && tool->number < 1e8;
    return is_change ? static_cast<int>(tool->number) : -1;
}

}  // namespace ncsim::gcode
