// node search.mjs BOOK: each query of queries.csv finds its page first (or one of several, a|b).
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {join, resolve} from "node:path";
import {gunzipSync} from "node:zlib";

const book = resolve(process.argv[2]);
const {find} = createRequire(import.meta.url)(join(book, "find.js"));
let index;
new Function("railbookSearch", readFileSync(join(book, "search.js"), "utf8"))((packed) => { index = JSON.parse(gunzipSync(Buffer.from(packed, "base64"))); });
let wrong = 0;
const lines = readFileSync(new URL("queries.csv", import.meta.url), "utf8").trim().split("\n").slice(1);
for (const line of lines) {
  const [query, page] = line.split(",");
  const hits = find(index, query);
  if (page.split("|").includes(hits[0]?.href.split("#")[0])) continue;
  wrong++;
  console.log(`"${query}" finds first ${hits.slice(0, 3).map((h) => `${h.href} (${h.score.toFixed(1)})`).join(", ") || "nothing"}, not ${page}`);
}
if (find(index, "qwertzuiop").length > 0) { wrong++; console.log("finds what is not there"); }
console.log(`${lines.length} queries, ${wrong} wrong`);
process.exitCode = wrong > 0 ? 1 : 0;
