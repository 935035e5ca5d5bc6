// SPDX-License-Identifier: GPL-3.0-or-later
//
// The body of material that a program starts with, specified or derived from the cutting moves.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/shape.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::toolpath {

/// File and placement of a stock that is not a block.
struct StockFile {
    std::string path;
    /// Rotations by right angles about the program's axes, for example "X180".
    std::string turn{};
    Vec3 move{};  ///< Translation after the rotation, mm.
    bool operator==(const StockFile&) const = default;
};

/// A block, a round bar in its box (square across the bar's axis), or a body from a file in its
/// box. In mm, in the frame of the program.
struct Stock {
    Box box;
    bool is_round = false;
    int axis = 2;  ///< Axis of a bar: 0, 1, 2 for X, Y, Z.
    std::optional<StockFile> from{};
    std::shared_ptr<const cda::Shape> shape{};  ///< Content of `from`, after it was read.
    /// Placement of `shape` in relation to the file, for what Shape::sources record.
    cda::Placement placement{};
    /// Largest distance between `shape` and the body that the file describes.
    double deflection_mm = 0.0;
    bool operator==(const Stock& o) const {
        return box == o.box && is_round == o.is_round && axis == o.axis && from == o.from;
    }
};

/// Reads a stock, in mm:
/// - `x0,y0,z0:x1,y1,z1`: two corners;
/// - `LxWxH`: sizes, with the top at Z0, centred on X0 Y0;
/// - `LxWxH@x,y,z`: sizes and the corner with the smallest coordinates;
/// - `DdxH`: diameter and height of a bar, with the top at Z0 and the axis in X0 Y0;
/// - `DdxH@x,y,z`: the same with the centre of the lower end;
/// - `DXdxL` or `DYdxL`: a bar along X or Y, centred on the program zero, or with `@` as above.
///
/// Numbers are inches if the text ends in `in` or `"`. A number may have a unit of its own
/// (`4inx2inx12mm`), and fractions are inches (`100x50x1/2`). Returns empty, with the reason in
/// `message`, if the text has none of these forms or encloses no volume.
std::optional<Stock> parse_stock_option(std::string_view text, std::string& message);

/// Reads "x,y,z".
std::optional<Vec3> parse_triple(std::string_view text);

/// Returns the stock on its lattice. A bar is a prism whose sides touch the circle and whose
/// corners lie at most `tolerance_mm` outside the circle.
cda::Shape stock_shape(const Stock& stock, double tolerance_mm);
/// Returns the finest lattice that contains a block or a bar; for a file its own lattice.
cda::Lattice stock_lattice(const Stock& stock);

/// Stock of a program that does not specify a stock.
struct DerivedStock {
    Stock stock;
    std::string rule;  ///< Rule by which `stock` was derived, in words for the assumption sheet.
};

/// The three highest heights of level cuts, mm.
class HighestLevels {
public:
    /// Adds the height of a level cut.
    void add(double z);
    void add(const HighestLevels& others);
    /// Returns the highest level.
    double highest() const { return levels_[0]; }
    /// Returns the distance between neighbouring levels if all three are equally far apart, as
    /// roughing passes are.
    std::optional<double> step() const;

private:
    static constexpr double kNone = -std::numeric_limits<double>::infinity();
    std::array<double, 3> levels_{kNone, kNone, kNone};
};

/// Derives a block from `swept`, the box swept by the tools in all cutting moves (mm). The sides
/// and the bottom lie outside that box by a twentieth of the size, at least 2 mm. The top is Z0 if
/// the tool cuts below Z0, because programs put Z0 there, unless all cuts lie within a band that is
/// more than 10 mm and more than four times the band's height below Z0. Otherwise the top is the
/// highest cutting position of a tool tip, `highest_tip`, or a step above it if `levels` shows
/// passes in equal steps, because the first pass removed a step, too. The block is at least 1 mm
/// thick.
DerivedStock derive_stock(const Box& swept, double highest_tip, const HighestLevels& levels = {});
/// Derives a sheet of 1 mm directly below the path, for a path of unknown height.
DerivedStock derive_sheet(const Box& tips);
/// Derives a bar about `axis` (0, 1, 2) through the program zero, for a part that rotates about
/// that axis. The bar's radius is `radius`, the largest distance of the tips from the axis during
/// cuts. The ends have the allowance of derive_stock().
DerivedStock derive_bar(const Box& swept, int axis, double radius);
/// Derives a block around all cutting positions of the tips, for a part that rotates about several
/// axes.
DerivedStock derive_block(const Box& tips);

}  // namespace ncsim::toolpath
