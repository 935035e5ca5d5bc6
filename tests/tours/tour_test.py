#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the steps of a tutorial in an empty folder, as a user would, and compares what it shows.

Usage: tour_test.py NCSIM PAGE [--update]

A block "```nc FILE" (or toml, python, yaml …) is a file, "```toml FILE +" is appended to a file. "```sh" has
commands; "# exit code 4" at the end of a line is the code, otherwise 0. Each line of "```text" is part of the
output of the commands above, in this order. A picture of the page is a file that a command writes, byte by byte; --update copies it
to the page. Exits with 77 if the page needs the Python package and there is none.
"""
import filecmp
import os
import re
import shutil
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```(\w+) *(\S*) *(\+?)\n(.*?)^```$", re.M | re.S)
PICTURE = re.compile(r"!\[[^\]]*\]\(([\w-]+\.png)\)")
LEAST = 4  # commands and shown lines of a tutorial


def fail(message):
    sys.exit("FAILED: " + message)


def run_line(line, folder, environment):
    command, _, comment = line.partition("  # exit code ")
    done = subprocess.run(["sh", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", timeout=120, check=False)
    if done.returncode != int(comment or 0):
        fail(f"{line}: exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def compare(shown, output):
    """Fails unless the lines of `shown` are parts of lines of `output`, in this order."""
    rest = iter(output.split("\n"))
    for line in shown.rstrip("\n").split("\n"):
        if line.strip() not in ("…", "") and not any(line in other for other in rest):
            fail(f"the page shows '{line}', the output is\n{output}")


def run_page(text, folder, environment, pictures):
    output, commands, shown = "", 0, 0
    for language, name, mode, content in BLOCK.findall(text):
        if name:
            path = os.path.join(folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "a" if mode else "w", encoding="utf-8") as file:
                file.write(content)
        elif language == "sh":
            lines = content.rstrip("\n").split("\n")
            output = "".join(run_line(line, folder, environment) for line in lines)
            commands += len(lines)
        elif language == "text":
            compare(content, output)
            shown += content.count("\n")
        else:
            fail(f"a block of {language} without a name")
    for picture in PICTURE.findall(text):
        made = os.path.join(folder, picture)
        if not os.path.exists(made):
            fail(f"no command of the page writes {picture}")
        if "--update" in sys.argv[3:]:
            shutil.copy(made, os.path.join(pictures, picture))
        elif not filecmp.cmp(made, os.path.join(pictures, picture), shallow=False):
            fail(f"a command of the page writes another {picture} than the page shows")
    if commands < LEAST or shown < LEAST:
        fail(f"{commands} commands, {shown} lines of output")
    print(f"{commands} commands, {shown} lines of output")


def main():
    program, page = os.path.abspath(sys.argv[1]), sys.argv[2]
    with open(page, encoding="utf-8") as file:
        text = file.read()
    with tempfile.TemporaryDirectory() as home:
        bin_folder, folder = os.path.join(home, "bin"), os.path.join(home, "work")
        os.mkdir(bin_folder)
        os.mkdir(folder)
        os.symlink(program, os.path.join(bin_folder, "ncsim"))
        os.symlink(sys.executable, os.path.join(bin_folder, "python3"))
        environment = dict(os.environ, PATH=bin_folder + ":" + os.environ["PATH"], HOME=home)
        if "import ncsim" in text and subprocess.run([sys.executable, "-c", "import ncsim"], check=False).returncode:
            print("skipped: there is no Python package")
            sys.exit(77)
        run_page(text, folder, environment, os.path.dirname(page))


if __name__ == "__main__":
    main()
