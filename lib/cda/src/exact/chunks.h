// SPDX-License-Identifier: GPL-3.0-or-later
//
// An array in chunks of fixed size.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace ncsim::cda {

/// Array that grows without moving items, for arrays that take a large share of the memory. The
/// array never exists twice, and at most a single chunk is unused.
template <class T>
class Chunks {
public:
    void push_back(T item) {
        if (size_ % kChunk == 0 && size_ / kChunk == chunks_.size())
            chunks_.push_back(std::make_unique_for_overwrite<T[]>(kChunk));
        chunks_[size_ / kChunk][size_ % kChunk] = std::move(item);
        ++size_;
    }
    T& operator[](std::size_t i) { return chunks_[i / kChunk][i % kChunk]; }
    const T& operator[](std::size_t i) const { return chunks_[i / kChunk][i % kChunk]; }
    std::size_t size() const { return size_; }
    /// Removes all items and keeps the memory.
    void clear() { size_ = 0; }

private:
    static constexpr std::size_t kChunk = 4096;
    std::vector<std::unique_ptr<T[]>> chunks_;
    std::size_t size_ = 0;
};

}  // namespace ncsim::cda
