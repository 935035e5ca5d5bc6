// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the review of changed programs.
#include "ncsim/report/review_page.h"

#include "ncsim/base/file_names.h"
#include "ncsim/base/version.h"
#include "ncsim/report/describe.h"

#include "append.h"
#include "markup.h"
#include "page_arrays.h"
#include "program_diff.h"
#include "review_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string_view>
#include <utility>

namespace ncsim::report {

extern const std::string_view kPageStyle;
extern const std::string_view kReviewStyle;
extern const std::string_view kReviewScript;
extern const std::string_view kThemeScript;

namespace {

constexpr std::size_t kMostRanges = 6;  // of a region and a program
constexpr std::size_t kMostRuns = 20;   // of each program

std::string volume_html(double mm3, LengthUnit unit) {
    return escaped(in_unit(fmt::format("{:.6g} mm3", mm3), unit));
}

std::string name_html(const std::string& path) {
    return escaped(relative_path(path));
}

// HTML of a comparison.
class SetUpReview {
public:
    SetUpReview(const simulation::Review& review, std::string prefix, LengthUnit unit)
        : review_(review),
          prefix_(std::move(prefix)),
          unit_(unit),
          old_name_(name_html(review.difference.old_name)),
          new_name_(name_html(review.difference.new_name)),
          diff_(program_diff(marked(review.old_side, &simulation::ReviewRegion::old_lines, true),
                             marked(review.new_side, &simulation::ReviewRegion::new_lines, false),
                             prefix_)) {}

    std::string html() const {
        return pictures_html() + regions_html() + values_html() + process_html() + program_html();
    }

private:
    using Lines = std::vector<verify::LineRange>;

    MarkedProgram marked(const simulation::ReviewSide& side, Lines simulation::ReviewRegion::*lines,
                         bool is_old) const {
        MarkedProgram program{side.source, {}, {}};
        for (std::size_t i = 0; i < review_.regions.size(); ++i) {
            std::size_t listed = 0;
            for (const verify::LineRange& range : review_.regions[i].*lines) {
                if (range.file != 0) continue;
                program.marks.push_back({range.first, range.last, i + 1});
                if (listed++ < kMostRanges) program.open_lines.push_back(range.first);
            }
        }
        const auto& process = review_.difference.process;
        for (const ProcessDifference::Run& run : is_old ? process.only_old : process.only_new) {
            if (is_program(side, run.file)) program.open_lines.push_back(run.line);
        }
        return program;
    }

    bool is_program(const simulation::ReviewSide& side, const std::string& file) const {
        const Difference& d = review_.difference;
        return file == (&side == &review_.old_side ? d.old_name : d.new_name);
    }

    // Returns a number of a line, as a link if the page has the line.
    std::string line_link(char letter, std::uint32_t line, const std::string& text) const {
        const std::vector<bool>& shown = letter == 'o' ? diff_.shown_old : diff_.shown_new;
        if (line >= shown.size() || !shown[line]) return text;
        return fmt::format("<a href=\"#{}{}-{}\">{}</a>", prefix_, letter, line, text);
    }

    std::string lines_html(const simulation::ReviewSide& side, char letter,
                           const Lines& lines) const {
        std::string html;
        for (std::size_t i = 0; i < lines.size() && i < kMostRanges; ++i) {
            const verify::LineRange& range = lines[i];
            std::string text = std::to_string(range.first);
            if (range.last != range.first) append(text, "–{}", range.last);
            if (range.file == 0) {
                text = line_link(letter, range.first, text);
            } else if (range.file < side.files.size()) {
                text.insert(0, escaped(base_name(side.files[range.file])) + ':');
            }
            append(html, "{}{}", i == 0 ? "" : ", ", text);
        }
        if (lines.size() > kMostRanges) append(html, " and {} more", lines.size() - kMostRanges);
        return html;
    }

    std::string figure_html(const std::string& caption, const std::string& alt,
                            const std::string& png, const std::string& pins = {}) const {
        if (png.empty()) return {};
        return fmt::format(
            "<figure><div class=\"picture\"><img width=\"800\" height=\"600\" alt=\"{}\" "
            "src=\"data:image/png;base64,{}\">{}</div><figcaption>{}</figcaption></figure>\n",
            alt, base64(png), pins, caption);
    }

