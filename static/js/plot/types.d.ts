/** The words that the modules of plots share; known everywhere without an import, and never sent. */

interface Trace {
  id: string;
  /** May hold symbols such as `R_s`. */
  label: string;
  x: number[];
  /** `null` is a gap. */
  y: (number | null)[];
  /** Name of a CSS custom property, such as `--Rs`. */
  color: string;
  /** Plotly's: solid, dash, dot, dashdot, longdash, or lengths in px. */
  dash?: string;
  /** px */
  width?: number;
  /** Written behind a value. */
  unit?: string;
  axis?: "y" | "y2";
  /** Heading in the CSV file, `id` when missing. */
  column?: string;
  /** Whether no name stands at it, because another curve's says it too. */
  bare?: boolean;
}

interface Mark {
  x: number;
  label: string;
  kind: "landmark" | "current";
}

/** What several curves span, behind them all. */
interface Band {
  id: string;
  x: readonly number[];
  low: readonly (number | null)[];
  high: readonly (number | null)[];
  /** Name of a CSS custom property. */
  color: string;
}

interface Axis {
  title: string;
  /** `null` follows the data. */
  range?: readonly number[] | null;
  ticks?: readonly number[] | { values: readonly number[]; text: readonly string[] };
  /** `°` is written at each tick, others belong in the title. */
  unit?: string;
  /** Heading of x in the CSV file. */
  column?: string;
  /** Its symbol, where it is named beside a value. */
  short?: string;
  /** Least room for the labels of its ticks in px, so that frames of several plots align. */
  labels?: number;
  /** Of the keyboard. */
  steps?: Steps;
  /** Of x alone: equal ratios stand equally far apart. */
  scale?: "log";
}

interface Axes {
  x: Axis;
  y: Axis;
  y2: Axis | null;
}

interface Steps {
  step: number;
  fine: number;
  page: number;
}

interface Size {
  width: number;
  height: number;
}

interface Tick {
  value: number;
  label: string;
}

/** A curve's value where the marker stands. */
interface Reached {
  id: string;
  y: number | null;
}

interface Place {
  x: number;
  y: number;
}

type Box = Place & Size;

interface Segment {
  x1: number;
  y1: number;
  x2: number;
  y2: number;
}

/** The width of a label in px. */
type Measure = (label: string) => number;

type Span = [number, number];

/** How a plot is laid out on its area. */
interface Arrangement {
  size: Size;
  margins: { left: number; right: number; top: number; bottom: number };
  /** Where curves are drawn. */
  frame: Box;
  /** Of the axes as drawn. */
  ranges: { x: Span; y: Span; y2: Span | null };
  ticks: { x: Tick[]; y: Tick[]; y2: Tick[] };
  fontSize: number;
  /** How much larger than at a desk everything is written. */
  unit: number;
  padding: number;
  /** Whether room is kept above the frame for the names of marks. */
  marksRow: boolean;
  xPixel: (value: number) => number;
  yPixel: (value: number, axis?: "y" | "y2") => number;
  xValue: (pixel: number) => number;
}

/** The page's colors and faces as plain values. */
interface Theme {
  paper: string;
  ink: string;
  muted: string;
  rule: string;
  accent: string;
  panel: string;
  family: string;
  symbolFamily: string;
  /** How much larger than 14 px the page writes. */
  unit: number;
  /** A custom property's value. */
  color: (property: string) => string;
}

/** A figure for a paper or a slide. */
interface Publication {
  /** `clear-dark` has light letters for dark slides. */
  ground: "white" | "clear" | "clear-dark";
  width_mm: number;
  /** Without the caption. */
  height_mm: number;
  /** Of the axes. */
  font_pt: number;
  /** Paragraphs. */
  caption: readonly string[];
}

type OnPick = (x: number, how: { settled: boolean; fine: boolean; free: boolean }) => void;

interface PlotOptions {
  /** What readers hear, and the title of an exported picture. */
  name: string;
  x: Axis;
  y: Axis;
  y2?: Axis | null;
  onPick?: OnPick;
  /** Without ending. */
  filename?: string;
  /** So many curves at most carry their names, more have a legend. */
  names?: number;
  /** A picture of the same curves: while it stands, Plotly is asked for once they are seen. */
  meanwhile?: Element | null | undefined;
}

