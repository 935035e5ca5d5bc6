// SPDX-License-Identifier: GPL-3.0-or-later
//
// Evaluation of the facet rule. A facet is clipped to the box of the leaf and to the facet's cell.
// The sections that other cells remove from the facet are convex. The remaining area is not
// computed, only the outline: edges of the facet outside of all sections, and edges of sections
// outside of all other sections. Where edges coincide, the same rule applies one dimension lower.
#include "tree/evaluation.h"

#include "exact/none.h"
#include "tree/domination.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace ncsim::cda {

namespace {

// True if the parallel line directions n_s × n_a and n_s × n_b agree in orientation.
bool same_side(const Plane& s, const Plane& a, const Plane& b) {
    const auto cross = [&s](const Plane& p) {
        return std::array<std::int64_t, 3>{std::int64_t{s.ny} * p.nz - std::int64_t{s.nz} * p.ny,
                                           std::int64_t{s.nz} * p.nx - std::int64_t{s.nx} * p.nz,
                                           std::int64_t{s.nx} * p.ny - std::int64_t{s.ny} * p.nx};
    };
    const auto u = cross(a);
    const auto v = cross(b);
    Int128 sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += static_cast<Int128>(u[i]) * v[i];
    return sum > 0;
}

class Evaluator {
public:
    Evaluator(const BlockTree& block, const EvaluationInput& input, Evaluation& result)
        : block_(block), input_(input), result_(result) {
        const auto first = static_cast<std::uint32_t>(block.planes());
        std::uint32_t source = first;
        for (const Plane& plane : input.stock)
            stock_planes_.emplace_back(plane, source++);
        if (input.window) {
            for (const Plane& plane : *input.window)
                window_planes_.emplace_back(plane, source++);
        }
        first_wall_ = source;
        table_.assign(source + 6, kNone);
    }

    void run() {
        block_.visit([this](const HalfBox& box) { return enters(box); },
                     [this](const HalfBox& box, std::span<const BlockTree::Entry> entries) {
                         start_leaf(box, entries);
                     });
        // A query with a window returns only whether and where a piece exists.
        if (!input_.window) result_.outlines.cancel(seams_);
    }

private:
    using Planes = std::vector<const FilterPlane*>;

    // Range of planes in rows_.
    struct Range {
        std::size_t begin = 0, end = 0;
        bool is_empty() const { return begin == end; }
    };
    // A cell with the planes that cut the current box.
    struct LocalCell {
        std::uint32_t cell = 0;
        Range planes;
    };
    // Planes of rows_, each with the share of a polygon below the plane.
    using Cuts = std::vector<std::pair<double, std::size_t>>;
    // The part of the current facet that a cell removes: the part below all `planes`, each of which
    // bounds an edge of the part.
    struct Section {
        const LocalCell* cell = nullptr;
        Cuts cuts;
        FilteredPolygon area;
        Planes planes;
    };

    // Finds the planes that cut the box; false if the box is above one of the planes.
    static bool active(const std::vector<FilterPlane>& planes, const HalfBox& box,
                       Planes& cutting) {
        const BoxFrame frame(box);
        cutting.clear();
        for (const FilterPlane& plane : planes) {
            switch (side_of(frame, HalfPlane(plane.exact))) {
                case Side::Below: break;
                case Side::Above: return false;
                case Side::On: cutting.push_back(&plane); break;
            }
        }
        return true;
    }

    bool enters(const HalfBox& box) {
        if (input_.only_first && !result_.outlines.pieces().empty()) return false;
        if (!input_.window) return true;
        const BoxFrame frame(box);
        return std::none_of(window_planes_.begin(), window_planes_.end(),
                            [&](const FilterPlane& plane) {
                                return side_of(frame, HalfPlane(plane.exact)) == Side::Above;
                            });
    }

