// Elements without markup: text only ever becomes a text node, so that no label can become an element.

type Child = Node | string;

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

export function makeSelect(
  options: { value: string; text: string; group?: string }[],
  name: string,
  onChange: (value: string) => void,
): HTMLSelectElement {
  const select = make("select", { "aria-label": name });
  const groups = new Map<string, HTMLOptGroupElement>();
  for (const option of options) {
    let place: HTMLElement = select;
    if (option.group !== undefined) {
      const group = groups.get(option.group) ?? make("optgroup", { label: option.group });
      groups.set(option.group, group);
      select.append(group);
      place = group;
    }
    place.append(make("option", { value: option.value }, option.text));
  }
  select.addEventListener("change", () => onChange(select.value));
  return select;
}

export function makeButton(text: string, onClick: () => void, key?: string): HTMLButtonElement {
  const button = make("button", { type: "button" }, text);
  if (key !== undefined) {
    button.append(make("kbd", {}, key));
  }
  button.addEventListener("click", onClick);
  return button;
}

export function formatNumber(value: number): string {
  return value === 0 ? "0" : String(Number(value.toPrecision(3)));
}
