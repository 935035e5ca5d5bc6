// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flat aggregate: subtraction, bindings, remainders, volume, boundary.
#include "ncsim/cda/flat.h"

#include "exact/query_point.h"
#include "flat/facet_difference.h"
#include "surface/stitch.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace ncsim::cda {

namespace {

constexpr std::uint32_t kNoFacet = ~std::uint32_t{0};

CdaCell make_cell(CellKind kind, const Cell& from, ConvexPolytope body) {
    CdaCell cell{kind, from.origin, from.rank, std::move(body), {}};
    cell.bindings.resize(cell.body.facets().size());
    return cell;
}

// Reverses a fragment: the facet of a negative cell is a wall with the material outside of the
// cell.
void reverse_fragment(Fragment& fragment) {
    fragment.plane = fragment.plane.opposite();
    for (auto& loop : fragment.loops) {
        std::vector<Fragment::Corner> turned;
        const std::size_t n = loop.size();
        for (std::size_t i = 0; i < n; ++i) {
            turned.push_back({loop[n - 1 - i].point, loop[(2 * n - 2 - i) % n].edge});
        }
        loop = std::move(turned);
    }
}

}  // namespace

FlatCda::FlatCda(Clock clock) : clock_(clock) {}

FlatCda::FlatCda(const Cell& stock, const Lattice& lattice, Clock clock)
    : clock_(clock), lattice_(lattice) {
    auto body = ConvexPolytope::of(stock, lattice);
    if (!body) throw std::invalid_argument("the stock has no volume");
    centre_ = body->bounds().centre();
    positive_ = make_cell(CellKind::Positive, stock, std::move(*body));
    positive_remainders_.resize(positive_.body.facets().size());
    for (std::uint32_t i = 0; i < positive_.body.facets().size(); ++i) {
        add_remainder({CellKind::Positive, 0, i});
    }
    compute_volume();
}

std::unique_ptr<WorkpieceModel> FlatCda::create(const Cell& stock, const Lattice& lattice) const {
    return std::make_unique<FlatCda>(stock, lattice, clock_);
}

std::unique_ptr<WorkpieceModel> FlatCda::clone() const {
    return std::make_unique<FlatCda>(*this);
}

CdaCell& FlatCda::cell_of(const FacetRef& facet) {
    return const_cast<CdaCell&>(std::as_const(*this).cell_of(facet));
}

const CdaCell& FlatCda::cell_of(const FacetRef& facet) const {
    switch (facet.kind) {
        case CellKind::Negative: return negative_[facet.cell];
        case CellKind::Zero: return zero_[facet.cell];
        case CellKind::Positive:
        case CellKind::Contact: break;
    }
    return positive_;
}

ConvexPolygon FlatCda::polygon(const FacetRef& facet) const {
    if (facet.kind == CellKind::Contact) return contacts_[facet.cell].polygon;
    return ConvexPolygon::of_facet(cell_of(facet).body, facet.facet);
}

bool FlatCda::is_drawn(const FacetRef& facet) const {
    switch (facet.kind) {
        case CellKind::Positive: return true;
        case CellKind::Negative: return !negative_[facet.cell].bindings[facet.facet].up.has_value();
        case CellKind::Zero:
        case CellKind::Contact: break;
    }
    return false;
}

FlatCda::Remainder& FlatCda::remainder_of(const FacetRef& facet) {
    return facet.kind == CellKind::Positive ? positive_remainders_[facet.facet]
                                            : negative_remainders_[facet.cell][facet.facet];
}

void FlatCda::add_remainder(const FacetRef& facet) {
    Remainder& whole = remainder_of(facet);
    whole.polygons.push_back(polygon(facet));
    changed_.push_back(facet);
}

// The volume is a third of the sum of distance times area over the surface, relative to the centre
// of the stock; walls made by negative cells have the opposite sign.
double FlatCda::compute_volume() {
    double change = 0.0;
    for (const FacetRef& facet : changed_) {
        Remainder& remainder = remainder_of(facet);
        double now = 0.0;
        for (const ConvexPolygon& polygon : remainder.polygons)
            now += area(polygon);
        if (now == remainder.area) continue;
        const Plane& plane = cell_of(facet).body.facets()[facet.facet].plane;
        const double sign = facet.kind == CellKind::Positive ? 1.0 : -1.0;
        change += sign * distance_about(plane, centre_) * (now - remainder.area) / 3.0;
        remainder.area = now;
    }
    changed_.clear();
    volume_ += change;
    return change;
}

std::uint32_t FlatCda::facet_in_plane(std::uint32_t negative, const Plane& plane) const {
    const auto& planes = planes_of_negative_[negative];
    const auto it = std::lower_bound(planes.begin(), planes.end(), std::pair{plane, 0U});
    return it != planes.end() && it->first == plane ? it->second : kNoFacet;
}

