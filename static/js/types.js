/**
 * The shapes that the API sends; types only, nothing is loaded from here at run time.
 *
 * @typedef {{name: string, symbol: string, default: number | null, minimum: number, maximum: number,
 *   unit: string, description: string, integer?: boolean, choices?: [string, number][], triple?: boolean}} Parameter
 * @typedef {{id: string, title: string, kind: string, applies_to: string[], parameters: Parameter[],
 *   latex: string, reference: string, validity: string, cost: unknown, trap?: boolean}} Model
 * @typedef {{id: string, name: string, category: string, n: number, k: number | null,
 *   wavelength_nm: number | null, kind: string, rival_of: string | null,
 *   n_range_nm: [number, number] | null, aliases?: string[], source?: string}} Material
 * @typedef {{n_i: number, n_t: number, k_t: number, eta: number, kappa: number, kind: string,
 *   F0: number, F82: number, brewster_deg: number | null, critical_deg: number | null,
 *   pseudo_brewster_deg: number, principal_deg: number}} Interface
 * @typedef {{model: string, quantity: string, values: (number | null)[], reason?: string | null}} Curve
 * @typedef {{interface: Interface, theta_i_deg: number[], curves: Curve[]}} Curves
 * @typedef {{re: number, im: number, abs: number, phase_deg: number}} Amplitude
 * @typedef {{interface: Interface, theta_i_deg: number, theta_t_deg: number | null,
 *   total_internal_reflection: boolean, r_s: Amplitude, r_p: Amplitude, t_s: Amplitude,
 *   t_p: Amplitude, Rs: number, Rp: number, R: number, Ts: number, Tp: number, T: number,
 *   penetration_depth_wavelengths: number | null}} Snell
 * @typedef {{parameters: Parameter[], models: Model[], materials: Material[]}} Catalog
 * @typedef {{title: string, detail: string, errors: {parameter?: string, value?: unknown, message: string}[]}} ProblemBody
 * @typedef {Record<string, any>} State
 * @typedef {{deg: number, label: string}} Landmark
 * @typedef {{id: string, label: string, x: number[], y: (number | null)[], color: string, dash?: string,
 *   width?: number, unit?: string, axis?: 'y' | 'y2'}} Trace
 * @typedef {object} ViewContext what main.js gives to a view
 * @property {HTMLElement} element
 * @property {readonly {id: string, title: string}[]} views all there are
 * @property {Catalog} catalog
 * @property {State} presets the state's defaults
 * @property {() => State} state
 * @property {{set: (patch: State, options?: {history?: 'push' | 'replace' | 'none'}) => void, settle: () => void}} actions
 * @property {(text: string) => void} say
 * @property {(name: string, blob: Blob) => void} save
 * @property {() => Promise<void>} describe completes the models' formulas, sources and costs
 * @property {() => Promise<void>} describeMedia completes the media's aliases and sources
 * @property {(latex: string, element: HTMLElement) => Promise<void>} typeset
 * @typedef {object} View
 * @property {(state: State, answers: Record<string, any>, moving: boolean) => void} update
 * @property {(state: State, answers: Record<string, any>) => string} sentence
 * @property {() => void} theme
 * @property {(name: string, problem: {title: string, lines: string[]}) => boolean} [problem] whether the view
 *   says itself what went wrong with this query
 * @property {() => void} deactivate
 * @property {() => void} destroy
 * @typedef {object} ViewModule
 * @property {(catalog: Catalog) => Record<string, import('./state.js').Field>} fields
 * @property {(context: ViewContext) => View} createView
 * @property {(state: State, catalog: Catalog, moving?: boolean) => Record<string, string>} queries what is left out
 *   keeps its last answer
 * @property {(state: State, catalog: Catalog) => Record<string, string>} [later] what is asked for when all of
 *   these are answered and nothing moves, one after the other
 * @property {(state: State, catalog: Catalog) => string[]} restCalls
 */

export {};
