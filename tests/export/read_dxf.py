# SPDX-License-Identifier: GPL-3.0-or-later
"""read_dxf.py <section.dxf> <report.json>: ezdxf finds nothing to repair, the pieces make as many
closed outlines as the report tells, around as much area."""
import json
import math
import sys

import ezdxf

SAME = 3e-6  # mm; coordinates are written in nanometres


def pieces(drawing):
    """Start, end, and the points between; arcs and circles in steps of a thousandth of a turn."""
    for entity in drawing.modelspace():
        kind = entity.dxftype()
        if kind == "LINE":
            yield [entity.dxf.start, entity.dxf.end]
        elif kind in ("ARC", "CIRCLE"):
            centre, radius = entity.dxf.center, entity.dxf.radius
            begin = entity.dxf.start_angle if kind == "ARC" else 0.0
            turn = (entity.dxf.end_angle - begin) % 360.0 if kind == "ARC" else 360.0
            steps = max(8, int(20 * turn))
            yield [(centre[0] + radius * math.cos(math.radians(begin + turn * i / steps)),
                    centre[1] + radius * math.sin(math.radians(begin + turn * i / steps)))
                   for i in range(steps + 1)]
        elif kind != "TEXT":
            raise SystemExit(f"a {kind}")


def outlines(drawing):
    """Closed, whichever way round their pieces are drawn."""
    left = [[(p[0], p[1]) for p in piece] for piece in pieces(drawing)]
    while left:
        loop = left.pop()
        while math.dist(loop[0], loop[-1]) > SAME:
            for i, piece in enumerate(left):
                if math.dist(loop[-1], piece[0]) < SAME or math.dist(loop[-1], piece[-1]) < SAME:
                    left.pop(i)
                    loop += piece[1:] if math.dist(loop[-1], piece[0]) < SAME else piece[-2::-1]
                    break
            else:
                raise SystemExit(f"open at {loop[-1]}")
        yield loop


def area(loop):
    return abs(sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(loop, loop[1:] + loop[:1]))) / 2.0


def holds(loop, point):
    """Is the point inside? Even and odd."""
    inside = False
    for p, q in zip(loop, loop[1:] + loop[:1]):
        if (p[1] > point[1]) != (q[1] > point[1]):
            if p[0] + (point[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]) > point[0]:
                inside = not inside
    return inside


drawing = ezdxf.readfile(sys.argv[1])
audit = drawing.audit()
if audit.errors or audit.fixes:
    raise SystemExit(f"{audit.errors} {audit.fixes}")
told = json.load(open(sys.argv[2]))["sections"]
loops = list(outlines(drawing))
if len(loops) != sum(section["outlines"] for section in told):
    raise SystemExit(f"{len(loops)} outlines")
# What is in an odd number of others is a hole.
total = sum(area(loop) * (-1) ** sum(holds(other, loop[0]) for other in loops if other is not loop)
            for loop in loops)
expected = sum(section["area_mm2"] for section in told)
length = sum(section["length_mm"] for section in told)
if abs(total - expected) > 2e-3 * length + 1e-9:
    raise SystemExit(f"{total} mm2, not {expected}")
names = {layer.dxf.name for layer in drawing.layers}
if any(entity.dxf.layer not in names for entity in drawing.modelspace()):
    raise SystemExit("a layer that is not told")