// Thesis 4.5: makes `hole`, the polygon `mask`, a hole in `facet`.
void FlatCda::bind(const FacetRef& hole, const FacetRef& facet, const ConvexPolygon& mask) {
    if (hole.kind != CellKind::Contact) cell_of(hole).bindings[hole.facet].up = facet;
    cell_of(facet).bindings[facet.facet].down.push_back(hole);
    if (!is_drawn(facet)) return;
    if (hole.kind == CellKind::Zero || hole.kind == CellKind::Contact) ++totals_.zero_facets;
    Remainder& remainder = remainder_of(facet);
    if (remainder.polygons.empty()) return;
    std::vector<ConvexPolygon> rest;
    for (const ConvexPolygon& polygon : remainder.polygons) {
        cda::subtract(polygon, mask.edges, rest);
    }
    remainder.polygons = std::move(rest);
    changed_.push_back(facet);
}

bool FlatCda::comes_before(std::uint32_t a, std::uint32_t b) const {
    const auto key = [this](std::uint32_t cell) {
        return std::tuple{negative_[cell].rank, negative_[cell].origin, cell};
    };
    return key(a) < key(b);
}

// Applies the facet rule of docs/cda.md: a facet of a zero cell is a hole in the facet of the
// negative cell with the same plane. If both cells have this plane with the same orientation, the
// walls coincide, and the wall stays with the first cell.
void FlatCda::bind_zero_cell(std::uint32_t zero, std::uint32_t first, std::uint32_t second) {
    for (std::uint32_t i = 0; i < zero_[zero].body.facets().size(); ++i) {
        const Plane& plane = zero_[zero].body.facets()[i].plane;
        const std::uint32_t a = facet_in_plane(first, plane);
        const std::uint32_t b = facet_in_plane(second, plane);
        const bool bind_first = b == kNoFacet || (a != kNoFacet && comes_before(second, first));
        const FacetRef facet{CellKind::Negative, bind_first ? first : second, bind_first ? a : b};
        const FacetRef hole{CellKind::Zero, zero, i};
        bind(hole, facet, polygon(hole));
    }
}

bool FlatCda::add_contact(std::uint32_t first, std::uint32_t second) {
    const auto& facets = negative_[second].body.facets();
    for (std::uint32_t b = 0; b < facets.size(); ++b) {
        const std::uint32_t a = facet_in_plane(first, facets[b].plane.opposite());
        if (a == kNoFacet) continue;
        const FacetRef first_facet{CellKind::Negative, first, a};
        const FacetRef second_facet{CellKind::Negative, second, b};
        auto common = below(polygon(first_facet), polygon(second_facet).edges);
        if (!common) continue;
        const FacetRef hole{CellKind::Contact, static_cast<std::uint32_t>(contacts_.size()), 0};
        contacts_.push_back({std::move(*common), first_facet, second_facet});
        const ConvexPolygon& mask = contacts_.back().polygon;
        bind(hole, first_facet, mask);
        bind(hole, second_facet, reversed(mask));
        return true;  // convex bodies without common inner points touch in one plane at most
    }
    return false;
}

RemovalByMotion FlatCda::account() const {
    RemovalByMotion result;
    for (const StepStatistics& step : steps_) {
        if (step.removed_volume > 0.0) {
            result[step.origin].volume += step.removed_volume;
            result[step.origin].bounds.add(step.bounds);
        }
    }
    return result;
}

double FlatCda::subtract(const Cell& cell) {
    totals_.origin = cell.origin;
    totals_.bounds = cell.bounds;
    totals_.negative = {};
    totals_.zero = {};
    totals_.new_zero_cells = 0;
    totals_.new_contacts = 0;
    totals_.removed_volume = 0.0;
    auto body = intersect(positive_.body, cell, lattice_, totals_.negative, clock_);
    if (!body) return 0.0;

    const auto number = static_cast<std::uint32_t>(negative_.size());
    negative_.push_back(make_cell(CellKind::Negative, cell, std::move(*body)));
    const auto& facets = negative_.back().body.facets();
    negative_remainders_.emplace_back(facets.size());
    planes_of_negative_.emplace_back();
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
        planes_of_negative_.back().emplace_back(facets[i].plane, i);
    }
    std::sort(planes_of_negative_.back().begin(), planes_of_negative_.back().end());

    for (std::uint32_t i = 0; i < facets.size(); ++i) {
        const FacetRef facet{CellKind::Negative, number, i};
        if (const auto wall = positive_.body.facet_in(facets[i].plane)) {
            bind(facet, {CellKind::Positive, 0, *wall}, polygon(facet));
            ++totals_.stencilled_negative_facets;
        } else {
            add_remainder(facet);
            ++totals_.visible_negative_facets;
        }
    }

    for (std::uint32_t other = 0; other < number; ++other) {
        const ConvexPolytope& a = negative_[other].body;
        const ConvexPolytope& b = negative_[number].body;
        if (!a.bounds().overlaps(b.bounds())) continue;
        if (auto common = intersect(a, b, totals_.zero, clock_)) {
            const auto zero = static_cast<std::uint32_t>(zero_.size());
            zero_.push_back(make_cell(CellKind::Zero, cell, std::move(*common)));
            bind_zero_cell(zero, other, number);
            ++totals_.new_zero_cells;
        } else if (add_contact(other, number)) {
            ++totals_.new_contacts;
        }
    }
    const double change = compute_volume();
    totals_.removed_volume = change == 0.0 ? 0.0 : -change * lattice_.cubic_unit_mm3();
    steps_.push_back(totals_);
    return totals_.removed_volume;
}

