// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/apart.h"

namespace ncsim::brep {

void keep_apart(Part& part) {
    constexpr double kShort = 3e-7, kLeast = 1e-5;  // mm
    // One may bring another one's ends nearer.
    constexpr int kPasses = 3;
    for (int pass = 0; pass < kPasses; ++pass) {
        for (const Edge& edge : part.edges) {
            Vec3 &a = part.vertices[edge.from], &b = part.vertices[edge.to];
            const double length = cda::norm(b - a);
            if (length >= kShort || length == 0.0) continue;
            const Vec3 move = (0.5 * (kLeast - length) / length) * (b - a);
            a = a - move;
            b = b + move;
        }
    }
}

}  // namespace ncsim::brep
