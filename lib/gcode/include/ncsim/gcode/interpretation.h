// SPDX-License-Identifier: GPL-3.0-or-later
//
// Input and output values of interpret().
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/joints.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/gcode/source.h"
#include "ncsim/gcode/state.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Units of a program before G20 and G21.
enum class DefaultUnits : std::uint8_t { Millimetres, Inches };

/// A tool in the tool table of the control. `offset` is the vector that G43 applies. Motions
/// describe the tip, so offsets only affect positions in machine coordinates.
struct ToolTableEntry {
    int number = 0;
    std::array<Length, 3> offset{};  ///< X, Y, Z.
    bool length_specified = false;   ///< `offset` is specified; otherwise `offset` is 0 by default.
    std::optional<Length> diameter;  ///< Diameter for G41 and G42.
    bool operator==(const ToolTableEntry&) const = default;
};

/// Callback that receives the state of the control after each block, and before the first one, with
/// line 0. `file`: index into Interpretation::files. Moves that cutter compensation or a corner
/// holds back are in the state already.
using StateObserver =
    std::function<void(std::uint32_t file, std::uint32_t line, const MachineState& state)>;

/// Callback that returns the text of a called program by the name in the call ("probe", "O1234"),
/// or nullopt. The library itself reads no files.
using FileReader = std::function<std::optional<SourceFile>(std::string_view name)>;

/// Limits at which a program without an end is stopped with a diagnostic.
struct Limits {
    /// Largest number of blocks that loops, calls and repeats execute again.
    std::uint64_t repeated_blocks = 4'000'000;
    std::uint32_t call_depth = 64;
};

/// Tool centre point control: the control keeps the tip in place while rotary axes turn. If rotary
/// axes are not at 0 when the mode begins, the position of the tip depends on the geometry of the
/// machine; without a JointSolver the position is unknown.
struct TipControl {
    /// M428 and similar codes, which each LinuxCNC configuration defines.
    std::map<int, Coordinates> m_codes;
    bool by_length_word = false;  ///< G43.4 begins tip control, G49 ends it.
    /// With G43.4, the frame of X Y Z turns with the table and is fixed to the table at axis
    /// positions 0, whatever the axis positions at G43.4 are. False: the frame is unspecified.
    bool frame_at_zero = false;
    std::vector<Coordinates> kinematics{};  ///< Kinematics of LinuxCNC's G12.1 Pn, by P.
    /// Meaning of X, Y and Z at the start of the program.
    Coordinates at_start = Coordinates::Axes;
    bool operator==(const TipControl&) const = default;
};

/// Parameters of the control for the position of parts on the table: the dynamic fixture offset of
/// Fanuc (G54.2 Pn), or the setting error of a part (G54.4 Pn).
struct TableOffsets {
    /// Offset of one number P.
    struct One {
        /// Vector from the zero of the coordinate system (for G54.2 usually the centre of the
        /// table) to the zero of the part, in machine coordinates, mm. Valid with the rotary axes
        /// at `at`.
        std::array<double, 3> offset{};
        std::array<double, 3> at{};  ///< Positions of A, B, C for which `offset` is given, degrees.
        /// G54.4: rotations of the part about the fixed axes X, then Y, then Z; degrees.
        std::array<double, 3> turns{};
        bool operator==(const One&) const = default;
    };
    std::map<int, One> by_number;
    /// True if the tool moves with the zero when the code or the table moves the zero; false if the
    /// tool stays and its coordinates change; empty if unspecified.
    std::optional<bool> moves;
    /// Rotary axes compensate rotations about X and Y, so the tool stays normal to the part.
    bool axes_take_turns = false;
    bool operator==(const TableOffsets&) const = default;
};

/// Interpretation of an absolute value of a rotary axis. An incremental value is the distance
/// itself.
enum class RotaryWay : std::uint8_t {
    Linear,    ///< Position on an unbounded line: 350 to 10 is -340 (LinuxCNC, Heidenhain).
    Shortest,  ///< Position on the circle by the shortest way: +20 (Fanuc, roll-over; M126).
    Sign,      ///< Absolute value: the position; sign: the direction (LinuxCNC's WRAPPED_ROTARY).
    Positive,  ///< Position on the circle, always in the positive direction.
};

/// M codes that clamp and release a rotary axis.
struct RotaryClamp {
    char letter = 'B';
    int clamp = 10, release = 11;
    bool operator==(const RotaryClamp&) const = default;
};

/// Settings of the control and of the machine for interpret().
struct InterpreterOptions {
    /// Units of programs without G20 and G21.
    DefaultUnits default_units = DefaultUnits::Millimetres;
    /// Origins of G54, G55 … G59.3 in machine coordinates at the start. The distance between an
    /// unspecified origin and another origin is unknown.
    std::array<Position, 9> work_offsets{};
    /// True for each system whose origin is specified.
    std::array<bool, 9> work_offsets_specified{};
    std::map<int, Position> extended_offsets;  ///< Specified origins of G54.1 Pn, by n.
    /// Position of the tool at the start of the program, in the coordinates of G54; an empty
    /// coordinate is unknown.
    std::array<std::optional<Length>, 3> start{};
    /// `start` is in machine coordinates. Otherwise `start` is in G54 as set at the first move; if
    /// the origin of G54 is unspecified, `start` is in the system of the first move.
    bool start_is_of_machine = false;
    /// Target positions of G28 and G30 in machine coordinates, until G28.1 and G30.1 set new
    /// positions.
    std::array<Position, 2> homes{};
    /// Reads the program and its subprograms without blocks that start with '/' (ExecutedText).
    bool block_delete = false;

