#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts mutants of a library that its tests kill.

    tests/mutants/run.py LIBRARY [--count 100] [--seed 20261201]

A mutant is the library with one operator or constant changed (sites.py lists the operators). It is
killed if a test fails, crashes, or takes many times its usual time; an index out of range is a crash
(_GLIBCXX_ASSERTIONS). The mutants are drawn from all
sources lib/LIBRARY/src/*.cpp, compiled into one library, and chosen at run time. Each test first
runs without a mutant, to record the mutants whose places it evaluates; a mutant then runs only
these tests. The same sources, tests and seed give the same table.

`equivalent.txt` lists mutants that no test can kill, each with the reason.
"""
import argparse
import concurrent.futures
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import schemata  # noqa: E402
import sites as finder  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))

# Test programs that count for a library, and the filter of their tests: its unit tests, which for
# gcode contain whole programs of tests/gcode/good, bad and the corpus; for verify also the tests of
# `ncsim check` that take less than a minute in all.
TESTS = {
    'gcode': {'ncsim_gcode_tests': '*'},
    'toolpath': {'ncsim_toolpath_tests': '*'},
    'verify': {'ncsim_verify_tests': '*',
               'ncsim_cli_tests': ('Check.*:Rules.*:RuleExamples.*:Doubts.*:Requirements.*:'
                                   'Fixtures.*:JobOfTwoSetUps.*:*/Verdicts.*')},
}
MEMORY = 16 << 30


def fail(message):
    sys.exit(f'run.py: {message}')


class Build:
    """Commands of the build folder, and the folder for sources and programs with mutants."""

    def __init__(self, folder, library, seed):
        self.folder = os.path.abspath(folder)
        self.lib = library
        self.source = os.path.join(ROOT, 'lib', library, 'src')
        self.work = os.path.join(self.folder, 'mutants', f'{library}-{seed}')
        self.copy = os.path.join(self.work, 'src')
        self.archive = os.path.join(self.work, f'libncsim_{library}.a')
        os.makedirs(self.work, exist_ok=True)

    def ninja(self, *arguments):
        ran = subprocess.run(['ninja', '-C', self.folder, *arguments], check=False, text=True,
                             stdout=subprocess.PIPE)
        if ran.returncode != 0:
            fail(f'{self.folder} is no build with tests: {ran.stdout.strip()}')
        return ran.stdout

    def link_command(self, target):
        last = self.ninja('-t', 'commands', target).splitlines()[-1]
        return next(part for part in last.split(' && ') if ' -o ' in part)

    def units(self):
        """Translation units of the library: object, source, arguments of the compiler."""
        objects = re.compile(rf'\S*lib/{self.lib}/CMakeFiles/ncsim_{self.lib}(_\w+)?\.dir/')
        units = []
        for command in self.ninja('-t', 'commands', f'lib/{self.lib}/libncsim_{self.lib}.a'
                                  ).splitlines():
            words = shlex.split(command)
            if '-c' in words and objects.match(words[words.index('-o') + 1]):
                units.append((words[words.index('-o') + 1], words[words.index('-c') + 1], words))
        if not units:
            fail(f'{self.folder} does not build lib/{self.lib}')
        return units


def sources_of(unit, root):
    """The sources of the library in a unit, which may join several: path → name."""
    with open(unit) as text:
        joined = re.findall(r'#include "(/.*\.cpp)"', text.read())
    return {path: os.path.relpath(path, root) for path in joined or [unit]}


def flags(words):
    return [word for word in words if re.match(r'-(I|D|std=|isystem)', word)] + [
        word for at, word in enumerate(words) if words[at - 1] == '-isystem']


