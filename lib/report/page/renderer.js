// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws meshes with WebGL 2: first colour, normal and number of each pixel, then light and edges.
// Edges are found between pixels, so no line lies in a face and flickers.
"use strict";

// --- Matrices, by columns ------------------------------------------------------------------------

const Matrix = {
  unit: () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  move: (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1],
  scale: (s) => [s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, 0, 0, 0, 1],
  product(a, b) {
    const result = new Array(16).fill(0);
    for (let column = 0; column < 4; column += 1) {
      for (let row = 0; row < 4; row += 1) {
        for (let k = 0; k < 4; k += 1) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
      }
    }
    return result;
  },
  turn([x, y, z], angle) {
    const c = Math.cos(angle), s = Math.sin(angle), d = 1 - c;
    return [c + x * x * d, y * x * d + z * s, z * x * d - y * s, 0,
      x * y * d - z * s, c + y * y * d, z * y * d + x * s, 0,
      x * z * d + y * s, y * z * d - x * s, c + z * z * d, 0, 0, 0, 0, 1];
  },
  // Frame with the origin in `at` and the Z axis along `axis`.
  along(axis, at) {
    const [x, y, z] = axis;
    const side = Math.abs(z) > 0.999999 ? [1, 0, 0] : unitVector([-y, x, 0]);
    const other = cross(axis, side);
    return [...side, 0, ...other, 0, ...axis, 0, ...at, 1];
  },
  // Inverse of a rotation and translation.
  inverseOfRigid(m) {
    const t = [m[12], m[13], m[14]], axes = [0, 4, 8].map((i) => [m[i], m[i + 1], m[i + 2]]);
    const [x, y, z] = axes;
    return [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0,
      -dot(x, t), -dot(y, t), -dot(z, t), 1];
  },
  turned: (m, [x, y, z]) => [0, 1, 2].map((i) => m[i] * x + m[4 + i] * y + m[8 + i] * z),
  apply(m, [x, y, z]) {
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    return [0, 1, 2].map((i) => (m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i]) / w);
  },
};
function dot(a, b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
function minus(a, b) { return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]; }
function plus(a, b, factor = 1) { return [0, 1, 2].map((i) => a[i] + factor * b[i]); }
function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
function norm(a) { return Math.hypot(a[0], a[1], a[2]); }
function unitVector(a) { const n = norm(a) || 1; return [a[0] / n, a[1] / n, a[2] / n]; }

// --- Shaders -------------------------------------------------------------------------------------

