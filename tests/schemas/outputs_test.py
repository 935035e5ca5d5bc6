"""Validates the JSON outputs of ncsim against docs/schemas, and the schemas against the outputs.

Usage: outputs_test.py NCSIM

The samples and a few programs give the outputs. A schema notices each required key that an output lacks, and each
key that it does not know. Each key of a schema occurs in an output.
"""
import copy
import json
import os
import tempfile
import unittest

from jsonschema import Draft7Validator

from common import SOURCE, call, errors, load, resolved, variants

SAMPLES = os.path.join(SOURCE, "samples")
# Keys of rare parts; the sources write them.
RARE = {"report": {"facets_coarser", "deflection_mm"}, "check": None}

HEAD = "G21 G90 G17 G54\n"
PROGRAMS = {
    # A bore with a cone, a through bore, a pocket with corners, a boss.
    "holes.nc": "(T1 D=8. TAPER=118DEG - drill)\n(T2 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,20.,30.,30.,20.)\n"
                f"{HEAD}T1 M6 S1000 M3\nG0 X-20 Y-20 Z5\nG1 Z-10 F100\nG0 Z5\nX20\nG1 Z-30\nG0 Z5\n"
                "T2 M6 S2000 M3\nG0 X0 Y8 Z5\nG1 Z-4 F200\nG2 X0 Y8 I0 J-8\nG1 Z5\nM8\nG4 P1\n"
                "G0 X-20 Y20\nG1 Z-3\nX-10\nM77\nM30\n",
    "other.nc": "(T1 D=8. TAPER=118DEG - drill)\n(T2 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,21.,30.,30.,21.)\n"
                f"{HEAD}T1 M6 S1000 M3\nG0 X-20 Y-20 Z5\nG1 Z-12 F100\nG0 Z5\nX20\nG1 Z-30\nG0 Z5\n"
                "T2 M6 S2500 M3\nG0 X0 Y8 Z5\nG1 Z-4 F300\nG2 X0 Y8 I0 J-8\nG1 Z5\nM30\n",
    "thin.nc": "(T1 D=4. CR=0. - flat end mill)\n(T2 D=0.2 CR=0. - flat end mill)\n"
               f"(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n{HEAD}T1 M6 S1000 M3\n"
               "G0 X-30 Y0 Z5\nG1 Z-3 F300\nX30\nY4.3\nX-30\nG0 Z5\nT2 M6\nG0 X-30 Y-8.1\nG1 Z-3 F300\nX30\nG0 Z5\nM30\n",
    "calls.nc": f"(T1 D=4. CR=0. - flat end mill)\n{HEAD}T1 M6 S1000 M3\nG0 X0 Y0 Z5\nM98 P200\nM30\n",
    "O200.nc": "O200\nG91 G1 Z-6 F100\nX10\nM77\nG90\nM99\n",
    "tilted.nc": f"(T1 D=6. CR=1. TAPER=10DEG - bull nose end mill)\n{HEAD}T1 M6 S1000 M3\nG0 X0 Y0 Z50 A20 C10\n"
                 "G1 X5 Y-5 Z40 F100\nG0 Z60\nG1 Z50\nM30\n",
    # A cylinder ends less than a facet from the next cylinder, so the solid needs a finer cut.
    "corner.nc": "(T1 D=6. CR=3. - ball end mill)\n(STOCK/BLOCK,100.,100.,40.,0.,0.,40.)\nG21 G90\nT1 M6 S5000 M3\n"
                 "G0 X0. Y0. Z20.\nG1 X83.333 Y0. Z-4.168 F1500.\nX100. Y0. Z-6.265\nX100. Y25. Z-6.265\n"
                 "G0 Z20.\nM30\n",
    "broken.nc": f"{HEAD}T7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F10\nX5 Q (\n",
    "set.nc": f"{HEAD}T1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM30\n",
}
JOB = """version = 2
stock = "40x30x10"
[[tool]]
number = 1
kind = "taper"
diameter = 6
corner_radius = 0.5
taper = 3
length = 20
shank_diameter = 8
[[tool]]
number = 3
kind = "v"
diameter = 10
tip_diameter = 1
angle = 90
length = 8
"""
MILL = """name = "mill"
[rapid]
x = 9000
y = 9000
z = 6000
[offsets]
G54 = [0, 0, 0]
"""


