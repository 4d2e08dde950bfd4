/** One state object: its part that differs from the defaults stands in the URL, and in what is asked of the server. */

export class LinkError extends Error {}

const LONGEST_QUOTE = 40;

/** A link may say anything, at any length. @param {string} text */
export function shortened(text) {
  return text.length > LONGEST_QUOTE ? `${text.slice(0, LONGEST_QUOTE - 1)}…` : text;
}

/**
 * A number; null where the declaration has no default, which leaves it to the server.
 * @param {{default: number | null, minimum: number, maximum: number}} bounds
 * @returns {Field}
 */
export function number({ default: preset, minimum, maximum }) {
  return {
    default: preset,
    parse(text) {
      const value = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : Number.NaN;
      if (!(value >= minimum && value <= maximum)) {
        throw new LinkError(`allowed is a number from ${minimum} to ${maximum}`);
      }
      return value;
    },
    print: (value) => (value === null ? "" : String(value)),
  };
}

/** @param {string} preset @param {string[]} options @returns {Field} */
export function choice(preset, options) {
  return {
    default: preset,
    parse(text) {
      if (!options.includes(text)) throw new LinkError(allowedWords(options, text));
      return text;
    },
    print: String,
  };
}

/**
 * Any of some words, in the order given.
 * @param {string[]} options
 * @param {readonly string[]} [preset] unless it is empty, an empty list is written "none"
 * @returns {Field}
 */
export function list(options, preset = []) {
  const empty = preset.length ? "none" : "";
  return {
    default: Object.freeze([...preset]),
    parse(text) {
      if (empty && text === empty) return Object.freeze([]);
      const words = text.split(",");
      const strange = words.find((word) => !options.includes(word));
      if (strange !== undefined) {
        throw new LinkError(`“${shortened(strange)}”: ${allowedWords(options, strange)}`);
      }
      return Object.freeze([...new Set(words)]);
    },
    print: (value) => value.join(",") || empty,
  };
}

/** Of a number's field, only the whole ones. @param {Field} field @returns {Field} */
export function whole(field) {
  return {
    ...field,
    parse(text) {
      const value = field.parse(text);
      if (!Number.isInteger(value)) throw new LinkError("allowed is a whole number");
      return value;
    },
  };
}

/** One of some ids or none. @param {string[] | (() => string[])} ids @returns {Field} */
export function optional(ids) {
  return {
    default: null,
    parse(text) {
      const options = typeof ids === "function" ? ids() : ids;
      if (!options.includes(text)) throw new LinkError(allowedWords(options, text));
      return text;
    },
    print: (value) => value ?? "",
  };
}

/** @param {Record<string, Field>} fields @param {StateOptions} [options] */
export function createState(
  fields,
  { window: frame = null, implied = () => ({}), now = Date.now } = {},
) {
  const schema = { ...fields };
  /** @returns {State} */
  const defaults = () =>
    Object.fromEntries(Object.entries(schema).map(([key, field]) => [key, field.default]));
  let current = defaults();
  /** @type {Set<(state: State, moving: boolean) => void>} */
  const listeners = new Set();
  let moving = false; // a gesture is open: its history entry exists and is being replaced
  let written = -Infinity;

  /** @param {State} state */
  function query(state = current) {
    const hidden = implied(state);
    return Object.entries(schema)
      .filter(
        ([key, field]) =>
          !(key in hidden) && field.print(state[key]) !== field.print(field.default),
      )
      .map(
        ([key, field]) =>
          `${encodeURIComponent(key)}=${encodeURIComponent(field.print(state[key])).replace(/%2C/g, ",")}`,
      )
      .join("&");
  }

  /** @param {'pushState' | 'replaceState'} method */
  function write(method) {
    if (!frame) return;
    const search = query();
    const target = `${frame.location.pathname}${search ? `?${search}` : ""}`;
    if (target === `${frame.location.pathname}${frame.location.search}` && method === "pushState")
      return;
    frame.history[method](null, "", target);
    written = now();
  }

  function tell() {
    for (const listener of listeners) listener(current, moving);
  }

  return {
    get: () => current,
    defaults,
    moving: () => moving,
    toQuery: () => query(),

    /**
     * `replace` is for a gesture: its first value makes a page of the history, the next ones replace
     * that, and `push` or `settle` closes it.
     * @param {State} patch
     * @param {{history?: 'push' | 'replace' | 'none'}} [options]
     */
    set(patch, { history = "push" } = {}) {
      const unknown = Object.keys(patch).find((key) => !(key in schema));
      if (unknown) throw new Error(`the state has no field ${unknown}`);
      const next = { ...current, ...patch };
      Object.assign(next, implied(next));
      current = Object.freeze(next);
      if (history === "replace") {
        if (!moving) write("pushState");
        // A change of the URL takes as long as a frame, and browsers refuse more than 100 in 30 s.
        else if (now() - written > 1000) write("replaceState");
        moving = true;
      } else if (history === "push") {
        write(moving ? "replaceState" : "pushState");
        moving = false;
      }
      tell();
    },

    /** Close the open gesture, if there is one. */
    settle() {
      if (!moving) return;
      moving = false;
      write("replaceState");
      tell();
    },

    /** @param {(state: State, moving: boolean) => void} listener @returns {() => void} */
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },

    /**
     * Take the state from a link. What the link may not say stays at its default and is reported.
     * @param {string} search
     * @returns {LinkProblem[]}
     */
    fromQuery(search) {
      /** @type {LinkProblem[]} */
      const problems = [];
      const next = defaults();
      const seen = new Set();
      for (const [key, text] of new URLSearchParams(search)) {
        const field = Object.hasOwn(schema, key) ? schema[key] : undefined;
        if (!field) {
          problems.push({ key, text, message: "this page knows no such parameter" });
        } else if (seen.has(key)) {
          problems.push({ key, text, message: "it is given twice; the first one counts" });
        } else {
          seen.add(key);
          try {
            next[key] = field.parse(text);
          } catch (error) {
            if (!(error instanceof LinkError)) throw error;
            problems.push({ key, text, message: error.message });
          }
        }
      }
      const consequences = implied(next);
      for (const key of Object.keys(consequences)) {
        if (seen.has(key)) {
          problems.push({
            key,
            text: String(next[key]),
            message: "a preset gives this value already; the preset counts",
          });
        }
      }
      current = Object.freeze({ ...next, ...consequences });
      moving = false;
      tell();
      return problems;
    },

    /** Add the fields of a view or model that became known later. @param {Record<string, Field>} more */
    extend(more) {
      for (const [key, field] of Object.entries(more)) {
        if (key in schema) continue;
        schema[key] = field;
        current = Object.freeze({ ...current, [key]: field.default });
      }
    },
  };
}

