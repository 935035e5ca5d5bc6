#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Types of the Python package: mypy reads the examples and the package that they import, stubtest
compares the stub with the module.

Usage: types_test.py FOLDER_OF_PACKAGE EXAMPLES WORK
"""
import pathlib
import subprocess
import sys

try:
    import mypy  # noqa: F401
except ImportError:
    print("mypy is missing (Debian package mypy)")
    sys.exit(77)

package, examples, work = (pathlib.Path(argument) for argument in sys.argv[1:])
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
names = [str(path) for path in sorted(examples.glob("*.py"))]
for command in (["mypy", "--config-file", config, "--scripts-are-modules", *names],
                ["mypy.stubtest", "--mypy-config-file", config, "--allowlist", allowed,
                 "ncsim._ncsim"]):
    result = subprocess.run([sys.executable, "-m", *map(str, command)])
    if result.returncode != 0:
        sys.exit(1)
