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

void DrawnBox::add(Vec2 p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    bottom = std::min(bottom, p.y);
    top = std::max(top, p.y);
}

void DrawnBox::add(const DrawnBox& box, double moved) {
    if (box.is_empty()) return;
    add({box.left + moved, box.bottom});
    add({box.right + moved, box.top});
}

DrawnBox box_of(const brep::Section& section) {
    DrawnBox box;
    const auto around = [&](Vec2 centre, double radius) {
        box.add({centre.x - radius, centre.y - radius});
        box.add({centre.x + radius, centre.y + radius});
    };
    for (const brep::Outline& outline : section.outlines) {
        for (const brep::SectionPiece& piece : outline) {
            box.add(piece.from);
            // A closed curve extends beyond its end point.
            if (const auto* arc = std::get_if<brep::FlatArc>(&piece.curve)) {
                if (piece.from == piece.to) around(arc->centre, arc->radius);
            } else if (const auto* e = std::get_if<brep::FlatEllipse>(&piece.curve)) {
                if (piece.from == piece.to) around(e->centre, hypotenuse(e->major.x, e->major.y));
            }
            if (piece.from == piece.to) continue;
            for (const Vec2& p : chords_of(piece))
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
        if (box.is_empty()) box.add(Vec2{});
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

double angle_about(Vec2 centre, Vec2 p) {
    const double angle = angle_of(p.x - centre.x, p.y - centre.y);
    return angle < 0.0 ? angle + 360.0 : angle;
}

std::vector<Vec2> chords_of(const brep::SectionPiece& piece) {
    std::vector<Vec2> points;
    // Appends points on centre + cos(a) x + sin(a) y for `a` between `start` and `end`, in degrees.
    const auto go = [&](Vec2 c, Vec2 x, Vec2 y, double start, double end, bool is_ccw,
                        double radius) {
        double turn = is_ccw ? end - start : start - end;
        while (turn <= 0.0)
            turn += 360.0;
        // The error of a chord over the angle a is r (1 - cos(a / 2)), about r a² / 8.
        const double most = std::sqrt(8.0 * brep::kChordsMm / std::max(radius, brep::kChordsMm)) /
                            kRadiansPerDegree;
        const int steps = std::max(1, static_cast<int>(std::ceil(turn / most)));
        for (int i = 1; i < steps; ++i) {
            const auto t = sin_cos(start + (is_ccw ? turn : -turn) * i / steps);
            points.push_back({c.x + t.cos * x.x + t.sin * y.x, c.y + t.cos * x.y + t.sin * y.y});
        }
    };
    if (const auto* arc = std::get_if<brep::FlatArc>(&piece.curve)) {
        go(arc->centre, {arc->radius, 0.0}, {0.0, arc->radius},
           angle_about(arc->centre, piece.from), angle_about(arc->centre, piece.to), arc->is_ccw,
           arc->radius);
    } else if (const auto* e = std::get_if<brep::FlatEllipse>(&piece.curve)) {
        const double major = hypotenuse(e->major.x, e->major.y);
        const double ratio = e->minor_radius / major;
        const Vec2 minor{-ratio * e->major.y, ratio * e->major.x};
        const auto place = [&](Vec2 p) {
            const double u = p.x - e->centre.x, v = p.y - e->centre.y;
            return angle_of((u * e->major.x + v * e->major.y) / (major * major),
                            (u * minor.x + v * minor.y) / (e->minor_radius * e->minor_radius));
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
