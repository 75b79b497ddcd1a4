-- Pandoc filter: fills a chapter's page from its record.
--   {{id}}              in a text or a formula: a value; the number of a figure or table, as a link
--   {{fig-09}} alone    the figure or table, with its checks; {{table-1: rows}} folds its checks, {{table-1: checks}} its rows
--   {{outcome:id}}      what came of a check, as a link to it
--   {{coverage}} alone  the inventory of the paper
--   {{work-precision}}, {{work-precision: id}}, {{stability}}, {{verdicts}}, {{checks}} alone
--   {{picture: track-joint}} alone  the picture that the example of `railbook track joint` on the page Tools draws
--   {{symbols}} alone   the symbols of data/symbols.csv; a formula has no other ones (see symbols.lua)
-- Metadata: part (paper or study), record (JSON file), figures (folder of its PNGs), data (folder of its CSVs and scripts),
-- chapters (see frame.lua), parts (folder for what the overview pages take from this one).
-- An unknown id, a missing file, or an item of the record that the page does not show exactly once is an error.

package.path = PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/?.lua;" .. package.path
local html, items, record, frame = require "html", require "items", require "record", require "frame"
local symbols = require "symbols"
local drawings, tools, studies, parts = require "drawings", require "tools", require "studies", require "parts"

local r, figures, data, page
local problems, shown, reported, anchors = {}, {}, {}, {}
local docs = PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/../docs"
local symbol_list -- of the chapter, or nil
local tags = {} -- the numbers of the page's display formulas

-- Where the sources say {{text}}: "main.cpp:12".
local function place(token)
  for _, path in ipairs(PANDOC_STATE.input_files) do
    local file, n = io.open(path), 0
    for line in file and file:lines() or function() end do
      n = n + 1
      if line:find(token, 1, true) then return path .. ":" .. n end
    end
    if file then file:close() end
  end
  return r and r.chapter or "?"
end

