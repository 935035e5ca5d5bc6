// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of the review of a changed program: the difference, both programs, regions and pictures.
#pragma once

#include "ncsim/simulation/difference.h"
#include "ncsim/verify/distances.h"
#include "ncsim/verify/region.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// Conditions of the feed moves of a tool, as text: "200 to 500 mm/min", "M3 5000 rpm", "M8".
struct ToolProcess {
    std::string feed, spindle, coolant;
};

/// A tool of a program.
struct ReviewTool : ToolProcess {
    std::string shape;  ///< As from toolpath::describe().
    verify::Distances distances;
};

/// Either of the two programs.
struct ReviewSide {
    std::string source;              ///< Text of the program.
    std::vector<std::string> files;  ///< Names of files; 0: the program.
    std::map<int, ReviewTool> tools;
};

/// Connected material of a single part.
struct ReviewRegion {
    bool is_only_old = true;  ///< False: only the new part has the material.
    double volume_mm3 = 0.0;
    Box box;     ///< mm
    Vec3 point;  ///< A point of the surface, mm.
    /// Lines of each program that left a surface of the material, or removed the material.
    std::vector<verify::LineRange> old_lines, new_lines;
    bool has_stock_surface = false;  ///< A surface of the material is uncut stock.
};

/// Pictures from the same direction, PNG.
struct ReviewPicture {
    std::string view;  ///< "isometric"
    std::string before, after;
    std::string difference;  ///< Empty: the parts are equal.
    /// Place of a region in the picture: shares of width and height, from the upper left corner.
    struct Pin {
        std::size_t region = 0;  ///< Index into Review::regions.
        double x = 0.0, y = 0.0;
    };
    std::vector<Pin> pins;
};

/// Comparison of two programs.
struct Review {
    Difference difference;
    ReviewSide old_side, new_side;
    /// The largest regions of each kind; regions of the old part come first.
    std::vector<ReviewRegion> regions;
    std::vector<ReviewPicture> pictures;
};

}  // namespace ncsim::simulation
