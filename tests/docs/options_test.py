#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each command of ncsim in the pages, and each of its options, is in the help of the program.

Usage: options_test.py NCSIM SOURCE

Commands are code: `ncsim run part.nc --png part.png`, or lines of a code block that begin with ncsim, build/ncsim or
./dev run. A line that ends with a backslash continues.
"""
import os
import re
import subprocess
import sys

CODE = re.compile(r"^```[^\n]*\n(.*?)^```|^((?: {4}[^\n]*\n)+)|`([^`\n]+)`", re.M | re.S)
COMMAND = re.compile(r"(?:^|[\s|;&])(?:build/)?ncsim ([a-z]+)((?: [^\n|;&#]*)?)")
LEAST = 150  # commands in all pages


def pages(source):
    names = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"]
    for folder, _, files in os.walk(os.path.join(source, "docs")):
        if "reference" not in os.path.relpath(folder, source).split(os.sep):
            names += [os.path.relpath(os.path.join(folder, name), source) for name in files if name.endswith(".md")]
    return sorted(names)


def commands_of(text):
    """Yields the line, the command and its options of each command of ncsim in a page."""
    for span in CODE.finditer(text):
        start, code = span.start(), span[1] or span[2] or span[3]
        joined = code.replace("\\\n", "  ")
        for match in COMMAND.finditer(joined):
            line = text[:start].count("\n") + joined[:match.start() + 1].count("\n") + 1
            yield line, match[1], re.findall(r"(?<![\w-])(--?[A-Za-z][\w-]*)", match[2])


def options_of(program, command):
    ran = subprocess.run([program, command, "--help"], capture_output=True, text=True, check=False)
    return set(re.findall(r"(?<![\w-])--?[A-Za-z][\w-]*", ran.stdout)) if ran.returncode == 0 else None


def main():
    program, source = os.path.abspath(sys.argv[1]), sys.argv[2]
    probe = "a\n\n    build/ncsim run x.nc --pgn y\n\n`cd z; ncsim chekc -q`\n"
    assert list(commands_of(probe)) == [(3, "run", ["--pgn"]), (5, "chekc", ["-q"])]
    assert "--pgn" not in options_of(program, "run") and options_of(program, "chekc") is None
    known, faults, count = {}, [], 0
    for page in pages(source):
        with open(os.path.join(source, page), encoding="utf-8") as file:
            text = file.read()
        for line, command, options in commands_of(text):
            count += 1
            if command in ("help", "version"):
                continue
            if command not in known:
                known[command] = options_of(program, command)
            if known[command] is None:
                faults.append(f"{page}:{line}: there is no command {command}")
                continue
            # --color stands with each command.
            faults += [f"{page}:{line}: ncsim {command} has no option {option}" for option in options
                       if option not in known[command] | {"--color"}]
    if count < LEAST:
        faults.append(f"{count} commands, expected {LEAST}")
    for fault in faults:
        print(fault)
    print(f"{count} commands, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
