// Events of the walkthrough ("cut", "box lifts") as vertical lines over a chart of frames.

import type uPlot from "uplot";
import type { FrameEvent } from "./data";
import { make } from "./dom";
import type { FrameAxis } from "./curves";

/** Least distance of two labels in pixels; closer ones only have their line and its title. */
const labelRoom = 70;

interface Mark { position: number; label: string }

function listMarks(axis: FrameAxis, events: FrameEvent[]): Mark[] {
  return axis.keys.flatMap((key, i) => {
    const labels = key === null ? [] : events.filter(([frame]) => frame === key[1]).map(([, label]) => label);
    return labels.length === 0 ? [] : [{ position: axis.positions[i]!, label: labels.join(", ") }];
  });
}

/** Hooks of a chart that keep its marks in place while it is resized. Labels are text nodes. */
export function makeEventHooks(axis: FrameAxis, events: FrameEvent[]): { ready: (plot: uPlot) => void; draw: (plot: uPlot) => void } {
  const marks = listMarks(axis, events);
  const layer = make("div", { class: "event-layer" });
  const lines = marks.map((mark) => {
    const line = make("div", { class: "event-line", title: mark.label }, make("span", {}, mark.label));
    layer.append(line);
    return { line, mark };
  });
  return {
    ready: (plot) => plot.over.append(layer),
    draw: (plot) => {
      let free = -Infinity;
      for (const { line, mark } of lines) {
        const x = plot.valToPos(mark.position, "x");
        line.style.left = `${x}px`;
        line.classList.toggle("to-left", x > plot.over.clientWidth - labelRoom);
        line.classList.toggle("bare", x < free);
        free = x < free ? free : x + labelRoom;
      }
    },
  };
}
