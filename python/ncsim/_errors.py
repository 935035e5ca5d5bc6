# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions with the place of the fault."""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Tuple

# "job.toml:3:5: unknown key": file, line and column of a message.
_PLACE = re.compile(r"(?P<file>[^\n]+?):(?P<line>\d+)(?::(?P<column>\d+))?: ")


@dataclass(frozen=True)
class Diagnostic:
    """A message about a place in a program."""

    severity: str  #: "note", "warning" or "error".
    code: str  #: Stable: "arc-without-centre".
    message: str
    file: str
    line: int  #: From 1; 0: no place.
    column: int  #: From 1, in bytes.
    count: int  #: Number of occurrences; the place is the first.

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}: {self.severity}: {self.message} [{self.code}]"


class Error(Exception):
    """Base of the exceptions of ncsim. file, line, column and code are None if unknown."""

    file: Optional[str] = None
    line: Optional[int] = None
    column: Optional[int] = None
    code: Optional[str] = None

    def __init__(self, message: str) -> None:
        super().__init__(message)
        place = _PLACE.match(message)
        if place:
            self.file = place["file"]
            self.line = int(place["line"])
            self.column = int(place["column"]) if place["column"] else None


class UsageError(Error, ValueError):
    """Unusable argument, or a file that cannot be read."""


class ProgramError(Error):
    """Program that cannot be simulated, or with errors in its blocks."""

    diagnostics: List[Diagnostic]  #: All messages about the program.

    def __init__(self, message: str, diagnostics: Sequence[Tuple[Any, ...]] = ()) -> None:
        super().__init__(message)
        self.args = (message, diagnostics)
        self.diagnostics = [Diagnostic(*row) for row in diagnostics]
        errors = [d for d in self.diagnostics if d.severity == "error"]
        if errors:
            first = errors[0]
            self.file, self.line, self.column = first.file, first.line, first.column
            self.code = first.code

    def __str__(self) -> str:
        return str(self.args[0])