// Colour at a place from 0 to 1 of the scale, in a shader with `scale`.
const kScaled = `
vec3 scaled(float t) {
  float at = 4.0 * clamp(t, 0.0, 1.0);
  int below = min(int(at), 3);
  return mix(scale[below], scale[below + 1], at - float(below));
}`;
const kMeshVertex = `#version 300 es
uniform mat4 model, camera;
uniform mat3 turned;
uniform uint state, chosen;
uniform vec3 bodyColour, chosenColour, errorColour;
uniform vec3 tools[16], scale[5];
uniform float lastLine;
uniform int colouring;
uniform bool isPart;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uint line;
layout(location = 3) in uvec2 life;
layout(location = 4) in float deviation;
out vec3 place, facing;
out float away;
flat out vec3 paintOf;
flat out uint corner, isVarying;
${kScaled}
// Colour of a face, by kColours in paint.js. isVarying: the colour differs within the face.
void paint() {
  uint lineOf = line & 0x7ffffffu, tool = line >> 27u & 15u;
  isVarying = colouring == 3 || (colouring == 2 && tool > 0u) ? 1u : 0u;
  paintOf = colouring == 1 && lineOf > 0u ? scaled(float(lineOf) / lastLine) : tools[tool];
  bool isChosen = lineOf == chosen && lineOf > 0u, isWrong = line >> 31u == 1u && colouring != 3;
  if (!isChosen && !isWrong) return;
  isVarying = 0u;
  paintOf = isChosen ? chosenColour : errorColour;
}
void main() {
  isVarying = 0u;
  paintOf = bodyColour;
  if (isPart) paint();
  vec4 at = model * vec4(position, 1.0);
  place = at.xyz;
  facing = turned * normal;
  away = deviation;
  corner = uint(gl_VertexID);
  gl_Position = life.x <= state && state < life.y ? camera * at : vec4(2.0, 2.0, 2.0, 1.0);
}`;
const kMeshFragment = `#version 300 es
precision highp float;
precision highp int;
uniform vec3 eye, bodyColour, faceColour;
uniform vec3 scale[5], deviations[5];
uniform vec2 depths, limits;
uniform vec4 section;
uniform uint kind;
uniform int colouring;
uniform bool isCut, isPart, isSheer;
in vec3 place, facing;
in float away;
flat in vec3 paintOf;
flat in uint corner, isVarying;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 normal;
layout(location = 2) out uint number;
${kScaled}
// Colour of a point of a face; limits: tolerance and largest deviation.
vec3 varyingPaint() {
  if (colouring == 2) return scaled((depths.y - place.z) / (depths.y - depths.x));
  float size = abs(away);
  if (size <= limits.x) return deviations[2];
  float t = (size - limits.x) / (limits.y - limits.x);
  return away < 0.0 ? mix(deviations[1], deviations[0], t) : mix(deviations[3], deviations[4], t);
}
void main() {
  if (isSheer && (int(gl_FragCoord.x) + int(gl_FragCoord.y)) % 2 == 0) discard;
  if (isCut && dot(section.xyz, place) > section.w) discard;
  vec3 n = normalize(facing);
  vec3 paint = isVarying == 1u ? varyingPaint() : paintOf;
  number = kind << 28u | corner + 1u;
  // Kind of pixel: 1 a face with edges, 0.75 a cut face, 0.5 without edges, 0.25 an inner side, which
  // is seen through a gap between polygons, 0 without light.
  float pixel = isSheer ? 0.5 : 1.0;
  if (!gl_FrontFacing && !isSheer) {
    n = -n;
    pixel = 0.25;
    vec3 ray = place - eye;
    float t = (section.w - dot(section.xyz, eye)) / dot(section.xyz, ray);
    // The plane is before this inner side of the body, so it meets material: the cut face, if no
    // other face is nearer.
    if (isCut && t > 0.0 && t < 1.0) {
      n = section.xyz;
      paint = isPart ? faceColour : 0.8 * bodyColour;
      number = 7u << 28u;
      pixel = 0.75;
    }
  }
  colour = vec4(paint, 1.0);
  normal = vec4(0.5 * n + 0.5, pixel);
}`;
const kLineVertex = `#version 300 es
uniform mat4 camera;
uniform vec3 from, to;
uniform bool isSingle;
layout(location = 0) in vec3 position;
layout(location = 1) in float rapid;
out float isRapid;
void main() {
  vec3 at = isSingle ? (gl_VertexID == 0 ? from : to) : position;
  isRapid = rapid;
  gl_Position = camera * vec4(at, 1.0);
  gl_Position.z -= 2e-5 * gl_Position.w;
}`;
const kLineFragment = `#version 300 es
precision highp float;
precision highp int;
uniform vec3 feedColour, rapidColour;
in float isRapid;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 normal;
layout(location = 2) out uint number;
void main() {
  colour = vec4(isRapid > 0.5 ? rapidColour : feedColour, 1.0);
  normal = vec4(0.0);
  number = 0u;
}`;
const kScreenVertex = `#version 300 es
void main() {
  gl_Position = vec4(float(gl_VertexID / 2) * 4.0 - 1.0, float(gl_VertexID % 2) * 4.0 - 1.0, 0.0, 1.0);
}`;
const kScreenFragment = `#version 300 es
precision highp float;
precision highp int;
uniform sampler2D colours, normals;
uniform highp sampler2D depths;
uniform vec3 background, edgeColour, lamp;
uniform float near, far;
uniform int samples;
out vec4 result;
float distanceAt(ivec2 at) {
  float d = 2.0 * texelFetch(depths, at, 0).r - 1.0;
  return 2.0 * near * far / (far + near - d * (far - near));
}
bool isGap(float kind) { return kind > 0.2 && kind < 0.3; }
bool isCutFace(float kind) { return kind > 0.7 && kind < 0.8; }
vec3 lit(vec3 paint, vec3 n) {
  return paint * (0.38 + 0.62 * max(dot(n, lamp), 0.0) + 0.08 * n.z);
}
vec3 directionOf(vec4 stored) { return normalize(2.0 * stored.xyz - 1.0); }
vec3 sampleAt(ivec2 at, ivec2 most) {
  vec4 own = texelFetch(normals, at, 0);
  // An inner side of a body shows through a gap, which is narrower than a pixel.
  for (int i = 0; i < 4 && isGap(own.a); i += 1) {
    ivec2 beside = clamp(at + (i < 2 ? ivec2(2 * i - 1, 0) : ivec2(0, 2 * i - 5)), ivec2(0), most);
    vec4 other = texelFetch(normals, beside, 0);
    if (isGap(other.a) || other.a == 0.0) continue;
    own = other;
    at = beside;
  }
  vec4 paint = texelFetch(colours, at, 0);
  if (paint.a == 0.0) return background;
  if (own.a == 0.0) return paint.rgb;
  vec3 n = directionOf(own);
  vec3 shown = lit(paint.rgb, n);
  if (own.a < 0.6) return shown;
  float edge = 0.0, z = distanceAt(at), same = 0.004 * z;
  bool isCut = isCutFace(own.a);
  // The border of a cut face is drawn on the cut face alone.
  float least = isCut ? 0.6 : 0.9;
  for (int i = 0; i < 2; i += 1) {
    ivec2 step = i == 0 ? ivec2(1, 0) : ivec2(0, 1);
    ivec2 a = clamp(at - step, ivec2(0), most), b = clamp(at + step, ivec2(0), most);
    vec4 na = texelFetch(normals, a, 0), nb = texelFetch(normals, b, 0);
    float za = distanceAt(a), zb = distanceAt(b);
    bool isOtherA = na.a > least && dot(n, directionOf(na)) < 0.90;
    bool isOtherB = nb.a > least && dot(n, directionOf(nb)) < 0.90;
    if (isOtherA || isOtherB) {
      // A plane seen through a gap of one sample is not a face, neither here nor in the next sample.
      if (distance(na, nb) < 0.02 && z > max(za, zb) && abs(za - zb) < same)
        return lit(texelFetch(colours, a, 0).rgb, directionOf(na));
      ivec2 c = clamp(isOtherA ? at - 2 * step : at + 2 * step, ivec2(0), most);
      bool isGapNext = (isOtherA ? za : zb) > z && abs(distanceAt(c) - z) < same &&
        distance(texelFetch(normals, c, 0), own) < 0.02;
      if (!isGapNext) edge = 1.0;
    }
    bool hasA = na.a > 0.9 || texelFetch(colours, a, 0).a == 0.0;
    bool hasB = nb.a > 0.9 || texelFetch(colours, b, 0).a == 0.0;
    if (isCut && (texelFetch(colours, a, 0).a == 0.0 || texelFetch(colours, b, 0).a == 0.0))
      edge = 1.0;
    if (isCut || !hasA || !hasB) continue;
    // Only the nearer side of a jump is an edge, and no slope is one.
    if (max(za, zb) - z - abs(z - min(za, zb)) > same) edge = 1.0;
  }
  return mix(shown, edgeColour, 0.8 * edge);
}
void main() {
  ivec2 base = ivec2(gl_FragCoord.xy) * samples;
  ivec2 most = textureSize(colours, 0) - 1;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; i += 1) {
    if (i >= samples * samples) break;
    sum += sampleAt(base + ivec2(i % samples, i / samples), most);
  }
  result = vec4(sum / float(samples * samples), 1.0);
}`;

