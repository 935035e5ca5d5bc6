// SPDX-License-Identifier: GPL-3.0-or-later
//
// Both renderers draw the numbers of surfaces, band by band, and Resolver computes the pixels. The
// renderers differ only in how they find hidden and removed parts of a surface.
#include "ncsim/export/render.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/mesh/open_mesh.h"

#include "render/cut_surface.h"
#include "render/edge_tiles.h"
#include "render/offscreen.h"
#include "render/opengl_buffer.h"
#include "render/overlay_art.h"
#include "render/palette.h"
#include "render/pixel_resolver.h"
#include "render/recess_shade.h"
#include "render/surface.h"
#include "render/visibility.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::exporter {

namespace {

constexpr std::uint32_t kMaxSamples = 4;
constexpr unsigned kOpaque = 255;

// Material in the plane of a cut.
constexpr Rgba8 kCutOnWhite{238, 236, 230}, kCutOnDark{150, 154, 160};

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
    if (options.colouring == Colouring::Design && options.distances == nullptr)
        throw std::runtime_error("cannot colour by distance: no distances are specified");
    if (options.see_through && options.renderer != Renderer::Own)
        throw std::runtime_error("cannot render a transparent part with OSMesa");
    if (options.samples < 1 || options.samples > kMaxSamples) {
        throw std::runtime_error("cannot render with " + std::to_string(options.samples) +
                                 " samples: 1 to " + std::to_string(kMaxSamples) + " are possible");
    }
}

// Contents of a picture.
class Scene {
public:
    virtual ~Scene() = default;
    // Draws all polygons, in the same order at each call.
    virtual void draw(PolygonTarget& target) = 0;
    // Marks the tiles that edges of surfaces cross. Edges between polygons of one flat surface may
    // be missing.
    virtual void mark(EdgeTiles& tiles) { draw(tiles); }
};

std::unique_ptr<SampleBuffer> buffer_of(Renderer renderer) {
    if (renderer == Renderer::Osmesa) return std::make_unique<OpenGlBuffer>(osmesa_context());
    return std::make_unique<VisibilityBuffer>();
}

// Sum of the layers of a transparent part, front to back. A layer is a picture of the scene without
// the surfaces of the layers before.
class LayerSum {
public:
    /// Adds the pixels of `tile`, the next layer, with `weight` of kWhole.
    void add(const Image& layer, const PixelRect& tile, std::uint32_t weight) {
        sums_.resize(layer.pixels.size());
        for (std::uint32_t y = tile.y; y < tile.y + tile.height; ++y) {
            for (std::uint32_t x = tile.x; x < tile.x + tile.width; ++x) {
                const Rgba8& pixel = layer.at(x, y);
                auto& sum = sums_[std::size_t{y} * layer.width + x];
                sum[0] += weight * pixel.r;
                sum[1] += weight * pixel.g;
                sum[2] += weight * pixel.b;
            }
        }
    }
    /// Replaces the pixels by the means of all layers.
    void write(Image& image) const {
        const auto mean = [](std::uint32_t sum) {
            return static_cast<std::uint8_t>((sum + kWhole / 2) / kWhole);
        };
        for (std::size_t i = 0; i < sums_.size(); ++i)
            image.pixels[i] = {mean(sums_[i][0]), mean(sums_[i][1]), mean(sums_[i][2])};
    }
    /// Returns the weight of the layer after layers that left `rest` of kWhole.
    static std::uint32_t weight(std::uint32_t rest) { return rest * 7 / 20; }

    static constexpr std::uint32_t kWhole = 1U << 16;

private:
    std::vector<std::array<std::uint32_t, 3>> sums_;
};

