// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes in VRML97. The text becomes nodes of few kinds, which may occur under several parents
// (USE). Then the tree is traversed, and each shape placed. Both steps are bounded, by depth and by
// the size of the result.
#include "meshes/vrml_mesh.h"

#include "ncsim/base/angles.h"
#include "ncsim/base/number_text.h"

#include "meshes/polygons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace ncsim::setup {

namespace {

constexpr int kDeepestNode = 64;
constexpr std::size_t kMostCorners = 30'000'000, kMostVisits = 100'000;

// A linear map followed by a translation.
struct Affine {
    std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 shift;

    Vec3 operator()(Vec3 p) const {
        return Vec3{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} + shift;
    }
    double determinant() const { return dot(rows[0], cross(rows[1], rows[2])); }
};

Affine operator*(const Affine& a, const Affine& b) {
    Affine product;
    for (std::size_t i = 0; i < 3; ++i) {
        product.rows[i] =
            a.rows[i].x * b.rows[0] + a.rows[i].y * b.rows[1] + a.rows[i].z * b.rows[2];
    }
    product.shift = a(b.shift);
    return product;
}

Affine shift_by(Vec3 by) {
    Affine result;
    result.shift = by;
    return result;
}

Affine turn_about(Vec3 axis, double radians) {
    Affine result;
    const double length = norm(axis);
    if (!(length > 0.0)) return result;
    const Vec3 u = (1.0 / length) * axis;
    const SinCos q = sin_cos(radians / kRadiansPerDegree);
    const double k = 1.0 - q.cos;
    const Vec3 w = q.sin * u;
    result.rows = {Vec3{q.cos + k * u.x * u.x, k * u.x * u.y - w.z, k * u.x * u.z + w.y},
                   Vec3{k * u.x * u.y + w.z, q.cos + k * u.y * u.y, k * u.y * u.z - w.x},
                   Vec3{k * u.x * u.z - w.y, k * u.y * u.z + w.x, q.cos + k * u.z * u.z}};
    return result;
}

struct VrmlNode;
using VrmlNodePointer = std::shared_ptr<const VrmlNode>;

struct VrmlNode {
    Affine placing;
    std::vector<VrmlNodePointer> children;  // visible children
    Polygons faces;
};

// Meaning of a name while the text is read: a node, or the points of a node.
struct VrmlNamed {
    VrmlNodePointer node;
    std::shared_ptr<const std::vector<Vec3>> points;
};

// Names of nodes without a body for collisions.
constexpr std::string_view kWithoutBody =
    " Appearance AudioClip Background Color ColorInterpolator CoordinateInterpolator "
    "CylinderSensor DirectionalLight Fog FontStyle ImageTexture IndexedLineSet Material "
    "MovieTexture NavigationInfo Normal NormalInterpolator OrientationInterpolator "
    "PixelTexture PlaneSensor PointLight PointSet PositionInterpolator ProximitySensor "
    "ScalarInterpolator Script Sound SphereSensor SpotLight Text TextureCoordinate "
    "TextureTransform TimeSensor TouchSensor Viewpoint VisibilitySensor WorldInfo ";

bool is_without_body(std::string_view node) {
    return kWithoutBody.find(fmt::format(" {} ", node)) != std::string_view::npos;
}

class VrmlReader {
public:
    explicit VrmlReader(std::string_view text) : text_(text) {}

    VrmlNodePointer read() {
        auto root = std::make_shared<VrmlNode>();
        for (std::string_view word = next(); !word.empty(); word = next()) {
            if (word == "ROUTE") {
                skip_route();
            } else if (const VrmlNamed named = node(word); named.node) {
                root->children.push_back(named.node);
            }
        }
        return root;
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        const auto line =
            1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
        throw Refused{fmt::format("line {}: {}", line, what)};
    }

    static bool is_blank(char c) {
        return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',';
    }
    static bool is_bracket(char c) { return c == '{' || c == '}' || c == '[' || c == ']'; }

