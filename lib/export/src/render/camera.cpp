// SPDX-License-Identifier: GPL-3.0-or-later
//
// Standard views and a camera that fits a box.
#include "ncsim/export/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ncsim::exporter {

namespace {

constexpr std::array<std::pair<std::string_view, View>, 7> kViews{{{"iso", View::Iso},
                                                                   {"top", View::Top},
                                                                   {"front", View::Front},
                                                                   {"back", View::Back},
                                                                   {"left", View::Left},
                                                                   {"right", View::Right},
                                                                   {"bottom", View::Bottom}}};

// Empty space on each side of the part, as a share of the height or width of the picture.
constexpr double kMargin = 0.06;
// Distance of a perspective eye in diagonals of the box. With 4, the box subtends about 14 degrees,
// as with a 150 mm lens: parallel edges look parallel, but the far end is clearly behind.
constexpr double kEyeDiagonals = 4.0;

// Directions towards the eye and upwards, for each view.
struct Directions {
    Vec3 back, up;
};

Directions directions(View view) {
    switch (view) {
        case View::Iso: return {{0.6, -0.9, 0.8}, {0, 0, 1}};
        case View::Top: return {{0, 0, 1}, {0, 1, 0}};
        case View::Bottom: return {{0, 0, -1}, {0, 1, 0}};
        case View::Front: return {{0, -1, 0}, {0, 0, 1}};
        case View::Back: return {{0, 1, 0}, {0, 0, 1}};
        case View::Left: return {{-1, 0, 0}, {0, 0, 1}};
        case View::Right: return {{1, 0, 0}, {0, 0, 1}};
    }
    return {{0, 0, 1}, {0, 1, 0}};
}

Box with_size(Box box) {
    if (box.is_empty()) box.add(Vec3{});
    if (norm(box.size()) > 0.0) return box;
    const Vec3 half{0.5, 0.5, 0.5};
    const Vec3 point = box.min;
    box.add(point - half);
    box.add(point + half);
    return box;
}

}  // namespace

std::optional<View> parse_view(std::string_view name) {
    for (const auto& [text, view] : kViews) {
        if (text == name) return view;
    }
    return std::nullopt;
}

std::string_view name(View view) {
    for (const auto& [text, value] : kViews) {
        if (value == view) return text;
    }
    return {};
}

Camera fit_camera(const Box& box_or_nothing, View view, double aspect, Projection projection) {
    const Box box = with_size(box_or_nothing);
    const auto [back, up] = directions(view);
    const double diagonal = norm(box.size());
    Camera camera;
    camera.target = box.centre();
    camera.back = normalized(back);
    camera.right = normalized(cross(up, camera.back));
    camera.up = cross(camera.back, camera.right);
    camera.depth = 0.51 * diagonal;  // half of the diagonal and a small margin
    camera.distance = projection == Projection::Perspective ? kEyeDiagonals * diagonal : 0.0;

    // Half of the visible extent at the target, from the eight projected corners.
    double half_width = 0.0;
    double half_height = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{(corner & 1) != 0 ? box.max.x : box.min.x,
                     (corner & 2) != 0 ? box.max.y : box.min.y,
                     (corner & 4) != 0 ? box.max.z : box.min.z};
        const Vec3 q = p - camera.target;
        const double scale = camera.is_orthographic()
                                 ? 1.0
                                 : camera.distance / (camera.distance - dot(q, camera.back));
        half_width = std::max(half_width, scale * std::abs(dot(q, camera.right)));
        half_height = std::max(half_height, scale * std::abs(dot(q, camera.up)));
    }
    const double fitting = std::max(half_height, half_width / aspect);
    // A flat box seen from its edge has neither width nor height.
    camera.height = fitting > 0.0 ? 2.0 * fitting / (1.0 - 2.0 * kMargin) : diagonal;
    return camera;
}

}  // namespace ncsim::exporter
