// SPDX-License-Identifier: GPL-3.0-or-later
//
// read_step <folder or file> [--fine] [--booleans]: reads the file, or every .step in the folder,
// with OpenCASCADE. The result must be valid closed solids, in millimetres, with the number of
// faces and the volume in the adjacent .expect file. The volume there is called "solid" if the
// volume in different formats differs. Each face must become triangles, as programs draw faces, and
// the triangles must have the volume, too. A face hardly wider than the distance of chords from
// arcs is triangulated by finer chords. With --fine, each face must also have triangles at
// deflections of 0.1, 0.02 and 0.003 mm. With --booleans, the check before Boolean operations,
// which FreeCAD asks, too, must have no complaint, and both halves of the part must have its volume
// together.
#include <BOPAlgo_ArgumentAnalyzer.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

namespace {

struct Expectation {
    double volume = 0.0;
    int faces = 0;
    int solids = 0;      // negative: the number of shells, if voids are unknown
    double moved = 0.0;  // mm, by simplification: the volume may be off by `moved` times the area
};

Expectation read_expectation(const std::filesystem::path& path) {
    std::ifstream in(path);
    Expectation result;
    for (std::string word; in >> word;) {
        if (word == "volume" || word == "solid") in >> result.volume;
        if (word == "faces") in >> result.faces;
        if (word == "solids") in >> result.solids;
        if (word == "moved") in >> result.moved;
    }
    return result;
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, kind, map);
    return map.Extent();
}

bool all_shells_are_closed(const TopoDS_Shape& shape) {
    for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
        if (!BRep_Tool::IsClosed(shell.Current())) return false;
    }
    return true;
}

// The drawing of a shape: the number of faces without triangles, and the volume within all
// triangles.
struct Drawn {
    int without = 0;
    int finer = 0;      // narrow faces that need finer chords
    std::string where;  // middle of a face without triangles
    double volume = 0.0;
};

std::string middle_of(const TopoDS_Shape& face) {
    GProp_GProps surface;
    BRepGProp::SurfaceProperties(face, surface);
    const gp_Pnt at = surface.CentreOfMass();
    return std::to_string(at.X()) + ' ' + std::to_string(at.Y()) + ' ' + std::to_string(at.Z());
}

constexpr double kDeflectionMm = 0.01, kAngleOfChords = 0.3;

Handle(Poly_Triangulation) mesh_of(const TopoDS_Shape& face) {
    TopLoc_Location at;
    return BRep_Tool::Triangulation(TopoDS::Face(face), at);
}

// True if chords of two edges of the face may cross.
bool is_narrow(const TopoDS_Shape& face) {
    GProp_GProps surface, edges;
    BRepGProp::SurfaceProperties(face, surface);
    BRepGProp::LinearProperties(face, edges);
    const double width = 2.0 * std::abs(surface.Mass()) / edges.Mass();
    return width < 2.0 * kDeflectionMm;
}

Handle(Poly_Triangulation) finer_mesh_of(const TopoDS_Shape& face) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(face);
    BRepMesh_IncrementalMesh(copy, 0.1 * kDeflectionMm, false, 0.1 * kAngleOfChords);
    return mesh_of(copy);
}

bool is_empty(const Handle(Poly_Triangulation) & mesh) {
    return mesh.IsNull() || mesh->NbTriangles() == 0;
}

Drawn draw(const TopoDS_Shape& shape) {
    BRepMesh_IncrementalMesh(shape, kDeflectionMm, false, kAngleOfChords);
    Drawn drawn;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        auto mesh = mesh_of(face.Current());
        if (is_empty(mesh) && is_narrow(face.Current())) {
            mesh = finer_mesh_of(face.Current());
            ++drawn.finer;
        }
        if (is_empty(mesh)) {
            ++drawn.without;
            drawn.where = middle_of(face.Current());
            continue;
        }
        double six = 0.0;
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            int a = 0, b = 0, c = 0;
            mesh->Triangle(i).Get(a, b, c);
            six += mesh->Node(a).XYZ().DotCross(mesh->Node(b).XYZ(), mesh->Node(c).XYZ());
        }
        drawn.volume += (face.Current().Orientation() == TopAbs_REVERSED ? -six : six) / 6.0;
    }
    return drawn;
}

// Returns the middles of faces that have no triangles at a deflection.
std::string undrawn(const TopoDS_Shape& shape, double deflection_mm) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape);
    BRepMesh_IncrementalMesh(copy, deflection_mm, false, kAngleOfChords);
    std::string where;
    for (TopExp_Explorer face(copy, TopAbs_FACE); face.More(); face.Next()) {
        if (is_empty(mesh_of(face.Current())))
            where += (where.empty() ? "" : ", ") + middle_of(face.Current());
    }
    return where;
}

double volume_of(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties, 1e-9);
    return properties.Mass();
}

