// The charts of the dashboard. The page is complete without them.

import "uplot/dist/uPlot.min.css";
import "./enhanced.css";
import "./dashboard.css";
import { HistoryFigure } from "./dashboard_chart";
import { readDashboardData } from "./dashboard_data";
import { onTheme } from "./theme";

document.documentElement.classList.add("enhanced");
const data = readDashboardData();
if (data !== null) {
  const byId = new Map(data.series.map((series) => [String(series.id), series]));
  const figures = new Map<Element, HistoryFigure>();
  document.querySelectorAll<HTMLElement>("figure[data-series]").forEach((figure) => {
    const series = byId.get(figure.dataset["series"] ?? "");
    if (series !== undefined) {
      figures.set(figure, new HistoryFigure(figure, series, data.nights));
    }
  });
  const observer = new IntersectionObserver(
    (entries) => entries.forEach((entry) => figures.get(entry.target)?.show(entry.isIntersecting)),
    { rootMargin: "800px" },
  );
  figures.forEach((_, figure) => observer.observe(figure));
  onTheme(() => figures.forEach((figure) => figure.redraw()));
}
