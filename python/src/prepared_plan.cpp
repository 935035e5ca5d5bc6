// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the files of a request.
#include "prepared_plan.h"

#include "ncsim/simulation/plan_reader.h"

#include "failures.h"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace ncsim::python {

namespace {

// Reads each subprogram once. A program is followed several times, the last time perhaps long after
// the simulation, and its subprograms must not change then.
gcode::FileReader kept_files(gcode::FileReader read) {
    struct Kept {
        std::mutex mutex;
        std::map<std::string, std::optional<gcode::SourceFile>> files;  // by name
    };
    return [read = std::move(read), kept = std::make_shared<Kept>()](std::string_view name) {
        const std::scoped_lock lock(kept->mutex);
        auto known = kept->files.find(std::string(name));
        if (known == kept->files.end()) known = kept->files.emplace(name, read(name)).first;
        return known->second;
    };
}

}  // namespace

PreparedPlan prepare(const Request& request, const std::stop_token& stop) {
    PreparedPlan made;
    made.inputs = std::make_unique<ProgramText>(request.job.program, request.text);
    try {
        for (const std::string& path : {request.job.program, request.job.job, request.machine}) {
            if (!path.empty() && !(request.text && path == request.job.program))
                made.inputs->expect(path);
        }
        simulation::LeftStocks left_stocks;
        made.plan = simulation::read_plan(request.job, request.accuracy, request.machine,
                                          left_stocks, *made.inputs, stop);
        made.machine = simulation::machine_for(request.machine, made.plan.job, *made.inputs);
    } catch (const std::runtime_error& e) {
        throw UsageFailure(e.what());
    }
    gcode::FileReader& read_file = made.plan.job.interpreter.read_file;
    read_file = kept_files(std::move(read_file));
    made.plan.budget.stop_with(stop);
    return made;
}

}  // namespace ncsim::python
