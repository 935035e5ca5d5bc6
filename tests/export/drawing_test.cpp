// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests sections as DXF and SVG.
#include "ncsim/export/drawing.h"

#include "support/count.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace ncsim::exporter {
namespace {

using brep::FlatArc;
using brep::FlatEllipse;
using brep::FlatLine;
using brep::Section;

// Returns a half disc of radius 5: the line from (-5, 0) is stock, and T3 cut the arc. The disc has
// a hole.
Section half_disc() {
    Section section;
    section.plane = {2, -4.0};
    section.outlines = {{{{-5, 0}, {5, 0}, FlatLine{}, cda::Origin{0}},
                         {{5, 0}, {-5, 0}, FlatArc{{0, 0}, 5.0, true}, cda::Origin{1}}},
                        {{{1, 2}, {1, 2}, FlatArc{{0, 2}, 1.0, false}, cda::Origin{1}}}};
    return section;
}

mesh::Provenance provenance() {
    return {{{0, 0}, {12, 3}}, "a&b.nc"};
}

std::string dxf(const std::vector<DrawnSection>& sections) {
    std::ostringstream out;
    write_dxf(out, sections, "a&b.nc");
    return out.str();
}

std::string svg(const std::vector<DrawnSection>& sections) {
    std::ostringstream out;
    write_svg(out, sections, "a&b.nc");
    return out.str();
}

TEST(Dxf, HasALineAnArcAndACircleOnTheLayersOfTheirTools) {
    const Section section = half_disc();
    const mesh::Provenance from = provenance();
    const std::string text = dxf({{&section, &from}});
    EXPECT_NE(text.find("0\nLINE\n8\nSTOCK\n10\n-5\n20\n0\n30\n0\n11\n5\n21\n0\n31\n0\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("0\nARC\n8\nT3\n10\n0\n20\n0\n30\n0\n40\n5\n50\n0\n51\n180\n"),
              std::string::npos);
    EXPECT_NE(text.find("0\nCIRCLE\n8\nT3\n10\n0\n20\n2\n30\n0\n40\n1\n"), std::string::npos);
    EXPECT_NE(text.find("1\nz=-4 of a&b.nc\n"), std::string::npos);
}

// FreeCAD skips the first group of a layer. If this is the name, the layer has no colour.
TEST(Dxf, NamesALayerBehindAnotherGroup) {
    const Section section = half_disc();
    const mesh::Provenance from = provenance();
    const std::string text = dxf({{&section, &from}});
    for (const std::string name : {"0", "NOTES", "STOCK", "T3"})
        EXPECT_NE(text.find("0\nLAYER\n70\n0\n2\n" + name + "\n62\n"), std::string::npos) << name;
}

TEST(Dxf, NamesOtherAlphabetsByNumber) {
    const Section section = half_disc();
    const mesh::Provenance from = provenance();
    std::ostringstream out;
    write_dxf(out, {{&section, &from}}, "M\xC3\xBCller\xF0\x9F\x94\xA7.nc");
    EXPECT_NE(out.str().find("z=-4 of M\\U+00FCller?.nc\n"), std::string::npos) << out.str();
}

// DXF has counter-clockwise arcs only.
TEST(Dxf, TurnsAnArcAroundThatGoesClockwise) {
    Section section;
    section.outlines = {{{{0, 5}, {5, 0}, FlatArc{{0, 0}, 5.0, false}, cda::Origin{1}},
                         {{5, 0}, {0, 5}, FlatLine{}, cda::Origin{1}}}};
    const mesh::Provenance from = provenance();
    EXPECT_NE(dxf({{&section, &from}}).find("40\n5\n50\n0\n51\n90\n"), std::string::npos);
}

TEST(Dxf, SaysWhatIsOfFacets) {
    Section section = half_disc();
    section.outlines[0][1].is_facet = true;
    const mesh::Provenance from = provenance();
    EXPECT_NE(dxf({{&section, &from}}).find("8\nT3-FACETS\n"), std::string::npos);
    const std::string all = dxf({{&section, &from, true}});
    EXPECT_NE(all.find("8\nSTOCK\n"), std::string::npos);
    EXPECT_EQ(all.find("8\nT3\n"), std::string::npos);
}

TEST(Dxf, DrawsSectionsBesideEachOther) {
    const Section section = half_disc();
    const mesh::Provenance from = provenance();
    const std::vector<DrawnSection> two{{&section, &from}, {&section, &from}};
    // The start is at -5 + 30 = 25, which is 20 from the right end of the first section.
    EXPECT_EQ(places_of(two), (std::vector<double>{0.0, 30.0}));
    const std::string text = dxf(two);
    EXPECT_NE(text.find("8\n2-STOCK\n10\n25\n"), std::string::npos);
    EXPECT_NE(text.find("z=-4 of a&b.nc, moved by 30"), std::string::npos);
}

TEST(Svg, HasArcsWithUpDown) {
    const Section section = half_disc();
    const mesh::Provenance from = provenance();
    const std::string text = svg({{&section, &from}});
    EXPECT_NE(text.find("M-5 0L5 0A5 5 0 0 0 -5 0Z"), std::string::npos) << text;
    // A full circle is written as two halves.
    EXPECT_NE(text.find("M1 -2A1 1 0 1 1 -1 -2A1 1 0 1 1 1 -2Z"), std::string::npos) << text;
    EXPECT_NE(text.find("a&amp;b.nc"), std::string::npos);
}

// OpenSCAD moves a drawing whose view box does not begin at 0, fills all outlines that it finds,
// and ignores definitions.
TEST(Svg, HasOneFilledPathOutsideOfDefinitions) {
    const Section section = half_disc();
    const mesh::Provenance from = provenance();
    std::string text = svg({{&section, &from}, {&section, &from}});
    EXPECT_NE(text.find(" width=\"50mm\" height=\"22mm\" viewBox=\"0 0 50 22\">\n"
                        "<g transform=\"translate(10 10)\">\n"),
              std::string::npos)
        << text;
    for (const std::string name : {"outlines-1", "outlines-2"}) {
        const std::size_t begin = text.find("<defs><g id=\"" + name + "\">");
        const std::size_t end = text.find("</g></defs>", begin);
        ASSERT_LT(begin, end);
        EXPECT_EQ(
            ncsim::test::count(text.substr(begin, end - begin), "<path fill=\"none\" stroke="), 2U);
        EXPECT_EQ(text.find("<use xlink:href=\"#" + name + "\"/>"), end + 12);
        text.erase(begin, end - begin);
    }
    EXPECT_EQ(ncsim::test::count(text, "<path"), 2U);
    EXPECT_EQ(ncsim::test::count(text, "<path fill=\"#e4e4e4\" fill-rule=\"evenodd\""), 2U);
}

TEST(Svg, AnEllipseIsOneAndLinesInDxf) {
    Section section;
    section.outlines = {{{{0, 2}, {0, -2}, FlatEllipse{{0, 0}, {0, 4}, 2.0, true}, cda::Origin{1}},
                         {{0, -2}, {0, 2}, FlatLine{}, cda::Origin{1}}}};
    section.outlines[0][0].from = {0, 4};
    section.outlines[0][0].to = {0, -4};
    section.outlines[0][1].from = {0, -4};
    section.outlines[0][1].to = {0, 4};
    const mesh::Provenance from = provenance();
    EXPECT_NE(svg({{&section, &from}}).find("A4 2 -90 0 0 0 4"), std::string::npos);
    // OpenSCAD leaves out POLYLINE.
    const std::string text = dxf({{&section, &from}});
    EXPECT_EQ(text.find("POLYLINE"), std::string::npos);
    EXPECT_GT(ncsim::test::count(text, "0\nLINE\n8\nT3\n"), 20U);
    EXPECT_NE(text.find("0\nLINE\n8\nT3\n10\n0\n20\n4\n"), std::string::npos) << text;
    EXPECT_NE(text.find("11\n0\n21\n-4\n31\n0\n0\nLINE\n8\nT3\n10\n0\n20\n-4\n"),
              std::string::npos);
}

TEST(Drawing, OfNothingIsThere) {
    const Section section;
    const mesh::Provenance from = provenance();
    EXPECT_NE(svg({{&section, &from}}).find("empty"), std::string::npos);
    EXPECT_NE(dxf({{&section, &from}}).find("empty"), std::string::npos);
}

}  // namespace
}  // namespace ncsim::exporter
