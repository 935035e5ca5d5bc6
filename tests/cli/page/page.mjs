// SPDX-License-Identifier: GPL-3.0-or-later
//
// node page.mjs <ncsim> <chromium> <samples> [<folder for screenshots>]: makes pages and uses them
// as a reader would. The page of a program with a fault plays to lines, and its states have the
// volume of `run --at-line`. Clicks on faces select lines, findings lead to their place, a section
// cuts the part open. Nothing is loaded from anywhere.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Reader } from "./reader.mjs";

const [ncsim, browserPath, samples, pictures] = process.argv.slice(2);
const reader = new Reader("page", ncsim, browserPath, pictures);
const { folder } = reader;
const expect = (...words) => reader.expect(...words), near = (...words) => reader.near(...words);
const call = (...words) => reader.call(...words);
async function open(file, options = {}) {
  // A small window: the tests draw without a graphics card.
  const page = await reader.open(file, { viewport: { width: 1000, height: 720 }, ...options });
  await page.evaluate(() => window.ncsim.ready);
  return page;
}
async function picture(page, name) {
  if (!pictures) return;
  await page.evaluate(() => window.ncsim.view.draw());
  await reader.picture(page, name, {});
}

// A slot along X at Y0, a second slot along Y made at rapid, a bore by a second tool; and markup
// where it must do no harm.
const program = [
  "(T1 D=10. - flat end mill) (</script><b>bold</b> & \"quoted\")",
  "(T2 D=8. - flat end mill)",
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
  "T2 M6 S4000 M3",
  "G0 X-20. Y18. Z5.",
  "G1 Z-12. F200.",
  "G0 Z5.",
  "M30", ""].join("\n");
writeFileSync(join(folder, "part.nc"), program);
expect(call("check", "part.nc", "--html", "page.html") === 1, "a program with a fault fails");
expect(call("run", "part.nc", "--html", "run.html", "--every", "1") === 0, "the page of a run");
const volumes = [7, 8, 11, 15].map((line) => {
  call("run", "part.nc", "--at-line", String(line), "--report", "report.json");
  return [line, JSON.parse(readFileSync(join(folder, "report.json"))).volume_mm3.part];
});

// Clicks a point of the part.
async function click(page, ...point) {
  const at = await page.evaluate((p) => window.ncsim.view.project(...p), point);
  await page.mouse.click(at.x, at.y);
  return page.locator("#picked").textContent();
}
const selected = (page) => page.evaluate(() => window.ncsim.selected());

