// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of machine links.
#include "cli/run_program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::cli_test {
namespace {

// Returns a closed box as ASCII STL.
std::string box_stl(const std::array<double, 3>& low, const std::array<double, 3>& high) {
    std::string stl = "solid box\n";
    const auto corner = [&](int i) {
        return fmt::format("vertex {} {} {}\n", i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1],
                           i & 4 ? high[2] : low[2]);
    };
    constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : kFaces) {
        for (const auto& t : {std::array{f[0], f[1], f[2]}, std::array{f[0], f[2], f[3]}}) {
            stl += "facet normal 0 0 0\nouter loop\n";
            for (const int v : t)
                stl += corner(v);
            stl += "endloop\nendfacet\n";
        }
    }
    return stl + "endsolid\n";
}

TEST(Machine, WithMeshesHasAPictureOfItsPose) {
    Folder folder;
    folder.write("table.stl", box_stl({-50, -50, -20}, {50, 50, 0}));
    folder.write("head.stl", box_stl({-20, -20, 0}, {20, 20, 80}));
    const std::string machine =
        "part = { link = \"table\" }\nspindle = { link = \"z\" }\n"
        "[[link]]\nname = \"table\"\naxis = \"A\"\nturns_about = [1, 0, 0]\nthrough = [0, 0, -10]\n"
        "positive = \"part\"\nmesh = \"table.stl\"\ncolour = \"#c08040\"\n"
        "[[link]]\nname = \"x\"\naxis = \"X\"\nmoves_along = [1, 0, 0]\n"
        "[[link]]\nname = \"y\"\nparent = \"x\"\naxis = \"Y\"\nmoves_along = [0, 1, 0]\n"
        "[[link]]\nname = \"z\"\nparent = \"y\"\naxis = \"Z\"\nmoves_along = [0, 0, 1]\n"
        "mesh = \"head.stl\"\n";
    folder.write("m.toml", machine);
    const auto picture = [&](const std::string& pose) {
        const Ran ran =
            folder.run({"machine", "m.toml", "--png", "p.png", "--view", "right", "--pose", pose});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_NE(ran.out.find("link table: 12 triangles"), std::string::npos) << ran.out;
        return folder.read("p.png");
    };
    const std::string home = picture("Z60"), leaning = picture("Z60,A30");
    EXPECT_NE(home, leaning);
    EXPECT_EQ(picture("Z60,A360"), home);
    // Around a part: the table stays below the part in all rotations; the head does not.
    folder.write("a.nc",
                 "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\n"
                 "(FROM/0.,0.,50.)\nG21 G90 G17 T1 M6\nS5000 M3\nG0 X0 Y0 Z40\nG1 Z-2 "
                 "F300\nG0 Z40\nG0 A30\nM30\n");
    folder.write("m.toml", machine + "[offsets]\nG54 = [0, 0, 10]\n");
    const auto around = [&](const std::string& line, bool shown) {
        std::vector<std::string> words{"run",   "a.nc",   "--machine", "m.toml",    "--png",
                                       "p.png", "--view", "right",     "--at-line", line};
        if (shown) words.emplace_back("--show-machine");
        const Ran ran = folder.run(words);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read("p.png");
    };
    EXPECT_NE(around("8", true), around("8", false));
    EXPECT_NE(around("8", true), around("9", true));
    EXPECT_EQ(around("8", false), around("9", false));
    EXPECT_EQ(folder.run({"run", "a.nc", "--show-machine", "--png", "p.png"}).exit_code, 2);
    folder.write("bare.toml", "preset = \"4axis-a\"\n");
    for (const auto& [file, message] : std::vector<std::pair<std::string, std::string>>{
             {"preset = \"4axis-a\"\n", "no link of the machine has a mesh"},
             {machine + "colour = \"red\"\n", "expected \"#rrggbb\""},
             {machine + "[[link]]\nname = \"v\"\nmesh = \"gone.stl\"\n", "gone.stl"},
             {machine + "[[link]]\nname = \"v\"\nmesh = \"m.toml\"\n", "m.toml"}}) {
        folder.write("m.toml", file);
        const Ran ran = folder.run({"machine", "m.toml", "--png", "q.png"});
        EXPECT_EQ(ran.exit_code, 2) << file;
        EXPECT_NE(ran.err.find(message), std::string::npos) << ran.err;
    }
    EXPECT_EQ(folder.run({"machine", "bare.toml", "--view", "inside"}).exit_code, 2);
}

