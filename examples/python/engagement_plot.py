#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots how much material each block removes for each mm of its path.

Usage: engagement_plot.py PROGRAM PICTURE
"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import ncsim


def main(program: str, picture: str) -> int:
    ledger = ncsim.check(program, ledger=True).ledger
    assert ledger is not None
    feed = ledger[(ledger["kind"] == ncsim.Kind.FEED) & (ledger["length"] > 0.0)]
    if not len(feed):
        print(f"{program}: no feed move")
        return 1
    engagement = feed["removed"] / feed["length"]
    path = np.cumsum(feed["length"])
    figure, axes = plt.subplots(figsize=(9, 4), layout="constrained")
    for tool in np.unique(feed["tool"]):
        of_tool = feed["tool"] == tool
        axes.bar(path[of_tool], engagement[of_tool], width=-feed["length"][of_tool], align="edge",
                 label=f"T{tool}")
    axes.set_xlabel("path at feed, mm")
    axes.set_ylabel("removed, mm³ per mm")
    axes.set_title(program.rsplit("/", 1)[-1])
    axes.legend()
    figure.savefig(picture, dpi=120)
    highest = int(np.argmax(engagement))
    print(f"largest engagement: {engagement[highest]:.2f} mm3/mm, line {feed['line'][highest]}, "
          f"T{feed['tool'][highest]}")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
