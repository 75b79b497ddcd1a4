-- How a study looks on the page: error against run time, and stability.

local html = require "html"

local studies = {}

local most_rows = 10 -- of a longer list these are open

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
  local heads, rows, known = {"method", "setting"}, {}, {}
  for _, quantity in ipairs(quantities) do
    heads[#heads + 1] = quantity == "" and "error" or "error of " .. quantity
  end
  local failures = false
  for _, run in ipairs(runs) do failures = failures or run.outcome ~= "converged" end
  for _, head in ipairs({"median time", "quartiles of time", "work", failures and "outcome" or nil}) do heads[#heads + 1] = head end
  for _, w in ipairs(list) do
    local quantity = w.quantity or ""
    known[quantity] = math.max(known[quantity] or 0, w.reference_uncertainty or 0)
  end
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
    if failures then row[#row + 1] = html.text(run.outcome) end
    row.class = failed and "failed" or i > 1 and runs[i - 1].first.method ~= w.method and "first" or nil
    rows[i] = row
  end
  local said = {}
  for _, quantity in ipairs(quantities) do
    if known[quantity] > 0 then
      said[#said + 1] = html.number(("%.1g"):format(known[quantity])) .. (#quantities > 1 and " (" .. html.text(quantity) .. ")" or "")
    end
  end
  local note = #said > 0 and html.tag("p", {class = "reason"},
    "Relative errors; the reference itself is known to " .. table.concat(said, ", ") .. ".") or ""
  local name = several and html.tag("p", {class = "caption"}, html.tag("b", nil, html.text(id))) or ""
  return name .. html.folded_table("work", heads, rows, most_rows, "runs") .. note
end

-- Error against run time, a table for each study of the list.
function studies.work_precision(list)
  local ids, runs, out = {}, {}, {}
  for _, w in ipairs(list) do
    if not runs[w.id] then
      ids[#ids + 1] = w.id
      runs[w.id] = {}
    end
    table.insert(runs[w.id], w)
  end
  for i, id in ipairs(ids) do out[i] = study(id, runs[id], #ids > 1) end
  return table.concat(out, "\n")
end

function studies.stability(list)
  local rows = {}
  for i, s in ipairs(list) do
    local number = function(x) return type(x) == "number" and html.number(("%.2g"):format(x)) or "–" end
    local error, bound = number(s.error), number(s.allowed)
    rows[i] = {
      html.tag("span", {id = "stability/" .. s.id}, html.text(s.case)), html.text(s.stress),
      html.text(s.result) .. ((s.reference or "") ~= "" and html.tag("span", {class = "place"}, "reference: " .. html.text(s.reference)) or ""),
      {error, class = "number"}, {bound, class = "number"}, {html.badge(s.pass and s.found or "failed"), class = "outcome"}}
  end
  return html.folded_table("stability cards", {"case", "what is stressed", "result", "error", "allowed", "found"}, rows, most_rows, "cases")
end

return studies
