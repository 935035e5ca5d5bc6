#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of docs/reference are those that docs/site/reference.py makes from the program.

Usage: reference_test.py NCSIM SOURCE WORK
"""
import json
import os
import shutil
import subprocess
import sys
import unittest

NCSIM, SOURCE, WORK = (os.path.abspath(path) for path in sys.argv[1:4])
WORK = os.path.join(WORK, "reference")  # removed first: never a folder that the caller has named
UPDATE = "python3 docs/site/reference.py build/ncsim . docs/reference"


def pages(folder):
    """Returns the text of each page by its path below the folder."""
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            with open(path, encoding="utf-8") as file:
                found[os.path.relpath(path, folder)] = file.read()
    return found


class Reference(unittest.TestCase):
    def test_is_current(self):
        shutil.rmtree(WORK, ignore_errors=True)
        subprocess.run([sys.executable, os.path.join(SOURCE, "docs/site/reference.py"), NCSIM, SOURCE, WORK], check=True)
        made, kept = pages(WORK), pages(os.path.join(SOURCE, "docs/reference"))
        self.assertEqual(sorted(made), sorted(kept), f"write them: {UPDATE}")
        for name, text in made.items():
            self.assertEqual(kept[name], text, f"docs/reference/{name} is out of date; write it: {UPDATE}")

    def test_has_each_key_of_a_schema(self):
        with open(os.path.join(SOURCE, "docs/schemas/job.schema.json"), encoding="utf-8") as file:
            schema = json.load(file)
        with open(os.path.join(SOURCE, "docs/reference/files/job.md"), encoding="utf-8") as file:
            page = file.read()
        for key in schema["properties"]:
            self.assertIn(f"| `{key}` |", page)
        self.assertIn("| `stock.min` | array of 3 × number -1e+06 to 1e+06, required | lower corner", page)
        for key in schema["definitions"]["tool"]["properties"]:
            self.assertIn(f"| `{key}` |", page[page.index("## tool\n"):])

    def test_has_each_option_and_each_rule(self):
        text = pages(os.path.join(SOURCE, "docs/reference"))
        for option in ("--watch", "--step-strict", "--write-baseline", "--tool-table", "--convert"):
            self.assertIn(f"`{option}`", text["cli.md"])
        self.assertEqual(len(os.listdir(os.path.join(SOURCE, "examples/rules"))),
                         sum(name.startswith("rules/") for name in text))
        self.assertIn("| CGAL | GPL-3.0-or-later, LGPL-3.0-or-later |", text["licences.md"])
        for name in text:
            if name.startswith("rules/"):
                self.assertIn("## A program that fails\n", text[name])
                self.assertIn("## A program that passes\n", text[name])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
