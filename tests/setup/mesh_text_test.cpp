// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes as text (OBJ, VRML97), polygons as triangles, and signs of inches in programs without a
// unit.
#include "ncsim/toolpath/tool_table.h"

#include "files/toml_text.h"
#include "job/unit_clues.h"
#include "meshes/obj_mesh.h"
#include "meshes/polygons.h"
#include "meshes/vrml_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {
namespace {

using Corners = std::vector<Vec3>;

template <class Read>
std::string refusal(const Read& read) {
    try {
        (void)read();
    } catch (const Refused& refused) {
        return refused.reason;
    }
    return {};
}

/// Area vector of triangles: half the sum of the cross products of their sides.
Vec3 area_of(const Corners& corners) {
    Vec3 sum;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        sum = sum + 0.5 * cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
    return sum;
}

TEST(Polygons, BecomeTrianglesOfTheSameArea) {
    // An L of area 3: not convex. Seen from +Z counter-clockwise.
    const Polygons shape{{{0, 0, 5}, {2, 0, 5}, {2, 1, 5}, {1, 1, 5}, {1, 2, 5}, {0, 2, 5}},
                         {{0, 1, 2, 3, 4, 5}}};
    const Corners corners = corners_of(shape);
    EXPECT_EQ(corners.size(), 12U);
    const Vec3 area = area_of(corners);
    EXPECT_NEAR(area.x, 0.0, 1e-12);
    EXPECT_NEAR(area.y, 0.0, 1e-12);
    EXPECT_NEAR(area.z, 3.0, 1e-12);
    double sizes = 0.0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        sizes += norm(area_of({corners[i], corners[i + 1], corners[i + 2]}));
    EXPECT_NEAR(sizes, 3.0, 1e-12) << "no triangle overlaps another";
}

TEST(Polygons, WithoutAnAreaAreLeftOut) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}};
    EXPECT_TRUE(corners_of({points, {{0, 1}}}).empty());
    EXPECT_TRUE(corners_of({points, {{0, 1, 2, 3}}}).empty());
    EXPECT_EQ(corners_of({points, {{0, 1, 4}}}), (Corners{points[0], points[1], points[4]}));
    EXPECT_EQ(refusal([&] {
                  return corners_of({points, {{0, 1, 5}}});
              }),
              "a face names a corner that is not there");
    for (const double far : {1e9, -1e9, std::nan("")}) {
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<Vec3> away = points;
            away[1][axis] = far;
            EXPECT_EQ(refusal([&] {
                          return corners_of({away, {{0, 1, 4}}});
                      }),
                      "it has a corner that is no place");
        }
    }
    EXPECT_EQ(refusal([&] { return corners_of({{{9e8, 0, 0}}, {}}); }), "");
}

TEST(ObjMesh, CountsPointsFromBothEnds) {
    const std::string points = "# a comment\nv 0 0 0\nv 1 0 0 # x\n\tv +0 1 0\r\n";
    const Corners expected{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(read_obj(points + "f 1 2 3\n"), expected);
    EXPECT_EQ(read_obj(points + "f -3 -2 -1"), expected);
    EXPECT_EQ(read_obj(points + "vn 0 0 1\nvt 0 0\nf 1/1/1 2//1 3/1\n"), expected);
    EXPECT_EQ(read_obj(points + "v 1 1 0\nf 1 2 4 3\n").size(), 6U);
    const auto reason = [&](const std::string& text) {
        return refusal([&] { return read_obj(points + text); });
    };
    const std::string before = "line 5: a face names a point that does not stand before it";
    for (const char* face : {"f 1 2 4", "f 0 1 2", "f -4 1 2", "f 1 2 x", "f 1 2 3x"})
        EXPECT_EQ(reason(face), before) << face;
    EXPECT_EQ(reason("f 1 2"), "line 5: a face has three corners or more");
    EXPECT_EQ(reason("\nv 1 2"), "line 6: a point has three numbers");
    EXPECT_EQ(reason("v 1 2 z"), "line 5: a point has three numbers");
    EXPECT_EQ(reason("curv 0 1 1 2"), "line 5: curves and curved surfaces are not read");
}

TEST(ObjMesh, IsRecognisedByItsFirstWord) {
    for (const char* text : {"v 1 2 3", "# x\n\n o part\n", "mtllib a.mtl\n", "s off", "\tf 1 2 3"})
        EXPECT_TRUE(is_obj(text)) << text;
    for (const char* text : {"", "# only a comment\n", "solid x", "vx 1", "version 3\nv 1 2 3"})
        EXPECT_FALSE(is_obj(text)) << text;
}

const std::string kVrml = "#VRML V2.0 utf8\n";

/// Greatest and least coordinates of a mesh.
struct Bounds {
    Vec3 least{1e9, 1e9, 1e9}, most{-1e9, -1e9, -1e9};
};
Bounds bounds_of(const std::string& text) {
    Bounds bounds;
    for (const Vec3& p : read_vrml(kVrml + text)) {
        for (int axis = 0; axis < 3; ++axis) {
            bounds.least[axis] = std::min(bounds.least[axis], p[axis]);
            bounds.most[axis] = std::max(bounds.most[axis], p[axis]);
        }
    }
    return bounds;
}
void expect_bounds(const std::string& text, Vec3 least, Vec3 most) {
    const Bounds bounds = bounds_of(text);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(bounds.least[axis], least[axis], 1e-9) << text;
        EXPECT_NEAR(bounds.most[axis], most[axis], 1e-9) << text;
    }
}

