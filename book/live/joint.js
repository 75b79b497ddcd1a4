// Chapter 7: a wheel runs over a low joint.
"use strict";

railbookFigure("joint", {
  hint: "Drag the point: faster to the right, a deeper joint upwards. P1 is the blow of the rail alone, P2 that of the whole track.",
  columns: 2,
  state: {
    speed: {unit: "mph", si: 0.44704, value: 60, low: 10, high: 120, step: 1, label: "speed"},
    dip: {unit: "in", si: 0.0254, value: 0.5, low: 0, high: 0.7, step: 0.01, label: "dip of the joint"},
    wheel: {unit: "kg", si: 1, value: 650, low: 200, high: 1500, step: 10, label: "unsprung mass"},
    pad: {unit: "times typical", si: 1, value: 1, low: 0.1, high: 4, step: 0.1, label: "stiffness between rail and tie"},
    damping: {unit: "of critical", si: 1, value: 0.05, low: 0, high: 1, step: 0.05, label: "damping there"},
  },

  build(figure) {
    this.choose = figure.plot("Choose the passage", [10, 120, "speed, mph"], [0, 0.7, "dip, in"], {height: 265, key: [["dashed: equal speed × dip", "soft"]]});
    this.bodies = figure.plot("In slow motion, displacements 60 times", [-1.8, 1.8, ""], [-1.02, 0.82, ""], {equal: 1, bare: true, key: [["the rail is drawn without its dip", "soft"]]});
    this.force = figure.plot("Force between wheel and rail", [-2, 16, "time from the joint, ms"], [0, 350, "force, kN"], {height: 205, key: [["dashed: the static load", "soft"]]});
    this.motion = figure.plot("Motions, down positive", [-2, 16, "time from the joint, ms"], [1.6, -0.2, "displacement, mm"],
      {height: 205, key: [["wheel, less the rail's shape", "curve-1"], ["rail", "curve-2"], ["tie and bed", "curve-3"]]});
    for (const key of ["speed", "dip", "wheel", "pad", "damping"]) figure.slider(key);
    figure.handle(this.choose, {x: "speed", y: "dip", label: "speed and dip", place: s => [s.speed, s.dip]});
  },

  show(figure, live, s) {
    const {short} = railbookFigure, kN = 1e-3;
    const answer = live.joint({speed: s.speed * 0.44704, dip: s.dip * 0.0254, wheel_mass: s.wheel, pad: s.pad, pad_damping: s.damping});
    const {passage} = answer, ms = passage.t.map(t => t * 1e3);
    for (const plot of [this.choose, this.force, this.motion]) plot.clear();
    const product = s.speed * s.dip, places = Array.from({length: 56}, (_, i) => 10 + 2 * i);
    this.choose.line(places, places.map(v => product / v), "soft", {"stroke-dasharray": "4 4"});
    const seen = passage.t.findLastIndex(t => t <= 0.016) + 1, mm = name => passage[name].slice(0, seen).map(v => v * 1e3);
    this.force.range([[0, 350], [0, 700], [0, 1400]], passage.force.slice(0, seen).map(f => f * kN));
    this.motion.range([[1.6, -0.2], [4, -0.5], [8, -1], [16, -2]], mm("rail"), mm("bed"));
    this.force.line(ms, passage.force.map(f => f * kN), "curve-1");
    this.force.line([-2, 16], [answer.static * kN, answer.static * kN], "soft", {"stroke-dasharray": "4 4"});
    for (const [name, t, f] of [["P1", answer.p1_time, answer.p1], ["P2", answer.p2_time, answer.p2]])
      if (Number.isFinite(f)) this.force.dot(t * 1e3, f * kN, "curve-2"), this.force.label(t * 1e3, name === "P1" ? Math.min(f * kN + 14, 0.94 * this.force.y1) : 0.06 * this.force.y1, name, "curve-2", name === "P1" ? "end" : "middle");
    if (Number.isFinite(answer.p2)) this.force.line([answer.p2_time * 1e3, answer.p2_time * 1e3], [0.13 * this.force.y1, answer.p2 * kN], "curve-2", {"stroke-width": 1, "stroke-dasharray": "2 3"});
    // The wheel without the shape of the rail under it: where it is above the rail by more than the static approach, it flies.
    const wheel = passage.wheel.map((w, i) => w - passage.surface[i]);
    [[wheel, "curve-1"], [passage.rail, "curve-2"], [passage.bed, "curve-3"]].forEach(([y, colour]) => this.motion.line(ms, y.map(v => v * 1e3), colour));
    figure.says([["P1", `${short(answer.p1 * kN, 4)} kN at ${short(answer.p1_time * 1e3)} ms`], ["P2 (mean over one period)", `${short(answer.p2 * kN, 4)} kN at ${short(answer.p2_time * 1e3)} ms`],
      ["static load", `${short(answer.static * kN, 4)} kN; the wheel ${answer.lost > 0 ? `is off the rail for ${short(answer.lost * 1e3)} ms` : "never leaves the rail"}`],
      ["natural frequencies", `${short(answer.frequency_1)}, ${short(answer.frequency_2)} and ${short(answer.frequency_3)} Hz`]]);
    this.play(figure, passage, s.speed * 0.44704);
  },

  // What moves, in metres: the rail with its joint runs past below the wheel, and wheel, rail and tie sink by 60 times their motion.
  play(figure, passage, speed) {
    const p = this.bodies, larger = 60, last = passage.t.findLastIndex(t => t <= 0.016);
    const turn = Array.from({length: 49}, (_, i) => i * Math.PI / 24);
    figure.animate((seconds, still) => {
      const i = still ? passage.force.indexOf(Math.max(...passage.force)) : Math.floor((seconds / 18) % 1 * last);
      const [wheel, rail, bed] = ["wheel", "rail", "bed"].map(name => -larger * passage[name][i]), run = speed * passage.t[i];
      p.clear();
      const box = (x0, x1, y0, y1, colour, share) => p.area([x0, x1, x1, x0], [y0, y0, y1, y1], colour, share, {stroke: `var(--${colour})`});
      box(-1.8, 1.8, -1.02, -0.9, "curve-5", 0.15);
      for (let x = -1.4; x < 1.5; x += 0.7) box(x - 0.14, x + 0.14, -0.72 + bed, -0.5 + bed, "curve-3", 0.3);
      for (let x = -1.4; x < 1.5; x += 0.7)
        for (const [from, to] of [[-0.9, -0.72 + bed], [-0.5 + bed, -0.34 + rail]]) {
          const n = 7; // the springs between
          p.line(Array.from({length: n + 1}, (_, k) => x + (k === 0 || k === n ? 0 : k % 2 ? 0.05 : -0.05)), Array.from({length: n + 1}, (_, k) => from + (to - from) * k / n), "soft", {"stroke-width": 1.3});
        }
      const joint = -run; // runs away backwards below the wheel
      for (const [x0, x1] of [[-1.8, joint - 0.01], [joint + 0.01, 1.8]])
        if (x1 > x0) box(Math.max(-1.8, x0), Math.min(1.8, x1), -0.34 + rail, -0.18 + rail, "curve-2", 0.3);
      p.area(turn.map(t => 0.46 * Math.cos(t)), turn.map(t => -0.18 + 0.46 + wheel + larger * passage.surface[i] + 0.46 * Math.sin(t)), "curve-1", 0.2, {stroke: "var(--curve-1)"});
      p.label(0.55, 0.5, `${(passage.t[i] * 1e3).toFixed(1).replace("-", "−")} ms: ${(passage.force[i] / 1e3).toFixed(0)} kN`, "text");
      p.label(joint + 0.03, -0.02, Math.abs(joint) < 1.4 ? "joint" : "", "curve-2");
    });
  },
});
