// Time against error: one point a method, bars for the intervals of ratio and error, the front as a line.

import uPlot from "uplot";
import type { Cell, CellError, Metric, Ratio, Round } from "./data";
import { formatNumber, make, makeSelect } from "./dom";
import { makeAxis, PlotSlot } from "./plot";
import { chartFont, onTheme, readSeriesColor, readTheme, type Theme } from "./theme";

interface Point { cell: Cell; ratio: Ratio; error: CellError; color: string }
type State = "cold" | "converged";
interface Box { left: number; top: number; right: number; bottom: number }

function listPoints(round: Round, metric: string, state: State): Point[] {
  const points: Point[] = [];
  for (const cell of round.cells) {
    const error = cell.errors[metric]?.[state] ?? null;
    if (cell.isMethod && cell.ratio !== null && error !== null) {
      points.push({ cell, ratio: cell.ratio, error, color: readSeriesColor(cell) });
    }
  }
  return points.sort((a, b) => a.ratio.value - b.ratio.value);
}

/** The points that no other one beats in both, from fast to slow. */
export function findFront(points: { time: number; error: number }[], lowerIsBetter: boolean): number[] {
  const sign = lowerIsBetter ? 1 : -1;
  const order = points.map((_, i) => i).sort((a, b) => {
    const p = points[a]!;
    const q = points[b]!;
    return p.time - q.time || sign * (p.error - q.error);
  });
  const front: number[] = [];
  let best = Infinity;
  for (const i of order) {
    const error = sign * points[i]!.error;
    if (error < best) {
      best = error;
      front.push(i);
    }
  }
  return front;
}

