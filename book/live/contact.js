// Chapter 1: roll the wheel across the rail, over the place where the radius of the rail's top changes.
"use strict";

railbookFigure("contact", {
  hint: "Drag the wheel across the rail. On the crown and on the corner Hertz's ellipse is right; in between it is not.",
  coarsens: "on 32 x 32 cells while it moves",
  state: {
    place: {unit: "mm", si: 1e-3, value: 0, low: -25, high: 8, step: 0.25, label: "place of first touch"},
    approach: {unit: "µm", si: 1e-6, value: 127, low: 10, high: 250, step: 1, label: "approach"},
    step: {unit: "", si: 1, value: 0, low: 0, high: 20, step: 1, label: "COUNTACT, iteration (0: CG-FFT)"},
  },

  build(figure) {
    this.section = figure.plot("Wheel and rail in section, heights 3 times", [-40, 30, "across the rail, mm"], [-7, 3, "height, mm"], {equal: 3, key: [["wheel", "curve-1"], ["rail: crown, 10 in, and corner, 1.25 in", "curve-7"]]});
    this.patch = figure.plot("Pressure on the contact from above", [-40, 20, "across the rail, mm"], [-15, 15, "along, mm"], {equal: 1, key: [["computed", "curve-2"], ["Hertz, right", "curve-3"], ["Hertz, wrong (dashed)", "soft"]]});
    figure.button("Play COUNTACT's iteration", () => this.play(figure));
    for (const key of ["place", "approach", "step"]) figure.slider(key);
    figure.handle(this.section, {x: "place", label: "place of first touch", place: s => [s.place, 1.7], whole: true});
  },

  // From the interpenetration curve inwards, one iteration after the other, and the other method's answer at the end.
  play(figure) {
    clearTimeout(this.next);
    const go = k => {
      figure.set({step: k});
      if (k > 0) this.next = setTimeout(() => go(k < (this.iterations ?? 20) ? k + 1 : 0), k === 1 || k === this.iterations ? 1500 : 400);
    };
    go(1);
  },

  show(figure, live, s) {
    const {short} = railbookFigure, mm = 1e3;
    const inputs = {place: s.place / mm, approach: s.approach * 1e-6}, cellsAlong = figure.coarse ? 32 : 48;
    const answer = live.contact({...inputs, cells: cellsAlong}), x0 = s.place;
    this.section.clear(), this.patch.clear();
    // The section comes with its plane level at first touch; on the crown that plane leans.
    const across = answer.section.x.map(x => x * mm + x0), ends = [across[across.length - 1], across[0]];
    for (const [z, colour, beyond] of [[answer.section.rail, "curve-7", -90], [answer.section.wheel, "curve-1", 90]]) {
      this.section.area([...across, ...ends], [...z.map(v => v * mm), beyond, beyond], colour, 0.12);
      this.section.line(across, z.map(v => v * mm), colour);
    }
    this.section.line([0, 0], [-9, 3], "soft", {"stroke-dasharray": "4 4", "stroke-width": 1});
    this.section.label(-1, -6.3, "crown", "soft", "end");
    this.section.label(1, -6.3, "corner", "soft");
    let {cells} = answer, from = answer;
    if (s.step > 0) {
      from = live.countact(inputs);
      this.iterations = from.iterations;
      const k = Math.min(s.step, from.iterations) - 1, own = i => from.cells.iteration[i] === k;
      const pick = name => from.cells[name].filter((_, i) => own(i));
      cells = {x: pick("x"), y: pick("y"), dx: pick("dx"), dy: pick("dy"), p: pick("p")};
      const o = from.outlines;
      const low = [], high = [];
      o.iteration.forEach((n, i) => { if (n === 0) low.push((o.left[i] + o.right[i]) / 2 * mm + x0), high.push(o.half[i] * mm); });
      for (const sign of [1, -1]) this.patch.line(low, high.map(v => sign * v), "soft", {"stroke-dasharray": "2 3"});
    }
    const most = Math.max(...cells.p, 1);
    cells.p.forEach((p, i) => {
      const fill = p >= 0 ? "var(--curve-2)" : "var(--curve-1)", more = {"fill-opacity": Math.min(1, 0.06 + 0.94 * Math.abs(p) / most).toFixed(2)};
      for (const sign of s.step > 0 && cells.y[i] > 1e-9 ? [1, -1] : [1])
        this.patch.cell(cells.x[i] * mm + x0, sign * cells.y[i] * mm, cells.dx[i] * mm, cells.dy[i] * mm, fill, more);
    });
    const turn = Array.from({length: 73}, (_, i) => i * Math.PI / 36);
    this.patch.line(turn.map(t => x0 + answer.hertz_a * mm * Math.cos(t)), turn.map(t => answer.hertz_b * mm * Math.sin(t)), answer.hertz ? "curve-3" : "soft", answer.hertz ? {} : {"stroke-dasharray": "6 4"});
    this.patch.line([0, 0], [-15, 15], "soft", {"stroke-dasharray": "4 4", "stroke-width": 1});
    figure.says([["force", `${short(answer.force / 1e3, 4)} kN; by Hertz's ellipse at this place ${short(answer.hertz_force / 1e3, 4)} kN`],
      ["largest pressure", `${short(answer.p_max / 1e6, 4)} MPa; by Hertz ${short(answer.hertz_p_max / 1e6, 4)} MPa`],
      ["Hertz's ellipse", answer.hertz ? "stays on one radius of the rail: it is exact" : "reaches over the change of radius: it is wrong"],
      ...(s.step > 0 ? [["COUNTACT", `iteration ${Math.min(s.step, from.iterations)} of ${from.iterations}: ${short(from.steps.force[Math.min(s.step, from.iterations) - 1] / 1e3, 4)} kN; blue cells pull and will leave`]] : [])]);
  },
});
