// SPDX-License-Identifier: GPL-3.0-or-later
//
// List of the files of a surface.
#include "ncsim/report/mesh_list.h"

#include "ncsim/base/version.h"

#include "json.h"

#include <ostream>

namespace ncsim::report {

namespace {

constexpr int kMeshListFormat = 1;

}  // namespace

void write_mesh_list(std::ostream& out, const std::string& program, Vec3 centre,
                     const std::vector<MeshFile>& files) {
    out << "{\"ncsim-meshes\": " << kMeshListFormat << ", \"version\": " << to_line(Json(kVersion))
        << ", \"program\": " << to_line(Json(program))
        << ", \"unit\": \"mm\", \"centre\": " << to_line(vector_json(centre)) << ", \"files\": [";
    const char* comma = "";
    for (const MeshFile& file : files) {
        const Json json{{"file", file.file},
                        {"sha256", file.sha256},
                        {"box", box_json(file.box)},
                        {"faces", file.faces},
                        {"open_edges", file.open_edges}};
        out << comma << '\n' << to_line(json);
        comma = ",";
    }
    out << "\n]}\n";
}

}  // namespace ncsim::report
