// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reader of the arrays that page_arrays.cpp packs.
"use strict";

// Returns the bytes of a text in Base64.
function bytesOf(text) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i += 1) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

async function inflated(text) {
  const stream = new Blob([bytesOf(text)]).stream();
  const whole = new Response(stream.pipeThrough(new DecompressionStream("deflate")));
  return new Uint8Array(await whole.arrayBuffer());
}

// Returns the numbers of a table with `stride` columns, row by row.
async function numbersOf(text, stride = 1) {
  if (!text) return new Int32Array(0);
  const bytes = await inflated(text);
  const count = bytes.length / 4;
  const numbers = new Int32Array(count);
  let at = 0;
  for (let column = 0; column < stride; column += 1) {
    let last = 0;
    for (let i = column; i < count; i += stride, at += 1) {
      const word = bytes[at] | bytes[count + at] << 8 | bytes[2 * count + at] << 16 |
        bytes[3 * count + at] << 24;
      last = last + ((word >>> 1) ^ -(word & 1)) | 0;
      numbers[i] = last;
    }
  }
  return numbers;
}

const kPageUnit = 1e-4;  // mm, as in page_arrays.h

async function positionsOf(text) {
  const numbers = await numbersOf(text, 3);
  const positions = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; i += 1) positions[i] = kPageUnit * numbers[i];
  return positions;
}

// Returns the corners of all triangles of a mesh, nine numbers a triangle.
async function cornersOf(mesh) {
  const vertices = await positionsOf(mesh.vertices);
  const index = await numbersOf(mesh.triangles, 3);
  const corners = new Float32Array(3 * index.length);
  for (let i = 0; i < index.length; i += 1) {
    for (let c = 0; c < 3; c += 1) corners[3 * i + c] = vertices[3 * index[i] + c];
  }
  return corners;
}

// Normal of each triangle for each corner, in units of 1/32767.
function flatNormals(corners) {
  const normals = new Int16Array(corners.length);
  for (let t = 0; t < corners.length; t += 9) {
    const e = [0, 1, 2].map((c) => corners[t + 3 + c] - corners[t + c]);
    const f = [0, 1, 2].map((c) => corners[t + 6 + c] - corners[t + c]);
    const n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    const length = Math.hypot(n[0], n[1], n[2]) || 1;
    for (let i = 0; i < 9; i += 1) normals[t + i] = 32767 * n[i % 3] / length;
  }
  return normals;
}

// The finished part: corners, normals, lines, tools and forms of the triangles.
async function readPart(mesh) {
  const [corners, table, normalOf, lines, tools, formOf] = await Promise.all([cornersOf(mesh),
    numbersOf(mesh.normals, 3), numbersOf(mesh.normalOf), numbersOf(mesh.lines),
    numbersOf(mesh.tools), numbersOf(mesh.formOf)]);
  const normals = new Int16Array(3 * normalOf.length);
  for (let i = 0; i < normals.length; i += 1) normals[i] = table[3 * normalOf[(i / 3) | 0] + i % 3];
  return { corners, normals, lines, tools, formOf, forms: mesh.forms };
}

// Averages the normals of polygons that meet in a corner at less than 35° and exist at the same
// time. Returns a normal for each corner of each polygon.
function smoothNormals(surface) {
  const { sizes, corners, first, end, normals } = surface;
  const kLeastCosine = 0.82;
  const count = corners.length / 3;
  let size = 1;
  while (size < 2 * count) size *= 2;
  const head = new Int32Array(size).fill(-1), next = new Int32Array(count);
  const polygon = new Int32Array(count), slot = new Int32Array(count);
  for (let p = 0, at = 0; p < sizes.length; p += 1) {
    for (let k = 0; k < sizes[p]; k += 1, at += 1) {
      polygon[at] = p;
      let h = Math.imul(corners[3 * at], 0x9e3779b1) ^ Math.imul(corners[3 * at + 1], 0x85ebca6b) ^
        Math.imul(corners[3 * at + 2], 0xc2b2ae35);
      h = (h ^ h >>> 15) & size - 1;
      slot[at] = h;
      next[at] = head[h];
      head[h] = at;
    }
  }
  const result = new Int16Array(3 * count);
  for (let at = 0; at < count; at += 1) {
    const p = polygon[at], own = 3 * p;
    let x = 0, y = 0, z = 0;
    for (let other = head[slot[at]]; other >= 0; other = next[other]) {
      if (corners[3 * other] !== corners[3 * at] || corners[3 * other + 1] !== corners[3 * at + 1] ||
          corners[3 * other + 2] !== corners[3 * at + 2]) continue;
      const q = polygon[other], n = 3 * q;
      if (first[q] >= end[p] || first[p] >= end[q]) continue;
      if (normals[n] * normals[own] + normals[n + 1] * normals[own + 1] +
          normals[n + 2] * normals[own + 2] < kLeastCosine) continue;
      x += normals[n];
      y += normals[n + 1];
      z += normals[n + 2];
    }
    const length = Math.hypot(x, y, z) || 1;
    result[3 * at] = 32767 * x / length;
    result[3 * at + 1] = 32767 * y / length;
    result[3 * at + 2] = 32767 * z / length;
  }
  return result;
}

