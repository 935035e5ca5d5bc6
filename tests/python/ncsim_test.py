#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the Python package ncsim.

Usage: PYTHONPATH=BUILD/python NCSIM=BUILD/ncsim ncsim_test.py [TEST…]
"""
import gc
import inspect
import json
import math
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import ncsim

NCSIM = os.environ["NCSIM"]
SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
SLOT = """(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,40.,40.,10.,0.,0.,10.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X-5. Y20. Z5.
G0 Z-5.
G1 X45. F300.
G0 Z5.
M30
"""
START = (0.0, 0.0, 50.0)
# A ball end mill over many lines: about half a second of work, and minutes with a fine tool.
LONG = "(T1 D=6. CR=3. - ball end mill)\n(STOCK/BLOCK,90.,90.,10.,0.,0.,10.)\nG21 G90 G54\nT1 M6\nS1 M3\n" + \
    "G0 X0 Y0 Z5\nG1 Z-1 F500\n" + "".join(
        f"G1 X{45 + 40 * math.sin(0.31 * i):.3f} Y{45 + 40 * math.cos(0.2 * i):.3f} "
        f"Z{-2 + math.sin(i):.3f}\n" for i in range(1500)) + "M30\n"


def slot(**options):
    return ncsim.simulate(text=SLOT, **{"start": START, **options})


class Part(unittest.TestCase):
    def test_has_the_volume_that_the_cutter_left(self):
        part = slot()
        self.assertAlmostEqual(part.stock_volume, 16000.0)
        self.assertAlmostEqual(part.volume, 16000.0 - 6 * 40 * 5)
        self.assertAlmostEqual(part.removed, 1200.0)
        self.assertEqual(part.stock_box, ((0.0, 0.0, -10.0), (40.0, 40.0, 0.0)))
        self.assertEqual(part.program, "program.nc")
        self.assertIn(1, part.tools)

    def test_is_the_part_of_the_command_line(self):
        part = ncsim.simulate(SAMPLES / "complex.nc")
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = (pathlib.Path(folder) / name for name in ("ours", "theirs"))
            part.mesh().write_stl(f"{ours}.stl")
            part.solid().write_step(f"{ours}.step", attributes=True)
            subprocess.run([NCSIM, "run", "-q", "--no-project", SAMPLES / "complex.nc",
                            "--stl", f"{theirs}.stl", "--step", f"{theirs}.step",
                            "--step-attributes"], check=True)
            for end in (".stl", ".step"):
                with self.subTest(end):
                    self.assertEqual(pathlib.Path(f"{ours}{end}").read_bytes(),
                                     pathlib.Path(f"{theirs}{end}").read_bytes())
            self.assertEqual(len(os.listdir(folder)), 4)

    def test_is_the_same_for_any_number_of_threads(self):
        meshes = [ncsim.simulate(SAMPLES / "complex.nc", threads=n).mesh() for n in (1, 4)]
        np.testing.assert_array_equal(meshes[0].vertices, meshes[1].vertices)
        np.testing.assert_array_equal(meshes[0].triangles, meshes[1].triangles)
        np.testing.assert_array_equal(meshes[0].lines, meshes[1].lines)

    def test_stops_after_a_line(self):
        self.assertEqual(slot(at_line=7).removed, 0.0)
        self.assertAlmostEqual(slot(at_line=8).removed, 1200.0)

    def test_has_volumes_by_tool_and_block(self):
        self.assertEqual(slot().removed_by_block, {})
        part = slot(volumes="block")
        self.assertAlmostEqual(part.removed_by_block[0, 8], 1200.0)
        self.assertAlmostEqual(part.removed_by_tool[1], 1200.0)

    def test_takes_tools_and_stock(self):
        text = "G21 G90 G54\nT2 M6\nS8000 M3\n" + SLOT[SLOT.index("G0 X-5"):]
        part = ncsim.simulate(text=text, tools={2: "flat:D8"}, stock="0,0,-10:40,40,0", start=START)
        self.assertAlmostEqual(part.removed, 8 * 40 * 5)
        self.assertEqual(set(part.mesh().tools.tolist()), {0, 2})

    def test_is_cut_by_another_model(self):
        part = slot(model="dexel", resolution=0.5)
        self.assertEqual(part.model, "dexel")
        self.assertLessEqual(abs(part.removed - 1200.0), part.volume_error)
        with self.assertRaisesRegex(ncsim.UsageError, "not exact"):
            part.solid()

    def test_follows_subprograms_of_the_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "o100.ngc").write_text("o<o100> sub\nG1 X45. F300.\no<o100> endsub\n")
            path = pathlib.Path(folder, "main.ngc")
            path.write_text(SLOT.replace("G1 X45. F300.", "o<o100> call"))
            part = ncsim.simulate(path, start=START)
        self.assertAlmostEqual(part.removed, 1200.0)
        self.assertEqual(len(part.files), 2)
        self.assertIn(1, part.motions["file"])  # the folder is gone


    def test_is_cut_on_a_machine(self):
        with tempfile.TemporaryDirectory() as folder:
            machine = pathlib.Path(folder, "machine.toml")
            machine.write_text('name = "mill"\n[position]\nstart = [0, 0, 100]\n')
            self.assertIn("position of G54", ncsim.simulate(text=SLOT, machine=machine).not_used[0])
            machine.write_text(machine.read_text() + "[offsets]\nG54 = [0, 0, 0]\n")
            part = ncsim.simulate(text=SLOT, machine=machine)
        self.assertEqual(part.not_used, [])
        self.assertEqual(part.motions["start"][1].tolist(), [0.0, 0.0, 100.0])


class Arrays(unittest.TestCase):
    def test_enclose_the_volume(self):
        mesh = slot().mesh()
        a, b, c = (mesh.vertices[mesh.triangles[:, i]] for i in range(3))
        self.assertAlmostEqual(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6, 14800.0)
        self.assertEqual(mesh.volume, 14800.0)
        self.assertEqual(set(mesh.lines.tolist()), {0, 8})
        self.assertEqual(set(mesh.tools.tolist()), {0, 1})
        self.assertEqual(len(mesh.faces), len(mesh.triangles))
        self.assertEqual(mesh.shells, 1)

    def test_outlive_the_simulation_without_copies(self):
        part = slot()
        mesh = part.mesh()
        arrays = [mesh.vertices, mesh.triangles, mesh.lines, mesh.tools, mesh.faces, part.motions]
        copies = [array.copy() for array in arrays]
        again = part.mesh().vertices
        self.assertEqual(again.__array_interface__["data"], arrays[0].__array_interface__["data"])
        del part, mesh, again
        gc.collect()
        slot(tool_tolerance=0.01).mesh()  # reuses freed memory
        for array, copy in zip(arrays, copies):
            self.assertFalse(array.flags.owndata)
            self.assertFalse(array.flags.writeable)
            for name in array.dtype.names or [...]:
                np.testing.assert_array_equal(array[name], copy[name])

    def test_free_the_memory_when_the_last_is_gone(self):
        def size():
            with open("/proc/self/statm") as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")
        text = SLOT.replace("M30", "G0 X1\nG0 X2\n" * 30_000 + "M30")
        # Threads have memory of their own, which grows in the first runs.
        for _ in range(3):
            motions = ncsim.simulate(text=text, start=START).motions
        before = size()
        for _ in range(12):
            motions = ncsim.simulate(text=text, start=START).motions
        self.assertLess(size() - before, 6 * motions.nbytes)

    def test_refuse_writing(self):
        with self.assertRaises(ValueError):
            slot().mesh().vertices[0, 0] = 1.0

    def test_have_the_motions(self):
        motions = slot().motions
        feed = motions[motions["kind"] == ncsim.Kind.FEED]
        self.assertEqual(len(feed), 1)
        self.assertEqual(feed["line"].tolist(), [8])
        self.assertEqual(feed["start"].tolist(), [[-5.0, 20.0, -5.0]])
        self.assertEqual(feed["end"].tolist(), [[45.0, 20.0, -5.0]])
        self.assertEqual(feed["length"].tolist(), [50.0])
        self.assertEqual(feed["seconds"].tolist(), [10.0])
        self.assertEqual(feed["shape"].tolist(), [ncsim.Shape.LINE])
        self.assertEqual(motions["kind"][0], ncsim.Kind.TOOL_CHANGE)
        unknown = ncsim.simulate(text=SLOT).motions
        self.assertTrue(np.isnan(unknown["start"][unknown["line"] == 6]).all())

    def test_of_a_part_that_is_gone_are_empty(self):
        text = SLOT.replace("40.,40.,10.,0.,0.,10.", "4.,4.,4.,-10.,-10.,0.").replace("D=6.", "D=90.")
        mesh = ncsim.simulate(text=text, start=START, stock="0,18,-4:4,22,0").mesh()
        self.assertEqual(mesh.vertices.shape, (0, 3))
        self.assertEqual(mesh.triangles.shape, (0, 3))


class SolidAndMeasures(unittest.TestCase):
    def test_have_true_surfaces(self):
        text = SLOT.replace("G0 X-5. Y20. Z5.\nG0 Z-5.\nG1 X45. F300.",
                            "G0 X20. Y20. Z5.\nG1 Z-5. F300.")
        part = ncsim.simulate(text=text, start=START)
        solid = part.solid()
        self.assertAlmostEqual(solid.volume, 16000 - math.pi * 9 * 5, places=6)
        bores = [face for face in solid.faces if face.kind == "cylinder"]
        self.assertEqual(len(bores), 1)
        self.assertAlmostEqual(bores[0].dimensions[0], 6.0)
        self.assertAlmostEqual(bores[0].area, math.pi * 6 * 5, places=6)
        self.assertTrue(bores[0].is_hollow)
        self.assertEqual((bores[0].lines, bores[0].tools), ((7,), (1,)))
        measures = part.measure()
        self.assertEqual([(b.diameter_mm, b.depth_mm, b.end) for b in measures.bores],
                         [(6.0, 5.0, "flat")])
        self.assertEqual(measures.extents, ((0, 0, -10), (40, 40, 0)))
        self.assertEqual(ncsim.measure(text=text, start=START), measures)

    def test_are_those_of_the_command_line(self):
        ours = ncsim.measure(SAMPLES / "complex.nc")
        theirs = json.loads(subprocess.run(
            [NCSIM, "measure", "-q", "--no-project", SAMPLES / "complex.nc", "--json", "-"],
            check=True, stdout=subprocess.PIPE).stdout)
        self.assertEqual(ours.volume_mm3, theirs["volume_mm3"])
        self.assertGreater(len(ours.floors) + len(ours.bores) + len(ours.distances), 3)
        for name in ("bores", "bosses", "corners", "floors", "distances"):
            self.assertEqual(len(getattr(ours, name)), len(theirs[name]), name)


class Verdicts(unittest.TestCase):
    def test_are_those_of_the_command_line(self):
        for sample in ("simple.nc", "complex.nc", "wave.nc"):
            with self.subTest(sample):
                ours = ncsim.check(SAMPLES / sample)
                run = subprocess.run([NCSIM, "check", "-q", "--no-project", "--exit-zero",
                                      SAMPLES / sample, "--json", "-"],
                                     check=True, capture_output=True)
                theirs = json.loads(run.stdout)["programs"][0]
                self.assertEqual(ours.json, theirs)
                self.assertEqual(len(ours.findings), len(theirs["findings"]))
                self.assertEqual(len(ours.doubts), len(theirs["doubts"]))

    def test_have_findings_with_a_place(self):
        verdict = ncsim.check(text=SLOT.replace("G1 X45. F300.", "G0 X45."), start=START)
        self.assertEqual(verdict.verdict, "failed")
        self.assertFalse(verdict)
        finding = next(f for f in verdict.findings if f.rule == "rapid-in-material")
        self.assertEqual((finding.severity, finding.line, finding.last_line), ("error", 8, 8))
        self.assertEqual(finding.file, "program.nc")
        self.assertEqual((finding.quantity.unit, finding.quantity.value), ("mm3", 1200.0))
        self.assertIsNone(verdict.ledger)
        self.assertEqual(pickle.loads(pickle.dumps(finding)), finding)
        self.assertIn("program.nc:8:", str(finding))

    def test_select_rules(self):
        text = SLOT.replace("G1 X45. F300.", "G0 X45.")
        verdict = ncsim.check(text=text, start=START, ignore=["rapid-in-material"])
        self.assertNotIn("rapid-in-material", [f.rule for f in verdict.findings])
        verdict = ncsim.check(text=text, start=START,
                              severity={"rapid-in-material": "note"})
        self.assertEqual({f.severity for f in verdict.findings
                          if f.rule == "rapid-in-material"}, {"note"})
        options = {"start": START, "severity": {"rapid-in-material": "warning"}}
        self.assertNotEqual(ncsim.check(text=text, **options).verdict, "failed")
        self.assertEqual(ncsim.check(text=text, warnings_as_errors=True, **options).verdict, "failed")
        with self.assertRaisesRegex(ncsim.UsageError, "ignore: 'no-such'"):
            ncsim.check(text=text, ignore=["no-such"])

    def test_keep_a_ledger(self):
        verdict = ncsim.check(text=SLOT, start=START, ledger=True)
        ledger = verdict.ledger
        del verdict
        gc.collect()
        row = ledger[ledger["line"] == 8][0]
        self.assertAlmostEqual(row["removed"], 1200.0)
        self.assertEqual((row["length"], row["seconds"], row["tool"]), (50.0, 10.0, 1))
        self.assertEqual(row["kind"], ncsim.Kind.FEED)
        self.assertFalse(ledger.flags.owndata)

    def test_compare_with_a_design(self):
        with tempfile.TemporaryDirectory() as folder:
            design = pathlib.Path(folder, "design.stl")
            slot().mesh().write_stl(design)
            same = ncsim.check(text=SLOT, start=START, design=design)
            self.assertEqual(same.design["gouge"]["regions"], 0)
            deep = ncsim.check(text=SLOT.replace("Z-5.", "Z-5.5"), start=START, design=design)
            self.assertIn("gouge", [f.rule for f in deep.findings])


class Errors(unittest.TestCase):
    def test_of_a_program_have_a_place(self):
        with self.assertRaises(ncsim.ProgramError) as caught:
            ncsim.simulate(text=SLOT.replace("X45.", "X"), name="slot.nc")
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column, error.code),
                         ("slot.nc", 8, 4, "number-expected"))
        self.assertEqual(str(error), "slot.nc:8:4: expected a number after X")
        self.assertEqual(error.diagnostics[0].severity, "error")
        self.assertEqual(pickle.loads(pickle.dumps(error)).line, 8)
        part = ncsim.simulate(text=SLOT.replace("X45.", "X"), start=START, allow_errors=True)
        self.assertEqual(part.removed, 0.0)
        self.assertEqual([d.line for d in part.diagnostics if d.severity == "error"], [8])

    def test_of_the_simulation_have_a_place(self):
        text = SLOT.replace("X-5.", "X0.").replace("G1 X45. F300.", "G2 X0 Y20 I400000 J0 F300.")
        with self.assertRaises(ncsim.ProgramError) as caught:
            ncsim.simulate(text=text, start=START, tolerance=1e-4)
        self.assertEqual((caught.exception.line, caught.exception.code), (8, "path-accuracy"))

    def test_of_files_have_a_place(self):
        with tempfile.TemporaryDirectory() as folder:
            job = pathlib.Path(folder, "job.toml")
            job.write_text("version = 2\nstok = 3\n")
            with self.assertRaises(ncsim.UsageError) as caught:
                ncsim.simulate(SAMPLES / "simple.nc", job=job)
            self.assertEqual((caught.exception.file, caught.exception.line), (str(job), 2))
            with self.assertRaisesRegex(ncsim.UsageError, "cannot read"):
                ncsim.simulate(pathlib.Path(folder, "missing.nc"))
            with self.assertRaisesRegex(ncsim.Error, "cannot write"):
                slot().mesh().write_stl(pathlib.Path(folder, "missing", "part.stl"))
            pathlib.Path(folder, "inner").mkdir()
            with self.assertRaises(ncsim.Error):
                slot().mesh().write_stl(pathlib.Path(folder, "inner"))
            self.assertEqual(sorted(os.listdir(folder)), ["inner", "job.toml"])

    def test_of_arguments_name_the_argument(self):
        for options, text in [({"stock": "1x2"}, "stock: '1x2'"),
                              ({"tools": {1: "fat"}}, "tools: "),
                              ({"tolerance": 0.0}, "tolerance: expected 0.0001 to 10"),
                              ({"tolerance": math.nan}, "tolerance: expected"),
                              ({"threads": 5000}, "threads: "),
                              ({"model": "clay"}, "model: 'clay': expected cda"),
                              ({"dialect": "basic"}, "dialect: 'basic': expected auto"),
                              ({"units": "ell"}, "units: 'ell'"),
                              ({"start": (0, 0, math.inf)}, "start: "),
                              ({"variables": {"x": 1.0}}, "variables: 'x'"),
                              ({"compensation": {0: 1.0}}, "compensation: 0"),
                              ({"volumes": "all"}, "volumes: 'all'"),
                              ({"at_line": 99}, "at_line: 99: the program has 10 lines"),
                              ({"step": 0}, "step: ")]:
            with self.subTest(text), self.assertRaisesRegex(ncsim.UsageError, text):
                slot(**options)
        for options in [{"tols": 1}, {"tools": "flat:D6"}, {"tools": {"a": "flat:D6"}},
                        {"start": (1, 2)}, {"start": 3}, {"threads": "many"},
                        {"variables": [1]}, {"allow": "G187"}]:
            with self.subTest(options), self.assertRaises(TypeError):
                ncsim.simulate(text=SLOT, **options)
        with self.assertRaises(TypeError):
            ncsim.simulate("a.nc", text="G0")
        with self.assertRaises(ncsim.UsageError):
            ncsim.simulate()

    def test_of_any_bytes_are_exceptions(self):
        for text in ("", "\0", "(" * 1000, "G1 X1e400", "%\n:::\n", "\u00e9\u4e2d"):
            with self.subTest(text[:5]), self.assertRaises(ncsim.Error):
                ncsim.simulate(text=text)

    def test_of_limits(self):
        with self.assertRaisesRegex(ncsim.Error, "given up"):
            ncsim.simulate(text=LONG, max_time=1e-6)


class Threads(unittest.TestCase):
    def test_run_in_parallel_and_find_the_same(self):
        alone = slot().mesh().vertices
        found = []

        def work():
            found.append(slot(threads=1).mesh().vertices)
        threads = [threading.Thread(target=work) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 8)
        for vertices in found:
            np.testing.assert_array_equal(vertices, alone)

    def test_may_read_the_first_arrays_of_a_process(self):
        code = ("import ncsim, sys, threading\n"
                "mesh = ncsim.simulate(sys.argv[1]).mesh()\n"
                "threads = [threading.Thread(target=lambda: mesh.triangles) for _ in range(6)]\n"
                "for thread in threads: thread.start()\n"
                "for thread in threads: thread.join()\n")
        for _ in range(3):
            subprocess.run([sys.executable, "-c", code, SAMPLES / "complex.nc"], check=True, timeout=60)

    def test_share_a_simulation(self):
        part = ncsim.simulate(SAMPLES / "complex.nc")
        results = []
        work = [part.mesh, part.solid, part.measure, lambda: part.motions, lambda: part.assumptions]
        threads = [threading.Thread(target=lambda f=f: results.append(f())) for f in 2 * work]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 10)

    def test_of_python_run_during_a_simulation(self):
        ticks = []
        is_done = threading.Event()

        def tick():
            while not is_done.wait(0.005):
                ticks.append(time.monotonic())
        ticker = threading.Thread(target=tick)
        ticker.start()
        ncsim.simulate(text=LONG, tool_tolerance=0.1, threads=1).mesh()
        is_done.set()
        ticker.join()
        self.assertGreater(len(ticks), 5)

    def test_end_at_keyboard_interrupt(self):
        timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        began = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            ncsim.simulate(text=LONG, tool_tolerance=0.0001)
        timer.join()
        self.assertLess(time.monotonic() - began, 60.0)
        self.assertAlmostEqual(slot().removed, 1200.0)


class Jobs(unittest.TestCase):
    def test_have_steps(self):
        job = SAMPLES / "two-sides" / "job.toml"
        steps = ncsim.steps(job)
        self.assertGreater(len(steps), 1)
        self.assertEqual([step.number for step in steps], list(range(1, len(steps) + 1)))
        with self.assertRaisesRegex(ncsim.UsageError, "programs: choose one with step=, from 1 to"):
            ncsim.simulate(job)
        with self.assertRaisesRegex(ncsim.UsageError, "there is no program 9: the job has"):
            ncsim.simulate(job, step=9)
        first, last = ncsim.simulate(job, step=1), ncsim.simulate(job, step=len(steps))
        self.assertAlmostEqual(last.stock_volume, first.volume, delta=1e-6 * first.volume)
        self.assertEqual(os.path.basename(ncsim.check(job, step=1).file), "top.nc")


class Interface(unittest.TestCase):
    def test_names_are_documented(self):
        for name in ncsim.__all__:
            value = getattr(ncsim, name)
            if inspect.isclass(value) or inspect.isfunction(value):
                self.assertTrue(inspect.getdoc(value), name)

    def test_version_is_that_of_the_program(self):
        said = subprocess.run([NCSIM, "--version"], check=True, stdout=subprocess.PIPE, text=True)
        self.assertEqual(said.stdout, f"ncsim {ncsim.__version__}\n")
        self.assertIn("cda", ncsim.MODELS)

    def test_options_are_those_of_the_command_line(self):
        text = subprocess.run([NCSIM, "check", "--help"], check=True, stdout=subprocess.PIPE,
                              text=True).stdout
        text += subprocess.run([NCSIM, "run", "--help"], check=True, stdout=subprocess.PIPE,
                               text=True).stdout
        names = {"step": "setup", "tools": "tool", "tool_tables": "tool-table",
                 "variables": "variable", "volumes": "block-volumes", "design_tolerance": "design-tol"}
        ours_alone = {"allow_errors", "ledger"}
        for types in (ncsim.SimulateOptions, ncsim.CheckOptions):
            for name in set(types.__annotations__) - ours_alone:
                self.assertIn(f"--{names.get(name, name.replace('_', '-'))}", text, name)


if __name__ == "__main__":
    unittest.main()
