-- The tables that the chapters leave: CSV with a line of heads; lines that begin with # say how far the numbers hold.

local csv = {}

local function cells(line)
  local out, at = {}, 1
  while at <= #line + 1 do
    local quoted, after = line:match('^"([^"]*)"(),?', at)
    if quoted then
      out[#out + 1], at = quoted, after + 1
    else
      local cell = line:match("^[^,]*", at)
      out[#out + 1], at = cell, at + #cell + 1
    end
  end
  return out
end

-- The rows of a file, each by the names of its columns, with the number of its block, from 0 on; blocks are parted by blank lines. Nil
-- and a text where it cannot be read.
function csv.read(path)
  local file, rows, heads, block, blank = io.open(path), {}, nil, 0, false
  if not file then return nil, path .. " does not exist" end
  for line in file:lines() do
    if line == "" then
      blank = #rows > 0
    elseif line:sub(1, 1) ~= "#" then
      if blank then block, blank = block + 1, false end
      local values = cells(line)
      if not heads then
        heads = values
      else
        local row = {block = tostring(block)}
        for i, head in ipairs(heads) do row[head] = values[i] end
        rows[#rows + 1] = row
      end
    end
  end
  file:close()
  return rows, heads
end

return csv
