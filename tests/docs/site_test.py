#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The site of the documentation: each page is in its menu, no link is broken, broken links are noticed.

Usage: site_test.py SOURCE WORK
"""
import os
import shutil
import subprocess
import sys
import unittest

import yaml

SOURCE, WORK = (os.path.abspath(path) for path in sys.argv[1:3])


def build(source, output):
    return subprocess.run([sys.executable, os.path.join(SOURCE, "docs/site/build.py"), source, output, "--no-headers"],
                          capture_output=True, text=True, check=False)


def names_in(menu):
    for entry in menu:
        for value in entry.values():
            yield from names_in(value) if isinstance(value, list) else [value]


class Site(unittest.TestCase):
    def test_each_page_is_in_the_menu_and_no_link_is_broken(self):
        ran = build(SOURCE, os.path.join(WORK, "site"))
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        with open(os.path.join(WORK, "site/mkdocs.yml"), encoding="utf-8") as file:
            menu = set(names_in(yaml.safe_load(file)["nav"]))
        docs = {os.path.relpath(os.path.join(folder, name), SOURCE)
                for folder, _, names in os.walk(os.path.join(SOURCE, "docs")) for name in names
                if name.endswith(".md")}
        self.assertEqual(menu, docs | {"index.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"})
        for name in menu:
            self.assertTrue(os.path.exists(os.path.join(WORK, "site/site", name[:-2] + "html")), name)
        self.assertTrue(os.path.exists(os.path.join(WORK, "site/site/search/search_index.json")))
        with open(os.path.join(WORK, "site/site/index.html"), encoding="utf-8") as file:
            self.assertIn('href="docs/jobs.html"', file.read())

    def test_broken_links_have_a_place(self):
        source = os.path.join(WORK, "broken")
        shutil.rmtree(source, ignore_errors=True)
        os.makedirs(os.path.join(source, "docs/site"))
        for name, text in {
                "README.md": "# A\n\n[good](docs/b.md#part-two) [none](docs/c.md)\n\n    [code](none.md)\n\n`[code](no.md)`\n",
                "docs/b.md": "# B\n\n## Part two\n\n[no heading](#part-three) [up](../README.md#a) [site](https://x.org)\n"}.items():
            with open(os.path.join(source, name), "w", encoding="utf-8") as file:
                file.write(text)
        ran = build(source, os.path.join(WORK, "broken-site"))
        self.assertEqual(ran.returncode, 1)
        self.assertEqual(ran.stderr, "README.md:3: there is no file docs/c.md\n"
                                     "docs/b.md:5: docs/b.md has no heading #part-three\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
