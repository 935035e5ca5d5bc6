// SPDX-License-Identifier: GPL-3.0-or-later
//
// Directions of the axes and the program zero, drawn over the picture.
"use strict";

const kAxisColours = ["#d6336c", "#2f9e44", "#1c7ed6"];  // X, Y, Z

function svgElement(name, properties, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(properties)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// Returns the marks: `element` to lay over the picture, and `place`, which moves them. The symbol
// of the program zero is that of the datum on drawings.
function makeMarks() {
  const kSize = 30;  // pixels, length of an axis
  const quarter = (start, end) => svgElement("path", { d: `M0 0L${start}A8 8 0 0 1 ${end}Z`,
    class: "filled" });
  const zero = svgElement("g", { class: "zero" }, svgElement("circle", { r: 8, class: "ring" }),
    quarter("0 -8", "8 0"), quarter("0 8", "-8 0"), svgElement("path", { d: "M-12 0H12M0-12V12" }));
  const axes = kAxisColours.map((colour, i) => {
    const line = svgElement("path", { stroke: colour });
    const name = svgElement("text", { fill: colour }, "XYZ"[i]);
    return { line, name, group: svgElement("g", {}, line, name) };
  });
  const triad = svgElement("g", { class: "triad" }, ...axes.map((axis) => axis.group));
  const svg = svgElement("svg", { class: "marks", "aria-hidden": "true" }, zero, triad);
  return {
    element: svg,
    // `frame`: right, up and towards the viewer; `at`: pixels of the program zero, or null.
    place([right, up, back], at, width, height) {
      svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
      const isSeen = at && at.x > 0 && at.y > 0 && at.x < width && at.y < height;
      zero.setAttribute("visibility", isSeen ? "visible" : "hidden");
      if (isSeen)
        zero.setAttribute("transform", `translate(${at.x.toFixed(1)} ${at.y.toFixed(1)})`);
      const scale = Number.parseFloat(getComputedStyle(svg).fontSize) / 14;
      triad.setAttribute("transform",
        `translate(${width - 52 * scale} ${height - 52 * scale}) scale(${scale})`);
      // The axis that points to the viewer is drawn last.
      const order = [0, 1, 2].sort((a, b) => back[a] - back[b]);
      triad.replaceChildren(...order.map((i) => axes[i].group));
      axes.forEach(({ line, name }, i) => {
        const x = kSize * right[i], y = -kSize * up[i], length = Math.hypot(x, y);
        line.setAttribute("d", `M0 0L${x.toFixed(2)} ${y.toFixed(2)}`);
        const away = length > 1 ? (length + 10) / length : 0;
        name.setAttribute("visibility", length > 6 ? "visible" : "hidden");
        name.setAttribute("transform", `translate(${(away * x).toFixed(2)} ${(away * y + 4).toFixed(2)})`);
      });
    },
  };
}
