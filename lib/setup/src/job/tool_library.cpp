// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unpacks tool libraries of Fusion. Reads libraries of FreeCAD and HSMWorks as libraries of Fusion,
// because all three have the same values.
#include "ncsim/setup/tool_library.h"

#include "ncsim/base/ascii.h"
#include "ncsim/base/file_names.h"
#include "ncsim/base/plain_text.h"

#include "job/setup_messages.h"
#include "machines/xml_root.h"

#include <fmt/format.h>
#include <iconv.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace ncsim::setup {

namespace {

using Json = nlohmann::json;

std::string text_of(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// --- FreeCAD ---

// Returns a value in mm or degrees, from text like "5.0000 mm", "0.25 in", "60 °", or from a
// number.
std::optional<double> value_of(const Json& parameters, const char* key) {
    const auto found = parameters.find(key);
    if (found == parameters.end()) return std::nullopt;
    if (found->is_number()) return found->get<double>();
    if (!found->is_string()) return std::nullopt;
    const auto& text = found->get_ref<const std::string&>();
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc()) return std::nullopt;
    std::string_view unit(read.ptr, static_cast<std::size_t>(end - read.ptr));
    while (!unit.empty() && unit.front() == ' ')
        unit.remove_prefix(1);
    static constexpr std::pair<std::string_view, double> kUnits[] = {
        {"", 1.0},    {"mm", 1.0},  {"cm", 10.0},  {"m", 1000.0},     {"um", 1e-3},
        {"in", 25.4}, {"\"", 25.4}, {"ft", 304.8}, {"\xc2\xb0", 1.0}, {"deg", 1.0}};
    for (const auto& [name, factor] : kUnits) {
        if (unit == name) return factor * value;
    }
    return std::nullopt;
}

// Types of Fusion for the shapes of FreeCAD; empty for a shape that is not read.
std::string type_of_shape(const std::string& shape) {
    static constexpr std::pair<std::string_view, std::string_view> kTypes[] = {
        {"endmill", "flat end mill"},
        {"ballend", "ball end mill"},
        {"bullnose", "bull nose end mill"},
        {"torus", "bull nose end mill"},
        {"v-bit", "engrave"},
        {"vbit", "engrave"},
        {"engraver", "engrave"},
        {"chamfer", "chamfer mill"},
        {"drill", "drill"},
        {"reamer", "reamer"},
        {"tap", "tap right hand"},
        {"thread-mill", "thread mill"},
        {"threadmill", "thread mill"},
        {"slittingsaw", "slot mill"},
        {"probe", "probe"}};
    for (const auto& [name, type] : kTypes) {
        if (shape == name) return std::string(type);
    }
    return {};
}

// Returns a tool bit as a tool of Fusion; null for a shape that is not read.
Json tool_of_bit(const Json& bit, const Json& number) {
    const std::string shape =
        lowercase(std::filesystem::path(text_of(bit, "shape")).stem().string());
    const std::string type = type_of_shape(shape);
    const auto parameters = bit.find("parameter");
    if (type.empty() || parameters == bit.end() || !parameters->is_object()) return nullptr;
    Json geometry = Json::object();
    const auto take = [&](const char* key, std::initializer_list<const char*> names) {
        for (const char* name : names) {
            if (const auto value = value_of(*parameters, name)) geometry[key] = *value;
        }
    };
    const bool is_cone = type == "engrave" || type == "chamfer mill";
    take("DC", {"Diameter"});
    take("SFDM", {"ShankDiameter"});
    take("TP", {"Pitch"});
    if (is_cone) {
        // The height is that of the cylinder above the cone.
        take("SIG", {"CuttingEdgeAngle"});
        take("tip-diameter", {"TipDiameter"});
    } else {
        take("SIG", {"TipAngle"});
        take("LCF", {"CuttingEdgeHeight", "CuttingEdgeLength", "BladeThickness"});
    }
    // Versions before 1.1 have the radius of the flat part.
    const auto flat = value_of(*parameters, "FlatRadius"),
               diameter = value_of(*parameters, "Diameter");
    if (type == "bull nose end mill" && flat && diameter) geometry["RE"] = *diameter / 2 - *flat;
    take("RE", {"CornerRadius"});
    return {{"type", type},
            {"description", text_of(bit, "name")},
            {"unit", "millimeters"},
            {"post-process", {{"number", number}}},
            {"geometry", std::move(geometry)}};
}

// Returns the path of a tool bit; empty if the file does not exist.
std::string path_of_bit(const std::string& folder, const std::string& name, InputSet& inputs) {
    namespace fs = std::filesystem;
    const std::string file = fs::path(name).filename().string();
    const std::string places[] = {name, (fs::path("..") / "Bit" / file).generic_string(),
                                  (fs::path("Bit") / file).generic_string()};
    for (const std::string& place : places) {
        std::string path = seen_in(folder, place);
        if (inputs.is_there(path)) return path;
    }
    return {};
}

Json parsed(const std::string& path, const std::string& bytes) {
    try {
        return Json::parse(bytes);
    } catch (const Json::exception&) {
        throw std::runtime_error(
            fmt::format("{}: this is no JSON that can be read", name_of_input(path)));
    }
}

// Reads the bits of a library as tools of Fusion.
Json tools_of_freecad(const Json& library, const std::string& path, InputSet& inputs,
                      gcode::Diagnostics& diagnostics) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    Json tools = Json::array();
    constexpr std::size_t kMostTools = 10'000;
    for (const Json& entry : library["tools"]) {
        const auto number = entry.find("nr");
        if (!entry.is_object() || number == entry.end() || !number->is_number_integer()) continue;
        if (tools.size() == kMostTools) break;
        const auto warn = [&](const gcode::MessageText& message, const std::string& what) {
            gcode::Diagnostic d =
                gcode::diagnostic_of(message, {}, {number->dump(), one_line(what)});
            d.file = base_name(path);
            diagnostics.push_back(std::move(d));
        };
        const std::string name = text_of(entry, "path");
        const std::string file = path_of_bit(folder, name, inputs);
        if (file.empty()) {
            warn(Message::BitMissing, name);
            continue;
        }
        const Json bit = parsed(file, inputs.read(file, kMostSetUpBytes));
        Json tool = bit.is_object() ? tool_of_bit(bit, *number) : Json();
        if (tool.is_null()) {
            warn(Message::BitShapeUnknown, text_of(bit, "shape"));
        } else {
            tools.push_back(std::move(tool));
        }
    }
    return tools;
}

