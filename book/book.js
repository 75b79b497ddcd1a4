// What a reader gets besides the text: search, theme, sorting, filtering, copying, previews. The pages are whole without it.
"use strict";

const make = (name, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...children);
  return element;
};
const all = (selector, root = document) => [...root.querySelectorAll(selector)];

// ---- theme: as the system has it, light, dark
function themeButton() {
  const order = ["auto", "light", "dark"];
  const root = document.documentElement;
  const button = make("button", {type: "button", id: "theme"});
  const show = () => {
    const now = root.dataset.theme || "auto";
    button.textContent = {auto: "◐ auto", light: "☀ light", dark: "☾ dark"}[now];
    button.setAttribute("aria-label", "theme: " + now);
  };
  button.onclick = () => {
    root.dataset.theme = order[(order.indexOf(root.dataset.theme || "auto") + 1) % 3];
    try { localStorage.setItem("theme", root.dataset.theme); } catch { /* a page from disk may have no storage */ }
    show();
  };
  show();
  return button;
}

// ---- all code open, or all folded
function codeButton() {
  const button = make("button", {type: "button", textContent: "‹ › code"});
  button.setAttribute("aria-label", "fold or open the code that is shown");
  button.onclick = () => {
    const shown = all("details.code.shown"), open = !shown.some((d) => d.open);
    shown.forEach((d) => { d.open = open; });
  };
  return button;
}

// ---- search over all pages; search.js comes when it is first wanted
let pages = null;
globalThis.railbookSearch = (packed) => { // gzip in base64: a third of the text
  const bytes = Uint8Array.from(atob(packed), (c) => c.charCodeAt(0));
  pages = new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).json();
};

const load = (src) => new Promise((done, failed) => document.head.append(make("script", {src, onload: done, onerror: failed})));
const loadSearch = async () => {
  if (!pages) await Promise.all([load("search.js"), load("find.js")]);
  pages = await pages;
};

// The text around the first of the words.
function excerpt(text, words) {
  const places = words.map((w) => text.toLowerCase().indexOf(w)).filter((i) => i >= 0);
  const at = places.length > 0 ? Math.max(0, Math.min(...places) - 40) : 0;
  return (at > 0 ? "… " : "") + text.slice(at, at + 130);
}

function searchBox() {
  const input = make("input", {type: "search", id: "search", placeholder: "Search (press /)"});
  input.setAttribute("aria-label", "search all pages");
  const list = make("ul", {className: "results", hidden: true});
  const show = async () => {
    list.hidden = input.value.trim() === "";
    if (list.hidden) return;
    await loadSearch();
    const hits = railbookFind.find(pages, input.value), words = railbookFind.words(input.value);
    list.replaceChildren(...hits.map((hit) => make("li", {}, make("a", {href: hit.href},
      make("b", {textContent: hit.title}), make("small", {textContent: hit.page + " · " + excerpt(hit.text, words)})))));
    if (hits.length === 0) list.append(make("li", {textContent: "Nothing found."}));
  };
  input.oninput = show;
  const step = (event, by) => {
    const links = all("a", list), at = links.indexOf(document.activeElement);
    event.preventDefault();
    (at + by < 0 ? input : links[Math.min(at + by, links.length - 1)])?.focus();
  };
  const box = make("span", {role: "search"}, input, list);
  box.onkeydown = (event) => {
    if (event.key === "ArrowDown") step(event, 1);
    if (event.key === "ArrowUp") step(event, -1);
    if (event.key === "Enter" && event.target === input) list.querySelector("a")?.click();
    if (event.key === "Escape") { list.hidden = true; input.focus(); }
  };
  box.addEventListener("focusout", (event) => { if (event.relatedTarget && !box.contains(event.relatedTarget)) list.hidden = true; });
  list.onclick = () => { list.hidden = true; };
  document.addEventListener("click", (event) => { if (!box.contains(event.target)) list.hidden = true; });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || /^(INPUT|TEXTAREA|SELECT)$/.test(document.activeElement.tagName)) return;
    event.preventDefault();
    input.focus();
  });
  return box;
}

// ---- sorting
function cellValue(row, column) {
  const cell = row.cells[column], given = cell?.dataset.sort;
  if (given !== undefined) return Number(given);
  const text = (cell?.textContent ?? "").trim();
  const number = Number.parseFloat(text.replace("−", "-").replace(/[\s\u202f]/g, "").replace(/×10−?/, "e"));
  return /^[−+-]?\.?\d/.test(text) && !Number.isNaN(number) ? number : text.toLowerCase();
}

function sortTable(table, head) {
  const up = head.getAttribute("aria-sort") !== "ascending";
  all("th[aria-sort]", table).forEach((th) => th.removeAttribute("aria-sort"));
  head.setAttribute("aria-sort", up ? "ascending" : "descending");
  const rows = [...table.tBodies[0].rows].map((row) => [cellValue(row, head.cellIndex), row]);
  const order = ([a], [b]) => typeof a === typeof b ? (a < b ? -1 : a > b ? 1 : 0) : typeof a === "number" ? -1 : 1;
  rows.sort(up ? order : (a, b) => order(b, a));
  table.tBodies[0].append(...rows.map(([, row]) => row));
}

