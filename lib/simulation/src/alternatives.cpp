// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readings of a program that could change the verdict, and their comparison.
#include "alternatives.h"

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/gcode/parser.h"
#include "ncsim/simulation/verification_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>

namespace ncsim::simulation {

namespace {

verify::Place place_of(const gcode::ProgramPlace& place) {
    return {place.file, place.span};
}

// Key of a finding: rule, file, line.
using FindingKey = std::tuple<std::string, std::uint32_t, std::uint32_t>;

FindingKey row_of(const verify::Finding& finding) {
    return {finding.rule, finding.place.file, finding.place.span.line};
}

bool is_serious(const verify::Finding& finding) {
    return finding.severity != verify::Severity::Note && finding.counts();
}

// Returns the most severe finding of `of` missing in `other`, or null.
const verify::Finding* missing_finding(const verify::Verdict& of, const verify::Verdict& other) {
    std::set<FindingKey> known;
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

// Returns the first rapid move in several axes whose box comes near the stock or a fixture, or
// null. Only such moves can meet a body on one path and miss the body on the second.
const ProgramFacts::SlantingRapid* first_rapid_near_bodies(
    const Survey& survey, const VerificationOptions& verification_options) {
    if (!survey.is_ready()) return nullptr;
    std::vector<Box> bodies{survey.stock->box};
    for (const verify::Fixture& fixture : verification_options.machine.machine.fixtures)
        bodies.push_back(fixture.place());
    const double radius = widest_radius(survey);
    const auto is_near = [radius](const Box& rapid, const Box& body) {
        for (int axis = 0; axis < 2; ++axis) {
            if (rapid.max[axis] + radius <= body.min[axis] ||
                rapid.min[axis] - radius >= body.max[axis])
                return false;
        }
        return rapid.min.z < body.max.z;
    };
    for (const auto& rapid : survey.slanting_rapids) {
        const bool meets =
            std::ranges::any_of(bodies, [&](const Box& body) { return is_near(rapid.box, body); });
        if (meets) return &rapid;
    }
    return nullptr;
}

// Order-dependent hash of the ends of motions.
class MotionHash {
public:
    void take(const gcode::Motion& motion) {
        const gcode::Position* to = gcode::end_of(motion);
        if (!to) return;
        add(static_cast<std::uint64_t>(motion.kind));
        add(static_cast<std::uint64_t>(motion.tool));
        add(motion.action.index());
        for (const double value :
             {to->x.mm(), to->y.mm(), to->z.mm(), to->a.degrees(), to->b.degrees(), to->c.degrees(),
              to->u.mm(), to->v.mm(), to->w.mm()})
            add(std::bit_cast<std::uint64_t>(value));
        if (const auto* arc = std::get_if<gcode::Arc>(&motion.action)) {
            for (const double value : {arc->centre_1.mm(), arc->centre_2.mm()})
                add(std::bit_cast<std::uint64_t>(value));
            add(static_cast<std::uint64_t>(arc->turns));
        }
    }
    std::uint64_t value() const { return value_; }

private:
    void add(std::uint64_t item) {
        constexpr std::uint64_t kPrime = 0x100000001b3;  // FNV-1a, 64 bits
        value_ = (value_ ^ item) * kPrime;
        value_ ^= value_ >> 29;
    }
    std::uint64_t value_ = 0xcbf29ce484222325;
};

// Codes of warnings and errors.
std::set<std::string> objections(const gcode::Diagnostics& diagnostics) {
    std::set<std::string> codes;
    for (const gcode::Diagnostic& d : diagnostics) {
        if (d.severity != gcode::Severity::Note) codes.insert(d.code);
    }
    return codes;
}

// Returns the hash of the motions of the program as `control` executes it. Empty if that control
// objects to more than `accepted`, because then the program was not written for that control.
std::optional<std::uint64_t> motions_on(const Plan& plan, gcode::Dialect control,
                                        const std::set<std::string>& accepted) {
    gcode::InterpreterOptions options = plan.job.interpreter;
    options.dialect = control;
    MotionHash hash;
    const gcode::Interpretation read = gcode::interpret(
        plan.job.program, options, [&](const gcode::Motion& motion) { hash.take(motion); });
    if (read.stopped || read.refused ||
        !std::ranges::includes(accepted, objections(read.diagnostics)))
        return std::nullopt;
    return hash.value();
}

// Adds the controls on which the program moves differently, if neither the user nor the program
// names a control.
void add_other_controls(const Plan& plan, const gcode::Interpretation& read,
                        std::vector<Alternative>& found) {
    const bool is_named = read.dialect.stated || !read.dialect.evidence.empty();
    if (is_named || !read.control_dependent || plan.job.interpreter.strict ||
        gcode::has_errors(read.diagnostics))
        return;
    const std::set<std::string> accepted = objections(read.diagnostics);
    std::set<std::optional<std::uint64_t>> known{std::nullopt};
    known.insert(motions_on(plan, gcode::Dialect::Auto, accepted));
    for (const gcode::Dialect control :
         {gcode::Dialect::Rs274, gcode::Dialect::Fanuc, gcode::Dialect::Haas}) {
        if (!known.insert(motions_on(plan, control, accepted)).second) continue;
        found.push_back({"control-guess",
                         fmt::format("on a control such as {}", gcode::name_of(control)),
                         place_of(*read.control_dependent),
                         [control](Plan& other, VerificationOptions&) {
                             other.job.interpreter.dialect = control;
                         },
                         true});
    }
}

// Switches of block delete, as bits: '/' and "/1" are bit 1, "/9" is bit 9.
using Switches = std::uint32_t;

// Returns the switches of the slashes that begin at `at` in `text`, as in "/1/3", and moves `at`
// behind them.
Switches switches_at(std::string_view text, std::size_t& at) {
    Switches found = 0;
    const auto skip_blanks = [&] { at = std::min(text.find_first_not_of(" \t", at), text.size()); };
    while (at < text.size() && text[at] == '/') {
        ++at;
        skip_blanks();
        const bool has_number = at < text.size() && text[at] >= '1' && text[at] <= '9';
        found |= 1U << (has_number ? text[at] - '0' : 1);
        if (has_number) ++at;
        skip_blanks();
    }
    return found;
}

// Calls `take(begin, end, switches)` for the slashes of each block of `program` that has some.
template <typename Take>
void for_each_deletable(const gcode::SourceFile& program, bool strict, const Take& take) {
    gcode::BlockReader reader(program, {.strict = strict});
    gcode::Block block;
    std::size_t begin = reader.place().offset;
    while (reader.next(block)) {
        if (block.deletable.length > 0) {
            const std::size_t slash = begin + block.deletable.column - 1;
            std::size_t end = slash;
            const Switches switches = switches_at(program.text, end);
            take(slash, end, switches);
        }
        begin = reader.place().offset;
    }
}

// Returns `program` in which only blocks of `switches` have a slash.
std::string with_slashes_of(const gcode::SourceFile& program, bool strict, Switches switches) {
    std::string text = program.text;
    for_each_deletable(program, strict, [&](std::size_t begin, std::size_t end, Switches of_block) {
        if ((of_block & switches) != 0) return;
        std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin),
                  text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    });
    return text;
}

// Adds readings with a part of the switches of block delete on, if the program uses several
// switches: all combinations of two or three switches; if there are more switches, each switch
// alone.
void add_single_switches(const Plan& plan, verify::Place place, std::vector<Alternative>& found) {
    constexpr int kMostCombined = 3;
    const bool strict = plan.job.interpreter.strict;
    Switches all = 0;
    for_each_deletable(plan.job.program, strict,
                       [&](std::size_t, std::size_t, Switches of_block) { all |= of_block; });
    const int count = std::popcount(all);
    if (count < 2) return;
    for (Switches on = (all - 1) & all; on != 0; on = (on - 1) & all) {
        if (count > kMostCombined && std::popcount(on) > 1) continue;
        std::string names;
        for (unsigned number = 1; number <= 9; ++number) {
            if ((on >> number & 1U) != 0)
                names += fmt::format("{}/{}", names.empty() ? "" : ", ", number);
        }
        found.push_back({"block-delete", fmt::format("with only the blocks of {} skipped", names),
                         place, [strict, on](Plan& other, VerificationOptions&) {
                             other.job.program.text =
                                 with_slashes_of(other.job.program, strict, on);
                             other.job.options.block_delete = true;
                             other.job.interpreter.block_delete = true;
                         }});
    }
}

std::string described(const verify::Finding& finding) {
    return fmt::format("{} in line {}", finding.rule, finding.place.span.line);
}

}  // namespace

std::vector<Alternative> alternatives_of(const Plan& plan, const Survey& survey,
                                         const VerificationOptions& verification_options) {
    std::vector<Alternative> found;
    const setup::JobOptions& options = plan.job.options;
    const gcode::Interpretation& read = survey.interpretation;
    if (read.deletable && !options.block_delete) {
        found.push_back({"block-delete", "with blocks that start with '/' skipped",
                         place_of(*read.deletable), [](Plan& other, VerificationOptions&) {
                             other.job.options.block_delete = true;
                             other.job.interpreter.block_delete = true;
                         }});
        const gcode::Dialect dialect = read.dialect.dialect;
        if (dialect != gcode::Dialect::Heidenhain && dialect != gcode::Dialect::Sinumerik)
            add_single_switches(plan, place_of(*read.deletable), found);
    }
    if (read.without_point && read.has_points && !options.increments) {
        found.push_back({"decimal-point",
                         "with numbers without a decimal point as least increments",
                         place_of(*read.without_point),
                         [](Plan& other, VerificationOptions&) {
                             other.job.options.increments = true;
                             other.job.interpreter.least_increments = true;
                         },
                         true});
    }
    add_other_controls(plan, read, found);
    if (const auto* rapid = first_rapid_near_bodies(survey, verification_options);
        rapid && !verification_options.is_rapid_specified) {
        found.push_back(
            {"rapid-path",
             verification_options.dog_leg ? "with straight rapid moves"
                                          : "with rapid moves axis by axis (dog-leg)",
             {rapid->file, rapid->span},
             [](Plan&, VerificationOptions& other) { other.dog_leg = !other.dog_leg; }});
    }
    return found;
}

std::string difference(const Checked& verdict, const Checked& other) {
    if (const auto* f = missing_finding(other.verdict, verdict.verdict)) return described(*f);
    if (const auto* f = missing_finding(verdict.verdict, other.verdict))
        return "without " + described(*f);
    if (verdict.outcome == other.outcome) return {};
    for (const verify::Doubt& doubt : other.verdict.doubts) {
        if (!doubt.accepted) return fmt::format("{}, {}", other.word, doubt.reason);
    }
    return std::string(other.word);
}

namespace {

// True if the parts differ by a hundredth of the removed volume. Smaller differences are corners
// where compensation begins; a design decides whether these matter.
bool is_another_part(const Checked& verdict, double more_mm3) {
    constexpr double kLeastShare = 0.01;
    constexpr double kLeastVolume = 0.01;  // mm³
    const double removed = verdict.verdict.ledger.stock_mm3 - verdict.verdict.ledger.rest_mm3;
    return std::abs(more_mm3) > std::max(kLeastVolume, kLeastShare * removed);
}

}  // namespace

std::optional<verify::Doubt> doubt_from(const Checked& verdict, const Checked& other,
                                        const Alternative& alternative) {
    std::string found = difference(verdict, other);
    if (!found.empty()) {
        found = fmt::format("the verdict is another one {}: {}", alternative.message, found);
    } else if (alternative.compares_parts) {
        const double more = other.verdict.ledger.rest_mm3 - verdict.verdict.ledger.rest_mm3;
        if (is_another_part(verdict, more))
            found = fmt::format("the part is another one {}: {:.6g} mm3 {} are left",
                                alternative.message, std::abs(more), more > 0.0 ? "more" : "less");
    }
    if (found.empty()) return std::nullopt;
    verify::Doubt doubt;
    doubt.reason = alternative.reason;
    doubt.message = std::move(found);
    doubt.place = alternative.place;
    return doubt;
}

}  // namespace ncsim::simulation
