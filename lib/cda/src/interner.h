// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equal keys get equal numbers, in order of first sight: a hash table with open addressing that
// keeps its keys in one array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::cda {

/// The finalizer of splitmix64: the same on every machine and in every run.
constexpr std::uint64_t mix(std::uint64_t h, std::uint64_t v) {
    h = (h ^ v) + 0x9e3779b97f4a7c15ULL;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ULL;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebULL;
    return h ^ (h >> 31);
}

/// `Hash` is a function of a key; `Equal` of two, and need not be transitive to the eye: it is only
/// asked of keys with equal hashes.
template <class Key, class Hash, class Equal = std::equal_to<Key>>
class Interner {
public:
    explicit Interner(Hash hash = {}, Equal equal = {}) : hash_(hash), equal_(equal) {}

    std::uint32_t operator()(const Key& key) {
        if (2 * keys_.size() >= slots_.size()) grow();
        const std::uint64_t h = hash_(key);
        std::size_t at = h & (slots_.size() - 1);
        const auto tag = static_cast<std::uint32_t>(h >> 32);
        for (; slots_[at].number != kFree; at = (at + 1) & (slots_.size() - 1)) {
            if (slots_[at].tag == tag && equal_(keys_[slots_[at].number], key))
                return slots_[at].number;
        }
        const auto number = static_cast<std::uint32_t>(keys_.size());
        slots_[at] = {number, tag};
        keys_.push_back(key);
        return number;
    }
    const std::vector<Key>& keys() const { return keys_; }
    std::size_t size() const { return keys_.size(); }
    /// Forgets all keys but keeps the room.
    void clear() {
        keys_.clear();
        slots_.assign(slots_.size(), {});
    }

private:
    static constexpr std::uint32_t kFree = ~std::uint32_t{0};
    struct Slot {
        std::uint32_t number = kFree;
        std::uint32_t tag = 0;
    };

    void grow() {
        std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
        old.swap(slots_);
        for (const Slot& slot : old) {
            if (slot.number == kFree) continue;
            std::size_t at = hash_(keys_[slot.number]) & (slots_.size() - 1);
            while (slots_[at].number != kFree)
                at = (at + 1) & (slots_.size() - 1);
            slots_[at] = slot;
        }
    }

    Hash hash_;
    Equal equal_;
    std::vector<Key> keys_;
    std::vector<Slot> slots_;
};

}  // namespace ncsim::cda
