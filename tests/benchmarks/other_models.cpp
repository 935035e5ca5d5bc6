// SPDX-License-Identifier: GPL-3.0-or-later
//
// other_models PROGRAM…: measures systems that the thesis names (chapter 2) and ncsim does not use,
// on the same hulls: a tree of BSP cells, voxels (OpenVDB), and Boolean operations of a CAD kernel
// (OpenCASCADE). OpenVDB and OpenCASCADE are optional. Rows are like rows of model_table.
// other_models --picture PROGRAM FILE.png: draws the part in several models, side by side.
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/tree.h"
#include "ncsim/dexel/dexel.h"
#include "ncsim/export/contact_sheet.h"
#include "ncsim/export/image.h"
#include "ncsim/export/png.h"
#include "ncsim/export/render.h"

#include "hulls.h"
#include "measure.h"

#include <fmt/format.h>
#include <sys/resource.h>

#ifdef NCSIM_HAS_OPENVDB
#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/LevelSetMeasure.h>
#include <openvdb/tools/VolumeToMesh.h>
#endif
#ifdef NCSIM_HAS_OCCT
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace ncsim;

using bench::cpu_seconds;

// Halfspace n·x <= d, with n of unit length, in mm.
struct Halfspace {
    Vec3 n;
    double d;
};
using Body = std::vector<Halfspace>;

struct Work {
    std::string name;
    Box stock;
    std::vector<Body> bodies;
    std::vector<Box> bounds;
    double exact_volume = 0.0;
};

Body body_of(const cda::Cell& cell, const cda::Lattice& lattice) {
    Body body;
    for (const cda::Plane& plane : cell.planes)
        body.push_back({cda::unit_normal(plane), cda::offset_mm(plane, lattice)});
    return body;
}

// Returns the work for the first `most` hulls.
Work work_of(bench::Hulls hulls, std::size_t most) {
    if (hulls.cells.size() > most) hulls.cells.resize(most);
    Work work{hulls.name, hulls.stock, {}, {}, hulls.exact_volume()};
    for (const cda::Cell& cell : hulls.cells) {
        work.bodies.push_back(body_of(cell, hulls.lattice));
        work.bounds.push_back(cell.bounds);
    }
    return work;
}

// Polygon of a convex body, in the plane of a halfspace.
using Polygon = std::vector<Vec3>;

Polygon clipped(const Polygon& polygon, const Halfspace& h) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& a = polygon[i];
        const Vec3& b = polygon[(i + 1) % polygon.size()];
        const double at_a = dot(h.n, a) - h.d, at_b = dot(h.n, b) - h.d;
        if (at_a <= 0.0) kept.push_back(a);
        if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0))
            kept.push_back(a + (at_a / (at_a - at_b)) * (b - a));
    }
    return kept;
}

