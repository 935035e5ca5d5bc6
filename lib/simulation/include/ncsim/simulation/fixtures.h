// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position of fixtures relative to the part.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/export/overlay.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/machine_description.h"

#include <span>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// Moves the fixtures of further coordinate systems to W and erases those whose position is unknown
/// because the distance of their system is unknown. Returns the erased fixtures, in words.
std::vector<std::string> place_fixtures(verify::MachineDescription& machine, const Plan& plan,
                                        const Survey& survey);

/// Returns, in words, the fixtures that overlap the stock when the program starts: the position of
/// the fixture or of the stock is wrong. Only for a specified block as stock.
std::vector<std::string> fixtures_in_stock(const Survey& survey,
                                           const verify::MachineDescription& machine);

/// Returns the shape of a fixture in W, for pictures.
exporter::Body body_of(const verify::Fixture& fixture);

/// Returns `stock` grown by the parts of the fixtures within half a diagonal of the stock: the box
/// of a picture that shows the part in its fixtures.
Box box_with_fixtures(const Box& stock, std::span<const verify::Fixture> fixtures);

/// Returns a bound for the distance of points of the fixtures from each other and from W's zero, in
/// mm: an addition to Camera::depth.
double reach_of(std::span<const verify::Fixture> fixtures);

/// Adds the fixtures and the free space below the stock of `job` to `machine`. Returns false if the
/// job specifies no fixtures.
bool add_fixtures(setup::MachineFile& machine, const setup::Job& job);

}  // namespace ncsim::simulation