double FlatCda::volume() const {
    return volume_ * lattice_.cubic_unit_mm3();
}

void FlatCda::render(FacetCanvas& canvas) const {
    std::vector<std::vector<Vec3>> masks;
    std::vector<Vec3> outline;
    const auto corners_mm = [this](const ConvexPolygon& p) {
        std::vector<Vec3> corners;
        corners.reserve(p.corners.size());
        for (const ExactPoint& c : p.corners)
            corners.push_back(lattice_.to_mm(c.approx));
        return corners;
    };
    const auto draw = [&](const CdaCell& cell, const FacetRef& facet, bool inside_out) {
        const ConvexPolygon whole = polygon(facet);
        outline = corners_mm(whole);
        if (inside_out) std::reverse(outline.begin(), outline.end());
        masks.clear();
        for (const FacetRef& hole : cell.bindings[facet.facet].down) {
            masks.push_back(corners_mm(polygon(hole)));
            // Masks are drawn from the same side as their facet.
            const bool opposite =
                hole.kind == CellKind::Contact && contacts_[hole.cell].polygon.plane != whole.plane;
            if (inside_out != opposite) std::reverse(masks.back().begin(), masks.back().end());
        }
        const Vec3 normal = unit_normal(whole.plane);
        canvas.draw({inside_out ? -normal : normal, cell.origin, outline, masks});
    };
    for (std::uint32_t i = 0; i < positive_remainders_.size(); ++i) {
        if (positive_remainders_[i].polygons.empty()) continue;
        draw(positive_, {CellKind::Positive, 0, i}, false);
    }
    for (std::uint32_t n = 0; n < negative_.size(); ++n) {
        for (std::uint32_t i = 0; i < negative_remainders_[n].size(); ++i) {
            // Facets without a remainder are completely masked.
            if (negative_remainders_[n][i].polygons.empty()) continue;
            draw(negative_[n], {CellKind::Negative, n, i}, true);
        }
    }
}

Boundary FlatCda::boundary() const {
    std::vector<Fragment> fragments;
    std::vector<ConvexPolygon> masks;
    const auto add = [&](const CdaCell& cell, const FacetRef& facet, const Remainder& remainder) {
        if (remainder.polygons.empty()) return;
        masks.clear();
        for (const FacetRef& hole : cell.bindings[facet.facet].down)
            masks.push_back(polygon(hole));
        auto parts = facet_difference(polygon(facet), masks, cell.origin);
        if (facet.kind == CellKind::Negative) {
            for (Fragment& part : parts)
                reverse_fragment(part);
        }
        std::move(parts.begin(), parts.end(), std::back_inserter(fragments));
    };
    for (std::uint32_t i = 0; i < positive_remainders_.size(); ++i) {
        add(positive_, {CellKind::Positive, 0, i}, positive_remainders_[i]);
    }
    for (std::uint32_t n = 0; n < negative_.size(); ++n) {
        for (std::uint32_t i = 0; i < negative_remainders_[n].size(); ++i) {
            add(negative_[n], {CellKind::Negative, n, i}, negative_remainders_[n][i]);
        }
    }
    Stitcher stitcher(lattice_, 1);
    stitcher.add_part(outlines_of(fragments));
    return stitcher.finish();
}

bool FlatCda::contains(Vec3 point) const {
    const QueryPoint query(point, lattice_);
    const auto& stock = positive_.body.facets();
    if (std::any_of(stock.begin(), stock.end(),
                    [&](const auto& f) { return query.side_of(f.plane) == Side::Above; })) {
        return false;
    }
    // Negative cells end at the stock's facets; there, the removed space includes the facet.
    const auto is_of_stock = [&](const Plane& plane) {
        return std::any_of(stock.begin(), stock.end(),
                           [&](const auto& f) { return f.plane == plane; });
    };
    const auto took_it = [&](const CdaCell& cell) {
        const auto& facets = cell.body.facets();
        return std::all_of(facets.begin(), facets.end(), [&](const auto& f) {
            return query.side_of(f.plane) == Side::Below || is_of_stock(f.plane);
        });
    };
    return std::none_of(negative_.begin(), negative_.end(), took_it);
}

}  // namespace ncsim::cda
