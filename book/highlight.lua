-- C++ as HTML: comments, strings, keywords, types and numbers in elements of their own; and the tokens that this needs.

local html = require "html"

local highlight = {}

-- Position just after the C++ token at `at`: enough of the language to know strings and comments from code.
function highlight.skip_token(text, at)
  local rest = function(pattern) return select(2, text:find("^" .. pattern, at)) end
  local prefix, delimiter = text:match('^(u?8?[UL]?R)"([^()\\%s]*)%(', at)
  if prefix then
    local _, stop = text:find(")" .. delimiter .. '"', at, true)
    return (stop or #text) + 1
  end
  local comment = text:find("^/%*", at)
  if comment then
    local _, stop = text:find("*/", at + 2, true)
    return (stop or #text) + 1
  end
  local stop = rest("//[^\n]*") or rest("[%a_][%w_]*") or rest("%.?%d[%w_.']*")
  if stop then return stop + 1 end
  local quote = text:match("^[\"']", at)
  if not quote then return at + 1 end
  local i = at + 1
  while i <= #text do
    local c = text:sub(i, i)
    if c == "\\" then
      i = i + 1
    elseif c == quote or c == "\n" then
      return i + 1
    end
    i = i + 1
  end
  return i
end

-- Short names take a quarter of a page less than spans with classes.
local element = {co = "i", kw = "b", cf = "b", dt = "var", st = "samp", dv = "kbd", pp = "u"}

local classes = {}
local function words(class, list)
  for word in list:gmatch("%S+") do classes[word] = class end
end
words("cf", "if else for while do switch case default break continue return throw try catch goto co_return co_await co_yield")
words("kw", [[alignas auto class concept const consteval constexpr constinit const_cast decltype delete dynamic_cast enum explicit
  extern false final friend inline mutable namespace new noexcept nullptr operator override private protected public
  reinterpret_cast requires sizeof static static_assert static_cast struct template this true typedef typeid typename union using
  virtual volatile]])
words("dt", "bool char double float int long short signed unsigned void size_t wchar_t")

local function class_of(token)
  if token:find("^//") or token:find("^/%*") then return "co" end
  if token:find('"') or token:find("^'") then return "st" end
  if token:find("^%.?%d") then return "dv" end
  return classes[token]
end

local function escape(text) return (html.escape(text):gsub("'", "&#39;")) end

-- The code as <pre><code>, without colours: what a reader looks up, not reads.
function highlight.plain(code) return '<pre class="cpp"><code>' .. escape(code) .. "</code></pre>" end

-- The same with colours.
function highlight.cpp(code)
  local out, plain, at = {}, 1, 1
  while at <= #code do
    local stop = highlight.skip_token(code, at)
    local token, class = code:sub(at, stop - 1), nil
    if token == "#" and (at == 1 or code:sub(at - 1, at - 1) == "\n") then
      stop = (code:find("\n", at, true) or #code + 1)
      token, class = code:sub(at, stop - 1), "pp"
    else
      class = class_of(token)
    end
    if class then
      if plain < at then out[#out + 1] = escape(code:sub(plain, at - 1)) end
      out[#out + 1] = ("<%s>%s</%s>"):format(element[class], escape(token), element[class])
      plain = stop
    end
    at = stop
  end
  out[#out + 1] = escape(code:sub(plain))
  return '<pre class="cpp"><code>' .. table.concat(out) .. "</code></pre>"
end

return highlight