await reader.run(async () => {
  let page = await open("page.html");
  const triangles = await page.evaluate(() => window.ncsim.view && window.ncsim.view.triangles);
  expect(triangles > 20, `the part was not drawn: ${reader.errors.join("; ")}`);
  expect(await page.locator("b", { hasText: "bold" }).count() === 0, "a remark became markup");

  // Three normals of length 1 for each triangle; at round ends the normals differ by corner.
  const [normals, off, round] = await page.evaluate(() => {
    const n = window.ncsim.view.part.normals;
    let worst = 0, turning = 0;
    for (let i = 0; i < n.length; i += 3)
      worst = Math.max(worst, Math.abs(Math.hypot(n[i], n[i + 1], n[i + 2]) / 32767 - 1));
    for (let t = 0; t < n.length; t += 9) {
      if (n[t] !== n[t + 3] || n[t] !== n[t + 6] || n[t + 1] !== n[t + 4]) turning += 1;
    }
    return [n.length / 9, worst, turning];
  });
  expect(normals === triangles, `${normals} normals for ${triangles} triangles`);
  expect(off < 1e-4, `a normal is longer or shorter by ${off}`);
  expect(round > 10 && round < triangles, `${round} of ${triangles} triangles are round`);
  await picture(page, "check");

  // The stock stays in the picture when the window changes, until the user moves the camera.
  const stockIsSeen = () => page.evaluate(() => {
    const frame = window.ncsim.view.canvas.getBoundingClientRect();
    return [-40, 40].every((x) => [-30, 30].every((y) => [-20, 0].every((z) => {
      const at = window.ncsim.view.project(x, y, z);
      return at.x > frame.left && at.x < frame.right && at.y > frame.top && at.y < frame.bottom;
    })));
  });
  for (const size of [[1280, 900], [500, 900], [2000, 700], [1000, 720]]) {
    await page.setViewportSize({ width: size[0], height: size[1] });
    // The browser reports the new size with the next picture.
    await page.evaluate(() => new Promise((done) => {
      requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)));
    }));
    expect(await stockIsSeen(), `a window of ${size} cuts the stock off`);
  }

  // Faces of the part that are seen from where the camera begins, and the lines that cut them.
  for (const [x, y, z, line] of [[-10, 5, -2, 7], [15, -20, -2, 11], [-20, 22, -1, 15],
    [-30, -20, 0, 0]]) {
    const text = await click(page, x, y, z);
    expect(await selected(page) === line, `a click at ${x}, ${y}, ${z} selects ${await selected(page)}`);
    if (line > 0) {
      const row = await page.locator("#source .selected").textContent();
      expect(row.includes(program.split("\n")[line - 1]), `line ${line} shows ${row}`);
    } else {
      expect(text.includes("uncut stock"), text);
    }
    if (line === 15) {
      expect(text.includes("hollow cylinder ⌀ 8.000 mm, length 12.000 mm, axis X -20.000 Y 18.000"), text);
      expect(text.includes("T2"), text);
      await picture(page, "face");
    }
  }

  // Finding: its line, its place, and the part after the line.
  await page.locator(".finding.error").first().click();
  expect(await selected(page) === 11, "a finding leads to its line");
  expect((await page.locator("#picked").textContent()).includes("removed"), "with its volume");
  const [target, line] = await page.evaluate(() => [window.ncsim.view.camera.target,
    window.ncsim.player.line()]);
  near(target[0], 20, 6, "X of the place of the finding");
  expect(line === 11, `the part is shown after line ${line}`);
  await picture(page, "finding");
  await page.locator(".finding.error").first().focus();
  await page.keyboard.press("Enter");
  expect(await page.locator("main svg[role=img]").count() === 2, "two plots");
  expect(await page.locator("img").evaluateAll((all) => all.every((i) => i.naturalWidth > 0)),
    "a picture is broken");

  // The drawn state has the volume of a run that stops at the line, without any upload.
  page = await open("run.html");
  const before = await page.evaluate(() => window.ncsim.view.uploaded());
  for (const [at, volume] of volumes) {
    await page.evaluate((n) => window.ncsim.player.goToLine(n), at);
    near(await page.evaluate(() => window.ncsim.view.volume()), volume, 2e-5 * volume,
      `volume after line ${at}`);
  }
  expect(await page.evaluate(() => window.ncsim.view.uploaded()) === before, "a step uploads data");
  // Before the bore is drilled, its place is the top of the stock.
  await page.evaluate(() => window.ncsim.player.goToLine(8));
  await click(page, -20, 18, 0);
  expect(await selected(page) === 0, "the bore exists before its line");
  await page.locator("#player input[type=range]").focus();
  await page.keyboard.press("ArrowRight");
  expect(await page.evaluate(() => window.ncsim.player.line()) === 9, "the slider steps by a move");
  await page.locator("#player button[title='next tool change']").click();
  expect((await page.locator("#player output").textContent()).includes("T2") ||
    await page.evaluate(() => window.ncsim.player.line()) >= 12, "the next tool");
  await page.evaluate(() => window.ncsim.player.goTo(0));
  await page.locator("#player button[title='play (space)']").click();
  await page.waitForFunction(() => window.ncsim.player.moves() >= 1, null, { timeout: 30000 });
  await page.locator("#player button[title='play (space)']").click();
  await page.evaluate(() => window.ncsim.player.goToLine(7));
  await picture(page, "play");

  // Section: the cut face is where the plane is, and a measurement across the slot.
  await page.evaluate(() => window.ncsim.player.goTo(window.ncsim.player.count));
  await page.locator("select[aria-label=section]").selectOption({ label: "section X" });
  await page.locator("select[aria-label=section]").evaluate((s) => s.dispatchEvent(new Event("input")));
  await page.evaluate(() => { window.ncsim.view.setView("right"); window.ncsim.view.draw(); });
  const cut = await click(page, 0, -20, -10);
  const cutAt = /^sectionX 0.000 Y (\S+) Z (\S+)/.exec(cut) || [];
  const pixel = await page.evaluate(() => 1 / Math.abs(window.ncsim.view.project(0, 1, 0).x -
    window.ncsim.view.project(0, 0, 0).x));
  near(Number(cutAt[1]), -20, pixel, `Y in ${cut}`);
  near(Number(cutAt[2]), -10, pixel, `Z in ${cut}`);
  await picture(page, "section");
  await page.locator("select[aria-label=section]").selectOption({ label: "no section" });
  await page.locator("select[aria-label=section]").evaluate((s) => s.dispatchEvent(new Event("input")));
  await page.evaluate(() => { window.ncsim.view.setView("top"); window.ncsim.view.draw(); });
  await page.locator("#measure").check();
  await click(page, -30, -20, 0);
  const distance = await click(page, -30, 0, -4);
  expect(distance.includes("between the planes 4.000 mm"), distance);
  expect(distance.includes("4.000 mm below the top"), distance);
  await page.locator("select[aria-label=unit]").selectOption("inch");
  expect((await click(page, -30, -20, 0)).includes("0.0000 in below"), "inches");
  await page.locator("#measure").uncheck();

  // Keys, rotation by the mouse, hidden bodies.
  await page.locator("#view canvas").focus();
  await page.keyboard.press("1");
  await page.mouse.move(400, 400);
  const azimuth = await page.evaluate(() => window.ncsim.view.camera.azimuth);
  await page.mouse.down();
  await page.mouse.move(480, 430, { steps: 4 });
  await page.mouse.up();
  expect(await page.evaluate(() => window.ncsim.view.camera.azimuth) < azimuth, "the part turns");
  await page.keyboard.press("p");
  expect(!await page.evaluate(() => window.ncsim.view.shown.path), "key P hides the path");
  await picture(page, "turned");

  // Colours: faces of the bore have the colour of the second tool, the legend names the tools.
  const pixelAt = (...point) => page.evaluate((p) => {
    const { view } = window.ncsim, at = view.project(...p), frame = view.canvas.getBoundingClientRect();
    view.draw();
    const copy = document.createElement("canvas").getContext("2d");
    copy.drawImage(view.canvas, frame.left - at.x, frame.top - at.y, frame.width, frame.height);
    return [...copy.getImageData(0, 0, 1, 1).data.slice(0, 3)];
  }, point);
  await page.evaluate(() => { window.ncsim.view.setView("top"); });
  let [red, , bluish] = await pixelAt(-30, 0, -4);
  expect(bluish > red + 40, `the slot of T1 is ${red}, ${bluish}`);
  expect((await page.locator(".legend").textContent()).includes("T2 flat end mill D8"), "a legend");
  await page.locator("select[aria-label=colours]").selectOption("depth");
  [red, , bluish] = await pixelAt(-30, -20, 0);
  expect(Math.abs(red - bluish) < 30, `uncut faces stay grey: ${red}, ${bluish}`);
  expect((await page.locator(".legend").textContent()).startsWith("Z 0Z -0.7874"), "a scale in inches");
  await page.locator("#source").focus();
  const below = await selected(page);
  await page.keyboard.press("ArrowDown");
  expect(await selected(page) === below + 1, "the key for the next line");

  // A phone, dark: nothing is wider than the screen.
  const phone = await open("run.html", { viewport: { width: 390, height: 844 }, colorScheme: "dark",
    deviceScaleFactor: 2 });
  expect(await phone.evaluate(() => document.documentElement.scrollWidth) <= 390, "a phone scrolls");
  expect(await phone.evaluate(() => document.documentElement.dataset.theme) === "dark", "dark");
  await picture(phone, "phone");

  // With a machine: its tool's tip is, after a line, where that line says, as the part has it.
  call("check", join(samples, "five-axis.nc"), "--job", join(samples, "five-axis.toml"),
    "--machine", join(samples, "machines", "trunnion.toml"), "--html", "mill.html");
  page = await open("mill.html");
  const tipAfter = (n) => page.evaluate((number) => {
    window.ncsim.select(number);
    const { machine } = window.ncsim.view;
    const tool = machine.bodies.find((body) => body.name === "tool");
    const lowest = tool.corners.reduce((z, c, i) => (i % 3 === 2 ? Math.min(z, c) : z), 0);
    return machine.place("tool", 0, 0, lowest);
  }, n);
  for (const [n, x, y, z] of [[83, -22, -38.105, 30], [84, -22, -38.105, -4],
    [85, -18.894, -36.949, -5.044]]) {
    const tip = await tipAfter(n);
    const away = Math.hypot(tip[0] - x, tip[1] - y, tip[2] - z);
    expect(away < 2e-3, `after line ${n} the tip is at ${tip}`);
  }
  await picture(page, "machine");
  // The machine is at rest: a point of the bed stays in the picture while the table turns the part.
  const placesAfter = (n) => page.evaluate((number) => {
    window.ncsim.select(number);
    const { view } = window.ncsim;
    return [view.machine.place("base", 100, 50, 20), [30, 0, 0]].map((p) => {
      const at = view.project(...p);
      return [at.x, at.y];
    });
  }, n);
  const moved = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
  const [atFirst, turned] = [await placesAfter(17), await placesAfter(83)];
  expect(moved(atFirst[0], turned[0]) < 0.1, `the base moves: ${atFirst[0]}, ${turned[0]}`);
  expect(moved(atFirst[1], turned[1]) > 5, `the part is at rest: ${atFirst[1]}, ${turned[1]}`);
  await page.locator("select[aria-label=frame]").selectOption("part");
  const [partFirst, partTurned] = [await placesAfter(17), await placesAfter(83)];
  expect(moved(partFirst[1], partTurned[1]) < 0.1, `the part moves: ${partFirst[1]}, ${partTurned[1]}`);
  // The cradle is between camera and part, so a face of the part is seen without the machine only.
  await page.locator("label", { hasText: "machine" }).locator("input").uncheck();
  await page.evaluate(() => window.ncsim.player.goTo(window.ncsim.player.count));
  await click(page, -38, -38, 0);
  expect(await selected(page) === 0, "the stock's corner is a face");

  // At a finding the machine is where the bodies meet, and the bodies have other colours. The second
  // finding is in the middle of the move down, which ends at Z-25.
  call("check", join(samples, "..", "examples", "rules", "machine-collision", "fails.nc"), "--html",
    "meets.html");
  page = await open("meets.html");
  const orange = () => page.evaluate(() => {
    window.ncsim.view.draw();
    const copy = document.createElement("canvas"), { canvas } = window.ncsim.view;
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0);
    const { data: bytes } = context.getImageData(0, 0, copy.width, copy.height);
    let count = 0;
    for (let i = 0; i < bytes.length; i += 4)
      if (bytes[i] > 120 && bytes[i] > bytes[i + 1] + 40 && bytes[i + 1] > bytes[i + 2] + 40) count += 1;
    return count;
  });
  near((await tipAfter(8))[2], -25, 1e-3, "tip after the line");
  expect(await orange() < 50, "orange without a finding");
  await page.locator(".finding").nth(1).click();
  const atFinding = await page.evaluate(() => window.ncsim.view.machine.place("tool", 0, 0,
    window.ncsim.view.machine.bodies.find((body) => body.name === "tool").corners.reduce(
      (z, c, i) => (i % 3 === 2 ? Math.min(z, c) : z), 0)));
  near(atFinding[0], 120, 1e-3, "tip at the second finding, X");
  near(atFinding[2], 37.5, 0.4, "tip at the second finding, Z");
  expect(await orange() < 50, "orange without links that meet");
  await page.locator(".finding").nth(0).click();
  expect(await orange() > 1000, "the table is not orange");
  await picture(page, "meets");

  // Distances from the design: the finding is in the list for a screen reader, and the gouge of 1 mm
  // in the picture. The address of the page says what the page shows.
  call("check", join(samples, "..", "examples", "rules", "gouge", "fails.nc"), "--html", "design.html");
  page = await open("design.html#line=7&colour=design&view=top");
  expect(await selected(page) === 7 && (await page.evaluate(() => window.ncsim.player.line())) === 7,
    "the line of the address");
  const list = await page.locator("#reasons").ariaSnapshot();
  expect(/heading "Findings \(1\)"[^]*- list:\s+- listitem:\s+- '?button "error the part is cut into the design: depth 1 mm/.test(list), list);
  expect((await click(page, 0, -17.5, -3)).startsWith("1.000 mm inside of the design: gouge"),
    "the depth of the gouge");
  expect((await click(page, 0, 10, 0)).startsWith("on the design"), "a face on the design");
  const legend = await page.locator(".legend").textContent();
  expect(legend.includes("gouge 1, left 0 at most") && legend.includes("% beyond ±0.1"), legend);
  const areas = await page.evaluate(() => [...areasByDeviation(window.ncsim.view.deviation, 1, 3)]);
  near(areas.reduce((sum, area) => sum + area, 0), 11170, 1, "area of the part");
  near(areas[0], 420, 20, "area of the floor and of the lowest millimetre of the wall");

  // Faces of an earlier set-up have tool and form, and no line of this program.
  call("run", "part.nc", "--save-stock", "part.ncstock", "-q");
  writeFileSync(join(folder, "next.nc"), program.split("\n").filter((line, i) => i < 4 || i > 11).join("\n"));
  call("run", "next.nc", "--stock", "part.ncstock", "--html", "next.html", "-q");
  page = await open("next.html");
  const earlier = await click(page, -30, 3, -4);
  expect(earlier.startsWith("cut in an earlier set-up") && earlier.includes("T1"), earlier);

  expect(reader.requests.filter((url) => url.startsWith("file:")).length === 7,
    `loaded: ${reader.requests}`);
}, (url) => url.startsWith("file:") || url.startsWith("data:"));
