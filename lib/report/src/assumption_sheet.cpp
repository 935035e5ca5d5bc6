// SPDX-License-Identifier: GPL-3.0-or-later
//
// The assumption sheet.
#include "ncsim/report/assumption_sheet.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"
#include "ncsim/report/describe.h"
#include "ncsim/report/value_source.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/verify/machine_description.h"

#include "append.h"

#include <fmt/format.h>

namespace ncsim::report {

namespace {

class Sheet {
public:
    template <typename... Args>
    void line(const char* key, fmt::format_string<Args...> format, Args&&... args) {
        append(text_, "  {:<11}", key);
        append(text_, format, std::forward<Args>(args)...);
        text_ += '\n';
    }
    // Does the same for a text of lengths.
    template <typename... Args>
    void lengths(const char* key, LengthUnit unit, fmt::format_string<Args...> format,
                 Args&&... args) {
        line(key, "{}", in_unit(fmt::format(format, std::forward<Args>(args)...), unit));
    }
    template <typename... Args>
    void title(fmt::format_string<Args...> format, Args&&... args) {
        append(text_, format, std::forward<Args>(args)...);
        text_ += '\n';
    }
    std::string text_;
};

std::string units(const simulation::ProgramFacts& program) {
    const char* name = program.interpretation.uses_inches ? "inches" : "millimetres";
    if (program.interpretation.units_stated) return fmt::format("{}, as the program says", name);
    if (!program.units_assumed) return fmt::format("{}, as specified", name);
    return fmt::format("{}, assumed: neither G20 nor G21 stands before the first length (--units)",
                       name);
}

std::string dialect(const simulation::ProgramFacts& program) {
    const gcode::DialectFindings& found = program.interpretation.dialect;
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

std::string assumption_sheet(const std::string& name, const simulation::ProgramFacts& program,
                             const CuttingFacts& cutting) {
    Sheet sheet;
    sheet.title("ncsim {}: {}, {} lines, {} moves", kVersion, one_line(name),
                program.interpretation.lines, program.moves);
    sheet.line("dialect", "{}", dialect(program));
    sheet.line("units", "{}", units(program));
    if (program.moves_without_start > 0) {
        const auto moves = program.moves_without_start;
        sheet.line("start", "unknown: the first {} nothing (--start X,Y,Z)",
                   moves == 1 ? "move cuts" : fmt::format("{} moves cut", moves));
    } else {
        sheet.line("start", "known");
    }
    for (std::size_t axis = 0; axis < program.unspecified.size(); ++axis) {
        if (program.unspecified[axis])
            sheet.line("", "assumed: {} 0, which the program never sets", "XYZ"[axis]);
    }
    if (program.uses_machine_coordinates) {
        sheet.lengths(
            "home", cutting.unit,
            "assumed: machine zero {:g} mm above the program zero, tool lengths 0 (G28, G30, G53)",
            verify::kHomeHeight);
    }
    if (program.turns_tools()) {
        sheet.line("rotation", "{}", program.rotation);
    }
    for (const auto& [number, used] : program.tools) {
        sheet.line(fmt::format("tool T{}", number).c_str(), "{}; {}",
                   tool_in_unit(toolpath::describe(used.tool), cutting.unit),
                   specified(used.specified_by, used.span, used.text, used.file, "--tool"));
        if (!used.assumed_values_text.empty())
            sheet.line("", "assumed: {}", in_unit(used.assumed_values_text, cutting.unit));
    }
    if (program.stock) {
        sheet.line("stock", "{}", in_unit(describe(*program.stock), cutting.unit));
        sheet.line("", "{}",
                   specified(program.stock->specified_by, program.stock->span, program.stock->text,
                             program.stock->file, "--stock"));
        if (program.stock->place_assumed) {
            sheet.line("",
                       "assumed: where it lies; a corner or the middle is at zero, as the cuts "
                       "have it");
        }
        if (program.stock->shape) {
            for (const std::string& assumed : program.stock->shape->assumed)
                sheet.line("", "assumed by the run that left it: {}", one_line(assumed));
        }
        sheet.line("model", "{}, lattice unit {:g} nm", cutting.model,
                   toolpath::stock_lattice(*program.stock).unit_mm * 1e6);
        if (cutting.is_model_chosen)
            sheet.line("", "rays, as a draft of {} moves; --model cda is exact", program.moves);
        if (cutting.resolution > 0.0) {
            sheet.lengths(
                "", cutting.unit,
                "rays {:.3g} mm apart{}: what is thinner may be missing, nothing is exact",
                cutting.resolution, cutting.has_rays_along_z_alone ? ", along Z alone" : "");
        }
    }
    sheet.lengths("tolerance", cutting.unit,
                  "arcs {:g} mm; round tools {:g} mm; rotary moves {:g} mm missed, {:g} mm gained",
                  cutting.tolerance, cutting.tool_tolerance, cutting.tolerance,
                  10 * cutting.tolerance);
    if (cutting.join_tolerance > 0.0) {
        sheet.lengths("draft", cutting.unit,
                      "coarse: tolerances grow with the block; moves in a row within {:g} mm of "
                      "a line are one",
                      cutting.join_tolerance);
    }
    if (cutting.is_draft_exact)
        sheet.line("draft", "exact: the program is short; only unspecified tools are guessed");
    return sheet.text_;
}

}  // namespace ncsim::report