// --- HSMWorks ---

// Returns XML as UTF-8; UTF-16 needs a byte order mark.
std::string as_utf8(const std::string& path, std::string bytes) {
    if (!bytes.starts_with("\xff\xfe") && !bytes.starts_with("\xfe\xff")) return bytes;
    const iconv_t converter = ::iconv_open("UTF-8", "UTF-16");
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the value by which POSIX reports an error
    if (converter == reinterpret_cast<iconv_t>(-1))
        throw std::runtime_error(
            fmt::format("{}: UTF-16 cannot be read here", name_of_input(path)));
    std::string text(2 * bytes.size(), '\0');
    char* from = bytes.data();
    char* to = text.data();
    std::size_t from_left = bytes.size(), to_left = text.size();
    const std::size_t result = ::iconv(converter, &from, &from_left, &to, &to_left);
    ::iconv_close(converter);
    if (result == static_cast<std::size_t>(-1))
        throw std::runtime_error(fmt::format("{}: this is no UTF-16", name_of_input(path)));
    text.resize(text.size() - to_left);
    return text;
}

// Returns the holder of a tool in the format of Fusion. Each section ends with `diameter` after
// `length`; a section without length is a step.
Json holder_of_hsm(const tinyxml2::XMLElement& tool) {
    Json segments = Json::array();
    const auto* holder = tool.FirstChildElement("holder");
    std::optional<double> below;
    for (const auto* section = holder ? holder->FirstChildElement("section") : nullptr; section;
         section = section->NextSiblingElement("section")) {
        const double diameter = section->DoubleAttribute("diameter");
        const double length = section->DoubleAttribute("length");
        if (length > 0) {
            segments.push_back({{"height", length},
                                {"lower-diameter", below.value_or(diameter)},
                                {"upper-diameter", diameter}});
        }
        below = diameter;
    }
    return {{"segments", std::move(segments)}};
}

// Reads <tool type="flat end mill" unit="inches"><nc number="5"/><body diameter="0.25"/></tool>.
Json tools_of_hsm(const std::string& path, const std::string& text) {
    tinyxml2::XMLDocument document;
    const bool is_table = text.find("<tool-table") != std::string::npos;
    const tinyxml2::XMLElement* root =
        xml_root(document, text, name_of_input(path), is_table ? "tool-table" : "tool-library",
                 ", a library of HSMWorks");
    static constexpr std::pair<const char*, const char*> kValues[] = {
        {"diameter", "DC"},         {"flute-length", "LCF"},
        {"corner-radius", "RE"},    {"taper-angle", "TA"},
        {"tip-angle", "SIG"},       {"tip-diameter", "tip-diameter"},
        {"shaft-diameter", "SFDM"}, {"shoulder-length", "shoulder-length"},
        {"body-length", "LB"},      {"thread-pitch", "TP"}};
    Json tools = Json::array();
    for (const auto* tool = root->FirstChildElement("tool"); tool;
         tool = tool->NextSiblingElement("tool")) {
        const auto* nc = tool->FirstChildElement("nc");
        const auto* body = tool->FirstChildElement("body");
        if (!nc || !body) continue;
        Json geometry = Json::object();
        for (const auto& [attribute, key] : kValues) {
            double value = 0.0;
            if (body->QueryDoubleAttribute(attribute, &value) == tinyxml2::XML_SUCCESS)
                geometry[key] = value;
        }
        const char* const type = tool->Attribute("type");
        // "taper-angle" is the included angle for drills, and the angle of one side for chamfer
        // mills.
        if (type && std::string_view(type).ends_with("drill") && !geometry.contains("SIG") &&
            geometry.contains("TA"))
            geometry["SIG"] = geometry["TA"];
        const auto* description = tool->FirstChildElement("description");
        const char* const words = description ? description->GetText() : nullptr;
        const char* const unit = tool->Attribute("unit");
        tools.push_back({{"type", type ? type : ""},
                         {"description", words ? words : ""},
                         {"unit", unit && std::string_view(unit) == "inches" ? "inches" : "mm"},
                         {"post-process", {{"number", nc->IntAttribute("number")}}},
                         {"geometry", std::move(geometry)},
                         {"holder", holder_of_hsm(*tool)}});
    }
    return tools;
}

