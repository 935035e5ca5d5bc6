// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts keyword arguments to options.
#include "request.h"

#include "ncsim/gcode/dialect.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/simulation/models.h"
#include "ncsim/toolpath/tool_spec.h"
#include "ncsim/verify/doubt.h"
#include "ncsim/verify/rule.h"
#include "ncsim/verify/setup.h"

#include "failures.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::python {

namespace py = pybind11;

namespace {

using Names = std::vector<std::string>;

// Keyword arguments. take() removes them, so that finish() finds unknown arguments.
class Arguments {
public:
    explicit Arguments(const py::dict& given) : left_(given.attr("copy")()) {}

    // Returns the value of `name`; empty if the argument is missing or None.
    template <class Value>
    std::optional<Value> take(const char* name, const char* type) {
        if (!left_.contains(name)) return std::nullopt;
        const py::object value = left_.attr("pop")(name);
        if (value.is_none()) return std::nullopt;
        try {
            return value.cast<Value>();
        } catch (const py::cast_error&) {
            throw py::type_error(fmt::format("{}: expected {}, not {}", name, type,
                                             py::repr(value).cast<std::string>()));
        }
    }
    template <class Value>
    void take(const char* name, const char* type, Value& result) {
        if (auto value = take<Value>(name, type)) result = std::move(*value);
    }
    template <class Value>
    void take(const char* name, const char* type, std::optional<Value>& result) {
        if (auto value = take<Value>(name, type)) result = std::move(value);
    }
    std::string text(const char* name) { return take<std::string>(name, "str").value_or(""); }
    bool flag(const char* name) { return take<bool>(name, "bool").value_or(false); }
    Names names(const char* name) { return take<Names>(name, "a list of str").value_or(Names{}); }
    // Returns a length from `least` to `most`; `usual` if the argument is missing.
    double number(const char* name, double usual, double least, double most) {
        const double value = take<double>(name, "float").value_or(usual);
        if (value == usual || (value >= least && value <= most)) return value;
        throw UsageFailure(fmt::format("{}: expected {} to {}, not {}", name, least, most, value));
    }
    std::optional<Vec3> point(const char* name) {
        const auto value = take<std::array<double, 3>>(name, "three numbers");
        if (!value) return std::nullopt;
        for (const double coordinate : *value) {
            if (!std::isfinite(coordinate))
                throw UsageFailure(fmt::format("{}: expected finite numbers", name));
        }
        return Vec3{(*value)[0], (*value)[1], (*value)[2]};
    }
    // Throws for an argument that was not taken.
    void finish() const {
        for (const auto& [name, value] : left_) {
            throw py::type_error(
                fmt::format("unexpected keyword argument '{}'", name.cast<std::string>()));
        }
    }

private:
    py::dict left_;
};

toolpath::ToolSpec tool_spec(const char* argument, const std::string& text) {
    std::string message;
    auto spec = toolpath::parse_tool_option(text, message);
    if (!spec) throw UsageFailure(fmt::format("{}: {}", argument, message));
    return std::move(*spec);
}

std::vector<toolpath::ToolSpec> take_tools(Arguments& arguments) {
    std::vector<toolpath::ToolSpec> tools;
    const auto texts =
        arguments.take<std::map<int, std::string>>("tools", "a dict of tool numbers and str");
    if (!texts) return tools;
    for (const auto& [number, text] : *texts)
        tools.push_back(tool_spec("tools", fmt::format("T{}={}", number, text)));
    return tools;
}

std::optional<toolpath::ToolSpec> take_assumed_tool(Arguments& arguments) {
    const auto text = arguments.take<std::string>("assume_tool", "str");
    if (!text) return std::nullopt;
    toolpath::ToolSpec spec = tool_spec("assume_tool", "T1=" + *text);
    spec.number = 0;
    return spec;
}

std::optional<toolpath::Stock> take_stock(Arguments& arguments) {
    const auto text = arguments.take<std::string>("stock", "str");
    if (!text) return std::nullopt;
    std::string message;
    auto stock = setup::specified_stock(*text, message);
    if (!stock) throw UsageFailure("stock: " + message);
    return stock;
}

std::optional<std::string> take_turn(Arguments& arguments) {
    auto text = arguments.take<std::string>("stock_turn", "str");
    if (!text) return std::nullopt;
    try {
        (void)setup::parse_any_turn(*text);
    } catch (const std::invalid_argument& e) {
        throw UsageFailure(fmt::format("stock_turn: {}", e.what()));
    }
    return text;
}

std::map<std::string, double> take_variables(Arguments& arguments) {
    std::map<std::string, double> variables;
    const auto given =
        arguments.take<std::map<std::string, double>>("variables", "a dict of names and numbers");
    if (!given) return variables;
    for (const auto& [text, value] : *given) {
        const auto name = setup::variable_name(text);
        if (!name || !std::isfinite(value))
            throw UsageFailure(
                fmt::format("variables: '{}': expected #500, #<_name>, R5 or Q5", text));
        variables[*name] = value;
    }
    return variables;
}

std::map<int, double> take_compensation(Arguments& arguments) {
    using Radii = std::map<int, double>;
    Radii radii =
        arguments.take<Radii>("compensation", "a dict of registers D and radii").value_or(Radii{});
    for (const auto& [number, radius] : radii) {
        if (number < 1 || number > 9999 || !std::isfinite(radius))
            throw UsageFailure(
                fmt::format("compensation: {}: expected a register from 1 to 9999", number));
    }
    return radii;
}

gcode::Dialect take_dialect(Arguments& arguments) {
    const auto name = arguments.take<std::string>("dialect", "str");
    if (!name) return gcode::Dialect::Auto;
    std::string known;
    for (const gcode::Dialect dialect : gcode::kDialectList) {
        if (*name == gcode::name_of(dialect)) return dialect;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", gcode::name_of(dialect));
    }
    throw UsageFailure(fmt::format("dialect: '{}': expected {}", *name, known));
}

std::optional<bool> take_inches(Arguments& arguments) {
    const auto unit = arguments.take<std::string>("units", "str");
    if (!unit) return std::nullopt;
    if (*unit != "mm" && *unit != "inch")
        throw UsageFailure(fmt::format("units: '{}': expected mm or inch", *unit));
    return *unit == "inch";
}

simulation::SimulationOptions take_accuracy(Arguments& arguments) {
    simulation::SimulationOptions accuracy;
    accuracy.tolerance = arguments.number("tolerance", accuracy.tolerance, 1e-4, 10.0);
    accuracy.tool_tolerance =
        arguments.number("tool_tolerance", accuracy.tool_tolerance, 1e-4, 10.0);
    accuracy.model = arguments.text("model");
    if (!accuracy.model.empty() && !simulation::find_model(accuracy.model)) {
        throw UsageFailure(
            fmt::format("model: '{}': expected {}", accuracy.model, simulation::model_names()));
    }
    accuracy.threads = static_cast<unsigned>(arguments.number("threads", 0.0, 1.0, 1024.0));
    accuracy.max_memory_gb = arguments.number("max_memory", 0.0, 1e-6, 1e9);
    accuracy.max_seconds = arguments.number("max_time", 0.0, 1e-6, 1e9);
    return accuracy;
}

void take_common(Request& request, Arguments& arguments, std::string program,
                 std::optional<std::string> text) {
    setup::JobOptions& job = request.job;
    request.text = std::move(text);
    job.job = arguments.text("job");
    if (!request.text && setup::is_job_file(program)) {
        if (!job.job.empty())
            throw UsageFailure(
                fmt::format("'{}' and job='{}': expected one job", program, job.job));
        job.job = std::exchange(program, {});
    }
    job.program = std::move(program);
    if (job.program.empty() && job.job.empty())
        throw UsageFailure("expected a program, the text of a program, or a job");
    if (const auto step = arguments.take<std::size_t>("step", "int")) {
        if (*step == 0) throw UsageFailure("step: steps are numbered from 1");
        job.job_step = *step - 1;
    }
    job.tools = take_tools(arguments);
    job.assumed_tool = take_assumed_tool(arguments);
    job.tool_tables = arguments.names("tool_tables");
    job.holders = arguments.text("holders");
    job.stock = take_stock(arguments);
    job.stock_turn = take_turn(arguments);
    job.stock_move = arguments.point("stock_move");
    job.start = arguments.point("start");
    job.inches = take_inches(arguments);
    arguments.take("increments", "bool", job.increments);
    arguments.take("block_delete", "bool", job.block_delete);
    job.subprograms = arguments.names("subprograms");
    job.variables = take_variables(arguments);
    job.compensation = take_compensation(arguments);
    job.dialect = take_dialect(arguments);
    job.strict = arguments.flag("strict");
    job.allow = arguments.names("allow");
    request.machine = arguments.text("machine");
    request.accuracy = take_accuracy(arguments);
}

Volumes take_volumes(Arguments& arguments) {
    const std::string text = arguments.take<std::string>("volumes", "str").value_or("total");
    if (text == "total") return Volumes::Total;
    if (text == "tool") return Volumes::ByTool;
    if (text == "block") return Volumes::ByBlock;
    throw UsageFailure(fmt::format("volumes: '{}': expected total, tool or block", text));
}

std::vector<std::string_view> ids_of(const char* argument, const std::string& name) {
    auto ids = verify::rules_named(name);
    if (ids.empty())
        throw UsageFailure(
            fmt::format("{}: '{}': no rule or category of this name", argument, name));
    return ids;
}

gcode::Severity severity_named(const std::string& name) {
    using gcode::Severity;
    for (const Severity severity : {Severity::Note, Severity::Warning, Severity::Error}) {
        if (name == verify::name_of(severity)) return severity;
    }
    throw UsageFailure(fmt::format("severity: '{}': expected note, warning or error", name));
}

verify::Selection take_selection(Arguments& arguments) {
    verify::Selection selection;
    if (const auto selected = arguments.take<Names>("select", "a list of str")) {
        for (const verify::RuleInfo& rule : verify::rules())
            selection.ignored.emplace(rule.id, "select");
        for (const std::string& name : *selected) {
            for (const std::string_view id : ids_of("select", name))
                selection.ignored.erase(std::string(id));
        }
    }
    for (const std::string& name : arguments.names("ignore")) {
        for (const std::string_view id : ids_of("ignore", name))
            selection.ignored.emplace(id, "ignore");
    }
    using Severities = std::map<std::string, std::string>;
    for (const auto& [name, severity] :
         arguments.take<Severities>("severity", "a dict of rules and str").value_or(Severities{})) {
        for (const std::string_view id : ids_of("severity", name))
            selection.severities[std::string(id)] = {severity_named(severity), "severity"};
    }
    selection.accepted_by = "accept";
    return selection;
}

Names take_accepted(Arguments& arguments) {
    Names names = arguments.names("accept");
    for (const std::string& name : names) {
        if (name != "all" && !verify::find_reason(name))
            throw UsageFailure(fmt::format("accept: '{}': no reason for doubt of this name", name));
    }
    return names;
}

Names take_required(Arguments& arguments) {
    Names names = arguments.names("require");
    for (const std::string& name : names) {
        if (std::ranges::find(verify::kRequirements, name) == std::end(verify::kRequirements))
            throw UsageFailure(fmt::format("require: '{}': unknown requirement", name));
    }
    return names;
}

std::optional<bool> take_dog_leg(Arguments& arguments) {
    const auto path = arguments.take<std::string>("rapid", "str");
    if (!path) return std::nullopt;
    if (*path != "linear" && *path != "dog-leg")
        throw UsageFailure(fmt::format("rapid: '{}': expected linear or dog-leg", *path));
    return *path == "dog-leg";
}

}  // namespace

