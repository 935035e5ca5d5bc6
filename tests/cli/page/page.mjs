// SPDX-License-Identifier: GPL-3.0-or-later
//
// node page.mjs <ncsim> <chromium> <samples> [<screenshot.png>]: makes the page of a program with a fault and
// uses it as a reader would: the part is drawn, a click on a face selects the line that cut it, a
// click on a finding goes to its line, and nothing is loaded from anywhere.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

const [ncsim, browserPath, samples, screenshot] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "ncsim-page-"));
let failures = 0;
function expect(condition, message) {
  if (condition) return;
  console.error(message);
  failures += 1;
}

// A slot along X at Y0, a second one along Y made at rapid, a hole; and markup where it must do no
// harm.
const program = [
  "(T1 D=10. - flat end mill) (</script><b>bold</b> & \"quoted\")",
  "(STOCK/BLOCK,80.,60.,20.,40.,30.,20.)",
  "G21 G90 G17 T1 M6 S4000 M3 F600",
  "G0 X-50. Y0. Z5.",
  "Z-4.",
  "G1 X50.",
  "G0 Z5.",
  "X20. Y-40.",
  "Z-8.",
  "G0 Y40.",
  "G0 Z5.",
  "X-20. Y18.",
  "G1 Z-12. F200.",
  "G0 Z5.",
  "M30", ""].join("\n");
writeFileSync(join(folder, "part.nc"), program);
let code = 0;
try {
  execFileSync(ncsim, ["check", "part.nc", "--html", "page.html"], { cwd: folder, stdio: "ignore" });
} catch (error) {
  code = error.status;
}
expect(code === 1, `exit code ${code} for a program with a fault`);

const browser = await chromium.launch({
  executablePath: browserPath,
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
try {
  const context = await browser.newContext({ viewport: { width: 1280, height: 1500 }, offline: true });
  const page = await context.newPage();
  const requests = [];
  const errors = [];
  page.on("request", (request) => requests.push(request.url()));
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => { if (message.type() === "error") errors.push(message.text()); });
  await page.goto(`file://${join(folder, "page.html")}`);

  const triangles = await page.evaluate(() => window.ncsim.view && window.ncsim.view.triangles);
  expect(triangles > 20, `the part was not drawn: ${errors.join("; ")}`);
  expect(await page.locator("b", { hasText: "bold" }).count() === 0, "a remark became markup");

  // Three normals of length 1 for each triangle; those of the slots' ends turn from corner to corner.
  const [normals, off, round] = await page.evaluate(() => {
    const mesh = JSON.parse(document.getElementById("data").textContent).mesh;
    const raw = Uint8Array.from(atob(mesh.normals), (c) => c.charCodeAt(0));
    const n = new Int16Array(raw.buffer);
    let worst = 0, turning = 0;
    for (let i = 0; i < n.length; i += 3) {
      worst = Math.max(worst, Math.abs(Math.hypot(n[i], n[i + 1], n[i + 2]) / 32767 - 1));
    }
    for (let t = 0; t < n.length; t += 9) {
      if (n[t] !== n[t + 3] || n[t] !== n[t + 6] || n[t + 1] !== n[t + 4]) turning += 1;
    }
    return [n.length / 9, worst, turning];
  });
  expect(normals === triangles, `${normals} normals for ${triangles} triangles`);
  expect(off < 1e-4, `a normal is longer or shorter by ${off}`);
  expect(round > 10 && round < triangles, `${round} of ${triangles} triangles are round`);

  // Faces of the part that are seen from where the camera begins, and the lines that cut them.
  for (const [x, y, z, line] of [[-10, 5, -2, 6], [15, -20, -2, 10], [-20, 23, -1, 13],
    [-30, -20, 0, 0]]) {
    const at = await page.evaluate((p) => window.ncsim.view.project(...p), [x, y, z]);
    await page.mouse.click(at.x, at.y);
    const selected = await page.evaluate(() => window.ncsim.selected());
    expect(selected === line, `a click at ${x}, ${y}, ${z} selects line ${selected}, not ${line}`);
    if (line > 0) {
      const text = await page.locator("#source .selected").textContent();
      expect(text.includes(program.split("\n")[line - 1]), `line ${line} shows ${text}`);
    }
  }
  const told = await page.locator("#picked").textContent();
  expect(told.includes("uncut stock"), told);

  await page.locator(".finding.error").click();
  expect(await page.evaluate(() => window.ncsim.selected()) === 10, "a finding leads to its line");
  expect((await page.locator("#picked").textContent()).includes("removed"), "with its volume");
  expect(await page.locator("svg").count() === 2, "two plots");
  expect(await page.locator("img").evaluateAll((all) => all.every((i) => i.naturalWidth > 0)),
    "a picture is broken");
  expect(requests.every((url) => url.startsWith("file:") || url.startsWith("data:")) &&
    requests.filter((url) => url.startsWith("file:")).length === 1, `loaded: ${requests}`);
  expect(errors.length === 0, `errors of the page: ${errors.join("; ")}`);
  expect(await page.locator("#stand").count() === 0, "a machine that nobody told");

  // With a machine: its tool's tip is, after a line, where that line says, as the part has it.
  execFileSync(ncsim, ["check", join(samples, "five-axis.nc"), "--job",
    join(samples, "five-axis.toml"), "--machine", join(samples, "machines", "trunnion.toml"),
    "--html", "mill.html"], { cwd: folder, stdio: "ignore" });
  await page.goto(`file://${join(folder, "mill.html")}`);
  const tipAfter = (line) => page.evaluate((n) => {
    window.ncsim.select(n);
    const told = JSON.parse(document.getElementById("data").textContent).machine;
    const tool = told.bodies.find((body) => body.name === "tool");
    const raw = Uint8Array.from(atob(tool.corners), (c) => c.charCodeAt(0));
    const lowest = new Float32Array(raw.buffer).reduce((z, c, i) => i % 3 === 2 ? Math.min(z, c) : z);
    return window.ncsim.view.machine.place("tool", 0, 0, lowest);
  }, line);
  for (const [line, x, y, z] of [[83, -22, -38.105, 30], [84, -22, -38.105, -4],
    [85, -18.894, -36.949, -5.044]]) {
    const tip = await tipAfter(line);
    const away = Math.hypot(tip[0] - x, tip[1] - y, tip[2] - z);
    expect(away < 1e-3, `after line ${line} the tip is at ${tip}`);
  }
  const before = await page.evaluate(() => window.ncsim.selected());
  await page.locator("#stand input[type=range]").press("ArrowRight");
  expect(await page.evaluate(() => window.ncsim.selected()) === before + 1, "the next line");
  // The cradle is between camera and part, so that a face of the part is seen without it alone.
  await page.locator("#stand input[type=checkbox]").uncheck();
  const at = await page.evaluate(() => window.ncsim.view.project(-38, -38, 0));
  await page.mouse.click(at.x, at.y);
  expect(await page.evaluate(() => window.ncsim.selected()) === 0, "the stock's corner is a face");
  expect(errors.length === 0, `errors of the page: ${errors.join("; ")}`);
  if (screenshot) await page.screenshot({ path: screenshot, fullPage: true });
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
process.exitCode = failures === 0 ? 0 : 1;
