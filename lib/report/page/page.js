// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of one program: the part in three dimensions, each face linked with the line that cut
// it, and the lines with their faces.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const lines = data.source;
const picked = document.getElementById("picked");
let selected = 0;
let view = null;

function bytes(text, Type) {
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i += 1) out[i] = raw.charCodeAt(i);
  return new Type(out.buffer);
}

// --- Source -------------------------------------------------------------------------------------

const box = document.getElementById("source");
const kWindow = 1500;  // lines shown at a time
let first = 1;

function showSource(from) {
  first = Math.max(1, Math.min(from, lines.length - kWindow + 1));
  const rows = document.createDocumentFragment();
  for (let n = first; n < first + kWindow && n <= lines.length; n += 1) {
    const row = document.createElement("div");
    const number = document.createElement("i");
    number.textContent = n;
    row.append(number, lines[n - 1] || " ");
    row.dataset.line = n;
    if (data.marks[n]) row.className = data.marks[n];
    rows.append(row);
  }
  box.replaceChildren(rows);
}

function rowOf(n) { return box.querySelector(`[data-line="${n}"]`); }

function select(n, scroll = true) {
  const old = rowOf(selected);
  if (old) old.classList.remove("selected");
  selected = n;
  if (n > 0) {
    if (!rowOf(n)) showSource(n - Math.floor(kWindow / 2));
    const row = rowOf(n);
    if (row) {
      row.classList.add("selected");
      if (scroll) row.scrollIntoView({ block: "center" });
    }
  }
  picked.replaceChildren();
  if (n > 0) {
    const strong = document.createElement("b");
    strong.textContent = `line ${n}`;
    const removed = data.removed[n];
    picked.append(strong, `  ${lines[n - 1] || ""}`,
      removed === undefined ? "" : `  — removed ${removed} mm³`);
  } else {
    picked.textContent = "uncut stock";
  }
  if (view) view.highlight(n);
}

box.addEventListener("click", (event) => {
  const row = event.target.closest("[data-line]");
  if (row) select(Number(row.dataset.line), false);
});
for (const finding of document.querySelectorAll(".finding[data-line]")) {
  finding.addEventListener("click", () => select(Number(finding.dataset.line)));
}
showSource(1);

// --- The part -----------------------------------------------------------------------------------

// Where triangles meet at more than 20°, as they are shaded.
function sharpEdges(corners, index, normals) {
  const kSmooth = Math.cos(Math.PI / 9), kUnit = 32767 * 32767, count = corners.length / 3;
  const cosine = (i, j) => (normals[3 * i] * normals[3 * j] +
    normals[3 * i + 1] * normals[3 * j + 1] + normals[3 * i + 2] * normals[3 * j + 2]) / kUnit;
  const open = new Map(), ends = [];
  for (let i = 0; i < index.length; i += 1) {
    const j = i % 3 === 2 ? i - 2 : i + 1;
    const back = index[j] * count + index[i];
    const other = open.get(back);
    if (other === undefined) {
      open.set(index[i] * count + index[j], [i, j]);
      continue;
    }
    open.delete(back);
    if (cosine(i, other[1]) + cosine(j, other[0]) > 2 * kSmooth) continue;
    for (const end of [index[i], index[j]]) ends.push(...corners.subarray(3 * end, 3 * end + 3));
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(ends), 3));
  return geometry;
}

