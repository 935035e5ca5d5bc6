#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of docs/pictures.md and compares the pictures with those of the page.

usage: pictures_test.py NCSIM SOURCE FOLDER [--update]

FOLDER receives the pictures. --update replaces those of the page; look at them before a commit.
"""
import filecmp
import os
import re
import shlex
import shutil
import subprocess
import sys

FEWEST = 12


def pictures_of(page):
    """Yields the file of each picture and the command below it."""
    for match in re.finditer(r"(?m)^!\[[^\]]+\]\((pictures/\S+\.png)\)\n\n {4}ncsim (run .*)$", page):
        yield match.group(1), shlex.split(match.group(2))


def main(ncsim, source, folder, update):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(source, "docs", "pictures.md"), encoding="utf-8") as file:
        page = file.read()
    shown = list(pictures_of(page))
    faults = []
    if len(shown) < FEWEST or len(shown) != page.count("!["):
        faults.append(f"docs/pictures.md: {len(shown)} pictures have a command, of {page.count('![')}")
    for picture, words in shown:
        name = os.path.basename(picture)
        made, wanted = os.path.join(folder, name), os.path.join(source, "docs", picture)
        if words.count(name) != 1:
            faults.append(f"{picture}: the command writes another file")
            continue
        words[words.index(name)] = made
        ran = subprocess.run([ncsim, *words, "-q"], cwd=source, capture_output=True, text=True, check=False)
        if ran.returncode != 0:
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
