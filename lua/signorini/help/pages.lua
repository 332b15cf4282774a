-- Help pages in a line each: how to call it, and what it does.

local core = require "signorini.core"
local cut = require "signorini.cut"

local pages = {}

local width, widest_head = 118, 46 -- characters of a line, and of what stands on its left

local closing = { ["("] = ")", ["{"] = " }" }

--- The brackets that are open at the end of a text.
local function open_brackets(text)
  local open = {}
  for bracket in text:gmatch "[(){}]" do
    if closing[bracket] then open[#open + 1] = bracket else open[#open] = nil end
  end
  return open
end

--- A text that is cut off inside brackets, with an end: "sg.body{ patch, … }".
local function closed(text)
  local open, ends = open_brackets(text), ""
  for _, bracket in ipairs(open) do ends = closing[bracket] .. ends end
  if #open == 0 then return text end
  return text:gsub("[%s,]*$", ""):gsub(", …$", "") .. ", …" .. ends
end

--- How to call what a page is about, in a few characters.
function pages.head(name)
  local line = core.docs[name]:match "^[^\n]*"
  local whole = closed(line)
  if utf8.len(whole) <= widest_head then return whole end
  local short
  for at in line:gmatch "(),%s" do
    local candidate = line:sub(1, at)
    if #open_brackets(candidate) > 0 and utf8.len(closed(candidate)) <= widest_head then short = closed(candidate) end
  end
  local call, bracket = line:match "^([%w_.:]+)%s*([({]?)"
  return short or call .. (bracket == "(" and "(…)" or bracket == "{" and "{ … }" or "")
end

--- The first sentence of a page behind its head.
function pages.summary(name)
  local lines, head = {}, ""
  for line in (core.docs[name] .. "\n"):gmatch "([^\n]*)\n" do
    if head == "" or #open_brackets(head) > 0 then head = head .. line else lines[#lines + 1] = line end
  end
  local text = table.concat(lines, " ")
  return text:match "^(.-)%.%f[%s\0]" or text
end

--- Lines of two columns, { left, right } each.
function pages.lines(entries)
  local most, lines = 0, {}
  for _, entry in ipairs(entries) do most = math.max(most, utf8.len(entry[1])) end
  for i, entry in ipairs(entries) do
    local blanks = (" "):rep(most - utf8.len(entry[1]))
    lines[i] = ("  %s%s  %s"):format(entry[1], blanks, cut(entry[2], width - most - 4))
  end
  return table.concat(lines, "\n")
end

--- A list of pages by their names.
function pages.list(names)
  local entries = {}
  for i, name in ipairs(names) do entries[i] = { pages.head(name), pages.summary(name) } end
  return pages.lines(entries)
end

return pages
