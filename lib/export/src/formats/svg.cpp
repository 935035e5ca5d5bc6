// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections as SVG. The y axis of SVG points down, so counter-clockwise arcs of the drawing have the
// sweep flag 0.
//
// The form suits OpenSCAD, too: the view box begins at 0, and the coloured outlines are used from
// definitions, because OpenSCAD fills each closed outline and widens each line.
#include "ncsim/base/angles.h"

#include "formats/drawing_parts.h"
#include "formats/file_text.h"

#include <cmath>
#include <map>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace ncsim::exporter {

namespace {

std::string hex(Rgba8 colour) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : {colour.r, colour.g, colour.b}) {
        text += kDigits[channel >> 4];
        text += kDigits[channel & 15];
    }
    return text;
}

class SvgWriter {
public:
    SvgWriter(const std::vector<DrawnSection>& sections, const std::string& program)
        : sections_(sections), places_(places_of(sections)), program_(program) {}

    std::string operator()() {
        DrawnBox box = box_of(sections_);
        if (box.is_empty()) box.add(Vec2{});
        constexpr double kMargin = 5.0, kBelow = 12.0;  // mm
        // Zero of the drawing in the page: whole mm, so that a shift by hand is simple.
        const double zero_x = std::ceil(kMargin - box.left);
        const double zero_y = std::ceil(kMargin + box.top);
        const double width = std::ceil(zero_x + box.right + kMargin);
        const double height = std::ceil(zero_y - box.bottom + kBelow);
        text_ =
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" "
            "xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" width=\"" +
            drawn(width) + "mm\" height=\"" + drawn(height) + "mm\" viewBox=\"0 0 " + drawn(width) +
            " " + drawn(height) + "\">\n<g transform=\"translate(" + drawn(zero_x) + " " +
            drawn(zero_y) + ")\">\n";
        for (number_ = 0; number_ < sections_.size(); ++number_)
            draw(sections_[number_], places_[number_]);
        return std::move(text_) + "</g>\n</svg>\n";
    }

private:
    static std::string at(Vec2 p) { return drawn(p.x) + " " + drawn(-p.y); }

    void draw(const DrawnSection& section, double place) {
        const std::string title = xml_text(title_of(section, place, program_));
        text_ +=
            "<g transform=\"translate(" + drawn(place) + " 0)\">\n<title>" + title + "</title>\n";
        const Palette palette(*section.provenance);
        std::string filled;
        // Outlines by tool, and whether they belong to facets.
        std::map<std::pair<FaceSource, bool>, std::string> lines;
        for (const brep::Outline& outline : section.section->outlines) {
            filled += "M" + at(outline.front().from);
            std::string* last = nullptr;
            for (const brep::SectionPiece& piece : outline) {
                const FaceSource maker(section.provenance->of(piece.origin));
                const bool is_facet = piece.is_facet || (section.is_faceted && maker.is_tool);
                std::string& path = lines[{maker, is_facet}];
                const std::string on = path_commands(piece);
                filled += on;
                if (last != &path) path += "M" + at(piece.from);
                path += on;
                last = &path;
            }
            filled += "Z";
        }
        if (!filled.empty())
            text_ += "<path fill=\"#e4e4e4\" fill-rule=\"evenodd\" d=\"" + filled + "\"/>\n";
        const std::string name = "outlines-" + std::to_string(number_ + 1);
        text_ += "<defs><g id=\"" + name + "\">\n";
        for (const auto& [who, path] : lines) {
            const auto& [maker, is_facet] = who;
            text_ += "<path fill=\"none\" stroke=\"" + hex(palette.colour(maker)) +
                     "\" stroke-width=\"0.25\"" +
                     (is_facet ? " stroke-dasharray=\"1 0.5\" class=\"facets\"" : "") + " d=\"" +
                     path + "\"><title>" + maker.name() + (is_facet ? ", facets" : "") +
                     "</title></path>\n";
        }
        text_ += "</g></defs>\n<use xlink:href=\"#" + name + "\"/>\n";
        DrawnBox box = box_of(*section.section);
        if (box.is_empty()) box.add(Vec2{});
        constexpr double kBelow = 8.0;
        const Vec2 corner{box.left, box.bottom - kBelow};
        text_ += "<text font-family=\"sans-serif\" font-size=\"4\" x=\"" + drawn(corner.x) +
                 "\" y=\"" + drawn(-corner.y) + "\">" + title + "</text>\n</g>\n";
    }

    // Returns the path commands of a piece, from the current point to its end.
    static std::string path_commands(const brep::SectionPiece& piece) {
        if (const auto* arc = std::get_if<brep::FlatArc>(&piece.curve)) {
            const Vec2 opposite{2.0 * arc->centre.x - piece.from.x,
                                2.0 * arc->centre.y - piece.from.y};
            return arcs(piece, arc->radius, arc->radius, 0.0, arc->is_ccw, opposite,
                        angle_about(arc->centre, piece.from), angle_about(arc->centre, piece.to));
        }
        if (const auto* e = std::get_if<brep::FlatEllipse>(&piece.curve)) {
            const Vec2 opposite{2.0 * e->centre.x - piece.from.x, 2.0 * e->centre.y - piece.from.y};
            // An arc of more than half the ellipse also spans more than 180° about the centre, so
            // the angles about the centre decide the large-arc flag.
            return arcs(piece, hypotenuse(e->major.x, e->major.y), e->minor_radius,
                        -angle_of(e->major.x, e->major.y), e->is_ccw, opposite,
                        angle_about(e->centre, piece.from), angle_about(e->centre, piece.to));
        }
        std::string text;
        for (const Vec2& p : chords_of(piece))
            text += "L" + at(p);
        return text;
    }

    static std::string arcs(const brep::SectionPiece& piece, double rx, double ry, double turned,
                            bool is_ccw, Vec2 opposite, double start, double end) {
        const std::string radii = "A" + drawn(rx) + " " + drawn(ry) + " " + drawn(turned) + " ";
        const std::string sweep = is_ccw ? "0 " : "1 ";
        if (piece.from == piece.to)
            return radii + "1 " + sweep + at(opposite) + radii + "1 " + sweep + at(piece.to);
        double turn = is_ccw ? end - start : start - end;
        if (turn <= 0.0) turn += 360.0;
        return radii + (turn > 180.0 ? "1 " : "0 ") + sweep + at(piece.to);
    }

    const std::vector<DrawnSection>& sections_;
    std::vector<double> places_;
    const std::string& program_;
    std::size_t number_ = 0;
    std::string text_;
};

}  // namespace

void write_svg(std::ostream& out, const std::vector<DrawnSection>& sections,
               const std::string& program) {
    out << SvgWriter(sections, program)();
    if (!out) throw std::runtime_error("cannot write SVG: the stream failed");
}

}  // namespace ncsim::exporter
