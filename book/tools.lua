-- The page Tools: docs/own-data.md, docs/commands.md, docs/many-records.md and docs/python.md, which tests hold to what the command answers.

local html, drawings = require "html", require "drawings"

local tools = {}

-- The chapter of each subject of the command, and back.
tools.chapters = {
  contact = "01-contact", hunting = "02-hunting", creep = "03-creep", filters = "04-filters", psd = "05-psd", quality = "06-quality",
  track = "07-track", wheelrail = "08-wheel-on-rail",
}

local most_lines = 7 -- of a longer answer these are open

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("a")
  file:close()
  return text
end

-- An answer as it is printed, its end folded when it is long.
local function answer(text)
  local lines = {}
  for line in (text .. "\n"):gmatch("(.-)\n") do lines[#lines + 1] = line end
  local function pre(first, last) return html.tag("pre", {class = "output"}, html.escape(table.concat(lines, "\n", first, last))) end
  if #lines <= most_lines + 4 then return pre(1, #lines) end
  return pre(1, most_lines) .. html.tag("details", {class = "more"},
    html.tag("summary", nil, ("%d more lines"):format(#lines - most_lines)) .. pre(most_lines + 1, #lines))
end

-- The drawing pictures/NAME of docs/, whose copy in figures/tools of the book is prepared as those of the chapters are.
local function picture(folder, book, image)
  local name = image.src:match("[^/]+$")
  drawings.prepare(book .. "/figures/tools/" .. name)
  local width, height = read(folder .. "/" .. image.src):match('width="(%d+)" height="(%d+)"')
  local what = pandoc.utils.stringify(image.caption)
  return html.tag("figure", nil, html.tag("a", {href = "figures/tools/" .. name}, html.tag("img", {src = "figures/tools/" .. name, alt = what,
    width = width, height = height, class = "drawing", loading = "lazy"})) .. html.tag("figcaption", nil, html.text(what) .. "."))
end

local pages = {["commands.md"] = "#commands", ["many-records.md"] = "#many-records", ["own-data.md"] = "#your-own-data", ["python.md"] = "#from-python"}

-- A document of the folder as HTML, its headings one level down. `chapters` are those of the book, by their id.
local function document(folder, book, name, chapters)
  local doc = pandoc.read(read(folder .. "/" .. name), "markdown-citations-implicit_figures")
  doc = doc:walk({
    Link = function(link)
      link.target = pages[link.target] or link.target
      return link
    end,
    Header = function(header)
      header.level = header.level + 1
      return header
    end,
    RawBlock = function() return {} end,
    Code = function(code) -- an option is not broken behind its hyphens
      if #code.text <= 24 then code.classes:insert "short" end
      return code
    end,
    CodeBlock = function(code)
      if code.classes:includes "answer" then return pandoc.RawBlock("html", answer(code.text)) end
      return pandoc.RawBlock("html", html.tag("div", {class = "command"}, html.tag("pre", nil, html.tag("code", nil, html.escape(code.text)))))
    end,
    Para = function(para)
      local image = #para.content == 1 and para.content[1]
      return image and image.t == "Image" and pandoc.RawBlock("html", picture(folder, book, image)) or nil
    end,
  })
  local blocks = pandoc.List()
  for _, block in ipairs(doc.blocks) do
    blocks:insert(block)
    local subject = block.t == "Header" and block.level == 3 and pandoc.utils.stringify(block):match("^(%l+): ")
    if subject then
      block.identifier = subject
      local chapter = chapters[tools.chapters[subject] or ""]
      if chapter then
        blocks:insert(pandoc.RawBlock("html", html.tag("p", {class = "other"}, "The method: chapter " .. html.tag("a", {href = chapter.id .. ".html"},
          chapter.number .. " " .. html.text(chapter.title)) .. ".")))
      end
    end
  end
  return pandoc.write(pandoc.Pandoc(blocks), "html5", {wrap_text = "none"}), doc
end

-- A page's `railbook SUBJECT VERB ...` in a sentence as links to the command's example, of those that docs/commands.txt in the folder lists.
function tools.linked(doc, folder)
  local names = {}
  for line in io.lines(folder .. "/commands.txt") do names[line:match("^(%l+ %l+) |") or ""] = true end
  return doc:walk({Code = function(code)
    local subject, verb = code.text:match("^railbook (%l+) (%l+)")
    if not subject or not names[subject .. " " .. verb] then return nil end
    return pandoc.Link({code}, ("tools.html#railbook-%s-%s"):format(subject, verb))
  end})
end

-- The picture that an example of the page Tools draws, folded, for the page of its chapter; `name` is "track-joint". Nil where there is none.
function tools.picture(folder, name)
  for line in io.lines(folder .. "/commands.txt") do
    local subject, verb, command, caption = line:match("^(%l+) (%l+) | [^|]+ | ([^|]+) | (.+)$")
    if subject and subject .. "-" .. verb == name then
      local width, height = read(folder .. "/pictures/" .. name .. ".svg"):match('width="(%d+)" height="(%d+)"')
      return html.tag("details", {class = "more"}, html.tag("summary", nil, "The picture that the command draws")
        .. html.tag("figure", nil, html.tag("a", {href = ("tools.html#railbook-%s"):format(name)}, html.tag("img", {src = ("figures/tools/%s.svg"):format(name),
          alt = caption, width = width, height = height, class = "drawing", loading = "lazy"}))
          .. html.tag("figcaption", nil, html.tag("b", {class = "see"}, html.text(caption) .. ".") .. " Drawn by "
            .. html.tag("code", nil, html.escape(command)) .. ".")))
    end
  end
end

-- Each command with its question, as links to its example.
local function index(doc)
  local rows, last = {}, nil
  for _, block in ipairs(doc.blocks) do
    if block.t == "Header" and block.level == 4 then
      last = block
    elseif block.t == "Para" and last then
      rows[#rows + 1] = {html.tag("a", {href = "#" .. last.identifier}, html.text(pandoc.utils.stringify(block))),
        html.tag("code", nil, html.escape(pandoc.utils.stringify(last)))}
      last = nil
    end
  end
  return html.table("commands", {"question", "command"}, rows)
end

-- A document of the folder, folded from a heading on: its first one, or the one that `from` says.
local function folded(folder, book, name, chapters, summary, from)
  local text = document(folder, book, name, chapters)
  local at = text:find("<h3" .. (from or ""), 1)
  return text:sub(1, at - 1) .. html.tag("details", {class = "more"}, html.tag("summary", nil, summary) .. text:sub(at))
end

-- The page, from the documents of the folder, in the book that is made in the folder `book`.
function tools.page(folder, book, chapters)
  local by_id = {}
  for _, c in ipairs(chapters) do by_id[c.id] = c end
  local commands, doc = document(folder, book, "commands.md", by_id)
  return table.concat({index(doc), folded(folder, book, "own-data.md", by_id, "Files of profiles, cars and sensors", ' id="files%-of%-profiles'), html.tag("h2", {id = "commands"}, "Commands"), commands,
    folded(folder, book, "many-records.md", by_id, "Several processors, and what it costs"),
    folded(folder, book, "python.md", by_id, "Six examples with what they print")}, "\n")
end

return tools
