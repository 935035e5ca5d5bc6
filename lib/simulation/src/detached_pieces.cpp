// SPDX-License-Identifier: GPL-3.0-or-later
//
// Search for the cuts that separate pieces from the part.
#include "detached_pieces.h"

#include "ncsim/verify/solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

namespace ncsim::simulation {

namespace {

// Number of pieces for which the separating block is searched; further pieces are only reported.
constexpr std::size_t kMostPieces = 16;

// The part after some of its cuts.
struct CutState {
    verify::Solids solids;
    verify::Place place;
    std::uint64_t motion = 0;
};

// Moments of the simulation, computed on demand.
class History {
public:
    History(const Plan& plan, const Survey& survey, const Verification& verification)
        : plan_(plan), survey_(&survey), verification_(verification) {
        plan_.tiles = nullptr;  // the part is cut again here
        verification_.verifier = nullptr;
    }

    const CutState& after(std::uint32_t cuts) {
        auto& moment = known_[cuts];
        if (!moment) {
            Verification limited = verification_;
            limited.most_cuts = cuts;
            const Simulation s = simulate(plan_, *survey_, limited, {});
            moment = std::make_unique<CutState>(
                CutState{verify::Solids(surface_of_program(s)), s.last_cut, s.last_motion});
        }
        return *moment;
    }

private:
    Plan plan_;
    const Survey* survey_;
    Verification verification_;
    std::map<std::uint32_t, std::unique_ptr<CutState>> known_;
};

// Returns the first number of cuts after which both points are in different pieces. Material that
// was separated stays separated; the last candidate separates.
std::uint32_t separation(History& history, const std::vector<cda::Origin>& origins, Vec3 a,
                         Vec3 b) {
    const auto apart = [&](std::uint32_t cuts) {
        const verify::Solids& solids = history.after(cuts).solids;
        return solids.at(a) != solids.at(b);
    };
    std::size_t low = 0, high = origins.size() - 1;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (apart(static_cast<std::uint32_t>(origins[middle]))) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    // If a later cut replaced the walls of the separating cut, the search continues between the
    // candidates.
    std::uint32_t last = static_cast<std::uint32_t>(origins[high]);
    std::uint32_t first = high > 0 ? static_cast<std::uint32_t>(origins[high - 1]) + 1 : 1;
    if (first < last && !apart(last - 1)) return last;
    while (first < last) {
        const std::uint32_t middle = first + (last - first) / 2;
        if (apart(middle)) {
            last = middle;
        } else {
            first = middle + 1;
        }
    }
    return last;
}

double thickness(const Box& box) {
    const Vec3 size = box.size();
    return std::min({size.x, size.y, size.z});
}

double accuracy(const Simulation& simulation) {
    double worst = 0.0;
    for (const auto& [number, facts] : simulation.cutters)
        worst = std::max(worst, facts.error_mm);
    return worst + simulation.bounds.gained_mm;
}

}  // namespace

std::vector<verify::Finding> detached_pieces(const Plan& plan, const Survey& survey,
                                             const Verification& verification,
                                             const Simulation& simulation) {
    std::vector<verify::Finding> findings;
    const cda::Boundary boundary = surface_of_program(simulation);
    if (boundary.shells < 2) return findings;
    const verify::Solids solids(boundary);
    if (solids.all().size() < 2) return findings;
    History history(plan, survey, verification);
    const verify::Solid& main = solids.all().front();
    const double least = 2 * accuracy(simulation);
    verify::Finding rest;
    rest.rule = "part-cut-free";
    rest.severity = verify::Severity::Note;
    rest.certainty = verify::Certainty::Within;
    rest.count = 0;
    double rest_volume = 0.0;
    for (std::size_t i = 1; i < solids.all().size(); ++i) {
        const verify::Solid& piece = solids.all()[i];
        if (thickness(piece.box) <= least || findings.size() >= kMostPieces || !piece.inner_point ||
            !main.inner_point || piece.origins.empty()) {
            ++rest.count;
            rest_volume += piece.volume_mm3;
            rest.box.add(piece.box);
            continue;
        }
        const std::uint32_t cut =
            separation(history, piece.origins, *piece.inner_point, *main.inner_point);
        const CutState& moment = history.after(cut);
        verify::Finding f;
        f.rule = "part-cut-free";
        f.place = f.last = moment.place;
        f.first_motion = f.last_motion = moment.motion;
        f.message = "a piece of the part is cut free";
        f.quantity = verify::Quantity{"left of it at the end", piece.volume_mm3, "mm3"};
        f.point = piece.inner_point;
        f.box = piece.box;
        findings.push_back(std::move(f));
    }
    if (rest.count > 0) {
        rest.message = fmt::format(
            "{} more loose piece{}, no thicker than the tools are accurate or too many to follow",
            rest.count, rest.count == 1 ? "" : "s");
        rest.quantity = verify::Quantity{"together", rest_volume, "mm3"};
        findings.push_back(std::move(rest));
    }
    return findings;
}

}  // namespace ncsim::simulation
