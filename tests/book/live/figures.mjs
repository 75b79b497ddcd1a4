// Each live figure of a page, in a browser: it comes, its handles go with the pointer and the keys, to both ends and between,
// at 1280 and 390 px, with text of 13 px; it keeps its state in the address and starts from it, shows the library's refusals, draws nothing
// but numbers, and leaves its drawing to print and to pages without scripts. With $ANSWER=40 an answer at the default state takes at
// most so many ms, and 2.5 times as many where a handle is at an end; for a quiet machine.
import {createServer} from "node:http";
import {createReadStream, existsSync} from "node:fs";
import {extname, join, normalize} from "node:path";
import {pathToFileURL} from "node:url";

const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const slowest = Number(process.env.ANSWER ?? Infinity);
const holder = (name) => `document.querySelector('.live[data-figure="${name}"]')`;

const comes = (name) => `(async () => {
  const holder = ${holder(name)};
  holder.scrollIntoView();
  for (let i = 0; i < 200 && !holder.classList.contains("on"); i++) { scrollBy(0, i % 2 ? 1 : -1); await new Promise((done) => setTimeout(done, 50)); }
  return holder.classList.contains("on") ? null : "does not come: " + (holder.querySelector(".message")?.textContent ?? ""); })()`;
const place = (name, k) => `(() => {
  const handle = ${holder(name)}.querySelectorAll(".handle")[${k}];
  handle.scrollIntoView({block: "center"});
  const knob = handle.getBoundingClientRect(), plot = handle.ownerSVGElement.getBoundingClientRect();
  return {x: knob.x + knob.width / 2, y: knob.y + knob.height / 2, left: plot.left, right: plot.right, top: plot.top, bottom: plot.bottom}; })()`;
const state = (name, k) => `(() => {
  const holder = ${holder(name)}, handle = holder.querySelectorAll(".handle")[${k}];
  const bad = /NaN|undefined|Infinity/.exec(holder.querySelector(".working").innerHTML);
  const size = (t) => parseFloat(getComputedStyle(t).fontSize) * (t.getScreenCTM ? Math.hypot(t.getScreenCTM().a, t.getScreenCTM().b) : 1);
  const frames = [...holder.querySelectorAll(".panes svg")].map((e) => e.getBoundingClientRect());
  const out = [...holder.querySelectorAll(".panes text")].find((t) => { const box = t.getBoundingClientRect(), frame = t.ownerSVGElement.getBoundingClientRect();
    return !t.closest("[clip-path]") && (box.left < frame.left - 1 || box.right > frame.right + 1); });
  return {hash: location.hash, value: handle.getAttribute("aria-valuetext"), bad: bad && bad[0], message: holder.querySelector(".message").textContent, says: holder.querySelector(".says").textContent,
    curves: holder.querySelectorAll(".panes polyline, .panes rect").length, out: out?.textContent, wide: frames.some((f) => f.right > innerWidth), whole: Number(holder.querySelector(".time").dataset.whole),
    size: Math.min(...[...holder.querySelectorAll(".panes text, .working p, .working label, .working dd, .working dt, .working input")].map(size))}; })()`;
const press = (name, k, key) => `${holder(name)}.querySelectorAll(".handle")[${k}].dispatchEvent(new KeyboardEvent("keydown", {key: "${key}", bubbles: true, cancelable: true}))`;
const startAgain = (name) => `${holder(name)}.querySelector(".foot button").click()`;
// What of a figure is seen: its static drawing, its working part.
const seen = (name) => `(() => { const h = ${holder(name)}, shown = (e) => Boolean(e) && e.checkVisibility() && e.getBoundingClientRect().height > 50;
  return {drawing: [...h.querySelectorAll("img, table, svg")].some((e) => !e.closest(".working") && shown(e) && e.naturalWidth !== 0), working: shown(h.querySelector(".working"))}; })()`;

