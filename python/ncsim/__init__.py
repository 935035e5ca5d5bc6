# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulation and verification of NC milling programs.

simulate() returns the part of a program, check() the verdict, measure() the dimensions of the
part. All functions take a program (a path, or text=) and the keyword arguments of SetUp. Lengths
are in mm, volumes in mm3, angles in degrees, in the coordinate system of the first cut.
"""
import numpy as _numpy  # noqa: F401  (threads that load it at the same time block each other)

from ._errors import Diagnostic, Error, ProgramError, UsageError
from ._measures import (Boss, Bore, Chamfer, Corner, Countersink, Distance, Floor, Measures, Thread,
                        measure)
from ._ncsim import models as MODELS
from ._ncsim import version as __version__
from ._set_up import CheckOptions, SetUp, SimulateOptions
from ._simulation import (Face, Kind, Mesh, Shape, Simulation, Solid, Step, simulate, steps)
from ._verdict import Doubt, Finding, Quantity, Skipped, Verdict, check

__all__ = [
    "Boss", "Bore", "Chamfer", "CheckOptions", "Corner", "Countersink", "Diagnostic", "Distance", "Doubt", "Error", "Face",
    "Finding", "Floor", "Kind", "MODELS", "Measures", "Mesh", "ProgramError", "Quantity", "SetUp",
    "Shape", "SimulateOptions", "Simulation", "Skipped", "Solid", "Step", "UsageError", "Verdict",
    "__version__", "check", "measure", "simulate", "steps",
]
