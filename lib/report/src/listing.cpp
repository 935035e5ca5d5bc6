// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks, motions and codes of a program, as text or JSON.
#include "ncsim/report/listing.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"
#include "ncsim/gcode/language.h"
#include "ncsim/gcode/print.h"

#include "json.h"
#include "motion_json.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace ncsim::report {

namespace {

// Passes text to a sink in chunks, so memory does not grow with the program.
class BufferedText {
public:
    explicit BufferedText(const TextSink& sink) : sink_(sink) {}
    void add(std::string_view line) {
        text_.append(line);
        if (text_.size() > (1U << 16)) flush();
    }
    void flush() {
        sink_(text_);
        text_.clear();
    }

private:
    const TextSink& sink_;
    std::string text_;
};

// Writes the elements of a JSON array, one a line, between a head and a tail.
class JsonLines {
public:
    JsonLines(const std::string& program, const char* name, const TextSink& sink) : out_(sink) {
        out_.add("{\"program\":" + to_line(program) + ",\"" + name + "\":[");
    }
    void add(const Json& element) {
        out_.add(first_ ? "\n" : ",\n");
        out_.add(to_line(element));
        first_ = false;
    }
    void finish(const gcode::Diagnostics& diagnostics) {
        out_.add("\n],\"findings\":" + to_line(findings_json(diagnostics)) + "}\n");
        out_.flush();
    }

private:
    BufferedText out_;
    bool first_ = true;
};

// Returns a word as blocks are printed: "G1" or "X[#1*2]".
std::string text_of(const gcode::Word& word) {
    std::string text;
    if (word.comma) text += ',';
    text += word.letter;
    if (word.literal) {
        gcode::print_number(text, word.number);
    } else {
        text.append(word.text);
    }
    return text;
}

Json to_json(const gcode::Block& block) {
    Json json{{"line", block.line}};
    std::string text;
    gcode::print(text, block);
    json["text"] = text;
    switch (block.kind) {
        case gcode::BlockKind::Words: json["kind"] = "words"; break;
        case gcode::BlockKind::Percent: json["kind"] = "percent"; break;
        case gcode::BlockKind::Command: json["kind"] = "command"; break;
        case gcode::BlockKind::Unreadable: json["kind"] = "unreadable"; break;
    }
    if (block.block_delete) json["block_delete"] = true;
    if (block.deletable.length > 0 && !block.block_delete)
        json["block_delete_from"] = block.deletable.column;
    if (block.has_number) json["number"] = block.number;
    for (const gcode::Word& word : block.words) {
        json["words"].push_back({{"text", text_of(word)}, {"column", word.span.column}});
    }
    for (const gcode::Assignment& a : block.assignments) {
        json["assignments"].push_back(
            {{"parameter", std::string(a.target)}, {"value", std::string(a.value)}});
    }
    for (const gcode::Comment& comment : block.comments) {
        json["comments"].push_back(std::string(comment.text));
    }
    return json;
}

}  // namespace

namespace {

/// Lists a program in a language other than G-code.
gcode::Diagnostics list_language(const gcode::SourceFile& program, gcode::ProgramListing& listing,
                                 bool as_json, const TextSink& sink) {
    gcode::DiagnosticLog log;
    const std::string kind(name_of(gcode::language_of(program)));
    gcode::ListedBlock line;
    if (as_json) {
        JsonLines out(base_name(program.name), "blocks", sink);
        while (listing.next(line, log)) {
            out.add({{"line", line.line},
                     {"text", line.text},
                     {"kind", line.is_readable ? kind : "unreadable"}});
        }
        out.finish(log.diagnostics());
        return log.take();
    }
    BufferedText out(sink);
    while (listing.next(line, log))
        out.add(fmt::format("L{} {}\n", line.line, one_line(line.text)));
    out.flush();
    return log.take();
}

}  // namespace

