// SPDX-License-Identifier: GPL-3.0-or-later
//
// mesh_step <solid.step> <mesh.stl> <deflection>: writes OpenCASCADE's triangles of the solid,
// within `deflection` mm of its surfaces.
#include <BRepMesh_IncrementalMesh.hxx>
#include <STEPControl_Reader.hxx>
#include <StlAPI_Writer.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc != 4) return EXIT_FAILURE;
    STEPControl_Reader reader;
    if (reader.ReadFile(argv[1]) != IFSelect_RetDone) return EXIT_FAILURE;
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    constexpr double kAngle = 0.3;  // rad
    const BRepMesh_IncrementalMesh mesh(shape, std::strtod(argv[3], nullptr), false, kAngle, true);
    StlAPI_Writer writer;
    writer.ASCIIMode() = false;
    return mesh.IsDone() && writer.Write(shape, argv[2]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
