// SPDX-License-Identifier: GPL-3.0-or-later
//
// node index.mjs <ncsim> <chromium> [<folder for screenshots>]: makes the index of a folder and uses
// the index as a reader would: sorts by click and by keyboard, searches, opens a page, on a wide and
// on a narrow screen, in light and dark, and without JavaScript. Only small pictures are loaded.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { Reader } from "./reader.mjs";

const reader = new Reader("index", ...process.argv.slice(2));
const { folder } = reader;
const expect = (...words) => reader.expect(...words), same = (...words) => reader.same(...words);
const picture = (...words) => reader.picture(...words);
const open = (options = {}) =>
  reader.open(join("pages", "index.html"), { viewport: { width: 1100, height: 800 }, ...options });
const check = (out, ...words) => reader.call("check", "all", "none.nc", "--html", out, ...words);

// A clean slot; the same deeper and longer; a slot made at rapid, twice; a program that does not
// describe its tool. Names with markup, quotes and many folders.
const head = "(T1 D=10. L=30. - flat end mill)\n(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n" +
  "(FROM/0.,0.,50.)\nG21 G90 G17 T1 M6\nS5000 M3\nG0 X-30. Y0. Z5.\n";
const slot = (z, feed) => `${head}Z-${z}.\nG1 X30. F${feed}.\nG0 Z5.\nM30\n`;
const crash = `${head}Z-2.\nX30.\nZ5.\nY8.\nZ-3.\nX-30.\nG0 Z5.\nM30\n`;
const deep = join("a".repeat(60), "b".repeat(60), "c".repeat(60));
const programs = {
  "short.nc": slot(1, 2000), "slow2.nc": slot(2, 100), "slow10.nc": slot(3, 300),
  "<b>bold & \"quoted\".nc": crash, [join(deep, "crash.nc")]: crash.replace("Y8.\nZ-3.\nX-30.\n", ""),
};
for (const [name, text] of Object.entries(programs)) {
  mkdirSync(join(folder, "all", dirname(name)), { recursive: true });
  writeFileSync(join(folder, "all", name), text);
}
expect(check("pages/", "-j", "1") === 2, "a program cannot be read");
expect(check("again/", "-j", "3", "--threads", "2") === 2, "again");
const index = readFileSync(join(folder, "pages", "index.html"), "utf8");
expect(index === readFileSync(join(folder, "again", "index.html"), "utf8"),
  "another number of jobs makes another index");
expect(!/(src|href)="(https?:)?\/\//.test(index), "an address is not relative");

const names = (page) => page.locator("tbody tr:visible .name a").evaluateAll((links) =>
  links.map((link) => link.textContent.replace(/^.*\//, "")));
const sorted = (page) => page.locator("[aria-sort]").evaluateAll((heads) =>
  heads.map((head) => [head.textContent, head.getAttribute("aria-sort")]));
const head_of = (page, name) => page.getByRole("columnheader", { name }).getByRole("button");

await reader.run(async () => {
  let page = await open();
  const all = await names(page);
  same(all.slice(0, 3), ["none.nc", "<b>bold & \"quoted\".nc", "crash.nc"],
    "the worst verdicts and most errors come first");
  same(await sorted(page), [["Verdict", "ascending"]], "the order at first");
  expect(await page.locator("tbody b").count() === 0, "a name became markup");
  same(await page.locator("tbody tr").evaluateAll((rows) => rows.map((row) => row.className)).then(
    (words) => words.slice(0, 3)), ["not-verified", "failed", "failed"], "verdicts");

  // Each verified program has a small picture of the part, with a name for readers.
  const shown = await page.locator("tbody img").evaluateAll(async (images) => Promise.all(
    images.map(async (image) => {
      image.loading = "eager";
      await image.decode();
      return [image.naturalWidth, image.alt !== ""];
    })));
  same(shown, Array(5).fill([200, true]), "small pictures");
  await picture(page, "index-light");

  // A click sorts; the next click turns the order round. Numbers are sorted as numbers.
  await head_of(page, "Time").click();
  same(await sorted(page), [["Time", "descending"]], "sorted by time");
  const slowest = await names(page);
  same([slowest[0], slowest.at(-1)], ["slow2.nc", "none.nc"], "slowest first, unknown last");
  await head_of(page, "Time").click();
  const fastest = await names(page);
  same(fastest.at(-1), "none.nc", "unknown last in either order");
  same([...fastest].slice(0, -1).reverse(), slowest.slice(0, -1), "the other order");
  await head_of(page, "Removed").focus();
  await page.keyboard.press("Enter");
  same((await names(page)).slice(0, 1), ["<b>bold & \"quoted\".nc"], "most removed first");
  await head_of(page, "Program").focus();
  await page.keyboard.press("Space");
  same(await sorted(page), [["Program", "ascending"]], "sorted by keyboard");
  same((await names(page)).filter((name) => name.startsWith("s")),
    ["short.nc", "slow2.nc", "slow10.nc"], "2 before 10");

  // All words must occur in the name or the verdict.
  const search = page.getByRole("searchbox", { name: "Search" });
  await search.fill("SLOW nc");
  same(await names(page), ["slow2.nc", "slow10.nc"], "a search");
  same(await page.getByRole("status").textContent(), "2 of 6 programs", "the count");
  await search.fill("failed crash");
  same(await names(page), ["crash.nc"], "a search for a verdict");
  await search.fill("");
  same((await names(page)).length, 6, "no search");

  await page.getByRole("link", { name: "slow2.nc" }).click();
  expect(await page.locator("h1").textContent() === "all/slow2.nc: clean", "the page of a program");

  // Dark, on a phone: nothing is wider than the screen.
  page = await open({ viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  const widths = await page.evaluate(() => [document.documentElement.scrollWidth,
    getComputedStyle(document.body).backgroundColor]);
  same(widths, [390, "rgb(18, 22, 27)"], "width and colour of a dark phone");
  await head_of(page, "Doubts").click();
  same(await sorted(page), [["Doubts", "descending"]], "sorted on a phone");
  const lefts = await page.locator("tbody tr:first-child .number").evaluateAll((cells) =>
    cells.map((cell) => Math.round(cell.getBoundingClientRect().left)));
  same(new Set(lefts).size, 2, `two columns of numbers next to the picture (${lefts})`);
  same(await page.getByRole("row").count(), 7, "rows for a screen reader on a phone");
  await picture(page, "index-phone-dark");

  page = await open({ javaScriptEnabled: false });
  same(await page.locator("tbody tr").count(), 6, "rows without JavaScript");
  same(await page.locator("button, input").count(), 0, "controls that would do nothing");
  await picture(page, "index-plain");
}, (url) => {
  const file = decodeURIComponent(url.replace("file://", ""));
  return file.startsWith(join(folder, "pages")) && existsSync(file);
});
