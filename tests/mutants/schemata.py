# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes sources that hold many mutants at once, each chosen at run time (mutant schemata)."""
import bisect
import hashlib
import re


def ordered(sites, sources, seed):
    """Returns all (site, change), in the random order of `seed`.

    The order depends on the texts of places, not on line numbers: a changed line of a source adds
    and removes its own mutants alone.
    """
    keyed = []
    times = {}
    for site in sites:
        source = sources[site.file]
        line = source[source.rfind(b'\n', 0, site.begin) + 1:].split(b'\n', 1)[0].strip()
        text = b'\0'.join([str(seed).encode(), site.file.encode(), site.operator.encode(), line,
                           source[site.begin:site.end]])
        times[text] = times.get(text, 0) + 1
        key = hashlib.sha256(text + b'\0%d' % times[text]).digest()
        keyed.append((key, site, site.changes[key[-1] % len(site.changes)]))
    return [(site, change) for key, site, change in sorted(keyed)]


class Source:
    """The text of one source with mutants."""

    def __init__(self, text, mutants):
        self.text = text
        # Among mutants of the same place, one that keeps the whole text comes first, with the others in it.
        self.mutants = sorted(mutants, key=lambda m: (
            m[1].begin, -m[1].end, '{%d:%d}' % (m[1].begin, m[1].end) not in m[2][1], m[0]))
        self.newlines = [at for at, byte in enumerate(text) if byte == 10]

    def line(self, at):
        return bisect.bisect_left(self.newlines, at) + 1

    def render(self):
        return self.part(0, len(self.text), frozenset())

    def part(self, begin, end, done):
        """The bytes from `begin` to `end`, with the mutants within that are not in `done`."""
        out = []
        at = begin
        for number, site, change in self.mutants:
            if number in done or site.begin < at or site.end > end:
                continue
            out.append(self.text[at:site.begin])
            out.append(self.mutant(number, site, change, done))
            at = site.end
        out.append(self.text[at:end])
        return b''.join(out)

    def mutant(self, number, site, change, done):
        """The text of one mutant. #line keeps the line numbers of repeated text right."""
        _, template = change
        is_long = b'\n' in self.text[site.begin:site.end]

        def within(match):
            begin, end = int(match[1]), int(match[2])
            text = self.part(begin, end, done | {number})
            return (b'\n#line %d\n' % self.line(begin) if is_long else b'') + text

        text = re.sub(rb'\{(\d+):(\d+)\}', within, template.encode())
        text = re.sub(rb'\bMUTANT\b', b'ncsim_mutant(%d)' % number, text)
        return text + (b'\n#line %d\n' % self.line(site.end) if is_long else b'')
