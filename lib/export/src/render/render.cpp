// SPDX-License-Identifier: GPL-3.0-or-later
//
// Both renderers draw the numbers of surfaces, tile by tile, and leave the rest to Resolver:
// what differs between them is only how hidden and removed parts of a surface are found.
#include "ncsim/export/render.h"

#include "ncsim/cda/mesh.h"

#include "render/overlay.h"
#include "render/palette.h"
#include "render/resolve.h"
#include "render/surface.h"
#include "render/visibility.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::exporter {

namespace {

using cda::Vec3;

constexpr std::uint32_t kMaxSamples = 4;
constexpr unsigned kOpaque = 255;
// Samples along a side of the largest rectangle drawn at once: with colours, depth and the copy
// that is read back some 12 bytes a sample, so 200 MB.
constexpr std::uint32_t kTileSide = 4096;

void check(const RenderOptions& options) {
    const auto is_side = [](std::uint32_t n) { return n >= 1 && n <= kMaxImageSide; };
    if (!is_side(options.width) || !is_side(options.height)) {
        throw std::runtime_error("cannot render a picture of " + std::to_string(options.width) +
                                 " by " + std::to_string(options.height) + " pixels: 1 to " +
                                 std::to_string(kMaxImageSide) + " are possible");
    }
    if (options.colouring == Colouring::Depth && !(options.depth_bottom < options.depth_top)) {
        throw std::runtime_error("cannot colour by depth: the bottom is not below the top");
    }
    if (options.samples < 1 || options.samples > kMaxSamples) {
        throw std::runtime_error("cannot render with " + std::to_string(options.samples) +
                                 " samples: 1 to " + std::to_string(kMaxSamples) + " are possible");
    }
}

// Draws everything `draw` draws, which is called once for each tile with the buffer.
template <typename Draw>
Image render(const ScreenMap& map, const RenderOptions& options, const SurfaceTable& table,
             Draw draw) {
    const std::uint32_t tile = (kTileSide - 2 * kTileMargin) / options.samples;
    const auto samples_of = [&](std::uint32_t pixels) {
        return std::min(pixels, tile) * options.samples + 2 * kTileMargin;
    };
    VisibilityBuffer buffer(samples_of(options.width), samples_of(options.height));
    Resolver resolver(map, options, table);
    Image image{options.width, options.height, {}};
    image.pixels.resize(std::size_t{options.width} * options.height);
    std::vector<SurfaceId> ids;
    for (std::uint32_t y = 0; y < options.height; y += tile) {
        for (std::uint32_t x = 0; x < options.width; x += tile) {
            const std::uint32_t width = std::min(tile, options.width - x);
            const std::uint32_t height = std::min(tile, options.height - y);
            buffer.begin({std::int64_t{x} * options.samples - kTileMargin,
                          std::int64_t{y} * options.samples - kTileMargin, samples_of(width),
                          samples_of(height)});
            draw(buffer);
            buffer.read(ids);
            resolver.resolve(ids, x, y, width, height, image);
        }
    }
    return image;
}

ScreenMap screen_map(const RenderOptions& options) {
    return {options.camera, static_cast<double>(options.width) * options.samples,
            static_cast<double>(options.height) * options.samples};
}

// Makes surfaces, coloured as the options say.
class Paint {
public:
    Paint(const ScreenMap& map, const Provenance& provenance, const RenderOptions& options)
        : map_(map),
          provenance_(provenance),
          palette_(provenance),
          colouring_(options.colouring),
          ghost_(options.ghost_stock),
          behind_(colour_of(options.background)),
          last_(provenance.entries.size() > 1 ? static_cast<double>(provenance.entries.size() - 1)
                                              : 1.0) {}

    Surface surface(Vec3 normal, Vec3 point, cda::Origin origin) const {
        const Vec3 n_C = map_.direction_in_camera(normal);
        Surface result;
        result.n_C = n_C;
        result.offset = cda::dot(n_C, map_.point_in_camera(point));
        const bool is_cut = origin != cda::kStockOrigin;
        if (is_cut && colouring_ == Colouring::Line) {
            // Origins are numbered as they were cut: program lines may come in loops.
            result.colour = scale_colour(static_cast<double>(origin) / last_);
        } else {
            result.colour = to_linear(palette_.colour(provenance_.of(origin)));
            if (!is_cut && ghost_) result.colour = 0.35F * result.colour + 0.65F * behind_;
            result.by_depth = is_cut && colouring_ == Colouring::Depth;
        }
        return result;
    }

private:
    const ScreenMap& map_;
    const Provenance& provenance_;
    Palette palette_;
    Colouring colouring_;
    bool ghost_;
    LinearColour behind_;
    double last_;
};

// Hands the facets of a model to the stencil buffer. The facets come in the same order for every
// tile, so their numbers stay the same; the table is filled by the first.
class StencilCanvas : public cda::FacetCanvas {
public:
    StencilCanvas(const ScreenMap& map, const Paint& paint, std::vector<Surface>& surfaces)
        : map_(map), paint_(paint), surfaces_(surfaces) {}

    void begin(VisibilityBuffer& buffer) {
        buffer_ = &buffer;
        next_ = 0;
    }

    void draw(const cda::MaskedFacet& facet) override {
        if (facet.outline.size() < 3 ||
            !faces_camera(map_.camera(), facet.normal, facet.outline[0])) {
            return;
        }
        if (next_ == surfaces_.size()) {
            surfaces_.push_back(paint_.surface(facet.normal, facet.outline[0], facet.origin));
        }
        const auto id = static_cast<SurfaceId>(++next_);
        project(facet.outline, outline_);
        masks_.resize(facet.masks.size());
        for (std::size_t i = 0; i < facet.masks.size(); ++i)
            project(facet.masks[i], masks_[i]);
        buffer_->draw(outline_, id, masks_);
    }

private:
    void project(std::span<const Vec3> polygon, std::vector<ScreenPoint>& result) const {
        result.clear();
        for (const Vec3& p : polygon)
            result.push_back(map_(p));
    }

