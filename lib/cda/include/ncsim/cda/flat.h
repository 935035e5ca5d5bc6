// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flat Convex Difference Aggregate of the thesis: C = P \ (N1 ∪ … ∪ Nn). The aggregate has one
// positive cell (the stock), negative cells (removed volume), and zero cells (overlaps of two
// negative cells) that mask hidden parts of facets.
// Source: Schüppel, Using Boolean Operations to Simulate CNC-Milling, 2001, chapters 3 to 5, with
// errors corrected as listed in docs/cda.md.
//
// Cost: quadratic in the number of overlapping cells. This class is the readable reference and the
// oracle of tests.
#pragma once

#include "ncsim/cda/cell_model.h"
#include "ncsim/cda/intersect.h"
#include "ncsim/cda/polygon.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/workpiece.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::cda {

/// Kinds of cells of the aggregate.
enum class CellKind : std::uint8_t {
    Positive,  ///< The stock.
    Negative,  ///< Intersection of a subtracted cell with the stock.
    Zero,      ///< Intersection of two negative cells.
    Contact,   ///< Common polygon of two negative cells that touch from opposite sides.
};

/// A facet of a cell of the aggregate.
struct FacetRef {
    CellKind kind = CellKind::Positive;
    std::uint32_t cell = 0;   ///< Index among the cells of that kind.
    std::uint32_t facet = 0;  ///< Facet of the cell's polytope; 0 for a contact.
    bool operator==(const FacetRef&) const = default;
};

/// Bindings of a facet (thesis 3.1): `up` is the facet in which this facet is a hole, `down` are
/// the facets that are holes in this facet. All lie in one plane.
struct FacetBinding {
    std::optional<FacetRef> up;
    std::vector<FacetRef> down;
};

/// A cell of the aggregate with the bindings of its facets.
struct CdaCell {
    CellKind kind = CellKind::Positive;
    Origin origin = kStockOrigin;
    std::int32_t rank = Cell::kFirstRank;  ///< Same meaning as Cell::rank.
    ConvexPolytope body;
    std::vector<FacetBinding> bindings;  ///< One per facet of the body.
};

/// A polygon in which two facets in opposite planes lie on each other, as with a step-over equal to
/// the tool's width, or peck drilling. Neither facet is a wall there, because no material separates
/// the two voids.
struct Contact {
    ConvexPolygon polygon;  ///< In the plane of `first`.
    FacetRef first, second;
};

/// Cost of one subtraction and counts of the aggregate after the subtraction: a row of thesis
/// figures 7.1, 7.2 and 7.6.
struct StepStatistics {
    Origin origin = kStockOrigin;
    IntersectionCosts negative;  ///< Intersection with the stock.
    IntersectionCosts zero;      ///< Intersections with the existing negative cells.
    std::uint32_t new_zero_cells = 0;
    std::uint32_t new_contacts = 0;
    /// Negative facets that are bound up to the stock.
    std::uint64_t stencilled_negative_facets = 0;
    /// Negative facets that are drawn, whether or not they are hidden.
    std::uint64_t visible_negative_facets = 0;
    /// Facets of zero cells that are bound up, hence drawn as masks.
    std::uint64_t zero_facets = 0;
    double removed_volume = 0.0;  ///< mm³
    Box bounds;                   ///< Bounds of the cell, mm.
};

/// Workpiece model with the flat aggregate. Exact; quadratic cost.
class FlatCda final : public WorkpieceModel, public AccountingModel, public CellModel {
public:
    static constexpr std::string_view kName = "cda-flat";

    /// Creates an empty prototype. `clock`, if not null, times subtractions.
    explicit FlatCda(Clock clock = nullptr);
    FlatCda(const Cell& stock, const Lattice& lattice, Clock clock = nullptr);

    std::string_view name() const override { return kName; }
    std::unique_ptr<WorkpieceModel> create(const Cell& stock,
                                           const Lattice& lattice) const override;
    /// Cost: O(negative cells) box tests and one intersection per overlapping cell.
    double subtract(const Cell& cell) override;
    /// Has no effect: the account is always kept.
    void track_removal() override {}
    RemovalByMotion account() const override;
    void render(FacetCanvas& canvas) const override;
    std::unique_ptr<WorkpieceModel> clone() const override;
    double volume() const override;
    /// Computes each facet minus the facets bound down to the facet (thesis 8.2), by CGAL's Boolean
    /// operations on polygons with an exact kernel.
    Boundary boundary() const override;
    bool contains(Vec3 point) const override;

    void write_statistics(std::ostream& out) const override;
    void write_cells(std::ostream& out) const override;

    const Lattice& lattice() const override { return lattice_; }
    const CdaCell& positive() const { return positive_; }
    const std::vector<CdaCell>& negative() const { return negative_; }
    const std::vector<CdaCell>& zero() const { return zero_; }
    const std::vector<Contact>& contacts() const { return contacts_; }
    const std::vector<StepStatistics>& steps() const { return steps_; }

    /// Returns the polygon of any facet, contacts included, counter-clockwise in the facet's plane.
    ConvexPolygon polygon(const FacetRef& facet) const;
    /// True if the facet, minus holes, is part of the surface: facets of the stock, and facets of
    /// negative cells that are not bound up.
    bool is_drawn(const FacetRef& facet) const;

private:
    CdaCell& cell_of(const FacetRef& facet);
    const CdaCell& cell_of(const FacetRef& facet) const;
    void bind(const FacetRef& hole, const FacetRef& facet, const ConvexPolygon& mask);
    void bind_zero_cell(std::uint32_t zero, std::uint32_t first, std::uint32_t second);
    bool add_contact(std::uint32_t first, std::uint32_t second);
    std::uint32_t facet_in_plane(std::uint32_t negative, const Plane& plane) const;
    bool comes_before(std::uint32_t a, std::uint32_t b) const;

    // Remainder of a drawn facet as convex polygons. bind() keeps remainders up to date, so the
    // volume is known at any time.
    struct Remainder {
        std::vector<ConvexPolygon> polygons;
        double area = 0.0;  // square units, as counted in volume_
    };
    Remainder& remainder_of(const FacetRef& facet);
    void add_remainder(const FacetRef& facet);
    double compute_volume();

    Clock clock_ = nullptr;
    Lattice lattice_;
    Vec3 centre_;  // centre of the stock in units; volumes are summed about this point
    CdaCell positive_;
    std::vector<CdaCell> negative_;
    std::vector<CdaCell> zero_;
    std::vector<Contact> contacts_;
    std::vector<Remainder> positive_remainders_;
    std::vector<std::vector<Remainder>> negative_remainders_;
    // Facets of each negative cell with their planes, sorted by plane.
    std::vector<std::vector<std::pair<Plane, std::uint32_t>>> planes_of_negative_;
    std::vector<FacetRef> changed_;  // facets whose remainders changed since volume_ was computed
    double volume_ = 0.0;            // cubic units
    std::vector<StepStatistics> steps_;
    StepStatistics totals_;
};

}  // namespace ncsim::cda
