// SPDX-License-Identifier: GPL-3.0-or-later
#include "stl_file.h"

#include "ncsim/cda/check.h"

#include "job.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <vector>

namespace ncsim::app {

namespace {

using cda::Vec3;

constexpr std::size_t kHead = 84, kRecord = 50;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    return word;
}

// Binary files may begin with "solid", too: the number of triangles tells.
std::optional<std::vector<Vec3>> read_binary(std::string_view bytes) {
    if (bytes.size() < kHead) return std::nullopt;
    const std::size_t count = word_at(bytes, kHead - 4);
    if (bytes.size() != kHead + kRecord * count) return std::nullopt;
    std::vector<Vec3> corners;
    corners.reserve(3 * count);
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Vec3 v;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t at = kHead + kRecord * t + 12 + 12 * corner + 4 * axis;
                v[static_cast<int>(axis)] = std::bit_cast<float>(word_at(bytes, at));
            }
            corners.push_back(v);
        }
    }
    return corners;
}

std::optional<std::vector<Vec3>> read_text(std::string_view text) {
    std::vector<Vec3> corners;
    for (std::size_t at = text.find("vertex"); at != std::string_view::npos;
         at = text.find("vertex", at)) {
        at += 6;
        Vec3 v;
        for (int axis = 0; axis < 3; ++axis) {
            at = text.find_first_not_of(" \t\r\n+", at);
            if (at == std::string_view::npos) return std::nullopt;
            const auto [end, error] =
                std::from_chars(text.data() + at, text.data() + text.size(), v[axis]);
            if (error != std::errc{}) return std::nullopt;
            at = static_cast<std::size_t>(end - text.data());
        }
        corners.push_back(v);
    }
    if (corners.empty() || corners.size() % 3 != 0) return std::nullopt;
    return corners;
}

}  // namespace

cda::TriangleMesh read_stl_file(const std::string& path) {
    const std::string bytes = read_text_file(path);
    auto corners = read_binary(bytes);
    if (!corners) corners = read_text(bytes);
    if (!corners) throw std::runtime_error(fmt::format("'{}' is no STL file", path));
    cda::TriangleMesh mesh;
    std::map<std::tuple<double, double, double>, std::uint32_t> known;
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < corners->size(); ++i) {
        const Vec3 v = (*corners)[i];
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
            throw std::runtime_error(fmt::format("'{}' has a corner that is no place", path));
        }
        const auto [at, is_new] =
            known.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(v);
        triangle[i % 3] = at->second;
        if (i % 3 < 2) continue;
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
            triangle[2] == triangle[0]) {
            continue;
        }
        mesh.triangles.push_back(triangle);
    }
    if (mesh.triangles.empty() || !cda::check(mesh).is_closed() || cda::volume(mesh) <= 0.0) {
        throw std::runtime_error(fmt::format(
            "the surface in '{}' is not closed, or turned inside out: what is inside of it?",
            path));
    }
    return mesh;
}

}  // namespace ncsim::app