def outputs():
    """Lists (schema, what, value) for all outputs, in a temporary folder."""
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**PROGRAMS, "job.toml": JOB, "mill.toml": MILL}.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)

        def add(schema, words, options, allowed=(0, 1, 4)):
            output = {"report": ["--report"], "tools": ["--json"]}.get(schema, ["--json"])
            output += [] if schema in ("tools", "explain") else ["-"]
            code, out, message = call([*words, *output, *options], folder)
            if code not in allowed:
                raise AssertionError(f"{words} {options}: exit code {code}: {message}")
            found.append((schema, " ".join([*words, *options]).replace(SAMPLES + os.sep, ""), json.loads(out)))

        samples = [os.path.join(SAMPLES, f"{name}.nc") for name in ("simple", "complex")]
        job = os.path.join(SAMPLES, "two-sides", "job.toml")
        for path in (*samples, job):
            add("report", ["run", path], ["-q"])
            add("measure", ["measure", path], ["-q"])
            add("tools", ["tools", path], [])
        for name in ("wave.nc", "five-axis.nc"):
            add("tools", ["tools", os.path.join(SAMPLES, name)], [])
        add("tools", ["tools", "calls.nc"], [])
        add("report", ["run", os.path.join(SAMPLES, "five-axis.nc")], ["-q"])
        add("check", ["check", SAMPLES], ["-q"])
        add("check", ["check", job], ["-q"])
        add("check", ["check", "holes.nc", "broken.nc", "missing.nc"], ["-q"], allowed=(2,))
        add("diff", ["diff", samples[0], samples[1]], ["-q"])
        add("diff", ["diff", job, job], ["-q"])
        add("diff", ["diff", job, job], ["-q", "--setup", "2"])
        call(["run", "holes.nc", "--save-stock", "a.ncstock", "--stl", "a.stl", "-q"], folder)
        add("report", ["run", "holes.nc"], ["-q", "--step", "a.step", "--section", "z=-2", "--dxf", "a.dxf",
                                            "--simplify", "0.1", "--stl", "b.stl", "--block-volumes",
                                            "--machine", "mill.toml", "--tool-tolerance", "0.5"])
        add("report", ["run", "corner.nc"], ["-q", "--step", "b.step"])
        add("report", ["run", "thin.nc"], ["-q", "--model", "dexel", "--resolution", "0.5"])
        add("report", ["run", "set.nc"], ["-q", "--stock", "a.stl", "--stock-turn", "X180", "--stock-move", "0,0,-5",
                                         "--tool", "T1=ball:D6:L20", "--at-line", "4"])
        add("report", ["run", "calls.nc"], ["-q", "--block-volumes"])
        add("report", ["run", "broken.nc"], ["-q"])
        add("report", ["run", "set.nc"], ["-q", "--tool", "T1=flat:D200:L50", "--stock", "1x1x0.5"])
        add("measure", ["measure", "holes.nc"], ["-q"])
        threads = os.path.join(SOURCE, "tests", "programs", "threads-and-chamfers", "program.nc")
        mills = ["--tool", "T4=slot:D8:L1", "--tool", "T5=tap:D6:K1"]
        add("measure", ["measure", threads], ["-q", *mills])
        for path, tools in (("holes.nc", []), (samples[1], []), (threads, mills)):  # faces of an earlier run
            call(["run", path, "--save-stock", "earlier.ncstock", "-q", *tools], folder)
            add("measure", ["measure", "set.nc"], ["-q", "--stock", "earlier.ncstock", "--tool", "T1=flat:D1:L20"])
        add("measure", ["measure", "set.nc"], ["-q", "--tool", "T1=flat:D200:L50", "--stock", "1x1x0.5"])
        add("tools", ["tools", "set.nc"], ["--job", "job.toml"])
        add("tools", ["tools", "tilted.nc"], [])
        add("tools", ["tools", "broken.nc"], [])
        add("explain", ["explain", samples[1], "--line", "20"], [])
        add("explain", ["explain", "holes.nc", "--line", "1"], [])
        add("explain", ["explain", "holes.nc:6", "--machine", "mill.toml"], [])
        add("explain", ["explain", "broken.nc:2"], [])
        add("diff", ["diff", "holes.nc", "other.nc"], ["-q", "--process"])
        add("diff", ["diff", "holes.nc", "holes.nc"], ["-q"])
    return found