// Returns the face of a body in the plane of the halfspace `number`; empty if the halfspace has no
// share in the surface.
Polygon face_of(const Body& body, std::size_t number) {
    constexpr double kFar = 1e3;
    const Halfspace& h = body[number];
    const Vec3 aside = std::abs(h.n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = normalized(cross(h.n, aside)), v = cross(h.n, u);
    const Vec3 at = h.d * h.n;
    Polygon face{at + kFar * (u + v), at + kFar * (v - u), at - kFar * (u + v),
                 at + kFar * (u - v)};
    for (std::size_t i = 0; i < body.size(); ++i) {
        if (i != number) face = clipped(face, body[i]);
    }
    return face;
}

std::vector<Polygon> polygons_of(const Body& body) {
    std::vector<Polygon> faces;
    for (std::size_t i = 0; i < body.size(); ++i) {
        Polygon face = face_of(body, i);
        if (face.size() > 2) faces.push_back(std::move(face));
    }
    return faces;
}

Body box_body(const Box& box) {
    return {{{1, 0, 0}, box.max.x},   {{-1, 0, 0}, -box.min.x}, {{0, 1, 0}, box.max.y},
            {{0, -1, 0}, -box.min.y}, {{0, 0, 1}, box.max.z},   {{0, 0, -1}, -box.min.z}};
}

// --- BSP: Naylor, Amanatides, Thibault, "Merging BSP Trees", SIGGRAPH 1990, of a convex body ---

// A convex region: its faces, each with the number of the body's plane in which the face lies, or
// `kOfNode`.
constexpr std::size_t kOfNode = ~std::size_t{0};
struct Region {
    struct Face {
        Polygon outline;
        std::size_t plane;
    };
    std::vector<Face> faces;

    double volume() const {
        double sum = 0.0;
        for (const Face& f : faces) {
            for (std::size_t i = 1; i + 1 < f.outline.size(); ++i)
                sum += dot(f.outline[0] - faces[0].outline[0],
                           cross(f.outline[i] - faces[0].outline[0],
                                 f.outline[i + 1] - faces[0].outline[0]));
        }
        return sum / 6.0;
    }
    Region cut(const Halfspace& h, std::size_t plane) const {
        Region kept;
        std::vector<Vec3> rim;
        constexpr double kOn = 1e-9;
        for (const Face& f : faces) {
            Polygon outline = clipped(f.outline, h);
            if (outline.size() < 3) continue;
            for (const Vec3& p : outline) {
                if (std::abs(dot(h.n, p) - h.d) < kOn) rim.push_back(p);
            }
            kept.faces.push_back({std::move(outline), f.plane});
        }
        if (kept.faces.empty() || rim.size() < 3) return kept;
        Vec3 middle;
        for (const Vec3& p : rim)
            middle = middle + (1.0 / static_cast<double>(rim.size())) * p;
        const Vec3 aside = std::abs(h.n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 u = normalized(cross(h.n, aside)), v = cross(h.n, u);
        std::ranges::sort(rim, {}, [&](const Vec3& p) {
            return std::atan2(dot(v, p - middle), dot(u, p - middle));
        });
        // Adds the section as a face, unless the region already has a face in the plane.
        const bool has_face = std::ranges::any_of(kept.faces, [&](const Face& f) {
            return std::ranges::all_of(
                f.outline, [&](const Vec3& p) { return std::abs(dot(h.n, p) - h.d) < kOn; });
        });
        if (!has_face) kept.faces.push_back({std::move(rim), plane});
        return kept;
    }
};

Region region_of(const Body& body) {
    Region region;
    for (std::size_t i = 0; i < body.size(); ++i) {
        Polygon face = face_of(body, i);
        if (face.size() > 2) region.faces.push_back({std::move(face), i});
    }
    return region;
}

struct Node {
    Halfspace plane{};
    std::unique_ptr<Node> inside, outside;  // a leaf has neither
    bool is_in = true;
};

class Bsp {
public:
    explicit Bsp(const Box& stock) : stock_(box_body(stock)) {}
    std::size_t nodes = 1;

    void subtract(const Body& body) {
        Region region = region_of(body);
        for (const Halfspace& h : stock_)
            region = region.cut(h, kOfNode);
        if (is_something(region)) subtract(root_, region, body);
    }
    double volume() const { return volume(root_, region_of(stock_)); }

private:
    static bool is_something(const Region& region) { return region.volume() > 1e-9; }
    static Halfspace opposite(const Halfspace& h) { return {-1.0 * h.n, -h.d}; }

    // Subtracts `region`, the part of the body in the node's cell.
    void subtract(Node& node, const Region& region, const Body& body) {
        if (!node.is_in) return;
        if (!node.inside) {
            std::vector<std::size_t> planes;
            for (const Region::Face& f : region.faces) {
                if (f.plane != kOfNode) planes.push_back(f.plane);
            }
            carve(node, planes, body);
            return;
        }
        const Region within = region.cut(node.plane, kOfNode);
        if (is_something(within)) subtract(*node.inside, within, body);
        const Region beyond = region.cut(opposite(node.plane), kOfNode);
        if (is_something(beyond)) subtract(*node.outside, beyond, body);
    }
    void carve(Node& leaf, const std::vector<std::size_t>& planes, const Body& body) {
        Node* node = &leaf;
        for (const std::size_t plane : planes) {
            node->plane = body[plane];
            node->inside = std::make_unique<Node>();
            node->outside = std::make_unique<Node>();
            nodes += 2;
            node = node->inside.get();
        }
        node->is_in = false;
    }
    static double volume(const Node& node, const Region& region) {
        if (!node.is_in) return 0.0;
        if (!node.inside) return region.volume();
        double sum = 0.0;
        const Region within = region.cut(node.plane, kOfNode);
        if (is_something(within)) sum += volume(*node.inside, within);
        const Region beyond = region.cut(opposite(node.plane), kOfNode);
        if (is_something(beyond)) sum += volume(*node.outside, beyond);
        return sum;
    }

    Body stock_;
    Node root_;
};

void print(const Work& work, const std::string& title, double seconds, const std::string& size,
           double volume, const std::string& note) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print("| {} | {} | {} | {:.0f} | {:.2f} | {} | {} | {:+.3g} | {} |\n", work.name, title,
               work.bodies.size(), 1e6 * seconds / static_cast<double>(work.bodies.size()), seconds,
               usage.ru_maxrss / 1024, size, volume - work.exact_volume, note);
    std::fflush(stdout);
}

void bsp(const Work& work) {
    const double start = cpu_seconds();
    Bsp tree(work.stock);
    for (const Body& body : work.bodies)
        tree.subtract(body);
    const double seconds = cpu_seconds() - start;
    print(work, "BSP tree, doubles", seconds, fmt::format("{} nodes", tree.nodes), tree.volume(),
          "no surface yet");
}

#ifdef NCSIM_HAS_OPENVDB
using Grid = openvdb::FloatGrid;

Grid::Ptr voxel_part(const Work& work, double size) {
    openvdb::initialize();
    const auto transform = openvdb::math::Transform::createLinearTransform(size);
    const auto background = static_cast<float>(3.0 * size);
    // The distance to the planes of a body is the distance to the surface, except outside near
    // edges.
    const auto grid_of = [&](const Body& body, const Box& box) {
        Grid::Ptr grid = Grid::create(background);
        grid->setTransform(transform);
        grid->setGridClass(openvdb::GRID_LEVEL_SET);
        auto accessor = grid->getAccessor();
        const auto index = [&](double mm, double more) {
            return static_cast<int>(std::floor(mm / size + more));
        };
        for (int x = index(box.min.x, -3); x <= index(box.max.x, 4); ++x) {
            for (int y = index(box.min.y, -3); y <= index(box.max.y, 4); ++y) {
                for (int z = index(box.min.z, -3); z <= index(box.max.z, 4); ++z) {
                    const Vec3 p{x * size, y * size, z * size};
                    double away = -1e9;
                    for (const Halfspace& h : body)
                        away = std::max(away, dot(h.n, p) - h.d);
                    const auto value = static_cast<float>(away);
                    const openvdb::Coord at(x, y, z);
                    if (std::abs(value) < background) {
                        accessor.setValue(at, value);
                    } else if (value < 0.0F) {
                        accessor.setValueOff(at, -background);
                    }
                }
            }
        }
        return grid;
    };
    Grid::Ptr part = grid_of(box_body(work.stock), work.stock);
    for (std::size_t i = 0; i < work.bodies.size(); ++i) {
        // Omits the part of the tool that is far from the stock.
        Box box = work.bounds[i];
        for (int axis = 0; axis < 3; ++axis) {
            box.min[axis] = std::max(box.min[axis], work.stock.min[axis] - 3 * size);
            box.max[axis] = std::min(box.max[axis], work.stock.max[axis] + 3 * size);
        }
        openvdb::tools::csgDifference(*part, *grid_of(work.bodies[i], box));
    }
    return part;
}

// Returns the surface, with two triangles per quad.
cda::Boundary surface_of(const Grid& part) {
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec4I> quads;
    openvdb::tools::volumeToMesh(part, points, quads);
    cda::Boundary boundary;
    boundary.shells = 1;
    for (const openvdb::Vec3s& p : points) {
        const openvdb::Vec3d q(p);
        boundary.vertices.push_back({q.x(), q.y(), q.z()});
    }
    // Quads of OpenVDB have the material on their left.
    for (const openvdb::Vec4I& q : quads) {
        for (const auto& t : {std::array{q[0], q[2], q[1]}, std::array{q[0], q[3], q[2]}}) {
            const auto& v = boundary.vertices;
            const Vec3 across = cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]);
            if (norm(across) == 0.0) continue;
            cda::BoundaryFace face;
            face.normal = normalized(across);
            face.offset = dot(face.normal, v[t[0]]);
            face.loops = {{t[0], t[1], t[2]}};
            boundary.faces.push_back(std::move(face));
        }
    }
    return boundary;
}

