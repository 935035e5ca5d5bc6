// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the index of pages.
#include "ncsim/report/page_index.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/version.h"
#include "ncsim/report/describe.h"
#include "ncsim/verify/machining_time.h"

#include "append.h"
#include "markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <string_view>
#include <tuple>
#include <vector>

namespace ncsim::report {

extern const std::string_view kPageStyle;
extern const std::string_view kIndexStyle;
extern const std::string_view kIndexScript;
extern const std::string_view kThemeScript;

namespace {

// Verdicts, the worst first.
constexpr std::array<std::string_view, 5> kVerdicts{"not-verified", "failed", "not-proven",
                                                    "accepted", "clean"};

std::size_t rank_of(std::string_view word) {
    return static_cast<std::size_t>(std::ranges::find(kVerdicts, word) - kVerdicts.begin());
}

struct Row {
    std::size_t rank = 0;
    std::uint64_t errors = 0;
    std::string html;
};

// Returns a cell with the value by which the script sorts; without a value, the row comes last.
std::string number_cell(std::string_view label, const std::string& value, const std::string& text) {
    return fmt::format(
        "<td role=\"cell\" class=\"number\" data-label=\"{}\" data-value=\"{}\">"
        "{}</td>",
        label, value, escaped(text));
}

std::string count_cell(std::string_view label, const IndexFacts* facts, std::uint64_t count) {
    const bool is_known = facts && facts->failure.empty();
    const std::string text = is_known ? std::to_string(count) : std::string();
    return number_cell(label, text, text);
}

std::string name_cell(const Entry& entry, const IndexFacts* facts) {
    const std::string program = entry.program.empty() ? "" : " (" + entry.program + ')';
    std::string name = escaped(relative_path(entry.path) + program);
    if (facts) name = fmt::format("<a href=\"{}\">{}</a>", escaped(facts->page), name);
    if (facts && !facts->failure.empty())
        append(name, "<small>{}</small>", escaped(facts->failure.substr(0, 300)));
    return "<th role=\"rowheader\" scope=\"row\" class=\"name\">" + name + "</th>";
}

Row row_of(const Entry& entry, const IndexFacts* facts, LengthUnit unit) {
    Row row{rank_of(entry.word), facts ? facts->errors : 0, {}};
    std::string picture;
    if (facts && !facts->picture.empty()) {
        picture = fmt::format(
            "<img loading=\"lazy\" width=\"100\" height=\"75\" alt=\"part of {}\" src=\"{}\">",
            escaped(base_name(entry.path)), escaped(facts->picture));
    }
    std::string seconds, time, volume, removed;
    if (facts && facts->seconds) {
        seconds = fmt::format("{:.3f}", *facts->seconds);
        time = verify::time_text(*facts->seconds);
    }
    if (facts && facts->removed_mm3) {
        volume = fmt::format("{:.6g}", *facts->removed_mm3);
        removed = in_unit(volume_text(*facts->removed_mm3), unit);
    }
    row.html = fmt::format(
        "<tr role=\"row\" class=\"{0}\"><td role=\"cell\" class=\"picture\">{1}</td>{2}"
        "<td role=\"cell\" class=\"verdict\" data-value=\"{3}\"><span>{0}</span></td>",
        entry.word, picture, name_cell(entry, facts), row.rank);
    row.html += count_cell("errors", facts, facts ? facts->errors : 0) +
                count_cell("warnings", facts, facts ? facts->warnings : 0) +
                count_cell("doubts", facts, facts ? facts->doubts : 0) +
                number_cell("time", seconds, time) + number_cell("removed", volume, removed) +
                "</tr>\n";
    return row;
}

// Returns the heads of the columns. `data-sort` is the order of the first click.
std::string head_html() {
    struct Column {
        const char *name, *sort;
    };
    constexpr Column kColumns[] = {{"Program", "ascending"}, {"Verdict", "ascending"},
                                   {"Errors", "descending"}, {"Warnings", "descending"},
                                   {"Doubts", "descending"}, {"Time", "descending"},
                                   {"Removed", "descending"}};
    std::string text =
        "<thead role=\"rowgroup\"><tr role=\"row\">"
        "<th role=\"columnheader\" scope=\"col\" class=\"picture\">Part</th>";
    for (const Column& column : kColumns) {
        append(text, "<th role=\"columnheader\" scope=\"col\"{} data-sort=\"{}\"{}>{}</th>",
               &column - kColumns > 1 ? " class=\"number\"" : "", column.sort,
               std::string_view(column.name) == "Verdict" ? " aria-sort=\"ascending\"" : "",
               column.name);
    }
    return text + "</tr></thead>\n";
}

std::string scope_html(const Scope& scope) {
    std::string text;
    if (!scope.called.empty()) text += "<section><h2>Judged with a caller</h2><ul>\n";
    for (const CalledFile& file : scope.called)
        append(text, "<li>{} (with {})</li>\n", escaped(relative_path(file.path)),
               escaped(relative_path(file.caller)));
    if (!scope.called.empty()) text += "</ul></section>\n";
    if (!scope.excluded.empty()) text += "<section><h2>Left out</h2><ul>\n";
    for (const ExcludedEntry& file : scope.excluded)
        append(text, "<li>{}: {}</li>\n", escaped(relative_path(file.path)), escaped(file.why));
    if (!scope.excluded.empty()) text += "</ul></section>\n";
    return text;
}

// Returns the rows, the worst verdict and the most errors first, and counts their verdicts.
std::vector<Row> rows_of(const Entries& all,
                         const std::function<const IndexFacts*(const Entry&)>& facts,
                         LengthUnit unit, std::map<std::string, std::size_t>& words) {
    std::vector<Row> rows;
    all([&](const Entry& entry) {
        ++words[entry.word];
        rows.push_back(row_of(entry, facts(entry), unit));
    });
    std::ranges::stable_sort(rows, [](const Row& a, const Row& b) {
        return std::tuple(a.rank, b.errors) < std::tuple(b.rank, a.errors);
    });
    return rows;
}

}  // namespace

IndexFacts index_facts(const Checked& checked) {
    IndexFacts facts;
    facts.failure = checked.failure;
    facts.errors = checked.verdict.count(verify::Severity::Error);
    facts.warnings = checked.verdict.count(verify::Severity::Warning);
    facts.doubts = checked.verdict.open_doubts();
    facts.seconds = checked.seconds;
    const verify::Ledger& ledger = checked.verdict.ledger;
    if (checked.simulated && ledger.measured) facts.removed_mm3 = ledger.removed_mm3;
    return facts;
}

void write_page_index(std::ostream& out, const Entries& all,
                      const std::function<const IndexFacts*(const Entry&)>& facts,
                      const Scope& scope, LengthUnit unit) {
    std::map<std::string, std::size_t> words;
    const std::vector<Row> rows = rows_of(all, facts, unit, words);
    std::string counts, table;
    for (const char* word : {"clean", "accepted", "not-proven", "failed", "not-verified"}) {
        if (words[word] > 0) append(counts, ", {} {}", words[word], word);
    }
    for (const Row& row : rows)
        table += row.html;
    const std::string worst(rows.empty() ? "clean" : kVerdicts.at(rows.front().rank));
    out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>ncsim check</title>\n"
           "<style>\n"
        << kPageStyle << kIndexStyle << "</style></head>\n<body>\n"
        << valid_utf8(fmt::format(
               "<header class=\"{}\"><h1>ncsim check: {} program{}{}</h1><p>ncsim {}</p></header>\n"
               "<main class=\"index\">\n<section><div id=\"search\"></div>\n"
               "<table id=\"programs\" role=\"table\" aria-label=\"programs\">\n{}"
               "<tbody role=\"rowgroup\">\n{}</tbody></table></section>\n{}</main>\n",
               worst, rows.size(), rows.size() == 1 ? "" : "s", counts, kVersion, head_html(),
               table, scope_html(scope)))
        << "<script>\n"
        << kThemeScript << "</script>\n<script>\n"
        << kIndexScript << "</script>\n</body></html>\n";
}

}  // namespace ncsim::report
