// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawing of axes, program zero, scale and legend over a finished picture.
#include "ncsim/export/marks.h"

#include "ncsim/base/angles.h"

#include "render/lettering.h"
#include "render/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace ncsim::exporter {

namespace {

// Shares of the height of the strip.
constexpr double kLetter = 0.13;     // height of capitals
constexpr double kAxisLength = 0.3;  // of the longest axis
constexpr double kStripMargin = 0.16;

// Largest length of the scale bar, as a share of the width of the picture.
constexpr double kBar = 0.16;

constexpr Rgba8 kPlace{196, 24, 92};
constexpr std::array kAxisColours{Rgba8{204, 52, 44}, Rgba8{40, 140, 60}, Rgba8{46, 96, 214}};

Rgba8 text_colour(Background background) {
    return background == Background::White ? Rgba8{40, 44, 50} : Rgba8{216, 220, 226};
}

Rgba8 halo_colour(Background background) {
    return background == Background::White ? Rgba8{255, 255, 255} : Rgba8{30, 33, 38};
}

// Returns the largest of 1, 2 and 5 times a power of ten up to `limit`.
double round_length(double limit) {
    double unit = 1e-6;
    while (10.0 * unit <= limit)
        unit *= 10.0;
    return 5.0 * unit <= limit ? 5.0 * unit : 2.0 * unit <= limit ? 2.0 * unit : unit;
}

class MarkPainter {
public:
    MarkPainter(Image& image, const Camera& camera, Background background, double strip_rows)
        : image_(image),
          camera_(camera),
          text_(text_colour(background)),
          halo_(halo_colour(background)),
          strip_(strip_rows > 0.0 ? strip_rows
                                  : mark_strip(image.width, image.height) * image.height),
          letter_(kLetter * strip_),
          line_(0.14 * letter_) {}

    void axes() {
        const double length = kAxisLength * strip_;
        const Vec2 origin{(kStripMargin + 0.36) * strip_, image_.height - 0.46 * strip_};
        std::array<std::size_t, 3> order{0, 1, 2};
        const auto direction = [](std::size_t axis) {
            Vec3 d;
            d[static_cast<int>(axis)] = 1.0;
            return d;
        };
        // The axis that points most towards the eye is drawn last.
        std::ranges::sort(order, {},
                          [&](std::size_t axis) { return dot(direction(axis), camera_.back); });
        for (const std::size_t axis : order) {
            const double x = dot(direction(axis), camera_.right);
            const double y = -dot(direction(axis), camera_.up);
            const Vec2 end{origin.x + length * x, origin.y + length * y};
            const Rgba8 colour = kAxisColours[axis];
            arrow(origin, end, colour);
            // An axis along the line of sight has its letter next to the origin.
            const double shown = hypotenuse(x, y);
            const double gap = 0.8 * letter_;
            const Vec2 at = shown > 0.2 ? Vec2{end.x + gap * x / shown, end.y + gap * y / shown}
                                        : Vec2{origin.x - 1.1 * gap, origin.y + 1.1 * gap};
            const std::string_view name = std::string_view("XYZ").substr(axis, 1);
            draw_text(image_, at.x - 0.5 * text_width(letter_, name), at.y + 0.5 * letter_, letter_,
                      colour, name);
        }
    }

    void zero() {
        const Vec2 at = pixel_of({});
        const double radius = 0.75 * letter_;
        circle(at, radius, 2.6 * line_, halo_);
        quarters(at, radius);
        circle(at, radius, line_, text_);
    }

    // Draws a ring around the place, and the text in a disc at the ring.
    void place(const MarkedPlace& marked) {
        const Vec2 at = pixel_of(marked.point);
        const double radius = letter_;
        circle(at, radius, 3.2 * line_, halo_);
        circle(at, radius, 1.6 * line_, kPlace);
        if (marked.text.empty()) return;
        const double width = text_width(letter_, marked.text);
        const Vec2 label{at.x + radius + 0.5 * width + 0.5 * letter_, at.y - radius};
        draw_stroke(image_, {label.x - 0.5 * width, label.y}, {label.x + 0.5 * width, label.y},
                    1.8 * letter_, kPlace);
        draw_text(image_, label.x - 0.5 * width + 0.1 * letter_, label.y + 0.5 * letter_, letter_,
                  Rgba8{255, 255, 255}, marked.text);
    }

