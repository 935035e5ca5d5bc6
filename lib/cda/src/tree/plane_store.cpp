// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compact storage of planes and of lists of cells.
#include "tree/plane_store.h"

#include <algorithm>
#include <cstring>

namespace ncsim::cda {

namespace {

// Writes seven bits per byte, the lowest first; the highest bit marks that more bytes follow.
void put(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
    for (; value >= 0x80; value >>= 7)
        bytes.push_back(static_cast<std::uint8_t>(value | 0x80));
    bytes.push_back(static_cast<std::uint8_t>(value));
}

std::uint32_t get(const std::uint8_t*& at) {
    std::uint32_t value = 0;
    for (int shift = 0;; shift += 7) {
        const std::uint32_t byte = *at++;
        value |= (byte & 0x7F) << shift;
        if (byte < 0x80) return value;
    }
}

// Maps 0, -1, 1, -2 … to 0, 1, 2, 3 …, modulo 2^32.
std::uint32_t zigzag(std::uint32_t difference) {
    return (difference << 1) ^ (0U - (difference >> 31));
}
std::uint32_t unzigzag(std::uint32_t value) {
    return (value >> 1) ^ (0U - (value & 1));
}

}  // namespace

std::uint32_t PlaneStore::add(const Plane& plane, std::uint16_t facet) {
    make_room(distances_);
    make_room(facets_);
    if (facet == kLoose) {
        distances_.push_back(static_cast<std::int64_t>(loose_.size()));
        make_room(loose_);
        loose_.push_back(plane);
    } else {
        distances_.push_back(plane.d);
    }
    facets_.push_back(facet);
    return static_cast<std::uint32_t>(facets_.size() - 1);
}

void PlaneStore::add_from(const PlaneStore& other, std::uint32_t number) {
    const std::uint16_t facet = other.facet(number);
    Plane plane;
    if (facet == kLoose) {
        plane = other.loose(number);
    } else {
        plane.d = other.distance(number);
    }
    add(plane, facet);
}

void PlaneStore::reserve(std::size_t planes, std::size_t loose) {
    distances_.reserve(planes);
    facets_.reserve(planes);
    loose_.reserve(loose);
}

std::size_t PlaneStore::memory() const {
    return distances_.capacity() * sizeof(std::int64_t) +
           facets_.capacity() * sizeof(std::uint16_t) + loose_.capacity() * sizeof(Plane);
}

PackedCells::PackedCells(const PackedCells& other) {
    if (other.is_empty()) return;
    bytes_ = std::make_unique_for_overwrite<std::uint8_t[]>(other.size());
    std::copy_n(other.bytes_.get(), other.size(), bytes_.get());
}

PackedCells& PackedCells::operator=(const PackedCells& other) {
    if (this != &other) *this = PackedCells(other);
    return *this;
}

std::size_t PackedCells::size() const {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes_.get(), sizeof(size));
    return size;
}

void PackedCells::write(const Words& words) {
    bytes_.reset();
    if (words.empty()) return;
    thread_local std::vector<std::uint8_t> bytes;
    bytes.assign(sizeof(std::uint32_t), 0);
    std::uint32_t cell = 0;
    std::uint32_t plane = 0;
    for (std::size_t at = 0; at < words.size();) {
        put(bytes, zigzag(words[at] - cell));
        cell = words[at++];
        std::uint32_t planes = words[at++];
        for (put(bytes, planes); planes > 0; --planes) {
            put(bytes, zigzag(words[at] - plane));
            plane = words[at++];
        }
    }
    const auto size = static_cast<std::uint32_t>(bytes.size());
    std::memcpy(bytes.data(), &size, sizeof(size));
    bytes_ = std::make_unique_for_overwrite<std::uint8_t[]>(size);
    std::copy(bytes.begin(), bytes.end(), bytes_.get());
}

void PackedCells::read(Words& words) const {
    words.clear();
    if (is_empty()) return;
    std::uint32_t cell = 0;
    std::uint32_t plane = 0;
    const std::uint8_t* at = bytes_.get() + sizeof(std::uint32_t);
    for (const std::uint8_t* const end = bytes_.get() + size(); at != end;) {
        words.push_back(cell += unzigzag(get(at)));
        std::uint32_t planes = get(at);
        for (words.push_back(planes); planes > 0; --planes)
            words.push_back(plane += unzigzag(get(at)));
    }
}

}  // namespace ncsim::cda
