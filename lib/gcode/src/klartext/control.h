// SPDX-License-Identifier: GPL-3.0-or-later
//
// Control floor of Klartext: paths, tools, datum shifts, rotation, mirror images, scale, tilted
// planes and hole cycles, as commands of Controller. No text of G-code is made.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/gcode/interpretation.h"

#include "control/command.h"
#include "control/controller.h"
#include "klartext/block.h"
#include "klartext/q_parameters.h"
#include "klartext/scanner.h"
#include "language/block_control.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::gcode::klartext {

/// Returns the names of tools that the program calls by name, in the order of the first call.
std::vector<std::string> tool_names(const SourceFile& program);
using language::Corner;
using language::kFirstNamedTool;

/// Executes blocks that act on the machine.
class Control : public language::BlockControl {
public:
    Control(const InterpreterOptions& options, Controller& machine, Parameters& parameters,
            DiagnosticLog& log);

    void set_units(bool inches);

    /// A contour of an SL cycle: the moves of a subprogram, and the side of the tool.
    struct Contour {
        language::Pass moves;
        CutterSide side = CutterSide::Off;
    };
    /// Runs the subprogram with a label without the machine, and returns its moves in the plane;
    /// nullopt after reporting an error.
    using ContourReader =
        std::function<std::optional<Contour>(const std::string& label, SourceSpan span)>;
    void set_contour_reader(ContourReader reader) { read_contour_ = std::move(reader); }
    /// Records a contour for `caller`: plane and units are those of the caller; cutter compensation
    /// is noted and does not act.
    void begin_contour(const Control& caller);
    CutterSide contour_side() const { return contour_side_; }
    Plane plane() const { return plane_; }

    // Each function returns false after reporting an error at which the program stops.
    bool path(const Block& block, const Corner* corner);
    bool tool_call(const Block& block);
    bool tool_def(const Block& block);
    bool cycle_def(const Block& block);
    bool pattern_def(const Block& block);
    bool cycle_call(const Block& block);
    void cycle_end(const Block& block);
    bool plane(const Block& block);
    bool function(const Block& block);
    bool stop_block(const Block& block);
    bool centre(const Block& block);
    /// APPR: approaches the contour that the block `next` begins. `centre`: the CC block between.
    bool approach(const Block& block, const Block& next, const Block* centre);
    /// DEP: departs from the contour.
    bool depart(const Block& block);

    /// Ends cutter compensation, as CALL PGM does.
    bool end_compensation(SourceSpan span);

private:
    /// Words of a path block with their values.
    struct Words {
        std::array<std::optional<double>, 9> axis;
        std::array<bool, 9> is_incremental{};
        std::array<SourceSpan, 9> span;
        std::optional<double> pr, pa, radius, feed, speed, mb, length, opening;
        bool is_pr_incremental = false, is_pa_incremental = false;
        bool is_rapid = false, is_retracted_fully = false;
        bool is_radius_signed = false;
        std::optional<CutterSide> side;
        int direction = 0;  ///< 1: counter-clockwise, -1: clockwise, 0: not specified.
        std::vector<int> m;
        bool has(int code) const;
        bool has_axes() const;
    };
    enum class Value : std::uint8_t { Number, Rapid, Automatic };
    struct CycleValue {
        Value kind = Value::Number;
        double number = 0.0;
    };
    /// A cycle that CYCL CALL, M99 and M89 execute.
    struct Cycle {
        int number = -1;
        std::map<std::uint32_t, CycleValue> values;
    };
    /// A transformation of coordinates by the cycles 8, 10, 11 and 26.
    struct Transformation {
        double angle = 0.0;
        std::array<bool, 3> is_mirrored{};
        std::array<double, 3> scale{1.0, 1.0, 1.0};
        std::array<double, 3> centre{};
    };

    bool gather(const Block& block, Words& words, bool is_ahead = false);
    bool take_m(const Block& block, const Word& word, Words& words);
    bool act_before(const Block& block, Words& words, Command& command);
    bool set_side(Command& command, const Words& words, SourceSpan span);
    bool act_after(const Block& block, const Words& words);
    bool linear_move(const Block& block, Words& words, const Corner* corner);
    bool retract(const Block& block, const Words& words, Command command);
    bool arc(const Block& block, const Words& words, const Corner* corner);
    bool polar_end(const Block& block, const Words& words, Axes& end);
    bool continue_tangentially(const Block& block, const Words& words, const Axes& end,
                               const Command& command);
    bool make_arc(const Words& words, const ProgramArc& arc, std::optional<double> radius,
                  const Command& command);
    Axes ends(const Words& words, AxisMask& mask) const;
    using Point = Vec2;
    std::optional<Point> start_direction(const Block& next, const Block* centre, const Axes& at);
    std::optional<Point> tangent_point(Point from, Point centre, double radius, double turn) const;
    Point in_plane() const;
    bool go_to(Point to, bool is_rapid, SourceSpan span);
    bool turn_to(Point to, Point centre, double turn, SourceSpan span);
    bool move_height(const Words& words, SourceSpan span);
    double rotary_end(double value, double at) const;
    void arrive(const Axes& end) override;
    void refresh() override;
    std::vector<ActiveMode> modes_left_on() const override;
    std::vector<ActiveMode> modes_at_change() const override;

    std::optional<int> tool_number(Scanner& scan, const Block& block, bool& has_tool);
    std::optional<double> radius_of_tool() const;
    double feed_of(double value) const {
        return inches_ && !per_revolution_ ? value / 10.0 : value;
    }

