-- The overview pages that are tables of all records: findings, ledger, stability, verification.

local csv, html, items, record = require "csv", require "html", require "items", require "record"
local check_tables = require "check_tables"

local overview = {}

local function heading(r) return html.tag("h2", {id = r.chapter}, r.number .. " " .. html.text(r.title)) end

local function join(parts) return table.concat(parts, "\n") end

-- A check as a link to its row on the chapter's page. A formula alone is no name: it follows that of its table.
local function check_link(check, r)
  local item = r.item[check.item]
  local href = items.href(item, r, "index"):gsub("#.*$", "") .. "#" .. check.id
  local name = check.what or check.id
  if name:match("^%$[^$]*%$$") then name = items.label(item, r) .. ": " .. name end
  return html.tag("a", {href = href}, html.text(name)) .. check_tables.unit(check)
end

-- What became of a statement of a paper that did not come out as it is printed: {rank, kind}.
local kinds = {
  ["failed"] = {0, "a check fails"}, ["not confirmed"] = {1, "the paper differs"}, ["corrected"] = {2, "the paper differs"},
  ["restored"] = {3, "our copy is damaged"}, ["unreadable"] = {4, "our copy is damaged"}, ["fitted"] = {5, "an input was chosen"},
  ["not testable"] = {6, "could not be tested"}}

-- The checks that the findings of a chapter name.
local function named_in(box)
  local out = {}
  for id in (box or ""):gmatch('#([^"]+)"') do out[id] = true end
  return out
end

-- "zone 1, B" and "zone 3, B" of one table are one finding.
local function alike(check) return table.concat({check.item, check.outcome, check.source, (check.what or check.id):gsub("%d+", "#")}, "\n") end

local function list_of(checks, field)
  local out = {}
  for i, check in ipairs(checks) do out[i] = field(check) end
  return table.concat(out, "; ")
end

local function finding_row(checks, kind, r)
  local check = checks[1]
  local more = #checks > 1 and html.text((" (and %d more of %s)"):format(#checks - 1, items.label(r.item[check.item], r))) or ""
  local why, trial = html.text(check.why or ""), check_tables.trial(check)
  local came = check_tables.cell(list_of(checks, check_tables.computed))
  if check.source == "claim" then
    why = came[1] .. (why ~= "" and "; " .. why or "")
    came = {"–", class = "number"}
  end
  if trial ~= "" then
    local of = #checks > 1 and ", for " .. html.text(check.what or check.id) or ""
    why = why .. html.tag("details", {class = "trial"}, html.tag("summary", nil, "What was varied" .. of) .. html.tag("p", nil, html.text(trial)))
  end
  return {check_link(check, r) .. more, {tostring(r.number), class = "number", sort = r.number}, kind, check_tables.outcome(check),
    check_tables.cell(list_of(checks, function(c) return check_tables.expected(c, true) end)), came, why}
end

