// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fixtures on the table, prepared for contact checks with tools.
#pragma once

#include "ncsim/cda/tree.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/setup.h"

#include "body.h"
#include "move.h"

#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

namespace ncsim::verify {

class FixtureScene {
public:
    /// Prepares the fixtures of `setup` on a common lattice that is fine enough for all fixtures.
    explicit FixtureScene(const Setup& setup);

    bool is_empty() const { return fixtures_.empty(); }
    /// Adds contacts of the tool in this step to `contacts`, at most a single contact for each
    /// fixture and piece.
    void find_contact(int tool, const toolpath::Step& step, std::vector<FixtureContact>& contacts);

private:
    bool touches(std::size_t fixture, const cda::Cell& cell) const;
    /// Returns the contact; without a box if the bodies are far apart.
    FixtureContact contact_of(Body& body, std::size_t fixture, const toolpath::Step& step) const;
    Body& finer_body(int tool, std::size_t piece, double factor);

    const Setup* setup_;
    cda::Lattice lattice_;
    std::vector<Fixture> fixtures_;
    std::vector<cda::TreeCda> boxes_;
    std::map<int, std::vector<Body>> tools_;  // a body for each piece
    std::map<std::tuple<int, std::size_t, double>, Body> fine_;
};

}  // namespace ncsim::verify
