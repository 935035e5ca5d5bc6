// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of pictures.
#include "options/picture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace ncsim::app {

namespace {

void read_size(const std::string& text, PictureOptions& options) {
    const char* first = text.data();
    const char* last = first + text.size();
    const auto width = std::from_chars(first, last, options.width);
    const bool cross =
        width.ec == std::errc{} && width.ptr != last && (*width.ptr == 'x' || *width.ptr == 'X');
    const auto height = cross ? std::from_chars(width.ptr + 1, last, options.height) : width;
    const auto good = [](std::uint32_t side) {
        return side >= 1 && side <= exporter::kMaxImageSide;
    };
    if (!cross || height.ec != std::errc{} || height.ptr != last || !good(options.width) ||
        !good(options.height)) {
        throw Refusal{fmt::format("--size '{}': expected WxH in pixels, 1x1 to {}x{}", text,
                                  exporter::kMaxImageSide, exporter::kMaxImageSide)};
    }
}

exporter::View read_view(const std::string& name) {
    const auto view = exporter::parse_view(name);
    if (!view) {
        throw Refusal{fmt::format(
            "--view '{}': expected iso, top, bottom, front, back, left or right", name)};
    }
    return *view;
}

std::vector<exporter::View> read_views(const std::string& names) {
    std::vector<exporter::View> views;
    for (std::size_t begin = 0; begin <= names.size();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        const auto view = exporter::parse_view(names.substr(begin, end - begin));
        if (!view) {
            throw Refusal{fmt::format(
                "--views '{}': expected names with commas between them, such as iso,top,front",
                names)};
        }
        views.push_back(*view);
        begin = end + 1;
    }
    return views;
}

exporter::Background read_background(const std::string& name) {
    if (name == "white") return exporter::Background::White;
    if (name == "dark") return exporter::Background::Dark;
    throw Refusal{fmt::format("--background '{}': expected white or dark", name)};
}

bool read_shade(const std::string& name) {
    if (name == "recesses") return true;
    if (name == "none") return false;
    throw Refusal{fmt::format("--shade '{}': expected recesses or none", name)};
}

MarkOptions read_marks(const std::string& list) {
    MarkOptions marks;
    if (list == "all") return marks;
    marks = {false, false, false, false};
    if (list == "none") return marks;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string name = list.substr(begin, end - begin);
        if (name == "axes") {
            marks.axes = true;
        } else if (name == "zero") {
            marks.zero = true;
        } else if (name == "scale") {
            marks.scale = true;
        } else if (name == "legend") {
            marks.legend = true;
        } else {
            throw Refusal{
                fmt::format("--marks '{}': expected all, none, axes, zero, scale or legend", name)};
        }
        begin = end + 1;
    }
    return marks;
}

}  // namespace

void require_pictures(const PictureOptions& options, bool has_pictures, const char* outputs) {
    if (has_pictures) return;
    const char* const option = options.cut_view      ? "--cut-view"
                               : options.see_through ? "--see-through"
                                                     : nullptr;
    if (option != nullptr)
        throw Refusal{fmt::format("{} changes pictures: it needs {}", option, outputs)};
}

brep::SectionPlane read_plane(const char* option, const std::string& text) {
    const auto plane = brep::parse_section_plane(text);
    if (!plane) {
        throw Refusal{fmt::format(
            "{} '{}': expected x=, y= or z= and a number of mm within 1 km: z=-4", option, text)};
    }
    return *plane;
}

void add_picture_options(cli::App& command, PictureOptions& o) {
    using Text = const std::string&;
    command
        .add_option_function<std::string>(
            "--view", [&o](Text name) { o.views = {read_view(name)}; },
            "iso, top, bottom, front, back, left, right [iso]")
        ->type_name("VIEW");
    command
        .add_option_function<std::string>(
            "--views", [&o](Text names) { o.views = read_views(names); },
            "Sheet of several views: iso,top,front")
        ->type_name("LIST")
        ->excludes("--view");
    command
        .add_option_function<std::string>(
            "--size", [&o](Text size) { read_size(size, o); },
            "Size of each view, pixels [1280x960]")
        ->type_name("WxH");
    command
        .add_option_function<std::string>(
            "--background", [&o](Text name) { o.background = read_background(name); },
            "white or dark [white]")
        ->type_name("WHAT");
    command
        .add_option_function<std::string>(
            "--marks", [&o](Text list) { o.marks = read_marks(list); },
            "axes, zero, scale, legend; all or none [all]")
        ->type_name("MARKS");
    command
        .add_option_function<std::string>(
            "--shade", [&o](Text name) { o.shades_recesses = read_shade(name); },
            "Darker pockets and holes: recesses, none [recesses]")
        ->type_name("WHAT");
    command.add_flag("--see-through", o.see_through, "Draw the part transparent");
    command
        .add_option_function<std::string>(
            "--cut-view", [&o](Text plane) { o.cut_view = read_plane("--cut-view", plane); },
            "Cut part and fixtures open at x, y or z, mm")
        ->type_name("x=N");
}

}  // namespace ncsim::app