function sortable(table) {
  for (const head of all("thead th", table)) {
    head.tabIndex = 0;
    head.title = "sort";
    head.onclick = () => sortTable(table, head);
    head.onkeydown = (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      sortTable(table, head);
    };
  }
}

// ---- filtering: a text, and one choice for each column that is marked
function choices(root) {
  const columns = new Map();
  for (const head of all("th[data-filter]", root)) {
    const name = head.textContent.trim();
    if (!columns.has(name)) columns.set(name, new Set());
    for (const row of head.closest("table").tBodies[0].rows) columns.get(name).add(row.cells[head.cellIndex].textContent.trim());
  }
  return [...columns].map(([name, values]) => {
    const select = make("select", {}, make("option", {value: "", textContent: "any " + name}),
      ...[...values].sort().map((value) => make("option", {value, textContent: value})));
    select.setAttribute("aria-label", name);
    select.dataset.column = name;
    return select;
  });
}

function filterable(root) {
  const input = make("input", {type: "search", placeholder: "Filter"});
  input.setAttribute("aria-label", "filter");
  const selects = choices(root), count = make("span", {role: "status"});
  const wanted = (row, heads) => row.textContent.toLowerCase().includes(input.value.toLowerCase()) && selects.every((select) => {
    const at = heads.indexOf(select.dataset.column);
    return !select.value || (at >= 0 && row.cells[at].textContent.trim() === select.value);
  });
  const apply = () => {
    const active = input.value !== "" || selects.some((s) => s.value);
    let shown = 0;
    for (const table of all("table", root)) {
      const heads = [...table.tHead.rows[0].cells].map((c) => c.textContent.trim());
      for (const row of table.tBodies[0].rows) {
        row.hidden = active && !wanted(row, heads);
        if (!row.hidden) shown++;
      }
    }
    for (const entry of all(".declaration", root)) {
      entry.hidden = active && !entry.textContent.toLowerCase().includes(input.value.toLowerCase());
      if (!entry.hidden) shown++;
    }
    for (const part of all("details.more", root)) {
      const any = all("tbody tr, .declaration", part).some((row) => !row.hidden);
      part.hidden = active && !any;
      part.open = active && any;
    }
    count.textContent = active ? shown + " shown" : "";
  };
  input.oninput = apply;
  selects.forEach((select) => { select.onchange = apply; });
  root.before(make("div", {className: "filter"}, input, ...selects, count));
}

// ---- copying
function copyButton(pre) {
  const holder = pre.parentElement;
  const button = make("button", {type: "button", className: "copy", textContent: "copy"});
  button.setAttribute("aria-label", "copy this code");
  button.onclick = async () => {
    const text = pre.textContent;
    try {
      await navigator.clipboard.writeText(text);
    } catch { // from disk there may be no clipboard
      const area = make("textarea", {value: text});
      document.body.append(area);
      area.select();
      document.execCommand("copy");
      area.remove();
    }
    button.textContent = "copied";
    setTimeout(() => { button.textContent = "copy"; }, 1200);
  };
  holder.classList.add("copied");
  holder.append(button);
}

// ---- a look at what a link of this page leads to
function previews() {
  let box = null;
  const close = () => { box?.remove(); box = null; };
  const open = (link) => {
    close();
    const target = document.getElementById(decodeURIComponent(link.hash.slice(1)));
    const whole = target?.closest(".equation, li[role], figure.item, section.item");
    if (!whole || whole.contains(link)) return;
    const copy = whole.cloneNode(true);
    all("details, .wide, .notes, .reason, .links, .copy", copy).forEach((e) => e.remove());
    all("[id]", copy).forEach((e) => e.removeAttribute("id"));
    copy.removeAttribute("id");
    box = make("div", {className: "preview"}, ...(whole.matches("li") ? copy.childNodes : [copy]));
    box.setAttribute("aria-hidden", "true");
    document.body.append(box);
    const at = link.getBoundingClientRect();
    box.style.left = Math.max(8, Math.min(at.left, innerWidth - box.offsetWidth - 16)) + scrollX + "px";
    const below = at.bottom + box.offsetHeight + 8 < innerHeight;
    box.style.top = (below ? at.bottom + 6 : at.top - box.offsetHeight - 6) + scrollY + "px";
  };
  for (const link of all('main a[href^="#"]:not(.permalink, .self, .number, .footnote-back)')) {
    link.addEventListener("mouseenter", () => open(link));
    link.addEventListener("mouseleave", close);
    link.addEventListener("focus", () => open(link));
    link.addEventListener("blur", close);
  }
}