// Bodies behind a transparent link are visible according to the opacity, in pictures and in files.
TEST(Machine, LinksAreTransparentWhereThatIsAskedFor) {
    Folder folder;
    folder.write("table.stl", box_stl({-50, -50, -20}, {50, 50, 0}));
    folder.write("column.stl", box_stl({-60, -90, -20}, {60, -80, 80}));
    folder.write(
        "m.toml",
        "part = { link = \"table\" }\nspindle = { link = \"z\" }\noffsets = { G54 = [0, 0, "
        "10] }\n[[link]]\nname = \"table\"\nmesh = \"table.stl\"\ncolour = \"#c08040\"\n"
        "[[link]]\nname = \"column\"\nmesh = \"column.stl\"\ncolour = \"#4060c0\"\n"
        "[[link]]\nname = \"x\"\naxis = \"X\"\nmoves_along = [1, 0, 0]\n"
        "[[link]]\nname = \"y\"\nparent = \"x\"\naxis = \"Y\"\nmoves_along = [0, 1, 0]\n"
        "[[link]]\nname = \"z\"\nparent = \"y\"\naxis = \"Z\"\nmoves_along = [0, 0, 1]\n");
    const auto picture = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"machine", "m.toml", "--png", "p.png", "--view", "front"};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = folder.run(words);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read("p.png");
    };
    EXPECT_NE(picture({}), picture({"--transparent", "column"}));
    EXPECT_EQ(folder.run({"machine", "m.toml", "--png", "p.png", "--transparent", "x"}).exit_code,
              2);
    folder.write("a.nc",
                 "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\n"
                 "(FROM/0.,0.,50.)\nG21 G90 G17 T1 M6\nS5000 M3\nG0 X0 Y0 Z40\nG1 Z-2 F300\nM30\n");
    const std::vector<std::string> run{"run",   "a.nc",   "--machine", "m.toml", "--show-machine",
                                       "--png", "r.png",  "--vrml",    "r.wrl",  "--gltf",
                                       "r.glb", "--view", "front"};
    const auto files = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = run;
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = folder.run(words);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read("r.png") + folder.read("r.wrl") + folder.read("r.glb");
    };
    const std::string opaque = files({}), seen_through = files({"--transparent", "column,table"});
    EXPECT_EQ(opaque.find("transparency"), std::string::npos);
    EXPECT_EQ(opaque.find("BLEND"), std::string::npos);
    EXPECT_NE(seen_through.find("transparency 0.7"), std::string::npos);
    EXPECT_NE(seen_through.find("BLEND"), std::string::npos);
    std::vector<std::string> unknown = run;
    unknown.insert(unknown.end(), {"--transparent", "colum"});
    const Ran ran = folder.run(unknown);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("no link 'colum'"), std::string::npos) << ran.err;
}

const std::string kOneLink =
    "part = { link = \"table\" }\nspindle = { link = \"z\" }\n"
    "[[link]]\nname = \"x\"\naxis = \"X\"\nmoves_along = [1, 0, 0]\n"
    "[[link]]\nname = \"y\"\nparent = \"x\"\naxis = \"Y\"\nmoves_along = [0, 1, 0]\n"
    "[[link]]\nname = \"z\"\nparent = \"y\"\naxis = \"Z\"\nmoves_along = [0, 0, 1]\n"
    "[[link]]\nname = \"table\"\n";

// Returns a box of faces with four corners and outward normals, as CAD systems write boxes.
std::string box_obj(std::array<int, 3> a, std::array<int, 3> b) {
    std::string text = "# a box\no box\n";
    for (int i = 0; i < 8; ++i) {
        text += fmt::format("v {} {} {}\n", i & 1 ? b[0] : a[0], i & 2 ? b[1] : a[1],
                            i & 4 ? b[2] : a[2]);
    }
    return text +
           "vn 0 0 1\nf 1//1 3//1 4//1 2//1\nf 5 6 8 7\nf -8 -7 -3 -4\nf 3 7 8 4\n"
           "f 1 5 7 3\nf 2 4 8 6\n";
}