interface Plot {
  draw: (
    traces: readonly Trace[],
    marks?: readonly Mark[],
    bands?: readonly Band[],
  ) => Promise<void>;
  fast: (traces: readonly Trace[], marks?: readonly Mark[]) => void;
  marker: (x: number | null, points?: readonly Reached[]) => void;
  /** Takes effect with the next `draw`; `y2: null` takes the second axis away. */
  axes: (changes: Partial<Pick<PlotOptions, "name" | "x" | "y" | "y2">>) => void;
  exportAs: (format: "png" | "svg" | "csv", publication?: Publication) => Promise<Blob>;
  /** Its title, and the curves in it. */
  about: () => { name: string; ids: readonly string[] };
  filename: (format: "png" | "svg" | "csv") => string;
  table: () => HTMLTableElement;
  theme: () => void;
  resize: () => void;
  destroy: () => void;
}

/** The cells of a heat map, a row for each y. */
interface Grid {
  x: readonly number[];
  y: readonly number[];
  z: readonly (readonly (number | null)[])[];
}

/** What its colors stand for. */
interface MapScale {
  kind: "signed" | "size";
  low: number;
  high: number;
  capped: boolean;
}

/** A part of a heat map in the units of its axes. */
interface Region {
  x: readonly [number, number];
  y: readonly [number, number];
}

interface MapValues {
  title: string;
  kind: MapScale["kind"];
  print: (value: number | null) => string;
  /** The size that a line is drawn at. */
  level?: number | null;
  /** What the colors span where the data are not to say it. */
  range?: readonly [number, number];
}

interface MapOptions {
  name: string;
  x: Axis;
  y: Axis;
  z: MapValues;
  /** To be outlined. */
  regions?: readonly Region[];
  /** Of the models or fits that it shows. */
  ids?: readonly string[];
  onPick: (x: number, y: number) => void;
}

interface PicksOptions {
  area: HTMLElement;
  handle: HTMLElement;
  arrangement: () => Arrangement | null;
  current: () => number | null;
  steps: () => Steps;
  onPick: OnPick;
  onActive: (picking: boolean) => void;
}

interface ArrangeOptions {
  size: Size;
  axes: Axes;
  traces: readonly Trace[];
  /** Width of a tick's label. */
  measure: Measure;
  marksRow: boolean;
  unit?: number;
  /** Room for a title above all. */
  header?: number;
  /** Room on every side. */
  padding?: number;
}

interface PlaceLabelsOptions {
  curves: readonly LabelledCurve[];
  frame: Box;
  /** What labels must not cover. */
  obstacles?: readonly Box[];
  /** Px of upright lines, kept clear of where that is cheap. */
  uprights?: readonly number[];
  /** Where they stood: they move only for a reason. */
  previous?: ReadonlyMap<string, Place>;
}

interface PlaceMarkNamesOptions {
  /** `x` in px. */
  marks: readonly { x: number; width: number }[];
  frame: Box;
  unit?: number;
  /** Px at the left of the lower row that the axis title takes. */
  reserved: number;
}

/** A curve in px, whose name is to be placed. */
interface LabelledCurve {
  id: string;
  width: number;
  height: number;
  x: readonly number[];
  y: readonly (number | null)[];
}

/** An axis as Plotly has computed it. */
interface PixelAxis {
  l2p: (value: number) => number;
  _length: number;
}

/** A part of a label in one style. */
interface Run {
  text: string;
  italic: boolean;
  sub: boolean;
}

/** A curve as Plotly has drawn it. */
interface DrawnLine {
  id: string;
  axis: string;
  path: Element;
  rest: Element[];
  scale: Plotly.FullAxis;
}

/** A plot to stand alone. */
interface Picture {
  /** Above the plot, unless it is empty. */
  title: string;
  /** Paragraphs below it. */
  caption?: readonly string[];
  /** On every side, px. */
  padding?: number;
  traces: readonly Trace[];
  marks: readonly Mark[];
  bands?: readonly Band[];
  /** Names at the curves. */
  most?: number;
  axes: Axes;
  theme: Theme;
  /** Without legend and caption. */
  size: Size;
}
