// SPDX-License-Identifier: GPL-3.0-or-later
//
// node arrays.mjs <ncsim> <samples>: reads the data of pages with the script of the pages, without
// a browser. The states of the part have the volume of `run --at-line`, and two runs with different
// numbers of threads write the same bytes.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { Script, createContext } from "node:vm";

const [ncsim, samples] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "ncsim-arrays-"));
let failures = 0;
function expect(condition, message) {
  if (condition) return;
  console.error(message);
  failures += 1;
}
function run(...words) {
  execFileSync(ncsim, ["run", ...words], { cwd: folder, stdio: "ignore" });
}
try {
  const program = join(samples, "wave.nc");
  run(program, "--html", "one.html", "--threads", "1");
  run(program, "--html", "two.html", "--threads", "2");
  const text = readFileSync(join(folder, "one.html"), "utf8");
  expect(text === readFileSync(join(folder, "two.html"), "utf8"), "threads change the page");
  expect(text.length < 4e6, `the page of wave.nc has ${text.length} bytes`);
  expect(!/(src|href)=["']?(https?:)?\/\//.test(text), "the page loads something");

  const scripts = [...text.matchAll(/<script>\n([^]*?)<\/script>/g)].map((match) => match[1]);
  expect(scripts.length === 6, `${scripts.length} scripts`);
  for (const script of scripts) new Script(script);  // throws where the syntax is wrong
  const context = createContext({ atob, Blob, Response, DecompressionStream, Math, Uint8Array,
    Int32Array, Uint32Array, Float32Array, Int16Array, Uint16Array, Promise });
  new Script(`${scripts[0]}; this.reader = { numbersOf, readPart, readPlay, volumeOfState };`)
    .runInContext(context);
  const data = JSON.parse(text.match(/<script id="data" type="application\/json">([^]*?)<\/script>/)[1]);
  const part = await context.reader.readPart(data.mesh);
  const play = await context.reader.readPlay(data.play);
  const { states } = play;
  const last = states.stateMoves.length - 1;
  expect(last >= 20, `${last + 1} states`);
  for (const state of [0, Math.floor(last / 3), Math.floor(2 * last / 3), last]) {
    run(program, "--report", "report.json", ...(state > 0 ?
      ["--at-line", String(states.stateLines[state])] : []));
    const report = JSON.parse(readFileSync(join(folder, "report.json"), "utf8"));
    const expected = state > 0 ? report.volume_mm3.part : report.volume_mm3.stock;
    const volume = context.reader.volumeOfState(states, state);
    expect(Math.abs(volume - expected) < 2e-5 * expected,
      `state ${state} has ${volume} mm3, the part after line ${states.stateLines[state]} ${expected}`);
  }
  let sum = 0;
  const c = part.corners;
  for (let i = 0; i < c.length; i += 9) {
    sum += c[i] * (c[i + 4] * c[i + 8] - c[i + 5] * c[i + 7]) +
      c[i + 1] * (c[i + 5] * c[i + 6] - c[i + 3] * c[i + 8]) +
      c[i + 2] * (c[i + 3] * c[i + 7] - c[i + 4] * c[i + 6]);
  }
  const final = context.reader.volumeOfState(states, last);
  expect(Math.abs(sum / 6 - final) < 2e-5 * final, `the finished part has ${sum / 6}, not ${final}`);
  // A machine stands by lines of the program itself, not of called files.
  writeFileSync(join(folder, "a.ngc"), ["(T1 D=6. CR=0. - flat end mill)",
    "(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)", "(FROM/0.,0.,50.)", "G21 G90 G17 G94", "T1 M6",
    "S5000 M3", "G0 X0 Y0 Z40", "o<far> call", "G0 Z40", "M2", ""].join("\n"));
  writeFileSync(join(folder, "far.ngc"),
    `o<far> sub\n${"\n".repeat(10)}G1 Z9 F300\nG1 X5\no<far> endsub\n`);
  try {
    execFileSync(ncsim, ["check", "a.ngc", "--machine", join(samples, "machines", "trunnion.toml"),
      "--html", "a.html"], { cwd: folder, stdio: "ignore" });
  } catch (error) {
    expect(error.status === 1 || error.status === 4, `check ended with ${error.status}`);
  }
  const machine = JSON.parse(readFileSync(join(folder, "a.html"), "utf8")
    .match(/<script id="data" type="application\/json">([^]*?)<\/script>/)[1]).machine;
  const lines = [...await context.reader.numbersOf(machine.lines)];
  expect(lines.filter((line) => line === 9).length === 1, `lines of the machine: ${lines}`);
  expect(!lines.includes(12) && !lines.includes(13), `lines of another file: ${lines}`);

  const lasting = play.points.slice(-3);
  expect(play.lines.length > 900 && Math.abs(lasting[0] - 60) < 1e-3,
    `the path ends at ${lasting} after ${play.lines.length} moves`);
} finally {
  rmSync(folder, { recursive: true });
}
process.exitCode = failures === 0 ? 0 : 1;
