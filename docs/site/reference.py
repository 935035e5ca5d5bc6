#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the reference pages that are made from the program: docs/reference.

Usage: reference.py NCSIM SOURCE FOLDER

Writes below FOLDER:
  cli.md            commands, options, topics, from `ncsim --help`, `ncsim COMMAND --help`, `ncsim help TOPIC`
  rules.md          all rules, from `ncsim rules --json`
  rules/RULE.md     a rule, with the programs of SOURCE/examples/rules/RULE
  files/NAME.md     a format of files or reports, from docs/schemas/NAME.schema.json
  licences.md       libraries and licences, from `ncsim --version --verbose`, without the versions of this system

Guarantees: the same program and examples give the same bytes.
"""
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../cmake"))
import help_pages  # noqa: E402
import schema_pages  # noqa: E402

MADE = "<!-- Written by docs/site/reference.py from the program. -->\n"


def cell(text):
    return (text or "").replace("|", "\\|").strip()


def code(text):
    return "`" + text + "`" if text else ""


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def block(text, kind="text"):
    return f"```{kind}\n{text.rstrip()}\n```\n"


def option_rows(options):
    for option in options:
        names = ", ".join(code(name) for name in (option.short, option.name) if name)
        yield names, code(option.type), cell(option.text)


def command_section(command):
    parts = [f"## {command.name}\n", command.summary + ".\n"]
    parts.append(block("ncsim " + command.usage))
    for group, options in [("", command.positionals)] + command.groups:
        rows = list(option_rows(options))
        if not rows:
            continue
        if group:
            parts.append(f"### {command.name}: {group}\n")
        parts.append(table((("option" if group else "argument"), "value", "meaning"), rows))
    example = dict(command.footers).get("Example")
    if example:
        parts.append("Example:\n")
        parts.append(block(example))
    return "\n".join(parts)


def cli_page(program):
    top = help_pages.Command("", help_pages.output_of(program, "--help"))
    parts = [MADE + "# Command line\n",
             "`ncsim COMMAND OPTIONS FILES`. `ncsim help COMMAND` prints the options of a command, and "
             "`ncsim help TOPIC`\na topic of the last section.\n",
             table(("command", "task"), [(f"[`{name}`](#{name})", cell(text)) for name, text in top.commands])]
    parts += [table(("option", "value", "meaning"), option_rows(top.options))]
    for name, _ in top.commands:
        parts.append(command_section(help_pages.Command(name, help_pages.output_of(program, name, "--help"))))
    parts.append("## Topics\n")
    for name, _ in top.topics:
        parts.append(f"### Topic: {name}\n")
        parts.append(block(help_pages.output_of(program, "help", name)))
    return "\n".join(parts)


def rule_page(rule, folder):
    parts = [MADE + f"# {rule['id']}\n",
             table(("key", "value"), [
                 ("category", code(rule["category"])), ("severity", rule["severity"]), ("what", cell(rule["what"])),
                 ("why", cell(rule["why"])), ("remedy", cell(rule["fix"])),
                 ("off", code(f"--ignore {rule['id']}") + "; for a block: the comment " +
                  code(f"(ncsim: ignore {rule['id']})")),
                 ("other severity", code(f"--severity {rule['id']}=note"))])]
    names = sorted(os.listdir(folder))
    order = [("A program that fails", "fails.nc"), ("A program that passes", "passes.nc"),
             ("Settings of both", "ncsim.toml"), ("Machine", "machine.toml")]
    for title, name in order:
        if name in names:
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                parts += [f"## {title}\n", block(file.read(), "toml" if name.endswith(".toml") else "gcode")]
    meshes = [name for name in names if name.endswith((".stl", ".obj"))]
    place = f"examples/rules/{rule['id']}"
    files = f"The files are in [{place}](../../../{place})"
    parts.append(files + (f", with {' and '.join(meshes)}.\n" if meshes else ".\n"))
    parts.append(block(f"ncsim check {place}/fails.nc    # {rule['severity']}: {rule['id']}\n"
                       f"ncsim check {place}/passes.nc   # clean"))
    return "\n".join(parts)


def rules_page(rules):
    parts = [MADE + "# Rules\n",
             "The rules of `ncsim check`. Each page has a program that fails and a program that passes.\n"
             "[verification.md](../verification.md) explains verdicts and the reasons for doubt.\n",
             table(("rule", "category", "severity", "finds"),
                   [(f"[{r['id']}](rules/{r['id']}.md)", r["category"], r["severity"], cell(r["what"])) for r in rules])]
    return "\n".join(parts)


def licence_page(program):
    """Returns the table of the libraries: lines of name, version, licence and use in columns."""
    text = help_pages.output_of(program, "--version", "--verbose")
    rows = []
    for line in text.split("\n"):
        if line.startswith("  "):
            name, _, licence, use = (line[start:end].strip() for start, end in ((2, 17), (17, 26), (26, 65), (65, None)))
            rows.append((name, licence, use))
    return "\n".join([
        MADE + "# Licences\n",
        "ncsim is free software: GPL-3.0-or-later, because Boolean operations of CGAL have this licence. The libraries of\n"
        "the sources have the same licence. `ncsim --version --verbose` prints the versions of an installation.\n",
        table(("library", "licence", "use"), rows),
        "- `ncsim-step`, a program of its own, uses OpenCASCADE (LGPL-2.1 with an exception).\n"
        "- The Python package uses pybind11 (BSD-3-Clause) and NumPy (BSD-3-Clause).\n"
        "- `ncsim-mpi` uses the MPI of the system.\n"])


def write(folder, name, text):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main():
    if len(sys.argv) != 4:
        sys.exit("usage: reference.py NCSIM SOURCE FOLDER")
    program, source, folder = (os.path.abspath(word) for word in sys.argv[1:])
    rules = json.loads(help_pages.output_of(program, "rules", "--json"))["rules"]
    write(folder, "cli.md", cli_page(program))
    write(folder, "rules.md", rules_page(rules))
    write(folder, "licences.md", licence_page(program))
    schemas = os.path.join(source, "docs/schemas")
    for name in sorted(os.listdir(schemas)):
        with open(os.path.join(schemas, name), encoding="utf-8") as file:
            page = schema_pages.page_of(json.load(file), f"../../schemas/{name}")
        write(folder, f"files/{name.split('.')[0]}.md", MADE + page)
    for rule in rules:
        write(folder, f"rules/{rule['id']}.md", rule_page(rule, os.path.join(source, "examples/rules", rule["id"])))


if __name__ == "__main__":
    main()
