// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/dexel/dexel.h"

#include "ncsim/cda/parallel.h"

#include "contour.h"
#include "cutter.h"
#include "rays.h"
#include "round_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::dexel {

namespace {

// Cells that wait until rays are cut: enough that all threads have work, few enough to keep.
constexpr std::size_t kBatch = 2048;
// Rows that a thread cuts at a time.
constexpr std::size_t kRows = 8;

cda::Vec3 in_units(cda::Vec3 mm, const cda::Lattice& lattice) {
    return (1.0 / lattice.unit_mm) * mm;
}

}  // namespace

double finest_resolution(cda::Vec3 size) {
    const double all = size.x * size.y + size.y * size.z + size.z * size.x;
    constexpr double kEdges = 1.01;  // rays beyond the stock
    return kEdges * std::sqrt(all / kMostRays);
}

class Dexel::Impl {
public:
    explicit Impl(const DexelParameters& parameters) : parameters_(parameters) {}

    Impl(const DexelParameters& parameters, const cda::Cell& stock, const cda::Lattice& lattice)
        : parameters_(parameters), lattice_(lattice) {
        const cda::Vec3 min = in_units(stock.bounds.min, lattice);
        const cda::Vec3 max = in_units(stock.bounds.max, lattice);
        if (!(min.x < max.x && min.y < max.y && min.z < max.z))
            throw std::invalid_argument("stock without volume");
        const double longest = std::max({max.x - min.x, max.y - min.y, max.z - min.z});
        const double pitch = parameters.resolution_mm > 0.0
                                 ? parameters.resolution_mm / lattice.unit_mm
                                 : default_resolution(longest);
        grid_.emplace(min, max, pitch);
        rays_.emplace(std::array{Rays(*grid_, 0), Rays(*grid_, 1), Rays(*grid_, 2)});
        for (Rays& rays : *rays_)
            Cutter(*grid_, rays).fill(CuttingCell(stock, lattice, *grid_));
    }

    Impl(const Impl& other)
        : parameters_(other.parameters_),
          lattice_(other.lattice_),
          grid_(other.grid_),
          rays_((other.settle(), other.rays_)) {}

    const DexelParameters& parameters() const { return parameters_; }
    const cda::Lattice& lattice() const { return lattice_; }
    const Grid& grid() const { return grid_.value(); }

    template <class Body>
    void cut(const Body& body) {
        if constexpr (std::is_same_v<Body, cda::Cell>) {
            waiting_.emplace_back(CuttingCell(body, lattice_, *grid_));
        } else {
            waiting_.emplace_back(SweptTool(body, lattice_, *grid_));
        }
        if (waiting_.size() >= kBatch) settle();
    }

    const std::array<Rays, 3>& rays() const {
        settle();
        return rays_.value();
    }

    // mm³
    std::array<double, 3> volumes() const {
        std::array<double, 3> volumes{};
        for (const Rays& along : rays()) {
            volumes[along.axis()] = along.length() * grid_->axes[along.u_axis()].pitch *
                                    grid_->axes[along.v_axis()].pitch * lattice_.cubic_unit_mm3();
        }
        return volumes;
    }

private:
    // Each row by one thread, and all cells in their order.
    void settle() const {
        const std::scoped_lock lock(mutex_);
        if (waiting_.empty()) return;
        struct Task {
            std::size_t axis, begin, end;
        };
        std::vector<Task> tasks;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const cda::Runs runs((*rays_)[axis].rows(), kRows);
            for (std::size_t i = 0; i < runs.tasks(); ++i)
                tasks.push_back({axis, runs.begin(i), runs.end(i)});
        }
        cda::in_parallel(parameters_.threads, tasks.size(), [&](std::size_t i) {
            Cutter cutter(*grid_, (*rays_)[tasks[i].axis]);
            for (const auto& body : waiting_) {
                std::visit([&](const auto& b) { cutter.cut(b, tasks[i].begin, tasks[i].end); },
                           body);
            }
        });
        waiting_.clear();
    }

    DexelParameters parameters_;
    cda::Lattice lattice_;
    std::optional<Grid> grid_;  // a prototype has none
    mutable std::mutex mutex_;
    mutable std::optional<std::array<Rays, 3>> rays_;
    mutable std::vector<std::variant<CuttingCell, SweptTool>> waiting_;
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

cda::Account Dexel::account() const {
    throw cda::CannotAnswer(kName, "what each motion took");
}

void Dexel::render(cda::FacetCanvas& canvas) const {
    const cda::Boundary surface = boundary();
    for (const cda::BoundaryFace& face : surface.faces) {
        std::vector<cda::Vec3> outline;
        for (const std::uint32_t corner : face.loops.front())
            outline.push_back(surface.vertices[corner]);
        canvas.draw({face.normal, face.origin, outline, {}});
    }
}

std::unique_ptr<cda::WorkpieceModel> Dexel::clone() const {
    return std::unique_ptr<cda::WorkpieceModel>(new Dexel(std::make_unique<Impl>(*impl_)));
}

double Dexel::volume() const {
    const std::array<double, 3> volumes = impl_->volumes();
    return (volumes[0] + volumes[1] + volumes[2]) / 3.0;
}

cda::Boundary Dexel::boundary() const {
    return Contour(impl_->grid(), impl_->rays(), impl_->lattice(), impl_->parameters().threads)
        .boundary();
}

bool Dexel::contains(cda::Vec3 point) const {
    const cda::Vec3 p = in_units(point, impl_->lattice());
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

double Dexel::volume_error() const {
    const std::array<double, 3> volumes = impl_->volumes();
    const auto [least, most] = std::minmax_element(volumes.begin(), volumes.end());
    return 0.5 * (*most - *least);
}

}  // namespace ncsim::dexel
