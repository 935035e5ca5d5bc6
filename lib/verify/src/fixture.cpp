// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks tools against fixtures.
#include "fixture.h"

#include "ncsim/cda/collision.h"
#include "ncsim/cda/flat.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/tree.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ncsim::verify {

using cda::Cell;

namespace {

Box grow_box(const Box& box, double by) {
    return {box.min - Vec3{by, by, by}, box.max + Vec3{by, by, by}};
}

// Factors of finer accuracy for tools in open contacts; the last leaves an error below 1 µm.
constexpr double kFiner[] = {16.0, 256.0};

// Margin (mm) around a fixture in which cells are considered.
constexpr double kMargin = 1.0;

Cell cell_of(const Box& box, const cda::Lattice& lattice) {
    return cda::box_cell(lattice.round(box.min), lattice.round(box.max), lattice);
}

// Returns a value that is larger for the worse contact: a certain clearance is no certain touch.
std::pair<bool, bool> weight(const FixtureContact& contact) {
    return {contact.touches, contact.certainty == Certainty::Certain};
}

}  // namespace

std::string name_of(const Fixture& fixture) {
    return "the fixture '" + fixture.name + "'";
}

Box Fixture::place() const {
    return grow_box(box, clearance_mm + deflection_mm);
}

FixtureScene::FixtureScene(const Setup& setup) : setup_(&setup), fixtures_(setup.machine.fixtures) {
    Box all;
    for (const Fixture& f : fixtures_)
        all.add(grow_box(f.place(), kMargin));
    if (all.is_empty()) return;
    lattice_ = cda::Lattice::for_stock(all);
    for (const Fixture& f : fixtures_)
        boxes_.emplace_back(cell_of(f.box, lattice_), lattice_);
    for (const auto& [number, facts] : setup.tools) {
        for (const toolpath::ToolPiece& piece : facts.tool.pieces) {
            tools_[number].emplace_back(piece, lattice_, setup.accuracy);
        }
    }
}

bool FixtureScene::touches(std::size_t index, const Cell& cell) const {
    const Fixture& fixture = fixtures_[index];
    if (fixture.mesh.triangles.empty()) return boxes_[index].contact(cell).has_value();
    // The part of the cell near the mesh is the material, and the mesh is the body that may meet
    // the material.
    Cell near = cell_of(grow_box(fixture.place(), kMargin), lattice_);
    near.planes.insert(near.planes.end(), cell.planes.begin(), cell.planes.end());
    if (!cda::ConvexPolytope::of(near, lattice_)) return false;
    return cda::collision(cda::FlatCda(near, lattice_), fixture.mesh).has_value();
}

FixtureContact FixtureScene::contact_of(Body& body, std::size_t f,
                                        const toolpath::Step& step) const {
    using toolpath::Side;
    FixtureContact contact;
    contact.fixture = f;
    const double clearance = fixtures_[f].clearance_mm;
    const double rounding = body.rounding(step);
    // The true surface may be this far outside or inside the triangles.
    const double hidden = fixtures_[f].deflection_mm;
    const auto meets = [&](const Cell& cell, double less) {
        return touches(f, less != 0.0 ? shrink_cell(cell, less, lattice_) : cell);
    };
    for (const Cell& cell : body.cells(step, 0.0, Side::Circumscribed)) {
        const bool touching = meets(cell, rounding - hidden);
        const bool near =
            touching || (clearance > 0.0 && meets(cell, rounding - clearance - hidden));
        if (near) contact.box.add(intersection(cell.bounds, fixtures_[f].place()));
        contact.touches |= touching;
    }
    if (contact.box.is_empty()) return contact;
    const double less =
        rounding + hidden + body.gained(step, 0.0) - (contact.touches ? 0.0 : clearance);
    for (const Cell& cell : body.cells(step, 0.0, Side::Inscribed)) {
        if (meets(cell, less)) contact.certainty = Certainty::Certain;
    }
    return contact;
}

Body& FixtureScene::finer_body(int tool, std::size_t piece, double factor) {
    const auto key = std::tuple(tool, piece, factor);
    const auto known = fine_.find(key);
    if (known != fine_.end()) return known->second;
    toolpath::ToolAccuracy accuracy = setup_->accuracy;
    accuracy.tolerance_mm /= factor;
    return fine_.try_emplace(key, setup_->tools.at(tool).tool.pieces[piece], lattice_, accuracy)
        .first->second;
}

void FixtureScene::find_contact(int tool, const toolpath::Step& step,
                                std::vector<FixtureContact>& contacts) {
    const auto found = tools_.find(tool);
    if (found == tools_.end()) return;
    std::vector<Body>& bodies = found->second;
    for (std::size_t piece = 0; piece < bodies.size(); ++piece) {
        const Box bounds = bodies[piece].bounds(step, 0.0);
        for (std::size_t f = 0; f < fixtures_.size(); ++f) {
            if (!bounds.overlaps(fixtures_[f].place())) continue;
            const auto old = std::ranges::find_if(contacts, [&](const FixtureContact& c) {
                return c.fixture == f && c.piece == piece;
            });
            if (old != contacts.end() && old->touches && old->certainty == Certainty::Certain) {
                continue;
            }
            FixtureContact contact = contact_of(bodies[piece], f, step);
            // If the accuracy of the tool leaves the contact open, a finer tool may decide.
            for (const double factor : kFiner) {
                if (contact.box.is_empty() || contact.certainty == Certainty::Certain) break;
                contact = contact_of(finer_body(tool, piece, factor), f, step);
            }
            if (contact.box.is_empty()) continue;
            contact.piece = piece;
            if (old == contacts.end()) {
                contacts.push_back(contact);
            } else {
                contact.box.add(old->box);
                if (weight(contact) < weight(*old)) {
                    contact.touches = old->touches;
                    contact.certainty = old->certainty;
                }
                *old = contact;
            }
        }
    }
}

}  // namespace ncsim::verify
