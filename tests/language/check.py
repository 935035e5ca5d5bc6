#!/usr/bin/env python3
"""Measures the language of comments, messages and docs, and compares it with limits.txt.

Usage: check.py SOURCE [--lower]

Per folder with sources: pronouns per 100 words of comments, percent of comment blocks that begin with a
word of rule 1, and how often words that the glossary replaces stand in comments and string literals.
Per folder with Markdown: pronouns per 100 words, percent of sentences of more than 25 words, and the same
words. CONTRIBUTING.md has the rules.

Fails if a figure is above its limit, if a folder has no limit and is above the bar, or if a limit is higher
than in the commit before. --lower writes limits.txt with the figures of today, where they are lower.
"""
import os
import re
import subprocess
import sys

PRONOUNS = re.compile(
    r"\b(it|its|these|those|they|them|one|ones|other|others|such|what|who|whom|nothing|something|"
    r"anything|nobody|somebody|anybody|all of it|all of them)\b", re.I)
STARTS = re.compile(r"(Of|What|Who|Whose|Those|As|Where|From|Else|So|Than|That|Likewise|Or|And|But|To)\b")
WORDS = re.compile(
    r"\b(told|untold|tells?|nobody|somebody|anybody|strangers?|beside)\b", re.I)
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
FIGURES = ("pronouns", "starts", "words", "long")
BAR = {"pronouns": 2.5, "starts": 2.0, "words": 0, "long": 0.0}
LONGEST_SENTENCE = 25
FEWEST_WORDS = 4  # of a comment block; shorter ones are labels


def comment_blocks(text):
    """Yields the text of each comment block: lines that begin with //, or a comment behind a declaration."""
    block = []
    for line in text.split("\n") + [""]:
        comment = re.match(r"\s*//+[!<]? ?(.*)", line)
        if comment:
            block.append(comment[1])
            continue
        if block:
            yield " ".join(block)
            block = []
        trailing = re.search(r";\s*//+[!<]* ?(.*)", line)
        if trailing:
            yield trailing[1]


def measure_sources(texts):
    words = pronouns = blocks = starts = replaced = 0
    for text in texts:
        for block in comment_blocks(text):
            block = re.sub(r"SPDX-License-Identifier: \S+", "", block).strip()
            replaced += len(WORDS.findall(block))
            if "Copyright" in block or len(block.split()) < FEWEST_WORDS:
                continue
            words += len(block.split())
            pronouns += len(PRONOUNS.findall(block))
            blocks += 1
            starts += bool(STARTS.match(block))
        code = re.sub(r"(?m)^\s*(//.*|#include.*)$", "", text)
        replaced += sum(len(WORDS.findall(literal)) for literal in LITERAL.findall(code))
    return {"pronouns": 100 * pronouns / max(words, 1), "starts": 100 * starts / max(blocks, 1),
            "words": replaced, "long": 0.0}


def sentences(markdown):
    """Yields the sentences of running text: no tables, headings, code or links' addresses."""
    text = re.sub(r"(?ms)^```.*?^```", "", markdown)
    text = re.sub(r"(?m)^(\||#| {4}).*$", "", text)
    text = re.sub(r"\]\([^)]*\)", "]", text)
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.) )", text):
        for sentence in re.split(r"(?<=[.!?:;])\s+", " ".join(paragraph.split())):
            if sentence:
                yield sentence


def measure_docs(texts):
    words = pronouns = count = long = replaced = 0
    for text in texts:
        for sentence in sentences(text):
            size = len(sentence.split())
            words += size
            count += 1
            long += size > LONGEST_SENTENCE
            pronouns += len(PRONOUNS.findall(sentence))
            replaced += len(WORDS.findall(sentence))
    return {"pronouns": 100 * pronouns / max(words, 1), "starts": 0.0, "words": replaced,
            "long": 100 * long / max(count, 1)}