void voxels(const Work& work, double size) {
    const double start = cpu_seconds();
    const Grid::Ptr part = voxel_part(work, size);
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec4I> quads;
    openvdb::tools::volumeToMesh(*part, points, quads);
    const double seconds = cpu_seconds() - start;
    print(work, fmt::format("voxels {} mm (OpenVDB)", size), seconds,
          fmt::format("{} MB of grid", part->memUsage() >> 20),
          openvdb::tools::levelSetVolume(*part), fmt::format("{} quads", quads.size()));
}
#endif

// Draws the same part in several models, with the same camera.
void picture(const std::string& program, const std::string& path) {
    const Work work = work_of(bench::hulls_of(program), ~std::size_t{0});
    constexpr double kSize = 0.05;  // mm
    constexpr std::uint32_t kWidth = 480, kHeight = 400;
    exporter::RenderOptions render;
    render.width = kWidth;
    render.height = kHeight;
    render.camera = exporter::fit_camera(work.stock, exporter::View::Iso,
                                         static_cast<double>(kWidth) / kHeight);
    std::vector<exporter::LabelledImage> pictures;
    const auto add = [&](const std::string& label, const cda::Boundary& boundary) {
        pictures.push_back({label, exporter::render_boundary(boundary, {}, render)});
    };
    const bench::Hulls hulls = bench::hulls_of(program);
    const auto cut = [&](const cda::WorkpieceModel& prototype) {
        auto part = prototype.create(hulls.stock_cell(), hulls.lattice);
        part->subtract_unmeasured(hulls.cells);
        return part->boundary();
    };
    add("cda", cut(cda::TreeCda()));
    using dexel::Directions;
    using dexel::Mesher;
    add("dexel, xyz", cut(dexel::Dexel({1, kSize, Directions::Three, Mesher::DualContouring})));
    add("dexel, z", cut(dexel::Dexel({1, kSize, Directions::OnlyZ, Mesher::DualContouring})));
    add("dexel, marching cubes",
        cut(dexel::Dexel({1, kSize, Directions::Three, Mesher::MarchingCubes})));
#ifdef NCSIM_HAS_OPENVDB
    add("voxels (OpenVDB)", surface_of(*voxel_part(work, kSize)));
#endif
    std::ofstream file(path, std::ios::binary);
    exporter::write_png(file, exporter::contact_sheet(pictures, {}));
}

