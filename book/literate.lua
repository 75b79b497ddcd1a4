-- Pandoc reader of literate C++: `pandoc -f literate.lua main.cpp section.cpp ...`.
-- A comment that opens with `/***` at the beginning of a line is prose in Markdown; everything else is code.
-- A prose line `{{code: contact/hertz.hpp hertz_from_approach}}` shows that function or type of lib/, `{{code: method.cpp search}}`
-- or `{{code: method/loop.cpp search}}` one of the chapter's own; behind `{{fold}}` alone, the code of the file is folded at the end. Functions that compute
-- are shown, where the paragraph before them names one of them in backquotes; the others, and what registers, formats and checks
-- (a function that takes a report::Item, a report::Section, main), are folded at the end.
-- A block ::: {.fold summary="..."} of prose, with what stands in it, is folded where it stands; so are the commands below "Try next".
-- The first file is the page; a prose line `{{include: section.cpp}}` continues with another one. Every .cpp
-- named on the command line must be included exactly once; a header may be.

package.path = PANDOC_SCRIPT_FILE:match("^(.*)/[^/]*$") .. "/?.lua;" .. package.path
local highlight = require "highlight"

local longest_open_block = 60 -- longer code is folded

local function fail(message)
  io.stderr:write("book: ", message, "\n")
  os.exit(1)
end

local function line_of(text, position)
  local _, newlines = text:sub(1, position - 1):gsub("\n", "")
  return newlines + 1
end

