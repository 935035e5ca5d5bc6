#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the mutants themselves, on a small source: places, changed texts, and two mutants at run
time, one that a test kills and one that survives.

    tests/mutants/run_test.py

Exit code 77 if libclang (python3-clang-14) is missing.
"""
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
try:
    import schemata
    import sites
    sites.Index.create()
except Exception as missing:  # no module, or no library behind the module
    print('run_test.py: libclang is missing:', missing)
    sys.exit(77)

SOURCE = r'''
constexpr double kLimit = 0.5;
constexpr int twice(int n) { return n + n; }
static_assert(twice(2) < 5);
struct Area {
    double sum = 0.0;
    void add(double value) { sum += value; }
};
double clamped(double value, bool negate) {
    Area area;
    if (negate) value = -value;
    area.add(value * 2.0);
    int left = 2;
    while (left > 0) --left;
    if (negate && left == 0) left = 1;
    switch (twice(1)) {
        case 2: break;
    }
    int counts[3] = {};
    counts[0] = value < kLimit &&
        // A comment with a brace }
        negate ? 1 : 4;
    return area.sum + counts[0];
}
#ifdef WITH_MAIN
int main() {
    // Neither 4.0 < 0.5 nor 4.0 <= 0.5: the boundary survives.
    return clamped(4.0, false) == 12.0 ? 0 : 1;
}
#endif
'''


def found_in(folder):
    path = os.path.join(folder, 'small.cpp')
    with open(path, 'w') as file:
        file.write(SOURCE)
    return path, sites.find_sites(path, ['-std=c++20'], {path: 'small.cpp'})


class Places(unittest.TestCase):
    def test_operators(self):
        with tempfile.TemporaryDirectory() as folder:
            _, found = found_in(folder)
        text = SOURCE.encode()
        places = {(site.operator, text[site.begin:site.end].decode()): [c[0] for c in site.changes]
                  for site in found}
        self.assertEqual(places['comparison', 'value < kLimit'], ['< to <=', '< to >='])
        self.assertEqual(places['constant', 'kLimit'], ['kLimit times ten'])
        self.assertEqual(places['sign', '-value'], ['- removed'])
        self.assertEqual(places['arithmetic', 'value * 2.0'], ['* to /'])
        self.assertEqual(places['accumulate', 'sum += value'], ['+= to -='])
        self.assertEqual(places['removal', 'area.add(value * 2.0)'], ['statement removed'])
        self.assertEqual(places['condition', 'negate'], ['negated'])
        self.assertEqual(places['number', '1'], ['1 to 2', '1 to 0', '1 to 10'])
        logical = [text for operator, text in places if operator == 'logical']
        self.assertEqual(len(logical), 2)
        # A decrement is no sign.
        self.assertFalse([p for p in places if p[0] == 'sign' and p[1].startswith('--')])
        # Nothing of constant expressions: kLimit = 0.5, n + n, twice(2) < 5, case 2, [3].
        for text in ('0.5', 'n + n', 'twice(2) < 5', '5', '3'):
            self.assertFalse([p for p in places if p[1] == text], text)

    def test_order_depends_on_the_seed_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            _, found = found_in(folder)
        sources = {'small.cpp': SOURCE.encode()}
        one = schemata.ordered(found, sources, 1)
        self.assertEqual(one, schemata.ordered(found[::-1][::-1], sources, 1))
        self.assertNotEqual(one, schemata.ordered(found, sources, 2))
        self.assertEqual(len(one), len(found))


class Runs(unittest.TestCase):
    def test_one_is_killed_and_one_survives(self):
        with tempfile.TemporaryDirectory() as folder:
            path, found = found_in(folder)
            text = SOURCE.encode()

            def mutant(number, operator, part, change):
                site = next(s for s in found if s.operator == operator and
                            text[s.begin:s.end].decode() == part)
                return number, site, next(c for c in site.changes if c[0] == change)

            mutants = [mutant(0, 'comparison', 'value < kLimit', '< to <='),
                       mutant(1, 'arithmetic', 'value * 2.0', '* to /'),
                       # Two mutants of the same place.
                       mutant(2, 'logical', 'negate && left == 0', '&& to ||'),
                       mutant(3, 'condition', 'negate && left == 0', 'negated')]
            with open(path, 'wb') as file:
                file.write(schemata.Source(text, mutants).render())
            program = os.path.join(folder, 'small')
            subprocess.run(['c++', '-std=c++20', '-DWITH_MAIN', '-include',
                            os.path.join(HERE, 'runtime.h'), path,
                            os.path.join(HERE, 'runtime.cpp'), '-o', program], check=True)
            reached = os.path.join(folder, 'reached')
            with open(reached, 'wb') as file:
                file.write(bytes(4))

            def status(number):
                return subprocess.run([program], env=dict(
                    os.environ, NCSIM_MUTANT=str(number), NCSIM_MUTANTS_REACHED=reached)).returncode

            self.assertEqual([status(n) for n in (-1, 0, 1, 2, 3)], [0, 0, 1, 0, 0])
            with open(reached, 'rb') as file:
                self.assertEqual(file.read(), b'\1\1\1\1')


if __name__ == '__main__':
    unittest.main()
