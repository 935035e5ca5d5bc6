// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sorts and searches the table of an index. Without this script, the table stays as written.
"use strict";

(() => {
  const table = document.getElementById("programs");
  const body = table.tBodies[0];
  const heads = [...table.tHead.rows[0].cells];
  const rows = [...body.rows];

  // Returns the sort value of a row in a column: a number, a text, or null if it is not known.
  function valueOf(row, column) {
    const cell = row.cells[column];
    if (cell.dataset.value === undefined) return cell.textContent;
    return cell.dataset.value === "" ? null : Number(cell.dataset.value);
  }

  // Sorts by a column. Rows without a value come last; equal rows keep the order of the file.
  function sort(column, order) {
    const sign = order === "descending" ? -1 : 1;
    const keys = rows.map((row, place) => ({ row, place, value: valueOf(row, column) }));
    keys.sort((a, b) => {
      if (a.value === null || b.value === null)
        return (a.value === null) - (b.value === null) || a.place - b.place;
      const difference = typeof a.value === "number" ? a.value - b.value
        : a.value.localeCompare(b.value, "en", { numeric: true });
      return sign * difference || a.place - b.place;
    });
    body.append(...keys.map((key) => key.row));
    heads.forEach((head, i) => {
      if (i === column) head.setAttribute("aria-sort", order);
      else head.removeAttribute("aria-sort");
    });
  }

  heads.forEach((head, column) => {
    if (!head.dataset.sort) return;
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = head.textContent;
    button.addEventListener("click", () => {
      const now = head.getAttribute("aria-sort");
      const other = now === "ascending" ? "descending" : "ascending";
      sort(column, now ? other : head.dataset.sort);
    });
    head.replaceChildren(button);
  });

  const input = document.createElement("input");
  input.type = "search";
  const label = document.createElement("label");
  label.append("Search", input);
  const count = document.createElement("output");
  count.setAttribute("aria-live", "polite");
  const texts = rows.map((row) =>
    `${row.querySelector(".name").textContent} ${row.querySelector(".verdict").textContent}`.toLowerCase());
  // Shows the rows whose name and verdict contain all words.
  function search() {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    rows.forEach((row, i) => {
      row.hidden = !words.every((word) => texts[i].includes(word));
      if (!row.hidden) shown += 1;
    });
    count.textContent = `${shown} of ${rows.length} programs`;
  }
  input.addEventListener("input", search);
  document.getElementById("search").append(label, count);
  search();
})();
