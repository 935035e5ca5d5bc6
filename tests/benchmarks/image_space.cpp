// SPDX-License-Identifier: GPL-3.0-or-later
//
// image_space [PROGRAM…]: measures image space (thesis 2.3). OpenCSG subtracts the hulls of a
// program from its stock in the depth buffer, for a single picture. The table also has the cost of
// the exact boundary and its picture. Depth and normal of every pixel are compared with the
// boundary, drawn by the same OpenGL. Mesa renders on the processor, with a single thread.
#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/render.h"

#include "hulls.h"
#include "measure.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glew.h>
#include <fmt/format.h>
#include <opencsg.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace ncsim;

constexpr int kWidth = 1024, kHeight = 768;
constexpr unsigned kSeconds = 120;

// Makes an OpenGL context without a window. Its surface is a picture in memory.
void make_context() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE ||
        eglBindAPI(EGL_OPENGL_API) != EGL_TRUE)
        throw std::runtime_error("EGL has no OpenGL without a surface");
    const std::array<EGLint, 15> wanted{EGL_SURFACE_TYPE,
                                        EGL_PBUFFER_BIT,
                                        EGL_RENDERABLE_TYPE,
                                        EGL_OPENGL_BIT,
                                        EGL_RED_SIZE,
                                        8,
                                        EGL_GREEN_SIZE,
                                        8,
                                        EGL_BLUE_SIZE,
                                        8,
                                        EGL_DEPTH_SIZE,
                                        24,
                                        EGL_STENCIL_SIZE,
                                        8,
                                        EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &found) != EGL_TRUE || found == 0)
        throw std::runtime_error("EGL has no pixel buffers with depth and stencil");
    const std::array<EGLint, 5> size{EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size.data());
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (surface == EGL_NO_SURFACE || context == EGL_NO_CONTEXT ||
        eglMakeCurrent(display, surface, surface, context) != EGL_TRUE)
        throw std::runtime_error("EGL gives no OpenGL context");
    // The last step of glewInit() fails without an X display, after all that is needed here.
    const GLenum status = glewInit();
    constexpr GLenum kNoDisplay = 4;
    if (status != GLEW_OK && status != kNoDisplay)
        throw std::runtime_error(reinterpret_cast<const char*>(glewGetErrorString(status)));
    if (GLEW_ARB_framebuffer_object == 0 && GLEW_EXT_framebuffer_object == 0)
        throw std::runtime_error("OpenGL has no framebuffer objects, which OpenCSG needs");
    glViewport(0, 0, kWidth, kHeight);
}

// Triangles, counter-clockwise seen from outside, in coordinates of the camera, with normals as
// colours.
struct Triangles {
    std::vector<float> points;
    std::vector<std::uint8_t> colours;

    void add(const std::array<Vec3, 3>& corners, Vec3 normal) {
        for (const Vec3& p : corners) {
            for (int axis = 0; axis < 3; ++axis) {
                points.push_back(static_cast<float>(p[axis]));
                colours.push_back(
                    static_cast<std::uint8_t>(std::lround(127.5 * (1.0 + normal[axis]))));
            }
        }
    }
    void draw(bool coloured) const {
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, points.data());
        if (coloured) {
            glEnableClientState(GL_COLOR_ARRAY);
            glColorPointer(3, GL_UNSIGNED_BYTE, 0, colours.data());
        }
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(points.size() / 3));
        glDisableClientState(GL_COLOR_ARRAY);
        glDisableClientState(GL_VERTEX_ARRAY);
    }
};

// Orthographic projection with x, y, z from -1 to 1.
class Screen {
public:
    explicit Screen(const exporter::Camera& camera) : camera_(camera) {}
    Vec3 operator()(Vec3 p) const {
        const Vec3 q = p - camera_.target;
        const double high = 2.0 / camera_.height;
        return {dot(q, camera_.right) * high * kHeight / kWidth, dot(q, camera_.up) * high,
                -dot(q, camera_.back) / camera_.depth};
    }
    /// Returns the difference in depth of pixels, which is from 0 to 1, for a distance in mm.
    float depth_of(double mm) const { return static_cast<float>(0.5 * mm / camera_.depth); }

private:
    exporter::Camera camera_;
};

class Convex : public OpenCSG::Primitive {
public:
    Convex(OpenCSG::Operation operation, const cda::ConvexPolytope& body,
           const cda::Lattice& lattice, const Screen& screen)
        : Primitive(operation, 1) {
        // The walls of a subtracted body are seen from inside.
        const double sign = operation == OpenCSG::Subtraction ? -1.0 : 1.0;
        Box box;
        std::vector<Vec3> corners;
        for (const cda::ExactPoint& v : body.vertices()) {
            corners.push_back(screen(lattice.to_mm(v.approx)));
            box.add(corners.back());
        }
        for (const auto& facet : body.facets()) {
            const Vec3 normal = sign * cda::unit_normal(facet.plane);
            for (std::size_t k = 1; k + 1 < facet.vertices.size(); ++k) {
                triangles_.add({corners[facet.vertices[0]], corners[facet.vertices[k]],
                                corners[facet.vertices[k + 1]]},
                               normal);
            }
        }
        const auto f = [](double v) { return static_cast<float>(std::clamp(v, -1.0, 1.0)); };
        setBoundingBox(f(box.min.x), f(box.min.y), f(box.min.z), f(box.max.x), f(box.max.y),
                       f(box.max.z));
    }
    void render() override { triangles_.draw(false); }
    void shade() const { triangles_.draw(true); }

private:
    Triangles triangles_;
};

