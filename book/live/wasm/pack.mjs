// node pack.mjs LIVE.js LIVE.wasm LOADER.js OUT: the module as one plain script, its WebAssembly deflated.
import {readFileSync, writeFileSync} from "node:fs";
import {constants, deflateSync} from "node:zlib";

const [glue, wasm, loader, out] = process.argv.slice(2);
const packed = deflateSync(readFileSync(wasm), {level: constants.Z_BEST_COMPRESSION, memLevel: 9});
const script = readFileSync(loader, "utf8")
  .replace("@WASM@", () => packed.toString("base64"))
  .replace("/* @GLUE@ */", () => readFileSync(glue, "utf8"));
writeFileSync(out, script);
console.log(`${out}: ${script.length} bytes, ${readFileSync(wasm).length} of WebAssembly`);
