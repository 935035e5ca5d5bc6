// SPDX-License-Identifier: GPL-3.0-or-later
//
// Result of the verification of a program: path, verdict or failure, and data for pages.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/vec3.h"
#include "ncsim/simulation/design_facts.h"
#include "ncsim/simulation/play_data.h"
#include "ncsim/verify/verdict.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::simulation {

/// A machine around the part, as a page shows it.
struct MachinePageData {
    /// Joint as in machine::Joint; `axis` is the index into Stand::values.
    struct Joint {
        std::size_t axis = 0;
        bool turns = false;
        Vec3 direction, through;
    };
    /// A body of the machine or of a tool.
    struct Body {
        std::string name;
        std::array<std::uint8_t, 3> colour{};  ///< sRGB.
        TriangleMesh mesh;                     ///< Machine coordinates with all joints at 0, mm.
        std::vector<Joint> moved_by;           ///< Joints that move the body, from the bed on.
        std::int32_t tool = -1;  ///< Body of this tool (Stand::tool); -1: body of the machine.
    };
    /// Positions of the joints at a time of the program, and the tool in the spindle.
    struct LinePose {
        std::array<double, 9> values{};
        std::int32_t tool = -1;
    };
    std::vector<Body> bodies;
    std::vector<Joint> part_moved_by;
    Vec3 zero;  ///< Origin of the program's frame, with all joints at 0.
    /// By line; for a line that runs several times, the last time.
    std::map<std::uint32_t, LinePose> line_poses;
    /// By index of a finding in which bodies meet: where the bodies meet.
    std::map<std::size_t, LinePose> finding_poses;
};

/// Form of a face, as CAD systems name it.
struct FaceForm {
    std::string name;                ///< "plane", "cylinder" …
    std::vector<double> dimensions;  ///< Diameters in mm; for a cone, the full angle in degrees.
    Vec3 axis;                       ///< Unit direction; zero: none.
    Vec3 origin;                     ///< A point on the axis, mm.
    bool is_hollow = false;          ///< The material surrounds the form, as around a bore.
};

/// Surface of a part with its distances from the design.
struct DeviationMesh {
    TriangleMesh mesh;  ///< mm, W.
    /// For each vertex, mm; positive: material is left, negative: the part is cut into the design.
    std::vector<double> deviation_mm;
    double tolerance_mm = 0.0;
};

/// Additional data for a page.
struct PageData {
    std::string source;  ///< Text of the program.
    std::string title;   ///< Name of the program file.
    Box stock;           ///< mm
    TriangleMesh mesh;   ///< Surface of the part; empty if nothing was simulated.
    /// For each triangle, the line that cut the triangle; 0: the stock.
    std::vector<std::uint32_t> lines;
    /// Three unit normals for each triangle: the normals of the true surface in the corners.
    std::vector<Vec3> normals;
    std::vector<FaceForm> forms;         ///< Recognised forms.
    std::vector<std::uint32_t> form_of;  ///< For each triangle, index into `forms` plus 1; 0: none.
    std::vector<std::uint32_t> tool_of;  ///< For each triangle, number of the tool; 0: the stock.
    std::vector<ColouredMesh> fixtures;  ///< Frame of the part.
    std::optional<PlayData> play;        ///< Empty: the page shows the finished part only.
    std::vector<std::pair<std::string, std::string>> pictures;  ///< Name and PNG.
    std::optional<DeviationMesh> deviation;  ///< Only if the part was compared with a design.
    std::string thumbnail;                   ///< Small picture for an index, PNG; empty: none.
    /// A specified machine with bodies and motion; otherwise nullopt.
    std::optional<MachinePageData> machine;
};

/// A finding of a baseline that was not found again.
struct ResolvedFinding {
    std::string rule, severity;
    std::uint32_t line = 0;  ///< Line in the baseline.
    std::string what;        ///< Message and quantity.
};

/// Operation: blocks of a tool between names in comments.
struct CheckedOperation {
    std::string name;        ///< Empty if the comments name none.
    std::uint32_t line = 0;  ///< Line of the name; 0 without one.
    int tool = 0;
    std::uint64_t first_motion = 0;  ///< As in LedgerRow.
};

/// Result of the verification of one program.
struct Checked {
    std::string path;     ///< Path as specified.
    std::string program;  ///< "O0101" if the file has several programs; otherwise empty.
    std::string_view word = "not-verified";  ///< "clean", "accepted", "not-proven", "failed".
    /// Outcome for `word`; only if there is a verdict.
    verify::Outcome outcome = verify::Outcome::NotProven;
    /// Reason why there is no verdict, such as an unreadable file or an internal error; empty:
    /// there is a verdict.
    std::string failure;
    verify::Verdict verdict;
    /// For each finding the line as written; empty for a finding without line.
    std::vector<std::string> lines;
    bool simulated = false;
    std::string not_simulated;  ///< Reason why the program was not simulated.
    std::string settings;  ///< Settings file (ncsim.toml) with options of the program; empty: none.
    std::string baseline;  ///< File of known findings; empty: none.
    std::vector<ResolvedFinding> resolved;  ///< Findings of the baseline that were not found.
    std::string stock;                      ///< Stock, as text.
    Box stock_box;                          ///< Its box, mm; empty: not known.
    std::string time;                       ///< Machining time, as text; empty: no motion.
    std::optional<double> seconds;          ///< Machining time; empty: not known.
    std::uint64_t moves = 0;
    std::vector<CheckedOperation> operations;  ///< In the order of execution.
    std::optional<DesignFacts> design;         ///< Only if the part was compared with a design.
    std::optional<PageData> page_data;         ///< Only if a page is written.
};

}  // namespace ncsim::simulation
