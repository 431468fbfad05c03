"use strict";
// Parts of the picture with a title are components and topics: "NAME (what else is known)".
(() => {
  // @ts-ignore: VS Code provides it.
  const host = acquireVsCodeApi();
  for (const title of Array.from(document.querySelectorAll("svg g > title"))) {
    const part = /** @type {Element} */ (title.parentElement);
    const name = (title.textContent || "").split(" (")[0];
    const open = () => host.postMessage({ name });
    part.setAttribute("role", "button");
    part.setAttribute("tabindex", "0");
    part.addEventListener("click", open);
    part.addEventListener("keydown", (event) => {
      if (/** @type {KeyboardEvent} */ (event).key === "Enter") {
        open();
      }
    });
  }
})();
