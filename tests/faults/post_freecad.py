# SPDX-License-Identifier: GPL-3.0-or-later
"""Posts 20 small milling programs by FreeCAD, as base programs for fault injection.

Usage:     freecadcmd tests/faults/post_freecad.py
Requires:  FreeCAD 0.20 with its Path workbench (Debian 12: package freecad).
Writes:    tests/faults/programs/freecad-NN-NAME.nc   the program as posted
           tests/faults/programs/freecad-NN-NAME.toml its set-up, an ncsim job file
           tests/faults/programs/mill.toml            the machine of all of them
Guarantees: a second run writes the same bytes. The time of a header is replaced by a constant.

The environment variable POST_ONLY selects programs by a part of their names: POST_ONLY=03,fanuc.
Lengths are in mm, feeds in mm/min. X0 Y0 Z0 is the centre of the top of the part.
"""
import ctypes
import importlib
import os
import re
import sys
import traceback

import FreeCAD
import Part
import PathScripts.PathAdaptive as PathAdaptive
import PathScripts.PathDeburr as PathDeburr
import PathScripts.PathDressupDogbone as PathDressupDogbone
import PathScripts.PathDressupHoldingTags as PathDressupHoldingTags
import PathScripts.PathDressupLeadInOut as PathDressupLeadInOut
import PathScripts.PathDressupRampEntry as PathDressupRampEntry
import PathScripts.PathDrilling as PathDrilling
import PathScripts.PathEngrave as PathEngrave
import PathScripts.PathHelix as PathHelix
import PathScripts.PathJob as PathJob
import PathScripts.PathMillFace as PathMillFace
import PathScripts.PathPocketShape as PathPocketShape
import PathScripts.PathPost as PathPost
import PathScripts.PathProfile as PathProfile
import PathScripts.PathSlot as PathSlot
import PathScripts.PathStock as PathStock
import PathScripts.PathToolBit as PathToolBit
import PathScripts.PathToolController as PathToolController
from FreeCAD import Vector

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "programs")
TIME = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d(:\d\d(\.\d+)?)?")
LICENCE = "# SPDX-License-Identifier: GPL-3.0-or-later\n"
SHAPES = {
    "flat": "endmill.fcstd",
    "ball": "ballend.fcstd",
    "bull": "bullnose.fcstd",
    "v": "chamfer.fcstd",
    "drill": "drill.fcstd",
}

MACHINE = """\
# Three-axis mill of the programs that post_freecad.py writes. The jaws of the vice are clear of
# every stock and of every tool path.
name = "three-axis mill"
below_stock = 4              # mm free between the stock and the bed of the vice
[travel]                     # machine coordinates, mm
x = [-600, 0]
y = [-400, 0]
z = [-450, 0]
[rapid]                      # mm/min
x = 12000
y = 12000
z = 8000
[spindle]
min = 200
max = 18000
[feed]
max = 4000                   # mm/min
[position]                   # machine coordinates, mm
home = [0, 0, 0]
tool_change = [0, 0, 0]
start = [0, 0, 0]
[offsets]                    # machine coordinates of the zero of the part, mm
G54 = [-300, -200, -320]
G55 = [-220, -200, -320]
[[fixture]]
name = "fixed jaw"
offset = "G54"
box = [[-90, 66, -60], [90, 90, -12]]
[[fixture]]
name = "moving jaw"
offset = "G54"
box = [[-90, -90, -60], [90, -66, -12]]
"""


def block(x, y, z, centre=(0, 0), top=0):
    """Returns a box of the size `x`, `y`, `z` whose top face is at the height `top`."""
    return Part.makeBox(x, y, z, Vector(centre[0] - x / 2, centre[1] - y / 2, top - z))


def cylinder(diameter, height, centre=(0, 0), top=0):
    """Returns an upright cylinder whose top face is at the height `top`."""
    return Part.makeCylinder(diameter / 2, height, Vector(centre[0], centre[1], top - height))


def rounded(solid, radius):
    """Returns `solid` with its vertical edges rounded."""
    vertical = [
        edge
        for edge in solid.Edges
        if len(edge.Vertexes) == 2
        and abs(edge.Vertexes[0].X - edge.Vertexes[1].X) < 1e-6
        and abs(edge.Vertexes[0].Y - edge.Vertexes[1].Y) < 1e-6
    ]
    return solid.makeFillet(radius, vertical)


