// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces watched bodies and intersects them with the part.
#include "body.h"

#include <algorithm>
#include <cmath>

namespace ncsim::verify {

using cda::Cell;
using toolpath::Pose;
using toolpath::Side;
using toolpath::Step;

namespace {

toolpath::Tool tool_of(toolpath::ToolPiece piece) {
    piece.cutting = true;  // watched pieces are traced like a cutter
    toolpath::Tool tool;
    tool.pieces.push_back(std::move(piece));
    return tool;
}

toolpath::ToolAccuracy accuracy_for(toolpath::ToolAccuracy accuracy, Side side) {
    accuracy.side = side;
    return accuracy;
}

}  // namespace

Pose raise_pose(const Pose& X_WT, double distance) {
    Pose pose = X_WT;
    if (distance != 0.0) pose.translation = pose.translation + distance * axis_of(X_WT);
    return pose;
}

Cell shrink_cell(const Cell& cell, double distance, const cda::Lattice& lattice) {
    Cell result = cell;
    const double units = distance / lattice.unit_mm;
    for (cda::Plane& plane : result.planes) {
        const double length = std::sqrt(static_cast<double>(plane.nx) * plane.nx +
                                        static_cast<double>(plane.ny) * plane.ny +
                                        static_cast<double>(plane.nz) * plane.nz);
        // Rounds in the direction of the shift.
        const auto shift = static_cast<std::int64_t>(std::ceil(std::abs(units) * length));
        plane = cda::canonical(plane.nx, plane.ny, plane.nz,
                               distance > 0.0 ? plane.d - shift : plane.d + shift);
    }
    if (distance < 0.0) {
        // Edges move farther out than faces: a corner of three right angles by sqrt(3).
        const double more = -4.0 * distance;
        result.bounds.min = result.bounds.min - Vec3{more, more, more};
        result.bounds.max = result.bounds.max + Vec3{more, more, more};
    }
    return result;
}

bool is_prism(const toolpath::ToolPiece& piece) {
    return std::ranges::all_of(piece.profile, [&](const toolpath::ProfilePoint& p) {
        return p.fillet == 0.0 && p.radius == piece.profile.front().radius;
    });
}

double rounding_of(const Step& step, bool prism, const cda::Lattice& lattice) {
    // Two hulls of rotated corners, rounded by half a unit on each axis, and their planes.
    constexpr double kUnits = 4.0;
    const auto is_exact = [](const Pose& pose) {
        for (const Vec3& row : pose.rows) {
            for (int i = 0; i < 3; ++i) {
                if (row[i] != 0.0 && std::abs(row[i]) != 1.0) return false;
            }
        }
        return true;
    };
    return prism && is_exact(step.X_WA) && is_exact(step.X_WB) ? 0.0 : kUnits * lattice.unit_mm;
}

Cell clipped(const Cell& cell, const Box& box, const cda::Lattice& lattice) {
    Cell result = cell;
    result.normals.reset();
    result.bounds = intersection(cell.bounds, box);
    const Cell sides = cda::box_cell(lattice.round(box.min), lattice.round(box.max), lattice);
    for (const cda::Plane& plane : sides.planes) {
        if (std::ranges::find(cell.planes, plane) == cell.planes.end())
            result.planes.push_back(plane);
    }
    return result;
}

void find_places(const Cell& cell, const cda::VerifyingModel& part, const Box& stock,
                 std::vector<Box>& places) {
    constexpr double kSmall = 1.0;  // mm
    constexpr std::size_t kMost = 16;
    const auto longest = [](const Box& box) {
        const Vec3 size = box.size();
        return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    };
    const auto length = [&](const Box& box) { return box.size()[longest(box)]; };
    std::vector<Box> open{intersection(cell.bounds, stock)};
    while (!open.empty() && open.size() < kMost) {
        const auto largest = std::ranges::max_element(open, {}, length);
        if (length(*largest) <= kSmall) break;
        const Box whole = *largest;
        open.erase(largest);
        const int axis = longest(whole);
        Box low = whole, high = whole;
        low.max[axis] = high.min[axis] = whole.centre()[axis];
        for (const Box& half : {low, high}) {
            if (part.contact(clipped(cell, half, part.lattice()))) open.push_back(half);
        }
    }
    places.insert(places.end(), open.begin(), open.end());
}

bool ascends(const Step& step) {
    return step.X_WA.rows == step.X_WB.rows &&
           dot(step.X_WB.translation - step.X_WA.translation, axis_of(step.X_WA)) > 0.0;
}

bool is_upright(const Step& step) {
    return step.X_WA.rows == Pose{}.rows && step.X_WB.rows == step.X_WA.rows;
}

Box intersection(const Box& a, const Box& b) {
    Box box;
    box.min = {std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)};
    box.max = {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)};
    return box.is_empty() ? Box{} : box;
}

