-- The front page: the picture that moves, the cards, the doors, and the figure of all printed numbers. All of them are drawn from the
-- records and from the tables that the chapters leave.

local html, items, csv = require "html", require "items", require "csv"

local front = {}

local function stop(text)
  io.stderr:write("book: the front page: ", text, "\n")
  os.exit(1)
end

local function chapter(records, id)
  for _, r in ipairs(records) do
    if r.chapter == id then return r end
  end
end

-- The rows of a chapter's table, of which the named columns must be there.
local function rows_of(r, name, columns)
  local rows, heads = csv.read(r.path:gsub("%.json$", "/") .. name)
  if not rows then stop(heads) end
  for _, column in ipairs(columns) do
    local there = column == "block"
    for _, head in ipairs(heads) do there = there or head == column end
    if not there then stop(("%s/%s has no column %s"):format(r.chapter, name, column)) end
  end
  return rows
end

local function value(r, id)
  local found = r.value[id]
  return found and found.text or stop(("%s has no value %s"):format(r.chapter, id))
end

-- "{{02-hunting/torus-range}}" in a text as the value of the record.
local function filled(text, records)
  return (text:gsub("{{([%w-]+)/([%w-]+)}}", function(id, name)
    local r = chapter(records, id)
    return html.number(value(r or stop("there is no record of " .. id), name))
  end))
end

local function numbers(x, y) return ("%.1f,%.1f"):format(x, y) end

-- ---- a small drawing for a card

local box = {width = 240, height = 150, left = 8, right = 8, top = 10, bottom = 24}

-- A column of a row, or the product "a*b" of two.
local function evaluate(row, expression)
  local product = 1
  for name in expression:gmatch("[^*]+") do product = product * (tonumber(row[name]) or 0 / 0) end
  return product
end

