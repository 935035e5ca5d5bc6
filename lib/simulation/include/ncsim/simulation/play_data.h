// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data with which a page plays a program: states of the part, path and tools.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/surface_recorder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// A body of one colour.
struct ColouredMesh {
    TriangleMesh mesh;                     ///< mm
    std::array<std::uint8_t, 3> colour{};  ///< sRGB
    std::string name{};                    ///< Name of the body in findings; empty: none.
};

/// A tool of a program.
struct PlayTool {
    std::string name;                  ///< "T3 end mill D10"
    std::vector<ColouredMesh> pieces;  ///< Frame of the tool: tip in the origin, axis +Z.
};

/// A move of the program.
struct PlayMove {
    std::uint32_t line = 0;  ///< Line of the program, from 1; 0: line of a called file.
    std::uint32_t tool = 0;  ///< Index into PlayData::tools.
    bool is_rapid = false;
    std::uint32_t first_point = 0;  ///< Start in PlayData::points.
    std::uint32_t last_point = 0;   ///< End; start and end may be the same point.
    double seconds = 0.0;           ///< Time at the end of the move.
};

/// State of the part in PlayData::surface.
struct PlayState {
    std::uint32_t moves = 0;  ///< Number of completed moves.
    std::uint32_t line = 0;   ///< Line of the last of these moves; 0: none.
};

/// A program as a page plays it. Frame of the part, mm.
struct PlayData {
    cda::SurfaceRecorder surface;
    std::vector<std::uint32_t> line_of_origin;  ///< Line of each origin in `surface`.
    std::vector<PlayState> states;              ///< By state of `surface`.
    std::vector<PlayMove> moves;
    std::vector<Vec3> points;  ///< Positions of the tip.
    std::vector<Vec3> axes;    ///< Direction of the tool in each point, from the tip up.
    std::vector<PlayTool> tools;
    bool feeds_known = true;  ///< False: moves without a feed are timed at 1000 mm/min.
};

}  // namespace ncsim::simulation
