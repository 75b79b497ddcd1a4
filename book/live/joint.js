// Chapter 7: a wheel runs over a low joint.
"use strict";

railbookFigure("joint", {
  hint: "Drag the point: faster to the right, a deeper joint upwards. P1 is the blow of the rail, P2 that of the whole track.",
  state: {
    speed: {unit: "mph", si: 0.44704, value: 60, low: 10, high: 120, step: 1, label: "speed"},
    dip: {unit: "in", si: 0.0254, value: 0.5, low: 0, high: 0.7, step: 0.01, label: "dip of the joint"},
    wheel: {unit: "kg", si: 1, value: 650, low: 200, high: 1500, step: 10, label: "unsprung mass"},
    pad: {unit: "times typical", si: 1, value: 1, low: 0.1, high: 4, step: 0.1, label: "stiffness between rail and tie"},
    damping: {unit: "of critical", si: 1, value: 0.05, low: 0, high: 1, step: 0.05, label: "damping there"},
  },

  build(figure) {
    this.choose = figure.plot("Choose the passage", [10, 120, "speed, mph"], [0, 0.7, "dip, in"], {height: 230});
    this.force = figure.plot("Force between wheel and rail", [-2, 16, "time from the joint, ms"], [0, 350, "force, kN"]);
    this.motion = figure.plot("Motions, down positive", [-2, 16, "time from the joint, ms"], [1.6, -0.6, "displacement, mm"]);
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
    this.choose.label(118, 0.62, "dashed: equal speed × dip", "soft", "end");
    this.force.line(ms, passage.force.map(f => f * kN), "curve-1");
    this.force.line([-2, 16], [answer.static * kN, answer.static * kN], "soft", {"stroke-dasharray": "4 4"});
    for (const [name, t, f] of [["P1", answer.p1_time, answer.p1], ["P2", answer.p2_time, answer.p2]])
      if (Number.isFinite(f)) this.force.dot(t * 1e3, f * kN, "curve-2"), this.force.label(t * 1e3 + 0.3, f * kN + 10, name, "curve-2");
    // The wheel without the shape of the rail under it: where it is above the rail by more than the static approach, it flies.
    const curves = {"wheel, less the rail's shape": ["curve-1", passage.wheel.map((w, i) => w - passage.surface[i])], rail: ["curve-2", passage.rail], "tie and bed": ["curve-3", passage.bed]};
    Object.entries(curves).forEach(([name, [colour, y]], k) => {
      this.motion.line(ms, y.map(v => v * 1e3), colour);
      this.motion.label([-1.7, 8, 10][k], -0.45, name, colour);
    });
    figure.says([["P1", `${short(answer.p1 * kN, 4)} kN at ${short(answer.p1_time * 1e3)} ms`], ["P2 (mean over one period)", `${short(answer.p2 * kN, 4)} kN at ${short(answer.p2_time * 1e3)} ms`],
      ["static load", `${short(answer.static * kN, 4)} kN`], ["without contact", answer.lost > 0 ? `${short(answer.lost * 1e3)} ms` : "never"],
      ["natural frequencies", `${short(answer.frequency_1)}, ${short(answer.frequency_2)} and ${short(answer.frequency_3)} Hz`]]);
  },
});
