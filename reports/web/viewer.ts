// Pictures of one round at full size: choose frame, method and kind; alone, wiped against another or side by side.
// All panes share one zoom, and it stays while pictures change, so that flipping compares the same pixels.

import type { Cell, Round } from "./data";
import { make, makeButton, makeSelect } from "./dom";

type Mode = "single" | "wipe" | "side";
const modes: { mode: Mode; title: string }[] = [
  { mode: "single", title: "Single" }, { mode: "wipe", title: "Wipe" }, { mode: "side", title: "Side by side" },
];
const modeKeys: Record<string, Mode> = { q: "single", w: "wipe", s: "side" };
const zooms = [1, 2, 4, 8, 16];
const referenceId = "reference";

/** One picture area with a picture on top of another where it wipes. */
class Pane {
  readonly element = make("div", { class: "pane" });
  readonly images: HTMLImageElement[] = [];

  constructor(private readonly size: { width: number; height: number }) {}

  /** `layers`: the lower picture, then the one on its left side. */
  show(layers: { url: string | undefined; caption: string }[], split: number): void {
    this.element.replaceChildren();
    this.images.length = 0;
    layers.forEach((layer, i) => {
      const frame = i === 0 ? this.element : make("div", { class: "top-image" });
      if (i > 0) {
        frame.style.clipPath = `inset(0 ${100 - split}% 0 0)`;
        this.element.append(frame);
      }
      const missing = (): HTMLElement => make("div", { class: "missing" }, "not kept");
      if (layer.url === undefined) {
        frame.append(missing());
      } else {
        const image = make("img", { src: layer.url, alt: layer.caption, draggable: "false" });
        image.width = this.size.width;
        image.height = this.size.height;
        image.addEventListener("error", () => image.replaceWith(missing()));
        this.images.push(image);
        frame.append(image);
      }
      const isRight = layers.length > 1 && i === 0;
      this.element.append(make("span", { class: isRight ? "caption right" : "caption" }, layer.caption));
    });
    if (layers.length > 1) {
      const divider = make("div", { class: "divider" });
      divider.style.left = `${split}%`;
      this.element.append(divider);
    }
  }
}

export class Viewer {
  private readonly cells: Cell[];
  private frame: number;
  private method: string;
  private other = referenceId;
  private kind = "method";
  private mode: Mode = "single";
  private zoom = 1;
  private center = { x: 0.5, y: 0.5 };
  private split = 50;

  private readonly panes: Pane[];
  private readonly panesElement = make("div", { class: "panes" });
  private readonly position = make("span", { class: "position" });
  private readonly frameButtons = new Map<number, HTMLButtonElement>();
  private readonly kindButtons = new Map<string, HTMLButtonElement>();
  private readonly modeButtons = new Map<Mode, HTMLButtonElement>();
  private readonly methodSelect: HTMLSelectElement;
  private readonly otherLabel: HTMLElement;
  private readonly wipe = make("input", { type: "range", min: "0", max: "100", value: "50", "aria-label": "Wipe position" });

  constructor(private readonly root: HTMLElement, private readonly round: Round) {
    this.cells = round.cells.filter((cell) => cell.isMethod);
    this.frame = round.pictures.frames[0] ?? 0;
    this.method = this.cells.find((cell) => round.pictures.urls[cell.id] !== undefined && cell.ratio?.value)?.id
      ?? this.cells[0]?.id ?? "";
    this.panes = [new Pane(round), new Pane(round)];
    const methods = this.cells.map((cell) => ({ value: cell.id, text: cell.label }));
    this.methodSelect = makeSelect(methods, "Method", (id) => this.change(() => (this.method = id)));
    this.methodSelect.value = this.method;
    const otherSelect = makeSelect([{ value: referenceId, text: "Reference" }, ...methods], "Compared with",
      (id) => this.change(() => (this.other = id)));
    this.otherLabel = make("label", {}, "against", otherSelect);
    this.wipe.addEventListener("input", () => this.change(() => (this.split = Number(this.wipe.value))));
    this.build();
    this.render();
  }

