// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of one program: the part at any line, with tool, path and fixtures; faces linked with
// the lines that cut them; measurements and a section.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
let lines = data.source || [];
const picked = document.getElementById("picked");
let selected = 0;
let view = null;
let player = null;

// --- Lengths -------------------------------------------------------------------------------------

let inInches = data.inches === true;
function numberText(mm) {
  const text = inInches ? (mm / 25.4).toFixed(4) : mm.toFixed(3);
  return Number(text) === 0 ? text.replace("-", "") : text;
}
function lengthText(mm) { return `${numberText(mm)} ${inInches ? "in" : "mm"}`; }
function timeText(milliseconds) {
  const s = Math.round(milliseconds / 1000), two = (n) => String(n).padStart(2, "0");
  return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
}

// Returns an element. Texts become text nodes, so markup in a program stays text.
function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (key in made && key !== "list") made[key] = value;
    else made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

// --- Source --------------------------------------------------------------------------------------

const box = document.getElementById("source");
const kWindow = 600;  // lines shown at a time
let firstShown = 1;

function showSource(from) {
  firstShown = Math.max(1, Math.min(from, lines.length - kWindow + 1));
  const rows = document.createDocumentFragment();
  for (let n = firstShown; n < firstShown + kWindow && n <= lines.length; n += 1) {
    const row = element("div", {}, element("i", { textContent: n }), lines[n - 1] || " ");
    row.dataset.line = n;
    if (data.marks[n]) row.className = data.marks[n];
    rows.append(row);
  }
  box.replaceChildren(rows);
}

function rowOf(n) { return box.querySelector(`[data-line="${n}"]`); }

// Marks a line of the source, by `className`, and scrolls the source alone to the line.
function markLine(n, className, scroll) {
  for (const old of box.querySelectorAll(`.${className}`)) old.classList.remove(className);
  if (n <= 0 || n > lines.length) return;
  if (!rowOf(n)) {
    if (!scroll) return;
    showSource(n - Math.floor(kWindow / 2));
    if (className !== "selected") markLine(selected, "selected", false);
  }
  const row = rowOf(n);
  row.classList.add(className);
  if (scroll) box.scrollTop = row.offsetTop - box.offsetTop - box.clientHeight / 2;
}

// Selects a line: its faces are highlighted.
function highlight(n, scroll = true) {
  selected = n;
  if (view) view.setAlarm(false);
  markLine(n, "selected", scroll);
  picked.replaceChildren();
  if (n > 0) {
    const removed = data.removed[n];
    picked.append(element("b", { textContent: `line ${n}` }), `  ${lines[n - 1] || ""}`,
      removed === undefined ? "" : `  — removed ${removed} mm³`);
  } else {
    picked.textContent = "uncut stock";
  }
  if (view) view.highlight(n);
}

// Selects a line and shows the part after the line.
function select(n, scroll = true) {
  highlight(n, scroll);
  if (n <= 0) return;
  if (player) player.goToLine(n);
  if (view && view.machine) view.machine.show(n);
  if (view) view.request();
}

box.addEventListener("keydown", (event) => {
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (!step || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  select(Math.max(1, Math.min(lines.length, selected + step)));
});
box.addEventListener("click", (event) => {
  const row = event.target.closest("[data-line]");
  if (row) select(Number(row.dataset.line), false);
});

// --- Findings ------------------------------------------------------------------------------------

function showFinding(item) {
  const [line, , point, isContact, bodies] =
    data.findings[item.dataset.finding] || [Number(item.dataset.line), "", [], false, []];
  if (line > 0) select(line);
  if (view) {
    if (point.length === 3) view.mark(point);
    if (player && line > 0 && isContact) {
      player.meet(line, point);
      view.setAlarm(true, bodies);
      view.showTip();
      if (view.machine) view.machine.showFinding(item.dataset.finding);
    }
  }
  document.getElementById("part").scrollIntoView({ block: "nearest" });
}
const findings = [...document.querySelectorAll(".finding[role=button]")];
for (const finding of findings) {
  finding.addEventListener("click", () => showFinding(finding));
  finding.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    showFinding(finding);
  });
}
let lastFinding = -1;
function nextFinding() {
  if (findings.length === 0) return;
  lastFinding = (lastFinding + 1) % findings.length;
  showFinding(findings[lastFinding]);
}

// --- Machine -------------------------------------------------------------------------------------

// Bodies of the links and of the tools. The part lies still, and the joints move the machine.
async function makeMachine(packed, renderer) {
  const lineOf = await numbersOf(packed.lines), tools = await numbersOf(packed.tools);
  const values = (await numbersOf(packed.values, 9)).map((v) => v);
  const value = (i, axis) => kPageUnit * values[9 * i + axis];
  const items = [], bodies = [];
  for (const body of packed.bodies) {
    const corners = await cornersOf(body.mesh);
    bodies.push({ ...body, corners });
    items.push({ mesh: renderer.mesh({ corners, normals: flatNormals(corners) }), kind: 5,
      colour: body.colour.map((c) => c / 255), matrix: Matrix.unit(), isShown: true });
  }
  function jointMatrix([axis, turns, direction, through], amount) {
    if (!turns) return Matrix.move(...direction.map((d) => d * amount));
    return Matrix.product(Matrix.move(...through),
      Matrix.product(Matrix.turn(direction, amount * Math.PI / 180),
        Matrix.move(...through.map((c) => -c))));
  }
  // Frame of the machine in the frame of the part, at present and before the first line.
  let frame = Matrix.unit();
  function indexOf(line) {
    let i = 0;
    while (i + 1 < lineOf.length && lineOf[i + 1] <= line) i += 1;
    return i;
  }
  // Places the bodies as after the line, or after the last line before it that moves.
  function show(line) {
    showPose(indexOf(line));
  }
  // Places the bodies where they meet.
  function showFinding(number) {
    if (packed.findings[number] !== undefined) showPose(packed.findings[number]);
  }
  function showPose(i) {
    const [x, y, z] = packed.zero;
    let toPart = Matrix.unit();
    for (const joint of packed.part_moved_by)
      toPart = Matrix.product(jointMatrix(joint, -value(i, joint[0])), toPart);
    toPart = Matrix.product(Matrix.move(-x, -y, -z), toPart);
    frame = toPart;
    packed.bodies.forEach((body, k) => {
      items[k].isShown = body.tool < 0 || body.tool === tools[i];
      items[k].matrix = body.moved_by.reduce((m, joint) =>
        Matrix.product(m, jointMatrix(joint, value(i, joint[0]))), toPart);
    });
  }
  // Returns the position of a point of a body in the frame of the part.
  function place(name, x, y, z) {
    const k = packed.bodies.findIndex((body, i) => body.name === name && items[i].isShown);
    return Matrix.apply(items[k].matrix, [x, y, z]);
  }
  show(0);
  const start = frame;
  // Returns the frame of a machine at rest in the frame of the part that moves.
  const rest = () => Matrix.product(frame, Matrix.inverseOfRigid(start));
  return { lines: lineOf, items, bodies, show, showFinding, place, rest };
}

