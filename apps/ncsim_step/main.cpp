// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim-step <deflection>: converts STEP on the standard input into triangles on the standard
// output, within <deflection> mm of the surfaces. Only this program uses OpenCASCADE. ncsim runs
// ncsim-step from lib/setup/src/meshes/step_file.cpp, which reads this format:
//
//     NCSIM-STEP 1
//     unit <name of the unit of length in the file>
//     solids <n>  vertices <n>  triangles <n>  faces <n>       each on a separate line
//     <name of a face>                                         a line for each face
//     then 3 doubles for each vertex (mm), 4 uint32 for each triangle: corners, face
//
// or "error <reason>" with exit code 1. Corners are joined along common edges and vertices of
// faces, so the surface is closed wherever the solid is closed.
#include <unistd.h>

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_LengthUnit.hxx>
#include <StepBasic_NamedUnit.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Refused {
    std::string reason;
};

// Surface that was read.
struct Surface {
    std::string unit;
    std::uint64_t solids = 0;
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<std::uint32_t, 4>> triangles;  // corners, face
    std::vector<std::string> names;                       // of faces
};

std::string to_one_line(const char* text) {
    std::string line = text;
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    return line;
}

// Classes of numbers of the same corner (union-find).
class CornerClasses {
public:
    std::uint32_t add() {
        first_.push_back(static_cast<std::uint32_t>(first_.size()));
        return first_.back();
    }
    std::uint32_t find(std::uint32_t i) {
        while (first_[i] != i)
            i = first_[i] = first_[first_[i]];
        return i;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        first_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> first_;
};

class Mesher {
public:
    Mesher(const STEPControl_Reader& reader, Surface& surface)
        : reader_(reader), surface_(surface) {}

    void operator()(const TopoDS_Shape& solid) {
        // Each instance in an assembly has separate corners.
        edges_.clear();
        vertices_.clear();
        for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next())
            add(TopoDS::Face(face.Current()));
    }

    void finish() {
        std::vector<std::uint32_t> number(points_.size(), UINT32_MAX);
        const auto corner = [&](std::uint32_t p) {
            const std::uint32_t first = same_.find(p);
            if (number[first] == UINT32_MAX) {
                number[first] = static_cast<std::uint32_t>(surface_.vertices.size());
                surface_.vertices.push_back(points_[first]);
            }
            return number[first];
        };
        for (const auto& t : raw_) {
            const std::array<std::uint32_t, 4> triangle{corner(t[0]), corner(t[1]), corner(t[2]),
                                                        t[3]};
            if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
                triangle[2] == triangle[0])
                continue;
            surface_.triangles.push_back(triangle);
        }
    }

