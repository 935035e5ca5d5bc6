// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include "ncsim/export/render.h"
#include "ncsim/toolpath/stock.h"

#include "version.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>
#include <string_view>

namespace ncsim::app {

namespace {

constexpr const char* kFooter = R"(
Tools:  T1=flat:D10:L40  kinds flat, ball, bull, face, v, chamfer, drill, taper; values D diameter,
        L length, R corner radius, A angle, P tip diameter, S shank; mm, or inches: D1/4in
Stock:  x0,y0,z0:x1,y1,z1 or LxWxH (top at Z0, centred) or LxWxH@x,y,z (smallest corner)

Exit codes: 0 clean, 1 the NC program has faults, 2 wrong usage, unreadable input or a failing
world (disk full, no such folder), 3 a bug of ours.

Example: ncsim run samples/simple.nc --png simple.png --gltf simple.glb)";

// Thrown inside parse_options() only: what CLI11 cannot check.
struct Refusal {
    std::string text;
};

void read_size(const std::string& text, Options& options) {
    const char* first = text.data();
    const char* last = first + text.size();
    const auto width = std::from_chars(first, last, options.width);
    const bool cross =
        width.ec == std::errc{} && width.ptr != last && (*width.ptr == 'x' || *width.ptr == 'X');
    const auto height = cross ? std::from_chars(width.ptr + 1, last, options.height) : width;
    const auto good = [](std::uint32_t side) {
        return side >= 1 && side <= exporter::kMaxImageSide;
    };
    if (!cross || height.ec != std::errc{} || height.ptr != last || !good(options.width) ||
        !good(options.height)) {
        throw Refusal{fmt::format("--size '{}': expected WxH in pixels, 1x1 to {}x{}", text,
                                  exporter::kMaxImageSide, exporter::kMaxImageSide)};
    }
}

double read_tolerance(const char* name, double mm) {
    if (!(mm >= 1e-4 && mm <= 10.0)) {
        throw Refusal{fmt::format("{}: expected 0.0001 to 10 mm, not {}", name, mm)};
    }
    return mm;
}

toolpath::ToolSpec read_tool(const std::string& text) {
    std::string message;
    auto spec = toolpath::parse_tool_option(text, message);
    if (!spec) throw Refusal{"--tool " + message};
    return std::move(*spec);
}

// No two outputs may be one file, and none the program itself.
void check_paths(const Options& o) {
    std::set<std::string> seen{std::filesystem::path(o.program).lexically_normal().string()};
    for (const std::string& path : outputs_of(o)) {
        if (path.rfind("/dev/", 0) == 0) continue;
        if (!seen.insert(std::filesystem::path(path).lexically_normal().string()).second) {
            throw Refusal{
                fmt::format("'{}' is named twice: an output may overwrite neither the program nor "
                            "another output",
                            path)};
        }
    }
}

// The thesis' model where its own views are asked for, else the one that scales.
void choose_model(Options& o) {
    const bool needs_flat = !o.stats.empty() || !o.xml.empty();
    if (o.model.empty()) o.model = needs_flat ? "cda-flat" : "cda";
    if (o.model != "cda" && o.model != "cda-flat") {
        throw Refusal{fmt::format("--model '{}': expected cda or cda-flat", o.model)};
    }
    if (needs_flat && o.model != "cda-flat") {
        throw Refusal{"--stats and --xml show the cells of --model cda-flat"};
    }
}

gcode::Dialect read_dialect(const std::string& name) {
    using gcode::Dialect;
    for (const Dialect dialect : {Dialect::Auto, Dialect::Rs274, Dialect::Fanuc, Dialect::Haas,
                                  Dialect::Grbl, Dialect::Mach3}) {
        if (name == gcode::name_of(dialect)) return dialect;
    }
    throw Refusal{
        fmt::format("--dialect '{}': expected auto, rs274, fanuc, haas, grbl or mach3", name)};
}

}  // namespace

std::vector<std::string> outputs_of(const Options& o) {
    std::vector<std::string> paths;
    for (const std::string* path :
         {&o.png, &o.gltf, &o.vrml, &o.stl, &o.step, &o.report, &o.stats, &o.xml}) {
        if (!path->empty()) paths.push_back(*path);
    }
    return paths;
}

