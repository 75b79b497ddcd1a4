-- Pandoc filter of the pages made of all records: index.md, and those of pages/, which it writes beside it. Each has a paragraph
-- {{name}} where its list goes.
-- Metadata: record (a list of JSON files), left-out (a list of chapters without a page, with the reason), chapters (see
-- frame.lua), parts (folder of what the chapters' pages left), header (the headers of lib/), figures (folder of the
-- pictures), book (folder of the result).

package.path = PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/?.lua;" .. package.path
local html, items, record, frame = require "html", require "items", require "record", require "frame"
local overview, benchmarks, library, front = require "overview", require "benchmarks", require "library", require "front"
local equations, appendix = require "equations", require "appendix"
local tools, csv, dkjson = require "tools", require "csv", require "dkjson"

local headline_heads = {"paper", "printed numbers", "confirmed", "consistent", "fitted", "corrected", "restored",
  "not confirmed", "unreadable / not testable", "claims: confirmed / consistent / not / not testable", "figures: paper’s data / rebuilt / lost", "verified by other routes"}

-- How many entries of a chapter's inventory are of a kind and left out for a reason.
local function left_out_of(r, kind, reason)
  local count = 0
  for _, line in ipairs(r.inventory) do
    if line.kind == kind and line.reason:find("^" .. reason) then count = count + 1 end
  end
  return count
end