// Draws the picture of a scene, in bands. If no edge is near a tile and its four corners see the
// same surface, the whole tile sees that surface: depth is linear over a tile, so a plane that is
// nearest at the corners is nearest between them. Only the remaining tiles are drawn sample by
// sample.
class Painter {
public:
    /// `table` contains the surfaces of the part.
    Painter(const ScreenMap& map, const RenderOptions& options, const SurfaceTable& table,
            Scene& scene)
        : options_(options),
          scene_(scene),
          tiles_(options.width, options.height, options.samples, kTileMargin),
          table_(table),
          last_of_part_(static_cast<SurfaceId>(table.surfaces.size())),
          shade_(map, options),
          resolver_(map, options, table, has_shade() ? &shade_ : nullptr),
          image_{options.width, options.height, {}} {
        const std::uint32_t row = tiles_.columns() * tiles_.side() * tiles_.side();
        rows_at_once_ = std::clamp(options.band_samples / row, 1U, tiles_.rows());
        image_.pixels.resize(std::size_t{options.width} * options.height);
    }

    Image paint() {
        const std::unique_ptr<SampleBuffer> made = buffer_of(options_.renderer);
        SampleBuffer& buffer = *made;
        if (has_shade()) {
            buffer.begin(shade_.cells());
            scene_.draw(buffer);
            shade_.gather(buffer.ids(), table_.surfaces);
        }
        if (options_.samples_everywhere) {
            tiles_.mark_all();
        } else {
            scene_.mark(tiles_);
            fill_plain_tiles(buffer);
        }
        for (std::uint32_t row = 0; row < tiles_.rows(); row += rows_at_once_)
            draw_tiles(buffer, row);
        if (options_.see_through) sum_.write(image_);
        return std::move(image_);
    }

private:
    bool has_shade() const { return options_.shades_recesses && !options_.see_through; }

    // Returns the pixels of the tile.
    PixelRect pixels(std::uint32_t column, std::uint32_t row) const {
        const std::uint32_t x = column * kTilePixels, y = row * kTilePixels;
        return {x, y, std::min(kTilePixels, options_.width - x),
                std::min(kTilePixels, options_.height - y)};
    }

    // Draws the scene into `rect`, and calls `use` with the surfaces and the weight of each layer:
    // one layer, or several of a transparent part.
    template <class Use>
    void draw_layers(SampleBuffer& buffer, const SampleRect& rect, const Use& use) {
        buffer.begin(rect);
        std::uint32_t rest = LayerSum::kWhole;
        for (std::uint32_t layer = 1;; ++layer) {
            scene_.draw(buffer);
            const std::span<const SurfaceId> ids = buffer.ids();
            const bool is_last = !options_.see_through || layer == kLayers ||
                                 std::ranges::none_of(ids, [&](SurfaceId id) {
                                     return id != kBackground && id <= last_of_part_;
                                 });
            const std::uint32_t weight = is_last ? rest : LayerSum::weight(rest);
            use(ids, weight);
            if (is_last) break;
            rest -= weight;
            buffer.peel(last_of_part_);
        }
    }

    // Adds the pixels of a tile to the sum of layers.
    void add(const PixelRect& tile, std::uint32_t weight) {
        if (options_.see_through) sum_.add(image_, tile, weight);
    }

    // Fills the tiles without an edge whose corners see the same surface in each layer; marks all
    // remaining tiles.
    void fill_plain_tiles(SampleBuffer& buffer) {
        // The centres of these cells are the corners of the tiles.
        const auto half = static_cast<std::int64_t>(tiles_.side() / 2);
        const SampleRect corners{-half, -half, tiles_.columns() + 1, tiles_.rows() + 1,
                                 tiles_.side()};
        std::vector<std::pair<std::vector<SurfaceId>, std::uint32_t>> layers;
        draw_layers(buffer, corners, [&](std::span<const SurfaceId> ids, std::uint32_t weight) {
            layers.emplace_back(std::vector(ids.begin(), ids.end()), weight);
        });
        for (std::uint32_t row = 0; row < tiles_.rows(); ++row) {
            for (std::uint32_t column = 0; column < tiles_.columns(); ++column) {
                if (tiles_.is_marked(column, row)) continue;
                const std::size_t i = std::size_t{row} * corners.width + column;
                const bool is_plain = std::ranges::all_of(layers, [&](const auto& layer) {
                    const std::vector<SurfaceId>& ids = layer.first;
                    return ids[i] == ids[i + 1] && ids[i] == ids[i + corners.width] &&
                           ids[i] == ids[i + corners.width + 1];
                });
                if (!is_plain) {
                    tiles_.mark(column, row);
                    continue;
                }
                for (const auto& [ids, weight] : layers) {
                    resolver_.fill(ids[i], pixels(column, row), image_);
                    add(pixels(column, row), weight);
                }
            }
        }
    }

