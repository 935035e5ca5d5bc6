// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unfolds the equal lines around the target of a link, for browsers that do not.
"use strict";

(() => {
  function reveal() {
    const target = location.hash && document.getElementById(location.hash.slice(1));
    const fold = target && target.closest("details");
    if (!fold || fold.open) return;
    fold.open = true;
    target.scrollIntoView();
  }
  window.addEventListener("hashchange", reveal);
  reveal();
})();
