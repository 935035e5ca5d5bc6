// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs in files: identity of files, search for programs, records of inputs, closed surfaces, and
// tools that are estimated from moves.
#include "ncsim/setup/file_id.h"
#include "ncsim/setup/input_observer.h"
#include "ncsim/setup/mesh_file.h"
#include "ncsim/setup/program_folder.h"
#include "ncsim/setup/recorded_input.h"
#include "ncsim/setup/tool_clues.h"

#include "files/toml_reader.h"
#include "meshes/mesh_keys.h"
#include "meshes/step_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::setup {
namespace {

namespace fs = std::filesystem;

/// A new folder for the files of a test.
class Inputs : public testing::Test {
protected:
    Inputs() : folder_(fs::path(testing::TempDir()) / ("inputs-" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        folder_ = fs::canonical(folder_);
    }
    ~Inputs() override { fs::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) const {
        const fs::path path = folder_ / name;
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_;
};

std::string refusal(const std::function<void()>& read) {
    try {
        read();
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return {};
}

// --- Identity ---

FileId id_at(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
    return id_of(status);
}

TEST_F(Inputs, AFileHasOneIdentityUnderAllNames) {
    const std::string a = write("a.nc", "G0"), b = write("b.nc", "G0");
    fs::create_symlink("a.nc", path("link"));
    fs::create_hard_link(a, path("hard"));
    EXPECT_EQ(id_at(a), id_at(path("./a.nc")));
    EXPECT_EQ(id_at(a), id_at(path("link")));
    EXPECT_EQ(id_at(a), id_at(path("hard")));
    EXPECT_NE(id_at(a), id_at(b)) << "equal content is another file";
    EXPECT_NE(id_at(a) < id_at(b), id_at(b) < id_at(a));
    const FileId fresh = id_of_new(path("new.nc"));
    EXPECT_EQ(fresh, id_of_new(path("./new.nc")));
    EXPECT_NE(fresh, id_of_new(path("other.nc")));
    EXPECT_EQ(fresh.name, "new.nc");
    EXPECT_NE(refusal([&] { id_of_new(path("none/new.nc")); }), "");
}

TEST_F(Inputs, LinksAreFollowedToTheirTarget) {
    const std::string a = write("sub/a.nc", "G0");
    EXPECT_EQ(without_links(a), a);
    EXPECT_EQ(without_links(path("none")), path("none"));
    fs::create_symlink("sub/a.nc", path("one"));
    fs::create_symlink("one", path("two"));
    fs::create_symlink(a, path("absolute"));
    fs::create_symlink("nowhere", path("open"));
    EXPECT_EQ(without_links(path("one")), a);
    EXPECT_EQ(without_links(path("two")), a);
    EXPECT_EQ(without_links(path("absolute")), a);
    EXPECT_EQ(without_links(path("open")), path("nowhere"));
    fs::create_symlink("round", path("round"));
    EXPECT_NE(refusal([&] { without_links(path("round")); }).find(path("round")),
              std::string::npos);
    for (int i = 0; i < 40; ++i)
        fs::create_symlink(i == 0 ? std::string("sub/a.nc") : "l" + std::to_string(i - 1),
                           path("l" + std::to_string(i)));
    EXPECT_EQ(without_links(path("l39")), a) << "as many links as the kernel follows";
    fs::create_symlink("l39", path("l40"));
    EXPECT_NE(refusal([&] { without_links(path("l40")); }), "");
}

TEST_F(Inputs, DescriptorsAreThoseOfThisProcess) {
    EXPECT_EQ(descriptor_named("/proc/self/fd/1"), 1);
    EXPECT_EQ(descriptor_named("/proc/thread-self/fd/2"), 2);
    EXPECT_EQ(descriptor_named("/proc/" + std::to_string(::getpid()) + "/fd/0"), 0);
    EXPECT_EQ(descriptor_named("/proc/1/fd/1"), -1) << "another process";
    EXPECT_EQ(descriptor_named("/proc/self/fd/x"), -1);
    EXPECT_EQ(descriptor_named("/proc/self/fdinfo/1"), -1);
    EXPECT_EQ(descriptor_named(path("fd/1")), -1);
    EXPECT_EQ(descriptor_named(""), -1);
}

// --- Programs of a folder ---

TEST_F(Inputs, ProgramsAreFoundByNameOrText) {
    write("b.nc", "anything");
    write("a/1234", "%\nO1234\nG0 X1\nM30\n%\n");
    write("notes.txt", "A letter to a friend about the weather.\n");
    write("empty.dat", "");
    write("picture.dat", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
    write(".git/c.nc", "G0");
    write("a/.svn/c.nc", "G0");
    fs::create_symlink("b.nc", path("link.nc"));
    fs::create_symlink("/etc/hostname", path("out.nc"));
    fs::create_symlink("nowhere.nc", path("open.nc"));
    fs::create_symlink("a", path("folder.nc"));
    ASSERT_EQ(::mkfifo(path("pipe.nc").c_str(), 0600), 0);
    const ProgramFolder found = programs_in_folder(folder_.string());
    EXPECT_EQ(found.programs,
              (std::vector<std::string>{path("a/1234"), path("b.nc"), path("link.nc")}));
    std::vector<ExcludedEntry> excluded{{path(".git"), "folder of version control"},
                                        {path("a/.svn"), "folder of version control"},
                                        {path("empty.dat"), "empty file"},
                                        {path("folder.nc"), "link to a folder"},
                                        {path("notes.txt"), "text without G-code"},
                                        {path("open.nc"), "link that leads nowhere"},
                                        {path("out.nc"), "link out of the folder"},
                                        {path("picture.dat"), "binary file"},
                                        {path("pipe.nc"), "FIFO"}};
    ASSERT_EQ(found.excluded.size(), excluded.size());
    for (std::size_t i = 0; i < excluded.size(); ++i) {
        EXPECT_EQ(found.excluded[i].path, excluded[i].path);
        EXPECT_EQ(found.excluded[i].why, excluded[i].why) << excluded[i].path;
    }
    EXPECT_NE(refusal([&] { programs_in_folder(path("none")); }), "");
    EXPECT_FALSE(why_no_program(path("none"))) << "a missing file";
    EXPECT_FALSE(why_no_program(path("b.nc")));
    EXPECT_EQ(why_no_program(path("pipe.nc")), "FIFO");
}

TEST_F(Inputs, SubprogramsEndWithoutAnEndOfTheProgram) {
    EXPECT_TRUE(is_subprogram_file(write("s.nc", "%\nO1000\nG1 X1\nM99\n%\n")));
    EXPECT_FALSE(is_subprogram_file(write("m.nc", "%\nO1000\nG1 X1\nM30\n%\n")));
    EXPECT_FALSE(is_subprogram_file(path("none")));
    EXPECT_FALSE(is_subprogram_file(folder_.string()));
    std::string text = "%\nO1000\n";
    for (int i = 0; i < 50'000; ++i)
        text += "G1 X" + std::to_string(i) + "\n";
    EXPECT_TRUE(is_subprogram_file(write("long.nc", text + "M99\n%\n"))) << "head and tail decide";
    EXPECT_FALSE(is_subprogram_file(write("long.nc", text + "M30\n%\n")));
}

// --- Records ---

TEST_F(Inputs, RecordsDecideWhetherAVerdictIsTheSame) {
    const std::string a = write("a.nc", "G0"), b = write("b.nc", "G1");
    InputSet inputs;
    RecordedInput record(inputs);
    EXPECT_TRUE(record.knows_all());
    EXPECT_EQ(record.read(a), "G0");
    EXPECT_FALSE(record.is_there(path("none")));
    EXPECT_THROW(record.read(path("absent")), std::runtime_error);
    EXPECT_TRUE(record.is_there(b));
    EXPECT_TRUE(record.is_there(a));
    EXPECT_EQ(record.files().size(), 4U);
    const auto is_same = [&] {
        InputSet later;
        return std::ranges::all_of(record.files(), [&](const auto& file) {
            return digest_of_file(file.first, later) == file.second;
        });
    };
    EXPECT_TRUE(is_same()) << "nothing changed";
    write("a.nc", "G1");
    EXPECT_FALSE(is_same()) << "content";
    write("a.nc", "G0");
    write("none", "");
    EXPECT_FALSE(is_same()) << "a file that was missing";
    fs::remove(path("none"));
    EXPECT_TRUE(is_same());
    fs::remove(b);
    EXPECT_FALSE(is_same()) << "a file that was only asked about";
}

TEST_F(Inputs, RecordsKnowNoFoldersAndDevices) {
    const std::string a = write("a.nc", "G0");
    InputSet inputs;
    RecordedInput folder(inputs);
    folder.look_through(folder_.string());
    EXPECT_FALSE(folder.knows_all());
    RecordedInput missing(inputs);
    EXPECT_THROW(missing.read(folder_.string()), std::runtime_error);
    EXPECT_FALSE(missing.knows_all());
    EXPECT_EQ(digest_of_file(folder_.string(), inputs), std::nullopt);
    EXPECT_EQ(digest_of_file("/dev/null", inputs), std::nullopt);
    EXPECT_NE(digest_of_file(a, inputs), std::nullopt);
}

TEST_F(Inputs, ObserverSeesEachAccess) {
    const std::string a = write("a.nc", "G0");
    std::vector<std::string> seen;
    observe_inputs([&](const std::string& path) { seen.push_back(path); });
    InputSet inputs;
    inputs.read(a);
    inputs.is_there(path("none"));
    programs_in_folder(folder_.string());
    observe_inputs({});
    inputs.read(a);
    note_input("x");
    EXPECT_EQ(std::ranges::count(seen, a), 1);
    EXPECT_EQ(std::ranges::count(seen, path("none")), 1);
    EXPECT_EQ(std::ranges::count(seen, folder_.string()), 1);
    EXPECT_EQ(std::ranges::count(seen, "x"), 0);
}

// --- Surfaces ---

struct Facet {
    Vec3 a, b, c;
};

/// A tetrahedron of volume 1000/6 mm³ with its corners on the axes.
std::vector<Facet> tetrahedron() {
    const Vec3 o{0, 0, 0}, x{10, 0, 0}, y{0, 10, 0}, z{0, 0, 10};
    return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}

std::string text_stl(const std::vector<Facet>& facets, const std::string& title = "t") {
    std::ostringstream out;
    out << "solid " << title << '\n';
    for (const Facet& f : facets) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const Vec3& p : {f.a, f.b, f.c})
            out << "vertex " << p.x << ' ' << p.y << ' ' << p.z << '\n';
        out << "endloop\nendfacet\n";
    }
    out << "endsolid\n";
    return out.str();
}

std::string binary_stl(const std::vector<Facet>& facets) {
    std::string bytes = "solid that is binary";
    bytes.resize(80, ' ');
    const auto add = [&](std::uint32_t word) {
        for (int i = 0; i < 4; ++i)
            bytes += static_cast<char>(word >> (8 * i) & 0xff);
    };
    add(static_cast<std::uint32_t>(facets.size()));
    for (const Facet& f : facets) {
        for (int i = 0; i < 3; ++i)
            add(0);
        for (const Vec3& p : {f.a, f.b, f.c}) {
            for (int axis = 0; axis < 3; ++axis)
                add(std::bit_cast<std::uint32_t>(static_cast<float>(p[axis])));
        }
        bytes += std::string(2, '\0');
    }
    return bytes;
}

std::string obj(const std::vector<Facet>& facets) {
    std::ostringstream out;
    for (const Facet& f : facets) {
        for (const Vec3& p : {f.a, f.b, f.c})
            out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    for (std::size_t i = 0; i < facets.size(); ++i)
        out << "f " << 3 * i + 1 << ' ' << 3 * i + 2 << ' ' << 3 * i + 3 << '\n';
    return out.str();
}

double volume_of(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles)
        sum += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
    return sum;
}

TEST_F(Inputs, SurfacesOfEachFormatAreTheSame) {
    for (const std::string& bytes :
         {text_stl(tetrahedron()), binary_stl(tetrahedron()), obj(tetrahedron())}) {
        InputSet inputs;
        // The name does not matter; the first bytes decide.
        const SurfaceFile file = read_surface_file(write("part.stp", bytes), inputs);
        EXPECT_EQ(file.mesh.vertices.size(), 4U) << "equal corners are merged";
        EXPECT_EQ(file.mesh.triangles.size(), 4U);
        EXPECT_NEAR(volume_of(file.mesh), 1000.0 / 6, 1e-9);
        EXPECT_FALSE(file.has_unit);
        EXPECT_EQ(file.deflection_mm, 0.0);
        EXPECT_EQ(file.assumed, "");
    }
    // A triangle without area is removed, in any order of the triangles.
    std::vector<Facet> facets = tetrahedron();
    facets.push_back({{10, 0, 0}, {10, 0, 0}, {0, 10, 0}});
    std::ranges::reverse(facets);
    InputSet inputs;
    EXPECT_EQ(read_surface_file(write("t.stl", text_stl(facets)), inputs).mesh.triangles.size(),
              4U);
}

TEST_F(Inputs, SurfacesThatHaveNoInsideAreRefused) {
    std::vector<Facet> open = tetrahedron(), inverted = tetrahedron(), one = tetrahedron();
    open.pop_back();
    for (Facet& f : inverted)
        std::swap(f.b, f.c);
    std::swap(one[0].b, one[0].c);
    const auto refused = [&](const std::string& bytes) {
        InputSet inputs;
        return refusal([&] { read_surface_file(write("t.stl", bytes), inputs); });
    };
    EXPECT_NE(refused(text_stl(open)).find("not closed (3 open edges)"), std::string::npos);
    EXPECT_NE(refused(text_stl(one)).find("not closed"), std::string::npos);
    EXPECT_NE(refused(binary_stl(inverted)).find("inside out"), std::string::npos);
    for (const std::string& bytes : {std::string(), std::string("solid\nendsolid\n"),
                                     std::string("ISO"), text_stl(tetrahedron()).substr(0, 150),
                                     binary_stl(tetrahedron()).substr(0, 200), binary_stl({})})
        EXPECT_TRUE(refused(bytes).starts_with("'" + path("t.stl") + "': ")) << bytes.size();
    EXPECT_NE(refusal([&] {
                  InputSet inputs;
                  read_surface_file(path("none.stl"), inputs);
              }),
              "");
}

TEST_F(Inputs, StepFilesAreKnownByTheirFirstLine) {
    EXPECT_TRUE(is_step("ISO-10303-21;\nHEADER;"));
    EXPECT_FALSE(is_step(""));
    EXPECT_FALSE(is_step("ISO-10303-2"));
    EXPECT_FALSE(is_step("solid ISO-10303-21;"));
}

TEST_F(Inputs, MeshKeysCheckTheLength) {
    const auto read = [&](double size, const std::string& more) -> double {
        std::vector<Facet> facets = tetrahedron();
        for (Facet& f : facets)
            f = {size / 10 * f.a, size / 10 * f.b, size / 10 * f.c};
        write("t.stl", text_stl(facets));
        const TomlReader reader("m.toml", "mesh = \"t.stl\"\n" + more);
        InputSet inputs;
        const auto named =
            read_mesh(reader, folder_.string(), inputs, TomlTable(reader.root(), ""));
        EXPECT_EQ(named->place, "m.toml:1:8");
        EXPECT_EQ(named->as_hull, more == "hull = true\n");
        Box box;
        for (const Vec3& p : named->file.mesh.vertices)
            box.add(p);
        return box.size().x;
    };
    EXPECT_NEAR(read(10, ""), 10.0, 1e-9);
    EXPECT_NEAR(read(10, "hull = true\n"), 10.0, 1e-9);
    EXPECT_NEAR(read(5.0, ""), 5.0, 1e-9);
    EXPECT_NE(refusal([&] { read(4.99, ""); }).find("if it is in metres"), std::string::npos);
    EXPECT_NEAR(read(4.99, "scale = 1\n"), 4.99, 1e-9);
    EXPECT_NEAR(read(0.1, "scale = 1000\n"), 100.0, 1e-9);
    EXPECT_NE(refusal([&] { read(2e6, ""); }), "");
    const auto bad = [&](const std::string& text) {
        const TomlReader reader("m.toml", text);
        InputSet inputs;
        return refusal(
            [&] { read_mesh(reader, folder_.string(), inputs, TomlTable(reader.root(), "")); });
    };
    for (const char* text : {"hull = true\n", "scale = 2\n", "mesh = \"none.stl\"\n",
                             "mesh = \"t.stl\"\nstl = \"t.stl\"\n"})
        EXPECT_TRUE(bad(text).starts_with("m.toml:")) << text;
    EXPECT_EQ(bad(""), "");
}

// --- Estimates of tools ---

gcode::Position at(Vec3 p) {
    gcode::Position position;
    position.x = gcode::Length::from_mm(p.x);
    position.y = gcode::Length::from_mm(p.y);
    position.z = gcode::Length::from_mm(p.z);
    return position;
}

void add_line(ToolClues& clues, Vec3 from, Vec3 to) {
    gcode::Motion motion;
    motion.action = gcode::Linear{at(from), at(to)};
    clues.take(motion, toolpath::Poses(nullptr, motion));
}

/// A pocket of `size` mm whose lines are `step` mm apart; along Y if `turned`.
std::string guess_of_pocket(double size, double step, bool turned, bool inches = false) {
    ToolClues clues;
    const auto place = [turned](double a, double b) {
        return turned ? Vec3{b, a, -1} : Vec3{a, b, -1};
    };
    for (int i = 0; i * step <= size; ++i)
        add_line(clues, place(0, i * step), place(size, i * step));
    return clues.guess(inches);
}

TEST(ToolClues, ThePocketHasAFlatTool) {
    for (const bool turned : {false, true}) {
        // 2.5 steps, and at most a quarter of the width.
        EXPECT_EQ(guess_of_pocket(40, 2, turned), "flat:D5");
        EXPECT_EQ(guess_of_pocket(40, 1.9, turned), "flat:D4");
        EXPECT_EQ(guess_of_pocket(16, 2, turned), "flat:D4");
        EXPECT_EQ(guess_of_pocket(400, 20, turned), "flat:D6") << "the largest size";
        EXPECT_EQ(guess_of_pocket(0.4, 0.05, turned), "flat:D0.2") << "less than the smallest";
        EXPECT_EQ(guess_of_pocket(40, 2.54, turned, true), "flat:D1/4in");
        EXPECT_EQ(guess_of_pocket(40, 2.5, turned, true), "flat:D3/16in");
    }
    EXPECT_EQ(ToolClues().guess(false), "flat:D6") << "no moves";
    EXPECT_EQ(ToolClues().guess(true), "flat:D1/4in");
}

TEST(ToolClues, HolesHaveADrill) {
    const auto drilled = [](const std::vector<Vec3>& holes) {
        ToolClues clues;
        for (const Vec3& p : holes) {
            for (int peck = 1; peck <= 3; ++peck)
                add_line(clues, p, p + Vec3{0, 0, -1.0 * peck});
        }
        return clues.guess(false);
    };
    EXPECT_EQ(drilled({{0, 0, 0}}), "drill:D6") << "one hole has no distance";
    EXPECT_EQ(drilled({{0, 0, 0}, {50, 50, 0}, {53, 54, 0}}), "drill:D5") << "3, 4, 5";
    EXPECT_EQ(drilled({{53, 54, 0}, {0, 0, 0}, {50, 50, 0}}), "drill:D5") << "in any order";
    EXPECT_EQ(drilled({{0, 0, 0}, {50, 50, 0}, {50, 54.9, 0}}), "drill:D4");
    EXPECT_EQ(drilled({{0, 0, 0}, {0, 8, 0}}), "drill:D2") << "a quarter of the width";
}

TEST(ToolClues, SlopesHaveABallAndShortShallowMovesAnEngraver) {
    ToolClues slopes;
    for (int i = 0; i < 20; ++i)
        add_line(slopes, {0, 0.5 * i, 0}, {40, 0.5 * i, -5});
    EXPECT_EQ(slopes.guess(false), "ball:D2") << "a quarter of 9.5 mm; ten steps are 5 mm";
    ToolClues letters, fewer, deep;
    for (int i = 0; i < 100; ++i) {
        add_line(letters, {0.5 * i, 0, 0}, {0.5 * i + 0.5, i % 2 ? 1.0 : 0.0, 0});
        if (i < 99) add_line(fewer, {0.5 * i, 0, 0}, {0.5 * i + 0.5, i % 2 ? 1.0 : 0.0, 0});
        add_line(deep, {0.5 * i, 0, 0}, {0.5 * i + 0.5, i % 2 ? 1.0 : 0.0, i == 0 ? -3.0 : 0.0});
    }
    EXPECT_EQ(letters.guess(false), "v:D6:A60") << "only the tip counts";
    EXPECT_TRUE(fewer.guess(false).starts_with("flat:")) << "fewer than 100 moves";
    EXPECT_TRUE(deep.guess(false).starts_with("flat:"));
}

TEST(ToolClues, TheTightestArcFitsTheTool) {
    const auto with_arc = [](double radius, gcode::Plane plane) {
        ToolClues clues;
        add_line(clues, {0, 0, 0}, {100, 0, 0});
        add_line(clues, {100, 0, 0}, {100, 100, 0});
        gcode::Arc arc;
        arc.plane = plane;
        arc.from = at({radius, 0, 0}), arc.to = at({0, radius, 0});
        gcode::Motion motion;
        motion.action = arc;
        clues.take(motion, toolpath::Poses(nullptr, motion));
        return clues.guess(false);
    };
    EXPECT_EQ(with_arc(1.0, gcode::Plane::XY), "flat:D2");
    EXPECT_EQ(with_arc(2.4, gcode::Plane::XY), "flat:D4");
    EXPECT_EQ(with_arc(0.04, gcode::Plane::XY), "flat:D6") << "a rounded corner of the path";
    EXPECT_EQ(with_arc(1.0, gcode::Plane::ZX), "flat:D6") << "not in the plane";
}

}  // namespace
}  // namespace ncsim::setup
