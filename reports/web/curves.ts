// Curves over frames: bursts stand side by side on the frame axis, with a gap between them.

import uPlot from "uplot";
import type { Cell, FrameEvent, Metric, Round } from "./data";
import { formatNumber, make, makeButton, makeSelect } from "./dom";
import { makeEventHooks } from "./events";
import { makeAxis, PlotSlot } from "./plot";
import { onTheme, readSeriesColor, readTheme } from "./theme";

const gapFrames = 3;

/** One position on the axis a frame; runs of frames without the empty stretches between them. */
export interface FrameAxis {
  positions: number[];
  /** segment, frame; null in the gaps */
  keys: ([number, number] | null)[];
  /** positions where a run begins and ends */
  runs: [number, number][];
}

/** Bursts, or the single frames where there is no burst. */
export function layOutFrames(segments: [number, number][]): FrameAxis {
  const bursts = segments.map((s, i) => ({ s, i })).filter(({ s }) => s[1] - s[0] > 1);
  const shown = bursts.length > 0 ? bursts : segments.map((s, i) => ({ s, i }));
  const axis: FrameAxis = { positions: [], keys: [], runs: [] };
  let position = 0;
  for (const { s, i } of shown) {
    if (position > 0) {
      axis.positions.push(position);
      axis.keys.push(null);
      position += gapFrames;
    }
    const begin = position;
    for (let frame = s[0]; frame < s[1]; ++frame) {
      axis.positions.push(position++);
      axis.keys.push([i, frame]);
    }
    axis.runs.push([begin, position - 1]);
  }
  return axis;
}

type Values = (number | null)[];
interface Curve { cell: Cell; middle: Values; low?: Values; high?: Values }

function alignValues(axis: FrameAxis, rows: [number, number, number | null][]): Values {
  const byKey = new Map(rows.map(([segment, frame, value]) => [`${segment}/${frame}`, value]));
  return axis.keys.map((key) => (key === null ? null : (byKey.get(`${key[0]}/${key[1]}`) ?? null)));
}

/** Chips below a chart: switch a curve off, read its value under the pointer. */
class Legend {
  readonly element = make("ul", { class: "legend" });
  readonly hidden = new Set<string>();
  private readonly readings = new Map<string, HTMLElement>();
  private readonly frame = make("li", { class: "axis-reading" });

  constructor(cells: Cell[], onSwitch: () => void) {
    for (const cell of cells) {
      const reading = make("span", { class: "reading" });
      const button = makeButton("", () => {
        const isShown = !this.hidden.delete(cell.id);
        if (isShown) {
          this.hidden.add(cell.id);
        }
        button.setAttribute("aria-pressed", String(!isShown));
        onSwitch();
      });
      button.setAttribute("aria-pressed", "true");
      button.append(make("span", { class: `swatch ${cell.series}` }), cell.label, reading);
      this.readings.set(cell.id, reading);
      this.element.append(make("li", {}, button));
    }
    this.element.append(this.frame);
  }

  read(frame: string, values: Map<string, string>): void {
    this.frame.textContent = frame;
    for (const [id, element] of this.readings) {
      element.textContent = values.get(id) ?? "";
    }
  }
}

/** Values without a neighbour: no line reaches them, so they need a point. */
function listLone(values: Values): number[] {
  const isAbsent = (i: number): boolean => (values[i] ?? null) === null;
  return values.flatMap((_, i) => (!isAbsent(i) && isAbsent(i - 1) && isAbsent(i + 1) ? [i] : []));
}

interface CurveChart {
  axis: FrameAxis;
  events: FrameEvent[];
  label: () => string;
  makeCurves: () => Curve[];
  /** drawn dashed below the curves */
  makeFloor?: () => Values;
}

