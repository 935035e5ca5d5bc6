// SPDX-License-Identifier: GPL-3.0-or-later
//
// node review.mjs <ncsim> <chromium> [<folder for screenshots>]: makes the review of a change and
// uses the review as a reader would. The picture of the difference has the colours of both kinds of
// material, numbers in the picture lead to differences, differences to lines of both programs, and
// lines back. Equal lines unfold. Nothing is loaded from anywhere.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { Reader } from "./reader.mjs";

const reader = new Reader("review", ...process.argv.slice(2));
reader.mayLog = false;
const { folder } = reader;
const expect = (...words) => reader.expect(...words), same = (...words) => reader.same(...words);
const open = (...words) => reader.open(...words), picture = (...words) => reader.picture(...words);
const diff = (...words) => reader.call("diff", ...words);

// Two slots, engraving, and a bore. The new program makes the first slot deeper and slower, the
// second shorter, and adds the bore; it has a new remark with markup.
const program = (isNew) => [
  "(T1 D=10. L=30. - flat end mill)", "(T2 D=6. L=30. - ball end mill)",
  "(STOCK/BLOCK,80.,60.,20.,40.,30.,20.)", "(FROM/0.,0.,50.)",
  ...isNew ? ["(</td><b>bold</b> & \"quoted\")"] : [],
  "G21 G90 G17 T1 M6", "S5000 M3", "G0 X-50. Y-20. Z5.", isNew ? "Z-6." : "Z-4.",
  isNew ? "G1 X50. F700." : "G1 X50. F800.", "G0 Z5.", "X-50. Y20.", "Z-3.",
  isNew ? "G1 X20." : "G1 X50.", "G0 Z5.", "T2 M6", "S8000 M3", "G0 X-30. Y0. Z5.", "G1 Z-1. F200.",
  ...Array.from({ length: 50 }, (_, i) => `X${i - 29}. Y${i % 2}. F400.`),
  "G0 Z5.",
  ...isNew ? ["X30. Y2.", "G1 Z-12. F100.", "G0 Z5."] : [], "M30", ""].join("\n");
writeFileSync(join(folder, "old.nc"), program(false));
writeFileSync(join(folder, "new.nc"), program(true));
expect(diff("old.nc", "new.nc", "--html", "review.html") === 1, "the parts differ");
expect(diff("old.nc", "old.nc", "--html", "same.html") === 0, "a program and itself");

// Returns how many pixels of a picture are orange (only old) and blue (only new, or cut by the first
// tool), and the means of their places.
const colours = (page, alt) => page.getByAltText(alt, { exact: true }).evaluate((image) => {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
  const context = canvas.getContext("2d");
  context.drawImage(image, 0, 0);
  const data = context.getImageData(0, 0, canvas.width, canvas.height).data;
  const found = { orange: [0, 0], blue: [0, 0] };
  for (let i = 0; i < data.length; i += 4) {
    const kind = data[i] > data[i + 2] + 60 ? "orange" : data[i + 2] > data[i] + 90 ? "blue" : null;
    if (!kind) continue;
    found[kind][0] += 1;
    found[kind][1] += (i / 4) % canvas.width / canvas.width;
  }
  return Object.values(found).map(([count, sum]) => [count, sum / count]);
});
const target = (page) => page.evaluate(() => {
  const element = document.querySelector(":target");
  const box = element.getBoundingClientRect();
  return [element.id, box.top > -1 && box.bottom <= innerHeight,
    getComputedStyle(element).backgroundColor];
});

