# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a program: volume, motions, mesh, solid."""
from __future__ import annotations

import enum
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Dict, List, Optional, Tuple

from . import _ncsim
from ._errors import Diagnostic
from ._set_up import Path, SimulateOptions, call_arguments

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from typing_extensions import Unpack

    from ._measures import Measures

Point = Tuple[float, float, float]


class Kind(enum.IntEnum):
    """Values of "kind" in Simulation.motions and Verdict.ledger."""

    RAPID = 0
    FEED = 1
    PROBE = 2
    DWELL = 3
    TOOL_CHANGE = 4


class Shape(enum.IntEnum):
    """Values of "shape" in Simulation.motions."""

    NONE = 0
    LINE = 1
    ARC = 2
    SPLINE = 3


class Mesh:
    """Surface of a part as triangles. The arrays are read-only views of the mesh."""

    def __init__(self, mesh: _ncsim.Mesh) -> None:
        self._mesh = mesh

    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """Corners, n x 3, mm."""
        return self._mesh.vertices

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """Indices into vertices, m x 3, counter-clockwise seen from outside."""
        return self._mesh.triangles

    @property
    def lines(self) -> npt.NDArray[np.uint32]:
        """Line of the program that cut each triangle; 0: the stock."""
        return self._mesh.lines

    @property
    def tools(self) -> npt.NDArray[np.uint32]:
        """Tool that cut each triangle; 0: the stock."""
        return self._mesh.tools

    @property
    def faces(self) -> npt.NDArray[np.uint32]:
        """Number of the flat face of each triangle, from 0."""
        return self._mesh.faces

    @property
    def volume(self) -> float:
        """Enclosed volume, mm3."""
        return self._mesh.volume

    @property
    def area(self) -> float:
        """Area of the surface, mm2."""
        return self._mesh.area

    @property
    def shells(self) -> int:
        """Number of closed surfaces."""
        return self._mesh.shells

    def write_stl(self, path: Path) -> None:
        """Writes binary STL, as `ncsim run --stl`."""
        self._mesh.write_stl(os.fspath(path))


@dataclass(frozen=True)
class Face:
    """A face of a solid."""

    kind: str  #: "plane", "cylinder", "cone", "sphere", "torus" …
    #: Diameter of a cylinder or sphere; full angle of a cone, degrees; both diameters of a torus.
    dimensions: Tuple[float, ...]
    axis: Point  #: Direction of the axis, normal of a plane; zero: none.
    origin: Point  #: A point on the axis, apex or centre.
    is_hollow: bool  #: The material surrounds the form, as around a bore.
    is_facet: bool  #: Facet of a round tool that matched no surface.
    area: float  #: mm2
    lines: Tuple[int, ...]  #: Lines that cut the face; empty: the stock.
    tools: Tuple[int, ...]


class Solid:
    """Part with true surfaces, for CAD."""

    def __init__(self, solid: _ncsim.Solid) -> None:
        self._solid = solid

    @property
    def faces(self) -> List[Face]:
        return [Face(**face) for face in self._solid.faces()]

    @property
    def volume(self) -> float:
        """Volume inside the true surfaces, mm3."""
        return self._solid.volume

    @property
    def area(self) -> float:
        """mm2"""
        return self._solid.area

    @property
    def centroid(self) -> Point:
        return self._solid.centroid

    @property
    def solids(self) -> int:
        """Number of separate bodies."""
        return self._solid.solids

    @property
    def facets(self) -> int:
        """Number of facets that matched no surface."""
        return self._solid.facets

    @property
    def miss(self) -> float:
        """Largest distance of an edge from its surfaces, mm."""
        return self._solid.miss

    def write_step(self, path: Path, *, attributes: bool = False) -> None:
        """Writes STEP AP242, as `ncsim run --step`; attributes: lines, tools and kind of faces."""
        self._solid.write_step(os.fspath(path), attributes)


