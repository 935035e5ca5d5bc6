// SPDX-License-Identifier: GPL-3.0-or-later
//
// What goes into interpret(), and what comes out of it: the values.
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

enum class DefaultUnits : std::uint8_t { Millimetres, Inches };

/// What the control has in its tool table. Lengths are offsets as G43 applies them; motions are
/// of the tool tip, so they only move what is said in machine coordinates.
struct ToolTableEntry {
    int number = 0;
    std::array<Length, 3> offset{};  ///< X, Y, Z.
    bool length_told = false;        ///< Somebody said that offset; else it is 0 by default.
    std::optional<Length> diameter;  ///< For G41 and G42.
    bool operator==(const ToolTableEntry&) const = default;
};

/// Called with each motion just before the sink: the frame it was programmed in.
using FrameObserver = std::function<void(const Motion&, const ProgramFrame&)>;

/// The text of a program beside the main one, by the name a call gives it ("probe", "O1234"), or
/// nullopt. The library itself reads no files.
using FileReader = std::function<std::optional<SourceFile>(std::string_view name)>;

/// Where a program that does not end is stopped, with a diagnostic.
struct Limits {
    std::uint64_t repeated_blocks = 4'000'000;  ///< Blocks run again by loops, calls, repeats.
    std::uint32_t call_depth = 64;
};

/// Tip control: the control keeps the tip in its place while rotary axes turn. If rotary axes are
/// not at 0 when the mode begins, the position of the tip is unknown: geometry would be needed.
struct TipControl {
    /// M428 and its kin, which each configuration of LinuxCNC has in its own way.
    std::map<int, Coordinates> m_codes;
    bool by_length_word = false;  ///< G43.4 begins it, G49 ends it.
    /// With G43.4, X Y Z turn with the table as it stands with its axes at 0, wherever they are at
    /// that time. Else that is not told.
    bool frame_at_zero = false;
    std::vector<Coordinates> kinematics{};     ///< Of LinuxCNC's G12.1 Pn, by P.
    Coordinates at_start = Coordinates::Axes;  ///< What X, Y and Z tell before any word.
    bool operator==(const TipControl&) const = default;
};

/// What a control has in its parameters of where parts are on the table: of G54.2 Pn, the dynamic
/// fixture offset of Fanuc, or of G54.4 Pn, what the setting of a part is off.
struct TableOffsets {
    struct One {
        /// From the zero of the coordinate system (of G54.2 as a rule the middle of the table) to
        /// that of the part: machine coordinates, mm,
        std::array<double, 3> offset{};
        std::array<double, 3> at{};  ///< with the rotary axes A, B, C at these degrees.
        /// Of G54.4: how the part is turned there about X, then Y, then Z, axes that stay; degrees.
        std::array<double, 3> turns{};
        bool operator==(const One&) const = default;
    };
    std::map<int, One> by_number;
    /// Whether the tool goes along when the zero moves, with the code itself or with the table, or
    /// stays and has other coordinates; empty: nobody told.
    std::optional<bool> moves;
    /// Rotary axes take turns about X and Y over, so that the tool does not lean on the part.
    bool axes_take_turns = false;
    bool operator==(const TableOffsets&) const = default;
};

/// What an absolute value of a rotary axis says. Increments are always the way itself.
enum class RotaryWay : std::uint8_t {
    Linear,    ///< A place on a line that goes on: 350 to 10 is -340 (LinuxCNC, Heidenhain).
    Shortest,  ///< A place on the circle, the shortest way: +20 (Fanuc, roll-over; M126).
    Sign,      ///< Its size is the place, its sign the way (LinuxCNC's WRAPPED_ROTARY).
    Positive,  ///< A place on the circle, always up.
};

/// M codes that hold a rotary axis, and let it go.
struct RotaryClamp {
    char letter = 'B';
    int clamp = 10, release = 11;
    bool operator==(const RotaryClamp&) const = default;
};

struct InterpreterOptions {
    /// For programs that say neither G20 nor G21.
    DefaultUnits default_units = DefaultUnits::Millimetres;
    /// Origins of G54, G55 … G59.3 in machine coordinates at the start. Where one is not told,
    /// nobody knows how far it is from the others.
    std::array<Position, 9> work_offsets{};
    std::array<bool, 9> work_offsets_told{};
    std::map<int, Position> extended_offsets;  ///< Those of G54.1 Pn that are told.
    /// Where the tool stands when the program starts, in the coordinates of G54; what is empty is
    /// not known.
    std::array<std::optional<Length>, 3> start{};
    /// `start` is a place of the machine. Otherwise it is in G54 as G54 is at the first move; if
    /// the place of G54 is not specified, in the system of the first move.
    bool start_is_of_machine = false;
    /// Where G28 and G30 lead, in machine coordinates, until G28.1 and G30.1 say otherwise.
    std::array<Position, 2> homes{};
    bool block_delete = false;  ///< Skip blocks that start with '/'.

