// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws both parts and their difference, and finds the lines on both sides.
#include "ncsim/simulation/review_data.h"

#include "ncsim/export/camera.h"
#include "ncsim/export/png.h"
#include "ncsim/export/render.h"
#include "ncsim/simulation/shading.h"
#include "ncsim/toolpath/tool_spec.h"

#include "compare_processes.h"
#include "difference_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

constexpr std::size_t kMostRegions = 10;  // of each part, as in the text of the difference
constexpr std::uint32_t kWidth = 800, kHeight = 600;
constexpr exporter::Rgba8 kOnlyOld{232, 89, 12};
constexpr exporter::Rgba8 kOnlyNew{28, 126, 214};

const char* words_for(exporter::View view) {
    using enum exporter::View;
    switch (view) {
        case Iso: return "isometric";
        case Top: return "from above";
        case Bottom: return "from below";
        case Front: return "from the front";
        case Back: return "from behind";
        case Left: return "from the left";
        case Right: return "from the right";
    }
    return "";
}

ReviewSide side_of(const SurveyedPlan& side) {
    ReviewSide result;
    result.source = side.plan.job.program.text;
    result.files = side.survey.interpretation.files;
    const std::map<int, ToolProcess> processes = processes_by_tool(side.plan);
    for (const auto& [number, distances] : side.survey.distances) {
        ReviewTool& tool = result.tools[number];
        tool.distances = distances;
        if (const auto used = side.survey.tools.find(number); used != side.survey.tools.end())
            tool.shape = toolpath::describe(used->second.tool);
        if (const auto found = processes.find(number); found != processes.end())
            static_cast<ToolProcess&>(tool) = found->second;
    }
    return result;
}

// Part with the surface to be shown.
struct ShownPart {
    const SurveyedPlan* side = nullptr;
    const Simulation* simulation = nullptr;
    cda::Boundary boundary;
};

ShownPart shown(const SurveyedPlan& side, const Simulation& simulation) {
    ShownPart part{&side, &simulation, {}};
    if (simulation.part) part.boundary = simulation.part->boundary();
    return part;
}

// Draws pictures of both parts and of their difference.
class Painter {
public:
    Painter(const Box& stock, const ShownPart& a, const ShownPart& b,
            const cda::WorkpieceModel* common)
        : stock_(stock), a_(a), b_(b), a_shading_(shading(a)), b_shading_(shading(b)) {
        if (common) common_ = common->boundary();
    }

    ReviewPicture paint(exporter::View view, const std::vector<ReviewRegion>& all,
                        bool differs) const {
        constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
        const exporter::Camera camera = exporter::fit_camera(stock_, view, kAspect);
        ReviewPicture picture;
        picture.view = words_for(view);
        picture.before = part_png(a_, a_shading_, camera);
        if (!common_) return picture;
        picture.after = part_png(b_, b_shading_, camera);
        if (!differs) return picture;
        picture.difference = difference_png(camera);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Vec3 offset = all[i].point - camera.target;
            picture.pins.push_back({i, 0.5 + dot(offset, camera.right) / (kAspect * camera.height),
                                    0.5 - dot(offset, camera.up) / camera.height});
        }
        return picture;
    }

private:
    static brep::Shading shading(const ShownPart& part) {
        if (!part.simulation->part) return {};
        return shading_of(part.side->plan, part.side->survey, *part.simulation, part.boundary);
    }

    static exporter::RenderOptions options(const exporter::Camera& camera) {
        exporter::RenderOptions render;
        render.width = kWidth;
        render.height = kHeight;
        render.camera = camera;
        return render;
    }

    static std::string png_of(const exporter::Image& image) {
        std::ostringstream png;
        exporter::write_png(png, image);
        return std::move(png).str();
    }

    static std::string part_png(const ShownPart& part, const brep::Shading& shading,
                                const exporter::Camera& camera) {
        return png_of(exporter::render_boundary(part.boundary, part.simulation->provenance,
                                                options(camera), {}, shading));
    }

    // Draws both parts in different colours, and the common material nearer to the eye by an
    // invisible distance. Thus a colour is visible only where a single part has material.
    std::string difference_png(const exporter::Camera& camera) const {
        constexpr double kNearer = 1.0 / (1 << 18);  // of the depth of the picture
        cda::Boundary common = *common_;
        for (Vec3& p : common.vertices)
            p = p + (kNearer * camera.depth) * camera.back;
        exporter::Overlay overlay;
        overlay.bodies.push_back({a_.boundary, kOnlyOld});
        overlay.bodies.push_back({b_.boundary, kOnlyNew});
        return png_of(exporter::render_boundary(common, {}, options(camera), overlay));
    }

    Box stock_;
    const ShownPart &a_, &b_;
    brep::Shading a_shading_, b_shading_;
    std::optional<cda::Boundary> common_;
};

using RegionLines = std::vector<verify::LineRange> ReviewRegion::*;

// Adds the largest regions of `material`, which belongs to `part` only, because the second program
// removed the material.
void add_regions(const OneSidedMaterial& material, bool is_only_old, const ShownPart& part,
                 const cda::WorkpieceModel& common, SeenAreas& seen,
                 std::vector<ReviewRegion>& regions) {
    if (material.regions.empty()) return;
    const RegionLines left_by = is_only_old ? &ReviewRegion::old_lines : &ReviewRegion::new_lines;
    const RegionLines removed_by =
        is_only_old ? &ReviewRegion::new_lines : &ReviewRegion::old_lines;
    DifferenceSurface surface(*part.simulation, part.boundary, common);
    for (std::size_t i = 0; i < material.regions.size() && i < kMostRegions; ++i) {
        const verify::Region& found = material.regions[i];
        ReviewRegion region;
        region.is_only_old = is_only_old;
        region.volume_mm3 = found.volume_mm3;
        region.box = found.box;
        region.*removed_by = found.lines;
        DifferenceSurface::Found left = surface.find_in(found.box, seen);
        region.*left_by = std::move(left.lines);
        region.has_stock_surface = left.has_stock;
        region.point = left.point.value_or(found.box.centre());
        regions.push_back(std::move(region));
    }
}

}  // namespace

Review review_of(const SurveyedPlan& a, const SurveyedPlan& b, Comparison comparison) {
    Review review;
    review.difference = std::move(comparison.difference);
    review.old_side = side_of(a);
    review.new_side = side_of(b);
    const Difference& d = review.difference;
    const ShownPart old_part = shown(a, comparison.old_part);
    const ShownPart new_part = shown(b, comparison.new_part);
    SeenAreas seen{};
    if (comparison.common) {
        add_regions(d.only_old, true, old_part, *comparison.common, seen, review.regions);
        add_regions(d.only_new, false, new_part, *comparison.common, seen, review.regions);
    }
    const Painter painter(a.survey.stock->box, old_part, new_part, comparison.common.get());
    const bool differs = d.only_old.volume_mm3 > 0.0 || d.only_new.volume_mm3 > 0.0;
    const auto most = static_cast<std::size_t>(std::ranges::max_element(seen) - seen.begin());
    for (const exporter::View view : {exporter::View::Iso, kAxisViews.at(most)})
        review.pictures.push_back(painter.paint(view, review.regions, differs));
    return review;
}

}  // namespace ncsim::simulation
