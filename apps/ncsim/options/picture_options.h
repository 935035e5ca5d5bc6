// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of commands that draw pictures of a part.
#pragma once

#include "ncsim/brep/section.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/render_options.h"

#include "options/option_row.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ncsim::app {

/// Marks of pictures, see exporter::Marks.
struct MarkOptions {
    bool axes = true, zero = true, scale = true, legend = true;

    bool any() const { return axes || zero || scale || legend; }
};

/// View, size and marks of pictures.
struct PictureOptions {
    /// Views of the picture; several views form a sheet with a caption. Never empty.
    std::vector<exporter::View> views{exporter::View::Iso};
    std::uint32_t width = 1280, height = 960;  ///< Size of each view in pixels.
    exporter::Background background = exporter::Background::White;
    MarkOptions marks;
    bool shades_recesses = true;  ///< Recesses of the part are darker.
    bool see_through = false;     ///< The part is transparent.
    /// Plane at which pictures show the part and the fixtures cut open.
    std::optional<brep::SectionPlane> cut_view;
};

/// Limits of --design-tol.
inline constexpr cli::Limits kDesignTolerances{1e-4, 1e4};

/// Rows of the options of pictures.
std::span<const OptionRow<PictureOptions>> picture_options();

/// Reads the name of a view. `option` is the option of the message.
/// Throws: Refusal.
exporter::View view_named(const char* option, const std::string& name);

/// Throws: Refusal if an option changes pictures that are not written. `outputs`: the options that
///     write pictures.
void require_pictures(const PictureOptions& options, bool has_pictures, const char* outputs);

/// Reads a plane such as "z=-4". `option` is the option of the message.
/// Throws: Refusal.
brep::SectionPlane read_plane(const char* option, const std::string& text);

}  // namespace ncsim::app