def measure(source):
    """Returns the figures of each folder, by its name; docs are named after their folder with *.md."""
    files = subprocess.run(["git", "-C", source, "ls-files", "--cached", "--others", "--exclude-standard"],
                           capture_output=True, text=True, check=True).stdout.split("\n")
    folders, docs = {}, {}
    for name in sorted(files):
        if not os.path.isfile(os.path.join(source, name)):
            continue
        folder = os.path.dirname(name) or "."
        with open(os.path.join(source, name), errors="replace") as file:
            if re.match(r"(lib|apps|tests|python)/.*\.(h|cpp|def)$", name):
                folders.setdefault(folder, []).append(file.read())
            elif name.endswith(".md"):
                docs.setdefault(folder + "/*.md", []).append(file.read())
    figures = {folder: measure_sources(texts) for folder, texts in folders.items()}
    figures.update({folder: measure_docs(texts) for folder, texts in docs.items()})
    return figures


def parse_limits(text):
    limits = {}
    for line in text.split("\n"):
        if not line or line.startswith("#"):
            continue
        folder, *numbers = line.split()
        limits[folder] = dict(zip(FIGURES, map(float, numbers)))
    return limits


def limit_text(limits):
    rows = ["# Limits of tests/language/check.py, which only go down: check.py SOURCE --lower writes this file.",
            "# folder, pronouns per 100 words, percent of blocks that begin with a word of rule 1, words of",
            "# rules 4 and 5, percent of sentences of more than 25 words."]
    for folder, limit in sorted(limits.items()):
        rows.append(f"{folder} {limit['pronouns']:.1f} {limit['starts']:.1f} {limit['words']:.0f} {limit['long']:.1f}")
    return "\n".join(rows) + "\n"


def round_up(figure):
    return -(-figure * 10 // 1) / 10


def all_sources(source, roots):
    for root in roots:
        for folder, _, names in os.walk(os.path.join(source, root)):
            for name in sorted(names):
                if name.endswith((".h", ".cpp", ".def")):
                    with open(os.path.join(folder, name), errors="replace") as file:
                        yield file.read()


def lowered(limits, figures):
    """Returns the limits of today's figures, where these are lower. Folders without limits get one only if
    there are no limits at all: a new folder keeps to the bar."""
    result = {}
    for folder, figure in figures.items():
        if limits and folder not in limits:
            continue
        old = limits.get(folder, {})
        limit = {name: max(BAR[name], min(old.get(name, float("inf")), round_up(figure[name]))) for name in FIGURES}
        if limit != BAR:
            result[folder] = limit
    return result


def main():
    source = sys.argv[1]
    path = os.path.join(source, "tests/language/limits.txt")
    with open(path) as file:
        limits = parse_limits(file.read())
    figures = measure(source)
    faults = []
    for folder, figure in sorted(figures.items()):
        limit = limits.get(folder, BAR)
        for name in FIGURES:
            if figure[name] > limit[name] + 1e-9:
                faults.append(f"{folder}: {name} {figure[name]:.2f}, limit {limit[name]:g}")
    before = subprocess.run(["git", "-C", source, "show", "HEAD:tests/language/limits.txt"],
                            capture_output=True, text=True)
    for folder, old in parse_limits(before.stdout if before.returncode == 0 else "").items():
        for name in FIGURES:
            if limits.get(folder, BAR)[name] > max(old[name], BAR[name]) + 1e-9:
                faults.append(f"limits.txt: {folder}: {name} went up from {old[name]:g}")
    if "--lower" in sys.argv:
        with open(path, "w") as file:
            file.write(limit_text(lowered(limits, figures)))
        return 0
    for fault in faults:
        print("language: " + fault, file=sys.stderr)
    lib = measure_sources(all_sources(source, ("lib", "apps")))
    print(f"language: lib and apps: {lib['pronouns']:.2f} pronouns per 100 words, {lib['starts']:.1f} % of blocks"
          f" begin with a word of rule 1, {lib['words']} words of rules 4 and 5; {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
