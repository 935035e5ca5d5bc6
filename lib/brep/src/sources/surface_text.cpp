// SPDX-License-Identifier: GPL-3.0-or-later
//
// One table lists the fields of each form (visit_fields); writing, reading and moving are visitors
// of this table.
#include "ncsim/brep/surface_text.h"

#include "ncsim/base/number_text.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {

namespace {

// Calls `v` for each field: point(), direction() (unit), vector(), length() (positive) and number()
// (any sign).
template <class V>
void visit_fields(Plane& f, V& v) {
    v.point(f.origin);
    v.direction(f.normal);
}
template <class V>
void visit_fields(Cylinder& f, V& v) {
    v.point(f.origin);
    v.direction(f.axis);
    v.length(f.radius);
}
template <class V>
void visit_fields(Cone& f, V& v) {
    v.point(f.apex);
    v.direction(f.axis);
    v.length(f.slope);
}
template <class V>
void visit_fields(Sphere& f, V& v) {
    v.point(f.centre);
    v.length(f.radius);
}
template <class V>
void visit_fields(Torus& f, V& v) {
    v.point(f.centre);
    v.direction(f.axis);
    v.length(f.major);
    v.length(f.minor);
}
template <class V>
void visit_fields(Extrusion& f, V& v) {
    v.point(f.centre);
    v.direction(f.axis);
    v.oblique(f.along, f.axis);
    v.length(f.radius);
}
template <class V>
void visit_fields(Dome& f, V& v) {
    v.point(f.centre);
    v.direction(f.axis);
    v.perpendicular(f.ahead, f.axis);
    v.length(f.reach);
    v.length(f.radius);
}
template <class V>
void visit_fields(Coil& f, V& v) {
    v.point(f.centre);
    v.direction(f.axis);
    v.perpendicular(f.ahead, f.axis);
    v.length(f.reach);
    v.length(f.radius);
    v.nonzero(f.lead);
}
template <class V>
void visit_fields(Spiral& f, V& v) {
    v.point(f.centre);
    v.direction(f.axis);
    v.perpendicular(f.ahead, f.axis);
    v.length(f.reach);
    v.number(f.lead);
    v.number(f.offset);
}
template <class V>
void visit_fields(Fillet& f, V& v) {
    v.number(f.centre_radius);
    v.number(f.height);
    v.number(f.radius);
}
template <class V>
void visit_fields(Flank& f, V& v) {
    v.number(f.radius);
    v.number(f.height);
    v.cosine_and_sine(f.cosine, f.sine);
    v.length(f.length);
}
template <class V>
void visit_fields(StraightPath& f, V& v) {
    v.point(f.from);
    v.vector(f.along);
    v.direction(f.axis);
}
template <class V>
void visit_fields(HelixPath& f, V& v) {
    v.point(f.centre);
    v.direction(f.about);
    v.perpendicular(f.ahead, f.about);
    v.number(f.reach);
    v.number(f.growth);
    v.number(f.lead);
    v.nonzero(f.swept);
    v.direction(f.axis);
}
template <class V>
void visit_fields(RotaryPath& f, V& v) {
    v.count(f.powers);
    for (std::size_t k = 0; k < f.powers.size(); ++k) {
        std::array<double, 6>& power = f.powers[k];
        Vec3 tip{power[0], power[1], power[2]}, axis{power[3], power[4], power[5]};
        if (k == 0) {
            v.point(tip);
        } else {
            v.vector(tip);
        }
        v.vector(axis);
        power = {tip.x, tip.y, tip.z, axis.x, axis.y, axis.z};
    }
}

// Writes fields.
class Writer {
public:
    void point(Vec3 p) { vector(p); }
    void direction(Vec3 d) { vector(d); }
    void perpendicular(Vec3 d, Vec3) { vector(d); }
    void vector(Vec3 p) {
        number(p.x);
        number(p.y);
        number(p.z);
    }
    void oblique(Vec3 d, Vec3) { vector(d); }
    void length(double x) { number(x); }
    void nonzero(double x) { number(x); }
    void cosine_and_sine(double cosine, double sine) {
        number(cosine);
        number(sine);
    }
    void number(double x) { word(shortest(x)); }
    void count(const std::vector<std::array<double, 6>>& powers) {
        number(static_cast<double>(powers.size()));
    }
    void word(std::string_view name) {
        if (!text.empty()) text += ' ';
        text += name;
    }

