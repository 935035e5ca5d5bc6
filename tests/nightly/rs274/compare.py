#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares ncsim with LinuxCNC's stand-alone interpreter on random programs.

compare.py NCSIM [--count N] [--first SEED] [--jobs J] [--kind NAME] [--cache FILE] [--table FILE]
           [--record FILE] [--show SEED] [--no-shrink]

Runs `rs274 -g` and `ncsim parse --canonical --dialect rs274`, with and without --strict, on the
programs of seeds FIRST … FIRST+COUNT-1 (random_programs.py). Motions have to agree within 1e-4 of
the unit of the program, feeds within 1e-3; strict has to refuse what rs274 refuses, and nothing
else. Of each class of differences the smallest program is printed. --table rewrites the table
between the marks of a Markdown file; --record writes programs that agree, with the motions of
rs274, for the tests of gcode. Exit code 1 if a difference has no entry in explained.py.

The machine of rs274 counts inches, which nothing changes without a configuration: its tool table is
in inches. All nine coordinate systems begin at the zero of the machine. ncsim prints motions in the frame of the workpiece, which is that
of the first cut; the frame of rs274's motions is moved there."""
import argparse
import concurrent.futures
import math
import os
import pickle
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import explained  # noqa: E402
import random_programs  # noqa: E402

TOOLS = "T1 P1 D0.2362204724 Z1.5 ;6 mm\nT2 P2 D0.1968503937 Z2 ;5 mm\nT3 P3 D0.3937007874 Z0.5 ;10 mm\n"
# No tool has an offset in X, which G20 and G21 of rs274 do not convert. The same table for ncsim:
# 6 mm would be larger than the 0.2362204724 inches of rs274.
TOOLS_MM = re.sub(r"([DZX])(\d[\d.]*)", lambda m: f"{m[1]}{float(m[2]) * 25.4:.12g}", TOOLS)
JOB = "version = 2\nstart = [0, 0, 0]\n[offsets]\n" + "".join(
    f"{name} = [0, 0, 0]\n" for name in
    ["G54", "G55", "G56", "G57", "G58", "G59", '"G59.1"', '"G59.2"', '"G59.3"'])


class Folder:
    """Files that both programs read."""

    def __init__(self):
        self.path = tempfile.mkdtemp(prefix="ncsim-rs274-")
        self.write("tool.tbl", TOOLS)
        self.write("tool-mm.tbl", TOOLS_MM)
        self.write("job.toml", JOB)

    def write(self, name, text):
        with open(os.path.join(self.path, name), "w", encoding="ascii") as out:
            out.write(text)


BEYOND = 1e9  # mm; longer ways are those of no machine, and ncsim refuses their values

FOLDER = None


def folder():
    global FOLDER
    if FOLDER is None:
        FOLDER = Folder()
    return FOLDER


def run_rs274(text):
    """Output and error of rs274, or None if it crashed or did not end."""
    f = folder()
    f.write("program.ngc", text)
    for name in ("rs274.var", "rs274.var.bak"):
        if os.path.exists(os.path.join(f.path, name)):
            os.remove(os.path.join(f.path, name))
    f.write("rs274.var", "")
    try:
        done = subprocess.run(["rs274", "-g", "-v", "rs274.var", "-t", "tool.tbl", "program.ngc"], cwd=f.path,
                              capture_output=True, timeout=20, check=False,
                              # rs274 keeps its tool table in $HOME: two at a time would share one.
                              env={**os.environ, "HOME": f.path})
    except subprocess.TimeoutExpired:
        return None
    if done.returncode < 0:
        return None
    return done.stdout.decode("latin-1"), done.stderr.decode("latin-1")


def run_ncsim(program, text, strict):
    f = folder()
    f.write("program.ngc", text)
    command = [program, "parse", "program.ngc", "--canonical", "--dialect", "rs274", "--tool-table", "tool-mm.tbl",
               "--job", "job.toml"] + (["--strict"] if strict else [])
    try:
        done = subprocess.run(command, cwd=f.path, capture_output=True, timeout=60, check=False)
    except subprocess.TimeoutExpired:
        return "", "time out"
    return done.stdout.decode(), done.stderr.decode()


def rotated(x, y, degrees):
    t = math.radians(degrees)
    return x * math.cos(t) - y * math.sin(t), x * math.sin(t) + y * math.cos(t)