class Setup:
    """One Path job: part, stock, tools and operations, and the files posted from them."""

    def __init__(self, name, part, stock, fixtures=("G54",), order="Fixture", clearance=20.0):
        """Creates the job.

        `stock`: the extents beyond the part in -X, +X, -Y, +Y, -Z, +Z.
        `clearance`: height above the stock to which FreeCAD lifts the tool at a work offset.
        """
        self.name = name
        self.tools = []
        self.document = FreeCAD.newDocument("Program")
        base = self.document.addObject("Part::Feature", "Part")
        base.Shape = part
        self.document.recompute()
        self.job = PathJob.Create("Job", [base])
        self.job.GeometryTolerance = 0.01
        for controller in list(self.job.Tools.Group):
            self.document.removeObject(controller.Name)
        self.document.removeObject(self.job.Stock.Name)
        self.job.Stock = PathStock.CreateFromBase(
            self.job, Vector(stock[0], stock[2], stock[4]), Vector(stock[1], stock[3], stock[5])
        )
        self.job.Fixtures = list(fixtures)
        self.job.OrderOutputBy = order
        self.job.SetupSheet.ClearanceHeightOffset = clearance
        self.job.SetupSheet.HorizRapid = "3600 mm/min"
        self.job.SetupSheet.VertRapid = "3000 mm/min"
        self.document.recompute()
        self.model = self.job.Model.Group[0]

    def tool(
        self, number, kind, diameter, flutes, stick_out, speed, feed, plunge, shank=None, **sizes
    ):
        """Adds a tool and its controller.

        `flutes`: length of the flutes. `stick_out`: length from the holder to the tip.
        `shank`: diameter of the shank if it is not that of the cutter.
        `sizes`: other properties of the FreeCAD tool bit, for instance TipAngle.
        """
        bit = PathToolBit.Factory.Create("Bit%d" % number, SHAPES[kind])
        bit.Diameter = diameter
        bit.Length = stick_out + 20
        if kind != "drill":
            bit.CuttingEdgeHeight = flutes
        for key, value in sizes.items():
            setattr(bit, key, value)
        # The fanuc post reads a property that the tool bits of FreeCAD 0.20 do not have.
        bit.addProperty("App::PropertyString", "ToolType")
        bit.ToolType = "Drill" if kind == "drill" else "EndMill"
        bit.Proxy._updateBitShape(bit)
        bit.Proxy.unloadBitBody(bit)
        controller = PathToolController.Create("TC%d" % number, bit, number)
        controller.Label = "T%d %s %g mm" % (number, kind, diameter)
        controller.SpindleSpeed = speed
        controller.SpindleDir = "Forward"
        controller.HorizFeed = "%g mm/min" % feed
        controller.VertFeed = "%g mm/min" % plunge
        self.job.Proxy.addToolController(controller)
        self.document.recompute()
        self.tools.append((number, kind, diameter, flutes, stick_out, shank or diameter, sizes))
        return controller

    def faces(self, height, lower=-1e9, upper=1e9):
        """Returns the names of the horizontal faces at `height` that look up.

        `lower`, `upper`: range of the X of their centres.
        """
        names = []
        for index, face in enumerate(self.model.Shape.Faces):
            if abs(face.BoundBox.ZMax - height) > 1e-6 or face.BoundBox.ZLength > 1e-6:
                continue
            if face.normalAt(0.5, 0.5).z > 0.5 and lower <= face.CenterOfMass.x <= upper:
                names.append("Face%d" % (index + 1))
        return [(self.model, names)]

    def holes(self, diameter):
        """Returns the names of the cylindrical faces of the diameter."""
        names = []
        for index, face in enumerate(self.model.Shape.Faces):
            if isinstance(face.Surface, Part.Cylinder):
                if abs(2 * face.Surface.Radius - diameter) < 1e-6:
                    names.append("Face%d" % (index + 1))
        return [(self.model, names)]

    def edges(self, height):
        """Returns the names of the edges at `height`."""
        names = [
            "Edge%d" % (index + 1)
            for index, edge in enumerate(self.model.Shape.Edges)
            if abs(edge.BoundBox.ZMax - height) < 1e-6 and edge.BoundBox.ZLength < 1e-6
        ]
        return [(self.model, names)]

    def operation(self, module, label, controller, base, depths, heights=(3, 40), **properties):
        """Adds an operation.

        `depths`: start depth, final depth and, where the operation has one, step down.
        `heights`: safe height and clearance height.
        """
        controllers = self.job.Tools.Group
        self.job.Tools.Group = [controller]  # FreeCAD asks the user if there are two
        result = module.Create(label.replace(" ", ""))
        self.job.Tools.Group = controllers
        result.Label = label
        result.ToolController = controller
        if base is not None:
            result.Base = base
        values = dict(zip(("StartDepth", "FinalDepth", "StepDown"), depths))
        values.update(zip(("SafeHeight", "ClearanceHeight"), heights))
        for key, value in values.items():
            if hasattr(result, key):
                result.setExpression(key, None)
                setattr(result, key, value)
        for key, value in properties.items():
            result.setExpression(key, None)
            setattr(result, key, value)
        ctypes.CDLL(None).srand(1)  # the Adaptive operation calls rand()
        self.document.recompute()
        if len(result.Path.Commands) < 3:
            raise RuntimeError("%s: operation %s has no path" % (self.name, label))
        return result

    def dressup(self, module, label, base, **properties):
        """Adds a dressup of the operation `base`. FreeCAD knows a dressup by its name."""
        result = self.document.addObject("Path::FeaturePython", "Dressup")
        dressup = module.ObjectDressup(result)
        result.Label = label
        result.Base = base
        self.job.Proxy.addOperation(result, base)
        dressup.setup(result)
        for key, value in properties.items():
            setattr(result, key, value)
        self.document.recompute()
        return result

    def post(self, post, arguments=""):
        """Writes the program and its set-up, and closes the document."""
        module = importlib.reload(importlib.import_module("PathScripts.post.%s_post" % post))
        objects = PathPost.CommandPathPost().buildPostList(self.job)[0]
        file = self.name + ".nc"
        module.export(objects, file, arguments + " --no-show-editor")
        with open(file) as stream:
            text = stream.read()
        text = TIME.sub("not recorded", text)
        with open(file, "w") as stream:
            stream.write(text)
        with open(self.name + ".toml", "w") as stream:
            stream.write(self.set_up(post, arguments))
        print("%s: %d lines" % (file, text.count("\n")))
        FreeCAD.closeDocument(self.document.Name)

    def set_up(self, post, arguments):
        """Returns the ncsim job file of the set-up."""
        box = self.job.Stock.Shape.BoundBox
        lines = [
            LICENCE + "# Posted by FreeCAD %s.%s, post-processor %s, arguments: %s"
            % (*FreeCAD.Version()[:2], post, arguments or "none"),
            "# Written by post_freecad.py. Lengths in mm, angles in degrees.",
            "version = 2",
            'program = "%s.nc"' % self.name,
            'units = "%s"' % ("inch" if "--inches" in arguments else "mm"),
            "start = [0, 0, 200]",
        ]
        if post == "centroid":  # M25 of a Centroid control retracts the spindle
            lines.append('allow = ["M25"]')
        lines += [
            "",
            "[stock]",
            "min = [%g, %g, %g]" % (box.XMin, box.YMin, box.ZMin),
            "max = [%g, %g, %g]" % (box.XMax, box.YMax, box.ZMax),
        ]
        for number, kind, diameter, flutes, stick_out, shank, sizes in self.tools:
            lines += ["", "[[tool]]", "number = %d" % number, 'kind = "%s"' % kind]
            lines += ["diameter = %g" % diameter, "length = %g" % flutes]
            if kind == "bull":
                lines.append("corner_radius = %g" % sizes["FlatRadius"])
            if kind == "v":
                lines.append("tip_diameter = %g" % sizes["TipDiameter"])
                lines.append("angle = %g" % sizes["CuttingEdgeAngle"])
            if kind == "drill":
                lines.append("angle = %g" % sizes["TipAngle"])
            if stick_out > flutes:
                lines.append("shank_diameter = %g" % shank)
                lines.append("shank_length = %g" % (stick_out - flutes))
            lines.append("stick_out = %g" % stick_out)
            lines.append("holder = [[28, 28, 20], [40, 40, 30]]")
            lines.append("offset = [0, 0, %g]" % (stick_out + 50))
        return "\n".join(lines) + "\n"


