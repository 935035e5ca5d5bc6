// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads STL and glTF files and checks the meshes.
#include "support/written_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace ncsim::test {

namespace {

using Point = std::array<float, 3>;
using Vector = std::array<double, 3>;

template <typename T>
T at(const std::string& bytes, std::size_t offset) {
    T value{};
    if (offset + sizeof value > bytes.size()) throw std::runtime_error("the file ends too early");
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

// Merges equal corners. `corners` has three points per triangle.
WrittenMesh welded(const std::vector<Point>& corners) {
    WrittenMesh mesh;
    mesh.points = corners;
    std::sort(mesh.points.begin(), mesh.points.end());
    mesh.points.erase(std::unique(mesh.points.begin(), mesh.points.end()), mesh.points.end());
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        std::array<std::uint32_t, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto found =
                std::lower_bound(mesh.points.begin(), mesh.points.end(), corners[i + k]);
            triangle[k] = static_cast<std::uint32_t>(found - mesh.points.begin());
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

Vector between(const Point& a, const Point& b) {
    Vector v{};
    for (std::size_t i = 0; i < 3; ++i)
        v[i] = static_cast<double>(b[i]) - static_cast<double>(a[i]);
    return v;
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double norm(const Vector& v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

}  // namespace

WrittenMesh read_stl(const std::string& bytes) {
    constexpr std::size_t kHead = 84, kRecord = 50;
    const std::size_t count = at<std::uint32_t>(bytes, kHead - 4);
    if (bytes.size() != kHead + kRecord * count) throw std::runtime_error("not binary STL");
    std::vector<Point> corners, normals;
    for (std::size_t t = 0; t < count; ++t) {
        normals.push_back(at<Point>(bytes, kHead + kRecord * t));
        for (std::size_t k = 1; k < 4; ++k)
            corners.push_back(at<Point>(bytes, kHead + kRecord * t + 12 * k));
    }
    WrittenMesh mesh = welded(corners);
    mesh.normals = std::move(normals);
    return mesh;
}

WrittenMesh read_glb(const std::string& bytes) {
    if (bytes.substr(0, 4) != "glTF") throw std::runtime_error("not binary glTF");
    const std::size_t length = at<std::uint32_t>(bytes, 12);
    const nlohmann::json scene = nlohmann::json::parse(bytes.substr(20, length));
    const std::size_t buffer = 20 + length + 8;
    std::vector<Point> corners;
    if (!scene.contains("meshes")) return {};
    for (const auto& primitive : scene["meshes"][0]["primitives"]) {
        const auto& indices = scene["accessors"][primitive["indices"].get<std::size_t>()];
        const auto& positions =
            scene["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
        const auto start = [&](const nlohmann::json& accessor) {
            const auto& view = scene["bufferViews"][accessor["bufferView"].get<std::size_t>()];
            return buffer + view.value("byteOffset", std::size_t{0});
        };
        constexpr int kUnsignedShort = 5123;
        const bool is_short = indices["componentType"] == kUnsignedShort;
        for (std::size_t i = 0; i < indices["count"].get<std::size_t>(); ++i) {
            const std::size_t corner =
                is_short ? std::size_t{at<std::uint16_t>(bytes, start(indices) + 2 * i)}
                         : std::size_t{at<std::uint32_t>(bytes, start(indices) + 4 * i)};
            corners.push_back(at<Point>(bytes, start(positions) + 12 * corner));
        }
    }
    return welded(corners);
}

Soundness soundness(const WrittenMesh& mesh) {
    Soundness found;
    found.triangles = mesh.triangles.size();
    const Point apex = mesh.points.empty() ? Point{} : mesh.points[mesh.points.size() / 2];
    for (const Point& p : mesh.points) {
        for (const float x : p)
            found.largest = std::max(found.largest, std::abs(static_cast<double>(x)));
    }
    // Directed edges with their places. Place = 3 · triangle + index of the corner where the edge
    // begins.
    std::vector<std::array<std::uint32_t, 3>> edges;
    double sixfold = 0.0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vector doubled =
            cross(between(mesh.points[a], mesh.points[b]), between(mesh.points[a], mesh.points[c]));
        if (a == b || b == c || c == a) {
            ++found.repeated;
        } else if (norm(doubled) == 0.0) {
            ++found.flat;
        }
        found.area += 0.5 * norm(doubled);
        const Vector from = between(apex, mesh.points[a]);
        sixfold += from[0] * doubled[0] + from[1] * doubled[1] + from[2] * doubled[2];
        edges.insert(edges.end(), {{a, b, 3 * t}, {b, c, 3 * t + 1}, {c, a, 3 * t + 2}});
    }
    found.volume = sixfold / 6.0;
    std::sort(edges.begin(), edges.end());
    const auto all = [&](std::uint32_t from, std::uint32_t to) {
        return std::equal_range(edges.begin(), edges.end(), std::array{from, to, 0U},
                                [](const auto& p, const auto& q) {
                                    return std::pair(p[0], p[1]) < std::pair(q[0], q[1]);
                                });
    };

    // Triangles around a corner are joined across edges into one or more fans.
    std::vector<std::uint32_t> fan(edges.size());
    std::iota(fan.begin(), fan.end(), 0U);
    const auto first_of = [&](std::uint32_t i) {
        while (fan[i] != i)
            i = fan[i] = fan[fan[i]];
        return i;
    };
    for (const auto& [from, to, place] : edges) {
        const auto [begin, end] = all(from, to);
        const auto [back, back_end] = all(to, from);
        if (end - begin != 1 || back_end - back != 1) {
            ++found.unpaired;
            continue;
        }
        // The next place in the adjacent triangle belongs to the same corner.
        const std::uint32_t other = (*back)[2];
        fan[first_of(place)] = first_of(other - other % 3 + (other % 3 + 1) % 3);
    }
    std::vector<std::size_t> fans(mesh.points.size(), 0);
    for (std::uint32_t i = 0; i < fan.size(); ++i) {
        if (fan[i] == i) ++fans[mesh.triangles[i / 3][i % 3]];
    }
    found.pinched = static_cast<std::size_t>(
        std::count_if(fans.begin(), fans.end(), [](std::size_t n) { return n > 1; }));
    return found;
}

std::string to_string(const Soundness& found) {
    return std::to_string(found.triangles) + " triangles, " + std::to_string(found.repeated) +
           " with a corner twice, " + std::to_string(found.flat) + " flat, " +
           std::to_string(found.unpaired) + " edges unpaired, " + std::to_string(found.pinched) +
           " corners pinched, volume " + std::to_string(found.volume);
}

}  // namespace ncsim::test