local function problem(token, message)
  local text = (token and place(token) .. ": " or "") .. message
  if not reported[text] then problems[#problems + 1] = text end
  reported[text] = true
end

local function unknown(token, id)
  problem(token, ("unknown id '%s' (not in %s)"):format(id, r.path))
end

local function exists(path)
  local file = io.open(path)
  if file then file:close() end
  return file ~= nil
end

local function require_data(token, name)
  if not exists(data .. "/" .. name) then
    problem(token, ("%s: the file %s/%s is missing"):format(r.chapter, data, name))
  end
end

-- The value of a symbol, which may be a number of the record, {{id}}.
local function symbol_value(text)
  local out = text:gsub("{{([%w][%w%-_./]*)}}", function(id)
    if not r.value[id] then problem(nil, ("%s: unknown id '%s' (not in %s)"):format(symbol_list.path, id, r.path)) end
    return r.value[id] and r.value[id].text or ""
  end)
  return out:find("[$`]") and html.text(out) or html.number(out)
end

-- The list of the chapter's symbols; from here on formulas are held to it.
local function use_symbols()
  local path = data .. "/printed/symbols.csv"
  local good, list = pcall(symbols.load, path)
  if not good then problem(nil, r.chapter .. ": " .. list:gsub("^.*/printed/", "data/")) end
  if not good then return end
  local name = page == "study" and r.chapter .. "-study" or r.chapter
  if not list then
    html.finish_formulas(function(_, tex)
      problem(nil, ("page %s: there are formulas, $%s$, but no %s/data/symbols.csv that says what their symbols mean"):format(name, tex, r.chapter))
    end)
    return
  end
  symbol_list = list
  list.path = r.chapter .. "/data/symbols.csv"
  html.finish_formulas(function(set, tex)
    return symbols.mark(list, set, function(symbol)
      if reported[symbol] then return end
      reported[symbol] = true
      local message = "page %s: the formula $%s$ has the symbol %s, which %s does not list"
      problem(tex:match("^%s*([^\n]-)%s*\n") or tex:match("^%s*(.-)%s*$"), message:format(name, tex:gsub("%s+", " "):gsub("^ ", ""):gsub(" $", ""), symbol, list.path))
    end)
  end)
end

-- What a picture shows, for who cannot see it, as its script says in lines "# alt: ...".
local function alt_of(path)
  local file, out = io.open(path), {}
  if not file then return nil end
  for line in file:lines() do out[#out + 1] = line:match("^# alt: (.*%S)") end
  file:close()
  return #out > 0 and table.concat(out, " ") or nil
end

local function item_block(item, token, more)
  for _, name in ipairs(item.csv) do require_data(token, name) end
  if item.script then
    item.script_shared = exists(data .. "/../" .. item.script)
    if not item.script_shared then require_data(token, item.script) end
    item.alt = item.alt or alt_of(data .. (item.script_shared and "/../" or "/") .. item.script)
  end
  if item.kind ~= "figure" then return items.table(item, r, more) end
  local good, result = pcall(items.figure, item, r, figures, more)
  if good then return result end
  problem(token, ("%s: %s"):format(r.chapter, result))
  return ""
end

local function mark(key, token)
  if shown[key] then problem(token, ("%s: '%s' is shown twice"):format(r.chapter, key)) end
  shown[key] = true
end

local function symbols_block(token)
  mark("the symbols", token)
  if symbol_list then return symbols.list(symbol_list, symbol_value) end
  problem(token, r.chapter .. " has no data/symbols.csv")
  return ""
end

-- {{outcome:table-2/p0-hertz}}: what came of a check, as a link to it.
local function outcome_of(id, token)
  local check = r.check[id]
  if not check then
    unknown(token, id)
    return pandoc.Str("")
  end
  local href = items.href(r.item[check.item], r, page):gsub("#.*$", "") .. "#" .. id
  return pandoc.RawInline("html", html.tag("a", {href = href}, html.badge(check.pass and check.outcome or "failed")))
end

local function stability(token)
  mark("the stability cases", token)
  if #r.stability == 0 then problem(token, r.path .. " has no stability cases") end
  return studies.stability(r.stability)
end

local function work_precision(id, token)
  local list, ids = {}, {}
  for _, w in ipairs(r.work_precision) do
    if not id or w.id == id then
      list[#list + 1] = w
      ids[w.id] = true
    end
  end
  if #list == 0 then unknown(token, id or "work-precision") end
  for each in pairs(ids) do mark("work-precision: " .. each, token) end
  return studies.work_precision(list)
end

-- An item may have the name of a list, stability say; then it shows the list as well.
local function block_for(name, argument, token)
  local list
  if name == "symbols" then list = symbols_block(token) end
  if name == "coverage" then list = items.coverage(r, page) end
  if name == "picture" and argument then
    list = tools.picture(docs, argument)
    if not list then problem(token, ("no example of docs/commands.txt draws '%s'"):format(argument)) end
    argument = nil
  end
  if name == "verdicts" then list = items.verdicts(r, page) end
  if name == "checks" then list = items.checks(r) end
  if name == "stability" then list = stability(token) end
  if name == "work-precision" then list = work_precision(argument, token) end
  local item = r.item[name]
  if not item then return list end
  if argument and not list and argument ~= "rows" and argument ~= "checks" then
    problem(token, ("%s: '%s' is open in part: allowed: rows, checks"):format(r.chapter, name))
  end
  item.open = argument
  mark(name, token)
  return item_block(item, token, list)
end

-- A display formula that carries a number, \tag{7}, stands in a block with that number and the anchor eq-7.
local function numbered(para)
  local math = para.content[1]
  local number = math and math.t == "Math" and math.text:match("\\tag{([^{}]*)}")
  if not number then return nil end
  math.text = math.text:gsub("\\tag{[^{}]*}", "")
  local after = pandoc.List()
  for i = 2, #para.content do after:insert(para.content[i]) end
  local label = pandoc.RawInline("html", html.tag("a", {class = "number", href = "#eq-" .. number}, html.escape("(" .. number .. ")")))
  local block = pandoc.Div({pandoc.Plain({pandoc.Span({math})  , label})}, {class = "equation"})
  if not anchors[number] then block.identifier = "eq-" .. number end
  anchors[number] = true
  return #after > 0 and {block, pandoc.Para(after)} or block
end

local function only_items(text) return text:find("^%s*{{.*}}%s*$") and not text:gsub("{{[^{}]*}}", ""):find("%S") end

-- A paragraph of nothing but {{...}}; one that is a mere value stays a paragraph.
local function Para(para)
  if #para.content > 0 and para.content[1].t == "Math" then
    local block = numbered(para)
    if block then return block end
  end
  local text = pandoc.utils.stringify(para)
  if not only_items(text) then return nil end
  local out = pandoc.List()
  for inner in text:gmatch("{{([^{}]*)}}") do
    local name, argument = inner:match("^%s*([%w][%w%-_./]*)%s*:?%s*(%S*)%s*$")
    local block = name and block_for(name, argument ~= "" and argument or nil, "{{" .. inner .. "}}")
    if not block then return nil end
    out:insert(pandoc.RawBlock("html", block))
  end
  return out
end

local function value_inlines(value)
  local title = value.value and ("%.10g %s"):format(value.value, value.unit or "") or nil
  return pandoc.RawInline("html", html.tag("span", {class = "value", title = title}, html.number(value.text)))
end

-- "(7)" in the text, where the page has an equation (7), leads there.
local function equation_reference(str)
  local out, at = pandoc.List(), 1
  while true do
    local open, close, number = str.text:find("%((%w[%w.-]*)%)", at)
    if not open then break end
    local beside = str.text:sub(open - 1, open - 1):find("%w") -- the number of an issue: 112(1)
    if tags[number] and not beside then
      if open > at then out:insert(pandoc.Str(str.text:sub(at, open - 1))) end
      out:insert(pandoc.Link({pandoc.Str("(" .. number .. ")")}, "#eq-" .. number, "", {class = "equation-reference"}))
    else
      out:insert(pandoc.Str(str.text:sub(at, close)))
    end
    at = close + 1
  end
  if at == 1 then return nil end
  if at <= #str.text then out:insert(pandoc.Str(str.text:sub(at))) end
  return out
end

-- A word of prose with its number as the book writes it.
local function tidied(str)
  local text = html.tidy(str.text)
  local raised = html.power_of_ten(html.escape(text))
  if raised:find("<sup>", 1, true) then return pandoc.RawInline("html", raised) end
  return text ~= str.text and pandoc.Str(text) or nil
end

-- Words in quotation marks are the paper's, letter by letter.
local function Quoted(quoted)
  quoted.content = quoted.content:walk({Str = function(str)
    return html.tidy(str.text) ~= str.text and not str.text:find("{{", 1, true) and pandoc.RawInline("html", html.escape(str.text)) or nil
  end})
  return quoted
end

local function Str(str)
  if not str.text:find("{{", 1, true) then return equation_reference(str) or tidied(str) end
  local out, at, text = pandoc.List(), 1, str.text
  while true do
    local open, close, id = text:find("{{([%w][%w%-_./:]*)}}", at)
    if not open then break end
    if open > at then out:insert(pandoc.Str(text:sub(at, open - 1))) end
    local value, item, check = r.value[id], r.item[id], id:match("^outcome:(.*)$")
    if check then
      out:insert(outcome_of(check, "{{" .. id .. "}}"))
    elseif value then
      out:insert(value_inlines(value))
    elseif item then
      out:insert(pandoc.Link({pandoc.Str(items.label(item, r))}, items.href(item, r, page), "", {class = "ref"}))
    else
      unknown("{{" .. id .. "}}", id)
    end
    at = close + 1
  end
  local rest = text:sub(at)
  if rest:find("{{", 1, true) then
    problem(rest:match("{{[^{}]*"), "'" .. rest .. "' is not an id: letters, digits, - _ . / between {{ and }}")
  end
  if rest ~= "" then out:insert(pandoc.Str(rest)) end
  return out
end

local function Math(math)
  if not math.text:find("{{", 1, true) then return nil end
  math.text = math.text:gsub("{{([%w][%w%-_./]*)}}", function(id)
    local value = r.value[id]
    if not value then
      problem("{{" .. id .. "}}", ("unknown id '%s' in a formula (for grouping, write { {%s} })"):format(id, id))
      return ""
    end
    return html.tex(value.text)
  end)
  return math
end

-- "Figure {{fig-1}}" says Figure once.
local function say_once(inlines, i)
  local link, word = inlines[i], inlines[i - 2]
  local said = word and word.t == "Str" and inlines[i - 1].t ~= "Str" and word.text:lower():match("%a+%.?$")
  if said == "figure" or said == "figures" or said == "fig." or said == "table" or said == "tables" then
    link.content = {pandoc.Str((pandoc.utils.stringify(link):gsub("^%a+ ", "")))}
  end
end

-- Words before "(6)" that count something else than equations.
local counted = {class = true, classes = true, zone = true, zones = true, case = true, step = true, page = true, note = true}

local function is_counted(inlines, i)
  local word = inlines[i - 2]
  return word and word.t == "Str" and inlines[i - 1].t == "Space" and counted[word.text:lower()]
end

-- "9 mph": the space between a number and its unit.
local function is_before_unit(inlines, i)
  local number, unit = inlines[i - 1], inlines[i + 1]
  return number and unit and number.t == "Str" and unit.t == "Str" and number.text:find("%d$") and html.is_unit(unit.text)
end

-- Browsers break lines beside a formula, even before a comma: what touches it stays with it.
local function Inlines(inlines)
  local out, run, formula = pandoc.List(), pandoc.List(), false
  local function close()
    if formula and #run > 1 then out:insert(pandoc.Span(run, {class = "together"})) else out:extend(run) end
    run, formula = pandoc.List(), false
  end
  for i, inline in ipairs(inlines) do
    if inline.t == "Link" and inline.classes:includes("ref") then say_once(inlines, i) end
    if inline.t == "Link" and inline.classes:includes("equation-reference") and is_counted(inlines, i) then inline = inline.content[1] end
    if (inline.t == "Space" or inline.t == "SoftBreak") and is_before_unit(inlines, i) then inline = pandoc.Str "\u{a0}" end
    local is_formula = inline.t == "Math" and inline.mathtype == "InlineMath"
    if is_formula or inline.t == "Str" or inline.t == "Note" then
      run:insert(inline)
      formula = formula or is_formula
    else
      close()
      out:insert(inline)
    end
  end
  close()
  return out
end

-- The paper's page has the title of its record, as everywhere; the first level-1 heading is that of the study. Further ones,
-- if any, go one level down with all that follow.
local function take_title(doc)
  local first, more = nil, false
  for i, block in ipairs(doc.blocks) do
    if block.t == "Header" and block.level == 1 then
      if first then more = true else first = i end
    end
  end
  doc.meta.title = pandoc.MetaString(r.title)
  if first then
    if page == "study" then doc.meta.title = pandoc.MetaInlines(doc.blocks[first].content) end
    doc.blocks:remove(first)
  end
  for i, block in ipairs(doc.blocks) do -- the findings stand under a heading of their own
    if block.t == "Div" and block.classes:includes("findings") then
      doc.blocks:insert(i, pandoc.Header(2, {pandoc.Str("In"), pandoc.Space(), pandoc.Str("short")}, {id = "in-short"}))
      break
    end
  end
  if more then doc = doc:walk({Header = function(h) h.level = h.level + 1 return h end}) end
  return doc:walk({Header = function(h)
    if pandoc.utils.stringify(h) == "" then error("chapter " .. r.chapter .. ": a heading without words") end
    if r.item[h.identifier] then h.identifier = h.identifier .. "-section" end
    h.content:insert(pandoc.Link({}, "#" .. h.identifier, "link to this section", {class = "permalink"}))
    return h
  end})
end

-- The paragraphs of {{...}} alone in a file of the chapter and in those that it includes.
local function paragraphs_of(path, out)
  local file = io.open(path)
  if not file then return out end
  local paragraph = {}
  for line in file:lines() do
    local included = line:match("^%s*{{%s*include:%s*(%S+)%s*}}%s*$")
    if included then paragraphs_of(path:gsub("[^/]*$", "") .. included, out) end
    if line:find("%S") and not line:find("^/%*%*%*") and not line:find("^%*/") then
      paragraph[#paragraph + 1] = line
    else
      local text = table.concat(paragraph, " ")
      if only_items(text) then out[#out + 1] = text end
      paragraph = {}
    end
  end
  file:close()
  return out
end

-- Numbers the figures and tables of this page in its order, and those of the chapter's other page in its own.
local function number_items(doc)
  local counts = {}
  local function number(text)
    for inner in text:gmatch("{{([%w][%w%-_./]*)%s*:?%s*%w*}}") do
      local item = r.item[inner]
      if item and not item.number then
        local kind = item.page .. (item.kind == "figure" and "figure" or "table")
        counts[kind] = (counts[kind] or 0) + 1
        item.number = counts[kind]
      end
    end
  end
  doc:walk({Para = function(para)
    local text = pandoc.utils.stringify(para)
    if only_items(text) then number(text) end
  end})
  local main = PANDOC_STATE.input_files[1]
  local other = page == "study" and main:gsub("[^/]*/[^/]*$", "main.cpp") or main:gsub("[^/]*$", "study/study.cpp")
  for _, text in ipairs(paragraphs_of(other, {})) do number(text) end
  for _, item in ipairs(r.items) do
    if not item.number and item.page == page then
      local message = "%s: item '%s' of %s is not shown: give it a paragraph {{%s}}"
      problem(nil, message:format(r.chapter, item.id, r.path, item.id))
      item.number = 0
    end
  end
end

local function check_all_shown()
  if page == "paper" and symbol_list and not shown["the symbols"] then
    problem(nil, ("%s: the symbols are not shown: add {{symbols}}"):format(r.chapter))
  end
  if page ~= (r.has_study and "study" or "paper") then return end
  if #r.stability > 0 and not shown["the stability cases"] then
    problem(nil, ("%s: the stability cases of %s are not shown: add {{stability}}"):format(r.chapter, r.path))
  end
  for _, w in ipairs(r.work_precision) do
    if not shown["work-precision: " .. w.id] then
      local message = "%s: the work-precision study '%s' is not shown: add {{work-precision: %s}}"
      problem(nil, message:format(r.chapter, w.id, w.id))
    end
  end
end

local function stop_on_problems()
  if #problems == 0 then return end
  for _, message in ipairs(problems) do io.stderr:write("book: ", message, "\n") end
  os.exit(1)
end

function Pandoc(doc)
  local text = function(key) return doc.meta[key] and pandoc.utils.stringify(doc.meta[key]) end
  local good, result = pcall(record.load, text "record")
  if not good then
    io.stderr:write("book: ", result, "\n")
    os.exit(1)
  end
  r, figures, data, page = result, text "figures", text "data", text "part" or "paper"
  doc = take_title(doc)
  use_symbols()
  number_items(doc)
  doc:walk({Math = function(math)
    local number = math.mathtype == "DisplayMath" and math.text:match("\\tag{([^{}]*)}")
    if number then tags[number] = math.text:gsub("\\tag{[^{}]*}", "") end
  end})
  doc = doc:walk({Para = Para, Quoted = Quoted}):walk({Str = Str, Math = Math}):walk({Inlines = Inlines})
  doc = tools.linked(doc, docs)
  check_all_shown()
  doc:walk({Math = function(math) html.formula(math.text, math.mathtype) end}) -- so that all problems are named at once
  stop_on_problems()
  frame.set(doc.meta, frame.chapters(frame.strings(doc.meta.chapters)), page == "study" and r.chapter .. "-study" or r.chapter)
  parts.leave(doc, text "parts", r, page,
    {tags = tags, symbols = symbol_list and symbols.list(symbol_list, symbol_value, true) or nil})
  if page == "paper" then -- those of both pages
    for _, item in ipairs(r.items) do
      for _, name in ipairs(item.csv) do
        drawings.round(data .. "/" .. name)
      end
      if item.png then drawings.prepare(("%s/../../figures/%s/%s"):format(data, r.chapter, item.png:gsub("%.png$", ".svg"))) end
    end
  end
  local raw = function(content) return pandoc.MetaInlines({pandoc.RawInline("html", content)}) end
  doc:walk({Div = function(div) if div.classes:includes "live" then doc.meta.live = true end end}) -- figure.js
  doc.meta.pagetitle = pandoc.MetaString(pandoc.utils.stringify(doc.meta.title))
  doc.meta["checks-csv"] = exists(data .. "/checks.csv")
  doc.meta.number = pandoc.MetaString(tostring(r.number))
  doc.meta.paper = r.paper and raw(html.text(r.paper)) or nil
  doc.meta.tally = page == "paper" and raw(items.checks(r)) or nil
  if r.doi and r.doi ~= "" then doc.meta.doi = pandoc.MetaString(r.doi) end
  if page == "study" then doc.meta["paper-page"] = pandoc.MetaString(r.chapter) doc.meta.study = nil end
  doc.meta.machine = raw(record.describe(r.machine))
  doc.meta.level = pandoc.MetaString(tostring(r.level or ""))
  doc.meta.seconds = raw(html.seconds(r.seconds))
  doc = doc:walk({Math = function(math) -- one that cannot be set stays, for pandoc to name it
    local set = html.formula(math.text, math.mathtype)
    return set and pandoc.RawInline("html", set) or nil
  end})
  if symbol_list then doc.blocks:insert(pandoc.RawBlock("html", symbols.meanings(symbol_list, symbol_value))) end
  stop_on_problems()
  return doc
end
