-- The equations of the papers: formula, function, test, and the places that use them.

local html, items = require "html", require "items"

local equations = {}

local function exists(path, name)
  local file = io.open((os.getenv("RAILBOOK_ROOT") or ".") .. "/" .. path)
  local text = file and file:read("a")
  if file then file:close() end
  return text and (not name or text:find("%f[%w_]" .. name .. "%f[^%w_]")) and true or false
end

-- Stops the build when the tree does not have what the inventory names.
local function require_named(r, path, name)
  if exists(path, name) then return end
  io.stderr:write(("book: the inventory of %s names %s%s, which is not there\n"):format(r.chapter, path, name and " " .. name or ""))
  os.exit(1)
end

-- The functions of a row, those of the library as links to their contract.
local function functions(row, r, anchors)
  local out = {}
  for path, name in row.symbol:gmatch("(%S+)%s+([%w_]+)") do
    local own = "chapters/" .. r.chapter .. "/" .. path
    if not exists(own, name) then require_named(r, "lib/" .. path, name) end
    local room = path:match("^([%w_]+)/")
    local anchor = room and room .. "-" .. name
    local text = html.tag("code", nil, html.escape(path .. " " .. name))
    out[#out + 1] = anchor and anchors[anchor] and html.tag("a", {href = "library.html#" .. anchor}, text) or text
  end
  return #out > 0 and table.concat(out, " ") or "–"
end

-- `parts`: what the chapters' pages left, with the TeX of their numbered formulas; `anchors`: the names that the page of the
-- library has.
function equations.all(records, parts, anchors)
  local out = {}
  for _, r in ipairs(records) do
    local rows = {}
    for _, row in ipairs(r.inventory) do
      if row.kind == "equation" then
        local treated, number, named = {}, row.number:match("^%(?([%w.-]+)%)?$"), {}
        for _, id in ipairs(row.treated) do
          local item = items.home(id, r)
          if not (item and named[item.id]) then treated[#treated + 1] = item and items.link(item, r, "index") or html.escape(id) end
          if item then named[item.id] = true end
        end
        for path in row.test:gmatch("%S+") do require_named(r, path) end
        local tags = parts[r.chapter] and parts[r.chapter].tags or {}
        if number and not tags[number] and tags[number:match("^%w+")] then number = number:match("^%w+") end -- (7-a) of a joint (7)
        local tex = number and tags[number]
        local anchor = r.chapter .. ".html" .. (tex and "#eq-" .. number or "")
        rows[#rows + 1] = {html.tag("a", {href = anchor}, html.text(row.number ~= "" and row.number or "unnumbered"))
            .. html.tag("span", {class = "place"}, html.text(row.place)),
          {(tex and html.formula(tex, "InlineMath") or "") .. html.tag("p", nil, html.text(row.what)), class = "long"},
          functions(row, r, anchors), row.test ~= "" and html.tag("code", nil, html.escape(row.test)) or "–",
          #treated > 0 and table.concat(treated, ", ") or items.named(row.reason, r, "index")}
      end
    end
    if #rows > 0 then
      out[#out + 1] = html.tag("h2", {id = r.chapter}, r.number .. " " .. html.text(r.title))
      out[#out + 1] = html.table("equations cards", {"equation", "formula", "function", "test", "used in"}, rows)
    end
  end
  return table.concat(out, "\n")
end

return equations
