// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of chains around each group.
#include "recognise/chains.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ncsim::brep {

namespace {

// Use of a chain in a loop.
struct ChainUse {
    std::uint32_t chain;
    bool is_forward;
};

}  // namespace

// Removes the chain from the loops of the groups beside its half-edges.
void Chains::remove_flipped(std::uint32_t number, std::vector<std::vector<Loop>>& all) const {
    const std::uint32_t h = chains_[number].edges.front();
    for (const std::uint32_t g : {groups_.group_at(h), groups_.opposite_group(h)}) {
        for (Loop& loop : all[g])
            std::erase_if(loop, [&](const EdgeUse& use) { return use.edge == number; });
        std::erase_if(all[g], [](const Loop& loop) { return loop.empty(); });
    }
}

// Inserts the chain into loops of the groups that it separates. Adds uses for which no gap between
// two ends exists to `left`.
void Chains::insert_flipped(std::uint32_t number, std::vector<std::vector<Loop>>& all,
                            std::vector<PendingUse>& left) const {
    const Chain& chain = chains_[number];
    if (chain.has_vanished) return;
    for (const auto& [g, is_forward] :
         {std::pair(chain.left, true), std::pair(chain.right, false)}) {
        if (chain.neighbour != kNone) {
            for (Loop& loop : all[g]) {
                const auto at = std::ranges::find(loop, chain.neighbour, &EdgeUse::edge);
                if (at == loop.end()) continue;
                loop.insert(is_forward != chain.is_before ? at + 1 : at, {number, is_forward});
            }
            continue;
        }
        if (!insert_use({g, {number, is_forward}}, all[g], true))
            left.push_back({g, {number, is_forward}});
    }
}

// Inserts the use into a gap of a loop. With `has_both`, the chain must fill the gap; otherwise one
// of its ends must fit, and further chains fill the rest. Returns false if there is no such gap.
bool Chains::insert_use(const PendingUse& one, std::vector<Loop>& loops, bool has_both) const {
    const auto begin_of = [&](const EdgeUse& use) {
        return use.is_forward ? chains_[use.edge].from : chains_[use.edge].to;
    };
    const auto end_of = [&](const EdgeUse& use) {
        return use.is_forward ? chains_[use.edge].to : chains_[use.edge].from;
    };
    for (Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const EdgeUse &before = loop[i], &next = loop[(i + 1) % loop.size()];
            const bool begins = end_of(before) == begin_of(one.use);
            const bool ends = end_of(one.use) == begin_of(next);
            const bool is_gap = end_of(before) != begin_of(next);
            if (has_both ? !begins || !ends : !is_gap || !(begins || ends)) continue;
            loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, one.use);
            return true;
        }
    }
    return false;
}

std::vector<std::vector<Loop>> Chains::loops() const {
    const auto first_of = [&](ChainUse use) {
        const Chain& c = chains_[use.chain];
        return use.is_forward ? c.edges.front() : mesh_.edges()[c.edges.back()].twin;
    };
    const auto last_of = [&](ChainUse use) {
        const Chain& c = chains_[use.chain];
        return use.is_forward ? c.edges.back() : mesh_.edges()[c.edges.front()].twin;
    };
    std::vector<std::vector<Loop>> all(groups_.size());
    std::vector<bool> seen(2 * chains_.size(), false);
    for (std::uint32_t i = 0; i < 2 * chains_.size(); ++i) {
        if (seen[i] || chains_[i / 2].is_inserted) continue;
        ChainUse use{i / 2, i % 2 == 0};
        const std::uint32_t g = groups_.group_at(first_of(use));
        Loop loop;
        for (;;) {
            seen[2 * use.chain + (use.is_forward ? 0 : 1)] = true;
            if (!chains_[use.chain].has_vanished) loop.push_back({use.chain, use.is_forward});
            const std::uint32_t next = groups_.next_boundary(last_of(use));
            use = {chain_of_[next], chains_[chain_of_[next]].edges.front() == next};
            if (seen[2 * use.chain + (use.is_forward ? 0 : 1)]) break;
        }
        if (!loop.empty()) all[g].push_back(std::move(loop));
    }
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
        if (chains_[c].is_flipped && !chains_[c].is_inserted) remove_flipped(c, all);
    }
    std::vector<PendingUse> left;
    for (const bool goes_on : {true, false}) {
        for (std::uint32_t c = 0; c < chains_.size(); ++c) {
            if (chains_[c].is_flipped && (chains_[c].neighbour != kNone) == goes_on)
                insert_flipped(c, all, left);
        }
    }
    // An inserted use makes a place for the next one.
    while (std::erase_if(left, [&](const PendingUse& one) {
               return insert_use(one, all[one.group], false);
           }) > 0) {
    }
    return all;
}

}  // namespace ncsim::brep
