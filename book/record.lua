-- A chapter's record, build/results/NN-name.json, read and indexed.

local dkjson = require "dkjson"
local html = require "html"

local record = {}

-- Chapter NN-name as the page's files and anchors know it.
local function basename(path) return path:match("[^/]+$") end

local function index(list, path, what)
  local by_id = {}
  for _, entry in ipairs(list) do
    if not entry.id then error(path .. ": " .. what .. " without an id", 0) end
    by_id[entry.id] = entry
  end
  return by_id
end

-- Throws a text naming the file when it is missing or not a record.
function record.load(path)
  local file = io.open(path, "rb")
  if not file then error(path .. " does not exist: run the chapter first (make reproduce)", 0) end
  local r, _, problem = dkjson.decode(file:read("a"), 1, nil)
  file:close()
  if type(r) ~= "table" then error(path .. " is not a record: " .. tostring(problem), 0) end
  if not r.chapter then error(path .. ': has no "chapter"', 0) end
  for _, key in ipairs({"checks", "items", "values", "work_precision", "stability", "inventory"}) do r[key] = r[key] or {} end
  if type(r.only) == "table" and #r.only > 0 then
    error(("%s holds only %s: run the whole chapter"):format(path, table.concat(r.only, ", ")), 0)
  end
  r.path = path
  r.number = tonumber(r.chapter:match("^%d+")) or 0
  r.title = r.title or r.chapter
  r.value, r.item = index(r.values, path, "a value"), index(r.items, path, "an item")
  for _, item in ipairs(r.items) do
    item.checks, item.csv = {}, item.csv or {}
    if type(item.csv) == "string" then item.csv = {item.csv} end
    for i, name in ipairs(item.csv) do item.csv[i] = basename(name) end
    for _, key in ipairs({"png", "script"}) do item[key] = item[key] and basename(item[key]) end -- "" becomes nil
    item.input, item.page = item.input or "paper", item.page or "paper"
    if item.failure == "" then item.failure = nil end
    if item.png then item.kind = "figure" end
  end
  r.check = {}
  for _, check in ipairs(r.checks) do
    check.of_paper = check.source == "print" or check.source == "claim"
    local item = r.item[check.item]
    if not item then error(("%s: check %s belongs to no item"):format(path, tostring(check.id)), 0) end
    table.insert(item.checks, check)
    r.check[check.id] = check
  end
  for _, item in ipairs(r.items) do r.has_study = r.has_study or item.page == "study" end
  return r
end

-- Share of the tolerance used, or nil where a check has no width (bounds, texts).
function record.used(check)
  local bound = check.kind == "at_most" or check.kind == "at_least" or check.kind == "exact" or check.kind == "not_the_print"
  local known = type(check.error) == "number" and type(check.allowed) == "number"
  if bound or not known or check.allowed <= 0 or check.trial then return nil end
  return check.error / check.allowed
end

-- passed, total, and the check closest to its tolerance.
function record.tally(checks)
  local passed, closest = 0, nil
  for _, check in ipairs(checks) do
    if check.pass then passed = passed + 1 end
    local used = record.used(check)
    if used and (not closest or used > record.used(closest)) then closest = check end
  end
  return passed, #checks, closest
end

record.outcomes = {"confirmed", "consistent", "fitted", "corrected", "restored", "not confirmed", "verified", "failed"}

-- {{outcome, count}, ...} of a list of checks, in that order.
function record.count(checks)
  local counts, out = {}, {}
  for _, check in ipairs(checks) do counts[check.outcome] = (counts[check.outcome] or 0) + 1 end
  for _, outcome in ipairs(record.outcomes) do
    if counts[outcome] then out[#out + 1] = {outcome, counts[outcome]} end
  end
  return out
end

-- The machine and the packages as one line of HTML.
function record.describe(machine)
  local keys, parts = {}, {}
  for key in pairs(machine or {}) do keys[#keys + 1] = key end
  table.sort(keys)
  for _, key in ipairs(keys) do
    local value = machine[key]
    local text = type(value) == "table" and record.describe(value) or html.escape(tostring(value))
    parts[#parts + 1] = html.escape(key:gsub("_", " ")) .. ": " .. text
  end
  return table.concat(parts, " · ")
end

return record