const MOST_NAMED = 8;
const NEAREST = 3;

/** @param {string} a @param {string} b @returns {number} letters to insert, leave out or change */
export function distance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, i) => i);
  for (let i = 1; i <= a.length; i += 1) {
    const next = [i];
    for (let j = 1; j <= b.length; j += 1)
      next.push(
        Math.min(
          (row[j] ?? 0) + 1,
          (next[j - 1] ?? 0) + 1,
          (row[j - 1] ?? 0) + (a[i - 1] === b[j - 1] ? 0 : 1),
        ),
      );
    row = next;
  }
  return row[b.length] ?? 0;
}

/** What the server said of words that are none: of pages that are not there, or refused. @type {Map<string, string>} */
export const refusals = new Map();

/**
 * The words allowed: all where they are few, else those spelled most like the one that was given.
 * @param {readonly string[]} options
 * @param {string} word
 */
export function allowedWords(options, word) {
  const said = refusals.get(word);
  if (said !== undefined) return `allowed is ${said}`;
  if (word.startsWith("own:"))
    return "it carries no material: it was cut or changed on its way; copy the whole link";
  if (options.length <= MOST_NAMED) return `allowed is one of ${options.join(", ")}`;
  const given = word.slice(0, 40).toLowerCase();
  const far = new Map(options.map((one) => [one, distance(given, one.toLowerCase())]));
  const near = [...options].sort((a, b) => (far.get(a) ?? 0) - (far.get(b) ?? 0)).slice(0, NEAREST);
  return `it is none of the ${options.length} allowed; the nearest are ${near.join(", ")}`;
}

const MOST = 200;

/** @param {Pick<StateStore, 'get' | 'set' | 'defaults' | 'subscribe' | 'toQuery'>} state */
export function createUndo(state) {
  /** @type {State[]} */
  let past = [];
  /** @type {State[]} */
  let future = [];
  let now = state.get();
  let link = state.toQuery();
  let stepping = false;

  state.subscribe((next, moving) => {
    if (moving) return; // a gesture is one step
    const text = state.toQuery();
    if (text !== link && !stepping) {
      past = [...past.slice(1 - MOST), now];
      future = [];
    }
    // What is implied (a preset's index at another wavelength) may be news without being a step.
    now = next;
    link = text;
  });

  /** @param {State[]} from @param {State[]} to @returns {boolean} whether there was one */
  function step(from, to) {
    const target = from.pop();
    if (!target) return false;
    to.push(now);
    stepping = true;
    try {
      // Views that were opened since have brought fields of their own.
      state.set({ ...state.defaults(), ...target });
    } finally {
      stepping = false;
    }
    return true;
  }

  return {
    undo: () => step(past, future),
    redo: () => step(future, past),
    depth: () => ({ past: past.length, future: future.length }),
  };
}

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

/**
 * Which models stand beside the exact one, the same in all views, and their parameters. Where nobody
 * has chosen, each view has models of its own.
 * @param {Model[]} models
 * @returns {Record<string, Field>}
 */
export function modelFields(models) {
  const ids = models.map((m) => m.id).filter((id) => id !== "exact");
  const any = list(ids, ids); // so that an empty list is written "none"
  return {
    models: { ...any, default: null, print: (value) => (value === null ? "" : any.print(value)) },
    ...Object.fromEntries(
      models.flatMap((model) => model.parameters.map((p) => [stateName(model, p), fieldOf(p)])),
    ),
  };
}

/** Those chosen, in a view that starts with none. @param {State} state @returns {readonly string[]} */
export const chosenModels = ({ models }) => models ?? [];

/** A link's query in today's words: what Compare shows was once called `against`. @param {string} search */
export function inTodaysWords(search) {
  const asked = new URLSearchParams(search);
  const models = asked.get("against");
  if (models === null) return search;
  asked.delete("against");
  if (asked.get("view") === "compare" || !asked.has("models")) asked.set("models", models);
  return `?${asked}`;
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