// Returns the corners of the box around points, three numbers each.
function cornersOfBox(lists) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const list of lists) {
    for (let i = 0; i < list.length; i += 1) {
      low[i % 3] = Math.min(low[i % 3], list[i]);
      high[i % 3] = Math.max(high[i % 3], list[i]);
    }
  }
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 1, 2].map((a) => (k >> a & 1 ? high : low)[a]));
}

// --- View ----------------------------------------------------------------------------------------

const kPart = 1, kState = 2, kTool = 3, kFixture = 4, kDeviation = 6;
// Fixture that the tool meets at a finding (picture.cpp).
const kMetColour = [240, 150, 40].map((c) => c / 255);
const kViews = {
  iso: [-Math.PI / 3, Math.PI / 5], top: [-Math.PI / 2, Math.PI / 2],
  bottom: [-Math.PI / 2, -Math.PI / 2], front: [-Math.PI / 2, 0], back: [Math.PI / 2, 0],
  right: [0, 0], left: [Math.PI, 0],
};
const kLight = {
  background: [0.933, 0.945, 0.957], edge: [0.12, 0.16, 0.20], face: [0.82, 0.72, 0.52],
  chosen: [1.0, 0.87, 0.15], error: [0.86, 0.20, 0.20], feed: [0.09, 0.24, 0.54],
  rapid: [0.78, 0.17, 0.16], mark: [0.85, 0.10, 0.10],
};
const kDark = {
  background: [0.085, 0.10, 0.12], edge: [0.02, 0.03, 0.04], face: [0.72, 0.62, 0.42],
  chosen: [1.0, 0.87, 0.15], error: [0.90, 0.25, 0.25], feed: [1.0, 0.91, 0.44],
  rapid: [1.0, 0.41, 0.36], mark: [1.0, 0.35, 0.35],
};

