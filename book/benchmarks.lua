-- Error against run time of all studies as small drawings, each on its own axes; a method has one colour on all of them.

local csv, html, items, record = require "csv", require "html", require "items", require "record"

local benchmarks = {}

local width, height = 430, 250
local left, right, top, bottom = 46, 8, 8, 34
local colours = 8 -- --curve-1 to --curve-8 of book.css

local function place(value, range, from, to)
  local share = (math.log(value, 10) - range[1]) / (range[2] - range[1])
  return from + math.min(1, math.max(0, share)) * (to - from)
end

local function power(n) return ("10<tspan dy=\"-4\" font-size=\"9\">%s%d</tspan>"):format(n < 0 and "−" or "", math.abs(n)) end

local times = {[-9] = "1 ns", [-8] = "10 ns", [-7] = "0.1 µs", [-6] = "1 µs", [-5] = "10 µs", [-4] = "0.1 ms", [-3] = "1 ms", [-2] = "10 ms", [-1] = "0.1 s", [0] = "1 s", [1] = "10 s",
  [2] = "100 s", [3] = "1000 s"}

-- Whole decades around the values, two at least and down to what a double holds.
local function decades(values, least, most)
  local low, high = math.huge, -math.huge
  for _, value in ipairs(values) do
    local n = math.log(value, 10)
    low, high = math.min(low, n), math.max(high, n)
  end
  low, high = math.max(least, math.floor(low)), math.min(most, math.ceil(high))
  while high - low < 2 do
    if high < most then high = high + 1 else low = low - 1 end
  end
  return {low, high}
end

