#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Types of the Python package: stubtest reads the package and compares the stub with the module;
mypy reads the examples.

Usage: types_test.py FOLDER_OF_PACKAGE WORK [EXAMPLES]
"""
import pathlib
import subprocess
import sys

try:
    import mypy  # noqa: F401
except ImportError:
    print("mypy is missing (Debian package mypy)")
    sys.exit(77)

package, work, *examples = (pathlib.Path(argument) for argument in sys.argv[1:])
work.mkdir(parents=True, exist_ok=True)
config = work / "mypy.ini"
config.write_text(f"""[mypy]
mypy_path = {package}
cache_dir = {work / "cache"}
strict = True
enable_incomplete_feature = Unpack
[mypy-matplotlib.*]
ignore_missing_imports = True
# Reading the types of NumPy takes most of the time.
[mypy-numpy.*]
follow_imports = skip
""")
# Classes of pybind11 have another metaclass, and no constructor of their own.
allowed = work / "allowed.txt"
allowed.write_text("".join(f"ncsim._ncsim.{name}\nncsim._ncsim.{name}.__init__\n"
                           for name in ("Mesh", "Simulation", "Solid")))
commands = [["mypy.stubtest", "--mypy-config-file", config, "--allowlist", allowed,
             "ncsim._ncsim"]]
for folder in examples:
    commands.append(["mypy", "--config-file", config, "--scripts-are-modules",
                     *sorted(folder.glob("*.py"))])
for command in commands:
    result = subprocess.run([sys.executable, "-m", *map(str, command)])
    if result.returncode != 0:
        sys.exit(1)