-- A curve of a card: "file.csv x y" with, after it, words "column=value" that rows must have (block=0 is the first of several), and
-- "dots" for points or "wide" for a broad pale line.
local function curve(r, text)
  local words, wanted, points = {}, {}, {}
  for word in text:gmatch("%S+") do words[#words + 1] = word end
  local name, x, y = words[1], words[2], words[3]
  for i = 4, #words do
    local column, is = words[i]:match("^(.+)=(.+)$")
    if column then wanted[column] = is end
  end
  local columns = {}
  for part in (x .. "*" .. y):gmatch("[^*]+") do columns[#columns + 1] = part end
  for column in pairs(wanted) do columns[#columns + 1] = column end
  for _, row in ipairs(rows_of(r, name, columns)) do
    local fits = true
    for column, is in pairs(wanted) do fits = fits and row[column] == is end
    if fits then points[#points + 1] = {evaluate(row, x), evaluate(row, y), row.block} end
  end
  return {points = points, dots = words[#words] == "dots", wide = words[#words] == "wide"}
end

-- The limits of an axis, "0 20", or those of the points.
local function range(text, curves, index, log)
  local low, high = (text or ""):match("^(%S+) (%S+)$")
  if low then return tonumber(low), tonumber(high) end
  low, high = math.huge, -math.huge
  for _, c in ipairs(curves) do
    for _, p in ipairs(c.points) do
      local v = p[index]
      if v == v and (not log or v > 0) then low, high = math.min(low, v), math.max(high, v) end
    end
  end
  local wider = log and 0 or 0.06 * (high - low)
  return low - wider, high + wider
end

local function scale(low, high, from, to, log)
  if log then low, high = math.log(low), math.log(high) end
  return function(v)
    if log then v = v > 0 and math.log(v) or 0 / 0 end
    local at = from + (v - low) / (high - low) * (to - from)
    return at == at and at or nil
  end
end

local function path(c, x, y)
  local out, pen, block, last_x, last_y = {}, "M", nil, nil, nil
  for _, p in ipairs(c.points) do
    local px, py = x(p[1]), y(p[2])
    if p[3] ~= block then pen, block = "M", p[3] end
    if px and py then
      if pen == "M" or (px - last_x) ^ 2 + (py - last_y) ^ 2 > 1 then -- closer than a dot is not seen
        out[#out + 1], pen = pen .. numbers(px, py), "L"
        last_x, last_y = px, py
      end
    else
      pen = "M"
    end
  end
  return table.concat(out)
end

-- The drawing of a card with the attributes curve-1, curve-2, ..., x, y (names of the axes), x-range, y-range and log.
local function small_drawing(r, attributes, what)
  local log_x, log_y = (attributes.log or ""):find("x") ~= nil, (attributes.log or ""):find("y") ~= nil
  local curves = {}
  while attributes["curve-" .. #curves + 1] do
    curves[#curves + 1] = curve(r, attributes["curve-" .. #curves + 1])
    if #curves[#curves].points < 2 then stop("the card of " .. r.chapter .. " has a curve without points") end
  end
  local x1, x2 = range(attributes["x-range"], curves, 1, log_x)
  local y1, y2 = range(attributes["y-range"], curves, 2, log_y)
  local x = scale(x1, x2, box.left, box.width - box.right, log_x)
  local y = scale(y1, y2, box.height - box.bottom, box.top + 14, log_y)
  local out = {('<path class="axis" d="M%s H%s"/>'):format(numbers(box.left, box.height - box.bottom), box.width - box.right)}
  local clip = "clip-" .. r.chapter
  out[#out + 1] = ('<clipPath id="%s"><rect x="%d" y="%d" width="%d" height="%d"/></clipPath>'):format(clip, box.left, box.top,
    box.width - box.left - box.right, box.height - box.top - box.bottom)
  out[#out + 1] = ('<g clip-path="url(#%s)">'):format(clip)
  for i, c in ipairs(curves) do
    if c.dots then
      for _, p in ipairs(c.points) do
        local px, py = x(p[1]), y(p[2])
        if px and py then out[#out + 1] = ('<circle class="curve-%d" cx="%.1f" cy="%.1f" r="2.6"/>'):format(i, px, py) end
      end
    else
      out[#out + 1] = ('<path class="line curve-%d%s" d="%s"/>'):format(i, c.wide and " broad" or "", path(c, x, y))
    end
  end
  out[#out + 1] = ('</g><text x="%d" y="%d">%s</text>'):format(box.left, box.top + 2, html.escape("↑ " .. attributes.y))
  out[#out + 1] = ('<text x="%d" y="%d" text-anchor="end">%s</text>'):format(box.width - box.right, box.height - 8, html.escape(attributes.x .. " →"))
  return ('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(box.width, box.height, html.escape(what)) .. table.concat(out) .. "</svg>"
end

-- A card: a Div of the class card with a question and an answer in its paragraphs, chapter=NN-name, figure=id (where it leads), and the
-- attributes of small_drawing. Nil for a chapter that has no record.
function front.card(div, records)
  local a = div.attributes
  local r = chapter(records, a.chapter)
  if not r then return nil end
  local item = r.item[a.figure] or stop(("%s has no figure %s"):format(a.chapter, a.figure))
  local question, answer = pandoc.utils.stringify(div.content[1]), pandoc.utils.stringify(div.content[2])
  return html.tag("li", nil, html.tag("a", {href = items.href(item, r, "index")}, small_drawing(r, a, a.alt) .. html.tag("b", nil, html.text(question)))
    .. html.tag("p", nil, filled(html.text(answer), records)))
end

-- ---- a car that hunts

local plan = {width = 960, height = 250, centre = 118, foot = 10.2, inch = 62, gauge = 68}

-- Keyframes of a shift across the track, from the displacements of a period in inches.
local function keyframes(name, points)
  local out = {("@keyframes %s{"):format(name)}
  for _, p in ipairs(points) do
    out[#out + 1] = ("%.2f%%{transform:translateY(%.1fpx)}"):format(100 * p[1], p[2] * plan.inch)
  end
  out[#out + 1] = "}"
  return table.concat(out)
end

-- The path that a wheelset leaves behind: what it did `feet` ago, for `periods` periods to the left of x.
local function trail(points, x, length, periods)
  local out = {}
  for k = 0, periods - 1 do
    for i = #points, 2, -1 do
      out[#out + 1] = numbers(x - (k + 1 - points[i][1]) * length, plan.centre + points[i][2] * plan.inch)
    end
  end
  return table.concat(out, " ")
end

local function wheelset(class)
  local half = plan.gauge
  local out = {('<g class="%s"><g class="wheelset">'):format(class)}
  out[#out + 1] = ('<rect x="-3" y="%d" width="6" height="%d" rx="2"/>'):format(plan.centre - half + 8, 2 * half - 16)
  for _, side in ipairs({-1, 1}) do
    local at = plan.centre + side * (half - 12) - 7
    out[#out + 1] = ('<rect x="-17" y="%.1f" width="34" height="14" rx="3"/>'):format(at)
  end
  return table.concat(out) .. "</g></g>"
end

-- A stable cycle of the chapter on hunting, in plan view. Nil without that chapter.
function front.hunting(records)
  local r = chapter(records, "02-hunting")
  if not r then return "" end
  local ids = {front = {}, rear = {}, body = {}}
  for _, row in ipairs(rows_of(r, "fig-11-period.csv", {"part", "front_truck_in", "rear_truck_in", "body_in"})) do
    for name, points in pairs(ids) do table.insert(points, {tonumber(row.part), tonumber(row[name == "body" and "body_in" or name .. "_truck_in"])}) end
  end
  local function number(name) return tonumber((value(r, name):match "^[%d.]+")) end
  local speed, omega, flange, amplitude = number "period-speed", number "period-omega", number "flange-new", number "period-amplitude"
  local half_distance
  for _, row in ipairs((r.item.parameters or stop "02-hunting has no table parameters").rows) do
    if row[1] == "$L_C$" then half_distance = tonumber(row[3]) end
  end
  local period = 2 * math.pi / omega
  local length = speed * period * plan.foot -- px of a period along the track
  local seconds = 3
  local front_x = 660
  local rear_x = front_x - 2 * half_distance * plan.foot
  local ties = math.floor(length / 18 + 0.5)
  local tie = length / ties
  local css = {"@keyframes track{to{transform:translateX(-" .. ("%.1f"):format(length) .. "px)}}"}
  for _, name in ipairs({"front", "rear", "body"}) do css[#css + 1] = keyframes(name, ids[name]) end
  css[#css + 1] = (".moving :is(.track,.front,.rear,.body){animation:%gs linear infinite}.moving .track{animation-name:track}"):format(seconds)
  for _, name in ipairs({"front", "rear", "body"}) do
    css[#css + 1] = (".moving .%s{animation-name:%s;transform:translateY(%.1fpx)}"):format(name, name, ids[name][1][2] * plan.inch)
  end
  local out = {}
  local function add(...) out[#out + 1] = (...):format(select(2, ...)) end
  local rails, edge = {}, plan.gauge + flange * plan.inch - 5
  add('<clipPath id="behind-front"><rect x="0" y="0" width="%d" height="%d"/></clipPath>', front_x, plan.height)
  add('<clipPath id="behind-rear"><rect x="0" y="0" width="%.1f" height="%d"/></clipPath>', rear_x, plan.height)
  local tie_paths = {}
  for k = 0, math.ceil((plan.width + length) / tie) do tie_paths[#tie_paths + 1] = ("M%.1f,%.1f V%.1f"):format(k * tie, plan.centre - edge - 18, plan.centre + edge + 18) end
  add('<g class="track ties"><path d="%s"/></g>', table.concat(tie_paths))
  for _, side in ipairs({-1, 1}) do
    rails[#rails + 1] = ('<rect x="0" y="%.1f" width="%d" height="8"/>'):format(plan.centre + side * edge - (side < 0 and 8 or 0), plan.width)
  end
  add('<g class="rails">%s</g>', table.concat(rails))
  add('<path class="middle" d="M0,%d H%d"/>', plan.centre, plan.width)
  local periods = math.ceil(plan.width / length) + 1
  for _, part in ipairs({{"front", front_x}, {"rear", rear_x}}) do
    add('<g clip-path="url(#behind-%s)"><polyline class="track trail trail-%s" points="%s"/></g>', part[1], part[1],
      trail(ids[part[1]], part[2] + length, length, periods + 1))
  end
  add('<g class="body"><rect x="%.1f" y="%.1f" width="%.1f" height="%d" rx="10"/></g>', rear_x - 78, plan.centre - 40, front_x - rear_x + 156, 80)
  for _, part in ipairs({{"rear", rear_x}, {"front", front_x}}) do
    add('<g transform="translate(%.1f)">%s</g>', part[2], wheelset(part[1]))
  end
  local label = ('<text x="%.1f" y="%.1f" text-anchor="%s">%s</text>')
  local low = plan.centre + edge + 38
  add(label, rear_x, low, "middle", "rear wheelset")
  add(label, front_x, low, "middle", "front wheelset")
  add(label, (front_x + rear_x) / 2, plan.centre + 4, "middle", "car body")
  add(label, plan.width - 8, low, "end", ("%g ft/s →"):format(speed))
  local magnified = plan.inch / (plan.foot / 12)
  local says = ("Plan view of a freight car that hunts at %g ft/s: its two leading wheelsets swing from flange to flange, %s in to each side, "
    .. "and the body swings with them; the paths of the wheelsets lie behind them."):format(speed, amplitude)
  local figure = ('<figure class="moving"><style>%s</style><div><input type="checkbox" id="still"><label for="still">hold</label>'):format(table.concat(css))
    .. ('<svg viewBox="0 0 %d %d" role="img" preserveAspectRatio="xMidYMid slice" aria-label="%s">%s</svg>'):format(plan.width, plan.height, html.escape(says), table.concat(out))
    .. ('</div><figcaption><b>An empty freight car hunts at %g ft/s.</b> The leading wheelset of each truck is drawn; it swings %.2g in to either side. '
      .. 'Computed; profiles and dampers are ours. %.0f times enlarged across, %.0f times slower. <a href="%s">Choose the speed</a>.</figcaption></figure>')
      :format(speed, amplitude, magnified, seconds / period, r.chapter .. ".html#live-hunting")
  return figure
end

-- ---- all printed numbers

local chart = {width = 990, left = 84, right = 6, top = 20, height = 270, straight = 0.01, most = 40}

-- The place of a difference in per cent: straight up to chart.straight, then a power of ten for each equal step.
local function place(percent)
  local size = math.abs(percent)
  local steps = size <= chart.straight and size / chart.straight or 1 + math.log(size / chart.straight, 10)
  local most = 1 + math.log(chart.most / chart.straight, 10)
  return (percent < 0 and -1 or 1) * math.min(steps / most, 1.04)
end

-- The difference and the tolerance of a check in per cent of the print; nil for words.
local function deviation(check)
  local printed = tonumber((tostring(check.printed):gsub("−", "-")))
  local computed = tonumber(check.computed)
  if not printed or not computed or printed == 0 then return nil end
  local allowed = check.kind == "relative" and check.allowed or (check.kind == "last_digit" or check.kind == "absolute") and check.allowed / math.abs(printed)
  if check.kind == "at_most" then return nil end
  return 100 * (computed / printed - 1), allowed and 100 * allowed
end

-- Every number that a paper prints as a mark: its difference from the print on a scale of powers of ten, with its tolerance, in the colour
-- of what came of it; numbers that our copies do not show are marks on the lowest line. Each is a link to its check.
function front.numbers(records)
  local columns, untested = {}, 0 -- untested: numbers that can be read, and compared with nothing
  for _, r in ipairs(records) do
    local list = {}
    for _, check in ipairs(r.checks) do
      if check.source == "print" then list[#list + 1] = {check = check} end
    end
    for _, row in ipairs(r.inventory) do
      if row.kind == "number" and (row.reason or ""):find("^unreadable") then list[#list + 1] = {lost = row} end
      if row.kind == "number" and (row.reason or ""):find("^not testable") then untested = untested + 1 end
    end
    if #list > 0 then columns[#columns + 1] = {r = r, list = list} end
  end
  local count, gap = 0, 1.6
  for _, column in ipairs(columns) do count = count + #column.list + gap end
  if count == 0 then return "" end
  local step = (chart.width - chart.left - chart.right) / count
  local middle, half, lowest = chart.top + chart.height / 2, chart.height / 2, chart.top + chart.height + 22
  local out, at, seen, marks = {}, chart.left, {}, 0
  local function add(...) out[#out + 1] = (...):format(select(2, ...)) end
  for _, percent in ipairs({-10, -1, -0.1, 0, 0.1, 1, 10}) do
    local y = middle - half * place(percent)
    add('<path class="grid" d="M%d,%.1f H%d"/><text x="%d" y="%.1f" text-anchor="end">%s</text>', chart.left, y, chart.width - chart.right, chart.left - 6,
      y + 4, percent == 0 and "0" or ("%s%g %%"):format(percent < 0 and "−" or "+", math.abs(percent)))
  end
  add('<text x="%d" y="%.1f" text-anchor="end">unreadable</text>', chart.left - 6, lowest + 4)
  for _, column in ipairs(columns) do
    local r, start = column.r, at
    at = at + gap / 2 * step
    for _, entry in ipairs(column.list) do
      local x, check = at + step / 2, entry.check
      if check then
        marks = marks + 1
        local outcome = check.pass and check.outcome or "failed"
        local off, allowed = deviation(check)
        seen[outcome] = (seen[outcome] or 0) + 1
        local href = items.href(r.item[check.item], r, "index"):gsub("#.*$", "") .. "#" .. check.id
        local title = ("%s: printed %s, %s"):format(check.what or check.id, check.printed,
          off and (("difference %+.2g %%"):format(off):gsub("-", "−")) or "computed " .. tostring(check.computed_text or check.computed))
        add('<a href="%s" class="%s"><title>%s</title>', html.escape(href), outcome:gsub(" ", "-"), html.escape(title .. ", " .. outcome))
        if allowed then
          local up, down = middle - half * place(allowed), middle + half * place(allowed)
          add('<path class="tolerance" d="M%.1f,%.1f V%.1f"/>', x, up, down)
        end
        local y = middle - half * place(off or 0)
        if outcome == "consistent" then
          add('<rect x="%.1f" y="%.1f" width="6" height="6"/>', x - 3, y - 3)
        elseif outcome == "confirmed" then
          add('<circle cx="%.1f" cy="%.1f" r="3.4"/>', x, y)
        elseif outcome == "fitted" or outcome == "restored" then
          add('<path d="M%.1f,%.1f l4,4 -4,4 -4,-4 z"/>', x, y - 4)
        else
          add('<path d="M%.1f,%.1f l4.4,8 h-8.8 z"/>', x, y - 5)
        end
        add '</a>'
      else
        local lost = entry.lost
        seen.lost = (seen.lost or 0) + 1
        add('<a href="%s.html#coverage" class="lost"><title>%s</title><rect class="catch" x="%.1f" y="%.1f" width="10" height="10"/><path d="M%.1f,%.1f l6,6 m0,-6 l-6,6"/></a>', r.chapter,
          html.escape(lost.what .. ", " .. lost.reason), x - 5, lowest - 5, x - 3, lowest - 3)
      end
      at = at + step
    end
    at = at + gap / 2 * step
    local width = at - start
    if #columns > 1 and column ~= columns[#columns] then add('<path class="between" d="M%.1f,%d V%.1f"/>', at, chart.top - 6, lowest + 8) end
    add('<text x="%.1f" y="%.1f" text-anchor="middle">%s</text>', start + width / 2, lowest + 28, width > 60 and r.number .. " " .. r.chapter:gsub("^%d+%-", "") or tostring(r.number))
  end
  local key = {}
  for _, outcome in ipairs({"confirmed", "consistent", "fitted", "restored", "corrected", "not confirmed", "failed"}) do
    if seen[outcome] then key[#key + 1] = ('<span class="%s">%s</span> %d'):format(outcome:gsub(" ", "-"), outcome, seen[outcome]) end
  end
  local rebuilt, drawn = 0, 0 -- figures, and those that rest on inputs which a paper does not give
  for _, r in ipairs(records) do
    for _, item in ipairs(r.items) do
      if item.kind == "figure" then
        drawn = drawn + 1
        if item.input == "rebuilt" then rebuilt = rebuilt + 1 end
      end
    end
  end
  if seen.lost then key[#key + 1] = ('<span class="lost">unreadable</span> %d'):format(seen.lost) end
  return '<figure class="numbers"><div class="wide">' .. ('<svg viewBox="0 0 %d %d" role="group" aria-label="All printed numbers: difference from the print">%s</svg>')
    :format(chart.width, lowest + 36, table.concat(out)) .. ("</div><figcaption><b>All %d printed numbers that can be compared</b> (%d more cannot). Height: difference from the print, logarithmic beyond 0.01 %%; "
      .. "line: tolerance; triangles: corrected or not confirmed. %s. %d of %d figures rest on our inputs.</figcaption></figure>"):format(marks, untested, table.concat(key, " · "), rebuilt, drawn)
end

-- ---- the doors

-- Where to begin, and the chapters that are left out, with the reason.
function front.read(chapters, left_out)
  local out = {}
  for i, line in ipairs(left_out) do out[i] = html.tag("li", nil, html.text(line)) end
  local first = #chapters > 0 and ": " .. html.tag("a", {href = chapters[1].id .. ".html"}, "begin with the first") .. ", or follow a picture above" or ""
  return html.tag("p", nil, "A chapter teaches one paper, from its question to its limits" .. first .. ".")
    .. (#out > 0 and html.tag("ul", nil, table.concat(out, "\n")) or "")
end

return front
