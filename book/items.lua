-- How the things of a record look on the page: figures, tables, checks, work-precision, stability, verdicts.

local html = require "html"
local record = require "record"

local items = {}

local most_claims = 4 -- of more than these only the telling ones are open
local longest_notes = 300 -- letters; longer reasons are folded
local most_rows = 10 -- of a longer list these are open
local widest = 1100 -- a picture of so many pixels has its caption below it, and the width of the page
local whole = 40 -- a table of at most so many rows is open as a whole

local function share(ratio) return html.number(("%.3g"):format(ratio * 100)) .. " %" end

-- What came out, as it is shown.
function items.computed(check)
  local text = check.computed_text or check.computed
  if type(text) == "number" then text = ("%.7g"):format(text) end
  if text == nil or text == "nan" then text = "not a number" end
  return text:find("[$`]") and html.text(text) or html.number(text)
end

-- A cell of a number or of words.
function items.cell(text, class)
  local words = #text:gsub("<[^>]*>", "") > 24
  return {text, class = words and "words" or class or "number"}
end

-- The difference and what is allowed of it, as they are shown.
function items.difference(check)
  local kind, error, allowed = check.kind, check.error, check.allowed
  if kind == "exact" then return check.pass and "" or "differs", "" end
  if kind == "at_most" then return "–", "at most" end
  if kind == "at_least" then return "–", "at least" end
  if type(error) ~= "number" or type(allowed) ~= "number" then return "–", "–" end
  if check.trial then return share(error) .. " of the print", "rounding " .. share(allowed) end
  local of = kind == "digitised" and " of axis" or ""
  if kind == "last_digit" or kind == "absolute" then
    return html.number(("%.2g"):format(error)), html.number(("%.2g"):format(allowed))
  end
  return share(error), share(allowed) .. of
end

-- A printed text as a number, or nil: "34 072", ".3", "2.25e-2".
local function printed_number(text)
  return tonumber((tostring(text):gsub("\u{202f}", ""):gsub("[%s,]", ""):gsub("−", "-")))
end

-- What the computation differs by, in per cent of the print, with its sign.
local function difference_from_print(check)
  local printed, computed = printed_number(check.printed), check.computed
  if type(computed) ~= "number" or not printed then return check.kind == "exact" and (check.pass and "same" or "differs") or items.difference(check) end
  if computed == printed then return "0 %" end
  if check.kind == "digitised" or printed == 0 then return (items.difference(check)) .. (check.kind == "digitised" and " of axis" or "") end
  local off = 100 * (computed - printed) / math.abs(printed)
  local size = math.abs(off)
  if size < 1e-9 then return "0 %" end -- rounding
  local text = size >= 9.95 and ("%.0f"):format(size) or size >= 0.095 and ("%.1f"):format(size) or ("%.1g"):format(size)
  return html.number((off < 0 and "-" or "+") .. text) .. " %"
end

-- ", psi", or nothing.
function items.unit(check)
  local unit = check.unit or ""
  return unit ~= "" and unit ~= "1" and ", " .. html.unit(html.escape(unit)) or ""
end

-- What the check is held against: the text of the paper, or the number of another work or method.
function items.said(check, of_paper)
  return check.source == "claim" and "–" or html.number((of_paper and check.printed or check.reference) or "–")
end

