// Charts, viewer, film and sorting for the report's page. Everything here adds to a page that is complete without it.

import "uplot/dist/uPlot.min.css";
import "./enhanced.css";
import { makeErrorCurves, makeTimeCurves } from "./curves";
import { readPageData, type Round } from "./data";
import { FilmPlayer } from "./film";
import { makeScatter } from "./scatter";
import { makeSortable } from "./tables";
import { Viewer } from "./viewer";

function makeCharts(section: HTMLElement, round: Round, deviceClass: string): void {
  const find = (name: string): HTMLElement | null => section.querySelector(`[data-chart="${name}"]`);
  const [scatter, times, errors] = [find("scatter"), find("times"), find("errors")];
  if (scatter !== null && times !== null && errors !== null) {
    makeScatter(scatter, round);
    makeTimeCurves(times, round, deviceClass);
    makeErrorCurves(errors, round);
  }
}

document.documentElement.classList.add("enhanced");
const data = readPageData();
for (const round of data?.rounds ?? []) {
  const section = document.getElementById(`round-${round.id}`);
  if (section === null) {
    continue;
  }
  makeCharts(section, round, data!.deviceClass);
  const viewer = section.querySelector<HTMLElement>("[data-viewer]");
  if (viewer !== null && round.pictures.frames.length > 0) {
    new Viewer(viewer, round);
  }
  const film = section.querySelector<HTMLElement>("[data-film]");
  if (film !== null && round.film !== null) {
    new FilmPlayer(film, round, round.film);
  }
  // Viewer and film show the same pictures, larger; the sheets fold up.
  section.querySelectorAll("details.sheet").forEach((sheet) => sheet.removeAttribute("open"));
}
document.querySelectorAll<HTMLTableElement>("table[data-sortable]").forEach(makeSortable);
