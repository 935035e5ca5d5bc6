// SPDX-License-Identifier: GPL-3.0-or-later
//
// What leaves know, in little memory: most of what a tree holds. Planes are without the normals
// that cells of a family have in common: ten bytes each. Lists of numbers are written as
// differences, in as few bytes as each needs.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/plane.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Room for one more, and for an eighth at most that nobody needs.
template <class T>
void make_room(std::vector<T>& items) {
    if (items.size() == items.capacity()) items.reserve(items.size() + items.size() / 8 + 16);
}

/// Planes by number.
class PlaneStore {
public:
    /// Facet of a plane whose normal is no family's.
    static constexpr std::uint16_t kLoose = 0xFFFF;

    /// `facet`: its number in the family of its cell, or kLoose. Returns its number here.
    std::uint32_t add(const Plane& plane, std::uint16_t facet);
    void add_from(const PlaneStore& other, std::uint32_t number);
    std::uint16_t facet(std::uint32_t number) const { return facets_[number]; }
    /// Of one that is not loose.
    std::int64_t distance(std::uint32_t number) const { return distances_[number]; }
    /// Of one that is.
    const Plane& loose(std::uint32_t number) const {
        return loose_[static_cast<std::size_t>(distances_[number])];
    }
    std::size_t size() const { return facets_.size(); }
    void reserve(std::size_t planes, std::size_t loose);
    /// Bytes held.
    std::size_t memory() const;

private:
    std::vector<std::int64_t> distances_;  // of loose ones: where in loose_
    std::vector<std::uint16_t> facets_;
    std::vector<Plane> loose_;
};

/// Of each cell of a leaf its number, how many planes, and the numbers of these.
class PackedCells {
public:
    /// In this form they are read and written.
    using Words = std::vector<std::uint32_t>;
    static constexpr std::size_t kHead = 2;

    PackedCells() = default;
    PackedCells(const PackedCells& other);
    PackedCells& operator=(const PackedCells& other);
    PackedCells(PackedCells&&) noexcept = default;
    PackedCells& operator=(PackedCells&&) noexcept = default;
    ~PackedCells() = default;

    void write(const Words& words);
    /// O(words).
    void read(Words& words) const;
    bool is_empty() const { return !bytes_; }
    /// Bytes held.
    std::size_t memory() const { return bytes_ ? size() : 0; }

private:
    std::size_t size() const;

    std::unique_ptr<std::uint8_t[]> bytes_;  // first, in four of them, how many
};

}  // namespace ncsim::cda