class Simulation:
    """The part that a program leaves of its stock."""

    def __init__(self, simulation: _ncsim.Simulation) -> None:
        self._simulation = simulation
        self._motions: Optional[npt.NDArray[np.void]] = None

    def __repr__(self) -> str:
        return f"<ncsim.Simulation of {self.program}: {self.volume:.3f} mm3 of {self.stock_volume:.3f}>"

    @property
    def program(self) -> str:
        return self._simulation.program

    @property
    def files(self) -> List[str]:
        """The program and the called files; "file" of motions is an index."""
        return self._simulation.files

    @property
    def model(self) -> str:
        return self._simulation.model

    @property
    def tolerance(self) -> float:
        return self._simulation.tolerance

    @property
    def tool_tolerance(self) -> float:
        return self._simulation.tool_tolerance

    @property
    def tools(self) -> Dict[int, str]:
        """Descriptions of the tools that move, by number."""
        return self._simulation.tools

    @property
    def stock(self) -> str:
        """Description of the stock."""
        return self._simulation.stock

    @property
    def stock_box(self) -> Optional[Tuple[Point, Point]]:
        """Least and largest coordinates of the stock; None: the stock is empty."""
        return self._simulation.stock_box

    @property
    def stock_volume(self) -> float:
        return self._simulation.stock_volume

    @property
    def volume(self) -> float:
        """Volume of the part, mm3."""
        return self._simulation.volume

    @property
    def volume_error(self) -> float:
        """Bound of the error of volume, for models that are not exact."""
        return self._simulation.volume_error

    @property
    def removed(self) -> float:
        """Removed volume, mm3."""
        return self.stock_volume - self.volume

    @property
    def removed_by_tool(self) -> Dict[int, float]:
        """Removed volume by tool; empty without volumes="tool"."""
        return self._simulation.removed_by_tool

    @property
    def removed_by_block(self) -> Dict[Tuple[int, int], float]:
        """Removed volume by (file, line); empty without volumes="block"."""
        return self._simulation.removed_by_block

    @property
    def hulls(self) -> int:
        """Number of convex hulls that were removed."""
        return self._simulation.hulls

    @property
    def diagnostics(self) -> List[Diagnostic]:
        """Messages about the program."""
        return [Diagnostic(*row) for row in self._simulation.diagnostics]

    @property
    def not_used(self) -> List[str]:
        """Values of the machine that cannot be used."""
        return self._simulation.not_used

    @property
    def assumptions(self) -> List[str]:
        """Values that had to be assumed: "stock-guess: …"."""
        return self._simulation.assumptions()

    @property
    def motions(self) -> npt.NDArray[np.void]:
        """Motions in the order of execution: a structured, read-only array.

        Fields: file, line, column, tool, kind (Kind), shape (Shape), start, end (X, Y, Z of the
        tip), start_angles, end_angles (A, B, C), feed, speed, length, seconds. NaN: unknown.
        """
        if self._motions is None:
            self._motions = self._simulation.motions()
        return self._motions

    def mesh(self) -> Mesh:
        """Returns the surface as triangles."""
        return Mesh(self._simulation.mesh())

    def solid(self, *, refinements: int = 6) -> Solid:
        """Returns the part with true surfaces, after up to `refinements` further cuts."""
        return Solid(self._simulation.solid(refinements))

    def measure(self) -> Measures:
        """Returns the dimensions of the part, as `ncsim measure`."""
        from ._measures import measures_from
        return measures_from(self._simulation.measures())


def simulate(program: Optional[Path] = None, *, text: Optional[str] = None, name: str = "program.nc",
             **options: Unpack[SimulateOptions]) -> Simulation:
    """Simulates a program and returns the part.

    program: path of an NC program or a job file (.toml). text: the program itself, with the name
    `name` in messages. options: see SimulateOptions and SetUp.

    Raises UsageError for unusable arguments and files, ProgramError for a program with errors,
    Error if a limit ends the simulation.
    """
    return Simulation(_ncsim.simulate(*call_arguments(program, text, name, options)))


@dataclass(frozen=True)
class Step:
    """A program of a job."""

    number: int  #: Value of step=.
    set_up: int
    set_up_name: str
    program: str
    label: str


def steps(job: Path) -> List[Step]:
    """Returns the programs of a job file with set-ups, in the order of machining."""
    return [Step(*row) for row in _ncsim.steps(os.fspath(job))]
