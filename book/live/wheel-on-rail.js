// Chapter 8: shift the wheelset, and the patches move from the tread to the flange.
"use strict";

railbookFigure("wheel-on-rail", {
  hint: "Drag the wheel sideways (or press the arrow keys). At 10 kN it stands on two patches near 5 mm, and beyond on its flange.",
  coarsens: "on 16 x 16 cells while it moves",
  state: {
    shift: {unit: "mm", si: 1e-3, value: 3, low: -5, high: 6.5, step: 0.1, label: "shift to the right"},
    yaw: {unit: "mrad", si: 1e-3, value: 0, low: -15, high: 15, step: 0.5, label: "yaw"},
    load: {unit: "kN", si: 1e3, value: 10, low: 5, high: 150, step: 1, label: "wheel load"},
  },

  build(figure) {
    this.section = figure.plot("Right wheel on its rail", [700, 800, "across the track, mm"], [-26, 14, "height, mm"], {equal: 1, key: [["wheel", "curve-1"], ["rail", "curve-7"], ["forces", "curve-2"]]});
    this.patches = figure.plot("Patches from above, largest pressure darkest", [710, 770, "across the track, mm"], [-12, 12, "along, mm"], {equal: 1});
    for (const key of ["shift", "yaw", "load"]) figure.slider(key);
    figure.handle(this.section, {x: "shift", label: "shift of the wheelset", place: s => [775 + s.shift, 8], grip: x => ({shift: x - 775}), whole: true});
  },

  show(figure, live, s) {
    const {short} = railbookFigure, mm = 1e3;
    const answer = live.wheel_on_rail({shift: s.shift / mm, yaw: s.yaw / mm, load: s.load * 1e3, cells: figure.coarse ? 16 : 20});
    const {section, patches} = this, {cells} = answer;
    section.clear(), patches.clear();
    const up = z => z.map(v => -v * mm), out = y => y.map(v => v * mm);
    for (const [{y, z}, colour, beyond] of [[answer.rail, "curve-7", -60], [answer.wheel, "curve-1", 60]]) {
      const across = out(y);
      section.area([...across, across[across.length - 1], across[0]], [...up(z), beyond, beyond], colour, 0.12);
      section.line(across, up(z), colour);
    }
    answer.patches.y.forEach((y, k) => {
      const z = answer.patches.z[k], angle = answer.patches.angle[k], length = answer.patches.load[k] / (s.load * 1e3) * 9;
      section.line([y * mm, y * mm + length * Math.sin(angle)], [-z * mm, -z * mm - length * Math.cos(angle)], "curve-2", {"stroke-width": 4});
    });
    const most = Math.max(...cells.p);
    cells.p.forEach((p, i) => patches.cell(cells.y[i] * mm, cells.along[i] * mm, cells.d_across[i] * mm, cells.d_along[i] * mm, "var(--curve-2)",
      {"fill-opacity": (0.1 + 0.9 * p / most).toFixed(2)}));
    figure.says(Array.from(answer.patches.load, (load, k) => [`patch ${k + 1}`, `${short(load / 1e3)} kN, largest pressure ${short(answer.patches.p_max[k] / 1e6)} MPa, ` +
      `${short(answer.patches.area[k] * 1e6)} mm², at an angle of ${short(answer.patches.angle[k] * -180 / Math.PI, 2)}°`])
      .concat([["force on the rail", `${short(answer.force_x / 1e3)} kN along, ${short(answer.force_y / 1e3)} kN to the right`]]));
  },
});