await reader.run(async () => {
  let page = await open("review.html");
  same(await page.locator("h1").textContent(),
    "old.nc → new.nc: the parts differ, the process differs", "the heading");
  expect(await page.locator("b", { hasText: "bold" }).count() === 0, "a remark became markup");
  same(await page.locator("img").evaluateAll((images) =>
    images.map((image) => `${image.alt} ${image.naturalWidth}`)),
  ["isometric", "from above"].flatMap((view) =>
    ["old part", "new part", "difference"].map((what) => `${what}, ${view} 800`)), "pictures");

  // The floor of the first slot and the bore are orange in the view from above, the end of the second slot is blue.
  const [orange, blue] = await colours(page, "difference, from above");
  expect(orange[0] > 20000 && Math.abs(orange[1] - 0.5) < 0.1, `orange: ${orange}`);
  expect(blue[0] > 5000 && blue[0] < 25000 && blue[1] > 0.75, `blue: ${blue}`);
  same((await colours(page, "old part, from above"))[0][0] > 1000, true, "the second tool is orange");

  // Links lead from the picture to the difference, to lines of both programs, and back.
  const pins = page.locator(".views a.region");
  same(await pins.allTextContents(), ["1", "2", "3", "1", "2", "3"], "numbers in the pictures");
  await pins.nth(4).click();
  const [id, isSeen] = await target(page);
  same([id, isSeen], ["s1r-2", true], "a number in the picture leads to the difference");
  const regions = page.locator(".regions li");
  const texts = await regions.allTextContents();
  expect(texts[0].includes("only in old.nc") && texts[0].includes("surface by old.nc: line 9") &&
    texts[0].includes("removed by new.nc: line 10"), texts[0]);
  expect(texts[2].includes("only in new.nc") && texts[2].includes("removed by old.nc: line 13") &&
    texts[2].includes("surface by new.nc: line 14"), texts[2]);
  await regions.nth(2).getByRole("link", { name: "13" }).click();
  let [line, lineIsSeen, colour] = await target(page);
  same([line, lineIsSeen], ["s1o-13", true], "a difference leads to the line of the old program");
  same(colour, "rgb(255, 232, 204)", "the line is marked");
  await regions.nth(2).getByRole("link", { name: "14" }).click();
  [line, lineIsSeen] = await target(page);
  same([line, lineIsSeen], ["s1n-14", true], "and to the line of the new program");
  await page.locator("#s1n-14 a.region").click();
  same((await target(page))[0], "s1r-3", "a line leads to its difference");

  // Changed lines are marked on both sides; equal lines unfold.
  same(await page.locator("#s1o-9 + td mark, #s1n-10 + td mark").allTextContents(), ["8", "7"],
    "changed digits");
  const fold = page.locator("summary", { hasText: "equal lines" }).last();
  const hidden = page.locator("#s1o-40");
  expect(!await hidden.isVisible(), "a long equal stretch is folded");
  await fold.focus();
  await page.keyboard.press("Enter");
  expect(await hidden.isVisible(), "the stretch unfolds");
  await picture(page, "review-light");
  page = await open("review.html#s1n-40");
  expect(await page.locator("#s1n-40").isVisible(), "a link unfolds its line");

  const cell = page.getByRole("row", { name: /^volume of the part/ }).getByRole("cell");
  expect(/^-[0-9.]+ mm3 \(-[0-9.]+ %\)$/.test((await cell.allTextContents())[2]), "change of volume");

  page = await open("review.html", { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  same(await page.evaluate(() => [document.documentElement.scrollWidth,
    getComputedStyle(document.body).backgroundColor]), [390, "rgb(18, 22, 27)"],
  "width and colour of a dark phone");
  await picture(page, "review-phone-dark");

  page = await open("same.html", { javaScriptEnabled: false });
  same(await page.locator("h1").textContent(), "old.nc → old.nc: the same part", "identical");
  expect(await page.getByText("The texts are the same.").isVisible(), "identical texts");
  same(await page.locator("img").count(), 2, "one picture for both parts");
  await page.locator("summary").click();
  expect(await page.locator("#s1o-9").isVisible(), "lines unfold without JavaScript");
  await picture(page, "review-same");
}, (url) => /^(file:.*\/(review|same)\.html|data:)/.test(url));
