"""Compares the schemas of TOML files with the readers of ncsim, and validates the project's TOML files.

Usage: toml_test.py NCSIM

A schema and a reader agree on the keys of an object: the message about a misspelt key lists the keys that the
reader knows. Keys of ncsim.toml are the options of `ncsim check --help` that the reader accepts.
"""
import concurrent.futures
import glob
import itertools
import json
import os
import re
import struct
import tempfile
import threading
import tomllib
import unittest

from jsonschema import Draft7Validator

from common import SOURCE, call, errors, load, names, resolved, variants

KINDS = {"job": ["tools", "part.nc", "--no-project", "--job", "tested.toml"],
         "machine": ["machine", "tested.toml"],
         "holders": ["tools", "part.nc", "--no-project", "--holders", "tested.toml"],
         "project": ["tools", "part.nc"]}
FILE_OF = {"project": "ncsim.toml"}
SCHEMAS = {kind: load(kind) for kind in KINDS}
PLACE = re.compile(r"^ncsim: [\w.-]+:(\d+):(\d+): (.*)")
TYPE_ERROR = re.compile(r"expected (a number|a text|true or false|a table|a list|\d values in brackets|"
                        r"a whole number|a value)|write \[\[")
PROBES = (-7, "a text", {"zz": 1}, [{"zz": 1}])


# --- TOML -------------------------------------------------------------------------------------
def toml_value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(k)} = {toml_value(v)}" for k, v in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    return json.dumps(value)


def toml_text(document):
    """Writes a line per key of the document."""
    return "".join(f"{json.dumps(k)} = {toml_value(v)}\n" for k, v in document.items())


