// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps 2 to 5 of stitching, see stitch.cpp.
#include "surface/half_edges.h"

#include "ncsim/base/parallel.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace ncsim::cda {

namespace {

// Lines per task of a thread.
constexpr std::size_t kRun = 2048;

int dot_sign(const Direction& a, const Direction& b) {
    const Int128 v = static_cast<Int128>(a.x) * b.x + static_cast<Int128>(a.y) * b.y +
                     static_cast<Int128>(a.z) * b.z;
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

bool follows(const Interval& first, const Interval& second) {
    return first.owner == second.owner && first.head == second.tail &&
           first.forward == second.forward;
}

// The points on a line in order, with the position of each point.
class LinePoints {
public:
    explicit LinePoints(const Naming& names) : names_(names) {}

    template <class Intervals>
    void rank(std::uint32_t line, const Intervals& here) {
        line_points_.clear();
        for (const Interval& i : here)
            line_points_.insert(line_points_.end(), {i.tail, i.head});
        std::sort(line_points_.begin(), line_points_.end());
        line_points_.erase(std::unique(line_points_.begin(), line_points_.end()),
                           line_points_.end());
        by_number_.clear();
        for (const std::uint32_t stop : line_points_)
            by_number_.emplace_back(stop, 0U);
        std::sort(line_points_.begin(), line_points_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return names_.comes_before(line, a, b);
        });
        for (std::uint32_t i = 0; i < line_points_.size(); ++i) {
            std::lower_bound(by_number_.begin(), by_number_.end(), std::pair{line_points_[i], 0U})
                ->second = i;
        }
    }
    std::uint32_t position(std::uint32_t point) const {
        return std::lower_bound(by_number_.begin(), by_number_.end(), std::pair{point, 0U})->second;
    }
    std::uint32_t operator[](std::size_t i) const { return line_points_[i]; }
    std::size_t size() const { return line_points_.size(); }

private:
    const Naming& names_;
    std::vector<std::uint32_t> line_points_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_number_;
};

// Step 2: cancels forward and backward pieces of one owner where they coincide; the rest are
// covers. Each end of a cover is an end of a piece, so there are at most as many covers as pieces.
class Canceller {
public:
    explicit Canceller(const Naming& names) : names_(names), line_points_(names) {}