    // Returns the next word, bracket, or string with its quotes; empty at the end.
    std::string_view next() {
        while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '#')) {
            if (text_[at_] == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else {
                ++at_;
            }
        }
        const std::size_t begin = at_;
        if (at_ == text_.size()) return {};
        if (is_bracket(text_[at_])) return text_.substr(at_++, 1);
        if (text_[at_] == '"') {
            for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
                if (text_[at_] == '\\') ++at_;
            }
            if (at_ >= text_.size()) {
                at_ = begin;
                refuse("a text without end");
            }
            ++at_;
            return text_.substr(begin, at_ - begin);
        }
        while (at_ < text_.size() && !is_blank(text_[at_]) && !is_bracket(text_[at_]) &&
               text_[at_] != '"' && text_[at_] != '#') {
            ++at_;
        }
        return text_.substr(begin, at_ - begin);
    }

    std::string_view peek() {
        const std::size_t before = at_;
        const std::string_view word = next();
        at_ = before;
        return word;
    }

    std::string_view some_word() {
        const std::string_view word = next();
        if (word.empty()) refuse("the file ends within a node");
        return word;
    }

    void expect(std::string_view what) {
        if (some_word() != what) refuse(fmt::format("expected '{}'", what));
    }

    template <class Number>
    Number number() {
        std::string_view word = some_word();
        if (word.starts_with('+')) word.remove_prefix(1);
        const auto value = number_in<Number>(word);
        if (!value) refuse("expected a number");
        return *value;
    }

    Vec3 vector() {
        Vec3 v;
        for (int i = 0; i < 3; ++i)
            v[i] = number<double>();
        return v;
    }

    bool yes_or_no() {
        const std::string_view word = some_word();
        if (word != "TRUE" && word != "FALSE") refuse("expected TRUE or FALSE");
        return word == "TRUE";
    }

    void skip_route() {
        for (int i = 0; i < 3; ++i)
            some_word();
    }

    // Skips to the bracket that closes the last opening bracket.
    void skip_to_end() {
        for (std::size_t open = 1; open > 0;) {
            const std::string_view word = some_word();
            if (word == "{" || word == "[") ++open;
            if (word == "}" || word == "]") --open;
        }
    }

    // Skips the value of a field: up to the next name, or the end of the node.
    void skip_value() {
        for (;;) {
            const std::string_view word = peek();
            if (word.empty()) refuse("the file ends within a node");
            const bool is_name = (word[0] >= 'a' && word[0] <= 'z') || word == "}" ||
                                 word == "ROUTE" || word == "PROTO" || word == "EXTERNPROTO";
            if (is_name) return;
            next();
            if (word == "DEF" || word == "USE") some_word();
            if (word == "{" || word == "[") skip_to_end();
            if (word == "IS") refuse("prototypes are not read");
        }
    }

    // Passes each field to `take`, up to the end of the node. `take` returns false for unknown
    // fields, which are skipped.
    template <class Take>
    void fields(const Take& take) {
        expect("{");
        for (;;) {
            const std::string_view name = some_word();
            if (name == "}") return;
            if (name == "ROUTE") {
                skip_route();
            } else if (name == "PROTO" || name == "EXTERNPROTO") {
                refuse("prototypes are not read");
            } else if (!take(name)) {
                skip_value();
            }
        }
    }

    // Reads a node, or several nodes in brackets.
    template <class Take>
    void nodes(const Take& take) {
        std::string_view word = some_word();
        if (word != "[") {
            take(node(word));
            return;
        }
        while ((word = some_word()) != "]")
            take(node(word));
    }

    // Reads a node; `word` is its first word.
    VrmlNamed node(std::string_view word) {
        if (word == "NULL") return {};
        if (word == "USE") {
            const auto known = named_.find(some_word());
            if (known == named_.end()) refuse("USE names nothing that was defined before");
            return known->second;
        }
        std::string name;
        if (word == "DEF") {
            name = some_word();
            word = some_word();
        }
        if (++depth_ > kDeepestNode) refuse("nodes stand too deep in each other");
        VrmlNamed made = body_of(std::string(word));
        --depth_;
        // A name of an invisible node has to be known, too.
        if (!name.empty()) named_[name] = made;
        return made;
    }

    VrmlNamed body_of(const std::string& type) {
        if (type == "Group" || type == "Transform" || type == "Anchor" || type == "Billboard" ||
            type == "Collision") {
            return {group(), nullptr};
        }
        if (type == "Switch") return {one_of("choice", -1), nullptr};
        if (type == "LOD") return {one_of("level", 0), nullptr};
        if (type == "Shape") return {shape(), nullptr};
        if (type == "IndexedFaceSet") return {face_set(), nullptr};
        if (type == "Box") return {box(), nullptr};
        if (type == "Coordinate") return {nullptr, points()};
        if (!is_without_body(type)) {
            // The type may be any text.
            std::string shown = type.substr(0, 40);
            std::ranges::replace_if(
                shown, [](char c) { return c < ' ' || c > '~'; }, '?');
            refuse(fmt::format("'{}' is not read: IndexedFaceSet and Box are", shown));
        }
        expect("{");
        skip_to_end();
        return {};
    }

    VrmlNodePointer group() {
        auto made = std::make_shared<VrmlNode>();
        Vec3 translation, centre, scale{1, 1, 1}, axis{0, 0, 1}, scale_axis{0, 0, 1};
        double angle = 0.0, scale_angle = 0.0;
        fields([&](std::string_view name) {
            if (name == "children") {
                nodes([&](const VrmlNamed& child) {
                    if (child.node) made->children.push_back(child.node);
                });
            } else if (name == "translation") {
                translation = vector();
            } else if (name == "center") {
                centre = vector();
            } else if (name == "scale") {
                scale = vector();
            } else if (name == "rotation") {
                axis = vector();
                angle = number<double>();
            } else if (name == "scaleOrientation") {
                scale_axis = vector();
                scale_angle = number<double>();
            } else {
                return false;
            }
            return true;
        });
        Affine scaling;
        scaling.rows = {Vec3{scale.x, 0, 0}, Vec3{0, scale.y, 0}, Vec3{0, 0, scale.z}};
        made->placing = shift_by(translation) * shift_by(centre) * turn_about(axis, angle) *
                        turn_about(scale_axis, scale_angle) * scaling *
                        turn_about(scale_axis, -scale_angle) * shift_by(-centre);
        return made;
    }

    VrmlNodePointer one_of(std::string_view list, int which) {
        auto made = std::make_shared<VrmlNode>();
        std::vector<VrmlNodePointer> all;
        fields([&](std::string_view name) {
            if (name == list) {
                nodes([&](const VrmlNamed& child) { all.push_back(child.node); });
            } else if (name == "whichChoice") {
                which = number<int>();
            } else {
                return false;
            }
            return true;
        });
        if (which >= 0 && static_cast<std::size_t>(which) < all.size() &&
            all[static_cast<std::size_t>(which)]) {
            made->children.push_back(all[static_cast<std::size_t>(which)]);
        }
        return made;
    }

    VrmlNodePointer shape() {
        auto made = std::make_shared<VrmlNode>();
        fields([&](std::string_view name) {
            if (name != "geometry") return false;
            const VrmlNamed geometry = node(some_word());
            if (geometry.node) made->children.push_back(geometry.node);
            return true;
        });
        return made;
    }

    std::shared_ptr<const std::vector<Vec3>> points() {
        auto made = std::make_shared<std::vector<Vec3>>();
        fields([&](std::string_view name) {
            if (name != "point") return false;
            if (peek() != "[") {
                made->push_back(vector());
                return true;
            }
            next();
            while (peek() != "]")
                made->push_back(vector());
            next();
            return true;
        });
        return made;
    }

    VrmlNodePointer face_set() {
        auto made = std::make_shared<VrmlNode>();
        bool is_ccw = true;
        std::vector<std::uint32_t> face;
        const auto finish_face = [&] {
            if (!face.empty()) made->faces.faces.push_back(std::move(face));
            face.clear();
        };
        const auto index = [&] {
            const auto number_of_point = number<std::int64_t>();
            if (number_of_point == -1) return finish_face();
            if (number_of_point < 0 || number_of_point > 0xFFFF'FFFF)
                refuse("a face names a point that is not there");
            face.push_back(static_cast<std::uint32_t>(number_of_point));
        };
        fields([&](std::string_view name) {
            if (name == "coord") {
                const VrmlNamed specified = node(some_word());
                if (!specified.points) refuse("expected the points of the faces (Coordinate)");
                made->faces.points = *specified.points;
            } else if (name == "coordIndex") {
                if (peek() == "[") {
                    next();
                    while (peek() != "]")
                        index();
                    next();
                } else {
                    index();
                }
                finish_face();
            } else if (name == "ccw") {
                is_ccw = yes_or_no();
            } else {
                return false;
            }
            return true;
        });
        for (auto& specified : made->faces.faces) {
            if (!is_ccw) std::ranges::reverse(specified);
        }
        return made;
    }

    VrmlNodePointer box() {
        auto made = std::make_shared<VrmlNode>();
        Vec3 size{2, 2, 2};
        fields([&](std::string_view name) {
            if (name != "size") return false;
            size = vector();
            return true;
        });
        for (int i = 0; i < 8; ++i) {
            made->faces.points.push_back({(i & 1 ? 0.5 : -0.5) * size.x,
                                          (i & 2 ? 0.5 : -0.5) * size.y,
                                          (i & 4 ? 0.5 : -0.5) * size.z});
        }
        made->faces.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        return made;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    std::map<std::string, VrmlNamed, std::less<>> named_;
};

// Collects the corners of all shapes. A short file may contain very many shapes (USE within USE).
class CornerCollector {
public:
    void visit(const VrmlNode& node, const Affine& above) {
        if (++visits_ > kMostVisits) throw Refused{"it has more than 100,000 nodes"};
        const Affine placing = above * node.placing;
        Polygons faces = node.faces;
        for (Vec3& p : faces.points)
            p = placing(p);
        if (placing.determinant() < 0.0) {
            for (auto& face : faces.faces)
                std::ranges::reverse(face);
        }
        const std::vector<Vec3> more = corners_of(faces);
        if (corners_.size() + more.size() > kMostCorners)
            throw Refused{"it has more than ten million triangles"};
        corners_.insert(corners_.end(), more.begin(), more.end());
        for (const VrmlNodePointer& child : node.children)
            visit(*child, placing);
    }
    std::vector<Vec3> take() { return std::move(corners_); }

private:
    std::vector<Vec3> corners_;
    std::size_t visits_ = 0;
};

}  // namespace

bool is_vrml(std::string_view bytes) {
    return bytes.starts_with("#VRML ");
}

std::vector<Vec3> read_vrml(std::string_view bytes) {
    if (!bytes.starts_with("#VRML V2.0 utf8")) throw Refused{"VRML, but not VRML97 (V2.0 utf8)"};
    const VrmlNodePointer root = VrmlReader(bytes).read();
    CornerCollector collector;
    collector.visit(*root, {});
    return collector.take();
}

}  // namespace ncsim::setup