-- What came out otherwise than printed, first what the paper has otherwise and a chapter's own findings name.
local function findings_table(records, parts)
  local found, counts = {}, {}
  local function add(rank, named, r, kind, row, statements)
    found[#found + 1] = {rank = rank * 2 + (named and 0 or 1), chapter = r.number, order = #found, kind = kind, row = row}
    counts[kind] = (counts[kind] or 0) + statements
  end
  for _, r in ipairs(records) do
    local named, groups, order = named_in(parts[r.chapter] and parts[r.chapter].findings), {}, {}
    for _, check in ipairs(r.checks) do
      local outcome = check.pass and check.outcome or "failed"
      if kinds[outcome] and (check.of_paper or outcome == "failed") then
        local key = alike(check)
        if not groups[key] then
          groups[key] = {outcome = outcome}
          order[#order + 1] = groups[key]
        end
        table.insert(groups[key], check)
        groups[key].named = groups[key].named or named[check.id]
      end
    end
    for _, group in ipairs(order) do
      local kind = kinds[group.outcome]
      add(kind[1], group.named, r, kind[2], finding_row(group, kind[2], r), #group)
    end
    for _, line in ipairs(r.inventory) do
      local outcome = line.reason:match("^(not testable)") or line.reason:match("^(unreadable)")
      if outcome then
        local kind = kinds[outcome]
        local why = line.reason:gsub("^%a[%a ]+: ?", "")
        add(kind[1], false, r, kind[2], {html.tag("a", {href = r.chapter .. ".html#paper-row-by-row"}, html.text(line.what)),
          {tostring(r.number), class = "number", sort = r.number}, kind[2], {html.badge(outcome), class = "outcome"}, "–", "–",
          items.named(why, r, "index")}, 1)
      end
    end
  end
  table.sort(found, function(a, b) return a.rank < b.rank or a.rank == b.rank and a.order < b.order end)
  local rows, open = {}, 0
  for i, entry in ipairs(found) do
    rows[i] = entry.row
    if entry.kind == "a check fails" or entry.kind == "the paper differs" then open = i end
  end
  local said = {}
  for _, kind in ipairs({"a check fails", "the paper differs", "our copy is damaged", "an input was chosen", "could not be tested"}) do
    if counts[kind] then said[#said + 1] = html.tag("b", nil, counts[kind]) .. ": " .. kind end
  end
  local heads = {"what the paper has", {"chapter", filter = true}, {"kind", filter = true}, {"outcome", filter = true}, "printed", "computed", "what was found, and why"}
  return html.tag("p", {class = "tally"}, table.concat(said, " · "))
    .. html.folded_table("sortable findings-table cards", heads, rows, open, "where our copy is damaged, an input was chosen, or nothing could be tested")
end

-- A file of a chapter's data, or nil where it has none.
local function data_of(r, name)
  return (csv.read(("%s/../chapters/%s/data/%s"):format(PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$"), r.chapter, name)))
end

-- The findings of a chapter, each with what it means for a reader, a row of so-what.csv.
local function with_meaning(box, r)
  local rows, i = data_of(r, "so-what.csv"), 0
  if not rows then return box end
  box = box:gsub("</li>", function(close)
    i = i + 1
    return rows[i] and html.tag("p", {class = "so-what"}, html.tag("b", nil, "What it means.") .. " " .. html.text(rows[i].so_what)) .. close
  end)
  if i ~= #rows then
    io.stderr:write(("book: %s has %d findings and chapters/%s/data/so-what.csv %d rows\n"):format(r.chapter, i, r.chapter, #rows))
    os.exit(1)
  end
  return box
end

-- Every number and claim that did not come out as the paper has it, by importance; then the findings that open the chapters.
function overview.findings(records, parts)
  local out = {html.tag("div", {class = "filterable"}, findings_table(records, parts))}
  for _, r in ipairs(records) do
    local box = parts[r.chapter] and parts[r.chapter].findings
    if box then out[#out + 1] = heading(r) .. html.tag("div", {class = "findings"}, with_meaning(box, r)) end
  end
  return join(out)
end

-- What came out, and under it the trial of a verdict against the paper.
local function computed_and_tried(check)
  local cell, trial = check_tables.cell(check_tables.computed(check)), check_tables.trial(check)
  if trial ~= "" then cell = {cell[1] .. html.tag("p", {class = "reason"}, html.text(trial)), class = "words"} end
  return cell
end

-- How many checks of each outcome each chapter has, with their sums.
local function totals(records)
  local heads, sums, rows = {"chapter"}, {}, {}
  for _, outcome in ipairs(record.outcomes) do
    for _, r in ipairs(records) do
      for _, check in ipairs(r.checks) do
        if (check.pass and check.outcome or "failed") == outcome then sums[outcome] = (sums[outcome] or 0) + 1 end
      end
    end
    if sums[outcome] then heads[#heads + 1] = outcome end
  end
  heads[#heads + 1] = "all"
  local function row(first, counts)
    local out, all = {first}, 0
    for i = 2, #heads - 1 do
      local count = counts[heads[i]] or 0
      out[i], all = {count > 0 and tostring(count) or "–", class = "number"}, all + count
    end
    out[#heads] = {tostring(all), class = "number"}
    return out
  end
  for i, r in ipairs(records) do
    local counts = {}
    for _, check in ipairs(r.checks) do
      local outcome = check.pass and check.outcome or "failed"
      counts[outcome] = (counts[outcome] or 0) + 1
    end
    rows[i] = row(html.tag("a", {href = "#" .. r.chapter, title = r.title}, r.number .. " " .. html.text((r.chapter:gsub("^%d+%-", ""):gsub("%-", " ")))), counts)
  end
  rows[#rows + 1] = row("all chapters", sums)
  rows[#rows].class = "sum"
  return html.table("totals", heads, rows)
end

-- How many digits of each check's number hold in all modes of rounding, by its id: rows {check, digits, reason} of tests/digits.
local function digits_of(r)
  local by_id = {}
  for _, row in ipairs(csv.read(PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/../tests/digits/" .. r.chapter .. ".csv") or {}) do
    if r.check[row.check] then by_id[row.check] = row end
  end
  return by_id
end

-- All checks, one folded table a chapter, of which the first is open.
function overview.ledger(records)
  local heads = {"what", "place", {"source", filter = true}, "printed or reference", "computed", "tolerance used", "digits",
    {"outcome", filter = true}}
  local out = {}
  for _, r in ipairs(records) do
    local rows, digits = {}, digits_of(r)
    for i, check in ipairs(r.checks) do
      local used, held = record.used(check), digits[check.id]
      rows[i] = {check_link(check, r), html.text(check.of_paper and check.place or check.by or ""), check.source or "–",
        check_tables.cell(check_tables.expected(check, check.of_paper)), computed_and_tried(check),
        {used and ("%.0f %%"):format(100 * used) or "–", class = "number", sort = used},
        held and held.digits or "",
        check_tables.outcome(check), class = not check.pass and "failed" or nil}
    end
    local counts = {}
    for j, pair in ipairs(record.count(r.checks)) do
      counts[j] = html.tag("span", {class = "count"}, pair[2] .. " " .. html.badge(pair[1]))
    end
    local summary = html.tag("b", nil, r.number .. " " .. html.text(r.title)) .. " " .. join(counts)
    out[#out + 1] = html.tag("details", {class = "more", id = r.chapter, open = #out == 0 and "" or nil},
      html.tag("summary", nil, summary) .. html.table("sortable ledger cards", heads, rows))
  end
  return totals(records) .. html.tag("div", {class = "filterable"}, join(out))
end

-- How many digits hold however arithmetic rounds, and why some are fewer than six.
function overview.digits(records)
  local rows, all, few, least = {}, 0, 0, 15
  for _, r in ipairs(records) do
    local digits = digits_of(r)
    for _, check in ipairs(r.checks) do
      local held = digits[check.id]
      if held then
        all = all + 1
        if held.reason ~= "" then
          few = few + 1
          rows[few] = {check_link(check, r), {held.digits, class = "number"}, html.text(held.reason)}
        elseif check.of_paper then
          least = math.min(least, tonumber(held.digits))
        end
      end
    end
  end
  return html.tag("p", nil, ("Every chapter also runs with arithmetic that rounds up, down and towards zero, with the mathematics of a processor without fused "
    .. "multiply-add, and as Clang and other levels of optimisation compile it. Of %d numbers %d keep six digits or more "
    .. "in all runs, and those that stand beside a paper at least %d, but for the following."):format(all, all - few, least))
    .. html.folded_table("sortable cards", {"number", "digits", "why"}, rows, 6, "numbers")
end


-- What each chapter's checks against other works and methods found: one row for each work or method and item.
local function second_routes(r)
  local groups, order = {}, {}
  for _, check in ipairs(r.checks) do
    if not check.of_paper then
      local key = (check.by or "") .. "\n" .. check.item
      local group = groups[key]
      if not group then
        group = {by = check.by or "", source = check.source, item = check.item, checks = {}}
        groups[key], order[#order + 1] = group, group
      end
      table.insert(group.checks, check)
    end
  end
  local rows = {}
  for i, group in ipairs(order) do
    local passed, total, closest = record.tally(group.checks)
    local item = r.item[group.item]
    rows[i] = {html.tag("a", {href = items.href(item, r, "index")}, items.title(item)), html.text(group.by),
      {passed .. " of " .. total, class = "number"},
      {closest and check_tables.difference(closest) or "–", class = "number"},
      {closest and select(2, check_tables.difference(closest)) or "–", class = "number"}, class = passed < total and "failed" or nil}
  end
  return rows
end

-- Folded by chapter: what a reader looks up.
function overview.verification(records)
  local out = {}
  local heads = {"computed", "compared with", "passed", "difference nearest its bound", "allowed"}
  for _, r in ipairs(records) do
    local rows, passed, all = second_routes(r), 0, 0
    for _, check in ipairs(r.checks) do
      if not check.of_paper then
        all = all + 1
        if check.pass then passed = passed + 1 end
      end
    end
    if #rows > 0 then
      out[#out + 1] = html.tag("details", {class = "more", id = r.chapter},
        html.tag("summary", nil, html.tag("b", nil, r.number .. " " .. html.text(r.title)) .. (" %d of %d checks passed"):format(passed, all))
        .. html.table("sortable routes cards", heads, rows))
    end
  end
  return html.tag("div", {class = "filterable"}, join(out))
end

-- How many of the 16 digits of a double the worst error found leaves, as a bar; the claim leaves those of the darker part.
local function digits_bar(claimed, worst)
  local function digits(text)
    local error = tonumber(text)
    return error and math.max(0, math.min(16, error == 0 and 16 or -math.log(error, 10)))
  end
  local claim, found = digits(claimed), digits(worst)
  if not claim or not found then return {"", class = "bar"} end
  return {html.tag("span", {class = "digits", style = ("--c:%.1f;--f:%.1f"):format(math.min(claim, found), found)}, ("%.0f"):format(found)), class = "bar", sort = found}
end

-- tests/claims.csv, whose rows the tests hold: a table for each room of lib/, in the order of the file.
function overview.claims(path)
  local rooms, order = {}, {}
  local file = assert(io.open(path))
  local headings = file:read() == "function,kind,bound,worst,inputs,route"
  assert(headings, path .. ": other columns than were expected")
  for line in file:lines() do
    local row, cells = {}, {}
    for cell in (line .. ","):gmatch("([^,]*),") do
      cells[#cells + 1] = cell
      row[#row + 1] = html.number(cell)
    end
    assert(#row == 6, path .. ": a row without six cells: " .. line)
    local room, name = row[1]:match("^([%w_]+)::([%w_]+)$")
    assert(room, path .. ": no room::function: " .. line)
    row[1] = "<code>" .. name .. "</code>"
    table.insert(row, 5, row[2]:find("^relative") and digits_bar(cells[3], cells[4]) or {"", class = "bar"})
    for _, i in ipairs({3, 4}) do row[i] = {row[i], class = "number"} end
    if not rooms[room] then rooms[room], order[#order + 1] = {}, room end
    table.insert(rooms[room], row)
  end
  file:close()
  local out = {}
  for i, room in ipairs(order) do
    out[i] = "<h3><code>" .. room .. "</code></h3>" .. html.folded_table("sortable claims",
      {"function", "error", "claimed below", "worst found", "digits left", "inputs", "compared with"}, rooms[room], 14)
  end
  return join(out)
end

-- The cause of each stiff and extreme case of a chapter, by its id; every case of a chapter with such a list must be in it.
local function causes_of(r)
  local list = data_of(r, "causes.csv")
  local by_id = {}
  for _, row in ipairs(list or {}) do by_id[row.case] = row.cause end
  for _, s in ipairs(r.stability) do
    if list and not by_id[s.id] then
      io.stderr:write(("book: chapters/%s/data/causes.csv lacks the case %s\n"):format(r.chapter, s.id))
      os.exit(1)
    end
  end
  return by_id
end

-- All stiff and extreme cases, by what makes them hard.
function overview.stability(records)
  local causes = csv.read(PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/causes.csv")
  causes[#causes + 1] = {cause = "other", title = "Other", sentence = "Cases that have not been put in order."}
  local heads = {"case", {"chapter", filter = true}, "what is stressed", "result", "relative error", "allowed", {"found, as expected", filter = true}}
  local number = function(x) return {type(x) == "number" and html.number(("%.2g"):format(x)) or "–", class = "number", sort = x} end
  local rows, counts, known = {}, {}, {}
  for _, cause in ipairs(causes) do rows[cause.cause], counts[cause.cause], known[cause.cause] = {}, {}, true end
  for _, r in ipairs(records) do
    local of = causes_of(r)
    for _, s in ipairs(r.stability) do
      local page, cause = r.has_study and r.chapter .. "-study" or r.chapter, of[s.id] or "other"
      if not known[cause] then
        io.stderr:write(("book: chapters/%s/data/causes.csv: the cause %s is not in book/causes.csv\n"):format(r.chapter, cause))
        os.exit(1)
      end
      local found = s.pass and s.found or "failed"
      counts[cause][found] = (counts[cause][found] or 0) + 1
      table.insert(rows[cause], {html.tag("a", {href = page .. ".html#stability/" .. s.id}, html.text(s.case)),
        {tostring(r.number), class = "number", sort = r.number}, html.text(s.stress),
        html.text(s.result), number(s.error), number(s.allowed), {html.badge(found), class = "outcome"},
        class = not s.pass and "failed" or nil})
    end
  end
  local out = {}
  for _, cause in ipairs(causes) do
    if #rows[cause.cause] > 0 then
      local tally = {}
      for _, found in ipairs({"holds", "degrades", "refused", "failed"}) do
        local count = counts[cause.cause][found]
        if count then tally[#tally + 1] = count .. " " .. html.badge(found) end
      end
      out[#out + 1] = html.tag("h2", {id = "cause-" .. cause.cause}, html.text(cause.title)) .. html.tag("p", nil, html.text(cause.sentence))
        .. html.tag("p", {class = "tally"}, table.concat(tally, " "))
        .. html.folded_table("sortable stability cards", heads, rows[cause.cause], 12, "cases")
    end
  end
  return html.tag("div", {class = "filterable"}, join(out))
end

return overview
