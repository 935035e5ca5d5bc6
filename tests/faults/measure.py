#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts faults into clean programs and counts what `ncsim check` says of them.

    tests/faults/measure.py NCSIM [--corpus FOLDER] [--programs N] [--only NAME,…] [--share I/N]
                            [--jobs N] [--text docs/faults.md] [--save FILE] [--list]

Base programs are those of samples/ and tests/faults/programs and, with --corpus, programs of a folder with
INDEX.tsv and programs/, as tests/corpus/run_corpus reads them. The set-up of a program of the corpus is what
`ncsim run --draft --save-job` writes, without its marks of guesses: whoever runs this specifies the guesses.
Programs that are not clean are no base. At most N base programs are used (60), the shortest first.

    --only   base programs whose names hold one of these words
    --share  part I of N of the pairs of a program and a fault, from 0 on
    --text   writes the table between the lines <!-- faults --> and <!-- /faults --> of a document
    --save   writes one line for each pair: program, fault, outcome
    --list   prints the pairs that are clean although part or process differs

Columns: found: errors; not proven: exit code 4; harmless: `ncsim diff --process` finds no difference, or of a
set-up, nothing is touched. Where the program is clean and differs: found with the design: `check --design` with
the part of the program without the fault; within 0.1 mm: that is clean, too; process alone: feeds, speeds,
coolant, tools or dwells differ and the part does not.