// The same body from each file format.
TEST(Machine, ReadsTheSameMeshInEveryFormat) {
    Folder folder;
    const auto picture = [&](const std::string& mesh, const std::string& text,
                             const std::string& more = "") {
        folder.write(mesh, text);
        folder.write("m.toml", kOneLink + "mesh = \"" + mesh + "\"\n" + more);
        const Ran ran = folder.run({"machine", "m.toml", "--png", "p.png"});
        EXPECT_EQ(ran.exit_code, 0) << mesh << ran.err;
        return folder.read("p.png");
    };
    const std::string expected = picture("a.stl", box_stl({-50, -40, -20}, {50, 40, 10}));
    EXPECT_EQ(picture("b.obj", box_obj({-50, -40, -20}, {50, 40, 10})), expected);
    // Box with a translation; faces with inward normals, mirrored; two half boxes.
    const std::string vrml = "#VRML V2.0 utf8\n";
    EXPECT_EQ(picture("c.wrl", vrml + "WorldInfo { title \"a } box\" info [ \"{\" ] }\n"
                                      "DEF T Transform { translation 0 0 -5 children [\n"
                                      "Shape { appearance Appearance { material DEF M Material {\n"
                                      "diffuseColor 1 0 0 } } geometry Box { size 100 80 30 } } ] }"
                                      "\nROUTE A.b TO C.d\n"),
              expected);
    const std::string faces =
        "geometry IndexedFaceSet { coord DEF P Coordinate { point [ -50 -40 -20, 50 -40 -20,\n"
        "-50 40 -20, 50 40 -20, -50 -40 10, 50 -40 10, -50 40 10, 50 40 10 ] }\n"
        "creaseAngle 0.5 coordIndex [ ";
    const std::string outwards = "0 2 3 1 -1 4 5 7 6 -1 0 1 5 4 -1 2 6 7 3 -1 0 4 6 2 -1 1 3 7 5 ";
    EXPECT_EQ(picture("d.wrl", vrml + "Shape { " + faces + outwards + "-1 ] } }\n"), expected);
    EXPECT_EQ(picture("e.wrl", vrml + "Transform { scale 1 -1 1 children Shape { " + faces +
                                   outwards + "] } } }\n"),
              expected);
    EXPECT_EQ(picture("f.wrl", vrml +
                                   "Transform { rotation 0 0 1 1.5707963267948966 scale 0.8 "
                                   "1.25 1 children Shape { " +
                                   faces + outwards + "] } } }\n"),
              expected);
    EXPECT_EQ(picture("g.wrl", vrml +
                                   "Group { children [ Switch { whichChoice -1 choice DEF H Shape "
                                   "{ " +
                                   faces + outwards +
                                   "] } } } Collision { children USE H } "
                                   "] }\n"),
              expected);
    EXPECT_EQ(
        picture("h.obj", box_obj({-5000, -4000, -2000}, {5000, 4000, 1000}), "scale = 0.01\n"),
        expected);
    // An L, whose face with six corners is not convex: seen from above, the face differs from its
    // hull.
    const std::string ell =
        "v 0 0 0\nv 30 0 0\nv 30 10 0\nv 10 10 0\nv 10 30 0\nv 0 30 0\nv 0 0 9\nv 30 0 9\n"
        "v 30 10 9\nv 10 10 9\nv 10 30 9\nv 0 30 9\nf 6 5 4 3 2 1\nf 7 8 9 10 11 12\n"
        "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";
    folder.write("l.obj", ell);
    folder.write("m.toml", kOneLink + "mesh = \"l.obj\"\n");
    const Ran ran = folder.run({"machine", "m.toml"});
    EXPECT_NE(ran.out.find("link table: 20 triangles"), std::string::npos) << ran.out << ran.err;
}