    std::string pins_html(const simulation::ReviewPicture& picture) const {
        std::string html;
        for (const simulation::ReviewPicture::Pin& pin : picture.pins) {
            append(html,
                   "<a class=\"region\" href=\"#{}r-{}\" title=\"difference {}\" "
                   "style=\"left:{:.2f}%;top:{:.2f}%\">{}</a>",
                   prefix_, pin.region + 1, pin.region + 1, 100 * pin.x, 100 * pin.y,
                   pin.region + 1);
        }
        return html;
    }

    std::string pictures_html() const {
        const Difference& d = review_.difference;
        std::string html = "<section><h2>Part</h2>\n";
        if (!d.stocks.empty()) append(html, "<p>{}</p>\n", escaped(in_unit(d.stocks, unit_)));
        if (d.same_motions) {
            html += "<p>Both programs make the same motions with the same tools.</p>\n";
        } else if (d.only_old.volume_mm3 == 0.0 && d.only_new.volume_mm3 == 0.0) {
            html += "<p>Both programs make the same part.</p>\n";
        } else {
            append(html,
                   "<p><span class=\"swatch old\"></span> only in {}: {} · "
                   "<span class=\"swatch new\"></span> only in {}: {}</p>\n",
                   old_name_, volume_html(d.only_old.volume_mm3, unit_), new_name_,
                   volume_html(d.only_new.volume_mm3, unit_));
        }
        // Each view is a row; the single pictures of equal parts share a row.
        const auto row = [](const std::string& figures) {
            return "<div class=\"views\">\n" + figures + "</div>\n";
        };
        std::string single;
        for (const simulation::ReviewPicture& picture : review_.pictures) {
            if (picture.after.empty()) {
                single += figure_html("both, " + picture.view, "old part, " + picture.view,
                                      picture.before);
                continue;
            }
            html += row(figure_html(fmt::format("before: {}, {}", old_name_, picture.view),
                                    "old part, " + picture.view, picture.before) +
                        figure_html(fmt::format("after: {}, {}", new_name_, picture.view),
                                    "new part, " + picture.view, picture.after) +
                        figure_html("difference, " + picture.view, "difference, " + picture.view,
                                    picture.difference, pins_html(picture)));
        }
        if (!single.empty()) html += row(single);
        return html + "</section>\n";
    }

    std::string region_html(std::size_t i) const {
        const simulation::ReviewRegion& region = review_.regions[i];
        std::string html = fmt::format(
            "<li id=\"{}r-{}\"><b><span class=\"swatch {}\"></span> {} only in {}</b>"
            "<small>within {}</small>",
            prefix_, i + 1, region.is_only_old ? "old" : "new",
            volume_html(region.volume_mm3, unit_), region.is_only_old ? old_name_ : new_name_,
            escaped(in_unit(describe(region.box), unit_)));
        const auto side = [&](const std::string& name, bool has_material,
                              const simulation::ReviewSide& lines_of, char letter,
                              const Lines& lines) {
            if (lines.empty() && !(has_material && region.has_stock_surface)) return;
            append(html, "<p>{} by {}: ", has_material ? "surface" : "removed", name);
            if (!lines.empty()) {
                const bool is_one = lines.size() == 1 && lines[0].first == lines[0].last;
                html += (is_one ? "line " : "lines ") + lines_html(lines_of, letter, lines);
            }
            if (has_material && region.has_stock_surface)
                html += lines.empty() ? "uncut stock" : ", and uncut stock";
            html += "</p>";
        };
        side(old_name_, region.is_only_old, review_.old_side, 'o', region.old_lines);
        side(new_name_, !region.is_only_old, review_.new_side, 'n', region.new_lines);
        return html + "</li>\n";
    }

    std::string regions_html() const {
        if (review_.regions.empty()) return {};
        std::string html = "<section><h2>Differences of the part</h2>\n<ol class=\"regions\">\n";
        for (std::size_t i = 0; i < review_.regions.size(); ++i)
            html += region_html(i);
        html += "</ol>\n";
        const Difference& d = review_.difference;
        const std::size_t all = d.only_old.regions.size() + d.only_new.regions.size();
        if (all > review_.regions.size())
            append(html, "<p>and {} smaller regions</p>\n", all - review_.regions.size());
        return html + "</section>\n";
    }

    std::string values_html() const {
        return "<section><h2>Values</h2>\n" + review_table(review_, unit_) + "</section>\n";
    }

