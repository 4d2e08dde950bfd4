/** The words that the modules of the diagram share; known everywhere without an import, and never sent. */

interface DiagramValues {
  interface: { n_i: number; n_t: number; k_t: number };
  theta_i_deg: number;
  theta_t_deg: number | null;
  R: number;
  Rs: number;
  Rp: number;
  T: number;
  Ts?: number;
  Tp?: number;
  tir: boolean;
  penetration_depth_wavelengths: number | null;
  field_penetration_depth_wavelengths: number | null;
  polarization: "s" | "p" | "unpolarized";
  labels: { incident: string; transmitted: string };
  angleUnit: "deg" | "rad";
  landmarks: readonly Landmark[];
  /** Refracted rays of white light, in place of the one. */
  dispersion?: readonly ColoredRay[];
  /** While something moves nothing is turned over. */
  held?: boolean;
}

interface ColoredRay {
  nm: number;
  theta_t_deg: number | null;
  color: string;
}

interface DragActions {
  onTheta: (theta_i_deg: number, how: { fine: boolean; free: boolean }) => void;
  onSettle?: () => void;
  onStep?: (kind: "+" | "-" | "fine+" | "fine-" | "page+" | "page-" | "home" | "end") => void;
}

/** Where the ray meets the surface, in px. */
interface Stage extends Size, Place {
  /** Of an arrow that carries all of the light. */
  length: number;
  /** Radius of the angles' arcs. */
  arc: number;
  /** px that stand for one vacuum wavelength of depth. */
  wavelength: number;
  /** px of words from the edge. */
  inset: number;
  /** How much larger than at a desk everything is written. */
  unit: number;
  /** Its two ends. */
  normal: { top: number; bottom: number };
  /** Whether the light comes from below: all is worked out as if from above, and seen turned over. */
  mirror?: boolean;
}

/** What is drawn, for the words to be placed around it. */
interface Drawn {
  values: DiagramValues;
  /** Reflected. */
  share: number;
  /** Transmitted. */
  rest: number;
  /** In vacuum wavelengths. */
  depth: number | null;
  /** Unit vectors of the rays. */
  back: Place;
  up: Place;
  down: Place | null;
  source: Place;
  /** What the signs of polarization cover. */
  signs: readonly Box[];
}

/** A place for a label's centre, and what it costs. */
interface Candidate extends Place {
  slot: string;
  cost: number;
}

interface Wish {
  id: string;
  size: Size;
  candidates: Candidate[];
  optional?: boolean;
}

interface Placed extends Place {
  id: string;
  slot: string;
  clear: boolean;
}

interface ListenForDragsOptions {
  host: HTMLElement;
  handle: HTMLElement;
  grip: SVGElement;
  stage: () => Stage;
  theta: () => number;
  /** The angle whose name lies under the pointer. */
  named: (event: PointerEvent) => number | undefined;
  actions: DragActions;
}

interface DescriptionOptions {
  interface: { n_i: number; n_t: number; k_t: number };
  labels: { incident: string; transmitted: string };
  theta_i_deg: number;
  theta_t_deg: number | null;
  tir: boolean;
  /** Share. */
  reflected: number;
  /** Share. */
  passed: number;
  depth: number | null;
  field_penetration_depth_wavelengths: number | null;
  polarization: string;
  angleUnit: "deg" | "rad";
}

interface PlaceAllOptions {
  wishes: readonly Wish[];
  frame: Box;
  segments: readonly Segment[];
  boxes: readonly Box[];
  previous?: ReadonlyMap<string, Placed>;
}

type DiagramFaces = Record<"name" | "index" | "angle" | "share" | "landmark", Measure>;

/** A line with a place of its own: its left end, at middle height. */
interface FixedLine extends Place {
  key: "upperName" | "upperIndex" | "lowerName" | "lowerIndex" | "depth" | "total" | "totalRest";
  text: string;
  box: Box;
}

/** A label by its centre. */
interface PlacedText extends Place {
  id: string;
  text: string;
  box: Box;
  clear: boolean;
}
