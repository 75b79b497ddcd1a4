// node live.mjs MODULE.js LIVE_ANSWERS STATES RUNS: the live module answers as the library does natively, and with the
// numbers that the chapters' runs in the folder RUNS found. Prints the time of each call.
import {execFileSync} from "node:child_process";
import {readFileSync, readdirSync} from "node:fs";
import {runInThisContext} from "node:vm";
import {createRequire} from "node:module";

const [moduleFile, program, states, runs] = process.argv.slice(2);
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = "/";
const started = performance.now();
runInThisContext(readFileSync(moduleFile, "utf8"));
const live = await railbookLive();
console.log(`start: ${(performance.now() - started).toFixed(0)} ms`);

let failed = 0;
const fail = text => { failed++; console.log(`FAILED ${text}`); };
const native = execFileSync(program, [states], {maxBuffer: 1 << 28}).toString().trim().split("\n").map(JSON.parse);

// The same functions, with the same inputs, defaults and ranges.
const described = Object.entries(live).map(([name, call]) => [name, ...call.inputs.map(i =>
  [i.name, i.unit, i.value, i.low, i.high].join("|"))].join("\t"));
const expected = native.shift().describe.trim().split("\n").map(line => {
  const [name, , ...inputs] = line.split("\t");
  return [name, ...inputs.map(i => i.split("|").map((x, k) => k < 2 ? x : String(Number(x))).join("|"))].join("\t");
});
expected.forEach((line, k) => { if (line !== described[k]) fail(`described: ${described[k]}\n  natively: ${line}`); });
if (described.length !== expected.length) fail("the module has other functions than the sources");

// Numbers of an answer by name, a column of a table together.
function columns(answer) {
  const all = {};
  for (const [name, value] of Object.entries(answer))
    if (typeof value === "number") all[name] = [value];
    else for (const [column, numbers] of Object.entries(value)) all[`${name}.${column}`] = Array.from(numbers);
  return all;
}
function nativeColumns({text, numbers}) {
  const all = {};
  let at = 0;
  const number = x => typeof x === "string" ? Number(x) : x;
  for (const part of text.split(" ")) {
    const [name, rows, names] = part.split(":");
    if (rows === undefined) { all[name] = [number(numbers[at++])]; continue; }
    const list = names.split(",");
    list.forEach((column, k) => {
      all[`${name}.${column}`] = Array.from({length: +rows}, (_, i) => number(numbers[at + i * list.length + k]));
    });
    at += rows * list.length;
  }
  return all;
}

const called = new Set();
for (const one of native) {
  const [name, tolerance, ...given] = one.state.split(/\s+/);
  const inputs = Object.fromEntries(given.map(word => {
    const [key, value] = word.split("=");
    return [key, value.includes(",") ? value.split(",").map(Number) : Number(value)];
  }));
  called.add(name);
  let answer;
  try {
    answer = live[name](inputs);
  } catch (error) {
    if (one.numbers !== undefined || error.message !== one.text) fail(`${one.state}: ${error.message}\n  natively: ${one.text}`);
    else console.log(`${one.state}: refused alike`);
    continue;
  }
  if (one.numbers === undefined) { fail(`${one.state}: answered, but natively: ${one.text}`); continue; }
  live[name](inputs); // the second time without what is made once
  const a = columns(answer), b = nativeColumns(one);
  let worst = 0, where = "";
  for (const key of new Set([...Object.keys(a), ...Object.keys(b)])) {
    if (a[key]?.length !== b[key]?.length) { fail(`${one.state}: ${key} has ${a[key]?.length} rows, natively ${b[key]?.length}`); continue; }
    const zeroed = x => Math.abs(x) < 1e-12 ? 0 : x; // rounding of a force across, a place in the middle ...
    a[key] = a[key].map(zeroed), b[key] = b[key].map(zeroed);
    const size = Math.max(...b[key].map(Math.abs).filter(Number.isFinite), 1e-300);
    a[key].forEach((x, i) => {
      const off = Object.is(x, b[key][i]) ? 0 : Math.abs(x - b[key][i]) / size;
      if (!(off <= worst)) [worst, where] = [off, `${key}[${i}]: ${x}, natively ${b[key][i]}`];
    });
  }
  console.log(`${one.state}: ${live[name].took.toFixed(1)} ms, off by ${worst.toExponential(1)} ${where}`);
  if (!(worst <= Number(tolerance))) fail(`${one.state}: off by ${worst} at ${where}`);
}
for (const name of Object.keys(live)) if (!called.has(name)) fail(`${name} is called at no state`);

// Wrong input names are refused, and so are values out of range, with the range.
for (const [given, text] of [[{sped: 1}, /no input/], [{speed: -1}, /speed.*-1.*m\/s/]])
  try {
    live.joint(given);
    fail(`${JSON.stringify(given)} was taken`);
  } catch (error) {
    if (!text.test(error.message)) fail(`${JSON.stringify(given)}: ${error.message}`);
  }

// What the chapters' own runs found, to the digits of their records.
const record = chapter => JSON.parse(readFileSync(`${runs}/${chapter}/results/${chapter}.json`, "utf8"));
const check = (chapter, id) => record(chapter).checks.find(c => c.id === id).computed;
function same(what, x, recorded, tolerance) {
  console.log(`${what}: ${x}, in the record ${recorded}`);
  if (!(Math.abs(x / recorded - 1) <= tolerance)) fail(`${what}: ${x}, in the record ${recorded}`);
}
const foot = 0.3048, inch = foot / 12, lbf = 4.4482216152605, mph = 5280 * foot / 3600;
same("critical speed with new wheels, ft/s", live.critical().speeds.speed[0] / foot, check("02-hunting", "critical-speeds/speed-new"), 1e-9);
const grid = live.contact({cells: 96}); // the record's grid has 127
same("force of Example 2, lbf", grid.force / lbf, check("01-contact", "example-2/F-printed"), grid.force_error);
const peaks = record("07-track").items.find(item => item.id === "joint-peaks");
const column = name => peaks.columns.indexOf(name);
for (const row of peaks.rows) {
  const passage = live.joint({speed: row[column("speed, mph")] * mph, dip: row[column("dip, in")] * inch});
  same(`P1 at ${row[0]} mph, kN`, passage.p1 / 1000, row[column("P1, kN")], 1e-4);
  same(`P2 at ${row[0]} mph, kN`, passage.p2 / 1000, row[column("P2, kN")], 1e-4);
}

if (failed > 0) process.exit(1);