// A body for each link and each piece of a tool; where they are is told by the joints, which go
// about the bed while the part, here, lies still.
function makeMachine(told) {
  const group = new THREE.Group();
  const lines = bytes(told.lines, Uint32Array), tools = bytes(told.tools, Int32Array);
  const values = bytes(told.values, Float32Array);
  const bodies = told.bodies.map((body) => {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position",
      new THREE.BufferAttribute(bytes(body.corners, Float32Array), 3));
    geometry.computeVertexNormals();
    geometry.computeBoundingSphere();
    const [r, g, b] = body.colour;
    const object = new THREE.Mesh(geometry,
      new THREE.MeshLambertMaterial({ color: new THREE.Color(`rgb(${r},${g},${b})`) }));
    object.matrixAutoUpdate = false;
    group.add(object);
    return object;
  });

  function jointMatrix([axis, turns, direction, through], stand) {
    const along = new THREE.Vector3(...direction), at = new THREE.Vector3(...through);
    if (!turns) {
      along.multiplyScalar(stand[axis]);
      return new THREE.Matrix4().makeTranslation(along.x, along.y, along.z);
    }
    return new THREE.Matrix4().makeTranslation(at.x, at.y, at.z)
      .multiply(new THREE.Matrix4().makeRotationAxis(along, stand[axis] * Math.PI / 180))
      .multiply(new THREE.Matrix4().makeTranslation(-at.x, -at.y, -at.z));
  }
  const movedBy = (joints, stand) =>
    joints.reduce((m, joint) => m.multiply(jointMatrix(joint, stand)), new THREE.Matrix4());

  // After the line, or the last one before it that moves; before all of them, after the first.
  function indexOf(line) {
    let i = 0;
    while (i + 1 < lines.length && lines[i + 1] <= line) i += 1;
    return i;
  }
  function show(line) {
    const i = indexOf(line);
    const stand = values.subarray(9 * i, 9 * i + 9);
    const [x, y, z] = told.zero;
    // Of inverses the last comes first: transposed turns, ways back.
    let toPart = new THREE.Matrix4();
    for (const joint of told.part_moved_by) {
      const back = stand.slice();
      back[joint[0]] = -stand[joint[0]];
      toPart = jointMatrix(joint, back).multiply(toPart);
    }
    toPart = new THREE.Matrix4().makeTranslation(-x, -y, -z).multiply(toPart);
    told.bodies.forEach((body, k) => {
      bodies[k].visible = body.tool < 0 || body.tool === tools[i];
      bodies[k].matrix.multiplyMatrices(toPart, movedBy(body.moved_by, stand));
      bodies[k].matrixWorldNeedsUpdate = true;
    });
    return i;
  }
  // A point of a body, machine coordinates with all joints at 0, as the part has it now.
  function place(name, x, y, z) {
    const k = told.bodies.findIndex((body, i) => body.name === name && bodies[i].visible);
    return new THREE.Vector3(x, y, z).applyMatrix4(bodies[k].matrix).toArray();
  }
  show(0);
  group.updateMatrixWorld(true);
  const sphere = new THREE.Box3().setFromObject(group).getBoundingSphere(new THREE.Sphere());
  return { group, lines, show, place, sphere };
}

