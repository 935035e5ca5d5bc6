// SPDX-License-Identifier: GPL-3.0-or-later
//
// manifold_hulls.mjs FOLDER FILE: subtracts the hulls of FILE (write_hulls) from their stock with the package
// manifold-3d that is installed in FOLDER. Prints CPU seconds of the Booleans and the volume of the part (mm³) as JSON.
// Hulls are made before the clock starts; the Booleans are evaluated by asking for the volume.
import {readFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const [folder, file] = process.argv.slice(2);
const {default: load} = await import(pathToFileURL(`${folder}/node_modules/manifold-3d/manifold.js`));
const wasm = await load();
wasm.setup();
const {Manifold} = wasm;

const lines = readFileSync(file, 'utf8').trim().split('\n');
const numbers = (line) => line.split(' ').map(Number);
const [low, high] = [numbers(lines[0]).slice(0, 3), numbers(lines[0]).slice(3, 6)];
const expected = Number(lines[1]);
const stock = Manifold.cube(high.map((v, i) => v - low[i])).translate(low);
const bodies = lines.slice(2).map((line) => {
    const flat = numbers(line);
    const points = [];
    for (let i = 0; i < flat.length; i += 3) points.push(flat.slice(i, i + 3));
    const body = Manifold.hull(points);
    body.volume();
    return body;
});

const before = process.cpuUsage();
const part = Manifold.difference([stock, ...bodies]);
const volume = part.volume();
const used = process.cpuUsage(before);
console.log(JSON.stringify({
    seconds: (used.user + used.system) / 1e6,
    volume,
    expected,
    triangles: part.numTri(),
}));
