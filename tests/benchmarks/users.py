#!/usr/bin/env python3
"""users.py BUILD [WORKLOAD...]: the workloads that people run, as one table.

Each row is a command of the program in BUILD: CPU seconds and peak memory, medians of RUNS (3) runs with one
thread, and the ratio to the row that the last column names. Programs are written into BUILD/users. WORKLOAD is
the beginning of the name of a program; without one, all are measured. MANIFOLD=off leaves out manifold-3d.

The last table subtracts the hulls of three programs with manifold-3d (npm), if npm can install the package.
"""
import json
import math
import os
import statistics
import subprocess
import sys
import time

BLOCK = ((0, 0, -40), (100, 100, 0))
MANIFOLD = "manifold-3d@3.5.4"


class Program:
    """NC text of one workload: header with tools and stock, then moves."""

    def __init__(self, kind, diameter, block=BLOCK, tools=1):
        low, high = block
        corner = diameter / 2 if kind == "ball" else 0
        name = "ball end mill" if kind == "ball" else "flat end mill"
        size = [high[i] - low[i] for i in range(3)]
        self.lines = [f"(T{t} D={diameter:g} CR={corner:g} - {name})" for t in range(1, tools + 1)]
        self.lines.append("(STOCK/BLOCK," + ",".join(f"{v:g}" for v in size + [-v for v in low]) + ")")
        self.lines += ["G21 G90 G17 G94", "T1 M6", "S12000 M3", "G0 Z5"]

    def add(self, code, **words):
        self.lines.append(" ".join([code] + [f"{k.upper()}{v:.4f}" for k, v in words.items()]).strip())

    def text(self):
        return "\n".join(self.lines + ["G0 Z5", "M5", "M30"]) + "\n"


def height(x, y):
    return -8 + 5 * math.sin(2 * math.pi * x / 50) * math.cos(2 * math.pi * y / 50)


def wave(rows, segments):
    """A raster of a ball over crossed sines."""
    program = Program("ball", 6)
    for j in range(rows):
        y = 100.0 * j / (rows - 1)
        xs = [100.0 * i / segments for i in range(segments + 1)]
        for x in reversed(xs) if j % 2 else xs:
            if len(program.lines) < 7:
                program.add("G0", x=x, y=y)
                program.add("G1 F1500", z=height(x, y))
            else:
                program.add("G1", x=x, y=y, z=height(x, y))
    return program.text()


