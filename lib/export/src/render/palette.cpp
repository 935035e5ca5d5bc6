// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of stock and tools, and conversion between sRGB and linear values.
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::exporter {

namespace {

// A dull grey for the stock and soft hues for the tools. Successive tool colours differ for most
// kinds of colour blindness (blue and orange first).
constexpr Rgba8 kStockColour{150, 156, 164};
constexpr std::array<Rgba8, 8> kToolColours{{{126, 182, 226},
                                             {240, 172, 98},
                                             {128, 200, 160},
                                             {226, 146, 186},
                                             {238, 218, 116},
                                             {172, 156, 222},
                                             {226, 124, 98},
                                             {104, 192, 194}}};
// A brown that is unlike all tool colours.
constexpr Rgba8 kUnnumberedColour{164, 122, 90};

constexpr std::array<Rgba8, 5> kScale{
    {{248, 222, 112}, {122, 200, 122}, {52, 152, 156}, {62, 96, 160}, {78, 48, 118}}};

constexpr Rgba8 kWithin{132, 190, 140};
// Slight and large distances.
constexpr Rgba8 kSlightGouge{246, 168, 110}, kDeepGouge{170, 12, 30};
constexpr Rgba8 kSlightExcess{146, 196, 240}, kThickExcess{18, 62, 156};

float to_linear(std::uint8_t channel) {
    const float c = static_cast<float>(channel) / 255.0F;
    return c * c;
}

std::uint8_t to_srgb(float channel) {
    const float c = std::sqrt(std::clamp(channel, 0.0F, 1.0F));
    return rounded(255.0F * c);
}

}  // namespace

LinearColour to_linear(Rgba8 colour) {
    return {to_linear(colour.r), to_linear(colour.g), to_linear(colour.b)};
}

Rgba8 to_srgb(LinearColour colour) {
    return {to_srgb(colour.r), to_srgb(colour.g), to_srgb(colour.b), 255};
}

double linear_share(std::uint8_t channel) {
    constexpr double kLinearUpTo = 0.04045;
    const double c = static_cast<double>(channel) / 255.0;
    if (c <= kLinearUpTo) return c / 12.92;
    // x^2.4 = x² · ⁵√x². Newton's method finds the root from above and decreases until convergence.
    const double x = (c + 0.055) / 1.055;
    const double square = x * x;
    double root = 1.0;
    for (double next = 0.0;; root = next) {
        next = (4.0 * root + square / (root * root * root * root)) / 5.0;
        if (!(next < root)) break;
    }
    constexpr double kDigits = 1e7;
    return std::round(kDigits * square * root) / kDigits;
}

LinearColour scale_colour(double t) {
    const double position = std::clamp(t, 0.0, 1.0) * static_cast<double>(kScale.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(position), kScale.size() - 2);
    const auto share = static_cast<float>(position - static_cast<double>(below));
    return (1.0F - share) * to_linear(kScale[below]) + share * to_linear(kScale[below + 1]);
}

LinearColour distance_colour(double mm, double tolerance, double largest) {
    const double size = std::abs(mm);
    if (size <= tolerance) return to_linear(kWithin);
    const double t = std::clamp((size - tolerance) / (largest - tolerance), 0.0, 1.0);
    const auto share = static_cast<float>(largest > tolerance ? t : 1.0);
    const LinearColour from = to_linear(mm < 0.0 ? kSlightGouge : kSlightExcess);
    const LinearColour to = to_linear(mm < 0.0 ? kDeepGouge : kThickExcess);
    return (1.0F - share) * from + share * to;
}

std::string FaceSource::name() const {
    if (!is_tool) return "stock";
    std::string text(1, 'T');
    text += std::to_string(tool);
    return text;
}

Palette::Palette(const mesh::Provenance& provenance) : face_sources_{FaceSource({})} {
    for (const mesh::Provenance::Entry& entry : provenance.entries)
        face_sources_.emplace_back(entry);
    std::sort(face_sources_.begin(), face_sources_.end());
    face_sources_.erase(std::unique(face_sources_.begin(), face_sources_.end()),
                        face_sources_.end());
    if (face_sources_.size() > 1 && face_sources_[1].tool == 0) first_numbered_ = 2;
}

std::size_t Palette::rank(FaceSource maker) const {
    const auto found = std::lower_bound(face_sources_.begin(), face_sources_.end(), maker);
    const bool known = found != face_sources_.end() && *found == maker;
    return known ? static_cast<std::size_t>(found - face_sources_.begin()) : 0;
}

Rgba8 Palette::colour(FaceSource maker) const {
    const std::size_t position = rank(maker);
    if (position == 0) return kStockColour;
    if (position < first_numbered_) return kUnnumberedColour;
    return kToolColours[(position - first_numbered_) % kToolColours.size()];
}

}  // namespace ncsim::exporter