class Mutants:
    """The library with the chosen mutants."""

    def __init__(self, build, count, seed):
        self.build = build
        self.count = count
        self.units = build.units()
        self.contents = {}
        self.unit_of = {}
        found = []
        with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
            jobs = []
            for _, path, words in self.units:
                sources = sources_of(path, build.source)
                for file, name in sources.items():
                    with open(file, 'rb') as text:
                        self.contents[name] = text.read()
                    self.unit_of[name] = path
                jobs.append(pool.submit(finder.find_sites, path, flags(words), sources))
            for job in jobs:
                found += job.result()
        self.order = schemata.ordered(found, self.contents, seed)
        self.refused = set()
        self.places = len(found)

    def chosen(self):
        order = [m for at, m in enumerate(self.order) if at not in self.refused]
        return [(number, site, change) for number, (site, change) in enumerate(order[:self.count])]

    def write(self):
        """Writes the sources that changed; returns the units whose sources hold mutants."""
        chosen = self.chosen()
        for folder, _, files in os.walk(self.build.source):
            target = os.path.join(self.build.copy, os.path.relpath(folder, self.build.source))
            os.makedirs(target, exist_ok=True)
            for file in files:
                if not file.endswith('.cpp'):
                    shutil.copy2(os.path.join(folder, file), os.path.join(target, file))
        units = set()
        for name, text in self.contents.items():
            mine = [m for m in chosen if m[1].file == name]
            if mine:
                units.add(self.unit_of[name])
            put(os.path.join(self.build.copy, name), schemata.Source(text, mine).render())
        return units

    def compile(self):
        """Builds the archive. A mutant that does not compile gives its place to the next."""
        while True:
            units = self.write()
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                done = list(pool.map(lambda unit: self.compile_unit(unit, unit[1] in units),
                                     self.units))
            errors = [error for _, error in done if error]
            if not errors:
                break
            for error in errors:
                self.refuse(error)
        runtime = os.path.join(self.build.work, 'runtime.o')
        subprocess.run(['c++', '-O2', '-fPIC', '-c', os.path.join(HERE, 'runtime.cpp'), '-o',
                        runtime], check=True)
        if os.path.exists(self.build.archive):
            os.remove(self.build.archive)
        subprocess.run(['ar', 'qc', self.build.archive, *[o for o, _ in done], runtime], check=True)

    def compile_unit(self, unit, has_mutants):
        """Returns the object, and the errors of the compiler."""
        usual, path, words = unit
        usual = os.path.join(self.build.folder, usual)
        if not has_mutants:
            return usual, ''
        stem = os.path.join(self.build.work, os.path.basename(path))
        with open(path) as text:
            joined = text.read()
        if path.startswith(self.build.source):
            joined = f'#include "{path}"\n'
        put(stem + '.cpp', joined.replace(self.build.source, self.build.copy).encode())
        texts = [stem + '.cpp'] + [os.path.join(self.build.copy, name)
                                   for name, user in self.unit_of.items() if user == path]
        if is_newer(stem + '.o', [usual, *texts, __file__, os.path.join(HERE, 'runtime.h')]):
            return stem + '.o', ''
        own = [word.replace(self.build.source, self.build.copy) for word in flags(words)]
        command = ['c++', *own, '-O1', '-DNDEBUG', '-D_GLIBCXX_ASSERTIONS', '-fPIC', '-ffp-contract=off', '-w', '-include',
                   os.path.join(HERE, 'runtime.h'), '-c', stem + '.cpp', '-o', stem + '.o']
        result = subprocess.run(command, text=True, stderr=subprocess.PIPE)
        return stem + '.o', result.stderr if result.returncode else ''

    def refuse(self, error):
        """Takes out the mutants in lines that the compiler refuses, or else the next one above."""
        refused = set()
        above = []
        for path, line in re.findall(r'^(/\S+?):(\d+):\d+: error:', error, re.MULTILINE):
            name = os.path.relpath(path, self.build.copy)
            above += [(int(line) - site.line, self.order.index((site, change)))
                      for _, site, change in self.chosen()
                      if name == site.file and site.line < int(line)]
            for _, site, change in self.chosen():
                last = site.line + self.contents[name][site.begin:site.end].count(
                    b'\n') if name == site.file else 0
                if name == site.file and site.line <= int(line) <= last:
                    refused.add(self.order.index((site, change)))
        if not refused and above:
            # The initializer of a member, in a type of which the line has a constant.
            refused.add(min(above)[1])
        if not refused:
            fail('does not compile:\n' + error)
        self.refused |= refused


