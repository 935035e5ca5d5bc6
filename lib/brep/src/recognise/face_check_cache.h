// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cache of the checks of faces. Most faces do not change between rounds, and a result remains valid
// while the surface and the edges of the face are the same.
#pragma once

#include "ncsim/brep/measure.h"
#include "ncsim/brep/part.h"

#include "query/part_check.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ncsim::brep {

class FaceCheckCache {
public:
    /// All measures refer to `apex`.
    explicit FaceCheckCache(Vec3 apex) : apex_(apex) {}

    struct Entry {
        Measure measure;  ///< Measured from the apex.
        /// Tolerance of the last check; the results below belong to it.
        std::optional<double> tolerance_mm;
        bool is_faulty = false;
        double miss_mm = 0.0;
        /// Places of the faults, as numbers of loops and of uses in the loop; empty if unknown.
        std::vector<std::pair<std::size_t, std::size_t>> fault_at;

    private:
        friend class FaceCheckCache;
        struct Piece {
            Vec3 from, to;
            Curve curve;
            bool is_forward;
            bool operator==(const Piece&) const = default;
        };
        Surface surface_;
        std::vector<std::vector<Piece>> loops_;
        std::size_t outline_ = 0;
        Frame frame_;
    };

    /// Returns the entry of a face, which stays valid. Sets the frame of the face, and makes the
    /// outline of a plane the first loop. `name` identifies the face in all rounds.
    Entry& lookup(const Part& part, Face& face, std::uint32_t name);
    /// Returns true if the face has faults within the tolerance, as faults_of(). Sets `miss_mm` to
    /// the larger of itself and the largest deviation of the edges. The clearance is `clear_mm`, or
    /// this deviation if smaller.
    /// Requires: equal tolerances of a face come with equal clearances.
    static bool is_faulty(Entry& entry, const Part& part, std::uint32_t face, double tolerance_mm,
                          double clear_mm, double& miss_mm);

private:
    Vec3 apex_;
    std::unordered_map<std::uint32_t, Entry> entries_;
};

}  // namespace ncsim::brep