#ifdef NCSIM_HAS_OCCT
TopoDS_Shape solid_of(const Body& body) {
    // Edges shorter than the sewing tolerance become edges without length, which OpenCASCADE cannot
    // cut.
    constexpr double kSewn = 1e-6, kShortest = 2e-6;  // mm
    BRepBuilderAPI_Sewing sewing(kSewn);
    for (const Polygon& p : polygons_of(body)) {
        BRepBuilderAPI_MakePolygon outline;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3& before = p[(i + p.size() - 1) % p.size()];
            if (norm(p[i] - before) > kShortest) outline.Add(gp_Pnt(p[i].x, p[i].y, p[i].z));
        }
        outline.Close();
        BRepBuilderAPI_MakeFace face(outline.Wire(), true);
        if (face.IsDone()) sewing.Add(face.Face());
    }
    sewing.Perform();
    TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL);
    if (!shells.More()) throw std::runtime_error("a hull is no shell");
    TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shells.Current())).Solid();
    BRepLib::OrientClosedSolid(solid);
    return solid;
}

double volume_of(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return std::abs(properties.Mass());
}

void cad_kernel(const Work& work) {
    TopoDS_Shape part = solid_of(box_body(work.stock));
    const double start = cpu_seconds();
    std::size_t failed = 0;
    for (const Body& body : work.bodies) {
        BRepAlgoAPI_Cut cut(part, solid_of(body));
        if (!cut.IsDone() || cut.HasErrors()) {
            ++failed;
            continue;
        }
        part = cut.Shape();
    }
    const double seconds = cpu_seconds() - start;
    const bool is_valid = BRepCheck_Analyzer(part).IsValid();
    print(work, fmt::format("CAD kernel (OpenCASCADE), {} hulls", work.bodies.size()), seconds, "-",
          volume_of(part),
          fmt::format("{} cuts failed; {}", failed, is_valid ? "valid" : "NOT valid"));
}
#endif

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::string> names(argv + 1, argv + argc);
        if (names.size() == 3 && names[0] == "--picture") {
            picture(names[1], names[2]);
            return 0;
        }
        if (names.empty()) {
            names = {NCSIM_SOURCE_DIR "/samples/simple.nc", NCSIM_SOURCE_DIR "/samples/complex.nc",
                     "wave-100", "wave-900"};
        }
        fmt::print(
            "| program | system | hulls | µs a hull | all, s | MB | size | volume - exact, mm³ | "
            "|\n"
            "|---|---|---|---|---|---|---|---|---|\n");
        for (const std::string& name : names) {
            const bench::Hulls hulls = bench::hulls_of(name);
            const Work work = work_of(hulls, hulls.cells.size());
            const auto apart = [&](const char* title, const std::function<void()>& measure) {
                constexpr unsigned kSeconds = 300;
                bench::apart(work.name + " | " + title, kSeconds, measure);
            };
            apart("BSP tree", [&] { bsp(work); });
#ifdef NCSIM_HAS_OPENVDB
            for (const double size : {0.5, 0.2})
                apart("voxels", [&] { voxels(work, size); });
#endif
#ifdef NCSIM_HAS_OCCT
            constexpr std::size_t kMostCuts = 50;
            apart("CAD kernel", [&] { cad_kernel(work_of(hulls, kMostCuts)); });
#endif
        }
    } catch (const std::exception& e) {
        std::fprintf(stderr, "other_models: %s\n", e.what());
        return 2;
    }
    return 0;
}
