// What the live figures share: a place in the page, plots with handles that are dragged or moved by arrow keys, the state in
// the address, and the module, which is loaded when the first figure comes into view.
//
//   railbookFigure("creep", {
//     hint: "Drag the point ...",                                  what to try first
//     coarsens: "on fewer cells while you drag",                   where figure.coarse makes a difference
//     state: {creep: {unit: "‰", si: 1e-3, value: 1, low: 0, high: 8, step: 0.1, label: "longitudinal creepage"}},
//     build(figure) { ... },                                        makes plots and controls, for each width of the page
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
const raised = n => `10${String(n).replace(/./g, c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)])}`;
const power = v => raised(Math.round(Math.log10(v)));
// Three digits, the minus a minus, powers of ten raised.
function short(v, digits = 3) {
  if (!Number.isFinite(v)) return "–";
  const [lead, n] = v.toExponential(digits - 1).split("e").map(Number);
  if (v !== 0 && (n < -3 || n > 4)) return `${lead === 1 ? "" : `${lead}×`}${raised(n)}`.replace("-", "−");
  return Number(v.toPrecision(digits)).toString().replace("-", "−");
}

class Plot {
  // x and y: [from, to, label]. key: [name, colour] of curves, named above the frame. log, or logx: both axes, or that of x, by powers of ten; equal: lengths
  // along y are drawn so many times as long as those along x; bare: no axes. Units of the drawing are pixels of the page.
  constructor(name, x, y, {width, height = 260, key = [], log = false, logx = log, equal = 0, bare = false}) {
    [this.x0, this.x1] = x, [this.y0, this.y1] = y;
    Object.assign(this, {log, logx, left: bare ? 2 : 58, right: width - (bare ? 2 : 18), top: 8});
    const room = bare ? 4 : 46, wide = this.right - this.left;
    this.bottom = equal ? Math.round(this.top + wide * equal * Math.abs((y[1] - y[0]) / (x[1] - x[0])))
      : Math.round(bare ? Math.max(height * width / 460, 110) : Math.min(height, 0.66 * width + 20)) - room;
    this.svg = shape("svg", {viewBox: `0 0 ${width} ${this.bottom + room}`, role: "group", "aria-label": name});
    const clip = `live-clip-${++Plot.count}`, frame = shape("clipPath", {id: clip});
    this.field = {x: this.left, y: this.top, width: wide, height: this.bottom - this.top};
    frame.append(shape("rect", this.field));
    this.axes = shape("g", {class: "axes"}), this.curves = shape("g", {"clip-path": `url(#${clip})`}), this.handles = shape("g", {});
    this.svg.append(frame, this.axes, this.curves, this.handles);
    const keys = key.map(([text, colour]) => element("span", {className: "key", textContent: text, style: `color: var(--${colour})`}));
    this.root = element("div", {}, element("p", {className: "name", textContent: name}), ...(keys.length ? [element("p", {className: "keys"}, ...keys.flatMap(k => [k, " "]))] : []), this.svg);
    this.labels = [x[2], y[2]];
    if (!bare) this.ticks();
  }

  // Other ends of the axis y: the first pair that contains the values, or the last.
  range(ends, ...values) {
    const low = Math.min(...values.map(v => Math.min(...v))), high = Math.max(...values.map(v => Math.max(...v)));
    const [y0, y1] = ends.find(([a, b]) => low >= Math.min(a, b) && high <= Math.max(a, b)) ?? ends[ends.length - 1];
    if (y0 === this.y0 && y1 === this.y1) return;
    [this.y0, this.y1] = [y0, y1];
    this.axes.replaceChildren();
    this.ticks();
  }

  share(v, from, to, log) { return log ? Math.log(v / from) / Math.log(to / from) : (v - from) / (to - from); }
  x(v) { return this.left + (this.right - this.left) * this.share(v, this.x0, this.x1, this.logx); }
  y(v) { return this.bottom - (this.bottom - this.top) * this.share(v, this.y0, this.y1, this.log); }
  back(share, from, to, log) { return log ? from * (to / from) ** share : from + (to - from) * share; }
  at(px, py) {
    return [this.back((px - this.left) / (this.right - this.left), this.x0, this.x1, this.logx), this.back((this.bottom - py) / (this.bottom - this.top), this.y0, this.y1, this.log)];
  }