    // Draws the marked tiles of a band.
    void draw_tiles(SampleBuffer& buffer, std::uint32_t first_row) {
        const std::uint32_t end_row = std::min(first_row + rows_at_once_, tiles_.rows());
        std::uint32_t left = tiles_.columns(), right = 0, top = end_row, bottom = first_row;
        for (std::uint32_t row = first_row; row < end_row; ++row) {
            for (std::uint32_t column = 0; column < tiles_.columns(); ++column) {
                if (!tiles_.is_marked(column, row)) continue;
                left = std::min(left, column);
                right = std::max(right, column + 1);
                top = std::min(top, row);
                bottom = std::max(bottom, row + 1);
            }
        }
        if (left >= right) return;
        const std::uint32_t side = tiles_.side();
        const SampleRect seen{
            std::int64_t{left} * side - kTileMargin, std::int64_t{top} * side - kTileMargin,
            (right - left) * side + 2 * kTileMargin, (bottom - top) * side + 2 * kTileMargin};
        draw_layers(buffer, seen, [&](std::span<const SurfaceId> ids, std::uint32_t weight) {
            for (std::uint32_t row = top; row < bottom; ++row) {
                for (std::uint32_t column = left; column < right; ++column) {
                    if (!tiles_.is_marked(column, row)) continue;
                    resolver_.resolve(ids, seen, pixels(column, row), image_);
                    add(pixels(column, row), weight);
                }
            }
        });
    }

    const RenderOptions& options_;
    Scene& scene_;
    EdgeTiles tiles_;
    std::uint32_t rows_at_once_ = 1;  // rows of tiles
    const SurfaceTable& table_;
    SurfaceId last_of_part_;
    RecessShade shade_;
    Resolver resolver_;
    Image image_;
    LayerSum sum_;
};

ScreenMap screen_map(const RenderOptions& options) {
    return {options.camera, static_cast<double>(options.width) * options.samples,
            static_cast<double>(options.height) * options.samples};
}

// Creates surfaces with the colours of the options.
class Paint {
public:
    Paint(const ScreenMap& map, const mesh::Provenance& provenance, const RenderOptions& options)
        : map_(map),
          provenance_(provenance),
          palette_(provenance),
          colouring_(options.colouring),
          ghost_(options.ghost_stock),
          behind_(colour_of(options.background)),
          cut_(to_linear(options.background == Background::White ? kCutOnWhite : kCutOnDark)),
          last_(provenance.entries.size() > 1 ? static_cast<double>(provenance.entries.size() - 1)
                                              : 1.0) {}

    Surface surface(Vec3 normal, Vec3 point, cda::Origin origin) const {
        const Vec3 n_C = map_.direction_in_camera(normal);
        Surface result;
        result.n_C = n_C;
        result.offset = dot(n_C, map_.point_in_camera(point));
        result.has_shade = true;
        const bool is_cut = origin != cda::kStockOrigin;
        if (is_cut && colouring_ == Colouring::Line) {
            // Origins are numbered in the order of cutting; program lines may repeat in loops.
            result.colour = scale_colour(static_cast<double>(origin) / last_);
        } else {
            result.colour = to_linear(palette_.colour(provenance_.of(origin)));
            if (!is_cut && ghost_) result.colour = 0.35F * result.colour + 0.65F * behind_;
            if (is_cut && colouring_ == Colouring::Depth) result.pattern = Pattern::Depth;
        }
        return result;
    }