def put(path, text):
    """Writes a file if its contents differ."""
    if os.path.exists(path):
        with open(path, 'rb') as file:
            if file.read() == text:
                return
    with open(path, 'wb') as file:
        file.write(text)


def is_newer(path, others):
    return os.path.exists(path) and all(
        os.path.getmtime(other) <= os.path.getmtime(path) for other in others)


class Program:
    """A test program linked with the mutants."""

    def __init__(self, build, target, only):
        self.build = build
        self.name = target
        self.path = os.path.join(build.work, target)
        command = build.link_command(target)
        if target == 'ncsim_cli_tests':
            command = self.with_own_ncsim(command)
        self.link(command, self.path)
        listed = subprocess.run([self.path, '--gtest_list_tests', f'--gtest_filter={only}'],
                                check=True, text=True, stdout=subprocess.PIPE).stdout
        self.tests = []
        for line in listed.splitlines():
            line = line.split('#')[0].rstrip()
            if line and not line.startswith(' '):
                suite = line
            elif line:
                self.tests.append(suite + line.strip())

    def link(self, command, output):
        usual = f'lib/{self.build.lib}/libncsim_{self.build.lib}.a'
        words = [self.build.archive if word == usual else word for word in shlex.split(command)]
        words[words.index('-o') + 1] = output
        subprocess.run([word for word in words if word != ':'], cwd=self.build.folder, check=True)

    def with_own_ncsim(self, command):
        """Links ncsim with the mutants, and compiles the source that names the program with it."""
        ncsim = os.path.join(self.build.work, 'ncsim')
        self.link(self.build.link_command('ncsim'), ncsim)
        source = os.path.join(ROOT, 'tests/cli/run_program.cpp')
        usual = next(word for word in shlex.split(command) if word.endswith('run_program.cpp.o'))
        compiled = os.path.join(self.build.work, 'run_program.o')
        words = next(words for words in map(shlex.split, self.build.ninja(
            '-t', 'commands', 'ncsim_cli_tests').splitlines()) if source in words)
        words = [word for word in words if not word.startswith('-DNCSIM_PROGRAM')]
        words[words.index('-o') + 1] = compiled
        subprocess.run([*words, f'-DNCSIM_PROGRAM="{ncsim}"'], cwd=self.build.folder, check=True)
        return command.replace(usual, compiled)

    def run(self, tests, mutant, timeout, reached=None):
        """Runs tests; returns 'passed', 'failed' or 'late', and the seconds that it took."""
        environment = dict(os.environ, NCSIM_MUTANT=str(mutant))
        if reached:
            environment['NCSIM_MUTANTS_REACHED'] = reached
        chosen = '*' if len(tests) == len(self.tests) and mutant >= 0 else ':'.join(tests)
        start = time.monotonic()
        process = subprocess.Popen(
            [self.path, '--gtest_fail_fast', '--gtest_brief=1', f'--gtest_filter={chosen}'],
            cwd=os.path.join(self.build.folder, 'tests'), env=environment, start_new_session=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
        try:
            status = process.wait(timeout)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.wait()
            return 'late', timeout
        return 'passed' if status == 0 else 'failed', time.monotonic() - start


class Judge:
    """Runs the tests against each mutant."""

    def __init__(self, programs, mutants, jobs):
        self.programs = programs
        self.mutants = mutants
        self.jobs = jobs
        self.reached = {}

    def record(self):
        """Runs each test without a mutant: time, and the mutants that it reaches."""
        def one(job):
            place, (program, test) = job
            path = os.path.join(program.build.work, f'reached-{place}')
            with open(path, 'wb') as file:
                file.write(bytes(len(self.mutants)))
            outcome, seconds = program.run([test], -1, 600, path)
            with open(path, 'rb') as file:
                bytes_ = file.read()
            os.remove(path)
            return program, test, outcome, seconds, {n for n, byte in enumerate(bytes_) if byte}

        tests = [(program, test) for program in self.programs for test in program.tests]
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for program, test, outcome, seconds, numbers in pool.map(one, enumerate(tests)):
                if outcome != 'passed':
                    fail(f'{program.name} --gtest_filter={test}: {outcome} without a mutant')
                for number in numbers:
                    self.reached.setdefault(number, []).append((seconds, program, test))

    def judge(self, number):
        """Returns the outcome of a mutant, and the number of tests that reach it.

        Fast tests go first; the time allowed is a multiple of the recorded time.
        """
        reaching = sorted(self.reached.get(number, []), key=lambda r: (r[0], r[2]))
        for batch in (reaching[:20], reaching[20:]):
            for program in self.programs:
                mine = [(seconds, test) for seconds, p, test in batch if p is program]
                if not mine:
                    continue
                limit = 20 + 10 * sum(seconds for seconds, _ in mine)
                outcome, _ = program.run([test for _, test in mine], number, limit)
                if outcome != 'passed':
                    return outcome, len(reaching)
        return 'survived', len(reaching)

    def all(self, numbers):
        def one(number):
            outcome = self.judge(number)
            print(f'mutant {number}: {outcome[0]}', file=sys.stderr, flush=True)
            return outcome

        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return dict(zip(numbers, pool.map(one, numbers)))


def equivalents():
    """Rows of equivalent.txt: (file, text of the line, change) → reason."""
    rows = {}
    with open(os.path.join(HERE, 'equivalent.txt')) as file:
        for line in file:
            if line.strip() and not line.startswith('#'):
                name, text, change, reason = (part.strip() for part in line.split(' | '))
                rows[name, text, change] = reason
    return rows


def describe(site, change, contents):
    source = contents[site.file]
    line = source[source.rfind(b'\n', 0, site.begin) + 1:].split(b'\n', 1)[0].strip().decode()
    part = ' '.join(source[site.begin:site.end].decode().split())
    return line, f'{change[0]} in `{part}`'


def report(build, mutants, outcomes, seed):
    known = equivalents()
    tally = {'killed': 0, 'late': 0, 'survived': 0, 'unreached': 0, 'equivalent': 0}
    for number, site, change in mutants.chosen():
        if number not in outcomes:
            continue
        outcome, reaching = outcomes[number]
        line, text = describe(site, change, mutants.contents)
        if outcome != 'survived':
            tally['killed'] += 1
            tally['late'] += outcome == 'late'
            continue
        reason = known.get((site.file, line, text))
        tally['equivalent' if reason else 'survived'] += 1
        tally['unreached'] += not reaching and not reason
        what = f'equivalent ({reason})' if reason else f'survived {reaching} tests'
        print(f'lib/{build.lib}/src/{site.file}:{site.line}:{site.column}: {number}: '
              f'{site.operator}: {text}: {what}\n    {line}')
    print(f'{build.lib}, seed {seed}: {len(outcomes)} mutants of {mutants.places} places, '
          f'{tally["killed"]} killed ({tally["late"]} by time), {tally["survived"]} survived '
          f'({tally["unreached"]} reached by no test), {tally["equivalent"]} equivalent')
    return tally


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('lib', metavar='library', choices=sorted(TESTS))
    parser.add_argument('--count', type=int, default=100)
    parser.add_argument('--seed', type=int, default=20261201)
    parser.add_argument('--build', default=os.path.join(ROOT, 'build/release'))
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--least', type=int, default=0,
                        help='exit with 1 if fewer mutants are killed, or more than 5 are equivalent')
    parser.add_argument('--numbers', help='run these mutants alone, as in 3,17')
    options = parser.parse_args()
    build = Build(options.build, options.lib, options.seed)
    build.ninja(*TESTS[options.lib])
    mutants = Mutants(build, options.count, options.seed)
    mutants.compile()
    programs = [Program(build, name, only) for name, only in TESTS[options.lib].items()]
    judge = Judge(programs, mutants.chosen(), options.jobs)
    judge.record()
    numbers = ([int(n) for n in options.numbers.split(',')] if options.numbers else
               range(len(mutants.chosen())))
    tally = report(build, mutants, judge.all(list(numbers)), options.seed)
    if tally['killed'] < options.least or (options.least and tally['equivalent'] > 5):
        sys.exit(1)


if __name__ == '__main__':
    main()