PLANES = {"CANON_PLANE_XY": (0, 1), "CANON_PLANE_XZ": (2, 0), "CANON_PLANE_YZ": (1, 2)}


def read_rs274(output):
    """Motions in machine coordinates, mm, and the rotation at the first cut."""
    events, unit, g5x, g92, theta, feed, plane, per_minute = [], 25.4, [0.0] * 6, [0.0] * 6, 0.0, 0.0, "CANON_PLANE_XY", True
    at = [0.0] * 6
    length = [0.0] * 3
    first_theta = None
    threads = False
    head = [0.0] * 6  # where the machine is, without the length of the tool; mm
    length_changed = False

    def machine(p):
        q = [a + b for a, b in zip(p, g92)]
        q[0], q[1] = rotated(q[0], q[1], theta)
        return [(a + b) * (unit if i < 3 else 1.0) for i, (a, b) in enumerate(zip(q, g5x))]

    for line in output.splitlines():
        found = re.match(r"\s*\d+\s+N\S+\s+(\w+)\((.*)\)", line)
        if not found:
            continue
        name, rest = found.groups()
        if name == "USE_LENGTH_UNITS":
            now = 1.0 if "MM" in rest else 25.4
            for values in (g5x, g92, at, length):
                for i in range(3):
                    values[i] *= unit / now
            unit = now
        elif name == "SET_G5X_OFFSET":
            g5x = [float(v) for v in rest.split(",")[1:7]]
        elif name == "SET_G92_OFFSET":
            g92 = [float(v) for v in rest.split(",")[:6]]
        elif name == "SET_XY_ROTATION":
            theta = float(rest)
        elif name == "USE_TOOL_LENGTH_OFFSET":
            now = [float(v) for v in rest.split(",")[0].split()]
            at = [a + before - after for a, before, after in zip(at, length, now)] + at[3:]
            length = now
            length_changed = True
        elif name == "SET_FEED_RATE":
            feed = float(rest) * unit
        elif name == "COMMENT" and "feed mode set to" in rest:
            per_minute = "units per minute" in rest
        elif name == "SELECT_PLANE":
            plane = rest
        elif name.endswith("SPEED_FEED_SYNCH"):
            threads = name.startswith("START")
        elif name == "DWELL":
            events.append(("dwell", float(rest), None, None, None, unit))
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE", "RIGID_TAP"):
            before = list(at)
            at = [float(v) for v in rest.split(",")]
            at += before[len(at):]
            was, head = head, [a + b * unit for a, b in zip(machine(at), length + [0.0] * 3)]
            if name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED") and all(abs(a - b) < 1e-4 * unit for a, b in zip(head, was)):
                if length_changed:  # The tip has another place now: ncsim may print it.
                    events.append(("rest", machine(at), None, None, None, unit))
                continue
            length_changed = False
            kind = {"STRAIGHT_TRAVERSE": "rapid", "STRAIGHT_PROBE": "probe"}.get(name, "feed")
            if kind != "rapid" and first_theta is None:
                first_theta = theta
            events.append((kind, machine(at), None, None, feed if per_minute and kind == "feed" and not threads else None, unit))
            if name == "RIGID_TAP":
                at, head = before, was
                events.append(("feed", machine(at), None, None, None, unit))
        elif name == "ARC_FEED":
            if first_theta is None:
                first_theta = theta
            v = [float(x) for x in rest.split(",")]
            first, second = PLANES[plane]
            third = 3 - first - second
            at = list(at)
            at[first], at[second], at[third] = v[0], v[1], v[5]
            at[3:6] = v[6:9]
            centre = [0.0] * 6
            centre[first], centre[second] = v[2], v[3]
            centre = machine(centre)
            head = [a + b * unit for a, b in zip(machine(at), length + [0.0] * 3)]
            length_changed = False
            events.append(("arc", machine(at), (plane, centre[first], centre[second]), int(v[4]), feed if per_minute else None, unit))
        elif name == "NURBS_FEED":
            head = [math.nan] * 6  # not printed
            events.append(("spline", None, None, None, None, unit))
    return events, first_theta or 0.0


NAMES = {"XY": "CANON_PLANE_XY", "ZX": "CANON_PLANE_XZ", "YZ": "CANON_PLANE_YZ"}