// The states of the part as triangles: corners on the grid, normals, lines, and the states in
// which each triangle exists.
async function readStates(packed) {
  const [sizes, corners, lines, first, end, normalOf, table, stateMoves, stateLines] =
    await Promise.all([numbersOf(packed.sizes), numbersOf(packed.corners, 3),
      numbersOf(packed.lines), numbersOf(packed.first), numbersOf(packed.end),
      numbersOf(packed.normalOf), numbersOf(packed.normals, 3), numbersOf(packed.stateMoves),
      numbersOf(packed.stateLines)]);
  const normals = new Float32Array(3 * sizes.length);
  let triangles = 0;
  for (let p = 0; p < sizes.length; p += 1) {
    triangles += sizes[p] - 2;
    for (let c = 0; c < 3; c += 1) normals[3 * p + c] = table[3 * normalOf[p] + c] / 32767;
  }
  const smooth = smoothNormals({ sizes, corners, first, end, normals });
  const states = {
    origin: packed.origin, step: packed.step, triangles, stateMoves, stateLines,
    corners: new Uint16Array(9 * triangles), normals: new Int16Array(9 * triangles),
    lines: new Int32Array(triangles), life: new Uint16Array(2 * triangles),
  };
  let t = 0;
  for (let p = 0, at = 0; p < sizes.length; at += sizes[p], p += 1) {
    for (let k = 1; k + 1 < sizes[p]; k += 1, t += 1) {
      const fan = [at, at + k, at + k + 1];
      for (let v = 0; v < 3; v += 1) {
        for (let c = 0; c < 3; c += 1) {
          states.corners[9 * t + 3 * v + c] = corners[3 * fan[v] + c];
          states.normals[9 * t + 3 * v + c] = smooth[3 * fan[v] + c];
        }
      }
      states.lines[t] = lines[p];
      states.life[2 * t] = first[p];
      states.life[2 * t + 1] = end[p];
    }
  }
  return states;
}

// Volume of the part in a state, mm³, by the divergence theorem.
function volumeOfState(states, state) {
  const c = states.corners;
  let sum = 0;
  for (let t = 0; t < states.triangles; t += 1) {
    if (states.life[2 * t] > state || states.life[2 * t + 1] <= state) continue;
    const i = 9 * t;
    sum += c[i] * (c[i + 4] * c[i + 8] - c[i + 5] * c[i + 7]) +
      c[i + 1] * (c[i + 5] * c[i + 6] - c[i + 3] * c[i + 8]) +
      c[i + 2] * (c[i + 3] * c[i + 7] - c[i + 4] * c[i + 6]);
  }
  return sum * states.step ** 3 / 6;
}

// Moves, path and tools of the program.
async function readPlay(packed) {
  const [lines, tools, rapid, first, last, milliseconds, points, axes, states] = await Promise.all([
    numbersOf(packed.lines), numbersOf(packed.tools), numbersOf(packed.rapid),
    numbersOf(packed.first), numbersOf(packed.last), numbersOf(packed.milliseconds),
    positionsOf(packed.points), numbersOf(packed.axes, 3), readStates(packed.surface)]);
  const bodies = [];
  for (const tool of packed.toolBodies) {
    const pieces = [];
    for (const piece of tool.pieces)
      pieces.push({ corners: await cornersOf(piece), colour: piece.colour });
    bodies.push({ name: tool.name, pieces });
  }
  return { lines, tools, rapid, first, last, milliseconds, points, axes, states, bodies };
}
