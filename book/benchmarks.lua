-- Error against run time of all studies as small drawings on common axes.

local html = require "html"

local benchmarks = {}

local width, height = 430, 250
local left, right, top, bottom = 46, 8, 8, 34
local axes = {seconds = {-7, 2}, error = {-16, 0}}
local colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#B07A00", "#3F8FC0", "#7F7F7F", "#7A4FBF"}

local function place(value, range, from, to)
  local share = (math.log(value, 10) - range[1]) / (range[2] - range[1])
  return from + math.min(1, math.max(0, share)) * (to - from)
end

local function x_of(seconds) return place(seconds, axes.seconds, left, width - right) end
local function y_of(error) return place(error, axes.error, height - bottom, top) end

local function power(n) return ("10<tspan dy=\"-4\" font-size=\"8\">%s%d</tspan>"):format(n < 0 and "−" or "", math.abs(n)) end

local function frame()
  local out = {}
  for n = axes.seconds[1], axes.seconds[2] do
    local x = x_of(10.0 ^ n)
    out[#out + 1] = ('<line class="grid" x1="%.1f" x2="%.1f" y1="%d" y2="%d"/>'):format(x, x, top, height - bottom)
    if n % 3 == 0 then
      local names = {[-6] = "1 µs", [-3] = "1 ms", [0] = "1 s"}
      out[#out + 1] = ('<text x="%.1f" y="%d" text-anchor="middle">%s</text>'):format(x, height - bottom + 13, names[n] or "")
    end
  end
  for n = axes.error[1], axes.error[2], 4 do
    local y = y_of(10.0 ^ n)
    out[#out + 1] = ('<line class="grid" x1="%d" x2="%d" y1="%.1f" y2="%.1f"/>'):format(left, width - right, y, y)
    out[#out + 1] = ('<text x="%d" y="%.1f" text-anchor="end">%s</text>'):format(left - 4, y + 4, power(n))
  end
  out[#out + 1] = ('<text x="%d" y="%d" text-anchor="middle">run time</text>'):format((left + width) // 2, height - 6)
  out[#out + 1] = ('<text transform="translate(10 %d) rotate(-90)" text-anchor="middle">error</text>'):format((height - bottom) // 2)
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
  for _, runs in pairs(by_method) do table.sort(runs, function(a, b) return a.seconds_min < b.seconds_min end) end
  return by_method, order
end

local function panel(list, title)
  local by_method, order = curves(list)
  if #order == 0 then return nil end
  local uncertainty, out, keys = 0, {frame()}, {}
  for _, w in ipairs(list) do uncertainty = math.max(uncertainty, w.reference_uncertainty or 0) end
  if uncertainty > 0 then
    local y = y_of(uncertainty)
    out[#out + 1] = ('<rect class="band" x="%d" y="%.1f" width="%d" height="%.1f"/>'):format(
      left, y, width - left - right, height - bottom - y)
  end
  for i, method in ipairs(order) do
    local colour, points = colours[(i - 1) % #colours + 1], {}
    for j, w in ipairs(by_method[method]) do
      local x, y = x_of(w.seconds_median), y_of(math.max(w.error, 1e-300))
      points[j] = ("%.1f,%.1f"):format(x, y)
      out[#out + 1] = ('<circle cx="%.1f" cy="%.1f" r="3" fill="%s"><title>%s</title></circle>'):format(x, y, colour,
        html.escape(("%s, %s: error %.2g in %.3g s"):format(w.method, w.setting, w.error, w.seconds_median)))
    end
    out[#out + 1] = ('<polyline points="%s" fill="none" stroke="%s" stroke-width="1.5"/>'):format(table.concat(points, " "), colour)
    keys[i] = ('<span class="key"><svg width="12" height="12" aria-hidden="true"><circle cx="6" cy="6" r="4" fill="%s"/></svg> %s</span>')
      :format(colour, html.text(method))
  end
  local drawing = html.tag("svg", {class = "panel", viewBox = ("0 0 %d %d"):format(width, height), role = "img",
    ["aria-label"] = title}, table.concat(out))
  return drawing, table.concat(keys, " ")
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
  local out = {}
  for _, r in ipairs(records) do
    local tiles = {}
    local studies, ids = group(r.work_precision, "id")
    for _, id in ipairs(ids) do
      local quantities, names = group(studies[id], "quantity")
      for k, name in ipairs(names) do
        local item, own = drawn_in(r, id, names, k)
        local title = (item and item.title or id):gsub(" and work$", "") .. (own and "" or ": " .. name)
        local drawing, keys = panel(quantities[name], title)
        local page = r.has_study and r.chapter .. "-study" or r.chapter
        local link = html.tag("a", {href = page .. ".html" .. (item and "#" .. item.id or "")}, html.text(title))
        tiles[#tiles + 1] = html.tag("li", nil, html.tag("p", nil, html.tag("b", nil, link)) .. (drawing
          and drawing .. html.tag("p", {class = "keys"}, keys) or html.tag("p", nil, "Not timed in this run.")))
      end
    end
    if #tiles > 0 then
      out[#out + 1] = html.tag("h2", {id = r.chapter}, r.number .. " " .. html.text(r.title))
      out[#out + 1] = html.tag("ul", {class = "panels"}, table.concat(tiles, "\n"))
    end
  end
  return table.concat(out, "\n")
end

return benchmarks
