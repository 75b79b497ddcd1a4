// Figures that answer: a reader moves a slider, and the page draws what the chapter's program computed for that value. It
// chooses and draws, and computes nothing. The data are two tables of the program:
//   <id>-panels.csv   panel,kind,x_label,y_label,x_from,x_to,y_from,y_to,scale   kind: lines, cells (dots), plane (dots and the unit circle)
//                     or says; scale: lin, log, logx or logy
//   <id>-answer.csv   the sliders' columns, then panel,curve,x,y (of a `says` panel: x is a number, and curve what it is, with its unit)
"use strict";

const answers = new Map();
globalThis.railbookAnswer = (id, panels, rows) => answers.set(id, {panels: table(panels), rows: table(rows)});

// "=3,..." stands for the first three cells of the line before; "~" for the x that the curve before has at that place.
function table(text) {
  let before = [], curve = {head: null, x: []}, last = [];
  const whole = (line) => {
    const [, count, rest] = line.match(/^=(\d+),(.*)$/) ?? [];
    const row = count ? [...before.slice(0, count), ...cells(rest)] : cells(line), n = row.length, head = row.slice(0, n - 2).join();
    if (head !== curve.head) { last = curve.x; curve = {head, x: []}; }
    if (row[n - 2] === "~") row[n - 2] = last[curve.x.length];
    curve.x.push(row[n - 2]);
    return before = row;
  };
  const [head, ...lines] = text.trim().split("\n").filter((line) => line && !line.startsWith("#")).map(whole);
  return {head, lines};
}