def rounds(count, changes_tool):
    """The same raster in `count` depths, or in ten bands; with a tool change for each, or without."""
    program = Program("ball", 6, tools=10)
    rows, segments = (32, 31) if count > 1 else (55, 54)
    band = rows if count > 1 else rows // 10 + 1
    for k in range(count):
        for j in range(rows):
            y = 100.0 * j / (rows - 1)
            if j % band == 0:
                program.add("G0", z=20)
                number = (k if count > 1 else j // band) + 1
                if changes_tool and number > 1:
                    program.lines += [f"T{number} M6", "S12000 M3"]
                program.add("G0", x=0, y=y)
            xs = [100.0 * i / segments for i in range(segments + 1)]
            for x in reversed(xs) if j % 2 else xs:
                program.add("G1 F1500", x=x, y=y, z=height(x, y) - 0.1 * k)
    return program.text()


def drill(count, diameter):
    """count × count holes by G81."""
    program = Program("flat", diameter)
    pitch = 100.0 / count
    for i in range(count * count):
        place = {"x": pitch * (i % count + 0.5), "y": pitch * (i // count + 0.5)}
        program.add("G98 G81 Z-15 R1 F200" if i == 0 else "", **place)
    program.lines.append("G80")
    return program.text()


def contour(passes, teeth=24):
    """A wall with rounded teeth by arcs, in many depths."""
    program = Program("flat", 6)
    points = [(50 + r * math.cos(a), 50 + r * math.sin(a))
              for i in range(2 * teeth)
              for r, a in [((40, 34)[i % 2], math.pi * i / teeth)]]
    for k in range(passes):
        program.add("G0", x=points[0][0], y=points[0][1])
        program.add("G1 F600", z=-20.0 * (k + 1) / passes)
        for i in range(1, len(points) + 1):
            (x, y), before = points[i % len(points)], points[i - 1]
            program.add("G2" if i % 2 else "G3", x=x, y=y, r=0.6 * math.dist((x, y), before))
        program.add("G0", z=5)
    return program.text()


def pocket(turns, points):
    """One layer of a spiral pocket."""
    program = Program("flat", 6)
    program.add("G0", x=52, y=50)
    program.add("G1 F800", z=-3)
    for i in range(1, turns * points + 1):
        angle, radius = 2 * math.pi * i / points, 2 + 35 * i / (turns * points)
        program.add("G1", x=50 + radius * math.cos(angle), y=50 + radius * math.sin(angle))
    return program.text()


def rotary(moves, kind):
    """A raster around a bar: a pose every few degrees."""
    program = Program(kind, 6, ((0, -30, -30), (100, 30, 30)))
    program.add("G0", x=0, y=0, z=60, a=0)
    program.lines.append("G1 F1500")
    for i in range(moves):
        angle = 7.2 * i
        program.add("", x=100.0 * i / moves, a=angle, z=24 + 3 * math.sin(math.radians(0.37 * angle)))
    program.add("G0", z=60)
    return program.text()


def tiny():
    """A part of seven moves."""
    program = Program("flat", 6, ((0, 0, -10), (40, 30, 0)))
    program.add("G0", x=10, y=10)
    program.add("G1 F500", z=-3)
    for x, y in ((30, 10), (30, 20), (10, 20), (10, 10)):
        program.add("G1", x=x, y=y)
    return program.text()


PROGRAMS = {
    "tiny": tiny,
    "wave1k": lambda: wave(32, 31),
    "wave3k": lambda: wave(55, 54),
    "wave10k": lambda: wave(100, 99),
    "tools1": lambda: rounds(1, False),
    "tools10": lambda: rounds(1, True),
    "rounds_same": lambda: rounds(8, False),
    "rounds_tools": lambda: rounds(8, True),
    "pocket3k": lambda: pocket(40, 75),
    "contour10k": lambda: contour(200),
    "drill1k": lambda: drill(32, 2.0),
    "drill10k": lambda: drill(100, 0.7),
    "rotary1k_ball": lambda: rotary(1000, "ball"),
    "rotary1k_flat": lambda: rotary(1000, "flat"),
}

STL = ["-q", "--stl", "out.stl"]
# Program, arguments after `run`, and the row that it is compared with.
ROWS = [
    ("tiny", STL, None),
    ("tiny", ["-q", "--png", "out.png"], "tiny --stl"),
    ("wave1k", STL, None),
    ("wave3k", STL, None),
    ("wave3k", STL + ["--report", "out.json"], "wave3k --stl"),
    ("wave3k", STL + ["--report", "out.json", "--block-volumes"], "wave3k --stl"),
    ("wave10k", STL, None),
    ("tools1", STL, None),
    ("tools10", STL, "tools1 --stl"),
    ("rounds_same", STL, None),
    ("rounds_tools", STL, "rounds_same --stl"),
    ("pocket3k", STL, None),
    ("contour10k", STL, None),
    ("drill1k", STL, None),
    ("drill1k", ["-q", "--3mf", "out.3mf"], "drill1k --stl"),
    ("drill1k", ["-q", "--step", "out.step"], "drill1k --stl"),
    ("drill1k", STL + ["--model", "dexel"], "drill1k --stl"),
    ("drill10k", STL, None),
    ("drill10k", ["-q", "--3mf", "out.3mf"], "drill10k --stl"),
    ("drill10k", ["-q", "--step", "out.step"], "drill10k --stl"),
    ("drill10k", ["-q", "--step", "out.step"], "drill1k --step"),
    ("drill10k", STL + ["--model", "dexel"], "drill10k --stl"),
    ("rotary1k_ball", STL, None),
    ("rotary1k_flat", STL, None),
]


def label(program, arguments):
    """"wave3k --stl --report": the name without -q and files."""
    words = [a for a in arguments if a != "-q" and not a.startswith("out.")]
    if len(words) > 1 and words[0] == "--stl":
        words.pop(0)
    return " ".join([program] + words)


def usage_of(command, folder):
    """CPU seconds and peak memory (MB) of one command. Exits if the command fails."""
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"users.py: {' '.join(command)}: exit code {process.returncode}\n{errors.decode()[-500:]}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def medians(command, folder, runs):
    costs = [usage_of(command, folder) for _ in range(runs)]
    return tuple(statistics.median(column) for column in zip(*costs))


def install_manifold(folder):
    """True if manifold-3d is in `folder`, which has no other packages."""
    if os.path.isdir(os.path.join(folder, "node_modules", "manifold-3d")):
        return True
    command = ["npm", "install", "--no-audit", "--no-fund", "--prefix", folder, MANIFOLD]
    try:
        return subprocess.run(command, capture_output=True, timeout=180).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False


def compare_with_manifold(build, folder, costs):
    writer = os.path.join(build, "tests", "benchmarks", "write_hulls")
    if not os.path.exists(writer):
        print("\nmanifold-3d: not measured, because write_hulls is not built (./dev bench users builds it)")
        return
    if not install_manifold(folder):
        print(f"\nmanifold-3d: not measured, because npm cannot install {MANIFOLD}")
        return
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "manifold_hulls.mjs")
    print(f"\n| hulls of | {MANIFOLD}, CPU s | ncsim, text to STL, CPU s | ratio | volumes differ by |")
    print("|---|---|---|---|---|")
    for name in ("wave1k", "drill1k", "pocket3k"):
        if f"{name} --stl" not in costs:
            continue
        with open(os.path.join(folder, name + ".hulls"), "w") as out:
            subprocess.run([writer, os.path.join(folder, name + ".nc")], stdout=out, check=True)
        ran = subprocess.run(["node", script, folder, name + ".hulls"], cwd=folder, capture_output=True)
        if ran.returncode != 0:
            print(f"| {name} | failed: {ran.stderr.decode()[-80:].strip()} | | | |")
            continue
        found = json.loads(ran.stdout)
        own = costs[f"{name} --stl"][0]
        print(f"| {name} | {found['seconds']:.2f} | {own:.2f} | {found['seconds'] / own:.1f} "
              f"| {abs(found['volume'] / found['expected'] - 1):.1e} |", flush=True)


def main():
    build, wanted = os.path.abspath(sys.argv[1]), sys.argv[2:]
    runs = int(os.environ.get("RUNS", "3"))
    folder = os.path.join(build, "users")
    os.makedirs(folder, exist_ok=True)
    is_wanted = lambda name: not wanted or any(name.startswith(w) for w in wanted)
    for name, make in PROGRAMS.items():
        if is_wanted(name):
            with open(os.path.join(folder, name + ".nc"), "w") as out:
                out.write(make())
    print(f"medians of {runs}, one thread, {time.strftime('%Y-%m-%d')}\n")
    print("| run | CPU s | MB | ratio | to |\n|---|---|---|---|---|")
    costs = {}
    for name, arguments, base in ROWS:
        if not is_wanted(name):
            continue
        key = label(name, arguments)
        if key not in costs:
            command = [os.path.join(build, "ncsim"), "run", name + ".nc", "--threads", "1", *arguments]
            costs[key] = medians(command, folder, runs)
        seconds, memory = costs[key]
        ratio = f"{seconds / costs[base][0]:.2f} | {base}" if base in costs else "|"
        print(f"| {key} | {seconds:.3f} | {memory:.0f} | {ratio} |", flush=True)
    if os.environ.get("MANIFOLD") != "off":
        compare_with_manifold(build, folder, costs)


if __name__ == "__main__":
    main()