async function makeView(holder) {
  const canvas = element("canvas", { tabIndex: 0, role: "img", "aria-label": "part in three dimensions" });
  const renderer = new Renderer(canvas);
  const marks = makeMarks(), legend = element("div", { className: "legend" });
  holder.append(canvas, marks.element, legend);
  const part = data.mesh ? await readPart(data.mesh) : null;
  const play = data.play ? await readPlay(data.play) : null;
  const deviation = data.deviation ? await readDeviation(data.deviation) : null;
  const paint = makePaint(part, play, deviation);
  const faulty = new Set(Object.keys(data.marks).filter((n) => data.marks[n] === "error").map(Number));
  // Returns for each corner the line, the colour of the tool (bits 27 to 30), and a bit for errors.
  const marked = (count, lineAt, toolAt) => {
    const all = new Uint32Array(count);
    for (let i = 0; i < count; i += 1) {
      const line = lineAt(i);
      all[i] = (line & 0x7ffffff | toolAt(i, line) << 27) + (faulty.has(line) ? 0x80000000 : 0);
    }
    return all;
  };
  const partMesh = part && part.corners.length ? renderer.mesh({ corners: part.corners,
    normals: part.normals,
    lines: marked(part.corners.length / 3, (i) => part.lines[(i / 3) | 0],
      (i, line) => paint.ofFace(part.tools[(i / 3) | 0], line)) }) : null;
  const deviationMesh = deviation ? renderer.mesh({ corners: deviation.corners,
    normals: flatNormals(deviation.corners), deviation: deviation.deviation }) : null;
  let stateMesh = null;
  const stateMatrix = play ? Matrix.product(Matrix.move(...play.states.origin),
    Matrix.scale(play.states.step)) : null;
  if (play) {
    const { corners, normals, polygonOf, lines: lineOf, first, end } = play.states;
    const life = new Uint16Array(2 * polygonOf.length);
    for (let i = 0; i < polygonOf.length; i += 1) {
      life[2 * i] = first[polygonOf[i]];
      life[2 * i + 1] = end[polygonOf[i]];
    }
    stateMesh = renderer.mesh({ corners, normals, life, matrix: stateMatrix,
      index: indexOfStates(play.states),
      lines: marked(polygonOf.length, (i) => lineOf[polygonOf[i]], (i, line) => paint.ofLine(line)) });
  }
  const fixtures = [];
  for (const body of data.fixtures || []) {
    const corners = await cornersOf(body);
    fixtures.push({ corners, colour: body.colour.map((c) => c / 255), name: body.name,
      mesh: renderer.mesh({ corners, normals: flatNormals(corners) }) });
  }
  const tools = (play ? play.bodies : []).map((tool) => tool.pieces.map((piece) => ({
    corners: piece.corners, colour: piece.colour.map((c) => c / 255),
    mesh: renderer.mesh({ corners: piece.corners, normals: flatNormals(piece.corners) }),
  })));
  // The path as pairs of points, and the number of points before each move.
  let path = null, pointsBefore = null;
  if (play) {
    pointsBefore = new Int32Array(play.lines.length + 1);
    for (let m = 0; m < play.lines.length; m += 1)
      pointsBefore[m + 1] = pointsBefore[m] + 2 * (play.last[m] - play.first[m]);
    const all = pointsBefore[play.lines.length];
    const points = new Float32Array(3 * all), rapid = new Uint8Array(all);
    for (let m = 0, at = 0; m < play.lines.length; m += 1) {
      for (let i = play.first[m]; i < play.last[m]; i += 1, at += 2) {
        for (let c = 0; c < 6; c += 1) points[3 * at + c] = play.points[3 * i + c];
        rapid[at] = rapid[at + 1] = play.rapid[m];
      }
    }
    path = renderer.path(points, rapid);
  }
  const machine = data.machine ? await makeMachine(data.machine, renderer) : null;

  const stock = data.stock;
  const centre = [0, 1, 2].map((i) => (stock[i] + stock[3 + i]) / 2);
  const corners = cornersOfBox([stock]);
  const radius = norm(minus([stock[3], stock[4], stock[5]], centre)) || 1;
  const withFixtures = fixtures.length ? cornersOfBox([corners.flat(),
    ...fixtures.map((body) => body.corners)]) : corners;
  let extent = radius;
  const shown = { part: true, path: true, tool: true, fixtures: true, machine: Boolean(machine),
    axes: true };
  const camera = { target: centre, azimuth: kViews.iso[0], height: kViews.iso[1], distance: 1 };
  const kFieldOfView = 25 * Math.PI / 180, kHeightOfButtons = 34;
  let chosen = 0, state = play ? play.states.stateMoves.length - 1 : 0;
  let moves = play ? play.lines.length : 0, tip = null;
  let section = null, segments = [], matrix = Matrix.unit(), eye = [0, 0, 0];
  let isMachineAtRest = true, alarm = false, met = [], legendOf = -1;
  let isDark = false, isWaiting = false, pixelRatio = 1, frames = 0;
  let isFitted = true;  // the camera is as fit() left it

  // Frame in which the camera is at rest, in the frame of the part.
  function rest() {
    return machine && shown.machine && isMachineAtRest ? machine.rest() : Matrix.unit();
  }
  // Axes of the camera in the frame of the part: right, up, and towards the viewer.
  function frameOfCamera() {
    const frame = rest();
    return axesOfCamera().map((axis) => Matrix.turned(frame, axis));
  }
  function axesOfCamera() {
    const { azimuth: a, height: h } = camera;
    const back = [Math.cos(h) * Math.cos(a), Math.cos(h) * Math.sin(a), Math.sin(h)];
    const right = [-Math.sin(a), Math.cos(a), 0];
    return [right, cross(back, right), back];
  }

  // Moves the camera so that the stock fills the picture.
  function fit() {
    const [right, up, back] = frameOfCamera();
    const wide = canvas.clientWidth / Math.max(1, canvas.clientHeight);
    const tangent = Math.tan(kFieldOfView / 2);
    // Share of the height below the buttons of the views.
    const free = Math.max(0.7, 1 - kHeightOfButtons / Math.max(1, canvas.clientHeight));
    const around = shown.machine && machine ? machineCorners() :
      shown.fixtures ? withFixtures : corners;
    // The middle of the extent on the picture, then the distance at which each corner is inside.
    const range = (axis) => {
      const all = around.map((p) => dot(p, axis));
      return [Math.min(...all), Math.max(...all)];
    };
    const [[x0, x1], [y0, y1], [z0, z1]] = [right, up, back].map(range);
    camera.target = plus(plus(right.map((c) => c * (x0 + x1) / 2), up, (y0 + y1) / 2), back,
      (z0 + z1) / 2);
    let distance = 4 * Math.max(radius, extent);
    for (let round = 0; round < 4; round += 1) {
      // Perspective moves the middle of the picture.
      const all = around.map((p) => minus(p, camera.target)).map((q) =>
        [dot(q, right) / (distance - dot(q, back)), dot(q, up) / (distance - dot(q, back))]);
      for (const [i, axis] of [[0, right], [1, up]]) {
        const ends = all.map((p) => p[i]);
        camera.target = plus(camera.target, axis,
          distance * (Math.min(...ends) + Math.max(...ends)) / 2);
      }
      distance = 0;
      for (const p of around) {
        const q = minus(p, camera.target);
        distance = Math.max(distance, dot(q, back) + 1.06 * Math.max(
          Math.abs(dot(q, right)) / (tangent * wide), Math.abs(dot(q, up)) / (tangent * free)));
      }
    }
    camera.target = plus(camera.target, up, distance * tangent * (1 - free));
    camera.distance = distance;
    camera.target = Matrix.apply(Matrix.inverseOfRigid(rest()), camera.target);
    isFitted = true;
  }
  function machineCorners() {
    const points = machine.items.map((item, k) => {
      const c = machine.bodies[k].corners, all = [];
      for (let i = 0; i < c.length; i += 9) all.push(...Matrix.apply(item.matrix, [c[i], c[i + 1], c[i + 2]]));
      return all;
    });
    const all = cornersOfBox(points);
    extent = norm(minus(all[7], all[0])) / 2;
    return all;
  }

  function place() {
    const [right, up, back] = frameOfCamera();
    eye = plus(Matrix.apply(rest(), camera.target), back, camera.distance);
    const wide = canvas.clientWidth / Math.max(1, canvas.clientHeight);
    const near = Math.max(camera.distance / 200, camera.distance - 6 * Math.max(radius, extent));
    const far = camera.distance + 8 * Math.max(radius, extent);
    const f = 1 / Math.tan(kFieldOfView / 2);
    const projection = [f / wide, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
      2 * far * near / (near - far), 0];
    const world = [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2],
      back[2], 0, -dot(right, eye), -dot(up, eye), -dot(back, eye), 1];
    matrix = Matrix.product(projection, world);
    const lamp = unitVector(plus(plus(back, up, 0.45), right, -0.25));
    return { camera: matrix, eye, near, far, lamp };
  }

  // True if the finished part is shown instead of a recorded state.
  function isFinished() {
    return partMesh !== null && (!play || state === play.states.stateMoves.length - 1);
  }

  function toolMatrix() { return tip ? Matrix.along(tip.axis, tip.at) : Matrix.unit(); }

  function draw() {
    isWaiting = false;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (width === 0 || height === 0) return;
    pixelRatio = Math.min(window.devicePixelRatio || 1, Math.sqrt(9e6 / (width * height)));
    renderer.resize(Math.max(1, Math.round(width * pixelRatio)),
      Math.max(1, Math.round(height * pixelRatio)));
    const placed = place();
    const meshes = [];
    // Only the finished part is compared with the design.
    const colouring = paint.colouring === 3 && !isFinished() ? 0 : paint.colouring;
    if (legendOf !== colouring) updateLegend(colouring);
    if (shown.part) {
      if (colouring === 3) {
        meshes.push({ mesh: deviationMesh, kind: kDeviation, isPart: true, isSectioned: true });
      } else if (isFinished()) meshes.push({ mesh: partMesh, kind: kPart, isPart: true, isSectioned: true });
      else meshes.push({ mesh: stateMesh, kind: kState, isPart: true, isSectioned: true });
    }
    if (shown.fixtures) {
      for (const body of fixtures) {
        meshes.push({ mesh: body.mesh, kind: kFixture, isSectioned: true,
          colour: met.includes(body.name) ? kMetColour : body.colour });
      }
    }
    if (shown.machine && machine) {
      const isToolMet = met.includes("the tool") || !met.some((name) => name.startsWith("the link "));
      const colours = isDark ? kDark : kLight;
      machine.items.forEach((item, k) => {
        const { name, tool } = machine.bodies[k];
        const isMet = alarm && (tool >= 0 ? isToolMet : met.includes(`the link '${name}'`));
        const colour = isMet ? (tool >= 0 ? colours.error : kMetColour) : item.colour;
        if (item.isShown) meshes.push({ ...item, colour });
      });
    }
    if (shown.tool && tip && !(shown.machine && machine)) {
      for (const piece of tools[tip.tool]) {
        meshes.push({ mesh: piece.mesh, kind: kTool, matrix: toolMatrix(),
          colour: alarm ? (isDark ? kDark : kLight).error : piece.colour, isSheer: true });
      }
    }
    const scene = { view: placed, colours: isDark ? kDark : kLight, section,
      paint: { ...paint, colouring }, meshes, chosen, state,
      paths: [], segments: [...segments] };
    if (shown.path && path && moves > 0) {
      const whole = Math.min(Math.floor(moves), play.lines.length);
      scene.paths.push({ path, first: 0, count: pointsBefore[whole] });
      if (tip && tip.from) {
        scene.segments.push({ from: tip.from, to: tip.at, colour: scene.colours.feed,
          rapid: tip.rapid });
      }
    }
    renderer.draw(scene);
    const zero = Matrix.apply(matrix, [0, 0, 0]);
    marks.place(frameOfCamera(), shown.axes && zero[2] < 1 ? { x: (zero[0] + 1) / 2 * width,
      y: (1 - zero[1]) / 2 * height } : null, width, height);
    marks.element.style.visibility = shown.axes ? "visible" : "hidden";
    frames += 1;
  }
  function updateLegend(colouring = legendOf) {
    legendOf = colouring;
    showLegend(legend, { ...paint, colouring }, deviation);
  }
  function request() {
    if (isWaiting) return;
    isWaiting = true;
    window.requestAnimationFrame(draw);
  }

  // Ray of a point of the canvas (CSS pixels).
  function rayThrough(x, y) {
    const [right, up, back] = frameOfCamera();
    const wide = canvas.clientWidth / canvas.clientHeight, tangent = Math.tan(kFieldOfView / 2);
    return plus(plus(back.map((c) => -c), right, tangent * wide * (2 * x / canvas.clientWidth - 1)),
      up, tangent * (1 - 2 * y / canvas.clientHeight));
  }
  // Returns the corners of the polygon that a hit is on, in mm.
  function cornersOfHit(hit) {
    const source = hit.kind === kPart ? part.corners : play.states.corners;
    const p = hit.kind === kPart ? 0 : play.states.polygonOf[hit.corner];
    const begin = hit.kind === kPart ? hit.corner - hit.corner % 3 : play.states.starts[p];
    const end = hit.kind === kPart ? begin + 3 : play.states.starts[p + 1];
    const all = [];
    for (let i = begin; i < end; i += 1) {
      const at = [source[3 * i], source[3 * i + 1], source[3 * i + 2]];
      all.push(hit.kind === kPart ? at : Matrix.apply(stateMatrix, at));
    }
    return all;
  }
  // Returns the normal of a plane polygon: the sum over its triangles.
  function normalOfCorners(all) {
    let sum = [0, 0, 0];
    for (let i = 1; i + 1 < all.length; i += 1)
      sum = plus(sum, cross(minus(all[i], all[0]), minus(all[i + 1], all[0])));
    return unitVector(sum);
  }
  // Returns the extent along an axis of all faces of a form: the depth of a bore.
  function lengthAlong(axis, form) {
    let low = Infinity, high = -Infinity;
    for (let t = 0; t < part.formOf.length; t += 1) {
      if (part.formOf[t] !== form) continue;
      for (let i = 9 * t; i < 9 * t + 9; i += 3) {
        const at = axis[0] * part.corners[i] + axis[1] * part.corners[i + 1] +
          axis[2] * part.corners[i + 2];
        low = Math.min(low, at);
        high = Math.max(high, at);
      }
    }
    return high - low;
  }
  // Returns the face at a point of the canvas; null: no face of the part.
  function pick(x, y) {
    draw();
    const hit = renderer.pick(x * pixelRatio, y * pixelRatio);
    if (!hit) return null;
    const ray = rayThrough(x, y);
    if (hit.kind === 7) {
      const t = (section[3] - dot(section, eye)) / dot(section, ray);
      return { line: null, point: plus(eye, ray, t), normal: section.slice(0, 3), form: null };
    }
    if (hit.kind === kDeviation) {
      const at = hit.corner - hit.corner % 3, c = deviation.corners;
      const [a, b, d] = [0, 3, 6].map((k) => [0, 1, 2].map((i) => c[3 * at + k + i]));
      const normal = unitVector(cross(minus(b, a), minus(d, a)));
      const point = plus(eye, ray, dot(normal, minus(a, eye)) / (dot(normal, ray) || 1));
      return { line: null, point, normal, form: null, away: deviation.deviation[at] };
    }
    if (hit.kind !== kPart && hit.kind !== kState) return null;
    const around = cornersOfHit(hit), normal = normalOfCorners(around);
    const along = dot(normal, ray);
    let point = plus(eye, ray, dot(normal, minus(around[0], eye)) / (along || 1));
    // A corner of the face that is near on the picture is meant exactly.
    for (const corner of around) {
      const p = project(...corner), frame = canvas.getBoundingClientRect();
      if (Math.hypot(p.x - frame.left - x, p.y - frame.top - y) < 7) point = corner;
    }
    const result = { point, normal, form: null, tool: 0 };
    if (hit.kind === kPart) {
      const triangle = Math.floor(hit.corner / 3), form = part.formOf[triangle];
      result.line = part.lines[triangle];
      result.tool = part.tools[triangle];
      if (form > 0) {
        result.form = part.forms[form - 1];
        result.length = lengthAlong(result.form[2], form);
      }
    } else {
      result.line = play.states.lines[play.states.polygonOf[hit.corner]];
    }
    return result;
  }
  function project(x, y, z) {
    place();
    const p = Matrix.apply(matrix, [x, y, z]), frame = canvas.getBoundingClientRect();
    return { x: frame.left + (p[0] + 1) / 2 * frame.width,
      y: frame.top + (1 - p[1]) / 2 * frame.height };
  }

  function setView(name) {
    [camera.azimuth, camera.height] = kViews[name];
    fit();
    request();
  }

  addGestures(canvas, {
    turn(dx, dy) {
      isFitted = false;
      camera.azimuth -= dx / 150;
      camera.height = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, camera.height + dy / 150));
      request();
    },
    shift(dx, dy) {
      isFitted = false;
      const [right, up] = axesOfCamera();
      const step = 2 * camera.distance * Math.tan(kFieldOfView / 2) / canvas.clientHeight;
      camera.target = plus(plus(camera.target, right, -dx * step), up, dy * step);
      request();
    },
    zoom(factor) {
      isFitted = false;
      camera.distance = Math.max(radius / 50, Math.min(40 * Math.max(radius, extent),
        camera.distance * factor));
      request();
    },
    click(x, y) { showPicked(pick(x, y)); },
  });
  new ResizeObserver(() => {
    if (isFitted && canvas.clientWidth > 0) fit();
    request();
  }).observe(canvas);

  fit();
  const made = {
    canvas, machine, play, part, shown, camera, request, draw, pick, project, setView, fit: () => {
      fit();
      request();
    },
    triangles: part ? part.lines.length : 0,
    stateTriangles: play ? play.states.triangles : 0,
    uploaded: () => renderer.uploaded,
    frames: () => frames,
    highlight(line) { chosen = Math.max(0, line); request(); },
    // Moves the camera if the tip is outside of the picture.
    showTip() {
      if (!tip) return;
      const p = project(...tip.at), frame = canvas.getBoundingClientRect();
      const isSeen = p.x > frame.left + 40 && p.x < frame.right - 40 &&
        p.y > frame.top + frame.height * 0.35 && p.y < frame.bottom - 40;
      if (isSeen) return;
      isFitted = false;
      const inRest = Matrix.apply(Matrix.inverseOfRigid(rest()), tip.at);
      camera.target = plus(camera.target.map((c) => c / 2), inRest, 0.5);
      camera.distance *= 1.3;
      request();
    },
    setDark(dark) { isDark = dark; request(); },
    // Shows the part after `count` moves, with the tip where `tipNow` says.
    show(count, stateNow, tipNow) {
      moves = count;
      state = stateNow;
      tip = tipNow;
      request();
    },
    state: () => state,
    volume: () => (play ? volumeOfState(play.states, state) : NaN),
    setSection(plane) { section = plane; request(); },
    section: () => section,
    paint, deviation,
    setMachineAtRest(isAtRest) {
      isMachineAtRest = isAtRest;
      fit();
      request();
    },
    // Draws the tool in the colour of errors, and marks the bodies with these names.
    setAlarm(isOn, bodies = []) {
      alarm = isOn;
      met = bodies;
      request();
    },
    setColouring(name) {
      paint.colouring = kColours.indexOf(name);
      request();
    },
    updateLegend: () => updateLegend(),
    setSegments(all) {
      const { mark } = isDark ? kDark : kLight;
      segments = all.map(([from, to]) => ({ from, to, colour: mark, rapid: false }));
      request();
    },
    // Marks a point with a cross and turns the camera to it.
    mark(point) {
      const size = radius / 12;
      this.setSegments([0, 1, 2].map((axis) => {
        const step = [0, 0, 0];
        step[axis] = size;
        return [minus(point, step), plus(point, step)];
      }));
      isFitted = false;
      camera.target = Matrix.apply(Matrix.inverseOfRigid(rest()), point);
      camera.distance = Math.min(camera.distance, 5 * radius);
      request();
    },
  };
  draw();
  return made;
}

