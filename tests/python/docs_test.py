#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the Python blocks of docs/python.md, in order, and compares the options with the tables.

Usage: PYTHONPATH=BUILD/python docs_test.py
"""
import os
import pathlib
import re
import tempfile
import unittest

import ncsim

ROOT = pathlib.Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs" / "python.md").read_text()


class Page(unittest.TestCase):
    def test_blocks_run(self):
        blocks = re.findall(r"(?s)```python\n(.*?)```", TEXT)
        self.assertGreater(len(blocks), 3)
        names = {}
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(ROOT / "samples", os.path.join(folder, "samples"))
            before = os.getcwd()
            os.chdir(folder)
            try:
                for block in blocks:
                    exec(compile(block, "docs/python.md", "exec"), names)
                self.assertTrue(pathlib.Path("part.step").read_text().startswith("ISO-10303-21"))
            finally:
                os.chdir(before)
        self.assertGreater(names["slot"].removed, 0.0)

    def test_all_arguments_and_members_are_listed(self):
        running = re.sub(r"(?s)```.*?```", "", TEXT)
        words = set(re.findall(r"[a-z_]+", " ".join(re.findall(r"`([^`]+)`", running))))
        for options in (ncsim.SimulateOptions, ncsim.CheckOptions):
            self.assertEqual(set(options.__annotations__) - words, set(), options.__name__)
        for type_ in (ncsim.Simulation, ncsim.Mesh, ncsim.Solid):
            members = {name for name in vars(type_) if not name.startswith("_")}
            self.assertEqual(members - words, set(), type_.__name__)
        fields = ncsim.simulate(ROOT / "samples" / "simple.nc").motions.dtype.names
        self.assertEqual(set(fields) - words, set())


if __name__ == "__main__":
    unittest.main()