    const ScreenMap& map_;
    const Paint& paint_;
    VisibilityBuffer* buffer_ = nullptr;
    std::size_t next_ = 0;
    std::vector<Surface>& surfaces_;
    std::vector<ScreenPoint> outline_;
    std::vector<std::vector<ScreenPoint>> masks_;
};

// The triangles of a boundary. Those of a flat face are one surface, those of a round one have
// normals of their own each.
class BoundaryArt {
public:
    /// Appends its surfaces to `table`.
    BoundaryArt(const ScreenMap& map, const cda::Boundary& boundary, const brep::Shading& shading,
                const Paint& paint, SurfaceTable& table)
        : mesh_(cda::triangulate(boundary)) {
        for (const Vec3& p : mesh_.vertices)
            points_.push_back(map(p));
        std::vector<SurfaceId> of_face(boundary.faces.size(), kBackground);
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            const std::uint32_t f = mesh_.face[t];
            const cda::BoundaryFace& face = boundary.faces[f];
            const Vec3 point = boundary.vertices[face.loops.front().front()];
            if (!faces_camera(map.camera(), face.normal, point)) {
                ids_.push_back(kBackground);
                continue;
            }
            const bool is_round = shading.known(f) == brep::Shading::Known::Round;
            if (is_round || of_face[f] == kBackground) {
                table.surfaces.push_back(paint.surface(face.normal, point, face.origin));
                of_face[f] = static_cast<SurfaceId>(table.surfaces.size());
            }
            ids_.push_back(of_face[f]);
            if (!is_round) continue;
            std::array<Vec3, 3> corners, normals;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t v = mesh_.triangles[t][i];
                const Vec3 p = mesh_.vertices[v];
                corners[i] = map.point_in_camera(p);
                normals[i] = map.direction_in_camera(shading.normal_or_none(f, face.normal, v, p));
            }
            table.bends.emplace_back(corners, normals);
            table.surfaces.back().bend = static_cast<std::uint32_t>(table.bends.size());
        }
    }

    void draw(VisibilityBuffer& buffer) const {
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (ids_[t] == kBackground) continue;
            const auto& [a, b, c] = mesh_.triangles[t];
            const std::array<ScreenPoint, 3> corners{points_[a], points_[b], points_[c]};
            buffer.draw(corners, ids_[t]);
        }
    }

private:
    cda::TriangleMesh mesh_;
    std::vector<ScreenPoint> points_;
    std::vector<SurfaceId> ids_;  // of triangles; the background's: they are not seen
};

// The picture that `draw` makes of an overlay; with bodies that are not opaque, that of the others
// with the whole one over it, by their share.
template <typename Draw>
Image with_transparent(const Overlay& overlay, const Draw& draw) {
    const auto is_transparent = [](const Body& body) { return body.colour.a < kOpaque; };
    const auto first = std::ranges::find_if(overlay.bodies, is_transparent);
    if (first == overlay.bodies.end()) return draw(overlay);
    const unsigned share = first->colour.a;
    Overlay opaque = overlay;
    std::erase_if(opaque.bodies, is_transparent);
    Image image = draw(opaque);
    const Image whole = draw(overlay);
    const auto mix = [share](std::uint8_t& below, std::uint8_t above) {
        below = static_cast<std::uint8_t>(
            (share * above + (kOpaque - share) * below + kOpaque / 2) / kOpaque);
    };
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        Rgba8& below = image.pixels[i];
        const Rgba8& above = whole.pixels[i];
        if (below == above) continue;
        mix(below.r, above.r);
        mix(below.g, above.g);
        mix(below.b, above.b);
        mix(below.a, above.a);
    }
    return image;
}

Image draw_model(const cda::WorkpieceModel& model, const Provenance& provenance,
                 const RenderOptions& options, const Overlay& overlay) {
    check(options);
    const ScreenMap map = screen_map(options);
    const Paint paint(map, provenance, options);
    SurfaceTable table;
    StencilCanvas canvas(map, paint, table.surfaces);
    OverlayArt art(map, overlay, options);
    return render(map, options, table, [&](VisibilityBuffer& buffer) {
        canvas.begin(buffer);
        model.render(canvas);
        art.draw(buffer, table.surfaces);
    });
}

Image draw_boundary(const cda::Boundary& boundary, const Provenance& provenance,
                    const RenderOptions& options, const Overlay& overlay,
                    const brep::Shading& shading) {
    check(options);
    const ScreenMap map = screen_map(options);
    OverlayArt art(map, overlay, options);
    SurfaceTable table;
    const BoundaryArt part(map, boundary, shading, Paint(map, provenance, options), table);
    return render(map, options, table, [&](VisibilityBuffer& buffer) {
        part.draw(buffer);
        art.draw(buffer, table.surfaces);
    });
}

}  // namespace

Image render_model(const cda::WorkpieceModel& model, const Provenance& provenance,
                   const RenderOptions& options, const Overlay& overlay) {
    return with_transparent(overlay, [&](const Overlay& shown) {
        return draw_model(model, provenance, options, shown);
    });
}

Image render_boundary(const cda::Boundary& boundary, const Provenance& provenance,
                      const RenderOptions& options, const Overlay& overlay,
                      const brep::Shading& shading) {
    return with_transparent(overlay, [&](const Overlay& shown) {
        return draw_boundary(boundary, provenance, options, shown, shading);
    });
}

}  // namespace ncsim::exporter