// Left: turn; right, shift or two fingers: move; wheel or two fingers: nearer.
function addGestures(canvas, on) {
  const pointers = new Map();
  let moved = 0, isShift = false;
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    if (pointers.size === 0) moved = 0;
    isShift = event.button === 2 || event.button === 1 || event.shiftKey;
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const old = pointers.get(event.pointerId);
    if (!old) return;
    const dx = event.clientX - old[0], dy = event.clientY - old[1];
    moved += Math.abs(dx) + Math.abs(dy);
    if (pointers.size === 2) {
      const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      const before = Math.hypot(old[0] - other[0], old[1] - other[1]);
      const after = Math.hypot(event.clientX - other[0], event.clientY - other[1]);
      if (after > 0) on.zoom(before / after);
      on.shift(dx / 2, dy / 2);
    } else if (isShift) {
      on.shift(dx, dy);
    } else if (moved > 3) {
      on.turn(dx, dy);
    }
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  const end = (event) => {
    if (!pointers.delete(event.pointerId) || pointers.size > 0 || moved > 4) return;
    if (event.type !== "pointerup" || event.button > 0) return;
    const frame = canvas.getBoundingClientRect();
    on.click(event.clientX - frame.left, event.clientY - frame.top);
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    on.zoom(Math.exp(Math.max(-120, Math.min(120, event.deltaY)) / 500));
  }, { passive: false });
}

