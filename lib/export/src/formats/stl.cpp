// SPDX-License-Identifier: GPL-3.0-or-later
//
// Binary STL: 80 bytes of header, a count, and for each triangle a normal, three corners and two
// unused bytes; little-endian.
#include "ncsim/export/stl.h"

#include "ncsim/base/parallel.h"
#include "ncsim/cda/shape.h"
#include "ncsim/mesh/float_mesh.h"

#include "formats/file_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ncsim::exporter {

namespace {

// Must not begin with "solid", by which readers recognise the text form of STL.
constexpr std::string_view kHeader = "binary STL by ncsim, unit: millimetre";
const std::string kHeaderWithAssumptions =
    "binary STL by ncsim, unit: mm; " + std::string(cda::kAssumedMark);
constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kRecordSize = 50;  // bytes of a triangle; the last two stay 0

// Writes the bytes of a number. Returns the position after the last byte.
char* put(char* at, std::uint32_t number) {
    for (int shift = 0; shift < 32; shift += 8)
        *at++ = static_cast<char>((number >> shift) & 0xFF);
    return at;
}

char* put(char* at, const mesh::FloatPoint& point) {
    for (const float coordinate : point)
        at = put(at, std::bit_cast<std::uint32_t>(coordinate));
    return at;
}

using Corners = std::array<mesh::FloatPoint, 3>;

// Returns the normal of the corners as written, so readers that check normals accept the file; zero
// if the corners are collinear.
mesh::FloatPoint normal_of(const Corners& corners) {
    const auto widened = [](const mesh::FloatPoint& p) {
        return Vec3{static_cast<double>(p[0]), static_cast<double>(p[1]),
                    static_cast<double>(p[2])};
    };
    const Vec3 a = widened(corners[0]);
    return mesh::to_floats(normalized(cross(widened(corners[1]) - a, widened(corners[2]) - a)));
}

}  // namespace

void write_stl(std::ostream& out, const TriangleMesh& mesh, std::size_t threads,
               std::string_view assumed) {
    const mesh::FloatMesh rounded = mesh::round_to_floats(mesh, {}, threads);
    if (rounded.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw std::runtime_error("too many triangles for an STL file");
    }
    std::string head(kHeader);
    if (!assumed.empty()) {
        head = kHeaderWithAssumptions;
        head += assumed;
        head.resize(std::min(head.size(), kHeaderSize));
    }
    head.resize(kHeaderSize + sizeof(std::uint32_t), '\0');
    put(head.data() + kHeaderSize, static_cast<std::uint32_t>(rounded.triangles.size()));
    out.write(head.data(), static_cast<std::streamsize>(head.size()));
    const Runs runs(rounded.triangles.size(), kFlushSize / kRecordSize);
    make_in_parallel(
        threads, runs.tasks(),
        [&](std::size_t task) {
            std::string bytes((runs.end(task) - runs.begin(task)) * kRecordSize, '\0');
            char* at = bytes.data();
            for (std::size_t t = runs.begin(task); t < runs.end(task); ++t) {
                const auto& [a, b, c] = rounded.triangles[t];
                const Corners corners{rounded.points[a], rounded.points[b], rounded.points[c]};
                char* next = put(at, normal_of(corners));
                for (const mesh::FloatPoint& corner : corners)
                    next = put(next, corner);
                at += kRecordSize;
            }
            return bytes;
        },
        [&out](std::size_t, const std::string& bytes) {
            out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        });
    if (!out) throw std::runtime_error("cannot write STL: the stream failed");
}

}  // namespace ncsim::exporter
