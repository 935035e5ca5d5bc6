// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts made of boxes on an integer grid, tilted as a whole: everything about them can be said
// without the geometry kernel, so they are what the renderers and writers are tested with.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/export/provenance.h"

#include <array>
#include <memory>
#include <vector>

namespace ncsim::exporter::test {

struct GridBox {
    std::array<int, 3> min{}, max{};

    bool contains_cell(std::array<int, 3> cell) const;
};

/// A stock box and the boxes that were cut from it, in this order; box i has Origin{i + 1}. `X_WG`
/// is columns of a rotation followed by a shift: it takes the grid to the workpiece.
struct BoxPart {
    GridBox stock;
    std::vector<GridBox> cuts;
    double cell_mm = 1.0;
    std::array<cda::Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    cda::Vec3 shift;

    cda::Vec3 to_W(cda::Vec3 p_G) const;
    /// Rotated by rational angles (no sine): 3-4-5 about z, then 5-12-13 about x.
    BoxPart tilted() const;
};

/// The surface of the part, a square face for each side of a cell that shows. Cells that touch
/// in an edge only have no place in a Boundary and must not occur.
cda::Boundary boundary_of(const BoxPart& part);

/// Facets with masks, by the facet rule for axis-parallel boxes.
class BoxModel : public cda::WorkpieceModel {
public:
    explicit BoxModel(BoxPart part) : part_(std::move(part)) {}

    std::string_view name() const override { return "boxes"; }
    const cda::Lattice& lattice() const override { return lattice_; }
    std::unique_ptr<cda::WorkpieceModel> create(const cda::Cell& stock,
                                                const cda::Lattice& lattice) const override;
    double subtract(const cda::Cell& cell) override;
    cda::RemovalByMotion account() const override;
    void render(cda::FacetCanvas& canvas) const override;
    std::unique_ptr<cda::WorkpieceModel> clone() const override;
    double volume() const override { return cda::volume(boundary()); }
    cda::Boundary boundary() const override { return boundary_of(part_); }
    bool contains(cda::Vec3 point) const override;

private:
    BoxPart part_;
    cda::Lattice lattice_;
};

/// 60 × 40 × 20 with a groove in three abutting passes, a slot across it and a blind pocket.
BoxPart grooved_part();
/// Six times eight passes of a raster, abutting and crossing.
BoxPart raster_part();
/// With a void inside that no tool could have reached: two shells, one solid.
BoxPart hollow_part();
/// Cut in two: two shells, two solids.
BoxPart halved_part();
/// Nothing is left of it.
BoxPart vanished_part();

/// Line 10 (i + 1) for cut i; tools 1 and 7 by turns.
Provenance provenance_of(const BoxPart& part);

/// A plate with a hole through it: two of its faces have a hole. Lines 0 (outside) and 20.
cda::Boundary plate_with_hole();

}  // namespace ncsim::exporter::test