def read_ncsim(output):
    events = []
    for line in output.splitlines():
        words = line.split()
        if len(words) < 2 or not words[0].startswith("L"):
            continue
        kind = words[1]
        if kind == "dwell":
            events.append(("dwell", float(words[2]), None, None, None, 1.0))
            continue
        if kind not in ("rapid", "feed", "arc", "probe", "spline"):
            continue
        at = [0.0] * 6
        for word in words:
            if re.fullmatch(r"[XYZABC]-?[\d.e-]+", word):
                at["XYZABC".index(word[0])] = float(word[1:])
        feed = next((float(w[1:]) for w in words if re.fullmatch(r"F[\d.e-]+", w)), None)
        if kind == "arc":
            i = words.index("centre")
            events.append((kind, at, (NAMES[words[2]], float(words[i + 1]), float(words[i + 2])),
                           int(words[words.index("turns") + 1]), feed, 1.0))
        else:
            events.append((kind, at, None, None, feed, 1.0))
    return events


def without_rests(events):
    """Events without straight moves of no length."""
    out, at, unit = [], [0.0] * 6, 1.0
    for e in events:
        # rs274 prints four decimals of inches, and of millimetres.
        rounding = 1.5e-4 * max(e[5], unit)
        if e[0] in ("rapid", "feed") and at is not None and \
                max(abs(round(a, 4) - round(b, 4)) for a, b in zip(e[1], at)) < rounding:
            continue
        out.append(e)
        unit = e[5]
        if e[0] != "dwell":
            at = e[1] if e[0] != "spline" else None  # rs274 does not print where a spline ends
    return out


def turned(p, theta):
    p = list(p)
    p[0], p[1] = rotated(p[0], p[1], -theta)
    return p


def shifts(events, theta, ours):
    """Where the workpiece may lie: as the first cuts have it, else the first or the last motions."""
    def places(all_events, kinds):
        return [e[1] for e in all_events if e[0] in kinds and e[1]]

    cuts, our_cuts = (places(all_events, ("feed", "arc")) for all_events in (events, ours))
    moves, our_moves = (places(all_events, ("rapid", "feed", "arc")) for all_events in (events, ours))
    pairs = []
    if cuts and our_cuts:
        pairs.append((cuts[0], our_cuts[0]))
        pairs += [(e[1], our_cuts[0]) for e in events if e[0] == "rest"][:1]
    elif moves and our_moves:
        pairs += [(moves[-1], our_moves[-1]), (moves[0], our_moves[0])]
    return [[round(b - a, 3) for a, b in zip(turned(p, theta), q)] for p, q in pairs] or [[0.0] * 6]


def aligned(events, theta, shift):
    """Motions of rs274 in the frame of the workpiece of ncsim."""
    out = []
    for kind, at, centre, turns, feed, unit in events:
        if kind == "dwell":
            out.append((kind, at, centre, turns, feed, unit))
            continue
        if at is not None:
            at = [a + s for a, s in zip(turned(at, theta), shift)]
        if centre is not None:
            first, second = PLANES[centre[0]]
            p = [0.0] * 6
            p[first], p[second] = centre[1], centre[2]
            if centre[0] == "CANON_PLANE_XY":
                p = turned(p, theta)
            centre = (centre[0], p[first] + shift[first], p[second] + shift[second])
        out.append((kind, at, centre, turns, feed, unit))
    return out


def same(a, b, theta):
    if a[0] != b[0]:
        return f"{a[0]} and not {b[0]}"
    if a[0] == "dwell":
        return None if abs(a[1] - b[1]) < 1e-3 else "dwell"
    if a[0] == "spline":
        return None
    near = 2.1e-4 * a[5] + 1.1e-3
    if max(abs(p - q) for p, q in zip(a[1], b[1])) > near:
        return "end"
    if a[2] is not None:
        if a[2][0] != b[2][0] or a[3] != b[3]:
            return "plane or turns"
        if (theta == 0.0 or a[2][0] == "CANON_PLANE_XY") and \
                max(abs(a[2][1] - b[2][1]), abs(a[2][2] - b[2][2])) > near:
            return "centre"
    if a[4] is not None and (b[4] is None or abs(a[4] - b[4]) > 1e-3 + 1e-4 * a[4] * 25.4) and a[0] != "rapid":
        return "feed"
    return None


def refusal(error):
    """The message of rs274, without numbers; None if it read the whole program."""
    lines = [line for line in error.splitlines() if line and line != "executing"]
    lines = [line for line in lines if not line.startswith("is_callable")]
    if not lines:
        return None
    return re.sub(r"-?\d+(\.\d+)?", "#", lines[0])[:90]