// --- Questions -----------------------------------------------------------------------------------

let isMeasuring = false;
let measured = [];

// Returns name and size of the surface of a face: "bore ⌀ 10.000 mm".
function formText(hit) {
  if (!hit.form) {
    return Math.abs(hit.normal[2]) > 0.9999 ? `plane Z ${numberText(hit.point[2])}` : "";
  }
  const [name, sizes, axis, origin, hollow] = hit.form;
  if (name === "cylinder") {
    const upright = Math.abs(axis[2]) > 0.9999 ?
      `, axis X ${numberText(origin[0])} Y ${numberText(origin[1])}` : "";
    return `${hollow ? "hollow " : ""}cylinder ⌀ ${lengthText(sizes[0])}, length ` +
      `${lengthText(hit.length)}${upright}`;
  }
  if (name === "cone") return `${hollow ? "hollow " : ""}cone ${sizes[0].toFixed(2)}°`;
  if (name === "sphere") return `${hollow ? "hollow " : ""}sphere ⌀ ${lengthText(sizes[0])}`;
  if (name === "torus") return `torus ⌀ ${lengthText(sizes[0])}, tube ⌀ ${lengthText(sizes[1])}`;
  if (name === "plane" && Math.abs(hit.normal[2]) > 0.9999)
    return `plane Z ${numberText(hit.point[2])}`;
  return name;
}

