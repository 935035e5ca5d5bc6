// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a program: reads blocks, follows loops and calls, passes commands to Controller.
//
// runner.cpp has the execution of a block, o_words.cpp the control words of RS274/NGC, macro_b.cpp
// the control words of Fanuc Macro B, calls.cpp the common part: subprograms, files, call frames.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/parser.h"

#include "control/controller.h"
#include "control/system_variable.h"
#include "language/program_runner.h"
#include "program/block_resolver.h"
#include "program/head_modes.h"
#include "program/program_index.h"

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

namespace ncsim::gcode {

/// Runs a program in G-code.
class Runner final : public language::ProgramRunner {
public:
    Runner(const SourceFile& program, const InterpreterOptions& options, const Rules& rules,
           ArcCentres& centres, const MotionSink& sink, DiagnosticLog& log, Interpretation& result);

    void run();

private:
    struct OpenFile {
        const SourceFile* source = nullptr;
        std::unique_ptr<SourceFile> owned;  // Set for files other than the main program.
        BlockReader reader;
        std::unique_ptr<ProgramIndex> index;
    };
    enum class CallKind : std::uint8_t { OWord, Subprogram, Lines, Macro };
    struct Frame {
        CallKind kind = CallKind::OWord;
        std::string label;
        std::size_t file = 0;  // File to return to.
        BlockReader::Place back;
        std::size_t own_file = 0;     // File of the subprogram.
        BlockReader::Place start;     // Start of the subprogram, for repeats.
        std::uint64_t remaining = 0;  // Runs after the present run.
        bool has_locals = false;
        std::size_t local_count = 0;
        Parameters::Locals locals;
        std::size_t repeats = 0;  // Size of repeats_ at the call.
        // Modes saved by M70 and M73; null: none.
        std::shared_ptr<const Controller::SavedModes> modes;
        bool restores = false;  // M73: restores the modes at the return.
    };
    struct Repeat {
        std::string label;
        std::size_t file = 0;
        std::uint64_t remaining = 0;
    };
    struct Target {
        std::size_t file = 0;
        std::size_t marker = 0;
    };

    // Execution of a block
    bool step() override;
    void report_missing_end(std::uint32_t line) override;
    std::uint32_t last_line() const override { return block_.line; }
    std::uint32_t current_file() const override { return static_cast<std::uint32_t>(current_); }
    bool percent();
    bool is_first_text() const;
    bool assign(const Block& block);
    bool assign_number(const Assignment& assignment, double number, double value,
                       const std::string& unknown);
    void tool_change_in_comment();
    void act_on_words();
    void begin_data_lines();
    bool take_data_line();
    void execute_before(std::size_t count);
    void scale_increments();
    void check_points();
    bool counts_increments(const Word& word) const;
    void note_points();
    void note_blend();
    void note_control_dependent();
    void note_language();

    // Control words. Each function may seek, call or return.
    void o_word();
    bool check_sub(std::size_t i);
    bool check_label(std::size_t i);
    void o_branch(std::size_t i);
    void o_loop(std::size_t i);
    void o_leave(std::size_t i);
    void o_call();
    bool macro_word();  // Returns false if the rest of the block is to be skipped.
    void go_to(std::string_view label);
    void macro_call(int g);

    // Calls
    void save_or_restore(int m);
    bool call_code(int m);
    void call_subprogram();
    std::optional<Target> find_named_program(std::string_view name);
    std::optional<std::string_view> name_in_comment() const;
    void call_program_file(std::string_view name);
    bool is_control_program(double number) const;
    void report_control_program(double number, SourceSpan span);
    bool probe_macro(int number, const std::array<double, Parameters::kLocals + 1>& values,
                     SourceSpan span);
    void execute_text(const std::string& text, SourceSpan span);
    void call_lines();
    bool record_outline();
    void return_from_subprogram();
    bool continue_at(double number, bool is_main);
    void enter(Frame frame, const Target& target);
    void finish_subprogram();
    std::optional<Target> find_target(ControlWord word, const std::string& label, bool in_files);
    std::optional<std::size_t> open_file(const std::string& name);

    OpenFile& file() { return files_[current_]; }
    ProgramIndex& index();
    std::optional<std::string> label_of(std::string_view label, SourceSpan span);
    std::optional<bool> condition(std::string_view text, SourceSpan span);
    bool jump(std::size_t file_number, BlockReader::Place place);
    void fault(const MessageText& message, SourceSpan span,
               std::initializer_list<std::string_view> arguments = {});

    const Rules& rules_;
    Resolver resolver_;
    HeadModes head_modes_;
    std::deque<OpenFile> files_;
    std::size_t current_ = 0;
    std::vector<Frame> frames_;
    std::vector<Repeat> repeats_;
    /// File and line of each subroutine definition that was reached.
    std::map<std::string, std::pair<std::size_t, std::uint32_t>> subs_;
    std::set<std::string> called_;  ///< Labels of the called subroutines.
    /// File and line of each control structure that was reached, by subroutine and label.
    std::map<std::pair<std::string, std::string>, std::pair<std::size_t, std::uint32_t>> labels_;
    std::shared_ptr<const Controller::SavedModes>
        main_modes_;  // Modes saved by M70 outside of calls.
    Block block_;
    Command command_;
    std::uint32_t else_if_line_ = 0;  // Line of an elseif that was reached by a jump.
    std::string modal_call_;          // G66: the block to execute after each move.
    std::size_t modal_level_ = 0;     // Call level of the G66.
    int data_lines_ = 0;              // L of the G10 whose lines of data end at G11; 0: none.
    bool is_native_ = false;          // Behind G290 of SINUMERIK.
    bool in_main_title_ = false;      // After "O1" of the main program.
    bool percent_opened_ = false;
    bool something_read_ = false;
    bool has_reported_points_ = false;
};

}  // namespace ncsim::gcode