  private build(): void {
    const frames = make("span", { class: "group", role: "group", "aria-label": "Frame" });
    for (const frame of this.round.pictures.frames) {
      const button = makeButton(String(frame), () => this.change(() => (this.frame = frame)));
      this.frameButtons.set(frame, button);
      frames.append(button);
    }
    const kinds = make("span", { class: "group", role: "group", "aria-label": "Picture" });
    this.round.pictures.kinds.forEach((kind, i) => {
      const button = makeButton(kind.title, () => this.change(() => (this.kind = kind.key)), String(i + 1));
      this.kindButtons.set(kind.key, button);
      kinds.append(button);
    });
    const modeGroup = make("span", { class: "group", role: "group", "aria-label": "Layout" });
    for (const { mode, title } of modes) {
      const key = Object.keys(modeKeys).find((k) => modeKeys[k] === mode)!;
      const button = makeButton(title, () => this.change(() => (this.mode = mode)), key);
      this.modeButtons.set(mode, button);
      modeGroup.append(button);
    }
    const zoomGroup = make("span", { class: "group", role: "group", "aria-label": "Zoom" },
      makeButton("−", () => this.stepZoom(-1)), makeButton("+", () => this.stepZoom(1)));
    this.root.tabIndex = 0;
    this.root.setAttribute("role", "group");
    this.root.setAttribute("aria-label", "Picture viewer");
    this.root.append(
      make("div", { class: "bar-row" }, make("label", {}, "Frame", frames), make("label", {}, "Method", this.methodSelect),
        this.otherLabel),
      make("div", { class: "bar-row" }, kinds, modeGroup, zoomGroup, this.wipe, this.position),
      this.panesElement,
    );
    this.root.addEventListener("keydown", (event) => this.onKey(event));
    for (const pane of this.panes) {
      this.listen(pane.element);
    }
    new ResizeObserver(() => this.place()).observe(this.root);
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLSelectElement ||
        event.target instanceof HTMLInputElement) {
      return;
    }
    const kind = this.round.pictures.kinds[Number(event.key) - 1];
    const mode = modeKeys[event.key];
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const methodStep = { n: 1, p: -1 }[event.key];
    if (kind !== undefined) {
      this.change(() => (this.kind = kind.key));
    } else if (mode !== undefined) {
      this.change(() => (this.mode = mode));
    } else if (step !== undefined) {
      const { frames } = this.round.pictures;
      const index = (frames.indexOf(this.frame) + step + frames.length) % frames.length;
      this.change(() => (this.frame = frames[index]!));
    } else if (methodStep !== undefined) {
      const index = this.cells.findIndex((cell) => cell.id === this.method);
      const next = this.cells[(index + methodStep + this.cells.length) % this.cells.length];
      this.change(() => (this.method = next?.id ?? this.method));
      this.methodSelect.value = this.method;
    } else if (event.key === "+" || event.key === "-") {
      this.stepZoom(event.key === "+" ? 1 : -1);
    } else {
      return;
    }
    event.preventDefault();
  }

  /** Dragging pans all panes; in wipe mode at zoom 1 it moves the divider. Ctrl + wheel zooms. */
  private listen(element: HTMLElement): void {
    let last: { x: number; y: number } | null = null;
    element.addEventListener("pointerdown", (event) => {
      last = { x: event.clientX, y: event.clientY };
      element.setPointerCapture(event.pointerId);
      element.classList.add("dragging");
    });
    element.addEventListener("pointerup", () => {
      last = null;
      element.classList.remove("dragging");
    });
    element.addEventListener("pointermove", (event) => {
      const box = element.getBoundingClientRect();
      this.showPosition((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
      if (last === null) {
        return;
      }
      if (this.mode === "wipe" && this.zoom === 1) {
        this.split = Math.min(100, Math.max(0, (100 * (event.clientX - box.left)) / box.width));
        this.wipe.value = String(this.split);
        this.render();
      } else {
        this.center.x -= (event.clientX - last.x) / (box.width * this.zoom);
        this.center.y -= (event.clientY - last.y) / (box.height * this.zoom);
        this.place();
      }
      last = { x: event.clientX, y: event.clientY };
    });
    element.addEventListener("pointerleave", () => (this.position.textContent = ""));
    element.addEventListener("wheel", (event) => {
      if (event.ctrlKey) {
        event.preventDefault();
        this.stepZoom(event.deltaY < 0 ? 1 : -1);
      }
    }, { passive: false });
  }

  private showPosition(u: number, v: number): void {
    const x = Math.floor((this.center.x + (u - 0.5) / this.zoom) * this.round.width);
    const y = Math.floor((this.center.y + (v - 0.5) / this.zoom) * this.round.height);
    this.position.textContent = `x ${x}, y ${y}, ${this.zoom}×`;
  }

  private stepZoom(step: number): void {
    const index = Math.min(zooms.length - 1, Math.max(0, zooms.indexOf(this.zoom) + step));
    this.zoom = zooms[index]!;
    this.position.textContent = `${this.zoom}×`;
    this.place();
  }

  private change(act: () => void): void {
    act();
    this.render();
  }

  /** The picture of one side. The reference's side of a method's picture is the reference's own. */
  private findLayer(cellId: string): { url: string | undefined; caption: string } {
    const { kinds, urls } = this.round.pictures;
    const cell = this.cells.find((c) => c.id === cellId);
    const isReference = cell === undefined;
    const key = isReference ? (this.kind.startsWith("shaded") ? "shaded_reference" : "reference") : this.kind;
    const ofReference = kinds.find((k) => k.key === key)?.ofReference ?? false;
    // A picture of the reference stands with every method that has pictures.
    const holders = ofReference ? this.cells.map((c) => c.id) : [cellId];
    const url = holders.map((id) => urls[id]?.[String(this.frame)]?.[key]).find((found) => found !== undefined);
    const title = kinds.find((k) => k.key === key)?.title ?? key;
    return { url, caption: ofReference ? title : `${cell?.label ?? ""}: ${title.toLowerCase()}` };
  }

  private render(): void {
    const press = <K>(buttons: Map<K, HTMLButtonElement>, active: K): void =>
      buttons.forEach((button, key) => button.setAttribute("aria-pressed", String(key === active)));
    press(this.frameButtons, this.frame);
    press(this.kindButtons, this.kind);
    press(this.modeButtons, this.mode);
    this.otherLabel.hidden = this.mode === "single";
    this.wipe.hidden = this.mode !== "wipe";
    const [first, second] = this.panes as [Pane, Pane];
    const mine = this.findLayer(this.method);
    const theirs = this.findLayer(this.other);
    first.show(this.mode === "wipe" ? [theirs, mine] : [mine], this.split);
    second.show(this.mode === "side" ? [theirs] : [], this.split);
    this.panesElement.replaceChildren(first.element, ...(this.mode === "side" ? [second.element] : []));
    this.place();
  }

  /** Sizes the panes and moves their pictures to the shared centre and zoom. */
  private place(): void {
    const half = 0.5 / this.zoom;
    this.center.x = Math.min(1 - half, Math.max(half, this.center.x));
    this.center.y = Math.min(1 - half, Math.max(half, this.center.y));
    const count = this.mode === "side" ? 2 : 1;
    // No taller than the window, so that the buttons and the picture are seen at once.
    const room = (this.root.clientWidth - 2 * (count - 1)) / count;
    const width = Math.max(1, Math.min(room, (0.76 * window.innerHeight * this.round.width) / this.round.height));
    this.panesElement.style.gridAutoColumns = `${width}px`;
    const scale = (width / this.round.width) * this.zoom;
    const height = (width * this.round.height) / this.round.width;
    const left = (half - this.center.x) * this.round.width * scale;
    const top = (half - this.center.y) * this.round.height * scale;
    for (const pane of this.panes) {
      pane.element.style.height = `${height}px`;
      for (const image of pane.images) {
        image.style.transform = `translate(${left}px, ${top}px) scale(${scale})`;
      }
    }
  }
}