PROGRAMS = []


def program(function):
    """Registers a function that makes one program; its number is the order of registration."""
    number = len(PROGRAMS) + 1
    name = "freecad-%02d-%s" % (number, function.__name__.replace("_", "-"))
    PROGRAMS.append((name, function))
    return function


@program
def pocket_ramped(name):
    """Rounded pocket, entered by a ramp, and the outer contour."""
    part = block(70, 50, 14).cut(rounded(block(40, 24, 6), 6))
    setup = Setup(name, part, (4, 4, 4, 4, 0, 0), clearance=130)
    mill = setup.tool(1, "flat", 8, 20, 40, 6000, 700, 200)
    pocket = setup.operation(
        PathPocketShape, "Pocket", mill, setup.faces(-6), (0, -6, 2), StepOver=60,
        OffsetPattern="Offset"
    )
    setup.dressup(PathDressupRampEntry, "Pocket ramp", pocket, Angle=75, Method="RampMethod1")
    setup.operation(PathProfile, "Contour", mill, None, (0, -12, 4), Side="Outside")
    setup.post("linuxcnc")


@program
def drilled_plate_inch(name):
    """Six through holes by G81 and G83, in inches."""
    part = block(76.2, 50.8, 12.7)
    for x in (-25.4, 0, 25.4):
        for y in (-12.7, 12.7):
            part = part.cut(cylinder(6.35 if x else 5, 20, (x, y), 1))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0), clearance=150)
    small = setup.tool(11, "drill", 5, 50, 50, 2500, 200, 150, TipAngle=118.0)
    large = setup.tool(12, "drill", 6.35, 60, 60, 2000, 200, 120, TipAngle=118.0)
    setup.operation(PathDrilling, "Drill 5", small, setup.holes(5), (0, -14.7), RetractHeight=2)
    setup.operation(
        PathDrilling, "Drill quarter inch", large, setup.holes(6.35), (0, -15), RetractHeight=2,
        PeckEnabled=True, PeckDepth=4,
    )
    setup.post("linuxcnc", "--inches")


