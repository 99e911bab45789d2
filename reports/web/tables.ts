// Tables that sort by a click on a head; a third click gives back the run's order.

export function makeSortable(table: HTMLTableElement): void {
  const body = table.tBodies[0];
  const head = table.tHead;
  if (body === undefined || head === null) {
    return;
  }
  const original = [...body.rows];
  for (const th of head.querySelectorAll<HTMLTableCellElement>("th[data-sort]")) {
    th.tabIndex = 0;
    const sort = (): void => {
      const state = th.getAttribute("aria-sort");
      head.querySelectorAll("[aria-sort]").forEach((other) => other.removeAttribute("aria-sort"));
      if (state === "descending") {
        body.append(...original);
        return;
      }
      const next = state === "ascending" ? "descending" : "ascending";
      th.setAttribute("aria-sort", next);
      body.append(...sortRows(original, findColumn(head, th), next === "ascending"));
    };
    th.addEventListener("click", sort);
    th.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        sort();
      }
    });
  }
}

/** The column of a head cell in a head of two rows: spans of the first row, then the second row below its groups. */
function findColumn(head: HTMLTableSectionElement, th: HTMLTableCellElement): number {
  const [first, second] = [head.rows[0], head.rows[1]];
  let column = 0;
  let below = 0;
  for (const cell of first?.cells ?? []) {
    if (cell === th) {
      return column;
    }
    if (cell.rowSpan === 1) {
      for (let i = 0; i < cell.colSpan; ++i) {
        if (second?.cells[below++] === th) {
          return column + i;
        }
      }
    }
    column += cell.colSpan;
  }
  return 0;
}

function sortRows(rows: HTMLTableRowElement[], column: number, ascending: boolean): HTMLTableRowElement[] {
  const read = (row: HTMLTableRowElement): number | null => {
    const text = row.cells[column]?.dataset["value"];
    return text === undefined ? null : Number(text);
  };
  return [...rows].sort((a, b) => {
    const [x, y] = [read(a), read(b)];
    if (x === null || y === null) {
      return x === y ? 0 : x === null ? 1 : -1; // rows without a number stay below
    }
    return ascending ? x - y : y - x;
  });
}