    void start_leaf(const HalfBox& box, std::span<const BlockTree::Entry> entries) {
        if (!active(stock_planes_, box, stock_) || !active(window_planes_, box, window_)) return;
        if (entries.empty() && stock_.empty() && window_.empty()) return;
        // Collects the planes that cut the box in one vector that is not reallocated.
        std::size_t count = 0;
        for (const BlockTree::Entry& entry : entries)
            count += entry.planes.size();
        leaf_planes_.clear();
        leaf_planes_.reserve(count);
        rows_.clear();
        stock_range_ = add_rows(stock_);
        window_range_ = add_rows(window_);
        cells_.resize(entries.size());
        for (std::size_t i = 0; i < entries.size(); ++i) {
            cells_[i].cell = entries[i].cell;
            cells_[i].planes.begin = rows_.size();
            for (const std::uint32_t plane : entries[i].planes) {
                leaf_planes_.emplace_back(block_.plane(entries[i].cell, plane, input_.cells),
                                          plane);
                rows_.add(leaf_planes_.back());
            }
            cells_[i].planes.end = rows_.size();
        }
        for (std::size_t i = 0; i < 3; ++i) {
            // 2x <= max has an odd distance, hence is canonical.
            std::array<std::int32_t, 3> n{};
            n[i] = 2;
            const auto wall = first_wall_ + static_cast<std::uint32_t>(2 * i);
            walls_[2 * i] = FilterPlane({-n[0], -n[1], -n[2], -box.min[i]}, wall);
            walls_[2 * i + 1] = FilterPlane({n[0], n[1], n[2], box.max[i]}, wall + 1);
            table_[wall] = table_[wall + 1] = kNone;
        }
        if (input_.only_first && input_.window && covers_window(box)) return;
        box_ = &box;
        last_cover_ = 0;
        ++result_.leaves;
        result_.outlines.start_page();
        evaluate_leaf();
    }

    Range add_rows(const Planes& planes) {
        Range range{rows_.size(), 0};
        for (const FilterPlane* plane : planes)
            rows_.add(*plane);
        range.end = rows_.size();
        return range;
    }

    // True if a single cell covers the window's part of the box. This case is frequent where passes
    // overlap; no facet needs evaluation then.
    bool covers_window(const HalfBox& box) {
        const BoxFrame frame(box);
        const auto find_boxed = [&](const Range& planes, std::vector<BoxPlane>& seen) {
            seen.clear();
            for (std::size_t i = planes.begin; i < planes.end; ++i)
                seen.emplace_back(HalfPlane(rows_[i].exact), rows_[i].exact, frame);
        };
        find_boxed(window_range_, seen_window_);
        return std::ranges::any_of(cells_, [&](const LocalCell& local) {
            find_boxed(local.planes, seen_cell_);
            return dominated(seen_window_, seen_cell_) != Domination::None;
        });
    }

    void evaluate_leaf() {
        const auto takes_same = [](const LocalCell&, bool same) { return same; };
        for (const FilterPlane* s : stock_) {
            if (section_of_box(*s) && clip_to(stock_range_) && clip_strictly_to(window_range_)) {
                finish(kStockOrigin, false, nullptr, takes_same);
            }
        }
        for (const LocalCell& local : cells_) {
            for (std::size_t i = local.planes.begin; i < local.planes.end; ++i) {
                if (!section_of_box(rows_[i]) || !clip_to(local.planes) ||
                    !clip_strictly_to(stock_range_) || !clip_strictly_to(window_range_)) {
                    continue;
                }
                // If two walls are opposite, both disappear; if two walls are equal, the first
                // stays.
                finish(input_.cells.origin(local.cell), true, &local,
                       [&](const LocalCell& other, bool same) {
                           return !same || input_.cells.comes_before(other.cell, local.cell);
                       });
            }
        }
        for (const FilterPlane* s : window_) {
            if (section_of_box(*s) && clip_to(window_range_) && clip_to(stock_range_)) {
                finish(kStockOrigin, false, nullptr, takes_same);
            }
        }
    }

    bool section_of_box(const FilterPlane& plane) {
        return facet_.assign_section(plane, box_->min, box_->max, walls_);
    }
    const Plane& facet_plane() const { return facet_.plane().exact; }

    // Keeps the part of facet_ below the planes. A plane that contains the facet with the same
    // orientation has no effect; with the opposite orientation, nothing is left.
    bool clip_to(const Range& planes) {
        if (planes.is_empty()) return true;
        facet_.classify_rows(rows_, planes.begin, planes.end, filter_results_);
        for (std::size_t i = planes.begin; i < planes.end; ++i) {
            if (filter_results_.where[i] == FilterResult::Above) return false;
        }
        cuts_.clear();
        for (std::size_t i = planes.begin; i < planes.end; ++i) {
            if (filter_results_.where[i] == FilterResult::Below) continue;
            const Plane& plane = rows_[i].exact;
            if (filter_results_.where[i] == FilterResult::Across ||
                !facet_plane().is_parallel_to(plane)) {
                cuts_.emplace_back(share_below(filter_results_, i), i);
                continue;
            }
            const bool same = same_direction(facet_plane(), plane);
            const int beyond = distance_beyond(facet_plane(), plane, same);
            if (beyond < 0 || (beyond == 0 && !same)) return false;
        }
        return clip_in_order(facet_, cuts_, planes);
    }