async function drag(browser, name, handles, wrong) {
  for (const width of [1280, 390]) {
    await browser.width(width);
    await wait(300);
    for (let k = 0; k < handles; k++) {
      const values = new Set();
      for (const share of [0, 1, null]) { // null: some way back from the end
        const at = await browser.run(place(name, k));
        const to = share === null ? {x: at.x - 14, y: at.y + 14} : {x: at.left + share * (at.right - at.left), y: at.bottom + share * (at.top - at.bottom)};
        await browser.send("Input.dispatchMouseEvent", {type: "mousePressed", x: at.x, y: at.y, button: "left", clickCount: 1});
        await browser.send("Input.dispatchMouseEvent", {type: "mouseMoved", x: to.x, y: to.y, button: "left", buttons: 1});
        await browser.send("Input.dispatchMouseEvent", {type: "mouseReleased", x: to.x, y: to.y, button: "left"});
        await wait(400);
        const now = await browser.run(state(name, k));
        values.add(now.value);
        if (now.bad) wrong(`draws ${now.bad} at ${now.value}`);
        if (now.message) wrong(`answers "${now.message}" at ${now.value}`);
        if (now.curves < 2) wrong(`draws nothing at ${now.value}`);
        if (now.size < 12.9) wrong(`has text of ${now.size.toFixed(1)} px at ${width} px`);
        if (now.wide) wrong(`is wider than the page at ${width} px`);
        if (now.out) wrong(`cuts off "${now.out}" at ${width} px`);
        if (!now.hash.startsWith(`#live-${name}?`)) wrong("does not keep its state in the address");
      }
      if (values.size < 3) wrong(`handle ${k + 1} does not go with the pointer at ${width} px: ${[...values]}`);
    }
  }
  await browser.width(1280);
  await wait(300);
}

async function keys(browser, name, handles, wrong) {
  for (let k = 0; k < handles; k++) {
    const values = [];
    for (const key of ["Home", "ArrowRight", "ArrowUp", "End", "ArrowLeft", "ArrowDown"]) {
      await browser.run(press(name, k, key));
      await wait(60);
      values.push((await browser.run(state(name, k))).value);
    }
    if (new Set([values[0], values[1], values[3], values[4]]).size < 4) wrong(`handle ${k + 1} does not go with the keys: ${values}`);
    const reached = await browser.run(`(() => { const h = ${holder(name)}.querySelectorAll(".handle")[${k}]; h.focus(); return document.activeElement === h && h.tabIndex === 0; })()`);
    if (!reached) wrong(`handle ${k + 1} is not reached by the Tab key`);
  }
  await browser.run(startAgain(name));
  await wait(400);
}

// A number that the library refuses, typed; its text is the figure's message, and goes when the number is right again.
async function refusal(browser, name, wrong) {
  const typed = await browser.run(`(() => { const input = ${holder(name)}.querySelector('input[type="number"]'); if (!input) return false;
    input.value = "-1e6"; input.onchange(); return true; })()`);
  if (!typed) {
    await browser.run(`location.hash = location.hash.replace(/=[^&]*/, "=-1e6")`);
  }
  await wait(400);
  const now = await browser.run(state(name, 0));
  if (!/; allowed: from /.test(now.message)) wrong(`answers to a number out of range "${now.message}"`);
  if (/NaN|undefined/.test(now.message)) wrong(`says "${now.message}"`);
  await browser.run(startAgain(name));
  await wait(400);
  if ((await browser.run(state(name, 0))).message) wrong("keeps its message when the number is right again");
}

// The link to a state, opened anew: the same state and the same answer.
async function link(browser, page, name, url, wrong) {
  await browser.run(press(name, 0, "ArrowLeft"));
  await browser.run(press(name, 0, "ArrowLeft"));
  await wait(500);
  const before = await browser.run(state(name, 0));
  await browser.go("about:blank");
  await browser.go(url + before.hash);
  const never = await browser.run(comes(name));
  if (never) return wrong(never);
  await wait(500);
  const after = await browser.run(state(name, 0));
  if (after.value !== before.value || after.says !== before.says || after.hash !== before.hash) wrong(`opened by a link shows ${after.value}: ${after.says}, not ${before.value}: ${before.says}`);
}

// What is seen, asked again for up to 3 s while it is not what is wanted.
async function soon(browser, name, drawing, working) {
  for (let i = 0; ; i++) {
    const now = await browser.run(seen(name));
    if ((now.drawing === drawing && now.working === working) || i === 30) return now;
    await wait(100);
  }
}

