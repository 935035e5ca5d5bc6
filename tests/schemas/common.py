"""Schemas of docs/schemas, and calls of ncsim, for the tests of this folder."""
import json
import os
import subprocess
import sys

from jsonschema import Draft7Validator

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
SCHEMAS = os.path.join(SOURCE, "docs", "schemas")
NCSIM = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 and os.path.isfile(sys.argv[1]) else "ncsim"


def load(name):
    with open(os.path.join(SCHEMAS, f"{name}.schema.json"), encoding="utf-8") as file:
        return json.load(file)


def names():
    return sorted(name.split(".")[0] for name in os.listdir(SCHEMAS) if name.endswith(".schema.json"))


def errors(schema, value):
    """Lists the errors of `value`, each with its place."""
    return [f"{'/'.join(map(str, e.absolute_path)) or 'root'}: {e.message[:300]}"
            for e in Draft7Validator(schema).iter_errors(value)]


def call(words, folder, **options):
    """Runs ncsim. Returns the exit code, the standard output and the standard error."""
    run = subprocess.run([NCSIM, *words], cwd=folder, capture_output=True, stdin=subprocess.DEVNULL, text=True,
                         errors="replace", timeout=1000, check=False, **options)
    return run.returncode, run.stdout, run.stderr


def resolved(schema, node):
    """Follows `$ref`, and `allOf` with a single element."""
    while True:
        if "$ref" in node:
            target = schema
            for name in node["$ref"].removeprefix("#/").split("/"):
                target = target[name]
            node = target
        elif len(node.get("allOf", ())) == 1:
            node = {**resolved(schema, node["allOf"][0]), **{k: v for k, v in node.items() if k != "allOf"}}
        else:
            return node


def variants(schema, node):
    """Lists the schemas of an `anyOf`; the schema itself if there is none."""
    node = resolved(schema, node)
    choices = [resolved(schema, one) for one in node.get("anyOf", ())]
    typed = [one for one in choices if "type" in one or "enum" in one]
    return typed if typed and "properties" not in node else [node]