// --- Renderer ------------------------------------------------------------------------------------

class Renderer {
  constructor(canvas) {
    this.canvas = canvas;
    const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.gl = gl;
    this.uploaded = 0;  // bytes of vertex data since the page was opened
    this.meshes = this.program(kMeshVertex, kMeshFragment);
    this.lines = this.program(kLineVertex, kLineFragment);
    this.screen = this.program(kScreenVertex, kScreenFragment);
    this.target = null;
    gl.enable(gl.DEPTH_TEST);
  }

  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(gl.getProgramInfoLog(program));
    const at = {};
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
    for (let i = 0; i < count; i += 1) {
      const { name } = gl.getActiveUniform(program, i);
      at[name] = gl.getUniformLocation(program, name);
    }
    return { program, at };
  }

  buffer(array, kind = this.gl.ARRAY_BUFFER) {
    const gl = this.gl, buffer = gl.createBuffer();
    gl.bindBuffer(kind, buffer);
    gl.bufferData(kind, array, gl.STATIC_DRAW);
    this.uploaded += array.byteLength;
    return buffer;
  }

  // Returns a mesh to draw. `corners`: three numbers a corner; `index`: the corners of triangles, if
  // not each three in turn; `lines`, `life`, `deviation`: one, two, one number a corner.
  mesh({ corners, normals, index = null, lines = null, life = null, deviation = null,
    matrix = Matrix.unit() }) {
    const gl = this.gl, vao = gl.createVertexArray();
    gl.bindVertexArray(vao);
    this.buffer(corners);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, corners instanceof Uint16Array ? gl.UNSIGNED_SHORT : gl.FLOAT,
      false, 0, 0);
    this.buffer(normals);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 3, gl.SHORT, true, 0, 0);
    if (lines) {
      this.buffer(lines);
      gl.enableVertexAttribArray(2);
      gl.vertexAttribIPointer(2, 1, gl.UNSIGNED_INT, 0, 0);
    }
    if (life) {
      this.buffer(life);
      gl.enableVertexAttribArray(3);
      gl.vertexAttribIPointer(3, 2, gl.UNSIGNED_SHORT, 0, 0);
    }
    if (deviation) {
      this.buffer(deviation);
      gl.enableVertexAttribArray(4);
      gl.vertexAttribPointer(4, 1, gl.FLOAT, false, 0, 0);
    }
    if (index) this.buffer(index, gl.ELEMENT_ARRAY_BUFFER);
    gl.bindVertexArray(null);
    return { vao, count: (index || corners).length / (index ? 1 : 3), matrix, isIndexed: index !== null,
      hasLines: lines !== null, hasLife: life !== null };
  }

  // Returns lines to draw: two points a line.
  path(points, rapid) {
    const gl = this.gl, vao = gl.createVertexArray();
    gl.bindVertexArray(vao);
    this.buffer(points);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    this.buffer(rapid);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 1, gl.UNSIGNED_BYTE, false, 0, 0);
    gl.bindVertexArray(null);
    return { vao, count: points.length / 3 };
  }

  // Sets the size of the picture in pixels.
  resize(width, height) {
    const gl = this.gl;
    const samples = width * height <= 3e6 ? 2 : 1;
    if (this.target && this.target.width === width && this.target.height === height) return;
    if (this.target) {
      for (const texture of this.target.textures) gl.deleteTexture(texture);
      gl.deleteFramebuffer(this.target.frame);
    }
    this.canvas.width = width;
    this.canvas.height = height;
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    const textures = [gl.RGBA8, gl.RGBA8, gl.R32UI, gl.DEPTH_COMPONENT24].map((format, i) => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, samples * width, samples * height);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, i < 3 ? gl.COLOR_ATTACHMENT0 + i :
        gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, texture, 0);
      return texture;
    });
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1, gl.COLOR_ATTACHMENT2]);
    this.target = { frame, textures, width, height, samples };
  }

  // Draws `scene`: view { camera, eye, near, far, lamp }, colours, section, meshes and paths.
  draw(scene) {
    const gl = this.gl, { width, height, samples } = this.target;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target.frame);
    gl.viewport(0, 0, samples * width, samples * height);
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.clearBufferfv(gl.COLOR, 1, [0, 0, 0, 0]);
    gl.clearBufferuiv(gl.COLOR, 2, [0, 0, 0, 0]);
    gl.clearBufferfi(gl.DEPTH_STENCIL, 0, 1, 0);
    this.drawMeshes(scene);
    this.drawLines(scene);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    const { program, at } = this.screen;
    gl.useProgram(program);
    gl.disable(gl.DEPTH_TEST);
    for (const [unit, name, texture] of [[0, "colours", 0], [1, "normals", 1], [2, "depths", 3]]) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this.target.textures[texture]);
      gl.uniform1i(at[name], unit);
    }
    gl.uniform3fv(at.background, scene.colours.background);
    gl.uniform3fv(at.edgeColour, scene.colours.edge);
    gl.uniform3fv(at.lamp, scene.view.lamp);
    gl.uniform1f(at.near, scene.view.near);
    gl.uniform1f(at.far, scene.view.far);
    gl.uniform1i(at.samples, samples);
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.enable(gl.DEPTH_TEST);
  }

  drawMeshes(scene) {
    const gl = this.gl, { program, at } = this.meshes;
    gl.useProgram(program);
    gl.uniformMatrix4fv(at.camera, false, scene.view.camera);
    gl.uniform3fv(at.eye, scene.view.eye);
    gl.uniform3fv(at.faceColour, scene.colours.face);
    gl.uniform3fv(at.chosenColour, scene.colours.chosen);
    gl.uniform3fv(at.errorColour, scene.colours.error);
    gl.uniform3fv(at["tools[0]"], scene.paint.tools);
    gl.uniform3fv(at["scale[0]"], scene.paint.scale);
    gl.uniform3fv(at["deviations[0]"], scene.paint.deviations);
    gl.uniform1i(at.colouring, scene.paint.colouring);
    gl.uniform1f(at.lastLine, scene.paint.lastLine);
    gl.uniform2fv(at.depths, scene.paint.depths);
    gl.uniform2fv(at.limits, scene.paint.limits);
    gl.uniform4fv(at.section, scene.section || [0, 0, 1, 0]);
    gl.uniform1ui(at.chosen, scene.chosen);
    gl.uniform1ui(at.state, scene.state);
    for (const item of scene.meshes) {
      const { mesh } = item, m = item.matrix || mesh.matrix;
      const scale = Math.hypot(m[0], m[1], m[2]);
      gl.uniformMatrix4fv(at.model, false, m);
      gl.uniformMatrix3fv(at.turned, false,
        [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]].map((v) => v / scale));
      gl.uniform1ui(at.kind, item.kind);
      gl.uniform1i(at.isPart, item.isPart ? 1 : 0);
      gl.uniform1i(at.isCut, scene.section && item.isSectioned ? 1 : 0);
      gl.uniform1i(at.isSheer, item.isSheer ? 1 : 0);
      gl.uniform3fv(at.bodyColour, item.colour || [0.5, 0.5, 0.5]);
      gl.bindVertexArray(mesh.vao);
      if (!mesh.hasLines) gl.vertexAttribI4ui(2, 0, 0, 0, 0);
      if (!mesh.hasLife) gl.vertexAttribI4ui(3, 0, 0xffffffff, 0, 0);
      if (mesh.isIndexed) gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0);
      else gl.drawArrays(gl.TRIANGLES, 0, mesh.count);
    }
  }

  drawLines(scene) {
    const gl = this.gl, { program, at } = this.lines;
    gl.useProgram(program);
    gl.uniformMatrix4fv(at.camera, false, scene.view.camera);
    gl.uniform3fv(at.rapidColour, scene.colours.rapid);
    for (const { path, first, count } of scene.paths) {
      gl.uniform3fv(at.feedColour, scene.colours.feed);
      gl.uniform1i(at.isSingle, 0);
      gl.bindVertexArray(path.vao);
      gl.drawArrays(gl.LINES, first, count);
    }
    gl.bindVertexArray(null);
    for (const { from, to, colour, rapid } of scene.segments) {
      gl.uniform3fv(at.feedColour, colour);
      gl.uniform1i(at.isSingle, 1);
      gl.uniform3fv(at.from, from);
      gl.uniform3fv(at.to, to);
      gl.vertexAttrib1f(1, rapid ? 1 : 0);
      gl.drawArrays(gl.LINES, 0, 2);
    }
  }

  // Returns kind and a corner of the polygon at a pixel of the picture; null: background.
  pick(x, y) {
    const gl = this.gl, { samples, height } = this.target, pixel = new Uint32Array(4);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target.frame);
    gl.readBuffer(gl.COLOR_ATTACHMENT2);
    gl.readPixels(Math.floor(samples * (x + 0.5)), Math.floor(samples * (height - y - 0.5)), 1, 1,
      gl.RGBA_INTEGER, gl.UNSIGNED_INT, pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    if (pixel[0] === 0) return null;
    return { kind: pixel[0] >>> 28, corner: (pixel[0] & 0xfffffff) - 1 };
  }
}
