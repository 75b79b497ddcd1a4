-- Pandoc filter of the contents page and the gallery: {{chapters}}, {{legend}} and {{gallery}} from all records.
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

local function chapter_row(r)
  local passed, total, closest = record.tally(r.checks)
  local badges = {}
  for _, pair in ipairs(record.count(r.items, "verdict")) do
    badges[#badges + 1] = pair[2] .. " " .. html.badge(pair[1])
  end
  local worst = closest and ("%.0f %%"):format(100 * record.used(closest)) or "–"
  local link = html.tag("a", {href = r.chapter .. ".html"}, r.number .. " " .. html.text(r.title))
  return {
    link, html.text(r.paper), table.concat(badges, "<br>"),
    {("%d of %d"):format(passed, total), class = "number"}, {worst, class = "number"},
    {html.seconds(r.seconds), class = "number"}, class = passed < total and "failed" or nil}
end

local function chapters(records, left_out)
  local rows = {}
  for _, r in ipairs(records) do
    rows[#rows + 1] = chapter_row(r)
    rows[#rows].name = r.chapter
  end
  for _, line in ipairs(left_out) do
    local name, why = line:match("^(%S+) (.*)$")
    local none = {"–", class = "number"}
    rows[#rows + 1] = {html.escape(name), html.text(why), html.badge("no page"), none, none, none, name = name}
  end
  table.sort(rows, function(a, b) return a.name < b.name end)
  local heads = {"chapter", "paper", "tables and figures", "checks passed", "worst error", "run time"}
  return html.table("chapters", heads, rows)
end

local meanings = {
  {"reproduced", "every check passes at the printed precision"},
  {"explained", "every check passes, some at a wider tolerance or against a method of our own; the reason is given"},
  {"misprint", "the printed number is shown to be wrong; ours equals the corrected one"},
  {"reconstructed", "the paper does not give the input, or draws without numbers; ours is stated"},
  {"sketch", "the paper draws the idea only; ours is computed, with nothing to check it against"},
  {"not-reproducible", "the paper gives too little, and says so here"},
  {"failed", "a check does not pass"},
}

local function legend()
  local rows = {}
  for i, m in ipairs(meanings) do rows[i] = {html.badge(m[1]), html.text(m[2])} end
  return html.table("legend", {"verdict", "meaning"}, rows)
end

local function gallery(records)
  local out = {}
  for _, r in ipairs(records) do
    local tiles = {}
    for _, item in ipairs(r.items) do
      if item.png then
        local source = ("figures/%s/%s"):format(r.chapter, item.png)
        local image = html.tag("img", {src = source, alt = item.title, loading = "lazy"})
        tiles[#tiles + 1] = html.tag("li", nil, html.tag("a", {href = r.chapter .. ".html#" .. item.id}, image)
          .. html.tag("p", nil, items.title(item) .. " " .. html.badge(item.verdict)))
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
  local made = {
    ["{{chapters}}"] = function() return chapters(records, strings(doc.meta["left-out"])) end,
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
