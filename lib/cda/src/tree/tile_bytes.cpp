// SPDX-License-Identifier: GPL-3.0-or-later
//
// Serialisation of outlines.
#include "tree/tile_bytes.h"

#include "exact/wide.h"
#include "surface/naming.h"

#include <array>
#include <bit>
#include <cmath>
#include <ostream>
#include <stdexcept>

namespace ncsim::cda {

namespace {

constexpr std::size_t kPlaneBytes = 20;  // three components of 4 bytes, a distance of 8
constexpr std::size_t kPointBytes = 36;  // three coordinates of 8 bytes, three indices of 4
constexpr std::size_t kPieceBytes = 20;

[[noreturn]] void fail(const char* why) {
    throw std::invalid_argument(why);
}

// True if components and distance have the bits of planes that come near the stock.
bool is_representable(const Plane& plane) {
    constexpr std::int64_t kMost = std::int64_t{1} << kNormalBits;
    constexpr std::int64_t kMaxPlaneOffset = 3 * (kMost << kCoordinateBits);
    bool fits = plane.d >= -kMaxPlaneOffset && plane.d <= kMaxPlaneOffset;
    for (const std::int64_t n :
         {std::int64_t{plane.nx}, std::int64_t{plane.ny}, std::int64_t{plane.nz}})
        fits = fits && n >= -kMost && n <= kMost;
    return fits && (plane.nx != 0 || plane.ny != 0 || plane.nz != 0);
}

// True if |coordinates| <= 2^26, so that rounding fits 64 bits.
bool is_near(const ExactPoint& p) {
    constexpr int kBits = kCoordinateBits + 1;
    const UInt128 most = magnitude(p.w) << kBits;
    return magnitude(p.x) <= most && magnitude(p.y) <= most && magnitude(p.z) <= most;
}

}  // namespace

void put_u32(std::ostream& out, std::uint32_t value) {
    std::array<char, 4> bytes{};
    for (char& byte : bytes) {
        byte = static_cast<char>(value & 0xffU);
        value >>= 8;
    }
    out.write(bytes.data(), bytes.size());
}

void put_u64(std::ostream& out, std::uint64_t value) {
    put_u32(out, static_cast<std::uint32_t>(value));
    put_u32(out, static_cast<std::uint32_t>(value >> 32));
}

void put_double(std::ostream& out, double value) {
    put_u64(out, std::bit_cast<std::uint64_t>(value));
}

void put_outlines(std::ostream& out, const Outlines& outlines) {
    put_u32(out, static_cast<std::uint32_t>(outlines.planes().size()));
    for (const Plane& plane : outlines.planes()) {
        for (const std::int32_t n : {plane.nx, plane.ny, plane.nz})
            put_u32(out, static_cast<std::uint32_t>(n));
        put_u64(out, static_cast<std::uint64_t>(plane.d));
    }
    put_u32(out, static_cast<std::uint32_t>(outlines.points().size()));
    for (const Outlines::Point& point : outlines.points()) {
        for (const std::int64_t x : point.fixed.at)
            put_u64(out, static_cast<std::uint64_t>(x));
        for (const std::uint32_t plane : point.planes)
            put_u32(out, plane);
    }
    put_u32(out, static_cast<std::uint32_t>(outlines.pieces().size()));
    for (const Outlines::Piece& piece : outlines.pieces()) {
        for (const std::uint32_t n :
             {piece.plane, piece.edge, static_cast<std::uint32_t>(piece.origin), piece.tail,
              piece.head})
            put_u32(out, n);
    }
}

std::uint32_t TileBytes::u32() {
    if (bytes_.size() < 4) fail("it breaks off");
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<std::uint8_t>(bytes_[i]);
    bytes_.remove_prefix(4);
    return value;
}

std::uint64_t TileBytes::u64() {
    const std::uint64_t low = u32();
    return low | std::uint64_t{u32()} << 32;
}

double TileBytes::number() {
    const auto value = std::bit_cast<double>(u64());
    if (!std::isfinite(value)) fail("a number is none");
    return value;
}

std::uint32_t TileBytes::count(std::size_t bytes_each) {
    const std::uint32_t n = u32();
    if (n > bytes_.size() / bytes_each) fail("it breaks off");
    return n;
}

Outlines TileBytes::outlines() {
    Outlines outlines;
    const std::uint32_t planes = count(kPlaneBytes);
    for (std::uint32_t i = 0; i < planes; ++i) {
        Plane plane;
        plane.nx = static_cast<std::int32_t>(u32());
        plane.ny = static_cast<std::int32_t>(u32());
        plane.nz = static_cast<std::int32_t>(u32());
        plane.d = static_cast<std::int64_t>(u64());
        if (!is_representable(plane)) fail("a plane is none of a part");
        outlines.add_plane(plane);
    }
    const std::uint32_t points = count(kPointBytes);
    for (std::uint32_t i = 0; i < points; ++i) {
        Outlines::Point point;
        for (std::int64_t& x : point.fixed.at)
            x = static_cast<std::int64_t>(u64());
        for (std::uint32_t& plane : point.planes) {
            plane = u32();
            if (plane >= planes) fail("a point is in a plane that is not there");
        }
        const auto at = [&](std::size_t k) { return outlines.planes()[point.planes[k]]; };
        const auto exact = meet_exactly(at(0), at(1), at(2));
        if (!exact || !is_near(*exact) || FixedPoint::of(*exact) != point.fixed)
            fail("a point is not where its planes meet");
        outlines.add_point(point);
    }
    const std::uint32_t pieces = count(kPieceBytes);
    for (std::uint32_t i = 0; i < pieces; ++i) {
        Outlines::Piece piece;
        piece.plane = u32();
        piece.edge = u32();
        piece.origin = Origin{u32()};
        piece.tail = u32();
        piece.head = u32();
        if (piece.plane / 2 >= planes || piece.edge >= planes || piece.tail >= points ||
            piece.head >= points || piece.tail == piece.head || piece.origin == kOutside) {
            fail("an edge is of something that is not there");
        }
        const Plane face = outlines.plane(piece.plane & ~1U);
        if (face.is_parallel_to(outlines.planes()[piece.edge])) fail("an edge is in no line");
        outlines.add(piece);
    }
    outlines.close();
    return outlines;
}

std::string_view TileBytes::outlines_as_bytes() {
    const std::string_view before = bytes_;
    for (const std::size_t bytes_each : {kPlaneBytes, kPointBytes, kPieceBytes}) {
        const std::size_t items = count(bytes_each);
        bytes_.remove_prefix(items * bytes_each);
    }
    return before.substr(0, before.size() - bytes_.size());
}

}  // namespace ncsim::cda
