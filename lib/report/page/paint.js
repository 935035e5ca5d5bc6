// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of faces and their legend: by tool, line, depth, or distance from the design.
"use strict";

const kColours = ["tool", "line", "depth", "design"];  // order as in renderer.js

// The colours of pictures (palette.cpp): stock, then tools by number.
const kStockColour = [150, 156, 164];
const kToolColours = [[126, 182, 226], [240, 172, 98], [128, 200, 160], [226, 146, 186],
  [238, 218, 116], [172, 156, 222], [226, 124, 98], [104, 192, 194]];
const kUnnumberedColour = [164, 122, 90];  // of a tool without a number
const kUnnumbered = kToolColours.length + 1, kMostInLegend = 9;
const kScale = [[248, 222, 112], [122, 200, 122], [52, 152, 156], [62, 96, 160], [78, 48, 118]];
// Deep and slight gouge, within the tolerance, little and much material left.
const kDeviations = [[170, 12, 30], [246, 168, 110], [132, 190, 140], [146, 196, 240], [18, 62, 156]];

function shares(colours) { return colours.flat().map((c) => c / 255); }
function css(colour) { return `rgb(${colour.join(" ")})`; }

// Returns how faces are painted; `part`, `play` and `deviation` may be null.
function makePaint(part, play, deviation) {
  // Tools that cut the part first, as in pictures; then tools that only move.
  const numberOf = (name) => Number((/^T(\d+)/.exec(name) || [0, 0])[1]);
  const names = new Map((play ? play.bodies : []).map((tool) => [numberOf(tool.name), tool.name]));
  const ascending = (all) => [...new Set(all)].sort((a, b) => a - b);
  const cutting = ascending(part ? part.tools.filter((tool, i) => tool > 0 || part.lines[i] > 0) : []);
  const numbers = [...cutting, ...ascending(names.keys()).filter((n) => !cutting.includes(n))];
  const indexOf = new Map(numbers.filter((n) => n > 0).map((n, i) => [n, i % kToolColours.length + 1]));
  const ofTool = (number) => indexOf.get(number) || kUnnumbered;
  const lineOfMoves = play ? play.lines : [];
  let lastLine = 1;
  for (const line of lineOfMoves) lastLine = Math.max(lastLine, line);
  const toolOfLine = new Uint8Array(lastLine + 1);
  for (let m = 0; m < lineOfMoves.length; m += 1) {
    toolOfLine[lineOfMoves[m]] = ofTool(numberOf(play.bodies[play.tools[m]].name));
  }
  toolOfLine[0] = 0;
  let largest = deviation ? 2 * deviation.tolerance : 0;
  let [deepest, thickest] = [0, 0];
  for (const d of deviation ? deviation.deviation : []) {
    deepest = Math.max(deepest, -d);
    thickest = Math.max(thickest, d);
  }
  largest = Math.max(largest, deepest, thickest);
  const tools = [kStockColour, ...kToolColours, kUnnumberedColour];
  while (tools.length < 16) tools.push(kStockColour);
  return {
    colouring: 0, tools: shares(tools), scale: shares(kScale), deviations: shares(kDeviations),
    lastLine, depths: [data.stock[2], data.stock[5]],
    limits: [deviation ? deviation.tolerance : 0, largest], deepest, thickest, names,
    numbers: part ? cutting : numbers,
    // Index of the colour of a face, by its tool and line, or by the line alone.
    ofFace: (tool, line) => (tool > 0 || line > 0 ? ofTool(tool) : 0),
    ofLine: (line) => (line < toolOfLine.length ? toolOfLine[line] : 0),
  };
}

// Returns the area (mm²) of the surface by distance from the design, in `count` classes from
// -`largest` to `largest`.
function areasByDeviation({ corners: c, deviation }, largest, count) {
  const areas = new Float64Array(count);
  for (let t = 0; t < deviation.length; t += 3) {
    const [a, b, d] = [0, 3, 6].map((k) => [c[3 * t + k], c[3 * t + k + 1], c[3 * t + k + 2]]);
    const area = norm(cross(minus(b, a), minus(d, a))) / 2;
    const mean = (deviation[t] + deviation[t + 1] + deviation[t + 2]) / 3;
    const at = Math.floor(count * (mean / largest + 1) / 2);
    areas[Math.max(0, Math.min(count - 1, at))] += area;
  }
  return areas;
}

