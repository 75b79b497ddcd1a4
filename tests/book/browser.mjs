// node browser.mjs BOOK [PAGE ...]: opens each page of the woven book in headless Chromium and looks for what a reader would
// trip over. Exit status 0 good, 1 faults, 77 there is no browser (skipped). With $AXE, the file axe.min.js of npm's axe-core, it also asks
// that for what keeps readers out.
import {existsSync, readdirSync, readFileSync} from "node:fs";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {Browser, chromium} from "./chromium.mjs";
import {liveFigures, liveOverHttp} from "./live/figures.mjs";

const highest = 20000; // px at 1280 px of width with the code folded
const slowest = Number(process.env.PAINT ?? Infinity); // ms to the first paint, from disk: on a quiet machine PAINT=1000
const widths = [360, 768, 1280, 1920];

const book = resolve(process.argv[2]);
const path = chromium();
if (!path) {
  console.log("no Chromium on this machine: skipped");
  process.exit(77);
}
const pages = process.argv.length > 3 ? process.argv.slice(3) : readdirSync(book).filter((name) => name.endsWith(".html")).sort();
const axe = process.env.AXE && existsSync(process.env.AXE) ? readFileSync(process.env.AXE, "utf8") : null;
const faults = [];
const fault = (page, text) => { faults.push(page + ": " + text); console.log("FAULT " + page + ": " + text); };

