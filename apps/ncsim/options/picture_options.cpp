// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of pictures.
#include "options/picture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>

namespace ncsim::app {

namespace {

using PictureArgs = PictureOptions;

void read_size(const char* option, const std::string& text, PictureOptions& o) {
    const char* first = text.data();
    const char* last = first + text.size();
    const auto width = std::from_chars(first, last, o.width);
    const bool cross =
        width.ec == std::errc{} && width.ptr != last && (*width.ptr == 'x' || *width.ptr == 'X');
    const auto height = cross ? std::from_chars(width.ptr + 1, last, o.height) : width;
    const auto good = [](std::uint32_t side) {
        return side >= 1 && side <= exporter::kMaxImageSide;
    };
    if (!cross || height.ec != std::errc{} || height.ptr != last || !good(o.width) ||
        !good(o.height)) {
        throw Refusal{fmt::format("{} '{}': expected WxH in pixels, 1x1 to {}x{}", option, text,
                                  exporter::kMaxImageSide, exporter::kMaxImageSide)};
    }
}

// Calls `take` for each word between commas; empty words, too.
template <class Take>
void each_word(const std::string& list, const Take& take) {
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        take(list.substr(begin, end - begin));
        begin = end + 1;
    }
}

std::vector<exporter::View> read_view(const char* option, const std::string& name) {
    return {view_named(option, name)};
}

std::vector<exporter::View> read_views(const char* option, const std::string& names) {
    std::vector<exporter::View> views;
    each_word(names, [&](const std::string& name) {
        const auto view = exporter::parse_view(name);
        if (!view)
            throw Refusal{fmt::format(
                "{} '{}': expected names with commas between them, such as iso,top,front", option,
                names)};
        views.push_back(*view);
    });
    return views;
}

constexpr Choice<exporter::Background> kBackgrounds[] = {{"white", exporter::Background::White},
                                                         {"dark", exporter::Background::Dark}};

constexpr Choice<bool> kShades[] = {{"recesses", true}, {"none", false}};

MarkOptions read_marks(const char* option, const std::string& list) {
    MarkOptions marks;
    if (list == "all") return marks;
    marks = {false, false, false, false};
    if (list == "none") return marks;
    constexpr Choice<bool MarkOptions::*> kMarks[] = {{"axes", &MarkOptions::axes},
                                                      {"zero", &MarkOptions::zero},
                                                      {"scale", &MarkOptions::scale},
                                                      {"legend", &MarkOptions::legend}};
    each_word(list, [&](const std::string& name) {
        const auto* const mark =
            std::ranges::find(kMarks, name, [](const auto& m) { return m.word; });
        if (mark == std::end(kMarks))
            throw Refusal{fmt::format("{} '{}': expected all, none, axes, zero, scale or legend",
                                      option, list)};
        marks.*mark->value = true;
    });
    return marks;
}

constexpr OptionRow<PictureArgs> kPictureRows[] = {
    {"--view", "VIEW", kOfTiles, "iso, top, bottom, front, back, left, right [iso]",
     read<&PictureArgs::views, read_view>},
    {"--views", "LIST", kLook, "Sheet of several views: iso,top,front",
     read<&PictureArgs::views, read_views>, without("--view")},
    {"--size", "WxH", kLook, "Size of each view, pixels [1280x960]", act<read_size>},
    {"--background", "WHAT", kLook, "white or dark [white]",
     choose<&PictureArgs::background, kBackgrounds>},
    {"--marks", "MARKS", kLook, "axes, zero, scale, legend; all or none [all]",
     read<&PictureArgs::marks, read_marks>},
    {"--shade", "WHAT", kLook, "Darker pockets and holes: recesses, none [recesses]",
     choose<&PictureArgs::shades_recesses, kShades>},
    {"--see-through", "", kLook, "Draw the part transparent", store<&PictureArgs::see_through>},
    {"--cut-view", "x=N", kLook, "Cut part and fixtures open at x, y or z, mm",
     read<&PictureArgs::cut_view, read_plane>}};

}  // namespace

void require_pictures(const PictureOptions& options, bool has_pictures, const char* outputs) {
    if (has_pictures) return;
    const char* const option = options.cut_view      ? "--cut-view"
                               : options.see_through ? "--see-through"
                                                     : nullptr;
    if (option != nullptr)
        throw Refusal{fmt::format("{} changes pictures: it needs {}", option, outputs)};
}

exporter::View view_named(const char* option, const std::string& name) {
    const auto view = exporter::parse_view(name);
    if (view) return *view;
    throw Refusal{fmt::format("{} '{}': expected iso, top, bottom, front, back, left or right",
                              option, name)};
}

brep::SectionPlane read_plane(const char* option, const std::string& text) {
    const auto plane = brep::parse_section_plane(text);
    if (!plane) {
        throw Refusal{fmt::format(
            "{} '{}': expected x=, y= or z= and a number of mm within 1 km: z=-4", option, text)};
    }
    return *plane;
}

std::span<const OptionRow<PictureOptions>> picture_options() {
    return kPictureRows;
}

}  // namespace ncsim::app