-- Cuts a source file into pieces {prose = bool, text = ..., line = first line}.
local function cut(source)
  local text, name = source.text:gsub("\r\n", "\n"), source.name
  local pieces, at, start = {}, 1, 1
  local function add(prose, first, last)
    pieces[#pieces + 1] = {prose = prose, text = text:sub(first, last), line = line_of(text, first)}
  end
  while at <= #text do
    local at_line_start = at == 1 or text:sub(at - 1, at - 1) == "\n"
    if at_line_start and text:find("^/%*%*%*[^*/]", at) then
      local close, stop = text:find("*/", at + 4, true)
      if not close then fail(name .. ":" .. line_of(text, at) .. ": prose opened with /*** is never closed") end
      add(false, start, at - 1)
      add(true, at + 4, close - 1)
      at, start = stop + 1, stop + 1
    else
      at = highlight.skip_token(text, at)
    end
  end
  add(false, start, #text)
  return pieces
end

-- Drops blank lines at both ends; returns the rest and how many lines went at the top.
local function trim_lines(text)
  local dropped = 0
  while text:find("^[ \t]*\n") do
    text = text:gsub("^[ \t]*\n", "", 1)
    dropped = dropped + 1
  end
  return (text:gsub("%s+$", "")), dropped
end

local function count_lines(text) return select(2, text:gsub("\n", "")) + 1 end

-- Splits leading #include, using and namespace lines (with the comments between them) off a piece of code.
local function split_headers(text)
  local stop, at, found = 0, 1, false
  while at <= #text do
    local finish = text:find("\n", at, true) or #text
    local line = text:sub(at, finish)
    if line:find("^#include") or line:find("^#pragma") or line:find("^#define") or line:find("^using ")
        or line:find("^namespace%s+[%w_]+%s*=") or line:find("^namespace[%s%w_:]*{%s*$") then
      stop, found = finish, true
    elseif not (line:find("^%s*$") or line:find("^%s*//")) then
      break
    end
    at = finish + 1
  end
  local headers, body = text:sub(1, stop), text:sub(stop + 1)
  local few = count_lines(headers) < 4 and not headers:find("#include", 1, true) and body:find("%S")
  if not found or few then return nil, text end
  return headers, body
end

local function fenced(code, file, line, role)
  local longest = 2
  for run in code:gmatch("`+") do longest = math.max(longest, #run) end
  local fence = ("`"):rep(longest + 1)
  return ('%s {.cpp file="%s" line="%d" role="%s"}\n%s\n%s\n'):format(fence, file, line, role, code, fence)
end

-- Whether a piece of code only registers, formats and checks.
local function is_glue(code)
  for line in code:gmatch("[^\n]+") do
    if not line:find("^[%s/}]") and (line:find("report::Item&", 1, true) or line:find("report::Section ", 1, true)
        or line:find("report::Row&", 1, true) or line:find("^int main%(")) then return true end
  end
  -- a signature that goes on in the next line
  return code:find("^[%w][^\n;{]*%([^\n]*\n[^\n]*report::Item&") ~= nil
end

-- Cuts code at blank lines between top-level definitions into runs that are shown and runs that are folded:
-- {{code, lines before it, folded}, ...}.
local function runs(code)
  local out, chunk, start, n = {}, {}, 1, 0
  local function close(last)
    local text = table.concat(chunk, "\n")
    if text:find("%S") then
      local glue = is_glue(text) or not text:find("[%w]") or text:find("^}") ~= nil
      local previous = out[#out]
      if previous and previous.glue == glue then
        previous.text = previous.text .. "\n\n" .. text
      else
        out[#out + 1] = {text = text, before = start - 1, glue = glue}
      end
    end
    chunk, start = {}, last + 1
  end
  for line in (code .. "\n"):gmatch("(.-)\n") do
    n = n + 1
    local top = #chunk == 0 or chunk[#chunk]:find("^}") or chunk[#chunk]:find("^[^%s].*;%s*$") -- a definition ended above
    if line == "" and top then close(n) else chunk[#chunk + 1] = line end
  end
  close(n)
  return out
end

local function split_lines(text)
  local lines = {}
  for line in (text:gsub("\n$", "") .. "\n"):gmatch("(.-)\n") do lines[#lines + 1] = line end
  return lines
end

-- The text of a file in a folder of the chapter, or else of the library, and its path for a reader.
local function read_file(folder, path, from)
  local root = os.getenv("RAILBOOK_LIB") or "lib"
  local file, name = io.open(folder .. path), path
  if not file then file, name = io.open(root .. "/" .. path), "lib/" .. path end
  if not file then fail(from .. ": no file " .. path .. " of the chapter and no file " .. name) end
  local text = file:read("a")
  file:close()
  return text, name
end

-- The text of a function or type of a file with the comment above it, and its first line. `path` names the file for a reader.
local function code_of(text, path, name, from)
  local lines = split_lines(text)
  for i, line in ipairs(lines) do
    local defines = not line:find("^[%s/#]") and line:find("%f[%w_]" .. name .. "%f[^%w_]")
    local declared = line:find("^struct%s+" .. name) or line:find("^class%s+" .. name)
      or line:find("[%s&*:]" .. name .. "%(") or line:find("^" .. name .. "%(")
    if defines and declared then
      local first, last = i, i
      while first > 1 and (lines[first - 1]:find("^//") or lines[first - 1]:find("^template")) do first = first - 1 end
      while last <= #lines and not lines[last]:find("^}") and not (lines[last]:find(";%s*$") and not lines[last]:find("^%s")) do
        last = last + 1
      end
      local body = table.concat(lines, "\n", first, math.min(last, #lines))
      if body:find("{", 1, true) then return body, first end
    end
  end
  fail(from .. ": " .. path .. " defines no " .. name)
end

-- The functions and types that code at the beginning of a line defines.
local function definitions(code)
  local names = {}
  for line in code:gmatch("[^\n]+") do
    local name = line:match("^struct%s+([%w_]+)") or line:match("^class%s+([%w_]+)")
      or line:match("^enum class%s+([%w_]+)")
    if not name and not line:find(";%s*$") and not line:find("^template") then
      name = line:match("^[%a_].-[%s&*:]([%w_]+)%(")
    end
    if name and names[#names] ~= name then names[#names + 1] = name end
  end
  return names
end

local unnamed = {} -- code of the library that the text before it does not speak of

-- Whether text has the name in backquotes: `hertz`, `hertz(k)` or `contact::hertz`.
local function speaks_of(text, name)
  for code in text:gmatch("`([^`]+)`") do
    if code:find("%f[%w_]" .. name .. "%f[^%w_]") then return true end
  end
  return false
end

local Weaver = {}
Weaver.__index = Weaver

-- Keeps the paragraph that the reader has before the next block of code: formulas, figures and headings alone are none.
function Weaver:read(text)
  for paragraph in (text .. "\n\n"):gmatch("(.-)\n%s*\n") do
    local alone = not paragraph:gsub("{{[^{}]*}}", ""):gsub("%$%$.-%$%$", ""):find("%w") or paragraph:find("^%s*#+ [^\n]*$")
    local goes_on = self.paragraph and paragraph:find("^%s*%l") -- behind a formula in the middle of a sentence
    if not alone then self.paragraph = goes_on and self.paragraph .. "\n" .. paragraph or paragraph end
  end
end

function Weaver:names(names)
  for _, name in ipairs(names) do
    if speaks_of(self.paragraph or "", name) then return true end
  end
  return false
end

-- `aside`: it is folded at the end, since the prose says so, or no prose comes after it and it would stand below a heading
-- that is not its own.
function Weaver:code(piece, file, aside)
  local code, dropped = trim_lines(piece.text)
  if code == "" then return end
  local line = piece.line + dropped
  local headers, body = split_headers(code)
  if headers then
    self:emit(fenced(trim_lines(headers), file, line, "headers"))
    self.blocks = self.blocks + 1
    body, dropped = trim_lines(body)
    line = line + count_lines(headers) - 1 + dropped
    if body == "" then return end
    code = body
  end
  for _, run in ipairs(runs(code)) do
    local names = definitions(run.text)
    local role = (run.glue or aside) and "glue" or #names > 0 and not self:names(names) and "helper" or "code"
    self:emit(fenced(run.text, file, line + run.before, role))
    self.blocks = self.blocks + 1
  end
end

function Weaver:emit(text) self.out[#self.out + 1] = text .. "\n" end

-- Whether the code behind it is to be folded.
function Weaver:prose(piece, file)
  local line, folded = piece.line, false
  local body = piece.text:gsub("^[ \t]+", "")
  local paragraph = {}
  local function read()
    self:read(table.concat(paragraph, "\n"))
    paragraph = {}
  end
  for text in (body .. "\n"):gmatch("(.-)\n") do
    local included = text:match("^%s*{{%s*include:%s*(%S+)%s*}}%s*$")
    local path, name = text:match("^%s*{{%s*code:%s*(%S+)%s+([%w_]+)%s*}}%s*$")
    if included then
      read()
      self:emit("")
      self:file(included, file .. ":" .. line)
    elseif text:find("^%s*{{%s*fold%s*}}%s*$") then
      folded = true
    elseif path then
      local from, own = file .. ":" .. line, self.sources[path]
      local text_of, code_path
      if own then
        text_of, code_path = own.text, path
      else
        text_of, code_path = read_file(self.folder, path, from)
      end
      local code, first = code_of(text_of, code_path, name, from)
      read()
      if not self:names({name}) then
        unnamed[#unnamed + 1] = ("%s:%d: the paragraph before {{code: %s %s}} does not name `%s`"):format(file, line, path, name, name)
      end
      self:emit("")
      self:emit(fenced(code, code_path, first, "code"))
      self.blocks = self.blocks + 1
    else
      self.out[#self.out + 1] = text
      paragraph[#paragraph + 1] = text
    end
    line = line + 1
  end
  read()
  self:emit("")
  return folded
end

function Weaver:file(name, from)
  local source = self.sources[name]
  if not source then fail(from .. ": include of '" .. name .. "', which is not a file of this chapter") end
  if self.seen[name] then
    fail(from .. ": '" .. name .. "' is included twice (first at " .. self.seen[name] .. ")")
  end
  self.seen[name] = from
  local pieces, last_prose, folded = cut(source), 0, false
  for i, piece in ipairs(pieces) do
    if piece.prose then last_prose = i end
  end
  for i, piece in ipairs(pieces) do
    if piece.prose then
      folded = self:prose(piece, name)
    else
      self:code(piece, name, folded or name == self.main and i > last_prose)
    end
  end
end

-- What a folded block says: what it defines, if that is several things; else its first comment or line.
local function summary_of(code)
  local names = definitions(code)
  if #names > 1 then return {pandoc.Code(table.concat(names, ", "))} end
  local comment = code:match("^%s*///?%s*([^\n]+)") or code:match("\n%s*///?%s*([^\n]+)")
  local first = code:match("^%s*([^\n]+)")
  if comment then return {pandoc.Str((comment:gsub("%s+$", "")))} end
  return {pandoc.Code(first)}
end

local function details(class, summary, content, more)
  local out = pandoc.List({pandoc.RawBlock("html", ('<details class="%s"%s><summary>'):format(class, more or ""))})
  out:insert(pandoc.Plain(summary))
  out:insert(pandoc.RawBlock("html", "</summary>"))
  out:extend(content)
  out:insert(pandoc.RawBlock("html", "</details>"))
  return out
end

local function where(text) return pandoc.Span({pandoc.Str(text)}, {class = "where"}) end

-- Code that computes stands where the text speaks of it, folded when it is long. The rest is left for the end of the page, by file.
local function present(block, rest)
  local file, line, role = block.attributes.file, block.attributes.line, block.attributes.role
  if not role then return nil end
  local lines = count_lines(block.text)
  local place = ("%s:%s"):format(file, line)
  if role ~= "code" then
    local plain = pandoc.RawBlock("html", highlight.plain(block.text))
    if not rest[file] then
      rest[file] = {lines = 0, blocks = pandoc.List()}
      rest[#rest + 1] = file
    end
    rest[file].lines = rest[file].lines + lines
    rest[file].blocks:extend({pandoc.Plain({where(place)}), plain})
    return {}
  end
  local shown = pandoc.RawBlock("html", highlight.cpp(block.text))
  if lines <= longest_open_block then return details("code shown", {where(place)}, {shown}, " open") end
  return details("code", {pandoc.Span(summary_of(block.text)), pandoc.Space(), where(("%s, %d lines"):format(place, lines))}, {shown})
end

-- What the text does not name, and what includes, registers, formats and checks: a fold for each file.
local function rest_of(rest)
  local out = pandoc.List()
  if #rest == 0 then return out end
  out:insert(pandoc.Header(2, {pandoc.Str("The rest of the program")}, {id = "the-rest-of-the-program"}))
  local inner, lines = pandoc.List(), 0
  for _, file in ipairs(rest) do
    inner:extend(details("code", {pandoc.Code(file), pandoc.Space(), where(rest[file].lines .. " lines")}, rest[file].blocks))
    lines = lines + rest[file].lines
  end
  local what = ("What the text does not name, and what registers, draws, formats and checks: %d lines of %d %s."):format(lines, #rest, #rest == 1 and "file" or "files")
  out:extend(details("code rest", {pandoc.Str(what)}, inner))
  return out
end

function Reader(inputs)
  local weaver = setmetatable({sources = {}, seen = {}, out = {}, blocks = 0}, Weaver)
  local main
  for _, source in ipairs(inputs) do
    local name = source.name:match("[^/]+$")
    main = main or name
    weaver.sources[name] = {name = name, text = source.text}
  end
  weaver.main = main
  weaver.folder = inputs[1].name:match("^.*/") or ""
  weaver:file(main, "the command line")
  for _, source in ipairs(inputs) do
    local name = source.name:match("[^/]+$")
    if name:find("%.cpp$") and not weaver.seen[name] then
      fail(source.name .. " is not included in the page: add a line {{include: " .. name .. "}} to the prose")
    end
  end

  if #unnamed > 0 then fail(table.concat(unnamed, "\nbook: ")) end

  local dialect = "markdown-citations-example_lists-blank_before_header+autolink_bare_uris"
  local doc = pandoc.read(table.concat(weaver.out, "\n"), dialect)
  local found, rest, section = 0, {}, ""
  local function presented(list)
    local out = pandoc.List()
    for _, block in ipairs(list) do
      if block.t == "Header" then section = pandoc.utils.stringify(block) end
      local shown = block.t == "CodeBlock" and present(block, rest)
      if shown then
        found = found + 1
        out:extend(shown)
      elseif block.t == "Div" and block.classes:includes("fold") then
        if not block.attributes.summary then fail(main .. ": ::: {.fold} without a summary") end
        out:extend(details("more", {pandoc.Str(block.attributes.summary)}, presented(block.content)))
      elseif section == "Try next" and block.t == "CodeBlock" and block.classes:includes("console") then
        out:extend(details("more", {pandoc.Str("The command and its answer")}, {block}))
      else
        out:insert(block)
      end
    end
    return out
  end
  local blocks = presented(doc.blocks)
  if found ~= weaver.blocks then
    fail(main .. ": some code was swallowed by prose: a ``` block, <div> or $$ of the prose is not closed")
  end
  blocks:extend(rest_of(rest))
  return pandoc.Pandoc(blocks, doc.meta)
end
