// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program, verified, as reports tell it: from a path to a verdict, whatever is wrong with it.
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/report/design_facts.h"
#include "ncsim/verify/finding.h"
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

namespace ncsim::report {

/// A machine as a page shows it, about the part.
struct MachineLook {
    /// As machine::Joint; `axis` is its place in Stand::values.
    struct Joint {
        std::size_t axis = 0;
        bool turns = false;
        cda::Vec3 direction, through;
    };
    struct Body {
        std::string name;
        std::array<std::uint8_t, 3> colour{};  ///< sRGB.
        cda::TriangleMesh mesh;                ///< Machine coordinates with all joints at 0, mm.
        std::vector<Joint> moved_by;           ///< From the bed on.
        std::int32_t tool = -1;  ///< A piece of this tool of Stand; -1: of the machine.
    };
    /// Where the joints are at the end of a line of the program, and which tool is in the spindle.
    struct Stand {
        std::array<double, 9> values{};
        std::int32_t tool = -1;
    };
    std::vector<Body> bodies;
    std::vector<Joint> part_moved_by;
    cda::Vec3 zero;                         ///< Of the program, with all joints at 0.
    std::map<std::uint32_t, Stand> stands;  ///< By line; of one that is run often, the last time.
};

/// What a page shows beside the verdict.
struct Look {
    std::string source;                ///< The program.
    cda::TriangleMesh mesh;            ///< Of the part; empty if nothing was simulated.
    std::vector<std::uint32_t> lines;  ///< For each triangle the line that cut it; 0: the stock.
    /// Three for each triangle, in its corners: those of what its facet stands for. Unit.
    std::vector<cda::Vec3> normals;
    std::vector<std::pair<std::string, std::string>> pictures;  ///< Name and PNG.
    std::optional<MachineLook> machine;  ///< Where one is told that has shapes, and moves.
};

/// A finding of a baseline that is not there any more.
struct NoLonger {
    std::string rule, severity;
    std::uint32_t line = 0;  ///< Where it was.
    std::string what;        ///< Message and quantity.
};

struct Checked {
    std::string path;                        ///< As it was named.
    std::string program;                     ///< "O0101" of a file with several; else empty.
    std::string_view word = "not-verified";  ///< "clean", "accepted", "not-proven", "failed".
    /// What the word says; only where there is a verdict.
    verify::Outcome outcome = verify::Outcome::NotProven;
    /// Why there is no verdict: it could not be read, or something broke. Empty: there is one.
    std::string failure;
    verify::Verdict verdict;
    /// For each finding the line it points at, as written; empty where there is none.
    std::vector<std::string> lines;
    bool simulated = false;
    std::string not_simulated;        ///< Why not.
    std::string settings;             ///< The ncsim.toml that told some options; empty: none.
    std::string baseline;             ///< The file of known findings; empty: none.
    std::vector<NoLonger> no_longer;  ///< What is in that and was not found.
    std::string stock;                ///< What it was verified against, in words.
    std::string time;                 ///< How long it takes, in words; empty: it does not move.
    std::uint64_t moves = 0;
    std::optional<DesignFacts> design;  ///< Only where the part was compared with one.
    std::optional<Look> look;           ///< Only where a page was asked for.
};

/// "part.nc (O0101)": the path, and the program if the file has several.
std::string name_of(const Checked& checked);

/// The file a finding is in, relative.
std::string file_of(const Checked& checked, const verify::Place& place);

/// "rapid move through material: removed 12.5 mm3": message and quantity.
std::string headline(const verify::Finding& finding);

}  // namespace ncsim::report