    void operator()(std::uint32_t line, std::span<Interval> here, std::vector<Interval>& covers) {
        // A line with only outside pieces has no edge of a face.
        if (std::ranges::all_of(here,
                                [&](const Interval& i) { return names_.is_outside(i.owner); }))
            return;
        if (here.size() == 2 && here[0].tail == here[1].tail && here[0].head == here[1].head) {
            if (here[0].owner == here[1].owner && !names_.is_outside(here[0].owner)) return;
            covers.insert(covers.end(), here.begin(), here.end());
            return;
        }
        line_points_.rank(line, here);
        std::sort(here.begin(), here.end(), [&](const Interval& a, const Interval& b) {
            return std::tuple(a.owner, line_points_.position(a.tail)) <
                   std::tuple(b.owner, line_points_.position(b.tail));
        });
        for (std::size_t begin = 0; begin < here.size();) {
            std::size_t end = begin + 1;
            while (end < here.size() && here[end].owner == here[begin].owner)
                ++end;
            // A single piece has no partner, and outside pieces are already cancelled.
            if (end == begin + 1 || names_.is_outside(here[begin].owner)) {
                covers.insert(covers.end(), here.begin() + static_cast<std::ptrdiff_t>(begin),
                              here.begin() + static_cast<std::ptrdiff_t>(end));
                begin = end;
                continue;
            }
            breaks_.clear();
            for (std::size_t i = begin; i < end; ++i)
                breaks_.insert(breaks_.end(), {line_points_.position(here[i].tail),
                                               line_points_.position(here[i].head)});
            std::sort(breaks_.begin(), breaks_.end());
            breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
            active_.clear();
            std::size_t next = begin;
            for (std::size_t b = 0; b + 1 < breaks_.size(); ++b) {
                std::erase_if(active_, [&](const Interval* c) {
                    return line_points_.position(c->head) <= breaks_[b];
                });
                while (next < end && line_points_.position(here[next].tail) <= breaks_[b])
                    active_.push_back(&here[next++]);
                // Pieces of one owner with the same direction have no common inner points, so there
                // is at most one piece per direction.
                if (active_.size() != 1) continue;
                covers.push_back({line_points_[breaks_[b]], line_points_[breaks_[b + 1]],
                                  here[begin].owner, active_[0]->forward});
            }
            begin = end;
        }
    }

private:
    const Naming& names_;
    LinePoints line_points_;
    std::vector<std::uint32_t> breaks_;
    std::vector<const Interval*> active_;
};

// Step 3: finds corners. Two consecutive covers of an owner are one edge, unless the owner has a
// corner between the covers, where an edge on another line begins or ends.
class Corners {
public:
    Corners(const Naming& names, Groups<Interval>& covers) : query_number_(names.points(), kNone) {
        std::uint32_t count = 0;
        for (std::size_t line = 0; line < names.lines(); ++line) {
            const std::span<Interval> here = covers.of(line);
            for (std::size_t i = 1; i < here.size(); ++i) {
                std::uint32_t& asked = query_number_[here[i].tail];
                if (asked == kNone && follows(here[i - 1], here[i])) asked = count++;
            }
        }
        ends_ = Groups<std::uint32_t>(count);
        const auto for_each_end = [&](auto take) {
            for (const Interval& c : covers.all()) {
                for (const std::uint32_t end : {c.tail, c.head}) {
                    if (query_number_[end] != kNone) take(query_number_[end], c.owner);
                }
            }
        };
        for_each_end([&](std::uint32_t asked, std::uint32_t) { ends_.count(asked); });
        ends_.reserve();
        for_each_end([&](std::uint32_t asked, std::uint32_t owner) { ends_.add(asked, owner); });
    }
    // True if exactly two covers of the owner end at the point. Requires: the point is in
    // query_number_.
    bool is_passed(std::uint32_t owner, std::uint32_t point) const {
        const std::span<const std::uint32_t> owners = ends_.of(query_number_[point]);
        return std::count(owners.begin(), owners.end(), owner) == 2;
    }

private:
    std::vector<std::uint32_t> query_number_;  // per point: number among the queried points
    Groups<std::uint32_t> ends_{0};  // per queried point: owners of the covers that end there
};

// Joins the covers of a line that are one edge.
void join_covers(const Naming& names, const Corners& corners, std::span<const Interval> covers,
                 std::vector<Interval>& joined) {
    joined.clear();
    for (const Interval& c : covers) {
        if (!joined.empty() && follows(joined.back(), c) && !names.is_outside(c.owner) &&
            corners.is_passed(c.owner, c.tail)) {
            joined.back().head = c.head;
        } else {
            joined.push_back(c);
        }
    }
}

// Step 4: divides the edges of all owners on a line at each corner of an owner.
class EdgeDivider {
public:
    EdgeDivider(const Naming& names, const Corners& corners)
        : names_(names), corners_(corners), line_points_(names) {}

    void divide_edges(std::uint32_t line, std::span<Interval> here) {
        join_covers(names_, corners_, here, joined_);
        if (joined_.size() == 2 && joined_[0].tail == joined_[1].tail &&
            joined_[0].head == joined_[1].head && joined_[0].forward != joined_[1].forward) {
            const auto h = static_cast<std::uint32_t>(half_edges.size());
            for (const Interval& c : joined_)
                add_half_edge(c, c.tail, c.head, line);
            half_edges[h].partner = h + 1;
            half_edges[h + 1].partner = h;
            return;
        }
        if (joined_.empty()) return;
        line_points_.rank(line, joined_);
        std::sort(joined_.begin(), joined_.end(), [&](const Interval& a, const Interval& b) {
            return std::tuple(line_points_.position(a.tail), a.owner) <
                   std::tuple(line_points_.position(b.tail), b.owner);
        });
        active_.clear();
        std::size_t next = 0;
        for (std::uint32_t b = 0; b + 1 < line_points_.size(); ++b) {
            std::erase_if(active_,
                          [&](const Interval* c) { return line_points_.position(c->head) <= b; });
            while (next < joined_.size() && line_points_.position(joined_[next].tail) <= b)
                active_.push_back(&joined_[next++]);
            line_intervals_.clear();
            for (const Interval* c : active_) {
                line_intervals_.push_back(static_cast<std::uint32_t>(half_edges.size()));
                add_half_edge(*c, line_points_[b], line_points_[b + 1], line);
            }
            if (!line_intervals_.empty()) pair(names_.direction(line), line_intervals_);
        }
    }

    std::vector<HalfEdge> half_edges;

private:
    void add_half_edge(const Interval& c, std::uint32_t low, std::uint32_t high,
                       std::uint32_t line) {
        half_edges.push_back({c.forward ? low : high, c.forward ? high : low, c.owner,
                              line & kMostLines, c.forward, false});
    }