def codes_of(text):
    errors = re.findall(r": error: .*\[([a-z0-9-]+)\]", text)
    return errors


def difference(ncsim, lines, strict, reference=None):
    """A short description of how the two differ, or None; and the reference."""
    text = "\n".join(lines) + "\n"
    reference = reference or run_rs274(text)
    if reference is None:
        return None, None
    output, error = reference
    theirs, theta = read_rs274(output)
    if any(abs(v) > BEYOND for e in theirs for v in (e[1] if isinstance(e[1], list) else [])):
        return None, reference
    if any("G33" in line for line in lines):  # rs274 prints no pitch
        theirs = [e[:4] + (None,) + e[5:] for e in theirs]
    refused = refusal(error)
    canonical, messages = run_ncsim(ncsim, text, strict)
    if "time out" in messages or "internal" in messages:
        return "ncsim: " + messages[:60], reference
    ours = read_ncsim(canonical)
    our_errors = codes_of(messages)
    if refused and strict and not our_errors:
        return f"strict accepts: {refused}", reference
    if not refused and our_errors:
        return f"{'strict ' if strict else ''}refuses: {our_errors[0]}", reference
    if our_errors and not strict:
        return None, reference
    if refused and "arc-centre-mode" in messages:
        return None, reference  # rs274 refuses the arcs; ncsim says that it assumes absolute centres.
    if refused and not any(e[0] in ("feed", "arc") for e in theirs):
        return None, reference  # The first cut of ncsim decides the frame.
    if refused and "cycle-spindle" in our_errors:
        theirs = theirs[:-4]  # rs274 refuses the cycle after it went to the hole
    if "compensation-gouge" in our_errors:
        theirs = theirs[:-2]  # ncsim finds such a corner a block earlier
    theirs, ours = without_rests(theirs), without_rests(ours)
    found = [first_difference(aligned(theirs, theta, shift), ours, theta, refused)
             for shift in shifts(theirs, theta, ours)]
    return (None if None in found else found[0]), reference


def first_difference(theirs, ours, theta, refused):
    # rs274 keeps moves under compensation back, and ncsim goes on behind what it refuses.
    i = j = 0
    while i < len(theirs) or j < len(ours):
        if i < len(theirs) and theirs[i][0] == "rest":
            j += j < len(ours) and ours[j][0] in ("rapid", "feed") and not same(("rapid",) + theirs[i][1:], ("rapid",) + ours[j][1:], theta)
            i += 1
            continue
        if (i == len(theirs) or j == len(ours)) and refused:
            return None
        if j == len(ours):
            return f"motion missing: {theirs[i][0]}"
        if i == len(theirs):
            return f"motion added: {ours[j][0]}"
        what = same(theirs[i], ours[j], theta)
        if what and refused and i == len(theirs) - 1:
            return None  # the first move of the block that rs274 refuses
        if what:
            return f"motion: {what}"
        i, j = i + 1, j + 1
    return None


