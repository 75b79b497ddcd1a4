// What a search finds: pure functions over the index that search.js brings, without a page (tests/book/search.mjs tries them in Node).
//   index: [[file, title, kind, keywords, [[title, anchor, text], ...]], ...]   kind: chapter, study, tools, overview or library
"use strict";

const railbookFind = (() => {
  const weight = {chapter: 1, tools: 0.75, overview: 0.85, study: 0.6, library: 0.35};
  const idle = new Set("a an and are at by do for from how i in is it my of on or the this to what where which with your".split(" "));
  const plain = (text) => text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "").replace(/[\u2010-\u2015]/g, "-");

  // The word without the ending of its plural: what begins like it is meant too.
  const stem = (word) => word.length > 4 && word.endsWith("ies") ? word.slice(0, -3)
    : word.length > 4 && /(ss|sh|ch|x)es$/.test(word) ? word.slice(0, -2) : word.length > 3 && /[^su]s$/.test(word) ? word.slice(0, -1) : word;

  function words(query) {
    const all = plain(query).split(/[^\p{L}\p{N}_+.]+/u).filter((w) => w);
    const kept = all.filter((w) => !idle.has(w));
    return (kept.length > 0 ? kept : all).map(stem);
  }

  const patterns = new Map();
  function pattern(word) {
    if (!patterns.has(word)) patterns.set(word, new RegExp("(?<![\\p{L}\\p{N}])" + word.replace(/[.+]/g, "\\$&"), "gu"));
    return patterns.get(word);
  }
  const count = (text, word) => (text.match(pattern(word)) ?? []).length;

  // How well a place answers the words; 0 when it has not all of them.
  function score(list, title, keywords, text, whole) {
    let sum = 0;
    for (const word of list) {
      const inTitle = count(title, word), inKeywords = count(keywords, word), inText = Math.min(count(text, word), 4);
      if (inTitle + inKeywords + inText === 0) return 0;
      sum += (inTitle ? 12 : 0) + (inKeywords ? 16 : 0) + inText;
    }
    const phrase = list.length > 1 ? list.join(" ") : null;
    if (phrase && keywords.includes(phrase)) sum += 12;
    if (phrase && title.includes(phrase)) sum += 8;
    if (title === whole) sum += 6; // a name that is asked for
    return sum / list.length;
  }

  // The places that answer a query, the best first: {href, page, title, text, score}.
  function find(index, query) {
    const list = words(query), whole = plain(query).trim(), hits = [];
    if (list.length === 0) return hits;
    for (const entry of index) {
      const [file, page, kind, keywords, places] = entry;
      entry.plain ??= {page: plain(page), keywords: plain(keywords), places: places.map(([title, , text]) => [plain(title), plain(text)])};
      const prepared = entry.plain, all = prepared.places.map(([title, text]) => title + " " + text).join(" ");
      let best = 0;
      const inPage = [];
      places.forEach(([title, anchor, text], i) => {
        const s = score(list, prepared.places[i][0], "", prepared.places[i][1], whole) * weight[kind];
        if (s > 0) inPage.push({score: s, href: file + (anchor ? "#" + anchor : ""), page, title, text});
        best = Math.max(best, s);
      });
      const own = score(list, prepared.page, prepared.keywords, kind === "library" ? "" : all, whole) * weight[kind];
      if (own > 0) hits.push({score: own + 0.2 * best + 0.01, href: file, page, title: page, text: places[0]?.[2] ?? ""});
      hits.push(...inPage);
    }
    return hits.sort((a, b) => b.score - a.score).slice(0, 30);
  }

  return {find, words};
})();
if (typeof module !== "undefined") module.exports = railbookFind;
