/** The options of this room's functions; known everywhere without an import, and never sent. */

/** A view that was opened. */
interface Opened {
  module: ViewModule;
  view: View;
  host: Pick<HTMLElement, "hidden">;
}

/** A figure that can be drawn for a publication. */
interface Published {
  exportAs: (format: "png" | "svg", publication: Publication) => Promise<Blob>;
  /** Its title, and what is drawn in it. */
  about: () => { name: string; ids: readonly string[] };
  /** px of its width that are not the plot's, such as a key's. */
  beside?: number;
}

/** The media that a figure takes its indices from. */
interface Behind {
  /** Whose media they are. */
  state?: State | null;
  /** Of `n_i`, `n_t` and `k_t`, those that the figure holds fixed. */
  indices?: readonly string[];
  /** That it shows over their wavelengths. */
  presets?: readonly string[];
}

/** What the keys do that work everywhere. */
interface Orders {
  find: () => void;
  help: () => void;
  undo: () => void;
  redo: () => void;
}

interface RouterOptions {
  /** The first one is shown where an address names none. */
  views: readonly { id: string }[];
  load: (id: string) => Promise<ViewModule>;
  make: (id: string, module: ViewModule) => Omit<Opened, "module">;
  state: Pick<StateStore, "get" | "set" | "extend" | "fromQuery">;
  catalog: Catalog;
  /** The state's defaults, which each view adds to. */
  presets: State;
  /** The open view is left for another. */
  onLeave: (id: string) => void;
  /** A view cannot be loaded. */
  onFailure: (id: string, href: string, again: () => Promise<void>) => void;
  onArrival: (problems: LinkProblem[]) => void;
}

interface ShellOptions {
  onPresent: () => void;
  views: { id: string; title: string }[];
  onView: (id: string) => void;
  onTheme: () => void;
}

interface ExportsOptions {
  /** Such as "the curves". */
  what: string;
  /** All three unless given. */
  kinds?: readonly ("png" | "svg" | "csv")[];
  /** Of the file, without ending. */
  name: () => string;
  make: (format: "png" | "svg" | "csv") => Promise<Blob | Blob[]>;
  save: (name: string, blob: Blob) => void;
  /** What can be set up for a publication, a part of the REST call on the page that it shows, and where its indices are from. */
  print?: {
    figures: () => Published[];
    call: string;
    behind: () => Behind;
    /** Whether they need the width of two columns. */
    wide?: () => boolean;
  };
}

interface SettleDownOptions {
  /** Whether it stands in another page. */
  guest: boolean;
  /** Whose answers are on the screen. */
  paths: () => string[];
  showVersion: (version: string) => void;
}

interface SnippetsOptions {
  models: Model[];
  actions: Pick<Actions, "set">;
  say: (text: string) => void;
  save: (name: string, blob: Blob) => void;
}

interface TablesOptions {
  /** In the document, because plots read colors and sizes from it. */
  parent: HTMLElement;
  catalog: Catalog;
  actions: Pick<Actions, "set">;
}

interface ModelChoiceOptions {
  models: Model[];
  label: string;
  actions: Pick<Actions, "set">;
}

/** What is to be drawn for a publication. */
interface PublishTask {
  figures: Published[];
  /** A part of the REST call that they show. */
  call: string;
  behind: Behind;
  /** Of the files. */
  name: string;
  save: (name: string, blob: Blob) => void;
  /** Whether a column's width is too small. */
  wide?: boolean;
}

interface Cited {
  id: string;
  title: string;
  reference: string;
}

interface CitedPreset {
  id: string;
  name: string;
  kind: string;
  wavelength_nm: number | null;
  source: string;
  doi: string[];
}

interface CitedMedium {
  /** Of the preset. */
  id: string;
  /** Where it is taken; null is the preset's own wavelength. */
  at_nm?: number | null;
  /** The only index that is taken. */
  of?: string;
}

/** What can be found. */
interface Findable {
  id: string;
  name: string;
  category: string;
  aliases?: string[];
  source?: string;
  does: string;
  run: () => void;
}

/** What only some views know, and can be found from everywhere. */
interface FindablePlaces {
  sections: readonly { id: string; title: string }[];
  steps: readonly { id: string; title: string }[];
  traps: readonly { id: string; title: string }[];
  sheets: readonly { title: string }[];
  engines: readonly { id: string; title: string }[];
  targets: Readonly<Record<string, string>>;
}

interface FinderOptions {
  catalog: Catalog;
  views: readonly { id: string; title: string }[];
  /** The one that is open. */
  view: () => string;
  set: (patch: State) => void;
  describeMedia: () => Promise<void>;
  formulas: () => Promise<{ formulas: { id: string; title: string }[] }>;
  places: () => Promise<FindablePlaces>;
  actions: readonly { name: string; note: string; run: () => void }[];
  notice: (id: string, notice: { title: string; lines: string[] }) => void;
}
