// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines in URDF, in three steps:
// 1. The elements become links and joints, each joint in the frame of its parent.
// 2. All links are placed, from the root on, with all joints at 0.
// 3. The links are converted to the frame of the spindle nose.
#include "machines/urdf_machine.h"

#include "ncsim/base/angles.h"
#include "ncsim/machine/relative.h"
#include "ncsim/setup/mesh_file.h"

#include "machines/xml_root.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::setup {

namespace {

using machine::Pose;
using tinyxml2::XMLElement;

constexpr double kMillimetres = 1000.0;  // per metre
constexpr std::size_t kMostLinksOfFile = 100;

// Returns a rotation by roll about x, then pitch about y, then yaw about z, all about fixed axes.
Pose turned_by(Vec3 roll_pitch_yaw) {
    Pose X;
    for (int axis = 2; axis >= 0; --axis) {
        machine::Joint joint;
        joint.turns = true;
        joint.direction[axis] = 1.0;
        X = X * pose_of(joint, roll_pitch_yaw[axis] / kRadiansPerDegree);
    }
    return X;
}

struct UrdfLink {
    const XMLElement* at = nullptr;
    std::string name;
    TriangleMesh mesh;  // in its own frame, mm
    double deflection_mm = 0.0;
    std::string assumed;
    const XMLElement* mesh_at = nullptr;     // the last mesh
    const XMLElement* carried_by = nullptr;  // joint that carries the link
    std::size_t parent = 0;
    Pose X_of_parent;
    std::optional<machine::Joint> joint;  // in its own frame
    std::optional<std::pair<double, double>> limits;
    double rate = 0.0;  // per minute
    bool is_placed = false;
    Pose X_placed;
};

class UrdfReader {
public:
    UrdfReader(std::string name, std::string folder, InputSet& inputs)
        : name_(std::move(name)), folder_(std::move(folder)), inputs_(inputs) {}

    MachineFile read(const std::string& text) {
        tinyxml2::XMLDocument document;
        const XMLElement* robot = xml_root(document, text, name_, "robot", " (URDF)");
        for (const XMLElement* e = robot->FirstChildElement("link"); e;
             e = e->NextSiblingElement("link")) {
            take_link(e);
        }
        for (const XMLElement* e = robot->FirstChildElement("joint"); e;
             e = e->NextSiblingElement("joint")) {
            take_joint(e);
        }
        const std::size_t part = find(robot, "workpiece"), tool = find(robot, "tool");
        place_all(robot);
        MachineFile file;
        if (const char* title = robot->Attribute("name")) file.machine.name = title;
        build(file, part, tool);
        return file;
    }

private:
    std::string place_of(const XMLElement* at) const {
        return fmt::format("{}:{}", name_, at->GetLineNum());
    }

    [[noreturn]] void fail(const XMLElement* at, const std::string& what) const {
        throw std::runtime_error(fmt::format("{}: {}", place_of(at), what));
    }

    std::string text(const XMLElement* e, const char* key) const {
        const char* value = e->Attribute(key);
        if (!value || !*value) fail(e, fmt::format("<{}> needs '{}'", e->Name(), key));
        return value;
    }

    // Reads exactly as many numbers as `numbers` has elements, separated by blanks.
    void take_numbers(const XMLElement* e, const char* key, std::string_view rest,
                      std::span<double> numbers) const {
        constexpr double kLargestNumber = 1e6;
        constexpr std::string_view kBlanks = " \t\r\n+";
        for (double& number : numbers) {
            rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
            const auto [end, error] =
                std::from_chars(rest.data(), rest.data() + rest.size(), number);
            if (error != std::errc{} || !(std::abs(number) <= kLargestNumber)) {
                fail(e, fmt::format("'{}': expected {} number{}, at most 1000000", key,
                                    numbers.size(), numbers.size() == 1 ? "" : "s"));
            }
            rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        }
        if (rest.find_first_not_of(kBlanks) != std::string_view::npos)
            fail(e, fmt::format("'{}': more than {} numbers", key, numbers.size()));
    }

