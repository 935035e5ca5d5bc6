#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists sources that changed in more than names, comments and includes.

changed_sources.py FIRST PATTERN…

Compares the working tree with the commit FIRST. A file counts as unchanged if its tokens are those
of the file at FIRST after identifiers, comments, line breaks and #include lines are ignored: what
clang-tidy said of that file still holds."""
import re
import subprocess
import sys

TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#[ \t]*include[^\n]*|(R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|'
                   r"'(?:\\.|[^'\\\n])+'" r"|[A-Za-z_]\w*|\d[\w.']*|[^\s\w])", re.DOTALL | re.MULTILINE)


KEYWORDS = set("""auto bool break case catch char class const constexpr continue default delete do double else enum explicit
    false float for friend if inline int long mutable namespace new noexcept nullptr operator override private protected
    public requires return short signed sizeof static std struct switch template this throw true try typename union
    unsigned using virtual void while""".split())


def tokens(text):
    found = (match[1] for match in TOKEN.finditer(text) if match[1])
    return ["name" if re.fullmatch(r"[A-Za-z_]\w*", token) and token not in KEYWORDS else token for token in found]


def git(*words):
    return subprocess.run(["git", *words], capture_output=True, text=True, check=True).stdout


def main():
    first, patterns = sys.argv[1], sys.argv[2:]
    for line in git("diff", "--find-renames=50%", "--diff-filter=AMR", "--name-status", first, "--",
                    *patterns).splitlines():
        status, *paths = line.split("\t")
        with open(paths[-1], encoding="utf-8") as source:
            now = tokens(source.read())
        if status == "A" or tokens(git("show", f"{first}:{paths[0]}")) != now:
            print(paths[-1])


if __name__ == "__main__":
    main()