    std::string text;
};

// Reads fields; is_good turns false at the first field that is missing or out of range.
class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    void point(Vec3& p) { vector(p); }
    void direction(Vec3& d) {
        vector(d);
        is_good = is_good && std::abs(norm(d) - 1.0) <= kPointError;
    }
    void perpendicular(Vec3& d, Vec3 axis) {
        direction(d);
        is_good = is_good && std::abs(dot(d, axis)) <= kPointError;
    }
    void vector(Vec3& p) {
        number(p.x);
        number(p.y);
        number(p.z);
    }
    void oblique(Vec3& d, Vec3 axis) {
        direction(d);
        is_good = is_good && dot(d, axis) >= kRounding;
    }
    void length(double& x) {
        number(x);
        is_good = is_good && x > 0.0;
    }
    void nonzero(double& x) {
        number(x);
        is_good = is_good && std::abs(x) >= kRounding;
    }
    void cosine_and_sine(double& cosine, double& sine) {
        number(cosine);
        number(sine);
        is_good = is_good && std::abs(cosine * cosine + sine * sine - 1.0) <= kRounding &&
                  std::abs(cosine) >= kRounding;
    }
    void number(double& x) {
        any_number(x);
        // Ten times the range of the lattice.
        is_good = is_good && std::abs(x) <= 1000.0 * kPartMm;
    }
    // Bounds of boxes may be infinite.
    void any_number(double& x) {
        x = number_in<double>(word()).value_or(std::numeric_limits<double>::quiet_NaN());
        is_good = is_good && !std::isnan(x);
    }
    void count(std::vector<std::array<double, 6>>& powers) {
        double size = 0.0;
        number(size);
        is_good = is_good && size >= 1.0 && size <= 64.0 && size == std::floor(size);
        if (is_good) powers.resize(static_cast<std::size_t>(size));
    }
    std::string_view word() {
        const std::size_t begin = std::min(rest_.find_first_not_of(' '), rest_.size());
        const std::size_t end = std::min(rest_.find(' ', begin), rest_.size());
        const std::string_view result = rest_.substr(begin, end - begin);
        rest_.remove_prefix(end);
        return result;
    }

    bool is_good = true;

private:
    std::string_view rest_;
};

// Rotates and shifts fields.
class Mover {
public:
    explicit Mover(const RigidMotion& motion) : motion_(motion) {}

    void point(Vec3& p) {
        vector(p);
        p = p + motion_.shift;
    }
    void direction(Vec3& d) { vector(d); }
    void perpendicular(Vec3& d, Vec3) { vector(d); }
    void oblique(Vec3& d, Vec3) { vector(d); }
    void vector(Vec3& p) {
        p = {dot(motion_.rows[0], p), dot(motion_.rows[1], p), dot(motion_.rows[2], p)};
    }
    void length(double) {}
    void nonzero(double) {}
    void cosine_and_sine(double, double) {}
    void number(double) {}
    void count(const std::vector<std::array<double, 6>>&) {}

private:
    const RigidMotion& motion_;
};

template <class Variant, std::size_t I = 0>
bool emplace_by_name(Variant& variant, std::string_view name, const auto& names) {
    if constexpr (I == std::tuple_size_v<std::remove_cvref_t<decltype(names)>>) {
        return false;
    } else {
        if (names[I] != name) return emplace_by_name<Variant, I + 1>(variant, name, names);
        variant.template emplace<I>();
        return true;
    }
}

constexpr std::array<std::string_view, 2> kMeridians{"fillet", "flank"};
constexpr std::array<std::string_view, 3> kPaths{"line", "helix", "rotary"};
constexpr std::string_view kHollow = "hollow", kAtRest = "rest", kWithin = "within",
                           kBetween = "between", kBelowSide = "below-side";

void write(Writer& writer, const Form& form) {
    writer.word(kForms[form.index()]);
    std::visit(
        [&](auto fields) {
            using F = decltype(fields);
            if constexpr (std::is_same_v<F, Envelope>) {
                Meridian meridian = fields.sweep->meridian();
                ToolPath path = fields.sweep->path();
                writer.word(kMeridians[meridian.index()]);
                std::visit([&](auto& m) { visit_fields(m, writer); }, meridian);
                writer.word(kPaths[path.index()]);
                std::visit([&](auto& p) { visit_fields(p, writer); }, path);
            } else if constexpr (requires { visit_fields(fields, writer); }) {
                visit_fields(fields, writer);
            }
        },
        form);
}

