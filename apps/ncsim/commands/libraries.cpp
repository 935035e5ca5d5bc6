// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks the libraries for their versions.
#include "commands/libraries.h"

#include "ncsim/base/version.h"

#include "options/cli.h"

#include <CGAL/version.h>
#include <fmt/format.h>
#include <gif_lib.h>
#include <gmp.h>
#include <libqhull_r/libqhull_r.h>
#include <mpfr.h>
#include <nettle/version.h>
#include <png.h>
#include <tinyxml2.h>
#include <toml++/impl/version.h>
#include <zip.h>
#include <zlib.h>

#include <nlohmann/detail/abi_macros.hpp>

namespace ncsim::app {

namespace {

std::string dotted(int major, int minor, int patch) {
    return fmt::format("{}.{}.{}", major, minor, patch);
}

// Returns the number of "2020.2.r 2020/08/31".
std::string qhull_number() {
    const std::string text = qh_version;
    return text.substr(0, text.find(".r"));
}

}  // namespace

std::vector<Library> libraries() {
    return {
        {"CGAL", CGAL_VERSION_STR, "GPL-3.0-or-later, LGPL-3.0-or-later", "sections, solids"},
        {"Qhull", qhull_number(), "Qhull", "convex hulls"},
        {"GMP", gmp_version, "LGPL-3.0-or-later or GPL-2.0-or-later", "numbers of CGAL"},
        {"MPFR", mpfr_get_version(), "LGPL-3.0-or-later", "numbers of CGAL"},
        {"tinygltf", NCSIM_TINYGLTF_VERSION, "MIT", "glTF"},
        {"CLI11", cli::library_version(), "BSD-3-Clause", "command line"},
        {"fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100), "MIT",
         "texts"},
        {"nlohmann-json",
         dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                NLOHMANN_JSON_VERSION_PATCH),
         "MIT", "JSON"},
        {"toml++", dotted(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH), "MIT", "TOML"},
        {"tinyxml2", dotted(TIXML2_MAJOR_VERSION, TIXML2_MINOR_VERSION, TIXML2_PATCH_VERSION),
         "Zlib", "XML"},
        {"nettle", fmt::format("{}.{}", nettle_version_major(), nettle_version_minor()),
         "LGPL-3.0-or-later or GPL-2.0-or-later", "digests, base64"},
        {"libzip", zip_libzip_version(), "BSD-3-Clause", "libraries of tools"},
        {"zlib", zlibVersion(), "Zlib", "PNG, 3MF, pages"},
        {"libpng", png_get_libpng_ver(nullptr), "libpng", "PNG"},
        {"giflib", dotted(GIFLIB_MAJOR, GIFLIB_MINOR, GIFLIB_RELEASE), "MIT", "GIF"},
        {"OSMesa", NCSIM_OSMESA_VERSION, "MIT", "--renderer osmesa; loaded on request"},
    };
}

std::string version_text() {
    std::string text = fmt::format(
        "ncsim {}\n"
        "licence  GPL-3.0-or-later: free software, without warranty\n"
        "STEP     read by ncsim-step, a program of its own with OpenCASCADE (LGPL-2.1 with "
        "exception)\n"
        "\n",
        kVersion);
    for (const Library& one : libraries())
        text +=
            fmt::format("  {:<14} {:<8} {:<38} {}\n", one.name, one.version, one.licence, one.use);
    return text;
}

}  // namespace ncsim::app
