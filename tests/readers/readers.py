#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens files of ncsim in other programs, and compares what these find with what ncsim reports.

Usage: readers.py NCSIM FOLDER [--nightly] [--write PAGE]

FOLDER receives a Debian 12 by debootstrap with packages of fixed versions, and packages of npm; both are kept for the
next run. Needs root, debootstrap, Node.js with npm, and access to both registries. --nightly includes large programs,
and x_ite, which needs /usr/bin/chromium.
--write replaces the table between the marks of PAGE, docs/files.md. Exit code 1: a program finds something else than
EXPECTED says. The run is no part of the tests, because registries change.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
LIGHT = {"freecad-python3": "0.20.2+dfsg1-4+deb12u1", "gmsh": "4.8.4+ds2-3", "openscad": "2021.01-6",
         "openctm-tools": "1.0.3+dfsg1-2.1+b3", "assimp-utils": "5.2.5~ds0-1+b1", "python3-ezdxf": "0.18.1-1",
         "librecad": "2.2.0-1", "admesh": "0.98.4-2", "xvfb": None, "xauth": None}
LARGE = {"prusa-slicer": "2.5.0+dfsg-4", "inkscape": "1.2.2-2+deb12u1", "meshlab": "2020.09+dfsg1-2",
         "blender": "3.4.1+dfsg-2+b1"}
SAME_VOLUME = 1e-5  # of a mesh or a solid, relative
SAME_AREA = 2e-3    # of a section in chords of OpenSCAD, relative
SAME_LENGTH = 1e-3  # mm
SAME_COLOUR = 1     # of 255
BEGIN, END = "<!-- tests/readers/readers.py begins -->", "<!-- tests/readers/readers.py ends -->"


class Workshop:
    """A Debian and packages of npm, with the files of ncsim in the folder `files`."""

    def __init__(self, folder, packages):
        self.root, self.npm = os.path.join(folder, "debian"), os.path.join(folder, "npm")
        self.versions = {}
        if not os.path.exists(os.path.join(self.root, "etc/debian_version")):
            run(["debootstrap", "--variant=minbase", "bookworm", self.root])
        # With the updates that this machine gets: some of the versions are updates.
        shutil.copytree("/etc/apt/sources.list.d", os.path.join(self.root, "etc/apt/sources.list.d"), dirs_exist_ok=True)
        if os.path.exists("/etc/apt/sources.list"):
            shutil.copy("/etc/apt/sources.list", os.path.join(self.root, "etc/apt/sources.list"))
        missing = [name for name in packages if not self.version(name)]
        if missing:
            self.chroot("apt-get update -q")
            words = " ".join(name + (f"={packages[name]}" if packages[name] else "") for name in missing)
            self.chroot("DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends " + words)
        shutil.copytree(os.path.join(HERE, "npm"), self.npm, dirs_exist_ok=True)
        run(["npm", "ci", "--no-audit", "--no-fund"], cwd=self.npm)
        self.files = os.path.join(self.root, "files")
        shutil.rmtree(self.files, ignore_errors=True)
        shutil.copytree(os.path.join(HERE, "debian"), self.files)

    def version(self, package):
        if package not in self.versions:
            said = self.chroot("dpkg-query -W -f '${Status} ${Version}' " + package + " || true", quiet=True)
            match = re.search(r"installed (\S+)$", said)
            self.versions[package] = match[1] if match else ""
        return self.versions[package]

    def chroot(self, command, quiet=False):
        # The mount of /proc ends with the command.
        return run(["unshare", "--mount", "sh", "-c", 'mount -t proc proc "$0/proc" && exec chroot "$0" sh -c "$1"', self.root,
                    "mkdir -p /files && cd /files && " + command], quiet=quiet)

    def result(self, command, file):
        """Runs a script in the Debian that writes FILE.json, and returns its content."""
        path = os.path.join(self.files, file + ".json")
        if os.path.exists(path):
            os.remove(path)
        self.chroot(f"export FILE={file} QTWEBENGINE_DISABLE_SANDBOX=1 QT_X11_NO_MITSHM=1; {command} >{file}.log 2>&1 </dev/null || true")
        with open(path, encoding="utf-8") as read:
            return json.load(read)

    def node(self, script, file):
        said = run(["node", os.path.join(self.npm, script), os.path.join(self.files, file)], cwd=self.npm)
        return json.loads(re.search(r"^RESULT (.*)$", said, re.M)[1])

    def stl(self, command, file="read.stl"):
        """Runs a command in the Debian that writes an STL file; returns its volume and box, by admesh."""
        self.chroot(f"rm -f {file}; {command}")
        said = self.chroot(f"admesh {file}")
        box = [[float(x) for x in re.search(rf"Min {axis} = *(\S+), Max {axis} = *(\S+)", said).groups()] for axis in "XYZ"]
        return {"volume": float(re.search(r"Volume *: *(\S+)", said)[1]), "min": [low for low, _ in box],
                "size": [high - low for low, high in box]}


