# SPDX-License-Identifier: GPL-3.0-or-later
"""Dimensions of a part, as a calliper would measure them."""
from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

from ._set_up import Path, SetUp
from ._simulation import Point, simulate
from ._verdict import box_from

if TYPE_CHECKING:
    from typing_extensions import Unpack


@dataclass(frozen=True)
class Bore:
    """Cylinder around air, more than half of a circle."""

    diameter_mm: float
    depth_mm: float
    end: str  #: "through", "flat", "cone" …
    through: bool
    mouth: Point
    axis: Point
    mouth_slants_by_mm: float
    covers_degrees: float
    lines: Tuple[int, ...]
    tools: Tuple[int, ...]
    tip_depth_mm: Optional[float] = None
    tip_angle_degrees: Optional[float] = None


@dataclass(frozen=True)
class Boss:
    """Cylinder around material, more than half of a circle."""

    diameter_mm: float
    height_mm: float
    foot: Point
    axis: Point
    covers_degrees: float
    lines: Tuple[int, ...]
    tools: Tuple[int, ...]


@dataclass(frozen=True)
class Thread:
    """Thread by a tap, or by a turn or more of a thread mill or a slot mill."""

    diameter_mm: float
    pitch_mm: Optional[float]  #: None: the tap has no pitch.
    depth_mm: float
    inside: bool
    mouth: Point
    lines: Tuple[int, ...]
    tools: Tuple[int, ...]


@dataclass(frozen=True)
class Countersink:
    """Cone around air that opens at its wide end."""

    diameter_mm: float
    depth_mm: float
    angle_degrees: float
    tip: bool
    mouth: Point
    axis: Point
    covers_degrees: float
    lines: Tuple[int, ...]
    tools: Tuple[int, ...]


@dataclass(frozen=True)
class Chamfer:
    """Plane or cone in the place of the edge between a level face and an upright face."""

    width_mm: float
    height_mm: float
    angle_degrees: float
    length_mm: float
    at: Point
    lines: Tuple[int, ...]
    tools: Tuple[int, ...]


@dataclass(frozen=True)
class Corner:
    """Rounded corner: cylinder of at most half of a circle."""

    radius_mm: float
    inside: bool
    covers_degrees: float
    centre: Point
    axis: Point
    lines: Tuple[int, ...]
    tools: Tuple[int, ...]


@dataclass(frozen=True)
class Floor:
    """Plane face that looks up."""

    z: float
    below_top_mm: float
    above_bottom_mm: float
    area_mm2: float
    walls_all_round: bool
    min: Point
    max: Point
    lines: Tuple[int, ...]
    tools: Tuple[int, ...]


@dataclass(frozen=True)
class Distance:
    """Distance of two parallel walls."""

    mm: float
    between: str  #: "void" or "material"
    start: Point
    end: Point
    lines: Tuple[int, ...]
    tools: Tuple[int, ...]


@dataclass(frozen=True)
class Measures:
    """All dimensions of a part, to a millionth of a mm."""

    program: str
    volume_mm3: float
    extents: Optional[Tuple[Point, Point]]  #: None: nothing is left.
    bores: List[Bore]
    bosses: List[Boss]
    corners: List[Corner]
    floors: List[Floor]
    distances: Optional[List[Distance]]  #: None: there are too many walls.
    unmeasured_facets: int  #: Facets of round tools that matched no surface.
    threads: List[Thread]
    countersinks: List[Countersink]
    chamfers: List[Chamfer]


def _plain(row: Dict[str, Any], **names: str) -> Dict[str, Any]:
    """Returns the row with tuples for lists, and with the new names of keys."""
    return {names.get(key, key): tuple(value) if isinstance(value, list) else value
            for key, value in row.items()}


def measures_from(text: str) -> Measures:
    """Returns the measures of a report (docs/schemas/measure.schema.json)."""
    report = json.loads(text)
    distances = report["distances"]
    names = {"from": "start", "to": "end"}
    return Measures(
        program=report["program"], volume_mm3=report["volume_mm3"],
        extents=box_from(report["extents"]),
        bores=[Bore(**_plain(row)) for row in report["bores"]],
        bosses=[Boss(**_plain(row)) for row in report["bosses"]],
        corners=[Corner(**_plain(row)) for row in report["corners"]],
        floors=[Floor(**_plain(row)) for row in report["floors"]],
        distances=None if distances is None else [
            Distance(**_plain(row, **names)) for row in distances],
        unmeasured_facets=report["not_measured"]["facets"],
        threads=[Thread(**_plain(row)) for row in report["threads"]],
        countersinks=[Countersink(**_plain(row)) for row in report["countersinks"]],
        chamfers=[Chamfer(**_plain(row)) for row in report["chamfers"]])


def measure(program: Optional[Path] = None, *, text: Optional[str] = None,
            name: str = "program.nc", **options: Unpack[SetUp]) -> Measures:
    """Simulates a program and returns the dimensions of the part: simulate(…).measure()."""
    return simulate(program, text=text, name=name, **options).measure()
