// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common part of the control floors of languages whose blocks are not words of G-code (Klartext,
// SINUMERIK): commands of Controller, positions, arcs, tools by name, holes.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/gcode/interpretation.h"

#include "control/command.h"
#include "control/controller.h"
#include "language/milling.h"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::language {

/// Letters of the axes, by index.
/// Letters of the coordinates of a centre, by the index of the axis.
inline constexpr std::array kCentres{'I', 'J', 'K'};
/// Number of the first tool with a name; the next names follow.
inline constexpr int kFirstNamedTool = 9001;

/// Returns the number of a tool whose name is a number below `kFirstNamedTool`, as in T="12";
/// otherwise 0.
int number_in_name(std::string_view name);

/// Corner between a path block and the next block.
struct Corner {
    char letter = 'R';  ///< 'R' (rounding), 'C' (chamfer), 'L' (chamfer by its length).
    double size = 0.0;
    bool is_modal = false;       ///< Without an error if the next block is no path.
    std::optional<double> feed;  ///< Feed of the corner only.
    SourceSpan span;
};
void put(Command& command, const Corner& corner);

/// Depths of a hole that is drilled in infeeds. Heights along the tool axis, active units.
struct Pecks {
    double surface = 0.0, bottom = 0.0;
    double clear = 0.0;  ///< Height of the clearance above the surface.
    double from = 0.0;   ///< Height at which the first infeed begins; usually the surface.
    double infeed = 0.0;
    double decrement = 0.0;  ///< Amount by which each infeed is smaller than the last infeed.
    double least = 0.0;      ///< Smallest infeed; 0: the decrement.
    double ahead = 0.0;      ///< Distance above the last depth up to which the tool is rapid.
    /// Same distance before the last infeed; between, it changes in equal steps. Empty: `ahead`.
    std::optional<double> last_ahead;
    double breaking = 0.0;     ///< Retraction for chip breaking.
    double breaks = 0.0;       ///< Number of breaks before a full retraction.
    double break_depth = 0.0;  ///< Depth between breaks within an infeed; 0: none.
    double feed = 0.0;
    std::optional<double> first_feed;  ///< Feed of the first infeed, unless `feed`.
    std::optional<double> up;          ///< Feed of the retraction; empty: rapid.
    double dwell_above = 0.0, dwell_below = 0.0, dwell_between = 0.0;  ///< Seconds.
    bool halves_last = false;  ///< The last two infeeds are equal if the rest is short.
};

/// A tapped hole.
struct Tapping {
    double surface = 0.0, bottom = 0.0, clear = 0.0;
    double feed = 0.0;
    double feed_out = 0.0;
    SpindleTurning in = SpindleTurning::Clockwise;
    SpindleTurning after = SpindleTurning::Stopped;  ///< After the hole.
    double step = 0.0;                               ///< Infeed; 0: in one.
    double breaking = 0.0;  ///< Retraction between infeeds; 0: up to `clear`.
    double dwell = 0.0;     ///< Seconds at the bottom.
};

/// Executes blocks that act on the machine.
class BlockControl {
public:
    BlockControl(const InterpreterOptions& options, Controller& machine, DiagnosticLog& log);
    virtual ~BlockControl() = default;

    /// Sets the file of the following blocks, as an index into Interpretation::files.
    void set_file(std::uint32_t file) { file_ = file; }
    void add_tool_names(const std::vector<std::string>& names);
    /// Shows the cycle `number` that the block `span` defines for calls (DefinedCycle); 0: none.
    void show_defined_cycle(int number, SourceSpan span);
    /// True after the end of the program.
    bool has_ended() const { return has_ended_; }
    /// Ends the main program at the block `span`: reports modes that are still active.
    void end_program(SourceSpan span);

protected:
    bool fail(const MessageText& message, SourceSpan span,
              std::initializer_list<std::string_view> arguments = {});
    static Command make(SourceSpan span);
    /// Executes `command`.
    /// Returns: false if the program stops.
    bool run(const Command& command);
    /// Reports modes that must not be active at a tool change, and a tool that was not retracted.
    void check_tool_change(SourceSpan span);
    /// A mode of the language, and the block that ends the mode.
    struct ActiveMode {
        std::string_view name, end;
    };
    /// Returns the active modes that a program ends before its own end.
    virtual std::vector<ActiveMode> modes_left_on() const = 0;
    /// Returns the active modes that a program ends before a tool change.
    virtual std::vector<ActiveMode> modes_at_change() const = 0;
    /// True if the position along an axis of `mask` is unknown, or relative to an unknown position.
    bool is_unknown(AxisMask mask) const;
    /// Reads the position from the machine.
    virtual void refresh();
    /// Sets the position after a straight move to `end`.
    virtual void arrive(const Axes& end);

    /// Form of the element that continues the last element tangentially.
    enum class Tangent : std::uint8_t { None, Line, Arc };
    Tangent tangent_arc(const Axes& end, ProgramArc& arc) const;
    /// Makes `arc` with the modes in `command`. `named`: axes of the block; `radius`: the arc is
    /// given by its radius instead of its centre.
    bool make_arc(const ProgramArc& arc, AxisMask named, std::optional<double> radius,
                  Command command);

    bool move_to(double height, std::optional<double> feed);
    bool dwell(double seconds);
    bool peck(const Pecks& pecks, const MessageText& too_many);
    bool tap(const Tapping& tapping, const MessageText& too_many);
    /// Retracts with the spindle oriented. `steps_aside`: the tool leaves the wall first.
    bool bore_out(double clear, std::optional<double> feed, bool steps_aside);

    bool cut(const OutlineMove& move, double height, std::optional<double> feed);
    bool move_in_plane(Vec2 to, std::optional<double> feed);
    Vec2 point_in_plane() const;
    bool wind(Vec2 centre, double end, double pitch, bool is_clockwise, double feed);
    /// Mills an area; the tool ends at the height `m.clear`. `name`: the cycle.
    bool mill(const Milling& m, std::string_view name);
    bool mill_face(const FaceMilling& m);
    bool mill_thread(const ThreadMilling& m);
    /// Mills along a contour; the tool ends at the end of the last level, lifted. `name`: the
    /// cycle.
    bool mill_along(const ContourPath& m, std::string_view name);

    int number_of(const std::string& tool_name);
    std::optional<double> diameter_of(int tool) const;
    /// Reports that the cycle `name` is left out.
    void report_unknown_radius(std::string_view name);

    const InterpreterOptions& options_;
    Controller& machine_;
    DiagnosticLog& log_;
    std::uint32_t file_ = 0;
    /// Position in coordinates of the program, without cutter compensation.
    Axes at_{};
    Plane plane_ = Plane::XY;
    int tool_ = 0;
    std::map<std::string, int> named_tools_;
    std::optional<Vec2> tangent_;  ///< Direction at the end of the last element.
    SourceSpan cycle_span_;        ///< Block of the moves of a cycle.
    /// Lowest height of the feed moves, and highest of all moves, since the last tool change or
    /// change of the frame.
    std::optional<double> lowest_feed_, highest_;
    bool has_ended_ = false;

private:
    bool follow(const Pass& pass, double feed);
    bool plunge(const Milling& m, double from, double level);
    bool rough(const Milling& m, Vec2 entry);
    bool finish(const Milling& m, Vec2 entry);
    bool leave(const Milling& m, double height, Vec2 entry);
    bool follow_contour(const ContourPath& m, const Pass& contour, CutterSide side, double level);
};

}  // namespace ncsim::gcode::language
