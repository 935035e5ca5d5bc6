// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of a program: stated accuracy, threads, models, points and lines.
#include "nightly/examine.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"

#include "nightly/judge.h"
#include "nightly/surface.h"
#include "support/random.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace ncsim::nightly {

namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw std::runtime_error(what);
}

std::string text_of(const Vec& p) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, "(%.17g, %.17g, %.17g)", p[0], p[1], p[2]);
    return buffer;
}

Vec vec_of(const Vec3& v) {
    return {v.x, v.y, v.z};
}

std::vector<Vec> vertices_of(const std::vector<Vec3>& vertices) {
    std::vector<Vec> all;
    all.reserve(vertices.size());
    for (const Vec3& v : vertices)
        all.push_back(vec_of(v));
    return all;
}

Surface polygons_of(const cda::Boundary& boundary) {
    Surface surface{vertices_of(boundary.vertices), {}};
    for (const cda::BoundaryFace& face : boundary.faces)
        surface.loops.insert(surface.loops.end(), face.loops.begin(), face.loops.end());
    return surface;
}

Surface triangles_of(const TriangleMesh& mesh) {
    Surface surface{vertices_of(mesh.vertices), {}};
    for (const auto& t : mesh.triangles)
        surface.loops.push_back({t[0], t[1], t[2]});
    return surface;
}

class Examination {
public:
    Examination(const Program& program, const ProgramFile& file)
        : program_(program),
          file_(file),
          random_(program.seed ^ 0x6f7261636c65ULL),
          simulation_(file.run(program, {"--threads=1"})),
          stated_(stated_accuracy(simulation_, program)),
          judge_(program, stated_),
          boundary_(simulation_.part->boundary()),
          mesh_(cda::triangulate(boundary_)),
          triangles_(triangles_of(mesh_)) {
        const Vec size = program.stock.max - program.stock.min;
        stock_volume_ = size[0] * size[1] * size[2];
    }

    Tally operator()() {
        tally_.hulls = simulation_.hulls;
        stated();
        surface();
        threads();
        flat();
        points();
        lines();
        return tally_;
    }

private:
    // --- Checks without oracle ---

    void stated() const {
        require(stated_.unit == lattice_unit(program_.stock), "the lattice is another one");
        // For an arc with rotary moves both tolerances add up.
        const double t = program_.tolerance_mm;
        require(stated_.missed <= 2 * t * (1 + 1e-12),
                "arcs or turns miss more than the tolerance");
        require(stated_.gained <= 11 * t * (1 + 1e-12), "arcs or turns gain more than they may");
        for (std::size_t i = 0; i < program_.tools.size(); ++i) {
            // The tool error may exceed a tolerance that polygons on the lattice cannot keep
            // (tool_polytope.h).
            const double tolerance = program_.tool_tolerance_mm;
            const double r = program_.tools[i].radius();
            const double units = program_.tools[i].is_whole_ball() ? 4 : 2;
            if (tolerance < std::max(r / 1000, units * std::sqrt(r * stated_.unit))) continue;
            require(stated_.tool_error[i] <= tolerance, "a tool is coarser than its tolerance");
        }
    }

    void surface() const {
        const Surface polygons = polygons_of(boundary_);
        require(is_closed(polygons), "the surface is not closed");
        require(is_closed(triangles_), "the mesh is not closed");
        const double volume = simulation_.part->volume();
        const double slack = 1e-9 * stock_volume_;
        require(std::abs(enclosed_volume(polygons) - volume) <= slack,
                "the volume of the surface is not that of the part");
        require(std::abs(enclosed_volume(triangles_) - volume) <= slack,
                "the volume of the mesh is not that of the part");
        require(volume >= -slack && volume <= simulation_.stock_volume + slack,
                "the volume is none that the stock can have");
    }

    void threads() const {
        const std::uint64_t hash = hash_of(boundary_);
        for (const char* option : {"--threads=2", "--threads=8"}) {
            const simulation::Simulation other = file_.run(program_, {option});
            require(hash_of(other.part->boundary()) == hash,
                    std::string(option) + ": another surface");
        }
    }