@program
def helix_bores(name):
    """Two bores by helical arcs."""
    part = block(70, 40, 16)
    part = part.cut(cylinder(18, 10, (-16, 0))).cut(cylinder(14, 8, (16, 0)))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0), clearance=130)
    mill = setup.tool(3, "flat", 8, 20, 40, 5000, 600, 200)
    setup.operation(
        PathHelix, "Bore 18", mill, setup.holes(18), (0, -10, 2), StepOver=50, StartSide="Inside"
    )
    setup.operation(
        PathHelix, "Bore 14", mill, setup.holes(14), (0, -8, 2), StepOver=50, StartSide="Inside"
    )
    setup.post("linuxcnc", "--axis-modal --line-numbers")


@program
def boss_contour(name):
    """Round boss, milled from outside in two steps, without a length offset (G43)."""
    part = block(60, 60, 6, top=-6).fuse(cylinder(30, 7, top=0)).removeSplitter()
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0))
    mill = setup.tool(1, "flat", 10, 22, 40, 8000, 800, 300)
    top = setup.faces(0)
    setup.operation(PathProfile, "Boss rough", mill, top, (0, -6, 3), Side="Outside", OffsetExtra=8)
    setup.operation(PathProfile, "Boss finish", mill, top, (0, -6, 3), Side="Outside")
    setup.post("grbl", "--tool-change")


@program
def pecked_holes(name):
    """Eight blind holes by G83, which the post translates into single moves."""
    part = block(80, 50, 20)
    for x in (-30, -10, 10, 30):
        for y in (-15, 15):
            part = part.cut(cylinder(6, 14, (x, y)))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0))
    drill = setup.tool(2, "drill", 6, 60, 60, 1800, 300, 140, TipAngle=118.0)
    setup.operation(
        PathDrilling, "Peck", drill, setup.holes(6), (0, -14), RetractHeight=2, PeckEnabled=True,
        PeckDepth=5
    )
    setup.post("grbl", "--translate_drill --tool-change --line-numbers")