    Surface cut(const mesh::CutPlane& plane) const {
        Surface result = cut_surface(map_, plane, cut_, Pattern::PartHatch);
        result.has_shade = true;
        return result;
    }

private:
    const ScreenMap& map_;
    const mesh::Provenance& provenance_;
    Palette palette_;
    Colouring colouring_;
    bool ghost_;
    LinearColour behind_, cut_;
    double last_;
};

// Draws the facets of a model with their masks. The facets come in the same order in each pass, so
// their numbers stay the same; the first pass fills the table.
class StencilCanvas : public cda::FacetCanvas {
public:
    StencilCanvas(const ScreenMap& map, const Paint& paint, std::vector<Surface>& surfaces)
        : map_(map), paint_(paint), surfaces_(surfaces) {}

    void begin(PolygonTarget& target) {
        target_ = &target;
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
        target_->draw(outline_, id, masks_);
    }

private:
    void project(std::span<const Vec3> polygon, std::vector<ScreenPoint>& result) const {
        result.clear();
        for (const Vec3& p : polygon)
            result.push_back(map_(p));
    }

    const ScreenMap& map_;
    const Paint& paint_;
    PolygonTarget* target_ = nullptr;
    std::size_t next_ = 0;
    std::vector<Surface>& surfaces_;
    std::vector<ScreenPoint> outline_;
    std::vector<std::vector<ScreenPoint>> masks_;
};

// The triangles of a boundary, cut open if the options have a plane. All triangles of a flat face
// are one surface; each triangle with normals or distances of its own is a surface.
class BoundaryArt {
public:
    /// Appends the surfaces of `boundary` to `table`.
    /// Requires: `boundary` and `table` outlive the object.
    BoundaryArt(const ScreenMap& map, const cda::Boundary& boundary, const brep::Shading& shading,
                const RenderOptions& options, const Paint& paint, SurfaceTable& table)
        : boundary_(boundary), surfaces_(table.surfaces), sees_backs_(options.see_through) {
        const DesignDistances* const distances =
            options.colouring == Colouring::Design ? options.distances : nullptr;
        TriangleMesh whole = distances ? distances->mesh : cda::triangulate(boundary);
        if (options.cut) {
            const auto faces = static_cast<std::uint32_t>(boundary.faces.size());
            mesh::OpenMesh open = mesh::open_mesh(whole, faces, *options.cut);
            mesh_ = std::move(open.mesh);
            add_surfaces(map, whole, open.old_triangle, shading, distances, paint, table);
            add_cut(map, *options.cut, paint, table);
        } else {
            mesh_ = std::move(whole);
            add_surfaces(map, mesh_, {}, shading, distances, paint, table);
        }
        for (const Vec3& p : mesh_.vertices)
            points_.push_back(map(p));
    }

    void draw(PolygonTarget& target) const {
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (ids_[t] != kBackground) target.draw(corners(t), ids_[t]);
        }
    }

    /// Marks the loops of the drawn flat faces, and all triangles of round faces.
    void mark(EdgeTiles& tiles) const {
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (ids_[t] != kBackground && has_edges_of_its_own(t)) tiles.draw(corners(t), ids_[t]);
        }
        for (const std::uint32_t f : flat_faces_) {
            for (const auto& loop : boundary_.faces[f].loops) {
                for (std::size_t i = 0; i < loop.size(); ++i)
                    tiles.add_edge(points_[loop[i]], points_[loop[(i + 1) % loop.size()]]);
            }
        }
    }