def run(words, cwd=None, quiet=False):
    ran = subprocess.run(words, cwd=cwd, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         encoding="utf-8", errors="replace", timeout=3000, check=False)
    if ran.returncode != 0 and not quiet:
        raise RuntimeError(f"{' '.join(words)[:200]}: {ran.returncode}\n{ran.stdout[-1500:]}")
    return ran.stdout


def gmsh(shop, _):
    said = shop.chroot("gmsh -0 read_gmsh.geo")
    box = [float(x) for x in re.search(r"^box (.*)$", said, re.M)[1].split()]
    linear = {tuple(float(x) for x in found.split(",")) for found in re.findall(r"Color \(([^)]*)\)", said)}
    return {"volume": float(re.search(r"^volume (\S+)$", said, re.M)[1]), "min": box[:3],
            "size": [b - a for a, b in zip(box, box[3:])], "colours": sorted(map(from_linear, linear)),
            "names": re.findall(r"Label 'Shapes/([^']*)'", shop.chroot("gmsh -0 pieces.step"))}


def from_linear(colour):
    shares = [12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055 for x in colour]
    return "#" + "".join(f"{round(255 * x):02x}" for x in shares)


def freecad_step(shop, file):
    headless = shop.result("freecadcmd read_freecad.py", file)
    found = shop.result("gui=1 timeout 100 xvfb-run -a freecad read_freecad.py", file)
    found["volume"] = headless["volume"]
    found["names"] = shop.result("gui=1 timeout 100 xvfb-run -a freecad read_freecad.py", "pieces.step")["names"]
    return found


def openscad(shop, file):
    flat = file.endswith((".dxf", ".svg"))
    scad = f'linear_extrude(1) import("{file}");' if flat else f'import("{file}");'
    return shop.stl(f"echo '{scad}' >read.scad && openscad -q -o read.stl read.scad")


def prusa(shop, file):
    said = shop.chroot(f"prusa-slicer --info {file}")
    value = lambda name: float(re.search(rf"^{name} = +(\S+)$", said, re.M)[1])
    return {"volume": value("volume"), "min": [value(f"min_{x}") for x in "xyz"], "size": [value(f"size_{x}") for x in "xyz"]}


def inkscape(shop, file):
    """The box of the filled paths in mm; the colours of the picture."""
    said = shop.chroot(f"inkscape --query-all {file} 2>/dev/null")
    boxes = [[float(x) * 25.4 / 96 for x in line.split(",")[1:]] for line in said.split("\n") if line.startswith("path")]
    low = [min(box[i] for box in boxes) for i in (0, 1)]
    high = [max(box[i] + box[i + 2] for box in boxes) for i in (0, 1)]
    shop.chroot(f"inkscape {file} --export-type=png --export-dpi=300 -o picture.png 2>/dev/null")
    return {"size": [high[0] - low[0], high[1] - low[1], 0.0], "colours": colours_of_png(os.path.join(shop.files, "picture.png"))}


