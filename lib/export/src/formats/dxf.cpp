// SPDX-License-Identifier: GPL-3.0-or-later
//
// A DXF file is a list of groups of two lines: a code for the kind of value, and the value. The
// version is AutoCAD R12, the last that needs neither handles nor classes.
#include "formats/drawing_parts.h"

#include <cstdint>
#include <initializer_list>
#include <ostream>
#include <set>
#include <stdexcept>
#include <utility>

namespace ncsim::exporter {

namespace {

// AutoCAD colour numbers: black or white for stock and notes, and grey for facets.
constexpr int kPlain = 7, kGrey = 8;

// Returns `utf8` in ASCII: another character becomes \U+ with four hexadecimal digits, or ? if it
// needs more digits. Readers interpret DXF text in their own code page.
// Requires: `utf8` is well-formed.
std::string ascii(const std::string& utf8) {
    std::string text;
    for (std::size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<std::uint8_t>(utf8[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        std::uint32_t number = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length && i + k < utf8.size(); ++k)
            number = number << 6 | (static_cast<std::uint8_t>(utf8[i + k]) & 0x3FU);
        i += length;
        if (length == 1) {
            text += static_cast<char>(lead);
        } else if (length == 4) {
            text += '?';
        } else {
            text += "\\U+";
            for (int shift = 12; shift >= 0; shift -= 4)
                text += "0123456789ABCDEF"[(number >> shift) & 0xF];
        }
    }
    return text;
}

struct Layer {
    std::string name;
    int colour = kPlain;
    bool operator<(const Layer& other) const { return name < other.name; }
};

class DxfWriter {
public:
    DxfWriter(const std::vector<DrawnSection>& sections, std::string program)
        : sections_(sections), places_(places_of(sections)), program_(std::move(program)) {}

    std::string operator()() {
        head();
        tables();
        groups({{0, "SECTION"}, {2, "ENTITIES"}});
        for (number_ = 0; number_ < sections_.size(); ++number_)
            draw(sections_[number_]);
        groups({{0, "ENDSEC"}, {0, "EOF"}});
        return std::move(text_);
    }

private:
    void group(int code, const std::string& value) {
        text_ += std::to_string(code) + "\n" + value + "\n";
    }
    void groups(std::initializer_list<std::pair<int, const char*>> all) {
        for (const auto& [code, value] : all)
            group(code, value);
    }
    void point(int code, Vec2 p) {
        group(code, drawn(p.x));
        group(code + 10, drawn(p.y));
        group(code + 20, "0");
    }

    void head() {
        groups({{999, "section by ncsim, mm"}, {0, "SECTION"}, {2, "HEADER"}});
        groups({{9, "$ACADVER"}, {1, "AC1009"}, {9, "$INSUNITS"}, {70, "4"}});
        DrawnBox box = box_of(sections_);
        if (box.is_empty()) box.add(Vec2{});
        group(9, "$EXTMIN");
        point(10, {box.left, box.bottom});
        group(9, "$EXTMAX");
        point(10, {box.right, box.top});
        group(0, "ENDSEC");
    }

    Layer layer(const brep::SectionPiece& piece, std::size_t number) const {
        const DrawnSection& section = sections_[number];
        const FaceSource maker(section.provenance->of(piece.origin));
        Layer layer;
        layer.name = maker.is_tool ? maker.name() : "STOCK";
        constexpr int kColours = 6;
        if (maker.is_tool) layer.colour = 1 + static_cast<int>(maker.tool % kColours);
        const bool is_facet = piece.is_facet || (section.is_faceted && maker.is_tool);
        if (is_facet) {
            layer.name += "-FACETS";
            layer.colour = kGrey;
        }
        if (sections_.size() > 1) layer.name = std::to_string(number + 1) + "-" + layer.name;
        return layer;
    }

    void tables() {
        std::set<Layer> layers{{"0", kPlain}, {"NOTES", kPlain}};
        for (std::size_t i = 0; i < sections_.size(); ++i) {
            for (const brep::Outline& outline : sections_[i].section->outlines) {
                for (const brep::SectionPiece& piece : outline)
                    layers.insert(layer(piece, i));
            }
        }
        groups({{0, "SECTION"}, {2, "TABLES"}, {0, "TABLE"}, {2, "LTYPE"}, {70, "1"}});
        groups({{0, "LTYPE"}, {2, "CONTINUOUS"}, {70, "0"}, {3, "Solid line"}});
        groups({{72, "65"}, {73, "0"}, {40, "0"}, {0, "ENDTAB"}});
        groups({{0, "TABLE"}, {2, "LAYER"}});
        group(70, std::to_string(layers.size()));
        for (const Layer& layer : layers) {
            group(0, "LAYER");
            // FreeCAD skips the first group of a layer.
            group(70, "0");
            group(2, layer.name);
            group(62, std::to_string(layer.colour));
            group(6, "CONTINUOUS");
        }
        groups({{0, "ENDTAB"}, {0, "ENDSEC"}});
    }

    void draw(const DrawnSection& section) {
        for (const brep::Outline& outline : section.section->outlines) {
            for (const brep::SectionPiece& piece : outline)
                draw(piece);
        }
        const DrawnBox box = box_of(*section.section);
        constexpr double kHeight = 3.0, kBelow = 8.0;  // mm
        groups({{0, "TEXT"}, {8, "NOTES"}});
        point(10, moved({box.is_empty() ? 0.0 : box.left,
                         (box.is_empty() ? 0.0 : box.bottom) - kBelow}));
        group(40, drawn(kHeight));
        group(1, ascii(title_of(section, places_[number_], program_)));
    }

    Vec2 moved(Vec2 p) const { return {p.x + places_[number_], p.y}; }

    void entity(const std::string& kind, const std::string& layer) {
        group(0, kind);
        group(8, layer);
    }

    void draw(const brep::SectionPiece& piece) {
        const std::string on = layer(piece, number_).name;
        if (const auto* arc = std::get_if<brep::FlatArc>(&piece.curve)) {
            const bool is_whole = piece.from == piece.to;
            entity(is_whole ? "CIRCLE" : "ARC", on);
            point(10, moved(arc->centre));
            group(40, drawn(arc->radius));
            if (is_whole) return;
            // Arcs of DXF run counter-clockwise.
            group(50, drawn(angle_about(arc->centre, arc->is_ccw ? piece.from : piece.to)));
            group(51, drawn(angle_about(arc->centre, arc->is_ccw ? piece.to : piece.from)));
            return;
        }
        // R12 has neither ellipses nor splines, and OpenSCAD leaves out POLYLINE.
        Vec2 from = piece.from;
        for (const Vec2& to : chords_of(piece)) {
            entity("LINE", on);
            point(10, moved(from));
            point(11, moved(to));
            from = to;
        }
    }

    const std::vector<DrawnSection>& sections_;
    std::vector<double> places_;
    std::string program_;
    std::size_t number_ = 0;
    std::string text_;
};

}  // namespace

void write_dxf(std::ostream& out, const std::vector<DrawnSection>& sections,
               const std::string& program) {
    out << DxfWriter(sections, program)();
    if (!out) throw std::runtime_error("cannot write DXF: the stream failed");
}

}  // namespace ncsim::exporter