function makeView(holder, mesh) {
  const corners = bytes(mesh.vertices, Float32Array);
  const index = bytes(mesh.triangles, Uint32Array);
  const lineOf = bytes(mesh.lines, Uint32Array);
  const count = index.length / 3;
  const positions = new Float32Array(9 * count);
  for (let i = 0; i < index.length; i += 1) {
    positions.set(corners.subarray(3 * index[i], 3 * index[i] + 3), 3 * i);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  const colours = new THREE.BufferAttribute(new Float32Array(9 * count), 3);
  geometry.setAttribute("color", colours);
  const normals = bytes(mesh.normals, Int16Array);
  geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3, true));
  geometry.computeBoundingSphere();

  const kStock = [0.72, 0.75, 0.79], kCut = [0.33, 0.58, 0.84], kChosen = [0.98, 0.52, 0.12];
  const kFault = [0.86, 0.20, 0.20];
  function paint(chosen) {
    for (let t = 0; t < count; t += 1) {
      const line = lineOf[t];
      let colour = line === 0 ? kStock : kCut;
      if (data.marks[line] === "error") colour = kFault;
      if (line === chosen && line > 0) colour = kChosen;
      for (let v = 0; v < 3; v += 1) colours.array.set(colour, 9 * t + 3 * v);
    }
    colours.needsUpdate = true;
  }

  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xeef1f4);
  const part = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ vertexColors: THREE.VertexColors }));
  scene.add(part);
  const edges = new THREE.LineSegments(sharpEdges(corners, index, normals),
    new THREE.LineBasicMaterial({ color: 0x31404f }));
  scene.add(edges);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x8a96a3, 0.75));
  const lamp = new THREE.DirectionalLight(0xffffff, 0.55);
  scene.add(lamp);

  const machine = data.machine ? makeMachine(data.machine) : null;
  let sphere = geometry.boundingSphere;
  const camera = new THREE.PerspectiveCamera(35, 1, 1, 100);
  camera.up.set(0, 0, 1);
  const target = new THREE.Vector3();
  let azimuth = -Math.PI / 3, height = Math.PI / 5, distance = 1;
  // All of the machine, or the part alone.
  function showMachine(shown) {
    if (machine && shown) scene.add(machine.group);
    if (machine && !shown) scene.remove(machine.group);
    sphere = machine && shown ? machine.sphere : geometry.boundingSphere;
    camera.near = geometry.boundingSphere.radius / 100;
    camera.far = sphere.radius * 100;
    target.copy(sphere.center);
    distance = 3.6 * sphere.radius;
  }

  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setPixelRatio(window.devicePixelRatio);
  holder.append(renderer.domElement);

  function draw() {
    const width = holder.clientWidth, tall = holder.clientHeight;
    renderer.setSize(width, tall, false);
    camera.aspect = width / tall;
    camera.position.set(
      target.x + distance * Math.cos(height) * Math.cos(azimuth),
      target.y + distance * Math.cos(height) * Math.sin(azimuth),
      target.z + distance * Math.sin(height));
    camera.lookAt(target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    lamp.position.copy(camera.position).add(new THREE.Vector3(0, 0, sphere.radius));
    renderer.render(scene, camera);
  }

  function pick(x, y) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(2 * x / holder.clientWidth - 1,
      1 - 2 * y / holder.clientHeight), camera);
    const hits = ray.intersectObject(part);
    return hits.length > 0 ? lineOf[hits[0].faceIndex] : null;
  }

  // Left: turn, right or shift: move, wheel: nearer.
  let drag = null;
  const canvas = renderer.domElement;
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    drag = { x: event.clientX, y: event.clientY, moved: 0, pan: event.button === 2 || event.shiftKey };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!drag) return;
    const dx = event.clientX - drag.x, dy = event.clientY - drag.y;
    drag.x = event.clientX;
    drag.y = event.clientY;
    drag.moved += Math.abs(dx) + Math.abs(dy);
    if (drag.pan) {
      const step = distance / holder.clientHeight;
      const right = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
      const up = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
      target.addScaledVector(right, -dx * step).addScaledVector(up, dy * step);
    } else {
      azimuth -= dx / 150;
      height = Math.max(-1.55, Math.min(1.55, height + dy / 150));
    }
    draw();
  });
  canvas.addEventListener("pointerup", (event) => {
    const was = drag;
    drag = null;
    if (!was || was.moved > 4) return;
    const frame = canvas.getBoundingClientRect();
    const line = pick(event.clientX - frame.left, event.clientY - frame.top);
    if (line !== null) select(line);
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    distance *= Math.exp(event.deltaY / 800);
    draw();
  }, { passive: false });
  window.addEventListener("resize", draw);

  showMachine(true);
  paint(0);
  draw();
  return {
    highlight(line) {
      paint(line);
      if (machine && line > 0) this.stood(machine.show(line));
      draw();
    },
    machine,
    stood() {},
    showMachine(shown) { showMachine(shown); draw(); },
    // Where a point of the part is on the page: for tests and for those who script it.
    project(x, y, z) {
      const p = new THREE.Vector3(x, y, z).project(camera);
      const frame = canvas.getBoundingClientRect();
      return { x: frame.left + (p.x + 1) / 2 * frame.width, y: frame.top + (1 - p.y) / 2 * frame.height };
    },
    triangles: count,
  };
}

const holder = document.getElementById("view");
if (holder && data.mesh) {
  try {
    view = makeView(holder, data.mesh);
    picked.textContent = "Click a face to see the line that cut it, or a line to see its faces.";
  } catch (error) {
    picked.textContent = `No view of the part here: ${error.message}`;
  }
}
const controls = document.getElementById("stand");
if (controls && view && view.machine) {
  const [shown, slider] = controls.querySelectorAll("input");
  shown.addEventListener("change", () => view.showMachine(shown.checked));
  slider.min = 0;
  slider.max = view.machine.lines.length - 1;
  slider.value = 0;
  view.stood = (i) => { slider.value = i; };
  slider.addEventListener("input", () => select(view.machine.lines[slider.value]));
} else if (controls) {
  controls.remove();
}
window.ncsim = { select, view, selected: () => selected };
