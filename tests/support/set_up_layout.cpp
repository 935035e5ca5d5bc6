// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chooses tools and features, and lays the features out on the block.
#include "support/set_up_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ncsim::test::set_ups {

void Writer::run() {
    draft_.inches = random_.one_in(6);
    choose_features();
    lay_out();
    write();
    finish_tools();
    set_machine();
    general_faults();
}

Length Writer::mm(double value) const {
    return std::llround(value * 1000.0 / (draft_.inches ? 2.54 : 1.0));
}

Length Writer::margin(double low, double high) {
    return happens(35) ? 0 : happens(25) ? 1 : within(low, high);
}

void Writer::choose_features() {
    const std::int64_t tools = random_.between(1, 3);
    for (std::int64_t i = 0; i < tools; ++i) {
        Tool tool;
        tool.kind = one_of({"flat", "flat", "flat", "ball", "bull", "drill", "face", "v", "slot"});
        tool.diameter = 2 * (tool.kind == "face"   ? within(10, 18)
                             : tool.kind == "slot" ? within(6, 10)
                                                   : within(1.5, 7));
        if (tool.kind == "bull") tool.corner = tool.diameter / random_.between(4, 8);
        draft_.tools.push_back(tool);
        for (std::int64_t n = random_.between(1, 2); n > 0; --n)
            features_.push_back(feature_for(draft_.tools.size() - 1));
    }
}

Writer::Feature Writer::feature_for(std::size_t index) {
    const Tool& tool = draft_.tools[index];
    Feature f;
    f.tool = index;
    if (tool.kind == "face" || tool.kind == "v") {
        f.kind = Kind::OpenSlot;
    } else if (tool.kind == "drill") {
        f.kind = one_of({Kind::Drilling, Kind::Drilling, Kind::Incremental});
    } else if (tool.kind == "slot") {
        f.kind = Kind::Side;
    } else {
        f.kind = one_of({Kind::OpenSlot, Kind::Loop, Kind::Pocket, Kind::Pocket, Kind::Helix,
                         Kind::Arcs, Kind::Incremental, Kind::Rotated});
    }
    f.room = within(2, 6);
    f.width = tool.diameter + 2 * f.room + 2 * within(0.5, 2);
    // A cone cuts no higher than the cone itself. Shapes without a cylindrical shank need a single
    // pass.
    const bool single =
        tool.kind == "v" || tool.kind == "face" || tool.kind == "slot" || f.kind == Kind::Rotated;
    const std::int64_t passes = single ? 1 : random_.between(1, 3);
    Length pass = within(0.5, 4);
    if (tool.kind == "v") pass = std::min(pass, tool.diameter / 2 - mm(0.3));
    if (tool.kind == "face") pass = tool.diameter / 10 + within(0.2, 1);
    if (tool.kind == "drill") pass = within(3, 12);
    for (std::int64_t i = 1; i <= passes; ++i)
        f.passes.push_back(i * pass);
    if (tool.kind == "slot") f.passes = {within(6, 10)};
    f.depth = f.passes.back();
    return f;
}

bool Writer::is_open(const Feature& f) const {
    return f.kind == Kind::OpenSlot || f.kind == Kind::Loop || f.kind == Kind::Side;
}

void Writer::lay_out() {
    Length deepest = 0, open = 0;
    for (const Feature& f : features_) {
        deepest = std::max(deepest, f.depth);
        if (is_open(f)) open = std::max(open, f.depth);
    }
    const Length height = deepest + within(6, 20);
    Length at = within(-60, 20);
    draft_.stock_min = {at, within(-50, 10), 0};
    draft_.stock_max[Y] = draft_.stock_min[Y] + within(50, 80);
    top_ = one_of({Length{0}, height, within(-60, -30), within(-10, 10)});
    draft_.stock_max[Z] = top_;
    draft_.stock_min[Z] = top_ - height;

    // Strips in random order, so moves between features cross further features.
    std::vector<std::size_t> order(features_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random_.next() % i]);
    const bool clamp = features_.size() > 1 && happens(60);
    const std::size_t before = clamp ? 1 + random_.next() % (features_.size() - 1) : 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (clamp && i == before) {
            clamp_min_ = at;
            at += within(8, 15);
            clamp_max_ = at;
        }
        features_[order[i]].x0 = at;
        at += features_[order[i]].width;
    }
    draft_.stock_max[X] = at;

    const Length far = mm(45);
    high_ = top_;
    if (clamp) {
        high_ += within(4, 12);
        draft_.fixtures.push_back({"clamp",
                                   {clamp_min_, draft_.stock_min[Y] - far, top_},
                                   {clamp_max_, draft_.stock_max[Y] + far, high_}});
    }
    clear_ = high_ + margin(1, 10);
    home_height_ = clear_ + margin(1, 60);
    // A start position no higher than the clamp may touch the clamp.
    draft_.start_specified = home_height_ == high_ || happens(70);
    const int rest = static_cast<int>(random_.between(0, 2));
    if (rest == 0) {
        const Length jaw = open > 0 ? top_ - open - margin(0.1, 2) : top_ - mm(3);
        jaw_top_ = std::max(jaw, draft_.stock_min[Z] + 1);
        const Length low = draft_.stock_min[Z] - mm(10);
        draft_.fixtures.push_back(
            {"fixed jaw",
             {draft_.stock_min[X] - far, draft_.stock_max[Y], low},
             {draft_.stock_max[X] + far, draft_.stock_max[Y] + far, *jaw_top_}});
        draft_.fixtures.push_back({"moving jaw",
                                   {draft_.stock_min[X] - far, draft_.stock_min[Y] - far, low},
                                   {draft_.stock_max[X] + far, draft_.stock_min[Y], *jaw_top_}});
        if (happens(50)) draft_.below_stock = mm(10);
    } else if (rest == 1) {
        const Length low = draft_.stock_min[Z];
        draft_.fixtures.push_back(
            {"table",
             {draft_.stock_min[X] - far, draft_.stock_min[Y] - far, low - mm(20)},
             {draft_.stock_max[X] + far, draft_.stock_max[Y] + far, low}});
        has_table_ = true;
    } else {
        draft_.below_stock = within(1, 8);
    }
}

}  // namespace ncsim::test::set_ups
