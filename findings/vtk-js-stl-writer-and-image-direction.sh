#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @kitware/vtk.js 37.4.3.
# Input:    STLWriter: a cylinder (CylinderSource with its default of 6 sides: quadrilaterals and hexagons), the same
#           as triangles, a cube, and a triangle at x = 1234.5678. ImageMarchingCubes: an image of the distance to a
#           point, turned by 90 degrees about Z (setDirection). GCodeReader: a program with two levels. Source:
#           STLWriter.d.ts (any vtkPolyData), ImageData.d.ts, GCodeReader.d.ts; STL: float32, a count of triangles.
# Expected: An STL file with the volume 649.52, or an error. 1234.5678 as float32. A surface in the middle of the
#           bounds of the image. Each port of GCodeReader has the lines of a level.
# Seen:     After three corners, the next index is taken as the size of a face: the cylinder has the volume 198.46,
#           and its file has 11 triangles and the count 8; the cube is an error. Coordinates are rounded to 6 digits,
#           also in the binary format. The surface ignores the direction and is outside the image. The levels are at
#           the ports 1 to n instead of 0 to n - 1: port 0 is empty, and a loop over the ports misses the last level.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --legacy-peer-deps --prefix "$work" \
  @kitware/vtk.js@37.4.3 esbuild@0.21.5 >/dev/null

cat >check.mjs <<'JS'
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkImageData from '@kitware/vtk.js/Common/DataModel/ImageData';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkTriangleFilter from '@kitware/vtk.js/Filters/General/TriangleFilter';
import vtkCubeSource from '@kitware/vtk.js/Filters/Sources/CubeSource';
import vtkCylinderSource from '@kitware/vtk.js/Filters/Sources/CylinderSource';
import vtkImageMarchingCubes from '@kitware/vtk.js/Filters/General/ImageMarchingCubes';
import vtkSTLWriter from '@kitware/vtk.js/IO/Geometry/STLWriter';
import vtkGCodeReader from '@kitware/vtk.js/IO/Misc/GCodeReader';
const { writeSTL } = vtkSTLWriter;
const mesh = (points, faces) => {
  const data = vtkPolyData.newInstance();
  data.getPoints().setData(Float32Array.from(points.flat()), 3);
  data.getPolys().setData(Uint32Array.from(faces.flatMap((face) => [face.length, ...face])));
  return data;
};
const bounds = (points) => [0, 1, 2].map((axis) => {
  const values = points.map((p) => p[axis]);
  return `${Math.min(...values).toFixed(1)} to ${Math.max(...values).toFixed(1)}`;
}).join(', ');
const volume = (triangles) => triangles.reduce((sum, [a, b, c]) => sum + (a[0] * (b[1] * c[2] - b[2] * c[1]) -
  a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6, 0);
const readStl = (view) => {
  const triangles = [];
  for (let at = 84; at + 50 <= view.byteLength; at += 50) {
    triangles.push([12, 24, 36].map((p) => [0, 4, 8].map((q) => view.getFloat32(at + p + q, true))));
  }
  return triangles;
};
const write = (name, data) => {
  try {
    const view = writeSTL(data);
    const triangles = readStl(view);
    console.log(`${name}: count ${view.getUint32(80, true)}, file ${view.byteLength} bytes, triangles ${triangles.length}, ` +
      `volume ${volume(triangles).toFixed(2)}`);
  } catch (error) {
    console.log(`${name}: ${error.message}`);
  }
};
const cylinder = vtkCylinderSource.newInstance({ radius: 5, height: 10, capping: true });
const split = vtkTriangleFilter.newInstance();
split.setInputConnection(cylinder.getOutputPort());
for (const [name, source] of [['cylinder of triangles', split], ['cylinder', cylinder], ['cube', vtkCubeSource.newInstance()]]) {
  source.update();
  write(name, source.getOutputData());
}
const far = readStl(writeSTL(mesh([[1234.5678, 0, 0], [1235, 0, 0], [1235, 1, 0]], [[0, 1, 2]])));
console.log(`1234.5678: ${far[0][0][0].toFixed(4)}, as float32 ${Math.fround(1234.5678).toFixed(4)}`);

const size = 25;
const image = vtkImageData.newInstance({ spacing: [0.5, 0.5, 0.5], origin: [-2, -6, -6] });
image.setDimensions([size, size, size]);
const values = new Float32Array(size ** 3);
for (let k = 0, i = 0; k < size; k++) for (let j = 0; j < size; j++) for (let l = 0; l < size; l++) {
  values[i++] = Math.hypot(l * 0.5 - 6, j * 0.5 - 6, k * 0.5 - 6);
}
image.getPointData().setScalars(vtkDataArray.newInstance({ numberOfComponents: 1, values, name: 'distance' }));
for (const [name, direction] of [['image', [1, 0, 0, 0, 1, 0, 0, 0, 1]], ['turned image', [0, 1, 0, -1, 0, 0, 0, 0, 1]]]) {
  image.setDirection(direction);
  const contour = vtkImageMarchingCubes.newInstance({ contourValue: 2, mergePoints: true });
  contour.setInputData(image);
  contour.update();
  const data = contour.getOutputData().getPoints().getData();
  const points = Array.from({ length: data.length / 3 }, (_, i) => [...data.slice(3 * i, 3 * i + 3)]);
  const box = image.getBounds();
  console.log(`${name}: bounds ${bounds([[box[0], box[2], box[4]], [box[1], box[3], box[5]]])}, surface ${bounds(points)}`);
}

const reader = vtkGCodeReader.newInstance();
reader.parse('G90\nG0 X0 Y0 Z1\nG1 X10\nG1 Y10\nG1 Z2\nG1 X0\n');
const levels = reader.get().output.map((data) => data.getLines().getNumberOfCells());
console.log(`G-code: ports ${reader.getNumberOfOutputPorts()}, lines ${[0, 1, 2].map((i) => levels[i] ?? 'none').join(' ')}`);
JS
# The package expects a browser: a bundler resolves its folders, and the banner declares its globals.
node_modules/.bin/esbuild check.mjs --bundle --format=esm --platform=node --outfile=bundle.mjs --log-level=error \
  --banner:js='globalThis.self ??= globalThis; globalThis.window ??= globalThis;
globalThis.document ??= { createElement: () => ({ getContext: () => null, style: {} }), head: { appendChild() {} } };'
node bundle.mjs | grep -v mcubes | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
cylinder of triangles: count 20, file 1084 bytes, triangles 20, volume 649.52
cylinder: count 8, file 634 bytes, triangles 11, volume 198.46
cube: Cannot read properties of undefined (reading 'toPrecision')
1234.5678: 1234.5699, as float32 1234.5677
image: bounds -2.3 to 10.3, -6.3 to 6.3, -6.3 to 6.3, surface 2.0 to 6.0, -2.0 to 2.0, -2.0 to 2.0
turned image: bounds -14.3 to -1.8, -6.3 to 6.3, -6.3 to 6.3, surface 2.0 to 6.0, -2.0 to 2.0, -2.0 to 2.0
G-code: ports 2, lines none 3 2
EXPECTED
