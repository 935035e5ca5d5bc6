// SPDX-License-Identifier: GPL-3.0-or-later
//
// Replaces deleted blocks by blanks.
#include "ncsim/gcode/executed_text.h"

#include "ncsim/base/ascii.h"
#include "ncsim/gcode/parser.h"

#include "klartext/reader.h"
#include "sinumerik/line_reader.h"
#include "text/line_end.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {
namespace {

/// A part of a text, in bytes.
struct Range {
    std::size_t begin = 0, end = 0;
    bool contains(std::size_t at) const { return at >= begin && at < end; }
};

/// A block to replace by blanks, except the part `kept`.
struct DeletedBlock {
    Range block, kept;
};
using DeletedBlocks = std::vector<DeletedBlock>;

/// Returns the block number of a line that begins at `begin`, with its N: "N100" of "/N100 G0";
/// an empty range if there is none.
Range number_of(std::string_view line, std::size_t begin) {
    std::size_t at = line.find_first_not_of(std::string_view(" \t\0/0123456789", 14));
    if (at == std::string_view::npos || upper(line[at]) != 'N') return {};
    const std::size_t first = at++;
    while (at < line.size() && is_blank(line[at]))
        ++at;
    const std::size_t digits = at;
    while (at < line.size() && is_digit(line[at]))
        ++at;
    return at > digits ? Range{begin + first, begin + at} : Range{};
}

DeletedBlocks find_in_gcode(const SourceFile& file, bool strict) {
    DeletedBlocks found;
    BlockReader reader(file, {.strict = strict});
    Block block;
    BlockReader::Place place = reader.place();
    const std::string_view text = file.text;
    while (place.offset < text.size()) {
        const LineEnd end = find_line_end(text.substr(place.offset));
        const std::string_view line = text.substr(place.offset, end.length);
        if (line.find('/') != std::string_view::npos) {
            reader.seek(place);
            reader.next(block);
            if (block.deletable.length > 0) {
                const std::size_t slash = place.offset + block.deletable.column - 1;
                found.push_back(
                    {{slash, place.offset + end.length}, number_of(line, place.offset)});
            }
        }
        place = {place.offset + end.next, place.line + 1};
    }
    return found;
}

DeletedBlocks find_in_klartext(const SourceFile& file) {
    DeletedBlocks found;
    klartext::Reader reader(file);
    klartext::Block block;
    std::size_t begin = reader.place().offset;
    while (reader.next_verb(block)) {
        const std::size_t end = reader.place().offset;
        if (block.block_delete) found.push_back({{begin, end}, {}});
        begin = end;
    }
    return found;
}

DeletedBlocks find_in_sinumerik(const SourceFile& file) {
    DeletedBlocks found;
    sinumerik::Reader reader(file);
    sinumerik::Line line;
    const auto begin_of = [&](std::string_view part) {
        return static_cast<std::size_t>(part.data() - file.text.data());
    };
    while (reader.next(line)) {
        if (!line.block_delete) continue;
        const std::size_t code = begin_of(line.code);
        // The label ends with the colon in front of the code.
        const std::size_t label = line.label.empty() ? code : begin_of(line.label);
        const std::size_t number = line.number.empty() ? label : begin_of(line.number);
        found.push_back({{line.offset, label}, {number, number + line.number.size()}});
        found.push_back({{code, reader.place().offset}, {}});
    }
    return found;
}

DeletedBlocks find_deleted(const SourceFile& file, Language language, bool strict) {
    if (file.text.find('/') == std::string::npos) return {};
    switch (language) {
        case Language::GCode: break;
        case Language::Klartext: return find_in_klartext(file);
        case Language::Sinumerik: return find_in_sinumerik(file);
    }
    return find_in_gcode(file, strict);
}

/// Replaces `deleted` in `text` by blanks. Line ends stay.
void blank(std::string& text, const DeletedBlocks& deleted) {
    for (const DeletedBlock& one : deleted) {
        for (std::size_t at = one.block.begin; at < one.block.end; ++at) {
            const bool is_kept = text[at] == '\n' || text[at] == '\r' || one.kept.contains(at);
            if (!is_kept) text[at] = ' ';
        }
    }
}

/// Returns the language in which interpret() reads `program`.
Language language_read(const SourceFile& program, const InterpreterOptions& options) {
    if (options.strict) return Language::GCode;
    switch (options.dialect) {
        case Dialect::Auto: break;
        case Dialect::Heidenhain: return Language::Klartext;
        case Dialect::Sinumerik: return Language::Sinumerik;
        default: return Language::GCode;
    }
    if (!options.of_file) return language_of(program);
    switch (options.of_file->kind) {
        case Kind::Heidenhain: return Language::Klartext;
        case Kind::Siemens: return Language::Sinumerik;
        default: return Language::GCode;
    }
}

}  // namespace

void remove_deleted_blocks(SourceFile& file, Language language, bool strict) {
    blank(file.text, find_deleted(file, language, strict));
}

ExecutedText::ExecutedText(const SourceFile& program, const InterpreterOptions& options)
    : program_(&program) {
    if (!options.block_delete) return;
    language_ = language_read(program, options);
    const DeletedBlocks deleted = find_deleted(program, language_, options.strict);
    if (deleted.empty()) return;
    blank(without_deleted_.emplace(program).text, deleted);
}

}  // namespace ncsim::gcode
