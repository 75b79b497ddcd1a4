-- gnuplot's drawings as the book has them: words in the colour of a thin line, which are hard to read on white, get a darker one of
-- the same hue, with a contrast of 4.5 or more; exponents and indices are at least 9 px high at the width at which a page shows the
-- drawing (book.css: 992 px of a canvas from 1100 px on, else 736 px); and what is drawn takes few bytes.

local drawings = {}

local darker = {["86,180,233"] = "58,121,156", ["230,159,0"] = "154,107,0", ["204,121,167"] = "159,94,130", ["0,158,115"] = "0,131,95",
  ["213,94,0"] = "190,84,0", ["127,127,127"] = "112,112,112", ["128,128,128"] = "112,112,112"}

local function tenths(x) return math.floor(10 * x + 0.5) end

-- A number of tenths, without what can be left out.
local function number(n)
  local text = n % 10 == 0 and ("%d"):format(n // 10) or ("%.1f"):format(n / 10)
  return (text:gsub("^(-?)0%.", "%1."))
end

local function pair(x, y)
  local second = number(y)
  return number(x) .. (second:find("^-") and "" or ",") .. second
end

local nearest = 1.5 -- tenths of a dot that a curve may move when points are left out
local most_left_out = 80

-- The points {x, y} of a polyline, in tenths, without those that lie on the straight line of their neighbours.
local function thinned(points)
  local out, kept = {points[1]}, 1
  local function straight(last)
    local from, to = points[kept], points[last]
    local dx, dy = to[1] - from[1], to[2] - from[2]
    local length = math.sqrt(dx * dx + dy * dy)
    for i = kept + 1, last - 1 do
      local x, y = points[i][1] - from[1], points[i][2] - from[2]
      local along = x * dx + y * dy
      if length == 0 or along < 0 or along > length * length or math.abs(x * dy - y * dx) > nearest * length then return false end
    end
    return true
  end
  for i = 3, #points do
    if i - kept > most_left_out or not straight(i) then
      kept = i - 1
      out[#out + 1] = points[kept]
    end
  end
  if #points > 1 then out[#out + 1] = points[#points] end
  return out
end

-- A path of gnuplot's, of absolute M, L and Z, to a tenth of a dot and relative.
local function path(d)
  if d:find("[^MLZ%d%s.,-]") then return d end
  local out, points = {}, {}
  local function close()
    for i, point in ipairs(#points > 0 and thinned(points) or {}) do
      if i == 1 then
        out[#out + 1] = "M" .. pair(point[1], point[2])
      else
        local before = points.last
        local step = pair(point[1] - before[1], point[2] - before[2])
        out[#out + 1] = (i > 2 and (step:find("^-") and "" or " ") or "l") .. step
      end
      points.last = point
    end
    points = {}
  end
  for letter, first, second in (d .. " "):gmatch("([MLZ]?)%s*(%-?[%d.]*),?(%-?[%d.]*)%s") do
    if letter == "Z" then
      close()
      out[#out + 1] = "z"
    elseif first ~= "" then
      if letter == "M" then close() end
      local point, before = {tenths(tonumber(first)), tenths(tonumber(second))}, points[#points]
      local same = before and before[1] == point[1] and before[2] == point[2] and #points > 1
      if not same then points[#points + 1] = point end
    end
  end
  close()
  return table.concat(out)
end

local function colour(r, g, b) return ("#%02x%02x%02x"):format(tonumber(r), tonumber(g), tonumber(b)) end

-- The definitions of marks that are drawn, with those that these are made of.
local function used_marks(svg)
  local head, defs, body = svg:match("^(.-<defs>)(.-)(</defs>.*)$")
  if not head then return svg end
  local kept, wanted = {}, {}
  for id in body:gmatch("#(gpPt%d+)") do wanted[id] = true end
  for id in body:gmatch("#(gpDot)") do wanted[id] = true end
  local marks = {}
  for mark in defs:gmatch("<[%a]+ [^<>]*/>") do
    local id = mark:match("id='(%w+)'")
    if id then marks[#marks + 1] = {id = id, of = mark:match("href='#(%w+)'"), text = mark} end
  end
  for i = #marks, 1, -1 do
    if wanted[marks[i].id] and marks[i].of then wanted[marks[i].of] = true end
  end
  for _, mark in ipairs(marks) do
    if wanted[mark.id] then kept[#kept + 1] = mark.text end
  end
  for filter, id in defs:gmatch("(<filter id='(%w+)'.-</filter>)") do
    if body:find("url(#" .. id, 1, true) then kept[#kept + 1] = filter end
  end
  return head .. table.concat(kept) .. body
end

-- Groups and paths of the same attributes, of which there are more than two, as classes. Each kind: an element, a pattern of attributes,
-- and its rule.
local kinds = {
  {"g", 'fill="none" color="([%w#]+)" stroke="currentColor" stroke%-width="([%d.]+)"', "fill:none;stroke:currentColor;color:%s;stroke-width:%s"},
  {"g", 'stroke="none" fill="([%w#]+)" font%-size="([%d.]+)" +text%-anchor="(%w+)"', "stroke:none;fill:%s;font-size:%spx;text-anchor:%s"},
  {"path", "stroke='([%w#]+)' stroke%-dasharray='([%d.,]+)'", "stroke:%s;stroke-dasharray:%s"},
  {"path", "stroke='([%w#]+)'", "stroke:%s"},
  {"use", "color='([%w#]+)'", "color:%s"},
}

local function classes(svg)
  local rules = {}
  for _, kind in ipairs(kinds) do
    local count, order, class = {}, {}, {}
    local element, attributes = "<" .. kind[1] .. " [^>]*>", "(" .. kind[2] .. ")"
    for text in svg:gmatch(element) do
      local found = text:match(attributes)
      if found then
        if not count[found] then order[#order + 1] = found end
        count[found] = (count[found] or 0) + 1
      end
    end
    for _, found in ipairs(order) do
      if count[found] > 2 and #rules < 52 then
        local n = #rules
        class[found] = string.char((n < 26 and 97 or 39) + n) -- a to z, then A to Z
        rules[n + 1] = "." .. class[found] .. "{" .. kind[3]:format(found:match(kind[2])) .. "}"
      end
    end
    svg = svg:gsub(element, function(text)
      return (text:gsub(attributes, function(found) return class[found] and ('class="%s"'):format(class[found]) end, 1))
    end)
  end
  if #rules == 0 then return svg end
  return (svg:gsub("<defs>", "<style>" .. table.concat(rules) .. "</style><defs>", 1))
end

-- The text of an SVG file prepared; that of another program than gnuplot gets its exponents and colours only.
function drawings.prepared(svg)
  for from, to in pairs(darker) do
    svg = svg:gsub('fill="rgb%(' .. from .. '%)" font%-size', 'fill="rgb(' .. to .. ')" font-size')
  end
  local canvas = tonumber(svg:match('viewBox="0 0 (%d+)'))
  if canvas then
    local least = math.ceil(90 * canvas / (canvas >= 1100 and 992 or 736)) / 10
    svg = svg:gsub('<tspan +font%-size="([%d.]+)"', function(size)
      return ('<tspan font-size="%.1f"'):format(math.max(tonumber(size), least))
    end)
  end
  if not svg:find("<title>Gnuplot</title>", 1, true) then return svg end
  svg = svg:gsub("xlink:href='#gp", "href='#gp")
  svg = svg:gsub(" d='([^']*)'", function(d) return " d='" .. path(d) .. "'" end)
  svg = svg:gsub("<polygon fill = ('[^']*')([^>]-) points = '([^']*)'/>", function(fill, attributes, points)
    local opacity = tonumber(attributes:match("fill%-opacity = '([%d.]+)'") or 1)
    return ("<path fill=%s%s d='%s'/>"):format(fill, opacity < 1 and (" fill-opacity='%g'"):format(opacity) or "", path("M" .. points .. " Z "))
  end)
  svg = svg:gsub("translate%((%-?[%d.]+),(%-?[%d.]+)%)", function(x, y) return "translate(" .. pair(tenths(x), tenths(y)) .. ")" end)
  svg = svg:gsub("(['\"])rgb%( *(%d+), *(%d+), *(%d+)%)", function(quote, r, g, b) return quote .. colour(r, g, b) end)
  svg = svg:gsub(' stroke%-linecap="butt" stroke%-linejoin="miter"', ""):gsub(' class="gridline"', "") -- as without
  svg = svg:gsub('<tspan font%-size="[%d.]+" dy="[%d.-]+"></tspan></text>', "</text>"):gsub("<tspan >", "<tspan>")
  svg = svg:gsub("(<tspan[^>]*>%s*)%-(%.?%d[%d.]*%s*</tspan>)", "%1−%2") -- a minus, as in the text
  svg = svg:gsub("^<%?xml.-%?>%s*", ""):gsub("<desc>.-</desc>%s*", ""):gsub("<title>gnuplot_plot_%w+</title>", ""):gsub(">%s*\n%s*<", "><"):gsub("%s+>", ">")
  return classes(used_marks(svg))
end

-- A table of a figure, its numbers to six digits.
function drawings.rounded(text)
  local function short(cell)
    local number = tonumber(cell)
    local digits = ("%.6g"):format(number or 0):gsub("e([+-])0", "e%1"):gsub("e%+", "e")
    return number and #digits < #cell and digits or nil
  end
  return (text:gsub("%f[^,\n\0](%-?%d*%.%d+)%f[,\n\0]", short):gsub("%f[^,\n\0](%-?%d*%.%d+e[+-]?%d+)%f[,\n\0]", short))
end

-- Changes a file in its place, where it is.
local function change(path_of_file, by)
  local file = io.open(path_of_file, "rb")
  if not file then return end
  local text = file:read("a")
  file:close()
  file = assert(io.open(path_of_file, "wb"))
  file:write(by(text))
  file:close()
end

function drawings.prepare(path_of_file) change(path_of_file, drawings.prepared) end
function drawings.round(path_of_file) change(path_of_file, drawings.rounded) end

return drawings
