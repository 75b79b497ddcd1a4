// What the live figures share: a place in the page, plots with handles that are dragged or moved by arrow keys, the state in
// the address, and the module, which is loaded when the first figure comes into view.
//
//   railbookFigure("creep", {
//     hint: "Drag the point ...",                                  what to try first
//     state: {creep: {unit: "‰", si: 1e-3, value: 1, low: 0, high: 8, step: 0.1, label: "longitudinal creepage"}},
//     build(figure) { ... },                                        makes plots and controls, once
//     show(figure, live, state) { ... }});                          computes and draws; state in the units above
//
// In the page <div class="live" data-figure="creep"> holds what stands there in print and without a script.
"use strict";

{

const svgns = "http://www.w3.org/2000/svg";
const shape = (name, attributes, text) => {
  const element = document.createElementNS(svgns, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
};
const element = (name, properties, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};
// Three digits, the minus a minus, powers of ten raised.
function short(v, digits = 3) {
  if (!Number.isFinite(v)) return "–";
  const [lead, power] = v.toExponential(digits - 1).split("e").map(Number);
  if (v !== 0 && (power < -3 || power > 4))
    return `${lead === 1 ? "" : `${lead}×`}10${String(power).replace(/./g, c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)])}`.replace("-", "−");
  return Number(v.toPrecision(digits)).toString().replace("-", "−");
}

class Plot {
  // x and y: [from, to, label]; log: both axes by powers of ten; equal: one scale, by the height.
  constructor(name, x, y, {width = 460, height = 280, log = false, bare = false} = {}) {
    [this.x0, this.x1] = x, [this.y0, this.y1] = y;
    Object.assign(this, {log, left: bare ? 4 : 58, right: width - 18, top: name ? 24 : 8, bottom: height - (bare ? 4 : 46)});
    this.root = shape("svg", {viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": name || `${y[2]} against ${x[2]}`});
    const clip = `live-clip-${++Plot.count}`, frame = shape("clipPath", {id: clip});
    frame.append(shape("rect", {x: this.left, y: this.top, width: this.right - this.left, height: this.bottom - this.top}));
    this.axes = shape("g", {class: "axes"}), this.curves = shape("g", {"clip-path": `url(#${clip})`}), this.handles = shape("g", {});
    this.root.append(frame, this.axes, this.curves, this.handles);
    if (name) this.root.append(shape("text", {x: (this.left + this.right) / 2, y: 15, "text-anchor": "middle", class: "name"}, name));
    if (bare) return;
    this.ticks(x, y);
  }

  share(v, from, to) { return this.log ? Math.log(v / from) / Math.log(to / from) : (v - from) / (to - from); }
  x(v) { return this.left + (this.right - this.left) * this.share(v, this.x0, this.x1); }
  y(v) { return this.bottom - (this.bottom - this.top) * this.share(v, this.y0, this.y1); }
  back(share, from, to) { return this.log ? from * (to / from) ** share : from + (to - from) * share; }
  at(px, py) {
    return [this.back((px - this.left) / (this.right - this.left), this.x0, this.x1), this.back((this.bottom - py) / (this.bottom - this.top), this.y0, this.y1)];
  }

  steps(from, to) {
    const out = [];
    if (this.log) for (let n = Math.ceil(Math.log10(from) - 1e-9); n <= Math.log10(to) + 1e-9; n++) out.push(10 ** n);
    else {
      const raw = Math.abs(to - from) / 6, power = 10 ** Math.floor(Math.log10(raw)), step = [1, 2, 5, 10].map(f => f * power).find(s => s >= raw);
      for (let n = Math.ceil(Math.min(from, to) / step - 1e-9); n * step <= Math.max(from, to) + step * 1e-9; n++) out.push(n * step);
    }
    return out;
  }

  ticks([, , xLabel], [, , yLabel]) {
    for (const v of this.steps(this.x0, this.x1))
      this.axes.append(shape("line", {x1: this.x(v), x2: this.x(v), y1: this.top, y2: this.bottom}), shape("text", {x: this.x(v), y: this.bottom + 17, "text-anchor": "middle"}, short(v)));
    for (const v of this.steps(this.y0, this.y1))
      this.axes.append(shape("line", {x1: this.left, x2: this.right, y1: this.y(v), y2: this.y(v)}), shape("text", {x: this.left - 5, y: this.y(v) + 4, "text-anchor": "end"}, short(v)));
    this.axes.append(shape("text", {x: (this.left + this.right) / 2, y: this.bottom + 37, "text-anchor": "middle"}, xLabel),
      shape("text", {transform: `translate(13 ${(this.top + this.bottom) / 2}) rotate(-90)`, "text-anchor": "middle"}, yLabel));
  }

  clear() { this.curves.replaceChildren(); }
  put(name, attributes, text) { this.curves.append(shape(name, attributes, text)); }
  line(xs, ys, colour, more = {}) {
    const points = Array.from(xs, (x, i) => [this.x(x), this.y(ys[i])]).filter(p => p.every(Number.isFinite)).map(p => p.map(v => v.toFixed(1)).join()).join(" ");
    this.put("polyline", {points, fill: "none", stroke: `var(--${colour})`, "stroke-width": 2, ...more});
  }
  dot(x, y, colour, r = 4) { this.put("circle", {cx: this.x(x), cy: this.y(y), r, fill: `var(--${colour})`}); }
  label(x, y, text, colour = "text", anchor = "start") { this.put("text", {x: this.x(x), y: this.y(y), "text-anchor": anchor, style: `fill: var(--${colour})`}, text); }
  // A cell of a table with middle and sizes; share 0 to 1 of the colour, or a colour of its own.
  cell(x, y, dx, dy, fill, more = {}) {
    const [a, b] = [this.x(x - dx / 2), this.x(x + dx / 2)].sort((p, q) => p - q), [c, d] = [this.y(y - dy / 2), this.y(y + dy / 2)].sort((p, q) => p - q);
    this.put("rect", {x: a.toFixed(2), y: c.toFixed(2), width: (b - a + 0.2).toFixed(2), height: (d - c + 0.2).toFixed(2), fill, ...more});
  }
}
Plot.count = 0;

class LiveFigure {
  constructor(holder, definition, live) {
    Object.assign(this, {holder, definition, live, name: holder.dataset.figure, state: {}, watchers: []});
    for (const [key, s] of Object.entries(definition.state)) this.state[key] = s.value;
    this.read();
    this.panes = element("div", {className: "panes"}), this.controls = element("div", {className: "controls"});
    this.numbers = element("dl", {className: "says"});
    this.numbers.setAttribute("aria-live", "polite");
    this.message = element("p", {className: "message"}), this.time = element("span", {className: "time"});
    this.message.setAttribute("role", "status");
    definition.build(this);
    const still = element("details", {className: "still"}, element("summary", {textContent: "The drawing that stands here in print"}), ...holder.childNodes);
    addEventListener("beforeprint", () => { still.open = true; });
    addEventListener("afterprint", () => { still.open = false; });
    const link = element("button", {type: "button", textContent: "Link to this state", onclick: () => navigator.clipboard?.writeText(location.href)});
    const reset = element("button", {type: "button", textContent: "Start again", onclick: () => this.set(Object.fromEntries(Object.entries(definition.state).map(([k, s]) => [k, s.value])))});
    holder.replaceChildren(element("div", {className: "working"}, element("p", {className: "hint", textContent: definition.hint}), this.panes, this.controls, this.message, this.numbers,
      element("p", {className: "foot"}, reset, " ", link, " ", this.time)), still);
    holder.classList.add("on");
    this.show();
  }

  plot(...args) {
    const plot = new Plot(...args);
    this.panes.append(plot.root);
    return plot;
  }

  clamp(key, v) {
    const s = this.definition.state[key];
    return Number(Math.min(s.high, Math.max(s.low, Math.round(v / s.step) * s.step)).toPrecision(9));
  }
  text(key) { return `${short(this.state[key], 4)} ${this.definition.state[key].unit}`; }
  set(change) {
    for (const [key, v] of Object.entries(change)) this.state[key] = this.clamp(key, v);
    this.write();
    if (!this.waiting) this.waiting = requestAnimationFrame(() => { this.waiting = 0; this.show(); });
  }

  slider(key) {
    const s = this.definition.state[key];
    const input = element("input", {type: "range", min: s.low, max: s.high, step: s.step, oninput: () => this.set({[key]: Number(input.value)})});
    const output = element("output", {});
    this.controls.append(element("label", {}, element("span", {textContent: s.label}), input, output));
    this.watchers.push(() => { input.value = this.state[key]; output.textContent = this.text(key); input.setAttribute("aria-valuetext", output.textContent); });
  }
  choice(key, names) {
    const s = this.definition.state[key];
    const select = element("select", {onchange: () => this.set({[key]: Number(select.value)})}, ...names.map((name, i) => element("option", {value: i, textContent: name})));
    this.controls.append(element("label", {}, element("span", {textContent: s.label}), select));
    this.watchers.push(() => { select.value = this.state[key]; });
  }

  // A handle at place(state) = [x, y] of a plot; x and y name what dragging along an axis moves, and grip(x, y) may say it otherwise.
  handle(plot, {x, y, label, place, grip}) {
    const key = x ?? y, s = this.definition.state[key];
    const knob = shape("circle", {r: 9, class: "handle", tabindex: 0, role: "slider", "aria-label": label, "aria-valuemin": s.low, "aria-valuemax": s.high});
    plot.handles.append(knob);
    const move = event => {
      const box = plot.root.getBoundingClientRect(), view = plot.root.viewBox.baseVal;
      const [vx, vy] = plot.at((event.clientX - box.left) * view.width / box.width, (event.clientY - box.top) * view.height / box.height);
      this.set(grip ? grip(vx, vy) : {...(x && {[x]: vx}), ...(y && {[y]: vy})});
    };
    knob.onpointerdown = event => { knob.setPointerCapture(event.pointerId); event.preventDefault(); knob.focus(); };
    knob.onpointermove = event => { if (knob.hasPointerCapture(event.pointerId)) move(event); };
    knob.onkeydown = event => {
      const [which, sign] = {ArrowRight: [x ?? y, 1], ArrowLeft: [x ?? y, -1], ArrowUp: [y ?? x, 1], ArrowDown: [y ?? x, -1]}[event.key] ?? [];
      if (event.key === "Home" || event.key === "End") this.set({[key]: event.key === "Home" ? s.low : s.high});
      else if (!which) return;
      else this.set({[which]: this.state[which] + sign * this.definition.state[which].step * (event.shiftKey ? 10 : 1)});
      event.preventDefault();
    };
    this.watchers.push(() => {
      const [px, py] = place(this.state);
      knob.setAttribute("cx", plot.x(px)), knob.setAttribute("cy", plot.y(py));
      knob.setAttribute("aria-valuenow", this.state[key]), knob.setAttribute("aria-valuetext", [x, y].filter(Boolean).map(k => this.text(k)).join(", "));
    });
  }

  says(pairs) {
    this.numbers.replaceChildren(...pairs.flatMap(([what, text]) => [element("dt", {textContent: what}), element("dd", {textContent: text})]));
  }

  show() {
    this.message.textContent = "";
    const begin = performance.now();
    try {
      this.definition.show(this, this.live, this.state);
      this.time.textContent = `computed and drawn in ${short(performance.now() - begin, 2)} ms`;
    } catch (error) {
      this.message.textContent = error.message;
      this.time.textContent = "";
    }
    for (const watch of this.watchers) watch();
  }

  write() {
    const text = Object.entries(this.state).map(([key, v]) => `${key}=${v}`).join("&");
    try { history.replaceState(null, "", `#live-${this.name}?${text}`); } catch { /* some browsers refuse from disk */ }
  }
  read() {
    const [id, text] = decodeURIComponent(location.hash.slice(1)).split("?");
    if (id !== `live-${this.name}` || !text) return;
    for (const [key, v] of new URLSearchParams(text)) if (key in this.state && Number.isFinite(Number(v))) this.state[key] = this.clamp(key, Number(v));
    requestAnimationFrame(() => this.holder.scrollIntoView());
  }
}

const definitions = new Map();
globalThis.railbookFigure = (name, definition) => definitions.set(name, definition);
railbookFigure.short = short;

// A script of the folder live/, once.
const scripts = new Map();
function script(src) {
  if (!scripts.has(src))
    scripts.set(src, new Promise((done, failed) => document.head.append(element("script", {src: `live/${src}`, onload: done, onerror: () => failed(new Error(`live/${src} is missing`))}))));
  return scripts.get(src);
}

for (const holder of document.querySelectorAll(".live[data-figure]")) {
  const name = holder.dataset.figure;
  const start = async () => {
    try {
      await Promise.all([script("module.js"), script(`${name}.js`)]);
      new LiveFigure(holder, definitions.get(name), await railbookLive());
    } catch (error) { // the drawing stays
      holder.append(element("p", {className: "message", textContent: `This figure cannot compute here: ${error.message}`}));
    }
  };
  if (location.hash.startsWith(`#live-${name}?`)) start();
  else new IntersectionObserver(([entry], observer) => {
    if (!entry.isIntersecting) return;
    observer.disconnect();
    start();
  }, {rootMargin: "300px"}).observe(holder);
}
}