    Dialect dialect = Dialect::Auto;
    /// Conclusions from the whole file, if the program is one of several in the file; null:
    /// concluded from the program.
    std::shared_ptr<const DialectFindings> of_file;
    /// Applies the rules of RS274/NGC as in LinuxCNC: a block that LinuxCNC refuses is an error.
    /// Otherwise the program runs as on the control it was written for, with warnings.
    bool strict = false;
    /// Harmless words, such as "G187", "M198", which the interpreter skips without a message.
    std::vector<std::string> allow;
    /// Numbers without a decimal point count least increments, as on older controls: 0.001 mm,
    /// 0.0001 inch, 0.001 degrees. Applies only to axis words, I J K, R and Q with plain numbers.
    bool least_increments = false;
    std::vector<ToolTableEntry> tools;
    /// Radii for G41 and G42 in the registers D at the start, by number. A radius replaces half the
    /// diameter of the tool with the same number.
    std::map<int, Length> compensation;
    /// Values of variables at the start that the job specifies: "#500", "#<_depth>".
    std::map<std::string, double> variables;
    /// Clearance of G83 above the last depth before feeding again, and retraction of G73, in units
    /// of the program: a parameter of the machine. Default: 0.254 mm, at most up to R.
    std::optional<double> peck_clearance;
    /// Retract mode of canned cycles before the program sets G98 or G99, a parameter of the
    /// machine. Default: G99 for LinuxCNC, G98 for other controls.
    std::optional<bool> starts_with_g99;
    TipControl tip_control;
    /// Kinematics of the machine; null: unspecified.
    std::shared_ptr<const JointSolver> joints;
    std::array<RotaryWay, 3> rotary_ways{};  ///< Rotary ways of A, B and C.
    std::vector<RotaryClamp> clamps;
    TableOffsets fixture_offsets, setting_errors;  ///< For G54.2; for G54.4.
    FileReader read_file;
    StateObserver observe_state;
    Limits limits;
};

/// A span in a file of the program.
struct ProgramPlace {
    std::uint32_t file = 0;  ///< Index into Interpretation::files.
    SourceSpan span;
};

/// A coordinate system whose origin InterpreterOptions specifies and the program sets to a
/// different value before the first cut in the system. Machine coordinates, mm.
struct OffsetConflict {
    int system = 1;  ///< 1: G54 … 9: G59.3; 9 + n: G54.1 Pn.
    std::array<double, 3> specified{};
    /// Empty: set from the position of the tool (G92, G10 L20), which is unknown.
    std::array<std::optional<double>, 3> written{};
    ProgramPlace place;  ///< The block that sets the origin.
};

/// Results of interpret(), for the assumption sheet and for reports.
struct Interpretation {
    Diagnostics diagnostics;
    bool units_stated = false;  ///< G20 or G21 came before the first length.
    bool uses_inches = false;   ///< The first length is in inches.
    std::uint64_t lines = 0;
    std::uint64_t motions = 0;
    std::vector<std::string> files;  ///< [0] is the program; called O-files follow.
    DialectFindings dialect;         ///< Dialect of the program, with the reasons.
    /// Coordinate system that W is: 1: G54 … 9: G59.3; 9 + n: G54.1 Pn. See motion.h.
    int workpiece_system = 1;
    /// Origin and rotation of W; in machine coordinates only along axes with `frame` 0.
    WorkOffset workpiece;
    std::vector<OffsetConflict> offset_conflicts;
    /// First block with '/' of block delete that execution reached; empty with block delete.
    std::optional<ProgramPlace> deletable;
    /// On Fanuc and Haas: first length or angle without a decimal point that would have another
    /// value in least increments. `has_points`: some number has a decimal point.
    std::optional<ProgramPlace> without_point;
    bool has_points = false;
    /// First block whose motions depend on the control: a cycle, G41, G10, a variable, H0 …
    std::optional<ProgramPlace> control_dependent;
    /// First move before G90 and G91. Empty if the control starts with G90, or if the values of the
    /// program make sense in only one of the two modes.
    std::optional<ProgramPlace> distance_guess;
    /// Registers of InterpreterOptions::compensation that no G41 and no G42 reads.
    std::set<int> unread_registers;
    /// Modes that the program does not set before the first move, with the codes that set them:
    /// "units (G20, G21)". The previous program determines these modes.
    std::vector<std::string> inherited_modes;
    /// Largest P of G64, the distance by which LinuxCNC may miss corners, mm; 0: none. `blend` is
    /// the block.
    double blend_mm = 0.0;
    ProgramPlace blend;
    bool uses_length_offsets = false;  ///< The program contains G43 or a similar code.
    /// Positions of the tip with joints not at 0 were requested; later positions depend on the
    /// solver.
    bool requested_tip_positions = false;
    /// Angle by which a part is misaligned according to G54.4, degrees. Under G54.4, motions are at
    /// the programmed positions on the part; positions of the machine axes differ.
    double setting_askew = 0.0;
    /// The program is not a readable milling program, or stopped at a code after which all
    /// positions would be wrong.
    bool refused = false;
    bool stopped = false;  ///< Stopped before the end, by a limit or a missing part.
    bool ended = false;    ///< M2, M30 or a closing '%' was executed.
};

/// Callback that receives each motion in the order of execution. The reference is valid during the
/// call.
using MotionSink = std::function<void(const Motion&)>;

}  // namespace ncsim::gcode
