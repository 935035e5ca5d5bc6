# SPDX-License-Identifier: GPL-3.0-or-later
"""Verdict on a program: findings, doubts, ledger."""
from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

from . import _ncsim
from ._set_up import CheckOptions, Path, call_arguments
from ._simulation import Point

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from typing_extensions import Unpack


@dataclass(frozen=True)
class Quantity:
    """A measured number: removed 12.5 mm3."""

    name: str
    value: float
    unit: str  #: "mm", "mm3", "mm/min" …


@dataclass(frozen=True)
class Finding:
    """A fault, or a row of the same fault in successive motions."""

    rule: str
    severity: str  #: "note", "warning" or "error".
    category: str
    message: str
    hint: str  #: Remedy.
    file: str
    line: Optional[int]  #: First line, from 1; None: no place.
    column: Optional[int]
    last_line: Optional[int]
    certain: bool  #: False: within the error of the round tool.
    first_motion: Optional[int]  #: From 1, in the order of execution.
    last_motion: Optional[int]
    tool: Optional[int]
    count: int  #: Number of motions.
    quantity: Optional[Quantity]
    point: Optional[Point]  #: Point of the first motion.
    box: Optional[Tuple[Point, Point]]  #: Box of all contacts.
    code: Optional[str]  #: Code of the message, for findings of the interpreter.
    suppressed: bool  #: By a comment in the program.
    accepted: Optional[str]  #: Reason of the baseline that accepts the finding.
    assumptions: Tuple[str, ...]

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}:{self.column}" if self.line else self.file
        return f"{place}: {self.severity}: {self.message} [{self.rule}]"


@dataclass(frozen=True)
class Doubt:
    """Reason for which a program without findings is not proven safe."""

    reason: str  #: "stock-guess"
    message: str
    fix: str
    file: str
    line: Optional[int]
    column: Optional[int]
    count: int
    accepted: bool


@dataclass(frozen=True)
class Skipped:
    """Rule that was not checked."""

    rule: str
    reason: str
    deselected: bool


@dataclass(frozen=True)
class Verdict:
    """Result of check()."""

    verdict: str  #: "clean", "accepted", "not-proven" or "failed".
    file: str
    findings: List[Finding]
    doubts: List[Doubt]
    skipped: List[Skipped]
    simulated: bool
    seconds: Optional[float]  #: Machining time; None: unknown.
    moves: int
    totals: Optional[Dict[str, Any]]  #: Volumes, path lengths and times; None: not simulated.
    design: Optional[Dict[str, Any]]  #: Deviations from the design.
    text: str  #: Report of `ncsim check`.
    json: Dict[str, Any]  #: The program in `ncsim check --json`: an element of "programs".
    #: Blocks in the order of execution, a structured, read-only array; None without ledger=True.
    #: Fields: file, line, first_motion, last_motion, tool, kind, length, removed, seconds.
    ledger: Optional[npt.NDArray[np.void]] = field(default=None, compare=False, repr=False)

    @property
    def is_clean(self) -> bool:
        """True if the exit code of `ncsim check` would be 0."""
        return self.verdict in ("clean", "accepted")

    def __bool__(self) -> bool:
        return self.is_clean


def _point(value: Optional[List[float]]) -> Optional[Point]:
    return None if value is None else (value[0], value[1], value[2])


def box_from(value: Optional[Dict[str, List[float]]]) -> Optional[Tuple[Point, Point]]:
    """Returns the box of a report."""
    if value is None:
        return None
    low, high = value["min"], value["max"]
    return (low[0], low[1], low[2]), (high[0], high[1], high[2])


def _finding(row: Dict[str, Any]) -> Finding:
    return Finding(
        rule=row["rule"], severity=row["severity"], category=row["category"],
        message=row["message"], hint=row["hint"], file=row["file"], line=row.get("line"),
        column=row.get("column"), last_line=row.get("last_line"), certain=row["certain"],
        first_motion=row.get("first_motion"), last_motion=row.get("last_motion"),
        tool=row.get("tool"), count=row["count"],
        quantity=Quantity(**row["quantity"]) if "quantity" in row else None,
        point=_point(row.get("point")), box=box_from(row.get("box")), code=row.get("code"),
        suppressed=row["suppressed"], accepted=row.get("accepted"),
        assumptions=tuple(row["assumptions"]))


def _doubt(row: Dict[str, Any]) -> Doubt:
    return Doubt(reason=row["reason"], message=row["message"], fix=row["fix"], file=row["file"],
                 line=row.get("line"), column=row.get("column"), count=row["count"],
                 accepted=row["accepted"])


def check(program: Optional[Path] = None, *, text: Optional[str] = None, name: str = "program.nc",
          **options: Unpack[CheckOptions]) -> Verdict:
    """Verifies a program and returns the verdict, as `ncsim check`.

    program, text, name: as in simulate(). options: see CheckOptions and SetUp. A fault of the
    program is a finding, not an exception.

    Raises UsageError for unusable arguments and files, Error if a limit ends the verification.
    """
    report, report_text, ledger = _ncsim.check(*call_arguments(program, text, name, options))
    row = json.loads(report)
    return Verdict(
        verdict=row["verdict"], file=row["file"],
        findings=[_finding(finding) for finding in row["findings"]],
        doubts=[_doubt(doubt) for doubt in row["doubts"]],
        skipped=[Skipped(**skipped) for skipped in row["skipped"]],
        simulated=row["simulated"], seconds=row.get("seconds"), moves=row["moves"],
        totals=row.get("ledger"), design=row.get("design"), text=report_text, json=row,
        ledger=ledger)