    // Returns the approximate share of a polygon below a plane, from the polygon's filter results.
    static double share_below(const FilterResults& results, std::size_t i) {
        const double low = results.low[i];
        const double high = results.high[i];
        return low < high ? low / (low - high) : 1.0;
    }

    // Clips by the given planes, starting with the planes that leave least, because most of the
    // remaining planes do not meet a small rest: after two clips all planes are classified again.
    bool clip_in_order(FilteredPolygon& polygon, Cuts& cuts, const Range& planes) {
        constexpr std::size_t kFirst = 2;
        constexpr std::size_t kWorthALook = 4;
        if (cuts.size() >= kFirst + kWorthALook) {
            for (std::size_t k = 0; k < kFirst; ++k) {
                const auto begin = cuts.begin() + static_cast<std::ptrdiff_t>(k);
                std::iter_swap(begin, std::min_element(begin, cuts.end()));
                if (!polygon.clip(rows_[cuts[k].second])) return false;
            }
            polygon.classify_rows(rows_, planes.begin, planes.end, clipped_results_);
            std::size_t kept = 0;
            for (std::size_t i = kFirst; i < cuts.size(); ++i) {
                const std::size_t plane = cuts[i].second;
                const FilterResult where = clipped_results_.where[plane];
                if (where == FilterResult::Above) return false;
                if (where != FilterResult::Below)
                    cuts[kept++] = {share_below(clipped_results_, plane), plane};
            }
            cuts.resize(kept);
        }
        std::sort(cuts.begin(), cuts.end());
        return std::all_of(cuts.begin(), cuts.end(),
                           [&](const auto& cut) { return polygon.clip(rows_[cut.second]); });
    }

    // The same, but false if the facet lies in one of the planes.
    bool clip_strictly_to(const Range& planes) {
        for (std::size_t i = planes.begin; i < planes.end; ++i) {
            if (rows_[i].exact == facet_plane()) return false;
        }
        return clip_to(planes);
    }

    // Applies the facet rule: removes from facet_ the parts that other cells take.
    // `takes_coplanar(cell, same)` is true if a cell with a facet in the same plane, in the same or
    // the opposite orientation, takes the common part.
    template <class TakesCoplanar>
    void finish(Origin origin, bool is_wall, const LocalCell* self, TakesCoplanar takes_coplanar) {
        ++result_.facets_tested;
        sections_in_use_ = 0;
        // Most facets are covered by a single cell, often by the cell that covered the previous
        // facet.
        if (last_cover_ < cells_.size() && &cells_[last_cover_] != self) {
            const Range& planes = cells_[last_cover_].planes;
            facet_.classify_rows(rows_, planes.begin, planes.end, filter_results_);
            if (removed_by(cells_[last_cover_], takes_coplanar, next_section()) == Overlap::Covered)
                return;
        }
        facet_.classify_rows(rows_, window_range_.end, rows_.size(), filter_results_);
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (&cells_[i] == self) continue;
            switch (removed_by(cells_[i], takes_coplanar, next_section())) {
                case Overlap::None: break;
                case Overlap::Covered: last_cover_ = i; return;
                case Overlap::Undecided: ++sections_in_use_; break;
            }
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < sections_in_use_; ++i) {
            if (!find_area(sections_[i])) continue;
            if (kept != i) std::swap(sections_[kept], sections_[i]);
            ++kept;
        }
        sections_in_use_ = kept;
        write_outlines(origin, is_wall);
    }

    Section& next_section() {
        if (sections_in_use_ == sections_.size()) sections_.emplace_back();
        return sections_[sections_in_use_];
    }

    // Classifies, by single planes, the part of facet_ that `other` takes; facet_ has been looked
    // at. The section receives the undecided planes.
    template <class TakesCoplanar>
    Overlap removed_by(const LocalCell& other, TakesCoplanar takes_coplanar, Section& section) {
        bool coplanar_same = false;
        bool coplanar_opposite = false;
        const Range& planes = other.planes;
        for (std::size_t i = planes.begin; i < planes.end; ++i) {
            if (filter_results_.where[i] == FilterResult::Above) return Overlap::None;
        }
        section.cell = &other;
        section.cuts.clear();
        for (std::size_t i = planes.begin; i < planes.end; ++i) {
            if (filter_results_.where[i] == FilterResult::Below) continue;
            const Plane& plane = rows_[i].exact;
            if (filter_results_.where[i] == FilterResult::Across) {
                section.cuts.emplace_back(share_below(filter_results_, i), i);
            } else if (!plane.is_parallel_to(facet_plane())) {
                const int where = facet_.classify(rows_[i]);
                if (where < 0) return Overlap::None;
                if (where == 0) section.cuts.emplace_back(share_below(filter_results_, i), i);
            } else {
                const bool same = same_direction(facet_plane(), plane);
                const int beyond = distance_beyond(facet_plane(), plane, same);
                if (beyond < 0 || (beyond == 0 && !takes_coplanar(other, same)))
                    return Overlap::None;
                if (beyond == 0) (same ? coplanar_same : coplanar_opposite) = true;
            }
        }
        if (coplanar_same && coplanar_opposite) return Overlap::None;  // a flat cell
        return section.cuts.empty() ? Overlap::Covered : Overlap::Undecided;
    }