    Vec3 vector(const XMLElement* e, const char* key, Vec3 otherwise) const {
        const char* value = e ? e->Attribute(key) : nullptr;
        if (!value) return otherwise;
        std::array<double, 3> numbers{};
        take_numbers(e, key, value, numbers);
        return {numbers[0], numbers[1], numbers[2]};
    }

    std::optional<double> number(const XMLElement* e, const char* key) const {
        const char* value = e ? e->Attribute(key) : nullptr;
        if (!value) return std::nullopt;
        std::array<double, 1> numbers{};
        take_numbers(e, key, value, numbers);
        return numbers[0];
    }

    // Returns the pose of <origin>, mm.
    Pose origin(const XMLElement* of) const {
        const XMLElement* e = of->FirstChildElement("origin");
        Pose X = turned_by(vector(e, "rpy", {}));
        X.translation = kMillimetres * vector(e, "xyz", {});
        return X;
    }

    std::size_t find(const XMLElement* at, const std::string& name) const {
        const auto found = std::ranges::find(links_, name, &UrdfLink::name);
        if (found == links_.end()) fail(at, fmt::format("there is no link '{}'", name));
        return static_cast<std::size_t>(found - links_.begin());
    }

    void take_link(const XMLElement* e) {
        UrdfLink link;
        link.at = e;
        link.name = text(e, "name");
        if (std::ranges::find(links_, link.name, &UrdfLink::name) != links_.end())
            fail(e, fmt::format("link '{}' is specified twice", link.name));
        if (links_.size() >= kMostLinksOfFile)
            fail(e, fmt::format("more than {} links", kMostLinksOfFile));
        const char* kind = e->FirstChildElement("collision") ? "collision" : "visual";
        for (const XMLElement* body = e->FirstChildElement(kind); body;
             body = body->NextSiblingElement(kind)) {
            take_body(body, link);
        }
        links_.push_back(std::move(link));
    }