    // The cost is quadratic in the number of overlapping hulls, so only small programs are
    // compared.
    void flat() {
        constexpr std::uint64_t kMostPlanes = 2500;
        const auto& tree = dynamic_cast<const cda::TreeCda&>(*simulation_.part);
        if (tree.counts().planes > kMostPlanes || simulation_.hulls > 40) return;
        tally_.flat = 1;
        flat_ = file_.run(program_, {"--model=cda-flat"}).part;
        const cda::Boundary boundary = flat_->boundary();
        require(boundary.vertices == boundary_.vertices, "cda-flat: other corners");
        require(hash_of(boundary) == hash_of(boundary_), "cda-flat: other faces");
        require(std::abs(flat_->volume() - simulation_.part->volume()) <= 1e-9 * stock_volume_,
                "cda-flat: another volume");
    }

    // --- Points ---

    Verdict judge(const Vec& p) {
        const Verdict verdict = judge_(p);
        ++tally_.points;
        if (verdict == Verdict::Open) return verdict;
        ++tally_.certain;
        if (verdict == Verdict::Material) ++tally_.material;
        const bool expected = verdict == Verdict::Material;
        const auto complain = [&](const char* who) {
            throw std::runtime_error(std::string(who) + " is wrong about the point " + text_of(p) +
                                     ": it must be " + judge_.explain(p));
        };
        if (simulation_.part->contains({p[0], p[1], p[2]}) != expected) complain("the part");
        if (flat_ && flat_->contains({p[0], p[1], p[2]}) != expected) complain("cda-flat");
        // The mesh is checked less often, because the cost is linear in the number of triangles.
        if (triangles_.loops.size() < 400 || random_.one_in(8)) {
            ++tally_.asked_of_mesh;
            // An integer up to rounding, which is largest next to walls of a few nanometres.
            const double turns = winding_number(triangles_, p);
            if (std::abs(turns - (expected ? 1.0 : 0.0)) > 0.25) complain("the mesh");
        }
        return verdict;
    }

    // Returns a distance from 0.1 lattice units to several times the tolerances.
    double aside(double allowed) {
        const double least = 0.1 * stated_.unit;
        const double most = std::max(5 * allowed, 100 * stated_.unit);
        const double distance = least * std::pow(most / least, random_.unit());
        return random_.one_in(2) ? distance : -distance;
    }

    Vec random_direction() {
        while (true) {
            const Vec v{random_.within(-1, 1), random_.within(-1, 1), random_.within(-1, 1)};
            if (const double n = norm(v); n > 0.1 && n < 1.0) return (1 / n) * v;
        }
    }

    double largest_allowance() const {
        double most = stated_.unit;
        for (std::size_t i = 0; i < program_.moves.size(); ++i)
            most = std::max(most, judge_.allowance(i).beyond());
        return most;
    }

    void points() {
        for (const Vec& p : program_.probes)
            judge(p);
        near_surface();
        near_sweeps();
        anywhere();
    }

    // Next to the mesh: finds material that should not exist.
    void near_surface() {
        if (mesh_.triangles.empty()) return;
        const double allowed = largest_allowance();
        for (int i = 0; i < 200; ++i) {
            const auto& t = mesh_.triangles[random_.next() % mesh_.triangles.size()];
            const Vec a = vec_of(mesh_.vertices[t[0]]);
            const Vec b = vec_of(mesh_.vertices[t[1]]);
            const Vec c = vec_of(mesh_.vertices[t[2]]);
            double u = random_.unit();
            double v = random_.unit();
            if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
            Vec n = cross(b - a, c - a);
            const double length = norm(n);
            n = length > 0.0 ? (1 / length) * n : random_direction();
            judge(a + u * (b - a) + v * (c - a) + aside(allowed) * n);
        }
    }

