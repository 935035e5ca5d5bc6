// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_step_cases <folder>: writes STEP files with OpenCASCADE as CAD systems would: an assembly,
// inches, curved bodies, and shapes that are not solids.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace {

TopoDS_Compound together(const std::vector<TopoDS_Shape>& shapes) {
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes)
        builder.Add(compound, shape);
    return compound;
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double x) {
    gp_Trsf by;
    by.SetTranslation(gp_Vec(x, 0, 0));
    return shape.Moved(TopLoc_Location(by));
}

// Returns the shell of `solid` without the first `less` faces; the shell is closed only if `less`
// is 0.
TopoDS_Shell shell_of(const TopoDS_Shape& solid, int less) {
    BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    int left_out = 0;
    for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
        if (left_out++ >= less) builder.Add(shell, face.Current());
    }
    shell.Closed(less == 0);
    return shell;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return EXIT_FAILURE;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    bool good = true;
    const auto write = [&](const TopoDS_Shape& shape, const std::string& name,
                           STEPControl_StepModelType as, const char* unit = "MM") {
        // OpenCASCADE reads the settings when the writer is created, and again when the writer
        // writes.
        STEPControl_Controller::Init();
        Interface_Static::SetCVal("write.step.unit", unit);
        Interface_Static::SetIVal("write.step.assembly", 1);
        STEPControl_Writer writer;
        good = good && writer.Transfer(shape, as) == IFSelect_RetDone &&
               writer.Write((folder / name).c_str()) == IFSelect_RetDone;
    };
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Solid();
    write(box, "box.step", STEPControl_AsIs);
    write(box, "inch.step", STEPControl_AsIs, "INCH");
    write(box, "metre.step", STEPControl_AsIs, "M");
    // Two instances of a body.
    write(together({box, moved(box, 40.0)}), "assembly.step", STEPControl_AsIs);
    const gp_Ax2 beside(gp_Pnt(0, 15, 0), gp::DZ());
    write(together({BRepPrimAPI_MakeSphere(2.5).Solid(),
                    moved(BRepPrimAPI_MakeTorus(2.5, 0.75).Solid(), 10.0),
                    BRepPrimAPI_MakeCone(beside, 2.0, 0.75, 3.0).Solid(),
                    moved(BRepPrimAPI_MakeCylinder(beside, 1.5, 3.0).Solid(), 10.0)}),
          "curved.step", STEPControl_AsIs);
    write(shell_of(box, 0), "shell.step", STEPControl_ShellBasedSurfaceModel);
    write(shell_of(box, 1), "open.step", STEPControl_ShellBasedSurfaceModel);
    write(TopExp_Explorer(box, TopAbs_WIRE).Current(), "wire.step", STEPControl_AsIs);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
