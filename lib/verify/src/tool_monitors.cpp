// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creates the bodies of a tool that are watched.
#include "tool_monitors.h"

#include <algorithm>
#include <limits>

namespace ncsim::verify {

namespace {

constexpr double kAll = std::numeric_limits<double>::infinity();

// Returns a cylinder about the tool axis, from `low` to `high` mm above the tip.
toolpath::ToolPiece cylinder(double diameter, double low, double high) {
    return {{{diameter / 2, low, 0.0}, {diameter / 2, high, 0.0}}, true};
}

// Returns the cylinder that reaches into the crests of the thread around a thread mill. The lowest
// turn is omitted, because a mill that ends its helix there has left the thread.
toolpath::ToolPiece thread_wall(const ToolFacts& facts, const toolpath::ToolAccuracy& accuracy) {
    constexpr double kDepth = 0.5;    // of the pitch; a full thread is 0.54 deep
    constexpr double kLeast = 0.05;   // mm, without a pitch
    constexpr double kPolygon = 2.0;  // tolerances, in which the wall may be a polygon
    const double height = toolpath::cutting_height_of(facts.tool);
    const double depth = facts.pitch ? kDepth * *facts.pitch : kLeast;
    const double reach = std::max(depth, kPolygon * accuracy.tolerance_mm);
    const double low = std::min(facts.pitch.value_or(1.0), height / 2);
    return cylinder(toolpath::cutting_diameter_of(facts.tool) + 2 * reach, low, height);
}

// Adds the corners of the piece's inscribed polytope, moved by a thousandth towards the centroid of
// the corners.
void add_probes(const toolpath::ToolPiece& piece, const cda::Lattice& lattice,
                const toolpath::ToolAccuracy& inscribed, std::vector<Vec3>& probes_T) {
    const toolpath::PiecePolytope polytope = toolpath::approximate(piece, lattice, inscribed);
    Vec3 middle;
    for (const cda::LatticePoint& p : polytope.points_T)
        middle = middle + lattice.to_mm(p);
    middle =
        (1.0 / static_cast<double>(std::max<std::size_t>(1, polytope.points_T.size()))) * middle;
    for (const cda::LatticePoint& p : polytope.points_T)
        probes_T.push_back(middle + 0.999 * (lattice.to_mm(p) - middle));
}

// True if the cutter is nowhere narrower above. A motion up along the axis then meets only material
// above the cutter.
bool widens(const toolpath::Tool& tool) {
    double radius = 0.0;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) continue;
        for (const toolpath::ProfilePoint& p : piece.profile) {
            if (p.radius < radius) return false;
            radius = p.radius;
        }
        if (piece.profile.back().fillet != 0.0) return false;
    }
    return true;
}

// True if the cutter is a cylinder of its largest radius from `low` mm on.
bool is_straight_above(const toolpath::Tool& tool, double low) {
    const double radius = toolpath::cutting_diameter_of(tool) / 2;
    return std::ranges::all_of(tool.pieces, [&](const toolpath::ToolPiece& piece) {
        if (!piece.cutting) return true;
        const toolpath::ToolPiece above = toolpath::slice(piece, low, kAll);
        return above.profile.empty() || (is_prism(above) && above.profile.front().radius == radius);
    });
}

// Returns the smallest height from which the cutter is such a cylinder.
double start_of_cylinder(const toolpath::Tool& tool) {
    double least = toolpath::cutting_height_of(tool);
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        // The corners of the slice include the ends of fillets.
        for (const toolpath::ProfilePoint& p : toolpath::slice(piece, 0.0, kAll).profile) {
            if (p.height < least && is_straight_above(tool, p.height)) least = p.height;
        }
    }
    return least;
}

// Returns the parts of the cutting pieces between two heights.
std::vector<Body> slices(const toolpath::Tool& tool, double low, double high,
                         const cda::Lattice& lattice, const toolpath::ToolAccuracy& accuracy) {
    std::vector<Body> bodies;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) continue;
        const toolpath::ToolPiece part = toolpath::slice(piece, low, high);
        if (!part.profile.empty()) bodies.emplace_back(part, lattice, accuracy);
    }
    return bodies;
}

FlutesAbove make_flutes_above(const toolpath::Tool& tool, double height,
                              const cda::Lattice& lattice, const toolpath::ToolAccuracy& accuracy) {
    return {height, slices(tool, height, kAll, lattice, accuracy),
            slices(tool, 0.0, height, lattice, accuracy)};
}

}  // namespace

ToolMonitors watch(const ToolFacts& facts, const Selection& selection, const cda::Lattice& lattice,
                   const toolpath::ToolAccuracy& accuracy) {
    ToolMonitors w;
    const toolpath::ToolPiece* cutting = nullptr;
    for (std::size_t i = 0; i < facts.tool.pieces.size(); ++i) {
        const toolpath::ToolPiece& piece = facts.tool.pieces[i];
        if (piece.cutting) cutting = &piece;
        if (!piece.cutting && selection.includes("non-cutting-contact"))
            w.bodies.push_back({i, Body(piece, lattice, accuracy, cutting)});
    }
    const double height = toolpath::cutting_height_of(facts.tool);
    if (facts.blind_diameter && *facts.blind_diameter > 0.0 && selection.includes("plunge")) {
        w.core.emplace(cylinder(*facts.blind_diameter, 0.0, height), lattice, accuracy);
    }
    using toolpath::ToolKind;
    const ToolKind kind = facts.tool.kind;
    if (kind == ToolKind::ThreadMill && selection.includes("thread-retract"))
        w.wall.emplace(thread_wall(facts, accuracy), lattice, accuracy);
    const bool has_mouth =
        (kind == ToolKind::Countersink && selection.includes("countersink-depth")) ||
        (facts.flute_length && selection.includes("drill-depth"));
    if (has_mouth) {
        constexpr double kTall = 1.0;     // mm; raised, it asks about all of the column
        constexpr double kPolygon = 4.0;  // tolerances, by which it keeps off a wall around it
        const double d = toolpath::cutting_diameter_of(facts.tool);
        const double inner = std::max(d / 2, d - kPolygon * accuracy.tolerance_mm);
        w.mouth.emplace(cylinder(inner, 0.0, kTall), lattice, accuracy);
    }
    if (facts.flat_tip && selection.includes("tip-cut")) {
        constexpr double kThin = 0.05;  // mm
        w.tip.emplace(cylinder(*facts.flat_tip, 0.0, std::min(kThin, height)), lattice, accuracy);
    }
    if (facts.max_depth && *facts.max_depth < height && selection.includes("depth-limit")) {
        w.too_high = make_flutes_above(facts.tool, *facts.max_depth, lattice, accuracy);
    }
    if (facts.certain_flutes && *facts.certain_flutes < height) {
        w.uncertain = make_flutes_above(facts.tool, *facts.certain_flutes, lattice, accuracy);
    }
    w.straight_from_mm = start_of_cylinder(facts.tool);
    w.widens = widens(facts.tool);
    toolpath::ToolAccuracy inner = accuracy;
    inner.side = toolpath::Side::Inscribed;
    w.inscribed.emplace(facts.tool, lattice, inner);
    for (const toolpath::ToolPiece& piece : facts.tool.pieces) {
        if (piece.cutting) w.prism &= is_prism(piece);
        if (piece.cutting) add_probes(piece, lattice, inner, w.probes_T);
    }
    return w;
}

}  // namespace ncsim::verify
