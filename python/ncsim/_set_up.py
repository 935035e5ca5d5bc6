# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyword arguments of simulate(), check() and measure()."""
from __future__ import annotations

import os
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple, TypedDict, Union

Path = Union[str, "os.PathLike[str]"]


class SetUp(TypedDict, total=False):
    """Arguments of all functions. Each is an option of the program ncsim, with the same values.

    Missing arguments are as without the option; ncsim.toml is not read.
    """

    job: Path  #: Job file: tools, stock, set-ups.
    step: int  #: Program of the job, from 1 (steps()).
    tools: Mapping[int, str]  #: {1: "flat:D6:L22"}
    tool_tables: Sequence[Path]  #: Files with tools.
    holders: Path  #: File with tool holders.
    assume_tool: str  #: Tool for all tools without a description: "flat:D6".
    stock: Path  #: "100x60x20", "D50x80", or a stock file.
    stock_turn: str  #: Turns of a stock file: "X90,Z-37.5".
    stock_move: Tuple[float, float, float]
    machine: Path  #: Machine file.
    start: Tuple[float, float, float]  #: Position of the tool at the start, in G54.
    units: str  #: "mm" or "inch": unit of programs without G20 and G21.
    increments: bool  #: Numbers without a point are in 0.001 mm.
    dialect: str  #: "auto", "rs274", "fanuc", "haas", "heidenhain", "sinumerik" …
    strict: bool  #: Errors for blocks that LinuxCNC refuses.
    variables: Mapping[str, float]  #: {"#500": 1.0}
    compensation: Mapping[int, float]  #: Radius of G41 and G42 by register D.
    subprograms: Sequence[Path]  #: Folders with subprograms.
    block_delete: bool  #: Skips blocks that start with "/".
    allow: Sequence[str]  #: Words without effect: ["G187"].
    model: str  #: A name of MODELS.
    tolerance: float  #: Deviation of arcs and rotary moves, mm.
    tool_tolerance: float  #: Deviation of round tools, mm.
    threads: int
    max_memory: float  #: Limit of the process, GB.
    max_time: float  #: Limit of the simulation, s.


class SimulateOptions(SetUp, total=False):
    """Arguments of simulate()."""

    at_line: int  #: Stops after this line.
    resolution: float  #: For the model "dexel", mm.
    volumes: str  #: "total", "tool", "block": detail of the removed volumes; "block" is slow.
    allow_errors: bool  #: Blocks with errors are skipped and do not raise ProgramError.


class CheckOptions(SetUp, total=False):
    """Arguments of check()."""

    select: Sequence[str]  #: Only these rules or categories.
    ignore: Sequence[str]
    severity: Mapping[str, str]  #: {"air-cut": "error"}
    accept: Sequence[str]  #: Reasons for doubt that do not count.
    require: Sequence[str]  #: Values that must be specified: ["holder"].
    baseline: Path  #: File of known findings.
    design: Path  #: Surface file of the design.
    design_tolerance: float
    rapid: str  #: "linear" or "dog-leg".
    cut_free: bool  #: Finds pieces that are cut free.
    air_cuts: bool  #: Finds feed moves that remove nothing.
    warnings_as_errors: bool
    ledger: bool  #: Measures each block (Verdict.ledger); slow.


_PATHS = {"job", "holders", "machine", "stock", "baseline", "design"}
_PATH_LISTS = {"tool_tables", "subprograms"}


def call_arguments(program: Optional[Path], text: Optional[str], name: str,
                   options: Mapping[str, Any]) -> Tuple[str, Optional[str], Dict[str, Any]]:
    """Returns the arguments of the functions of _ncsim, with paths as str."""
    arguments = dict(options)
    for key in _PATHS & arguments.keys():
        if arguments[key] is not None:
            arguments[key] = os.fspath(arguments[key])
    for key in _PATH_LISTS & arguments.keys():
        if arguments[key] is not None and not isinstance(arguments[key], str):
            arguments[key] = [os.fspath(path) for path in arguments[key]]
    if program is not None and text is not None:
        raise TypeError("expected a program or text=, not both")
    if text is not None and not isinstance(text, str):
        raise TypeError(f"text: expected str, not {type(text).__name__}")
    if text is not None:
        return name, text, arguments
    return ("" if program is None else os.fspath(program)), None, arguments
