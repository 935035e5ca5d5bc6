// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recorded path, tools and states of the part.
#include "ncsim/simulation/play_recorder.h"

#include "ncsim/cda/tile_number.h"
#include "ncsim/toolpath/tool_spec.h"
#include "ncsim/verify/distances.h"

#include "tool_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ncsim::simulation {

namespace {

// Number of states of a long program. Twice as many states take nearly twice the bytes.
constexpr std::uint64_t kStates = 20;
// Most polygons of a page. If states need more, half of the states are dropped, unless the last
// state alone has nearly as many polygons: then its part of the page is the largest.
constexpr std::size_t kMostPolygons = 900'000;
constexpr double kMostPerLastState = 1.25;
// The drawn path deviates from the simulated path by at most this distance, mm.
constexpr double kPathTolerance = 0.02;
// Largest change of a unit vector for a drawn tool.
constexpr double kAxisTolerance = 1e-3;

// Rates for the time of moves whose rate is not specified, mm/min.
constexpr double kRapidRate = 10000.0;
constexpr double kFeedRate = 1000.0;

// Models without a tree record the whole surface of each state anew.
std::uint64_t states_for(const Plan& plan) {
    constexpr std::uint64_t kStatesOfMeshes = 8;
    return plan.model == cda::kTiledModel ? kStates : kStatesOfMeshes;
}

double distance_from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double length = dot(along, along);
    const double t = length > 0.0 ? std::clamp(dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return norm(p - (a + t * along));
}

}  // namespace

PlayRecorder::PlayRecorder(const Plan& plan, const Survey& survey, std::uint64_t every)
    : survey_(survey),
      every_(every != 0 ? every : std::max<std::uint64_t>(1, survey.moves / states_for(plan))),
      data_{cda::SurfaceRecorder(cda::RecordGrid::around(survey.stock->box)),
            {},
            {},
            {},
            {},
            {},
            {},
            true} {}

std::uint32_t PlayRecorder::tool_index(int number) {
    const auto [known, is_new] =
        tools_.try_emplace(number, static_cast<std::uint32_t>(data_.tools.size()));
    if (is_new) {
        PlayTool& tool = data_.tools.emplace_back();
        tool.name = fmt::format("T{}", number);
        const auto used = survey_.tools.find(number);
        if (used != survey_.tools.end()) {
            tool.name += ' ' + toolpath::describe(used->second.tool);
            tool.pieces = tool_pieces(used->second.tool);
        }
    }
    return known->second;
}

void PlayRecorder::record_state(const cda::WorkpieceModel& part) {
    part.record_surface(data_.surface);
    const std::uint32_t line = data_.moves.empty() ? 0 : data_.moves.back().line;
    data_.states.push_back({static_cast<std::uint32_t>(data_.moves.size()), line});
    has_changed_ = false;
    moves_since_state_ = 0;
}

void PlayRecorder::begin(const cda::WorkpieceModel& part) {
    record_state(part);
}

void PlayRecorder::begin_move(const gcode::Motion& motion) {
    motion_ = &motion;
    has_steps_ = false;
}

void PlayRecorder::add_step(const toolpath::Step& step) {
    const auto add = [this](const toolpath::Pose& pose) {
        data_.points.push_back(pose.translation);
        data_.axes.push_back(toolpath::Pose{pose.rows, {}} * Vec3{0, 0, 1});
    };
    if (!has_steps_) {
        const bool continues =
            !data_.points.empty() && norm(data_.points.back() - step.X_WA.translation) < 1e-6;
        if (!continues) add(step.X_WA);
        first_point_ = static_cast<std::uint32_t>(data_.points.size() - 1);
        has_steps_ = true;
    }
    add(step.X_WB);
}

// Erases points that the path does not need.
void PlayRecorder::simplify_move() {
    auto& points = data_.points;
    auto& axes = data_.axes;
    std::size_t kept = first_point_;  // last point that stays
    const std::vector<Vec3> p(points.begin() + first_point_, points.end());
    const std::vector<Vec3> a(axes.begin() + first_point_, axes.end());
    std::size_t begin = 0;
    const auto fits = [&](std::size_t end) {
        if (norm(a[end] - a[begin]) > kAxisTolerance) return false;
        for (std::size_t i = begin + 1; i < end; ++i) {
            if (distance_from_segment(p[i], p[begin], p[end]) > kPathTolerance) return false;
        }
        return true;
    };
    for (std::size_t end = 2; end < p.size(); ++end) {
        if (end - begin < 32 && fits(end)) continue;
        begin = end - 1;
        ++kept;
        points[kept] = p[begin];
        axes[kept] = a[begin];
    }
    if (p.size() > 1) {
        ++kept;
        points[kept] = p.back();
        axes[kept] = a.back();
    }
    points.resize(kept + 1);
    axes.resize(kept + 1);
}

void PlayRecorder::end_move(bool has_cut, const cda::WorkpieceModel& part) {
    verify::Distances distances;
    verify::add(distances, *motion_);
    seconds_ += distances.dwell_seconds + 60.0 * distances.rapid_mm / kRapidRate;
    if (distances.feed_seconds) {
        seconds_ += *distances.feed_seconds;
    } else {
        seconds_ += 60.0 * distances.feed_mm / kFeedRate;
        data_.feeds_known = false;
    }
    has_changed_ |= has_cut;
    if (!has_steps_) return;
    simplify_move();
    PlayMove move;
    if (motion_->file == 0) move.line = motion_->span.line;
    move.tool = tool_index(motion_->tool);
    move.is_rapid = motion_->kind == gcode::MoveKind::Rapid;
    move.first_point = first_point_;
    move.last_point = static_cast<std::uint32_t>(data_.points.size() - 1);
    move.seconds = seconds_;
    data_.moves.push_back(move);
    ++moves_since_state_;
    if (!has_changed_ || moves_since_state_ < every_) return;
    record_state(part);
    if (is_too_large()) drop_states(false);
}

// True if the states have more polygons than a page should.
bool PlayRecorder::is_too_large() const {
    const auto pieces = data_.surface.pieces();
    if (pieces.size() <= kMostPolygons) return false;
    const auto lasting =
        std::ranges::count(pieces, cda::SurfaceRecorder::kNever, &cda::SurfacePiece::end_state);
    return static_cast<double>(pieces.size()) > kMostPerLastState * static_cast<double>(lasting);
}

// Drops every second state. `keeps_last`: the last state stays.
void PlayRecorder::drop_states(bool keeps_last) {
    std::vector<std::uint32_t> kept;
    std::vector<PlayState> states;
    for (std::uint32_t i = 0; i < data_.states.size(); ++i) {
        if (i % 2 != 0 && !(keeps_last && i + 1 == data_.states.size())) continue;
        kept.push_back(i);
        states.push_back(data_.states[i]);
    }
    has_changed_ = kept.back() + 1 != data_.states.size();
    data_.surface.keep_states(kept);
    data_.states.swap(states);
    every_ *= 2;
}

PlayData PlayRecorder::finish(const cda::WorkpieceModel& part,
                              std::vector<std::uint32_t> line_of_origin) {
    if (has_changed_ || data_.states.size() == 1) record_state(part);
    while (is_too_large() && data_.states.size() > 2)
        drop_states(true);
    data_.line_of_origin = std::move(line_of_origin);
    return std::move(data_);
}

}  // namespace ncsim::simulation