private:
    void add(const TopoDS_Face& face) {
        TopLoc_Location place;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
        if (mesh.IsNull()) throw Refused{"a face of it cannot be cut into triangles"};
        const auto number = static_cast<std::uint32_t>(surface_.names.size());
        surface_.names.push_back(name_of(face));
        std::vector<std::uint32_t> nodes;
        for (Standard_Integer i = 1; i <= mesh->NbNodes(); ++i) {
            const gp_Pnt p = mesh->Node(i).Transformed(place.Transformation());
            nodes.push_back(same_.add());
            points_.push_back({p.X(), p.Y(), p.Z()});
        }
        const bool is_turned =
            (face.Orientation() == TopAbs_REVERSED) != place.Transformation().IsNegative();
        for (Standard_Integer i = 1; i <= mesh->NbTriangles(); ++i) {
            Standard_Integer a = 0, b = 0, c = 0;
            mesh->Triangle(i).Get(a, b, c);
            if (is_turned) std::swap(b, c);
            raw_.push_back({nodes[static_cast<std::size_t>(a - 1)],
                            nodes[static_cast<std::size_t>(b - 1)],
                            nodes[static_cast<std::size_t>(c - 1)], number});
        }
        for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next())
            join(TopoDS::Edge(e.Current()), mesh, place, nodes);
    }

    // Joins the nodes of an edge with the nodes in the second face, and the ends with the vertices.
    void join(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & mesh,
              const TopLoc_Location& place, const std::vector<std::uint32_t>& nodes) {
        const Handle(Poly_PolygonOnTriangulation) line =
            BRep_Tool::PolygonOnTriangulation(edge, mesh, place);
        if (line.IsNull()) return;
        std::vector<std::uint32_t> along;
        for (Standard_Integer i = 1; i <= line->NbNodes(); ++i)
            along.push_back(nodes[static_cast<std::size_t>(line->Node(i) - 1)]);
        if (!BRep_Tool::Degenerated(edge)) {
            const auto [at, is_new] =
                edges_.try_emplace(map_.Add(edge.Oriented(TopAbs_FORWARD)), along);
            for (std::size_t i = 0; !is_new && i < std::min(along.size(), at->second.size()); ++i)
                same_.unite(along[i], at->second[i]);
        } else {
            for (const std::uint32_t p : along)
                same_.unite(p, along.front());
        }
        const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
        const std::array<std::pair<TopoDS_Vertex, std::uint32_t>, 2> ends{
            {{TopExp::FirstVertex(forward), along.front()},
             {TopExp::LastVertex(forward), along.back()}}};
        for (const auto& [vertex, p] : ends) {
            if (vertex.IsNull()) continue;
            const auto [at, is_new] =
                vertices_.try_emplace(map_.Add(vertex.Oriented(TopAbs_FORWARD)), p);
            if (!is_new) same_.unite(p, at->second);
        }
    }

    std::string name_of(const TopoDS_Face& face) const {
        const auto transfer = reader_.WS()->TransferReader();
        Handle(Standard_Transient) entity = transfer->EntityFromShapeResult(face, 1);
        if (entity.IsNull())
            entity = transfer->EntityFromShapeResult(face.Located(TopLoc_Location()), 1);
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
        if (item.IsNull() || item->Name().IsNull()) return {};
        return to_one_line(item->Name()->ToCString());
    }

    const STEPControl_Reader& reader_;
    Surface& surface_;
    TopTools_IndexedMapOfShape map_;
    std::map<Standard_Integer, std::vector<std::uint32_t>> edges_;  // by number in map_
    std::map<Standard_Integer, std::uint32_t> vertices_;
    std::vector<std::array<double, 3>> points_;
    std::vector<std::array<std::uint32_t, 4>> raw_;
    CornerClasses same_;
};

// Returns the solids of `shape`, including closed shells without a solid.
std::vector<TopoDS_Shape> solids_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Shape> solids;
    for (TopExp_Explorer e(shape, TopAbs_SOLID); e.More(); e.Next()) {
        for (TopExp_Explorer shell(e.Current(), TopAbs_SHELL); shell.More(); shell.Next()) {
            if (!BRep_Tool::IsClosed(shell.Current()))
                throw Refused{"a solid of it is not closed: what is inside of it?"};
        }
        solids.push_back(e.Current());
    }
    for (TopExp_Explorer e(shape, TopAbs_SHELL, TopAbs_SOLID); e.More(); e.Next()) {
        if (!BRep_Tool::IsClosed(e.Current()))
            throw Refused{"a surface of it is not closed: what is inside of it?"};
        TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(e.Current()));
        // A shell does not specify the inner side.
        BRepClass3d_SolidClassifier outside(solid);
        outside.PerformInfinitePoint(1e-6);
        if (outside.State() == TopAbs_IN) solid.Reverse();
        solids.push_back(solid);
    }
    return solids;
}

bool has_length(const Handle(StepRepr_GlobalUnitAssignedContext) & context) {
    if (context.IsNull()) return false;
    for (Standard_Integer i = 1; i <= context->NbUnits(); ++i) {
        const Handle(Standard_Transient) unit = context->UnitsValue(i);
        if (unit->IsKind(STANDARD_TYPE(StepBasic_SiUnitAndLengthUnit)) ||
            unit->IsKind(STANDARD_TYPE(StepBasic_ConversionBasedUnitAndLengthUnit)) ||
            unit->IsKind(STANDARD_TYPE(StepBasic_LengthUnit)))
            return true;
    }
    return false;
}

