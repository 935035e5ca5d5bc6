// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading and writing of stock files.
#include "ncsim/base/number_text.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/shape.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <istream>
#include <map>
#include <numeric>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace ncsim::cda {

namespace {

using Normal = std::array<std::int64_t, 3>;

constexpr std::string_view kMagic = "ncsim stock 3";
constexpr std::string_view kMagicWithoutSources = "ncsim stock 2";
constexpr std::string_view kMagicWithoutAssumptions = "ncsim stock 1";
constexpr const char* kUnknownAssumptions =
    "its format, of ncsim 0.1, does not record the assumptions of the run that wrote it";
// Limits for damaged files; runs write far fewer and shorter lines.
constexpr std::size_t kMostAssumed = 10000;
constexpr std::size_t kLongestAssumed = 2000;
constexpr std::size_t kLongestSource = 20000;
constexpr std::size_t kMostSurfacesOfASource = 10000;
// More planes than any hull has; a limit for damaged files.
constexpr std::size_t kMostPlanes = 65536;
// |d| of planes that pass within kMaxPose of the origin is below this value.
constexpr std::int64_t kMostDistance = std::int64_t{1} << 62;

// Writes cells, with each normal once.
class CellWriter {
public:
    explicit CellWriter(std::ostream& out) : out_(out) {}

    void write(std::string_view name, const Cell& cell) {
        std::string line(name);
        for (const Plane& plane : cell.planes) {
            const auto [at, is_new] =
                normals_.try_emplace({plane.nx, plane.ny, plane.nz}, normals_.size());
            if (is_new) {
                out_ << "normal " + std::to_string(plane.nx) + ' ' + std::to_string(plane.ny) +
                            ' ' + std::to_string(plane.nz) + '\n';
            }
            line += ' ' + std::to_string(at->second) + ' ' + std::to_string(plane.d);
        }
        out_ << line << '\n';
    }

private:
    std::ostream& out_;
    std::map<Normal, std::size_t> normals_;
};

}  // namespace

void write_shape(std::ostream& out, const Shape& shape) {
    out << kMagic << '\n';
    for (std::size_t i = 0; i < std::min(shape.assumed.size(), kMostAssumed); ++i)
        out << "assumed " << std::string_view(shape.assumed[i]).substr(0, kLongestAssumed) << '\n';
    out << "unit " << shortest(shape.lattice.unit_mm) << '\n';
    for (const ShapeSource& source : shape.sources) {
        out << "source " << source.text << '\n';
        for (const std::string& surface : source.surfaces)
            out << "surface " << surface << '\n';
    }
    CellWriter writer(out);
    writer.write("outer", shape.outer);
    Origin origin = kStockOrigin;
    for (const Cell& cell : shape.carved) {
        if (!shape.sources.empty() && cell.origin != origin) {
            origin = cell.origin;
            out << "origin " + std::to_string(static_cast<std::uint32_t>(origin)) + '\n';
        }
        writer.write("cell", cell);
    }
    out << "end " + std::to_string(shape.carved.size()) + '\n';
}

namespace {

class Reader {
public:
    explicit Reader(std::istream& in) : in_(in) {}

    Shape read() {
        const bool is_known = next() && (line_ == kMagic || line_ == kMagicWithoutSources ||
                                         line_ == kMagicWithoutAssumptions);
        if (!is_known) refuse("not a stock that ncsim wrote");
        const bool has_sources = line_ == kMagic;
        if (line_ == kMagicWithoutAssumptions) shape_.assumed.emplace_back(kUnknownAssumptions);
        read_head();
        bool has_outer = false;
        while (next()) {
            if (word("normal")) {
                read_normal();
            } else if (has_sources && !has_outer && word("source ")) {
                read_source();
            } else if (!has_outer && !shape_.sources.empty() && word("surface ")) {
                read_surface();
            } else if (!has_outer && word("outer")) {
                shape_.outer = read_cell();
                check_outer();
                has_outer = true;
            } else if (has_outer && has_sources && word("origin")) {
                read_origin();
            } else if (has_outer && word("cell")) {
                shape_.carved.push_back(read_cell());
                shape_.carved.back().bounds = bounds_of(shape_.carved.back());
                shape_.carved.back().origin = origin_;
            } else if (has_outer && word("end")) {
                std::size_t count = 0;
                if (!number(count) || !is_at_end() || count != shape_.carved.size()) {
                    refuse("expected the number of cells above");
                }
                return std::move(shape_);
            } else {
                refuse("expected source, normal, outer, origin, cell or end, in this order");
            }
        }
        refuse("the file breaks off");
    }

private:
    [[noreturn]] void refuse(const char* why) const {
        throw std::runtime_error(std::to_string(count_) + ": " + why);
    }
    // Reads assumptions and lattice.
    void read_head() {
        bool has_line = next();
        while (has_line && word("assumed ")) {
            if (shape_.assumed.size() == kMostAssumed || rest_.size() > kLongestAssumed)
                refuse("more assumptions than a run makes");
            shape_.assumed.emplace_back(rest_);
            has_line = next();
        }
        if (!has_line || !word("unit")) refuse("expected the lattice: unit 1e-05");
        double unit = 0.0;
        if (!number(unit) || !is_unit(unit) || !is_at_end()) {
            refuse("expected a length in mm: 1, 2 or 5 times a power of ten, at least 1e-05");
        }
        shape_.lattice.unit_mm = unit;
    }
    void read_source() {
        if (rest_.size() > kLongestSource) refuse("a longer source than ncsim writes");
        shape_.sources.push_back({std::string(rest_), {}, count_});
    }
    void read_surface() {
        std::vector<std::string>& surfaces = shape_.sources.back().surfaces;
        if (rest_.size() > kLongestSource || surfaces.size() == kMostSurfacesOfASource)
            refuse("more surfaces than a motion leaves");
        surfaces.emplace_back(rest_);
    }
    void read_origin() {
        std::uint32_t origin = 0;
        if (!number(origin) || !is_at_end() || origin >= shape_.sources.size())
            refuse("expected the number of a source above");
        origin_ = Origin{origin};
    }
    bool next() {
        ++count_;
        if (!std::getline(in_, line_)) return false;
        rest_ = line_;
        return true;
    }
    bool word(std::string_view name) {
        if (!rest_.starts_with(name)) return false;
        rest_.remove_prefix(name.size());
        return true;
    }
    // True if the unit is one that Lattice::for_stock() chooses; computed in the same way.
    static bool is_unit(double unit) {
        double decade = 1e-5;
        for (int k = 0; k < 12; ++k, decade *= 10.0) {
            for (const double step : {1.0, 2.0, 5.0}) {
                if (unit == step * decade) return true;
            }
        }
        return false;
    }
    bool is_at_end() const { return rest_.empty(); }
    template <class Number>
    bool number(Number& value) {
        if (!rest_.starts_with(' ')) return false;
        rest_.remove_prefix(1);
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{}) return false;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return true;
    }