function cells(line) {
  if (!line.includes('"')) return line.split(",");
  return [...line.matchAll(/("([^"]|"")*"|[^,]*)(,|$)/g)].map((m) => m[1].replace(/^"|"$/g, "").replaceAll('""', '"')).slice(0, -1);
}

const colours = ["var(--text)", "var(--curve-1)", "var(--curve-2)", "var(--curve-3)", "var(--curve-4)", "var(--curve-5)"];
let panelCount = 0;
const svgns = "http://www.w3.org/2000/svg";
const draw = (name, attributes, text) => {
  const element = document.createElementNS(svgns, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
};
const raised = (n) => String(n).replace(/./g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
function short(v) {
  const text = Number(v.toPrecision(3)).toString().replace("-", "−");
  if (v === 0 || (Math.abs(v) >= 1e-3 && Math.abs(v) < 1e5)) return text;
  const power = Math.floor(Math.log10(Math.abs(v)) + 1e-9), lead = Number((v / 10 ** power).toPrecision(3));
  return (lead === 1 ? "" : String(lead).replace("-", "−") + "×") + "10" + raised(power);
}

function ticks(from, to, log) {
  if (log) {
    const out = [];
    for (let n = Math.ceil(Math.log10(from) - 1e-9); n <= Math.log10(to) + 1e-9; n++) out.push(10 ** n);
    return out;
  }
  const raw = (to - from) / 5, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= raw);
  const out = [];
  for (let v = Math.ceil(from / step - 1e-9) * step; v <= to + step * 1e-9; v += step) out.push(Math.abs(v) < step * 1e-9 ? 0 : v);
  return out;
}

class Panel {
  constructor([name, kind, xLabel, yLabel, xFrom, xTo, yFrom, yTo, scale]) {
    Object.assign(this, {name, kind, xLabel, yLabel, xLog: /log$|logx/.test(scale), yLog: /log$|logy/.test(scale)});
    [this.x0, this.x1, this.y0, this.y1] = [xFrom, xTo, yFrom, yTo].map(Number);
    this.names = [];
    if (kind === "says") {
      this.root = make("dl", {className: "says"});
      this.root.setAttribute("aria-live", "polite");
      return;
    }
    this.drawing = draw("svg", {viewBox: "0 0 470 290", role: "img", "aria-label": name + ": " + yLabel + " against " + xLabel});
    this.keys = make("p", {className: "keys"});
    this.root = make("div", {}, this.drawing, this.keys);
    this.axes();
    const clip = "panel-" + ++panelCount; // what leaves the axes is cut off there
    const frame = draw("clipPath", {id: clip});
    frame.append(draw("rect", {x: 50, y: 26, width: 402, height: 222}));
    this.drawing.append(frame);
    if (kind === "plane") this.drawing.append(draw("ellipse", {cx: this.x(0), cy: this.y(0), rx: this.x(1) - this.x(0), ry: this.y(0) - this.y(1),
      fill: "none", stroke: colours[1], "stroke-width": 1.5}));
    this.curves = draw("g", {"clip-path": "url(#" + clip + ")"});
    this.drawing.append(this.curves);
  }

  x(v) { return 52 + 398 * (this.xLog ? Math.log(v / this.x0) / Math.log(this.x1 / this.x0) : (v - this.x0) / (this.x1 - this.x0)); }
  y(v) { return 246 - 218 * (this.yLog ? Math.log(v / this.y0) / Math.log(this.y1 / this.y0) : (v - this.y0) / (this.y1 - this.y0)); }

  axes() {
    for (const v of ticks(this.x0, this.x1, this.xLog))
      this.drawing.append(draw("line", {class: "grid", x1: this.x(v), x2: this.x(v), y1: 28, y2: 246}),
        draw("text", {x: this.x(v), y: 260, "text-anchor": "middle"}, short(v)));
    for (const v of ticks(this.y0, this.y1, this.yLog))
      this.drawing.append(draw("line", {class: "grid", x1: 52, x2: 450, y1: this.y(v), y2: this.y(v)}),
        draw("text", {x: 47, y: this.y(v) + 4, "text-anchor": "end"}, short(v)));
    this.drawing.append(draw("text", {x: 251, y: 280, "text-anchor": "middle"}, this.xLabel),
      draw("text", {transform: "translate(11 137) rotate(-90)", "text-anchor": "middle"}, this.yLabel),
      draw("text", {x: 251, y: 14, "text-anchor": "middle", class: "name"}, this.name));
  }

  colour(curve) {
    if (!this.names.includes(curve)) this.names.push(curve);
    return colours[this.names.indexOf(curve) % colours.length];
  }

  key(curve, colour, dashes, dots) {
    const sample = draw("svg", {viewBox: "0 0 22 8", width: 22, height: 8, "aria-hidden": "true"});
    sample.append(!dots ? draw("line", {x1: 0, x2: 22, y1: 4, y2: 4, stroke: colour, "stroke-width": 2, "stroke-dasharray": dashes})
      : draw("circle", {cx: 11, cy: 4, r: 3.5, fill: colour}));
    return make("span", {className: "key"}, sample, " " + curve);
  }

  show(rows) {
    const curves = new Map();
    for (const [curve, x, y] of rows) {
      if (!curves.has(curve)) curves.set(curve, []);
      curves.get(curve).push([x, y]);
    }
    if (this.kind === "says") {
      this.root.replaceChildren(...[...curves].flatMap(([what, [[x]]]) => [make("dt", {textContent: what.replace(/,.*$/, "")}),
        make("dd", {textContent: (Number.isNaN(Number(x)) || x === "" ? x : short(Number(x))) + " " + (what.split(",")[1] ?? "").trim()})]));
      return;
    }
    this.curves.replaceChildren();
    this.keys.replaceChildren();
    let at = 0;
    for (const [curve, points] of curves) {
      const colour = this.colour(curve);
      const inside = points.map(([x, y]) => [Number(x), Number(y)]).map(([x, y]) => [this.x(x), this.y(this.yLog ? Math.max(y, this.y0 / 10) : y)]);
      const dots = this.kind !== "lines" || inside.length === 1;
      if (dots) {
        for (const [x, y] of inside) this.curves.append(draw("circle", {cx: x, cy: y, r: this.kind === "cells" ? 3 : 5, fill: colour}));
      } else {
        this.curves.append(draw("polyline", {points: inside.map((p) => p.map((v) => v.toFixed(1)).join()).join(" "), fill: "none",
          stroke: colour, "stroke-width": 2, "stroke-dasharray": at % 2 ? "6 3" : ""}));
      }
      if (curve) this.keys.append(this.key(curve, colour, at++ % 2 ? "6 3" : "", dots), " ");
    }
  }
}

// One slider for each column before "panel"; the state of all is in the address.
class Answer {
  constructor(holder, {panels, rows}) {
    this.id = holder.dataset.id;
    const first = rows.head.indexOf("panel");
    this.names = rows.head.slice(0, first);
    this.rows = new Map();
    this.values = this.names.map(() => []);
    for (const line of rows.lines) {
      const key = line.slice(0, first).join();
      line.slice(0, first).forEach((v, i) => { if (!this.values[i].includes(v)) this.values[i].push(v); });
      if (!this.rows.has(key)) this.rows.set(key, []);
      this.rows.get(key).push(line.slice(first));
    }
    this.panels = panels.lines.map((line) => new Panel(line));
    this.sliders = this.names.map((name, i) => this.slider(name, this.values[i]));
    holder.replaceChildren(make("div", {className: "sliders"}, ...this.sliders.map((s) => s.label)),
      make("div", {className: "panes"}, ...this.panels.map((p) => p.root)));
    this.read();
    this.show();
  }

  slider(name, values) {
    const [, word, unit] = name.match(/^(.*?)(?:_([^_]*))?$/);
    const input = make("input", {type: "range", min: 0, max: values.length - 1, step: 1, value: Math.floor((values.length - 1) / 2)});
    const output = make("output", {});
    input.oninput = () => { this.show(); this.write(); };
    return {label: make("label", {}, word.replaceAll("-", " ") + " ", input, " ", output), input, output, unit: (unit ?? "").replaceAll("-", "·"), values};
  }

  show() {
    const chosen = this.sliders.map((s) => s.values[s.input.value]);
    this.sliders.forEach((s, i) => {
      s.output.textContent = short(Number(chosen[i])) + " " + s.unit;
      s.input.setAttribute("aria-valuetext", s.output.textContent);
    });
    const rows = this.rows.get(chosen.join()) ?? [];
    for (const panel of this.panels) panel.show(rows.filter(([name]) => name === panel.name).map((row) => row.slice(1)));
  }

  write() {
    const state = this.sliders.map((s) => s.values[s.input.value]).join(":");
    try { history.replaceState(null, "", "#" + this.id + "=" + state); } catch { /* some browsers refuse from disk */ }
  }

  read() {
    const [id, state] = decodeURIComponent(location.hash.slice(1)).split("=");
    if (id !== this.id || !state) return;
    state.split(":").forEach((value, i) => {
      const at = this.sliders[i]?.values.indexOf(value) ?? -1;
      if (at >= 0) this.sliders[i].input.value = at;
    });
    document.getElementById(this.id)?.scrollIntoView();
  }
}

for (const holder of all(".answer")) {
  const start = () => {
    const script = make("script", {src: holder.dataset.src, onload: () => new Answer(holder, answers.get(holder.dataset.id))});
    document.head.append(script);
  };
  if (location.hash.startsWith("#" + holder.dataset.id + "=")) start();
  else new IntersectionObserver(([entry], observer) => {
    if (!entry.isIntersecting) return;
    observer.disconnect();
    start();
  }, {rootMargin: "400px"}).observe(holder);
}
