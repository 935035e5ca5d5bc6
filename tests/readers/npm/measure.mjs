// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volume, box, colours and names of a file, which readers print as a line of JSON.

// Collects triangles of a mesh, in mm, and their attributes.
export class Measure {
  constructor() {
    this.sixfold = 0;
    this.min = [Infinity, Infinity, Infinity];
    this.max = [-Infinity, -Infinity, -Infinity];
    this.colours = new Set();
    this.names = new Set();
  }

  triangle(a, b, c) {
    const cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    this.sixfold += a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2];
    for (const p of [a, b, c]) {
      for (let i = 0; i < 3; ++i) {
        this.min[i] = Math.min(this.min[i], p[i]);
        this.max[i] = Math.max(this.max[i], p[i]);
      }
    }
  }

  print(version) {
    const size = this.max.map((x, i) => x - this.min[i]);
    console.log("RESULT " + JSON.stringify({
      version, volume: this.sixfold / 6, min: this.min, size,
      colours: [...this.colours].sort(), names: [...this.names].sort(),
    }));
  }
}

export function hex(colour) {
  const byte = (x) => Math.round(255 * x).toString(16).padStart(2, "0");
  return "#" + colour.slice(0, 3).map(byte).join("");
}

// Returns the byte of sRGB, from 0 to 1, of a linear share.
export function srgb(x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
}