    void scale(const Marks& marks) {
        const double right = image_.width - kStripMargin * strip_;
        const double base = image_.height - kStripMargin * strip_;
        const bool is_parallel =
            std::ranges::any_of(std::array{camera_.back.x, camera_.back.y, camera_.back.z},
                                [](double d) { return std::abs(d) > 1.0 - 1e-12; });
        const std::string size = fmt::format("{:.4g} x {:.4g} x {:.4g} {}", marks.size.x,
                                             marks.size.y, marks.size.z, marks.unit);
        const double top = base - 2.0 * letter_;
        if (marks.has_size)
            write_to_the_left(right, is_parallel ? top - 1.2 * letter_ : base, size);
        if (!is_parallel) return;
        const double shown =
            round_length(kBar * camera_.height * image_.width / image_.height / marks.mm_per_unit);
        const double length = shown * marks.mm_per_unit * image_.height / camera_.height;
        const Vec2 a{right - length, base};
        const Vec2 b{right, base};
        draw_stroke(image_, a, b, line_, text_);
        for (const Vec2& end : {a, b})
            draw_stroke(image_, {end.x, end.y - 0.4 * letter_}, {end.x, end.y + 0.4 * letter_},
                        line_, text_);
        write_to_the_left(right, base - 0.8 * letter_, fmt::format("{:g} {}", shown, marks.unit));
    }

    // Writes the entries in columns of three rows.
    void legend(const Marks& marks) {
        constexpr std::size_t kRows = 3;
        const double row = 0.62 * strip_ / kRows;
        double x = left_of_legend();
        double width = 0.0;
        for (std::size_t i = 0; i < marks.legend.size(); ++i) {
            if (i > 0 && i % kRows == 0) {
                x += width + 2.0 * letter_;
                width = 0.0;
            }
            const auto& [colour, text] = marks.legend[i];
            const double needed = 1.9 * letter_ + text_width(letter_, text);
            const bool has_room = x + needed <= right_of_legend();
            const double y =
                image_.height - 0.8 * strip_ + (static_cast<double>(i % kRows) + 0.5) * row;
            if (!has_room) {
                draw_text(image_, x, y + 0.5 * letter_, letter_, text_, "...");
                return;
            }
            draw_stroke(image_, {x + 0.5 * letter_, y}, {x + 0.9 * letter_, y}, letter_, colour);
            draw_text(image_, x + 1.9 * letter_, y + 0.5 * letter_, letter_, text_, text);
            width = std::max(width, needed);
        }
    }

    // Draws the scale of colours with a text at each end.
    void colour_scale(const Marks& marks) {
        const double base = image_.height - 0.5 * strip_;
        double x = left_of_legend();
        draw_text(image_, x, base + 0.5 * letter_, letter_, text_, marks.scale_begin);
        x += text_width(letter_, marks.scale_begin) + letter_;
        const double room = right_of_legend() - x - letter_ - text_width(letter_, marks.scale_end);
        const double length = std::min(room, 0.25 * image_.width);
        if (length < letter_) return;
        const std::vector<Rgba8> colours =
            marks.scale_colours.empty() ? usual_colours() : marks.scale_colours;
        const double step = length / static_cast<double>(colours.size());
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const double a = x + step * static_cast<double>(i);
            draw_stroke(image_, {a, base}, {a + step, base}, letter_, colours[i]);
        }
        bars(marks.scale_bars, x, length, base - letter_);
        draw_text(image_, x + 0.5 * (length - text_width(letter_, marks.scale_middle)),
                  base + 2.2 * letter_, letter_, text_, marks.scale_middle);
        draw_text(image_, x + length + letter_, base + 0.5 * letter_, letter_, text_,
                  marks.scale_end);
    }

private:
    static std::vector<Rgba8> usual_colours() {
        constexpr int kSteps = 64;
        std::vector<Rgba8> colours;
        colours.reserve(kSteps);
        for (int i = 0; i < kSteps; ++i)
            colours.push_back(to_srgb(scale_colour((i + 0.5) / kSteps)));
        return colours;
    }

    // Draws a bar for each height, from `base` up.
    void bars(const std::vector<double>& heights, double left, double length, double base) {
        const double step = length / static_cast<double>(std::max<std::size_t>(1, heights.size()));
        const double highest = 0.5 * strip_ - 2.0 * letter_;
        for (std::size_t i = 0; i < heights.size(); ++i) {
            if (!(heights[i] > 0.0)) continue;
            const double x = left + step * (static_cast<double>(i) + 0.5);
            const double height = std::max(1.0, highest * heights[i]);
            draw_stroke(image_, {x, base}, {x, base - height}, std::max(1.0, 0.6 * step), text_);
        }
    }

    // Returns the pixel that shows a point of W.
    Vec2 pixel_of(Vec3 p_W) const {
        const double pixel = camera_.height / image_.height;  // mm
        const Vec3 from_target = p_W - camera_.target;
        return {0.5 * image_.width + dot(from_target, camera_.right) / pixel,
                0.5 * image_.height - dot(from_target, camera_.up) / pixel};
    }