# --- ncsim ------------------------------------------------------------------------------------
def box_mesh(size):
    """Returns a cube as binary STL."""
    corner = [(x * size, y * size, z * size) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    data = struct.pack("<80xI", len(triangles))
    for triangle in triangles:
        data += struct.pack("<12f2x", 0, 0, 0, *(x for i in triangle for x in corner[i]))
    return data


class Reader:
    """Folders with the files that examples name; a thread has a folder of its own."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.own = threading.local()

    def _make(self):
        folder = tempfile.mkdtemp(dir=self.folder.name)
        program = "(T1 D=10. CR=0. - flat end mill)\nG21 G90 G54 T1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM30\n"
        for name, text in (("part.nc", program), ("back.nc", program), ("tool.tbl", "T1 P1 D10 ;flat end mill\n"),
                           ("job.toml", 'version = 2\nprogram = "part.nc"\n'), ("mill.toml", 'name = "mill"\n'),
                           ("known.json", "{}"),
                           ("holders.toml", '[[holder]]\nname = "a"\nsegments = [[30, 40]]\n')):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        for name in ("vise.stl", "cradle.stl", "stock.stl", "design.stl"):
            with open(os.path.join(folder, name), "wb") as file:
                file.write(box_mesh(20.0))
        os.mkdir(os.path.join(folder, "subprograms"))
        return folder

    def read(self, kind, document):
        """Returns an error message, or an empty text if ncsim reads the document."""
        if not hasattr(self.own, "path"):
            self.own.path = self._make()
        path = os.path.join(self.own.path, FILE_OF.get(kind, "tested.toml"))
        with open(path, "w", encoding="utf-8") as file:
            file.write(toml_text(document))
        words = KINDS[kind]
        if kind == "job" and "setup" in document:
            words = ["tools", "tested.toml", "--no-project", "--setup", "1"]
        code, _, message = call(words, self.own.path)
        if kind == "project":
            os.remove(path)
        if code not in (0, 1, 2, 4):
            raise AssertionError(f"exit code {code}: {message}\n{document}")
        return message.strip() or "no message" if code == 2 else ""

    def read_all(self, tasks):
        """Yields (task, message) for tasks (kind, document, …)."""
        with concurrent.futures.ThreadPoolExecutor(max(2, min(4, os.cpu_count() or 2))) as pool:
            yield from zip(tasks, pool.map(lambda task: self.read(task[0], task[1]), tasks))


READER = Reader()


# --- documents from schemas -------------------------------------------------------------------
def example(schema, node):
    node = variants(schema, node)[0]
    if node.get("examples"):
        return node["examples"][0]
    if "enum" in node:
        return node["enum"][0]
    if node.get("type") == "object":
        return {key: example(schema, node["properties"][key]) for key in node.get("required", ())}
    if node.get("type") == "array":
        return [example(schema, node["items"])] * node.get("minItems", 1)
    return {"number": 1, "integer": 1, "boolean": True}.get(node.get("type"), "a")


class Place:
    """An object of a schema. `document(value)` is a file with `value` as this object; `base` is a valid value."""

    def __init__(self, kind, path, node, base, document):
        self.kind, self.path, self.node, self.base, self.document = kind, path, node, base, document

    def __str__(self):
        return f"{self.kind} {'.'.join(self.path) or 'root'}"


def places(kind, schema, node=None, path=(), value=None, document=lambda value: value):
    """Yields a Place for each object of a schema. `value` is a valid value of `node`."""
    for choice in variants(schema, node or schema):
        if choice.get("type") == "array" and isinstance(choice.get("items"), dict):
            items = value if isinstance(value, list) and value else example(schema, choice)
            # The element with the most keys: the first set-up has no place of the part.
            at = max(range(len(items)), key=lambda i: len(items[i]) if isinstance(items[i], dict) else 0)
            yield from places(kind, schema, choice["items"], path + ("[]",), items[at],
                              lambda inner, at=at, items=items: document([*items[:at], inner, *items[at + 1:]]))
        if choice.get("type") != "object":
            continue
        minimal = example(schema, {**choice, "examples": []})
        base = value if isinstance(value, dict) and set(minimal) <= set(value) else minimal
        yield Place(kind, path, choice, base, document)
        children = [(key, child) for key, child in choice.get("properties", {}).items()]
        for pattern, child in choice.get("patternProperties", {}).items():
            children += [(key, child) for key in base if re.search(pattern, key)][:1]
        for key, child in children:
            inner = base.get(key, example(schema, child))
            # Keys such as turn and move exclude points.
            fewer = ({k: v for k, v in base.items() if k not in left_out}
                     for count in (1, 2) for left_out in itertools.combinations(base, count))
            for rest in itertools.chain((base,), fewer, (minimal,)):
                whole = completed(schema, [document({**rest, key: inner})])
                if whole is not None:
                    break
            else:
                continue
            more = {k: v for k, v in whole.items() if k not in document({**rest, key: inner})}
            yield from places(kind, schema, child, path + (key,), inner,
                              lambda value, key=key, rest=rest, more=more: {**more, **document({**rest, key: value})})


def node_at(schema, path):
    node = resolved(schema, schema)
    for step in path:
        for choice in variants(schema, node):
            if isinstance(step, int) and "items" in choice:
                node = choice["items"]
                break
            if step in choice.get("properties", {}):
                node = choice["properties"][step]
                break
        else:
            return None
    return resolved(schema, node)


def repairs(error):
    """Yields (path, key) of keys that a document lacks."""
    path = tuple(error.absolute_path)
    if error.validator == "required":
        for key in error.validator_value:
            if key not in error.instance:
                yield path, key
    if error.validator == "dependencies":
        for key, needed in error.validator_value.items():
            if key in error.instance and isinstance(needed, list):
                yield from ((path, other) for other in needed if other not in error.instance)
    for part in error.context:
        yield from repairs(part)


def with_value(document, path, key, value):
    if not path:
        return {**document, key: value}
    step, rest = path[0], path[1:]
    inner = with_value(document[step], rest, key, value)
    if isinstance(document, list):
        return [inner if i == step else other for i, other in enumerate(document)]
    return {**document, step: inner}


def completed(schema, documents):
    """Adds the keys that the documents lack. Returns the first valid document; None if there is none."""
    for _ in range(4):
        further = []
        for document in documents:
            faults = list(Draft7Validator(schema).iter_errors(document))
            if not faults:
                return document
            for path, key in dict.fromkeys(r for fault in faults for r in repairs(fault)):
                node = node_at(schema, (*path, key))
                if node is not None:
                    further.append(with_value(document, path, key, example(schema, node)))
        documents = further
    return None


PLACES = [place for kind, schema in SCHEMAS.items() for place in places(kind, schema)]
# A place for each different schema of an object: fixtures are in set-ups, jobs and machines.
DIFFERENT = list({json.dumps(place.node): place for place in reversed(PLACES)}.values())


def has(document, path, key):
    """True if the object at `path` has the key; "[]" is any element of a list."""
    if not path:
        return key in document
    inner = document if path[0] == "[]" else [document[path[0]]] if path[0] in document else []
    return any(has(one, path[1:], key) for one in inner)


def files_of_keys():
    """Yields (kind, document, place, key) for each example of each key."""
    for place in DIFFERENT:
        if place.kind == "project" and place.path:
            continue  # the same options as at the root, and files
        schema = SCHEMAS[place.kind]
        minimal = example(schema, {**place.node, "examples": []})
        for key, value in place.node.get("properties", {}).items():
            has_key = has(place.document(place.base), place.path, key)
            if has_key:
                yield place.kind, place.document(place.base), place, key
            for one in resolved(schema, value)["examples"]:
                more = {"stock": "stock.stl"} if key.startswith("stock-") else {}  # options of one file
                documents = (completed(schema, [place.document({**rest, **more, key: one})])
                             for rest in (place.base, minimal))
                document = next((one for one in documents if one is not None), None)
                if document is not None or not has_key:
                    yield place.kind, document, place, key


def is_of_names(place):
    """True if the reader derives the keys of the object from a rule, such as names of axes."""
    return "patternProperties" in place.node or set(place.node["properties"]) == set("ABC")


def differing_keys(node):
    """Lists the keys of an object; the first key alone if all keys have the same schema, such as G54, G55, …"""
    keys = list(node.get("properties", {}))
    kinds = {json.dumps({k: v for k, v in node["properties"][key].items() if k not in ("description", "examples")})
             for key in keys}
    return keys[:1] if len(kinds) == 1 else keys


# --- tests ------------------------------------------------------------------------------------
class Schemas(unittest.TestCase):
    def test_each_key_has_a_description_and_valid_examples(self):
        for place in PLACES:
            schema = SCHEMAS[place.kind]
            self.assertIn("title", schema)
            self.assertIs(place.node["additionalProperties"], False, place)
            self.assertEqual(errors(schema, place.document(place.base)), [], place)
            for key, value in place.node.get("properties", {}).items():
                value = resolved(schema, value)
                where = f"{place} {key}"
                self.assertGreater(len(value.get("description", "")), 5, where)
                self.assertTrue(value.get("examples"), where)
                for one in value["examples"]:
                    self.assertEqual(list(Draft7Validator(schema).evolve(schema=value).iter_errors(one)), [], where)

    def test_schemas_are_schemas(self):
        for name in names():
            Draft7Validator.check_schema(load(name))

    def test_definitions_of_the_same_name_are_equal(self):
        job, machine, project = SCHEMAS["job"], SCHEMAS["machine"], SCHEMAS["project"]
        for name in ("fixture", "offsets"):
            self.assertEqual(job["definitions"][name], machine["definitions"][name], name)
        self.assertEqual(job["definitions"]["rules"], project["definitions"]["rules"])


class Files(unittest.TestCase):
    def expect_valid(self, kind, text, where):
        self.assertEqual(errors(SCHEMAS[kind], tomllib.loads(text)), [], f"{where} as {kind}")

    def expect_valid_file(self, kind, path):
        with open(path, encoding="utf-8") as file:
            self.expect_valid(kind, file.read(), os.path.relpath(path, SOURCE))

    def kind_of(self, path):
        """Selects the kind by the name and the keys of the root."""
        if os.path.basename(path) == "ncsim.toml":
            return "project"
        with open(path, "rb") as file:
            return "job" if "version" in tomllib.load(file) else "machine"

    def test_samples_are_valid(self):
        files = glob.glob(os.path.join(SOURCE, "samples", "**", "*.toml"), recursive=True)
        self.assertGreater(len(files), 5)
        for path in files:
            self.expect_valid_file(self.kind_of(path), path)

    def test_files_of_verdicts_and_faults_are_valid(self):
        folder = os.path.join(SOURCE, "tests", "verdicts")
        with open(os.path.join(folder, "index.json"), encoding="utf-8") as file:
            index = json.load(file)
        kinds = {}
        for entry in index:
            words = entry.get("options", [])
            for option, kind in (("--machine", "machine"), ("--job", "job"), ("--holders", "holders")):
                for i, word in enumerate(words[:-1]):
                    if word == option:
                        kinds[words[i + 1]] = kind
        for path in glob.glob(os.path.join(folder, "*.toml")):
            self.expect_valid_file(kinds.get(os.path.basename(path), self.kind_of(path)), path)
        self.assertGreater(len(kinds), 15)
        for path in glob.glob(os.path.join(SOURCE, "tests", "faults", "programs", "*.toml")):
            self.expect_valid_file(self.kind_of(path), path)

    def test_toml_in_the_documentation_is_valid(self):
        """A block is valid for a schema that has the keys of the block."""
        found = 0
        for page in glob.glob(os.path.join(SOURCE, "docs", "*.md")) + [os.path.join(SOURCE, "README.md")]:
            with open(page, encoding="utf-8") as file:
                text = file.read()
            before = ""
            blocks = re.findall(r"(?ms)^```toml *([^\n]*)\n(.*?)^```", text)
            if page.endswith("machines.md"):  # parts of a machine file, indented
                blocks += [("", block) for block in re.findall(r"(?m)((?:^ {4}.*\n)+)", text)
                           if " = " in block and "|" not in block and "# of a [[" not in block]
            for info, block in blocks:
                block = re.sub(r"(?m)^ {4}", "", block)
                before = before + block if info.endswith("+") else block
                keys = set(tomllib.loads(before))
                kinds = [kind for kind, schema in SCHEMAS.items() if keys <= set(schema["properties"])]
                self.assertTrue(kinds, f"{os.path.basename(page)}: no file has the keys {sorted(keys)}")
                self.assertTrue(any(not errors(SCHEMAS[kind], tomllib.loads(before)) for kind in kinds),
                                f"{os.path.basename(page)}: {block}\n"
                                f"{errors(SCHEMAS[kinds[0]], tomllib.loads(before))}")
                found += 1
        self.assertGreater(found, 10)


class Documentation(unittest.TestCase):
    """Compares the tables of docs/jobs.md with the schema of job files."""

    @classmethod
    def setUpClass(cls):
        with open(os.path.join(SOURCE, "docs", "jobs.md"), encoding="utf-8") as file:
            cls.page = file.read()
        cls.job = SCHEMAS["job"]

    def rows(self, heading):
        """Lists (keys, text of the value) of the table below a heading."""
        section = re.search(rf"(?ms)^## {heading}$(.*?)(?=^## |\Z)", self.page)[1]
        rows = re.findall(r"(?m)^\| (`.*?) \| (.*) \|$", section)
        return [(re.findall(r"`\[*(?:\w+\.)?(\w+)\]*`", keys), value) for keys, value in rows]

    def expect_each_key_once(self, heading, node, others=()):
        listed = [key for keys, _ in self.rows(heading) for key in keys]
        self.assertEqual(sorted(listed), sorted(set(node["properties"]) - set(others)), heading)

    def expect_words(self, heading, key, words):
        value = next(value for keys, value in self.rows(heading) if keys == [key])
        self.assertEqual(sorted(re.findall(r"`(\w+)", value)), sorted(words), f"{heading}: {key}")

    def test_each_key_of_a_job_is_in_a_table_once(self):
        definitions = self.job["definitions"]
        self.expect_each_key_once("Set-ups", definitions["setup"])
        self.expect_each_key_once("Values for all set-ups", self.job)
        self.expect_each_key_once("Tools", definitions["tool"])
        self.expect_each_key_once("Fixtures", definitions["fixture"], others=["stl"])  # an older name

    def test_names_in_the_tables_are_those_of_the_schema(self):
        definitions, root = self.job["definitions"], self.job["properties"]
        self.expect_words("Set-ups", "assumed", definitions["setup"]["properties"]["assumed"]["items"]["enum"])
        self.expect_words("Values for all set-ups", "assumed", root["assumed"]["items"]["enum"])
        self.expect_words("Tools", "assumed", definitions["tool"]["properties"]["assumed"]["items"]["enum"])
        self.expect_words("Tools", "piece", definitions["tool"]["properties"]["piece"]["items"]["properties"])
        for shape in ("vise", "clamp"):
            self.expect_words("Fixtures", shape, definitions["fixture"]["properties"][shape]["properties"])
        outputs = next(value for keys, value in self.rows("Values for all set-ups") if keys == ["outputs"])
        self.assertEqual(sorted(re.findall(r"`(\w+)`", outputs)),
                         sorted([*definitions["outputs"]["properties"], "run"]))
        stock = next(value for keys, value in self.rows("Values for all set-ups") if keys == ["stock"])
        keys = [key for choice in root["stock"]["anyOf"] for key in choice.get("properties", ())]
        self.assertEqual(sorted(re.findall(r"`(\w+)`", stock)), sorted(keys))


class Keys(unittest.TestCase):
    def test_ncsim_reads_an_example_of_each_key(self):
        tasks = list(files_of_keys())
        for _, document, place, key in tasks:
            self.assertIsNotNone(document, f"{place} {key}: no valid file has this key")
        for (kind, document, place, key), message in READER.read_all(tasks):
            if "no axis" in message:  # the preset of the example has other axes
                value = example(SCHEMAS[kind], place.node["properties"][key])
                message = min(READER.read(kind, {**place.document({key: value}), "preset": preset})
                              for preset in SCHEMAS[kind]["properties"]["preset"]["enum"])
            self.assertEqual(message, "", f"{place} {key}:\n{toml_text(document)}")
        self.assertGreater(len(tasks), 200)

    def test_a_misspelt_key_is_refused_and_the_message_lists_the_keys_of_the_schema(self):
        tasks = []
        for place in PLACES:
            schema, document = SCHEMAS[place.kind], place.document({**place.base, "zz": 1})
            self.assertNotEqual(errors(schema, document), [], place)
            tasks.append((place.kind, document, place))
        for (_, document, place), message in READER.read_all(tasks):
            found = PLACE.match(message)
            self.assertTrue(found, f"{place}: '{message}'\n{toml_text(document)}")
            self.assertIn('"zz"', toml_text(document).split("\n")[int(found[1]) - 1], f"{place}: {message}")
            if "'zz' is not known" not in found[3]:
                self.assertRegex(found[3], r"\bzz'", f"{place}: {message}")
                self.assertTrue(place.kind == "project" or is_of_names(place), f"{place}: {message}")
                continue
            known = re.search(r"expected (.*?)( \(did you mean .*)?$", found[3])[1].split(", ")
            self.assertEqual(sorted(known), sorted(place.node["properties"]), str(place))

    def test_keys_of_ncsim_toml_are_the_options_that_it_may_contain(self):
        options = re.findall(r"(?m)^  (?:-\w,)?--([a-z-]+)", call(["check", "--help"], SOURCE)[1])
        self.assertGreater(len(options), 50)
        tasks = [("project", {"version": 1, name: "a"}, name) for name in options]
        known = {name for (_, _, name), message in READER.read_all(tasks)
                 if "no option of ncsim check" not in message}
        # --setup needs a job on the command line, so ncsim refuses each value in ncsim.toml.
        known.remove("setup")
        self.assertEqual(known, set(SCHEMAS["project"]["properties"]) - {"version", "program"})
        self.assertEqual(known, set(SCHEMAS["project"]["definitions"]["program"]["properties"]) - {"files"})

    def test_schema_and_reader_agree_on_names_of_axes_systems_and_variables(self):
        candidates = ["A", "B", "C", "D", "U", "X", "Z", "a", "x", "", "G53", "G54", "G59", "G59.1", "G59.3", "G59.4",
                      "g54", "G54.1 P0", "G54.1 P1", "G54.1 P99", "G54.1 P100", "G54.1 P300", "G54.1 P301", "G54.1P1",
                      "G54.1 P007", "#1", "#0", "#500", "#99999", "#100000", "#05", "#<a>", "#<_depth>", "#<>", "#a",
                      "D0", "D1", "d7", "D01", "D9999", "D10000", "D1.5", "D-1", "M6", "M99", "M100", "M0428", "M9999",
                      "M10000", "m428", "P0", "P1", "P01", "P99", "P100", "P300", "P301", "p1", "P-1", "P", "R5", "r0", "R", "R100000", "Q12345", "q1", "Q-1"]
        tasks = [(place.kind, place.document({name: next(iter(place.base.values()))}), place, name)
                 for place in DIFFERENT if is_of_names(place) for name in candidates
                 if name[:1] in ("", "a", "x", "R", "r", "Q", "q", *(key[0] for key in place.base))]
        self.assertGreater(len(tasks), 80)
        for (kind, document, place, name), message in READER.read_all(tasks):
            if "has no axis" in message:  # the preset of the example
                message = ""
            self.assertEqual(not message, not errors(SCHEMAS[kind], document), f"{place} '{name}': {message}")

    def test_schema_and_reader_agree_on_types(self):
        """ncsim also reads options in other forms: a number as a text, a list of one value."""
        options = {key.replace("-", "_") for key in SCHEMAS["project"]["properties"]} & \
            set(SCHEMAS["job"]["properties"])
        tasks = [(place.kind, place.document({**place.base, key: probe}), place, key, probe)
                 for place in DIFFERENT for key in differing_keys(place.node) for probe in PROBES
                 if not (place.kind == "project" and place.path)]  # the same options as at the root
        for (kind, document, place, key, probe), message in READER.read_all(tasks):
            faults = errors(SCHEMAS[kind], document)
            where = f"{place} {key} = {toml_value(probe)}: '{message}', {faults}"
            if not message and faults:
                is_option = kind == "project" or kind == "job" and not place.path and key in options
                self.assertTrue(is_option and isinstance(probe, (int, float, list)), where)
            if message and not faults:
                self.assertFalse(TYPE_ERROR.search(message) or "'zz' is not known" in message, where)

    def test_lists_of_names_are_complete(self):
        """Compares rules, categories and reasons with `ncsim rules`, and other names with messages."""
        rules = json.loads(call(["rules", "--json"], SOURCE)[1])
        named = SCHEMAS["job"]["definitions"]["rules"]["anyOf"][0]["enum"]
        self.assertEqual(sorted(named), sorted({r["id"] for r in rules["rules"]} |
                                               {r["category"] for r in rules["rules"]}))
        reasons = ["all", *(r["id"] for r in rules["reasons"])]
        self.assertEqual(SCHEMAS["job"]["properties"]["accept"]["items"]["enum"], reasons)
        self.assertEqual(SCHEMAS["project"]["definitions"]["reasons"]["anyOf"][0]["enum"], reasons)
        tasks = []
        for place in DIFFERENT:
            for key, value in place.node.get("properties", {}).items():
                value = resolved(SCHEMAS[place.kind], value)
                value, wrong = (value["items"], ["zz"]) if value.get("type") == "array" else (value, "zz")
                if all(isinstance(word, str) for word in value.get("enum", [0])):
                    tasks.append((place.kind, place.document({**place.base, key: wrong}), place, key, value["enum"]))
        self.assertGreater(len(tasks), 20)
        for (_, _, place, key, enum), message in READER.read_all(tasks):
            where = f"{place} {key}: {message}"
            self.assertTrue(message, where)
            if "expected" not in message or "ncsim rules" in message:
                continue
            listed = re.findall(r"[\w+-]+", message.split("expected", 1)[1].split(", not ")[0])
            if key == "model":  # job files and ncsim.toml are read by check, too
                listed = [word for word in listed if word not in ("cda-flat", "dexel")]
            self.assertEqual(sorted(set(listed) - {"or"}), sorted(enum), where)


if __name__ == "__main__":
    unittest.main()