def objects(schema, node, value, path=()):
    """Yields (schema of the object, object, path) for each object in a value."""
    node = next((one for one in variants(schema, node)
                 if not list(Draft7Validator(schema).evolve(schema=one).iter_errors(value))), None)
    if isinstance(value, list) and node:
        for i, one in enumerate(value):
            yield from objects(schema, node["items"], one, (*path, i))
    elif isinstance(value, dict) and node:
        yield node, value, path
        for key, inner in value.items():
            if key in node.get("properties", {}):
                yield from objects(schema, node["properties"][key], inner, (*path, key))


def changed(value, path, change):
    value = copy.deepcopy(value)
    inner = value
    for step in path:
        inner = inner[step]
    change(inner)
    return value


def identity(node):
    """Returns a text that is equal for all uses of a definition."""
    return json.dumps(node.get("properties", {}))


def all_keys(schema, node, path=()):
    """Yields (object, path, key, schema of the value) for each key of a schema."""
    for one in variants(schema, node):
        if "items" in one:
            yield from all_keys(schema, one["items"], path)
        for key, inner in one.get("properties", {}).items():
            yield one, path, key, resolved(schema, inner)
            yield from all_keys(schema, inner, (*path, key))


class Outputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.outputs = outputs()
        cls.schemas = {name: load(name) for name in ("report", "check", "measure", "tools", "diff",
                                                        "explain")}

    def test_each_output_is_valid(self):
        for name, what, value in self.outputs:
            self.assertEqual(errors(self.schemas[name], value), [], what)

    def test_a_missing_key_and_an_unknown_key_are_noticed(self):
        seen = set()
        for name, what, value in self.outputs:
            schema = self.schemas[name]
            for node, inner, path in objects(schema, schema, value):
                if (name, identity(node)) in seen:
                    continue
                seen.add((name, identity(node)))
                for key in node.get("required", ()):
                    without = changed(value, path, lambda one, key=key: one.pop(key))
                    self.assertNotEqual(errors(schema, without), [], f"{what}: {path} without {key}")
                if node.get("additionalProperties") is False:
                    more = changed(value, path, lambda one: one.update(zz=1))
                    self.assertNotEqual(errors(schema, more), [], f"{what}: {path} with zz")
        self.assertGreater(len(seen), 40)

    def test_no_key_of_a_schema_is_invented(self):
        for name, rare in RARE.items():
            self.assertIn(name, self.schemas)
        for name, schema in self.schemas.items():
            if RARE.get(name, ()) is None:
                continue  # tests/verify/schemas has the rare keys of check
            seen = {(identity(node), key) for of, _, value in self.outputs if of == name
                    for node, inner, _ in objects(schema, schema, value) for key in inner}
            lacking = [(path, key) for node, path, key, _ in all_keys(schema, schema)
                       if (identity(node), key) not in seen and key not in RARE.get(name, ())]
            self.assertEqual(lacking, [], name)

    def test_keys_that_no_output_of_this_test_has_are_in_the_sources(self):
        with open(os.path.join(SOURCE, "lib", "report", "src", "run_report.cpp"), encoding="utf-8") as file:
            source = file.read()
        for key in RARE["report"]:
            self.assertIn(f'"{key}"', source)

    def test_schemas_describe_each_key(self):
        for name, schema in self.schemas.items():
            self.assertIn("title", schema)
            self.assertIn("description", schema)
            for _, path, key, value in all_keys(schema, schema):
                self.assertTrue(value.get("description"), f"{name} {path} {key}")


if __name__ == "__main__":
    unittest.main()