  steps(from, to, most, log) {
    const out = [];
    if (log) {
      const first = Math.ceil(Math.log10(from) - 1e-9), last = Math.floor(Math.log10(to) + 1e-9), stride = Math.ceil((last - first) / most);
      for (let n = first; n <= last; n += stride) out.push(10 ** n);
    } else {
      const raw = Math.abs(to - from) / most, power = 10 ** Math.floor(Math.log10(raw)), step = [1, 2, 5, 10].map(f => f * power).find(s => s >= raw);
      for (let n = Math.ceil(Math.min(from, to) / step - 1e-9); n * step <= Math.max(from, to) + step * 1e-9; n++) out.push(n * step);
    }
    return out;
  }

  ticks() {
    const [xLabel, yLabel] = this.labels;
    for (const v of this.steps(this.x0, this.x1, Math.min(6, this.field.width / 50), this.logx))
      this.axes.append(shape("line", {x1: this.x(v), x2: this.x(v), y1: this.top, y2: this.bottom}), shape("text", {x: this.x(v), y: this.bottom + 17, "text-anchor": "middle"}, short(v)));
    for (const v of this.steps(this.y0, this.y1, Math.min(6, this.field.height / 28), this.log))
      this.axes.append(shape("line", {x1: this.left, x2: this.right, y1: this.y(v), y2: this.y(v)}), shape("text", {x: this.left - 5, y: this.y(v) + 4, "text-anchor": "end"}, this.log && v < 0.01 ? power(v) : short(v)));
    this.axes.append(shape("text", {x: (this.left + this.right) / 2, y: this.bottom + 37, "text-anchor": "middle"}, xLabel),
      shape("text", {transform: `translate(13 ${(this.top + this.bottom) / 2}) rotate(-90)`, "text-anchor": "middle"}, yLabel));
  }

  clear() { this.curves.replaceChildren(); }
  put(name, attributes, text) { this.curves.append(shape(name, attributes, text)); }
  points(xs, ys) {
    return Array.from(xs, (x, i) => [this.x(x), this.y(ys[i])]).filter(p => p.every(Number.isFinite)).map(p => p.map(v => v.toFixed(1)).join()).join(" ");
  }
  line(xs, ys, colour, more = {}) { this.put("polyline", {points: this.points(xs, ys), fill: "none", stroke: `var(--${colour})`, "stroke-width": 2, ...more}); }
  // An area, lightly filled.
  area(xs, ys, colour, share = 0.15, more = {}) { this.put("polygon", {points: this.points(xs, ys), fill: `var(--${colour})`, "fill-opacity": share, ...more}); }
  dot(x, y, colour, r = 4) { this.put("circle", {cx: this.x(x), cy: this.y(y), r, fill: `var(--${colour})`}); }
  label(x, y, text, colour = "text", anchor = "start") { this.put("text", {x: this.x(x), y: this.y(y), "text-anchor": anchor, style: `fill: var(--${colour})`}, text); }
  // A cell of a table with middle and sizes; share 0 to 1 of the colour, or a colour of its own.
  cell(x, y, dx, dy, fill, more = {}) {
    const [a, b] = [this.x(x - dx / 2), this.x(x + dx / 2)].sort((p, q) => p - q), [c, d] = [this.y(y - dy / 2), this.y(y + dy / 2)].sort((p, q) => p - q);
    this.put("rect", {x: a.toFixed(2), y: c.toFixed(2), width: (b - a + 0.2).toFixed(2), height: (d - c + 0.2).toFixed(2), fill, ...more});
  }
}
Plot.count = 0;

const motionless = matchMedia("(prefers-reduced-motion: reduce)");

