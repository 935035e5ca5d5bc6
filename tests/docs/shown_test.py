#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands that README and the pages show, in a folder with the files that these commands name.

Usage: shown_test.py NCSIM SOURCE

A command is a line of a code block that begins with ncsim or build/ncsim, or code in a sentence with a file or an
option. It may end with 0, 1 or 4, not with 2 (wrong usage, a file is missing) or 3. A block that follows a command
and begins with one of OUTPUTS is its output: each line is part of a line of the output, in this order; an ellipsis
stands for any lines. Tutorials, pictures and tables of claims have tests of their own.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

CODE = re.compile(r"^```[^\n]*\n(.*?)^```|^((?: {4}[^\n]*\n)+)|`([^`]+)`", re.M | re.S)
COMMAND = re.compile(r"(?:zcat [\w.]+ \| )?(?:build/)?ncsim [a-z-].*")
OUTPUTS = ("ncsim ", "part  ", "section ", "part.nc:", "tool T1")
# Placeholders, long runs, commands of other machines, and words that are no command.
NOT_RUN = re.compile(r"…|FILE|FOLDER|NAME|TOPIC|I/N|\{|viewer|1000000|shard (?:auto|3)|\$old|wave.nc --model|^ncsim [a-z-]+$"
                     r"|^ncsim [a-z]+ --(?:html|stl|process)$|shard|merge|mpi")
OTHER_TESTS = re.compile(r"first-.*|end-not-proven|pictures|quality|comparison|cluster|faults|files")
LEAST = {"commands": 60, "outputs": 5}
HOLES = "G21 G90 G17 G94\nT1 M6 S5000 M3\nG0 X{} Y10. Z5.\nG1 Z-3. F200.\nG0 Z5.\n" + "(-)\n" * 40 + "M30\n"


def prepare(folder, source, ncsim):
    """Writes the files that the pages name."""
    for name in ("samples", "examples"):
        os.symlink(os.path.join(source, name), os.path.join(folder, name))
    os.makedirs(os.path.join(folder, "build"))
    os.makedirs(os.path.join(folder, "bin"))
    for place in ("build", "bin"):
        os.symlink(ncsim, os.path.join(folder, place, "ncsim"))
    shown = os.path.join(source, "tests/docs/shown")
    os.mkdir(os.path.join(folder, "programs"))
    for name in os.listdir(shown):
        for place in ("", "programs"):
            # The pages name lines up to 120.
            with open(os.path.join(shown, name), encoding="utf-8") as file:
                text = file.read().replace("M30\n", "(-)\n" * 110 + "M30\n")
            with open(os.path.join(folder, place, name), "w", encoding="utf-8") as file:
                file.write(text)

    def write(name, text):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    comments = "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,50.,30.,10.,0.,0.,10.)\n"
    for name, place in (("old.nc", 10), ("new.nc", 11), ("other.nc", 12), ("top.nc", 13), ("back.nc", 14)):
        write(name, comments + HOLES.format(f"{place}."))
    write("main.nc", "G21 G90\nM98 P0022\nM98 P0022\nM30\n")
    write("O0022.nc", "O0022\nG0 X1.\nG0 Z5.\nM99\n")
    write("mill.toml", "[travel]\nx = [-500, 500]\n")
    shutil.copy(os.path.join(folder, "mill.toml"), os.path.join(folder, "machine.toml"))
    job = 'version = 2\nmachine = "mill.toml"\n' + comments_as_job() + "".join(
        f'[[setup]]\nname = "{name}"\nprogram = "{name}.nc"\n' for name in ("top", "back"))
    for name in ("job.toml", "old.toml", "new.toml"):
        write(name, job)
    write("library.fctl", '{"version": 1, "tools": []}\n')
    subprocess.run(["gzip", "-k", "part.nc"], cwd=folder, check=True)
    subprocess.run([ncsim, "run", "part.nc", "-q", "--stl", "part.stl"], cwd=folder, check=True)


def comments_as_job():
    return '[stock]\nmin = [0, 0, -10]\nmax = [50, 30, 0]\n[[tool]]\nnumber = 1\nkind = "flat"\ndiameter = 6\nlength = 20\n'


def spans(text):
    """Yields the line of each piece of code, its text, and whether it is a block."""
    for match in CODE.finditer(text):
        code = match[1] or match[2] or match[3]
        yield text[:match.start()].count("\n") + 1, code.replace("\\\n", " "), match[3] is None


def commands_of(code, is_block):
    for line in code.split("\n"):
        line = re.sub(r"\s+# .*", "", " ".join(line.split()) if not is_block else line.strip())
        if COMMAND.fullmatch(line) and not NOT_RUN.search(line):
            yield line


def missing_line(shown, output):
    """Returns the first line of `shown` that is not in `output`, in this order; None if all are."""
    rest = iter(output.split("\n"))
    for line in shown.rstrip("\n").split("\n"):
        if line.strip() not in ("…", "") and not any(line[4:] in other for other in rest):
            return line
    return None


def check_page(name, text, folder, environment, count):
    faults, output = [], ""
    for line, code, is_block in spans(text):
        first = code.strip().split("\n")[0]
        commands = list(commands_of(code, is_block))
        if is_block and not commands and output and first.startswith(OUTPUTS) and "ncsim check" not in first:
            count["outputs"] += 1
            lost = missing_line(code, output)
            if lost:
                faults.append(f"{name}:{line}: the output does not have '{lost}':\n{output[:3000]}")
            continue
        for command in commands:
            count["commands"] += 1
            if " init " in command:  # replaces no job file
                os.rename(os.path.join(folder, "job.toml"), os.path.join(folder, "kept.toml"))
            done = subprocess.run(["sh", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False)
            output = done.stdout
            if " init " in command:
                os.rename(os.path.join(folder, "kept.toml"), os.path.join(folder, "job.toml"))
            if done.returncode not in (0, 1, 4):
                faults.append(f"{name}:{line}: {command}: exit code {done.returncode}\n{output[:500]}")
    return faults


def main():
    ncsim, source = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    pages = ["README.md"] + sorted(f"docs/{name}" for name in os.listdir(os.path.join(source, "docs"))
                                   if name.endswith(".md") and not OTHER_TESTS.fullmatch(name[:-3]))
    faults, count = [], {"commands": 0, "outputs": 0}
    for page in pages:
        with open(os.path.join(source, page), encoding="utf-8") as file:
            text = file.read()
        if "ncsim " not in text:
            continue
        with tempfile.TemporaryDirectory() as folder:
            prepare(folder, source, ncsim)
            if page == "README.md":
                shutil.copy(os.path.join(folder, "rapid.nc"), os.path.join(folder, "part.nc"))
            environment = dict(os.environ, PATH=os.path.join(folder, "bin") + ":" + os.environ["PATH"])
            faults += check_page(page, text, folder, environment, count)
    faults += [f"{count[what]} {what}, expected {least}" for what, least in LEAST.items() if count[what] < least]
    for fault in faults:
        print(fault)
    print(f"{count['commands']} commands, {count['outputs']} outputs, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