private:
    // Appends a surface for each triangle of mesh_ that lies in a face of the boundary.
    // `whole_triangle`: index of the triangle of `whole` that contains it; empty: the same index.
    void add_surfaces(const ScreenMap& map, const TriangleMesh& whole,
                      std::span<const std::uint32_t> whole_triangle, const brep::Shading& shading,
                      const DesignDistances* distances, const Paint& paint, SurfaceTable& table) {
        const std::size_t count =
            whole_triangle.empty() ? mesh_.triangles.size() : whole_triangle.size();
        std::vector<SurfaceId> of_face(boundary_.faces.size(), kBackground);
        const auto is_visible = [&](Vec3 normal, Vec3 point) {
            return faces_camera(map.camera(), normal, point);
        };
        for (std::size_t t = 0; t < count; ++t) {
            const std::uint32_t f = mesh_.face[t];
            const cda::BoundaryFace& face = boundary_.faces[f];
            const Vec3 point = boundary_.vertices[face.loops.front().front()];
            const bool is_back = sees_backs_ && is_visible(-face.normal, point);
            if (!is_back && !is_visible(face.normal, point)) {
                ids_.push_back(kBackground);
                continue;
            }
            const bool is_round = shading.recognition(f) == brep::Shading::Recognition::Curved;
            const bool is_alone = is_round || distances;
            if (is_alone || of_face[f] == kBackground) {
                table.surfaces.push_back(
                    paint.surface(is_back ? -face.normal : face.normal, point, face.origin));
                of_face[f] = static_cast<SurfaceId>(table.surfaces.size());
                if (!is_alone) flat_faces_.push_back(f);
            }
            ids_.push_back(of_face[f]);
            if (!is_alone) continue;
            const auto& vertices = whole.triangles[whole_triangle.empty() ? t : whole_triangle[t]];
            std::array<Vec3, 3> points, corners;
            for (std::size_t i = 0; i < 3; ++i) {
                points[i] = whole.vertices[vertices[i]];
                corners[i] = map.point_in_camera(points[i]);
            }
            if (is_round) {
                std::array<Vec3, 3> normals;
                for (std::size_t i = 0; i < 3; ++i) {
                    const Vec3 n = map.direction_in_camera(
                        shading.normal_or_none(f, face.normal, vertices[i], points[i]));
                    normals[i] = is_back ? -n : n;
                }
                table.bends.emplace_back(corners, normals);
                table.surfaces.back().bend = static_cast<std::uint32_t>(table.bends.size());
            }
            if (distances) add_ramp(corners, vertices, *distances, table);
        }
    }

    // Colours the last surface by distance.
    static void add_ramp(const std::array<Vec3, 3>& corners,
                         const std::array<std::uint32_t, 3>& vertices,
                         const DesignDistances& distances, SurfaceTable& table) {
        std::array<double, 3> values{};
        for (std::size_t i = 0; i < 3; ++i)
            values[i] = distances.distance_mm.at(vertices[i]);
        table.surfaces.back().pattern = Pattern::Distance;
        table.surfaces.back().ramp = static_cast<std::uint32_t>(table.ramps.size());
        table.ramps.emplace_back(corners, values);
    }

    // Appends the surface of the cut, for the remaining triangles.
    void add_cut(const ScreenMap& map, const mesh::CutPlane& cut, const Paint& paint,
                 SurfaceTable& table) {
        SurfaceId id = kBackground;
        if (faces_camera(map.camera(), cut.normal, cut.offset * cut.normal)) {
            table.surfaces.push_back(paint.cut(cut));
            id = static_cast<SurfaceId>(table.surfaces.size());
        }
        ids_.resize(mesh_.triangles.size(), id);
    }

    std::array<ScreenPoint, 3> corners(std::size_t t) const {
        const auto& [a, b, c] = mesh_.triangles[t];
        return {points_[a], points_[b], points_[c]};
    }

    // True for triangles that are surfaces, and for triangles with a vertex that the boundary does
    // not have.
    bool has_edges_of_its_own(std::size_t t) const {
        const Surface& surface = surfaces_[ids_[t] - 1];
        return surface.bend != 0 || surface.pattern == Pattern::Distance ||
               std::ranges::any_of(mesh_.triangles[t],
                                   [&](auto v) { return v >= boundary_.vertices.size(); });
    }

    const cda::Boundary& boundary_;
    const std::vector<Surface>& surfaces_;
    bool sees_backs_;                        // also faces that face away are drawn
    std::vector<std::uint32_t> flat_faces_;  // flat faces that are drawn
    TriangleMesh mesh_;
    std::vector<ScreenPoint> points_;
    // Surface of each triangle; kBackground: the triangle is not drawn.
    std::vector<SurfaceId> ids_;
};

