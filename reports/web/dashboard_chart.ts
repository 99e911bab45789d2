// One series over the nights: value with its interval, the fence it is held against, steps, segments.

import uPlot from "uplot";
import type { HistorySeries, Night } from "./dashboard_data";
import { formatNumber, make } from "./dom";
import { followWidth, makeAxis } from "./plot";
import { chartFont, readTheme, type Theme } from "./theme";

const height = 210;
/** More nights than these are a line without dots. */
const mostDots = 120;
type Values = (number | null)[];

/** Columns of a chart: a gap stands between segments. */
interface Columns {
  positions: number[];
  /** index of the point at each position; null in a gap */
  points: (number | null)[];
}

export function layOutNights(series: HistorySeries): Columns {
  const begins = new Set(series.segments.map(([point]) => point));
  const columns: Columns = { positions: [], points: [] };
  series.positions.forEach((position, point) => {
    if (point > 0 && begins.has(point)) {
      columns.positions.push(position - 0.5);
      columns.points.push(null);
    }
    columns.positions.push(position);
    columns.points.push(point);
  });
  return columns;
}

/** A metric that never moves has a fence of a millionth: no axis is finer than half a percent. */
function padRange(low: number, high: number): [number, number] {
  const most = Math.max(Math.abs(low), Math.abs(high));
  const pad = Math.max(0.06 * (high - low), 0.0025 * most, Number.MIN_VALUE);
  return [low - pad, high + pad];
}

function pick(columns: Columns, values: Values): Values {
  return columns.points.map((point) => (point === null ? null : (values[point] ?? null)));
}

/** Upright lines with words on the canvas: steps in the accent, segments in grey. */
function drawMarks(plot: uPlot, series: HistorySeries, theme: Theme): void {
  const { ctx, bbox } = plot;
  const scale = devicePixelRatio;
  ctx.save();
  ctx.font = chartFont.replace("12px", `${Math.round(11 * scale)}px`);
  ctx.textBaseline = "top";
  let row = 0;
  const mark = (position: number, text: string, color: string, dash: number[]): void => {
    const x = Math.round(plot.valToPos(position, "x", true));
    ctx.strokeStyle = color;
    ctx.fillStyle = color;
    ctx.lineWidth = scale;
    ctx.setLineDash(dash.map((length) => length * scale));
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    const room = bbox.left + bbox.width - x;
    ctx.textAlign = room < ctx.measureText(text).width + 8 * scale ? "right" : "left";
    const shift = ctx.textAlign === "right" ? -4 * scale : 4 * scale;
    ctx.fillText(text, x + shift, bbox.top + (2 + 13 * (row++ % 3)) * scale);
  };
  for (const [point, text] of series.segments) {
    mark((series.positions[point] ?? 0) - 0.5, text, theme.soft, [2, 3]);
  }
  for (const [position, text, isConfirmed] of series.steps) {
    mark(position, text, isConfirmed ? theme.accent : theme.soft, isConfirmed ? [] : [4, 4]);
  }
  ctx.restore();
}