@program
def zigzag_pocket_inch(name):
    """Rectangular pocket in zigzag lines, in inches. The tool change is a comment."""
    part = block(76.2, 50.8, 12.7).cut(block(50.8, 25.4, 5))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0))
    mill = setup.tool(4, "flat", 6.35, 19, 40, 9000, 900, 250)
    setup.operation(
        PathPocketShape, "Pocket", mill, setup.faces(-5), (0, -5, 2.5), StepOver=50,
        OffsetPattern="ZigZagOffset", ZigZagAngle=30,
    )
    setup.post("grbl", "--inches --wait-for-spindle=2")


@program
def adaptive_pocket(name):
    """Rounded pocket, adaptive clearing with helical entry. The post makes feed moves of rapids."""
    part = block(56, 44, 14).cut(rounded(block(34, 26, 8), 6))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0), clearance=130)
    mill = setup.tool(5, "flat", 10, 22, 40, 8000, 1000, 300)
    setup.operation(
        PathAdaptive, "Adaptive", mill, setup.faces(-8), (0, -8, 4), StepOver=40, Tolerance=0.3,
        HelixAngle=5, HelixDiameterLimit=6, LiftDistance=1, UseOutline=False, UseHelixArcs=True,
    )
    setup.post("mach3_mach4")


@program
def faced_block_g55(name):
    """Face milled from outside, then the contour, in G55."""
    part = block(60, 50, 12)
    setup = Setup(name, part, (3, 3, 3, 3, 0, 2), fixtures=("G55",), clearance=140)
    face = setup.tool(1, "flat", 20, 25, 45, 3000, 900, 300, shank=16)
    mill = setup.tool(2, "flat", 8, 22, 40, 7000, 800, 250)
    setup.operation(
        PathMillFace, "Face", face, None, (2, 0, 1), heights=(5, 40), StepOver=60,
        BoundaryShape="Stock",
        OffsetPattern="ZigZag",
    )
    setup.operation(
        PathProfile, "Contour", mill, None, (0, -10, 5), heights=(5, 40), Side="Outside"
    )
    setup.post("mach3_mach4", "--modal")


@program
def drilled_pocket(name):
    """Pocket by an end mill, spot holes by G81, deep holes by G83: three tools, modal G words."""
    part = block(80, 50, 18).cut(rounded(block(30, 30, 4), 5))
    for x in (-30, 30):
        for y in (-15, 15):
            part = part.cut(cylinder(5, 14, (x, y)))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0), clearance=150)
    mill = setup.tool(1, "flat", 8, 22, 40, 7000, 800, 250)
    spot = setup.tool(2, "drill", 8, 45, 45, 2400, 300, 120, TipAngle=90.0)
    drill = setup.tool(3, "drill", 5, 60, 60, 2000, 300, 140, TipAngle=118.0)
    setup.operation(
        PathPocketShape, "Pocket", mill, setup.faces(-4), (0, -4, 2), StepOver=50,
        OffsetPattern="Offset"
    )
    setup.operation(PathDrilling, "Spot", spot, setup.holes(5), (0, -2), RetractHeight=2)
    setup.operation(
        PathDrilling, "Drill", drill, setup.holes(5), (0, -14), RetractHeight=2, PeckEnabled=True,
        PeckDepth=4
    )
    setup.post("fanuc", "--no-header --no-axis-modal")


@program
def lead_in_contour(name):
    """Rounded contour with arcs into and out of it."""
    part = rounded(block(60, 40, 10), 8)
    setup = Setup(name, part, (5, 5, 5, 5, 0, 0), clearance=130)
    mill = setup.tool(7, "flat", 10, 22, 40, 6000, 700, 200)
    contour = setup.operation(PathProfile, "Contour", mill, None, (0, -8, 4), Side="Outside")
    setup.dressup(
        PathDressupLeadInOut, "Contour lead", contour, Length=6, StyleOn="Arc", StyleOff="Arc",
        IncludeLayers=True
    )
    setup.post("fanuc", "--no-header --no-axis-modal")


