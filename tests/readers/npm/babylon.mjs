// SPDX-License-Identifier: GPL-3.0-or-later
//
// babylon.mjs FILE: reads glTF or STL with Babylon.js, without a display.
import { readFileSync } from "node:fs";
import { AbstractEngine, LoadAssetContainerAsync, NullEngine, Scene, Vector3 } from "@babylonjs/core";
import "@babylonjs/loaders/glTF/index.js";
import "@babylonjs/loaders/STL/index.js";
import { hex, Measure, srgb } from "./measure.mjs";

const file = process.argv[2], ending = "." + file.split(".").pop();
const scene = new Scene(new NullEngine());
scene.useRightHandedSystem = true;
const data = "data:application/octet-stream;base64," + readFileSync(file).toString("base64");
const container = await LoadAssetContainerAsync(data, scene, { pluginExtension: ending });
container.addAllToScene();
const measure = new Measure();
const place = (p) => (ending === ".glb" ? [1000 * p.x, -1000 * p.z, 1000 * p.y] : [p.x, p.z, p.y]);
for (const mesh of scene.meshes) {
  if (mesh.name) measure.names.add(mesh.name);
  const positions = mesh.getVerticesData("position"), indices = mesh.getIndices();
  if (!positions) continue;
  const world = mesh.computeWorldMatrix(true);
  const corner = (i) => place(Vector3.TransformCoordinates(Vector3.FromArray(positions, 3 * i), world));
  for (let i = 0; i + 2 < indices.length; i += 3) {
    measure.triangle(corner(indices[i]), corner(indices[i + 1]), corner(indices[i + 2]));
  }
  const colour = mesh.material?.albedoColor;
  if (colour) measure.colours.add(hex([colour.r, colour.g, colour.b].map(srgb)));
  if (mesh.material?.name) measure.names.add(mesh.material.name);
  for (const kind of mesh.getVerticesDataKinds()) {
    if (!/line/i.test(kind)) continue;
    for (const line of new Set(mesh.getVerticesData(kind))) measure.names.add(`${kind}=${line}`);
  }
}
measure.print(AbstractEngine.Version);
process.exit(0);
