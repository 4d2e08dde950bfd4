/** What opens the sheet of one's own material. */
interface OwnGiven {
  files?: File[];
  /** Where it is wanted. */
  side?: "incident" | "material" | "layer";
}

interface OwnOptions {
  catalog: Catalog;
  set: (values: Record<string, unknown>) => void;
  say: (sentence: string) => void;
}
