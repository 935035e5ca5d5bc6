// SPDX-License-Identifier: GPL-3.0-or-later
//
// x_ite.mjs FILE: reads VRML with x_ite in Chromium without a window. The page takes the nodes from
// the scene; polygons are fans, because ncsim writes convex ones.
import { createReadStream, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { chromium } from "playwright-core";
import { hex, Measure } from "./measure.mjs";

const PAGE = `<!doctype html><script src="/node_modules/x_ite/dist/x_ite.min.js"></script><x3d-canvas></x3d-canvas>`;

const server = createServer((request, answer) => {
  if (request.url === "/") answer.setHeader("Content-Type", "text/html").end(PAGE);
  else if (request.url === "/part.wrl") answer.setHeader("Content-Type", "model/vrml").end(readFileSync(process.argv[2]));
  else {
    if (request.url.endsWith("js")) answer.setHeader("Content-Type", "text/javascript");
    createReadStream("." + request.url.split("?")[0]).on("error", () => answer.writeHead(404).end()).pipe(answer);
  }
});
await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: [
  "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic",
  "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"] });
const page = await browser.newPage();
await page.goto(`http://127.0.0.1:${server.address().port}/`);
const { version, names, colours, polygons } = await page.evaluate(async () => {
  /* global X3D */
  await X3D();
  const view = X3D.getBrowser(document.querySelector("x3d-canvas"));
  await view.loadURL(new X3D.MFString("/part.wrl"));
  const found = { version: view.version, names: [], colours: [], polygons: [] };
  const walk = (node) => {
    if (!node) return;
    if (node.getNodeName()) found.names.push(node.getNodeName());
    if (node.getNodeTypeName() === "Shape") {
      const { r, g, b } = node.appearance.material.diffuseColor;
      found.colours.push([r, g, b]);
      const points = [...node.geometry.coord.point].map((p) => [p.x, p.y, p.z]);
      let polygon = [];
      for (const index of node.geometry.coordIndex) {
        if (index >= 0) polygon.push(points[index]);
        else found.polygons.push(polygon.splice(0));
      }
    }
    for (const child of node.children ?? []) walk(child);
  };
  for (const node of view.currentScene.rootNodes) walk(node);
  return found;
});
await browser.close();
server.close();
const measure = new Measure();
names.forEach((name) => measure.names.add(name));
colours.forEach((colour) => measure.colours.add(hex(colour)));
for (const polygon of polygons) {
  for (let i = 1; i + 1 < polygon.length; ++i) measure.triangle(polygon[0], polygon[i], polygon[i + 1]);
}
measure.print(version);
process.exit(0);