def shrink(ncsim, lines, strict, wanted):
    """The program without the lines that the difference does not need."""
    changed = True
    while changed:
        changed = False
        size = max(len(lines) // 2, 1)
        while size >= 1:
            i = 0
            while i < len(lines) - 1:
                fewer = lines[:i] + lines[min(i + size, len(lines) - 1):]
                found, _ = difference(ncsim, fewer, strict)
                if found == wanted:
                    lines, changed = fewer, True
                else:
                    i += size
            size //= 2
    # Words, too.
    for i, line in enumerate(lines[:-1]):
        words = line.split()
        j = 0
        while len(words) > 1 and j < len(words):
            fewer = lines[:i] + [" ".join(words[:j] + words[j + 1:])] + lines[i + 1:]
            found, _ = difference(ncsim, fewer, strict)
            if found == wanted:
                words = words[:j] + words[j + 1:]
                lines = fewer
            else:
                j += 1
    return lines


def examine(task):
    ncsim, seed, reference = task
    kind, lines = random_programs.program(seed)
    found = []
    for strict in (False, True):
        what, reference = difference(ncsim, lines, strict, reference)
        if what:
            found.append((seed, kind, strict, what))
    return seed, found, reference


def number(value):
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def is_recorded(seed, cache):
    """False for programs whose refusal ncsim finds at another block."""
    return not re.search("corner|pindle", refusal(cache[seed][1]) or "")


def record(path, seeds, cache):
    """Writes programs, and the motions of rs274 in machine coordinates, mm."""
    with open(path, "w", encoding="ascii") as out:
        out.write("# Random programs that ncsim reads as LinuxCNC does, and the motions of rs274 (Debian's\n"
                  "# linuxcnc-uspace 2.9.0~pre1): machine coordinates, mm. \"refused\": rs274 reads no further.\n"
                  "# Written by tests/nightly/rs274/compare.py --record.\n")
        for seed in seeds:
            kind, lines = random_programs.program(seed)
            output, error = cache[seed]
            out.write(f"== {seed} {kind}\n" + "\n".join(lines) + "\n--\n")
            for e in without_rests(read_rs274(output)[0]):
                if e[0] == "dwell":
                    out.write(f"dwell {number(e[1])}\n")
                elif e[0] == "spline":
                    out.write("spline\n")
                else:
                    text = " ".join([e[0]] + [number(v) for v in e[1][:4]])
                    if e[2]:
                        text += f" {number(e[2][1])} {number(e[2][2])} {e[3]}"
                    out.write(text + "\n")
            if refusal(error):
                out.write("refused\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("ncsim")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--kind")
    parser.add_argument("--cache")
    parser.add_argument("--table")
    parser.add_argument("--record")
    parser.add_argument("--record-count", type=int, default=300)
    parser.add_argument("--show", type=int)
    parser.add_argument("--no-shrink", action="store_true")
    arguments = parser.parse_args()
    arguments.ncsim = os.path.abspath(arguments.ncsim)
    if arguments.show is not None:
        kind, lines = random_programs.program(arguments.show)
        print(f"({kind})", *lines, sep="\n")
        print(*(run_rs274("\n".join(lines) + "\n") or ("crash", "")))
        for strict in (False, True):
            print(*run_ncsim(arguments.ncsim, "\n".join(lines) + "\n", strict))
            print("strict:" if strict else "default:", difference(arguments.ncsim, lines, strict)[0])
        return 0
    cache = {}
    if arguments.cache and os.path.exists(arguments.cache):
        with open(arguments.cache, "rb") as stored:
            cache = pickle.load(stored)
    seeds = range(arguments.first, arguments.first + arguments.count)
    if arguments.kind:
        seeds = [s for s in seeds if random_programs.KINDS[s % len(random_programs.KINDS)].__name__ == arguments.kind]
    found, unread = [], 0
    agreeing = set()
    with concurrent.futures.ProcessPoolExecutor(arguments.jobs) as pool:
        for seed, differences, reference in pool.map(examine, [(arguments.ncsim, s, cache.get(s)) for s in seeds], chunksize=8):
            found += differences
            unread += reference is None
            if reference is not None:
                cache[seed] = reference
                if not differences:
                    agreeing.add(seed)
    if arguments.cache:
        with open(arguments.cache, "wb") as stored:
            pickle.dump(cache, stored)
    classes = {}
    for seed, kind, strict, what in found:
        classes.setdefault((strict, kind if "motion" in what else "", what), []).append(seed)
    unexplained = 0
    counts = {}
    for (strict, kind, what), members in sorted(classes.items(), key=lambda c: -len(c[1])):
        for name, entry in explained.CLASSES.items():
            explained_seeds = [s for s in members if entry.covers(strict, what, random_programs.program(s)[1])]
            if explained_seeds:
                counts[name] = counts.get(name, 0) + len(explained_seeds)
                members = [s for s in members if s not in explained_seeds]
        if not members:
            continue
        unexplained += len(members)
        shortest = min(members, key=lambda s: len(random_programs.program(s)[1]))
        print(f"{len(members):5d} {'strict ' if strict else 'default'} {kind:12s} {what}   seeds {members[:12]}")
        if not arguments.no_shrink:
            small = shrink(arguments.ncsim, random_programs.program(shortest)[1], strict, what)
            print("        " + " | ".join(small))
    total = len(list(seeds))
    print(f"{total} programs, {unread} not read by rs274, {len({f[0] for f in found})} differ, {unexplained} differences unexplained")
    for name, count in sorted(counts.items()):
        print(f"{count:5d} explained: {name}")
    if arguments.table:
        explained.write_table(arguments.table, total, counts)
    if arguments.record:
        record(arguments.record, [s for s in sorted(agreeing) if is_recorded(s, cache)][:arguments.record_count], cache)
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main())