class LiveFigure {
  constructor(holder, definition, live) {
    Object.assign(this, {holder, definition, name: holder.dataset.figure, state: {}, spent: 0});
    this.live = Object.fromEntries(Object.entries(live).map(([name, call]) => [name, (...given) => {
      try { return call(...given); } finally { this.spent += call.took ?? 0; }
    }]));
    for (const [key, s] of Object.entries(definition.state)) this.state[key] = s.value;
    this.panes = element("div", {className: "panes"}), this.controls = element("div", {className: "controls"});
    this.numbers = element("dl", {className: "says"});
    this.numbers.setAttribute("aria-live", "polite");
    this.message = element("p", {className: "message"}), this.time = element("span", {className: "time"});
    this.message.setAttribute("role", "status");
    const still = element("details", {className: "still"}, element("summary", {textContent: "The drawing of this page, with its symbols"}), ...holder.childNodes);
    const print = matchMedia("print"), printed = () => { still.open = print.matches; };
    print.addEventListener("change", printed);
    addEventListener("beforeprint", () => { still.open = true; });
    addEventListener("afterprint", printed);
    const link = element("button", {type: "button", textContent: "Link to this state", onclick: () => { this.write(); this.copy(link); }});
    const reset = element("button", {type: "button", textContent: "Start again", onclick: () => this.set(Object.fromEntries(Object.entries(definition.state).map(([k, s]) => [k, s.value])))});
    holder.replaceChildren(element("div", {className: "working"}, element("p", {className: "hint", textContent: definition.hint}), this.panes, this.controls, this.message, this.numbers,
      element("p", {className: "foot"}, reset, " ", link, " ", this.time)), still);
    holder.classList.add("on");
    this.read();
    addEventListener("hashchange", () => { if (this.read()) this.show(); });
    new ResizeObserver(() => { if (this.panes.clientWidth > 0 && Math.abs(this.panes.clientWidth - this.built) > 4) this.build(); }).observe(this.panes);
    this.build();
  }

  // Plots in columns as wide as the page has room for, so that their text keeps its size; again when the width changes.
  build() {
    const wide = this.built = this.panes.clientWidth, most = this.definition.columns ?? 2, gap = 14;
    this.count = Math.max(1, Math.min(most, Math.floor((wide + gap) / (290 + gap))));
    this.width = Math.floor((wide - gap * (this.count - 1)) / this.count);
    this.panes.style.gridTemplateColumns = `repeat(${this.count}, ${this.width}px)`;
    this.panes.replaceChildren(), this.controls.replaceChildren();
    this.watchers = [];
    this.definition.build(this);
    this.show();
  }

  // A plot of the width of a column, or of `across` columns where there are so many.
  plot(name, x, y, {across = 1, ...options} = {}) {
    const columns = Math.min(across, this.count), plot = new Plot(name, x, y, {width: columns * this.width + 14 * (columns - 1), ...options});
    plot.root.style.gridColumn = `span ${columns}`;
    this.panes.append(plot.root);
    return plot;
  }

  clamp(key, v) {
    const s = this.definition.state[key];
    return Number(Math.min(s.high, Math.max(s.low, Math.round(v / s.step) * s.step)).toPrecision(9));
  }
  text(key) { return `${short(this.state[key], 4)} ${this.definition.state[key].unit}`; }
  // What is dragged stays in its range; what is typed may leave it, and the library's refusal is shown. While something moves,
  // a figure may compute on fewer cells (figure.coarse).
  set(change, {moving = false, typed = false} = {}) {
    for (const [key, v] of Object.entries(change)) this.state[key] = typed ? v : this.clamp(key, v);
    this.write();
    this.coarse = moving;
    if (!this.waiting) this.waiting = requestAnimationFrame(() => { this.waiting = 0; this.show(); });
    clearTimeout(this.rest);
    if (moving && this.definition.coarsens) this.rest = setTimeout(() => { this.coarse = false; this.show(); }, 250);
  }

  slider(key) {
    const s = this.definition.state[key];
    const input = element("input", {type: "range", min: s.low, max: s.high, step: s.step, oninput: () => this.set({[key]: Number(input.value)}, {moving: true})});
    const number = element("input", {type: "number", step: "any", onchange: () => { if (number.value !== "") this.set({[key]: Number(number.value)}, {typed: true}); }});
    number.setAttribute("aria-label", `${s.label}, as a number`);
    this.controls.append(element("label", {}, element("span", {textContent: s.label}), input, number, " ", s.unit));
    this.watchers.push(() => { input.value = this.state[key]; number.value = Number(this.state[key].toPrecision(6)); input.setAttribute("aria-valuetext", this.text(key)); });
  }
  choice(key, names) {
    const s = this.definition.state[key];
    const select = element("select", {onchange: () => this.set({[key]: Number(select.value)})}, ...names.map((name, i) => element("option", {value: i, textContent: name})));
    this.controls.append(element("label", {}, element("span", {textContent: s.label}), select));
    this.watchers.push(() => { select.value = this.state[key]; });
  }
  button(text, action) { this.controls.append(element("button", {type: "button", textContent: text, onclick: action})); }

