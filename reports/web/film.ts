// Plays the film of a round: several kinds of pictures of one method side by side, frame by frame.

import type { Cell, Film, Round } from "./data";
import { make, makeButton, makeSelect } from "./dom";

/** Kinds that are shown at first, where the method has them. */
const firstKinds = ["visibility", "picture", "reference", "error", "flicker", "age", "cause"];
/** Frames a second; 30 is the default step of a walkthrough. */
const rates = [30, 15, 10, 5, 2];
const firstRate = 10;
const narrowestPane = 210;

interface Pane { key: string; element: HTMLElement; image: HTMLImageElement; missing: HTMLElement }

export class FilmPlayer {
  private readonly cells: Cell[];
  private readonly wanted = new Set(firstKinds);
  private method: string;
  private frame = 0; // from the film's begin
  private rate = firstRate;
  private timer: number | null = null;
  private panes: Pane[] = [];
  /** Decoded pictures of the present choice: held so that the browser keeps them. */
  private readonly preloaded = new Map<string, HTMLImageElement>();
  private isSeen = false;

  private readonly last: number;
  private readonly slider: HTMLInputElement;
  private readonly playButton: HTMLButtonElement;
  private readonly position = make("output", { class: "film-position" });
  private readonly event = make("output", { class: "film-event" });
  private readonly kindGroup = make("span", { class: "group", role: "group", "aria-label": "Pictures shown" });
  private readonly panesElement = make("div", { class: "film-panes" });

  constructor(private readonly root: HTMLElement, private readonly round: Round, private readonly film: Film) {
    this.cells = round.cells.filter((cell) => film.urls[cell.id] !== undefined);
    // The method with the most to show: one with a history.
    const countKinds = (cell: Cell): number => Object.keys(film.urls[cell.id] ?? {}).length;
    this.method = [...this.cells].sort((a, b) => countKinds(b) - countKinds(a))[0]?.id ?? "";
    this.last = film.end - film.begin - 1;
    this.slider = make("input", { type: "range", min: "0", max: String(this.last), step: "1", value: "0", "aria-label": "Frame of the film" });
    this.slider.addEventListener("input", () => {
      this.stop();
      this.show(Number(this.slider.value));
    });
    this.playButton = makeButton("Play", () => this.toggle());
    this.build();
    this.layOut();
  }

