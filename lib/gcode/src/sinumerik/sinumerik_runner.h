// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a SINUMERIK program: statements, jumps, loops, repeats, subprograms, modal calls. Blocks
// that act on the machine go to Control.
#pragma once

#include "ncsim/gcode/interpretation.h"

#include "language/program_runner.h"
#include "sinumerik/formula.h"
#include "sinumerik/line_reader.h"
#include "sinumerik/sinumerik_control.h"
#include "sinumerik/variables.h"
#include "sinumerik/words.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::gcode::sinumerik {

/// Returns the names of tools that the program selects by name, in the order of the first one.
std::vector<std::string> tool_names(const SourceFile& program);

/// Returns the name of a program in `path`: "/_N_CUS_DIR/_N_L320_SPF" is "L320".
std::string program_name(std::string_view path);

/// Runs a program.
class Runner final : public language::ProgramRunner {
public:
    Runner(const SourceFile& program, const InterpreterOptions& options,
           const std::array<RotaryWay, 3>& ways, const Rules& rules, ArcCentres& centres,
           const MotionSink& sink, DiagnosticLog& log, Interpretation& result);

private:
    struct File {
        const SourceFile* source = nullptr;
        std::unique_ptr<SourceFile> owned;  // Set for files other than the main program.
        std::vector<Section> sections;
    };
    /// A label or a block number, with the start of its line.
    struct Label {
        std::string name;
        Place place;
    };
    /// A program of a file.
    struct Program {
        std::size_t file = 0;
        Section section;
        bool has_labels = false;
        std::vector<Label> labels;
        // Ends of structures, by the start and whether ELSE ends them.
        std::map<std::pair<std::size_t, bool>, std::optional<Place>> ends;
    };
    enum class LoopKind : std::uint8_t { For, While, Loop, Repeat };
    struct Loop {
        LoopKind kind = LoopKind::Loop;
        Place header, body;
        Target counter;
        double last = 0.0;
    };
    /// Blocks that REPEAT runs again.
    struct Passage {
        Place begin;
        std::size_t stop = 0;  // Offset of the first line behind the blocks.
        Place back;
        std::uint64_t remaining = 0;
    };
    struct Argument {
        std::optional<Value> value;
        std::optional<Target> target;  // For parameters with VAR.
    };
    /// A modal call (MCALL).
    struct Modal {
        bool is_active = false;
        bool is_cycle = false;
        CycleCall cycle;
        std::string program;
        std::vector<Argument> arguments;
        SourceSpan span;  // Place of the block with MCALL.
    };
    /// A program that runs.
    struct Frame {
        std::size_t program = 0;
        std::string name;
        Place back;  // In the program that called.
        std::vector<Loop> loops;
        std::vector<Passage> repeats;
        std::vector<Argument> arguments;
        std::vector<std::pair<std::string, Target>> copies;  // Copies of parameters with VAR.
        std::uint64_t runs_left = 0;                         // Remaining executions of "L100 P3".
        std::optional<SavedModes> saved;
        Modal modal;
        std::deque<HolePlace> places;  // Places of a pattern, for a modal subprogram.
        SourceSpan places_span;
    };

    bool step() override;
    std::uint32_t last_line() const override { return line_.line; }
    std::uint32_t current_file() const override {
        return static_cast<std::uint32_t>(programs_[frames_.back().program].file);
    }
    bool act();
    bool statement(std::string_view name, CodeScanner& scan, bool& is_done);
    bool flow_statement(std::string_view name, CodeScanner& scan, bool& is_flow);
    bool return_statement(CodeScanner& scan, SourceSpan span);
    bool call_statement(std::string_view name, CodeScanner& scan, SourceSpan span);
    bool items(CodeScanner& scan);
    bool item(CodeScanner& scan, Words& words, bool& has_words);
    bool finish_block(const Words& words, SourceSpan span);
    bool end_main_program();
    bool assign(CodeScanner& scan);
    bool skip_call(CodeScanner& scan);
    bool named_call(std::string_view raw, CodeScanner& scan, bool is_first);
    bool built_in(const std::string& name, CodeScanner& scan, bool is_modal, bool& is_known);
    bool define(CodeScanner& scan);
    bool define_one(Type type, std::uint32_t length, CodeScanner& scan);
    bool frame_statement(std::string_view name, CodeScanner& scan);
    bool is_at_end(CodeScanner& scan);

    // Jumps and loops.
    bool condition(CodeScanner& scan, bool& is_true);
    bool if_statement(CodeScanner& scan);
    bool jump(std::string_view kind, CodeScanner& scan);
    bool case_statement(CodeScanner& scan);
    std::optional<std::string> jump_target(CodeScanner& scan);
    bool go_to(std::string_view kind, const std::string& label);
    const std::vector<Label>& labels();
    bool loop_statement(std::string_view name, CodeScanner& scan);
    bool end_loop(std::string_view name, CodeScanner& scan);
    bool for_loop(CodeScanner& scan);
    bool repeat_section(std::string_view name, CodeScanner& scan);
    std::optional<Place> end_of_structure(Place after, std::string_view name, bool stops_at_else);
    bool skip_to_end(std::string_view name, bool stops_at_else);
    void leave_structures(std::size_t offset);
    bool next_pass();

    // Calls.
    bool proc(CodeScanner& scan);
    bool modal(CodeScanner& scan);
    bool call_modal();
    void show_modal();
    std::optional<std::vector<Argument>> arguments(CodeScanner& scan);
    std::optional<Arguments> cycle_arguments(CodeScanner& scan);
    bool call(const std::string& name, std::vector<Argument> arguments, double runs,
              SourceSpan span);
    std::optional<std::size_t> find_program(const std::string& name);
    std::optional<std::size_t> program_of(std::size_t file, const std::string& name);
    bool finish_program();
    std::optional<double> take_runs(CodeScanner& scan);

    // Contours of cycles.
    struct ContourSource {
        bool is_found = false;
        std::size_t program = 0;
        Place begin;
        std::size_t stop = 0;  ///< Offset of the first line behind the contour; 0: to its end.
    };
    std::optional<ContourSource> find_contour(const std::string& name, SourceSpan span);
    std::optional<language::Pass> record_contour(const std::string& name, SourceSpan span);
    bool run_contour(const ContourSource& source, std::size_t own_program);

    bool refuse_text(std::size_t at);
    void seek(Place place);

    Frame& frame() { return frames_.back(); }
    Program& program() { return programs_[frame().program]; }
    bool is_in_subprogram() const { return frames_.size() > 1; }

    const std::array<RotaryWay, 3>& ways_;
    const Rules& rules_;
    ArcCentres& centres_;
    Control control_;
    Variables variables_;
    Expressions expressions_;
    WordReader words_;
    std::deque<File> files_;
    std::deque<Program> programs_;
    std::vector<Frame> frames_;
    std::optional<Reader> reader_;
    Line line_, ahead_;
};

}  // namespace ncsim::gcode::sinumerik