TEST(VrmlMesh, PlacesBoxes) {
    const std::string box = "Shape { geometry Box { size 2 4 6 } }";
    expect_bounds(box, {-1, -2, -3}, {1, 2, 3});
    expect_bounds("Transform { translation 10 20 30 children [ " + box + " ] }", {9, 18, 27},
                  {11, 22, 33});
    expect_bounds("Transform { scale 2 1 3 children " + box + " }", {-2, -2, -9}, {2, 2, 9});
    // A quarter turn about Z exchanges X and Y; the translation is applied behind the turn.
    expect_bounds("Transform { translation 10 0 0 rotation 0 0 1 1.5707963267948966 children [ " +
                      box + " ] }",
                  {8, -1, -3}, {12, 1, 3});
    // Transforms in each other, and USE.
    expect_bounds(
        "Transform { translation 1 0 0 children [ Transform { translation 0 5 0 children [ "
        "DEF B " +
            box + " ] } ] }\nTransform { translation -7 0 0 children [ USE B ] }",
        {-8, -2, -3}, {2, 7, 3});
}

TEST(VrmlMesh, ReadsFaceSets) {
    const std::string set =
        "Shape { geometry IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] "
        "} "
        "coordIndex [ 0, 1, 2, 3, -1 ] CCW } }";
    const auto with = [&](const std::string& ccw) {
        std::string text = set;
        text.replace(text.find("CCW"), 3, ccw);
        return area_of(read_vrml(kVrml + text));
    };
    EXPECT_NEAR(with("").z, 1.0, 1e-12);
    EXPECT_NEAR(with("ccw TRUE").z, 1.0, 1e-12);
    EXPECT_NEAR(with("ccw FALSE").z, -1.0, 1e-12);
    EXPECT_TRUE(is_vrml(kVrml));
    EXPECT_FALSE(is_vrml("solid VRML V2.0 utf8\n"));
    EXPECT_NE(refusal([] { return read_vrml("#VRML V1.0 ascii\nCube { }\n"); }), "");
    EXPECT_NE(refusal([] { return read_vrml(kVrml + "Shape { geometry Sphere { } }"); }), "");
    EXPECT_NE(refusal([] { return read_vrml(kVrml + "Shape { geometry Box { size 1 2 } }"); }), "");
}

TEST(TomlText, ShowsNoCharacterThatAnEditorObeys) {
    EXPECT_EQ(quoted("a\"b"), "\"a\\\"b\"");
    EXPECT_EQ(quoted("\x7f"), "\"\\u007F\"");
    EXPECT_EQ(quoted("\xC2\x85"), "\"\\u0085\"");
    EXPECT_EQ(quoted("\xE2\x80\xAE\xE2\x80\xA8\xE2\x81\xA6"), "\"\\u202E\\u2028\\u2066\"");
    EXPECT_EQ(quoted("\xE2\x80\x8D"), "\"\xE2\x80\x8D\"");
    EXPECT_EQ(quoted("\xC3\xA4"), "\"\xC3\xA4\"");
}

TEST(UnitClues, NeedToolsInInchesAndSmallNumbers) {
    const auto inches = [](const std::string& tool, const std::string& blocks) {
        toolpath::ToolEntry entry;
        entry.text = tool;
        return suggests_inches({"t.nc", blocks}, std::vector{entry});
    };
    const std::string small = "G0 X1.5 Y-2 Z0.1\nG1 Z-0.25 F12\n";
    for (const char* tool :
         {"1/4 END MILL", "1/2\" end mill", "0.25 inch", ".5IN BALL", "3/16 drill", "1 INCHES"})
        EXPECT_TRUE(inches(tool, small)) << tool;
    for (const char* tool : {"6MM", "6 mm end mill", "1/4 6MM", "END MILL", "T1 D6", "1/3 MILL",
                             "12/16/2024", "INCH", "5 INSERTS", "1/1"})
        EXPECT_FALSE(inches(tool, small)) << tool;
    const char* quarter = "1/4 END MILL";
    EXPECT_FALSE(inches(quarter, "G20\n" + small));
    EXPECT_FALSE(inches(quarter, "G21\n" + small));
    EXPECT_FALSE(inches(quarter, "G70\n" + small));
    EXPECT_FALSE(inches(quarter, "G71\n" + small));
    EXPECT_TRUE(inches(quarter, small + "F150\n"));
    EXPECT_FALSE(inches(quarter, small + "F151\n"));
    for (const char* axis : {"X", "Y", "Z"}) {
        EXPECT_TRUE(inches(quarter, small + axis + "60\n")) << axis;
        EXPECT_FALSE(inches(quarter, small + axis + "60.5\n")) << axis;
    }
    EXPECT_FALSE(inches(quarter, small + "X-60.5\n"));
    EXPECT_TRUE(inches(quarter, small + "Z-4\n"));
    EXPECT_FALSE(inches(quarter, small + "Z-4.1\n"));
    EXPECT_FALSE(suggests_inches({"t.nc", small}, {}));
}

}  // namespace
}  // namespace ncsim::setup