def colours_of_png(path):
    """Frequent colours of a picture with 8 bits per channel, on white paper."""
    with open(path, "rb") as file:
        data = file.read()
    width, height, kind = int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big"), data[25]
    packed, at = b"", 8
    while at < len(data):
        size, name = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        packed += data[at + 8:at + 8 + size] if name == b"IDAT" else b""
        at += size + 12
    raw, step, line, count = zlib.decompress(packed), {2: 3, 6: 4}[kind], b"", {}
    for y in range(height):
        begin = y * (width * step + 1)
        line = unfiltered(raw[begin], bytearray(raw[begin + 1:begin + 1 + width * step]), line or bytes(width * step), step)
        for x in range(0, len(line), step):
            if step == 3 or line[x + 3] == 255:
                colour = bytes(line[x:x + 3]).hex()
                count[colour] = count.get(colour, 0) + 1
    return sorted("#" + colour for colour, n in count.items() if n > 300)


def unfiltered(kind, line, above, step):
    for i, value in enumerate(line):
        left, up, corner = (line[i - step] if i >= step else 0), above[i], (above[i - step] if i >= step else 0)
        nearest = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))[2]
        line[i] = (value + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
    return line


def librecad(shop, file):
    """Colours of the strokes of the PDF that LibreCAD prints."""
    shop.chroot(f"rm -f part.pdf; QT_QPA_PLATFORM=offscreen librecad dxf2pdf {file}")
    with open(os.path.join(shop.files, "part.pdf"), "rb") as read:
        streams = re.findall(rb"stream\r?\n(.*?)endstream", read.read(), re.S)
    drawn = b"".join(zlib.decompressobj().decompress(stream) for stream in streams if stream[:1] == b"x")
    strokes = len(re.findall(rb"(?:^|\s)S(?=\s)", drawn))
    if strokes < 5:
        raise RuntimeError(f"{strokes} strokes")
    return {"names": [f"{strokes} strokes"]}


def gltfpack(shop, file):
    """The packed file, read by three.js."""
    packed = os.path.join(shop.files, "packed.glb")
    run(["node", os.path.join(shop.npm, "node_modules/gltfpack/cli.js"), "-i", os.path.join(shop.files, file), "-o", packed,
         "-noq", "-kn", "-km", "-ke", "-kv"])
    return shop.node("three.mjs", "packed.glb")


def validator(shop, file):
    said = run(["node", "-e", "require('gltf-validator').validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[1])))"
                              ".then(r => console.log(JSON.stringify(r.issues)))", os.path.join(shop.files, file)], cwd=shop.npm)
    issues = json.loads(said[said.index("{"):])
    if issues["numErrors"] or issues["numWarnings"]:
        raise RuntimeError(said)
    return {}


def occt(shop, file):
    found = shop.node("occt.mjs", file)
    found["names"] = shop.node("occt.mjs", "pieces.step")["names"]
    return found


def script(name):
    return lambda shop, file: shop.node(name, file)


def freecad(shop, file):
    return shop.result("freecadcmd read_freecad.py", file)


def blender(shop, file):
    return shop.result("timeout 200 blender -b --factory-startup --python read_blender.py", file)


def assimp(shop, file):
    return shop.stl(f"assimp export {file} read.stl >/dev/null")


def openctm(shop, file):
    return shop.stl(f"ctmconv {file} read.stl >/dev/null")


def meshlab(shop, file):
    return shop.stl(f"QT_X11_NO_MITSHM=1 timeout 100 xvfb-run -a meshlabserver -i {file} -o read.stl >/dev/null 2>&1")


def ezdxf(shop, file):
    return shop.result(f"python3 read_ezdxf.py {file}", file)


# Program, package (of npm: with a /), format, reader, and what it is expected to find: size, colours, names or lines
# of the program. "–" is absent: the program has no such thing, or does not say. "no" is lost.
READERS = [
    ("gltf-validator", "npm/gltf-validator", "glb", validator, "–", "–", "–"),
    ("three.js", "npm/three", "glb", script("three.mjs"), "yes", "yes", "lines"),
    ("three.js after gltfpack", "npm/gltfpack", "glb", gltfpack, "yes", "yes", "names"),
    ("Babylon.js", "npm/@babylonjs/core", "glb", script("babylon.mjs"), "yes", "yes", "names"),
    ("Blender", "blender", "glb", blender, "yes", "yes", "names"),
    ("FreeCAD", "freecad-python3", "step", freecad_step, "yes", "yes", "names"),
    ("gmsh", "gmsh", "step", gmsh, "yes", "yes", "names"),
    ("occt-import-js", "npm/occt-import-js", "step", occt, "yes", "yes", "names"),
    ("three.js", "npm/three", "3mf", script("three.mjs"), "yes", "yes", "names"),
    ("OpenSCAD", "openscad", "3mf", openscad, "yes", "–", "–"),
    ("PrusaSlicer", "prusa-slicer", "3mf", prusa, "yes", "–", "–"),
    ("three.js", "npm/three", "stl", script("three.mjs"), "yes", "–", "–"),
    ("Babylon.js", "npm/@babylonjs/core", "stl", script("babylon.mjs"), "yes", "–", "–"),
    ("FreeCAD", "freecad-python3", "stl", freecad, "yes", "–", "–"),
    ("OpenSCAD", "openscad", "stl", openscad, "yes", "–", "–"),
    ("PrusaSlicer", "prusa-slicer", "stl", prusa, "yes", "–", "–"),
    ("Blender", "blender", "stl", blender, "yes", "–", "–"),
    ("three.js", "npm/three", "ply", script("three.mjs"), "yes", "yes", "–"),
    ("FreeCAD", "freecad-python3", "ply", freecad, "yes", "–", "–"),
    ("openctm", "openctm-tools", "ply", openctm, "yes", "–", "–"),
    ("assimp", "assimp-utils", "ply", assimp, "yes", "–", "–"),
    ("MeshLab", "meshlab", "ply", meshlab, "yes", "–", "–"),
    ("Blender", "blender", "ply", blender, "yes", "–", "–"),
    ("three.js", "npm/three", "wrl", script("three.mjs"), "yes", "yes", "names"),
    ("x_ite", "npm/x_ite", "wrl", script("x_ite.mjs"), "yes", "yes", "names"),
    ("ezdxf", "python3-ezdxf", "dxf", ezdxf, "yes", "–", "names"),
    ("FreeCAD", "freecad-python3", "dxf", freecad, "yes", "–", "names"),
    ("OpenSCAD", "openscad", "dxf", openscad, "yes", "–", "–"),
    ("LibreCAD", "librecad", "dxf", librecad, "–", "–", "–"),
    ("Inkscape", "inkscape", "svg", inkscape, "yes", "yes", "–"),
    ("OpenSCAD", "openscad", "svg", openscad, "yes", "–", "–"),
]
FORMATS = {"glb": "glTF", "step": "STEP", "3mf": "3MF", "stl": "STL", "ply": "PLY", "wrl": "VRML", "dxf": "DXF", "svg": "SVG"}
COLOURS = ["#7eb6e2", "#969ca4", "#f0ac62"]  # T1, stock, T2
NAMES = {"glb": ["T1", "T2", "stock"], "3mf": ["T1", "T2", "stock"], "wrl": ["LINE_9", "LINE_15", "STOCK"],
         "dxf": ["STOCK", "T1", "T2"], "step": ["SOLID_1", "SOLID_2"]}
LINES = {9, 15}


def write_files(ncsim, folder):
    """Writes all formats; returns the volumes of the mesh and the solid, and the area of the sections."""
    for name in ("part.nc", "pieces.nc"):
        shutil.copy(os.path.join(HERE, name), folder)
    words = [ncsim, "run", "part.nc", "-q", "--report", "report.json", "--section", "z=-3", "--section", "y=12"]
    for option, ending in (("gltf", "glb"), ("step", "step"), ("3mf", "3mf"), ("stl", "stl"), ("ply", "ply"), ("vrml", "wrl"),
                           ("dxf", "dxf"), ("svg", "svg")):
        words += ["--" + option, "part." + ending]
    run(words, cwd=folder)
    run([ncsim, "run", "pieces.nc", "-q", "--step", "pieces.step"], cwd=folder)
    run([ncsim, "measure", "part.nc", "-q", "--json", "measured.json"], cwd=folder)
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
        report = json.load(file)
    with open(os.path.join(folder, "measured.json"), encoding="utf-8") as file:
        solid = json.load(file)["volume_mm3"]
    return report["volume_mm3"]["part"], solid, sum(section["area_mm2"] for section in report["sections"])


def near(found, wanted, limit):
    return all(abs(a - b) <= limit for a, b in zip(found, wanted))


def size_of(found, ending, volumes):
    """yes, no, or – if the program states none of it."""
    if "size" not in found and "volume" not in found:
        return "–"
    is_flat = ending in ("dxf", "svg")
    wanted = volumes[2] if is_flat else volumes[1] if ending == "step" else volumes[0]
    size = [140.0, 62.0] if is_flat else [60.0, 50.0, 12.0]
    low = [0.0, 0.0, -12.0] if not is_flat else [0.0, -12.0] if ending == "dxf" else [5.0, 12.0]
    good = near(found["size"], size, SAME_LENGTH)
    if "min" in found:
        good = good and near(found["min"], low, SAME_LENGTH)
    if "volume" in found:
        good = good and abs(found["volume"] - wanted) <= (SAME_AREA if is_flat else SAME_VOLUME) * wanted
    return "yes" if good else "no"


def colours_of(found):
    if not found.get("colours") or found["colours"] == ["#ffffff"]:
        return "–"
    parts = [[int(c[i:i + 2], 16) for i in (1, 3, 5)] for c in found["colours"]]
    has = lambda colour: any(near([int(colour[i:i + 2], 16) for i in (1, 3, 5)], part, SAME_COLOUR) for part in parts)
    return "yes" if all(map(has, COLOURS)) else "no"


def names_of(found, ending):
    names = set(found.get("names", []))
    lines = {float(name.split("=")[1]) for name in names if re.match(r"_nc_line=", name, re.I)}
    if LINES <= lines or "_NC_LINE" in names:
        return "lines"
    wanted = NAMES.get(ending, [])
    return "names" if wanted and all(any(n.endswith(w) for n in names) for w in wanted) else "–"


def version_of(shop, package):
    if package.startswith("npm/"):
        with open(os.path.join(shop.npm, "node_modules", package[4:], "package.json"), encoding="utf-8") as file:
            return json.load(file)["version"]
    return shop.version(package)


def main():
    arguments = [word for word in sys.argv[1:] if not word.startswith("--")]
    is_nightly, page = "--nightly" in sys.argv, arguments[2] if "--write" in sys.argv else None
    shop = Workshop(os.path.abspath(arguments[1]), LIGHT | (LARGE if is_nightly else {}))
    volumes = write_files(os.path.abspath(arguments[0]), shop.files)
    rows, faults = [], 0
    for program, package, ending, reader, *expected in READERS:
        if (package in LARGE or program == "x_ite") and not is_nightly:
            continue
        try:
            found = reader(shop, "part." + ending)
            got = ["yes", size_of(found, ending, volumes), colours_of(found), names_of(found, ending)]
        except (RuntimeError, OSError, ValueError, KeyError, TypeError, AttributeError) as fault:
            found, got = {"fault": str(fault)}, ["no", "–", "–", "–"]
        rows.append(f"| {FORMATS[ending]} | {program} | {version_of(shop, package)} | {' | '.join(got)} |")
        print(rows[-1], flush=True)
        if got != ["yes", *expected]:
            faults += 1
            print(f"expected {expected}, found {json.dumps(found)[:1500]}")
    table = "\n".join(["| format | program | version | opens | size and place | colours | attributes |", "|" + " --- |" * 7] + rows)
    if page:
        with open(page, encoding="utf-8") as file:
            text = file.read()
        head, tail = text[:text.index(BEGIN)], text[text.index(END):]
        with open(page, "w", encoding="utf-8") as file:
            file.write(f"{head}{BEGIN}\n\n{table}\n\n{tail}")
    print(f"{len(rows)} rows, {faults} not as expected")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