    void read_normal() {
        Normal n{};
        for (std::int64_t& component : n) {
            if (!number(component)) refuse("a normal has three numbers");
            if (component > (1 << kNormalBits) || component < -(1 << kNormalBits)) {
                refuse("a normal with a component beyond 2^24");
            }
        }
        if (!is_at_end() || n == Normal{}) refuse("a normal has three numbers, not all zero");
        // Planes perpendicular to axes lie at integers: the tree depends on this property.
        if (std::gcd(std::gcd(n[0], n[1]), n[2]) != 1) refuse("a normal with a common divisor");
        normals_.push_back(n);
    }

    Cell read_cell() {
        Cell cell;
        std::unordered_set<Plane, PlaneHash> known;
        while (!is_at_end()) {
            std::size_t normal = 0;
            std::int64_t d = 0;
            if (!number(normal) || !number(d)) refuse("a cell is pairs of whole numbers");
            if (normal >= normals_.size()) refuse("a normal that was not given before");
            if (d > kMostDistance || d < -kMostDistance) refuse("a distance beyond 2^62");
            const Normal& n = normals_[normal];
            const Plane plane = canonical(n[0], n[1], n[2], d);
            if (known.insert(plane).second) cell.planes.push_back(plane);
            if (cell.planes.size() > kMostPlanes) refuse("a cell with more than 65536 planes");
        }
        return cell;
    }

    // Returns bounds from the axis-parallel planes, which all cells written by ncsim have, within
    // the outer bounds.
    Box bounds_of(const Cell& cell) const {
        Box box = shape_.outer.bounds;
        for (const Plane& plane : cell.planes) {
            const std::array<std::int32_t, 3> n{plane.nx, plane.ny, plane.nz};
            for (int i = 0; i < 3; ++i) {
                const auto k = static_cast<std::size_t>(i);
                if (n[(k + 1) % 3] != 0 || n[(k + 2) % 3] != 0) continue;
                const double wall = shape_.lattice.unit_mm *
                                    (static_cast<double>(plane.d) / static_cast<double>(n[k]));
                if (n[k] > 0) box.max[i] = std::min(box.max[i], wall);
                if (n[k] < 0) box.min[i] = std::max(box.min[i], wall);
            }
        }
        return box;
    }

    // Checks that the outer cell is bounded, within the range of the lattice, and has volume, by
    // clipping the whole lattice.
    void check_outer() {
        constexpr std::int64_t kReach = std::int64_t{1} << kCoordinateBits;
        constexpr LatticePoint kMin{-kReach, -kReach, -kReach};
        constexpr LatticePoint kMax{kReach, kReach, kReach};
        const Cell world = box_cell(kMin, kMax, shape_.lattice);
        std::optional<ConvexPolytope> body = ConvexPolytope::of(world, shape_.lattice);
        for (const Plane& plane : shape_.outer.planes) {
            const Side side = classify_box(body->bounds(), plane);
            if (side == Side::Below) continue;
            if (side == Side::On) body = body->clip(plane);
            if (side == Side::Above || !body) refuse("the outer cell has no volume");
        }
        // If a side of the lattice remains, no plane bounds the cell there.
        for (const Plane& side : world.planes) {
            const auto& its_own = shape_.outer.planes;
            if (body->facet_in(side) &&
                std::find(its_own.begin(), its_own.end(), side) == its_own.end()) {
                refuse("the outer cell reaches beyond the lattice");
            }
        }
        shape_.outer.bounds = {shape_.lattice.to_mm(body->bounds().min),
                               shape_.lattice.to_mm(body->bounds().max)};
    }

    std::istream& in_;
    std::string line_;
    std::string_view rest_;
    std::size_t count_ = 0;
    std::vector<Normal> normals_;
    Origin origin_ = kStockOrigin;
    Shape shape_;
};

}  // namespace

Shape read_shape(std::istream& in) {
    return Reader(in).read();
}

}  // namespace ncsim::cda
