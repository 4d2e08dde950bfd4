/** Plotly, which loads as a classic script beside the page's modules. */

/** @returns {Promise<Plotly.Library>} the library, once its script has run */
export async function library() {
  if (window.Plotly) return window.Plotly;
  const script = document.querySelector('script[src*="plotly"]');
  if (!script) throw new Error("Plotly's script is not on the page");
  await new Promise((resolve, reject) => {
    script.addEventListener("load", resolve, { once: true });
    script.addEventListener("error", () => reject(new Error("Plotly could not be loaded")), {
      once: true,
    });
  });
  return library();
}
