// SPDX-License-Identifier: GPL-3.0-or-later
//
// node check_formats.mjs <build folder> <work folder> <program or folder>... [--most N]
//     [--only vrml,ply] [--limit <seconds>] [-- <options of ncsim run>...]
//
// Runs ncsim on every program that simulates without faults, writes all formats, and has them read
// by programs that nobody here wrote: OpenCASCADE (STEP), lib3mf, Coin (VRML), admesh (STL, and PLY
// through assimp), the Khronos validator (glTF). Each must find the volume of the report, OpenCASCADE
// that of the solid, and closed surfaces. With --most, N programs evenly spread over all. Prints a line for
// each complaint and a table; exit code 1 if there is any.
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";

const args = process.argv.slice(2);
const split = args.indexOf("--");
const options = split < 0 ? [] : args.splice(split).slice(1);
const mostAt = args.indexOf("--most");
const most = mostAt < 0 ? Infinity : Number(args.splice(mostAt, 2)[1]);
const onlyAt = args.indexOf("--only");
const only = onlyAt < 0 ? null : args.splice(onlyAt, 2)[1].split(",");
const limitAt = args.indexOf("--limit");
const limit = limitAt < 0 ? 60 : Number(args.splice(limitAt, 2)[1]);
const [build, work, ...sources] = args.map((path) => resolve(path));

function programsOf(path) {
  if (!statSync(path).isDirectory()) return [path];
  return readdirSync(path).sort().flatMap((name) => programsOf(join(path, name)));
}
const isProgram = (name) => /\.(nc|ngc|tap|cnc|gcode|txt|mpf|eia|min)$/i.test(name);
let programs = sources.flatMap(programsOf).filter(isProgram);
if (programs.length > most) {
  programs = Array.from({ length: most }, (_, i) => programs[Math.floor((i * programs.length) / most)]);
}

rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
const readable = { vrml: "wrl", ply: "ply", "3mf": "3mf", stl: "stl", step: "step" };
const asked = Object.entries(readable).filter(([option]) => only === null || only.includes(option));
// What the others are compared with is always written.
const formats = { gltf: "glb", report: "json", ...Object.fromEntries(asked) };
const tally = { programs: programs.length, written: 0, "not simulated": 0, "too long": 0, "nothing left": 0 };
const complaints = [];

// The program lines that a face is left of which no simplification takes away: one with a triangle
// that is not thin.
const thin = 2e-4; // mm
function linesOf(glb) {
  const json = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString("utf8"));
  const bin = glb.subarray(28 + glb.readUInt32LE(12));
  const offset = (accessor) => json.bufferViews[accessor.bufferView].byteOffset ?? 0;
  const lines = new Set();
  for (const { attributes, indices } of json.meshes?.[0].primitives ?? []) {
    const [line, position, index] = [attributes._NC_LINE, attributes.POSITION, indices].map((n) => json.accessors[n]);
    const isShort = index.componentType === 5123;
    const corner = (i) =>
      isShort ? bin.readUInt16LE(offset(index) + 2 * i) : bin.readUInt32LE(offset(index) + 4 * i);
    const point = (i) => [0, 1, 2].map((k) => bin.readFloatLE(offset(position) + 12 * corner(i) + 4 * k));
    for (let i = 0; i < index.count; i += 3) {
      const [a, b, c] = [point(i), point(i + 1), point(i + 2)];
      const [ab, ac, bc] = [[a, b], [a, c], [b, c]].map(([p, q]) => q.map((x, k) => x - p[k]));
      const area = Math.hypot(
        ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]);
      const longest = Math.max(...[ab, ac, bc].map((edge) => Math.hypot(...edge)));
      if (area > thin * longest) lines.add(bin.readFloatLE(offset(line) + 4 * corner(i)));
    }
  }
  return [...lines].sort((p, q) => p - q);
}

for (const [i, program] of programs.entries()) {
  const stem = join(work, `${i}_${basename(program).replace(/[^A-Za-z0-9]/g, "_")}`);
  const outputs = Object.entries(formats).flatMap(([option, type]) => [`--${option}`, `${stem}.${type}`]);
  const ran = spawnSync(
    join(build, "ncsim"),
    ["run", program, "-q", "--assume-tool", "flat:D6", ...outputs, ...options],
    { timeout: 1000 * limit, encoding: "utf8" },
  );
  if (ran.error) {
    tally["too long"] += 1;
    complaints.push(`${program}: takes more than ${limit} s`);
    continue;
  }
  if (ran.status === 3 || ran.status === null) complaints.push(`${program}: ncsim ended with ${ran.status ?? ran.signal}`);
  if (ran.status !== 0) {
    if (ran.status === 2) complaints.push(`${program}: ${ran.stderr.trim().split("\n").pop()}`);
    tally["not simulated"] += 1;
    for (const type of Object.values(formats)) rmSync(`${stem}.${type}`, { force: true });
    continue;
  }
  const report = JSON.parse(readFileSync(`${stem}.json`, "utf8"));
  const { faces, shells } = report.part;
  // The solid for CAD has true surfaces, and the volume within these.
  const solid = report.step;
  const moved = solid ? 1e-6 + Math.max(solid.edges_within_mm, solid.facets_within_mm) : 1e-4;
  if (faces === 0) tally["nothing left"] += 1;
  tally.written += 1;
  const lines = linesOf(readFileSync(`${stem}.glb`));
  writeFileSync(
    `${stem}.expect`,
    `volume ${report.volume_mm3.part}\nlines ${lines.join(" ")}\nfaces 0\nsolids ${faces === 0 ? 0 : -shells}\n` +
      `solid ${(solid ?? { volume_mm3: report.volume_mm3.part }).volume_mm3}\nmoved ${moved}\n`,
  );
}

