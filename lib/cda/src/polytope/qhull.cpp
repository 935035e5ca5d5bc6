// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interface to the reentrant qhull library.
#include "polytope/qhull.h"

#include <algorithm>
#include <cstdio>
#include <memory>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace ncsim::cda {

namespace {

// Returns a sink for the messages of qhull; the return code indicates failure.
std::FILE* null_sink() {
    static const std::unique_ptr<std::FILE, int (*)(std::FILE*)> sink(
        std::fopen("/dev/null", "w"), [](std::FILE* f) { return f ? std::fclose(f) : 0; });
    return sink.get();
}

// Frees a qhT in any state, also after an error.
struct Session {
    qhT qh{};
    Session() { qh_zero(&qh, null_sink()); }
    ~Session() {
        qh.NOerrexit = True;
        qh_freeqhull(&qh, !qh_ALL);
        int unfreed = 0;
        int bytes = 0;
        qh_memfreeshort(&qh, &unfreed, &bytes);
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
};

}  // namespace

std::optional<HullFacets> quickhull(std::span<const Vec3> points) {
    if (points.size() < 4) return std::nullopt;
    std::vector<coordT> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Vec3& p : points)
        coordinates.insert(coordinates.end(), {p.x, p.y, p.z});

    Session session;
    qhT* qh = &session.qh;
    char options[] = "qhull";
    const int failed = qh_new_qhull(qh, 3, static_cast<int>(points.size()), coordinates.data(),
                                    False, options, null_sink(), null_sink());
    if (failed != 0) return std::nullopt;

    HullFacets hull;
    facetT* facet = nullptr;
    FORALLfacets {
        setT* corners = qh_facet3vertex(qh, facet);
        std::vector<std::uint32_t> loop;
        vertexT* vertex = nullptr;
        vertexT** vertexp = nullptr;
        FOREACHvertex_(corners) {
            loop.push_back(static_cast<std::uint32_t>(qh_pointid(qh, vertex->point)));
        }
        qh_settempfree(qh, &corners);
        // qhull orders corners clockwise seen from outside (qh_ORIENTclock).
        std::reverse(loop.begin(), loop.end());
        hull.loops.push_back(std::move(loop));
    }
    return hull;
}

}  // namespace ncsim::cda