function toolName(number) {
  const prefix = `T${number} `;
  const found = data.play && data.play.toolBodies.find((tool) => `${tool.name} `.startsWith(prefix));
  return found ? found.name : `T${number}`;
}

function distanceFromDesign(mm) {
  if (Math.abs(mm) < 5e-4) return "on the design";
  return `${lengthText(Math.abs(mm))} ${mm < 0 ? "inside" : "outside"} of the design: ` +
    (mm < 0 ? "gouge" : "material is left");
}

function showPicked(hit) {
  if (!hit) return;
  if (hit.line === null) {
    picked.replaceChildren(hit.away === undefined ? "section" : distanceFromDesign(hit.away));
  } else {
    highlight(hit.line);
    if (hit.line > 0 && hit.tool > 0) picked.append(`  — ${toolName(hit.tool)}`);
    if (hit.line === 0 && hit.tool > 0)
      picked.replaceChildren(`cut in an earlier set-up  — ${toolName(hit.tool)}`);
    if (hit.line > 0 && player) {
      picked.append(" ", element("button", { type: "button", textContent: "show this line",
        onclick: () => select(hit.line) }));
    }
  }
  const [x, y, z] = hit.point.map(numberText);
  const form = hit.line === null ? "" : formText(hit);
  picked.append(element("br"), `${form ? `${form} · ` : ""}X ${x} Y ${y} Z ${z} · ` +
    `${lengthText(data.stock[5] - hit.point[2])} below the top of the stock`);
  if (!isMeasuring) return;
  measured = measured.length === 1 ? [measured[0], hit] : [hit];
  if (measured.length === 1) {
    view.mark(hit.point);
    picked.append(element("br"), "click the second point");
  } else {
    view.setSegments([[measured[0].point, hit.point]]);
    picked.append(element("br"), distanceText(...measured));
  }
}

function distanceText(a, b) {
  const d = minus(b.point, a.point);
  let text = `distance ${lengthText(norm(d))} · ΔX ${numberText(d[0])} ΔY ${numberText(d[1])} ` +
    `ΔZ ${numberText(d[2])}`;
  const isCylinder = (hit) => hit.form && hit.form[0] === "cylinder";
  if (isCylinder(a) && isCylinder(b)) {
    const [, , axis, from] = a.form, [, , other, to] = b.form;
    if (Math.abs(dot(axis, other)) > 0.99999) {
      const across = cross(minus(to, from), axis);
      text += ` · between the axes ${lengthText(norm(across))}`;
    }
  } else if (!isCylinder(a) && !isCylinder(b) && Math.abs(dot(a.normal, b.normal)) > 0.99999) {
    text += ` · between the planes ${lengthText(Math.abs(dot(d, a.normal)))}`;
  }
  return text;
}

// --- Player --------------------------------------------------------------------------------------

const kSpeeds = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

