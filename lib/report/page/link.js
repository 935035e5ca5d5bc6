// SPDX-License-Identifier: GPL-3.0-or-later
//
// Opens a page as its address says: part.html#line=43&view=top&section=x:10.
"use strict";

// Sets a control of the page as a user does.
function setControl(control, value) {
  if (control.type === "checkbox") control.checked = value;
  else control.value = value;
  control.dispatchEvent(new Event("input"));
  control.dispatchEvent(new Event("change"));
}

// Numbers between commas; null if a number is missing.
function numbersIn(text, count) {
  const all = text.split(",").map(Number);
  return all.length === count && all.every(Number.isFinite) ? all : null;
}

const kLinkKeys = {
  theme: (text, controls) => controls.setDark(text === "dark"),
  unit: (text, { unit }) => setControl(unit, text),
  colour: (text, { colour }) => setControl(colour, text),
  view: (text) => { if (Object.hasOwn(kViews, text)) view.setView(text); },
  hide: (text, { boxes }) => {
    for (const name of text.split(",")) if (Object.hasOwn(boxes, name)) setControl(boxes[name], false);
  },
  section: (text, controls) => {
    const [axis, place] = text.toLowerCase().split(":"), at = Number(place);
    if ("xyz".includes(axis) && axis.length === 1)
      controls.setSection("xyz".indexOf(axis), place && Number.isFinite(at) ? at : null);
  },
  line: (text) => { if (Number(text) > 0) select(Number(text)); },
  finding: (text) => { if (findings[Number(text) - 1]) showFinding(findings[Number(text) - 1]); },
  // Asks the face that the picture shows at a point.
  face: (text) => {
    const point = numbersIn(text, 3);
    if (!point) return;
    const at = view.project(...point), frame = view.canvas.getBoundingClientRect();
    showPicked(view.pick(at.x - frame.left, at.y - frame.top));
  },
};

// Follows the part of the address after #, in the order of kLinkKeys.
function followLink(controls) {
  const link = new URLSearchParams(window.location.hash.slice(1));
  for (const [key, follow] of Object.entries(kLinkKeys)) {
    for (const value of link.getAll(key)) follow(value, controls);
  }
}