TEST(Machine, RefusesMeshesThatItCannotTrust) {
    Folder folder;
    const std::string vrml = "#VRML V2.0 utf8\n";
    std::string deep, bomb = "DEF A0 Shape { geometry Box { size 9 9 9 } }\n";
    for (int i = 0; i < 100'000; ++i)
        deep += "Group { children ";
    for (int i = 1; i < 60; ++i) {
        bomb += fmt::format("DEF A{} Group {{ children [ USE A{} USE A{} ] }}\n", i, i - 1, i - 1);
    }
    for (const auto& [mesh, message] : std::vector<std::pair<std::string, std::string>>{
             {"v 0 0 0\nv 1 0\n", "line 2: a point has three numbers"},
             {"v 0 0 0\nf 1 2 3\n", "line 2: a face names a point that does not stand before it"},
             {"v 0 0 0\nf 0 1 1\n", "a face names a point that does not stand before it"},
             {"v 0 0 0\nf 1 1\n", "a face has three corners or more"},
             {"v 0 0 0\nv 90 0 0\nv 0 90 0\nf 1 2 3\n", "its surface is not closed"},
             {"v 1e300 0 0\nv 90 0 0\nv 0 90 0\nf 1 2 3\n", "a corner that is no place"},
             {"v nan 0 0\nf 1 1 1\n", "a corner that is no place"},
             {"v 0 0 0\n", "it has no triangles"},
             {"cstype bezier\n", "it is neither"},
             {"g a\ncstype bezier\n", "line 2: curves and curved surfaces are not read"},
             {box_obj({0, 0, 0}, {1, 2, 1}),
              "m.toml:19:8: the mesh is 2 mm long: if it is in metres"},
             {"#VRML V1.0 ascii\n", "VRML, but not VRML97"},
             {vrml, "it has no triangles"},
             {vrml + "\n\nShape { geometry Sphere { radius 30 } }\n",
              "line 4: 'Sphere' is not read"},
             {vrml + "Inline { url \"x.wrl\" }\n", "'Inline' is not read"},
             {vrml + "PROTO Nut [ ] { Group { } }\nNut { }\n", "'PROTO' is not read"},
             {vrml + "Group { children [ USE B ] }\n", "USE names nothing"},
             {vrml + "DEF A Group { children [ USE A ] }\n", "USE names nothing"},
             {vrml + "Group { children [ Group { }\n", "the file ends within a node"},
             {vrml + "WorldInfo { title \"a }\n", "a text without end"},
             {vrml + "Shape { geometry Box { size 1 2 } }\n", "expected a number"},
             {vrml + "Shape { geometry IndexedFaceSet { coord Coordinate { point [ 0 0 0 ] }\n"
                     "coordIndex [ 0 1 2 ] } }\n",
              "a face names a corner that is not there"},
             {vrml + "Shape { geometry IndexedFaceSet { coordIndex [ 0 -2 ] } }\n",
              "a face names a point that is not there"},
             {vrml + deep, "nodes stand too deep in each other"},
             {vrml + bomb, "more than 100,000 nodes"}}) {
        folder.write("a.mesh", mesh);
        folder.write("m.toml", kOneLink + "mesh = \"a.mesh\"\n");
        const Ran ran = folder.run({"machine", "m.toml"});
        EXPECT_EQ(ran.exit_code, 2) << mesh.substr(0, 100);
        EXPECT_NE(ran.err.find(message), std::string::npos) << ran.err << mesh.substr(0, 100);
        // The message also names the place in the machine file.
        EXPECT_NE(ran.err.find("m.toml:19:8: "), std::string::npos) << ran.err;
    }
    folder.write("m.toml", kOneLink + "mesh = \"gone.stl\"\n");
    const Ran gone = folder.run({"machine", "m.toml"});
    EXPECT_EQ(gone.exit_code, 2);
    EXPECT_NE(gone.err.find("m.toml:19:8: cannot read 'gone.stl'"), std::string::npos) << gone.err;
    folder.write("a.mesh", box_obj({0, 0, 0}, {1, 2, 1}));
    for (const auto& [more, code] :
         std::vector<std::pair<std::string, int>>{{"scale = 1\n", 0}, {"scale = 0\n", 2}}) {
        folder.write("m.toml", kOneLink + "mesh = \"a.mesh\"\n" + more);
        EXPECT_EQ(folder.run({"machine", "m.toml"}).exit_code, code) << more;
    }
    folder.write("m.toml", kOneLink + "scale = 2\n");
    EXPECT_NE(folder.run({"machine", "m.toml"}).err.find("'scale': there is no mesh"),
              std::string::npos);
}

TEST(Machine, AMeshThatCrossesItselfIsRefusedOrItsHullIsTaken) {
    Folder folder;
    // A prism over an outline like an 8, whose larger loop has the correct orientation.
    folder.write(
        "eight.obj",
        "v 0 0 0\nv 40 0 0\nv 10 20 0\nv 20 20 0\nv 0 0 9\nv 40 0 9\nv 10 20 9\nv 20 20 9\n"
        "f 3 2 1\nf 4 3 1\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\n"
        "f 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n");
    folder.write("box.obj", box_obj({-50, -50, -90}, {50, 50, -50}));
    folder.write("p.nc", "G21 G90 G94 T1 M6\nG0 X0 Y0 Z5\nM2\n");
    const auto asked = [&](const std::string& specified, std::vector<std::string> command) {
        folder.write("m.toml", kOneLink + specified);
        return folder.run(std::move(command));
    };
    const std::vector<std::string> machine{"machine", "m.toml"},
        check{"check",   "p.nc",     "--machine", "m.toml",
              "--stock", "10x10x10", "--tool",    "T1=flat:D6:L20"};
    for (const auto& command : {machine, check}) {
        const Ran crossed = asked("mesh = \"eight.obj\"\n", command);
        EXPECT_EQ(crossed.exit_code, 2) << crossed.out << crossed.err;
        EXPECT_NE(crossed.err.find("m.toml:19:8: the mesh of the link 'table': its surface crosses "
                                   "itself"),
                  std::string::npos)
            << crossed.err;
        const Ran fixture = asked(
            "mesh = \"box.obj\"\n[[fixture]]\nname = \"vice\"\nmesh = "
            "\"eight.obj\"\n",
            command);
        EXPECT_EQ(fixture.exit_code, 2);
        EXPECT_NE(fixture.err.find("m.toml:22:8: the mesh of the fixture 'vice'"),
                  std::string::npos)
            << fixture.err;
        const Ran hull = asked("mesh = \"eight.obj\"\nhull = true\n", command);
        EXPECT_NE(hull.exit_code, 2) << hull.err;
    }
    EXPECT_NE(asked("hull = true\n", machine).err.find("'hull': there is no mesh"),
              std::string::npos);
}

}  // namespace
}  // namespace ncsim::cli_test
