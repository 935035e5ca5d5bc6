#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks all programs of a folder, several at a time, and prints a line for each.

Usage: check_folder.py FOLDER
"""
import pathlib
import sys
from concurrent.futures import ThreadPoolExecutor
from typing import Tuple

import ncsim


def row(program: pathlib.Path) -> Tuple[bool, str]:
    """Returns whether the program is clean, and its line of the table."""
    try:
        # A simulation runs without Python's global interpreter lock.
        verdict = ncsim.check(program, threads=1)
    except ncsim.Error as error:
        return False, f"{program.name:20} not verified: {error}"
    errors = sum(finding.severity == "error" for finding in verdict.findings)
    minutes = "unknown" if verdict.seconds is None else f"{verdict.seconds / 60:.1f} min"
    return verdict.is_clean, (f"{program.name:20} {verdict.verdict:12} {errors} errors, "
                              f"{len(verdict.doubts)} doubts, time {minutes}")


def main(folder: str) -> int:
    programs = sorted(pathlib.Path(folder).glob("*.nc"))
    with ThreadPoolExecutor() as threads:
        rows = list(threads.map(row, programs))
    for _, text in rows:
        print(text)
    return 0 if rows and all(is_clean for is_clean, _ in rows) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