// Returns the kinds of the complaints of the check before Boolean operations (BOPAlgo_CheckStatus).
std::vector<int> complaints_of(const TopoDS_Shape& shape) {
    BOPAlgo_ArgumentAnalyzer analyzer;
    analyzer.SetShape1(shape);
    analyzer.ArgumentTypeMode() = true;
    analyzer.SelfInterMode() = true;
    analyzer.SmallEdgeMode() = true;
    analyzer.RebuildFaceMode() = true;
    analyzer.ContinuityMode() = true;
    analyzer.TangentMode() = true;
    analyzer.MergeVertexMode() = true;
    analyzer.MergeEdgeMode() = true;
    analyzer.CurveOnSurfaceMode() = true;
    analyzer.Perform();
    std::vector<int> kinds;
    for (const BOPAlgo_CheckResult& result : analyzer.GetCheckResult())
        kinds.push_back(result.GetCheckStatus());
    return kinds;
}

// Returns the sum of the volumes of the part on both sides of a plane across X.
double volume_of_halves(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    const gp_Pnt low = box.CornerMin().Translated(gp_Vec(-1, -1, -1));
    const gp_Pnt high = box.CornerMax().Translated(gp_Vec(1, 1, 1));
    const double middle = low.X() + 0.4321 * (high.X() - low.X());
    const auto part_in = [&](const gp_Pnt& from, const gp_Pnt& to) {
        return volume_of(BRepAlgoAPI_Common(shape, BRepPrimAPI_MakeBox(from, to).Shape()).Shape());
    };
    return part_in(low, {middle, high.Y(), high.Z()}) + part_in({middle, low.Y(), low.Z()}, high);
}

struct Strictness {
    bool is_fine = false, has_booleans = false;
};

bool check(const std::filesystem::path& path, const Strictness& strictness) {
    const Expectation expected =
        read_expectation(std::filesystem::path(path).replace_extension(".expect"));
    bool good = true;
    const auto expect = [&](bool condition, const std::string& message) {
        if (!condition) std::cerr << path << ": " << message << '\n';
        good = good && condition;
    };
    STEPControl_Reader reader;
    expect(reader.ReadFile(path.c_str()) == IFSelect_RetDone, "OpenCASCADE cannot read it");
    if (!good) return false;
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    if (expected.solids == 0) {
        expect(shape.IsNull() || count(shape, TopAbs_FACE) == 0, "there is something in it");
        return good;
    }
    if (shape.IsNull()) return expect(false, "there is nothing in it"), false;
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    // Integrals over faces with spline edges are rough unless a tolerance is specified, which is
    // slow.
    if (std::abs(properties.Mass() - expected.volume) > 1e-9 * expected.volume) {
        GProp_GProps better;
        BRepGProp::VolumeProperties(shape, better, 1e-9);
        properties = better;
    }
    const int solids = count(shape, TopAbs_SOLID);
    const int faces = count(shape, TopAbs_FACE);
    const int shells = count(shape, TopAbs_SHELL);
    expect(expected.solids < 0 ? shells == -expected.solids : solids == expected.solids,
           std::to_string(solids) + " solids, " + std::to_string(shells) + " shells");
    expect(faces == expected.faces || expected.faces == 0, std::to_string(faces) + " faces");
    expect(BRepCheck_Analyzer(shape).IsValid(), "not valid");
    expect(all_shells_are_closed(shape), "a shell is open");
    GProp_GProps surface;
    BRepGProp::SurfaceProperties(shape, surface);
    const double slack = 1e-9 * expected.volume + expected.moved * surface.Mass();
    expect(std::abs(properties.Mass() - expected.volume) <= slack,
           "volume " + std::to_string(properties.Mass()));
    const Drawn drawn = draw(shape);
    for (const double deflection : {0.1, 0.02, 0.003}) {
        const std::string where = strictness.is_fine ? undrawn(shape, deflection) : "";
        expect(where.empty(), "faces without triangles at " + std::to_string(deflection) +
                                  " mm deflection: " + where);
    }
    if (strictness.has_booleans) {
        const std::vector<int> complaints = complaints_of(shape);
        std::string kinds;
        for (const int kind : complaints)
            kinds += " " + std::to_string(kind);
        expect(complaints.empty(), "complaints before Booleans, of the kinds" + kinds);
        const double halves = volume_of_halves(shape);
        expect(std::abs(halves - properties.Mass()) < 1e-6 * properties.Mass(),
               "two halves of " + std::to_string(halves) + " mm³ together");
    }
    expect(drawn.without == 0,
           std::to_string(drawn.without) + " faces without triangles, at " + drawn.where);
    expect(
        std::abs(drawn.volume - properties.Mass()) <= slack + 2.0 * kDeflectionMm * surface.Mass(),
        "triangles around " + std::to_string(drawn.volume));
    std::cout << path << ": " << solids << " solids, " << faces << " faces, ";
    if (drawn.finer > 0) std::cout << drawn.finer << " of them by finer chords, ";
    std::cout << properties.Mass() << " mm³\n";
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    Strictness strictness;
    for (int i = 2; i < argc; ++i) {
        const std::string option = argv[i];
        if (option != "--fine" && option != "--booleans") return EXIT_FAILURE;
        (option == "--fine" ? strictness.is_fine : strictness.has_booleans) = true;
    }
    if (argc < 2) return EXIT_FAILURE;
    const std::filesystem::path path = argv[1];
    if (!std::filesystem::is_directory(path))
        return check(path, strictness) ? EXIT_SUCCESS : EXIT_FAILURE;
    int files = 0;
    bool good = true;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
        if (entry.path().extension() != ".step") continue;
        ++files;
        good = check(entry.path(), strictness) && good;
    }
    return good && files > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