    double left_of_legend() const { return (2.0 * kStripMargin + 0.9) * strip_; }
    double right_of_legend() const {
        return (1.0 - kBar) * image_.width - 2.0 * kStripMargin * strip_;
    }

    void arrow(Vec2 from, Vec2 to, Rgba8 colour) {
        draw_stroke(image_, from, to, 1.4 * line_, colour);
        const double length = hypotenuse(to.x - from.x, to.y - from.y);
        if (length < letter_) return;
        const double x = 0.45 * letter_ * (to.x - from.x) / length;
        const double y = 0.45 * letter_ * (to.y - from.y) / length;
        draw_stroke(image_, to, {to.x - x - 0.6 * y, to.y - y + 0.6 * x}, 1.4 * line_, colour);
        draw_stroke(image_, to, {to.x - x + 0.6 * y, to.y - y - 0.6 * x}, 1.4 * line_, colour);
    }

    void circle(Vec2 centre, double radius, double width, Rgba8 colour) {
        constexpr int kSides = 32;
        Vec2 last{centre.x + radius, centre.y};
        for (int i = 1; i <= kSides; ++i) {
            const SinCos at = sin_cos(360.0 * i / kSides);
            const Vec2 next{centre.x + radius * at.cos, centre.y + radius * at.sin};
            draw_stroke(image_, last, next, width, colour);
            last = next;
        }
    }

    // Fills the upper right and the lower left quarter of a circle with the colour of text, and the
    // others with that of the background.
    void quarters(Vec2 centre, double radius) {
        const auto rows = static_cast<int>(std::ceil(4.0 * radius / line_));
        for (int row = 0; row <= rows; ++row) {
            const double y = radius * (2.0 * row / rows - 1.0);
            const double half = std::sqrt(std::max(0.0, radius * radius - y * y));
            const double at = centre.y + y;
            const bool is_right_dark = y < 0.0;
            draw_stroke(image_, {centre.x, at}, {centre.x + half, at}, line_,
                        is_right_dark ? text_ : halo_);
            draw_stroke(image_, {centre.x - half, at}, {centre.x, at}, line_,
                        is_right_dark ? halo_ : text_);
        }
    }

    void write_to_the_left(double right, double base_line, std::string_view text) {
        // The last letter has a space behind it.
        const double left = right - text_width(letter_, text) + 0.3 * letter_;
        draw_text(image_, left, base_line, letter_, text_, text);
    }

    Image& image_;
    const Camera& camera_;
    Rgba8 text_, halo_;
    double strip_, letter_, line_;  // pixels
};

}  // namespace

double mark_strip(std::uint32_t width, std::uint32_t height) {
    constexpr double kShare = 0.12;
    return kShare * std::min(1.0, 0.75 * width / height);
}

Camera with_mark_strip(Camera camera, double strip) {
    camera.height /= 1.0 - strip;
    camera.target = camera.target - (0.5 * strip * camera.height) * camera.up;
    return camera;
}

std::vector<std::pair<std::uint32_t, Rgba8>> tool_colours(const mesh::Provenance& provenance) {
    const Palette palette(provenance);
    std::vector<std::pair<std::uint32_t, Rgba8>> colours;
    for (const FaceSource& source : palette.face_sources()) {
        if (source.is_tool) colours.emplace_back(source.tool, palette.colour(source));
    }
    return colours;
}

std::vector<Rgba8> distance_colours(const DesignDistances& distances, std::size_t count) {
    std::vector<Rgba8> colours;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        colours.push_back(to_srgb(distance_colour(distances.largest_mm * (2.0 * share - 1.0),
                                                  distances.tolerance_mm, distances.largest_mm)));
    }
    return colours;
}

void draw_marks(Image& image, const Camera& camera, Background background, const Marks& marks) {
    const bool is_small = image.width < kLeastMarkedSide || image.height < kLeastMarkedSide;
    if (is_small && !(marks.strip_rows > 0.0)) return;
    if (!camera.is_orthographic()) return;
    MarkPainter painter(image, camera, background, marks.strip_rows);
    if (marks.zero) painter.zero();
    for (const MarkedPlace& marked : marks.places)
        painter.place(marked);
    if (marks.axes) painter.axes();
    if (marks.scale) painter.scale(marks);
    if (!marks.legend.empty()) painter.legend(marks);
    if (!marks.scale_begin.empty() || !marks.scale_end.empty()) painter.colour_scale(marks);
}

}  // namespace ncsim::exporter
