// Chapter 4: drive the geometry car at any speed, stop it, back it up; what its gyro says raw, and through the hybrid filter.
"use strict";

const liveTimes = Array.from({length: 12}, (_, i) => `v${i}`);
railbookFigure("filters", {
  hint: "Drag the points: drive slowly over a curve, stop, go back. The raw gyro smears what it measures, the hybrid filter does not.",
  state: Object.fromEntries(liveTimes.map((key, i) => [key,
    {unit: "mph", si: 0.44704, value: [60, 60, 40, 15, 2, 0, -6, 0, 10, 30, 50, 60][i], low: -20, high: 80, step: 1, label: `speed after ${3 * i} s`}])
    .concat([["at", {unit: "mph", si: 0.44704, value: 9, low: 1, high: 120, step: 1, label: "steady speed of the gains"}]])),

  build(figure) {
    this.speed = figure.plot("Draw the speed of the car", [0, 33, "time, s"], [-20, 80, "speed, mph"], {height: 225});
    this.gains = figure.plot("What the filters keep of a wave, at a steady speed", [2, 1000, "wavelength, ft"], [0, 1.05, "gain"],
      {height: 225, logx: true, key: [["gyro, analog", "curve-2"], ["hybrid", "curve-1"], ["dashed: accelerometer", "soft"]]});
    const key = [["raw gyro", "curve-2"], ["hybrid", "curve-1"], ["truth", "soft"]];
    this.curvature = figure.plot("Curvature of the track, as measured", [0, 370, "place along the track, m"], [-6, 7, "curvature, 1/km"], {height: 225, key});
    this.error = figure.plot("Error of both", [0, 370, "place along the track, m"], [-6, 7, "error, 1/km"], {height: 225, key: key.slice(0, 2)});
    liveTimes.forEach((key, i) => figure.handle(this.speed, {y: key, label: `speed after ${3 * i} s`, place: s => [3 * i, s[key]]}));
    const drive = (text, speeds) => figure.button(text, () => figure.set(Object.fromEntries(liveTimes.map((key, i) => [key, speeds[i] ?? speeds[0]]))));
    figure.slider("at");
    drive("Even 60 mph", [60]);
    drive("Even 15 mph", [15]);
    drive("Brake, back up, go on", [60, 60, 40, 15, 2, 0, -6, 0, 10, 30, 50, 60]);
  },

  show(figure, live, s) {
    const {short} = railbookFigure;
    const answer = live.car({speeds: liveTimes.map(key => s[key] * 0.44704), step: 3, begin: 130, kink_at: 60}), {marks, path} = answer;
    for (const plot of [this.speed, this.curvature, this.error]) plot.clear();
    this.speed.line(liveTimes.map((_, i) => 3 * i), liveTimes.map(key => s[key]), "curve-1");
    this.speed.line([0, 33], [0, 0], "soft", {"stroke-dasharray": "4 4"});
    const km = values => values.map(v => v * 1e3), far = values => values.map((v, i) => (v - marks.truth[i]) * 1e3);
    this.curvature.line(marks.position, km(marks.raw), "curve-2", {"stroke-width": 1.4});
    this.curvature.line(path.position, km(path.truth), "soft", {"stroke-width": 4, "stroke-opacity": 0.5});
    this.curvature.line(marks.position, km(marks.hybrid), "curve-1", {"stroke-width": 1.4});
    this.error.line(marks.position, far(marks.raw), "curve-2", {"stroke-width": 1.4});
    this.error.line(marks.position, far(marks.hybrid), "curve-1", {"stroke-width": 1.4});
    const kept = live.gains({speed: s.at * 0.44704}), feet = kept.gains.wavelength.map(w => w / 0.3048), dashed = {"stroke-dasharray": "5 4"};
    this.gains.clear();
    [["gyro", "curve-2", {}], ["gyro_hybrid", "curve-1", {}], ["accelerometer", "curve-2", dashed], ["accelerometer_hybrid", "curve-1", dashed]]
      .forEach(([name, colour, more]) => this.gains.line(feet, kept.gains[name], colour, more));
    const rms = values => Math.sqrt(values.reduce((sum, v) => sum + v * v, 0) / Math.max(values.length, 1));
    figure.says([["error, root of the mean square", `raw ${short(rms(far(marks.raw)))}, hybrid ${short(rms(far(marks.hybrid)), 2)} per km`],
      [`one place in records forwards and back at ${short(s.at)} mph`, `${short(kept.apart * 1e3)} mm apart by the hybrid filter`], ["the analog filter", "1 Hz, ours; a car that turns round passes marks twice"]]);
  },
});
