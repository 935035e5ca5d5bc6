// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sample machine: files that `run --show-machine` writes move as the program says.
#include "ncsim/base/angles.h"
#include "ncsim/machine/relative.h"
#include "ncsim/setup/machine_formats.h"

#include "cli/run_program.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using machine::Pose;

const std::string kSamples = std::string(NCSIM_SOURCE_DIR) + "/samples/";

std::vector<std::string> sample_run(std::vector<std::string> more) {
    std::vector<std::string> words{"run",         kSamples + "five-axis.nc",
                                   "--job",       kSamples + "five-axis.toml",
                                   "--machine",   kSamples + "machines/trunnion.toml",
                                   "--tolerance", "0.05",
                                   "-q",          "--show-machine"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// Independent glTF reader: pose of each node at any time, according to the format.
class Scene {
public:
    explicit Scene(const std::string& path) {
        std::string errors, warnings;
        EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model_, &errors, &warnings, path))
            << errors;
        EXPECT_EQ(errors + warnings, "");
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            for (const int child : model_.nodes[i].children)
                parents_[child] = static_cast<int>(i);
        }
    }

    const tinygltf::Model& model() const { return model_; }

    int node(const std::string& name) const {
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            if (model_.nodes[i].name == name) return static_cast<int>(i);
        }
        ADD_FAILURE() << "no node " << name;
        return 0;
    }

    // Returns the pose of a node in the frame of the node `machine`, which is the machine frame,
    // mm.
    Pose pose(int node, double seconds) const {
        const auto parent = parents_.find(node);
        if (parent == parents_.end()) return {};
        return pose(parent->second, seconds) * local(node, seconds);
    }
    Pose pose(const std::string& name, double seconds) const { return pose(node(name), seconds); }

    std::vector<double> sampled(int node, const std::string& path, double seconds) const {
        for (const tinygltf::Animation& animation : model_.animations) {
            for (const auto& channel : animation.channels) {
                if (channel.target_node != node || channel.target_path != path) continue;
                return sampled(animation.samplers[static_cast<std::size_t>(channel.sampler)],
                               seconds);
            }
        }
        return {};
    }

    std::vector<float> floats(int accessor) const {
        const auto& a = model_.accessors[static_cast<std::size_t>(accessor)];
        const auto& view = model_.bufferViews[static_cast<std::size_t>(a.bufferView)];
        std::vector<float> values(
            a.count * static_cast<std::size_t>(
                          tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type))));
        std::memcpy(values.data(), model_.buffers[0].data.data() + view.byteOffset,
                    values.size() * sizeof(float));
        return values;
    }

    // Returns all times at which moves of a line begin, s.
    std::vector<double> times_of(int line) const {
        std::vector<double> times;
        const auto& extras = model_.animations.at(0).extras;
        const auto& lines = extras.Get("lines");
        for (std::size_t i = 0; i < lines.ArrayLen(); ++i) {
            const int index = static_cast<int>(i);
            if (lines.Get(index).GetNumberAsInt() == line)
                times.push_back(extras.Get("seconds").Get(index).GetNumberAsDouble());
        }
        return times;
    }

