// SPDX-License-Identifier: GPL-3.0-or-later
//
// node shots.mjs <ncsim> <chromium> <source> <folder> [--update]: makes the pictures of docs/page.md
// by the commands below them, and compares them. Browsers of other versions draw letters and edges
// slightly differently, so blocks of pixels are compared. --update replaces the pictures of the
// documentation; look at them before a commit.
import { mkdirSync, readFileSync, statSync, symlinkSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Reader } from "./reader.mjs";

const [ncsim, browserPath, source, out, update] = process.argv.slice(2);
const kFewest = 8, kMostBytes = 150000;
const reader = new Reader("shots", ncsim, browserPath);
const { folder } = reader;
const expect = (...words) => reader.expect(...words);
for (const name of ["samples", "examples"]) symlinkSync(join(source, name), join(folder, name));
mkdirSync(out, { recursive: true });

// Picture, command, file and address, size, and colours of the system.
const kShot = new RegExp(String.raw`^!\[[^\]]+\]\(pictures/(\S+)\)\n\n {4}ncsim (.*)\n` +
  String.raw` {4}(\S+\.html)(#\S+)? +(\d+)x(\d+)( dark)?$`, "gm");
const text = readFileSync(join(source, "docs", "page.md"), "utf8");
const shots = [...text.matchAll(kShot)];
expect(shots.length >= kFewest && shots.length === text.split("![").length - 1,
  `docs/page.md: ${shots.length} pictures have a command, of ${text.split("![").length - 1}`);

// Returns the share of blocks of 16 x 16 pixels whose mean colours differ by more than 12 of 255.
function differenceOf([first, second]) {
  const kBlock = 16;
  const read = async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height);
  };
  const meanOf = (image, x, y) => {
    const sums = [0, 0, 0];
    for (let j = y; j < y + kBlock; j += 1) {
      for (let i = x; i < x + kBlock; i += 1) {
        for (let c = 0; c < 3; c += 1) sums[c] += image.data[4 * (j * image.width + i) + c];
      }
    }
    return sums.map((sum) => sum / kBlock ** 2);
  };
  return Promise.all([read(first), read(second)]).then(([a, b]) => {
    if (a.width !== b.width || a.height !== b.height) return 1;
    let blocks = 0, other = 0;
    for (let y = 0; y + kBlock <= a.height; y += kBlock) {
      for (let x = 0; x + kBlock <= a.width; x += kBlock, blocks += 1) {
        const [m, n] = [meanOf(a, x, y), meanOf(b, x, y)];
        if (m.some((value, c) => Math.abs(value - n[c]) > 12)) other += 1;
      }
    }
    return other / blocks;
  });
}

await reader.run(async () => {
  for (const [, name, command, file, hash, width, height, dark] of shots) {
    const code = reader.call(...command.split(" "));
    expect([0, 1, 4].includes(code), `${name}: exit code ${code}`);
    const page = await reader.open(file + (hash || ""), { colorScheme: dark ? "dark" : "light",
      viewport: { width: Number(width), height: Number(height) } });
    await page.evaluate(async () => {
      await Promise.all([...document.images].map((image) => {
        image.loading = "eager";
        return image.decode();
      }));
      if (!window.ncsim) return;
      await window.ncsim.ready;
      window.ncsim.view.draw();
    });
    const picture = await page.screenshot({ path: join(out, name) });
    expect(picture.length <= kMostBytes, `${name}: ${picture.length} bytes`);
    const shown = join(source, "docs", "pictures", name);
    if (update === "--update") writeFileSync(shown, picture);
    const difference = await page.evaluate(differenceOf,
      [picture.toString("base64"), readFileSync(shown).toString("base64")]);
    expect(difference < 0.02, `${name}: ${(100 * difference).toFixed(1)} % differ: ${join(out, name)}`);
    expect(statSync(shown).size <= kMostBytes, `${name}: too large`);
    await page.context().close();
  }
}, (url) => /^(file:|data:)/.test(url));