// --- Fusion ---

// Returns the JSON file of a library .tools, which is a ZIP archive.
std::string unpacked(const std::string& path, const std::string& bytes) {
    const auto fail = [&](const char* what) {
        throw std::runtime_error(fmt::format("{}: {}", name_of_input(path), what));
    };
    zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr);
    zip_t* const opened = zip_open_from_source(source, ZIP_RDONLY, nullptr);
    if (!opened) {
        zip_source_free(source);
        fail("this is no ZIP archive that can be read");
    }
    const std::unique_ptr<zip_t, void (*)(zip_t*)> archive(opened, zip_discard);
    for (zip_int64_t i = 0; i < zip_get_num_entries(archive.get(), 0); ++i) {
        const auto index = static_cast<zip_uint64_t>(i);
        const char* const name = zip_get_name(archive.get(), index, 0);
        if (!name || !lowercase(name).ends_with(".json")) continue;
        const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
            zip_fopen_index(archive.get(), index, 0), zip_fclose);
        if (!file) fail("its JSON file cannot be read");
        std::string text;
        std::array<char, 65536> part{};
        for (zip_int64_t read = 1; read > 0;) {
            read = zip_fread(file.get(), part.data(), part.size());
            if (read < 0) fail("its JSON file cannot be read");
            text.append(part.data(), static_cast<std::size_t>(read));
            if (text.size() > kMostSetUpBytes) fail("its JSON file is larger than 64 MB");
        }
        return text;
    }
    fail("the archive has no JSON file");
    return {};
}

// Reads tools of Fusion. An empty list is no error.
toolpath::ToolFile read_as_fusion(const std::string& path, const Json& tools, const char* format) {
    toolpath::ToolFile file;
    if (!tools.empty())
        file = toolpath::read_tool_file(
            {base_name(name_of_input(path)),
             tools.dump(-1, ' ', false, Json::error_handler_t::replace)});  // broken UTF-8
    file.format = format;
    return file;
}

bool is_freecad_library(const Json& json) {
    const auto tools = json.is_object() ? json.find("tools") : json.end();
    return tools != json.end() && tools->is_array() &&
           std::ranges::all_of(*tools,
                               [](const Json& t) { return t.is_object() && t.contains("nr"); });
}

}  // namespace

toolpath::ToolFile read_tool_library(const std::string& path, InputSet& inputs,
                                     bool machine_inches) {
    std::string bytes = inputs.read(path, kMostSetUpBytes);
    const bool is_bit = lowercase(path).ends_with(".fctb");
    if (is_bit) {
        throw std::runtime_error(fmt::format(
            "{}: a tool bit of FreeCAD has no number; expected its library, .fctl", path));
    }
    if (lowercase(path).ends_with(".fctl")) {
        const Json library = parsed(path, bytes);
        if (!is_freecad_library(library)) {
            throw std::runtime_error(
                fmt::format("{}: expected a list 'tools' with 'nr' and 'path'", path));
        }
        gcode::Diagnostics diagnostics;
        const Json tools = tools_of_freecad(library, path, inputs, diagnostics);
        toolpath::ToolFile file = read_as_fusion(path, tools, "FreeCAD tool library");
        std::ranges::move(diagnostics, std::back_inserter(file.diagnostics));
        return file;
    }
    if (bytes.starts_with("PK\x03\x04")) {
        return toolpath::read_tool_file({base_name(name_of_input(path)), unpacked(path, bytes)});
    }
    const std::string text = as_utf8(path, std::move(bytes));
    const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    if (first != std::string::npos && text[first] == '<')
        return read_as_fusion(path, tools_of_hsm(path, text), "HSMWorks tool library");
    return toolpath::read_tool_file({base_name(name_of_input(path)), text}, machine_inches);
}

}  // namespace ncsim::setup
