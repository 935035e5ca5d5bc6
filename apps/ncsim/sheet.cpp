// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet.h"

#include "plain_text.h"
#include "version.h"

#include <fmt/format.h>

#include <iterator>

namespace ncsim::app {

namespace {

class Sheet {
public:
    template <typename... Args>
    void line(const char* key, fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), "  {:<11}", key);
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
        text_ += '\n';
    }
    template <typename... Args>
    void title(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
        text_ += '\n';
    }
    std::string text_;
};

std::string units(const Survey& survey) {
    const char* name = survey.interpretation.uses_inches ? "inches" : "millimetres";
    if (survey.interpretation.units_stated) return fmt::format("{}, as the program says", name);
    return fmt::format("{}, assumed: neither G20 nor G21 stands before the first length (--units)",
                       name);
}

std::string dialect(const Survey& survey) {
    const gcode::DialectFindings& found = survey.interpretation.dialect;
    std::string text(gcode::name_of(found.dialect));
    if (found.stated) return text;
    if (found.evidence.empty()) return text + ", assumed: nothing speaks for another";
    for (std::size_t i = 0; i < found.evidence.size() && i < 3; ++i) {
        text += fmt::format("{} {} (line {})", i == 0 ? ", because of" : ",",
                            one_line(found.evidence[i].text), found.evidence[i].line);
    }
    return text;
}

}  // namespace

std::string told(toolpath::ToldBy by, gcode::SourceSpan span, const std::string& text,
                 const std::string& file, const char* option) {
    switch (by) {
        case toolpath::ToldBy::Comment:
            return fmt::format("line {}: ({})", span.line, one_line(text));
        case toolpath::ToldBy::Option: return fmt::format("from {}", option);
        case toolpath::ToldBy::Table: {
            std::string where = "from " + one_line(file);
            if (span.line > 0) where += fmt::format(", line {}", span.line);
            return text.empty() ? where : fmt::format("{}: {}", where, one_line(text));
        }
        case toolpath::ToldBy::Assumption: break;
    }
    return fmt::format("assumed: {}", one_line(text));
}

std::string describe(const cda::Box& box) {
    const cda::Vec3 size = box.size();
    return fmt::format(
        "{:.6g} x {:.6g} x {:.6g} mm, X {:.6g} to {:.6g}, Y {:.6g} to {:.6g}, Z {:.6g} to {:.6g}",
        size.x, size.y, size.z, box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z);
}

std::string describe(const toolpath::Stock& stock) {
    constexpr const char* kBars[] = {"a round bar along X in ", "a round bar along Y in ",
                                     "a round bar in "};
    if (!stock.from) return (stock.is_round ? kBars[stock.axis] : "") + describe(stock.box);
    std::string text = fmt::format("{} in {}", base_name(stock.from->path), describe(stock.box));
    if (!stock.from->turn.empty()) text += ", turned " + stock.from->turn;
    return one_line(text);
}

std::string assumption_sheet(const Job& job, const Survey& survey) {
    Sheet sheet;
    sheet.title("ncsim {}: {}, {} lines, {} moves", kVersion, one_line(job.program.name),
                survey.interpretation.lines, survey.moves);
    sheet.line("dialect", "{}", dialect(survey));
    sheet.line("units", "{}", units(survey));
    if (survey.moves_from_nowhere > 0) {
        sheet.line("start", "not told: {} move{} until all of X, Y and Z are known leave no trace",
                   survey.moves_from_nowhere, survey.moves_from_nowhere == 1 ? "" : "s");
    } else {
        sheet.line("start", "known");
    }
    for (std::size_t axis = 0; axis < survey.untold.size(); ++axis) {
        if (survey.untold[axis])
            sheet.line("", "assumed: {} 0, since the program never tells it", "XYZ"[axis]);
    }
    if (survey.uses_machine_coordinates) {
        sheet.line(
            "home",
            "assumed: machine zero {:g} mm above the program zero, tool lengths 0 (G28, G30, G53)",
            kHomeHeight);
    }
    if (survey.turns_tools()) {
        sheet.line("rotation",
                   "assumed: A, B, C turn the tool about X, Y, Z through the program zero");
    }
    for (const auto& [number, used] : survey.tools) {
        sheet.line(fmt::format("tool T{}", number).c_str(), "{}; {}", describe(used.tool),
                   told(used.told_by, used.span, used.text, used.file, "--tool"));
        if (!used.filled_in.empty()) sheet.line("", "assumed: {}", used.filled_in);
    }
    if (survey.stock) {
        sheet.line("stock", "{}", describe(*survey.stock));
        sheet.line("", "{}",
                   told(survey.stock->told_by, survey.stock->span, survey.stock->text,
                        survey.stock->file, "--stock"));
        if (survey.stock->place_assumed) {
            sheet.line("",
                       "assumed: where it lies; a corner or the middle is at zero, as the cuts "
                       "have it");
        }
        sheet.line("model", "{}, lattice unit {:g} nm", job.options.model,
                   toolpath::stock_lattice(*survey.stock).unit_mm * 1e6);
    }
    sheet.line("tolerance",
               "arcs {:g} mm; round tools {:g} mm; turning tools {:g} mm missed, {:g} mm gained",
               job.options.tolerance, job.options.tool_tolerance, job.options.tolerance,
               10 * job.options.tolerance);
    if (job.options.join_tolerance > 0.0) {
        sheet.line("draft",
                   "coarse: tolerances grow with the block; moves in a row within {:g} mm of "
                   "a line are one",
                   job.options.join_tolerance);
    }
    return sheet.text_;
}

}  // namespace ncsim::app
