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

// Returns corners of a surface and for each corner the distance from the design, mm; positive:
// material is left.
async function readDeviation(packed) {
  const [corners, index, values] = await Promise.all([cornersOf(packed),
    numbersOf(packed.triangles, 3), numbersOf(packed.deviation)]);
  const deviation = new Float32Array(index.length);
  for (let i = 0; i < index.length; i += 1) deviation[i] = kPageUnit * values[index[i]];
  return { corners, deviation, tolerance: packed.tolerance };
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

// Returns the numbers of corners by place: `members` from `starts[v]` to `starts[v + 1]` have the same
// place. `corners`: three numbers below 65536 a corner.
function cornersByPlace(corners) {
  const count = corners.length / 3;
  let size = 1;
  while (size < count) size *= 2;
  const known = new Int32Array(size).fill(-1), vertexOf = new Int32Array(count);
  let vertices = 0;
  for (let i = 0; i < count; i += 1) {
    const x = corners[3 * i], y = corners[3 * i + 1], z = corners[3 * i + 2];
    let h = Math.imul(x | y << 16, 0x9e3779b1);
    h = Math.imul(h ^ h >>> 15 ^ z, 0x85ebca6b);
    h = (h ^ h >>> 13) & size - 1;
    for (; known[h] >= 0; h = h + 1 & size - 1) {
      const k = 3 * known[h];
      if (corners[k] === x && corners[k + 1] === y && corners[k + 2] === z) break;
    }
    if (known[h] < 0) {
      known[h] = i;
      vertexOf[i] = vertices;
      vertices += 1;
    } else {
      vertexOf[i] = vertexOf[known[h]];
    }
  }
  const starts = new Int32Array(vertices + 1), members = new Int32Array(count);
  for (let i = 0; i < count; i += 1) starts[vertexOf[i] + 1] += 1;
  for (let v = 0; v < vertices; v += 1) starts[v + 1] += starts[v];
  const next = starts.slice();
  for (let i = 0; i < count; i += 1) {
    members[next[vertexOf[i]]] = i;
    next[vertexOf[i]] += 1;
  }
  return { starts, members };
}

// Averages the normals of polygons that meet in a corner at less than 35° and exist at the same
// time. Returns a normal for each corner of each polygon, in units of 1/32767. `table`: normals in
// these units; `normalOf`, `first`, `end`: for each polygon.
function smoothNormals({ polygonOf, corners, first, end, normalOf, table }) {
  const kLeastCosine = 0.82 * 32767 * 32767;
  const { starts, members } = cornersByPlace(corners);
  const result = new Int16Array(corners.length);
  let x = new Float64Array(64), y = new Float64Array(64), z = new Float64Array(64);
  let from = new Int32Array(64), to = new Int32Array(64);
  for (let v = 0; v + 1 < starts.length; v += 1) {
    const begin = starts[v], m = starts[v + 1] - begin;
    if (m > x.length) {
      [x, y, z] = [x, y, z].map(() => new Float64Array(2 * m));
      [from, to] = [from, to].map(() => new Int32Array(2 * m));
    }
    for (let i = 0; i < m; i += 1) {
      const p = polygonOf[members[begin + i]], n = 3 * normalOf[p];
      x[i] = table[n];
      y[i] = table[n + 1];
      z[i] = table[n + 2];
      from[i] = first[p];
      to[i] = end[p];
    }
    for (let i = 0; i < m; i += 1) {
      let sx = 0, sy = 0, sz = 0, isFlat = true;
      for (let k = 0; k < m; k += 1) {
        if (from[k] >= to[i] || from[i] >= to[k]) continue;
        if (x[i] * x[k] + y[i] * y[k] + z[i] * z[k] < kLeastCosine) continue;
        isFlat = isFlat && x[i] === x[k] && y[i] === y[k] && z[i] === z[k];
        sx += x[k];
        sy += y[k];
        sz += z[k];
      }
      const at = 3 * members[begin + i];
      const scale = isFlat ? 0 : 32767 / Math.sqrt(sx * sx + sy * sy + sz * sz);
      result[at] = isFlat ? x[i] : sx * scale;
      result[at + 1] = isFlat ? y[i] : sy * scale;
      result[at + 2] = isFlat ? z[i] : sz * scale;
    }
  }
  return result;
}

// The states of the part as convex polygons: corners on the grid and normals, the polygon of each
// corner, and for each polygon the line, the first corner, and the states in which it exists.
async function readStates(packed) {
  const [sizes, all, lines, first, end, normalOf, table, stateMoves, stateLines] =
    await Promise.all([numbersOf(packed.sizes), numbersOf(packed.corners, 3),
      numbersOf(packed.lines), numbersOf(packed.first), numbersOf(packed.end),
      numbersOf(packed.normalOf), numbersOf(packed.normals, 3), numbersOf(packed.stateMoves),
      numbersOf(packed.stateLines)]);
  const corners = new Uint16Array(all);
  const starts = new Int32Array(sizes.length + 1), polygonOf = new Int32Array(corners.length / 3);
  for (let p = 0, at = 0; p < sizes.length; p += 1) {
    polygonOf.fill(p, at, at += sizes[p]);
    starts[p + 1] = at;
  }
  const normals = smoothNormals({ polygonOf, corners, first, end, normalOf, table });
  return { origin: packed.origin, step: packed.step, stateMoves, stateLines, corners, normals,
    polygonOf, starts, lines, first, end, triangles: polygonOf.length - 2 * sizes.length };
}

// Returns the corners of the triangles of all polygons: a fan for each.
function indexOfStates({ starts, triangles }) {
  const index = new Uint32Array(3 * triangles);
  for (let p = 0, t = 0; p + 1 < starts.length; p += 1) {
    for (let k = starts[p] + 1; k + 1 < starts[p + 1]; k += 1, t += 3) {
      index[t] = starts[p];
      index[t + 1] = k;
      index[t + 2] = k + 1;
    }
  }
  return index;
}

// Volume of the part in a state, mm³, by the divergence theorem.
function volumeOfState({ corners: c, starts, first, end, step }, state) {
  let sum = 0;
  for (let p = 0; p + 1 < starts.length; p += 1) {
    if (first[p] > state || end[p] <= state) continue;
    const i = 3 * starts[p];
    for (let j = i + 3; j + 3 < 3 * starts[p + 1]; j += 3) {
      sum += c[i] * (c[j + 1] * c[j + 5] - c[j + 2] * c[j + 4]) +
        c[i + 1] * (c[j + 2] * c[j + 3] - c[j] * c[j + 5]) +
        c[i + 2] * (c[j] * c[j + 4] - c[j + 1] * c[j + 3]);
    }
  }
  return sum * step ** 3 / 6;
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