SimulateRequest simulate_request(std::string program, std::optional<std::string> text,
                                 const py::dict& given) {
    Arguments arguments(given);
    SimulateRequest request;
    take_common(request, arguments, std::move(program), std::move(text));
    arguments.take("at_line", "int", request.at_line);
    request.resolution = arguments.number("resolution", 0.0, 1e-4, 1e3);
    request.volumes = take_volumes(arguments);
    request.allows_errors = arguments.flag("allow_errors");
    arguments.finish();
    return request;
}

CheckRequest check_request(std::string program, std::optional<std::string> text,
                           const py::dict& given) {
    Arguments arguments(given);
    CheckRequest request;
    take_common(request, arguments, std::move(program), std::move(text));
    request.selection = take_selection(arguments);
    request.job.accept = take_accepted(arguments);
    request.job.require = take_required(arguments);
    request.baseline = arguments.text("baseline");
    request.design = arguments.text("design");
    request.design_tolerance = arguments.number("design_tolerance", 0.1, 1e-4, 1e4);
    request.dog_leg = take_dog_leg(arguments);
    request.detached_pieces = arguments.flag("cut_free");
    request.air_cuts = arguments.flag("air_cuts");
    request.warnings_as_errors = arguments.flag("warnings_as_errors");
    request.ledger = arguments.flag("ledger");
    arguments.finish();
    return request;
}

}  // namespace ncsim::python
