// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extents, placement, chords and titles of sections on a drawing.
#include "formats/drawing_parts.h"

#include "ncsim/base/angles.h"

#include "formats/file_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ncsim::exporter {

using brep::FlatPoint;

std::string drawn(double number) {
    std::array<char, 64> digits{};
    constexpr int kNanometres = 6;
    char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                    std::chars_format::fixed, kNanometres)
                          .ptr;
    std::string text(digits.data(), end);
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

void DrawnBox::add(FlatPoint p) {
    left = std::min(left, p.u);
    right = std::max(right, p.u);
    bottom = std::min(bottom, p.v);
    top = std::max(top, p.v);
}

void DrawnBox::add(const DrawnBox& box, double moved) {
    if (box.is_empty()) return;
    add({box.left + moved, box.bottom});
    add({box.right + moved, box.top});
}

DrawnBox box_of(const brep::Section& section) {
    DrawnBox box;
    const auto around = [&](FlatPoint centre, double radius) {
        box.add({centre.u - radius, centre.v - radius});
        box.add({centre.u + radius, centre.v + radius});
    };
    for (const brep::Outline& outline : section.outlines) {
        for (const brep::SectionPiece& piece : outline) {
            box.add(piece.from);
            // A closed curve extends beyond its end point.
            if (const auto* arc = std::get_if<brep::FlatArc>(&piece.curve)) {
                if (piece.from == piece.to) around(arc->centre, arc->radius);
            } else if (const auto* e = std::get_if<brep::FlatEllipse>(&piece.curve)) {
                if (piece.from == piece.to) around(e->centre, hypotenuse(e->major.u, e->major.v));
            }
            if (piece.from == piece.to) continue;
            for (const FlatPoint& p : chords_of(piece))
                box.add(p);
        }
    }
    return box;
}

std::vector<double> places_of(const std::vector<DrawnSection>& sections) {
    std::vector<double> places;
    double right = 0.0;
    constexpr double kApart = 20.0;  // mm
    for (const DrawnSection& drawn : sections) {
        DrawnBox box = box_of(*drawn.section);
        // An empty section has a title, which needs a place.
        if (box.is_empty()) box.add(FlatPoint{});
        // Whole millimetres keep the coordinates readable.
        const double place = places.empty() ? 0.0 : std::ceil(right + kApart - box.left);
        places.push_back(place);
        right = box.right + place;
    }
    return places;
}

DrawnBox box_of(const std::vector<DrawnSection>& sections) {
    const std::vector<double> places = places_of(sections);
    DrawnBox box;
    for (std::size_t i = 0; i < sections.size(); ++i)
        box.add(box_of(*sections[i].section), places[i]);
    return box;
}

double angle_about(FlatPoint centre, FlatPoint p) {
    const double angle = angle_of(p.u - centre.u, p.v - centre.v);
    return angle < 0.0 ? angle + 360.0 : angle;
}

std::vector<FlatPoint> chords_of(const brep::SectionPiece& piece) {
    std::vector<FlatPoint> points;
    // Appends points on centre + cos(a) x + sin(a) y for `a` between `start` and `end`, in degrees.
    const auto go = [&](FlatPoint c, FlatPoint x, FlatPoint y, double start, double end,
                        bool is_ccw, double radius) {
        double turn = is_ccw ? end - start : start - end;
        while (turn <= 0.0)
            turn += 360.0;
        // The error of a chord over the angle a is r (1 - cos(a / 2)), about r a² / 8.
        const double most = std::sqrt(8.0 * brep::kChordsMm / std::max(radius, brep::kChordsMm)) /
                            kRadiansPerDegree;
        const int steps = std::max(1, static_cast<int>(std::ceil(turn / most)));
        for (int i = 1; i < steps; ++i) {
            const auto t = sin_cos(start + (is_ccw ? turn : -turn) * i / steps);
            points.push_back({c.u + t.cos * x.u + t.sin * y.u, c.v + t.cos * x.v + t.sin * y.v});
        }
    };
    if (const auto* arc = std::get_if<brep::FlatArc>(&piece.curve)) {
        go(arc->centre, {arc->radius, 0.0}, {0.0, arc->radius},
           angle_about(arc->centre, piece.from), angle_about(arc->centre, piece.to), arc->is_ccw,
           arc->radius);
    } else if (const auto* e = std::get_if<brep::FlatEllipse>(&piece.curve)) {
        const double major = hypotenuse(e->major.u, e->major.v);
        const double ratio = e->minor_radius / major;
        const FlatPoint minor{-ratio * e->major.v, ratio * e->major.u};
        const auto place = [&](FlatPoint p) {
            const double u = p.u - e->centre.u, v = p.v - e->centre.v;
            return angle_of((u * e->major.u + v * e->major.v) / (major * major),
                            (u * minor.u + v * minor.v) / (e->minor_radius * e->minor_radius));
        };
        go(e->centre, e->major, minor, place(piece.from), place(piece.to), e->is_ccw, major);
    } else if (const auto* chords = std::get_if<brep::FlatChords>(&piece.curve)) {
        points = chords->between;
    }
    points.push_back(piece.to);
    return points;
}

std::string title_of(const DrawnSection& section, double moved, const std::string& program) {
    std::string text = name_of(section.section->plane);
    if (!program.empty()) text += " of " + printable_utf8(program);
    if (moved != 0.0) text += ", moved by " + drawn(moved);
    if (section.section->outlines.empty()) text += ", empty";
    if (section.is_faceted) text += ", of facets";
    return text;
}

}  // namespace ncsim::exporter
