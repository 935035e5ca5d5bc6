// SPDX-License-Identifier: GPL-3.0-or-later
//
// Observes one tile.
#include "check/check_tile.h"

#include "ncsim/setup/digest.h"
#include "ncsim/setup/recorded_input.h"
#include "ncsim/verify/evidence.h"

#include "check/check_program.h"
#include "check/check_settings.h"
#include "run/tile.h"
#include "system/output.h"

#include <stdexcept>
#include <utility>

namespace ncsim::app {

int check_tile(CheckOptions options) {
    setup::InputSet inputs(inputs_of(options));
    OutputSet outputs(inputs);
    const ShardNumber& number = options.number;
    const TilePlace place({options.tile_words, {}, number.shard, number.of}, options.tile_out);
    if (place.is_done(inputs)) return place.report_done("was verified before");
    place.reserve(outputs);

    setup::RecordedInput read(inputs);
    SettingsOfPrograms settings(options, options.programs, read);
    const CheckSettings& asked = settings.of(0);
    simulation::Plan plan =
        plan_to_check(options.programs[0], asked.options, options.threads, read);
    if (plan.job.programs_in_file > 1)
        throw std::runtime_error(
            "--tile: the file has several programs; tiles are of a single one");
    plan.tile = cda::TileNumber{number.shard, number.of};
    simulation::VerificationOptions verification_options = asked.verification_options;
    simulation::add_fixtures(verification_options, plan.job);
    simulation::TileResult seen = simulation::check_tile(std::move(plan), verification_options);
    report::TileFile file;
    file.head = {options.tile_words, read.files(), number.shard, number.of, read.knows_all()};
    file.stock_contacts = std::move(seen.stock_contacts);
    file.evidence = verify::bytes_of(seen.evidence);
    file.tile = std::move(seen.tile);
    place.write(file, outputs);
    return place.report_done("was verified");
}

}  // namespace ncsim::app
