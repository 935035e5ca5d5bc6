// SPDX-License-Identifier: GPL-3.0-or-later
//
// Projection of paths, bodies and boxes to polygons.
#include "render/overlay_art.h"

#include "ncsim/base/angles.h"
#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/mesh/open_mesh.h"

#include "render/cut_surface.h"
#include "render/line_scale.h"
#include "render/palette.h"

#include <algorithm>
#include <cmath>

namespace ncsim::exporter {

namespace {

// In pixels of a picture with 960 rows (line_scale()).
constexpr double kLineWidth = 1.6;
constexpr double kDash = 9.0;
constexpr double kGap = 6.0;

constexpr Rgba8 kFeedOnWhite{22, 62, 138};
constexpr Rgba8 kRapidOnWhite{200, 44, 40};
constexpr Rgba8 kGhostOnWhite{150, 156, 164};
constexpr Rgba8 kGhostOnDark{120, 128, 138};
constexpr Rgba8 kFeedOnDark{255, 232, 112};
constexpr Rgba8 kRapidOnDark{255, 104, 92};

// Returns the point after the perspective division. The point must be in front of the eye. Lines
// stay straight on the screen, so the division can come first.
ScreenPoint divided(const ScreenPoint& p) {
    return {p.x / p.w, p.y / p.w, p.z / p.w, 1.0};
}

ScreenPoint interpolate(const ScreenPoint& a, const ScreenPoint& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), 1.0};
}

Surface line_surface(Rgba8 colour) {
    Surface surface;
    surface.n_C = {0, 0, 1};
    surface.colour = to_linear(colour);
    surface.is_line = true;
    return surface;
}

}  // namespace

OverlayArt::OverlayArt(const ScreenMap& map, const Overlay& overlay, const RenderOptions& options)
    : map_(map),
      pixel_(line_scale(options)),
      half_width_(0.5 * kLineWidth * pixel_),
      lift_((4.0 * half_width_ * map.sample_size()) * options.camera.back) {
    const bool is_white = options.background == Background::White;
    surfaces_.push_back(line_surface(is_white ? kFeedOnWhite : kFeedOnDark));
    surfaces_.push_back(line_surface(is_white ? kRapidOnWhite : kRapidOnDark));
    surfaces_.push_back(line_surface(is_white ? kGhostOnWhite : kGhostOnDark));
    for (const Body& body : overlay.bodies)
        add_body(body, options);
    for (const PathLine& path : overlay.paths)
        add_path(path, path.is_rapid ? 1 : 0);
    for (const Ghost& ghost : overlay.ghosts)
        add_ghost(ghost);
}

// Adds the twelve edges of a box. The edges lie slightly inside the box and behind the faces of the
// part, so the outline of a part that fills the box hides them.
void OverlayArt::add_ghost(const Ghost& ghost) {
    constexpr std::size_t kSurface = 2;
    const double inset = 0.5 * norm(lift_);
    const Vec3 inwards{inset, inset, inset};
    const Box box{ghost.box.min + inwards, ghost.box.max - inwards};
    if (box.is_empty()) return;
    const auto corner = [&](unsigned which) {
        return divided(map_(Vec3{(which & 1U) != 0 ? box.max.x : box.min.x,
                                 (which & 2U) != 0 ? box.max.y : box.min.y,
                                 (which & 4U) != 0 ? box.max.z : box.min.z} -
                            lift_));
    };
    for (unsigned from = 0; from < 8; ++from) {
        for (const unsigned axis : {1U, 2U, 4U}) {
            if ((from & axis) != 0) continue;
            add_stroke(corner(from), corner(from | axis), 0.5 * half_width_, kSurface);
        }
    }
}

void OverlayArt::add_path(const PathLine& path, std::size_t surface) {
    double walked = 0.0;  // distance from the first point, in samples
    const double dash = kDash * pixel_;
    const double period = (kDash + kGap) * pixel_;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const ScreenPoint a = divided(map_(path.points[i - 1] + lift_));
        const ScreenPoint b = divided(map_(path.points[i] + lift_));
        const double length = hypotenuse(b.x - a.x, b.y - a.y);
        if (!path.is_rapid) {
            add_stroke(a, b, half_width_, surface);
            continue;
        }
        if (length == 0.0) continue;
        // Dashes continue around corners.
        auto dashes = static_cast<std::int64_t>(std::floor(walked / period));
        for (; static_cast<double>(dashes) * period < walked + length; ++dashes) {
            const double at = static_cast<double>(dashes) * period;
            const double from = std::max(at, walked) - walked;
            const double to = std::min(at + dash, walked + length) - walked;
            if (from >= to) continue;
            add_stroke(interpolate(a, b, from / length), interpolate(a, b, to / length), 0.0,
                       surface);
        }
        walked += length;
    }
}

// Adds a rectangle around the segment, extended by `overhang` at both ends to close corners.
void OverlayArt::add_stroke(const ScreenPoint& a, const ScreenPoint& b, double overhang,
                            std::size_t surface) {
    const double length = hypotenuse(b.x - a.x, b.y - a.y);
    const double x = length > 0.0 ? (b.x - a.x) / length : 1.0;
    const double y = length > 0.0 ? (b.y - a.y) / length : 0.0;
    const auto corner = [&](const ScreenPoint& p, double along, double aside) {
        return ScreenPoint{p.x + along * x - aside * y, p.y + along * y + aside * x, p.z, 1.0};
    };
    pieces_.push_back({{corner(a, -overhang, -half_width_), corner(b, overhang, -half_width_),
                        corner(b, overhang, half_width_), corner(a, -overhang, half_width_)},
                       4,
                       surface});
}

void OverlayArt::add_body(const Body& body, const RenderOptions& options) {
    TriangleMesh mesh = cda::triangulate(body.surface);
    const std::size_t first = surfaces_.size();
    for (const cda::BoundaryFace& face : body.surface.faces) {
        const Vec3 n_C = map_.direction_in_camera(face.normal);
        const Vec3 point = map_.point_in_camera(body.surface.vertices[face.loops[0][0]]);
        surfaces_.push_back({n_C, dot(n_C, point), to_linear(body.colour)});
    }
    if (body.is_cut && options.cut) {
        const mesh::CutPlane& cut = *options.cut;
        const auto faces = static_cast<std::uint32_t>(body.surface.faces.size());
        mesh = mesh::open_mesh(mesh, faces, cut).mesh;
        surfaces_.push_back(cut_surface(map_, cut, to_linear(body.colour), Pattern::BodyHatch));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const bool is_old = mesh.face[t] < body.surface.faces.size();
        const Vec3 normal = is_old ? body.surface.faces[mesh.face[t]].normal : options.cut->normal;
        if (!faces_camera(map_.camera(), normal, mesh.vertices[a])) continue;
        pieces_.push_back(
            {{map_(mesh.vertices[a]), map_(mesh.vertices[b]), map_(mesh.vertices[c]), {}},
             3,
             first + mesh.face[t]});
    }
}

void OverlayArt::draw(PolygonTarget& target, std::vector<Surface>& surfaces) {
    if (pieces_.empty()) return;
    if (!first_) {
        first_ = surfaces.size();
        surfaces.insert(surfaces.end(), surfaces_.begin(), surfaces_.end());
    }
    for (const Piece& piece : pieces_) {
        target.draw(std::span(piece.corners).first(piece.count),
                    static_cast<SurfaceId>(*first_ + piece.surface + 1));
    }
}

}  // namespace ncsim::exporter
