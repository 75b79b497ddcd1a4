-- What stands around every page: the contents at the side, the page before and the page after.

local html, tools = require "html", require "tools"

local frame = {}

-- The pages made of all records, in reading order: file, name, and what they are for.
frame.overviews = {
  {"findings", "Findings", "what did not come out as the papers have it, and what opens each chapter"},
  {"ledger", "Ledger", "every check: what is printed, what came out, how much of its tolerance is used"},
  {"benchmarks", "Benchmarks", "error against run time of every method"},
  {"stability", "Stability", "every stiff and extreme case, and what became of it"},
  {"verification", "Verification", "what the library is held against"},
  {"equations", "Equations", "every equation of the papers, its function, its test"},
  {"library", "Library", "every public function and type, room by room"},
  {"gallery", "Gallery", "two dozen figures"},
  {"tools", "Tools", "the command for data of your own: examples, answers, file formats"},
  {"symbols", "Symbols and units", "what the letters of the formulas mean"},
  {"cite", "How to cite", "the project and the papers"},
  {"changes", "Changes", "what is new in each version"},
  {"reading", "How to read a page", "what stands where, and what the words mean"},
}

-- The texts of metadata given once or several times on pandoc's command line.
function frame.strings(value)
  local out = {}
  if not value then return out end
  if pandoc.utils.type(value) ~= "List" then value = {value} end
  for i, entry in ipairs(value) do out[i] = pandoc.utils.stringify(entry) end
  return out
end

-- The chapters as the build names them, "01-contact|Contact stress|study": {id, number, title, study}.
function frame.chapters(strings)
  local out = {}
  for i, text in ipairs(strings) do
    local id, title, study = text:match("^([^|]*)|(.*)|([^|]*)$")
    out[i] = {id = id, number = tonumber(id:match("^%d+")), title = title, study = study == "study"}
  end
  return out
end

-- Every page in the order of reading: {{file, title}, ...}.
function frame.pages(chapters)
  local out = {{"index", "railbook"}}
  for _, c in ipairs(chapters) do
    out[#out + 1] = {c.id, c.number .. " " .. c.title}
    if c.study then out[#out + 1] = {c.id .. "-study", c.number .. " Cost and stability"} end
  end
  for _, page in ipairs(frame.overviews) do out[#out + 1] = {page[1], page[2]} end
  return out
end

local function link(file, text, current, class)
  return html.tag("a", {href = file .. ".html", class = class, ["aria-current"] = file == current and "page" or nil}, text)
end

-- The contents of the book before and after the place where the sections of the page `current` stand.
local function contents(chapters, current)
  local before, after, out = {}, {}, nil
  out = before
  local function add(text) out[#out + 1] = text end
  add('<ul class="overview">')
  add("<li>" .. link("index", "Front page", current) .. "</li>")
  for _, page in ipairs(frame.overviews) do
    add("<li>" .. link(page[1], page[2], current))
    if page[1] == current then out = after end
    add("</li>")
  end
  add('</ul>\n<ol class="chapters">')
  for _, c in ipairs(chapters) do
    local study = c.id .. "-study"
    add("<li>" .. link(c.id, c.number .. " " .. html.text(c.title), current))
    if c.id == current then out = after end
    if c.study and (current == c.id or current == study) then
      add(link(study, "Cost and stability", current, "study"))
      if study == current then out = after end
    end
    add("</li>")
  end
  add("</ol>")
  return table.concat(before, "\n"), table.concat(after, "\n")
end

local function raw(text) return pandoc.MetaInlines({pandoc.RawInline("html", text)}) end

-- Sets what the template needs of the book around the page `current`.
function frame.set(meta, chapters, current)
  local before, after = contents(chapters, current)
  for subject, id in pairs(tools.chapters) do -- the command for a reader's own data, under the chapter's title
    if id == current then meta.command = pandoc.MetaString(subject) end
  end
  meta["contents-before"], meta["contents-after"], meta.file = raw(before), raw(after), pandoc.MetaString(current)
  local pages = frame.pages(chapters)
  for i, page in ipairs(pages) do
    if page[1] == current then
      meta.running = raw((page[2]:gsub('[\\"<&]', function(c) return ("\\%x "):format(c:byte()) end))) -- a string of CSS, for the head of a printed page
      local previous, following = pages[i - 1], pages[i + 1]
      if previous then meta.prev, meta["prev-title"] = pandoc.MetaString(previous[1]), raw(html.text(previous[2])) end
      if following then meta.next, meta["next-title"] = pandoc.MetaString(following[1]), raw(html.text(following[2])) end
    end
  end
end

return frame
