// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a Klartext program: labels, repeats, calls, Q parameters, jumps. Blocks that act on the
// machine go to Control.
#pragma once

#include "ncsim/gcode/interpretation.h"

#include "klartext/control.h"
#include "klartext/q_parameters.h"
#include "klartext/reader.h"
#include "language/program_runner.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::klartext {

/// Runs a program.
class Runner final : public language::ProgramRunner {
public:
    Runner(const SourceFile& program, const InterpreterOptions& options, const Rules& rules,
           ArcCentres& centres, const MotionSink& sink, DiagnosticLog& log, Interpretation& result);

private:
    struct OpenFile {
        const SourceFile* source = nullptr;
        std::unique_ptr<SourceFile> owned;  // Set for files other than the main program.
        Reader reader;
        bool has_labels = false;
        std::map<std::string, Reader::Place> labels;  // Start of the block after each label.
    };
    /// A subprogram (CALL LBL) or a program (CALL PGM) that runs.
    struct Frame {
        bool is_program = false;
        std::string label;
        std::size_t file = 0;  // To return to.
        Reader::Place back;
        std::size_t repeats = 0;  // Size of repeats_ at the call.
        Parameters::Locals locals;
    };
    /// A CALL LBL with REP that runs.
    struct Repeat {
        std::size_t file = 0;
        Reader::Place call;
        std::string label;
        std::uint64_t remaining = 0;
    };

    bool step() override;
    std::uint32_t last_line() const override { return block_.line; }
    std::uint32_t current_file() const override { return static_cast<std::uint32_t>(current_); }
    bool act();
    bool begin_program();
    void finish_subprogram();
    bool path();
    bool approach();
    std::optional<Corner> corner_after(bool& is_refused);
    bool read_corner_feed(Corner& corner);
    bool assignment();
    bool assign_text(Scanner& scan);
    bool fn();
    bool arithmetic(Scanner& scan, std::uint32_t number);
    bool branch(Scanner& scan);
    bool system_read(Scanner& scan);
    bool call_label();
    bool call_program();
    std::optional<std::string> label_of(Scanner& scan);
    std::optional<Reader::Place> find_label(const std::string& label);
    bool jump_to(const std::string& label, SourceSpan span);
    void go(std::size_t file_number, Reader::Place place);
    bool enter(Frame frame, std::size_t file_number, Reader::Place place, SourceSpan span);
    std::optional<std::size_t> open_file(const std::string& name);
    bool refuse(std::string_view what);
    bool refuse_text();
    bool probes_tool();
    std::optional<Control::Contour> record_contour(const std::string& label, SourceSpan span);
    bool run_contour(const std::string& label, SourceSpan span);

    OpenFile& file() { return files_[current_]; }

    const Rules& rules_;
    ArcCentres& centres_;
    Parameters parameters_;
    Control control_;
    std::deque<OpenFile> files_;
    std::size_t current_ = 0;
    std::vector<Frame> frames_;
    std::vector<Repeat> repeats_;
    Block block_, next_;
    bool has_begun_ = false;  // After BEGIN PGM, or a block without BEGIN PGM.
    bool has_begin_ = false;  // The main program has BEGIN PGM.
};

}  // namespace ncsim::gcode::klartext
