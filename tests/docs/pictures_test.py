#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of docs/pictures.md and README.md, and compares the pictures with those of the pages.

usage: pictures_test.py NCSIM SOURCE FOLDER [--update]

FOLDER receives the pictures. --update replaces those of the pages; look at them before a commit.
"""
import filecmp
import os
import re
import shlex
import shutil
import subprocess
import sys

FEWEST = {"docs/pictures.md": 16, "README.md": 2}


def pictures_of(page):
    """Yields the file of each picture and the command below it."""
    for match in re.finditer(r"(?m)^!\[[^\]]+\]\((\S+\.png)\)\n\n {4}(?:build/)?ncsim ((?:run|check) .*)$", page):
        yield match.group(1), shlex.split(match.group(2), comments=True)


def read_pages(source, faults):
    """Returns the pictures of all pages, by their file in the source, with their commands."""
    shown = []
    for name, fewest in FEWEST.items():
        with open(os.path.join(source, name), encoding="utf-8") as file:
            page = file.read()
        found = list(pictures_of(page))
        count = len(re.findall(r"(?m)^!\[[^\]]+\]\(\S+\.png\)", page))
        if len(found) < fewest or len(found) != count:
            faults.append(f"{name}: {len(found)} pictures have a command, of {count}")
        shown += [(os.path.join(os.path.dirname(name), picture), words) for picture, words in found]
    return shown


def main(ncsim, source, folder, update):
    os.makedirs(folder, exist_ok=True)
    faults = []
    shown = read_pages(source, faults)
    for picture, words in shown:
        name = os.path.basename(picture)
        made, wanted = os.path.join(folder, name), os.path.join(source, picture)
        if words.count(name) != 1:
            faults.append(f"{picture}: the command writes another file")
            continue
        words[words.index(name)] = made
        ran = subprocess.run([ncsim, *words, "-q"], cwd=source, capture_output=True, text=True, check=False)
        # `check` shows findings: exit code 1.
        if ran.returncode not in ((0, 1) if words[0] == "check" else (0,)):
            faults.append(f"{picture}: exit code {ran.returncode}: {ran.stderr}")
        elif update:
            shutil.copyfile(made, wanted)
        elif not os.path.exists(wanted) or not filecmp.cmp(made, wanted, shallow=False):
            faults.append(f"{picture}: the command makes another picture: {made}")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3], "--update" in sys.argv[4:]))
