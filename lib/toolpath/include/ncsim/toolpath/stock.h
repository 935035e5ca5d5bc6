// SPDX-License-Identifier: GPL-3.0-or-later
//
// The block of material a program starts with: said by somebody, or derived from what is cut.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/shape.h"
#include "ncsim/cda/vec.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::toolpath {

/// Where stock that is no block comes from.
struct StockFile {
    std::string path;
    std::string turn{};  ///< "X180": by right angles about the axes of the program,
    cda::Vec3 move{};    ///< and then moved by so much, mm.
    bool operator==(const StockFile&) const = default;
};

/// A block; a round bar in its box, which is square across its axis; or any shape in its box, from
/// a file. mm.
struct Stock {
    cda::Box box;
    bool is_round = false;
    int axis = 2;  ///< Of a bar: 0, 1, 2 for X, Y, Z.
    std::optional<StockFile> from{};
    std::shared_ptr<const cda::Shape> shape{};  ///< Of `from`, once it was read.
    double deflection_mm = 0.0;  ///< How far `shape` may be from what the file means.
    bool operator==(const Stock& o) const {
        return box == o.box && is_round == o.is_round && axis == o.axis && from == o.from;
    }
};

/// Reads `x0,y0,z0:x1,y1,z1` (two corners) or `LxWxH` (sizes; the top at Z0, centred on X0 Y0) or
/// `LxWxH@x,y,z` (sizes and the corner with the smallest coordinates), for a bar `DdxH` (diameter
/// and height; the top at Z0, the axis in X0 Y0) or `DdxH@x,y,z` (the middle of its lower end); for
/// one that lies along X or Y `DXdxL` or `DYdxL` (centred on the program's zero), with `@`
/// likewise. In mm, or in inches where the text ends in `in` or `"`; a number may have a unit of
/// its own (`4inx2inx12mm`), and fractions are inches (`100x50x1/2`). Nothing if it is of none of
/// these forms or encloses no volume; the message then says why.
std::optional<Stock> parse_stock_option(std::string_view text, std::string& message);

/// "x,y,z"
std::optional<cda::Vec3> parse_triple(std::string_view text);

/// The stock on its lattice: the finest that reaches a block or a bar, its own for a file. A bar
/// has as many sides as it takes for none of them to lie more than `tolerance_mm` outside of the
/// circle, which all of them touch.
cda::Shape stock_shape(const Stock& stock, double tolerance_mm);
cda::Lattice stock_lattice(const Stock& stock);

/// For a program that does not say what it cuts.
struct DerivedStock {
    Stock stock;
    std::string rule;  ///< How it was made, in words for the assumption sheet.
};

/// The three highest of the heights at which tools cut level, mm.
class HighestLevels {
public:
    void add(double z);
    void add(const HighestLevels& others);
    double highest() const { return levels_[0]; }
    /// From one to the next, if all three are equally far apart, as passes of a roughing are.
    std::optional<double> step() const;

private:
    static constexpr double kNone = -std::numeric_limits<double>::infinity();
    std::array<double, 3> levels_{kNone, kNone, kNone};
};

/// From the box swept by the tools in all cutting moves (mm). The sides and the bottom stand a
/// twentieth of the size away from it, at least 2 mm. The top is Z0 where the tool cuts below Z0:
/// programs put it there, unless all cuts lie within a band that is more than 10 mm and four times
/// its height below Z0; else the highest cutting position of a tool tip, `highest_tip`, or a step
/// above it, where that is the first of passes in equal steps: it took a step, too. At least 1 mm
/// thick.
DerivedStock derive_stock(const cda::Box& swept, double highest_tip,
                          const HighestLevels& levels = {});
/// For a path of which nobody tells the height: a sheet of 1 mm right below it.
DerivedStock derive_sheet(const cda::Box& tips);
/// For a part that turns about `axis` (0, 1, 2) through the program's zero: a bar about it, as
/// thick as the tips are far out where they cut, `radius`. Its ends stand away as above.
DerivedStock derive_bar(const cda::Box& swept, int axis, double radius);
/// For a part that turns about several: a block around all the tips' cutting positions.
DerivedStock derive_block(const cda::Box& tips);

}  // namespace ncsim::toolpath
