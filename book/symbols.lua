-- The symbols of a chapter, data/symbols.csv (symbol in TeX, meaning, unit, value), and where they stand in formulas: there each
-- carries its number in the list, for a reader who wants its meaning, and one that the list lacks is an error.
-- A listed symbol may be a letter, a letter with a subscript or an accent (x_a, \bar x), or several letters (\Delta t). A listed
-- x_i stands for x_1 and x_{i+1} too. \dot x and x^2 are the symbol x. Not symbols: numbers, operators, names of functions, the d of
-- a differential, \Delta and \partial before a symbol, e, i, \pi, and the index of a listed x_i.

local html = require "html"

local symbols = {}

-- The lines of CSV as lists of fields.
function symbols.parse(text)
  local rows, row, at = {}, {}, 1
  text = text:gsub("\r", "")
  if not text:find("\n$") then text = text .. "\n" end
  while at <= #text do
    local field
    if text:sub(at, at) == '"' then
      local stop = at
      repeat stop = text:find('"', stop + 1, true) or error("a quoted field is not closed", 0) until text:sub(stop + 1, stop + 1) ~= '"' or
        (function() stop = stop + 1 return false end)()
      field, at = text:sub(at + 1, stop - 1):gsub('""', '"'), stop + 1
    else
      local stop = text:find("[,\n]", at)
      field, at = text:sub(at, stop - 1), stop
    end
    row[#row + 1] = field
    if text:sub(at, at) == "\n" then
      if #row > 1 or row[1] ~= "" then rows[#rows + 1] = row end
      row = {}
    end
    at = at + 1
  end
  return rows
end

-- ---- MathML as a tree: {tag, attributes, children} or {tag, attributes, text = ...}

local function parse(text)
  local root = {tag = "", children = {}}
  local stack, at = {root}, 1
  while true do
    local open, close, slash, tag, attributes = text:find("<(/?)([%a]+)([^>]*)>", at)
    if not open then break end
    local top = stack[#stack]
    if slash == "/" then
      if #top.children == 0 then top.text = text:sub(at, open - 1) end
      stack[#stack] = nil
    else
      local node = {tag = tag, attributes = attributes, children = {}}
      table.insert(top.children, node)
      stack[#stack + 1] = node
    end
    at = close + 1
  end
  return root
end

local function write(node, out)
  if node.tag ~= "" then out[#out + 1] = "<" .. node.tag .. (node.symbol and (' data-s="%d"'):format(node.symbol) or "") .. node.attributes .. ">" end
  if node.text then out[#out + 1] = node.text end
  for _, child in ipairs(node.children) do write(child, out) end
  if node.tag ~= "" then out[#out + 1] = "</" .. node.tag .. ">" end
  return out
end

-- What is drawn alike is written alike: spaces, and groups of one, do not count.
local function key_of(node)
  if node.tag == "mspace" then return "" end
  if #node.children == 0 then
    local style = node.attributes:match('mathvariant="normal"') and node.tag == "mi" and "|upright " or ""
    return style .. (node.text or "")
  end
  local parts = {}
  for _, child in ipairs(node.children) do
    local part = key_of(child)
    if part ~= "" then parts[#parts + 1] = part end
  end
  local group = node.tag == "mrow" or node.tag == "" or node.tag == "semantics" or node.tag == "math"
  if group then return table.concat(parts, " ") end
  return node.tag .. "(" .. table.concat(parts, ";") .. ")"
end

local letters = {}
for name, letter in ("alpha α beta β gamma γ delta δ epsilon ϵ varepsilon ε zeta ζ eta η theta θ vartheta ϑ iota ι kappa κ lambda λ mu μ nu ν xi ξ pi π rho ρ varrho ϱ sigma σ tau τ upsilon υ phi ϕ varphi φ chi χ psi ψ omega ω Gamma Γ Delta Δ Theta Θ Lambda Λ Xi Ξ Pi Π Sigma Σ Phi Φ Psi Ψ Omega Ω ell ℓ"):gmatch("(%a+) (%S+)") do
  letters[letter] = "\\" .. name
end

-- A symbol as TeX, for a message.
local function tex_of(node)
  local c = node.children
  if node.tag == "msub" then
    local subscript = tex_of(c[2])
    return tex_of(c[1]) .. "_" .. (#subscript > 1 and "{" .. subscript .. "}" or subscript)
  end
  if node.tag == "msubsup" then return tex_of(c[1]) .. "_{" .. tex_of(c[2]) .. "}^{" .. tex_of(c[3]) .. "}" end
  if node.tag == "msup" then return tex_of(c[1]) .. "^{" .. tex_of(c[2]) .. "}" end
  if node.tag == "mover" then
    local marks = {["‾"] = "\\bar", ["¯"] = "\\bar", ["̄"] = "\\bar", ["ˆ"] = "\\hat", ["˜"] = "\\tilde", ["→"] = "\\vec", ["˙"] = "\\dot", ["¨"] = "\\ddot"}
    return (marks[c[2].text or ""] or "\\overset") .. "{" .. tex_of(c[1]) .. "}"
  end
  if #c == 0 then return node.tag == "mspace" and "" or node.tag == "mtext" and "\\text{" .. (node.text or "") .. "}" or letters[node.text] or node.text or "" end
  local parts = {}
  for i, child in ipairs(c) do parts[i] = tex_of(child) end
  return (table.concat(parts, " "):gsub("(%W) ", "%1"):gsub(" ([^%w])", "%1"):gsub("(%f[\\%w]%w) %f[%w]", "%1"))
end

-- ---- the list

local ignored = {["e"] = true, ["i"] = true, ["π"] = true, ["∂"] = true, ["∇"] = true, ["Δ"] = true, ["/"] = true, ["′"] = true, ["″"] = true,
  ["‴"] = true, ["⁗"] = true, ["∞"] = true, ["…"] = true, ["⋯"] = true, ["%"] = true, ["°"] = true, ["!"] = true, ["ℜ"] = true, ["ℑ"] = true}
local derivative = {["˙"] = true, ["¨"] = true, ["̇"] = true, ["̈"] = true}

-- Whether a subscript consists of indices: numbers and letters from i to n, which are gathered in `seen`.
local function is_index(node, seen)
  if #node.children == 0 then
    if node.tag == "mn" or node.tag == "mspace" then return true end
    if node.tag == "mo" then return ({["+"] = true, ["−"] = true, [","] = true, ["±"] = true, ["′"] = true})[node.text] or false end
    if node.tag ~= "mi" or not (node.text or ""):find("^[i-n]$") then return false end
    seen[node.text] = true
    return true
  end
  for _, child in ipairs(node.children) do
    if not is_index(child, seen) then return false end
  end
  return true
end

-- Whether a superscript is no power: a word, or the T of a transposed matrix.
local function is_label(node)
  if node.tag == "mi" then return node.text == "T" end
  for _, child in ipairs(node.children) do
    if child.tag ~= "mi" or not (child.text or ""):find("^%a$") then return false end
  end
  return #node.children > 2
end

-- Reads the list; throws a text that names what is wrong with it.
function symbols.load(path)
  local file = io.open(path)
  if not file then return nil end
  local text = file:read("a")
  file:close()
  local good, rows = pcall(symbols.parse, text)
  if not good then error(path .. ": " .. rows, 0) end
  if not rows[1] or table.concat(rows[1], ",") ~= "symbol,meaning,unit,value" then
    error(path .. ": the first line is not symbol,meaning,unit,value", 0)
  end
  local list = {path = path, by_key = {}, index = {}, generic = {}, longest = 1}
  for i = 2, #rows do
    local row = rows[i]
    local tex = (row[1] or ""):gsub("^%$", ""):gsub("%$$", "")
    if #row ~= 4 then error(("%s: the line of %s has %d fields, not 4"):format(path, tex, #row), 0) end
    if not row[2]:find("%S") then error(("%s: %s has no meaning"):format(path, tex), 0) end
    local set = html.formula(tex, "InlineMath")
    if not set then error(("%s: the symbol %s is not TeX that can be set"):format(path, tex), 0) end
    local tree = parse((set:gsub("<annotation.-</annotation>", "")))
    local node = tree
    while #node.children == 1 do node = node.children[1] end
    local entry = {tex = tex, math = set, meaning = row[2], unit = row[3], value = row[4]}
    local key = key_of(node)
    if list.by_key[key] then error(("%s: the symbol %s is listed twice"):format(path, tex), 0) end
    list[#list + 1] = entry
    entry.number, list.by_key[key] = #list, #list
    if node.tag == "mrow" then
      local count = 0
      for _, child in ipairs(node.children) do count = count + (child.tag ~= "mspace" and 1 or 0) end
      list.longest = math.max(list.longest, count)
    end
    if node.tag == "msub" then
      local seen = {}
      if is_index(node.children[2], seen) and next(seen) then
        for letter in pairs(seen) do list.index[letter] = true end
        local base = key_of(node.children[1])
        list.generic[base] = list.generic[base] or entry
      end
    end
  end
  return list
end

-- ---- a formula

-- Adds the numbers of the symbols to a formula and calls `missing` with each symbol (TeX) that the list lacks.
function symbols.mark(list, formula, missing)
  local head, rest = formula:match("^(.-)(<annotation.*)$")
  if not head then
    head, rest = formula:match("^(.*)(</math>)$")
  end
  if not head then return formula end
  local tree = parse(head .. "</math>")
  local integral = head:find("∫", 1, true) ~= nil
  local visit
  local indices, lacking = {}, {} -- of this formula
  local function lacks(node)
    lacking[#lacking + 1] = tex_of(node)
  end

  -- a symbol that the list has as it stands
  local function listed(node)
    local number = list.by_key[key_of(node)]
    if number then node.symbol = number end
    return number ~= nil
  end

  local function base_and(node, ...)
    visit(node)
    for _, part in ipairs({...}) do visit(part) end
  end

  local function is_letter(node) return node and (node.tag == "mi" or node.tag == "msub" or node.tag == "msup" or node.tag == "mover" or node.tag == "msubsup" or node.tag == "mo" and node.text == "ℓ") end

  local function subscripted(node, base, subscript)
    local number = list.by_key["msub(" .. key_of(base) .. ";" .. key_of(subscript) .. ")"]
    if number then
      node.symbol = number
      return true
    end
    local entry = list.generic[key_of(base)]
    local seen = {}
    if entry and is_index(subscript, seen) then
      for letter in pairs(seen) do indices[letter] = true end
      node.symbol = entry.number
      return true
    end
    if base.tag == "mrow" or base.tag == "mo" and base.text ~= "ℓ" then -- a sum, a limit, a bracket
      visit(base)
      visit(subscript)
      return true
    end
    if base.tag == "mover" and derivative[base.children[2].text] and subscripted(node, base.children[1], subscript) then return true end
    return false
  end

  local function sequence(children)
    local i = 1
    while i <= #children do
      local taken = false
      for length = list.longest, 2, -1 do -- several letters that are one symbol
        local parts, last = {}, i
        while children[last] and #parts < length do
          local part = key_of(children[last])
          if part ~= "" then parts[#parts + 1] = part end
          last = last + 1
        end
        local number = #parts == length and children[i].tag ~= "mspace" and list.by_key[table.concat(parts, " ")]
        if number then
          local row = {tag = "mrow", attributes = "", children = {}, symbol = number}
          for _ = i, last - 1 do table.insert(row.children, table.remove(children, i)) end
          table.insert(children, i, row)
          taken = true
          break
        end
      end
      local node, following = children[i], children[i + 1]
      while following and following.tag == "mspace" do following = children[i + 2] end
      local d = node.tag == "mi" and node.text or node.tag == "msup" and node.children[1].text
      local differential = d == "d" and (is_letter(following) or node.tag == "msup") and (integral or children.fraction or i == 1 and not children[3])
      local order = (node.text == "O" or node.text == "o") and following and (key_of(following):find("^%(") or following.text == "(")
      if not (taken or differential or order) then visit(node) end
      i = i + 1
    end
  end

  function visit(node)
    local c = node.children
    if node.tag == "mtext" or node.tag == "mn" or node.tag == "mspace" then return end
    if node.tag == "mi" or node.tag == "mo" and node.text == "ℓ" then
      local text = node.text or ""
      if listed(node) or ignored[text] or text:find("^[%p%d%s]*$") or #text > 1 and text:find("^[%a%s]+$") then return end
      if node.attributes:find('mathvariant="normal"', 1, true) or list.index[text] then return end
      return lacks(node)
    end
    if node.tag == "mo" then return end
    if node.tag == "mstyle" and node.attributes:find("mathvariant", 1, true) then
      if not listed(node) and not node.attributes:find('"normal"', 1, true) then lacks(node) end
      return
    end
    if node.tag == "msub" then
      if not subscripted(node, c[1], c[2]) then lacks(node) end
    elseif node.tag == "msup" then
      if not listed(node) then base_and(c[1], not is_label(c[2]) and c[2] or nil) end
    elseif node.tag == "msubsup" then
      if not listed(node) then
        if not subscripted(node, c[1], c[2]) then lacks({tag = "msub", attributes = "", children = {c[1], c[2]}}) end
        if not is_label(c[3]) then visit(c[3]) end
      end
    elseif node.tag == "mover" then
      if listed(node) then return end
      local mark = c[2].text or ""
      local whole = c[1].tag == "mi" or c[1].tag == "msub" -- a bar over an expression is its mean
      if derivative[mark] or not whole then return visit(c[1]) end
      lacks(node)
    elseif node.tag == "mfrac" then
      for _, part in ipairs(c) do
        local row = part.tag == "mrow" and part.children or {part}
        row.fraction = true
        sequence(row)
        if part.tag ~= "mrow" then node.children[part == c[1] and 1 or 2] = row[1] end
      end
    else
      sequence(c)
    end
  end

  sequence(tree.children)
  for _, symbol in ipairs(lacking) do
    if not indices[symbol] then missing(symbol) end
  end
  return (table.concat(write(tree, {})):gsub("</math>$", "")) .. rest
end

-- ---- how the list looks

local function unit_of(entry) return html.unit(html.escape(entry.unit)) end

-- ", in" or, where a value is known, ", 0.5 in".
local function worth(entry, value)
  local unit = entry.unit ~= "" and entry.unit ~= "1" and unit_of(entry) or ""
  if entry.value == "" then return unit ~= "" and ", " .. unit or "" end
  local text = value(entry.value)
  return ", " .. text .. (unit ~= "" and not text:gsub("<[^>]*>", ""):find("%a") and " " .. unit or "")
end

-- The list, in as many columns as there is room for. `value` makes HTML of the text of a value; without anchors, where another page
-- shows it.
function symbols.list(list, value, no_anchors)
  local out = {}
  for i, entry in ipairs(list) do
    out[i] = html.tag("li", {id = not no_anchors and "symbol-" .. entry.number or nil}, entry.math .. " " .. html.text(entry.meaning)
      .. html.tag("span", {class = "unit"}, worth(entry, value)))
  end
  local content = html.tag("ul", {class = "symbols"}, table.concat(out, "\n"))
  if no_anchors then return content end
  return html.tag("details", {class = "more"}, html.tag("summary", nil, ("The %d symbols of the page, with units and values"):format(#list)) .. content)
end

-- What a reader's page takes the meanings from.
function symbols.meanings(list, value)
  local out = {}
  for i, entry in ipairs(list) do
    out[i] = ('<li id="meaning-%d">%s: %s</li>'):format(entry.number, entry.math, html.text(entry.meaning) .. worth(entry, value))
  end
  return '<ul id="meanings" hidden>\n' .. table.concat(out, "\n") .. "\n</ul>"
end

return symbols