    Dialect dialect = Dialect::Auto;
    /// Conclusions from the whole file, if the program is one of several in it; null: from the
    /// program.
    std::shared_ptr<const DialectFindings> of_file;
    /// RS274/NGC as LinuxCNC runs it: what that control refuses is an error. Otherwise the
    /// program gets what the machine it was written for gives it, with warnings.
    bool strict = false;
    /// Harmless words, "G187", "M198", which the interpreter skips without a message.
    std::vector<std::string> allow;
    /// Numbers without a decimal point count least increments, as older controls read them: 0.001
    /// mm, 0.0001 inch, 0.001 degrees. Only of axis words, I J K, R and Q, and only where a plain
    /// number stands there.
    bool least_increments = false;
    std::vector<ToolTableEntry> tools;
    /// Radii of G41 and G42 in the registers D at the start, by number; they take the place of
    /// half the diameter of the tool with that number.
    std::map<int, Length> compensation;
    /// Values of variables at the start that the job specifies: "#500", "#<_depth>".
    std::map<std::string, double> variables;
    /// How far above the last depth G83 starts to feed again and how far G73 draws back, in units
    /// of the program: a parameter of the machine. Without it 0.254 mm, and never above R.
    std::optional<double> peck_clearance;
    /// What canned cycles retract to before the program says G98 or G99, a parameter of the
    /// machine, too. Without it: G98, under strict rules G99.
    std::optional<bool> starts_with_g99;
    TipControl tip_control;
    /// How the machine turns; null: nobody told it.
    std::shared_ptr<const JointSolver> joints;
    std::array<RotaryWay, 3> rotary_ways{};  ///< Of A, B and C.
    std::vector<RotaryClamp> clamps;
    TableOffsets fixture_offsets, setting_errors;  ///< Of G54.2, of G54.4.
    FileReader read_file;
    FrameObserver observe_frame;
    Limits limits;
};

struct ProgramPlace {
    std::uint32_t file = 0;  ///< Index into Interpretation::files.
    SourceSpan span;
};

/// A coordinate system whose origin InterpreterOptions specifies and the program sets elsewhere
/// before its first cut there. Machine coordinates, mm.
struct OffsetConflict {
    int system = 1;  ///< 1: G54 … 9: G59.3; 9 + n: G54.1 Pn.
    std::array<double, 3> specified{};
    /// Empty: by the place of the tool (G92, G10 L20), which is unknown.
    std::array<std::optional<double>, 3> written{};
    ProgramPlace place;  ///< The block that set it.
};

/// What was concluded on the way, for the assumption sheet and for reports.
struct Interpretation {
    Diagnostics diagnostics;
    bool units_stated = false;  ///< G20 or G21 came before the first length.
    bool uses_inches = false;   ///< At the first length.
    std::uint64_t lines = 0;
    std::uint64_t motions = 0;
    std::vector<std::string> files;  ///< [0] is the program; O-files that were called follow.
    DialectFindings dialect;         ///< What the program was read as, and why.
    /// The coordinate system that W is: 1: G54 … 9: G59.3; 9 + n: G54.1 Pn. See motion.h.
    int workpiece_system = 1;
    /// Its origin and rotation; in machine coordinates only where its frame is 0.
    WorkOffset workpiece;
    std::vector<OffsetConflict> offset_conflicts;
    /// The first block that starts with '/', of those that were met.
    std::optional<ProgramPlace> deletable;
    /// On Fanuc, Haas and kin: the first length or angle without a decimal point that would be
    /// another one in least increments, and whether others have a point.
    std::optional<ProgramPlace> without_point;
    bool has_points = false;
    /// The first block whose motions depend on the control: a cycle, G41, G10, a variable, H0 …
    std::optional<ProgramPlace> control_dependent;
    /// The first move before G90 and G91, unless the control starts with G90 or the values of the
    /// program make sense only with one of them.
    std::optional<ProgramPlace> distance_guess;
    /// Of InterpreterOptions::compensation, those that no G41 and no G42 reads.
    std::set<int> unread_registers;
    /// Modes that the program does not set before its first move, with the codes that set them:
    /// "units (G20, G21)". In them the program goes on from the one before.
    std::vector<std::string> inherited_modes;
    /// The largest P of G64, by which LinuxCNC may miss corners, mm, and where it is; 0: none.
    double blend_mm = 0.0;
    ProgramPlace blend;
    bool uses_length_offsets = false;  ///< G43 or one of its kin comes in it.
    /// Where joints that are not at 0 have the tip was asked for: the program goes on from there.
    bool asked_for_places = false;
    /// By how many degrees a part was set up askew of which G54.4 spoke: under it the motions are
    /// where they are told on the part, and the axes of the machine elsewhere.
    double setting_askew = 0.0;
    /// Not a milling program we read, or stopped at a code that would misplace all that follows.
    bool refused = false;
    bool stopped = false;  ///< Stopped before its end, by a limit or a missing part.
    bool ended = false;    ///< M2, M30, or a closing '%' was met.
};

/// Called for each motion in the order of execution. The reference is valid during the call.
using MotionSink = std::function<void(const Motion&)>;

}  // namespace ncsim::gcode
