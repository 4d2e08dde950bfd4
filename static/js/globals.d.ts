// The part that the page uses of the two vendored libraries, which load as classic scripts and
// put one global each on the window; either is missing until its script has run.

declare namespace Plotly {
  type Numbers = ArrayLike<number> | readonly (number | null)[];

  interface Line {
    color?: string;
    width?: number;
    dash?: string;
    simplify?: boolean;
    shape?: "linear" | "spline";
  }

  interface Trace {
    type?: "scatter" | "heatmap" | "contour";
    mode?: string;
    name?: string;
    uid?: string;
    x?: Numbers;
    y?: Numbers;
    z?: readonly Numbers[];
    text?: string | readonly string[];
    line?: Line;
    marker?: Record<string, unknown>;
    visible?: boolean | "legendonly";
    showlegend?: boolean;
    hoverinfo?: string;
    hovertemplate?: string;
    [attribute: string]: unknown;
  }

  interface Axis {
    title?: string | { text?: string; font?: Record<string, unknown>; standoff?: number };
    range?: [number, number];
    type?: "linear" | "log";
    autorange?: boolean | "reversed";
    [attribute: string]: unknown;
  }

  interface Layout {
    xaxis?: Axis;
    yaxis?: Axis;
    shapes?: Record<string, unknown>[];
    annotations?: Record<string, unknown>[];
    margin?: { l?: number; r?: number; t?: number; b?: number; pad?: number };
    width?: number;
    height?: number;
    [attribute: string]: unknown;
  }

  interface Config {
    responsive?: boolean;
    displayModeBar?: boolean | "hover";
    displaylogo?: boolean;
    showSendToCloud?: boolean;
    plotlyServerURL?: string;
    staticPlot?: boolean;
    [option: string]: unknown;
  }

  interface ImageOptions {
    format: "png" | "svg" | "jpeg" | "webp";
    width?: number | null;
    height?: number | null;
    scale?: number;
    filename?: string;
    imageDataOnly?: boolean;
  }

  interface Figure {
    data: Trace[];
    layout: Layout;
    config?: Config;
  }

  /** What Plotly computed for an axis; `l2p` maps a number to pixels from the axis's origin. */
  interface FullAxis extends Axis {
    range: [number, number];
    _offset: number;
    _length: number;
    l2p(value: number): number;
    p2l(pixels: number): number;
  }

  interface FullLayout {
    xaxis: FullAxis;
    yaxis: FullAxis;
    [attribute: string]: unknown;
  }

  /** The element after the first `newPlot` or `react`. */
  interface PlotElement extends HTMLElement {
    data: Trace[];
    layout: Layout;
    _fullLayout: FullLayout;
    _fullData: Trace[];
    // biome-ignore lint/suspicious/noExplicitAny: the event differs with its name
    on(event: string, listener: (event: any) => void): void;
    removeAllListeners(event: string): void;
  }

  interface Library {
    version: string;
    newPlot(
      target: HTMLElement,
      data: Trace[],
      layout?: Layout,
      config?: Config,
    ): Promise<PlotElement>;
    react(
      target: HTMLElement,
      data: Trace[],
      layout?: Layout,
      config?: Config,
    ): Promise<PlotElement>;
    relayout(target: HTMLElement, changes: Record<string, unknown>): Promise<PlotElement>;
    restyle(
      target: HTMLElement,
      changes: Record<string, unknown>,
      traces?: number | number[],
    ): Promise<PlotElement>;
    purge(target: HTMLElement): void;
    toImage(target: HTMLElement | Figure, options: ImageOptions): Promise<string>;
    downloadImage(target: HTMLElement | Figure, options: ImageOptions): Promise<string>;
    Plots: { resize(target: HTMLElement): Promise<void> };
  }
}

declare namespace katex {
  interface Options {
    displayMode?: boolean;
    throwOnError?: boolean;
    output?: "html" | "mathml" | "htmlAndMathml";
    macros?: Record<string, string>;
    strict?: boolean | string;
    trust?: boolean;
  }

  interface Library {
    version: string;
    render(tex: string, element: HTMLElement, options?: Options): void;
  }
}

declare var Plotly: Plotly.Library;
declare var katex: katex.Library;

interface Window {
  Plotly?: Plotly.Library;
  katex?: katex.Library;
}
