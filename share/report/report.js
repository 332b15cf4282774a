// Reports: sorts, filters and downloads tables, and shows the values of charts. Without it the page is readable.
"use strict";

// ── Tables ──────────────────────────────────────────────────────────────────

const collator = new Intl.Collator("en", { numeric: true });

/** The value of a cell: a number, a text, or null where it is missing. */
function valueOf(cell) {
  if (cell.classList.contains("missing")) return null;
  return cell.classList.contains("number") ? Number(cell.dataset.value ?? cell.textContent) : cell.textContent;
}

/** Numbers before texts. */
function compare(a, b) {
  if (typeof a === "number" && typeof b === "number") return a - b;
  if (typeof a !== typeof b) return typeof a === "number" ? -1 : 1;
  return collator.compare(a, b);
}

const relations = {
  "=": (order) => order === 0, "!=": (order) => order !== 0, "<": (order) => order < 0,
  ">": (order) => order > 0, "<=": (order) => order <= 0, ">=": (order) => order >= 0,
};

/** A function of a row from a word of the filter: "mesh>=4" compares a column, other words occur anywhere in the row. */
function conditionOf(word, names) {
  const parts = /^(.+?)(<=|>=|!=|=|<|>)(.+)$/.exec(word);
  const column = parts ? names.findIndex((name) => name.toLowerCase() === parts[1].toLowerCase()) : -1;
  if (column < 0) return (row) => row.text.includes(word.toLowerCase());
  const [, , relation, text] = parts;
  return (row) => {
    const value = row.values[column];
    if (value === null) return false;
    const wanted = Number(text);
    if (typeof value === "number") return !Number.isNaN(wanted) && relations[relation](value - wanted);
    return relations[relation](collator.compare(value.toLowerCase(), text.toLowerCase()));
  };
}

