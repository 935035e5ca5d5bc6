// SPDX-License-Identifier: GPL-3.0-or-later
//
// 80 bytes of header, a count, and for each triangle its normal, its corners and two bytes without
// meaning; little-endian.
#include "ncsim/export/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::exporter {

namespace {

using FloatPoint = std::array<float, 3>;

// Must not begin with "solid": by that word readers tell the text form of STL.
constexpr std::string_view kHeader = "binary STL by ncsim, unit: millimetre";
constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFlushSize = std::size_t{1} << 20;

void append(std::string& bytes, std::uint32_t number) {
    for (int shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<char>((number >> shift) & 0xFF));
    }
}

void append(std::string& bytes, const FloatPoint& point) {
    for (const float coordinate : point)
        append(bytes, std::bit_cast<std::uint32_t>(coordinate));
}

// Adding zero turns -0 into 0: some readers compare corners byte by byte.
FloatPoint to_float(cda::Vec3 p) {
    return {static_cast<float>(p.x) + 0.0F, static_cast<float>(p.y) + 0.0F,
            static_cast<float>(p.z) + 0.0F};
}

using Corners = std::array<FloatPoint, 3>;

// Of the corners as they are written, so that readers who check it find it right. Zero if they
// lie on a line.
FloatPoint normal_of(const Corners& corners) {
    const auto widened = [](const FloatPoint& p) {
        return cda::Vec3{static_cast<double>(p[0]), static_cast<double>(p[1]),
                         static_cast<double>(p[2])};
    };
    const cda::Vec3 a = widened(corners[0]);
    return to_float(cda::normalized(cda::cross(widened(corners[1]) - a, widened(corners[2]) - a)));
}

// Each distinct float point gets a number.
std::vector<std::uint32_t> number_points(const std::vector<FloatPoint>& points) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(points[a], a) < std::pair(points[b], b);
    });
    std::vector<std::uint32_t> numbers(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_new = i == 0 || points[order[i]] != points[order[i - 1]];
        numbers[order[i]] = is_new ? order[i] : numbers[order[i - 1]];
    }
    return numbers;
}

// Readers know corners by their coordinates alone. Where surfaces touch, or lie so near each other
// that floats cannot tell, corners that no edge connects would become one, and edges stand more
// than twice: all but the first move on by the least that floats can, in z, then y, then x.
void keep_apart(const cda::TriangleMesh& mesh, std::vector<FloatPoint>& points) {
    // Corners that an edge connects may fall together: their triangles go.
    std::vector<std::uint32_t> first(points.size());
    std::iota(first.begin(), first.end(), 0U);
    const auto find = [&](std::uint32_t v) {
        while (first[v] != v)
            v = first[v] = first[first[v]];
        return v;
    };
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = find(t[i]);
            const std::uint32_t b = find(t[(i + 1) % 3]);
            if (points[t[i]] == points[t[(i + 1) % 3]]) first[std::max(a, b)] = std::min(a, b);
        }
    }
    std::set<FloatPoint> taken;
    for (std::uint32_t v = 0; v < points.size(); ++v) {
        if (find(v) != v) {
            points[v] = points[find(v)];
            continue;
        }
        for (std::size_t axis = 2; !taken.insert(points[v]).second; axis = (axis + 2) % 3) {
            points[v][axis] = std::nextafter(points[v][axis], std::numeric_limits<float>::max());
        }
    }
}

// The triangles that are written, in the order of `mesh`.
std::vector<std::uint32_t> real_triangles(const cda::TriangleMesh& mesh,
                                          const std::vector<FloatPoint>& points) {
    const std::vector<std::uint32_t> numbers = number_points(points);
    // By corners, ascending; then those of one orientation, then those of the other.
    struct Key {
        std::array<std::uint32_t, 3> corners;
        bool is_odd;
        std::uint32_t triangle;
        auto operator<=>(const Key&) const = default;
    };
    std::vector<Key> keys;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<std::uint32_t, 3> c{};
        for (std::size_t i = 0; i < 3; ++i)
            c[i] = numbers[mesh.triangles[t][i]];
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
        const bool is_odd = (c[0] > c[1]) != ((c[1] > c[2]) != (c[0] > c[2]));
        std::sort(c.begin(), c.end());
        keys.push_back({c, is_odd, t});
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> result;
    for (std::size_t begin = 0; begin < keys.size();) {
        std::size_t end = begin;
        while (end < keys.size() && keys[end].corners == keys[begin].corners)
            ++end;
        const auto even = static_cast<std::size_t>(
            std::count_if(keys.begin() + static_cast<std::ptrdiff_t>(begin),
                          keys.begin() + static_cast<std::ptrdiff_t>(end),
                          [](const Key& key) { return !key.is_odd; }));
        const std::size_t odd = end - begin - even;
        const std::size_t pairs = std::min(even, odd);
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t rank = keys[i].is_odd ? i - begin - even : i - begin;
            if (rank >= pairs) result.push_back(keys[i].triangle);
        }
        begin = end;
    }
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace

void write_stl(std::ostream& out, const cda::TriangleMesh& mesh) {
    std::vector<FloatPoint> points;
    points.reserve(mesh.vertices.size());
    for (const cda::Vec3& p : mesh.vertices)
        points.push_back(to_float(p));
    keep_apart(mesh, points);
    const std::vector<std::uint32_t> triangles = real_triangles(mesh, points);
    if (triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw std::runtime_error("too many triangles for an STL file");
    }
    std::string bytes(kHeader);
    bytes.resize(kHeaderSize, '\0');
    append(bytes, static_cast<std::uint32_t>(triangles.size()));
    for (const std::uint32_t t : triangles) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Corners corners{points[a], points[b], points[c]};
        append(bytes, normal_of(corners));
        for (const FloatPoint& corner : corners)
            append(bytes, corner);
        bytes.append(2, '\0');
        if (bytes.size() >= kFlushSize) {
            out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
            bytes.clear();
        }
    }
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out) throw std::runtime_error("cannot write STL: the stream failed");
}

}  // namespace ncsim::exporter
