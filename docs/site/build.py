#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the documentation as HTML: docs, README, changelog by mkdocs; public headers by doxygen.

Usage: build.py SOURCE OUTPUT [--no-headers]

SOURCE is the repository, OUTPUT/site the result. A link to a file or heading that does not exist is an error
with file and line. Links to files outside docs lead to copies; links to folders become text.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys

LINK = re.compile(r"(?<!\\)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")
HEADING = re.compile(r"^#{1,6} +(.*?) *$", re.M)
CODE = re.compile(r"^```[\s\S]*?^```|^(?: {4}.*\n)+|`[^`\n]*`", re.M)
PAGES = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md")


def anchors_of(text):
    """Returns the anchors of the headings, as GitHub and mkdocs make them."""
    anchors = set()
    for heading in HEADING.findall(CODE.sub(lambda m: m[0] if m[0].startswith("`") and "\n" not in m[0] else "", text)):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        anchors.add(re.sub(r"[^\w\- ]", "", plain.lower()).strip().replace(" ", "-"))
    return anchors


def pages_of(source):
    """Returns the Markdown files of the site by their path in the repository."""
    names = [name for name in PAGES if os.path.exists(os.path.join(source, name))]
    for folder, _, files in sorted(os.walk(os.path.join(source, "docs"))):
        place = os.path.relpath(folder, source)
        names += sorted(f"{place}/{name}" for name in files if name.endswith(".md"))
    pages = {}
    for name in names:
        with open(os.path.join(source, name), encoding="utf-8") as file:
            pages[name] = file.read()
    return pages


def site_name(name):
    return "index.md" if name == "README.md" else name


class Linker:
    """Rewrites the links of pages; collects files to copy, and broken links."""

    def __init__(self, source, pages):
        self.source, self.pages = source, pages
        self.files, self.broken = set(), []

    def rewritten(self, name, text):
        code = [match.span() for match in CODE.finditer(text)]

        def link(match):
            if any(begin <= match.start() < end for begin, end in code):
                return match[0]
            return self.link(name, text[:match.start()].count("\n") + 1, match)

        return LINK.sub(link, text)

    def link(self, name, line, match):
        label, address = match[1], match[2]
        if re.match(r"[a-z]+:", address):
            return match[0]
        path, _, anchor = address.partition("#")
        target = os.path.normpath(os.path.join(os.path.dirname(name), path)) if path else name
        full = os.path.join(self.source, target)
        if target.startswith("..") or not os.path.exists(full):
            self.broken.append(f"{name}:{line}: there is no file {path}")
            return match[0]
        if os.path.isdir(full):
            return label
        if target in self.pages:
            if anchor and anchor not in anchors_of(self.pages[target]):
                self.broken.append(f"{name}:{line}: {target} has no heading #{anchor}")
        else:
            self.files.add(target)
        address = os.path.relpath(site_name(target), os.path.dirname(site_name(name)) or ".")
        return f"[{label}]({address if path else ''}{'#' + anchor if anchor else ''})"


def make_source(source, folder):
    """Writes the Markdown files and the files that they link to. Returns broken links."""
    shutil.rmtree(folder, ignore_errors=True)
    pages = pages_of(source)
    linker = Linker(source, pages)
    for name, text in pages.items():
        path = os.path.join(folder, site_name(name))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(linker.rewritten(name, text))
    for name in sorted(linker.files):
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        shutil.copyfile(os.path.join(source, name), path)
    return linker.broken


def with_rules(settings, source):
    """Replaces an entry of the menu that ends in /* by an entry for each page of that folder."""
    def entries(match):
        names = sorted(name for name in os.listdir(os.path.join(source, match[2])) if name.endswith(".md"))
        return "".join(f"{match[1]}- {name[:-3]}: {match[2]}/{name}\n" for name in names)

    return re.sub(r"^( +)- (docs/\S+)/\*\n", entries, settings, flags=re.M)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source")
    parser.add_argument("output")
    parser.add_argument("--no-headers", action="store_true")
    words = parser.parse_args()
    source, output = os.path.abspath(words.source), os.path.abspath(words.output)
    broken = make_source(source, os.path.join(output, "source"))
    for fault in broken:
        print(fault, file=sys.stderr)
    if broken:
        return 1
    with open(os.path.join(source, "docs/site/mkdocs.yml"), encoding="utf-8") as file:
        settings = file.read()
    settings = with_rules(settings.replace("../../build/docs", output), source)
    with open(os.path.join(output, "mkdocs.yml"), "w", encoding="utf-8") as file:
        file.write(settings)
    subprocess.run(["mkdocs", "build", "--quiet", "--config-file", os.path.join(output, "mkdocs.yml")], check=True)
    if not words.no_headers:
        doxyfile = os.path.join(output, "Doxyfile")
        with open(doxyfile, "w", encoding="utf-8") as file:
            file.write(f"@INCLUDE = {source}/docs/site/Doxyfile\nOUTPUT_DIRECTORY = {output}/site\n")
        subprocess.run(["doxygen", doxyfile], check=True, cwd=source, stderr=subprocess.DEVNULL)
    return 0


if __name__ == "__main__":
    sys.exit(main())