function csvField(text) {
  return /[",\r\n]|^[#\s]|\s$/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text;
}

/** The text of a CSV file, units in comments, as study:csv writes it. */
function csvOf(title, heads, rows) {
  const units = heads.filter((head) => head.dataset.unit).map((head) => `# ${head.dataset.name} (${head.dataset.unit})`);
  const lines = rows.map((row) => row.values.map((value) => (value === null ? "" : csvField(String(value)))).join(","));
  const names = heads.map((head) => csvField(head.dataset.name)).join(",");
  return [`# ${title.replaceAll(/\s+/g, " ")}`, ...units, names, ...lines, ""].join("\n");
}

function download(text, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/csv;charset=utf-8" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function setUpTable(block) {
  const heads = [...block.querySelectorAll("th")];
  const names = heads.map((head) => head.dataset.name);
  const body = block.querySelector("tbody");
  const input = block.querySelector("input");
  const rows = [...body.rows].map((element) => {
    const values = [...element.cells].map(valueOf);
    return { element, values, text: element.textContent.toLowerCase() };
  });
  let order = rows;
  let shown = rows;

  function sortBy(column) {
    const before = heads[column].getAttribute("aria-sort");
    const next = before === null ? "ascending" : before === "ascending" ? "descending" : null;
    for (const head of heads) head.removeAttribute("aria-sort");
    if (next) heads[column].setAttribute("aria-sort", next);
    const sign = next === "descending" ? -1 : 1;
    order = !next ? rows : [...rows].sort((a, b) => {
      const left = a.values[column], right = b.values[column];
      if (left === null || right === null) return (left === null) - (right === null); // missing ones last
      return sign * compare(left, right);
    });
    for (const row of order) body.append(row.element);
    filter();
  }

  function filter() {
    const conditions = input.value.split(/\s+/).filter(Boolean).map((word) => conditionOf(word, names));
    shown = order.filter((row) => conditions.every((fits) => fits(row)));
    const visible = new Set(shown);
    for (const row of rows) row.element.hidden = !visible.has(row);
    const all = `${rows.length} ${rows.length === 1 ? "row" : "rows"}`;
    block.querySelector(".count").textContent = shown.length < rows.length ? `${shown.length} of ${all}` : all;
  }

  heads.forEach((head, column) => head.firstElementChild.addEventListener("click", () => sortBy(column)));
  input.addEventListener("input", filter);
  block.querySelector(".download").addEventListener("click", () => {
    const title = block.dataset.title;
    download(csvOf(title, heads, shown), `${title.replaceAll(/[^\p{L}\p{N}.-]+/gu, "_") || "table"}.csv`);
  });
  block.querySelector("label").hidden = rows.length < 6;
  block.querySelector(".tools").hidden = false;
}

document.querySelectorAll(".table").forEach(setUpTable);

// ── Charts ──────────────────────────────────────────────────────────────────

const reach = 28; // pixels from the pointer to the nearest point

const tip = document.createElement("div");
tip.id = "tip";
tip.setAttribute("role", "status");
tip.hidden = true;
document.body.append(tip);

let ring = null; // around the shown spot

function hideTip() {
  tip.hidden = true;
  ring?.remove();
}

/** Shows the values of a spot, and of others at the same place. */
function show(svg, spots, spot) {
  const margin = spot.w === 0 ? 7 : 0;
  ring?.remove();
  ring = document.createElementNS(svg.namespaceURI, "rect");
  ring.classList.add("ring");
  for (const [name, value] of Object.entries({
    x: spot.x - spot.w / 2 - margin, y: spot.y - spot.h / 2 - margin, width: spot.w + 2 * margin,
    height: spot.h + 2 * margin, rx: margin,
  })) ring.setAttribute(name, value);
  svg.append(ring);
  const same = spots.filter((other) => Math.hypot(other.x - spot.x, other.y - spot.y) < 1);
  tip.textContent = same.map((other) => other.text).join("\n\n");
  tip.hidden = false;
  const place = ring.getBoundingClientRect(), size = tip.getBoundingClientRect(), gap = 8;
  const right = place.right + gap, below = place.bottom + gap;
  const x = right + size.width < innerWidth ? right : place.left - gap - size.width;
  tip.style.left = `${Math.max(gap, Math.min(x, innerWidth - size.width - gap))}px`;
  const y = place.top - gap - size.height > 0 ? place.top - gap - size.height : below;
  tip.style.top = `${Math.max(gap, Math.min(y, innerHeight - size.height - gap))}px`;
}

/** The spot nearest to the pointer, if it is within reach. */
function nearest(svg, spots, event) {
  const matrix = svg.getScreenCTM();
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  let best = null, least = (reach / matrix.a) ** 2;
  for (const spot of spots) {
    const dx = Math.max(0, Math.abs(at.x - spot.x) - spot.w / 2), dy = Math.max(0, Math.abs(at.y - spot.y) - spot.h / 2);
    if (spot.w > 0 && (dx > 0 || dy > 0)) continue; // a cell shows its value within it
    if (dx * dx + dy * dy < least) [best, least] = [spot, dx * dx + dy * dy];
  }
  return best;
}

function setUpChart(svg) {
  const spots = [...svg.querySelectorAll(".spots > *")].map((mark) => {
    const number = (name) => Number(mark.getAttribute(name) ?? 0);
    const title = mark.firstElementChild, w = number("width"), h = number("height");
    const spot = { x: number("cx") + number("x") + w / 2, y: number("cy") + number("y") + h / 2, w, h,
                   text: title.textContent };
    title.remove(); // the browser would show it as well
    return spot;
  });
  let current = -1;
  const look = (event) => {
    const spot = nearest(svg, spots, event);
    if (spot) show(svg, spots, spot);
    else hideTip();
    current = spots.indexOf(spot);
  };
  svg.addEventListener("pointermove", look);
  svg.addEventListener("pointerdown", look);
  svg.addEventListener("pointerleave", (event) => event.pointerType === "mouse" && hideTip());
  svg.addEventListener("blur", hideTip);
  svg.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (event.key === "Escape") hideTip();
    if (!step || spots.length === 0) return;
    event.preventDefault();
    current = Math.max(0, Math.min(current + step, spots.length - 1));
    show(svg, spots, spots[current]);
  });
}

document.querySelectorAll("figure.chart svg").forEach(setUpChart);
document.addEventListener("pointerdown", (event) => event.target.closest("figure.chart svg") || hideTip());
document.addEventListener("scroll", hideTip, { capture: true, passive: true });

// ── Printing ────────────────────────────────────────────────────────────────

addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((part) => { part.open = true; }));