async function withoutScript(browser, name, url, wrong) {
  await browser.send("Emulation.setEmulatedMedia", {media: "print"});
  const printed = await soon(browser, name, true, false);
  if (!printed.drawing || printed.working) wrong(`prints ${JSON.stringify(printed)}`);
  await browser.send("Emulation.setEmulatedMedia", {media: ""});
  const back = await soon(browser, name, false, true);
  if (back.drawing || !back.working) wrong(`shows after printing ${JSON.stringify(back)}`);
  await browser.send("Emulation.setScriptExecutionDisabled", {value: true});
  await browser.go(url);
  const bare = await browser.run(`${holder(name)}.scrollIntoView(), ${seen(name)}`);
  if (!bare.drawing || bare.working) wrong(`shows without scripts ${JSON.stringify(bare)}`);
  await browser.send("Emulation.setScriptExecutionDisabled", {value: false});
  await browser.go(url);
  await browser.run(comes(name)); // for what is asked of the page after this
}

// The least of five times at the default state and where the first two handles are at their ends.
async function times(browser, name, handles, wrong) {
  const least = async (action, ms) => {
    const all = [];
    for (let i = 0; i < 5; i++) { await browser.run(action(i)); await wait(ms); all.push((await browser.run(state(name, 0))).whole); }
    return Math.min(...all);
  };
  const usual = await least(() => startAgain(name), 300);
  let worst = 0;
  for (let k = 0; k < Math.min(2, handles); k++)
    for (const key of ["Home", "End"]) {
      const all = [];
      for (let i = 0; i < 4; i++) {
        await browser.run(press(name, k, key === "Home" ? "End" : "Home"));
        await wait(60);
        await browser.run(press(name, k, key));
        await wait(600);
        all.push((await browser.run(state(name, 0))).whole);
      }
      worst = Math.max(worst, Math.min(...all));
    }
  console.log(`live figure ${name}: ${usual.toFixed(1)} ms at its default state, ${worst.toFixed(1)} ms at an end`);
  if (usual > slowest || worst > 2.5 * slowest) wrong("is slow");
  await browser.run(startAgain(name));
  await wait(400);
}

export async function liveFigures(browser, book, page, fault) {
  const url = pathToFileURL(join(book, page)).href;
  const names = await browser.run(`[...document.querySelectorAll(".live[data-figure]")].map((e) => e.dataset.figure)`);
  for (const name of names) {
    const wrong = (text) => fault(page, `the live figure ${name}: ${text}`);
    const never = await browser.run(comes(name));
    if (never) { wrong(never); continue; }
    const top = await browser.run(`${holder(name)}.getBoundingClientRect().top + scrollY`);
    if (top > 900) wrong(`begins ${Math.round(top)} px down the page`);
    const handles = await browser.run(`${holder(name)}.querySelectorAll(".handle").length`);
    if (handles === 0) wrong("has no handle");
    if (slowest < Infinity) await times(browser, name, handles, wrong);
    await drag(browser, name, handles, wrong);
    await keys(browser, name, handles, wrong);
    await refusal(browser, name, wrong);
    await link(browser, page, name, url, wrong);
    await withoutScript(browser, name, url, wrong);
  }
}

// The same pages over http.
export async function liveOverHttp(browser, book, pages, fault) {
  const types = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".woff2": "font/woff2", ".png": "image/png"};
  const server = createServer((request, response) => {
    const file = join(book, normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname)));
    if (!file.startsWith(book) || !existsSync(file)) { response.writeHead(404).end(); return; }
    response.writeHead(200, {"content-type": types[extname(file)] ?? "application/octet-stream"});
    createReadStream(file).pipe(response);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  try {
    for (const page of pages) {
      browser.complaints.length = 0;
      await browser.go(`http://127.0.0.1:${server.address().port}/${page}`);
      for (const name of await browser.run(`[...document.querySelectorAll(".live[data-figure]")].map((e) => e.dataset.figure)`)) {
        const never = await browser.run(comes(name));
        const now = never ? {} : await browser.run(state(name, 0));
        if (never || now.message || now.curves < 2) fault(page, `over http the live figure ${name} ${never ?? `draws ${now.curves} curves: ${now.message}`}`);
      }
      browser.complaints.forEach((text) => fault(page, "over http: " + text));
    }
  } finally {
    server.close();
    server.closeAllConnections();
  }
}
