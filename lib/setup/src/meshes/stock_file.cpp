// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stock from surfaces and from .ncstock files.
#include "ncsim/setup/stock_file.h"

#include "ncsim/report/plain_text.h"
#include "ncsim/setup/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace ncsim::setup {

namespace {

bool ends_with(const std::string& text, std::string_view end) {
    if (text.size() <= end.size()) return false;
    return std::equal(
        end.begin(), end.end(), text.end() - static_cast<std::ptrdiff_t>(end.size()),
        [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

bool is_saved(const toolpath::StockFile& file, InputSet& inputs) {
    if (file.path != "-") return ends_with(file.path, ".ncstock");
    return inputs.read(file.path).starts_with("ncsim stock");
}

cda::Shape read_saved(const toolpath::StockFile& file, cda::Placement placement, InputSet& inputs) {
    std::istringstream in(inputs.read(file.path));
    cda::Shape shape;
    try {
        shape = cda::read_shape(in);
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(fmt::format("{}:{}", name_of_input(file.path), e.what()));
    }
    placement.shift = shape.lattice.round(file.move);
    return cda::placed(shape, placement);
}

// Reads a closed surface. `deflection_mm` is set to the value of the file.
cda::Shape read_surface(const toolpath::StockFile& file, const cda::Placement& placement,
                        InputSet& inputs, double& deflection_mm) {
    SurfaceFile surface = read_surface_file(file.path, inputs);
    deflection_mm = surface.deflection_mm;
    cda::TriangleMesh& mesh = surface.mesh;
    cda::Box box;
    std::vector<std::string> assumed;
    if (!surface.assumed.empty()) assumed.push_back(std::move(surface.assumed));
    for (cda::Vec3& p : mesh.vertices) {
        cda::Vec3 turned = file.move;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                turned[i] +=
                    placement.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] * p[k];
            }
        }
        p = turned;
        box.add(p);
    }
    cda::Shape shape = cda::shape_of(mesh, cda::Lattice::for_stock(box));
    shape.assumed = std::move(assumed);
    return shape;
}

}  // namespace

bool is_stock_file(const std::string& text) {
    return text == "-" || ends_with(text, ".ncstock") || ends_with(text, ".stl") ||
           ends_with(text, ".glb") || ends_with(text, ".step") || ends_with(text, ".stp");
}

cda::Placement parse_turn(const std::string& text) {
    cda::Placement placement;
    for (std::size_t begin = 0; begin <= text.size() && !text.empty();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view turn = std::string_view(text).substr(begin, end - begin);
        const std::size_t axis =
            turn.empty() ? std::string_view::npos : std::string_view("XYZxyz").find(turn[0]);
        int degrees = 0;
        const auto read =
            turn.size() < 2 ? std::from_chars_result{turn.data(), std::errc::invalid_argument}
                            : std::from_chars(turn.data() + 1, turn.data() + turn.size(), degrees);
        if (axis == std::string_view::npos || read.ec != std::errc{} ||
            read.ptr != turn.data() + turn.size() || degrees % 90 != 0) {
            throw std::invalid_argument(fmt::format(
                "'{}': expected right angles about axes, such as X180 or X90,Z-90", text));
        }
        placement = placement.turned(static_cast<int>(axis % 3), degrees / 90 % 4);
        begin = end + 1;
    }
    return placement;
}

toolpath::Stock read_stock_file(const toolpath::StockFile& file, InputSet& inputs) {
    toolpath::Stock stock;
    stock.from = file;
    try {
        const cda::Placement placement = parse_turn(file.turn);
        stock.shape = std::make_shared<const cda::Shape>(
            is_saved(file, inputs) ? read_saved(file, placement, inputs)
                                   : read_surface(file, placement, inputs, stock.deflection_mm));
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(fmt::format("stock '{}': {}", file.path, e.what()));
    }
    stock.box = stock.shape->outer.bounds;
    return stock;
}

void write_stock_file(std::ostream& out, const cda::Shape& stock, std::span<const cda::Cell> carved,
                      const std::vector<std::string>& assumed) {
    std::vector<std::string> lines;
    lines.reserve(assumed.size());
    for (const std::string& text : assumed)
        lines.push_back(report::one_line(text));
    cda::ShapeWriter writer(out, stock.lattice, stock.outer, lines);
    for (const cda::Cell& cell : stock.carved)
        writer.carve(cell);
    for (const cda::Cell& cell : carved)
        writer.carve(cell);
    writer.end();
}

}  // namespace ncsim::setup
