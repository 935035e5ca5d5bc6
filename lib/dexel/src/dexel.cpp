// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dexel model: rays, batches of waiting bodies, volume, surface.
#include "ncsim/dexel/dexel.h"

#include "ncsim/base/parallel.h"

#include "contour.h"
#include "cutter.h"
#include "open_cutter.h"
#include "rays.h"
#include "round_sweep.h"
#include "stretches.h"
#include "thin_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::dexel {

namespace {

// Bodies in a batch: enough work for all threads, and little memory.
constexpr std::size_t kBatch = 8192;
// Cells in a batch; cells are larger, because they have all facets.
constexpr std::size_t kMostCells = 1024;
// Runs of rows per thread.
constexpr std::size_t kRuns = 4;

Vec3 in_units(Vec3 mm, const cda::Lattice& lattice) {
    return (1.0 / lattice.unit_mm) * mm;
}

}  // namespace

double finest_resolution(Vec3 size) {
    const double all = size.x * size.y + size.y * size.z + size.z * size.x;
    constexpr double kEdges = 1.01;  // rays beyond the stock
    return kEdges * std::sqrt(all / kMostRays);
}

class Dexel::Impl {
public:
    explicit Impl(const DexelParameters& parameters) : parameters_(parameters) {}

    Impl(const DexelParameters& parameters, const cda::Cell& stock, const cda::Lattice& lattice)
        : parameters_(parameters), lattice_(lattice) {
        const Vec3 min = in_units(stock.bounds.min, lattice);
        const Vec3 max = in_units(stock.bounds.max, lattice);
        if (!(min.x < max.x && min.y < max.y && min.z < max.z))
            throw std::invalid_argument("stock without volume");
        const double longest = std::max({max.x - min.x, max.y - min.y, max.z - min.z});
        const double pitch = parameters.resolution_mm > 0.0
                                 ? parameters.resolution_mm / lattice.unit_mm
                                 : default_resolution(longest);
        const bool has_only_z = parameters.directions == Directions::OnlyZ;
        grid_.emplace(min, max, pitch);
        stock_.emplace(stock, lattice, *grid_);
        rays_.emplace();
        for (std::size_t axis = has_only_z ? 2 : 0; axis < 3; ++axis) {
            (*rays_)[axis] = Rays(*grid_, axis);
            Cutter(*grid_, (*rays_)[axis]).fill(*stock_);
        }
    }

    Impl(const Impl& other)
        : parameters_(other.parameters_),
          lattice_(other.lattice_),
          grid_(other.grid_),
          stock_(other.stock_),
          rays_((other.settle(), other.rays_)) {}

    const DexelParameters& parameters() const { return parameters_; }
    const cda::Lattice& lattice() const { return lattice_; }
    const Grid& grid() const { return grid_.value(); }

    void cut(const cda::Cell& cell) { add(CuttingCell(cell, lattice_, *grid_)); }
    void cut(const cda::RoundSweep& sweep) { add(SweptTool(sweep, lattice_, *grid_)); }

    const std::array<Rays, 3>& rays() const {
        settle();
        return rays_.value();
    }
    bool has_only_z() const { return parameters_.directions == Directions::OnlyZ; }
    // Returns the largest error of the mean volume in mm³, if any direction may be the right one.
    // Features shallower than the distance of the rays along a direction may be missing in that
    // direction.
    double doubtful_volume() const {
        const std::vector<double> seen = volumes();
        const double mean = mean_volume();
        double most = 0.0;
        std::size_t i = 0;
        for (const Rays& along : rays()) {
            if (along.rows() == 0) continue;
            const double of_walls =
                dexel::doubtful_volume(along, *grid_) * lattice_.cubic_unit_mm3();
            most = std::max(most, std::abs(seen[i++] - mean) + of_walls);
        }
        return most;
    }
    // Returns the area of a ray along the axis, mm².
    double area_of_ray(std::size_t axis) const {
        return grid_->axes[(axis + 1) % 3].pitch * grid_->axes[(axis + 2) % 3].pitch *
               lattice_.unit_mm * lattice_.unit_mm;
    }

    // Returns the volume of each existing direction, mm³.
    std::vector<double> volumes() const {
        std::vector<double> volumes;
        for (const Rays& along : rays()) {
            if (along.rows() == 0) continue;
            volumes.push_back(along.length() * lattice_.unit_mm * area_of_ray(along.axis()));
        }
        return volumes;
    }

    double mean_volume() const {
        const std::vector<double> seen = volumes();
        return std::accumulate(seen.begin(), seen.end(), 0.0) / static_cast<double>(seen.size());
    }

    cda::Boundary boundary() const {
        return contour(*grid_, rays(), *stock_, lattice_, parameters_.threads, parameters_.mesher);
    }

private:
    // Range of grid corners that a body may meet, by axis; a copy apart from the large body.
    struct Span {
        std::array<std::uint32_t, 3> begin, end;
        // True for a tool whose upper end is above the stock.
        bool is_open = false;
    };

    template <class OneBody>
    void add(OneBody&& body) {
        Span span{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            span.begin[axis] = static_cast<std::uint32_t>(body.box.begin[axis]);
            span.end[axis] = static_cast<std::uint32_t>(body.box.end[axis]);
        }
        if constexpr (std::is_same_v<std::remove_cvref_t<OneBody>, SweptTool>) {
            span.is_open = body.is_open_above(grid_->axes[2].at.back());
        } else {
            ++pending_cells_;
        }
        if (pending_.empty()) {
            pending_.reserve(kBatch);
            spans_.reserve(kBatch);
        }
        pending_.emplace_back(std::forward<OneBody>(body));
        spans_.push_back(span);
        if (pending_.size() >= kBatch || pending_cells_ >= kMostCells) settle();
    }

