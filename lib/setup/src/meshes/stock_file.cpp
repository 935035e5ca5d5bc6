// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stock from surfaces and from .ncstock files.
#include "ncsim/setup/stock_file.h"

#include "ncsim/base/angles.h"
#include "ncsim/base/ascii.h"
#include "ncsim/base/number_text.h"
#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/setup/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::setup {

namespace {

bool ends_with(const std::string& text, std::string_view end) {
    return text.size() > end.size() && lowercase(text).ends_with(end);
}

bool is_saved(const toolpath::StockFile& file, InputSet& inputs) {
    if (file.path != "-") return ends_with(file.path, ".ncstock");
    return inputs.read(file.path).starts_with("ncsim stock");
}

// Turns and moves a closed surface. The result is on the finest lattice that contains it.
cda::Shape turned(TriangleMesh& mesh, const Turn& turn, Vec3 move) {
    Box box;
    for (Vec3& p : mesh.vertices) {
        Vec3 q = move;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k)
                q[i] += turn.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] * p[k];
        }
        p = q;
        box.add(p);
    }
    return cda::shape_of(mesh, cda::Lattice::for_stock(box));
}

// Error of a surface whose corners are rounded: cda::shape_of() differs by two units of 10 nm, and
// so does the rounding.
constexpr double kRoundedMm = 4e-5;

cda::Shape read_saved(const toolpath::StockFile& file, const Turn& turn, const std::string& text,
                      toolpath::Stock& stock) {
    std::istringstream in(text);
    cda::Shape shape;
    try {
        shape = cda::read_shape(in);
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(fmt::format("{}:{}", name_of_input(file.path), e.what()));
    }
    if (turn.placement) {
        cda::Placement placement = *turn.placement;
        placement.shift = shape.lattice.round(file.move);
        stock.placement = placement;
        return cda::placed(shape, placement);
    }
    // The turned surface is cut into other cells, so their origins are unknown.
    TriangleMesh mesh =
        cda::triangulate(cda::create(cda::TreeCda(cda::TreeParameters{}), shape)->boundary());
    cda::Shape result = turned(mesh, turn, file.move);
    result.assumed = std::move(shape.assumed);
    stock.deflection_mm = kRoundedMm;
    return result;
}

// Reads a closed surface. `deflection_mm` is set to the value of the file.
cda::Shape read_surface(const toolpath::StockFile& file, const Turn& turn, InputSet& inputs,
                        double& deflection_mm) {
    SurfaceFile surface = read_surface_file(file.path, inputs);
    deflection_mm = surface.deflection_mm;
    cda::Shape shape = turned(surface.mesh, turn, file.move);
    if (!surface.assumed.empty()) shape.assumed = {std::move(surface.assumed)};
    return shape;
}

}  // namespace

bool is_stock_file(const std::string& text) {
    constexpr std::string_view kEnds[] = {".ncstock", ".stl", ".glb", ".step",
                                          ".stp",     ".obj", ".wrl"};
    return text == "-" ||
           std::ranges::any_of(kEnds, [&](std::string_view end) { return ends_with(text, end); });
}

std::optional<toolpath::Stock> specified_stock(const std::string& text, std::string& message) {
    if (!is_stock_file(text)) return toolpath::parse_stock_option(text, message);
    toolpath::Stock stock;
    stock.from = toolpath::StockFile{text};
    return stock;
}

namespace {

struct AxisTurn {
    int axis = 0;
    double degrees = 0.0;
};

// Reads "X90,Z-37.5". Empty if the text has another form.
std::optional<std::vector<AxisTurn>> turns_of(std::string_view text) {
    constexpr double kMost = 3600.0;
    std::vector<AxisTurn> turns;
    for (std::size_t begin = 0; begin <= text.size() && !text.empty();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view turn = text.substr(begin, end - begin);
        const std::size_t axis =
            turn.size() < 2 ? std::string_view::npos : std::string_view("XYZxyz").find(turn[0]);
        if (axis == std::string_view::npos) return std::nullopt;
        const auto degrees = number_in<double>(turn.substr(1));
        if (!degrees || !(std::abs(*degrees) <= kMost)) return std::nullopt;
        turns.push_back({static_cast<int>(axis % 3), *degrees});
        begin = end + 1;
    }
    return turns;
}

bool is_right_angle(const AxisTurn& turn) {
    return std::fmod(turn.degrees, 90.0) == 0.0;
}

cda::Placement placement_of(const std::vector<AxisTurn>& turns) {
    cda::Placement placement;
    for (const AxisTurn& turn : turns)
        placement = placement.turned(turn.axis, static_cast<int>(turn.degrees / 90.0) % 4);
    return placement;
}

}  // namespace

Turn parse_any_turn(const std::string& text) {
    const auto turns = turns_of(text);
    if (!turns) {
        throw std::invalid_argument(
            fmt::format("'{}': expected angles about axes, such as X180 or X90,Z-37.5", text));
    }
    Turn all;
    if (std::ranges::all_of(*turns, is_right_angle)) {
        all.placement = placement_of(*turns);
        for (std::size_t i = 0; i < 3; ++i)
            std::ranges::copy(all.placement->rows[i], all.rows[i].begin());
        return all;
    }
    all.placement.reset();
    for (const AxisTurn& turn : *turns) {
        const SinCos angle = sin_cos(turn.degrees);
        const auto a = static_cast<std::size_t>((turn.axis + 1) % 3);
        const auto b = static_cast<std::size_t>((turn.axis + 2) % 3);
        for (std::size_t k = 0; k < 3; ++k) {
            const double p = all.rows[a][k], q = all.rows[b][k];
            all.rows[a][k] = angle.cos * p - angle.sin * q;
            all.rows[b][k] = angle.sin * p + angle.cos * q;
        }
    }
    return all;
}

namespace {

// Makes a stock of the shape that `read` places by file.turn.
template <class Read>
toolpath::Stock stock_of(const toolpath::StockFile& file, const Read& read) {
    toolpath::Stock stock;
    stock.from = file;
    try {
        stock.shape = std::make_shared<const cda::Shape>(read(parse_any_turn(file.turn), stock));
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(fmt::format("stock '{}': {}", file.path, e.what()));
    }
    stock.box = stock.shape->outer.bounds;
    return stock;
}

}  // namespace

toolpath::Stock read_stock_file(const toolpath::StockFile& file, InputSet& inputs) {
    if (is_saved(file, inputs)) return read_saved_stock(file, inputs.read(file.path));
    return stock_of(file, [&](const Turn& turn, toolpath::Stock& stock) {
        return read_surface(file, turn, inputs, stock.deflection_mm);
    });
}

toolpath::Stock read_saved_stock(const toolpath::StockFile& file, const std::string& text) {
    return stock_of(file, [&](const Turn& turn, toolpath::Stock& stock) {
        return read_saved(file, turn, text, stock);
    });
}

}  // namespace ncsim::setup
