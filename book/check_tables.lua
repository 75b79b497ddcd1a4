-- How checks look on the page: tables of printed numbers, of claims and of other works and methods.

local html = require "html"
local record = require "record"

local check_tables = {}

local most_claims = 4 -- of more than these only the telling ones are open
local longest_notes = 300 -- letters; longer reasons are folded
local whole = 40 -- a table of at most so many rows is open as a whole

local function share(ratio) return html.number(("%.3g"):format(ratio * 100)) .. " %" end

-- How many digits of what came out are shown: one more than the print has.
local function significant(check)
  local printed = check.of_paper and tostring(check.printed or ""):gsub("\u{202f}", "")
  local mantissa = printed and printed:match("^[-+−]?([%d., ]*%d)")
  if not mantissa then return 7 end
  local digits = #mantissa:gsub("[., ]", ""):gsub("^0+", "")
  return math.max(4, math.min(7, digits + 1))
end

-- What came out, as it is shown.
function check_tables.computed(check)
  local text = check.computed_text or check.computed
  if type(text) == "number" then text = ("%%.%dg"):format(significant(check)):format(text) end
  if text == nil or text == "nan" then text = "not a number" end
  return text:find("[$`]") and html.text(text) or html.number(text)
end

-- A cell of a number or of words.
function check_tables.cell(text, class)
  local words = #text:gsub("<[^>]*>", "") > 24
  return {text, class = words and "words" or class or "number"}
end

-- The difference and what is allowed of it, as they are shown.
function check_tables.difference(check)
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
  if type(computed) ~= "number" or not printed then return check.kind == "exact" and (check.pass and "same" or "differs") or check_tables.difference(check) end
  if computed == printed then return "0 %" end
  if check.kind == "digitised" or printed == 0 then return (check_tables.difference(check)) .. (check.kind == "digitised" and " of axis" or "") end
  local off = 100 * (computed - printed) / printed
  local size = math.abs(off)
  if size < 1e-9 then return "0 %" end -- rounding
  local text = size >= 9.95 and ("%.0f"):format(size) or size >= 0.095 and ("%.1f"):format(size) or ("%.1g"):format(size)
  return html.number((off < 0 and "-" or "+") .. text) .. " %"
end

-- ", psi", or nothing.
function check_tables.unit(check)
  local unit = check.unit or ""
  return unit ~= "" and unit ~= "1" and ", " .. html.unit(html.escape(unit)) or ""
end

-- What the check is held against: the text of the paper, or the number of another work or method.
function check_tables.expected(check, of_paper)
  local bound = (check.kind == "at_most" or check.kind == "at_least") and tonumber(check.reference)
  if bound and not of_paper then return html.number(("%.3g"):format(bound)) end
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
function check_tables.trial(check)
  if not check.trial then return "" end
  local parts = {}
  for i, v in ipairs(check.trial.varied) do
    parts[i] = ("%s (%s): %s"):format(v.choice, settings(v.settings), v.range)
  end
  local function sentence(text) return text:sub(1, 1):upper() .. text:sub(2) end
  local comma = check.trial.quantity:find(",", 1, true) and "," or ""
  return ("%s%s is %s in every variation. %s."):format(sentence(check.trial.quantity), comma, check.trial.range, sentence(table.concat(parts, "; ")))
end

-- The reason of a check with its trial.
function check_tables.proof(check)
  local why, trial = check.why or "", check_tables.trial(check)
  if why == "" or trial == "" then return why .. trial end
  return why .. (why:match("[.!?]$") and " " or ". ") .. trial
end

-- Reasons, each said once and marked a, b, c ... in the rows it belongs to.
local function notes_of(checks)
  local marks, list, length = {}, {}, 0
  for _, check in ipairs(checks) do
    local why = check_tables.proof(check)
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
function check_tables.outcome(check) return {html.badge(check.pass and check.outcome or "failed"), class = "outcome"} end

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
    local mark = marks[check_tables.proof(check)]
    rows[i] = {html.tag("span", {id = check.id}, html.text(check.what or check.id)) .. place(check),
      check_tables.computed(check) .. (mark and html.tag("span", {class = "mark"}, mark) or ""),
      check_tables.outcome(check), class = not check.pass and "failed" or nil}
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
    local mark = marks[check_tables.proof(check)]
    rows[i] = {html.tag("span", {id = check.id}, html.text(check.what or check.id)) .. check_tables.unit(check) .. place(check),
      check_tables.cell(check_tables.expected(check, true)), check_tables.cell(check_tables.computed(check)),
      {difference_from_print(check) .. (mark and html.tag("span", {class = "mark"}, mark) or ""), class = "number"},
      check_tables.outcome(check), class = not check.pass and "failed" or nil}
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
    local off, allowed = check_tables.difference(check)
    local expected = check_tables.expected(check, false)
    if allowed == "at most" or allowed == "at least" then expected, allowed = "–", allowed .. " " .. expected end
    local mark = marks[check_tables.proof(check)]
    rows[i] = {
      html.tag("span", {id = check.id}, html.text(check.what or check.id)) .. check_tables.unit(check),
      check_tables.cell(expected, "number reference"), check_tables.cell(check_tables.computed(check)), {off, class = "number"},
      {allowed .. (mark and html.tag("span", {class = "mark"}, mark) or ""), class = "number"},
      check_tables.outcome(check), class = not check.pass and "failed" or nil}
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
    text = text .. ("; nearest to its limit is “%s” (%s of the tolerance)"):format(html.text(closest.what or closest.id),
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

-- All checks of an item.
function check_tables.of_item(item)
  local paper, others = {}, {}
  for _, check in ipairs(item.checks) do table.insert(check.of_paper and paper or others, check) end
  if item.open == "rows" and #item.checks > 0 then
    local content = paper_checks(paper, item.title) .. (#others > 0 and other_table(others) or "")
    return folded(content, item.checks, "")
  end
  return paper_checks(paper, item.title) .. other_checks(others, #paper == 0 and #(item.rows or {}) == 0 and not item.png)
end

return check_tables
