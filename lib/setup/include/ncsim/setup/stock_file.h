// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stock from files: a closed surface, or the result of an earlier program.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/shape.h"
#include "ncsim/setup/input.h"
#include "ncsim/toolpath/stock.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

/// True if `text` names a stock file: by the end of its name, .stl, .obj, .wrl, .glb, .step,
/// .stp or .ncstock,
/// or as "-", the standard input.
bool is_stock_file(const std::string& text);
/// Returns the stock that `text` specifies: dimensions ("100x60x20") or the name of a stock file,
/// which is not read. Empty with the expected form in `message` if `text` is neither.
std::optional<toolpath::Stock> specified_stock(const std::string& text, std::string& message);

/// A rotation of stock from a file.
struct Turn {
    /// Rows of the rotation matrix.
    std::array<std::array<double, 3>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    /// The same rotation, exact; empty unless the rotation consists of right angles.
    std::optional<cda::Placement> placement = cda::Placement{};
};
/// Reads rotations by any angles in degrees, in sequence: "X180", "X90,Z-37.5".
/// Throws: std::invalid_argument with the expected form.
Turn parse_any_turn(const std::string& text);

/// Reads, rotates and moves a stock. A rotation by other angles than right angles rounds the
/// corners of the surface to the lattice, within 40 nm (Stock::deflection_mm). Surfaces are read as
/// by read_surface_file(), in mm, on the finest lattice that contains them. A .ncstock of
/// --save-stock is read exactly, on its own lattice. Throws: std::runtime_error with the name of
/// the file, if it has neither form or is too far from the origin.
toolpath::Stock read_stock_file(const toolpath::StockFile& file, InputSet& inputs);

/// Does the same for the text of a .ncstock, which `file` names in messages.
toolpath::Stock read_saved_stock(const toolpath::StockFile& file, const std::string& text);

}  // namespace ncsim::setup