  // A handle at place(state) = [x, y] of a plot; x and y name what dragging along an axis moves, and grip(x, y) may say it otherwise.
  // whole: the plot is dragged along from wherever it is taken, as a body is.
  handle(plot, {x, y, label, place, grip, whole = false}) {
    const key = x ?? y, s = this.definition.state[key];
    const knob = shape("circle", {r: 9, class: "handle", tabindex: 0, role: "slider", "aria-label": label, "aria-valuemin": s.low, "aria-valuemax": s.high});
    const arrows = shape("path", {class: "arrows", d: `${x ? "M-14-4l-5 4 5 4M14-4l5 4-5 4" : ""}${y ? "M-4-14l4-5 4 5M-4 14l4 5 4-5" : ""}`});
    const grasp = whole ? shape("rect", {...plot.field, class: "grasp"}) : knob;
    plot.handles.append(...(whole ? [grasp] : []), arrows, knob);
    let from = null; // of the pointer to the knob
    const here = event => {
      const box = plot.svg.getBoundingClientRect(), scale = plot.svg.viewBox.baseVal.width / box.width;
      return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    };
    for (const part of new Set([grasp, knob])) {
      part.onpointerdown = event => {
        const [px, py] = here(event);
        from = [knob.cx.baseVal.value - px, knob.cy.baseVal.value - py];
        part.setPointerCapture(event.pointerId);
        event.preventDefault();
        knob.focus({preventScroll: true});
      };
      part.onpointermove = event => {
        if (!part.hasPointerCapture(event.pointerId)) return;
        const [px, py] = here(event), [vx, vy] = plot.at(px + from[0], py + from[1]);
        this.set(grip ? grip(vx, vy) : {...(x && {[x]: vx}), ...(y && {[y]: vy})}, {moving: true});
      };
    }
    knob.onkeydown = event => {
      const [which, sign] = {ArrowRight: [x ?? y, 1], ArrowLeft: [x ?? y, -1], ArrowUp: [y ?? x, 1], ArrowDown: [y ?? x, -1]}[event.key] ?? [];
      if (event.key === "Home" || event.key === "End") this.set({[key]: event.key === "Home" ? s.low : s.high});
      else if (!which) return;
      else this.set({[which]: this.state[which] + sign * this.definition.state[which].step * (event.shiftKey ? 10 : 1)}, {moving: true});
      event.preventDefault();
    };
    this.watchers.push(() => {
      const [px, py] = place(this.state), cx = plot.x(px), cy = plot.y(py);
      if (!Number.isFinite(cx + cy)) return; // of what the library refuses
      knob.setAttribute("cx", cx), knob.setAttribute("cy", cy);
      arrows.setAttribute("transform", `translate(${cx} ${cy})`);
      knob.setAttribute("aria-valuenow", this.state[key]), knob.setAttribute("aria-valuetext", [x, y].filter(Boolean).map(k => this.text(k)).join(", "));
    });
  }

  says(pairs) {
    this.numbers.replaceChildren(...pairs.flatMap(([what, text]) => [element("dt", {textContent: what}), element("dd", {textContent: text})]));
  }

  // Draws by the time in seconds, again and again while the figure is in sight; once, and `still`, for who asks for less motion.
  animate(draw) {
    cancelAnimationFrame(this.frame);
    const begin = performance.now(), still = motionless.matches;
    const next = now => {
      const box = this.holder.getBoundingClientRect();
      if (now === begin || (box.bottom > 0 && box.top < innerHeight)) draw(Math.max(0, now - begin) / 1000, still);
      if (!still) this.frame = requestAnimationFrame(next);
    };
    next(begin);
  }

  show() {
    this.message.textContent = "";
    const begin = performance.now();
    this.spent = 0;
    try {
      this.definition.show(this, this.live, this.state);
      const whole = performance.now() - begin;
      this.time.textContent = `computed in ${short(this.spent, 2)} ms, drawn in ${short(whole - this.spent, 2)} ms${this.coarse && this.definition.coarsens ? `; ${this.definition.coarsens}` : ""}`;
      Object.assign(this.time.dataset, {answer: this.spent, whole});
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
    if (id !== `live-${this.name}` || !text) return false;
    for (const [key, v] of new URLSearchParams(text)) if (key in this.state && v !== "" && Number.isFinite(Number(v))) this.state[key] = Number(v);
    requestAnimationFrame(() => this.holder.scrollIntoView());
    return true;
  }
  async copy(button) {
    const text = button.textContent;
    try {
      await navigator.clipboard.writeText(location.href);
      button.textContent = "Copied";
    } catch {
      button.textContent = "It stands in the address";
    }
    setTimeout(() => { button.textContent = text; }, 1500);
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