const ids = new Map(); // of each page
function idsOf(page) {
  if (!ids.has(page)) {
    const text = existsSync(join(book, page)) ? readFileSync(join(book, page), "utf8") : "";
    ids.set(page, new Set([...text.matchAll(/ id="([^"]*)"/g)].map((m) => m[1])));
  }
  return ids.get(page);
}

// Links: to files of the book, to places that are there, and outside to DOIs only.
function links(page, hrefs) {
  for (const href of new Set(hrefs)) {
    if (/^https?:/.test(href)) {
      if (!href.startsWith("https://doi.org/")) fault(page, "leads outside the book: " + href);
      continue;
    }
    if (href.startsWith("data:")) continue;
    const [file, anchor] = href.split("#");
    if (file && !existsSync(join(book, decodeURIComponent(file)))) fault(page, "leads nowhere: " + href);
    else if (anchor && (file === "" || file.endsWith(".html")) && !idsOf(file || page).has(decodeURIComponent(anchor)))
      fault(page, "leads to no place: " + href);
  }
}

// What stands out of the page to the right, at one width.
const overflow = `(() => {
  const wide = document.documentElement.scrollWidth - innerWidth;
  if (wide <= 1) return null;
  const inside = (e) => { for (let p = e.parentElement; p; p = p.parentElement) if (getComputedStyle(p).overflowX !== "visible") return true; return false; };
  const worst = [...document.querySelectorAll("body *")].filter((e) => e.getBoundingClientRect().right > innerWidth + 1 && !inside(e)).pop();
  return wide + " px too wide: " + (worst ? worst.tagName + "." + worst.getAttribute("class") + " " + worst.textContent.slice(0, 60) : "?");
})()`;

// On a phone a row of checks is a card with the outcome on top, and no accent hangs beside its letter.
const cards = `[...document.querySelectorAll("table.cards tbody tr")].filter((r) => r.checkVisibility()).map((row) => {
  const outcome = row.querySelector("td.outcome")?.getBoundingClientRect(), head = row.cells[0].getBoundingClientRect();
  if (head.width < 150) return "a card of " + head.width + " px";
  return outcome && outcome.top >= head.top ? "no outcome on top of " + row.cells[0].textContent : null; }).find((text) => text) ?? null`;
const accents = `[...document.querySelectorAll("mover")].filter((m) => m.checkVisibility() && m.lastElementChild.getAttribute("accent") === "true").map((m) => {
  if (/[\\u0300-\\u036f]/.test(m.lastElementChild.textContent)) return "a combining accent, which browsers hang beside its letter";
  const [base, mark] = [...m.children].map((e) => e.getBoundingClientRect());
  const off = (mark.left + mark.right) / 2 - (base.left + base.right) / 2;
  return Math.abs(off) > base.width / 2 ? "an accent " + off.toFixed(1) + " px beside its letter" : null; }).find((text) => text) ?? null`;

async function layout(browser, page) {
  await browser.width(390);
  for (const expression of [cards, accents]) {
    const seen = await browser.run(expression);
    if (seen) fault(page, seen);
  }
  for (const width of widths) {
    await browser.width(width);
    const wide = await browser.run(overflow);
    if (wide) fault(page, "at " + width + " px " + wide);
  }
  await browser.width(1280);
  await browser.run(`document.querySelectorAll("details.code").forEach((d) => { d.open = false; })`);
  const height = await browser.run("document.documentElement.scrollHeight");
  if (height > highest) fault(page, height + " px high, at most " + highest);
  const flat = await browser.run(`[...document.querySelectorAll("math")].filter((m) => m.checkVisibility() && m.getBoundingClientRect().width < 1).length`);
  if (flat > 0) fault(page, flat + " formulas without width");
  const repeated = await browser.run(`(() => { const seen = new Set(); return [...document.querySelectorAll("[id]")].map((e) => e.id).filter((id) => seen.has(id) || !seen.add(id)); })()`);
  if (repeated.length > 0) fault(page, "ids given twice: " + repeated.slice(0, 5));
  return height;
}

async function accessible(browser, page) {
  if (!axe) return;
  await browser.run(axe + "; 0");
  for (const theme of ["light", "dark"]) {
    const found = await browser.run(`document.documentElement.dataset.theme = "${theme}"; axe.run(document, {resultTypes: ["violations"], preload: false}).then((r) =>
      r.violations.filter((v) => v.impact === "serious" || v.impact === "critical").map((v) => v.id + ": " + v.nodes.length + " times, " + v.nodes[0].html.slice(0, 120)))`);
    found.forEach((text) => fault(page, theme + ": " + text));
  }
}

// Search, theme, sorting and filtering do what they say.
async function functions(browser) {
  const url = (page) => pathToFileURL(join(book, page)).href;
  await browser.go(url("index.html"));
  const hits = await browser.run(`(async () => { const s = document.getElementById("search"); s.value = "pressure"; await s.oninput();
    return document.querySelectorAll(".results a[href]").length; })()`);
  if (hits < 1) fault("search", "finds nothing of pressure");
  const none = await browser.run(`(async () => { const s = document.getElementById("search"); s.value = "qwertzuiop"; await s.oninput();
    return document.querySelector(".results").textContent; })()`);
  if (!none.includes("Nothing")) fault("search", "finds what is not there: " + none);
  const colours = await browser.run(`(() => { const out = []; for (let i = 0; i < 3; i++) { document.getElementById("theme").click();
    out.push(document.documentElement.dataset.theme + " " + getComputedStyle(document.body).backgroundColor); } return out; })()`);
  if (new Set(colours.map((c) => c.split(" ")[0])).size !== 3 || new Set(colours.map((c) => c.slice(c.indexOf(" ")))).size < 2)
    fault("theme", "does not change: " + colours);
  await browser.go(url("ledger.html"));
  const sorted = await browser.run(`(() => { const t = document.querySelector("table.ledger"); const h = t.tHead.rows[0].cells;
    const at = [...h].findIndex((c) => c.textContent.startsWith("tolerance")); h[at].click();
    const values = [...t.tBodies[0].rows].map((r) => r.cells[at].dataset.sort).filter((v) => v !== undefined).map(Number);
    return values.every((v, i) => i === 0 || values[i - 1] <= v) && h[at].getAttribute("aria-sort") === "ascending"; })()`);
  if (!sorted) fault("ledger.html", "a column does not sort");
  const filtered = await browser.run(`(() => { const rows = () => [...document.querySelectorAll("table.ledger tbody tr")].filter((r) => !r.hidden);
    const before = rows().length, s = [...document.querySelectorAll(".filter select")].find((e) => e.dataset.column === "outcome");
    s.value = "consistent"; s.onchange(); const after = rows();
    return after.length > 0 && after.length < before && after.every((r) => r.textContent.includes("consistent")); })()`);
  if (!filtered) fault("ledger.html", "the filter does not filter");
  const copied = await browser.run(`(async () => { let text = null; Object.defineProperty(navigator, "clipboard", {value: {writeText: async (t) => { text = t; }}, configurable: true});
    const m = document.createElement("pre"); m.textContent = "int x;"; const d = document.createElement("div"); d.append(m); document.body.append(d);
    copyButton(m); await d.querySelector(".copy").onclick(); return text; })()`);
  if (copied !== "int x;") fault("copy", "copies " + copied);
}

// The picture of the front page moves, is held by its box, and stands still for who asks for less motion.
async function motion(browser) {
  const url = pathToFileURL(join(book, "index.html")).href;
  const height = `document.querySelector(".moving .front")?.getBoundingClientRect().top`;
  const later = `new Promise((done) => setTimeout(() => done(${height}), 400))`;
  await browser.go(url);
  if (await browser.run(height) === undefined) return;
  if (await browser.run(height) === await browser.run(later)) fault("index.html", "its picture does not move");
  await browser.run(`document.getElementById("still").click()`);
  await browser.run(later);
  if (await browser.run(height) !== await browser.run(later)) fault("index.html", "its picture is not held");
  await browser.send("Emulation.setEmulatedMedia", {features: [{name: "prefers-reduced-motion", value: "reduce"}]});
  await browser.go(url);
  if (await browser.run("document.getAnimations().length") > 0) fault("index.html", "its picture moves for who asks for less motion");
  await browser.send("Emulation.setEmulatedMedia", {features: []});
}

// The marks of the chart of numbers are one stop of the Tab key; arrows go on within it.
async function chart(browser) {
  await browser.go(pathToFileURL(join(book, "index.html")).href);
  const found = await browser.run(`(() => {
    const marks = [...document.querySelectorAll(".numbers svg a")];
    if (marks.length === 0) return null;
    const stops = () => marks.filter((m) => m.tabIndex === 0).map((m) => marks.indexOf(m));
    const before = stops();
    marks[0].focus();
    for (const key of ["ArrowRight", "ArrowRight", "ArrowLeft", "End", "ArrowRight"])
      document.activeElement.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
    return {before, after: stops(), at: marks.indexOf(document.activeElement), last: marks.length - 1};
  })()`);
  if (found === null) return;
  if (String(found.before) !== "0") fault("index.html", found.before.length + " tab stops in its chart");
  if (found.at !== found.last || String(found.after) !== String(found.last)) fault("index.html", "arrows do not go through its chart");
}

const browser = new Browser(path);
try {
  await browser.open();
  await browser.width(1280);
  for (const page of pages) {
    browser.complaints.length = browser.requests.length = 0;
    await browser.go(pathToFileURL(join(book, page)).href);
    const paint = await browser.run(`new Promise((done) => { const seen = () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime;
      if (seen() !== undefined) done(seen()); else { new PerformanceObserver(() => done(seen() ?? 0)).observe({type: "paint", buffered: true}); setTimeout(() => done(-1), 3000); } })`);
    links(page, await browser.run(`[...document.querySelectorAll("[href], [src]")].map((e) => e.getAttribute("href") ?? e.getAttribute("src"))`));
    const height = await layout(browser, page);
    await liveFigures(browser, book, page, fault);
    await accessible(browser, page);
    browser.complaints.forEach((text) => fault(page, text));
    browser.requests.filter((url) => !/^(file|data|blob|about):/.test(url)).forEach((url) => fault(page, "asks outside: " + url));
    if (paint > slowest) fault(page, "first paint after " + Math.round(paint) + " ms");
    console.log(page.padEnd(26), String(height).padStart(6) + " px", String(Math.round(paint)).padStart(5) + " ms");
  }
  if (process.argv.length <= 3) await functions(browser);
  await liveOverHttp(browser, book, pages.filter((page) => /^\d\d-[a-z-]*\.html$/.test(page)), fault);
  if (pages.includes("index.html")) await motion(browser), await chart(browser);
} finally {
  await browser.close();
}
console.log(pages.length + " pages, " + faults.length + " faults" + (axe ? "" : "; not asked axe-core ($AXE)"));
process.exitCode = faults.length > 0 ? 1 : 0;