    void take_body(const XMLElement* body, UrdfLink& link) {
        const XMLElement* geometry = body->FirstChildElement("geometry");
        const XMLElement* shape = geometry ? geometry->FirstChildElement() : nullptr;
        if (!shape) fail(body, fmt::format("<{}> needs a <geometry>", body->Name()));
        const std::string_view kind = shape->Name();
        TriangleMesh mesh;
        if (kind == "box") {
            const Vec3 size = kMillimetres * vector(shape, "size", {});
            if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0))
                fail(shape, "'size': the box has no volume");
            mesh = box(size);
        } else if (kind == "mesh") {
            mesh = mesh_of(shape, link);
            link.mesh_at = shape;
        } else {
            fail(shape, fmt::format("<{}> is not read: <mesh> and <box> are", kind));
        }
        const Pose X = origin(body);
        const auto first = static_cast<std::uint32_t>(link.mesh.vertices.size());
        for (const Vec3& p : mesh.vertices)
            link.mesh.vertices.push_back(X * p);
        for (const auto& t : mesh.triangles)
            link.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }

    static TriangleMesh box(Vec3 size) {
        TriangleMesh mesh;
        for (int i = 0; i < 8; ++i) {
            mesh.vertices.push_back({(i & 1 ? 0.5 : -0.5) * size.x, (i & 2 ? 0.5 : -0.5) * size.y,
                                     (i & 4 ? 0.5 : -0.5) * size.z});
        }
        mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        return mesh;
    }

    // Returns the path of a file relative to this file. Packages are below this folder or next to
    // it.
    std::string path_of(const XMLElement* e, std::string_view specified) const {
        constexpr std::string_view kPackage = "package://";
        if (!specified.starts_with(kPackage)) {
            if (specified.find("://") != std::string_view::npos)
                fail(e,
                     "'filename': expected a file in the folder of this file, or of its package");
            return seen_in(folder_, std::string(specified));
        }
        specified.remove_prefix(kPackage.size());
        specified.remove_prefix(std::min(specified.find('/') + 1, specified.size()));
        std::string below = seen_in(folder_, std::string(specified));
        std::error_code ignored;
        if (std::filesystem::exists(below, ignored)) return below;
        return seen_in(folder_, "../" + std::string(specified));
    }

    TriangleMesh mesh_of(const XMLElement* e, UrdfLink& link) {
        const std::string path = path_of(e, text(e, "filename"));
        SurfaceFile file;
        try {
            file = read_surface_file(path, inputs_);
        } catch (const std::runtime_error& error) {
            fail(e, error.what());
        }
        const Vec3 scale = vector(e, "scale", {1, 1, 1});
        // Formats with a unit of their own were converted to mm.
        const double unit = file.has_unit ? 1.0 : kMillimetres;
        for (Vec3& p : file.mesh.vertices)
            p = unit * Vec3{scale.x * p.x, scale.y * p.y, scale.z * p.z};
        const double sign = scale.x * scale.y * scale.z;
        if (sign == 0.0) fail(e, "'scale': the mesh has no volume");
        if (sign < 0.0) {
            for (auto& t : file.mesh.triangles)
                std::swap(t[0], t[1]);
        }
        const double most = std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)});
        link.deflection_mm = std::max(link.deflection_mm, most * file.deflection_mm);
        if (link.assumed.empty()) link.assumed = std::move(file.assumed);
        return std::move(file.mesh);
    }

    // Returns the axis named by "A", "joint_a", "C-axis".
    static std::optional<char> letter_of(std::string_view name) {
        const auto letter = [](std::string_view word) -> std::optional<char> {
            if (word.size() != 1) return std::nullopt;
            const char upper =
                word[0] >= 'a' && word[0] <= 'z' ? static_cast<char>(word[0] - 'a' + 'A') : word[0];
            const bool is_one = std::string_view("XYZABC").find(upper) != std::string_view::npos;
            return is_one ? std::optional(upper) : std::nullopt;
        };
        constexpr std::string_view kBetween = "_- .";
        if (const auto alone = letter(name)) return alone;
        const auto first = letter(name.substr(0, name.find_first_of(kBetween)));
        const std::size_t last = name.find_last_of(kBetween);
        const auto behind =
            last == std::string_view::npos ? std::nullopt : letter(name.substr(last + 1));
        // A letter at both ends is ambiguous.
        if (first && behind) return std::nullopt;
        return first ? first : behind;
    }

    void take_joint(const XMLElement* e) {
        const std::string name = text(e, "name"), type = text(e, "type");
        const auto named = [&](const char* role) {
            const XMLElement* child = e->FirstChildElement(role);
            if (!child) fail(e, fmt::format("joint '{}' needs its <{}>", name, role));
            return find(child, text(child, "link"));
        };
        const std::size_t parent = named("parent");
        UrdfLink& link = links_[named("child")];
        if (link.carried_by)
            fail(e, fmt::format("link '{}' has a joint already, in line {}", link.name,
                                link.carried_by->GetLineNum()));
        link.carried_by = e;
        link.parent = parent;
        link.X_of_parent = origin(e);
        if (type == "fixed") return;
        const bool turns = type == "revolute" || type == "continuous";
        if (!turns && type != "prismatic")
            fail(e, fmt::format("joint '{}': '{}' is not simulated", name, type));
        if (e->FirstChildElement("mimic"))
            fail(e, fmt::format("joint '{}': one that follows another is not simulated", name));
        const auto letter = letter_of(name);
        if (!letter)
            fail(e,
                 fmt::format("joint '{}': which axis is it? Its name has to be X, Y, Z, A, B or C",
                             name));
        if (turns != (*letter <= 'C'))
            fail(e, fmt::format("joint '{}': X, Y and Z move straight, A, B and C turn", name));
        for (const UrdfLink& other : links_) {
            if (other.joint && other.joint->letter == *letter)
                fail(e, fmt::format("axis {} is specified twice", *letter));
        }
        const XMLElement* axis = e->FirstChildElement("axis");
        const Vec3 direction = vector(axis, "xyz", {1, 0, 0});
        constexpr double kNothing = 1e-6;
        if (norm(direction) < kNothing) fail(axis, "'xyz': it has no length");
        link.joint = machine::joint_of(*letter, turns, direction);
        const double unit = turns ? 1.0 / kRadiansPerDegree : kMillimetres;
        const XMLElement* limit = e->FirstChildElement("limit");
        const auto low = number(limit, "lower"), high = number(limit, "upper");
        if (type != "continuous" && low && high) {
            if (*low > *high) fail(limit, "'upper' must be above 'lower'");
            // Limits of 0 and 0 count as unspecified.
            if (*low < *high) link.limits = {unit * *low, unit * *high};
        }
        const auto rate = number(limit, "velocity");
        if (rate && *rate > 0.0) link.rate = 60.0 * unit * *rate;
    }

    void place_all(const XMLElement* robot) {
        std::size_t roots = 0;
        for (UrdfLink& link : links_) {
            if (link.carried_by) continue;
            link.is_placed = true;
            if (++roots > 1)
                fail(link.at,
                     fmt::format("link '{}' hangs on nothing: which joint carries it?", link.name));
        }
        if (roots == 0) fail(robot, "its links carry each other in a circle");
        for (std::size_t i = 0; i < links_.size(); ++i)
            place(i, 0);
    }

    void place(std::size_t number_of_link, std::size_t depth) {
        UrdfLink& link = links_[number_of_link];
        if (link.is_placed) return;
        if (depth > links_.size())
            fail(link.carried_by, fmt::format("link '{}' carries itself", link.name));
        place(link.parent, depth + 1);
        link.X_placed = links_[link.parent].X_placed * link.X_of_parent;
        link.is_placed = true;
    }

    // Returns the joints from the root on, each as a motion of the link. M is the frame of the
    // tool.
    machine::Chain moved_by(std::size_t number_of_link, const Pose& X_MR) const {
        std::vector<machine::Joint> joints;
        for (std::size_t i = number_of_link;; i = links_[i].parent) {
            if (links_[i].joint) joints.push_back(in_M(links_[i], X_MR));
            if (!links_[i].carried_by) break;
        }
        std::ranges::reverse(joints);
        return {joints};
    }

    static machine::Joint in_M(const UrdfLink& link, const Pose& X_MR) {
        const Pose X = X_MR * link.X_placed;
        const Pose R{X.rows, {}};
        machine::Joint joint = *link.joint;
        joint.direction = exact(normalized(R * joint.direction));
        joint.through = joint.turns ? X.translation : Vec3{};
        return joint;
    }

    // Removes the rounding of rotations by 1.5707963 from directions along an axis.
    static Vec3 exact(Vec3 direction) {
        constexpr double kSame = 1e-6;
        for (int i = 0; i < 3; ++i) {
            Vec3 own;
            own[i] = direction[i] < 0.0 ? -1.0 : 1.0;
            if (norm(direction - own) < kSame) return own;
        }
        return direction;
    }

    void build(MachineFile& file, std::size_t part, std::size_t tool) {
        const Pose X_MR = machine::inverse(links_[tool].X_placed);
        SpecifiedKinematics specified;
        // Letters of axes whose positive values move the part along the axis, instead of the tool.
        std::string turned_round;
        machine::Chain part_moved_by = moved_by(part, X_MR), tool_moved_by = moved_by(tool, X_MR);
        for (const bool is_part : {true, false}) {
            for (const machine::Joint& joint : (is_part ? part_moved_by : tool_moved_by).joints) {
                if (joint.turns) continue;
                Vec3 own;
                own[joint.letter - 'X'] = is_part ? -1.0 : 1.0;
                if (joint.direction == own) continue;
                if (joint.direction != -own) {
                    fail(carrier_of(joint.letter).carried_by,
                         fmt::format("axis {}: only {} along itself is simulated, as the frame of "
                                     "'tool' has it",
                                     joint.letter, joint.letter));
                }
                turned_round += joint.letter;
            }
        }
        for (const char letter : turned_round) {
            UrdfLink& link = carrier_of(letter);
            link.joint->direction = -link.joint->direction;
            if (link.limits) link.limits = {-link.limits->second, -link.limits->first};
            specified.guess += fmt::format(
                "{}{} counts as the tool goes against the part, and not as the "
                "link does",
                specified.guess.empty() ? "" : "; ", letter);
        }
        part_moved_by = moved_by(part, X_MR);
        tool_moved_by = moved_by(tool, X_MR);
        specified.chain = machine::seen_from(part_moved_by, tool_moved_by);
        for (const UrdfLink& link : links_) {
            if (!link.joint) continue;
            const char letter = link.joint->letter;
            if (!specified.chain.find(letter))
                fail(link.carried_by,
                     fmt::format("axis {} does not move the tool against the part", letter));
            if (link.joint->turns && link.limits)
                specified.travels[letter] = {link.limits->first, link.limits->second};
            if (link.joint->turns) continue;
            const auto axis = static_cast<std::size_t>(letter - 'X');
            if (link.limits)
                file.machine.travel[axis] =
                    verify::AxisRange{link.limits->first, link.limits->second};
            if (link.rate > 0.0) file.machine.rapid[axis] = link.rate;
        }
        for (const char letter : std::string_view("XYZ")) {
            if (!specified.chain.find(letter))
                fail(links_[tool].at, fmt::format("no joint moves along {}", letter));
        }
        file.kinematics = std::move(specified);
        file.part_moved_by = std::move(part_moved_by);
        file.tool_moved_by = std::move(tool_moved_by);
        // Links that are only a frame are left out; their children belong to the link that carries
        // the frame.
        const auto is_frame = [&](std::size_t i) {
            return links_[i].mesh.triangles.empty() && !links_[i].joint &&
                   (i == part || i == tool || (!links_[i].carried_by && links_[i].name == "world"));
        };
        const auto known = [&](std::size_t i) {
            while (is_frame(i) && links_[i].carried_by)
                i = links_[i].parent;
            return is_frame(i) ? std::string() : links_[i].name;
        };
        file.part_link = known(part);
        file.tool_link = known(tool);
        for (std::size_t i = 0; i < links_.size(); ++i) {
            if (is_frame(i)) continue;
            const UrdfLink& link = links_[i];
            MachineBody body;
            body.link = link.name;
            if (link.carried_by) body.parent = known(link.parent);
            if (link.joint) body.joint = in_M(link, X_MR);
            body.moved_by = moved_by(i, X_MR);
            body.mesh = link.mesh;
            body.deflection_mm = link.deflection_mm;
            body.assumed = link.assumed;
            body.mesh_at = place_of(link.mesh_at ? link.mesh_at : link.at);
            const Pose X = X_MR * link.X_placed;
            for (Vec3& p : body.mesh.vertices)
                p = X * p;
            (body.mesh.triangles.empty() ? file.other_links : file.bodies)
                .push_back(std::move(body));
        }
    }

    UrdfLink& carrier_of(char letter) {
        return *std::ranges::find_if(links_, [letter](const UrdfLink& link) {
            return link.joint && link.joint->letter == letter;
        });
    }

    std::string name_, folder_;
    InputSet& inputs_;
    std::vector<UrdfLink> links_;
};

}  // namespace

MachineFile read_urdf_machine(const std::string& path, InputSet& inputs) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return UrdfReader(name_of_input(path), folder, inputs).read(inputs.read(path, kMostSetUpBytes));
}

}  // namespace ncsim::setup