function makePlayer(play) {
  const count = play.lines.length;
  const endOf = (m) => play.milliseconds[m], startOf = (m) => (m > 0 ? play.milliseconds[m - 1] : 0);
  const slider = element("input", { type: "range", min: 0, max: count, step: 1, value: count,
    "aria-label": "move of the program" });
  const button = element("button", { type: "button", title: "play (space)", textContent: "▶",
    "aria-label": "play" });
  const where = element("output", { "aria-live": "off" });
  const speed = element("select", { title: "speed", "aria-label": "speed" },
    ...kSpeeds.map((s) => element("option", { value: s, textContent: `× ${s}` })));
  // Plays a program in about a minute.
  speed.value = kSpeeds.find((s) => count === 0 || endOf(count - 1) / s < 60000) || 1000;
  let moves = count, clock = count > 0 ? endOf(count - 1) : 0, isPlaying = false, before = 0;

  function stateOf(m) {
    const at = play.states.stateMoves;
    let low = 0, high = at.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (at[middle] <= m) low = middle;
      else high = middle - 1;
    }
    return low;
  }
  // Position of the tip: `share` of the move after `m` completed moves.
  function tipAt(m, share) {
    if (count === 0) return null;
    const move = Math.min(m, count - 1), part = m >= count ? 1 : share;
    const first = play.first[move], last = play.last[move];
    const point = (i) => [play.points[3 * i], play.points[3 * i + 1], play.points[3 * i + 2]];
    const axis = (i) => (play.axes.length ? unitVector([play.axes[3 * i], play.axes[3 * i + 1],
      play.axes[3 * i + 2]]) : [0, 0, 1]);
    if (m > 0 && m < count && share === 0) {
      const end = play.last[m - 1];
      return { at: point(end), axis: axis(end), tool: play.tools[m - 1], from: null };
    }
    let length = 0;
    for (let i = first; i < last; i += 1) length += norm(minus(point(i + 1), point(i)));
    let rest = part * length;
    for (let i = first; i < last; i += 1) {
      const a = point(i), b = point(i + 1), step = norm(minus(b, a));
      if (rest <= step || i + 1 === last) {
        const t = step > 0 ? Math.min(1, rest / step) : 1;
        return { at: plus(a, minus(b, a), t), tool: play.tools[move], from: a,
          axis: unitVector(plus(axis(i), minus(axis(i + 1), axis(i)), t)), rapid: play.rapid[move] };
      }
      rest -= step;
    }
    return { at: point(last), axis: axis(last), tool: play.tools[move], from: null };
  }
  // Shows the part after a line, and the tool where it is nearest to a point of a finding.
  function meet(line, point) {
    const kMostMoves = 400, kSteps = 24;
    goToLine(line);
    if (point.length !== 3) return;
    let nearest = Infinity, best = null;
    for (let m = moves - 1, n = 0; m >= 0 && n < kMostMoves && play.lines[m] === line; m -= 1, n += 1) {
      for (let i = 1; i <= kSteps; i += 1) {
        const tip = tipAt(m, i / kSteps), away = norm(minus(tip.at, point));
        if (away < nearest) [nearest, best] = [away, tip];
      }
    }
    if (best) view.show(moves, stateOf(moves), best);
  }
  function lineNow() { return moves > 0 ? play.lines[moves - 1] : 0; }
  function show(share = 0) {
    const state = stateOf(moves);
    view.setAlarm(false);
    view.show(moves, state, tipAt(moves, share));
    slider.value = moves;
    slider.setAttribute("aria-valuetext", `line ${moves > 0 ? play.lines[moves - 1] : 0}`);
    const line = share > 0 && moves < count ? play.lines[moves] : lineNow();
    const cut = play.states.stateLines[state];
    const isExact = play.states.stateMoves[state] === moves || state + 1 === play.states.stateMoves.length;
    const tool = count > 0 ? play.bodies[play.tools[Math.min(Math.max(moves - 1, 0), count - 1)]].name : "";
    where.textContent = `line ${line} · ${timeText(clock)} · ` +
      (isExact ? "" : `cut as after line ${cut} · `) + tool;
    where.title = where.textContent;
    markLine(line, "current", isPlaying || share > 0);
    if (view.machine) view.machine.show(line);
  }
  function goTo(m) {
    moves = Math.max(0, Math.min(count, m));
    clock = moves > 0 ? endOf(moves - 1) : 0;
    show();
  }
  // Shows the part after the last move of the line, or after the moves before the line.
  function goToLine(line) {
    let m = -1;
    for (let i = 0; i < count; i += 1) if (play.lines[i] === line) m = i;
    if (m < 0) for (let i = 0; i < count && play.lines[i] <= line; i += 1) m = i;
    goTo(m + 1);
  }
  function tick(now) {
    if (!isPlaying) return;
    clock += (now - before) * Number(speed.value);
    before = now;
    while (moves < count && endOf(moves) <= clock) moves += 1;
    if (moves >= count) {
      goTo(count);
      setPlaying(false);
      return;
    }
    const length = endOf(moves) - startOf(moves);
    show(length > 0 ? Math.max(0, clock - startOf(moves)) / length : 0);
    window.requestAnimationFrame(tick);
  }
  function setPlaying(on) {
    isPlaying = on;
    button.textContent = on ? "❚❚" : "▶";
    if (!on) return;
    if (moves >= count) goTo(0);
    before = performance.now();
    window.requestAnimationFrame(tick);
  }
  function toolChange(step) {
    let m = moves + (step > 0 ? 0 : -1);
    const toolBefore = (i) => play.tools[Math.max(0, Math.min(count - 1, i - 1))];
    for (m += step; m > 0 && m < count; m += step) if (play.tools[m] !== toolBefore(m)) return goTo(m);
    return goTo(step > 0 ? count : 0);
  }
  slider.addEventListener("input", () => {
    setPlaying(false);
    goTo(Number(slider.value));
  });
  button.addEventListener("click", () => setPlaying(!isPlaying));
  const small = (text, title, action) =>
    element("button", { type: "button", textContent: text, title, "aria-label": title,
      onclick: action });
  const bar = element("div", { className: "bar", id: "player" }, button,
    small("|◀", "to the start", () => goTo(0)), small("−1", "previous move (←)", () => goTo(moves - 1)),
    small("+1", "next move (→)", () => goTo(moves + 1)), small("▶|", "to the end", () => goTo(count)),
    small("T−", "previous tool change", () => toolChange(-1)),
    small("T+", "next tool change", () => toolChange(1)));
  if (findings.length) bar.append(small("!", "next finding (F)", nextFinding));
  bar.append(speed, slider, where);
  return { bar, goTo, goToLine, meet, setPlaying, toggle: () => setPlaying(!isPlaying), moves: () => moves,
    count, isPlaying: () => isPlaying, show, line: lineNow,
    state: () => stateOf(moves) };
}

// --- Tools of the view ---------------------------------------------------------------------------

