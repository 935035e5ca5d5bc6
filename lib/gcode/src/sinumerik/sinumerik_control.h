// SPDX-License-Identifier: GPL-3.0-or-later
//
// Control floor of SINUMERIK: moves, arcs, tools, frames and cycles, as commands of Controller.
// No text of G-code is made.
#pragma once

#include "ncsim/base/vec2.h"

#include "control/controller.h"
#include "language/block_control.h"
#include "sinumerik/formula.h"
#include "sinumerik/frame.h"
#include "sinumerik/line_reader.h"
#include "sinumerik/words.h"

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::gcode::sinumerik {

/// Arguments of a cycle; an omitted argument is empty.
using Arguments = std::vector<std::optional<Value>>;

/// A cycle that a block calls, or that MCALL calls after each move.
struct CycleCall {
    std::string name;  ///< "CYCLE81"
    Arguments arguments;
    SourceSpan span;
};

/// A position of a pattern of holes, in the plane.
struct HolePlace {
    double first = 0.0, second = 0.0;
};

/// Returns the decimal digit `place` of the argument `value`, from the right; 0: units.
int digit(double value, int place);

/// Modes that a subprogram with SAVE restores.
struct SavedModes {
    int motion = 0;
    Plane plane = Plane::XY;
    bool is_incremental = false;
    Frame frame;
};

/// Executes blocks that act on the machine.
class Control final : public language::BlockControl, public SystemValues {
public:
    /// `tool_word_changes`: the program has no M6, so T changes the tool.
    Control(const InterpreterOptions& options, const std::array<RotaryWay, 3>& ways,
            Controller& machine, DiagnosticLog& log, bool tool_word_changes);

    // Each function returns false after reporting an error at which the program stops.
    /// Executes the words of a block, except the end of the program.
    bool block(const Words& words, SourceSpan span);
    /// TRANS, ATRANS, ROT, AROT, SCALE, ASCALE, MIRROR, AMIRROR.
    bool frame(std::string_view name, const Words& words, SourceSpan span);
    /// Executes a cycle at the position of the tool.
    bool cycle(const CycleCall& call);
    /// CYCLE800.
    bool swivel(const CycleCall& call);
    /// Moves to a position of a pattern.
    bool move_over(const HolePlace& place, SourceSpan span);
    /// Returns the positions of HOLES1, HOLES2 and CYCLE801; nullopt after reporting an error.
    std::optional<std::vector<HolePlace>> pattern(const CycleCall& call);
    static bool is_hole_cycle(std::string_view name);
    static bool is_pattern(std::string_view name);
    /// Executes a cycle that mills an area, slots, a face, a contour or a thread.
    bool mill_cycle(const CycleCall& call);
    static bool is_milling_cycle(std::string_view name);
    /// Runs the subprogram, or the blocks between two labels ("A:B"), without the machine, and
    /// returns its moves in the plane; nullopt after reporting an error, no moves if the subprogram
    /// is missing.
    using ContourReader =
        std::function<std::optional<language::Pass>(const std::string& name, SourceSpan span)>;
    void set_contour_reader(ContourReader reader) { read_contour_ = std::move(reader); }
    /// Records a contour for `caller`: plane and units are those of the caller; cutter compensation
    /// does not act.
    void begin_contour(const Control& caller);
    Plane plane() const { return plane_; }

    SavedModes save() const { return {motion_, plane_, is_incremental_, chain_}; }
    bool restore(const SavedModes& saved, SourceSpan span);

    std::optional<double> system_value(std::string_view name, std::string_view axis) const override;

private:
    std::vector<ActiveMode> modes_left_on() const override;
    std::vector<ActiveMode> modes_at_change() const override;
    bool set_modes(const Words& words, SourceSpan span);
    bool set_tool(const Words& words, Command& command, SourceSpan span);
    bool set_edge(double edge, Command& command, SourceSpan span);
    bool set_system(int code, SourceSpan span);
    void set_units(int code, SourceSpan span);
    bool set_side(const Words& words, Command& command, SourceSpan span);
    bool put_speeds(const Words& words, Command& command, SourceSpan span);
    bool one_shot(const Words& words, SourceSpan span);
    bool dwell_block(const Words& words, SourceSpan span);
    bool seek_home(const Words& words, SourceSpan span);
    bool set_pole(int code, const Words& words, SourceSpan span);
    bool move(const Words& words, Command& command, SourceSpan span);
    void check_turn(const Axes& end, SourceSpan span);
    bool line(const Words& words, Command& command, const Axes& end, AxisMask mask,
              SourceSpan span);
    bool arc(const Words& words, const Command& command, const Axes& end, AxisMask mask,
             SourceSpan span);
    bool arc_by_points(const Words& words, const Command& command, ProgramArc arc, AxisMask mask,
                       SourceSpan span);
    bool arc_by_opening(const Words& words, const Command& command, ProgramArc arc, AxisMask mask,
                        bool has_end, SourceSpan span);
    bool tangential(const Command& command, const Axes& end, AxisMask mask, SourceSpan span);
    Axes ends(const Words& words, AxisMask& mask) const;
    bool polar_end(const Words& words, Axes& end, AxisMask& mask, SourceSpan span);
    double end_of(const Coordinate& word, std::size_t axis) const;
    bool is_increment(const Coordinate& word) const;
    std::optional<double> centre_of(const Words& words, std::size_t axis) const;
    double feed_of(double value) const;
    std::optional<language::Corner> corner_of(const Words& words) const;
    bool act_at_end(const Words& words, SourceSpan span);

    bool apply_frame(std::string_view name, SourceSpan span);
    bool offset_part(int code, const Words& words, SourceSpan span);

    std::optional<double> argument(const CycleCall& call, std::size_t index) const;
    double argument(const CycleCall& call, std::size_t index, double otherwise) const {
        return argument(call, index).value_or(otherwise);
    }
    /// Heights of a hole cycle.
    struct Hole {
        double retract = 0.0, surface = 0.0, clear = 0.0, bottom = 0.0;
        double feed = 0.0;
    };
    bool read_hole(const CycleCall& call, Hole& hole);
    bool refuses(const CycleCall& call, std::size_t index, std::string_view what);
    bool refuses_axis(const CycleCall& call, std::size_t index);
    void start_spindle(double direction);
    double dwell_time(double value) const;
    bool deep_hole(const CycleCall& call, const Hole& hole);
    bool tap_hole(const CycleCall& call, const Hole& hole);
    std::optional<double> pitch(const CycleCall& call, std::size_t metric, std::size_t pitch,
                                std::optional<std::size_t> unit);
    bool bore_hole(const CycleCall& call, const Hole& hole);
    bool stop_spindle_at_bottom(const CycleCall& call, const Hole& hole);
    struct MillingArguments;
    static MillingArguments milling_arguments(std::string_view name);
    bool rise(double retract);
    bool mill_area_cycle(const CycleCall& call, double radius);
    double milling_argument(const CycleCall& call, int place) const;
    bool read_area(const CycleCall& call, const MillingArguments& a, bool has_modes,
                   language::Milling& m);
    void read_passes(const CycleCall& call, const MillingArguments& a, bool has_modes,
                     language::Milling& m);
    bool read_milling_depth(const CycleCall& call, const MillingArguments& a, Hole& hole);
    bool read_variant(const CycleCall& call, const MillingArguments& a, language::Milling& m);
    bool read_spigot_blank(const CycleCall& call, const MillingArguments& a, language::Milling& m);
    bool read_slot_passes(const CycleCall& call, std::size_t feeds, double radius, Hole& hole,
                          language::Milling& m);
    bool read_slot_variant(const CycleCall& call, std::size_t variant, language::Milling& m);
    std::optional<int> count_of_slots(const CycleCall& call);
    bool mill_slots_cycle(const CycleCall& call, double radius);
    bool mill_circular_slots_cycle(const CycleCall& call, double radius);
    bool read_face_heights(const CycleCall& call, double depth, language::FaceMilling& m,
                           double& retract);
    bool mill_face_cycle(const CycleCall& call, double radius);
    bool mill_old_face_cycle(const CycleCall& call, double radius);
    bool read_lead(const CycleCall& call, std::size_t form, double radius, language::Lead& lead);
    bool read_path_heights(const CycleCall& call, Hole& hole);
    bool read_path_ways(const CycleCall& call, double radius, language::ContourPath& m);
    bool mill_path_cycle(const CycleCall& call, double radius);
    bool mill_thread_cycle(const CycleCall& call, double radius);

    std::array<RotaryWay, 3> ways_;
    bool tool_word_changes_ = false;
    bool is_tool_change_reported_ = false;
    bool is_feed_reported_ = false;
    bool turns_by_vector_ = false;  ///< ORIWKS, ORIVECT.
    bool is_turn_reported_ = false;
    int motion_ = 0;  ///< 0 … 3, kCip or kCt.
    bool is_incremental_ = false;
    bool is_feed_in_inches_ = false;
    bool goes_around_corners_ = true;  ///< G450
    int edge_ = 0;                     ///< D
    int system_ = 0;                   ///< Number of the last system: 54 …, 500.
    CutterSide side_ = CutterSide::Off;
    double modal_rounding_ = 0.0;     ///< RNDM; 0: off.
    double modal_corner_feed_ = 0.0;  ///< FRCM; 0: none.
    Vec2 pole_{};
    std::optional<double> polar_radius_, polar_angle_;  ///< Last words, while the tool is there.
    Frame chain_;                                       ///< TRANS, ROT, SCALE, MIRROR.
    Frame swivel_;                                      ///< CYCLE800
    std::array<double, 3> coarse_{}, fine_{};           ///< Parts of TRANS by G58 and G59.
    ContourReader read_contour_;
    bool records_contour_ = false;
    bool is_plain_offset_ = true;  ///< `chain_` is `coarse_` plus `fine_`.
};

}  // namespace ncsim::gcode::sinumerik
