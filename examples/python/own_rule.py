#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A rule of a shop: rapid moves go aside at least CLEARANCE mm above the stock.

Usage: own_rule.py PROGRAM [CLEARANCE]
"""
import sys

import numpy as np

import ncsim


def main(program: str, clearance: str = "2") -> int:
    part = ncsim.simulate(program)
    if part.stock_box is None:
        print(f"{program}: the stock is empty")
        return 1
    top = part.stock_box[1][2]
    motions = part.motions
    rapid = motions[motions["kind"] == ncsim.Kind.RAPID]
    start, end = rapid["start"], rapid["end"]
    is_low = np.minimum(start[:, 2], end[:, 2]) < top + float(clearance)
    goes_aside = (start[:, :2] != end[:, :2]).any(axis=1) & ~np.isnan(start).any(axis=1)
    for motion in rapid[is_low & goes_aside]:
        print(f"{part.files[motion['file']]}:{motion['line']}:{motion['column']}: error: "
              f"rapid move to X{motion['end'][0]:g} Y{motion['end'][1]:g} at "
              f"{min(motion['start'][2], motion['end'][2]) - top:g} mm above the stock [shop-clearance]")
    return 1 if (is_low & goes_aside).any() else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