@program
def step_pocket(name):
    """Pocket in a pocket."""
    part = block(80, 60, 16).cut(rounded(block(50, 40, 4), 6)).cut(rounded(block(24, 20, 9), 4))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0), clearance=130)
    mill = setup.tool(2, "flat", 6, 15, 35, 9000, 700, 200)
    setup.operation(
        PathPocketShape, "Upper pocket", mill, setup.faces(-4), (0, -4, 2), StepOver=60,
        OffsetPattern="Offset",
        UseOutline=True,
    )
    setup.operation(
        PathPocketShape, "Lower pocket", mill, setup.faces(-9), (-4, -9, 2.5), StepOver=60,
        OffsetPattern="Offset"
    )
    setup.post("centroid", "--no-header")


@program
def slots_inch(name):
    """Two slots, in inches."""
    part = block(76.2, 50.8, 12.7).cut(block(50.8, 9.525, 6, (0, 12)))
    part = part.cut(block(50.8, 9.525, 6, (0, -12)))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0))
    mill = setup.tool(1, "flat", 9.525, 22, 40, 8000, 800, 250)
    for number, y in enumerate((12, -12)):
        setup.operation(
            PathSlot, "Slot %d" % (number + 1), mill, None, (0, -6, 2),
            CustomPoint1=Vector(-18, y, -6),
            CustomPoint2=Vector(18, y, -6), CutPattern="ZigZag", LayerMode="Multi-pass",
        )
    setup.post("centroid", "--no-header --inches")


@program
def contour_with_tags(name):
    """Contour through the stock, with holding tags."""
    part = rounded(block(60, 40, 8), 5)
    setup = Setup(name, part, (10, 10, 10, 10, 0, 0))
    mill = setup.tool(1, "flat", 6, 18, 35, 8000, 700, 200)
    contour = setup.operation(PathProfile, "Contour", mill, None, (0, -8, 2), Side="Outside")
    tags = PathDressupHoldingTags.Create(contour, "DressupTag")
    tags.Label = "Contour tags"
    tags.Width, tags.Height, tags.Angle = 6, 3, 45
    setup.document.recompute()
    setup.post("smoothie", "--no-header")


@program
def pocket_and_holes(name):
    """Round pocket and four holes, two tools."""
    part = block(70, 50, 15).cut(cylinder(30, 5))
    for x in (-27, 27):
        for y in (-17, 17):
            part = part.cut(cylinder(4.5, 20, (x, y), 1))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0), clearance=130)
    mill = setup.tool(21, "flat", 8, 20, 35, 9000, 900, 250)
    drill = setup.tool(22, "drill", 4.5, 55, 55, 2500, 300, 120, TipAngle=118.0)
    setup.operation(
        PathPocketShape, "Pocket", mill, setup.faces(-5), (0, -5, 2.5), StepOver=60,
        OffsetPattern="Offset"
    )
    setup.operation(PathDrilling, "Drill", drill, setup.holes(4.5), (0, -17), RetractHeight=2)
    setup.post("uccnc", "--no-header --tool-length-offset --repeat")


@program
def bores_inch(name):
    """Four bores by helical arcs, in inches. The post writes no G20."""
    part = block(76.2, 50.8, 12.7)
    for x in (-22, 22):
        for y in (-12, 12):
            part = part.cut(cylinder(12.7, 7, (x, y)))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0))
    mill = setup.tool(1, "flat", 6.35, 19, 35, 9000, 700, 200)
    setup.operation(
        PathHelix, "Bores", mill, setup.holes(12.7), (0, -7, 1), StepOver=50, StartSide="Inside"
    )
    setup.post("uccnc", "--no-header --inches --repeat")


@program
def open_step(name):
    """Step along two sides of the part, by a bull-nose end mill."""
    part = block(70, 50, 16).cut(block(30, 60, 6, (30, 0)))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0))
    mill = setup.tool(1, "bull", 10, 22, 40, 6000, 800, 250, FlatRadius=1.5)
    setup.operation(
        PathPocketShape, "Step", mill, setup.faces(-6), (0, -6, 2), StepOver=60,
        OffsetPattern="Line", ZigZagAngle=90
    )
    setup.post("dynapath", "--no-header")


