#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each public type of the libraries has a comment: what doxygen reports as undocumented is a failure.

Usage: headers_test.py SOURCE WORK

Exits with 77 without doxygen.
"""
import os
import re
import shutil
import subprocess
import sys

UNDOCUMENTED = re.compile(r"^(.*): warning: Compound ncsim::(\S+) is not documented\.$", re.M)


def undocumented(source, headers, work):
    """Returns the place of each type below `headers` without a comment, by its name."""
    os.makedirs(work, exist_ok=True)
    doxyfile = os.path.join(work, "Doxyfile")
    with open(doxyfile, "w", encoding="utf-8") as file:
        file.write(f"@INCLUDE = {source}/docs/site/Doxyfile\nINPUT = {headers}\nOUTPUT_DIRECTORY = {work}\n"
                   "GENERATE_HTML = NO\nGENERATE_XML = YES\nWARN_IF_UNDOCUMENTED = YES\n")
    ran = subprocess.run(["doxygen", doxyfile], cwd=source, capture_output=True, text=True, check=True)
    return {name: place for place, name in UNDOCUMENTED.findall(ran.stderr)}


def main():
    source, folder = (os.path.abspath(path) for path in sys.argv[1:3])
    work = os.path.join(folder, "headers")  # removed first: never a folder that the caller has named
    if not shutil.which("doxygen"):
        print("skipped: no doxygen (packages.txt)")
        return 77
    shutil.rmtree(work, ignore_errors=True)
    # The check itself: a header with one type that has a comment, and one that has none.
    probe = os.path.join(work, "probe")
    os.makedirs(probe)
    with open(os.path.join(probe, "probe.h"), "w", encoding="utf-8") as file:
        file.write("namespace ncsim {\n/// A type.\nstruct A {\n    int a;\n};\nstruct B {\n    int b;  ///< B.\n};\n}\n")
    faults = [] if list(undocumented(source, probe, work)) == ["B"] else ["the check does not find a type without comment"]
    found = undocumented(source, "lib", work)
    faults += [f"{place}: ncsim::{name} has no comment" for name, place in found.items()]
    for fault in sorted(faults):
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
