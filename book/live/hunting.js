// Chapter 2: push the car at a speed, and see whether it runs straight again, hunts, or leaves the table of its profiles.
"use strict";

railbookFigure("hunting", {
  hint: "Drag the point: to the right the car is faster, upwards it is pushed farther aside. Left of the first critical speed (dot) small pushes die out; right of it they grow to a limit cycle, or derail the car.",
  state: {
    speed: {unit: "ft/s", si: 0.3048, value: 150, low: 60, high: 230, step: 1, label: "speed"},
    push: {unit: "in", si: 0.0254, value: 0.2, low: 0, high: 0.6, step: 0.01, label: "push of both trucks aside"},
    aside: {unit: "in", si: 0.0254, value: 0, low: -0.7, high: 0.7, step: 0.01, label: "a wheelset aside, to the left"},
    wheels: {unit: "", si: 1, value: 0, low: 0, high: 2, step: 1, label: "wheels and rails (all three are ours)"},
  },

  build(figure) {
    this.plane = figure.plot("Limit cycles, by describing functions", [60, 230, "speed, ft/s"], [0, 0.75, "amplitude of a wheelset, in"]);
    this.time = figure.plot("After the push", [0, 6, "time, s"], [-0.75, 0.75, "displacement, in"]);
    this.plan = figure.plot("The car from above, sideways 40 times", [-24, 24, ""], [-6, 6, ""], {height: 180, bare: true});
    this.pair = figure.plot("Its left wheel on the rail", [27, 33, "from the middle of the track, in"], [-1.6, 0.9, "height, in"]);
    for (const key of ["speed", "push", "aside"]) figure.slider(key);
    figure.choice("wheels", ["new wheels on worn rails", "CN profile A on new rails", "modified Heumann on worn rails"]);
    figure.handle(this.pair, {x: "aside", label: "wheelset aside", place: s => [30.5 + s.aside, 0.6], grip: x => ({aside: x - 30.5})});
    figure.handle(this.plane, {x: "speed", y: "push", label: "speed and push", place: s => [s.speed, s.push]});
  },

  show(figure, live, s) {
    const {short} = railbookFigure, foot = 0.3048, inch = foot / 12;
    this.branches ??= [];
    const branch = this.branches[s.wheels] ??= live.branch({wheels: s.wheels}).points;
    const critical = live.critical({wheels: s.wheels}).speeds;
    const answer = live.hunting({speed: s.speed * foot, front: s.push * inch, rear: s.push * inch, wheels: s.wheels, duration: 6, step: 0.02}), {motion} = answer;
    this.plane.clear(), this.time.clear();
    // Runs of the branch that this method calls stable are full lines.
    for (let i = 0, from = 0; i <= branch.speed.length; i++)
      if (i === branch.speed.length || branch.stable[i] !== branch.stable[from]) {
        this.plane.line(branch.speed.slice(from, i + 1).map(v => v / foot), branch.amplitude.slice(from, i + 1).map(a => a / inch), "curve-1", branch.stable[from] ? {} : {"stroke-dasharray": "5 4"});
        from = i;
      }
    this.plane.dot(critical.speed[0] / foot, 0, "curve-2", 5);
    if (answer.settled) this.plane.dot(s.speed, answer.amplitude / inch, "curve-3", 6);
    this.time.line(motion.t, motion.w1.map(x => x / inch), "curve-1", {"stroke-width": 1.4});
    this.time.line(motion.t, motion.w3.map(x => x / inch), "curve-2", {"stroke-width": 1.4});
    this.time.line(motion.t, motion.body.map(x => x / inch), "soft", {"stroke-width": 1.4});
    [["front truck", "curve-1", 0.1], ["rear truck", "curve-2", 1.6], ["body", "soft", 3]].forEach(([name, colour, at]) => this.time.label(at, 0.66, name, colour));
    const end = ["", `leaves the profiles' table after ${short(answer.t_end)} s: derailed`, "stalled"][answer.end]
      || (answer.settled ? "hunts on a limit cycle" : answer.amplitude < s.push * inch ? "dies out" : "is still growing after 6 s");
    const at = this.stand(live, s), degree = Math.PI / 180;
    figure.says([["the motion", end], ["amplitude of the last periods", `${short(answer.amplitude / inch)} in at ${short(answer.omega)} rad/s`],
      ["critical speeds (small motions grow)", [...critical.speed].map(v => short(v / foot, 4)).join(" and ") + " ft/s"],
      ["the wheelset aside rolls on", `radii of ${short(at.left_radius / inch, 5)} (left) and ${short(at.right_radius / inch, 5)} in, at contact angles of ${short(at.left_angle / degree)}° and ${short(at.right_angle / degree)}°`]]);
    this.play(motion);
  },

  // The wheelset moved aside: where its left wheel touches, and what both wheels roll on.
  stand(live, s) {
    const inch = 0.0254, profiles = (this.profiles ??= [])[s.wheels] ??= live.profiles({wheels: s.wheels});
    const at = live.wheelset({wheels: s.wheels, x: s.aside * inch}), {wheel, rail} = profiles, pair = this.pair;
    pair.clear();
    pair.line(rail.y.map(y => y / inch), rail.z.map(z => z / inch), "soft");
    pair.line(wheel.y.map((y, i) => (y + s.aside * inch - at.roll * (wheel.z[i] - profiles.height)) / inch), wheel.z.map((z, i) => (at.height + z - profiles.height + at.roll * wheel.y[i]) / inch), "curve-1");
    pair.dot(at.left_y / inch, at.left_z / inch, "curve-2", 5);
    return at;
  },

  // Plan view: the motion in its own time, again and again; standing for who asks for less motion.
  play(motion) {
    cancelAnimationFrame(this.frame);
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches, begin = performance.now();
    const L = 16.9, l = 2.833, a = 2.48, wide = 40 / 0.3048; // ft; what is sideways is drawn 40 times
    const draw = now => {
      const i = still ? 0 : Math.floor((now - begin) / 20) % motion.t.length, p = this.plan;
      p.clear();
      for (const y of [a, -a]) p.line([-24, 24], [y, y], "rule");
      const turned = (x, y, at, yaw, u, v) => [at + u * Math.cos(yaw) - v * Math.sin(yaw) + x, y + u * Math.sin(yaw) + v * Math.cos(yaw)];
      const box = (at, y, yaw, u, v, colour) => {
        const points = [[u, v], [-u, v], [-u, -v], [u, -v], [u, v]].map(([c, d]) => turned(0, y, at, yaw, c, d));
        p.line(points.map(q => q[0]), points.map(q => q[1]), colour);
      };
      box(0, motion.body[i] * wide, Math.max(-0.5, Math.min(0.5, motion.body_yaw[i] * 40)), 19, 1.6, "soft");
      [["w1", L + l], ["w2", L - l], ["w3", -L + l], ["w4", -L - l]].forEach(([w, at], k) =>
        box(at, motion[w][i] * wide, Math.max(-0.6, Math.min(0.6, motion[`yaw${k + 1}`][i] * 40)), 0.35, a, k < 2 ? "curve-1" : "curve-2"));
      if (!still) this.frame = requestAnimationFrame(draw);
    };
    draw(begin);
  },
});
