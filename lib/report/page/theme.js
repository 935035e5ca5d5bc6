// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a page without a control for it light or dark, as the system is.
"use strict";

(() => {
  const prefersDark = window.matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    document.documentElement.dataset.theme = prefersDark.matches ? "dark" : "light";
  };
  prefersDark.addEventListener("change", apply);
  apply();
})();