function overlaps(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/** Places a label beside its point where it hits nothing; nothing if there is no room. */
function placeLabel(x: number, y: number, width: number, height: number, area: Box, taken: Box[]): Box | null {
  const gap = 0.8 * height;
  const tries: [number, number][] = [
    [x + 0.5 * gap, y - 1.2 * height], [x + gap, y - height / 2], [x - gap - width, y - height / 2], [x - width / 2, y - gap - height],
    [x - width / 2, y + gap], [x + gap, y - 1.5 * height], [x + gap, y + 0.5 * height],
    [x - gap - width, y - 1.5 * height], [x - gap - width, y + 0.5 * height],
  ];
  for (const [left, top] of tries) {
    const box = { left, top, right: left + width, bottom: top + height };
    const inside = box.left >= area.left && box.right <= area.right && box.top >= area.top && box.bottom <= area.bottom;
    if (inside && !taken.some((other) => overlaps(box, other))) {
      return box;
    }
  }
  return null;
}

function shorten(text: string): string {
  return text.length > 36 ? `${text.slice(0, 35)}…` : text;
}

function drawPoints(plot: uPlot, points: Point[], metric: Metric, theme: Theme): void {
  const { ctx } = plot;
  const scale = devicePixelRatio;
  const area = { left: plot.bbox.left, top: plot.bbox.top, right: plot.bbox.left + plot.bbox.width, bottom: plot.bbox.top + plot.bbox.height };
  const toX = (value: number): number => plot.valToPos(value, "x", true);
  const toY = (value: number): number => plot.valToPos(value, "y", true);
  ctx.save();
  ctx.font = chartFont.replace("12px", `${12 * scale}px`);
  ctx.textBaseline = "middle";

  const floors = points.map((p) => p.error.floor).filter((f): f is number => f !== null);
  if (floors.length > 0) {
    const y = toY(floors.reduce((sum, f) => sum + f, 0) / floors.length);
    ctx.strokeStyle = theme.soft;
    ctx.setLineDash([5 * scale, 4 * scale]);
    ctx.lineWidth = scale;
    ctx.beginPath();
    ctx.moveTo(area.left, y);
    ctx.lineTo(area.right, y);
    ctx.stroke();
    ctx.setLineDash([]);
    ctx.fillStyle = theme.soft;
    ctx.textAlign = "right";
    ctx.fillText("reference floor", area.right - 6 * scale, y - 9 * scale);
    ctx.textAlign = "left";
  }

  const front = findFront(points.map((p) => ({ time: p.ratio.value, error: p.error.value })), metric.lowerIsBetter);
  ctx.strokeStyle = theme.accent;
  ctx.globalAlpha = 0.55;
  ctx.lineWidth = 1.5 * scale;
  ctx.beginPath();
  front.forEach((index, i) => {
    const point = points[index]!;
    const x = toX(point.ratio.value);
    const y = toY(point.error.value);
    if (i === 0) {
      ctx.moveTo(x, y);
    } else {
      ctx.lineTo(x, toY(points[front[i - 1]!]!.error.value));
      ctx.lineTo(x, y);
    }
  });
  ctx.stroke();
  ctx.globalAlpha = 1;

  const radius = 5.5 * scale;
  const taken: Box[] = points.map((p) => {
    const x = toX(p.ratio.value);
    const y = toY(p.error.value);
    return { left: x - radius, right: x + radius, top: y - radius, bottom: y + radius };
  });
  for (const point of points) {
    const x = toX(point.ratio.value);
    const y = toY(point.error.value);
    ctx.strokeStyle = point.color;
    ctx.fillStyle = point.color;
    ctx.lineWidth = 1.5 * scale;
    ctx.beginPath();
    for (const end of [toX(point.ratio.lower), toX(point.ratio.upper)]) {
      ctx.moveTo(x, y);
      ctx.lineTo(end, y);
      ctx.moveTo(end, y - 5 * scale);
      ctx.lineTo(end, y + 5 * scale);
    }
    for (const end of [toY(point.error.lower), toY(point.error.upper)]) {
      ctx.moveTo(x, y);
      ctx.lineTo(x, end);
      ctx.moveTo(x - 5 * scale, end);
      ctx.lineTo(x + 5 * scale, end);
    }
    ctx.stroke();
    ctx.beginPath();
    ctx.arc(x, y, radius, 0, 2 * Math.PI);
    ctx.fill();
    ctx.strokeStyle = theme.panel;
    ctx.stroke();
    const text = shorten(point.cell.label);
    const box = placeLabel(x, y, ctx.measureText(text).width, 15 * scale, area, taken);
    if (box !== null) {
      taken.push(box);
      const y0 = (box.top + box.bottom) / 2;
      ctx.strokeStyle = theme.panel; // a halo, where the front or the grid passes behind
      ctx.lineWidth = 4 * scale;
      ctx.lineJoin = "round";
      ctx.strokeText(text, box.left, y0);
      ctx.fillStyle = theme.ink;
      ctx.fillText(text, box.left, y0);
    }
  }
  ctx.restore();
}

/** A tip for the point nearest to the pointer. */
function makeTip(plot: uPlot, points: Point[], metric: Metric): void {
  const tip = make("div", { class: "tip", hidden: "" });
  plot.over.append(tip);
  plot.over.addEventListener("mouseleave", () => tip.setAttribute("hidden", ""));
  plot.over.addEventListener("mousemove", (event) => {
    let nearest: Point | null = null;
    let distance = 28;
    for (const point of points) {
      const dx = plot.valToPos(point.ratio.value, "x") - event.offsetX;
      const dy = plot.valToPos(point.error.value, "y") - event.offsetY;
      const away = Math.hypot(dx, dy);
      if (away < distance) {
        distance = away;
        nearest = point;
      }
    }
    tip.toggleAttribute("hidden", nearest === null);
    if (nearest !== null) {
      const x = plot.valToPos(nearest.ratio.value, "x");
      tip.replaceChildren(
        make("b", {}, nearest.cell.label),
        `${nearest.ratio.text} × anchor`,
        make("br"),
        `${metric.name} ${nearest.error.text} (n=${nearest.error.n} frames)`,
      );
      const toLeft = x > plot.over.clientWidth / 2;
      tip.style.left = toLeft ? "" : `${x + 14}px`;
      tip.style.right = toLeft ? `${plot.over.clientWidth - x + 14}px` : "";
      tip.style.top = `${Math.max(0, plot.valToPos(nearest.error.value, "y") - 30)}px`;
    }
  });
}

function padRange(low: number, high: number): [number, number] {
  const pad = 0.08 * (high - low || Math.abs(high) || 1);
  return [low - pad, high + pad];
}

export function makeScatter(figure: HTMLElement, round: Round): void {
  const metrics = round.metrics.filter((m) => m.kind === "image");
  if (metrics.length === 0) {
    figure.hidden = true;
    return;
  }
  let metric = metrics.find((m) => m.name === round.frontMetric) ?? metrics[0]!;
  let state: State = "cold";
  const holder = make("div");
  figure.append(holder);
  const slot = new PlotSlot(holder);

  const draw = (): void => {
    const theme = readTheme();
    const points = listPoints(round, metric.name, state);
    const times = points.flatMap((p) => [p.ratio.lower, p.ratio.upper]);
    const values = points.map((p) => p.error.value);
    const xRange = padRange(0, Math.max(1, ...times));
    const ends = points.flatMap((p) => [p.error.value, p.error.lower, p.error.upper]);
    const lowest = Math.min(...ends, ...(metric.lowerIsBetter ? [0] : []));
    const yRange = points.length === 0 ? ([0, 1] as [number, number]) : padRange(lowest, Math.max(...ends));
    const plot = slot.show(
      {
        height: 360,
        scales: { x: { time: false, range: () => [-0.03 * xRange[1], xRange[1]] }, y: { range: () => yRange } },
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, points: { show: false }, x: false, y: false },
        axes: [
          makeAxis(theme, "time, × anchor", 34),
          { ...makeAxis(theme, `${metric.name} (${state}), ${metric.lowerIsBetter ? "lower" : "higher"} is better`, 58), values: (_, splits) => splits.map(formatNumber) },
        ],
        series: [{}, { paths: () => null, points: { show: false } }],
        hooks: { draw: [(u) => drawPoints(u, points, metric, theme)] },
      },
      [points.map((p) => p.ratio.value), values],
    );
    makeTip(plot, points, metric);
  };

  const choose = makeSelect(metrics.map((m) => ({ value: m.name, text: m.name })), "Metric", (name) => {
    metric = metrics.find((m) => m.name === name) ?? metric;
    draw();
  });
  choose.value = metric.name;
  const chooseState = makeSelect(
    [{ value: "cold", text: "cold" }, { value: "converged", text: "converged" }], "State", (value) => {
      state = value === "converged" ? "converged" : "cold";
      draw();
    });
  figure.querySelector("figcaption")?.append(make("span", { class: "controls" }, choose, " ", chooseState));
  onTheme(draw);
}
