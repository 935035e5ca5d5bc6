// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stock that is no block: a closed surface, or what another program has left.
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

/// Does `text` name such a file? By its end, .stl, .glb, .step, .stp or .ncstock, or as "-", the
/// standard input.
bool is_stock_file(const std::string& text);

/// "X180", "X90,Z-90": turns by right angles about the axes of the program, one after the other.
/// Throws std::invalid_argument that says what was expected.
cda::Placement parse_turn(const std::string& text);

/// Reads it, turns it and moves it. Surfaces as read_surface_file() does, in mm, on the finest
/// lattice that reaches them; .ncstock as --save-stock writes it, exactly, on the lattice it has.
/// Throws std::runtime_error, naming the file, if it is neither or is too far from the origin.
toolpath::Stock read_stock_file(const toolpath::StockFile& file, InputSet& inputs);

/// Writes what is left of `stock` after `carved`, for read_stock_file(), with the assumptions of
/// the run, a text each.
void write_stock_file(std::ostream& out, const cda::Shape& stock, std::span<const cda::Cell> carved,
                      const std::vector<std::string>& assumed);

}  // namespace ncsim::setup
