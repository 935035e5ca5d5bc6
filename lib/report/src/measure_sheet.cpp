// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of a part as text and JSON.
#include "ncsim/report/measure_sheet.h"

#include "ncsim/base/version.h"
#include "ncsim/report/describe.h"

#include "append.h"
#include "json.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <tuple>
#include <utility>

namespace ncsim::report {

namespace {

constexpr std::size_t kMostRows = 40, kMostNumbers = 6;

// Returns a number as on a drawing: a fixed number of decimals, without trailing zeros.
std::string number_text(double value, int decimals = 3) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string list_text(const char* before, const std::vector<std::uint32_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < std::min(numbers.size(), kMostNumbers); ++i)
        append(text, "{}{}", i == 0 ? before : ", ", numbers[i]);
    return numbers.size() > kMostNumbers ? text + ", …" : text;
}

std::string cut_by_text(const CutBy& by) {
    if (by.is_stock()) return "stock";
    std::string text;
    for (const std::uint32_t tool : by.tools)
        append(text, "{}T{}", text.empty() ? "" : " ", tool);
    text += list_text(", line ", by.lines);
    std::map<std::string, std::vector<std::uint32_t>> earlier;
    for (const EarlierLine& at : by.earlier)
        earlier[at.program].push_back(at.line);
    for (const auto& [program, lines] : earlier)
        text += list_text((", " + program + ":").c_str(), lines);
    return text;
}

template <class T>
void sort_once(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

bool is_upright(Vec3 axis) {
    return std::abs(axis.z) > 1.0 - 1e-9;
}

std::string degrees_text(double degrees) {
    return fmt::format("{}°", number_text(std::round(degrees * 100.0) / 100.0));
}

// Returns the lines and tools of all, each once.
CutBy united(const std::vector<CutBy>& all) {
    CutBy by;
    for (const CutBy& one : all) {
        by.lines.insert(by.lines.end(), one.lines.begin(), one.lines.end());
        by.tools.insert(by.tools.end(), one.tools.begin(), one.tools.end());
        by.earlier.insert(by.earlier.end(), one.earlier.begin(), one.earlier.end());
    }
    sort_once(by.lines);
    sort_once(by.tools);
    sort_once(by.earlier);
    return by;
}

class Text {
public:
    Text(const MeasureSheet& sheet, LengthUnit unit) : sheet_(sheet), unit_(unit) {}

    std::string operator()() {
        append(text_, "part       {}; {}\n",
               sheet_.extents.is_empty() ? "nothing is left"
                                         : in_unit(describe(sheet_.extents), unit_),
               in_unit(volume_text(sheet_.volume_mm3), unit_));
        rows("bores", sheet_.bores, [this](const MeasuredBore& b) {
            return std::tuple("D" + length_text(b.diameter),
                              feature_text(b) + "; " + place_text(b.mouth, b.axis), b.by);
        });
        rows("threads", sheet_.threads, [this](const MeasuredThread& t) {
            std::string what = t.is_inside ? "inside" : "outside";
            what += t.pitch ? ", pitch " + length_text(*t.pitch) : std::string(", pitch unknown");
            append(what, ", {} deep; {}", length_text(t.depth), place_text(t.mouth, {0, 0, 1}));
            return std::tuple("D" + length_text(t.diameter), std::move(what), t.by);
        });
        rows("csk", sheet_.countersinks, [this](const MeasuredCountersink& c) {
            std::string what =
                fmt::format("{}, {} deep", degrees_text(c.angle_degrees), length_text(c.depth));
            if (c.has_tip) what += " to the tip";
            if (c.covers_degrees < 360.0) what += ", " + degrees_text(c.covers_degrees) + " of it";
            return std::tuple("D" + length_text(c.diameter),
                              what + "; " + place_text(c.mouth, c.axis), c.by);
        });
        rows("bosses", sheet_.bosses, [this](const MeasuredBoss& b) {
            std::string what = length_text(b.height) + " high";
            if (b.covers_degrees < 360.0) what += ", " + degrees_text(b.covers_degrees) + " of it";
            return std::tuple("D" + length_text(b.diameter),
                              what + "; " + place_text(b.foot, b.axis), b.by);
        });
        floors();
        distances("inside", true);
        distances("outside", false);
        chamfers();
        corners();
        if (sheet_.has_too_many_walls)
            text_ += "distances  not measured: there are too many walls\n";
        if (sheet_.facets > 0) {
            append(text_, "not known  {} facet{} of round tools, {}, not measured{}\n",
                   sheet_.facets, sheet_.facets == 1 ? "" : "s",
                   in_unit(fmt::format("{:.4g} mm2", sheet_.facet_area_mm2), unit_),
                   list_text(": line ", sheet_.facet_lines));
        }
        return std::move(text_);
    }

private:
    // Returns a length with three decimals of a millimetre, or four of an inch.
    std::string length_text(double mm) const {
        return number_text(in_unit(mm, unit_), unit_ == LengthUnit::Inch ? 4 : 3);
    }

    std::string place_text(Vec3 at, Vec3 axis) const {
        if (is_upright(axis)) {
            return fmt::format("X{} Y{}, {} Z{}", length_text(at.x), length_text(at.y),
                               axis.z > 0.0 ? "from" : "from below,", length_text(at.z));
        }
        return fmt::format("X{} Y{} Z{}, axis {} {} {}", length_text(at.x), length_text(at.y),
                           length_text(at.z), number_text(axis.x), number_text(axis.y),
                           number_text(axis.z));
    }

    std::string feature_text(const MeasuredBore& bore) const {
        std::string text = fmt::format("{} deep", length_text(bore.depth));
        if (bore.end == "through") text = "through, " + text;
        if (bore.tip_depth) {
            append(text, ", {} to the tip", length_text(*bore.tip_depth));
            if (bore.tip_angle_degrees)
                append(text, " of {}", degrees_text(*bore.tip_angle_degrees));
            if (bore.end == "ball") text += " of a ball";
        } else if (bore.end == "flat" || bore.end == "rounded") {
            append(text, ", {} bottom", bore.end);
        } else if (bore.end == "shoulder") {
            text += ", to a shoulder";
        }
        if (bore.mouth_slants_by > 0.0)
            append(text, ", its mouth {} lower at one side", length_text(bore.mouth_slants_by));
        if (bore.covers_degrees < 360.0)
            append(text, ", {} of it", degrees_text(bore.covers_degrees));
        return text;
    }

    template <typename Feature, typename Row>
    void rows(const char* title, const std::vector<Feature>& features, const Row& row) {
        for (std::size_t i = 0; i < std::min(features.size(), kMostRows); ++i) {
            const auto& [size, what, by] = row(features[i]);
            append(text_, "{:<10} {:<9} {}; {}\n", i == 0 ? title : "", size, what,
                   cut_by_text(by));
        }
        if (features.size() > kMostRows)
            append(text_, "{:<10} and {} more (--json)\n", "", features.size() - kMostRows);
    }

    // Appends the floors. The rest of the top of the stock often has many pieces, so floors of the
    // stock at the same height share a row.
    void floors() {
        struct Floors {
            MeasuredFloor first;
            std::size_t count = 0;
        };
        std::vector<Floors> all;
        for (const MeasuredFloor& floor : sheet_.floors) {
            auto same = std::ranges::find_if(all, [&](const Floors& f) {
                return floor.by.is_stock() && f.first.by.is_stock() && f.first.z == floor.z;
            });
            if (same == all.end()) {
                all.push_back({floor, 1});
                continue;
            }
            ++same->count;
            same->first.area += floor.area;
        }
        rows("floors", all, [&](const Floors& floors) {
            const MeasuredFloor& f = floors.first;
            const Vec3 size = f.box.size();
            const std::string how = floors.count > 1
                                        ? fmt::format("{} of them", floors.count)
                                        : length_text(size.x) + " x " + length_text(size.y);
            return std::tuple("Z" + length_text(f.z),
                              fmt::format("{} below the top, {} above the bottom; {}, {}{}",
                                          length_text(sheet_.extents.max.z - f.z),
                                          length_text(f.z - sheet_.extents.min.z), how,
                                          in_unit(fmt::format("{:.6g} mm2", f.area), unit_),
                                          f.is_closed ? ", walls all round" : ""),
                              f.by);
        });
    }

    void distances(const char* title, bool is_void) {
        std::vector<MeasuredDistance> of;
        std::ranges::copy_if(sheet_.distances, std::back_inserter(of),
                             [&](const MeasuredDistance& d) { return d.is_void == is_void; });
        rows(title, of, [this](const MeasuredDistance& d) {
            const Vec3 v = normalized(d.to - d.from);
            const Vec3 at = 0.5 * (d.from + d.to);
            std::string what =
                fmt::format("along {} {} {}", number_text(v.x), number_text(v.y), number_text(v.z));
            constexpr double kAlong = 1.0 - 1e-9;
            for (int axis = 0; axis < 3; ++axis) {
                if (std::abs(v[axis]) > kAlong) what = fmt::format("along {}", "XYZ"[axis]);
            }
            what += fmt::format("; at X{} Y{} Z{}", length_text(at.x), length_text(at.y),
                                length_text(at.z));
            return std::tuple(length_text(d.mm), std::move(what), d.by);
        });
    }

    // Appends the chamfers. Equal chamfers share a row, because an outline has many.
    void chamfers() {
        std::vector<std::pair<std::string, std::vector<CutBy>>> equal;
        for (const MeasuredChamfer& c : sheet_.chamfers) {
            const std::string width = length_text(c.width), height = length_text(c.height);
            const std::string size =
                fmt::format("{}{} x {}", width, width == height ? "" : " x " + height,
                            degrees_text(c.angle_degrees));
            auto found = std::ranges::find(equal, size, [](const auto& e) { return e.first; });
            if (found == equal.end()) found = equal.insert(equal.end(), {size, {}});
            found->second.push_back(c.by);
        }
        rows("chamfers", equal, [](const auto& entry) {
            const std::string what = fmt::format("{} of them", entry.second.size());
            return std::tuple(entry.first, what, united(entry.second));
        });
    }

    // Appends the corners. Equal corners share a row, because a pocket has four.
    void corners() {
        std::map<std::pair<std::string, bool>, std::vector<CutBy>> equal;
        for (const MeasuredCorner& c : sheet_.corners)
            equal[{length_text(c.radius), c.is_inside}].push_back(c.by);
        const std::vector list(equal.begin(), equal.end());
        rows("corners", list, [](const auto& entry) {
            const auto& [key, all] = entry;
            return std::tuple(
                "R" + key.first,
                fmt::format("{}, {} of them", key.second ? "inside" : "outside", all.size()),
                united(all));
        });
    }

    const MeasureSheet& sheet_;
    LengthUnit unit_;
    std::string text_;
};

// --- JSON ---------------------------------------------------------------------------------

Json with(Json json, const CutBy& by) {
    json["lines"] = by.lines;
    json["tools"] = by.tools;
    for (const EarlierLine& at : by.earlier)
        json["earlier"].push_back({{"program", at.program}, {"line", at.line}});
    return json;
}

Json to_json(const MeasuredBore& b) {
    Json json{{"diameter_mm", round_value(b.diameter)},
              {"depth_mm", round_value(b.depth)},
              {"end", b.end},
              {"through", b.end == "through"},
              {"mouth", vector_json(b.mouth)},
              {"axis", vector_json(b.axis)},
              {"mouth_slants_by_mm", round_value(b.mouth_slants_by)},
              {"covers_degrees", round_value(b.covers_degrees)}};
    if (b.tip_depth) json["tip_depth_mm"] = round_value(*b.tip_depth);
    if (b.tip_angle_degrees) json["tip_angle_degrees"] = round_value(*b.tip_angle_degrees);
    return with(std::move(json), b.by);
}

Json to_json(const MeasuredThread& t) {
    Json json{{"diameter_mm", round_value(t.diameter)},
              {"pitch_mm", rounded_json(t.pitch)},
              {"depth_mm", round_value(t.depth)},
              {"inside", t.is_inside},
              {"mouth", vector_json(t.mouth)}};
    return with(std::move(json), t.by);
}

Json to_json(const MeasuredCountersink& c) {
    Json json{{"diameter_mm", round_value(c.diameter)},
              {"depth_mm", round_value(c.depth)},
              {"angle_degrees", round_value(c.angle_degrees)},
              {"tip", c.has_tip},
              {"mouth", vector_json(c.mouth)},
              {"axis", vector_json(c.axis)},
              {"covers_degrees", round_value(c.covers_degrees)}};
    return with(std::move(json), c.by);
}

Json to_json(const MeasuredChamfer& c) {
    Json json{{"width_mm", round_value(c.width)},
              {"height_mm", round_value(c.height)},
              {"angle_degrees", round_value(c.angle_degrees)},
              {"length_mm", round_value(c.length)},
              {"at", vector_json(c.at)}};
    return with(std::move(json), c.by);
}

Json to_json(const MeasuredBoss& b) {
    Json json{{"diameter_mm", round_value(b.diameter)},
              {"height_mm", round_value(b.height)},
              {"foot", vector_json(b.foot)},
              {"axis", vector_json(b.axis)},
              {"covers_degrees", round_value(b.covers_degrees)}};
    return with(std::move(json), b.by);
}

Json to_json(const MeasuredCorner& c) {
    Json json{{"radius_mm", round_value(c.radius)},
              {"inside", c.is_inside},
              {"covers_degrees", round_value(c.covers_degrees)},
              {"centre", vector_json(c.on_axis)},
              {"axis", vector_json(c.axis)}};
    return with(std::move(json), c.by);
}

Json to_json(const MeasuredDistance& d) {
    Json json{{"mm", round_value(d.mm)},
              {"between", d.is_void ? "void" : "material"},
              {"from", vector_json(d.from)},
              {"to", vector_json(d.to)}};
    return with(std::move(json), d.by);
}

Json to_json(const MeasuredFloor& f, const Box& extents) {
    Json json{{"z", round_value(f.z)},
              {"below_top_mm", round_value(extents.max.z - f.z)},
              {"above_bottom_mm", round_value(f.z - extents.min.z)},
              {"area_mm2", round_value(f.area)},
              {"walls_all_round", f.is_closed},
              {"min", vector_json(f.box.min)},
              {"max", vector_json(f.box.max)}};
    return with(std::move(json), f.by);
}

template <typename Feature, typename... More>
Json list_json(const std::vector<Feature>& features, const More&... more) {
    Json list = Json::array();
    for (const Feature& feature : features)
        list.push_back(to_json(feature, more...));
    return list;
}

}  // namespace

std::string text_of(const MeasureSheet& sheet, LengthUnit unit) {
    return Text(sheet, unit)();
}

void write_measures(std::ostream& out, const MeasureSheet& sheet) {
    Json json{{"ncsim", kVersion},
              {"program", sheet.program},
              {"volume_mm3", round_value(sheet.volume_mm3)}};
    json["extents"] = box_json(sheet.extents);
    json["bores"] = list_json(sheet.bores);
    json["threads"] = list_json(sheet.threads);
    json["countersinks"] = list_json(sheet.countersinks);
    json["bosses"] = list_json(sheet.bosses);
    json["chamfers"] = list_json(sheet.chamfers);
    json["floors"] = list_json(sheet.floors, sheet.extents);
    json["distances"] = list_json(sheet.distances);
    if (sheet.has_too_many_walls) json["distances"] = nullptr;
    json["corners"] = list_json(sheet.corners);
    json["not_measured"] = {{"facets", sheet.facets},
                            {"area_mm2", round_value(sheet.facet_area_mm2)},
                            {"lines", sheet.facet_lines}};
    out << to_text(json);
}

}  // namespace ncsim::report
