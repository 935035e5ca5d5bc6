// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recorded states of a surface.
#include "ncsim/cda/surface_recorder.h"

#include "ncsim/base/mix.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ncsim::cda {

namespace {

constexpr double kSteps = 65535.0;

// Returns twice the area of a polygon, in squares of grid steps.
double double_area(std::span<const GridPoint> corners) {
    const auto from_first = [&](std::size_t i) {
        const auto along = [&](std::size_t axis) {
            return static_cast<double>(corners[i][axis]) - static_cast<double>(corners[0][axis]);
        };
        return Vec3{along(0), along(1), along(2)};
    };
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum = sum + cross(from_first(i), from_first(i + 1));
    return norm(sum);
}

SurfaceRecorder::Hash hash_of(Vec3 normal, std::span<const GridPoint> corners) {
    SurfaceRecorder::Hash hash{};
    for (const double c : {normal.x, normal.y, normal.z})
        hash = extended(hash, std::bit_cast<std::uint64_t>(c));
    for (const GridPoint& p : corners) {
        hash = extended(
            hash, std::uint64_t{p[0]} | std::uint64_t{p[1]} << 16U | std::uint64_t{p[2]} << 32U);
    }
    return hash;
}

}  // namespace

SurfaceRecorder::Hash extended(const SurfaceRecorder::Hash& hash, std::uint64_t number) {
    constexpr std::uint64_t kOther = 0x5851f42d4c957f2dU;
    return {mix(hash[0], number), mix(hash[1] ^ kOther, number)};
}

RecordGrid RecordGrid::around(const Box& box) {
    const Vec3 size = box.max - box.min;
    const double longest = std::max({size.x, size.y, size.z});
    return {box.min, longest > 0.0 ? longest / kSteps : 1.0};
}

GridPoint RecordGrid::nearest(Vec3 point) const {
    GridPoint result;
    const Vec3 steps = (1.0 / step) * (point - origin);
    for (std::size_t i = 0; i < 3; ++i) {
        const double at = std::clamp(steps[static_cast<int>(i)], 0.0, kSteps);
        result[i] = static_cast<std::uint16_t>(std::lround(at));
    }
    return result;
}

Vec3 RecordGrid::position(const GridPoint& point) const {
    return origin + step * Vec3{static_cast<double>(point[0]), static_cast<double>(point[1]),
                                static_cast<double>(point[2])};
}

void SurfaceRecorder::Polygons::add(const RecordGrid& grid, Vec3 normal, Origin origin,
                                    std::span<const Vec3> corners) {
    rounded_.clear();
    for (const Vec3& corner : corners) {
        const GridPoint point = grid.nearest(corner);
        if (rounded_.empty() || rounded_.back() != point) rounded_.push_back(point);
    }
    while (rounded_.size() > 1 && rounded_.front() == rounded_.back())
        rounded_.pop_back();
    if (rounded_.size() < 3 || double_area(rounded_) == 0.0) return;
    // The least corner first, so that equal polygons have equal lists.
    std::rotate(rounded_.begin(), std::ranges::min_element(rounded_), rounded_.end());
    SurfacePiece piece;
    piece.normal = normal;
    piece.origin = origin;
    piece.first_corner = static_cast<std::uint32_t>(corners_.size());
    piece.corners = static_cast<std::uint32_t>(rounded_.size());
    pieces_.push_back(piece);
    corners_.insert(corners_.end(), rounded_.begin(), rounded_.end());
}

SurfaceRecorder::Region& SurfaceRecorder::region_at(std::size_t region) {
    if (region >= regions_.size()) regions_.resize(region + 1);
    return regions_[region];
}

bool SurfaceRecorder::has_cell(std::size_t region, const Hash& hash) const {
    return region < regions_.size() && regions_[region].cells.contains(hash);
}

void SurfaceRecorder::replace_region(std::size_t region, std::span<const Cell> cells) {
    const std::uint32_t state = states_ - 1;
    auto& old = region_at(region).cells;
    std::map<Hash, std::vector<std::uint32_t>> next;
    std::vector<const Cell*> changed;
    for (const Cell& cell : cells) {
        const auto kept = old.find(cell.hash);
        if (kept == old.end()) {
            changed.push_back(&cell);
        } else {
            next.insert(old.extract(kept));
        }
    }
    // A changed cell usually keeps most of its polygons.
    std::map<Hash, std::uint32_t> lost;
    for (const auto& [hash, numbers] : old) {
        for (const std::uint32_t number : numbers) {
            SurfacePiece& piece = pieces_[number];
            piece.end_state = state;
            lost.emplace(hash_of(piece.normal,
                                 std::span(corners_).subspan(piece.first_corner, piece.corners)),
                         number);
        }
    }
    for (const Cell* cell : changed) {
        std::vector<std::uint32_t>& numbers = next[cell->hash];
        for (SurfacePiece piece : cell->polygons.pieces_) {
            const auto corners =
                std::span(cell->polygons.corners_).subspan(piece.first_corner, piece.corners);
            const auto same = lost.find(hash_of(piece.normal, corners));
            if (same != lost.end()) {
                pieces_[same->second].end_state = kNever;
                numbers.push_back(same->second);
                lost.erase(same);
                continue;
            }
            piece.first_corner = static_cast<std::uint32_t>(corners_.size());
            piece.first_state = state;
            piece.end_state = kNever;
            corners_.insert(corners_.end(), corners.begin(), corners.end());
            numbers.push_back(static_cast<std::uint32_t>(pieces_.size()));
            pieces_.push_back(piece);
        }
    }
    old.swap(next);
}

void SurfaceRecorder::keep_states(std::span<const std::uint32_t> kept) {
    const auto renumbered = [&](std::uint32_t state) {
        if (state == kNever) return kNever;
        return static_cast<std::uint32_t>(std::ranges::lower_bound(kept, state) - kept.begin());
    };
    std::vector<SurfacePiece> pieces;
    std::vector<GridPoint> corners;
    std::vector<std::uint32_t> new_number(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        SurfacePiece piece = pieces_[i];
        piece.first_state = renumbered(piece.first_state);
        piece.end_state = renumbered(piece.end_state);
        if (piece.first_state >= piece.end_state) continue;
        const auto own = std::span(corners_).subspan(piece.first_corner, piece.corners);
        piece.first_corner = static_cast<std::uint32_t>(corners.size());
        corners.insert(corners.end(), own.begin(), own.end());
        new_number[i] = static_cast<std::uint32_t>(pieces.size());
        pieces.push_back(piece);
    }
    // Regions hold pieces that still exist, and such pieces are not erased.
    for (Region& region : regions_) {
        for (auto& [hash, numbers] : region.cells) {
            for (std::uint32_t& number : numbers)
                number = new_number[number];
        }
    }
    pieces_.swap(pieces);
    corners_.swap(corners);
    states_ = static_cast<std::uint32_t>(kept.size());
}

}  // namespace ncsim::cda