-- A few settings of one choice, with their common unit at the end: "0.08, 0.04, 0.02 in".
local function settings(list)
  local unit = list[1]:match(" [^ ]+$")
  for _, text in ipairs(list) do
    if not text:match("^[-+−]?[%d.]+ [^ ]+$") or text:match(" [^ ]+$") ~= unit then return table.concat(list, ", ") end
  end
  local numbers = {}
  for i, text in ipairs(list) do numbers[i] = text:sub(1, -#unit - 1) end
  return table.concat(numbers, ", ") .. unit
end

-- What was varied before the verdict, and where the result came out; empty for a check without a trial.
function items.trial(check)
  if not check.trial then return "" end
  local parts = {}
  for i, v in ipairs(check.trial.varied) do
    parts[i] = ("%s (%s): %s"):format(v.choice, settings(v.settings), v.range)
  end
  local function sentence(text) return text:sub(1, 1):upper() .. text:sub(2) end
  return ("%s is %s in every variation. %s."):format(sentence(check.trial.quantity), check.trial.range, sentence(table.concat(parts, "; ")))
end

-- The reason of a check with its trial.
function items.proof(check)
  local why, trial = check.why or "", items.trial(check)
  if why == "" or trial == "" then return why .. trial end
  return why .. (why:match("[.!?]$") and " " or ". ") .. trial
end

-- Reasons, each said once and marked a, b, c ... in the rows it belongs to.
local function notes_of(checks)
  local marks, list, length = {}, {}, 0
  for _, check in ipairs(checks) do
    local why = items.proof(check)
    if why ~= "" and not marks[why] then
      length = length + utf8.len(why)
      local n = #list
      marks[why] = n < 26 and string.char(97 + n) or tostring(n + 1)
      list[n + 1] = html.tag("li", nil, html.tag("b", nil, marks[why]) .. " " .. html.text(why))
    end
  end
  local notes = #list > 0 and html.tag("ul", {class = "notes"}, table.concat(list, "\n")) or ""
  if #list > 3 or length > longest_notes then
    local summary = #list > 1 and ("The %d reasons"):format(#list) or "The reason"
    notes = html.tag("details", {class = "checks"}, html.tag("summary", nil, summary) .. notes)
  end
  return marks, notes
end

-- What came of a check, as a cell.
function items.outcome(check) return {html.badge(check.pass and check.outcome or "failed"), class = "outcome"} end

-- Whether a check is a statement that is true or not, without a number that it is held against.
local function in_words(check)
  return check.source == "claim" or not check.of_paper and check.kind == "exact" and (check.reference or "") == ""
end

-- Where in the paper a check belongs, unless the title of its table says so.
local function place_of(check, title)
  local place = check.place or ""
  local own = place:match("^%a+%.? %w+")
  if place == "" or own and title:find(own, 1, true) then return "" end
  return html.tag("span", {class = "place"}, html.text(place))
end

-- The first heading of a table of checks, with their place in the paper when they all have the same one; and the place of each.
local function places_of(checks, title, head)
  local first = place_of(checks[1], title)
  for _, check in ipairs(checks) do
    if place_of(check, title) ~= first then return head, function(each) return place_of(each, title) end end
  end
  local own = html.text(checks[1].place or "")
  return first ~= "" and ("%s (%s)"):format(head, own) or head, function() return "" end
end

-- Statements alone, without the columns of numbers that they have none of.
local function statements_table(checks, of_paper, title)
  local marks, notes = notes_of(checks)
  local rows, head, place = {}, "statement", function() return "" end
  if of_paper then head, place = places_of(checks, title, "claim") end
  for i, check in ipairs(checks) do
    local mark = marks[items.proof(check)]
    rows[i] = {html.tag("span", {id = check.id}, html.text(check.what or check.id)) .. place(check),
      items.computed(check) .. (mark and html.tag("span", {class = "mark"}, mark) or ""),
      items.outcome(check), class = not check.pass and "failed" or nil}
    if not of_paper then table.insert(rows[i], 2, html.text(check.by or "")) end
  end
  local heads = of_paper and {head, "found", "outcome"} or {head, "how it was tried", "found", "outcome"}
  return html.table("checks claims cards", heads, rows) .. notes
end

-- Printed numbers, all of them: what the paper has, what comes out, and the difference in per cent of the print.
local function printed_table(checks, title)
  local marks, notes = notes_of(checks)
  local rows, head, place = {}, places_of(checks, title, "what")
  for i, check in ipairs(checks) do
    local mark = marks[items.proof(check)]
    rows[i] = {html.tag("span", {id = check.id}, html.text(check.what or check.id)) .. items.unit(check) .. place(check),
      items.cell(items.said(check, true)), items.cell(items.computed(check)),
      {difference_from_print(check) .. (mark and html.tag("span", {class = "mark"}, mark) or ""), class = "number"},
      items.outcome(check), class = not check.pass and "failed" or nil}
  end
  return html.table("checks cards", {head, "printed", "computed", "difference", "outcome"}, rows) .. notes
end

-- Numbers and statements that another work or method has, which is named.
local function other_table(checks)
  local words, numbers = {}, {}
  for _, check in ipairs(checks) do table.insert(in_words(check) and words or numbers, check) end
  if #numbers == 0 then return statements_table(words, false) end
  if #words > 0 then return other_table(numbers) .. statements_table(words, false) end
  local marks, notes = notes_of(checks)
  local rows = {}
  for i, check in ipairs(checks) do
    local off, allowed = items.difference(check)
    local mark = marks[items.proof(check)]
    rows[i] = {
      html.tag("span", {id = check.id}, html.text(check.what or check.id)) .. items.unit(check),
      items.cell(items.said(check, false), "number reference"), items.cell(items.computed(check)), {off, class = "number"},
      {allowed .. (mark and html.tag("span", {class = "mark"}, mark) or ""), class = "number"},
      items.outcome(check), class = not check.pass and "failed" or nil}
  end
  return html.table("checks cards", {"what", "reference", "computed", "difference", "allowed", "outcome"}, rows) .. notes
end

-- One line on many checks.
local function summary(checks)
  local passed, total, closest = record.tally(checks)
  if total == 0 then return "No checks" end
  local text = total == 1 and (passed == 1 and "1 check, passed" or "1 check, failed")
    or passed == total and ("%d checks, all passed"):format(total) or ("%d of %d checks passed"):format(passed, total)
  if closest and total > 1 then
    local used = 100 * record.used(closest)
    text = text .. ("; the closest, %s, uses %s of its tolerance"):format(html.text(closest.what or closest.id),
      used < 1 and "less than 1 %" or ("%.0f %%"):format(used))
  end
  return text
end

local function folded(content, checks, more)
  return html.tag("details", {class = "checks"}, html.tag("summary", nil, more .. summary(checks)) .. content)
end

local telling = {["corrected"] = true, ["not confirmed"] = true, ["restored"] = true, ["fitted"] = true}

-- Claims of the paper: all of a few, of many those that came out otherwise than confirmed.
local function claims_table(checks, title)
  if #checks == 0 then return "" end
  local open, rest = {}, {}
  for _, check in ipairs(checks) do
    table.insert((#checks <= most_claims or not check.pass or telling[check.outcome]) and open or rest, check)
  end
  return (#open > 0 and statements_table(open, true, title) or "")
    .. (#rest > 0 and folded(statements_table(rest, true, title), rest, #open > 0 and "More: " or "") or "")
end

-- Checks of the paper: its numbers as a whole table, then its claims in words.
local function paper_checks(checks, title)
  local numbers, claims = {}, {}
  for _, check in ipairs(checks) do table.insert(check.source == "claim" and claims or numbers, check) end
  return (#numbers > 0 and printed_table(numbers, title) or "") .. claims_table(claims, title)
end

-- Checks against other works and methods: folded, unless one fails or they are few and all that their item has.
local function other_checks(checks, alone)
  if #checks == 0 then return "" end
  local passed = record.tally(checks)
  if passed < #checks or alone and #checks <= 3 then return other_table(checks) end
  return folded(other_table(checks), checks, "Against other works and methods: ")
end

local function checks_of(item)
  local paper, others = {}, {}
  for _, check in ipairs(item.checks) do table.insert(check.of_paper and paper or others, check) end
  if item.open == "rows" and #item.checks > 0 then
    local content = paper_checks(paper, item.title) .. (#others > 0 and other_table(others) or "")
    return folded(content, item.checks, "")
  end
  return paper_checks(paper, item.title) .. other_checks(others, #paper == 0 and #(item.rows or {}) == 0 and not item.png)
end

-- The file of the book that holds a CSV of the results: of a figure that answers, a script.
function items.file_of(name) return (name:gsub("%-answer%.csv$", "-answer.js")) end

local function links(item, r)
  local out = {}
  local function add(folder, name)
    out[#out + 1] = html.tag("a", {href = "data/" .. folder .. name}, html.escape(name))
  end
  for _, name in ipairs(item.csv) do add(r.chapter .. "/", items.file_of(name)) end
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

-- The place where a reader's sliders go, when the program left data for them: <id>-answer.csv (see answer.js).
local function answer(item, r)
  for _, name in ipairs(item.csv) do
    if name == item.id .. "-answer.csv" then
      return html.tag("div", {class = "answer", ["data-id"] = item.id,
        ["data-src"] = ("data/%s/%s-answer.js"):format(r.chapter, item.id)}, "")
    end
  end
  return ""
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
    html.tag("a", {href = href}, image), answer(item, r), html.tag("figcaption", nil, heading(item, r)), reason(item), more or "",
    checks_of(item)}, "\n"))
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
    local cells = {}
    for i, row in ipairs(rows) do
      cells[i] = {}
      for j, cell in ipairs(row) do
        local text = type(cell) == "number" and ("%.6g"):format(cell) or tostring(cell)
        local numeric = text:find("^%s*[-+−]?%.?%d") and not text:find("%a%a")
        local class = numeric and "number" or utf8.len(text) < 16 and "short" or "long"
        cells[i][j] = {numeric and html.number(text) or html.text(text), class = class}
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
    checks_of(item)}, "\n"))
end

-- The runs of one study: {method, setting, ..., errors = {quantity = error}}, and its quantities in order.
local function runs_of(list)
  local runs, by_key, quantities = {}, {}, {}
  for _, w in ipairs(list) do
    local key, quantity = w.method .. "\n" .. w.setting, w.quantity or ""
    if not quantities[quantity] then
      quantities[#quantities + 1] = quantity
      quantities[quantity] = true
    end
    local run = by_key[key]
    if not run then
      run = {first = w, errors = {}, outcome = "converged"}
      by_key[key], runs[#runs + 1] = run, run
    end
    run.errors[quantity] = w.error
    if not w.converged then run.outcome = "failed: " .. (w.reason or "") end
  end
  return runs, quantities
end

local function study(id, list, several)
  local runs, quantities = runs_of(list)
  local heads, rows, uncertainty = {"method", "setting"}, {}, 0
  for _, quantity in ipairs(quantities) do
    heads[#heads + 1] = quantity == "" and "error" or "error of " .. quantity
  end
  for _, head in ipairs({"median", "quartiles", "work", "outcome"}) do heads[#heads + 1] = head end
  for _, w in ipairs(list) do uncertainty = math.max(uncertainty, w.reference_uncertainty or 0) end
  for i, run in ipairs(runs) do
    local w, failed = run.first, run.outcome ~= "converged"
    local row = {html.text(w.method), {html.text(w.setting), class = "number"}}
    for _, quantity in ipairs(quantities) do
      local error = run.errors[quantity]
      row[#row + 1] = {type(error) == "number" and html.number(("%.2g"):format(error)) or "–", class = "number"}
    end
    local quartiles = w.samples and w.samples > 1 and html.seconds(w.seconds_q1) .. " to " .. html.seconds(w.seconds_q3) or "–"
    local unit = w.work_unit and w.work_unit ~= "" and " " .. html.escape(w.work_unit) or ""
    for _, text in ipairs({html.seconds(w.seconds_median), quartiles, html.count(w.work) .. unit}) do
      row[#row + 1] = {text, class = "number"}
    end
    row[#row + 1] = html.text(run.outcome)
    row.class = failed and "failed" or i > 1 and runs[i - 1].first.method ~= w.method and "first" or nil
    rows[i] = row
  end
  local note = uncertainty > 0 and html.tag("p", {class = "reason"},
    "Relative errors; the reference itself is known to " .. html.number(("%.1g"):format(uncertainty)) .. ".") or ""
  local name = several and html.tag("p", {class = "caption"}, html.tag("b", nil, html.text(id))) or ""
  return name .. html.folded_table("work", heads, rows, most_rows, "runs") .. note
end

-- Error against run time, a table for each study of the list.
function items.work_precision(list)
  local ids, studies, out = {}, {}, {}
  for _, w in ipairs(list) do
    if not studies[w.id] then
      ids[#ids + 1] = w.id
      studies[w.id] = {}
    end
    table.insert(studies[w.id], w)
  end
  for i, id in ipairs(ids) do out[i] = study(id, studies[id], #ids > 1) end
  return table.concat(out, "\n")
end

function items.stability(list)
  local rows = {}
  for i, s in ipairs(list) do
    local number = function(x) return type(x) == "number" and html.number(("%.2g"):format(x)) or "–" end
    local error, bound = number(s.error), number(s.allowed)
    rows[i] = {
      html.tag("span", {id = "stability/" .. s.id}, html.text(s.case)), html.text(s.stress), html.text(s.result),
      {error, class = "number"}, {bound, class = "number"}, {html.badge(s.pass and s.found or "failed"), class = "outcome"}}
  end
  return html.folded_table("stability cards", {"case", "what is stressed", "result", "error", "allowed", "found"}, rows, most_rows, "cases")
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
  local content = html.table("coverage cards", {"place", "number", "what the paper has", "here"}, rows)
  return html.tag("details", {class = "more", id = "paper-row-by-row"},
    html.tag("summary", nil, ("The paper row by row: %d equations, numbers, figures and claims, with what treats each"):format(#rows)) .. content)
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
  return html.tag("p", {class = "tally"}, table.concat(out, " "))
end

return items
