// A classic script, run before the first paint: a module would show the wrong page for a moment.
// @ts-check
(() => {
  const key = "fresnel-theme";
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const root = document.documentElement;

  /** @returns {string} what the user chose: light, dark or auto */
  function chosen() {
    try {
      return localStorage.getItem(key) ?? "auto";
    } catch {
      return "auto"; // storage may be forbidden
    }
  }

  function apply() {
    const choice = chosen();
    root.dataset.themeChoice = choice;
    root.dataset.theme = choice === "auto" ? (dark.matches ? "dark" : "light") : choice;
    for (const meta of document.querySelectorAll("meta[data-of]")) {
      const of = meta.getAttribute("data-of");
      const chosenToo = choice === of ? "all" : "not all";
      meta.setAttribute("media", choice === "auto" ? `(prefers-color-scheme: ${of})` : chosenToo);
    }
  }

  apply();
  // Embedded in another page, or presented, the view stands alone; this, too, must hold before the first paint.
  const asked = new URLSearchParams(location.search);
  for (const name of ["embed", "present"])
    root.toggleAttribute(`data-${name}`, asked.getAll(name)[0] === "1");
  // Words to start with stand above Explore alone.
  root.dataset.view = asked.get("view") ?? "explore";
  dark.addEventListener("change", () => {
    apply();
    root.dispatchEvent(new Event("themechange"));
  });
  root.addEventListener("themechoice", (event) => {
    try {
      localStorage.setItem(key, /** @type {CustomEvent<string>} */ (event).detail);
    } catch {
      root.dataset.themeChoice = /** @type {CustomEvent<string>} */ (event).detail;
    }
    apply();
    root.dispatchEvent(new Event("themechange"));
  });
})();
