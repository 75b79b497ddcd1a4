// Chapter 2: push the car at a speed, and see whether it runs straight again, hunts, or leaves the table of its profiles.
"use strict";

railbookFigure("hunting", {
  hint: "Drag the point to the right, past the critical speed: the car no longer runs straight again after a push, but hunts or derails. Farther up, the push is larger.",
  columns: 3,
  state: {
    speed: {unit: "ft/s", si: 0.3048, value: 130, low: 60, high: 230, step: 1, label: "speed"},
    push: {unit: "in", si: 0.0254, value: 0.2, low: 0, high: 0.6, step: 0.01, label: "push of both trucks aside"},
    aside: {unit: "in", si: 0.0254, value: 0, low: -0.7, high: 0.7, step: 0.01, label: "a wheelset aside, to the left"},
    full: {unit: "", si: 1, value: 0, low: 0, high: 1, step: 1, label: "limit cycles"},
    wheels: {unit: "", si: 1, value: 0, low: 0, high: 2, step: 1, label: "wheels and rails (all three are ours)"},
  },

  build(figure) {
    this.plane = figure.plot("How far a car hunts", [60, 230, "speed, ft/s"], [0, 0.75, "amplitude of a wheelset, in"],
      {key: [["dashed: unstable", "curve-1"], ["critical speed", "curve-2"], ["full equations", "curve-4"], ["this car", "curve-3"]]});
    this.time = figure.plot("After the push", [0, 6, "time, s"], [-0.75, 0.75, "displacement, in"], {key: [["front truck", "curve-1"], ["rear truck", "curve-2"], ["body", "soft"]]});
    this.circle = figure.plot("Does a disturbance of the cycle die out?", [-1.9, 1.9, "real part"], [-1.25, 1.25, "imaginary part"], {equal: 1, key: [["multipliers of half a period", "curve-4"]]});
    this.plan = figure.plot("The car from above, sideways 40 times", [-24, 24, ""], [-6, 6, ""], {height: 130, bare: true, across: 2, key: [["front", "curve-1"], ["rear", "curve-2"], ["body", "soft"]]});
    this.pair = figure.plot("Drag the wheel: the left one on its rail", [27, 33, "from the middle of the track, in"], [-1.3, 1, "height, in"], {equal: 1, key: [["wheel", "curve-1"], ["rail", "soft"], ["contact", "curve-2"]]});
    for (const key of ["speed", "push", "aside"]) figure.slider(key);
    figure.choice("full", ["by describing functions", "and by the full equations (a second, once)"]);
    figure.choice("wheels", ["new wheels on worn rails", "CN profile A on new rails", "modified Heumann on worn rails"]);
    figure.handle(this.pair, {x: "aside", label: "wheelset aside", place: s => [30.5 + s.aside, 0.7], grip: x => ({aside: x - 30.5}), whole: true});
    figure.handle(this.plane, {x: "speed", y: "push", label: "speed and push", place: s => [s.speed, s.push]});
  },

  show(figure, live, s) {
    const {short} = railbookFigure, foot = 0.3048, inch = foot / 12;
    this.branches ??= [];
    const branch = this.branches[s.wheels] ??= live.branch({wheels: s.wheels}).points;
    const critical = (this.critical ??= [])[s.wheels] ??= live.critical({wheels: s.wheels}).speeds;
    const answer = live.hunting({speed: s.speed * foot, front: s.push * inch, rear: s.push * inch, wheels: s.wheels, duration: 6, step: 0.02}), {motion} = answer;
    const full = s.full > 0 ? live.cycle({wheels: s.wheels, speed: s.speed * foot}) : null;
    this.plane.clear(), this.time.clear();
    if (full) this.plane.line(full.branch.speed.map(v => v / foot), full.branch.amplitude.map(a => a / inch), "curve-4");
    // Runs of the branch that this method calls stable are full lines.
    for (let i = 0, from = 0; i <= branch.speed.length; i++)
      if (i === branch.speed.length || branch.stable[i] !== branch.stable[from]) {
        this.plane.line(branch.speed.slice(from, i + 1).map(v => v / foot), branch.amplitude.slice(from, i + 1).map(a => a / inch), "curve-1", branch.stable[from] ? {} : {"stroke-dasharray": "5 4"});
        from = i;
      }
    this.plane.dot(critical.speed[0] / foot, 0, "curve-2", 6);
    const first = critical.speed[0] / foot, right = first < 120;
    this.plane.label(first + (right ? 6 : -6), 0.03, `${short(first, 4)} ft/s`, "curve-2", right ? "start" : "end");
    if (answer.settled) this.plane.dot(s.speed, answer.amplitude / inch, "curve-3", 6);
    this.time.line(motion.t, motion.w1.map(x => x / inch), "curve-1", {"stroke-width": 1.4});
    this.time.line(motion.t, motion.w3.map(x => x / inch), "curve-2", {"stroke-width": 1.4});
    this.time.line(motion.t, motion.body.map(x => x / inch), "soft", {"stroke-width": 1.4});
    const end = ["", `leaves the profiles' table after ${short(answer.t_end)} s: derailed`, "stalled"][answer.end]
      || (answer.settled ? "hunts on a limit cycle" : answer.amplitude < s.push * inch ? "dies out" : "is still growing after 6 s");
    this.stability(full);
    const at = this.stand(live, s), degree = Math.PI / 180;
    figure.says([["the motion", end], ["amplitude of the last periods", Number.isFinite(answer.amplitude) ? `${short(answer.amplitude / inch)} in at ${short(answer.omega)} rad/s` : "none: the motion ends before"],
      ["critical speeds (small motions grow)", [...critical.speed].map(v => short(v / foot, 4)).join(" and ") + " ft/s"],
      ...(full ? [["cycle by the full equations", full.found ? `${short(full.amplitude / inch)} in at ${short(full.omega)} rad/s, ${full.stable ? "stable" : "unstable"}; largest multiplier ${short(full.largest)}` : "none at this speed on this branch"]] : []),
      ["the wheelset aside rolls on", `radii of ${short(at.left_radius / inch, 5)} (left) and ${short(at.right_radius / inch, 5)} in, at contact angles of ${short(at.left_angle / degree)}° and ${short(at.right_angle / degree)}°`]]);
    this.play(figure, motion);
  },

  // The multipliers of the cycle, and the circle in which all are if it is stable.
  stability(full) {
    const turn = Array.from({length: 73}, (_, i) => i * Math.PI / 36), {circle} = this;
    circle.clear();
    circle.line(turn.map(Math.cos), turn.map(Math.sin), "soft", {"stroke-width": 1.3});
    if (!full?.found) return (full ? ["no cycle"] : ["choose the full", "equations below"]).forEach((line, i) => circle.label(0, 0.15 - 0.4 * i, line, "soft", "middle"));
    full.largest = Math.max(...full.multipliers.real.map((x, i) => Math.hypot(x, full.multipliers.imaginary[i])));
    full.multipliers.real.forEach((x, i) => circle.dot(x, full.multipliers.imaginary[i], "curve-4", 5));
  },

  // The wheelset moved aside: where its left wheel touches, and what both wheels roll on.
  stand(live, s) {
    const inch = 0.0254, profiles = (this.profiles ??= [])[s.wheels] ??= live.profiles({wheels: s.wheels});
    const at = live.wheelset({wheels: s.wheels, x: s.aside * inch}), {wheel, rail} = profiles, pair = this.pair;
    pair.clear();
    const inches = values => values.map(v => v / inch), across = inches(rail.y), head = inches(rail.z);
    const filled = (x, y, beyond, colour) => pair.area([...x, x[x.length - 1], x[0]], [...y, beyond, beyond], colour, 0.12);
    filled(across, head, -3, "soft");
    pair.line(across, head, "soft");
    const rim = [wheel.y.map((y, i) => (y + s.aside * inch - at.roll * (wheel.z[i] - profiles.height)) / inch), wheel.z.map((z, i) => (at.height + z - profiles.height + at.roll * wheel.y[i]) / inch)];
    filled(...rim, 3, "curve-1");
    pair.line(...rim, "curve-1");
    pair.dot(at.left_y / inch, at.left_z / inch, "curve-2", 5);
    return at;
  },

  // Plan view: the motion in its own time, again and again.
  play(figure, motion) {
    const L = 16.9, l = 2.833, a = 2.48, wide = 40 / 0.3048, p = this.plan; // ft; what is sideways is drawn 40 times
    figure.animate(seconds => {
      const i = Math.floor(seconds * 50) % motion.t.length;
      p.clear();
      for (const y of [a, -a]) p.line([-24, 24], [y, y], "rule");
      const box = (at, y, yaw, u, v, colour) => {
        const points = [[u, v], [-u, v], [-u, -v], [u, -v], [u, v]].map(([c, d]) => [at + c * Math.cos(yaw) - d * Math.sin(yaw), y + c * Math.sin(yaw) + d * Math.cos(yaw)]);
        p.area(points.map(q => q[0]), points.map(q => q[1]), colour, 0.15, {stroke: `var(--${colour})`, "stroke-width": 2});
      };
      const turned = (yaw, most) => Math.max(-most, Math.min(most, yaw * 40));
      box(0, motion.body[i] * wide, turned(motion.body_yaw[i], 0.5), 19, 1.6, "soft");
      [["w1", L + l], ["w2", L - l], ["w3", -L + l], ["w4", -L - l]].forEach(([w, at], k) =>
        box(at, motion[w][i] * wide, turned(motion[`yaw${k + 1}`][i], 0.6), 0.35, a, k < 2 ? "curve-1" : "curve-2"));
      p.label(23.5, -5.6, "forward →", "soft", "end");
    });
  },
});
