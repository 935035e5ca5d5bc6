// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round by round most faces stay what they are. What was found out about one stays true as long as
// its surface and its edges are the same.
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
    /// Measures are from `apex`.
    explicit FaceCheckCache(Vec3 apex) : apex_(apex) {}

    struct Entry {
        Measure measure;  ///< From the apex.
        /// Of the last check: within what, was anything found, and what do its edges miss?
        std::optional<double> tolerance_mm;
        bool is_faulty = false;
        double miss_mm = 0.0;
        /// Where the fault is: which edges of which loops. Nothing where that cannot be told.
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

    /// Gives the face its frame, and of a plane the outline as its first loop. `name` tells faces
    /// apart, from round to round. What is known of it stays where it is.
    Entry& lookup(const Part& part, Face& face, std::uint32_t name);
    /// Are there faults, and what do its edges miss? As faults_of(), of which a face is asked with
    /// one clearance for a tolerance; of edges that miss less, what these miss is enough.
    static bool is_faulty(Entry& entry, const Part& part, std::uint32_t face, double tolerance_mm,
                          double clear_mm, double& miss_mm);

private:
    Vec3 apex_;
    std::unordered_map<std::uint32_t, Entry> entries_;
};

}  // namespace ncsim::brep
