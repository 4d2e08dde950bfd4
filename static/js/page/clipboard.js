/** Copying text, also where the clipboard API is not offered (plain http on another machine). */

/** @param {string} text @returns {Promise<boolean>} whether it was copied */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = document.createElement("textarea");
    area.value = text;
    area.className = "hidden";
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

/**
 * Show on a button for a moment that it did its work.
 * @param {HTMLElement} button
 * @param {boolean} done
 */
export function flash(button, done) {
  button.dataset.flash = done ? "copied" : "not copied";
  setTimeout(() => delete button.dataset.flash, 1200);
}
