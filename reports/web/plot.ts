// What every uPlot chart here shares: axes in the page's colours, a size that follows the figure.

import uPlot from "uplot";
import { chartFont, type Theme } from "./theme";

export function makeAxis(theme: Theme, label: string, size: number): uPlot.Axis {
  return {
    label,
    labelFont: chartFont,
    font: chartFont,
    labelSize: 22,
    size,
    stroke: theme.soft,
    grid: { stroke: theme.line, width: 1 },
    ticks: { stroke: theme.line, width: 1, size: 5 },
  };
}

/** Keeps a chart as wide as its holder. Returns a function that ends it. */
export function followWidth(holder: HTMLElement, plot: uPlot): () => void {
  const observer = new ResizeObserver(() => {
    const width = Math.floor(holder.clientWidth);
    if (width > 0 && width !== plot.width) {
      plot.setSize({ width, height: plot.height });
    }
  });
  observer.observe(holder);
  return () => observer.disconnect();
}

/** A chart that can be drawn anew (another metric, another theme) in the same place. */
export class PlotSlot {
  private plot: uPlot | null = null;
  private stop: (() => void) | null = null;

  constructor(private readonly holder: HTMLElement) {}

  show(options: Omit<uPlot.Options, "width">, data: uPlot.AlignedData): uPlot {
    this.stop?.();
    this.plot?.destroy();
    const width = Math.max(200, Math.floor(this.holder.clientWidth));
    this.plot = new uPlot({ ...options, width }, data, this.holder);
    this.stop = followWidth(this.holder, this.plot);
    return this.plot;
  }
}
