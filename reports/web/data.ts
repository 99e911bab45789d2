// The shape of the JSON inside the page (reports/html/page_data.cpp writes it).

export interface Ratio { value: number; lower: number; upper: number; text: string }
/** `lower` and `upper`: how it spreads over content */
export interface CellError { value: number; lower: number; upper: number; text: string; floor: number | null; n: number }
export interface Cell {
  id: string;
  label: string;
  /** class that gives an element the cell's colour; also the name of the CSS variable */
  series: string;
  isMethod: boolean;
  onFront: boolean;
  ratio: Ratio | null;
  errors: Record<string, { cold: CellError | null; converged: CellError | null }>;
  /** segment, frame, median, min, max in milliseconds */
  times: [number, number, number, number, number][];
  /** segment, frame, value */
  frameErrors: Record<string, [number, number, number | null][]>;
}
export interface Metric {
  name: string;
  title: string;
  kind: "image" | "temporal" | "history";
  lowerIsBetter: boolean;
  /** segment, frame, what the reference's own noise gives there */
  frameFloors: [number, number, number][];
}
export interface PictureKind { key: string; title: string; ofReference: boolean }
export interface Pictures {
  frames: number[];
  kinds: PictureKind[];
  /** cell, frame, kind; absent where a picture was not kept */
  urls: Record<string, Record<string, Record<string, string>>>;
}
/** frame, label */
export type FrameEvent = [number, string];
export interface Film {
  begin: number;
  /** exclusive */
  end: number;
  kinds: PictureKind[];
  /** cell ("reference" for kinds of the reference), kind, then a URL a frame; null where no picture was kept */
  urls: Record<string, Record<string, (string | null)[]>>;
}
export interface Round {
  id: string;
  width: number;
  height: number;
  segments: [number, number][];
  events: FrameEvent[];
  metrics: Metric[];
  frontMetric: string;
  cells: Cell[];
  pictures: Pictures;
  film: Film | null;
}
export interface PageData { deviceClass: string; rounds: Round[] }

export function readPageData(): PageData | null {
  const element = document.getElementById("data");
  return element === null ? null : (JSON.parse(element.textContent ?? "") as PageData);
}
