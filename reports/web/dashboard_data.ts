// The shape of the JSON inside the dashboard (reports/html/dashboard_data.cpp writes it).

export interface Night { date: string; build: string; commit: string }
type Values = (number | null)[];
export interface HistorySeries {
  id: number;
  title: string;
  /** with the device class where it is a time: "x anchor, software" */
  unit: string;
  /** of each point: index of its night among those of the device and suite, and among all nights */
  positions: number[];
  nights: number[];
  values: number[];
  /** 95 % interval; empty where the series has none */
  lower: Values;
  upper: Values;
  /** what the night was held against; null where there was nothing yet */
  baseline: Values;
  fenceLow: Values;
  fenceHigh: Values;
  /** point that begins another segment, and what changed */
  segments: [number, string][];
  /** position, text, is it confirmed */
  steps: [number, string, boolean][];
  /** of the same cell, at the same points: drawn beside it, never gated */
  milliseconds: Values;
  millisecondsUnit: string;
}
export interface DashboardData { nights: Night[]; series: HistorySeries[] }

export function readDashboardData(): DashboardData | null {
  const element = document.getElementById("data");
  return element === null ? null : (JSON.parse(element.textContent ?? "") as DashboardData);
}
