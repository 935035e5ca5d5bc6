# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the Python package with CMake; pyproject.toml has its description."""
import pathlib
import re
import sys

from skbuild import setup

TREE = pathlib.Path(__file__).parent
VERSION = re.search(r"VERSION (\d+\.\d+\.\d+)\n", (TREE / "CMakeLists.txt").read_text())[1]

setup(
    version=VERSION,
    packages=["ncsim"],
    package_dir={"": "python"},
    cmake_args=[
        "-DCMAKE_BUILD_TYPE=Release", "-DNCSIM_BUILD_PYTHON=ON", "-DNCSIM_BUILD_APP=OFF",
        "-DNCSIM_BUILD_TESTS=OFF", "-DNCSIM_UNITY=ON", "-DNCSIM_PYTHON_DIR=python",
        f"-DPython_EXECUTABLE={sys.executable}",
    ],
    # The libraries and their headers are no part of the wheel.
    cmake_install_target="ncsim_python_install",
)
