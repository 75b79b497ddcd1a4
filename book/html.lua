-- Small pieces of HTML: escaping, numbers, badges, tables.

local mathml = require "mathml"

local html = {}

function html.escape(text)
  return (tostring(text):gsub("[&<>\"]", {["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;"}))
end

-- `<name key="value">content</name>`; attributes in alphabetical order, so that pages are reproducible.
function html.tag(name, attributes, content)
  local keys, out = {}, {"<" .. name}
  for key in pairs(attributes or {}) do keys[#keys + 1] = key end
  table.sort(keys)
  for _, key in ipairs(keys) do out[#out + 1] = (' %s="%s"'):format(key, html.escape(attributes[key])) end
  local opening = table.concat(out) .. ">"
  return content and opening .. content .. "</" .. name .. ">" or opening
end

-- ---- numbers: one way of writing them for texts, tables, captions and values

local thin = "\u{202f}"

-- 12345.678 as 12 345.678; four digits stay together.
local function grouped(digits)
  if #digits < 5 then return digits end
  return (digits:reverse():gsub("%d%d%d", "%0 "):reverse():gsub("^ ", ""):gsub(" ", thin))
end

-- The units that stay on the line of their number.
local units = {}
for unit in ([[% mm cm m km µm ft in mil Hz kHz s ms µs ns min h N kN MN GN MPa GPa psi lb lbf mph rad mrad deg mg g W kW dB bits
  mm² m² m/s m/s² km/h ft/s rad/s ft²]]):gmatch("%S+") do units[unit] = true end

-- Is the text a unit, perhaps with a full stop or a comma behind it?
function html.is_unit(text) return units[(text:gsub("[%p]+$", ""))] or text:find("^%%") ~= nil end

local function keep_units(text)
  return (text:gsub("(%d) ([^%s<&]+)", function(digit, unit) return html.is_unit(unit) and digit .. "\u{a0}" .. unit or nil end))
end

-- Plain text with its numbers as the book writes them: 0.005, 33 817.5, −3, 5 µs. Words of a paper, in quotation marks, stay as they are;
-- so do names, file names and other numbers that touch letters.
function html.tidy(text)
  local quotes, out, at = {["“"] = "”", ['"'] = '"'}, {}, 1
  local function tidy(part)
    part = (" " .. part):gsub("([%s(%[±≈<>=,;:/×+-])%.(%d)", "%10.%2"):gsub("−%.(%d)", "−0.%1")
    part = part:gsub("([%s(%[=<>,;:])%-(%d)", "%1−%2")
    part = part:gsub("()%f[%w_./–-](%d%d%d%d%d+)%f[^%w_]()", function(open, digits, close)
      local before, after = part:sub(open - 1, open - 1), part:sub(close, close + 1)
      if before:find("[%w_./#:-]") or after:find("^[/-]") or after:find("^%.%a") then return nil end
      return grouped(digits)
    end)
    part = part:gsub("(%d) ?u([sm])%f[%W]", "%1 µ%2")
    return keep_units(part):sub(2)
  end
  while at <= #text do
    local open, close
    for mark, ending in pairs(quotes) do
      local from = text:find(mark, at, true)
      local to = from and text:find(ending, from + #mark, true)
      if to and (not open or from < open) then open, close = from, to + #ending - 1 end
    end
    if not open then break end
    out[#out + 1] = tidy(text:sub(at, open - 1)) .. text:sub(open, close)
    at = close + 1
  end
  return table.concat(out) .. tidy(text:sub(at))
end

-- 1.2e-05 inside a text as 1.2×10⁻⁵; a bare 1e5 may be a name.
local function power_of_ten(text)
  text = text:gsub("%f[%w.]1[eE]([+-])0*(%d+)%f[%W]", function(sign, exponent)
    return "10<sup>" .. (sign == "-" and "−" or "") .. exponent .. "</sup>"
  end)
  text = text:gsub("%f[%w.]1e(%d%d%d?)%f[^%w]", "10<sup>%1</sup>")
  return (text:gsub("(%d)[eE]([+-])0*(%d+)", function(digit, sign, exponent)
    return digit .. "×10<sup>" .. (sign == "-" and "−" or "") .. exponent .. "</sup>"
  end))
end

html.power_of_ten = power_of_ten

-- Units as they are written: in^2, lb-s^-1, N·m, µm. The text is escaped already.
function html.unit(text)
  text = text:gsub("%*", "·"):gsub("(%a)%.(%a)", "%1·%2"):gsub("%f[%w]u([mNs])%f[%W]", "µ%1"):gsub("%f[%w]N m%f[%W]", "N·m")
  text = text:gsub("%f[%w]([%a]+)(%d)%f[%W]", function(name, power) -- N·m2
    return ({m = true, mm = true, cm = true, ft = true, ["in"] = true, s = true, rad = true})[name] and name .. "^" .. power
  end)
  return (text:gsub("%^(-?)(%d+)", function(sign, power)
    return "<sup>" .. (sign == "-" and "−" or "") .. power .. "</sup>"
  end))
end

-- A number as text, 1.2e-05 or "-3.4 psi", the way it is printed: 1.2×10⁻⁵, −3.4 psi. Other text: tidied, with its powers of ten.
function html.number(text)
  text = tostring(text):gsub("^([+-]?[%d.]+)[eE](%d+)$", "%1e+%2")
  local number, rest = text:match("^([+-]?%.?%d[%d.,eE+-]*)(.*)$")
  if not number then return power_of_ten(html.escape(html.tidy(text))) end
  number = html.tidy((number:gsub("^-", "−"):gsub("^%+", "+")))
  local is_unit = #rest < 24 and not rest:find("%f[%w]%a%a%a%a%a%a+") and not rest:find("[%(%)\"]") and not rest:find("%s[+−-]?%.?%d")
  if is_unit then return power_of_ten(html.escape(number)) .. html.unit(html.escape((rest:gsub("^ ", "\u{a0}")))) end
  return (power_of_ten(html.escape(html.tidy(number .. rest))):gsub("%^(-?)(%d+)", function(sign, power)
    return "<sup>" .. (sign == "-" and "−" or "") .. power .. "</sup>"
  end))
end

-- The same for a formula.
function html.tex(text)
  local number, unit = text:match("^(%-?%.?%d[%d.,]*)(.*)$")
  if not number then number, unit = "", text end
  local sign, exponent, rest = unit:match("^[eE]([+-]?)0*(%d+)(.*)$")
  if exponent then
    number = ("%s\\times 10^{%s%s}"):format(number, sign == "-" and sign or "", exponent)
    unit = rest
  end
  unit = unit:gsub("^%s+", ""):gsub("[%%#&_$]", "\\%0"):gsub("%^(-?%d+)", "}^{%1}\\text{")
  return unit == "" and number or ("%s\\;\\text{%s}"):format(number, unit)
end

local formulas, finish = {}, nil

-- From now on each formula is what `change` makes of its MathML and its TeX.
function html.finish_formulas(change) formulas, finish = {}, change end

-- A formula as MathML, or nil when its TeX is not understood. `kind` is InlineMath or DisplayMath.
function html.formula(tex, kind)
  local key = kind .. tex
  if formulas[key] then return formulas[key] end
  local doc = pandoc.Pandoc({pandoc.Plain({pandoc.Math(kind, tex)})})
  local out = pandoc.write(doc, "html", {html_math_method = "mathml"}):gsub("%s+$", "")
  if not out:find("<math", 1, true) then return nil end
  out = mathml.mend(out):gsub(' display="inline"', "", 1)
  formulas[key] = finish and finish(out, tex) or out
  return formulas[key]
end

local function formula_of_record(tex)
  local out = html.formula(tex, "InlineMath")
  if out then return out end
  io.stderr:write("book: the formula $", tex, "$ of a record cannot be set\n")
  os.exit(1)
end

-- Plain text: powers of ten, <sub> and <sup> as such, all else escaped.
local function plain(text)
  return (power_of_ten(html.escape(html.tidy(text))):gsub("&lt;(/?su[bp])&gt;", "<%1>"))
end

-- Text of a record: plain, with $...$ as MathML and `...` as code.
function html.text(text)
  local out, at = {}, 1
  text = tostring(text or "")
  while at <= #text do
    local open = text:find("[$`]", at)
    local mark = open and text:sub(open, open)
    local close = open and text:find(mark, open + 1, true)
    if not close then break end
    out[#out + 1] = plain(text:sub(at, open - 1))
    local inner = text:sub(open + 1, close - 1)
    out[#out + 1] = mark == "$" and formula_of_record(inner) or html.tag("code", nil, html.escape(inner))
    at = close + 1
  end
  return table.concat(out) .. plain(text:sub(at))
end

-- A length of time in the unit that suits it.
function html.seconds(seconds)
  if not seconds or seconds == 0 then return "–" end
  for _, unit in ipairs({{1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}, {1e-9, "ns"}}) do
    if seconds >= unit[1] then return ("%.3g %s"):format(seconds / unit[1], unit[2]) end
  end
  return ("%.2g ns"):format(seconds * 1e9)
end

-- A count: 12 345 678.
function html.count(count)
  if type(count) ~= "number" then return "–" end
  if count ~= math.floor(count) or math.abs(count) >= 1e15 then return html.number(("%.6g"):format(count)) end
  return grouped(("%.0f"):format(count))
end

local labels = {paper = "the paper’s data"}

-- The verdict or status as a coloured word.
function html.badge(status)
  return html.tag("span", {class = "badge " .. status:gsub("[^%w-]", "-")}, html.escape(labels[status] or status))
end

-- Heads are texts, or {text, filter = true} where a reader may choose among the values of the column; rows are lists of
-- cells, each HTML or {html, class = ..., sort = number}. The first cell of a row heads it. On a phone a row of a class with the
-- word cards becomes a card, on which each cell says the head of its column (--h2 and so on), and a cell of class outcome comes first.
function html.table(class, heads, rows, caption)
  local cards, names = class:find "%f[%w]cards%f[^%w]", {}
  for i = 2, cards and #heads or 0 do
    local head = type(heads[i]) == "table" and heads[i][1] or heads[i]
    names[#names + 1] = ("--h%d:'%s: '"):format(i, (head:gsub("['\\\\]", "’")))
  end
  local out = {html.tag("table", {class = class .. (#heads > 8 and " many" or ""), style = #names > 0 and table.concat(names, ";") or nil})}
  if caption then out[#out + 1] = html.tag("caption", nil, caption) end
  local cells = {}
  for i, head in ipairs(heads) do
    local below = rows[1] and rows[1][i]
    local filter = type(head) == "table" and head.filter and "yes" or nil
    cells[i] = html.tag("th", {scope = "col", class = type(below) == "table" and below.class or nil, ["data-filter"] = filter},
      html.text(type(head) == "table" and head[1] or head))
  end
  out[#out + 1] = "<thead><tr>" .. table.concat(cells) .. "</tr></thead>\n<tbody>"
  for _, row in ipairs(rows) do
    cells = {}
    for i, cell in ipairs(row) do
      local content = type(cell) == "table" and cell[1] or cell
      local attributes = {class = type(cell) == "table" and cell.class or nil}
      if type(cell) == "table" and type(cell.sort) == "number" then attributes["data-sort"] = ("%.6g"):format(cell.sort) end
      if i == 1 then attributes.scope = "row" end
      if cards and content == "–" then attributes["data-none"] = "" end
      cells[i] = html.tag(i == 1 and "th" or "td", attributes, content)
    end
    out[#out + 1] = html.tag("tr", {class = row.class, id = row.id}, table.concat(cells))
  end
  out[#out + 1] = "</tbody></table>"
  return html.tag("div", {class = "wide"}, table.concat(out, "\n"))
end

-- A table of which the first `most` rows are open and the others folded, when there are several of them.
function html.folded_table(class, heads, rows, most, more)
  if #rows <= most + 3 then return html.table(class, heads, rows) end
  local open, rest = {table.unpack(rows, 1, most)}, {table.unpack(rows, most + 1)}
  return html.table(class, heads, open) .. html.tag("details", {class = "more"},
    html.tag("summary", nil, ("%d more %s"):format(#rest, more or "rows")) .. html.table(class, heads, rest))
end

return html
