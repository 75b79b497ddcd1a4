// Chapter 3: a wheel that is held back creeps, and what sticks gives way from the trailing edge on.
"use strict";

railbookFigure("creep", {
  hint: "Drag the point along the curve: the more the wheel creeps, the less of its contact sticks. Then add spin.",
  coarsens: "on fewer cells while it moves",
  state: {
    creep: {unit: "‰", si: 1e-3, value: 1.5, low: 0, high: 8, step: 0.05, label: "longitudinal creepage"},
    lateral: {unit: "‰", si: 1e-3, value: 0, low: -6, high: 6, step: 0.1, label: "lateral creepage"},
    spin: {unit: "1/m", si: 1, value: 0, low: -25, high: 25, step: 0.5, label: "spin"},
    theory: {unit: "", si: 1, value: 1, low: 0, high: 1, step: 1, label: "theory"},
  },

  build(figure) {
    this.curve = figure.plot("Force on the friction limit", [0, 8, "longitudinal creepage, ‰"], [0, 1.05, "force along over friction limit"]);
    this.patch = figure.plot("Contact, rolling to the right; arrows are tractions", [-1.65, 1.65, "along rolling, mm"], [-1.05, 1.05, "across, mm"], {equal: 1, key: [["sticks", "curve-1"], ["slides", "curve-2"]]});
    for (const key of ["creep", "lateral", "spin"]) figure.slider(key);
    figure.choice("theory", ["FASTSIM", "full theory"]);
    figure.handle(this.curve, {x: "creep", label: "longitudinal creepage", place: s => [s.creep, this.share ?? 0]});
  },

  show(figure, live, s) {
    const short = v => railbookFigure.short(Math.abs(v) < 1e-9 ? 0 : v); // rounding
    const common = {theory: s.theory, lateral: s.lateral / 1e3, spin: s.spin};
    const kind = JSON.stringify(common);
    if (this.kind !== kind) {
      this.kind = kind;
      this.drawn = live.creep_curve({...common, to: 0.68, points: 24, along: 14, rows: 9}).curve;
    }
    this.curve.clear(), this.patch.clear();
    this.curve.line(this.drawn.creep.map(v => v * 1e3), this.drawn.fx, "curve-1");
    const answer = live.rolling({...common, creep: s.creep / 1e3, along: figure.coarse ? 14 : 20, rows: figure.coarse ? 9 : 13}), {cells} = answer;
    this.share = answer.fx / answer.limit;
    const most = Math.max(...cells.bound);
    cells.x.forEach((x, i) => this.patch.cell(x * 1e3, cells.y[i] * 1e3, cells.dx[i] * 1e3, cells.dy[i] * 1e3, cells.stick[i] > 0 ? "var(--curve-1)" : "var(--curve-2)", {"fill-opacity": 0.3, stroke: "var(--paper)", "stroke-width": 0.5}));
    cells.x.forEach((x, i) => { // an arrow in every other cell
      if (i % 2) return;
      const from = [x * 1e3, cells.y[i] * 1e3], to = [from[0] + 0.22 * cells.px[i] / most, from[1] + 0.22 * cells.py[i] / most];
      this.patch.line([from[0], to[0]], [from[1], to[1]], "text", {"stroke-width": 1.2});
      this.patch.dot(...to, "text", 1.6);
    });
    figure.says([["along rolling", `${short(100 * this.share)} % of the friction limit`], ["across", `${short(100 * answer.fy / answer.limit)} %`],
      ["area that sticks", `${short(100 * answer.stick_share)} %`], ["dimensionless creep X", short(answer.reduced)]]);
  },
});