Exit code 1 if a fault is only found with a design, or not at all, that needs none by FAULTS. The choice of place depends on the names of program and fault alone, so runs agree.
"""
import argparse
import csv
import hashlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter, namedtuple
from concurrent.futures import ThreadPoolExecutor

from inject import CLAMP, FAULTS, PROGRAM, SETUP, code_of, moves, word

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SECONDS = 30

Base = namedtuple("Base", "name program options job machine")

FOUND, NOT_PROVEN, HARMLESS = "found", "not proven", "harmless"
BY_DESIGN, WITHIN, PROCESS = "found with the design", "within 0.1 mm", "process alone"
OUTCOMES = (FOUND, NOT_PROVEN, HARMLESS, BY_DESIGN, WITHIN, PROCESS)
TOO_LONG = "too long"


class Runner:
    def __init__(self, ncsim, folder):
        self.ncsim, self.folder = ncsim, folder

    def __call__(self, *words):
        """Exit code and standard output of ncsim; None after too long."""
        try:
            ran = subprocess.run([self.ncsim, *words], capture_output=True, timeout=SECONDS, check=False)
            return ran.returncode, ran.stdout
        except subprocess.TimeoutExpired:
            return None, b""

    def check(self, base, program, *more):
        return self("check", program, "--no-project", "--quiet", "--threads", "1", *options_of(base), *more)[0]


def options_of(base):
    words = list(base.options)
    if base.job:
        words += ["--job", base.job]
    if base.machine:
        words += ["--machine", base.machine]
    return words


def toml_value(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return "[" + ", ".join(toml_value(v) for v in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(k)} = {toml_value(v)}" for k, v in value.items()) + " }"
    return json.dumps(value) if isinstance(value, str) else repr(value)


def toml_text(data):
    """TOML of a table: plain keys, tables, and arrays of tables."""
    text, tables = "", ""
    for key, value in data.items():
        if isinstance(value, dict):
            tables += f"[{key}]\n" + toml_text(value)
        elif isinstance(value, list) and value and all(isinstance(v, dict) for v in value):
            tables += "".join(f"[[{key}]]\n" + toml_text(v) for v in value)
        else:
            text += f"{key} = {toml_value(value)}\n"
    return text + tables


def own_bases():
    samples = os.path.join(ROOT, "samples")
    machines = os.path.join(samples, "machines")
    start = ("--start", "0,0,100")
    yield Base("simple.nc", os.path.join(samples, "simple.nc"), start, None, os.path.join(machines, "rotary.toml"))
    yield Base("complex.nc", os.path.join(samples, "complex.nc"),
               (*start, "--tool", "T1=flat:D8:L20", "--tool", "T2=flat:D5:L20"), None, None)
    yield Base("wave.nc", os.path.join(samples, "wave.nc"), (*start, "--tool", "T2=ball:D6:L20"), None, None)
    yield Base("five-axis.nc", os.path.join(samples, "five-axis.nc"), (), os.path.join(samples, "five-axis.toml"),
               os.path.join(machines, "trunnion.toml"))
    programs = os.path.join(HERE, "programs")
    for name in sorted(os.listdir(programs)):
        if name.endswith(".nc"):
            path = os.path.join(programs, name)
            yield Base(name, path, (), path[:-3] + ".toml", os.path.join(programs, "mill.toml"))


def corpus_bases(run, corpus, folder):
    """Programs with the set-up that a draft guesses, specified; the shortest first."""
    with open(os.path.join(corpus, "INDEX.tsv"), encoding="utf-8") as index:
        rows = sorted(csv.DictReader(index, delimiter="\t"), key=lambda r: (int(r["lines"]), r["program"]))
    for i, row in enumerate(rows):
        program = os.path.join(corpus, "programs", row["program"])
        job = os.path.join(folder, f"{i}.toml")
        run("run", program, "--draft", "--quiet", "--threads", "1", "--save-job", job)
        if not os.path.exists(job):
            continue
        with open(job, encoding="utf-8") as file:
            lines = [line for line in file if not line.startswith("assumed")]
        with open(job, "w", encoding="utf-8") as file:
            file.writelines(lines)
        yield Base(row["program"], program, ("--start", "0,0,100"), job, None)


def clean_bases(run, bases, folder, most):
    """Those that are clean, also against their own parts, each with its part as a design."""
    for base in bases:
        if most == 0:
            return
        if run.check(base, base.program) != 0:
            print(f"{base.name}: not clean; no base", file=sys.stderr)
            continue
        design = os.path.join(folder, hashlib.sha256(base.name.encode()).hexdigest()[:16] + ".stl")
        run("run", base.program, "--quiet", "--threads", "1", "--stl", design, *options_of(base))
        if not os.path.exists(design) or run.check(base, base.program, "--design", design) != 0:
            print(f"{base.name}: not clean against its own part; no base", file=sys.stderr)
            continue
        most -= 1
        yield base, design


def clamp(base, lines, rng):
    """The text of a machine file with a clamp on the stock, at the end of a cut; None: no place."""
    there = [(float(x[1]), float(y[1])) for i in sorted(moves(lines, {1, 2, 3}))
             if (x := re.search(word("X"), code_of(lines[i]))) and (y := re.search(word("Y"), code_of(lines[i])))]
    text = ""
    if base.machine:
        with open(base.machine, encoding="utf-8") as file:
            text = file.read()
    if not there or "mesh" in text or "preset" in text:
        return None
    x, y = rng.choice(there)
    unit = 25.4 if any(re.search(r"(?<![A-Z])G20\b", code_of(line)) for line in lines) else 1.0
    box = [[x * unit - 6, y * unit - 6, 0.01], [x * unit + 6, y * unit + 6, 15.0]]
    return text + f'\n[[fixture]]\nname = "clamp"\nbox = {box}\n'


def changed(base, fault, folder):
    """The base with the fault in it; None where there is no place for it."""
    rng = random.Random(f"{base.name} {fault.name}")
    with open(base.program, "rb") as file:
        lines = file.read().decode("latin-1").split("\n")
    program, job, machine = base.program, base.job, base.machine
    if fault.of == PROGRAM:
        faulty = fault.inject(lines, rng)
        if faulty is None or faulty == lines:
            return None
        # Of the same name in a folder with the files it may call.
        program = os.path.join(folder, os.path.basename(base.program))
        with open(program, "wb") as file:
            file.write("\n".join(faulty).encode("latin-1"))
    elif fault.of == SETUP:
        if not job:
            return None
        with open(job, "rb") as file:
            setup = fault.inject(tomllib.load(file), rng)
        if setup is None:
            return None
        job = os.path.join(folder, "job.toml")
        with open(job, "w", encoding="utf-8") as file:
            file.write(toml_text(setup))
    elif fault.of == CLAMP:
        text = clamp(base, lines, rng)
        if text is None:
            return None
        machine = os.path.join(folder, "machine.toml")
        with open(machine, "w", encoding="utf-8") as file:
            file.write(text)
    return base._replace(program=program, job=job, machine=machine)


def outcome(run, base, design, fault):
    """What comes of the fault in this program; None where there is no place for it."""
    folder = tempfile.mkdtemp(dir=run.folder)
    try:
        faulty = changed(base, fault, folder)
        if faulty is None:
            return None
        code = run.check(faulty, faulty.program)
        if code is None:
            return TOO_LONG
        if code != 0:
            return NOT_PROVEN if code == 4 else FOUND
        if fault.of == PROGRAM:
            code, text = run("diff", base.program, faulty.program, "--process", "--quiet", "--json", "-",
                             "--threads", "1", *options_of(base))
            if code is None:
                return TOO_LONG
            if code == 0:
                return HARMLESS
            if not json.loads(text)["differs"]:
                return PROCESS
        elif not fault.needs:
            return HARMLESS  # the same program, and no contact
        code = run.check(faulty, faulty.program, "--design", design)
        return TOO_LONG if code is None else BY_DESIGN if code != 0 else WITHIN
    finally:
        shutil.rmtree(folder)


def table(counts):
    lines = ["| fault | description | injected | " + " | ".join(OUTCOMES) + " |",
             "|" + " --- |" * (len(OUTCOMES) + 3)]
    total = Counter()
    for fault in FAULTS:
        of = counts[fault.name]
        total.update(of)
        lines.append(f"| `{fault.name}` | {fault.description} | {sum(of.values())} | " +
                     " | ".join(str(of[o]) for o in OUTCOMES) + " |")
    lines.append(f"| all | | {sum(total.values())} | " + " | ".join(str(total[o]) for o in OUTCOMES) + " |")
    return "\n".join(lines), total


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("ncsim")
    parser.add_argument("--corpus")
    parser.add_argument("--programs", type=int, default=60)
    parser.add_argument("--only", default="")
    parser.add_argument("--share", default="0/1")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--text")
    parser.add_argument("--save")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    share, shares = map(int, options.share.split("/"))
    with tempfile.TemporaryDirectory() as folder:
        run = Runner(os.path.abspath(options.ncsim), folder)
        bases = list(own_bases())
        if options.only:
            bases = [b for b in bases if any(word in b.name for word in options.only.split(","))]
        clean = list(clean_bases(run, bases, folder, options.programs))
        if options.corpus:
            clean += clean_bases(run, corpus_bases(run, os.path.abspath(options.corpus), folder), folder,
                                 options.programs - len(clean))
        pairs = [(base, design, fault) for base, design in clean for fault in FAULTS][share::shares]
        with ThreadPoolExecutor(options.jobs) as pool:
            outcomes = list(pool.map(lambda pair: outcome(run, *pair), pairs))
    counts = {fault.name: Counter() for fault in FAULTS}
    rows, bad = [], 0
    for (base, _, fault), what in zip(pairs, outcomes):
        if what is None:
            continue
        rows.append(f"{base.name}\t{fault.name}\t{what}\n")
        if what == TOO_LONG:
            continue
        counts[fault.name][what] += 1
        is_bad = (what == BY_DESIGN and "design" not in fault.needs or
                  what == PROCESS and not {"limits", "design"} & set(fault.needs.split()))
        bad += is_bad
        if is_bad or options.list and what in (BY_DESIGN, WITHIN, PROCESS):
            print(f"{base.name}: {fault.name}: {what}", file=sys.stderr)
    text, total = table(counts)
    text = f"{len(clean)} programs, {sum(total.values())} faults.\n\n{text}"
    print(text)
    if options.save:
        with open(options.save, "w", encoding="utf-8") as file:
            file.writelines(rows)
    if options.text:
        with open(options.text, encoding="utf-8") as file:
            old = file.read()
        with open(options.text, "w", encoding="utf-8") as file:
            file.write(re.sub(r"(<!-- faults -->\n)[\s\S]*(<!-- /faults -->)",
                              lambda m: m[1] + text + "\n" + m[2], old))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