// True if the file specifies a unit of length; OpenCASCADE assumes millimetres otherwise.
bool has_lengths(const Handle(Interface_InterfaceModel) & model) {
    bool tells = false;
    for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
        const Handle(Standard_Transient) entity = model->Value(i);
        if (const auto plain =
                Handle(StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext)::
                    DownCast(entity);
            !plain.IsNull())
            tells = tells || has_length(plain->GlobalUnitAssignedContext());
        if (const auto usual = Handle(
                StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx)::DownCast(entity);
            !usual.IsNull())
            tells = tells || has_length(usual->GlobalUnitAssignedContext());
    }
    return tells;
}

Surface read(std::istream& in, double deflection) {
    STEPControl_Reader reader;
    if (reader.ReadStream("part.step", in) != IFSelect_RetDone)
        throw Refused{"no STEP that can be read"};
    Surface surface;
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    if (lengths.IsEmpty() || !has_lengths(reader.WS()->Model()))
        throw Refused{"it does not say in which unit its lengths are"};
    surface.unit = to_one_line(lengths.First().ToCString());
    if (reader.NbRootsForTransfer() == 0) throw Refused{"there is no shape in it"};
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) throw Refused{"there is no shape in it"};
    const std::vector<TopoDS_Shape> solids = solids_of(shape);
    if (solids.empty()) throw Refused{"there is no solid in it"};
    surface.solids = solids.size();

    IMeshTools_Parameters how;
    how.Deflection = deflection;
    how.Angle = 0.5;
    how.InParallel = false;  // deterministic triangles
    const BRepMesh_IncrementalMesh mesh(shape, how);
    Mesher mesher(reader, surface);
    for (const TopoDS_Shape& solid : solids) {
        if (solid.ShapeType() == TopAbs_SOLID && mesh.IsDone()) mesher(solid);
    }
    mesher.finish();
    return surface;
}

template <typename T>
void put(std::FILE* out, const std::vector<T>& values) {
    if (!values.empty() &&
        std::fwrite(values.data(), sizeof(T), values.size(), out) != values.size())
        std::exit(EXIT_FAILURE);
}

void write(std::FILE* out, const Surface& s) {
    std::ostringstream head;
    head << "NCSIM-STEP 1\nunit " << s.unit << "\nsolids " << s.solids << "\nvertices "
         << s.vertices.size() << "\ntriangles " << s.triangles.size() << "\nfaces "
         << s.names.size() << '\n';
    for (const std::string& name : s.names)
        head << name << '\n';
    const std::string text = head.str();
    std::fwrite(text.data(), 1, text.size(), out);
    put(out, s.vertices);
    put(out, s.triangles);
}

}  // namespace

int main(int argc, char** argv) {
    const double deflection = argc == 2 ? std::strtod(argv[1], nullptr) : 0.0;
    if (!(deflection > 0.0)) {
        std::cerr << "ncsim-step <deflection in mm>: read by ncsim\n";
        return EXIT_FAILURE;
    }
    // Messages of OpenCASCADE must not reach the reader of the output.
    std::FILE* out = ::fdopen(::dup(STDOUT_FILENO), "wb");
    if (!out || !std::freopen("/dev/null", "w", stdout) || !std::freopen("/dev/null", "w", stderr))
        return EXIT_FAILURE;
    std::string what;
    try {
        write(out, read(std::cin, deflection));
        return std::fclose(out) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const Refused& refused) {
        what = refused.reason;
    } catch (const Standard_Failure& failure) {
        what = std::string("OpenCASCADE gave up: ") + to_one_line(failure.GetMessageString());
    } catch (const std::exception& e) {
        what = std::string("OpenCASCADE gave up: ") + to_one_line(e.what());
    }
    std::fprintf(out, "error %s\n", what.c_str());
    std::fclose(out);
    return EXIT_FAILURE;
}