struct Picture {
    std::vector<std::uint8_t> colours =
        std::vector<std::uint8_t>(std::size_t{4} * kWidth * kHeight);
    std::vector<float> depths = std::vector<float>(std::size_t{kWidth} * kHeight);
};

void begin_picture() {
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glClearStencil(0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glShadeModel(GL_FLAT);
    glDisable(GL_DITHER);
    // Visible faces are counter-clockwise, and z grows away from the eye without a projection.
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

Picture read_picture() {
    Picture picture;
    glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, picture.colours.data());
    glReadPixels(0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_FLOAT, picture.depths.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error(fmt::format("OpenGL error {:#x}", error));
    return picture;
}

Picture picture_of(const cda::Boundary& boundary, const Screen& screen) {
    const TriangleMesh mesh = cda::triangulate(boundary);
    Triangles triangles;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        triangles.add(
            {screen(mesh.vertices[a]), screen(mesh.vertices[b]), screen(mesh.vertices[c])},
            boundary.faces[mesh.face[t]].normal);
    }
    begin_picture();
    glDepthFunc(GL_LESS);
    glEnable(GL_CULL_FACE);
    triangles.draw(true);
    return read_picture();
}

// Differences of pictures, in pixels. A pixel next to an edge in either picture may show either
// surface; `inner` does not count that difference.
struct Difference {
    std::size_t part = 0, different = 0, inner = 0;
};

Difference compare(const Picture& exact, const Picture& other, float most) {
    const auto index = [](int x, int y) {
        return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
    };
    const auto same = [most](const Picture& p, std::size_t i, const Picture& q, std::size_t k) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            if (std::abs(p.colours[4 * i + channel] - q.colours[4 * k + channel]) > 2) return false;
        }
        return std::abs(p.depths[i] - q.depths[k]) < most;
    };
    Difference difference;
    for (int y = 1; y + 1 < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
            const std::size_t i = index(x, y);
            if (exact.depths[i] >= 1.0F && other.depths[i] >= 1.0F) continue;
            ++difference.part;
            if (same(exact, i, other, i)) continue;
            ++difference.different;
            bool is_near = false;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx)
                    is_near |= same(exact, index(x + dx, y + dy), other, i) ||
                               same(exact, i, other, index(x + dx, y + dy));
            }
            difference.inner += !is_near;
        }
    }
    return difference;
}

void write_ppm(const std::string& name, const Picture& picture) {
    std::FILE* file = std::fopen(name.c_str(), "wb");
    if (file == nullptr) throw std::runtime_error(name + " cannot be written");
    std::fprintf(file, "P6\n%d %d\n255\n", kWidth, kHeight);
    for (int y = kHeight - 1; y >= 0; --y) {
        for (int x = 0; x < kWidth; ++x)
            std::fwrite(&picture.colours[4 * (static_cast<std::size_t>(y) * kWidth +
                                              static_cast<std::size_t>(x))],
                        1, 3, file);
    }
    std::fclose(file);
}

struct Method {
    const char* name;
    OpenCSG::Algorithm algorithm;
    OpenCSG::DepthComplexityAlgorithm sampling;
};

