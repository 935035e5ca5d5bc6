#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the scripts in examples/python.

Usage: PYTHONPATH=BUILD/python examples_test.py [TEST…]
"""
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "samples"


def run(script, *arguments):
    """Returns the exit code and the standard output of an example."""
    result = subprocess.run([sys.executable, ROOT / "examples" / "python" / script, *arguments],
                            stdout=subprocess.PIPE, text=True, timeout=120)
    return result.returncode, result.stdout


class Examples(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def copy(self, name, change=lambda text: text):
        path = pathlib.Path(self.folder.name, name)
        path.write_text(change((SAMPLES / name).read_text()))
        return path

    @unittest.skipIf(importlib.util.find_spec("matplotlib") is None, "matplotlib is missing")
    def test_engagement_plot_writes_a_picture(self):
        picture = pathlib.Path(self.folder.name, "plot.png")
        code, text = run("engagement_plot.py", SAMPLES / "complex.nc", picture)
        self.assertEqual(code, 0)
        self.assertEqual(text, "largest engagement: 48.33 mm3/mm, line 49, T1\n")
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertGreater(picture.stat().st_size, 10_000)

    def test_check_folder_has_a_line_for_each_program(self):
        self.copy("simple.nc")
        pathlib.Path(self.folder.name, "folder.nc").mkdir()
        code, text = run("check_folder.py", self.folder.name)
        self.assertEqual(code, 1)
        folder, simple = text.splitlines()
        self.assertIn("not verified: cannot read", folder)
        self.assertRegex(simple, r"simple.nc +not-proven +0 errors, 2 doubts, time 2.4 min")

    def test_own_rule_finds_low_rapid_moves(self):
        self.assertEqual(run("own_rule.py", SAMPLES / "complex.nc"), (0, ""))
        code, text = run("own_rule.py", SAMPLES / "complex.nc", "11")
        self.assertEqual(code, 1)
        self.assertIn("complex.nc:17:1: error: rapid move to X60 Y-14 at 10 mm", text)

    def test_compare_posts_marks_differences(self):
        same = self.copy("complex.nc", lambda text: text.replace("G0 ", "G00 "))
        code, text = run("compare_posts.py", SAMPLES / "complex.nc", same)
        self.assertEqual((code, text.count("!")), (0, 0))
        deeper = self.copy("complex.nc", lambda text: text.replace("Z-", "Z-0", 1))
        code, text = run("compare_posts.py", SAMPLES / "simple.nc", deeper)
        self.assertEqual(code, 1)
        self.assertIn("! volume, mm3  202661.202", text)


if __name__ == "__main__":
    unittest.main()
