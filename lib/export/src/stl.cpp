// SPDX-License-Identifier: GPL-3.0-or-later
//
// 80 bytes of header, a count, and for each triangle its normal, its corners and two bytes without
// meaning; little-endian.
#include "ncsim/export/stl.h"

#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

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

bool is_degenerate(const FloatPoint& a, const FloatPoint& b, const FloatPoint& c) {
    return a == b || b == c || c == a;
}

FloatPoint normal_of(cda::Vec3 a, cda::Vec3 b, cda::Vec3 c) {
    return to_float(cda::normalized(cda::cross(b - a, c - a)));
}

}  // namespace

void write_stl(std::ostream& out, const cda::TriangleMesh& mesh) {
    if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw std::runtime_error("too many triangles for an STL file");
    }
    std::string bytes(kHeader);
    bytes.resize(kHeaderSize, '\0');
    append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        const cda::Vec3 a = mesh.vertices[triangle[0]];
        const cda::Vec3 b = mesh.vertices[triangle[1]];
        const cda::Vec3 c = mesh.vertices[triangle[2]];
        const std::array corners{to_float(a), to_float(b), to_float(c)};
        const bool degenerate = is_degenerate(corners[0], corners[1], corners[2]);
        append(bytes, degenerate ? FloatPoint{} : normal_of(a, b, c));
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