function makeTools() {
  const bar = element("div", { className: "bar", id: "tools" });
  const toggle = (name, key, text) => {
    const input = element("input", { type: "checkbox", checked: view.shown[name] });
    input.addEventListener("change", () => {
      view.shown[name] = input.checked;
      if (name === "machine") view.fit();
      view.request();
    });
    bar.append(element("label", { title: key ? `${text} (${key})` : text }, input, ` ${text}`));
    return input;
  };
  const boxes = { part: toggle("part", "", "part") };
  if (view.play) {
    boxes.path = toggle("path", "P", "path");
    boxes.tool = toggle("tool", "", "tool");
  }
  if ((data.fixtures || []).length) boxes.fixtures = toggle("fixtures", "X", "fixtures");
  if (view.machine) boxes.machine = toggle("machine", "", "machine");
  boxes.axes = toggle("axes", "A", "axes");
  const colour = element("select", { "aria-label": "colours", title: "colours (C)" },
    ...kColours.filter((name) => name !== "design" || view.deviation).map((name) =>
      element("option", { value: name,
        textContent: name === "design" ? "from design" : `by ${name}` })));
  colour.addEventListener("change", () => {
    view.setColouring(colour.value);
    if (colour.value === "design" && player) player.goTo(player.count);
  });
  bar.append(colour);
  if (view.machine) {
    const frame = element("select", { "aria-label": "frame", title: "what is at rest" },
      element("option", { value: "machine", textContent: "machine at rest" }),
      element("option", { value: "part", textContent: "part at rest" }));
    frame.addEventListener("change", () => view.setMachineAtRest(frame.value === "machine"));
    bar.append(frame);
  }

  const axis = element("select", { "aria-label": "section", title: "section (S)" },
    ...["no section", "section X", "section Y", "section Z"].map((text, i) =>
      element("option", { value: i - 1, textContent: text })));
  const at = element("input", { type: "range", min: 0, max: 1000, value: 500,
    "aria-label": "position of the section", id: "sectionAt" });
  const flip = element("input", { type: "checkbox" });
  const flipLabel = element("label", { title: "keep the other side" }, flip, " flip");
  const value = element("output", {});
  function cut() {
    const a = Number(axis.value);
    at.hidden = flipLabel.hidden = a < 0;
    if (a < 0) {
      value.textContent = "";
      view.setSection(null);
      return;
    }
    const low = data.stock[a], high = data.stock[3 + a];
    const position = low + (high - low) * Number(at.value) / 1000;
    // Keeps the side that is away from the usual place of the camera.
    const sign = (a === 1 ? -1 : 1) * (flip.checked ? -1 : 1);
    const plane = [0, 0, 0, sign * position];
    plane[a] = sign;
    view.setSection(plane);
    value.textContent = `${"XYZ"[a]} ${numberText(position)}`;
  }
  for (const input of [axis, at, flip]) input.addEventListener("input", cut);
  const measure = element("input", { type: "checkbox", id: "measure" });
  measure.addEventListener("change", () => {
    isMeasuring = measure.checked;
    measured = [];
    view.setSegments([]);
    picked.textContent = isMeasuring ? "click the first point" : "";
  });
  const unit = element("select", { "aria-label": "unit", title: "unit (U)" },
    element("option", { value: "mm", textContent: "mm" }),
    element("option", { value: "inch", textContent: "inch" }));
  unit.value = inInches ? "inch" : "mm";
  unit.addEventListener("change", () => {
    inInches = unit.value === "inch";
    cut();
    view.updateLegend();
  });
  bar.append(axis, at, flipLabel, value,
    element("label", { title: "distance of two points (M)" }, measure, " measure"), unit);
  const views = element("div", { className: "bar", id: "views" });
  Object.keys(kViews).forEach((name, i) => {
    views.append(element("button", { type: "button", textContent: name, title: `view: ${name} (${i + 1})`,
      onclick: () => view.setView(name) }));
  });
  const theme = element("button", { type: "button", textContent: "◐", title: "light or dark",
    "aria-label": "light or dark" });
  const prefersDark = window.matchMedia("(prefers-color-scheme: dark)");
  let dark = prefersDark.matches;
  const apply = () => {
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    view.setDark(dark);
  };
  theme.addEventListener("click", () => { dark = !dark; apply(); });
  prefersDark.addEventListener("change", () => { dark = prefersDark.matches; apply(); });
  views.append(element("button", { type: "button", textContent: "fit", title: "fit (0)",
    onclick: () => view.fit() }));
  view.canvas.parentNode.append(views);
  bar.append(theme);
  cut();
  apply();
  const flipBox = (input) => { input.checked = !input.checked; input.dispatchEvent(new Event("change")); };
  const keys = {
    p: () => boxes.path && flipBox(boxes.path), x: () => boxes.fixtures && flipBox(boxes.fixtures),
    a: () => flipBox(boxes.axes), m: () => flipBox(measure), f: nextFinding,
    c: () => setControl(colour, colour.options[(colour.selectedIndex + 1) % colour.length].value), 0: () => view.fit(),
    u: () => { unit.value = inInches ? "mm" : "inch"; unit.dispatchEvent(new Event("change")); },
    s: () => { axis.value = (Number(axis.value) + 2) % 4 - 1; cut(); },
    " ": () => player && player.toggle(),
    ArrowLeft: () => player && player.goTo(player.moves() - 1),
    ArrowRight: () => player && player.goTo(player.moves() + 1),
    Home: () => player && player.goTo(0), End: () => player && player.goTo(player.count),
  };
  Object.keys(kViews).forEach((name, i) => { keys[i + 1] = () => view.setView(name); });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.target.closest && event.target.closest("input, select, button, #source, .finding")) return;
    const action = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
  // Sets the section at a place along an axis, mm; null: in the middle.
  const setSection = (number, place) => {
    const low = data.stock[number], high = data.stock[3 + number];
    axis.value = number;
    if (place !== null) at.value = Math.round(1000 * (place - low) / (high - low));
    cut();
  };
  const setDark = (isDark) => {
    dark = isDark;
    apply();
  };
  return { bar, boxes, unit, colour, setSection, setDark };
}

// --- Start ---------------------------------------------------------------------------------------

async function start() {
  if (data.packedSource)
    lines = new TextDecoder().decode(await inflated(data.packedSource)).split("\n").slice(0, -1);
  showSource(1);
  const holder = document.getElementById("view");
  if (!holder) return;
  try {
    view = await makeView(holder);
  } catch (error) {
    holder.remove();
    document.getElementById("controls").remove();
    picked.textContent = `The part is not shown: ${error.message}`;
    return;
  }
  window.ncsim.view = view;
  const controls = document.getElementById("controls");
  if (view.play) {
    player = makePlayer(view.play);
    window.ncsim.player = player;
    controls.append(player.bar);
  }
  const tools = makeTools();
  controls.append(tools.bar);
  if (player) player.goTo(player.count);
  view.fit();
  picked.textContent = "Click a face for its line and size, or a line for the part after the line.";
  const pictures = document.getElementById("pictures");
  if (pictures) pictures.open = false;
  followLink(tools);
  window.addEventListener("hashchange", () => followLink(tools));
}
window.ncsim = { select, view, player, selected: () => selected };
window.ncsim.ready = start();
