/** The options of this room's functions; known everywhere without an import, and never sent. */

/** What came of a request; a status of 0 says that the server is out of reach. */
interface Received {
  status: number;
  text: string;
}

type Transport = (url: string, signal?: AbortSignal) => Promise<Received>;

type Failure = import("./api.js").Problem;
type StateStore = ReturnType<typeof import("../state/state.js").createState>;

/** What a link says that cannot be shown. */
interface LinkProblem {
  key: string;
  text: string;
  message: string;
}

/** The numbers at one angle. */
interface Reading {
  interface: Interface;
  theta_i_deg: number;
  theta_t_deg: number | null;
  tir: boolean;
  R: number;
  Rs: number;
  Rp: number;
  T: number;
  Ts: number;
  Tp: number;
  penetration_depth_wavelengths: number | null;
  field_penetration_depth_wavelengths: number | null;
  snell: Snell | null;
}

/** What the plot over the angle shows. */
interface Shown {
  polarization: string;
  angle: "deg" | "rad";
  show: string[];
  models: string[];
  marks: boolean;
}

interface ConstantsOptions {
  materials: Material[];
  /** What is implied has changed. */
  onChange: () => void;
  onProblem: (problem: Failure | null) => void;
  query: (how: { onAnswer: (data: Json) => void; onProblem: (problem: Failure) => void }) => {
    request: (path: string) => void;
  };
}

interface StateOptions {
  /** Whose URL follows the state; null for none. */
  window?: Pick<Window, "history" | "location"> | null;
  /** Values that others imply (a preset's indices): they follow from the state and are left out of the link. */
  implied?: (state: State) => State;
  now?: () => number;
}

interface QueryOptions {
  onAnswer: (data: Json, path: string) => void;
  onProblem: (problem: Failure) => void;
  onBusy?: (busy: boolean) => void;
  get?: (path: string, signal?: AbortSignal) => Promise<Json>;
  /** ms after which a newer request is sent beside one that is still under way. */
  patience?: number;
}

interface AskingOptions {
  /** Paths by name, and those that can wait until all these are answered; null where no view is open. */
  questions: () => { wanted: Record<string, string>; later: Record<string, string> } | null;
  moving: () => boolean;
  /** Whether what has been answered is on the screen. */
  painted: () => boolean;
  onAnswer: () => void;
  /** Whether it stays until the question is answered, or is asked no more. */
  onProblem: (name: string, problem: Failure) => boolean;
  /** Nothing that stays is left. */
  onRecovered: () => void;
  onBusy: (busy: boolean) => void;
  /** Answers by formulas that are here, once they are. */
  kernels?: () => Answerer | null;
  query?: typeof import("./api.js").createQuery;
}

/** A preset's indices at a wavelength. */
interface Resolved {
  id: string;
  wavelength_nm: number | null;
  n_absolute: number;
  k: number | null;
}
