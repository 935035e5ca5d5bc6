// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Convex Difference Aggregate of the thesis: C = P \ (N1 ∪ … ∪ Nn), flat. One positive cell
// (the stock), negative cells (what was taken), and zero cells where two negative ones
// overlap, which tell what of their facets must not be seen. Schüppel, Using Boolean Operations to
// Simulate CNC-Milling, 2001, chapters 3 to 5, with its known errors mended: docs/cda.md.
//
// Quadratic where cells overlap: the readable reference and the oracle of tests.
#pragma once

#include "ncsim/cda/intersect.h"
#include "ncsim/cda/polygon.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/visitor.h"
#include "ncsim/cda/workpiece.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::cda {

enum class CellKind : std::uint8_t {
    Positive,  ///< The stock.
    Negative,  ///< What a cell that was subtracted has in common with the stock.
    Zero,      ///< What two negative cells have in common.
    Contact,   ///< What two negative cells that touch from opposite sides have in common: one
               ///< polygon.
};

/// A facet of a cell of the aggregate.
struct FacetRef {
    CellKind kind = CellKind::Positive;
    std::uint32_t cell = 0;   ///< Among the cells of that kind.
    std::uint32_t facet = 0;  ///< Of the cell's polytope; 0 for a contact.
    bool operator==(const FacetRef&) const = default;
};

/// How a facet is bound (thesis 3.1): to the facet it is a hole in, and to those that are holes in
/// it. All lie in one plane.
struct FacetBinding {
    std::optional<FacetRef> up;
    std::vector<FacetRef> down;
};

struct CdaCell {
    CellKind kind = CellKind::Positive;
    Origin origin = kStockOrigin;
    std::int32_t rank = Cell::kFirstRank;  ///< As in Cell.
    ConvexPolytope body;
    std::vector<FacetBinding> bindings;  ///< One for each facet of the body.
};

/// A polygon in which two facets in opposite planes lie on each other: step-over as wide as the
/// tool, drilling in pecks. Neither facet is a wall there: between two voids there is no membrane.
struct Contact {
    ConvexPolygon polygon;  ///< In the plane of `first`.
    FacetRef first, second;
};

/// What one subtraction cost and what the aggregate was like after it: a row of thesis
/// figures 7.1, 7.2 and 7.6.
struct StepStatistics {
    Origin origin = kStockOrigin;
    IntersectionCosts negative;  ///< With the stock.
    IntersectionCosts zero;      ///< With the negative cells that were there.
    std::uint32_t new_zero_cells = 0;
    std::uint32_t new_contacts = 0;
    std::uint64_t stencilled_negative_facets = 0;  ///< Bound up to the stock.
    std::uint64_t visible_negative_facets = 0;     ///< Drawn, though not all of them can be seen.
    std::uint64_t zero_facets = 0;                 ///< Bound up, thus drawn as masks.
    double removed_volume = 0.0;                   ///< mm³
    Box bounds;                                    ///< Of the cell, mm.
};

class FlatCda final : public WorkpieceModel {
public:
    static constexpr std::string_view kName = "cda-flat";

    /// An empty prototype. `clock`, where given, is asked to time subtractions.
    explicit FlatCda(Clock clock = nullptr);
    FlatCda(const Cell& stock, const Lattice& lattice, Clock clock = nullptr);

    std::string_view name() const override { return kName; }
    std::unique_ptr<WorkpieceModel> create(const Cell& stock,
                                           const Lattice& lattice) const override;
    /// O(negative cells) box tests, one intersection for each that overlaps.
    double subtract(const Cell& cell) override;
    Account account() const override;
    void render(FacetCanvas& canvas) const override;
    std::unique_ptr<WorkpieceModel> clone() const override;
    double volume() const override;
    /// Each facet less what it is bound down to (thesis 8.2), by CGAL's Boolean operations on
    /// polygons with an exact kernel.
    Boundary boundary() const override;
    bool contains(Vec3 point) const override;

    void write_statistics(std::ostream& out) const override;
    void write_cells(std::ostream& out) const override;
    void accept(CdaVisitor& visitor) const;

    const Lattice& lattice() const override { return lattice_; }
    const CdaCell& positive() const { return positive_; }
    const std::vector<CdaCell>& negative() const { return negative_; }
    const std::vector<CdaCell>& zero() const { return zero_; }
    const std::vector<Contact>& contacts() const { return contacts_; }
    const std::vector<StepStatistics>& steps() const { return steps_; }

    /// The polygon of any facet, contacts included, counter-clockwise in its own plane.
    ConvexPolygon polygon(const FacetRef& facet) const;
    /// Is the facet part of the surface, but for its holes? Facets of the stock are, and facets of
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

    // What is left of a drawn facet, as convex polygons: kept up to date by bind(), so that volume
    // is known at any moment.
    struct Remainder {
        std::vector<ConvexPolygon> polygons;
        double area = 0.0;  // square units, as counted in volume_
    };
    Remainder& remainder_of(const FacetRef& facet);
    void add_remainder(const FacetRef& facet);
    double settle_volume();

    Clock clock_ = nullptr;
    Lattice lattice_;
    Vec3 centre_;  // of the stock, in units: volumes are summed about it
    CdaCell positive_;
    std::vector<CdaCell> negative_;
    std::vector<CdaCell> zero_;
    std::vector<Contact> contacts_;
    std::vector<Remainder> positive_remainders_;
    std::vector<std::vector<Remainder>> negative_remainders_;
    // Facets of negative cells by plane, sorted.
    std::vector<std::vector<std::pair<Plane, std::uint32_t>>> planes_of_negative_;
    std::vector<FacetRef> touched_;  // remainders that changed since volume_ was right
    double volume_ = 0.0;            // cubic units
    std::vector<StepStatistics> steps_;
    StepStatistics totals_;
};

}  // namespace ncsim::cda
