// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_solids <folder>: writes the solids built by hand as STEP, with the values that
// ncsim_read_step is to find.
#include "ncsim/export/step.h"

#include "brep/solids.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>

int main(int argc, char** argv) {
    if (argc != 2) return EXIT_FAILURE;
    const std::filesystem::path folder = argv[1];
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    for (const auto& solid : ncsim::brep::test::solids()) {
        std::ofstream out(folder / (solid.name + ".step"), std::ios::binary);
        ncsim::exporter::write_step_solid(out, solid.part, {{{}}, solid.name});
        std::ofstream(folder / (solid.name + ".expect"))
            << std::setprecision(17) << "solids 1\nfaces " << solid.faces << "\nvolume "
            << solid.volume << "\n";
        if (!out) return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
