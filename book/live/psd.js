// Chapter 5: make a track, measure a length of it, and see how sure its class is.
"use strict";

railbookFigure("psd", {
  hint: "Press “Another stretch” a few times: one mile of the same track gives another spectrum, and sometimes another class. Then make it longer.",
  columns: 3,
  state: {
    roughness: {unit: "in log₁₀ of m²·cycle/m", si: 1, value: -6.3, low: -8, high: -5, step: 0.05, label: "roughness A"},
    dip: {unit: "mm", si: 1e-3, value: 11, low: 0, high: 30, step: 0.5, label: "dip B of the joints, as printed"},
    scatter: {unit: "%", si: 0.01, value: 0, low: 0, high: 100, step: 5, label: "scatter of the dips"},
    length: {unit: "miles", si: 1609.344, value: 1, low: 0.5, high: 16, step: 0.5, label: "length measured"},
    seed: {unit: "", si: 1, value: 1, low: 1, high: 9999, step: 1, label: "stretch"},
  },

  build(figure) {
    this.rail = figure.plot("Height of the rail, the first 400 ft", [0, 120, "along, m"], [-40, 40, "height, mm"]);
    this.spectrum = figure.plot("Spectrum with its error band", [0.01, 1.4, "wavenumber, cycle/m"], [1e-9, 1e-1, "density, m²/(cycle/m)"], {log: true, key: [["measured", "curve-1"], ["fit", "curve-2"], ["truth without joints (dashed)", "curve-7"]]});
    this.odds = figure.plot("Chance of each class, from this stretch", [-0.6, 6.6, "class (0: none)"], [0, 1.05, "probability"], {key: [["true class", "curve-3"], ["others", "curve-2"]]});
    figure.button("Another stretch", () => figure.set({seed: figure.state.seed % 9999 + 1}));
    for (const key of ["roughness", "dip", "scatter", "length"]) figure.slider(key);
    figure.handle(this.spectrum, {y: "roughness", label: "roughness A", place: s => [0.02, 10 ** s.roughness / 0.02 ** 2], grip: (_, y) => ({roughness: Math.log10(y * 0.02 ** 2)})});
  },

  show(figure, live, s) {
    const {short} = railbookFigure;
    const answer = live.track({A: 10 ** s.roughness, dip: s.dip / 1e3, scatter: s.scatter / 100, length: s.length * 1609.344, seed: s.seed});
    const {rail, spectrum, odds} = this, t = answer.spectrum;
    for (const plot of [rail, spectrum, odds]) plot.clear();
    rail.range([[-40, 40], [-100, 100], [-300, 300], [-1000, 1000], [-3000, 3000]], answer.record.z.map(z => z * 1e3));
    rail.line(answer.record.x, answer.record.z.map(z => z * 1e3), "curve-1", {"stroke-width": 1.4});
    const band = [...t.phi].map((x, i) => [x, t.high[i]]).concat([...t.phi].map((x, i) => [x, t.low[i]]).reverse());
    spectrum.put("polygon", {points: band.map(([x, y]) => `${spectrum.x(x).toFixed(1)},${spectrum.y(y).toFixed(1)}`).join(" "), fill: "var(--curve-1)", "fill-opacity": 0.2});
    spectrum.line(t.phi, t.density, "curve-1", {"stroke-width": 1.4});
    spectrum.line(t.phi, t.truth, "curve-7", {"stroke-dasharray": "5 4"});
    spectrum.line(t.phi, t.fit, "curve-2");
    answer.odds.class.forEach((m, k) => {
      odds.cell(m, answer.odds.probability[k] / 2, 0.7, answer.odds.probability[k], m === answer.true_class ? "var(--curve-3)" : "var(--curve-2)");
    });
    figure.says([["read off this stretch", `A = ${short(answer.A)} ± ${short(answer.A_error, 2)} m²·cycle/m, B = ${short(answer.dip * 1e3)} ± ${short(answer.dip_error * 1e3, 2)} mm`],
      ["class", `${answer.class || "none"} by this stretch, ${answer.true_class || "none"} in truth`], ["averages", short(answer.averages)]]);
  },
});