    std::string runs_html(const simulation::ReviewSide& side, char letter,
                          const std::vector<ProcessDifference::Run>& runs) const {
        std::string html;
        for (std::size_t i = 0; i < runs.size() && i < kMostRuns; ++i) {
            const std::string place = name_html(runs[i].file) + ':' + std::to_string(runs[i].line);
            append(html, "<li class=\"{}\">{} {}: {}</li>\n", letter == 'o' ? "old" : "new",
                   letter == 'o' ? "−" : "+",
                   is_program(side, runs[i].file) ? line_link(letter, runs[i].line, place) : place,
                   escaped(in_unit(runs[i].condition, unit_)));
        }
        if (runs.size() > kMostRuns)
            append(html, "<li>and {} more</li>\n", runs.size() - kMostRuns);
        return html;
    }

    std::string process_html() const {
        const ProcessDifference& process = review_.difference.process;
        if (!process.differs()) return {};
        return "<section><h2>Feeds, speeds, coolant, tools and dwells</h2>\n<ul class=\"runs\">\n" +
               runs_html(review_.old_side, 'o', process.only_old) +
               runs_html(review_.new_side, 'n', process.only_new) + "</ul></section>\n";
    }

    std::string program_html() const {
        std::string html = "<section><h2>Program</h2>\n";
        if (diff_.removed + diff_.added == 0) {
            html += "<p>The texts are the same.</p>\n";
        } else {
            append(html, "<p>lines only in {}: {}; only in {}: {}</p>\n", old_name_, diff_.removed,
                   new_name_, diff_.added);
        }
        return html + diff_.html + "</section>\n";
    }

    const simulation::Review& review_;
    std::string prefix_;
    LengthUnit unit_;
    std::string old_name_, new_name_;
    ProgramDiff diff_;
};

std::string outcome_text(bool differs, bool other_process) {
    return std::string(differs ? "the parts differ" : "the same part") +
           (other_process ? ", the process differs" : "");
}

std::string names_of(const Difference& d) {
    return name_html(d.old_name) + " → " + name_html(d.new_name);
}

std::string header_of(const std::vector<simulation::Review>& reviews, LengthUnit unit) {
    const bool differs = std::ranges::any_of(
        reviews, [](const simulation::Review& review) { return review.difference.differs; });
    const bool other_process = std::ranges::any_of(reviews, [](const simulation::Review& review) {
        return review.difference.process.differs();
    });
    const Difference& first = reviews.front().difference;
    std::string html = fmt::format(
        "<header class=\"{}\"><h1>{}: {}</h1><p>ncsim diff · ncsim {}</p>",
        differs         ? "failed"
        : other_process ? "not-proven"
                        : "clean",
        reviews.size() == 1 ? names_of(first) : fmt::format("{} programs", reviews.size()),
        outcome_text(differs, other_process), kVersion);
    if (first.tolerance_mm3 > 0.0)
        append(html, "<p>permitted difference: {}</p>", volume_html(first.tolerance_mm3, unit));
    return html + "</header>\n";
}

}  // namespace

void write_review(std::ostream& out, const std::vector<simulation::Review>& reviews,
                  LengthUnit unit) {
    const Difference& first = reviews.front().difference;
    out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>"
        << valid_utf8(names_of(first)) << " · ncsim diff</title>\n<style>\n"
        << kPageStyle << kReviewStyle << "</style></head>\n<body>\n"
        << valid_utf8(header_of(reviews, unit)) << "<main class=\"review\">\n";
    for (std::size_t i = 0; i < reviews.size(); ++i) {
        const Difference& d = reviews[i].difference;
        if (!d.set_up.empty() || reviews.size() > 1) {
            out << valid_utf8(fmt::format("<h2 class=\"set-up\">{}{}{}: {}</h2>\n",
                                          escaped(d.set_up), d.set_up.empty() ? "" : ": ",
                                          names_of(d),
                                          outcome_text(d.differs, d.process.differs())));
        }
        out << valid_utf8(SetUpReview(reviews[i], fmt::format("s{}", i + 1), unit).html());
    }
    out << "</main>\n<script>\n"
        << kThemeScript << "</script>\n<script>\n"
        << kReviewScript << "</script>\n</body></html>\n";
}

}  // namespace ncsim::report
