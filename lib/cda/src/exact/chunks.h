// SPDX-License-Identifier: GPL-3.0-or-later
//
// An array in chunks of fixed size.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace ncsim::cda {

/// Array that grows without moving items, for arrays that take a large share of the memory. The
/// array never exists twice, and at most a single chunk is unused.
template <class T>
class Chunks {
public:
    void push_back(T item) {
        const std::size_t last = size_ / kChunk;
        if (last == chunks_.size()) chunks_.emplace_back().reserve(kChunk);
        chunks_[last].push_back(std::move(item));
        ++size_;
    }
    T& operator[](std::size_t i) { return chunks_[i / kChunk][i % kChunk]; }
    const T& operator[](std::size_t i) const { return chunks_[i / kChunk][i % kChunk]; }
    std::size_t size() const { return size_; }
    /// Removes all items and keeps the memory.
    void clear() {
        for (std::vector<T>& chunk : chunks_)
            chunk.clear();
        size_ = 0;
    }

private:
    static constexpr std::size_t kChunk = 4096;
    std::vector<std::vector<T>> chunks_;  // Memory of unused items is not touched.
    std::size_t size_ = 0;
};

}  // namespace ncsim::cda
