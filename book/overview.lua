-- The overview pages that are tables of all records: findings, ledger, stability, verification.

local html, items, record = require "html", require "items", require "record"

local overview = {}

local function heading(r) return html.tag("h2", {id = r.chapter}, r.number .. " " .. html.text(r.title)) end

local function join(parts) return table.concat(parts, "\n") end

-- A check as a link to its row on the chapter's page.
local function check_link(check, r)
  local href = items.href(r.item[check.item], r, "index"):gsub("#.*$", "") .. "#" .. check.id
  return html.tag("a", {href = href}, html.text(check.what or check.id)) .. items.unit(check)
end

local outcomes_found = {["corrected"] = 1, ["not confirmed"] = 2, ["restored"] = 3, ["fitted"] = 4, ["failed"] = 0}

local function findings_table(r)
  local found = {}
  for i, check in ipairs(r.checks) do
    local rank = check.of_paper and outcomes_found[check.pass and check.outcome or "failed"]
    if rank then found[#found + 1] = {rank, i, check} end
  end
  table.sort(found, function(a, b) return a[1] < b[1] or a[1] == b[1] and a[2] < b[2] end)
  local rows = {}
  for i, entry in ipairs(found) do
    local check = entry[3]
    local came, why = items.cell(items.computed(check)), html.text(items.proof(check))
    if came.class == "words" then came, why = {"–", class = "number"}, came[1] .. (why ~= "" and (check.trial and (check.why or "") == "" and ". " or "; ") .. why or "") end
    rows[i] = {check_link(check, r), items.outcome(check), html.text(check.place or ""),
      items.cell(items.said(check, true)), came, why}
  end
  local heads = {"what", {"outcome", filter = true}, "place in the paper", "printed", "computed", "proof or reason"}
  return #rows > 0 and html.table("sortable findings-table cards", heads, rows) or ""
end

-- The three findings of each chapter, and every number or claim that did not come out as the paper has it.
function overview.findings(records, parts)
  local out = {}
  for _, r in ipairs(records) do
    out[#out + 1] = heading(r)
    local box = parts[r.chapter] and parts[r.chapter].findings
    if box then out[#out + 1] = html.tag("div", {class = "findings"}, box) end
    out[#out + 1] = findings_table(r)
  end
  return html.tag("div", {class = "filterable"}, join(out))
end

-- What came out, and under it the trial of a verdict against the paper.
local function computed_and_tried(check)
  local cell, trial = items.cell(items.computed(check)), items.trial(check)
  if trial ~= "" then cell = {cell[1] .. html.tag("p", {class = "reason"}, html.text(trial)), class = "words"} end
  return cell
end

-- All checks, one folded table a chapter.
function overview.ledger(records)
  local heads = {"what", "place", {"source", filter = true}, "printed or reference", "computed", "tolerance used", {"outcome", filter = true}}
  local out = {}
  for _, r in ipairs(records) do
    local rows = {}
    for i, check in ipairs(r.checks) do
      local used = record.used(check)
      rows[i] = {check_link(check, r), html.text(check.of_paper and check.place or check.by or ""), check.source or "–",
        items.cell(items.said(check, check.of_paper)), computed_and_tried(check),
        {used and ("%.0f %%"):format(100 * used) or "–", class = "number", sort = used},
        items.outcome(check), class = not check.pass and "failed" or nil}
    end
    local counts = {}
    for j, pair in ipairs(record.count(r.checks)) do
      counts[j] = html.tag("span", {class = "count"}, pair[2] .. " " .. html.badge(pair[1]))
    end
    local summary = html.tag("b", nil, r.number .. " " .. html.text(r.title)) .. " " .. join(counts)
    out[#out + 1] = html.tag("details", {class = "more", id = r.chapter},
      html.tag("summary", nil, summary) .. html.table("sortable ledger cards", heads, rows))
  end
  return html.tag("div", {class = "filterable"}, join(out))
end

-- All stiff and extreme cases.
function overview.stability(records)
  local out = {}
  local heads = {"case", "what is stressed", "result", "error", "allowed", {"expected", filter = true}, {"found", filter = true}}
  local number = function(x) return {type(x) == "number" and html.number(("%.2g"):format(x)) or "–", class = "number", sort = x} end
  for _, r in ipairs(records) do
    local rows, counts = {}, {}
    for i, s in ipairs(r.stability) do
      local page = r.has_study and r.chapter .. "-study" or r.chapter
      local found = s.pass and s.found or "failed"
      counts[found] = (counts[found] or 0) + 1
      rows[i] = {html.tag("a", {href = page .. ".html#stability/" .. s.id}, html.text(s.case)), html.text(s.stress),
        html.text(s.result), number(s.error), number(s.allowed), html.text(s.expect or ""), {html.badge(found), class = "outcome"},
        class = not s.pass and "failed" or nil}
    end
    if #rows > 0 then
      local said = {}
      for _, found in ipairs({"holds", "degrades", "refused", "failed"}) do
        if counts[found] then said[#said + 1] = counts[found] .. " " .. html.badge(found) end
      end
      out[#out + 1] = heading(r) .. html.tag("p", {class = "tally"}, table.concat(said, " "))
        .. html.folded_table("sortable stability cards", heads, rows, 12, "cases")
    end
  end
  return html.tag("div", {class = "filterable"}, join(out))
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
      html.text(group.source), {passed .. " of " .. total, class = "number"},
      {closest and items.difference(closest) or "–", class = "number"},
      {closest and select(2, items.difference(closest)) or "–", class = "number"}, class = passed < total and "failed" or nil}
  end
  return rows
end

function overview.verification(records)
  local out = {}
  local heads = {"computed", "held against", {"kind", filter = true}, "passed", "difference nearest its bound", "allowed"}
  for _, r in ipairs(records) do
    local rows = second_routes(r)
    if #rows > 0 then out[#out + 1] = heading(r) .. html.folded_table("sortable routes cards", heads, rows, 14) end
  end
  return html.tag("div", {class = "filterable"}, join(out))
end

-- tests/claims.csv, whose rows the tests hold: a table for each room of lib/, in the order of the file.
function overview.claims(path)
  local rooms, order = {}, {}
  local file = assert(io.open(path))
  local headings = file:read() == "function,kind,bound,worst,inputs,route"
  assert(headings, path .. ": other columns than were expected")
  for line in file:lines() do
    local row = {}
    for cell in (line .. ","):gmatch("([^,]*),") do row[#row + 1] = html.text(cell) end
    assert(#row == 6, path .. ": a row without six cells: " .. line)
    local room, name = row[1]:match("^([%w_]+)::([%w_]+)$")
    assert(room, path .. ": no room::function: " .. line)
    row[1] = "<code>" .. name .. "</code>"
    for _, i in ipairs({3, 4}) do row[i] = {row[i], class = "number"} end
    if not rooms[room] then rooms[room], order[#order + 1] = {}, room end
    table.insert(rooms[room], row)
  end
  file:close()
  local out = {}
  for i, room in ipairs(order) do
    out[i] = "<h3><code>" .. room .. "</code></h3>" .. html.folded_table("sortable claims",
      {"function", "error", "claimed below", "worst found", "inputs", "held against"}, rooms[room], 14)
  end
  return join(out)
end

return overview