/** Draws into `holder`; returns what ends it. `read` hears of the night under the pointer. */
export function drawHistory(
  holder: HTMLElement,
  series: HistorySeries,
  nights: Night[],
  read: (text: string) => void,
): () => void {
  const theme = readTheme();
  const columns = layOutNights(series);
  const drawn: uPlot.Series[] = [{}];
  const bands: uPlot.Band[] = [];
  const data: Values[] = [];
  const hidden = { stroke: "transparent", points: { show: false } };
  const addBand = (high: Values, low: Values, fill: string): void => {
    bands.push({ series: [drawn.length, drawn.length + 1], fill });
    drawn.push(hidden, hidden);
    data.push(pick(columns, high), pick(columns, low));
  };
  addBand(series.fenceHigh, series.fenceLow, `${theme.soft}26`);
  if (series.lower.length > 0) {
    addBand(series.upper, series.lower, `${theme.accent}40`);
  }
  drawn.push({ stroke: theme.soft, width: 1, dash: [5, 4], points: { show: false } });
  data.push(pick(columns, series.baseline));
  const hasMilliseconds = series.milliseconds.length > 0;
  if (hasMilliseconds) {
    drawn.push({ scale: "ms", stroke: `${theme.soft}90`, width: 1, points: { show: false } });
    data.push(pick(columns, series.milliseconds));
  }
  drawn.push({ stroke: theme.accent, width: 1.75, points: { show: series.values.length <= mostDots, size: 4, fill: theme.accent } });
  data.push(pick(columns, series.values));

  const dateAt = new Map(series.positions.map((position, point) => [position, nights[series.nights[point] ?? -1]?.date ?? ""]));
  const readCursor = (plot: uPlot): void => {
    const index = plot.cursor.idx;
    const point = index === null || index === undefined ? null : (columns.points[index] ?? null);
    const night = point === null ? undefined : nights[series.nights[point] ?? -1];
    if (point === null || night === undefined) {
      read("");
      return;
    }
    const number = (values: Values): string => {
      const value = values[point] ?? null;
      return value === null ? "–" : formatNumber(value);
    };
    const milliseconds = hasMilliseconds ? `, ${number(series.milliseconds)} ${series.millisecondsUnit}` : "";
    read(`${night.date}: ${number(series.values)} ${series.unit}, fence ${number(series.fenceLow)} to ` +
      `${number(series.fenceHigh)}${milliseconds}, build ${night.build} ${night.commit}`);
  };
  const width = Math.max(200, Math.floor(holder.clientWidth));
  const axes: uPlot.Axis[] = [
    {
      ...makeAxis(theme, "", 28),
      labelSize: 0,
      space: 84,
      incrs: [1, 2, 5, 10, 20, 50, 100, 200],
      values: (_, splits) => splits.map((p) => dateAt.get(p) ?? ""),
    },
    { ...makeAxis(theme, series.unit, 58), values: (_, splits) => splits.map(formatNumber) },
  ];
  if (hasMilliseconds) {
    axes.push({
      ...makeAxis(theme, series.millisecondsUnit, 50),
      scale: "ms",
      side: 1,
      grid: { show: false },
      values: (_, splits) => splits.map(formatNumber),
    });
  }
  const plot = new uPlot(
    {
      width,
      height,
      scales: {
        x: { time: false, range: (_, low, high) => [low - 0.6, high + 0.6] },
        y: { range: (_, low, high) => padRange(low ?? 0, high ?? 1) },
      },
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, y: false, points: { size: 6 } },
      axes,
      series: drawn,
      bands,
      hooks: { setCursor: [readCursor], draw: [(u) => drawMarks(u, series, theme)] },
    },
    [columns.positions, ...data],
    holder,
  );
  const stop = followWidth(holder, plot);
  return () => {
    stop();
    plot.destroy();
    holder.replaceChildren();
  };
}

/** A figure that is drawn while it is near the window, so that thousands of nights open at once. */
export class HistoryFigure {
  private readonly holder = make("div", { class: "history-plot" });
  private readonly reading = make("p", { class: "history-reading" });
  private end: (() => void) | null = null;

  constructor(
    readonly figure: HTMLElement,
    private readonly series: HistorySeries,
    private readonly nights: Night[],
  ) {
    figure.append(this.holder, this.reading);
  }

  show(isNear: boolean): void {
    if (isNear === (this.end !== null)) {
      return;
    }
    this.end?.();
    this.end = isNear
      ? drawHistory(this.holder, this.series, this.nights, (text) => (this.reading.textContent = text))
      : null;
  }

  /** In the colours of the theme that is on now. */
  redraw(): void {
    if (this.end !== null) {
      this.show(false);
      this.show(true);
    }
  }
}
