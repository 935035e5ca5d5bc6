// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/spikes.h"

#include "topology/face_edges.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace ncsim::brep {

namespace {

class Spikes {
public:
    explicit Spikes(Part& part) : part_(part) {
        for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
            if (pair_of(part.faces[f])) waiting_.push_back(f);
        }
    }

    bool remove_all() {
        if (waiting_.empty()) return false;
        faces_of_.resize(part_.edges.size());
        for (std::uint32_t f = 0; f < part_.faces.size(); ++f) {
            for (const EdgeUse& use : uses_of(part_.faces[f]))
                faces_of_[use.edge].push_back(f);
        }
        bool any = false;
        while (!waiting_.empty()) {
            const std::uint32_t f = waiting_.back();
            waiting_.pop_back();
            while (remove_one(f))
                any = true;
        }
        return any;
    }

private:
    // Use of a straight edge by a loop.
    struct StraightUse {
        std::uint32_t low, high;  // lower and higher number of the two ends
        bool is_ascending;        // true if the loop runs from `low` to `high`
        std::uint32_t edge;
        std::size_t loop, at;
        auto key() const { return std::tuple(low, high, edge, loop, at); }
    };
    struct Pair {
        StraightUse forth, back;
    };

    // Erases a pair of uses of face `f`. False if the face has no pair.
    bool remove_one(std::uint32_t f) {
        const auto pair = pair_of(part_.faces[f]);
        if (!pair) return false;
        const EdgeUse forth = use_of(f, pair->forth), back = use_of(f, pair->back);
        std::vector<Loop>& loops = part_.faces[f].loops;
        erase_uses(loops, {pair->forth.loop, pair->forth.at}, {pair->back.loop, pair->back.at});
        std::erase_if(loops, [](const Loop& loop) { return loop.empty(); });
        if (loops.empty()) loops.emplace_back();
        for (const EdgeUse& use : {forth, back}) {
            Numbers& of = faces_of_[use.edge];
            of.erase(std::ranges::find(of, f));
        }
        if (forth.edge != back.edge) join(forth, back);
        return true;
    }

    const EdgeUse& use_of(std::uint32_t f, const StraightUse& use) const {
        return part_.faces[f].loops[use.loop][use.at];
    }

    // Returns two opposite uses between the same corners, anywhere in the loops of a planar face.
    std::optional<Pair> pair_of(const Face& face) {
        if (!is_plane(face)) return std::nullopt;
        std::vector<StraightUse>& uses = straight_uses_;
        uses.clear();
        for (std::size_t l = 0; l < face.loops.size(); ++l) {
            for (std::size_t i = 0; i < face.loops[l].size(); ++i) {
                const EdgeUse& use = face.loops[l][i];
                const Edge& edge = part_.edges[use.edge];
                if (!is_straight(edge) || edge.from == edge.to) continue;
                const auto [low, high] = std::minmax(edge.from, edge.to);
                uses.push_back({low, high, use.is_forward == (edge.from == low), use.edge, l, i});
            }
        }
        // Uses between the same corners become adjacent, and among these the uses of the same edge.
        std::ranges::sort(uses, {}, &StraightUse::key);
        for (std::size_t i = 0; i < uses.size(); ++i) {
            for (std::size_t j = i + 1;
                 j < uses.size() && uses[j].low == uses[i].low && uses[j].high == uses[i].high;
                 ++j) {
                if (uses[i].is_ascending != uses[j].is_ascending) return Pair{uses[i], uses[j]};
            }
        }
        return std::nullopt;
    }

    // Replaces every use of the edge of `back` by `forth`. The edge is used in the direction
    // opposite to `back` there, which is the direction of `forth`.
    void join(const EdgeUse& forth, const EdgeUse& back) {
        for (const std::uint32_t other : faces_of_[back.edge]) {
            for (Loop& loop : part_.faces[other].loops) {
                for (EdgeUse& use : loop) {
                    if (use.edge == back.edge) use = forth;
                }
            }
            faces_of_[forth.edge].push_back(other);
        }
        faces_of_[back.edge].clear();
        const Numbers& adjacent = faces_of_[forth.edge];
        waiting_.insert(waiting_.end(), adjacent.begin(), adjacent.end());
    }

    Part& part_;
    std::vector<Numbers> faces_of_;           // faces at each edge
    Numbers waiting_;                         // faces that may have a pair
    std::vector<StraightUse> straight_uses_;  // buffer of pair_of()
};

}  // namespace

bool remove_spikes(Part& part) {
    return Spikes(part).remove_all();
}

}  // namespace ncsim::brep
