// Colours come from the page's style sheet, so that charts and tables agree in light and dark.

import type { Cell } from "./data";

export interface Theme { ink: string; soft: string; line: string; panel: string; accent: string }

function readVariable(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function readTheme(): Theme {
  return {
    ink: readVariable("--ink"),
    soft: readVariable("--soft"),
    line: readVariable("--line"),
    panel: readVariable("--panel"),
    accent: readVariable("--accent"),
  };
}

export function readSeriesColor(cell: Cell): string {
  return readVariable(`--${cell.series}`);
}

export const chartFont = '12px system-ui, -apple-system, "Segoe UI", "Liberation Sans", sans-serif';

/** Calls back now and whenever the reader's system turns dark or light. */
export function onTheme(draw: () => void): void {
  draw();
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
}
