// Each live figure of a page, in a browser: it comes, its handles go with the pointer and the keys, to both ends and between,
// at 1280 and 390 px; it keeps its state in the address and starts from it, and draws nothing but numbers.
const wait = (ms) => new Promise((done) => setTimeout(done, ms));

const comes = (name) => `(async () => {
  const holder = document.querySelector('.live[data-figure="${name}"]');
  holder.scrollIntoView();
  for (let i = 0; i < 200 && !holder.classList.contains("on"); i++) { scrollBy(0, i % 2 ? 1 : -1); await new Promise((done) => setTimeout(done, 50)); }
  return holder.classList.contains("on") ? null : "does not come: " + (holder.querySelector(".message")?.textContent ?? ""); })()`;
const place = (name, k) => `(() => {
  const handle = document.querySelectorAll('.live[data-figure="${name}"] .handle')[${k}];
  handle.scrollIntoView({block: "center"});
  const knob = handle.getBoundingClientRect(), plot = handle.ownerSVGElement.getBoundingClientRect();
  return {x: knob.x + knob.width / 2, y: knob.y + knob.height / 2, left: plot.left, right: plot.right, top: plot.top, bottom: plot.bottom}; })()`;
const state = (name, k) => `(() => {
  const holder = document.querySelector('.live[data-figure="${name}"]'), handle = holder.querySelectorAll(".handle")[${k}];
  const bad = /NaN|undefined|Infinity/.exec(holder.querySelector(".panes").innerHTML);
  return {hash: location.hash, value: handle.getAttribute("aria-valuetext"), bad: bad && bad[0], message: holder.querySelector(".message").textContent,
    curves: holder.querySelectorAll(".panes polyline, .panes rect").length, size: Math.min(...[...holder.querySelectorAll(".panes text")].map((t) => parseFloat(getComputedStyle(t).fontSize) * Math.hypot(t.getScreenCTM().a, t.getScreenCTM().b)))}; })()`;

export async function liveFigures(browser, page, fault) {
  const names = await browser.run(`[...document.querySelectorAll(".live[data-figure]")].map((e) => e.dataset.figure)`);
  for (const name of names) {
    const wrong = (text) => fault(page, `the live figure ${name}: ${text}`);
    const never = await browser.run(comes(name));
    if (never) { wrong(never); continue; }
    const handles = await browser.run(`document.querySelectorAll('.live[data-figure="${name}"] .handle').length`);
    if (handles === 0) wrong("has no handle");
    for (const width of [1280, 390]) {
      await browser.width(width);
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
          if (now.size < 10) wrong(`has text of ${now.size.toFixed(1)} px at ${width} px`);
          if (!now.hash.startsWith(`#live-${name}?`)) wrong("does not keep its state in the address");
        }
        if (values.size < 3) wrong(`handle ${k + 1} does not go with the pointer at ${width} px: ${[...values]}`);
      }
    }
    await browser.width(1280);
    const before = await browser.run(state(name, 0));
    await browser.run(`document.querySelector('.live[data-figure="${name}"] .handle').dispatchEvent(new KeyboardEvent("keydown", {key: "Home", bubbles: true, cancelable: true}))`);
    await wait(200);
    const after = await browser.run(state(name, 0));
    if (after.value === before.value) wrong("does not go with the keys");
  }
}
