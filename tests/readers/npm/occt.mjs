// SPDX-License-Identifier: GPL-3.0-or-later
//
// occt.mjs FILE: reads STEP with occt-import-js, OpenCASCADE in WebAssembly.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { hex, Measure, srgb } from "./measure.mjs";

const require = createRequire(import.meta.url);
const occt = await require("occt-import-js")();
const read = occt.ReadStepFile(readFileSync(process.argv[2]), {
  linearUnit: "millimeter", linearDeflectionType: "absolute_value", linearDeflection: 0.001, angularDeflection: 0.01,
});
if (!read.success) throw new Error("cannot be read");
const measure = new Measure();
for (const mesh of read.meshes) {
  if (mesh.name) measure.names.add(mesh.name);
  const p = mesh.attributes.position.array, at = (i) => [p[3 * i], p[3 * i + 1], p[3 * i + 2]];
  const index = mesh.index.array;
  for (let i = 0; i + 2 < index.length; i += 3) measure.triangle(at(index[i]), at(index[i + 1]), at(index[i + 2]));
  for (const { color } of [mesh, ...mesh.brep_faces]) {
    if (color) measure.colours.add(hex(color.map(srgb))); // colours are linear
  }
}
measure.print(require("occt-import-js/package.json").version);
