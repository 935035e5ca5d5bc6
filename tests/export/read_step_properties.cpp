// SPDX-License-Identifier: GPL-3.0-or-later
//
// read_step_properties <solid.step> <schema> <pieces> <face name> …: reads the file as a document
// of OpenCASCADE. The document must have the volume, the area and the centroid that OpenCASCADE
// measures, a name for the part, colours on the faces, and a face of each specified name. If there
// are several pieces, each has the name SOLID_1 … and its volume.
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_Area.hxx>
#include <XCAFDoc_Centroid.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFDoc_Volume.hxx>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

namespace {

std::string name_of(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
    const TCollection_AsciiString text(name->Get(), '?');
    return text.ToCString();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return EXIT_FAILURE;
    bool good = true;
    const auto expect = [&](bool condition, const std::string& message) {
        if (!condition) std::cerr << argv[1] << ": " << message << '\n';
        good = good && condition;
    };
    STEPCAFControl_Reader reader;
    expect(Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1), "names cannot be read");
    reader.SetPropsMode(true);
    reader.SetNameMode(true);
    reader.SetColorMode(true);
    if (reader.ReadFile(argv[1]) != IFSelect_RetDone) return EXIT_FAILURE;
    std::string head(1000, ' ');
    std::ifstream(argv[1]).read(head.data(), static_cast<std::streamsize>(head.size()));
    expect(head.find(std::string("FILE_SCHEMA(('") + argv[2]) != std::string::npos,
           std::string("its schema is not ") + argv[2]);
    Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
    if (!reader.Transfer(document)) return EXIT_FAILURE;
    const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const auto colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
    TDF_LabelSequence parts;
    shapes->GetFreeShapes(parts);
    expect(parts.Length() == 1, std::to_string(parts.Length()) + " parts");
    if (!good) return EXIT_FAILURE;
    const TDF_Label part = parts.First();
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part);
    expect(!name_of(part).empty(), "it has no name");

    GProp_GProps volume, area;
    BRepGProp::VolumeProperties(shape, volume, 1e-9);
    BRepGProp::SurfaceProperties(shape, area, 1e-9);
    constexpr double kSame = 1e-7;
    double specified = 0.0;
    expect(XCAFDoc_Volume::Get(part, specified), "the file has no volume");
    expect(std::abs(specified - volume.Mass()) < kSame * specified,
           "volume " + std::to_string(specified) + ", not " + std::to_string(volume.Mass()));
    expect(XCAFDoc_Area::Get(part, specified), "the file has no area");
    expect(std::abs(specified - area.Mass()) < kSame * specified,
           "area " + std::to_string(specified) + ", not " + std::to_string(area.Mass()));
    gp_Pnt centre;
    expect(XCAFDoc_Centroid::Get(part, centre), "the file has no centroid");
    const double off = centre.Distance(volume.CentreOfMass());
    expect(off < 1e-6, "its centroid is " + std::to_string(off) + " mm off");

    TDF_LabelSequence pieces, components;
    XCAFDoc_ShapeTool::GetComponents(part, components);
    if (components.IsEmpty()) pieces.Append(part);
    for (int i = 1; i <= components.Length(); ++i) {
        TDF_Label piece;
        expect(XCAFDoc_ShapeTool::GetReferredShape(components(i), piece), "a piece has no shape");
        pieces.Append(piece);
        const std::string name = "SOLID_" + std::to_string(i);
        expect(name_of(piece) == name, name + " has the name " + name_of(piece));
        GProp_GProps own;
        BRepGProp::VolumeProperties(XCAFDoc_ShapeTool::GetShape(piece), own, 1e-9);
        expect(XCAFDoc_Volume::Get(piece, specified) &&
                   std::abs(specified - own.Mass()) < kSame * specified,
               name + " has no volume, or a wrong one");
    }
    expect(pieces.Length() == std::atoi(argv[3]), std::to_string(pieces.Length()) + " pieces");

    std::set<std::string> names;
    int faces = 0;
    for (const TDF_Label& piece : pieces) {
        const TopoDS_Shape body = XCAFDoc_ShapeTool::GetShape(piece);
        int all = 0, coloured = 0;
        for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next()) {
            ++all;
            Quantity_Color colour;
            if (colours->GetColor(face.Current(), XCAFDoc_ColorSurf, colour)) ++coloured;
            TDF_Label label;
            if (shapes->FindSubShape(piece, face.Current(), label)) names.insert(name_of(label));
        }
        // If all faces have the same colour, the piece may have the colour.
        Quantity_Color same;
        expect(coloured == all || colours->GetColor(body, XCAFDoc_ColorSurf, same),
               std::to_string(coloured) + " of " + std::to_string(all) + " faces have a colour");
        faces += all;
    }
    for (int i = 4; i < argc; ++i)
        expect(names.count(argv[i]) == 1, std::string("no face is called ") + argv[i]);
    std::cout << argv[1] << ": " << name_of(part) << ", " << faces << " faces, " << volume.Mass()
              << " mm3\n";
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