    // Next to the tools on their paths: finds missing material.
    void near_sweeps() {
        for (std::size_t i = 0; i < program_.moves.size(); ++i) {
            const Move& move = program_.moves[i];
            const RoundTool& tool = program_.tools[move.tool];
            for (int k = 0; k < 12; ++k) {
                const double t = k == 0 ? 0.0 : k == 1 ? 1.0 : random_.unit();
                const Vec on = tool.surface_point(random_.unit(), random_.unit());
                const Vec p_T = on + aside(judge_.allowance(i).beyond()) * random_direction();
                judge(move.course.to_workpiece(t, p_T));
            }
            const Vec inside = random_.unit() * tool.surface_point(random_.unit(), random_.unit());
            judge(move.course.to_workpiece(random_.unit(), inside));
        }
    }

    // Random points in the stock; certain points bound the volume.
    void anywhere() {
        constexpr int kCount = 200;
        int material = 0;
        int empty = 0;
        for (int i = 0; i < kCount; ++i) {
            Vec p{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                p[axis] = random_.within(program_.stock.min[axis], program_.stock.max[axis]);
            const Verdict verdict = judge(p);
            material += verdict == Verdict::Material ? 1 : 0;
            empty += verdict == Verdict::Empty ? 1 : 0;
        }
        // Hoeffding: a mean of n independent values deviates from the expectation by more than d
        // with probability at most exp(-2nd²).
        constexpr double kOnceIn1e12 = 0.263;  // sqrt(ln 1e12 / (2 · 200))
        const double share = simulation_.part->volume() / stock_volume_;
        require(share >= static_cast<double>(material) / kCount - kOnceIn1e12,
                "the volume is less than certain points allow");
        require(share <= 1.0 - static_cast<double>(empty) / kCount + kOnceIn1e12,
                "the volume is more than certain points allow");
    }

    // --- Lines of faces ---

    void lines() {
        if (mesh_.triangles.empty()) return;
        for (int i = 0; i < 20; ++i) {
            const std::size_t at = random_.next() % mesh_.triangles.size();
            const auto& t = mesh_.triangles[at];
            const Vec p = (1.0 / 3) * (vec_of(mesh_.vertices[t[0]]) + vec_of(mesh_.vertices[t[1]]) +
                                       vec_of(mesh_.vertices[t[2]]));
            const auto entry = simulation_.provenance.of(boundary_.faces[mesh_.face[at]].origin);
            if (entry.nc_line == 0) continue;
            ++tally_.lines;
            bool touches = false;
            for (std::size_t m = 0; m < program_.moves.size(); ++m) {
                if (program_.moves[m].line != entry.nc_line) continue;
                if (program_.moves[m].tool + 1 != entry.tool) continue;
                const auto is_there = [&](std::size_t move, double beside) {
                    const double allowed = judge_.allowance(move).beyond() + stated_.unit;
                    return judge_.distance(move, p).lower <= allowed + beside;
                };
                touches |= is_there(m, 0.0);
                // For a straight path in pieces or a whole turn, the face may belong to an earlier
                // move of the path. Then the named move was at most a tool width away.
                const double width = 2.0 * program_.tools[program_.moves[m].tool].radius();
                for (std::size_t k = m; !touches && k-- > 0;) {
                    if (program_.moves[k].tool != program_.moves[m].tool || !is_there(m, width))
                        break;
                    touches = is_there(k, 0.0);
                }
            }
            require(touches, "the surface at " + text_of(p) + " says it was cut by line " +
                                 std::to_string(entry.nc_line) + ", which was not there");
        }
    }

    const Program& program_;
    const ProgramFile& file_;
    test::Random random_;
    simulation::Simulation simulation_;
    std::unique_ptr<cda::WorkpieceModel> flat_;  // null if not compared
    StatedAccuracy stated_;
    Judge judge_;
    cda::Boundary boundary_;
    TriangleMesh mesh_;
    Surface triangles_;
    double stock_volume_ = 0.0;
    Tally tally_;
};

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
    hulls += other.hulls;
    flat += other.flat;
    points += other.points;
    certain += other.certain;
    material += other.material;
    asked_of_mesh += other.asked_of_mesh;
    lines += other.lines;
    return *this;
}

Tally examine(const Program& program, const ProgramFile& file) {
    return Examination(program, file)();
}

}  // namespace ncsim::nightly
