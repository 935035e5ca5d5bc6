#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the output of two postprocessors for the same part: volume, path, bores, faces.

Usage: compare_posts.py PROGRAM OTHER_PROGRAM
"""
import collections
import sys
from typing import Counter, Dict

import numpy as np

import ncsim


def facts(part: ncsim.Simulation) -> Dict[str, object]:
    motions = part.motions
    feed = motions["length"][motions["kind"] == ncsim.Kind.FEED]
    faces: Counter[str] = collections.Counter(face.kind for face in part.solid().faces)
    return {
        "volume, mm3": round(part.volume, 3),
        "tools": ", ".join(f"T{number}" for number in sorted(part.tools)),
        "feed, mm": round(float(np.nansum(feed)), 3),
        "bores": sorted((bore.diameter_mm, bore.depth_mm) for bore in part.measure().bores),
        "faces": dict(sorted(faces.items())),
    }


def main(program: str, other: str) -> int:
    ours, theirs = (facts(ncsim.simulate(path)) for path in (program, other))
    for name, value in ours.items():
        mark = " " if value == theirs[name] else "!"
        print(f"{mark} {name:12} {value}   {theirs[name]}")
    return 0 if ours == theirs else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