private:
    std::vector<double> sampled(const tinygltf::AnimationSampler& sampler, double seconds) const {
        const std::vector<float> times = floats(sampler.input);
        const std::vector<float> values = floats(sampler.output);
        const std::size_t width = values.size() / times.size();
        const auto value = [&](std::size_t key) {
            return std::vector<double>(
                values.begin() + static_cast<std::ptrdiff_t>(key * width),
                values.begin() + static_cast<std::ptrdiff_t>((key + 1) * width));
        };
        EXPECT_TRUE(std::ranges::is_sorted(times, std::less_equal<>()) || times.size() == 1);
        std::size_t next = 0;
        while (next < times.size() && static_cast<double>(times[next]) <= seconds)
            ++next;
        if (next == 0) return value(0);
        if (next == times.size() || sampler.interpolation == "STEP") return value(next - 1);
        const double t0 = static_cast<double>(times[next - 1]);
        const double share = (seconds - t0) / (static_cast<double>(times[next]) - t0);
        std::vector<double> a = value(next - 1);
        const std::vector<double> b = value(next);
        double cosine = 0.0;
        for (std::size_t i = 0; i < width; ++i)
            cosine += a[i] * b[i];
        double of_a = 1.0 - share, of_b = share;
        if (width == 4 && cosine < 1.0 - 1e-9) {
            EXPECT_GE(cosine, 0.7071);  // half of 90 degrees
            const double angle = std::acos(cosine);
            of_a = std::sin((1.0 - share) * angle) / std::sin(angle);
            of_b = std::sin(share * angle) / std::sin(angle);
        }
        for (std::size_t i = 0; i < width; ++i)
            a[i] = of_a * a[i] + of_b * b[i];
        return a;
    }

    Pose local(int number, double seconds) const {
        const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(number)];
        const auto take = [&](const char* path, const std::vector<double>& still) {
            const auto moved = sampled(number, path, seconds);
            return moved.empty() ? still : moved;
        };
        const auto t = take("translation", node.translation);
        const auto q = take("rotation", node.rotation);
        Pose X;
        if (!t.empty()) X.translation = {t[0], t[1], t[2]};
        if (!q.empty()) {
            const double x = q[0], y = q[1], z = q[2], w = q[3];
            X.rows = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                       {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                       {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
        }
        return X;
    }

    tinygltf::Model model_;
    std::map<int, int> parents_;
};

// Returns the values of the words in effect at each line; words are modal.
std::map<int, std::map<char, double>> positions() {
    std::ifstream in(kSamples + "five-axis.nc");
    std::map<int, std::map<char, double>> of_line;
    std::map<char, double> now;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (line.empty() || line[0] != 'G') continue;
        const std::regex word("([XYZAC])(-?[0-9.]+)");
        for (std::sregex_iterator w(line.begin(), line.end(), word), end; w != end; ++w)
            now[(*w)[1].str()[0]] = std::stod((*w)[2].str());
        of_line[number] = now;
    }
    return of_line;
}

double apart(Vec3 a, Vec3 b) {
    return norm(a - b);
}

// In the frame of the part the tip moves straight from end to end of each move, with the direction
// that A and C of the program specify.
TEST(MovingMachine, CarriesTheTipThroughThePartAsTheProgramSays) {
    Folder folder;
    const Ran ran = folder.run(sample_run({"--gltf", "m.glb"}));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const Scene scene((folder.path() / "m.glb").string());
    const double missed = scene.model().animations.at(0).extras.Get("error_mm").GetNumberAsDouble();
    EXPECT_GT(missed, 0.0);
    EXPECT_LE(missed, 0.01);
    // The node of the part is at the centre of the block, in whole millimetres.
    const Vec3 centre{0, 0, -10};
    const auto at = [&](double seconds) {
        const Pose X_MW = scene.pose("part", seconds);
        const Pose X_WT = machine::inverse(X_MW) * scene.pose("T1", seconds);
        return std::pair(X_WT.translation + centre, axis_of(X_WT));
    };
    const auto of_line = positions();
    int compared = 0;
    constexpr int kTipControl = 13;
    for (const auto& [line, words] : of_line) {
        const auto next = of_line.upper_bound(line);
        const auto begins = scene.times_of(line);
        if (line <= kTipControl || next == of_line.end() || begins.empty()) continue;
        const auto ends = scene.times_of(next->first);
        if (ends.empty()) continue;
        ASSERT_LT(begins[0], ends[0]);
        const auto [tip, axis] = at(ends[0]);
        const Vec3 specified{words.at('X'), words.at('Y'), words.at('Z')};
        // Positions and times are stored as floats.
        EXPECT_LT(apart(tip, specified), 1e-3 + missed) << line;
        // The table turns the part by the right hand: A, then C, inverted.
        const SinCos a = sin_cos(words.at('A')), c = sin_cos(words.at('C'));
        EXPECT_LT(apart(axis, {c.sin * a.sin, c.cos * a.sin, a.cos}), 1e-5) << line;
        // On the line between both ends.
        const Vec3 from = at(begins[0]).first;
        for (const double share : {0.21, 0.5, 0.83}) {
            const Vec3 there = at(begins[0] + share * (ends[0] - begins[0])).first;
            EXPECT_LT(apart(there, from + share * (specified - from)), 2e-3 + 3 * missed) << line;
        }
        ++compared;
    }
    EXPECT_GE(compared, 85);
}

