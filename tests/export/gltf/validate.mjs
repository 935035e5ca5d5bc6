// SPDX-License-Identifier: GPL-3.0-or-later
//
// node validate.mjs <folder>: every .glb in the folder passes the validator of the Khronos Group
// without errors and warnings, encloses the volume that the .expect file beside it names, and
// carries its program lines.
import { readFileSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";
import validator from "gltf-validator";

const folder = process.argv[2];
let failures = 0;
function expect(condition, file, message) {
  if (condition) return;
  console.error(`${file}: ${message}`);
  failures += 1;
}

// "volume 123.5\nlines 0 10 20\n" → { volume: [123.5], lines: [0, 10, 20] }
function readExpectation(path) {
  const rows = readFileSync(path, "utf8").trim().split("\n").map((row) => row.split(" "));
  return Object.fromEntries(rows.map(([key, ...values]) => [key, values.map(Number)]));
}

function parseGlb(bytes) {
  const jsonLength = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.subarray(20, 20 + jsonLength).toString("utf8"));
  return { json, bin: bytes.subarray(28 + jsonLength) };
}

function readAccessor({ json, bin }, index) {
  const accessor = json.accessors[index];
  const view = json.bufferViews[accessor.bufferView];
  const width = { SCALAR: 1, VEC3: 3 }[accessor.type];
  const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const isFloat = accessor.componentType === 5126;
  const isShort = accessor.componentType === 5123;
  const values = [];
  for (let i = 0; i < accessor.count * width; i += 1) {
    const at = start + (isShort ? 2 : 4) * i;
    values.push(isFloat ? bin.readFloatLE(at) : isShort ? bin.readUInt16LE(at) : bin.readUInt32LE(at));
  }
  return values;
}

// Volume in mm³, from the triangles, and the set of lines on the vertices.
function measure(glb) {
  let sixfold = 0;
  const lines = new Set();
  const primitives = glb.json.meshes?.[0].primitives ?? [];
  for (const primitive of primitives) {
    const p = readAccessor(glb, primitive.attributes.POSITION);
    for (const line of readAccessor(glb, primitive.attributes._NC_LINE)) lines.add(line);
    const corners = readAccessor(glb, primitive.indices).map((i) => p.slice(3 * i, 3 * i + 3));
    for (let t = 0; t < corners.length; t += 3) {
      const [a, b, c] = corners.slice(t, t + 3);
      sixfold +=
        a[0] * (b[1] * c[2] - b[2] * c[1]) +
        a[1] * (b[2] * c[0] - b[0] * c[2]) +
        a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return { volume: sixfold / 6, lines: [...lines].sort((a, b) => a - b) };
}

const files = readdirSync(folder).filter((name) => name.endsWith(".glb"));
expect(files.length > 0, folder, "no .glb files");
for (const file of files) {
  const bytes = readFileSync(join(folder, file));
  const report = await validator.validateBytes(new Uint8Array(bytes));
  const { numErrors, numWarnings } = report.issues;
  expect(numErrors + numWarnings === 0, file, JSON.stringify(report.issues, null, 2));

  const expected = readExpectation(join(folder, `${basename(file, ".glb")}.expect`));
  const { volume, lines } = measure(parseGlb(bytes));
  const [wanted] = expected.volume;
  expect(Math.abs(volume - wanted) <= 1e-5 * wanted, file, `volume ${volume}, not ${wanted}`);
  const missing = expected.lines.filter((line) => !lines.includes(line));
  expect(missing.length === 0, file, `lines ${missing} are missing`);
  // Where other formats are simplified, lines of thin faces only are not told.
  if (!expected.moved) expect(lines.length === expected.lines.length, file, `lines ${lines}, not ${expected.lines}`);
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${volume} mm³`);
}
process.exit(failures === 0 ? 0 : 1);