    // Computes the part of the facet below all crossing planes; false if the part has no area.
    bool find_area(Section& section) {
        section.area.assign(facet_);
        if (!clip_in_order(section.area, section.cuts, section.cell->planes)) return false;
        section.planes.clear();
        for (std::size_t i = 0; i < section.area.size(); ++i) {
            const FilterPlane& edge = section.area.edge_plane(i);
            if (is_in(edge, section.cell->planes)) section.planes.push_back(&edge);
        }
        return true;
    }

    // True if the plane belongs to the range. Planes of cells are in rows_ in the same order as in
    // leaf_planes_.
    bool is_in(const FilterPlane& plane, const Range& planes) const {
        const std::less_equal<const FilterPlane*> comes_first;
        return comes_first(&rows_[planes.begin], &plane) &&
               comes_first(&plane, &rows_[planes.end - 1]);
    }

    void write_outlines(Origin origin, bool is_wall) {
        const std::size_t before = result_.outlines.pieces().size();
        const std::span<const Section> sections(sections_.data(), sections_in_use_);
        for (std::size_t i = 0; i < facet_.size(); ++i) {
            remaining_.assign(1, facet_.edge(i));
            for (const Section& section : sections)
                subtract(section, true);
            write_remaining(origin, is_wall, false);
        }
        for (std::size_t k = 0; k < sections.size(); ++k) {
            const FilteredPolygon& area = sections[k].area;
            for (std::size_t i = 0; i < area.size(); ++i) {
                const auto& planes = sections[k].planes;
                if (std::find(planes.begin(), planes.end(), &area.edge_plane(i)) == planes.end())
                    continue;
                remaining_.assign(1, area.edge(i));
                // If two sections have an edge on the same side, the first section keeps the
                // edge.
                for (std::size_t j = 0; j < sections.size() && !remaining_.empty(); ++j) {
                    if (j != k) subtract(sections[j], j < k);
                }
                write_remaining(origin, is_wall, true);
            }
        }
        if (result_.outlines.pieces().size() == before) return;
        ++result_.facets_alive;
        add_volume(before);
    }

    // Removes a section from remaining_. A piece in an edge of the section is removed if the
    // section is on the opposite side of the piece's own area; if on the same side, only if
    // `takes_same`. A section that degenerates to a line removes nothing.
    void subtract(const Section& section, bool takes_same) {
        rest_.clear();
        for (const FilteredSegment& piece : remaining_) {
            FilteredSegment inside = piece;
            bool lost_tail = false;
            bool lost_head = false;
            bool touched = true;
            bool on_same_side = false;
            bool on_other_side = false;
            for (const FilterPlane* plane : section.planes) {
                switch (inside.clip(*plane)) {
                    case FilteredSegment::Clipped::Whole: break;
                    case FilteredSegment::Clipped::Tail: lost_tail = true; break;
                    case FilteredSegment::Clipped::Head: lost_head = true; break;
                    case FilteredSegment::Clipped::Nothing: touched = false; break;
                    case FilteredSegment::Clipped::Inside:
                        (same_side(facet_plane(), piece.line->exact, plane->exact)
                             ? on_same_side
                             : on_other_side) = true;
                        break;
                }
                if (!touched) break;
            }
            if (on_same_side && (on_other_side || !takes_same)) touched = false;
            if (!touched) {
                rest_.push_back(piece);
                continue;
            }
            if (lost_tail) {
                rest_.push_back(piece);
                rest_.back().head = inside.tail;
                rest_.back().head_cut = inside.tail_cut;
            }
            if (lost_head) {
                rest_.push_back(piece);
                rest_.back().tail = inside.head;
                rest_.back().tail_cut = inside.head_cut;
            }
        }
        remaining_.swap(rest_);
    }