// Each link is where the joints of its chain place it.
TEST(MovingMachine, HasEveryLinkWhereItsJointsBringIt) {
    Folder folder;
    const Ran ran = folder.run(sample_run({"--gltf", "m.glb"}));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const Scene scene((folder.path() / "m.glb").string());
    setup::InputSet inputs;
    const setup::MachineFile file =
        setup::read_machine(kSamples + "machines/trunnion.toml", inputs);
    ASSERT_EQ(file.bodies.size(), 7U);
    // Returns the joint values in the samplers of the file.
    const auto values_at = [&](double seconds) {
        machine::Values values{};
        for (const auto& [link, axis] :
             std::map<std::string, char>{{"saddle", 'Y'}, {"carriage", 'X'}, {"head", 'Z'}}) {
            const double place = scene.sampled(scene.node(link), "translation", seconds)
                                     .at(static_cast<std::size_t>(axis - 'X'));
            // A table moves in the opposite direction.
            values[*machine::index_of(axis)] = axis == 'Y' ? -place : place;
        }
        for (const auto& [link, axis] :
             std::map<std::string, char>{{"cradle", 'A'}, {"platter", 'C'}}) {
            const auto q = scene.sampled(scene.node(link), "rotation", seconds);
            // Positive values turn the part by the right hand.
            const double along = axis == 'A' ? q.at(0) : q.at(2);
            values[*machine::index_of(axis)] = 2.0 * angle_of(q.at(3), along);
        }
        return values;
    };
    bool has_tilted = false;
    for (const double seconds : {0.0, 11.3, 20.0, 33.7, 47.1, 62.9}) {
        const machine::Values values = values_at(seconds);
        has_tilted |= std::abs(values[3]) > 5.0;
        for (const setup::MachineBody& body : file.bodies) {
            const int node = scene.node(body.link);
            const tinygltf::Node& of_link = scene.model().nodes[static_cast<std::size_t>(node)];
            const auto& mesh = scene.model().meshes[static_cast<std::size_t>(of_link.mesh)];
            const std::vector<float> points =
                scene.floats(mesh.primitives[0].attributes.at("POSITION"));
            const std::vector<Vec3> corners = corners_at(body, values);
            ASSERT_EQ(points.size(), 3 * corners.size());
            const Pose X = scene.pose(node, seconds);
            for (std::size_t i = 0; i < corners.size(); i += 7) {
                const Vec3 p{static_cast<double>(points[3 * i]),
                             static_cast<double>(points[3 * i + 1]),
                             static_cast<double>(points[3 * i + 2])};
                EXPECT_LT(apart(X * p, corners[i]), 1e-3) << body.link << " " << seconds;
            }
        }
    }
    EXPECT_TRUE(has_tilted);
    const tinygltf::Node& cradle =
        scene.model().nodes[static_cast<std::size_t>(scene.node("cradle"))];
    EXPECT_EQ(cradle.extras.Get("axis").Get<std::string>(), "A");
    EXPECT_TRUE(cradle.extras.Get("turns").Get<bool>());
    EXPECT_EQ(cradle.extras.Get("through_z").GetNumberAsDouble(), -320.0);
    EXPECT_EQ(cradle.extras.Get("direction_x").GetNumberAsDouble(), 1.0);
    // assimp, an independent reader, opens the file.
    EXPECT_EQ(folder.shell("assimp export m.glb m.stl >out.txt && test -s m.stl").exit_code, 0)
        << folder.read("out.txt");
}

