// Made by `make accept-live`; edit book/live/wasm/loader.js and the sources beside it instead.
// The library's own C++ for the live figures. railbookLive() is a Promise of an object with one
// function for each of book/live/*.cpp: live.joint({speed: 26.8}) takes SI numbers by name, with
// defaults for those left out, and answers with numbers and tables of Float64Arrays by name.
// Bad input throws an Error with a text for the reader. live.joint.inputs says what there is.
(() => {
  const packed = "@WASM@";

  /* @GLUE@ */

  async function unpack() {
    const bytes = Uint8Array.from(atob(packed), c => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  function read(layout, numbers) {
    const answer = {};
    let at = 0;
    for (const part of layout.split(" ")) {
      const [name, rows, columns] = part.split(":");
      if (rows === undefined) {
        answer[name] = numbers[at++];
        continue;
      }
      const names = columns.split(","), table = {};
      names.forEach((column, k) => {
        table[column] = Float64Array.from({length: +rows}, (_, i) => numbers[at + i * names.length + k]);
      });
      at += rows * names.length;
      answer[name] = table;
    }
    return answer;
  }

  async function load() {
    const module = await railbookModule({wasmBinary: await unpack()});
    const text = pointer => module.UTF8ToString(pointer), live = {};
    text(module._live_describe()).trim().split("\n").forEach((line, number) => {
      const [name, list, ...fields] = line.split("\t");
      const inputs = fields.map(field => {
        const [key, unit, ...numbers] = field.split("|"), [value, low, high] = numbers.map(Number);
        return {name: key, unit, value, low, high};
      });
      const call = (given = {}) => {
        for (const key of Object.keys(given))
          if (key !== list && !inputs.some(input => input.name === key))
            throw new Error(`${name} has no input "${key}"`);
        const begin = performance.now();
        const values = inputs.map(input => Number(given[input.name] ?? input.value)).concat(Array.from(given[list] ?? [], Number));
        const into = module._live_buffer(values.length); // ahead of HEAPF64, which moves when memory grows
        module.HEAPF64.set(values, into / 8);
        const count = module._live_call(number, values.length), said = text(module._live_text());
        call.took = performance.now() - begin;
        if (count < 0) throw new Error(said);
        const from = module._live_buffer(0) / 8;
        return read(said, module.HEAPF64.subarray(from, from + count));
      };
      call.inputs = inputs;
      live[name] = call;
    });
    return live;
  }

  let loading;
  globalThis.railbookLive = () => loading ??= load();
})();