function makeCurveChart(figure: HTMLElement, { axis, events, label, makeCurves, makeFloor }: CurveChart): () => void {
  const holder = make("div");
  const slot = new PlotSlot(holder);
  let curves = makeCurves();

  const draw = (): void => {
    const theme = readTheme();
    curves = makeCurves();
    const shown = curves.filter((curve) => !legend.hidden.has(curve.cell.id));
    const series: uPlot.Series[] = [{}];
    const bands: uPlot.Band[] = [];
    const data: Values[] = [];
    const floor = makeFloor?.() ?? [];
    if (floor.some((value) => value !== null)) {
      series.push({ stroke: theme.soft, width: 1, dash: [5, 4], points: { show: false } });
      data.push(floor);
    }
    for (const curve of shown) {
      const color = readSeriesColor(curve.cell);
      if (curve.low !== undefined && curve.high !== undefined) {
        bands.push({ series: [series.length, series.length + 1], fill: `${color}2e` });
        series.push({ stroke: "transparent", points: { show: false } }, { stroke: "transparent", points: { show: false } });
        data.push(curve.high, curve.low);
      }
      const lone = listLone(curve.middle);
      series.push({ stroke: color, width: 1.75, points: { show: lone.length > 0, size: 6, filter: () => lone } });
      data.push(curve.middle);
    }
    const read = (plot: uPlot): void => {
      const index = plot.cursor.idx;
      const key = index === null || index === undefined ? null : axis.keys[index];
      const values = new Map<string, string>();
      if (key) {
        for (const curve of shown) {
          const value = curve.middle[index!];
          values.set(curve.cell.id, value === null || value === undefined ? "–" : formatNumber(value));
        }
      }
      legend.read(key ? `frame ${key[1]}` : "", values);
    };
    const marks = axis.runs.flatMap(([begin, end]) => (begin === end ? [begin] : [begin, end]));
    const { ready, draw: placeEvents } = makeEventHooks(axis, events);
    slot.show(
      {
        height: 300,
        scales: {
          x: { time: false },
          y: { range: (_, low, high) => [Math.min(0, low ?? 0), (high ?? 1) + 0.06 * Math.abs(high ?? 1)] },
        },
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, y: false, points: { size: 7 } },
        axes: [
          {
            ...makeAxis(theme, "frame", 34),
            splits: () => marks,
            values: (_, splits) => splits.map((p) => String(axis.keys[axis.positions.indexOf(p)]?.[1] ?? "")),
          },
          { ...makeAxis(theme, label(), 58), values: (_, splits) => splits.map(formatNumber) },
        ],
        series,
        bands,
        hooks: { setCursor: [read], ready: [ready], draw: [placeEvents] },
      },
      [axis.positions, ...data],
    );
  };

  const legend = new Legend(curves.map((curve) => curve.cell), draw);
  figure.append(holder, legend.element);
  onTheme(draw);
  return draw;
}

export function makeTimeCurves(figure: HTMLElement, round: Round, deviceClass: string): void {
  const axis = layOutFrames(round.segments);
  const cells = round.cells.filter((cell) => cell.times.length > 0);
  if (cells.length === 0) {
    figure.hidden = true;
    return;
  }
  const column = (cell: Cell, index: 2 | 3 | 4): Values =>
    alignValues(axis, cell.times.map((row) => [row[0], row[1], row[index]]));
  makeCurveChart(figure, {
    axis,
    events: round.events,
    label: () => `ms ${deviceClass}`,
    makeCurves: () =>
      cells.map((cell) => ({ cell, middle: column(cell, 2), low: column(cell, 3), high: column(cell, 4) })),
  });
}

const metricGroups = { image: "Errors of images", temporal: "Over time", history: "Histories (neither good nor bad)" };

export function makeErrorCurves(figure: HTMLElement, round: Round): void {
  const axis = layOutFrames(round.segments);
  const cells = round.cells.filter((cell) => cell.isMethod);
  if (round.metrics.length === 0 || cells.length === 0) {
    figure.hidden = true;
    return;
  }
  let metric: Metric = round.metrics.find((m) => m.name === round.frontMetric) ?? round.metrics[0]!;
  const draw = makeCurveChart(figure, {
    axis,
    events: round.events,
    label: () => metric.name,
    makeCurves: () => cells.map((cell) => ({ cell, middle: alignValues(axis, cell.frameErrors[metric.name] ?? []) })),
    makeFloor: () => alignValues(axis, metric.frameFloors),
  });
  const choose = makeSelect(round.metrics.map((m) => ({ value: m.name, text: m.name, group: metricGroups[m.kind] })), "Metric", (name) => {
    metric = round.metrics.find((m) => m.name === name) ?? metric;
    draw();
  });
  choose.value = metric.name;
  figure.querySelector("figcaption")?.append(make("span", { class: "controls" }, choose));
}
