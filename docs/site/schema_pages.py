#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a reference page of a JSON schema: a table of keys for the file, and one for each definition."""
import json


def cell(text):
    return (text or "").replace("|", "\\|").strip()


def code(value):
    return "`" + (value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)).replace("|", "\\|") + "`"


TYPED = {"$ref", "const", "enum", "type", "anyOf", "oneOf", "properties"}


def alternatives(schema):
    """Returns the alternatives of a value that have a type."""
    return [one for key in ("anyOf", "oneOf") for one in schema.get(key, []) if TYPED & set(one)]


def branches(schema):
    """Returns a schema and all schemas that it combines, from which its keys come."""
    parts = [one for key in ("anyOf", "oneOf", "allOf") for one in schema.get(key, [])]
    return [schema] + [branch for part in parts for branch in branches(part)]


def name_of(reference):
    return reference.rsplit("/", 1)[-1]


def range_of(schema):
    low = schema.get("minimum", schema.get("exclusiveMinimum"))
    high = schema.get("maximum", schema.get("exclusiveMaximum"))
    least = "above " if "exclusiveMinimum" in schema else ""
    if low is None and high is None:
        return ""
    if high is None:
        return f" from {low:g}" if not least else f" above {low:g}"
    return f" to {high:g}" if low is None else f" {least}{low:g} to {high:g}"


def type_of(schema):
    """Describes the values of a schema in a few words."""
    if "/properties/" in schema.get("$ref", ""):
        return f"as {code(name_of(schema['$ref']))} above"
    if "$ref" in schema:
        return f"[{name_of(schema['$ref'])}](#{name_of(schema['$ref']).replace('_', '-')})"
    if "const" in schema:
        return code(schema["const"])
    if "enum" in schema:
        return ", ".join(code(value) for value in schema["enum"])
    if alternatives(schema) and "type" not in schema:
        return " or ".join(dict.fromkeys(type_of(branch) for branch in alternatives(schema)))
    combined = [one for one in schema.get("allOf", []) if TYPED & set(one)]
    if combined and "type" not in schema:
        return type_of(combined[0])
    kind = schema.get("type", "")
    kinds = kind if isinstance(kind, list) else [kind]
    if "array" in kinds:
        items = schema.get("items")
        if isinstance(items, list):
            return "array of " + ", ".join(type_of(item) for item in items)
        counts = {schema.get("minItems"), schema.get("maxItems")}
        size = f"{schema['minItems']} × " if len(counts) == 1 and None not in counts else ""
        return f"array of {size}{type_of(items)}" if items else "array"
    words = {"object": "table", "number": "number", "integer": "whole number", "string": "text",
             "boolean": "true or false", "null": "null", "": "any value"}
    return " or ".join(words[one] for one in kinds) + range_of(schema)


def rows_of(schema, path=""):
    """Yields path, type, meaning and example of each key of a schema, without those of definitions."""
    for branch in branches(schema):
        for name, value in branch.get("properties", {}).items():
            key = f"{path}{name}"
            needed = ", required" if name in branch.get("required", []) else ""
            example = code(value["examples"][0]) if value.get("examples") else ""
            yield code(key), type_of(value) + needed, cell(value.get("description")), example
            yield from rows_below(value, key)
        for value in branch.get("patternProperties", {}).values():
            yield code(path + "…"), type_of(value), cell(value.get("description")), ""
            yield from rows_below(value, path + "…")
        extra = branch.get("additionalProperties")
        if isinstance(extra, dict) and extra:
            yield code(path + "…"), type_of(extra), cell(extra.get("description")), ""
            yield from rows_below(extra, path + "…")


def rows_below(value, key):
    for branch in branches(value):
        if "array" in (branch.get("type") or "") and isinstance(branch.get("items"), dict):
            yield from rows_of(branch["items"], key + "[].")
        else:
            yield from rows_of(branch, key + ".")


def table_of(schema):
    rows = list(dict.fromkeys(rows_of(schema)))
    if not rows:
        return f"| value |\n| --- |\n| {type_of(schema)} |\n"
    lines = ["| key | value | meaning | example |", "| --- | --- | --- | --- |"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def page_of(schema, file):
    """Returns the page of a schema; `file`: its path from the page."""
    parts = [f"# {schema['title']}\n",
             f"The schema is [{file.rsplit('/', 1)[-1]}]({file}). `[]` is each element of a list, `…` any name.\n"]
    if "properties" in schema or "anyOf" in schema:
        parts.append(table_of(schema))
    for name, definition in schema.get("definitions", {}).items():
        parts.append(f"## {name.replace('_', ' ')}\n")
        if definition.get("description"):
            parts.append(f"| meaning |\n| --- |\n| {cell(definition['description'])} |\n")
        parts.append(table_of(definition))
    return "\n".join(parts)