    Corner with_feed(Corner corner) const {
        if (corner.feed) corner.feed = feed_of(*corner.feed);
        return corner;
    }

    bool numbered_cycle(const Block& block, Scanner& scan, int number);
    bool old_cycle(const Block& block, Scanner& scan, int number, int part);
    bool read_cycle_values(const Block& block, Scanner& scan, Cycle& cycle);
    void report_left_out(const Cycle& cycle, SourceSpan span);
    bool preset(const Block& block, double number);
    bool datum_shift(const Block& block, Scanner& scan);
    bool mirror(const Block& block, Scanner& scan);
    bool rotation(const Block& block, Scanner& scan);
    bool scaling(const Block& block, Scanner& scan, bool by_axis);
    bool working_plane(const Block& block, Scanner& scan);
    bool apply(const Block& block);
    bool tilt(const FeatureFrame& frame, std::string_view name, SourceSpan span);

    using PatternValues = std::map<std::string, double, std::less<>>;
    /// A place of PATTERN DEF, with the surface that adds to Q203.
    struct PatternPlace {
        Point at;
        double surface = 0.0;
    };
    bool add_places(std::string_view kind, const PatternValues& values,
                    const std::vector<std::string_view>& required, SourceSpan span);
    bool call_at_places(bool is_rapid, SourceSpan span);
    bool call_cycle(SourceSpan span);
    bool pattern(const Cycle& pattern, SourceSpan span);
    std::vector<Point> places_of(const Cycle& pattern) const;
    std::optional<double> value(std::uint32_t q) const;
    double value(std::uint32_t q, double otherwise) const { return value(q).value_or(otherwise); }
    bool needs(std::initializer_list<std::uint32_t> parameters, SourceSpan span);
    std::optional<double> feed_value(std::uint32_t q) const;
    std::optional<double> feed_out(double down) const;
    bool drill(SourceSpan span);
    bool peck(SourceSpan span, double surface, double bottom, double clear);
    bool bore(double bottom, double clear);
    bool back_bore(SourceSpan span);
    bool tap(SourceSpan span, double surface, double bottom, double clear);
    using BlockControl::peck;
    using BlockControl::tap;
    bool bore_mill(SourceSpan span, double bottom, double clear);
    static bool is_area_cycle(int number);
    bool read_milling(SourceSpan span, double bottom, double clear, language::Milling& m);
    bool mill_area(SourceSpan span, double bottom, double clear);
    std::optional<Point> middle_of_area(const language::MilledArea& area) const;
    bool read_blank(SourceSpan span, language::Milling& m);
    bool mill_circular_slots(SourceSpan span, language::Milling& m);
    bool mill_polygon(SourceSpan span, language::Milling& m);
    static bool is_thread_cycle(int number);
    std::optional<double> feed_or_rapid(std::uint32_t q) const;
    bool read_thread(SourceSpan span, double surface, language::ThreadMilling& m);
    bool countersink_front(const language::ThreadMilling& m, double surface);
    bool prepare_thread(SourceSpan span, const language::ThreadMilling& m, double surface);
    bool thread_cycle(SourceSpan span);
    bool single_lip_drill(SourceSpan span, double surface, double bottom, double clear);
    bool mill_contour_train(SourceSpan span);
    struct MilledContour;
    struct ContourMilling;
    bool contour_labels(const Block& block, Scanner& scan);
    bool read_contours(SourceSpan span, bool is_climb, ContourMilling& m);
    bool check_contours(SourceSpan span, const std::vector<MilledContour>& contours);
    bool mill_contours(SourceSpan span);
    bool mill_levels(SourceSpan span, const ContourMilling& m);
    bool reach(const ContourMilling& m, const Area& area, Vec2 to, double level);
    bool mill_contour(const ContourMilling& m, const Area& area, const MilledContour& contour,
                      double level);

    Parameters& parameters_;
    bool inches_ = false;
    bool per_revolution_ = false;
    double tool_feed_ = 0.0;        ///< F of TOOL CALL.
    double feed_ = 0.0;             ///< Last feed, as programmed.
    double radius_oversize_ = 0.0;  ///< DR of TOOL CALL.
    CutterSide side_ = CutterSide::Off;
    std::optional<Vec2> centre_;
    std::optional<double> pr_, pa_;  ///< Last polar coordinates, if the tool is there.
    int last_direction_ = 0;
    bool was_rapid_ = true;       ///< The last line was rapid.
    bool shortest_way_ = false;   ///< M126
    bool calls_at_each_ = false;  ///< M89
    bool has_preset_ = false;     ///< Cycle 247 selected a preset.
    bool is_preset_reported_ = false;
    double surface_shift_ = 0.0;         ///< Tool axis of CYCL CALL POS.
    std::vector<PatternPlace> pattern_;  ///< Places of PATTERN DEF.
    Cycle cycle_;
    Cycle old_;  ///< Cycle with parts ("CYCL DEF 1.1 …") that is being defined.
    Transformation transformation_;
    std::vector<std::string> contour_labels_;  ///< Cycle 14.
    Cycle contour_data_;                       ///< Cycle 20.
    ContourReader read_contour_;
    bool records_contour_ = false;
    CutterSide contour_side_ = CutterSide::Off;  ///< Last RL or RR of the contour.
};

}  // namespace ncsim::gcode::klartext