// Returns the picture that `draw` makes of an overlay. If some bodies are not opaque, the picture
// with all bodies is blended over the picture without them, with the opacity of the first.
template <typename Draw>
Image blend_transparent(const Overlay& overlay, const Draw& draw) {
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

class ModelScene final : public Scene {
public:
    ModelScene(const cda::FacetModel& model, const ScreenMap& map, const Paint& paint,
               OverlayArt& art, std::vector<Surface>& surfaces)
        : model_(model), canvas_(map, paint, surfaces), art_(art), surfaces_(surfaces) {}

    void draw(PolygonTarget& target) override {
        canvas_.begin(target);
        model_.render(canvas_);
        art_.draw(target, surfaces_);
    }

private:
    const cda::FacetModel& model_;
    StencilCanvas canvas_;
    OverlayArt& art_;
    std::vector<Surface>& surfaces_;
};

class BoundaryScene final : public Scene {
public:
    BoundaryScene(const BoundaryArt& part, OverlayArt& art, std::vector<Surface>& surfaces)
        : part_(part), art_(art), surfaces_(surfaces) {}

    void draw(PolygonTarget& target) override {
        part_.draw(target);
        art_.draw(target, surfaces_);
    }
    void mark(EdgeTiles& tiles) override {
        part_.mark(tiles);
        art_.draw(tiles, surfaces_);
    }

private:
    const BoundaryArt& part_;
    OverlayArt& art_;
    std::vector<Surface>& surfaces_;
};

Image draw_model(const cda::FacetModel& model, const mesh::Provenance& provenance,
                 const RenderOptions& options, const Overlay& overlay) {
    check(options);
    const ScreenMap map = screen_map(options);
    const Paint paint(map, provenance, options);
    SurfaceTable table;
    OverlayArt art(map, overlay, options);
    ModelScene scene(model, map, paint, art, table.surfaces);
    return Painter(map, options, table, scene).paint();
}

Image draw_boundary(const cda::Boundary& boundary, const mesh::Provenance& provenance,
                    const RenderOptions& options, const Overlay& overlay,
                    const brep::Shading& shading) {
    check(options);
    const ScreenMap map = screen_map(options);
    OverlayArt art(map, overlay, options);
    SurfaceTable table;
    const BoundaryArt part(map, boundary, shading, options, Paint(map, provenance, options), table);
    BoundaryScene scene(part, art, table.surfaces);
    return Painter(map, options, table, scene).paint();
}

}  // namespace

Image render_model(const cda::FacetModel& model, const mesh::Provenance& provenance,
                   const RenderOptions& options, const Overlay& overlay) {
    return blend_transparent(overlay, [&](const Overlay& shown) {
        return draw_model(model, provenance, options, shown);
    });
}

Image render_boundary(const cda::Boundary& boundary, const mesh::Provenance& provenance,
                      const RenderOptions& options, const Overlay& overlay,
                      const brep::Shading& shading) {
    return blend_transparent(overlay, [&](const Overlay& shown) {
        return draw_boundary(boundary, provenance, options, shown, shading);
    });
}

}  // namespace ncsim::exporter
