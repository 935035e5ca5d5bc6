// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contours of CYCLE72: subprograms and blocks between labels that are recorded, not executed.
#include "language/contour_recorder.h"
#include "sinumerik/sinumerik_runner.h"
#include "text/line_end.h"
#include "text/message.h"

#include <algorithm>

namespace ncsim::gcode::sinumerik {

/// Returns the place of the contour `name`: a program, or "FIRST:LAST", two labels of the program
/// that runs; nullopt after reporting an error. Reports a program that is missing.
std::optional<Runner::ContourSource> Runner::find_contour(const std::string& name,
                                                          SourceSpan span) {
    ContourSource source;
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos) {
        const std::optional<std::size_t> found = find_program(program_name(name));
        if (!found) {
            report_missing_program(name, span);
            return source;
        }
        source.is_found = true;
        source.program = *found;
        source.begin = programs_[*found].section.begin;
        return source;
    }
    const auto place_of = [&](std::string label) -> std::optional<Place> {
        std::erase_if(label, is_blank);
        const auto found = std::ranges::find(labels(), upper_of(label), &Label::name);
        if (found != labels().end()) return found->place;
        fail(Message::LabelMissing, span, {label, ""});
        return std::nullopt;
    };
    const std::optional<Place> first = place_of(name.substr(0, colon));
    const std::optional<Place> last = first ? place_of(name.substr(colon + 1)) : std::nullopt;
    if (!last) return std::nullopt;
    source.is_found = true;
    source.program = frame().program;
    source.begin = *first;
    Reader reader(*files_[program().file].source, *last);
    Line line;
    (void)reader.next(line);
    source.stop = reader.place().offset;
    return source;
}

/// Runs the contour `name` with a separate machine, and returns the moves in the plane without the
/// first move, which leads to the contour. Returns no moves after a report of a missing program.
std::optional<language::Pass> Runner::record_contour(const std::string& name, SourceSpan span) {
    const std::optional<ContourSource> source = find_contour(name, span);
    if (!source) return std::nullopt;
    if (!source->is_found) return language::Pass();
    const SourceFile& file = *files_[programs_[source->program].file].source;
    const auto is_of_file = [&](const Program& one) {
        return one.file == programs_[source->program].file;
    };
    // The programs of a file are in the order of the sections of the file.
    const auto first = std::ranges::find_if(programs_, is_of_file);
    const std::size_t section =
        source->program - static_cast<std::size_t>(first - programs_.begin());
    language::ContourRecorder recorder(control_.plane(), machine_.state().unit_mm());
    const MotionSink take = recorder.sink();
    Interpretation ignored;
    {
        Runner runner(file, options_, ways_, rules_, centres_, take, log_, ignored);
        runner.variables_ = variables_;
        runner.control_.begin_contour(control_);
        // A read of the file counts as an execution of all lines.
        runner.repeated_ = repeated_ + line_count(file.text);
        log_.set_file(&file == files_[0].source ? std::string() : file.name);
        const bool done = runner.run_contour(*source, section);
        repeated_ = std::max<std::uint64_t>(1, runner.repeated_);
        const SourceFile& own = *files_[program().file].source;
        log_.set_file(program().file == 0 ? std::string() : own.name);
        if (!done) return std::nullopt;
    }
    if (recorder.is_complete() && !recorder.contour().empty()) return recorder.contour();
    fail(Message::BlockNeeds, span, {name, "a line to a point, and lines or arcs behind"});
    return std::nullopt;
}

/// Runs the blocks of `source`, which is the program `own_program` of this runner.
bool Runner::run_contour(const ContourSource& source, std::size_t own_program) {
    Frame contour;
    contour.program = own_program;
    contour.back = reader_->place();
    frames_.push_back(std::move(contour));
    if (source.stop == 0) variables_.begin_program();
    const std::size_t end = program().section.end;
    reader_.emplace(*files_[0].source, source.begin, end);
    const auto is_running = [&] {
        if (source.stop == 0) return is_in_subprogram();
        return frames_.size() > 2 || reader_->place().offset < source.stop;
    };
    while (is_running() && is_in_subprogram()) {
        if (!step() || ended_) return false;
    }
    machine_.flush();
    path_.finish();
    return !machine_.stopped();
}

}  // namespace ncsim::gcode::sinumerik
