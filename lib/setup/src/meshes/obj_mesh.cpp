// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads OBJ files.
#include "meshes/obj_mesh.h"

#include "ncsim/base/number_text.h"

#include "meshes/polygons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace ncsim::setup {

namespace {

constexpr std::string_view kObjBlanks = " \t\r";

// Returns the next word of a line; empty at the end.
std::string_view next_word(std::string_view& line) {
    const std::size_t begin = line.find_first_not_of(kObjBlanks);
    if (begin == std::string_view::npos) {
        line = {};
        return {};
    }
    const std::size_t end = std::min(line.find_first_of(kObjBlanks, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line.substr(0, line.find('#'));
}

template <class Number>
std::optional<Number> signed_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    return number_in<Number>(word);
}

}  // namespace

bool is_obj(std::string_view bytes) {
    constexpr std::array<std::string_view, 9> kFirst{"v", "vn", "vt",     "f",     "o",
                                                     "g", "s",  "mtllib", "usemtl"};
    while (!bytes.empty()) {
        std::string_view line = next_line(bytes);
        const std::string_view word = next_word(line);
        if (!word.empty()) return std::ranges::find(kFirst, word) != kFirst.end();
    }
    return false;
}

std::vector<Vec3> read_obj(std::string_view bytes) {
    Polygons polygons;
    std::size_t number = 0;
    const auto refuse = [&number](const char* what) {
        throw Refused{fmt::format("line {}: {}", number, what)};
    };
    while (!bytes.empty()) {
        ++number;
        std::string_view line = next_line(bytes);
        const std::string_view key = next_word(line);
        if (key == "v") {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis) {
                const auto value = signed_number<double>(next_word(line));
                if (!value) refuse("a point has three numbers");
                p[axis] = *value;
            }
            polygons.points.push_back(p);
        } else if (key == "f") {
            std::vector<std::uint32_t> face;
            for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
                const auto specified = signed_number<std::int64_t>(word.substr(0, word.find('/')));
                const auto count = static_cast<std::int64_t>(polygons.points.size());
                // Numbers count from 1, or backwards from the last point, which is -1.
                if (!specified || *specified == 0 || *specified > count || *specified < -count)
                    refuse("a face names a point that does not stand before it");
                face.push_back(static_cast<std::uint32_t>(*specified > 0 ? *specified - 1
                                                                         : count + *specified));
            }
            if (face.size() < 3) refuse("a face has three corners or more");
            polygons.faces.push_back(std::move(face));
        } else if (key == "curv" || key == "surf" || key == "cstype") {
            refuse("curves and curved surfaces are not read");
        }
    }
    return corners_of(polygons);
}

}  // namespace ncsim::setup
