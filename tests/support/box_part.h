// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts made of boxes on an integer grid, tilted as a whole. Tests of renderers and writers use the
// parts because all properties are known without the geometry kernel.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/cell_model.h"
#include "ncsim/mesh/provenance.h"

#include <array>
#include <utility>
#include <vector>

namespace ncsim::test {

struct GridBox {
    std::array<int, 3> min{}, max{};

    bool contains_cell(std::array<int, 3> cell) const;
};

/// A stock box and the boxes that are cut from the stock, in this order; box i has Origin{i + 1}.
/// `axes` (the columns of a rotation), `cell_mm` and `shift` map the grid to the workpiece.
struct BoxPart {
    GridBox stock;
    std::vector<GridBox> cuts;
    double cell_mm = 1.0;
    std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Vec3 shift;

    Vec3 to_W(Vec3 p_G) const;
    /// Returns the part, rotated by rational angles (no sine): 3-4-5 about Z, then 5-12-13 about X.
    BoxPart tilted() const;
};

/// Returns the surface of the part: a square face for each exposed side of a cell.
/// Requires: no two cells touch only in an edge, because a Boundary cannot represent that contact.
cda::Boundary boundary_of(const BoxPart& part);

/// Renders the facets of a part with masks, by the facet rule for axis-parallel boxes.
class BoxModel : public cda::FacetModel {
public:
    explicit BoxModel(BoxPart part) : part_(std::move(part)) {}

    void render(cda::FacetCanvas& canvas) const override;
    cda::Boundary boundary() const { return boundary_of(part_); }

private:
    BoxPart part_;
};

/// Returns 60 × 40 × 20 mm with a groove in three abutting passes, a slot across the groove and a
/// blind pocket.
BoxPart grooved_part();
/// Returns a part cut by six times eight passes of a raster, which abut and cross.
BoxPart raster_part();
/// Returns a part with a void inside that no tool could reach: two shells, one solid.
BoxPart hollow_part();
/// Returns a part that is cut in two: two shells, two solids.
BoxPart halved_part();
/// Returns a part that is removed entirely.
BoxPart vanished_part();

/// Returns line 10 (i + 1) for cut i, with the tools 1 and 7 in turn.
mesh::Provenance provenance_of(const BoxPart& part);

/// Returns a plate with a through hole, so two faces have a hole. The outside is stock; Origin{1}
/// cut the hole.
cda::Boundary plate_with_hole();

}  // namespace ncsim::test
