// SPDX-License-Identifier: GPL-3.0-or-later
//
// node bars.mjs <ncsim> <chromium> <samples>: measures what pages cost, prints a table of medians,
// and fails if a bar is missed. Takes minutes: the largest page has 200,000 moves.
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Reader } from "./reader.mjs";

const [ncsim, browserPath, samples] = process.argv.slice(2);
const reader = new Reader("bars", ncsim, browserPath);
const { folder } = reader;
const kRounds = 5, kTicks = 100;
const median = (all) => [...all].sort((a, b) => a - b)[all.length >> 1];
function bar(name, value, most, unit) {
  console.log(`${name.padEnd(58)} ${value.toFixed(2).padStart(8)} ${unit}, at most ${most}`);
  reader.expect(value <= most, `${name}: ${value} ${unit}`);
}

// A raster of a ball over crossed sines.
function raster(rows, segments) {
  const height = (x, y) => -8 + 5 * Math.sin(2 * Math.PI * x / 50) * Math.cos(2 * Math.PI * y / 50);
  const lines = ["(T1 D=6. CR=3. L=30. - ball end mill)", "(STOCK/BLOCK,100.,100.,30.,0.,0.,30.)",
    "G21 G90 G17 G94", "T1 M6", "S12000 M3", "G0 X0. Y0. Z20.", "G1 Z-8. F1500."];
  for (let j = 0; j < rows; j += 1) {
    for (let i = 0; i <= segments; i += 1) {
      const x = 100 * (j % 2 ? segments - i : i) / segments, y = 100 * j / (rows - 1);
      lines.push(`X${x.toFixed(3)} Y${y.toFixed(3)} Z${height(x, y).toFixed(3)}`);
    }
  }
  return [...lines, "G0 Z20.", "M30", ""].join("\n");
}

// Returns the CPU seconds of a command.
function seconds(...words) {
  const ran = spawnSync("/bin/sh", ["-c", '"$0" "$@" && times', ncsim, ...words],
    { cwd: folder, encoding: "utf8" });
  if (ran.status !== 0) throw new Error(`${words}: ${ran.stderr}`);
  const [user, system] = ran.stdout.trim().split("\n").at(-1).split(" ");
  const of = (text) => { const [, m, s] = /(\d+)m([\d.]+)s/.exec(text); return 60 * m + Number(s); };
  return of(user) + of(system);
}

// Returns the CPU seconds of the processes of the browser, by type.
function processes() {
  const all = new Map(), used = {};
  for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const fields = readFileSync(`/proc/${pid}/stat`, "utf8").replace(/^.*\) /, "").split(" ");
      const command = readFileSync(`/proc/${pid}/cmdline`, "utf8");
      all.set(pid, { parent: fields[1], cpu: (Number(fields[11]) + Number(fields[12])) / kTicks,
        type: (/--type=([a-z-]+)/.exec(command) || ["", "browser"])[1] });
    } catch { /* the process has ended */ }
  }
  for (const { parent, cpu, type } of all.values()) {
    let up = parent;
    while (up !== String(process.pid) && all.has(up)) up = all.get(up).parent;
    if (up === String(process.pid)) used[type] = (used[type] || 0) + cpu;
  }
  return used;
}

// Opens a page in a new browser, after an empty page. Returns the CPU seconds of the process of the
// page until the part is drawn, and what `ask` returns.
async function load(file, ask) {
  const page = await reader.open("blank.html");
  const before = processes();
  await page.goto(`file://${join(folder, file)}`);
  await page.evaluate(async () => {
    await window.ncsim.ready;
    await new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); });
  });
  const after = processes(), answer = await page.evaluate(ask);
  await reader.browser.close();
  reader.browser = undefined;
  return { cpu: after.renderer - before.renderer, answer };
}
const sizes = () => {
  const { view } = window.ncsim;
  return [view.triangles + view.stateTriangles, view.play.states.stateMoves.length];
};

await reader.run(async () => {
  writeFileSync(join(folder, "blank.html"), "<!DOCTYPE html><title>blank</title>");
  writeFileSync(join(folder, "1k.nc"), raster(32, 31));
  writeFileSync(join(folder, "22k.nc"), raster(150, 149));
  writeFileSync(join(folder, "200k.nc"), raster(447, 446));
  for (const program of [join(samples, "wave.nc"), "1k.nc"]) {
    const times = Array.from({ length: kRounds }, () => ["gltf", "html"].map((format) =>
      seconds("run", program, "-q", `--${format}`, `part.${format === "gltf" ? "glb" : format}`)));
    bar(`CPU of run --html by --gltf, ${program.split("/").at(-1)}`,
      median(times.map(([gltf, html]) => html / gltf)), 2.5, "times");
  }
  reader.call("run", join(samples, "wave.nc"), "-q", "--html", "wave.html");
  reader.call("run", "22k.nc", "-q", "--html", "22k.html");
  reader.call("run", "200k.nc", "-q", "--html", "200k.html");
  bar("page of wave.nc", statSync(join(folder, "wave.html")).size / 1e6, 4, "MB");
  bar("page of 200,000 moves", statSync(join(folder, "200k.html")).size / 1e6, 40, "MB");

  const wave = [], million = [];
  for (let round = 0; round < kRounds; round += 1) {
    wave.push(await load("wave.html", async () => {
      const { view, player } = window.ncsim, before = view.uploaded();
      for (let m = 0; m < player.count; m += 50) {
        player.goTo(m);
        view.draw();
      }
      return view.uploaded() - before;
    }));
    million.push(await load("22k.html", sizes));
  }
  bar("CPU to load wave.nc", median(wave.map(({ cpu }) => cpu)), 1, "s");
  bar("bytes sent by steps of the slider", wave[0].answer, 0, "B");
  const [triangles, states] = million[0].answer;
  reader.expect(triangles > 1e6, `${triangles} triangles`);
  bar(`CPU to load ${triangles} triangles`, median(million.map(({ cpu }) => cpu)), 3, "s");
  reader.expect(states > 20, `${states} states of 22,000 moves`);
  const large = await load("200k.html", sizes);
  reader.expect(large.answer[1] > 20, `${large.answer[1]} states of 200,000 moves`);
  bar(`CPU to load ${large.answer[0]} triangles`, large.cpu, 20, "s");
}, (url) => url.startsWith("file:"));
