/** What is asked of the server for a state, and which answers belong to it. */

/** @param {string} route @param {(string | false)[]} parts what is empty is left out */
export function path(route, parts) {
  const query = parts.filter(Boolean).join("&");
  return query ? `${route}?${query}` : route;
}

/**
 * @param {State} state
 * @param {Catalog} catalog
 * @param {readonly string[]} [names]
 * @returns {string[]} the indices that differ from the API's defaults
 */
export function mediaQuery(state, { parameters }, names = ["n_i", "n_t", "k_t"]) {
  return names
    .filter((name) => state[name] !== parameters.find((p) => p.name === name)?.default)
    .map((name) => `${name}=${state[name]}`);
}

/**
 * The answers to the questions of this very state.
 * @param {Record<string, any>} answers
 * @param {Record<string, string>} wanted paths by name
 * @returns {Record<string, any>}
 */
export function freshOf(answers, wanted) {
  return Object.fromEntries(
    Object.entries(wanted)
      .filter(([name, path]) => answers.asked?.[name] === path)
      .map(([name]) => [name, answers[name]]),
  );
}