std::variant<Options, Farewell> parse_options(const std::vector<std::string>& arguments) {
    Options o;
    std::string stock;
    std::string size;
    std::string view = "iso";
    std::string units = "mm";
    std::string colouring = "tool";
    std::string dialect = "auto";
    std::string assumed;
    std::vector<std::string> tools;
    double tolerance = o.tolerance;
    double tool_tolerance = o.tool_tolerance;

    CLI::App app{
        "ncsim runs an NC milling program without a machine and shows what is left of the block.",
        "ncsim"};
    app.set_version_flag("--version", fmt::format("ncsim {}", kVersion));
    app.require_subcommand(1);
    app.footer(kFooter);
    CLI::App* run =
        app.add_subcommand("run", "Simulate a program; write pictures, meshes and reports");
    run->footer(kFooter);
    run->add_option("program", o.program, "NC program")->required()->type_name("FILE");
    run->add_option("--png", o.png, "Picture of the part")->type_name("FILE");
    run->add_option("--gltf", o.gltf, "Mesh with the NC line of every face, glTF 2.0 binary")
        ->type_name("FILE");
    run->add_option("--vrml", o.vrml, "Mesh with the NC line of every face, VRML97")
        ->type_name("FILE");
    run->add_option("--stl", o.stl, "Mesh, binary STL")->type_name("FILE");
    run->add_option("--step", o.step, "Solid for CAD, STEP AP214")->type_name("FILE");
    run->add_option("--report", o.report, "What happened, JSON")->type_name("FILE");
    run->add_option("--stats", o.stats, "What each hull cost, CSV")->type_name("FILE");
    run->add_option("--xml", o.xml, "The cells of the workpiece, XML")->type_name("FILE");
    run->add_option("--stock", stock, "The block, if the program does not say it")
        ->type_name("BOX");
    run->add_option("--tool", tools, "A tool, more than once for more tools")
        ->type_name("TOOL")
        ->expected(1)
        ->take_all();
    run->add_option("--assume-tool", assumed, "For tools nobody describes, as flat:D6")
        ->type_name("TOOL");
    run->add_option("--units", units, "Of programs without G20 and G21: mm or inch")
        ->type_name("UNIT");
    run->add_flag("--block-delete", o.block_delete, "Skip blocks that start with '/'");
    run->add_option("--dialect", dialect,
                    "Control it was written for: auto, rs274, fanuc, haas, grbl, mach3")
        ->type_name("NAME");
    run->add_flag("--strict", o.strict, "Refuse what RS274/NGC as LinuxCNC runs it refuses");
    run->add_option("--allow", o.allow, "Words to pass over in silence: G187,M198")
        ->type_name("WORDS")
        ->delimiter(',');
    run->add_option("--model", o.model, "Workpiece model: cda, cda-flat")->type_name("NAME");
    run->add_option("--tolerance", tolerance, "Of arcs and turning tools, mm [0.005]")
        ->type_name("MM");
    run->add_option("--tool-tolerance", tool_tolerance, "Of round tools, mm [0.05]")
        ->type_name("MM");
    run->add_option("--threads", o.threads, "Threads; the result is the same for any number")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    run->add_option("--view", view, "iso, top, bottom, front, back, left, right")
        ->type_name("VIEW");
    run->add_option("--colour", colouring, "What colours tell: tool, line, depth")
        ->type_name("WHAT");
    run->add_option("--size", size, "Of the picture, pixels [1280x960]")->type_name("WxH");
    run->add_flag("!--no-block-volumes", o.block_volumes,
                  "Report without what each block removed: faster with --model cda");
    run->add_flag("--quiet,-q", o.quiet, "Only errors and warnings");

    try {
        // CLI11 takes them last first.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));

        if (!size.empty()) read_size(size, o);
        o.tolerance = read_tolerance("--tolerance", tolerance);
        o.tool_tolerance = read_tolerance("--tool-tolerance", tool_tolerance);
        if (const auto parsed = exporter::parse_view(view)) {
            o.view = *parsed;
        } else {
            throw Refusal{fmt::format(
                "--view '{}': expected iso, top, bottom, front, back, left or right", view)};
        }
        if (colouring == "line") {
            o.colouring = exporter::Colouring::Line;
        } else if (colouring == "depth") {
            o.colouring = exporter::Colouring::Depth;
        } else if (colouring != "tool") {
            throw Refusal{fmt::format("--colour '{}': expected tool, line or depth", colouring)};
        }
        o.dialect = read_dialect(dialect);
        if (units != "mm" && units != "inch") {
            throw Refusal{fmt::format("--units '{}': expected mm or inch", units)};
        }
        o.inches = units == "inch";
        choose_model(o);
        for (const std::string& tool : tools) {
            o.tools.push_back(read_tool(tool));
            const int number = o.tools.back().number;
            if (std::count_if(o.tools.begin(), o.tools.end(),
                              [number](const auto& t) { return t.number == number; }) > 1) {
                throw Refusal{fmt::format("--tool: T{} is described twice", number)};
            }
        }
        if (!assumed.empty()) {
            // With or without a number, which does not matter here.
            const std::size_t equals = assumed.find('=');
            o.assumed_tool =
                read_tool("T1=" + assumed.substr(equals == std::string::npos ? 0 : equals + 1));
            o.assumed_tool->number = 0;
        }
        if (!stock.empty()) {
            std::string message;
            o.stock = toolpath::parse_stock_option(stock, message);
            if (!o.stock) throw Refusal{"--stock " + message};
        }
        check_paths(o);
    } catch (const CLI::CallForHelp&) {
        const auto chosen = app.get_subcommands();
        return Farewell{kClean, chosen.empty() ? app.help() : chosen.front()->help()};
    } catch (const CLI::CallForVersion&) {
        return Farewell{kClean, fmt::format("ncsim {}\n", kVersion)};
    } catch (const CLI::ParseError& e) {
        return Farewell{kEnvironment, fmt::format("ncsim: {}\nTry: ncsim run --help\n", e.what())};
    } catch (const Refusal& e) {
        return Farewell{kEnvironment, fmt::format("ncsim: {}\n", e.text)};
    }
    return o;
}

}  // namespace ncsim::app