Body::Body(const toolpath::ToolPiece& piece, const cda::Lattice& lattice,
           toolpath::ToolAccuracy accuracy, const toolpath::ToolPiece* below)
    : lattice_(lattice),
      prism_(is_prism(piece)),
      outer_(tool_of(piece), lattice, accuracy_for(accuracy, Side::Circumscribed), below),
      inner_(tool_of(piece), lattice, accuracy_for(accuracy, Side::Inscribed), below) {}

std::vector<Cell> Body::cells(const Step& step, double raise, Side side) {
    std::vector<Cell> cells;
    toolpath::Cutter& cutter = side == Side::Circumscribed ? outer_ : inner_;
    cutter.trace(raise_pose(step.X_WA, raise), raise_pose(step.X_WB, raise), {}, cells,
                 toolpath::simplification_of(step.turning.raise_tool(raise)));
    return cells;
}

Box Body::bounds(const Step& step, double raise) const {
    return outer_.bounds(raise_pose(step.X_WA, raise), raise_pose(step.X_WB, raise),
                         toolpath::simplification_of(step.turning.raise_tool(raise)));
}

double gain_of(const toolpath::Cutter& cutter, const Step& step, double raise) {
    const toolpath::RotationBounds turning = step.turning.raise_tool(raise);
    const toolpath::ToolExtent kept = toolpath::split_into_slabs(
        toolpath::below(cutter.extent(), turning.top_mm), turning.slab_mm);
    return turning.chord_mm + toolpath::gained_mm(raise_pose(step.X_WA, raise),
                                                  raise_pose(step.X_WB, raise), turning, kept);
}

double Body::gained(const Step& step, double raise) const {
    return gain_of(inner_, step, raise);
}

double Body::rounding(const Step& step) const {
    return rounding_of(step, prism_, lattice_);
}

PartContact Body::find_contact(const Step& step, double raise, const cda::VerifyingModel& part,
                               const Box& stock) {
    PartContact meeting;
    if (!stock.overlaps(bounds(step, raise))) return meeting;
    const double rounding = this->rounding(step);
    for (const Cell& cell : cells(step, raise, Side::Circumscribed)) {
        const auto point =
            part.contact(rounding > 0.0 ? shrink_cell(cell, rounding, lattice_) : cell);
        if (!point) continue;
        if (!meeting.is_there) meeting.point = point;
        meeting.is_there = true;
        meeting.box.add(intersection(cell.bounds, stock));
    }
    if (!meeting.is_there) return meeting;
    const double less = gained(step, raise) + rounding;
    for (const Cell& cell : cells(step, raise, Side::Inscribed)) {
        const auto point = part.contact(less > 0.0 ? shrink_cell(cell, less, lattice_) : cell);
        if (!point) continue;
        meeting.certainty = Certainty::Certain;
        meeting.point = point;
    }
    return meeting;
}

bool Body::meets_certainly(const Step& step, double raise, const cda::VerifyingModel& part,
                           const Box& stock) {
    if (!stock.overlaps(bounds(step, raise))) return false;
    const double less = gained(step, raise) + rounding(step);
    return std::ranges::any_of(cells(step, raise, Side::Inscribed), [&](const Cell& cell) {
        return part.contact(less > 0.0 ? shrink_cell(cell, less, lattice_) : cell).has_value();
    });
}

double needed_raise(Body& body, const Step& step, double known, double limit, double raise_step,
                    const cda::VerifyingModel& part, const Box& stock) {
    const auto meets = [&](std::int64_t steps) {
        return body.find_contact(step, raise_step * static_cast<double>(steps), part, stock)
            .is_there;
    };
    const auto most = static_cast<std::int64_t>(std::ceil(limit / raise_step));
    auto low = static_cast<std::int64_t>(std::round(known / raise_step));
    std::int64_t width = 1;
    while (low + width < most && meets(low + width)) {
        low += width;
        width *= 2;
    }
    std::int64_t high = std::min(most, low + width);
    while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (meets(middle) ? low : high) = middle;
    }
    return raise_step * static_cast<double>(high);
}

}  // namespace ncsim::verify