    // Cuts all waiting bodies. One thread cuts each row, by all bodies in order.
    void settle() const {
        const std::scoped_lock lock(mutex_);
        if (pending_.empty()) return;
        struct Task {
            std::size_t axis, begin, end;
        };
        const std::size_t threads =
            parameters_.threads != 0 ? parameters_.threads : std::thread::hardware_concurrency();
        std::vector<Task> tasks;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t rows = (*rays_)[axis].rows();
            const std::size_t each = rows / (threads <= 1 ? 1 : kRuns * threads) / kBlock + 1;
            const Runs runs(rows, each * kBlock);
            for (std::size_t i = 0; i < runs.tasks(); ++i)
                tasks.push_back({axis, runs.begin(i), runs.end(i)});
        }
        const std::vector<Stretch> all{{0, pending_.size(), false}};
        const std::vector<Stretch> along_z =
            stretches_of(spans_.size(), [&](std::size_t k) { return spans_[k].is_open; });
        in_parallel(parameters_.threads, tasks.size(), [&](std::size_t i) {
            const auto& [axis, begin, end] = tasks[i];
            for (const Stretch& stretch : axis == 2 ? along_z : all)
                cut(axis, begin, end, stretch);
        });
        pending_.clear();
        spans_.clear();
        pending_cells_ = 0;
    }

    // Cuts rows [begin, end) by the bodies of a stretch.
    void cut(std::size_t axis, std::size_t begin, std::size_t end, const Stretch& stretch) const {
        Rays& along = (*rays_)[axis];
        const std::size_t across = along.v_axis();
        const auto for_each = [&](const auto& take) {
            for (std::size_t k = stretch.begin; k < stretch.end; ++k) {
                if (spans_[k].end[across] > begin && spans_[k].begin[across] < end)
                    take(pending_[k]);
            }
        };
        if (stretch.is_open) {
            std::vector<const SweptTool*> tools;
            for_each([&](const Body& body) { tools.push_back(&std::get<SweptTool>(body)); });
            OpenCutter(*grid_, along).cut(tools, begin / kBlock, (end + kBlock - 1) / kBlock);
            return;
        }
        std::vector<const Body*> bodies;
        for_each([&](const Body& body) { bodies.push_back(&body); });
        Cutter(*grid_, along).cut(bodies, begin, end);
    }

    DexelParameters parameters_;
    cda::Lattice lattice_;
    std::optional<Grid> grid_;  // empty in a prototype, as are the following members
    std::optional<CuttingCell> stock_;
    mutable std::mutex mutex_;
    mutable std::optional<std::array<Rays, 3>> rays_;
    mutable std::vector<Body> pending_;
    mutable std::vector<Span> spans_;  // ranges of pending_
    mutable std::size_t pending_cells_ = 0;
};

Dexel::Dexel(const DexelParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
Dexel::Dexel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Dexel::~Dexel() = default;

const cda::Lattice& Dexel::lattice() const {
    return impl_->lattice();
}

std::unique_ptr<cda::WorkpieceModel> Dexel::create(const cda::Cell& stock,
                                                   const cda::Lattice& lattice) const {
    return std::unique_ptr<cda::WorkpieceModel>(
        new Dexel(std::make_unique<Impl>(impl_->parameters(), stock, lattice)));
}

double Dexel::subtract(const cda::Cell& cell) {
    const double before = volume();
    impl_->cut(cell);
    return before - volume();
}

void Dexel::subtract_unmeasured(std::span<const cda::Cell> cells) {
    for (const cda::Cell& cell : cells)
        impl_->cut(cell);
}

void Dexel::subtract_sweep(const cda::RoundSweep& sweep) {
    impl_->cut(sweep);
}

std::unique_ptr<cda::WorkpieceModel> Dexel::clone() const {
    return std::unique_ptr<cda::WorkpieceModel>(new Dexel(std::make_unique<Impl>(*impl_)));
}

double Dexel::volume() const {
    return impl_->mean_volume();
}

cda::Boundary Dexel::boundary() const {
    return impl_->boundary();
}

bool Dexel::contains(Vec3 point) const {
    const Vec3 p = in_units(point, impl_->lattice());
    const Rays& along_z = impl_->rays()[2];
    const auto nearest = [&](std::size_t axis, double at) {
        const GridAxis& here = impl_->grid().axes[axis];
        const std::size_t i = std::clamp<std::size_t>(here.from(at), 1, here.cells());
        return at - here.at[i - 1] < here.at[i] - at ? i - 1 : i;
    };
    return along_z(nearest(0, p.x), nearest(1, p.y)).contains(p.z);
}

double Dexel::resolution() const {
    double largest = 0.0;
    for (const GridAxis& axis : impl_->grid().axes)
        largest = std::max(largest, axis.pitch);
    return largest * impl_->lattice().unit_mm;
}

std::size_t Dexel::rays() const {
    std::size_t count = 0;
    for (const Rays& along : impl_->rays())
        count += along.all().size();
    return count;
}

std::size_t Dexel::bytes() const {
    std::size_t sum = 0;
    for (const Rays& along : impl_->rays())
        sum += along.bytes();
    return sum;
}

double Dexel::volume_error() const {
    return impl_->doubtful_volume();
}

std::optional<cda::Aliasing> Dexel::aliasing() const {
    cda::Aliasing found;
    found.checks_only_along_z = impl_->has_only_z();
    for (const Rays& along : impl_->rays())
        find_thin_places(along, impl_->grid(), impl_->lattice(), found);
    return found;
}

}  // namespace ncsim::dexel
