-- Pandoc filter of the pages made of all records: {{headline}}, {{papers}}, {{legend}}, {{gallery}}, {{equations}}.
-- Metadata: record (a list of JSON files), left-out (a list of chapters without a page, with the reason).

package.path = PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/?.lua;" .. package.path
local html, items, record = require "html", require "items", require "record"

local function strings(value)
  local out = {}
  if not value then return out end
  if pandoc.utils.type(value) ~= "List" then value = {value} end
  for i, entry in ipairs(value) do out[i] = pandoc.utils.stringify(entry) end
  return out
end

local headline_heads = {"paper", "printed numbers", "confirmed", "consistent", "fitted", "corrected", "restored",
  "not confirmed", "unreadable", "claims: confirmed / not / not testable", "figures: paper’s data / rebuilt / lost", "verified by other routes"}

local function headline_row(r)
  local name = r.chapter:match("^%d+%-(.*)$")
  local row = {html.tag("a", {href = r.chapter .. ".html", title = r.title}, r.number .. " " .. html.escape(name)),
    class = record.tally(r.checks) < #r.checks and "failed" or nil}
  for _, cell in ipairs(r.headline or {}) do row[#row + 1] = {cell == "0" and "–" or cell, class = "number"} end
  return row
end

local function headline(records, left_out)
  local rows = {}
  for _, r in ipairs(records) do
    rows[#rows + 1] = headline_row(r)
    rows[#rows].name = r.chapter
  end
  for _, line in ipairs(left_out) do
    local name, why = line:match("^(%S+) (.*)$")
    rows[#rows + 1] = {html.escape(name) .. ": " .. html.text(why), name = name}
    for i = 2, #headline_heads do rows[#rows][i] = {"–", class = "number"} end
  end
  table.sort(rows, function(a, b) return a.name < b.name end)
  return html.table("chapters headline", headline_heads, rows)
end

local function citations(records)
  local out = {}
  for i, r in ipairs(records) do
    local pages = html.tag("a", {href = r.chapter .. ".html"}, html.text(r.title))
    if r.has_study then pages = pages .. " · " .. html.tag("a", {href = r.chapter .. "-study.html"}, "cost and stability") end
    out[i] = html.tag("li", nil, pages .. "<br>" .. html.text(r.paper))
  end
  return html.tag("ol", {class = "papers"}, table.concat(out, "\n"))
end

-- Stops the build when a file of the tree does not name what the inventory says it holds.
local function require_named(r, path, name)
  local file = io.open((os.getenv("RAILBOOK_ROOT") or ".") .. "/" .. path)
  local text = file and file:read("a")
  if file then file:close() end
  if text and (not name or text:find("%f[%w_]" .. name .. "%f[^%w_]")) then return end
  io.stderr:write(("book: the inventory of %s names %s%s, which is not there\n"):format(r.chapter, path, name and " " .. name or ""))
  os.exit(1)
end

-- Equation -> function -> test -> place on the page, for all papers.
local function equations(records)
  local out = {}
  for _, r in ipairs(records) do
    local rows = {}
    for _, row in ipairs(r.inventory) do
      if row.kind == "equation" then
        local treated, number = {}, row.number:match("^%(?([%w.-]+)%)?$")
        for j, id in ipairs(row.treated) do
          local item = r.item[id] or r.check[id] and r.item[r.check[id].item]
          treated[j] = item and html.tag("a", {href = items.href(item, r, "index")}, html.escape(id)) or html.escape(id)
        end
        for path, name in row.symbol:gmatch("(%S+)%s+([%w_]+)") do require_named(r, "lib/" .. path, name) end
        for path in row.test:gmatch("%S+") do require_named(r, path) end
        local anchor = r.chapter .. ".html" .. (number and "#eq-" .. number or "")
        rows[#rows + 1] = {html.tag("a", {href = anchor}, html.text(row.number)), html.text(row.place), html.text(row.what),
          row.symbol ~= "" and html.tag("code", nil, html.escape(row.symbol)) or "–",
          row.test ~= "" and html.tag("code", nil, html.escape(row.test)) or "–",
          #treated > 0 and table.concat(treated, ", ") or html.text(row.reason)}
      end
    end
    if #rows > 0 then
      out[#out + 1] = html.tag("h2", {id = r.chapter}, r.number .. " " .. html.text(r.title))
      out[#out + 1] = html.table("equations", {"equation", "place", "what", "function", "test", "checked in"}, rows)
    end
  end
  return table.concat(out, "\n")
end

local meanings = {
  {"confirmed", "rounds to the printed digits, or the claim holds as stated"},
  {"consistent", "within a stated tolerance, whose reason is given"},
  {"fitted", "met because an input that the paper does not give was chosen to meet it"},
  {"corrected", "the print is wrong: the check shows what is right"},
  {"restored", "our copy of the paper is damaged there; the reading is derived"},
  {"not confirmed", "something else was found; the check states it, and fails if that changes"},
  {"verified", "not of the paper: agrees with another publication, or with an independent method"},
  {"failed", "a check does not pass"},
  {"rebuilt", "a figure or table whose input the paper does not give: ours, documented"},
  {"added", "not in the paper"},
  {"sketch", "the paper draws the idea only"},
  {"lost", "the paper’s own is not to be had"},
}

local function legend()
  local rows = {}
  for i, m in ipairs(meanings) do rows[i] = {html.badge(m[1]), html.text(m[2])} end
  return html.table("legend", {"word", "meaning"}, rows)
end

local function gallery(records)
  local out = {}
  for _, r in ipairs(records) do
    local tiles = {}
    for _, item in ipairs(r.items) do
      if item.png then
        local source = ("figures/%s/%s"):format(r.chapter, item.png)
        local image = html.tag("img", {src = source, alt = item.title, loading = "lazy"})
        tiles[#tiles + 1] = html.tag("li", nil, html.tag("a", {href = items.href(item, r, "index")}, image)
          .. html.tag("p", nil, items.title(item) .. " " .. html.badge(item.failure and "failed" or item.input)))
      end
    end
    if #tiles > 0 then
      out[#out + 1] = html.tag("h2", {id = r.chapter}, r.number .. " " .. html.text(r.title))
      out[#out + 1] = html.tag("ul", {class = "gallery"}, table.concat(tiles, "\n"))
    end
  end
  return table.concat(out, "\n")
end

function Pandoc(doc)
  local records = {}
  for _, path in ipairs(strings(doc.meta.record)) do
    local good, r = pcall(record.load, path)
    if not good then
      io.stderr:write("book: ", r, "\n")
      os.exit(1)
    end
    records[#records + 1] = r
  end
  table.sort(records, function(a, b) return a.chapter < b.chapter end)
  local made = {
    ["{{headline}}"] = function() return headline(records, strings(doc.meta["left-out"])) end,
    ["{{papers}}"] = function() return citations(records) end, ["{{equations}}"] = function() return equations(records) end,
    ["{{legend}}"] = legend, ["{{gallery}}"] = function() return gallery(records) end,
  }
  local machine = records[1] and records[1].machine
  if machine then
    doc.meta.machine = pandoc.MetaInlines({pandoc.RawInline("html", record.describe(machine))})
  end
  return doc:walk({Para = function(para)
    local make = made[pandoc.utils.stringify(para)]
    return make and pandoc.RawBlock("html", make()) or nil
  end})
end