gcode::Diagnostics list_blocks(const gcode::SourceFile& program,
                               const gcode::ParserOptions& options, bool as_json,
                               const TextSink& sink) {
    if (const auto listing = options.strict ? nullptr : gcode::listing_of(program))
        return list_language(program, *listing, as_json, sink);
    gcode::DiagnosticLog log;
    gcode::BlockReader reader(program, options);
    gcode::Block block;
    if (as_json) {
        JsonLines out(base_name(program.name), "blocks", sink);
        while (reader.next(block, log)) {
            if (!block.text.empty()) out.add(to_json(block));
        }
        out.finish(log.diagnostics());
        return log.take();
    }
    BufferedText out(sink);
    std::string text;
    while (reader.next(block, log)) {
        text.assign("L").append(std::to_string(block.line)).append(1, ' ');
        const std::size_t head = text.size();
        gcode::print(text, block);
        if (text.size() == head) continue;
        out.add(one_line(text) + '\n');
    }
    out.flush();
    return log.take();
}

gcode::Diagnostics list_motions(const gcode::SourceFile& program,
                                const gcode::InterpreterOptions& options, bool as_json,
                                const TextSink& sink) {
    if (as_json) {
        JsonLines out(base_name(program.name), "motions", sink);
        auto result = gcode::interpret(program, options,
                                       [&out](const gcode::Motion& m) { out.add(to_json(m)); });
        out.finish(result.diagnostics);
        return std::move(result.diagnostics);
    }
    BufferedText out(sink);
    std::string text;
    auto result = gcode::interpret(program, options, [&](const gcode::Motion& motion) {
        text.clear();
        gcode::print(text, motion);
        text += '\n';
        out.add(text);
    });
    out.flush();
    return std::move(result.diagnostics);
}

MissingCodes list_missing_codes(const gcode::SourceFile& program,
                                const gcode::ControlCodes& control, bool as_json,
                                const TextSink& sink) {
    const std::vector<gcode::CodeUse> uses = gcode::missing_codes(program, control);
    const std::string name = base_name(program.name);
    MissingCodes count;
    for (const gcode::CodeUse& use : uses) {
        count.lacking += use.support == gcode::CodeSupport::No ? 1 : 0;
        count.unknown += use.support == gcode::CodeSupport::Unknown ? 1 : 0;
    }
    if (as_json) {
        Json lacks = Json::array(), options = Json::array(), unknown = Json::array();
        for (const gcode::CodeUse& use : uses) {
            (use.support == gcode::CodeSupport::No       ? lacks
             : use.support == gcode::CodeSupport::Option ? options
                                                         : unknown)
                .push_back({{"what", use.what},
                            {"line", use.first.line},
                            {"column", use.first.column},
                            {"count", use.count}});
        }
        sink(to_text({{"program", name},
                      {"control", control.title},
                      {"source", control.source},
                      {"list_is_complete", control.is_complete},
                      {"lacks", lacks},
                      {"options", options},
                      {"unknown", unknown}}));
        return count;
    }
    std::string text;
    const std::string file = one_line(program.name);
    for (const gcode::CodeUse& use : uses) {
        text += fmt::format(
            "{}:{}:{}: {}{}\n", file, use.first.line, use.first.column,
            use.support == gcode::CodeSupport::Option
                ? fmt::format("{} is an option of {}", use.what, control.title)
            : use.support == gcode::CodeSupport::Unknown
                ? fmt::format("{} cannot be judged", use.what)
            : control.is_complete
                ? fmt::format("{} has no {}", control.title, use.what)
                : fmt::format("{} is not in the list of codes of {}", use.what, control.title),
            use.count > 1 ? fmt::format(" ({} times)", use.count) : "");
    }
    if (count.lacking > 0) {
        text += fmt::format("{}: {} lacks {} of what this program uses; {}\n", file, control.title,
                            count.lacking, control.otherwise);
    } else if (count.unknown > 0) {
        text += fmt::format("{}: {} has all codes of this program that can be judged\n", file,
                            control.title);
    } else {
        text += fmt::format("{}: {} has all codes of this program\n", file, control.title);
    }
    text += fmt::format("source: {}{}\n", control.source,
                        control.is_complete ? "" : "; the list may have gaps");
    sink(text);
    return count;
}

}  // namespace ncsim::report
