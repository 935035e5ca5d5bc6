// SPDX-License-Identifier: GPL-3.0-or-later
//
// A hash table with open addressing that numbers distinct keys in order of first occurrence and
// keeps the keys in one array.
#pragma once

#include "ncsim/base/mix.h"

#include "exact/chunks.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Numbers distinct keys. `Hash` takes a key, `Equal` takes two keys. `Equal` is called only for
/// keys with equal tags, so only there must `Equal` be an equivalence.
template <class Key, class Hash, class Equal = std::equal_to<Key>>
class Interner {
public:
    explicit Interner(Hash hash = {}, Equal equal = {}) : hash_(hash), equal_(equal) {}

    std::uint32_t operator()(const Key& key) { return number(key, tag_of(key)); }
    /// Calls take(i, number of keys[i]) for all keys in order. While a key is looked up, the data
    /// of the next keys is prefetched, because large tables exceed the caches.
    template <class Take>
    void number_all(std::span<const Key> keys, Take take) {
        constexpr std::size_t kSlotAhead = 16;
        constexpr std::size_t kKeyAhead = 8;
        std::array<std::uint32_t, kSlotAhead> tags{};
        for (std::size_t i = 0; i < keys.size() + kSlotAhead; ++i) {
            if (i >= kSlotAhead) {
                const std::size_t k = i - kSlotAhead;
                take(k, number(keys[k], tags[k % kSlotAhead]));
            }
            if (slots_.empty()) grow();
            const std::size_t mask = slots_.size() - 1;
            if (i < keys.size()) {
                const std::uint32_t tag = tags[i % kSlotAhead] = tag_of(keys[i]);
                __builtin_prefetch(&slots_[tag & mask]);
            }
            if (i >= kKeyAhead && i - kKeyAhead < keys.size()) {
                const Slot& slot = slots_[tags[(i - kKeyAhead) % kSlotAhead] & mask];
                if (slot.number != kFree) __builtin_prefetch(&keys_[slot.number]);
            }
        }
    }
    const Chunks<Key>& keys() const { return keys_; }
    std::size_t size() const { return keys_.size(); }
    /// Removes all keys and keeps the memory.
    void clear() {
        keys_.clear();
        slots_.assign(slots_.size(), {});
    }

    /// Frees memory that only numbering needs. Call after the last key.
    void close() { slots_ = {}; }

private:
    static constexpr std::uint32_t kFree = ~std::uint32_t{0};
    struct Slot {
        std::uint32_t number = kFree;
        std::uint32_t tag = 0;
    };

    // Returns the stored part of a hash: sufficient to find the slot in a table of any size and to
    // reject most other keys.
    std::uint32_t tag_of(const Key& key) const {
        return static_cast<std::uint32_t>(hash_(key) >> 32);
    }

    std::uint32_t number(const Key& key, std::uint32_t tag) {
        if (2 * keys_.size() >= slots_.size()) grow();
        std::size_t at = tag & (slots_.size() - 1);
        for (; slots_[at].number != kFree; at = (at + 1) & (slots_.size() - 1)) {
            if (slots_[at].tag == tag && equal_(keys_[slots_[at].number], key))
                return slots_[at].number;
        }
        const auto result = static_cast<std::uint32_t>(keys_.size());
        slots_[at] = {result, tag};
        keys_.push_back(key);
        return result;
    }

    void grow() {
        std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
        old.swap(slots_);
        for (const Slot& slot : old) {
            if (slot.number == kFree) continue;
            std::size_t at = slot.tag & (slots_.size() - 1);
            while (slots_[at].number != kFree)
                at = (at + 1) & (slots_.size() - 1);
            slots_[at] = slot;
        }
    }

    Hash hash_;
    Equal equal_;
    Chunks<Key> keys_;
    std::vector<Slot> slots_;
};

}  // namespace ncsim::cda
