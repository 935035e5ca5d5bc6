#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""SECURITY.md lists all programs that ncsim runs, libraries that it loads, and no network connection.

Usage: security_test.py SOURCE

Searches the sources for calls that run programs, load libraries or open connections, and compares the files with
those that SECURITY.md describes.
"""
import os
import re
import sys

CALLS = re.compile(r"(?<![\w.>:])(?:::)?(execv|execve|execvp|execl|execlp|posix_spawnp?|popen|dlopen|getaddrinfo|fork|vfork)"
                   r"\s*\(|(?<![\w>])(?:::|std::)(system|socket|connect)\s*\(")
DESCRIBED = {
    "lib/setup/src/meshes/step_file.cpp": {"fork", "execv"},          # ncsim-step
    "apps/ncsim/system/large_pages.cpp": {"execv"},                   # ncsim itself
    "apps/ncsim/system/child_processes.cpp": {"fork"},                # --isolate
    "apps/ncsim/system/watch.cpp": {"fork"},                          # --watch
    "lib/export/src/render/shared_library.cpp": {"dlopen"},           # OSMesa
}
WORDS = ("ncsim-step", "--isolate", "--watch", "OSMesa", "600 s", "8 GB", "1 GB", "64 MB", "no network connection")


def calls_of(text):
    text = re.sub(r"//.*|\"(?:[^\"\\\n]|\\.)*\"", "", text)
    return {name for names in CALLS.findall(text) for name in names if name}


def main():
    source = sys.argv[1]
    faults = [] if calls_of('::execv(a); connect(b); ::socket(c); "popen(" // fork()\n') == {"execv", "socket"} else ["the search is broken"]
    found = {}
    for place in ("lib", "apps", "python"):
        for folder, _, names in os.walk(os.path.join(source, place)):
            for name in names:
                if name.endswith((".cpp", ".h")):
                    path = os.path.join(folder, name)
                    with open(path, encoding="utf-8") as file:
                        calls = calls_of(file.read())
                    if calls:
                        found[os.path.relpath(path, source)] = calls
    for name in sorted(set(found) | set(DESCRIBED)):
        if found.get(name) != DESCRIBED.get(name):
            faults.append(f"{name}: {found.get(name)}, described {DESCRIBED.get(name)}")
    with open(os.path.join(source, "SECURITY.md"), encoding="utf-8") as file:
        text = file.read()
    faults += [f"SECURITY.md does not mention {word}" for word in WORDS if word not in text]
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
