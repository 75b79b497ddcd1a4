-- Symbols and units, how to cite, and what changed.

local html = require "html"

local appendix = {}

local function stop(text)
  io.stderr:write("book: ", text, "\n")
  os.exit(1)
end

local function read(path)
  local file = io.open((os.getenv("RAILBOOK_ROOT") or ".") .. "/" .. path)
  if not file then return nil end
  local text = file:read("a")
  file:close()
  return text
end

-- The lists of symbols that the chapters' pages left.
function appendix.symbols(records, parts)
  local out = {}
  for _, r in ipairs(records) do
    local list = parts[r.chapter] and parts[r.chapter].symbols
    if list then
      out[#out + 1] = html.tag("h2", {id = r.chapter}, html.tag("a", {href = r.chapter .. ".html"}, r.number .. " " .. html.text(r.title))) .. list
    end
  end
  return table.concat(out, "\n")
end

local names = {metre = "m", millimetre = "mm", micrometre = "µm", kilometre = "km", inch = "in", foot = "ft", yard = "yd", mile = "mi", second = "s", millisecond = "ms",
  hour = "h", kilometre_per_hour = "km/h", mph = "mph", kilogram = "kg", pound = "lb", newton = "N", kilonewton = "kN", lbf = "lbf", kip = "kip", pascal = "Pa", megapascal = "MPa",
  gigapascal = "GPa", psi = "psi", ksi = "ksi", degree = "°", slug = "slug"}
local si = {{"m", "metre millimetre micrometre kilometre inch foot yard mile"}, {"s", "second millisecond hour"}, {"m/s", "kilometre_per_hour mph"},
  {"kg", "kilogram pound slug"}, {"N", "newton kilonewton lbf kip"}, {"Pa", "pascal megapascal gigapascal psi ksi"}, {"rad", "degree"}}

-- The constants of lib/units as a table: what one of each unit is in SI.
function appendix.units()
  local text = read("lib/units/constants.hpp")
  if not text then return "" end
  local value = {pi = math.pi}
  for name, expression in text:gmatch("inline constexpr double ([%w_]+) = ([^;]+);") do
    if name ~= "pi" then
      local formula = load("return " .. expression, name, "t", value)
      local good, number = pcall(formula or error)
      if not good then stop("lib/units/constants.hpp: cannot evaluate " .. name .. " = " .. expression) end
      value[name] = number
    end
  end
  local rows = {}
  for _, kind in ipairs(si) do
    for name in kind[2]:gmatch("%S+") do
      if value[name] and value[name] ~= 1 then
        rows[#rows + 1] = {html.escape(names[name]), html.text((name:gsub("_", " "))), {html.number(("%.10g"):format(value[name])), class = "number"}, kind[1]}
      end
    end
  end
  return html.table("units", {"unit", "name", "is", "in"}, rows)
end

-- CITATION.cff as a sentence and as BibTeX, and the papers.
function appendix.cite(records)
  local cff = read("CITATION.cff")
  if not cff then return "" end
  local own = cff:match("^(.-)\nreferences:") or cff
  local function field(name) return own:match("\n" .. name:gsub("%-", "%%-") .. ': "?([^"\n]+)"?') or stop("CITATION.cff has no " .. name) end
  local authors = {}
  for name in own:gmatch('%- name: "([^"]+)"') do authors[#authors + 1] = name end
  local title, version, year = field("title"), field("version"), field("date-released"):match("^%d+")
  local bibtex = ("@software{railbook,\n  title   = {%s},\n  author  = {{%s}},\n  version = {%s},\n  year    = {%s},\n  license = {%s}\n}"):format(
    title, table.concat(authors, " and "), version, year, field("license"))
  local papers = {}
  for _, r in ipairs(records) do
    if r.paper and not r.paper:match("^Addition") then
      local doi = r.doi and r.doi ~= "" and " " .. html.tag("a", {class = "doi", href = "https://doi.org/" .. r.doi}, "doi:" .. html.escape(r.doi)) or ""
      papers[#papers + 1] = html.tag("li", nil, html.tag("a", {href = r.chapter .. ".html"}, "Chapter " .. r.number) .. ": " .. html.text(r.paper) .. doi)
    end
  end
  return html.tag("p", nil, html.escape(("%s (%s). %s, version %s."):format(table.concat(authors, ", "), year, title, version)))
    .. html.tag("div", {class = "code"}, html.tag("pre", nil, html.tag("code", nil, html.escape(bibtex))))
    .. html.tag("h2", {id = "papers"}, "The papers") .. html.tag("ul", nil, table.concat(papers, "\n"))
end

-- CHANGELOG.md without its title.
function appendix.changes()
  local text = read("CHANGELOG.md")
  if not text then return "" end
  local doc = pandoc.read(text:gsub("^# [^\n]*\n", ""), "markdown-citations")
  return pandoc.write(doc, "html", {wrap_text = "none"})
end

return appendix
