// Chapter 6: on one wave at one speed a body with bump stops may swing in two ways, and how the wave begins decides.
"use strict";

railbookFigure("quality", {
  hint: "Drag the point along the frequency, from left to right. From some frequency on, the same wave gives two strokes: a sudden start finds the large one.",
  columns: 3,
  state: {
    frequency: {unit: "Hz", si: 1, value: 0.95, low: 0.25, high: 2, step: 0.01, label: "frequency of the wave (speed over wavelength)"},
    amplitude: {unit: "cm", si: 0.01, value: 1.04, low: 0.2, high: 2.5, step: 0.02, label: "amplitude of the track"},
    kappa: {unit: "times the spring", si: 1, value: 10, low: 0, high: 60, step: 1, label: "stiffness of the stops"},
    posted: {unit: "km/h", si: 1 / 3.6, value: 100, low: 20, high: 200, step: 5, label: "posted speed"},
    mass: {unit: "kg", si: 1, value: 7000, low: 2000, high: 13500, step: 100, label: "body's mass on a wheel (ours)"},
    damping: {unit: "of critical", si: 1, value: 0.2, low: 0.05, high: 0.6, step: 0.01, label: "damping"},
  },

  build(figure) {
    this.curve = figure.plot("Settled stroke, frequency swept up and down", [0.25, 2, "frequency, Hz"], [0, 8, "stroke, cm"], {key: [["upwards", "curve-2"], ["downwards", "curve-1"], ["without stops (dashed)", "soft"], ["limit 2.54 cm", "red"]]});
    this.time = figure.plot("The same wave, begun in two ways", [0, 60, "time, s"], [-5, 5, "stroke, cm"], {key: [["sudden start", "curve-2"], ["slow start, in 20 s", "curve-1"], ["the stops (dashed)", "soft"]]});
    this.allowed = figure.plot("What a posted speed allows, without stops", [0.5, 1000, "wavelength, m"], [0.01, 100, "amplitude, cm"], {log: true, key: [["by stroke and wheel force", "curve-3"], ["1.6 cm (dashed)", "soft"]]});
    for (const key of ["frequency", "amplitude", "kappa", "damping", "posted", "mass"]) figure.slider(key);
    figure.handle(this.curve, {x: "frequency", label: "frequency of the wave", place: s => [s.frequency, Math.min(8, this.stroke ?? 0)]});
  },

  show(figure, live, s) {
    const {short} = railbookFigure, body = {amplitude: s.amplitude / 100, kappa: s.kappa, damping: s.damping}, kind = JSON.stringify(body);
    if (this.kind !== kind) this.kind = kind, this.swept = live.stops_curve({...body, from: 0.25, to: 2, points: 45}).curve;
    const answer = live.stops({...body, frequency: s.frequency, duration: 60}), cm = values => values.map(v => v * 100);
    this.stroke = answer.sudden * 100;
    this.curve.clear(), this.time.clear();
    const {curve, time, swept} = this;
    curve.line([0.25, 2], [2.54, 2.54], "red", {"stroke-dasharray": "2 4"});
    curve.line(swept.frequency, cm(swept.linear), "soft", {"stroke-dasharray": "5 4"});
    curve.line(swept.frequency, cm(swept.up), "curve-2");
    curve.line(swept.frequency, cm(swept.down), "curve-1");
    curve.dot(s.frequency, answer.slow * 100, "curve-1", 5);
    time.line(answer.motion.t, cm(answer.motion.sudden), "curve-2", {"stroke-width": 1.1});
    time.line(answer.motion.t, cm(answer.motion.slow), "curve-1", {"stroke-width": 1.1});
    for (const gap of [0.6 * 2.54, -0.6 * 2.54]) time.line([0, 60], [gap, gap], "soft", {"stroke-dasharray": "3 3"});
    const left = live.allowance({speed: s.posted / 3.6, body_mass: s.mass});
    this.allowed.clear();
    this.allowed.line([0.5, 1000], [1.6, 1.6], "soft", {"stroke-dasharray": "4 4"});
    this.allowed.line(left.allowed.wavelength, cm(left.allowed.amplitude), "curve-3");
    figure.says([["sudden start", `${short(answer.sudden * 100)} cm`], ["slow start", `${short(answer.slow * 100)} cm`], ["without stops", `${short(answer.linear * 100)} cm`],
      [`at ${short(s.posted)} km/h posted`, `one amplitude for waves from ${short(left.from)} to ${short(left.until)} m`], ["so", answer.sudden > 1.05 * answer.slow ? "two motions at one speed: the start decides" : "one motion, however the wave begins"]]);
  },
});
