// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/spikes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {

namespace {

using Numbers = std::vector<std::uint32_t>;

class Spikes {
public:
    explicit Spikes(Part& part) : part_(part) {
        for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
            if (pair_of(part.faces[f])) waiting_.push_back(f);
        }
    }

    bool take_out() {
        if (waiting_.empty()) return false;
        faces_of_.resize(part_.edges.size());
        for (std::uint32_t f = 0; f < part_.faces.size(); ++f) {
            for (const Loop& loop : part_.faces[f].loops) {
                for (const EdgeUse& use : loop)
                    faces_of_[use.edge].push_back(f);
            }
        }
        bool any = false;
        while (!waiting_.empty()) {
            const std::uint32_t f = waiting_.back();
            waiting_.pop_back();
            while (take_one_out(f))
                any = true;
        }
        return any;
    }

private:
    // A straight edge as a loop runs along it.
    struct Way {
        std::uint32_t low, high;  // its ends
        bool goes_up;             // from the one to the other
        std::uint32_t edge;
        std::size_t loop, at;
        auto key() const { return std::tuple(low, high, edge, loop, at); }
    };
    struct Pair {
        Way there, back;
    };

    bool take_one_out(std::uint32_t f) {
        const auto pair = pair_of(part_.faces[f]);
        if (!pair) return false;
        const EdgeUse there = use_of(f, pair->there), back = use_of(f, pair->back);
        take_out_of(part_.faces[f].loops, *pair);
        for (const EdgeUse& use : {there, back}) {
            Numbers& of = faces_of_[use.edge];
            of.erase(std::ranges::find(of, f));
        }
        if (there.edge != back.edge) join(there, back);
        return true;
    }

    const EdgeUse& use_of(std::uint32_t f, const Way& way) const {
        return part_.faces[f].loops[way.loop][way.at];
    }

    // In planes wherever they are; else one after the other.
    std::optional<Pair> pair_of(const Face& face) {
        const bool is_plane = std::holds_alternative<Plane>(face.surface.form);
        std::vector<Way>& ways = ways_;
        ways.clear();
        for (std::size_t l = 0; l < face.loops.size(); ++l) {
            for (std::size_t i = 0; i < face.loops[l].size(); ++i) {
                const EdgeUse& use = face.loops[l][i];
                const Edge& edge = part_.edges[use.edge];
                if (!std::holds_alternative<Line>(edge.curve) || edge.from == edge.to) continue;
                const auto [low, high] = std::minmax(edge.from, edge.to);
                ways.push_back({low, high, use.is_forward == (edge.from == low), use.edge, l, i});
            }
        }
        // Those of one edge are beside each other.
        std::ranges::sort(ways, {}, &Way::key);
        const auto may_go = [&](const Way& a, const Way& b) {
            return a.goes_up != b.goes_up && (is_plane || are_neighbours(face, a, b));
        };
        for (std::size_t i = 0; i < ways.size(); ++i) {
            for (std::size_t j = i + 1;
                 j < ways.size() && ways[j].low == ways[i].low && ways[j].high == ways[i].high;
                 ++j) {
                if (may_go(ways[i], ways[j])) return Pair{ways[i], ways[j]};
            }
        }
        return std::nullopt;
    }

    static bool are_neighbours(const Face& face, const Way& a, const Way& b) {
        if (a.loop != b.loop) return false;
        const std::size_t size = face.loops[a.loop].size();
        return (a.at + 1) % size == b.at || (b.at + 1) % size == a.at;
    }

    // Of two loops that have one of them each becomes one, of one that has both two.
    static void take_out_of(std::vector<Loop>& loops, const Pair& pair) {
        auto [first, second] = std::minmax(pair.there, pair.back, [](const Way& a, const Way& b) {
            return std::pair(a.loop, a.at) < std::pair(b.loop, b.at);
        });
        const auto place = [](Loop& loop, std::size_t i) {
            return loop.begin() + static_cast<std::ptrdiff_t>(i);
        };
        Loop& one = loops[first.loop];
        std::rotate(one.begin(), place(one, first.at), one.end());
        if (first.loop != second.loop) {
            Loop& other = loops[second.loop];
            std::rotate(other.begin(), place(other, second.at), other.end());
            one.insert(one.end(), other.begin() + 1, other.end());
            one.erase(one.begin());
            other.clear();
        } else {
            const auto at = place(one, second.at - first.at);
            Loop rest(at + 1, one.end());
            one.erase(at, one.end());
            one.erase(one.begin());
            loops.push_back(std::move(rest));
        }
        std::erase_if(loops, [](const Loop& loop) { return loop.empty(); });
        if (loops.empty()) loops.emplace_back();
    }

    // Who had `back` has `there`, against whom had that.
    void join(const EdgeUse& there, const EdgeUse& back) {
        for (const std::uint32_t other : faces_of_[back.edge]) {
            for (Loop& loop : part_.faces[other].loops) {
                for (EdgeUse& use : loop) {
                    if (use.edge == back.edge) use = there;
                }
            }
            faces_of_[there.edge].push_back(other);
        }
        faces_of_[back.edge].clear();
        const Numbers& beside = faces_of_[there.edge];
        waiting_.insert(waiting_.end(), beside.begin(), beside.end());
    }

    Part& part_;
    std::vector<Numbers> faces_of_;  // of each edge
    Numbers waiting_;
    std::vector<Way> ways_;  // of the face that is looked at
};

}  // namespace

bool take_out_spikes(Part& part) {
    return Spikes(part).take_out();
}

}  // namespace ncsim::brep