local function headline_row(r)
  local name = r.chapter:match("^%d+%-(.*)$")
  local row = {html.tag("a", {href = r.chapter .. ".html", title = r.title}, r.number .. " " .. html.escape(name)),
    class = record.tally(r.checks) < #r.checks and "failed" or nil}
  local cells = {table.unpack(r.headline or {})}
  if #cells > 0 then -- of the record's all that is unreadable and not testable, here the numbers and the claims apart
    local unreadable, untested = left_out_of(r, "number", "unreadable"), left_out_of(r, "number", "not testable")
    cells[1] = tostring(math.tointeger(tonumber(cells[1]) - tonumber(cells[8])) + unreadable + untested)
    cells[8] = unreadable + untested == 0 and "0" or ("%d / %d"):format(unreadable, untested)
    cells[9] = cells[9]:gsub("%d+$", tostring(left_out_of(r, "claim", "not testable")))
  end
  for _, cell in ipairs(cells) do row[#row + 1] = {cell == "0" and "–" or cell, class = "number"} end
  return row
end

local function headline(records, left_out)
  local rows = {}
  for _, r in ipairs(records) do
    if not r.paper:match("^Addition") then -- a chapter beyond the papers has no claims of a paper to count
      rows[#rows + 1] = headline_row(r)
      rows[#rows].name = r.chapter
    end
  end
  for _, line in ipairs(left_out) do
    local name, why = line:match("^(%S+) (.*)$")
    rows[#rows + 1] = {html.escape(name) .. ": " .. html.text(why), name = name}
    for i = 2, #headline_heads do rows[#rows][i] = {"–", class = "number"} end
  end
  table.sort(rows, function(a, b) return a.name < b.name end)
  return html.table("chapters headline", headline_heads, rows)
end

-- The table's two sums that a reader should know first, in one sentence.
local function in_short(records)
  local printed, met, drawn, figures = 0, 0, 0, 0 -- printed: without the unreadable ones
  for _, r in ipairs(records) do
    if not r.paper:match("^Addition") then
      local cells = r.headline
      printed, met = printed + tonumber(cells[1]) - tonumber(cells[8]), met + tonumber(cells[2]) + tonumber(cells[3])
      local own, rebuilt, lost = cells[10]:match("^(%d+) / (%d+) / (%d+)$")
      drawn, figures = drawn + own, figures + own + rebuilt + lost
    end
  end
  return html.tag("p", nil, ("Of the %d printed numbers that can be compared, %d are confirmed to the last digit or consistent within a stated "
    .. "tolerance. Of the %d figures, %d are drawn from data that the paper prints; the others are rebuilt from inputs of ours, "
    .. "which their captions name, or lost."):format(printed, met, math.tointeger(figures), math.tointeger(drawn)))
end

local meanings = {
  {"confirmed", "rounds to the printed digits, or the claim holds as stated"},
  {"consistent", "within a stated tolerance, whose reason is given"},
  {"fitted", "met because an input that the paper does not give was chosen to meet it"},
  {"corrected", "the print is wrong; the check shows what is right, and a trial varies what we chose"},
  {"restored", "our copy of the paper is damaged there; the reading is derived"},
  {"not confirmed", "we found something else; the check guards our result, and a trial varies what we chose"},
  {"verified", "not a statement of the paper: it agrees with another publication, or with an independent method"},
  {"failed", "the check does not pass"},
  {"rebuilt", "a figure or table whose input the paper does not give; ours is documented"},
  {"added", "not in the paper"},
  {"sketch", "the paper draws only the idea"},
  {"lost", "the original is lost"},
}

local function legend()
  local rows = {}
  for i, m in ipairs(meanings) do rows[i] = {html.badge(m[1]), html.text(m[2])} end
  return html.table("legend", {"word", "meaning"}, rows)
end

local function tile(item, r, figures)
  local image = items.image(item, r, figures .. "/" .. r.chapter, true)
  return html.tag("li", nil, html.tag("a", {href = items.href(item, r, "index")}, image)
    .. html.tag("p", nil, html.tag("b", nil, items.link(item, r, "index")) .. " " .. items.title(item)))
end

-- The figures to look at first, and how many each chapter has in all; one that a run did not draw is replaced by the chapter's next.
local heroes = {"01-contact/bodies", "01-contact/scene", "01-contact/fig-12", "02-hunting/drawing", "02-hunting/fig-11", "02-hunting/scene-hunting",
  "03-creep/fig-01", "03-creep/fig-full-curve", "03-creep/fig-11", "04-filters/fig-layout", "04-filters/fig-directions", "04-filters/fig-curve",
  "05-psd/overview", "05-psd/fig-03", "05-psd/fig-11", "06-quality/fig-01", "06-quality/fig-level", "06-quality/fig-11",
  "07-track/fig-02", "07-track/fig-joint", "07-track/fig-moving", "08-wheel-on-rail/pair", "08-wheel-on-rail/scene", "08-wheel-on-rail/fig-patches"}
local of_each = 3

local function gallery(records, figures)
  local tiles = {}
  for _, r in ipairs(records) do
    local chosen, seen = {}, {}
    local function choose(item)
      if item and item.png and not seen[item] and #chosen < of_each then
        seen[item] = true
        chosen[#chosen + 1] = item
      end
    end
    for _, name in ipairs(heroes) do
      if name:match("^[^/]*") == r.chapter then choose(r.item[name:match("/(.*)$")]) end
    end
    for _, item in ipairs(r.items) do
      if item.page == "paper" then choose(item) end
    end
    for _, item in ipairs(chosen) do tiles[#tiles + 1] = tile(item, r, figures) end
  end
  return html.tag("ul", {class = "gallery"}, table.concat(tiles, "\n"))
end

local function read_file(path)
  local file = io.open(path, "rb")
  local text = file and file:read("a")
  if file then file:close() end
  return text
end

local function load_records(paths)
  local records = {}
  for i, path in ipairs(paths) do
    local good, r = pcall(record.load, path)
    if not good then
      io.stderr:write("book: ", r, "\n")
      os.exit(1)
    end
    records[i] = r
  end
  table.sort(records, function(a, b) return a.chapter < b.chapter end)
  return records
end

-- What the chapters' pages left for these: their findings, what a search finds on them, and the numbers of their figures and tables.
local function load_parts(folder, chapters, records)
  local parts = {}
  for _, c in ipairs(chapters) do
    for _, page in ipairs({c.id, c.id .. "-study"}) do
      local text = read_file(folder .. "/" .. page .. ".json")
      if text then parts[page] = dkjson.decode(text) end
    end
  end
  for _, r in ipairs(records) do
    for _, page in ipairs({r.chapter, r.chapter .. "-study"}) do
      for id, number in pairs(parts[page] and parts[page].numbers or {}) do r.item[id].number = number end
    end
  end
  return parts
end

local entities = {["&lt;"] = "<", ["&gt;"] = ">", ["&amp;"] = "&", ["&quot;"] = '"', ["&#39;"] = "'"}

local function plain(text)
  text = text:gsub("<style.-</style>", " "):gsub("<[^>]*>", " "):gsub("&#?%w+;", entities)
  return (text:gsub("%s+", " "):gsub("^ ", ""):gsub(" $", ""))
end

-- The sections of a page of HTML as a search finds them: {title, anchor, text}, what stands before the first heading first.
local function sections_of(page)
  local main = page:match("<main.->(.*)</main>") or page
  local out, at, entry = {}, 1, {"", "", ""}
  for open, id, title, close in main:gmatch('()<h[23] [^>]*id="([^"]*)"[^>]*>(.-)</h[23]>()') do
    entry[3] = plain(main:sub(at, open - 1))
    out[#out + 1] = entry
    entry, at = {plain(title), id, ""}, close
  end
  entry[3] = plain(main:sub(at))
  out[#out + 1] = entry
  out[1][1] = out[1][1] ~= "" and out[1][1] or plain(main:match("<h1.->(.-)</h1>") or "")
  return out
end

-- Overview pages that a search looks into; the others repeat the chapters.
local looked_into = {tools = true, reading = true, cite = true, verification = false}

-- search.json, which weave.cmake packs into search.js: {file, title of the page, kind, words that are meant by it too, {{title, anchor, text}, ...}} for each page (see find.js).
local function write_search(book, pages, parts, of_library, keywords)
  local all = {}
  for _, page in ipairs(pages) do
    local name, kind = page[1], "overview"
    local entries = parts[name] and parts[name].search or {}
    if name:find("^%d%d%-") then kind = name:find("%-study$") and "study" or "chapter" end
    if name == "library" then kind, entries = "library", of_library end
    if name == "tools" then kind = "tools" end
    if looked_into[name] then entries = sections_of(read_file(book .. "/" .. name .. ".html")) end
    all[#all + 1] = {name .. ".html", page[2], kind, keywords[name] or "", entries}
  end
  local file = assert(io.open(book .. "/search.json", "w"))
  file:write(dkjson.encode(all))
  file:close()
end

local function filled(doc, made)
  return doc:walk({Para = function(para)
    local make = made[pandoc.utils.stringify(para)]
    return make and pandoc.RawBlock("html", make()) or nil
  end})
end

-- The cards of the front page, of the chapters that have a record.
local function with_cards(doc, records)
  return doc:walk({Div = function(div)
    if not div.classes:includes "cards" then return nil end
    local cards = {}
    for _, card in ipairs(div.content) do cards[#cards + 1] = front.card(card, records) end
    return pandoc.RawBlock("html", html.tag("ul", {class = "cards"}, table.concat(cards, "\n")))
  end})
end

-- The contents, with the other overview pages and the search written beside it, in the folder `book`.
function Pandoc(doc)
  local text = function(key) return pandoc.utils.stringify(doc.meta[key]) end
  local chapters, book = frame.chapters(frame.strings(doc.meta.chapters)), text "book"
  local records = load_records(frame.strings(doc.meta.record))
  local parts, anchors = load_parts(text "parts", chapters, records), {}
  local library_page, of_library = library.all(frame.strings(doc.meta.header))
  for _, entry in ipairs(of_library) do anchors[entry[2]] = true end
  local made = {
    ["{{in-short}}"] = function() return in_short(records) end,
    ["{{headline}}"] = function() return headline(records, frame.strings(doc.meta["left-out"])) end,
    ["{{tools}}"] = function() return tools.page(PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/../docs", book, chapters) end,
    ["{{hunting}}"] = function() return front.hunting(records) end, ["{{numbers}}"] = function() return front.numbers(records) end,
    ["{{read}}"] = function() return front.read(chapters, frame.strings(doc.meta["left-out"])) end, ["{{equations}}"] = function() return equations.all(records, parts, anchors) end,
    ["{{symbols}}"] = function() return appendix.symbols(records, parts) end, ["{{units}}"] = appendix.units,
    ["{{cite}}"] = function() return appendix.cite(records) end, ["{{changes}}"] = appendix.changes,
    ["{{legend}}"] = legend, ["{{gallery}}"] = function() return gallery(records, text "figures") end,
    ["{{findings}}"] = function() return overview.findings(records, parts) end,
    ["{{ledger}}"] = function() return overview.ledger(records) end,
    ["{{stability}}"] = function() return overview.stability(records) end,
    ["{{digits}}"] = function() return overview.digits(records) end,
    ["{{verification}}"] = function() return overview.verification(records) end,
    ["{{claims}}"] = function() return overview.claims(PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/../tests/claims.csv") end,
    ["{{benchmarks}}"] = function() return benchmarks.all(records) end,
    ["{{costs}}"] = function() return benchmarks.costs(PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/../tests/cost") end,
    ["{{peers}}"] = function() return benchmarks.peers(PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/../tests/peers") end,
    ["{{library}}"] = function() return library_page end,
  }
  local here = PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$")
  local template = pandoc.template.compile(read_file(here .. "/template.html"))
  local machine = records[1] and records[1].machine
  for i, page in ipairs(frame.overviews) do
    local other = filled(pandoc.read(read_file(("%s/pages/%s.md"):format(here, page[1])), "markdown-citations"), made)
    frame.set(other.meta, chapters, page[1])
    other.meta.title, other.meta.pagetitle = pandoc.MetaString(page[2]), pandoc.MetaString(page[2])
    other.meta.page = pandoc.MetaString(page[1])
    other.meta.machine = machine and pandoc.MetaInlines({pandoc.RawInline("html", record.describe(machine))}) or nil
    other.meta.version = doc.meta.version
    local file = assert(io.open(("%s/%s.html"):format(book, page[1]), "w"))
    file:write(pandoc.write(other, "html5", {template = template, html_math_method = "mathml", wrap_text = "none"}))
    file:close()
  end
  local keywords = {}
  for _, row in ipairs(assert(csv.read(here .. "/keywords.csv"))) do keywords[row.page] = row.words end
  write_search(book, frame.pages(chapters), parts, of_library, keywords)
  frame.set(doc.meta, chapters, "index")
  doc.meta.machine = machine and pandoc.MetaInlines({pandoc.RawInline("html", record.describe(machine))}) or nil
  return filled(with_cards(doc, records), made)
end