// Readers of a folder or a file; each line on stderr is a complaint.
function read(name, command, ...rest) {
  const ran = spawnSync(command, rest, {
    encoding: "utf8", maxBuffer: 1 << 28, cwd: join(build, "tests/export/gltf"), timeout: 300000,
  });
  if (ran.error && ran.error.code !== "ETIMEDOUT") throw ran.error;
  const told = ran.stderr.split("\n").filter((line) => line.trim() !== "");
  if (ran.error) told.push(`takes more than 5 minutes: ${rest.at(-1)}`);
  if (ran.status !== 0 && told.length === 0) told.push(`fails: ${rest.at(-1)}`);
  complaints.push(...told.map((line) => `${name}: ${line}`));
  tally[`${name} complaints`] = (tally[`${name} complaints`] ?? 0) + told.length;
}
const written = (type) => readdirSync(work).filter((name) => name.endsWith(`.${type}`));
if (tally.written > 0) {
  // One after the other: OpenCASCADE takes long for large ones, and all are to be looked at.
  for (const name of written("step")) read("OpenCASCADE", join(build, "tests/ncsim_read_step"), join(work, name));
  if (formats["3mf"]) read("lib3mf", join(build, "tests/ncsim_read_3mf"), work);
  if (formats.vrml) read("Coin", join(build, "tests/ncsim_read_vrml"), work);
  read("gltf-validator", "node", join(build, "tests/export/gltf/validate.mjs"), work);
}

// Volume of a binary STL file, summed up in doubles, and the number of edges that triangles do not
// pass as often there as back. Surfaces that touch may share edges.
function measureStl(bytes) {
  const count = bytes.readUInt32LE(80);
  const edges = new Map();
  let sixfold = 0;
  let apex = null;
  for (let t = 0; t < count; t += 1) {
    const at = 84 + 50 * t + 12;
    const names = [0, 1, 2].map((i) => bytes.toString("latin1", at + 12 * i, at + 12 * i + 12));
    const points = [0, 1, 2].map((i) => [0, 4, 8].map((k) => bytes.readFloatLE(at + 12 * i + k)));
    apex ??= points[0];
    const [a, b, c] = points.map((p) => p.map((x, k) => x - apex[k]));
    sixfold +=
      a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    for (let i = 0; i < 3; i += 1) {
      const [from, to] = [names[i], names[(i + 1) % 3]];
      const [key, way] = from < to ? [from + to, 1] : [to + from, -1];
      if (from !== to) edges.set(key, (edges.get(key) ?? 0) + way);
    }
  }
  return { volume: sixfold / 6, open: [...edges.values()].filter((net) => net !== 0).length };
}

// admesh may find nothing to repair. assimp hands PLY on in floats, with triangles that these leave no
// area and touching surfaces as one: there only closedness and volume count.
const nothing = ["Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Facets reversed", "Backwards edges"];
for (const kind of ["stl", "ply"].filter((k) => formats[k])) {
  const name = kind === "stl" ? "admesh" : "assimp";
  tally[`${name} complaints`] = 0;
  for (const file of written(kind)) {
    const path = join(work, file);
    const expect = readFileSync(path.replace(/\.\w+$/, ".expect"), "utf8");
    if (/solids 0\n/.test(expect)) continue;
    const expected = Number(/^volume (\S+)/.exec(expect)[1]);
    const stl = kind === "stl" ? path : `${path}.stl_`;
    const bad = [];
    try {
      if (kind === "ply") execFileSync("assimp", ["export", path, stl, "-fstlb"], { stdio: "ignore" });
      const { volume, open } = measureStl(readFileSync(stl));
      if (open > 0) bad.push(`${open} open edges`);
      if (!(Math.abs(volume - expected) <= 1e-5 * expected + 0.01)) bad.push(`volume ${volume}, not ${expected}`);
      if (kind === "stl") {
        const told = execFileSync("admesh", [stl], { encoding: "utf8" });
        bad.push(...nothing.filter((what) => !new RegExp(`${what}\\s*:\\s*0\\s`).test(told)));
        if (!/Total disconnected facets\s*:\s*0\s+0/.test(told)) bad.push("disconnected facets");
      }
    } catch (e) {
      bad.push(`fails: ${e.message}`);
    }
    if (bad.length === 0) continue;
    tally[`${name} complaints`] += 1;
    complaints.push(`${name}: ${file}: ${bad.join(", ")}`);
  }
}

for (const complaint of complaints) console.error(complaint);
for (const [what, count] of Object.entries(tally)) console.log(`${String(count).padStart(6)} ${what}`);
process.exit(complaints.length === 0 ? 0 : 1);
