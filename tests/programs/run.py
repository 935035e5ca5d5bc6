#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares every stage of small programs with files: tests/programs/run.py NCSIM [--update] [NAME …].

A folder has a program, its options (a line each), subprograms if any, and what each stage makes of the program:

  blocks.txt    ncsim parse: the blocks in one spelling
  motions.txt   ncsim parse --canonical: motions in mm and degrees
  cut.txt       ncsim run: number of hulls, volumes, and what each line removes
  solid.txt     ncsim run --step: faces by kind of surface, edges by kind of curve
  findings.txt  ncsim check: exit code and text, without the rules that were not asked
  picture.png   ncsim run --png

A stage that a program does not reach has no file. --update writes the files: read the difference
before it is committed. Exit code 1 at a difference.
"""

import concurrent.futures
import difflib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
SURFACES = ("PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "SPHERICAL_SURFACE",
            "TOROIDAL_SURFACE", "B_SPLINE_SURFACE", "SURFACE_OF_LINEAR_EXTRUSION")
CURVES = ("LINE", "CIRCLE", "ELLIPSE", "B_SPLINE_CURVE")


def call(ncsim, folder, *arguments):
    """Returns exit code, standard output and standard error of a command."""
    ran = subprocess.run([ncsim, *arguments], cwd=folder, capture_output=True, timeout=120,
                         env={**os.environ, "NO_COLOR": "1"}, check=False)
    return ran.returncode, ran.stdout.decode(), ran.stderr.decode()


def reading_options(options):
    """Returns the options that `ncsim parse` has, too."""
    known = ("--dialect", "--block-delete", "--start", "--tool", "--units")
    pairs = zip(options[::2], options[1::2], strict=True)
    return [word for pair in pairs if pair[0] in known for word in pair]


def cut_text(report):
    """Writes the volumes of a run report, mm³."""
    volume = report["volume_mm3"]
    lines = [f"hulls {report['model']['hulls']}", f"stock {volume['stock']:.9g}",
             f"part {volume['part']:.9g}"]
    lines += [f"T{tool['number']} {tool['removed_mm3']:.9g}" for tool in report["tools"]]
    for block in report.get("blocks", []):
        file = f"@{block['file']}" if "file" in block else ""
        lines.append(f"L{block['line']}{file} {block['removed_mm3']:.9g}")
    return "\n".join(lines) + "\n"


def solid_text(step):
    """Counts the faces of a STEP file by surface, and the edges by curve."""
    entities = dict(re.findall(r"#(\d+)=([^;]*);", step))

    def kind(number, kinds):
        text = entities[number]
        basis = re.match(r"SURFACE_CURVE\('[^']*',#(\d+)", text)
        if basis:
            return kind(basis.group(1), kinds)
        return next((name for name in kinds if name in text), text.split("(")[0])

    counts = {}
    for text in entities.values():
        face = re.match(r"ADVANCED_FACE\(.*,#(\d+),\.[TF]\.\)$", text)
        edge = re.match(r"EDGE_CURVE\('[^']*',#\d+,#\d+,#(\d+),", text)
        name = kind(face.group(1), SURFACES) if face else kind(edge.group(1), CURVES) if edge else ""
        if name:
            key = ("face " if face else "edge ") + name
            counts[key] = counts.get(key, 0) + 1
    solids = sum(text.startswith("MANIFOLD_SOLID_BREP") for text in entities.values())
    return "".join(f"{name} {count}\n" for name, count in
                   [("solids", solids), *sorted(counts.items())])


def stages(ncsim, folder):
    """Runs a program; returns the contents of the files by name."""
    program = next(folder.glob("program.*")).name
    options = (folder / "options").read_text().split("\n")[:-1] if (folder / "options").exists() else []
    result = {}
    for name, extra in (("blocks.txt", []), ("motions.txt", ["--canonical"])):
        code, out, err = call(ncsim, folder, "parse", program, "--no-project", *extra,
                              *reading_options(options))
        result[name] = out + err + f"exit {code}\n"
    with tempfile.TemporaryDirectory() as made:
        made = pathlib.Path(made)
        code, _, err = call(ncsim, folder, "run", program, "--no-project", "-q", *options,
                            "--step", str(made / "s.step"), "--report", str(made / "r.json"),
                            "--block-volumes", "--png", str(made / "p.png"), "--size", "320x240")
        if code == 0:
            result["cut.txt"] = cut_text(json.loads((made / "r.json").read_text()))
            result["solid.txt"] = solid_text((made / "s.step").read_text())
            result["picture.png"] = (made / "p.png").read_bytes()
        else:
            result["cut.txt"] = f"{err}exit {code}\n"
    code, out, err = call(ncsim, folder, "check", program, "--no-project", *options)
    asked = [line for line in (out + err).splitlines(True) if not line.startswith("  skipped ")]
    result["findings.txt"] = "".join(asked) + f"exit {code}\n"
    return result


def difference(path, new):
    """Returns how a file differs from its new contents, as text."""
    if not path.exists():
        return f"{path}: is missing\n"
    if isinstance(new, bytes):
        return "" if path.read_bytes() == new else f"{path}: the picture differs\n"
    old = path.read_text()
    return "".join(difflib.unified_diff(old.splitlines(True), new.splitlines(True), str(path),
                                        "now"))


def main():
    """Returns the exit code."""
    ncsim = str(pathlib.Path(sys.argv[1]).resolve())
    update = "--update" in sys.argv
    names = [word for word in sys.argv[2:] if word != "--update"]
    folders = [HERE / name for name in names] or sorted(f for f in HERE.iterdir() if f.is_dir())
    faults = []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for folder, made in zip(folders, pool.map(lambda f: stages(ncsim, f), folders), strict=True):
            unknown = {f.name for f in folder.iterdir()} - set(made) - {"options"}
            stale = [f for f in sorted(unknown) if f.endswith((".txt", ".png"))]
            for name, new in made.items():
                if update:
                    write = (folder / name).write_bytes
                    write(new if isinstance(new, bytes) else new.encode())
                else:
                    faults.append(difference(folder / name, new))
            for name in stale:
                if update:
                    (folder / name).unlink()
                else:
                    faults.append(f"{folder / name}: no stage makes this file\n")
    print("".join(faults), end="")
    print(f"{len(folders)} programs, {sum(map(bool, faults))} differences")
    return 1 if any(faults) else 0


if __name__ == "__main__":
    sys.exit(main())
