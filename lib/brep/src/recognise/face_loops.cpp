// SPDX-License-Identifier: GPL-3.0-or-later
#include "recognise/face_loops.h"

#include "geometry/tolerances.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

namespace ncsim::brep {

namespace {

Loop::iterator place(Loop& loop, std::size_t i) {
    return loop.begin() + static_cast<std::ptrdiff_t>(i);
}

void drop_empty(std::vector<Loop>& loops) {
    std::erase_if(loops, [](const Loop& loop) { return loop.empty(); });
}

bool lies_between(Vec3 p, Vec3 from, Vec3 to) {
    const Vec3 along = to - from;
    const double t = dot(p - from, along) / dot(along, along);
    return t > 0.0 && t < 1.0 && norm(p - from - t * along) <= kReaderMm;
}

// Inserts `slit` next to `longer` into the loops of the adjacent face of `longer`, which runs along
// both edges in succession.
bool divide(std::vector<Loop>& loops, const EdgeUse& longer, const EdgeUse& slit, bool is_there) {
    for (Loop& loop : loops) {
        const auto at = std::ranges::find(loop, longer.edge, &EdgeUse::edge);
        if (at == loop.end()) continue;
        // This face runs against the longer edge, so along the slit.
        loop.insert(is_there ? at : at + 1, slit);
        return true;
    }
    return false;
}

// Removes both uses of two edges that have become one, or of one edge with the face on both sides.
void remove_uses(std::vector<Loop>& loops, std::uint32_t one, std::uint32_t two) {
    std::vector<UsePlace> uses;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        for (std::size_t i = 0; i < loops[l].size(); ++i) {
            if (loops[l][i].edge == one || loops[l][i].edge == two) uses.emplace_back(l, i);
        }
    }
    if (uses.size() == 2) erase_uses(loops, uses[0], uses[1]);
}

}  // namespace

FaceLoops::FaceLoops(const Groups& groups, const Chains& chains)
    : groups_(groups), chains_(chains), loops_(chains.loops()), same_(chains.vertices().size()) {
    for (const Chain& chain : chains_.all()) {
        joints_.push_back({chain.left, chain.right, chain.from, chain.to});
        if (chain.has_vanished) same_.unite(chain.from, chain.to);
    }
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        if (groups_.is_facet(g)) continue;
        for (std::size_t l = 0; l < loops_[g].size(); ++l) {
            while (close_slit(g, l)) {
            }
        }
    }
    for (std::vector<Loop>& loops : loops_)
        drop_empty(loops);
}

bool FaceLoops::is_flat(std::uint32_t group) const {
    return std::holds_alternative<Plane>(groups_.form_of(group));
}

std::vector<Corners> FaceLoops::touching_corners(std::uint32_t group,
                                                 const std::vector<Loop>& loops, double near_mm) {
    std::vector<std::uint32_t> corners;
    std::vector<Corners> touching;
    for (const Loop& loop : loops) {
        for (const EdgeUse& use : loop)
            corners.push_back(begin_of(use));
    }
    for (const Loop& loop : loops) {
        const Chain& chain = chains_.all()[loop.front().edge];
        const auto* circle = std::get_if<Circle>(&chain.curve);
        if (!chain.is_closed || !circle || is_flat(group)) continue;
        const auto on_it = std::ranges::find_if(corners, [&](std::uint32_t v) {
            const Vec3 p = at(v) - circle->centre;
            const double height = dot(p, circle->axis);
            const double radius = norm(p - height * circle->axis);
            const double deviation = radius - circle->radius;
            return v != chain.from && height * height + deviation * deviation <= near_mm * near_mm;
        });
        if (on_it != corners.end()) touching.emplace_back(chain.from, *on_it);
    }
    std::vector<std::pair<double, std::uint32_t>> along;
    along.reserve(corners.size());
    for (const std::uint32_t v : corners)
        along.emplace_back(at(v).x, v);
    std::ranges::sort(along);
    for (std::size_t i = 0; i < along.size(); ++i) {
        for (std::size_t j = i + 1; j < along.size(); ++j) {
            if (along[j].first > along[i].first + near_mm) break;
            const std::uint32_t one = along[i].second, other = along[j].second;
            if (norm(at(other) - at(one)) <= near_mm && same_.find(one) != same_.find(other))
                touching.emplace_back(one, other);
        }
    }
    std::erase_if(touching, [&](const Corners& one_place) { return is_edge_between(one_place); });
    return touching;
}

bool FaceLoops::is_edge_between(const Corners& corners) {
    const auto ends = std::minmax({same_.find(corners.first), same_.find(corners.second)});
    for (std::uint32_t c = 0; c < joints_.size(); ++c) {
        if (chains_.all()[c].has_vanished) continue;
        const auto [from, to] = ends_of(c);
        if (std::minmax({from, to}) == ends) return true;
    }
    return false;
}

