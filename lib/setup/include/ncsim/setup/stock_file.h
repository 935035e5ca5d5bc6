// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stock from files: a closed surface, or the result of an earlier program.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/shape.h"
#include "ncsim/setup/input.h"
#include "ncsim/toolpath/stock.h"

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

namespace ncsim::setup {

/// True if `text` names a stock file: by the end of its name, .stl, .glb, .step, .stp or .ncstock,
/// or as "-", the standard input.
bool is_stock_file(const std::string& text);

/// Reads rotations by right angles about the program's axes, in sequence: "X180", "X90,Z-90".
/// Throws: std::invalid_argument with the expected form.
cda::Placement parse_turn(const std::string& text);

/// Reads, rotates and moves a stock. Surfaces are read as by read_surface_file(), in mm, on the
/// finest lattice that contains them. A .ncstock of --save-stock is read exactly, on its own
/// lattice.
/// Throws: std::runtime_error with the name of the file, if it has neither form or is too far from
/// the origin.
toolpath::Stock read_stock_file(const toolpath::StockFile& file, InputSet& inputs);

/// Writes the rest of `stock` after the cells `carved`, for read_stock_file(), with the assumptions
/// of the run, a text each.
void write_stock_file(std::ostream& out, const cda::Shape& stock, std::span<const cda::Cell> carved,
                      const std::vector<std::string>& assumed);

}  // namespace ncsim::setup
