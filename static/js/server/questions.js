/** What is asked of the server for a state, and which answers belong to it. */

import { choice, LinkError, number, whole } from "../state/state.js";

/** @param {string} route @param {(string | false)[]} parts what is empty is left out */
export function path(route, parts) {
  const query = parts.filter(Boolean).join("&");
  return query ? `${route}?${query}` : route;
}

/** What the server declares of a parameter; nothing here knows its bounds. @param {readonly Parameter[]} parameters @param {string} name */
export function declared(parameters, name) {
  const found = parameters.find((p) => p.name === name);
  if (!found) throw new Error(`The server declares no ${name}`);
  return found;
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

/** @param {Model} model @param {Parameter} parameter */
export function stateName(model, parameter) {
  return `${model.id}.${parameter.name}`;
}

/** @param {Parameter} declared @returns {number | number[] | string | null} null leaves it to the server */
export function defaultOf({ choices, default: preset }) {
  const named = choices?.find(([, value]) => value === preset);
  return named ? named[0] : preset;
}

/** One number, or three for R, G and B. @param {Parameter} declared @returns {Field} */
function triple(declared) {
  const field = number(declared);
  return {
    default: declared.default,
    parse(text) {
      const values = text.split(",").map((part) => field.parse(part));
      if (values.length === 1) return values[0];
      if (values.length === 3) return Object.freeze(values);
      throw new LinkError("allowed is one number, or three with commas between");
    },
    print: (value) => (value === null ? "" : Array.isArray(value) ? value.join(",") : `${value}`),
  };
}

/** @param {Parameter} parameter @returns {Field} */
function fieldOf(parameter) {
  if (parameter.choices?.length) {
    const preset = String(defaultOf(parameter));
    return choice(
      preset,
      parameter.choices.map(([name]) => name),
    );
  }
  if (parameter.triple) return triple(parameter);
  return parameter.integer ? whole(number(parameter)) : number(parameter);
}

/** @param {Model[]} models @returns {Record<string, Field>} */
export function parameterFields(models) {
  return Object.fromEntries(
    models.flatMap((model) => model.parameters.map((p) => [stateName(model, p), fieldOf(p)])),
  );
}

/**
 * Parts of a query: the parameters of the models asked for that differ from what the server takes.
 * @param {State} state
 * @param {Model[]} models
 * @param {readonly string[]} ids
 * @returns {string[]}
 */
export function parameterQuery(state, models, ids) {
  return models
    .filter((model) => ids.includes(model.id))
    .flatMap((model) =>
      model.parameters
        .map((p) => ({ name: stateName(model, p), preset: defaultOf(p) }))
        .filter(({ name, preset }) => (state[name] ?? null) !== preset && state[name] != null)
        .map(({ name }) => `${name}=${state[name]}`),
    );
}
