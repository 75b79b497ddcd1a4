-- How the items of a record look on the page: figures, tables, and where what is treated.

local html = require "html"
local record = require "record"
local check_tables = require "check_tables"

local items = {}

local most_rows = 10 -- of a longer list these are open
local widest = 1100 -- a picture of so many pixels has its caption below it, and the width of the page
local whole = 40 -- a table of at most so many rows is open as a whole


local function links(item, r)
  local out = {}
  local function add(folder, name)
    out[#out + 1] = html.tag("a", {href = "data/" .. folder .. name}, html.escape(name))
  end
  for _, name in ipairs(item.csv) do add(r.chapter .. "/", name) end
  if item.script then add(item.script_shared and "" or r.chapter .. "/", item.script) end
  return #out > 0 and html.tag("span", {class = "links"}, table.concat(out, " · ")) or ""
end

-- "Figure 1.3"
function items.label(item, r)
  local kind, series = item.kind == "figure" and "Figure" or "Table", item.page == "study" and "S" or ""
  return item.number and ("%s %s%d.%d"):format(kind, series, r.number, item.number) or kind .. " " .. item.id
end

local abbreviations = {Fig = true, Figs = true, eq = true, eqs = true, Eq = true, p = true, pp = true, ref = true, cf = true, vs = true, No = true, Ref = true}

-- A caption as its first sentence and what follows; one without a full stop inside is nothing but its first sentence.
local function sentences(text)
  local at = 1
  while true do
    local open, close, word = text:find("([%w%)%%°%$]*)[.!?] +%f[%u%$\"“]", at)
    if not open then return text, "" end
    if not abbreviations[word] and not (#word == 1 and word:find("%u")) then
      return text:sub(1, close):gsub(" +$", ""), text:sub(close + 1)
    end
    at = close + 1
  end
end

-- A title "Figure 4. New boundary" has the paper's own number: what remains of it, and "Figure 4" or nil.
local function own_number(title)
  local kind, number, rest = title:match("^(%a+)%s+([%w-]+)[.:]%s+(.+)$")
  if kind ~= "Figure" and kind ~= "Table" then return title, nil end
  return rest, kind .. " " .. number
end

-- What an item shows, in a few words: the first sentence of its caption, as plain text and as HTML.
function items.plain_title(item)
  local title, number = own_number(item.title)
  local first = sentences(title):gsub("%.$", "")
  return first .. (number and (" (the paper’s %s)"):format(number) or "")
end

function items.title(item) return html.text(items.plain_title(item)) end

-- The whole caption: what to see, in bold, then how to read it.
function items.caption(item)
  local title, number = own_number(item.title)
  local first, rest = sentences(title)
  if rest == "" then return items.title(item) end
  return html.tag("b", {class = "see"}, html.text(first)) .. " " .. html.text(rest) .. (number and html.text((" The paper’s %s."):format(number)) or "")
end

local function heading(item, r)
  local label = html.tag("a", {class = "self", href = "#" .. item.id}, html.tag("b", nil, items.label(item, r) .. "."))
  local input = item.failure and "failed" or item.input ~= "paper" and item.input or nil
  return label .. " " .. items.caption(item) .. (input and " " .. html.badge(input) or "") .. links(item, r)
end

local function reason(item)
  local text = item.failure or item.not_drawn or item.reason
  return text and text ~= "" and html.tag("p", {class = "reason"}, html.text(text)) or ""
end

-- The size in pixels of a complete PNG; throws a text naming the file otherwise.
function items.png_size(path)
  local file = io.open(path, "rb")
  if not file then error("the figure " .. path .. " is missing", 0) end
  local bytes = file:read("a")
  file:close()
  if bytes:sub(1, 8) ~= "\137PNG\r\n\26\n" or not bytes:find("IEND", -12, true) then
    error("the figure " .. path .. " is not a complete PNG", 0)
  end
  return string.unpack(">I4I4", bytes, 17)
end

local entities = {["&lt;"] = "<", ["&gt;"] = ">", ["&amp;"] = "&", ["&quot;"] = '"', ["&apos;"] = "'", ["&#39;"] = "'"}

-- What a drawing of gnuplot shows, for who cannot see it: what is drawn against what, and the curves by name. Nil for another.
function items.described(svg)
  if not svg:find(">Gnuplot<", 1, true) then return nil end
  local across, up, curves, seen = {}, {}, {}, {}
  local function add(list, text)
    text = text:gsub("<[^>]*>", ""):gsub("&[#%w]+;", entities):gsub("%s+", " "):gsub("^ ", ""):gsub(" $", "")
    if text:find("%a") and not seen[text] then
      seen[text] = true
      list[#list + 1] = text
    end
  end
  for name in svg:gmatch('<g id="gnuplot_plot_%w+" ><title>([^<]*)</title>') do
    if not name:find("^gnuplot_plot_") then add(curves, name) end
  end
  for attributes, body in svg:gmatch("<g transform=\"translate([^>]*)>%s*(<text.-</g>)") do
    local turned, middle = attributes:find("rotate(", 1, true), attributes:find('text-anchor="middle"', 1, true)
    local text = body:gsub("<[^>]*>", "")
    if text:find("%a%a") and middle then add(turned and up or across, body) end
  end
  local what = #up > 0 and "Graph of " .. table.concat(up, "; ") or "Drawing"
  if #across > 0 then what = what .. (#up > 0 and " against " or ": ") .. table.concat(across, "; ") end
  if #curves > 0 then what = what .. ". Curves: " .. table.concat(curves, "; ") end
  return what .. "."
end

-- The picture of a figure, whose PNG has twice the pixels it is shown with: its SVG, which a dark page may turn, where there is one. `folder` holds the chapter's pictures.
function items.image(item, r, folder, lazy)
  local width, height = items.png_size(folder .. "/" .. item.png)
  local svg = item.png:gsub("%.png$", ".svg")
  local drawing, seen = io.open(folder .. "/" .. svg), nil
  if drawing then
    seen = items.described(drawing:read("a"))
    drawing:close()
  end
  local href = ("figures/%s/%s"):format(r.chapter, drawing and svg or item.png)
  local class = (drawing and "drawing" or "") .. (width // 2 >= widest and " wide" or "")
  local image = html.tag("img", {src = href, alt = item.alt or seen or "Picture: " .. item.title, width = width // 2, height = height // 2,
    class = class ~= "" and class or nil, loading = lazy and "lazy" or nil})
  return image, href, width // 2, height // 2
end

-- How high the caption of a figure is in the column beside it, in px: some 32 letters a line.
local function caption_height(item)
  local text, files = item.failure or item.not_drawn or item.reason or "", item.script or ""
  for _, name in ipairs(item.csv) do files = files .. name .. "   " end
  return 20 * (math.ceil((utf8.len(item.title) + 14) / 31) + math.ceil(#files / 34)) + 18 * math.ceil((utf8.len(text) or 0) / 36) + 20
end

-- A figure with its caption, beside it where there is room, `more` of the same item, and its checks.
function items.figure(item, r, folder, more)
  if not item.png and (item.failure or item.not_drawn) then return items.table(item, r, more) end
  if not item.png then error("the figure " .. item.id .. " was not drawn (--no-figures?)", 0) end
  local image, href, width, height = items.image(item, r, folder, true)
  local below = caption_height(item) > height * math.min(1, 736 / width)
  return html.tag("figure", {class = below and "item below" or "item", id = item.id}, table.concat({
    html.tag("a", {href = href}, image), html.tag("figcaption", nil, heading(item, r)), reason(item), more or "",
    check_tables.of_item(item)}, "\n"))
end

-- Whether a table is one that the paper prints: it says so, or holds printed numbers.
local function of_paper(item)
  if select(2, own_number(item.title)) or item.title:find("Table %d") then return true end
  for _, check in ipairs(item.checks) do
    if check.source == "print" then return true end
  end
  return false
end

-- A table: the display table if there is one, `more` of the same item, then the checks.
function items.table(item, r, more)
  local display = ""
  local rows = item.rows or {}
  if #rows > 0 then
    local cells, beyond = {}, {} -- the columns that have a cell which is neither a number, with its unit or not, nor a dash
    for i, row in ipairs(rows) do
      cells[i] = {}
      for j, cell in ipairs(row) do
        local text = type(cell) == "number" and ("%.6g"):format(cell) or tostring(cell)
        local begins = text:find("^%s*[-+−]?%.?%d")
        local numeric, short = begins and not text:find("%a%a"), utf8.len(text) < 16
        if not (begins and (numeric or short) or text == "–" or text == "") then beyond[j] = true end
        cells[i][j] = {numeric and html.number(text) or html.text(text), class = numeric and "number" or short and "short" or "long"}
      end
    end
    for _, row in ipairs(cells) do
      for j, cell in ipairs(row) do
        if not beyond[j] then cell.class = "number" end
      end
    end
    if item.open == "checks" then
      display = html.tag("details", {class = "more"}, html.tag("summary", nil, ("The table, %d rows"):format(#rows)) .. html.table("display", item.columns or {}, cells))
    else
      display = html.folded_table("display", item.columns or {}, cells, of_paper(item) and whole or most_rows)
    end
  end
  return html.tag("section", {class = "item", id = item.id}, table.concat({
    html.tag("p", {class = "caption"}, heading(item, r)), reason(item), display, more or "",
    check_tables.of_item(item)}, "\n"))
end

-- Where a reader finds an item: on this page or on the chapter's other one.
function items.href(item, r, page)
  local file = item.page == "study" and r.chapter .. "-study.html" or r.chapter .. ".html"
  return (item.page == page and "" or file) .. "#" .. item.id
end

-- "Figure 1.3", as a link.
function items.link(item, r, page)
  return html.tag("a", {href = items.href(item, r, page)}, html.escape(items.label(item, r)))
end

-- The item of an id, of the id of a check, or of "table-2/31-*", several checks of one item.
function items.home(id, r)
  local check = r.check[id]
  return r.item[id] or check and r.item[check.item] or r.item[id:match("^(.-)/") or ""]
end

-- Text that names items and stability cases of the chapter by their ids, as HTML that names them as the page does.
function items.named(text, r, page)
  local text = html.text(text):gsub("%f[%w%-/_][%w%-/_]+%-[%w%-_]*%w", function(id)
    local item = r.item[id]
    if item then return items.link(item, r, page) end
    for _, s in ipairs(r.stability) do
      if s.id == id then
        local file = page == (r.has_study and "study" or "paper") and "" or r.chapter .. (r.has_study and "-study" or "") .. ".html"
        return "“" .. html.tag("a", {href = file .. "#stability/" .. id}, html.text(s.case)) .. "”"
      end
    end
  end)
  return text
end

-- The paper, row by row, and what treats it.
function items.coverage(r, page)
  local rows = {}
  local function link(id)
    local check, home = r.check[id], items.home(id, r)
    if not home then return html.tag("code", nil, html.escape(id)) end
    if not check then return items.link(home, r, page) end
    local href = items.href(home, r, page):gsub("#.*$", "") .. "#" .. check.id
    return html.tag("a", {href = href}, html.badge(check.pass and check.outcome or "failed"))
  end
  for i, row in ipairs(r.inventory) do
    local treated = {}
    for j, id in ipairs(row.treated) do treated[j] = link(id) end
    if row.symbol ~= "" then treated[#treated + 1] = html.tag("code", nil, html.escape(row.symbol)) end
    rows[i] = {html.text(row.place), html.text(row.number ~= "" and row.number or row.kind), html.text(row.what),
      table.concat(treated, " ") .. (#treated > 0 and row.reason ~= "" and "; " or "") .. items.named(row.reason, r, page)}
  end
  local papers = not (r.paper or ""):match("^Addition") -- else a chapter beyond the papers
  local content = html.table("coverage cards", {"place", "number", papers and "what the paper has" or "what is compared", "here"}, rows)
  return html.tag("details", {class = "more", id = "paper-row-by-row"},
    html.tag("summary", nil, (papers and "The paper row by row: %d equations, numbers, figures and claims, with what treats each"
      or "What is compared, row by row: %d"):format(#rows)) .. content)
end

function items.verdicts(r, page)
  local rows = {}
  for i, item in ipairs(r.items) do
    local passed, total = record.tally(item.checks)
    rows[i] = {
      items.link(item, r, page), items.title(item),
      {total > 0 and ("%d of %d"):format(passed, total) or "–", class = "number"},
      html.badge(item.failure and "failed" or item.input), html.text(item.failure or item.reason)}
  end
  return html.folded_table("verdicts", {"item", "what", "checks passed", "input", "reason"}, rows, most_rows)
end

-- What became of all checks, in a line.
function items.checks(r)
  local passed, total = record.tally(r.checks)
  local paper, others = {}, {}
  for _, check in ipairs(r.checks) do table.insert(check.of_paper and paper or others, check) end
  local function counts(checks)
    local parts = {}
    for _, pair in ipairs(record.count(checks)) do
      parts[#parts + 1] = html.tag("span", {class = "count"}, pair[2] .. " " .. html.badge(pair[1]))
    end
    return table.concat(parts, " ")
  end
  local out = {passed == total and ("All %d automatic checks pass."):format(total) or ("%d of %d checks passed."):format(passed, total)}
  if #paper > 0 then out[#out + 1] = "Of the paper’s numbers and claims " .. counts(paper) .. (#others > 0 and ";" or ".") end
  if #others > 0 then out[#out + 1] = (#paper > 0 and "against" or "Against") .. " other works and methods " .. counts(others) .. "." end
  out[#out + 1] = html.tag("a", {href = "reading.html#what-the-words-mean"}, "What these words mean") .. "."
  return html.tag("p", {class = "tally"}, table.concat(out, " "))
end

return items
