-- MathML as browsers set it: pandoc's writer leaves combining accents, sizes without unit and letters one by one.

local mathml = {}

local accents = {["̇"] = "˙", ["̈"] = "¨", ["̂"] = "ˆ", ["̃"] = "˜", ["⃗"] = "→", ["̄"] = "¯"}

local signed = {["−"] = true, ["+"] = true, ["±"] = true, ["∓"] = true}

-- A sign after one of these belongs to what follows it.
local before_sign = {}
for sign in ("= ≈ ≤ ≥ < > &lt; &gt; ( [ { , ; : ± × ⋅ ∈ ∼ ≪ ≫ → |"):gmatch("%S+") do before_sign[sign] = true end

local function upright(inner)
  local letters = inner:gsub("<mi>([%a])</mi>", "%1")
  if letters:find("^%a%a+$") then return "<mi>" .. letters .. "</mi>" end
  if letters:find("^%a$") then return '<mi mathvariant="normal">' .. letters .. "</mi>" end
  return nil
end

local function signs(text)
  local out, at, previous = {}, 1, nil
  while true do
    local open, close, attributes, sign = text:find("<mo([^>]*)>([^<]*)</mo>", at)
    if not open then break end
    local between = text:sub(at, open - 1)
    out[#out + 1] = between
    local beside = previous and not between:gsub("<mspace[^>]*></mspace>", ""):find("%S")
    local unary = beside and before_sign[previous] and attributes == "" and signed[sign]
    out[#out + 1] = unary and '<mo form="prefix">' .. sign .. "</mo>" or text:sub(open, close)
    previous, at = sign, close + 1
  end
  return table.concat(out) .. text:sub(at)
end

local function one(text)
  local formula, annotation = text:match("^(.-)(<annotation.*)$")
  formula = formula or text
  for sign in pairs(signed) do formula = formula:gsub("<mi>" .. sign .. "</mi>", "<mo>" .. sign .. "</mo>") end -- pandoc 3.1 writes signs so
  formula = formula:gsub('<mo accent="true">([^<]*)</mo>', function(mark)
    return accents[mark] and '<mo accent="true" stretchy="false">' .. accents[mark] .. "</mo>"
  end)
  formula = formula:gsub('minsize="([%d.]+)" maxsize="([%d.]+)" stretchy="false"', 'stretchy="true" minsize="%1em" maxsize="%2em"')
  formula = formula:gsub('<mstyle mathvariant="normal">(.-)</mstyle>', upright)
  formula = formula:gsub("<mtable>(.-)</mtable>", function(rows) -- the parts of an aligned equation are as large as the equation
    if not rows:find('columnalign="right"', 1, true) then return nil end
    rows = rows:gsub('(<mtd columnalign="left">)<mo>([^<]*)</mo>', function(cell, sign)
      return signed[sign] and cell .. '<mspace width="0.222em"></mspace><mo form="infix">' .. sign .. "</mo>"
    end)
    return '<mtable class="aligned" displaystyle="true">' .. rows .. "</mtable>"
  end)
  local bare = signs(formula):gsub(' xmlns="http://www.w3.org/1998/Math/MathML"', ""):gsub("^(<math[^>]*>)<semantics>", "%1")
  return bare .. (annotation and "</math>" or "")
end

-- HTML with its formulas mended, without their TeX.
function mathml.mend(text) return (text:gsub("<math.-</math>", one)) end

return mathml