// A tool is visible while it is in the spindle; a rotation of more than half a turn is complete.
TEST(MovingMachine, ChangesToolsAndTurnsAllTheWay) {
    Folder folder;
    folder.write("a.nc",
                 "(T1 D=6. CR=0. - flat end mill)\n(T2 D=10. CR=0. - flat end mill)\n"
                 "(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\n(FROM/0.,0.,50.)\n"
                 "G21 G90 G17 G94\nT1 M6\nS5000 M3\nG0 X0 Y0 Z40\nG1 Z10 F300\nG1 C-300 F600\n"
                 "G0 Z40\nT2 M6\nG0 Z30\nT1 M6\nG0 Z20\nM30\n");
    const Ran ran = folder.run({"run", "a.nc", "--machine", kSamples + "machines/trunnion.toml",
                                "--show-machine", "--gltf", "m.glb", "--vrml", "m.wrl"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const Scene scene((folder.path() / "m.glb").string());
    const auto shown = [&](const std::string& tool, double seconds) {
        return scene.sampled(scene.node(tool), "scale", seconds).at(0);
    };
    const double first = scene.times_of(9).at(0), second = scene.times_of(13).at(0);
    const double third = scene.times_of(15).at(0);
    EXPECT_EQ(shown("T1", first), 1.0);
    EXPECT_EQ(shown("T2", first), 0.0);
    EXPECT_EQ(shown("T1", second + 0.01), 0.0);
    EXPECT_EQ(shown("T2", second + 0.01), 1.0);
    EXPECT_EQ(shown("T1", third + 0.01), 1.0);
    EXPECT_EQ(shown("T2", third + 0.01), 0.0);
    // 300 degrees at 600 degrees per minute take half a minute.
    const double from = scene.times_of(10).at(0);
    const Pose home = scene.pose("platter", from);
    for (const double degrees : {60.0, 150.0, 240.0, 299.0}) {
        const Pose X = machine::inverse(home) * scene.pose("platter", from + degrees / 10.0);
        // Positive values turn the part by the right hand.
        const SinCos q = sin_cos(-degrees);
        EXPECT_NEAR(X.rows[0].x, q.cos, 1e-4) << degrees;
        EXPECT_NEAR(X.rows[1].x, q.sin, 1e-4) << degrees;
    }
    const std::string vrml = folder.read("m.wrl");
    for (const char* text : {"#VRML V2.0", "DEF LINK_2_cradle Transform", "DEF CLOCK TimeSensor",
                             "DEF JOINT_C OrientationInterpolator", "DEF PART Transform",
                             "ROUTE JOINT_C.value_changed TO LINK_3_platter.set_rotation"}) {
        EXPECT_NE(vrml.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(vrml.find("JOINT_A"), std::string::npos);
}

// Line 12 of a subprogram in another file is not line 12 of the program.
TEST(MovingMachine, TellsNoLinesOfOtherFiles) {
    Folder folder;
    folder.write("a.ngc",
                 "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\n"
                 "(FROM/0.,0.,50.)\nG21 G90 G17 G94\nT1 M6\nS5000 M3\nG0 X0 Y0 Z40\n"
                 "o<far> call\nG0 Z40\nM2\n");
    folder.write("far.ngc", "o<far> sub\n\n\n\n\n\n\n\n\n\n\nG1 Z9 F300\nG1 X5\no<far> endsub\n");
    const std::string machine = kSamples + "machines/trunnion.toml";
    const Ran ran = folder.run(
        {"run", "a.ngc", "--machine", machine, "--show-machine", "--gltf", "m.glb", "-q"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const Scene scene((folder.path() / "m.glb").string());
    EXPECT_EQ(scene.times_of(9).size(), 1U);
    EXPECT_EQ(scene.times_of(12).size() + scene.times_of(13).size(), 0U);
}

// In pictures either the part or the machine is at rest.
TEST(MovingMachine, StandsStillInPicturesUnlessThePartDoes) {
    Folder folder;
    const auto picture = [&](const std::string& line, const std::string& frame) {
        std::vector<std::string> more{"--at-line", line, "--png", "p.png", "--size", "320x240"};
        if (!frame.empty()) more.insert(more.end(), {"--frame", frame});
        const Ran ran = folder.run(sample_run(more));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read("p.png");
    };
    const std::string machine = picture("20", "machine");
    EXPECT_EQ(machine, picture("20", ""));
    EXPECT_NE(machine, picture("20", "part"));
    EXPECT_EQ(folder.run(sample_run({"--frame", "moon"})).exit_code, 2);
    EXPECT_EQ(folder.run({"run", "a.nc", "--frame", "part"}).exit_code, 2);
}

// The part equals the part of the preset, and the verdict is clean.
TEST(MovingMachine, IsTheSamePartAsOnThePresetAndClean) {
    Folder folder;
    const auto part = [&](const std::string& machine) {
        const Ran ran = folder.run({"run", kSamples + "five-axis.nc", "--job",
                                    kSamples + "five-axis.toml", "--machine", kSamples + machine,
                                    "--tolerance", "0.05", "-q", "--stl", "p.stl"});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read("p.stl");
    };
    EXPECT_EQ(part("machines/trunnion.toml"), part("machines/trt.toml"));
    const Ran checked =
        folder.run({"check", kSamples + "five-axis.nc", "--job", kSamples + "five-axis.toml",
                    "--machine", kSamples + "machines/trunnion.toml", "--tolerance", "0.05"});
    EXPECT_EQ(checked.exit_code, 0) << checked.out;
    EXPECT_NE(checked.out.find(": clean:"), std::string::npos) << checked.out;
}

// The meshes of the links equal the results of their programs, byte for byte, except for the
// header, in which a run names its assumptions.
TEST(MovingMachine, IsMilledByItsOwnPrograms) {
    Folder folder;
    const Ran ran = folder.shell("\"" + kSamples + "machines/links/mill.sh\" \"$0\" .");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    for (const char* link :
         {"base", "saddle", "cradle", "platter", "carriage", "head", "spindle"}) {
        std::ifstream in(kSamples + "machines/links/" + link + ".stl", std::ios::binary);
        std::ostringstream kept;
        kept << in.rdbuf();
        constexpr std::size_t kHeader = 80;
        EXPECT_EQ(folder.read(std::string(link) + ".stl").substr(kHeader),
                  kept.str().substr(kHeader))
            << link;
    }
}

// The key of a cached verdict contains the contents of each mesh.
TEST(MovingMachine, IsCheckedAnewWhenAMeshHasChanged) {
    Folder folder;
    std::filesystem::copy(kSamples + "machines", folder.path(),
                          std::filesystem::copy_options::recursive);
    // Program up to the end of the first vane, with the return.
    std::ifstream in(kSamples + "five-axis.nc");
    std::string program, line, said;
    for (int number = 1; number <= 30 && std::getline(in, line); ++number)
        program += line + "\n";
    folder.write("a.nc", program + "G0 X0. Y0. Z60. A0. C0.\nM429\nM5\nM30\n");
    const auto check = [&] {
        const Ran ran = folder.run({"check", "a.nc", "--job", kSamples + "five-axis.toml",
                                    "--machine", "trunnion.toml", "--cache", "kept"});
        said = ran.out;
        return ran.exit_code;
    };
    EXPECT_EQ(check(), 0);
    EXPECT_EQ(check(), 0);
    const std::string platter = folder.read("links/platter.stl");
    folder.write("links/platter.stl", folder.read("links/carriage.stl"));
    EXPECT_EQ(check(), 1);
    folder.write("links/platter.stl", platter);
    EXPECT_EQ(check(), 0);
    // The machine file itself specifies the clearance between links and tool.
    const std::string machine = folder.read("trunnion.toml");
    std::string wider = machine;
    wider.replace(wider.find("clearance = 5"), 13, "clearance = 500");
    folder.write("trunnion.toml", wider);
    EXPECT_EQ(check(), 1);
    EXPECT_NE(said.find("[machine-near-miss]"), std::string::npos) << said;
    folder.write("trunnion.toml", "ignore = [[\"head\", \"part\"]]\n" + machine);
    EXPECT_EQ(check(), 0);
}

}  // namespace
}  // namespace ncsim::cli_test
