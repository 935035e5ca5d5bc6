// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds between normals, in SIMD lanes.
#include "tree/normal_table.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ncsim::cda {

namespace {

// Lanes of a vector that every machine of the target architecture supports.
constexpr std::size_t kFloats = 4;
using Floats = float __attribute__((vector_size(kFloats * sizeof(float))));

// Row sizes are multiples of this number, so no loop over a row has a remainder.
constexpr std::size_t kLanes = 2 * kFloats;
// Multipliers above this value would exceed the rounding margin; the bounds would be weak.
constexpr float kSteepest = 4.0F;

Floats load(const float* from) {
    Floats result;
    std::memcpy(&result, from, sizeof result);
    return result;
}
void store(Floats x, float* to) {
    std::memcpy(to, &x, sizeof x);
}
Floats all(float x) {
    return Floats{} + x;
}
Floats size_of(Floats x) {
    return x < 0.0F ? -x : x;
}

struct Bounds {
    Floats slope, offset;
};

Bounds bounds_from(Floats length, Floats across_1, Floats across_2, Floats m, Floats m_1,
                   Floats m_2) {
    const Floats slope = length / m;
    const auto tells = (slope > 0.0F) & (slope <= kSteepest);
    const Floats offset = size_of(across_1 - slope * m_1) + size_of(across_2 - slope * m_2);
    return {tells ? slope : Floats{}, tells ? offset : all(row::kUnknown)};
}

}  // namespace

std::size_t ScaledNormal::longest_axis() const {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(n[i]) > std::abs(n[axis])) axis = i;
    }
    return axis;
}

Bound bound_along(const ScaledNormal& p, const ScaledNormal& m) {
    const std::size_t k = p.longest_axis();
    const std::size_t u = k == 2 ? 0 : k + 1;
    const std::size_t v = k == 0 ? 2 : k - 1;
    const Bounds bounds =
        bounds_from(all(p.n[k]), all(p.n[u]), all(p.n[v]), all(m.n[k]), all(m.n[u]), all(m.n[v]));
    return {bounds.slope[0], bounds.offset[0]};
}

// Calls take(i, bounds) for groups of kFloats columns from i on, with the bounds that follow from a
// plane along `m`.
template <class Take>
void NormalTable::for_bounds(const ScaledNormal& m, Take take) const {
    for (std::size_t k = 0; k < 3; ++k) {
        const Floats along = all(m.n[k]);
        const Floats m_1 = all(m.n[k == 2 ? 0 : k + 1]);
        const Floats m_2 = all(m.n[k == 0 ? 2 : k - 1]);
        for (std::size_t i = groups_[k].begin; i < groups_[k].end; i += kFloats) {
            take(i, bounds_from(load(&length_[i]), load(&across_[0][i]), load(&across_[1][i]),
                                along, m_1, m_2));
        }
    }
}

void NormalTable::assign(std::span<const ScaledNormal> normals) {
    std::array<std::size_t, 3> sizes{};
    for (const ScaledNormal& normal : normals)
        ++sizes[normal.longest_axis()];
    // Columns without a normal fill the groups up; no plane bounds them.
    std::size_t begin = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        groups_[k] = {begin, begin};
        begin += (sizes[k] + kFloats - 1) / kFloats * kFloats;
    }
    stride_ = (begin + kLanes - 1) / kLanes * kLanes;
    length_.assign(stride_, 0.0F);
    across_[0].assign(stride_, 0.0F);
    across_[1].assign(stride_, 0.0F);
    columns_.resize(normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const ScaledNormal& normal = normals[i];
        const std::size_t k = normal.longest_axis();
        const std::size_t column = groups_[k].end++;
        columns_[i] = static_cast<std::uint32_t>(column);
        length_[column] = normal.n[k];
        across_[0][column] = normal.n[k == 2 ? 0 : k + 1];
        across_[1][column] = normal.n[k == 0 ? 2 : k - 1];
    }
    for (Group& group : groups_)
        group.end = group.begin + (group.end - group.begin + kFloats - 1) / kFloats * kFloats;
    const std::size_t entries = stride_ * stride_;
    if (slopes_.size() < entries) {
        slopes_.resize(2 * entries);
        offsets_.resize(2 * entries);
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const std::size_t first = columns_[i] * stride_;
        float* const slopes = &slopes_[first];
        float* const offsets = &offsets_[first];
        for_bounds(normals[i], [=](std::size_t k, const Bounds& bounds) {
            store(bounds.slope, slopes + k);
            store(bounds.offset, offsets + k);
        });
        for (std::size_t k = begin; k < stride_; ++k) {
            slopes[k] = 0.0F;
            offsets[k] = row::kUnknown;
        }
        // A plane gives no bound on itself.
        slopes_[first + columns_[i]] = 0.0F;
        offsets_[first + columns_[i]] = row::kUnknown;
    }
}

void NormalTable::bound_by(std::uint32_t column, float e, float* row) const {
    const float* const slopes = &slopes_[column * stride_];
    const float* const offsets = &offsets_[column * stride_];
    for (std::size_t i = 0; i < stride_; ++i)
        row[i] = std::min(row[i], slopes[i] * e + offsets[i]);
}

void NormalTable::bound_by(const ScaledNormal& m, float e, float* row) const {
    for_bounds(m, [=](std::size_t i, const Bounds& bounds) {
        const Floats bound = bounds.slope * e + bounds.offset;
        const Floats before = load(row + i);
        store(bound < before ? bound : before, row + i);
    });
}

void SeenPlanes::clear() {
    for (std::vector<float>& component : n_)
        component.clear();
    e_.clear();
}

void SeenPlanes::add(const ScaledNormal& normal, float e) {
    for (std::size_t i = 0; i < 3; ++i)
        n_[i].push_back(normal.n[i]);
    e_.push_back(e);
}

std::size_t SeenPlanes::end_group() {
    // Planes without a normal imply nothing.
    while (e_.size() % kFloats != 0)
        add({}, 0.0F);
    return e_.size();
}

bool SeenPlanes::imply(std::size_t begin, std::size_t end, const ScaledNormal& p, float e) const {
    const std::size_t k = p.longest_axis();
    const std::size_t u = k == 2 ? 0 : k + 1;
    const std::size_t v = k == 0 ? 2 : k - 1;
    // Same formula as bounds_from().
    const Floats length = all(p.n[k]);
    const Floats across_1 = all(p.n[u]);
    const Floats across_2 = all(p.n[v]);
    for (std::size_t i = begin; i < end; i += kFloats) {
        const Floats slope = length / load(&n_[k][i]);
        const Floats bound = slope * load(&e_[i]) + size_of(across_1 - slope * load(&n_[u][i])) +
                             size_of(across_2 - slope * load(&n_[v][i])) + row::kMargin;
        const auto implied = (slope > 0.0F) & (slope <= kSteepest) & (bound < e);
        if ((implied[0] | implied[1] | implied[2] | implied[3]) != 0) return true;
    }
    return false;
}

bool is_below(const float* a, const float* b, std::size_t size) {
    for (std::size_t i = 0; i < size; i += kLanes) {
        const auto above =
            (load(a + i) > load(b + i)) | (load(a + i + kFloats) > load(b + i + kFloats));
        if ((above[0] | above[1] | above[2] | above[3]) != 0) return false;
    }
    return true;
}

}  // namespace ncsim::cda