    // Step 5: pairs half-edges of opposite direction. Around the line, counter-clockwise about D, a
    // half-edge against D has material on the counter-clockwise side, a half-edge along D on the
    // clockwise side. Neighbours with only material between them are partners. The angle of a face
    // is the angle of the normal n for a half-edge along D, of −n against D, minus a quarter turn
    // for both.
    void pair(const Direction& direction, std::vector<std::uint32_t>& here) {
        const auto link = [&](std::uint32_t a, std::uint32_t b) {
            half_edges[a].partner = b;
            half_edges[b].partner = a;
        };
        if (here.size() == 2 && half_edges[here[0]].forward != half_edges[here[1]].forward) {
            return link(here[0], here[1]);
        }
        const auto normal = [&](std::uint32_t h) {
            const Plane& p = names_.owners()[half_edges[h].owner].first;
            const int sign = half_edges[h].forward ? 1 : -1;
            return Direction{sign * std::int64_t{p.nx}, sign * std::int64_t{p.ny},
                             sign * std::int64_t{p.nz}};
        };
        // Angles start at the first half-edge: the half turn [0, π) before [π, 2π).
        const Direction zero = normal(here[0]);
        const auto cross_sign = [&](const Direction& a, const Direction& b) {
            // (a × b) · D with a, b of 24 bits and D of 50.
            const auto c = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
                return static_cast<Int128>(p) * s - static_cast<Int128>(q) * r;
            };
            const Int128 v = c(a.y, a.z, b.y, b.z) * direction.x +
                             c(a.z, a.x, b.z, b.x) * direction.y +
                             c(a.x, a.y, b.x, b.y) * direction.z;
            return v > 0 ? 1 : v < 0 ? -1 : 0;
        };
        const auto is_second_half = [&](const Direction& v) {
            const int s = cross_sign(zero, v);
            return s < 0 || (s == 0 && dot_sign(zero, v) < 0);
        };
        std::sort(here.begin(), here.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Direction va = normal(a);
            const Direction vb = normal(b);
            const bool ha = is_second_half(va);
            const bool hb = is_second_half(vb);
            return ha != hb ? hb : cross_sign(va, vb) > 0;
        });
        for (std::size_t i = 0; i < here.size(); ++i) {
            const std::uint32_t a = here[i];
            const std::uint32_t b = here[(i + 1) % here.size()];
            half_edges[a].is_non_manifold = true;
            if (!half_edges[a].forward && half_edges[b].forward) link(a, b);
        }
    }

    const Naming& names_;
    const Corners& corners_;
    LinePoints line_points_;
    std::vector<std::uint32_t> line_intervals_;
    std::vector<const Interval*> active_;
    std::vector<Interval> joined_;
};

}  // namespace

Chunks<HalfEdge> pair_half_edges(const Naming& names, Groups<Interval> pieces,
                                 std::size_t threads) {
    const Runs runs(names.lines(), kRun);
    pieces.replace(runs, threads, [&names] { return Canceller(names); });
    const Corners corners(names, pieces);
    Chunks<HalfEdge> all;
    make_in_parallel(
        threads, runs.tasks(),
        [&](std::size_t task) {
            EdgeDivider breaker(names, corners);
            for (std::size_t line = runs.begin(task); line < runs.end(task); ++line)
                breaker.divide_edges(static_cast<std::uint32_t>(line), pieces.of(line));
            return std::move(breaker.half_edges);
        },
        [&](std::size_t, const std::vector<HalfEdge>& part) {
            const auto before = static_cast<std::uint32_t>(all.size());
            for (HalfEdge h : part) {
                if (h.partner != kNone) h.partner += before;
                all.push_back(h);
            }
        });
    return all;
}

std::vector<BorderEdge> find_border_edges(
    const Naming& names, Groups<Interval> pieces,
    const std::function<bool(std::uint32_t, std::uint32_t)>& is_wanted) {
    pieces.replace(Runs(names.lines(), kRun), 1, [&names] { return Canceller(names); });
    const Corners corners(names, pieces);
    std::vector<BorderEdge> edges;
    std::vector<Interval> joined;
    for (std::uint32_t line = 0; line < names.lines(); ++line) {
        join_covers(names, corners, pieces.of(line), joined);
        for (const Interval& i : joined) {
            if (is_wanted(i.tail, i.head)) edges.push_back({line, i});
        }
    }
    return edges;
}

}  // namespace ncsim::cda