@program
def holes_and_contour(name):
    """Holes by G83 and the contour, with coolant and line numbers."""
    part = rounded(block(60, 44, 10), 10)
    for x in (-18, 0, 18):
        part = part.cut(cylinder(6, 20, (x, 0), 1))
    setup = Setup(name, part, (4, 4, 4, 4, 0, 0), clearance=150)
    drill = setup.tool(1, "drill", 6, 50, 50, 1900, 300, 140, TipAngle=118.0)
    mill = setup.tool(2, "flat", 8, 22, 40, 7000, 700, 200)
    setup.operation(
        PathDrilling, "Drill", drill, setup.holes(6), (0, -12), RetractHeight=2, PeckEnabled=True,
        PeckDepth=3,
        CoolantMode="Flood",
    )
    setup.operation(
        PathProfile, "Contour", mill, None, (0, -9, 3), Side="Outside", CoolantMode="Mist"
    )
    setup.post("mach3_mach4", "--no-header --line-numbers")


@program
def two_offsets(name):
    """Two parts of one bar, in G54 and G55, ordered by tool: pocket, then holes."""
    part = block(60, 40, 12).cut(rounded(block(24, 24, 4), 5))
    for x in (-24, 24):
        part = part.cut(cylinder(5, 10, (x, 0)))
    setup = Setup(
        name, part, (0, 80, 0, 0, 0, 0), fixtures=("G54", "G55"), order="Tool", clearance=150
    )
    mill = setup.tool(1, "flat", 8, 22, 40, 7000, 800, 250)
    drill = setup.tool(2, "drill", 5, 50, 50, 2200, 300, 120, TipAngle=118.0)
    setup.operation(
        PathPocketShape, "Pocket", mill, setup.faces(-4), (0, -4, 2), StepOver=60,
        OffsetPattern="Offset"
    )
    setup.operation(PathDrilling, "Drill", drill, setup.holes(5), (0, -10), RetractHeight=2)
    setup.post("linuxcnc")


@program
def engraved_and_chamfered(name):
    """Lines engraved by a ball end mill, and a chamfer along the upper edge."""
    part = block(60, 40, 14)
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0), clearance=130)
    ball = setup.tool(1, "ball", 3, 8, 30, 12000, 600, 200, shank=6)
    chamfer = setup.tool(
        2, "v", 10, 4.5, 35, 8000, 500, 200, TipDiameter=1.0, CuttingEdgeAngle=90.0
    )
    lines = setup.document.addObject("Part::Feature", "Lines")
    zigzag = Part.makePolygon(
        [Vector(x, 8 if n % 2 else -8, 0) for n, x in enumerate(range(-20, 21, 8))]
    )
    lines.Shape = Part.makeCompound([zigzag, Part.Wire(Part.makeCircle(14))])
    setup.operation(PathEngrave, "Engrave", ball, None, (0, -0.6, 0.3), BaseShapes=[lines])
    setup.operation(
        PathDeburr, "Chamfer", chamfer, setup.edges(0), (0, -2, 2), Width=1, ExtraDepth=0.5
    )
    setup.post("fanuc", "--no-header --no-axis-modal")


@program
def dogbone_slot(name):
    """Rectangular opening with relieved corners."""
    part = block(70, 50, 10).cut(block(36, 22, 6))
    setup = Setup(name, part, (0, 0, 0, 0, 0, 0))
    mill = setup.tool(1, "flat", 6, 18, 35, 9000, 700, 200)
    inside = setup.operation(
        PathProfile, "Opening", mill, setup.faces(-6), (0, -6, 2), Side="Inside"
    )
    PathDressupDogbone.Create(inside, "DressupDogbone").Label = "Opening dogbone"
    setup.document.recompute()
    setup.post("rrf", "--no-header --wait-for-spindle=0")


def main():
    """Writes all programs that POST_ONLY selects, and the machine."""
    os.makedirs(FOLDER, exist_ok=True)
    os.chdir(FOLDER)
    with open("mill.toml", "w") as stream:
        stream.write(LICENCE + MACHINE)
    selected = os.environ.get("POST_ONLY", "").split(",")
    for name, function in PROGRAMS:
        if any(part in name for part in selected):
            function(name)


try:
    main()
except Exception:  # freecadcmd does not print where a script fails
    traceback.print_exc()
    sys.exit(1)
sys.exit(0)  # otherwise freecadcmd waits for commands
