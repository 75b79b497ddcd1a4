-- What a page leaves for the others: its findings, what the search finds on it, and the numbers of its figures and tables.

local html, items, mathml = require "html", require "items", require "mathml"
local dkjson = require "dkjson"

local parts = {}

local raised = {["−"] = "⁻"}
for i = 0, 9 do raised[tostring(i)] = utf8.char(({[0] = 0x2070, 0xb9, 0xb2, 0xb3})[i] or 0x2070 + i) end

-- The text of a block as a reader sees it: with the numbers that were inserted, and with its lists and tables in words.
local function words_of(block)
  local function text_of(raw)
    local entities = {["&lt;"] = "<", ["&gt;"] = ">", ["&amp;"] = "&", ["&quot;"] = '"', ["&#8239;"] = "\u{202f}"}
    raw = raw:gsub("<sup>([−%d]+)</sup>", function(power) return (power:gsub(utf8.charpattern, raised)) end)
    return pandoc.Str((raw:gsub("<annotation.-</annotation>", ""):gsub("<[^>]*>", ""):gsub("&[#%w]+;", entities)))
  end
  block = pandoc.Pandoc({block}):walk({
    RawInline = function(raw) return text_of(raw.text) end,
    Math = function(math) return text_of(html.formula(math.text, math.mathtype) or "") end,
    Note = function() return {} end})
  return (pandoc.write(block, "plain", {wrap_text = "none"}):gsub("%-%-%-+", " "):gsub("\u{a0}", " "):gsub("^%s+", ""):gsub("%s+", " "))
end

-- What a search finds: the sections with their text, and the figures and tables with what they show and check.
local function search_entries(doc, r, page)
  local out, entry = {}, {pandoc.utils.stringify(doc.meta.title), "", ""}
  out[1] = entry
  for _, block in ipairs(doc.blocks) do
    if block.t == "Header" then
      entry = {pandoc.utils.stringify(block), block.identifier, ""}
      out[#out + 1] = entry
    elseif block.t ~= "CodeBlock" and block.t ~= "RawBlock" and block.t ~= "Plain" then
      entry[3] = entry[3] .. (entry[3] ~= "" and " " or "") .. words_of(block)
    end
  end
  for _, item in ipairs(r.items) do
    if item.page == page then
      local whats = {item.title}
      for _, check in ipairs(item.checks) do whats[#whats + 1] = check.what or check.id end
      out[#out + 1] = {items.label(item, r) .. ". " .. items.plain_title(item), item.id, words_of(pandoc.Plain({pandoc.RawInline("html", html.text(table.concat(whats, "; ")))}))}
    end
  end
  return out
end

-- The box of the chapter's findings, with links that lead to this page from any other.
local function findings(doc, r)
  local out
  for _, block in ipairs(doc.blocks) do
    if block.t == "Div" and block.classes:includes("findings") and not out then
      out = pandoc.write(pandoc.Pandoc(block.content), "html", {html_math_method = "mathml"})
      out = mathml.mend(out):gsub('href="#', ('href="%s.html#'):format(r.chapter))
    end
  end
  return out
end

-- The numbers of this page's figures and tables.
local function numbers(r, page)
  local out = {}
  for _, item in ipairs(r.items) do
    if item.page == page then out[item.id] = item.number end
  end
  return out
end

-- Writes them into the folder for the other pages; `more` is written with them.
function parts.leave(doc, folder, r, page, more)
  local name = page == "study" and r.chapter .. "-study" or r.chapter
  local file = assert(io.open(folder .. "/" .. name .. ".json", "w"))
  file:write(dkjson.encode({findings = findings(doc, r), search = search_entries(doc, r, page), tags = more.tags,
    numbers = numbers(r, page), symbols = more.symbols}))
  file:close()
end

return parts
