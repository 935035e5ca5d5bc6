// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands on the table, ready to be asked whether a tool meets it.
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/setup.h"

#include "body.h"
#include "move.h"

#include <cstddef>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace ncsim::verify {

class FixtureScene {
public:
    /// The fixtures on a lattice of their own, fine enough for all of them.
    explicit FixtureScene(const Setup& setup);

    bool is_empty() const { return fixtures_.empty(); }
    /// Adds to `contacts` what the tool meets in this step; each fixture and piece stands once.
    void meet(int tool, const toolpath::Step& step, std::vector<FixtureContact>& contacts);

private:
    bool touches(std::size_t fixture, const cda::Cell& cell) const;
    /// Without a box where they are not even near.
    FixtureContact contact_of(Body& body, std::size_t fixture, const toolpath::Step& step) const;
    Body& finer(int tool, std::size_t piece, double factor);

    const Setup* setup_;
    cda::Lattice lattice_;
    std::vector<Fixture> fixtures_;
    std::vector<std::unique_ptr<cda::WorkpieceModel>> boxes_;
    std::map<int, std::vector<Body>> tools_;  // one body a piece
    std::map<std::tuple<int, std::size_t, double>, Body> fine_;
};

}  // namespace ncsim::verify