    // `reversed`: the face lies above the line's plane.
    void write_remaining(Origin origin, bool is_wall_of_part, bool reversed) {
        for (const FilteredSegment& piece : remaining_) {
            const std::uint32_t plane = index_of(*piece.plane);
            const std::uint32_t edge = index_of(*piece.line);
            std::uint32_t tail = result_.outlines.point(plane, edge, index_of(*piece.tail_cut));
            std::uint32_t head = result_.outlines.point(plane, edge, index_of(*piece.head_cut));
            if (reversed != is_wall_of_part) std::swap(tail, head);
            if (is_wall(*piece.line))
                seams_.push_back(static_cast<std::uint32_t>(result_.outlines.pieces().size()));
            result_.outlines.add(
                {2 * plane + static_cast<PlaneRef>(is_wall_of_part), edge, origin, tail, head});
        }
    }

    std::uint32_t index_of(const FilterPlane& plane) {
        std::uint32_t& index = table_[plane.source];
        if (index == kNone) {
            index = is_wall(plane) ? index_of_wall(plane.source - first_wall_)
                                   : result_.outlines.add_plane(plane.exact);
        }
        return index;
    }
    bool is_wall(const FilterPlane& plane) const { return plane.source >= first_wall_; }
    // Returns the same index for all leaves with a wall at this position, on either side.
    std::uint32_t index_of_wall(std::size_t wall) {
        const std::size_t axis = wall / 2;
        const std::int64_t at = wall % 2 == 0 ? box_->min[axis] : box_->max[axis];
        const std::uint32_t number = wall_numbers_({static_cast<std::int64_t>(axis), at});
        if (number == wall_indices_.size())
            wall_indices_.push_back(result_.outlines.add_plane(walls_[wall].exact));
        return wall_indices_[number];
    }

    // Adds a third of distance times area, from the pieces of the facet written last.
    void add_volume(std::size_t first_piece) {
        const Plane& plane = facet_plane();
        const Vec3 normal = unit_normal(plane);
        const auto& points = result_.outlines.points();
        const auto& pieces = result_.outlines.pieces();
        const Vec3 foot = points[pieces[first_piece].tail].fixed.approx();
        double doubled_area = 0.0;
        for (std::size_t i = first_piece; i < pieces.size(); ++i) {
            doubled_area += dot(normal, cross(points[pieces[i].tail].fixed.approx() - foot,
                                              points[pieces[i].head].fixed.approx() - foot));
        }
        // Outlines of walls run in the opposite direction as seen along the normal of the cell, so
        // the area is negative, as the volume must be.
        result_.volume += distance_about(plane, input_.centre) * doubled_area / 6.0;
    }

    const BlockTree& block_;
    const EvaluationInput& input_;
    Evaluation& result_;
    std::vector<FilterPlane> stock_planes_, window_planes_;
    std::uint32_t first_wall_ = 0;
    std::vector<std::uint32_t> table_;  // source of a plane → index in the outlines
    // Walls of leaves by axis and position → index in the outlines.
    struct HashWall {
        std::uint64_t operator()(const std::array<std::int64_t, 2>& wall) const {
            return mix(static_cast<std::uint64_t>(wall[0]), static_cast<std::uint64_t>(wall[1]));
        }
    };
    Interner<std::array<std::int64_t, 2>, HashWall> wall_numbers_;
    std::vector<std::uint32_t> wall_indices_;
    std::vector<std::uint32_t> seams_;  // pieces on walls
    // Data of the current leaf.
    const HalfBox* box_ = nullptr;
    std::array<FilterPlane, 6> walls_;
    Planes stock_, window_;
    std::vector<FilterPlane> leaf_planes_;
    PlaneRows rows_;  // planes of the stock, the window and the cells
    Range stock_range_, window_range_;
    std::vector<LocalCell> cells_;
    std::size_t last_cover_ = 0;
    std::vector<BoxPlane> seen_window_, seen_cell_;
    // Data of the current facet.
    FilteredPolygon facet_;
    FilterResults filter_results_;  // relation of facet_ to rows_
    Cuts cuts_;
    FilterResults clipped_results_;  // the same after some clips
    std::vector<Section> sections_;
    std::size_t sections_in_use_ = 0;
    std::vector<FilteredSegment> remaining_, rest_;
};

}  // namespace

Evaluation evaluate(const BlockTree& block, const EvaluationInput& input) {
    Evaluation result;
    Evaluator(block, input, result).run();
    result.outlines.close();
    return result;
}

}  // namespace ncsim::cda
