// SPDX-License-Identifier: GPL-3.0-or-later
//
// three.mjs FILE: reads glTF, STL, PLY, VRML or 3MF with the loader of three.js. The loader of 3MF
// has the DOM of jsdom.
import { readFileSync } from "node:fs";
import { JSDOM } from "jsdom";
import * as THREE from "three";
import { Measure } from "./measure.mjs";

const { window } = new JSDOM();
Object.assign(globalThis, { DOMParser: window.DOMParser, document: window.document, self: globalThis });
const file = process.argv[2], bytes = readFileSync(file);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const text = () => bytes.toString("utf8");
const loader = async (name) => new (await import(`three/addons/loaders/${name}.js`))[name]();
const mesh = (geometry) => new THREE.Mesh(geometry, new THREE.MeshBasicMaterial());

async function read() {
  switch (file.split(".").pop()) {
    case "glb": return (await (await loader("GLTFLoader")).parseAsync(buffer, "")).scene;
    case "stl": return mesh((await loader("STLLoader")).parse(buffer));
    case "ply": return mesh((await loader("PLYLoader")).parse(buffer));
    case "wrl": return (await loader("VRMLLoader")).parse(text(), "");
    default: return new (await import("three/addons/loaders/3MFLoader.js")).ThreeMFLoader().parse(buffer);
  }
}

const scene = await read();
const measure = new Measure();
// glTF is in metres with y up.
const scale = file.endsWith(".glb") ? 1000 : 1;
const place = (v) => (scale === 1 ? [v.x, v.y, v.z] : [scale * v.x, -scale * v.z, scale * v.y]);
scene.updateMatrixWorld(true);
scene.traverse((node) => {
  if (node.name) measure.names.add(node.name);
  if (!node.isMesh) return;
  const position = node.geometry.attributes.position, index = node.geometry.index;
  const corner = (i) => place(new THREE.Vector3().fromBufferAttribute(position, index ? index.getX(i) : i).applyMatrix4(node.matrixWorld));
  const count = index ? index.count : position.count;
  for (let i = 0; i + 2 < count; i += 3) measure.triangle(corner(i), corner(i + 1), corner(i + 2));
  for (const material of [node.material].flat()) {
    if (material.color) measure.colours.add("#" + material.color.getHexString());
    if (material.name) measure.names.add(material.name);
  }
  const colours = node.geometry.attributes.color;
  for (let i = 0; colours && i < colours.count; ++i) {
    measure.colours.add("#" + new THREE.Color().fromBufferAttribute(colours, i).getHexString());
  }
  for (const [name, values] of Object.entries(node.geometry.attributes)) {
    if (!/line/i.test(name)) continue;
    for (const line of new Set(values.array)) measure.names.add(`${name}=${line}`);
  }
});
measure.print(THREE.REVISION);