local function frame(axes)
  local out = {}
  for n = axes.seconds[1], axes.seconds[2] do
    local x = place(10.0 ^ n, axes.seconds, left, width - right)
    out[#out + 1] = ('<line class="grid" x1="%.1f" x2="%.1f" y1="%d" y2="%d"/>'):format(x, x, top, height - bottom)
    local crowded = axes.seconds[2] - axes.seconds[1] > 6 and (n - axes.seconds[1]) % 2 == 1
    if not crowded then
      local anchor = n == axes.seconds[2] and "end" or "middle"
      out[#out + 1] = ('<text x="%.1f" y="%d" text-anchor="%s">%s</text>'):format(x, height - bottom + 13, anchor, times[n] or "")
    end
  end
  local step = math.ceil((axes.error[2] - axes.error[1]) / 6)
  for n = axes.error[2], axes.error[1], -step do
    local y = place(10.0 ^ n, axes.error, height - bottom, top)
    out[#out + 1] = ('<line class="grid" x1="%d" x2="%d" y1="%.1f" y2="%.1f"/>'):format(left, width - right, y, y)
    out[#out + 1] = ('<text x="%d" y="%.1f" text-anchor="end">%s</text>'):format(left - 4, y + 4, power(n))
  end
  out[#out + 1] = ('<text x="%d" y="%d" text-anchor="middle">run time</text>'):format((left + width) // 2, height - 6)
  out[#out + 1] = ('<text transform="translate(11 %d) rotate(-90)" text-anchor="middle">error</text>'):format((height - bottom) // 2)
  return table.concat(out)
end

-- The runs of one quantity by method, in the order of time; what failed or was not timed has no place.
local function curves(list)
  local by_method, order = {}, {}
  for _, w in ipairs(list) do
    if w.converged and type(w.error) == "number" and type(w.seconds_median) == "number" and w.seconds_median > 0 then
      if not by_method[w.method] then
        by_method[w.method], order[#order + 1] = {}, w.method
      end
      table.insert(by_method[w.method], w)
    end
  end
  for _, runs in pairs(by_method) do table.sort(runs, function(a, b) return a.seconds_median < b.seconds_median end) end
  return by_method, order
end

local function panel(list, title, colour_of)
  local by_method, order = curves(list)
  if #order == 0 then return nil end
  local uncertainty, keys = 0, {}
  for _, w in ipairs(list) do uncertainty = math.max(uncertainty, w.reference_uncertainty or 0) end
  local seconds, errors = {}, {}
  for _, runs in pairs(by_method) do
    for _, w in ipairs(runs) do
      seconds[#seconds + 1], errors[#errors + 1] = w.seconds_median, math.max(w.error, uncertainty, 1e-16)
    end
  end
  local axes = {seconds = decades(seconds, -9, 3), error = decades(errors, -16, 1)}
  local function y_of(error) return place(math.max(error, 1e-300), axes.error, height - bottom, top) end
  local out = {frame(axes)}
  if uncertainty > 10.0 ^ axes.error[1] then
    local y = y_of(uncertainty)
    out[#out + 1] = ('<rect class="band" x="%d" y="%.1f" width="%d" height="%.1f"/>'):format(
      left, y, width - left - right, height - bottom - y)
  end
  for i, method in ipairs(order) do
    local class, points = "method-" .. colour_of[method], {}
    for j, w in ipairs(by_method[method]) do
      local x, y = place(w.seconds_median, axes.seconds, left, width - right), y_of(w.error)
      points[j] = ("%.1f,%.1f"):format(x, y)
      out[#out + 1] = ('<circle class="%s" cx="%.1f" cy="%.1f" r="3"><title>%s</title></circle>'):format(class, x, y,
        html.escape(("%s, %s: error %.2g in %s"):format(w.method, w.setting, w.error, html.seconds(w.seconds_median))))
    end
    out[#out + 1] = ('<polyline class="%s" points="%s"/>'):format(class, table.concat(points, " "))
    keys[i] = ('<span class="key"><svg width="12" height="12" aria-hidden="true"><circle class="%s" cx="6" cy="6" r="4"/></svg> %s</span>')
      :format(class, html.text(method))
  end
  local drawing = html.tag("svg", {class = "panel", viewBox = ("0 0 %d %d"):format(width, height), role = "img",
    ["aria-label"] = title}, table.concat(out))
  return drawing, table.concat(keys, " ")
end

-- Studies whose settings are lengths of a record, each a problem of its own: among them nothing is the cheapest.
local lengths = {["04-filters/cost-length"] = true, ["05-psd/fig-cost"] = true}

-- The quickest run whose method reaches `level` with it and with all settings after it, which are finer ones: a coarse run that meets an
-- accuracy by luck does not count. The runs of a method stand together, in the order of its settings.
local function quickest(list, level)
  local best, candidate
  for i, w in ipairs(list) do
    if i == 1 or w.method ~= list[i - 1].method then candidate = nil end
    local timed = type(w.seconds_median) == "number" and w.seconds_median > 0
    if not (w.converged and type(w.error) == "number" and w.error + (w.reference_uncertainty or 0) <= level) then
      candidate = nil
    elseif timed and (not candidate or w.seconds_median < candidate.seconds_median) then
      candidate = w
    end
    local last = i == #list or list[i + 1].method ~= w.method
    if last and candidate and (not best or candidate.seconds_median < best.seconds_median
        or candidate.seconds_median == best.seconds_median and candidate.method < best.method) then best = candidate end
  end
  return best
end

-- "For 1 % the cheapest is CG-FFT with 12 (0.6 ms), for 0.1 % ..."; what no method reached is said. Errors in the grey band are not told
-- apart.
local function cheapest(list)
  local uncertainty = 0
  for _, w in ipairs(list) do uncertainty = math.max(uncertainty, w.reference_uncertainty or 0) end
  local out, reached = {}, true
  for _, level in ipairs({{1e-2, "1 %"}, {1e-3, "0.1 %"}, {1e-4, "0.01 %"}, {1e-6, "10<sup>−6</sup>"}}) do
    if level[1] < 100 * uncertainty then break end
    local best = quickest(list, level[1])
    if best then
      local same = out[#out] and out[#out].best == best
      if same then out[#out].level = level[2] else out[#out + 1] = {best = best, level = level[2]} end
    elseif reached then
      reached = false
      out[#out + 1] = {level = level[2]}
    end
  end
  local said = {}
  for i, entry in ipairs(out) do
    local best = entry.best
    local accuracy = (i == 1 and "For %s accuracy" or "for %s"):format(entry.level)
    local setting = best and best.setting ~= "" and " (" .. html.text(best.setting) .. ")" or ""
    said[i] = best and ("%s %s%s%s %s"):format(accuracy, html.text(best.method), setting, i == 1 and " is cheapest, with" or ", with",
      html.seconds(tonumber(("%.2g"):format(best.seconds_median)))) or (i == 1 and "No run reaches %s accuracy" or "no run reaches %s"):format(entry.level)
  end
  return #said > 0 and html.tag("p", {class = "cheapest"}, table.concat(said, "; ") .. ".") or ""
end

local function group(list, key)
  local groups, order = {}, {}
  for _, w in ipairs(list) do
    local name = w[key] or ""
    if not groups[name] then
      groups[name], order[#order + 1] = {}, name
    end
    table.insert(groups[name], w)
  end
  return groups, order
end

-- A number from 1 on for each method, such that methods of one study have different ones where the colours suffice.
local function colours_of(records)
  local colour, order, together = {}, {}, {}
  for _, r in ipairs(records) do
    local studies, ids = group(r.work_precision, "id")
    for _, id in ipairs(ids) do
      local _, methods = group(studies[id], "method")
      for _, method in ipairs(methods) do
        if not together[method] then
          together[method], order[#order + 1] = {}, method
        end
        for _, other in ipairs(methods) do together[method][other] = true end
      end
    end
  end
  for _, method in ipairs(order) do
    local taken = {}
    for other in pairs(together[method]) do
      if colour[other] then taken[colour[other]] = true end
    end
    local free = 1
    while taken[free] and free < colours do free = free + 1 end
    colour[method] = free
  end
  return colour
end

-- The figure of the k-th quantity of a study, and whether it draws that quantity: a chapter may draw one for each, "spin-fx", "spin-fy".
local function drawn_in(r, id, names, k)
  if #names == 1 then return r.item[id], true end
  local stem, same = id:match("^(.+)%-[^-]*$") or id, {}
  local named = r.item[stem .. "-" .. names[k]]
  if named then return named, true end
  for _, item in ipairs(r.items) do
    if item.png and item.page == "study" and item.id:match("^(.+)%-[^-]*$") == stem then same[#same + 1] = item end
  end
  if #same == #names then return same[k], true end
  return r.item[id], false
end

-- One panel for each study and quantity, the chapters one after the other.
function benchmarks.all(records)
  local out, colour_of, machine = {}, colours_of(records), nil
  for _, r in ipairs(records) do
    local tiles = {}
    local studies, ids = group(r.work_precision, "id")
    if #ids > 0 then machine = machine or r.machine end
    for _, id in ipairs(ids) do
      local quantities, names = group(studies[id], "quantity")
      for k, name in ipairs(names) do
        local item, own = drawn_in(r, id, names, k)
        local title = (item and items.plain_title(item) or id):gsub(" and work$", "") .. (own and "" or ": " .. name)
        local drawing, keys = panel(quantities[name], title, colour_of)
        local page = r.has_study and r.chapter .. "-study" or r.chapter
        local link = html.tag("a", {href = page .. ".html" .. (item and "#" .. item.id or "")}, html.text(title))
        tiles[#tiles + 1] = html.tag("li", nil, html.tag("p", nil, html.tag("b", nil, link)) .. (drawing
          and drawing .. html.tag("p", {class = "keys"}, keys) .. (lengths[r.chapter .. "/" .. id] and "" or cheapest(quantities[name])) or html.tag("p", nil, "Not timed in this run.")))
      end
    end
    if #tiles > 0 then
      out[#out + 1] = html.tag("h2", {id = r.chapter}, r.number .. " " .. html.text(r.title))
      out[#out + 1] = html.tag("ul", {class = "panels"}, table.concat(tiles, "\n"))
    end
  end
  if machine then table.insert(out, 1, html.tag("p", nil, "Measured on this machine: " .. record.describe(machine) .. ".")) end
  return table.concat(out, "\n")
end

-- What ten works of the command cost, from tests/cost/costs.csv in a folder.
function benchmarks.costs(folder)
  local rows = {}
  for _, row in ipairs(assert(csv.read(folder .. "/costs.csv"))) do
    local function number(cell) return {tonumber(cell) and html.text(("%.0f"):format(cell)) or "", class = "number"} end
    rows[#rows + 1] = {html.text(row.work), number(row.million_instructions), number(row.transform_pairs)}
  end
  return html.table("costs", {"work", "million instructions", "pairs of transforms"}, rows)
end

-- Processor time beside that of other programs, from tests/peers/ratios.csv in a folder.
function benchmarks.peers(folder)
  local rows, machine = {}, ""
  for line in io.lines(folder .. "/ratios.csv") do machine = line:match("^# (.*, load at the start .*)$") or machine end
  for _, row in ipairs(assert(csv.read(folder .. "/ratios.csv"))) do
    local function number(cell) return {html.text(cell), class = "number"} end
    rows[#rows + 1] = {html.text(row.work), html.text(row.peer), number(row.median), number(row.lowest .. " to " .. row.highest), number(row.runs)}
  end
  return html.tag("p", nil, "Measured on: " .. html.text(machine) .. ".")
    .. html.table("peers", {"work", "beside", "ratio, median", "lowest to highest", "runs"}, rows)
end

return benchmarks