// Returns the colour of a distance from the design.
function deviationColour(mm, [tolerance, largest]) {
  if (Math.abs(mm) <= tolerance) return kDeviations[2];
  const t = (Math.abs(mm) - tolerance) / (largest - tolerance);
  const [from, to] = mm < 0 ? [kDeviations[1], kDeviations[0]] : [kDeviations[3], kDeviations[4]];
  return from.map((c, i) => Math.round(c + t * (to[i] - c)));
}

// Returns bars of the area in each class of the distance from the design.
function histogram(deviation, paint) {
  const kClasses = 41, [tolerance, largest] = paint.limits;
  const areas = areasByDeviation(deviation, largest, kClasses);
  const all = areas.reduce((sum, a) => sum + a, 0) || 1;
  const name = "http://www.w3.org/2000/svg", svg = document.createElementNS(name, "svg");
  svg.setAttribute("viewBox", `0 0 ${4 * kClasses} 40`);
  svg.setAttribute("class", "histogram");
  let beyond = 0;
  areas.forEach((area, i) => {
    const middle = largest * ((2 * i + 1) / kClasses - 1), share = area / all;
    if (Math.abs(middle) > tolerance) beyond += share;
    if (share === 0) return;
    // Roots, so that small areas can be seen next to large areas.
    const height = Math.max(1, 38 * Math.sqrt(share)), bar = document.createElementNS(name, "rect");
    for (const [key, value] of Object.entries({ x: 4 * i, y: 40 - height, width: 3.4, height,
      fill: css(deviationColour(middle, paint.limits)) })) bar.setAttribute(key, value);
    svg.append(bar);
  });
  return { svg, beyond };
}

// Fills the legend of the present colours.
function showLegend(legend, paint, deviation) {
  const swatch = (colour) => {
    const made = element("i", { className: "swatch" });
    made.style.background = css(colour);
    return made;
  };
  const bar = (colours, from, to) => {
    const made = element("i", { className: "scale" });
    made.style.background = `linear-gradient(to right, ${colours.map(css).join(", ")})`;
    return [element("span", { textContent: from }), made, element("span", { textContent: to })];
  };
  const short = (mm) => String(Number(numberText(mm)));
  const size = [0, 1, 2].map((i) => short(data.stock[3 + i] - data.stock[i]));
  const rows = [];
  if (paint.colouring === 0) {
    const tools = [kStockColour, ...kToolColours, kUnnumberedColour];
    for (const number of paint.numbers.slice(0, kMostInLegend)) {
      // Without shank and holder.
      const [name] = (paint.names.get(number) || `T${number}`).split(",");
      rows.push([swatch(tools[paint.ofFace(number, 1)]), element("span", { textContent: name })]);
    }
    const more = paint.numbers.length - kMostInLegend;
    if (more > 0) rows.push([element("span", { textContent: `and ${more} more tools` })]);
    rows.push([swatch(kStockColour), element("span", { textContent: "uncut" })]);
  } else if (paint.colouring === 1) {
    rows.push(bar(kScale, "line 1", `line ${paint.lastLine}`));
  } else if (paint.colouring === 2) {
    const [low, high] = paint.depths;
    rows.push(bar(kScale, `Z ${short(high)}`, `Z ${short(low)}`));
  } else {
    const { svg, beyond } = histogram(deviation, paint);
    const [tolerance, largest] = paint.limits;
    rows.push([svg], bar(kDeviations, `−${short(largest)}`, `+${short(largest)}`),
    [element("span", { textContent: `gouge ${short(paint.deepest)}, left ${short(paint.thickest)} at most` })],
    [element("span", { textContent: `${(100 * beyond).toFixed(1)} % beyond ±${short(tolerance)}` })]);
  }
  rows.push([element("span", { className: "size",
    textContent: `stock ${size.join(" × ")} ${inInches ? "in" : "mm"}` })]);
  legend.replaceChildren(...rows.map((row) => element("div", {}, ...row)));
}
