/**
 * The shapes that many modules speak of: what the API sends, the state, and what main.js and the
 * views promise each other. All are known everywhere without an import, and none is sent to a browser.
 */

interface Parameter {
  name: string;
  symbol: string;
  default: number | null;
  minimum: number;
  maximum: number;
  unit: string;
  description: string;
  integer?: boolean;
  choices?: [string, number][];
  triple?: boolean;
}

/** Name of a css custom property, without its dashes, and a dash. */
interface Look {
  color: string;
  dash: string;
}

interface Model {
  id: string;
  look?: Look;
  title: string;
  kind: string;
  applies_to: string[];
  parameters: Parameter[];
  takes_color?: boolean;
  latex: string;
  reference: string;
  validity: string;
  cost: unknown;
  trap?: boolean;
}

interface Material {
  id: string;
  name: string;
  category: string;
  /** relative to what its source measured it */
  n: number;
  /** against vacuum, as n_i and n_t are */
  n_absolute: number;
  k: number | null;
  wavelength_nm: number | null;
  kind: string;
  rival_of: string | null;
  n_range_nm: [number, number] | null;
  /** the largest, where its source gives n from one value to another */
  n_max?: number | null;
  aliases?: string[];
  source?: string;
  /** Of what is not in the list that the page starts with, all that its table shows. */
  swatch?: { gamut: string; hex: string | null };
}

interface Interface {
  n_i: number;
  n_t: number;
  k_t: number;
  eta: number;
  kappa: number;
  kind: string;
  F0: number;
  F82: number;
  brewster_deg: number | null;
  critical_deg: number | null;
  pseudo_brewster_deg: number;
  principal_deg: number;
}

/** A formula of kernels.js, and the names of its arguments in their order. */
interface Kernel {
  (...numbers: number[]): number;
  takes: readonly string[];
}

/** What kernels.js has of a model; of the exact solution many quantities besides R. */
interface KernelModel {
  R: Kernel;
  solve?: Record<string, Kernel>;
}

type KernelModels = Record<string, KernelModel>;

interface KernelAnswer {
  answer: Json;
  /** Whether the formulas gave all that was asked for. */
  complete: boolean;
}

type Answerer = (path: string, last: Json) => KernelAnswer | null;

interface Media {
  n_i: number;
  n_t: number;
  k_t: number;
}

interface Curve {
  model: string;
  quantity: string;
  values: (number | null)[];
  reason?: string | null;
}

interface Curves {
  interface: Interface;
  theta_i_deg: number[];
  curves: Curve[];
}

interface Amplitude {
  re: number;
  im: number;
  abs: number;
  phase_deg: number;
}

interface Snell {
  interface: Interface;
  theta_i_deg: number;
  theta_t_deg: number | null;
  total_internal_reflection: boolean;
  r_s: Amplitude;
  r_p: Amplitude;
  t_s: Amplitude;
  t_p: Amplitude;
  Rs: number;
  Rp: number;
  R: number;
  Ts: number;
  Tp: number;
  T: number;
  penetration_depth_wavelengths: number | null;
  field_penetration_depth_wavelengths: number | null;
}

interface Catalog {
  parameters: Parameter[];
  models: Model[];
  materials: Material[];
}

/** Whatever a JSON text can hold: who asks for it knows its shape. */
// biome-ignore lint/suspicious/noExplicitAny: a server's answer has no type before it is read
type Json = any;

/** The last answers by the names of their queries; `asked` has the path of each. */
type Answers = Record<string, Json>;

type State = Record<string, Json>;

/** One value of the state as the address spells it. */
interface Field {
  default: Json;
  /** Throws a LinkError for what a link may not say. */
  parse: (text: string) => Json;
  print: (value: Json) => string;
}

/** How a view changes the state. */
interface Actions {
  set: (patch: State, options?: { history?: "push" | "replace" | "none" }) => void;
  settle: () => void;
}

interface Landmark {
  deg: number;
  label: string;
}

/** What main.js gives to a view. */
interface ViewContext {
  element: HTMLElement;
  /** What stood here before the first view: the server's picture of it, if it drew one. */
  first: HTMLElement | null;
  /** All there are. */
  views: readonly { id: string; title: string }[];
  catalog: Catalog;
  /** The state's defaults. */
  presets: State;
  state: () => State;
  actions: Actions;
  say: (text: string) => void;
  save: (name: string, blob: Blob) => void;
  /** Completes the models' formulas, sources and costs. */
  describe: () => Promise<void>;
  /** Completes the media's aliases and sources. */
  describeMedia: () => Promise<void>;
  typeset: (latex: string, element: HTMLElement) => Promise<void>;
}

interface View {
  update: (state: State, answers: Answers, moving: boolean) => void;
  sentence: (state: State, answers: Answers) => string;
  theme: () => void;
  /** Whether the view says itself what went wrong with this query. */
  problem?: (name: string, problem: { title: string; lines: string[] }) => boolean;
  deactivate: () => void;
  destroy: () => void;
}

interface ViewModule {
  fields: (catalog: Catalog) => Record<string, Field>;
  createView: (context: ViewContext) => View;
  /** Paths by name; what is left out keeps its last answer. */
  queries: (state: State, catalog: Catalog, moving?: boolean) => Record<string, string>;
  /** What is asked for when all of these are answered and nothing moves, one after the other. */
  later?: (state: State, catalog: Catalog) => Record<string, string>;
  restCalls: (state: State, catalog: Catalog) => string[];
}

type Child = Node | string | null | undefined | false;

/** The element of a tag with classes, such as `p.hint`. */
type ElementOf<Tag extends string> = Tag extends `${infer Name}.${string}`
  ? ElementOf<Name>
  : Tag extends keyof HTMLElementTagNameMap
    ? HTMLElementTagNameMap[Tag]
    : never;

interface MakeElement {
  <Tag extends string>(tag: Tag, ...children: Child[]): ElementOf<Tag>;
  <Tag extends string>(
    tag: Tag,
    attributes: Record<string, unknown>,
    ...children: Child[]
  ): ElementOf<Tag>;
}

/** What is done at which event. */
type Listeners = {
  [Kind in keyof HTMLElementEventMap]?: (event: HTMLElementEventMap[Kind]) => void;
};