// ---- what a symbol of a formula means: under the pointer for a symbol, on focus for all symbols of a displayed formula
function symbolMeanings() {
  if (!document.getElementById("meanings")) return;
  const box = make("div", {className: "preview meaning", id: "meaning", hidden: true});
  box.setAttribute("role", "tooltip");
  document.body.append(box);
  let shown = null, closing = 0;
  const close = () => {
    shown?.removeAttribute("aria-describedby");
    shown = null;
    box.hidden = true;
  };
  const later = () => { closing = setTimeout(close, 250); };
  const open = (element, numbers) => {
    clearTimeout(closing);
    if (shown === element) return;
    close();
    shown = element;
    box.replaceChildren(...numbers.map((n) => make("p", {}, ...document.getElementById("meaning-" + n).cloneNode(true).childNodes)));
    box.hidden = false;
    const at = element.getBoundingClientRect();
    box.style.left = Math.max(8, Math.min(at.left, innerWidth - box.offsetWidth - 16)) + scrollX + "px";
    const below = at.bottom + box.offsetHeight + 8 < innerHeight;
    box.style.top = (below ? at.bottom + 4 : at.top - box.offsetHeight - 4) + scrollY + "px";
  };
  for (const symbol of all("[data-s]")) {
    symbol.addEventListener("pointerenter", () => open(symbol, [symbol.dataset.s]));
    symbol.addEventListener("pointerleave", later);
  }
  for (const formula of all("main math[display=block]")) {
    const numbers = [...new Set(all("[data-s]", formula).map((symbol) => symbol.dataset.s))];
    if (numbers.length === 0) continue;
    formula.tabIndex = 0;
    formula.addEventListener("focus", () => {
      if (!formula.matches(":focus-visible")) return;
      open(formula, numbers);
      formula.setAttribute("aria-describedby", box.id);
    });
    formula.addEventListener("blur", close);
  }
  box.addEventListener("pointerenter", () => clearTimeout(closing));
  box.addEventListener("pointerleave", later);
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") close(); });
  document.addEventListener("pointerdown", (event) => { if (!box.contains(event.target) && !event.target.closest("[data-s]")) close(); });
}

// ---- the section that is read, in the contents at the side
function markSection() {
  const links = new Map(all(".toc a").map((a) => [decodeURIComponent(a.hash.slice(1)), a]));
  const heads = all("main h2[id], main h3[id]").filter((h) => links.has(h.id));
  if (heads.length === 0) return;
  let marked = null;
  const mark = () => {
    const now = heads.findLast((h) => h.getBoundingClientRect().top < 120) ?? heads[0];
    if (now === marked) return;
    links.get(marked?.id)?.classList.remove("here");
    links.get(now.id).classList.add("here");
    marked = now;
  };
  addEventListener("scroll", mark, {passive: true});
  mark();
}

// ---- the marks of a chart are one stop of the Tab key; arrows go from one to the next
function oneStop(chart) {
  const marks = all("a", chart);
  const stop = (mark) => marks.forEach((m) => m.setAttribute("tabindex", m === mark ? 0 : -1));
  stop(marks[0]);
  chart.addEventListener("keydown", (event) => {
    const at = marks.indexOf(document.activeElement), last = marks.length - 1;
    const to = {ArrowRight: at + 1, ArrowDown: at + 1, ArrowLeft: at - 1, ArrowUp: at - 1, Home: 0, End: last}[event.key];
    if (at < 0 || !(to >= 0 && to <= last)) return;
    event.preventDefault();
    stop(marks[to]);
    marks[to].focus();
  });
}

// A place inside what is folded is unfolded when a link leads to it.
function unfold() {
  const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  let closed = false;
  for (let part = target.closest("details"); part; part = part.parentElement.closest("details")) {
    closed ||= !part.open;
    part.open = true;
  }
  if (closed) target.scrollIntoView();
}

all(".tools").forEach((tools) => tools.append(searchBox(), ...(document.querySelector("details.code.shown") ? [codeButton()] : []), themeButton()));
all("table.sortable").forEach(sortable);
all(".filterable").forEach(filterable);
all("pre").forEach(copyButton);
// What is wider than the page can be reached by the keyboard, and fades at the edge behind which it goes on.
const goesOn = (e) => e.classList.toggle("goes-on", e.scrollLeft + e.clientWidth < e.scrollWidth - 2);
const scrollers = all(".wide, pre, math[display=block], .equation > span, figure.item > a");
scrollers.forEach((e) => {
  if (e.scrollWidth > e.clientWidth && e.localName !== "a") e.tabIndex = 0;
  e.addEventListener("scroll", () => goesOn(e), {passive: true});
});
const edges = () => scrollers.forEach(goesOn);
edges();
addEventListener("resize", edges);
addEventListener("toggle", edges, true);
all(".numbers svg").forEach(oneStop);
previews();
symbolMeanings();
markSection();
unfold();
addEventListener("hashchange", unfold);