  private build(): void {
    const methods = makeSelect(this.cells.map((cell) => ({ value: cell.id, text: cell.label })), "Method of the film", (id) => {
      this.method = id;
      this.layOut();
    });
    methods.value = this.method;
    const rate = makeSelect(rates.map((r) => ({ value: String(r), text: `${r} frames/s` })), "Frames a second", (value) => {
      this.rate = Number(value);
      if (this.timer !== null) {
        this.stop();
        this.play();
      }
    });
    rate.value = String(this.rate);
    const jump = (text: string, name: string, frame: () => number): HTMLButtonElement => {
      const button = makeButton(text, () => {
        this.stop();
        this.show(frame());
      });
      button.setAttribute("aria-label", name);
      return button;
    };
    const buttons = make("span", { class: "group" }, jump("|◀", "First frame", () => 0), jump("◀", "Frame before", () => this.frame - 1),
      this.playButton, jump("▶", "Frame after", () => this.frame + 1), jump("▶|", "Last frame", () => this.last));
    this.root.tabIndex = 0;
    this.root.setAttribute("role", "group");
    this.root.setAttribute("aria-label", "Film");
    this.root.append(
      make("div", { class: "bar-row" }, make("label", {}, "Method", methods), this.kindGroup),
      this.panesElement,
      make("div", { class: "bar-row film-bar" }, buttons, make("div", { class: "film-track" }, this.slider, this.makeTicks()),
        this.position, rate),
      this.event,
    );
    this.root.addEventListener("keydown", (event) => this.onKey(event));
    new ResizeObserver(() => this.arrange()).observe(this.root);
    // Pictures are loaded ahead only once the film comes into view.
    const observer = new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting)) {
        observer.disconnect();
        this.isSeen = true;
        this.preload();
      }
    });
    observer.observe(this.root);
  }

  private makeTicks(): HTMLElement {
    const ticks = make("div", { class: "film-ticks" });
    for (const [frame, label] of this.listEvents()) {
      const tick = make("span", { class: "film-tick", title: label });
      tick.style.left = `${(100 * (frame - this.film.begin)) / Math.max(1, this.last)}%`;
      ticks.append(tick);
    }
    return ticks;
  }

  private listEvents(): [number, string][] {
    return this.round.events.filter(([frame]) => frame >= this.film.begin && frame < this.film.end);
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLSelectElement) {
      return;
    }
    const target: Record<string, number> = { ArrowLeft: this.frame - 1, ArrowRight: this.frame + 1, Home: 0, End: this.last };
    const frame = target[event.key];
    if (frame !== undefined) {
      this.stop();
      this.show(frame);
    } else if (event.key === " " && !(event.target instanceof HTMLButtonElement)) {
      this.toggle();
    } else {
      return;
    }
    event.preventDefault();
  }

  private toggle(): void {
    if (this.timer !== null) {
      this.stop();
      return;
    }
    if (this.frame === this.last) {
      this.show(0);
    }
    this.play();
  }

  private play(): void {
    this.playButton.textContent = "Pause";
    this.timer = window.setInterval(() => {
      this.show(this.frame + 1);
      if (this.frame === this.last) {
        this.stop();
      }
    }, 1000 / this.rate);
  }

  private stop(): void {
    if (this.timer !== null) {
      window.clearInterval(this.timer);
      this.timer = null;
    }
    this.playButton.textContent = "Play";
  }

  private findUrls(key: string): (string | null)[] | undefined {
    const ofReference = this.film.kinds.find((kind) => kind.key === key)?.ofReference ?? false;
    return this.film.urls[ofReference ? "reference" : this.method]?.[key];
  }

  /** Panes and switches anew, for another method or other kinds. */
  private layOut(): void {
    const kinds = this.film.kinds.filter((kind) => this.findUrls(kind.key) !== undefined);
    this.kindGroup.replaceChildren(...kinds.map((kind) => {
      const button = makeButton(kind.title, () => {
        if (!this.wanted.delete(kind.key)) {
          this.wanted.add(kind.key);
        }
        const index = kinds.indexOf(kind);
        this.layOut();
        (this.kindGroup.children[index] as HTMLElement).focus(); // the switches were made anew
      });
      button.setAttribute("aria-pressed", String(this.wanted.has(kind.key)));
      return button;
    }));
    this.panes = kinds.filter((kind) => this.wanted.has(kind.key)).map((kind) => {
      const image = make("img", { alt: kind.title, draggable: "false" });
      image.width = this.round.width;
      image.height = this.round.height;
      const missing = make("div", { class: "missing" }, "none on this frame");
      const frame = make("div", { class: "film-picture" }, image, missing);
      frame.style.aspectRatio = `${this.round.width} / ${this.round.height}`;
      const element = make("figure", {}, frame, make("figcaption", {}, kind.title));
      return { key: kind.key, element, image, missing };
    });
    this.panesElement.replaceChildren(...this.panes.map((pane) => pane.element));
    this.root.parentElement?.querySelectorAll<HTMLElement>(".film + .legends [data-legend]").forEach((legend) => {
      legend.hidden = !this.panes.some((pane) => pane.key === legend.dataset["legend"]);
    });
    this.arrange();
    this.show(this.frame);
    this.preload();
  }

  private arrange(): void {
    const most = Math.max(1, Math.floor(this.root.clientWidth / narrowestPane));
    const count = Math.max(1, this.panes.length);
    const rows = Math.ceil(count / most);
    this.panesElement.style.gridTemplateColumns = `repeat(${Math.ceil(count / rows)}, minmax(0, 1fr))`;
  }

  private preload(): void {
    if (!this.isSeen) {
      return;
    }
    const urls = new Set(this.panes.flatMap((pane) => this.findUrls(pane.key) ?? []).filter((url) => url !== null));
    for (const url of this.preloaded.keys()) {
      if (!urls.has(url)) {
        this.preloaded.delete(url);
      }
    }
    for (const url of urls) {
      if (!this.preloaded.has(url)) {
        const image = new Image();
        image.src = url;
        image.decode().catch(() => undefined); // a picture that went missing shows as such in its pane
        this.preloaded.set(url, image);
      }
    }
  }

  private show(frame: number): void {
    this.frame = Math.min(this.last, Math.max(0, frame));
    this.slider.value = String(this.frame);
    const shown = this.film.begin + this.frame;
    for (const pane of this.panes) {
      const url = this.findUrls(pane.key)?.[this.frame] ?? null;
      pane.image.hidden = url === null;
      pane.missing.hidden = url !== null;
      if (url !== null && pane.image.getAttribute("src") !== url) {
        pane.image.src = url;
      }
    }
    this.position.textContent = `frame ${shown} (${this.frame + 1} of ${this.last + 1})`;
    const passed = this.listEvents().filter(([at]) => at <= shown).at(-1);
    const ago = passed === undefined ? 0 : shown - passed[0];
    this.event.textContent = passed === undefined ? "" : `${passed[1]} (frame ${passed[0]}${ago > 0 ? `, ${ago} ago` : ""})`;
    this.event.classList.toggle("now", passed !== undefined && ago === 0);
  }
}