std::optional<Form> read_envelope(Reader& reader) {
    Meridian meridian;
    ToolPath path;
    if (!emplace_by_name(meridian, reader.word(), kMeridians)) return std::nullopt;
    std::visit([&](auto& m) { visit_fields(m, reader); }, meridian);
    if (!emplace_by_name(path, reader.word(), kPaths)) return std::nullopt;
    std::visit([&](auto& p) { visit_fields(p, reader); }, path);
    // Envelopes of helices cover 0.7 turns at most.
    const auto* helix = std::get_if<HelixPath>(&path);
    // On other paths, flanks leave planes, cylinders and cones, and balls leave cylinders.
    const auto* fillet = std::get_if<Fillet>(&meridian);
    const bool is_other =
        fillet ? fillet->centre_radius <= 0.0 && std::holds_alternative<StraightPath>(path)
               : !std::holds_alternative<RotaryPath>(path);
    if (!reader.is_good || is_other || (helix && std::abs(helix->swept) > 5.0)) return std::nullopt;
    auto sweep = std::make_shared<const Sweep>(meridian, path);
    if (!has_across(*sweep)) return std::nullopt;
    return Envelope{std::move(sweep)};
}

std::optional<Form> read_form(Reader& reader) {
    std::variant<Plane, Cylinder, Cone, Sphere, Torus, Extrusion, Dome, Coil, Spiral,
                 std::monostate>
        fields;
    static_assert(std::variant_size_v<decltype(fields)> == kForms.size());
    if (!emplace_by_name(fields, reader.word(), kForms)) return std::nullopt;
    return std::visit(
        [&](auto& form) -> std::optional<Form> {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(form)>, std::monostate>) {
                return read_envelope(reader);
            } else {
                visit_fields(form, reader);
                if (!reader.is_good) return std::nullopt;
                return form;
            }
        },
        fields);
}

void move(Form& form, Mover& mover) {
    std::visit(
        [&](auto& fields) {
            using F = std::remove_cvref_t<decltype(fields)>;
            if constexpr (std::is_same_v<F, Envelope>) {
                ToolPath path = fields.sweep->path();
                std::visit([&](auto& p) { visit_fields(p, mover); }, path);
                fields.sweep = std::make_shared<const Sweep>(fields.sweep->meridian(), path);
            } else if constexpr (requires { visit_fields(fields, mover); }) {
                visit_fields(fields, mover);
            }
        },
        form);
}

// Returns the box around the moved box. Bounds may be infinite.
Box moved(const Box& box, const RigidMotion& motion) {
    Box result{motion.shift, motion.shift};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const double share = motion.rows[static_cast<std::size_t>(i)][k];
            if (share == 0.0) continue;
            result.min[i] += share * (share > 0.0 ? box.min[k] : box.max[k]);
            result.max[i] += share * (share > 0.0 ? box.max[k] : box.min[k]);
        }
    }
    return result;
}

}  // namespace

std::string text_of(const CandidateSurface& candidate) {
    Writer writer;
    write(writer, candidate.surface.form);
    if (candidate.surface.is_hollow) writer.word(kHollow);
    if (candidate.is_at_rest) writer.word(kAtRest);
    if (candidate.place) {
        writer.word(kWithin);
        writer.vector(candidate.place->min);
        writer.vector(candidate.place->max);
    }
    if (candidate.ends) {
        writer.word(kBetween);
        for (Plane end : *candidate.ends)
            visit_fields(end, writer);
    }
    if (candidate.below_side) {
        writer.word(kBelowSide);
        writer.vector(*candidate.below_side);
    }
    return std::move(writer.text);
}

std::optional<CandidateSurface> candidate_of(std::string_view text) {
    Reader reader(text);
    const std::optional<Form> form = read_form(reader);
    if (!form) return std::nullopt;
    CandidateSurface candidate{{*form}};
    std::string_view mark = reader.word();
    const auto take = [&](std::string_view name) {
        if (mark != name) return false;
        mark = {};
        return true;
    };
    if (take(kHollow)) {
        candidate.surface.is_hollow = true;
        mark = reader.word();
    }
    if (take(kAtRest)) {
        candidate.is_at_rest = true;
        mark = reader.word();
    }
    if (take(kWithin)) {
        Box& box = candidate.place.emplace();
        for (Vec3* corner : {&box.min, &box.max}) {
            for (int i = 0; i < 3; ++i)
                reader.any_number((*corner)[i]);
        }
        mark = reader.word();
    }
    if (take(kBetween)) {
        for (Plane& end : candidate.ends.emplace())
            visit_fields(end, reader);
        mark = reader.word();
    }
    if (take(kBelowSide)) {
        reader.direction(candidate.below_side.emplace());
        mark = reader.word();
    }
    if (!reader.is_good || !mark.empty()) return std::nullopt;
    return candidate;
}

CandidateSurface moved(const CandidateSurface& candidate, const RigidMotion& motion) {
    CandidateSurface result = candidate;
    Mover mover(motion);
    move(result.surface.form, mover);
    if (result.place) result.place = moved(*result.place, motion);
    if (result.ends) {
        for (Plane& end : *result.ends)
            visit_fields(end, mover);
    }
    if (result.below_side) mover.direction(*result.below_side);
    return result;
}

}  // namespace ncsim::brep
