/** The options of this room's functions; known everywhere without an import, and never sent. */

interface WavelengthOptions {
  materials: Material[];
  actions: Actions;
  /** Of ids. */
  prefix?: string;
}

interface InterfaceOptions {
  catalog: Catalog;
  presets: State;
  state: () => State;
  actions: Actions;
  /** Of the ids. */
  prefix: string;
  /** How each index is shown, in this order. */
  manners?: Record<string, RowManner>;
  /** Makes a symbol that is explained by a tap. */
  term?: (name: string, symbol: Node) => HTMLElement;
  describeMedia: () => Promise<void>;
}

interface FieldOptions {
  label: string;
  placeholder?: string;
  materials: readonly Material[];
  /** Beside the name. */
  note: (material: Material) => string;
  /** Why a medium cannot stand on this side. */
  refusal: (material: Material) => string | null;
  /** Completes what media are found by. */
  describe: () => Promise<void>;
  onPick: (id: string) => void;
}

interface ListOptions extends Omit<FieldOptions, "label" | "placeholder"> {
  input: HTMLInputElement;
  /** What stands in the field for a medium, by default the chosen one. */
  written: (id?: string | null) => string;
  chosen: () => string | null;
}

interface ChoiceOptions {
  legend: string;
  items: { value: string; label: string; note?: string; content?: Node }[];
  several?: boolean;
  /** One below the other. */
  listed?: boolean;
  onChange: (values: string[]) => void;
}

interface SheetOptions {
  pages: SheetPage[];
  body: HTMLElement;
  /** The page shown first. */
  first: string;
}

interface ControlsOptions {
  catalog: Catalog;
  /** The state's defaults. */
  presets: State;
  state: () => State;
  actions: Actions;
  describeMedia: () => Promise<void>;
  say: (text: string) => void;
}

interface PlayerOptions {
  now: () => { value: number; low: number; high: number; fine: number };
  onValue: (value: number) => void;
  onPlaying: (playing: boolean) => void;
}

interface ParametersOptions {
  models: Model[];
  state: () => State;
  actions: Actions;
  /** Of ids. */
  prefix?: string;
}

interface RowOptions {
  parameter: { name: string; symbol: string; minimum: number; maximum: number };
  /** Of the ids, where another view has a row of the same name. */
  prefix?: string;
  /** The value that a double click goes back to; null leaves it to the server. */
  preset: number | null;
  label: string;
  /** The symbol, where it is explained by a tap. */
  term?: HTMLElement;
  /** Of the slider. */
  range: [number, number];
  /** Of the slider after "more". */
  wide?: [number, number];
  steps: Steps;
  onChange: (value: number | null, moving: boolean) => void;
  onSettle: () => void;
  /** How the value is written where it differs from the plain number (angles). */
  writing?: {
    print: (value: number) => string;
    end: (value: number) => string;
    parse: (text: string, expression: typeof import("../numbers/expression.js")) => number;
    allowed: () => string;
  };
}

/** How a parameter is moved; what it may be is declared by the server. */
type RowManner = Pick<RowOptions, "label" | "range" | "wide"> & Partial<Pick<RowOptions, "steps">>;

interface SheetPage {
  name: string;
  symbol: string;
  row: { element: HTMLElement };
  print: () => string;
}

/** A control of a model's own parameter. */
interface Control {
  element: HTMLElement;
  update: (value: Json, solved?: number) => void;
  stop: () => void;
}

interface FoldOptions {
  legend: string;
  entries: readonly {
    id: string;
    title: string;
    note: string;
    style: { color: string; dash: string };
  }[];
  open?: boolean;
  /** Those of all folds, in the order in which they were chosen. */
  chosen: () => readonly string[];
  onChange: (ids: string[]) => void;
}

/** A number of the Explore view. */
interface NumberEntry {
  name: string;
  heading: Node | string;
  get: (reading: Reading) => number | null | undefined;
  degrees?: boolean;
}

/** White light, once it was to be seen. */
interface WhiteLight {
  spread: typeof import("../explore/dispersion.js").spread;
  panel: Awaited<ReturnType<typeof import("../explore/dispersion.js").createDispersion>>;
}