void draw_by_opencsg(const bench::Hulls& hulls, const cda::Boundary& boundary,
                     const exporter::Camera& camera, const Method& method) {
    make_context();
    const std::vector<cda::ConvexPolytope> cut = bench::bodies_of(hulls, bench::Within::Lattice);
    // All of a tool has to be between the clipping planes of OpenGL, or its walls are counted
    // wrongly.
    exporter::Camera whole = camera;
    for (const cda::ConvexPolytope& body : cut) {
        for (const cda::ExactPoint& v : body.vertices()) {
            const Vec3 q = hulls.lattice.to_mm(v.approx) - camera.target;
            whole.depth = std::max(whole.depth, 1.01 * std::abs(dot(q, camera.back)));
        }
    }
    const Screen screen(whole);
    const Picture exact = picture_of(boundary, screen);
    std::vector<std::unique_ptr<Convex>> bodies;
    bodies.push_back(std::make_unique<Convex>(
        OpenCSG::Intersection, *cda::ConvexPolytope::of(hulls.stock_cell(), hulls.lattice),
        hulls.lattice, screen));
    for (const cda::ConvexPolytope& body : cut)
        bodies.push_back(
            std::make_unique<Convex>(OpenCSG::Subtraction, body, hulls.lattice, screen));
    std::vector<OpenCSG::Primitive*> primitives;
    for (const auto& body : bodies)
        primitives.push_back(body.get());
    OpenCSG::setOption(OpenCSG::AlgorithmSetting, method.algorithm);
    OpenCSG::setOption(OpenCSG::DepthComplexitySetting, method.sampling);
    double seconds = 0.0;
    Picture picture;
    // The first picture loads resources; the second is measured.
    for (int turn = 0; turn < 2; ++turn) {
        const double start = bench::cpu_seconds();
        begin_picture();
        OpenCSG::render(primitives);
        glDepthFunc(GL_EQUAL);
        glEnable(GL_CULL_FACE);
        for (const auto& body : bodies) {
            glCullFace(body->getOperation() == OpenCSG::Subtraction ? GL_FRONT : GL_BACK);
            body->shade();
        }
        glCullFace(GL_BACK);
        picture = read_picture();
        seconds = bench::cpu_seconds() - start;
        // A slow picture is not drawn twice.
        constexpr double kLong = 10.0;
        if (seconds > kLong) break;
    }
    if (const char* folder = std::getenv("NCSIM_PICTURES")) {
        write_ppm(fmt::format("{}/{}, exact.ppm", folder, hulls.name), exact);
        write_ppm(fmt::format("{}/{}, {}.ppm", folder, hulls.name, method.name), picture);
    }
    constexpr double kSameDepth = 0.02;  // mm
    const Difference difference = compare(exact, picture, screen.depth_of(kSameDepth));
    fmt::print("| {} | {} | {} | - | {:.2f} | {} | {:.2f} % | {:.3f} % |\n", hulls.name,
               bodies.size() - 1, method.name, seconds, difference.part,
               100.0 * static_cast<double>(difference.different) /
                   static_cast<double>(std::max<std::size_t>(difference.part, 1)),
               100.0 * static_cast<double>(difference.inner) /
                   static_cast<double>(std::max<std::size_t>(difference.part, 1)));
}

void draw_boundary(const bench::Hulls& hulls, const cda::Boundary& boundary, double cutting,
                   const exporter::Camera& camera) {
    exporter::RenderOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.camera = camera;
    options.samples = 1;
    mesh::Provenance provenance;
    provenance.entries = {{0, 0}, {1, 1}};
    double seconds = 0.0;
    for (int turn = 0; turn < 2; ++turn) {
        const double start = bench::cpu_seconds();
        exporter::render_boundary(boundary, provenance, options);
        seconds = bench::cpu_seconds() - start;
    }
    fmt::print("| {} | {} | exact boundary | {:.2f} | {:.2f} | - | - | - |\n", hulls.name,
               hulls.cells.size(), cutting, seconds);
}

}  // namespace

int main(int argc, char** argv) {
    // Mesa has a single thread, like ncsim.
    ::setenv("LP_NUM_THREADS", "0", 1);
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    try {
        std::vector<std::string> names(argv + 1, argv + argc);
        if (names.empty())
            names = {"wave-100", "pocket-100", "wave-1000", "pocket-1000", "wave-3000"};
        const std::array methods{
            Method{"OpenCSG, SCS", OpenCSG::SCS, OpenCSG::NoDepthComplexitySampling},
            Method{"OpenCSG, SCS, occlusion queries", OpenCSG::SCS, OpenCSG::OcclusionQuery},
            Method{"OpenCSG, Goldfeather", OpenCSG::Goldfeather,
                   OpenCSG::NoDepthComplexitySampling}};
        fmt::print(
            "| program | hulls | picture by | to the boundary, s | a picture, s | pixels of "
            "the part | of them different | and not at an edge |\n"
            "|---|---|---|---|---|---|---|---|\n");
        for (const std::string& name : names) {
            const bench::Hulls hulls = bench::hulls_of(name);
            const exporter::Camera camera = exporter::fit_camera(
                hulls.stock, exporter::View::Iso, static_cast<double>(kWidth) / kHeight);
            const double start = bench::cpu_seconds();
            cda::TreeParameters parameters;
            parameters.threads = 1;
            cda::TreeCda part(hulls.stock_cell(), hulls.lattice, parameters);
            part.subtract_unmeasured(hulls.cells);
            const cda::Boundary boundary = part.boundary();
            const double cutting = bench::cpu_seconds() - start;
            bench::apart(fmt::format("{} | {} | exact boundary", hulls.name, hulls.cells.size()),
                         kSeconds, [&] { draw_boundary(hulls, boundary, cutting, camera); });
            for (const Method& method : methods)
                bench::apart(
                    fmt::format("{} | {} | {}", hulls.name, hulls.cells.size(), method.name),
                    kSeconds, [&] { draw_by_opencsg(hulls, boundary, camera, method); });
        }
    } catch (const std::exception& e) {
        std::fprintf(stderr, "image_space: %s\n", e.what());
        return 2;
    }
    return 0;
}
