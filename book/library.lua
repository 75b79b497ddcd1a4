-- The reference of lib/, from its headers alone: the comment above a declaration is its contract.

local html, highlight = require "html", require "highlight"

local library = {}

local function lines_of(path)
  local out = {}
  for line in io.lines(path) do out[#out + 1] = line end
  return out
end

-- Where the declaration that begins at line i ends: a `;` or a `}` at the depth where it began.
local function declaration_end(lines, i)
  local depth = 0
  for j = i, #lines do
    local line = lines[j]:gsub("//.*$", ""):gsub('"[^"]*"', '""'):gsub("'[^']*'", "")
    for c in line:gmatch("[{}()]") do depth = depth + ((c == "{" or c == "(") and 1 or -1) end
    if depth <= 0 and (line:find("[;}]%s*$")) then return j end
  end
  return #lines
end

local function name_of(text)
  if text:find("^using%s+[%w_:]+;") then return nil end -- a name of another's
  text = text:gsub("^template%s*%b<>%s*", ""):gsub("%[%[[^%]]*%]%]%s*", "")
  local kind, name = text:match("^(%a+)%s+([%w_]+)%s*[:{;]?")
  if text:find("^enum%s+class%s") then return text:match("^enum%s+class%s+([%w_]+)"), "type" end
  if kind == "struct" or kind == "class" or kind == "using" or kind == "enum" or kind == "concept" then return name, "type" end
  local before = text:match("^([^{=;]-)%s*%(")
  if before and before:find("%s") then return before:match("([%w_]+)$") or before:match("operator.*$"), "function" end
  return text:match("([%w_]+)%s*[={;]") or text:match("([%w_]+)%s*%["), "constant"
end

-- A declaration without the bodies of its inline functions.
local function shortened(lines, first, last, kind)
  local text = table.concat(lines, "\n", first, last)
  if kind == "function" then
    local open = text:find("{%s*\n") or text:find("{[^{}]*}%s*$")
    if open and text:sub(1, open):find(")") then text = text:sub(1, open - 1):gsub("%s+$", "") .. ";" end
  end
  return text
end

-- {comment, entries = {{name, kind, comment, text, line}}} of a header; what is in namespace detail is not public.
function library.header(path)
  local lines = lines_of(path)
  local out, comment, i, hidden = {entries = {}}, {}, 1, false
  while i <= #lines do
    local line = lines[i]
    if line:find("^//") then
      comment[#comment + 1] = line:gsub("^///? ?", "")
    elseif line:find("^#pragma once") then
      out.comment, comment = table.concat(comment, "\n"), {}
    elseif line:find("^namespace") then
      hidden = line:find("detail") ~= nil
      comment = {}
    elseif line:find("^}") or line == "" or line:find("^#") then
      if line:find("^}") then hidden = false end
      if line == "" then comment = {} end
    else
      local last = declaration_end(lines, i)
      if line:find("^template") and last == i then last = declaration_end(lines, i + 1) end
      local name, kind = name_of(table.concat(lines, " ", i, last))
      local forward = line:find("^[%a]+%s+[%w_]+;%s*$") and (line:find("^class") or line:find("^struct"))
      if name and not hidden and not forward then
        local previous = out.entries[#out.entries]
        local same = #comment == 0 and previous and previous.last == i - 1 and previous.kind == "function" and kind == "function"
        if same then -- the contract stands above the first of several
          previous.text = previous.text .. "\n" .. shortened(lines, i, last, kind)
          previous.last = last
          if previous.names[#previous.names] ~= name then table.insert(previous.names, name) end
        else
          table.insert(out.entries, {name = name, names = {name}, kind = kind, comment = table.concat(comment, "\n"),
            text = shortened(lines, i, last, kind), line = i, last = last})
        end
      end
      comment, i = {}, last
    end
    i = i + 1
  end
  return out
end

-- Prose of a comment: paragraphs, and indented lines as code.
local function prose(text)
  local out, code = {}, {}
  local function close()
    if #code > 0 then out[#out + 1] = html.tag("pre", nil, html.tag("code", nil, html.escape(table.concat(code, "\n")))) end
    code = {}
  end
  local paragraph = {}
  local function finish()
    if #paragraph > 0 then out[#out + 1] = html.tag("p", nil, html.escape(table.concat(paragraph, " "))) end
    paragraph = {}
  end
  for line in (text .. "\n"):gmatch("(.-)\n") do
    if line:find("^  ") then
      finish()
      code[#code + 1] = line:sub(3)
    elseif line == "" then
      finish()
      close()
    else
      close()
      paragraph[#paragraph + 1] = line
    end
  end
  finish()
  close()
  return table.concat(out, "\n")
end

local abbreviations = {eq = true, eqs = true, Fig = true, Figs = true, p = true, pp = true, cf = true, vs = true, al = true, No = true, sec = true}

-- The first sentence of a comment, which may run over several lines.
local function headline(comment)
  local paragraph = (comment .. "\n\n"):match("^%s*(.-)\n%s*\n"):gsub("\n  .*$", ""):gsub("%s+", " ")
  local at = 1
  while true do
    local stop = paragraph:find("%.%f[%s\0]", at)
    if not stop then return (paragraph:gsub("[:,]%s*$", "")) end
    local word = paragraph:sub(1, stop - 1):match("(%a+)$") or ""
    local letter = #word == 1 -- e.g., i.e.
    if not letter and not abbreviations[word] then return paragraph:sub(1, stop) end
    at = stop + 1
  end
end

local function anchor(room, name) return room .. "-" .. name:gsub("[^%w_]+", "-") end

local function section(room, file, header, seen)
  local names, out = {}, {prose(header.comment or "")}
  for _, entry in ipairs(header.entries) do
    for _, name in ipairs(entry.names) do
      local id = anchor(room, name)
      names[#names + 1] = html.tag("code", nil, html.escape(name))
      if not seen[id] then entry.ids = entry.ids or {}; table.insert(entry.ids, id) end
      seen[id] = true
    end
    local ids, others = entry.ids or {}, {}
    for i = 2, #ids do others[i - 1] = html.tag("span", {id = ids[i]}, "") end
    out[#out + 1] = html.tag("div", {class = "declaration", id = ids[1]}, table.concat(others)
      .. html.tag("pre", nil, html.tag("code", nil, html.escape(entry.text))) .. prose(entry.comment))
  end
  local summary = html.tag("b", nil, html.escape(file)) .. " " .. html.escape(headline(header.comment or ""))
    .. html.tag("span", {class = "where"}, table.concat(names, " "))
  return html.tag("details", {class = "more header", id = room .. "-" .. file:match("([^/]+)%.hpp$") .. "-header"},
    html.tag("summary", nil, summary) .. table.concat(out, "\n"))
end

-- The example of a room: the lines between "// example" and "// end" of the test that runs it.
function library.example(room)
  local file = io.open((os.getenv("RAILBOOK_ROOT") or ".") .. "/tests/lib/" .. room .. "/example.cpp")
  if not file then return "" end
  local text = file:read("a")
  file:close()
  local body = text:match("\n *// example\n(.-)\n *// end")
  if not body then return "" end
  local indent = body:match("^ *")
  body = (body .. "\n"):gsub("(.-)\n", function(line) return (line:gsub("^" .. indent, "")) .. "\n" end)
  return html.tag("div", {class = "code"}, highlight.cpp((body:gsub("%s+$", ""))))
end

-- Rooms that only who works on the book or the commands needs: their headers in a line each.
local brief = {report = true, bench = true, plot = true, scene = true, tool = true, files = true}

-- The rooms by what a reader wants, with what each is for. A room that no line names stands in the last group.
local groups = {
  {"Physics", "Wheel, rail, vehicle and track.", {
    {"contact", "normal contact of elastic bodies: Hertz, conjugate gradients with FFT, stresses below the surface"},
    {"rolling", "creep forces of rolling contact: full theory, FASTSIM, creep laws, tables"},
    {"profiles", "curves of wheel and rail: built-in, measured, from files"},
    {"wheelset", "two rigid profiles that touch: contact points, constraint functions, conicity"},
    {"wheel_contact", "from profiles and a pose to patches, pressures, creepages and forces"},
    {"vehicle", "the freight car: parameters and linear stability"},
    {"cycles", "limit cycles of any oscillator: harmonic balance, continuation, Floquet multipliers, tori"},
    {"track", "beams, ties, joints, moving loads and impact"}}},
  {"Measured track", "From a record to numbers about its track.", {
    {"records", "a record of measured track: positions, units, missing samples, screening, warnings"},
    {"spectra", "power spectral densities: estimates, models, joints, classes"}, {"filters", "filters of a geometry car, and what they do to a record"},
    {"geometry_car", "a track-geometry car: sensors, motion, reconstruction of the geometry"},
    {"quality", "track quality: descriptor, exceedances, sections, indices and limits"}}},
  {"Numerics", "What the physics computes with.", {
    {"num", "roots, quadrature, FFT, linear algebra, ODE solvers, random numbers"}, {"units", "constants of units, quantities with units, input errors"},
    {"table", "CSV"}}},
  {"The making of the book and of the commands", "What draws, reports and reads options. Contracts and names stand in the headers.", {
    {"report", "chapters, checks, verdicts, records"}, {"bench", "error against run time"}, {"plot", "figures by gnuplot"}, {"scene", "pictures by OSMesa"},
    {"tool", "options with units, configuration files, answers"}, {"files", "results written safely"}}},
}

-- The page, and what a search finds on it: {{title, anchor, text}}.
function library.all(paths)
  local rooms, order, found, seen = {}, {}, {}, {}
  for _, path in ipairs(paths) do
    local room, file = path:match("([^/]+)/([^/]+)$")
    if not rooms[room] then
      rooms[room], order[#order + 1] = {}, room
    end
    local header = library.header(path)
    if brief[room] then
      table.insert(rooms[room], html.tag("p", nil, html.tag("code", nil, html.escape(room .. "/" .. file)) .. " " .. html.escape(headline(header.comment or ""))))
    else
      table.insert(rooms[room], section(room, room .. "/" .. file, header, seen))
    end
    for _, entry in ipairs(brief[room] and {} or header.entries) do
      found[#found + 1] = {entry.name, anchor(room, entry.name), room .. "/" .. file .. " " .. entry.comment:sub(1, 60):gsub("[\192-\255]?[\128-\191]*$", "")}
    end
  end
  local placed = {}
  for _, group in ipairs(groups) do
    for _, room in ipairs(group[3]) do placed[room[1]] = true end
  end
  for _, room in ipairs(order) do
    if not placed[room] then table.insert(groups[#groups][3], {room, ""}) end
  end
  local out = {}
  for _, group in ipairs(groups) do
    local list, parts = {}, {}
    for _, entry in ipairs(group[3]) do
      local room, what = entry[1], entry[2]
      if rooms[room] then
        list[#list + 1] = html.tag("li", nil, html.tag("a", {href = "#room-" .. room}, html.tag("code", nil, room)) .. (what ~= "" and ": " .. html.text(what) or ""))
        parts[#parts + 1] = html.tag("h3", {id = "room-" .. room}, html.tag("code", nil, "lib/" .. room)) .. html.tag("p", nil, html.text(what:sub(1, 1):upper() .. what:sub(2)) .. ".")
          .. library.example(room) .. table.concat(rooms[room], "\n")
      end
    end
    if #list > 0 then
      local id = group[1]:lower():gsub("%W+", "-")
      out[#out + 1] = html.tag("h2", {id = id}, group[1]) .. html.tag("p", nil, group[2]) .. html.tag("ul", nil, table.concat(list, "\n")) .. table.concat(parts, "\n")
    end
  end
  return html.tag("div", {class = "filterable"}, table.concat(out, "\n")), found
end

return library
