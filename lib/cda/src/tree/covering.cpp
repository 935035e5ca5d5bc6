// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proof that cells cover a window, by halving boxes.
#include "tree/covering.h"

#include "tree/domination.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

namespace ncsim::cda {

namespace {

// Smaller boxes are not halved; half units.
constexpr std::int64_t kLeastExtent = 4;
// A box that more planes of the window cut is halved first.
constexpr std::size_t kFewPlanes = 4;

class Covering {
public:
    Covering(const BlockTree& block, const CoveringInput& input)
        : block_(block), input_(input), left_(input.test_limit) {
        for (const IncomingCell* cell : input_.pending)
            cells_.push_back({cell->planes, 0, cell});
    }

    bool run() {
        const std::size_t pending = cells_.size();
        bool is_so = true;
        block_.visit([&](const HalfBox& box) { return is_so && enters(BoxFrame(box)); },
                     [&](const HalfBox& box, std::span<const BlockTree::Entry> entries) {
                         cells_.resize(pending);
                         add(entries);
                         is_so = is_removed(box);
                     });
        return is_so;
    }

private:
    struct Candidate {
        std::span<const Plane> planes;
        std::size_t last = 0;                  // the plane that last failed to contain a box
        const IncomingCell* bounds = nullptr;  // null if unknown
    };

    // Finds the planes of the window that cut the box; false if the box is above one plane.
    bool enters(const BoxFrame& box) {
        window_.clear();
        for (const Plane& plane : input_.window) {
            switch (side_of(box, HalfPlane(plane))) {
                case Side::Below: break;
                case Side::Above: return false;
                case Side::On: window_.push_back(&plane); break;
            }
        }
        return true;
    }

    // Adds the cells of a leaf.
    void add(std::span<const BlockTree::Entry> entries) {
        leaf_planes_.clear();
        for (const BlockTree::Entry& entry : entries) {
            for (const std::uint32_t plane : entry.planes)
                leaf_planes_.push_back(block_.plane(entry.cell, plane, input_.cells));
        }
        std::span<const Plane> rest = leaf_planes_;
        for (const BlockTree::Entry& entry : entries) {
            cells_.push_back({rest.first(entry.planes.size()), 0, nullptr});
            rest = rest.subspan(entry.planes.size());
        }
    }

    bool is_removed(const HalfBox& leaf) {
        // The latest cell first: it usually cleared the path.
        std::vector<std::uint32_t>& all = candidates(0);
        all.clear();
        for (std::size_t i = cells_.size(); i > 0; --i)
            all.push_back(static_cast<std::uint32_t>(i - 1));
        const HalfBox box = intersection(leaf, input_.bounds);
        return box.is_empty() || is_removed(box, 0);
    }

    // True if the window's part of the box is covered. Candidates are the cells that may be in the
    // box twice as large.
    bool is_removed(const HalfBox& box, std::size_t level) {
        const BoxFrame frame(box);
        if (!enters(frame)) return true;
        std::vector<std::uint32_t>& here = candidates(level + 1);
        here.clear();
        for (const std::uint32_t number : candidates(level)) {
            if (left_ == 0) return false;
            --left_;
            Candidate& candidate = cells_[number];
            if (candidate.bounds && !candidate.bounds->meets(frame)) continue;
            const Side side = where(candidate, frame);
            if (side == Side::Below) return true;
            if (side == Side::On) here.push_back(number);
        }
        const std::size_t axis = box.longest_axis();
        if (here.empty() || box.extent(axis) < kLeastExtent) return false;
        return is_removed(box.half(axis, false), level + 1) &&
               is_removed(box.half(axis, true), level + 1);
    }

    // Returns how the window's part of the box lies to the cell: below all planes, above a plane,
    // or undecided (On).
    Side where(Candidate& candidate, const BoxFrame& box) {
        if (candidate.bounds && !may_enclose(*candidate.bounds, box)) return Side::On;
        const std::size_t count = candidate.planes.size();
        for (std::size_t k = 0; k < count; ++k) {
            if (left_ == 0) return Side::On;
            --left_;
            const std::size_t i = (candidate.last + k) % count;
            const Plane& plane = candidate.planes[i];
            const Side side = side_of(box, HalfPlane(plane));
            if (side == Side::Above) return Side::Above;
            if (side == Side::Below || is_implied(plane, box)) continue;
            candidate.last = i;
            return Side::On;
        }
        return Side::Below;
    }

    // Filter that only saves work. Bounds of cells and of the window are rounded outwards by less
    // than kRounding.
    static bool may_enclose(const IncomingCell& cell, const BoxFrame& box) {
        constexpr double kRounding = 16.0;  // half units
        for (std::size_t i = 0; i < 3; ++i) {
            if (cell.min[i] > box.centre[i] - box.half[i] + kRounding) return false;
            if (cell.max[i] < box.centre[i] + box.half[i] - kRounding) return false;
        }
        return true;
    }

    // True if the window's part of the box is below the plane, although the box is not.
    bool is_implied(const Plane& plane, const BoxFrame& box) {
        if (window_.size() > kFewPlanes) return false;
        left_ -= std::min(left_, window_.size());
        const BoxPlane by(HalfPlane(plane), plane, box);
        return std::ranges::any_of(window_, [&](const Plane* w) {
            return implies(BoxPlane(HalfPlane(*w), *w, box), by) != Domination::None;
        });
    }

    std::vector<std::uint32_t>& candidates(std::size_t level) {
        while (levels_.size() <= level)
            levels_.emplace_back();
        return levels_[level];
    }

    const BlockTree& block_;
    const CoveringInput& input_;
    std::size_t left_;
    std::vector<Candidate> cells_;  // waiting cells, then cells of the leaf
    std::vector<Plane> leaf_planes_;
    std::vector<const Plane*> window_;  // planes that cut the current box
    // indices into cells_; a deque, because references must stay valid
    std::deque<std::vector<std::uint32_t>> levels_;
};

}  // namespace

bool is_covered(const BlockTree& block, const CoveringInput& input) {
    return Covering(block, input).run();
}

}  // namespace ncsim::cda