void FaceLoops::join_touching_loops() {
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        if (!groups_.is_facet(g) && !is_flat(g)) join(loops_[g]);
    }
}

void FaceLoops::join(std::vector<Loop>& loops) {
    const auto corner_of = [&](const EdgeUse& use) { return same_.find(begin_of(use)); };
    for (std::size_t l = 0; l < loops.size(); ++l) {
        Loop& loop = loops[l];
        for (std::size_t m = l + 1; m < loops.size(); ++m) {
            Loop& other = loops[m];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const auto forth = std::ranges::find(other, corner_of(loop[i]), corner_of);
                if (forth == other.end()) continue;
                std::rotate(other.begin(), forth, other.end());
                loop.insert(place(loop, i), other.begin(), other.end());
                other.clear();
                break;
            }
        }
    }
    drop_empty(loops);
}

bool FaceLoops::close_slit(std::uint32_t group, std::size_t loop) {
    const auto opposite_group_of = [&](const EdgeUse& use) -> std::uint32_t& {
        return use.is_forward ? joints_[use.edge].right : joints_[use.edge].left;
    };
    const auto is_straight = [&](const EdgeUse& use) {
        const Chain& chain = chains_.all()[use.edge];
        return !chain.has_failed && std::holds_alternative<Line>(chain.curve);
    };
    // True if both uses run along one circle, in opposite directions.
    const auto are_one_arc = [&](const EdgeUse& one, const EdgeUse& other) {
        const Chain &a = chains_.all()[one.edge], &b = chains_.all()[other.edge];
        const auto* first = std::get_if<Circle>(&a.curve);
        const auto* second = std::get_if<Circle>(&b.curve);
        if (a.has_failed || b.has_failed || a.is_closed || b.is_closed || !first || !second)
            return false;
        const Vec3 sum = (one.is_forward ? 1.0 : -1.0) * first->axis +
                         (other.is_forward ? 1.0 : -1.0) * second->axis;
        return norm(sum) <= kParallelAngle && norm(first->centre - second->centre) <= kReaderMm &&
               std::abs(first->radius - second->radius) <= kReaderMm;
    };
    const Loop& uses = loops_[group][loop];
    const std::size_t size = uses.size();
    for (std::size_t i = 0; i < size && size > 1; ++i) {
        const std::size_t next = (i + 1) % size;
        const EdgeUse forth = uses[i], back = uses[next];
        const bool are_straight = is_straight(forth) && is_straight(back);
        if (forth.edge == back.edge || (!are_straight && !are_one_arc(forth, back))) continue;
        const std::uint32_t start = begin_of(forth), far = end_of(forth), end = end_of(back);
        if (same_.find(far) != same_.find(begin_of(back))) continue;
        const std::uint32_t one = opposite_group_of(forth), two = opposite_group_of(back);
        if (one == group || two == group || groups_.is_facet(one) || groups_.is_facet(two))
            continue;
        const bool is_whole = norm(at(start) - at(end)) <= kReaderMm;
        if (!is_whole && !are_straight) continue;
        const bool is_longer = !is_whole && lies_between(at(end), at(start), at(far));
        const bool is_shorter = !is_whole && lies_between(at(start), at(far), at(end));
        if (!is_whole && !is_longer && !is_shorter) continue;
        // The rest of the longer edge stays in the loop. The other edge, the slit, separates the
        // faces on both sides.
        const EdgeUse slit = is_longer ? back : forth, longer = is_longer ? forth : back;
        if (is_whole) same_.unite(start, end);
        if (!is_whole && !divide(loops_[is_longer ? one : two], longer, slit, is_longer)) continue;
        if (is_longer) end_of(forth) = end;
        if (is_shorter) begin_of(back) = start;
        if (is_whole) {
            if (one == two) {
                remove_uses(loops_[one], forth.edge, back.edge);
            } else {
                opposite_group_of({forth.edge, !forth.is_forward}) = two;
                for (Loop& other : loops_[two]) {
                    for (EdgeUse& use : other) {
                        if (use.edge == back.edge) use = forth;
                    }
                }
            }
        } else if (one == two) {
            remove_uses(loops_[one], slit.edge, slit.edge);
        } else {
            opposite_group_of({slit.edge, !slit.is_forward}) = is_longer ? one : two;
        }
        Loop left;
        for (std::size_t k = 0; k < size; ++k) {
            const bool is_kept = !is_whole && uses[k].edge == longer.edge;
            if ((k != i && k != next) || is_kept) left.push_back(uses[k]);
        }
        loops_[group][loop] = std::move(left);
        return true;
    }
    return false;
}

}  // namespace ncsim::brep
