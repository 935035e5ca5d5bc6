#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the packages in a clean Debian 12, and uses them as documented.

Usage: clean_debian.py PACKAGES SOURCE [FOLDER]

PACKAGES is the folder with the packages of `./dev package`. FOLDER keeps the clean Debian for the next run; without,
it is temporary. Needs root, debootstrap and the Debian registry, so that it is run by hand and nightly. Exits with 77 if
debootstrap is missing.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

PROGRAM = """(T1 D=10. CR=0. - flat end mill)
(STOCK/BLOCK,80.,40.,20.,40.,20.,20.)
G21 G90 G17 (FROM/0.,0.,100.)
T1 M6 S8000 M3
G0 X-50. Y0. Z5.
G1 Z-2. F300.
X50.
G0 Z5.
M30
"""


def fail(message):
    sys.exit("FAILED: " + message)


def run(words, cwd=None):
    ran = subprocess.run(words, cwd=cwd, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         encoding="utf-8", errors="replace", check=False)
    if ran.returncode != 0:
        fail(f"{' '.join(words)}: {ran.returncode}\n{ran.stdout[-3000:]}")
    return ran.stdout


class Debian:
    """A clean Debian, copied from a base that is kept."""

    def __init__(self, base, folder):
        run(["cp", "-a", base, folder])
        self.folder = folder

    def sh(self, command):
        # The mount of /proc ends with the command.
        return run(["unshare", "--mount", "sh", "-c", 'mount -t proc proc "$0/proc" && exec chroot "$0" sh -c "$1"', self.folder,
                    "export DEBIAN_FRONTEND=noninteractive; cd /root && " + command])

    def write(self, name, text):
        with open(os.path.join(self.folder, "root", name), "w", encoding="utf-8") as file:
            file.write(text)


def three_commands(debian, packages):
    """From a clean Debian to picture and verdict of a program in three commands."""
    for package in packages:
        shutil.copy(package, os.path.join(debian.folder, "root"))
    debian.write("part.nc", PROGRAM)
    start = time.monotonic()
    debian.sh("apt-get update -q")
    debian.sh("apt-get install -y -q --no-install-recommends ./ncsim_*.deb")
    said = debian.sh("ncsim check part.nc --html part.html && ncsim run part.nc -q --png part.png && ls part.html part.png")
    seconds = time.monotonic() - start
    if "part.nc: clean" not in said:
        fail(said)
    print(f"three commands: {seconds:.0f} s")
    for command in ("man -w ncsim-check || test -e /usr/share/man/man1/ncsim-check.1.gz", "ncsim check /usr/share/doc/ncsim/samples/two-sides/job.toml",
                    "ncsim rules plunge"):
        debian.sh(command)


def other_packages(debian, source):
    debian.sh("apt-get install -y -q --no-install-recommends ./ncsim-step_*.deb ./python3-ncsim_*.deb")
    debian.sh("ncsim run part.nc -q --step part.step && ncsim check part.nc --design part.step")
    said = debian.sh("python3 -c 'import ncsim; print(ncsim.check(\"part.nc\").verdict)'")
    if "clean" not in said:
        fail(said)
    print("STEP and Python: clean")
    debian.sh("apt-get install -y -q --no-install-recommends ./libncsim-dev_*.deb g++ cmake make pkg-config")
    shutil.copytree(os.path.join(source, "examples/cpp"), os.path.join(debian.folder, "root/cpp"))
    debian.sh("cmake -S cpp -B build && cmake --build build --target hulls read_program && build/hulls")
    print("libncsim-dev: an example builds and runs")


def recipe(debian, packages, source):
    """Runs the RUN lines of the container recipe."""
    with open(os.path.join(source, "templates/Containerfile"), encoding="utf-8") as file:
        lines = re.findall(r"^RUN (.*)$", file.read(), re.M)
    os.makedirs(os.path.join(debian.folder, "tmp/packages"))
    for package in packages:
        shutil.copy(package, os.path.join(debian.folder, "tmp/packages"))
    for line in lines:
        debian.sh(line)
    if not debian.sh("ncsim --version").startswith("ncsim "):
        fail("no ncsim in the container")
    print(f"container recipe: {len(lines)} RUN lines")


def main():
    if not shutil.which("debootstrap"):
        print("skipped: there is no debootstrap")
        sys.exit(77)
    packages, source = glob.glob(os.path.join(os.path.abspath(sys.argv[1]), "*ncsim*.deb")), os.path.abspath(sys.argv[2])
    if len(packages) < 4:
        fail(f"packages: {packages}")
    with tempfile.TemporaryDirectory() as folder:
        base = os.path.join(os.path.abspath(sys.argv[3]) if len(sys.argv) > 3 else folder, "clean")
        if not os.path.exists(os.path.join(base, "etc/debian_version")):
            run(["debootstrap", "--variant=minbase", "bookworm", base])
        debian = Debian(base, os.path.join(folder, "debian"))
        three_commands(debian, packages)
        other_packages(debian, source)
        recipe(Debian(base, os.path.join(folder, "container")), packages, source)


if __name__ == "__main__":
    main()
