// SPDX-License-Identifier: GPL-3.0-or-later
#include "alternatives.h"

#include "ncsim/simulation/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

namespace ncsim::simulation {

namespace {

verify::Place place_of(const gcode::ProgramPlace& place) {
    return {place.file, place.span};
}

// Key of a finding: rule, file, line.
using Row = std::tuple<std::string, std::uint32_t, std::uint32_t>;

Row row_of(const verify::Finding& finding) {
    return {finding.rule, finding.place.file, finding.place.span.line};
}

bool is_serious(const verify::Finding& finding) {
    return finding.severity != verify::Severity::Note && finding.counts();
}

// Returns: the most severe finding of `of` missing in `other`, or null.
const verify::Finding* missing_finding(const verify::Verdict& of, const verify::Verdict& other) {
    std::set<Row> known;
    for (const verify::Finding& f : other.findings) {
        if (is_serious(f)) known.insert(row_of(f));
    }
    const verify::Finding* worst = nullptr;
    for (const verify::Finding& f : of.findings) {
        if (!is_serious(f) || known.contains(row_of(f))) continue;
        if (!worst || f.severity > worst->severity) worst = &f;
    }
    return worst;
}

double widest_radius(const Survey& survey) {
    double radius = 0.0;
    for (const auto& [number, used] : survey.tools) {
        for (const toolpath::ToolPiece& piece : used.tool.pieces) {
            for (const toolpath::ProfilePoint& p : piece.profile)
                radius = std::max(radius, p.radius);
        }
    }
    return radius;
}

// Returns: the first rapid move in several axes whose box comes near the stock or a fixture; only
// such moves can meet a body on one path and miss it on the other. Null if there is none.
const report::ProgramFacts::SlantingRapid* first_rapid_near_bodies(const Survey& survey,
                                                                   const Questions& questions) {
    if (!survey.is_ready()) return nullptr;
    std::vector<cda::Box> bodies{survey.stock->box};
    for (const verify::Fixture& fixture : questions.machine.machine.fixtures)
        bodies.push_back(fixture.place());
    const double radius = widest_radius(survey);
    const auto is_near = [radius](const cda::Box& rapid, const cda::Box& body) {
        for (int axis = 0; axis < 2; ++axis) {
            if (rapid.max[axis] + radius <= body.min[axis] ||
                rapid.min[axis] - radius >= body.max[axis])
                return false;
        }
        return rapid.min.z < body.max.z;
    };
    for (const auto& rapid : survey.slanting_rapids) {
        const bool meets = std::ranges::any_of(
            bodies, [&](const cda::Box& body) { return is_near(rapid.box, body); });
        if (meets) return &rapid;
    }
    return nullptr;
}

std::string described(const verify::Finding& finding) {
    return fmt::format("{} in line {}", finding.rule, finding.place.span.line);
}

}  // namespace

std::vector<Alternative> alternatives_to(const Plan& plan, const Survey& survey,
                                         const Questions& questions) {
    std::vector<Alternative> found;
    const setup::JobOptions& options = plan.job.options;
    const gcode::Interpretation& read = survey.interpretation;
    if (read.deletable && !options.block_delete) {
        found.push_back({"block-delete", "with blocks that start with '/' skipped",
                         place_of(*read.deletable), [](Plan& other, Questions&) {
                             other.job.options.block_delete = true;
                             other.job.interpreter.block_delete = true;
                         }});
    }
    if (read.without_point && read.has_points && !options.increments) {
        found.push_back({"decimal-point",
                         "with numbers without a decimal point as least increments",
                         place_of(*read.without_point), [](Plan& other, Questions&) {
                             other.job.options.increments = true;
                             other.job.interpreter.least_increments = true;
                         }});
    }
    const bool is_guessed = !read.dialect.stated && read.dialect.evidence.empty();
    if (read.compensation_start && is_guessed && !plan.job.interpreter.strict) {
        found.push_back({"reading-guess", "with cutter compensation as Fanuc begins it",
                         place_of(*read.compensation_start), [](Plan& other, Questions&) {
                             other.job.interpreter.compensation_start =
                                 gcode::CompensationStart::SquareToNext;
                         }});
    }
    if (const auto* rapid = first_rapid_near_bodies(survey, questions);
        rapid && !questions.is_rapid_specified) {
        found.push_back({"rapid-path",
                         questions.dog_leg ? "with straight rapid moves"
                                           : "with rapid moves axis by axis (dog-leg)",
                         {rapid->file, rapid->span},
                         [](Plan&, Questions& other) { other.dog_leg = !other.dog_leg; }});
    }
    return found;
}

std::string difference(const report::Checked& verdict, const report::Checked& other) {
    if (const auto* f = missing_finding(other.verdict, verdict.verdict)) return described(*f);
    if (const auto* f = missing_finding(verdict.verdict, other.verdict))
        return "without " + described(*f);
    if (verdict.outcome == other.outcome) return {};
    for (const verify::Doubt& doubt : other.verdict.doubts) {
        if (!doubt.accepted) return fmt::format("{}, {}", other.word, doubt.reason);
    }
    return std::string(other.word);
}

std::optional<verify::Doubt> doubt_between(const report::Checked& verdict,
                                           const report::Checked& other,
                                           const Alternative& alternative) {
    const std::string found = difference(verdict, other);
    if (found.empty()) return std::nullopt;
    verify::Doubt doubt;
    doubt.reason = alternative.reason;
    doubt.message = fmt::format("the verdict is another one {}: {}", alternative.message, found);
    doubt.place = alternative.place;
    return doubt;
}

}  // namespace ncsim::simulation
