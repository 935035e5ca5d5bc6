// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compact storage of leaves, which is most of a tree's memory. A plane with a shared normal takes
// ten bytes. Lists of numbers are stored as differences with variable length.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/plane.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ncsim::cda {

/// Reserves space for one more item, growing by an eighth so that little memory is unused.
template <class T>
void make_room(std::vector<T>& items) {
    if (items.size() == items.capacity()) items.reserve(items.size() + items.size() / 8 + 16);
}

/// Planes by number.
class PlaneStore {
public:
    /// Facet number of a plane whose normal is in no family.
    static constexpr std::uint16_t kLoose = 0xFFFF;

    /// Adds a plane. `facet`: facet number in the family of the plane's cell, or kLoose.
    /// Returns: the plane's number in this store.
    std::uint32_t add(const Plane& plane, std::uint16_t facet);
    void add_from(const PlaneStore& other, std::uint32_t number);
    std::uint16_t facet(std::uint32_t number) const { return facets_[number]; }
    /// Returns the distance. Requires: the plane is not loose.
    std::int64_t distance(std::uint32_t number) const { return distances_[number]; }
    /// Returns the plane. Requires: the plane is loose.
    const Plane& loose(std::uint32_t number) const {
        return loose_[static_cast<std::size_t>(distances_[number])];
    }
    std::size_t size() const { return facets_.size(); }
    void reserve(std::size_t planes, std::size_t loose);
    /// Returns the memory in bytes.
    std::size_t memory() const;

private:
    std::vector<std::int64_t> distances_;  // for loose planes: index in loose_
    std::vector<std::uint16_t> facets_;
    std::vector<Plane> loose_;
};

/// The cells of a leaf: for each cell the number, the number of planes, and the planes' numbers.
class PackedCells {
public:
    /// Unpacked form for reading and writing.
    using Words = std::vector<std::uint32_t>;
    static constexpr std::size_t kHead = 2;

    PackedCells() = default;
    PackedCells(const PackedCells& other);
    PackedCells& operator=(const PackedCells& other);
    PackedCells(PackedCells&&) noexcept = default;
    PackedCells& operator=(PackedCells&&) noexcept = default;
    ~PackedCells() = default;

    void write(const Words& words);
    /// Cost: O(words).
    void read(Words& words) const;
    bool is_empty() const { return !bytes_; }
    /// Returns the memory in bytes.
    std::size_t memory() const { return bytes_ ? size() : 0; }

private:
    std::size_t size() const;

    std::unique_ptr<std::uint8_t[]> bytes_;  // the first four bytes are the size
};

}  // namespace ncsim::cda
