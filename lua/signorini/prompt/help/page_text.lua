-- Text of a help page: how to call the function, its description, list of arguments, and examples.

local describe = require "signorini.call.describe"
local lists = require "signorini.call.lists"
local pages = require "signorini.pages"
local wrapped = require("signorini.call.text").wrapped

local width = 118 -- characters of a line
local widest_key = 14

--- Adds the words of a text to lines; the first line begins with `first`, further ones with `indent`.
local function add_wrapped(lines, first, text, indent)
  local words = {}
  for word in text:gmatch "%S+" do words[#words + 1] = word end
  for _, line in ipairs(wrapped(words, width, first, indent)) do lines[#lines + 1] = line end
end

--- Paragraphs: lines that begin with a blank are unchanged, others are filled; a source starts a new line.
local function add_text(lines, text)
  local paragraph = {}
  local function flush()
    if #paragraph > 0 then add_wrapped(lines, "", table.concat(paragraph, " "), "") end
    paragraph = {}
  end
  for line in (text .. "\n"):gmatch "([^\n]*)\n" do
    if line:find "^Source" then flush() end
    if line:find "^%s" or line == "" then
      flush()
      lines[#lines + 1] = line
    else
      paragraph[#paragraph + 1] = line
    end
  end
  flush()
end

--- The rows of the table inside a type (list, map or alternative), or nil.
local function rows_inside(type)
  if type.kind == "named" then return type.rows end
  if type.kind == "list" or type.kind == "map" or type.kind == "switch" then return rows_inside(type.of) end
  return type.kind == "either" and lists.map(lists.filter(type, rows_inside), rows_inside)[1] or nil
end

local function terms(row)
  local parts = { describe.one(row[2]), row.unit }
  if row.default ~= nil then
    parts[#parts + 1] = "default " .. describe.literal(row.default)
  elseif not pages.is_needed(row) then
    parts[#parts + 1] = row.otherwise and "by default " .. row.otherwise or "optional"
  end
  return table.concat(parts, "; ")
end

--- The text of a row: its meaning, then in parentheses type, unit and default.
local function row_text(row)
  local text = row[3] or ""
  return text == "" and terms(row) or ("%s (%s)"):format(text, terms(row))
end

local function add_rows(lines, rows, indent)
  local most = 0
  for _, row in ipairs(rows) do
    if type(row) == "table" then most = math.max(most, math.min(#row[1] + 2, widest_key)) end
  end
  for _, row in ipairs(rows) do
    if type(row) == "string" then
      lines[#lines + 1] = indent .. row
    elseif not row.hidden then
      local label = indent .. row[1] .. ":"
      label = label .. (" "):rep(math.max(1, #indent + most - #label))
      add_wrapped(lines, label, row_text(row), indent .. (" "):rep(most))
      local inside = rows_inside(row[2])
      if type(inside) == "table" then
        add_rows(lines, inside, indent .. "  ")
      elseif inside then
        lines[#lines + 1] = ('%s  see help "%s"'):format(indent, inside)
      end
    end
  end
end

--- Where to read about the object that a function returns, if it does.
local function result_text(page)
  local of = page.returns and pages.results(page)[1]
  local object = of and of.kind == "list" and of.of or of
  if not object or object.kind ~= "object" then return nil end
  local name = pages.of_objects(object.name)
  return not page.name:find("^" .. name .. ":") and ('Result: see help "%s".'):format(name) or nil
end

local page_text = { row = row_text }

--- The code of a page's examples, a list.
function page_text.examples(page)
  return type(page.example) == "table" and page.example or { page.example }
end

--- The text of one row.
function page_text.row(row)
  local lines = {}
  add_rows(lines, { row }, "")
  return table.concat(lines, "\n")
end

--- The text of a page, optionally without its examples.
function page_text.whole(page, without_examples)
  local lines = {}
  local head = pages.head(page)
  add_wrapped(lines, "", head, (" "):rep(math.min(#head:match "^[^{(]*" + 2, 30)))
  add_text(lines, page.text)
  if type(page.named) == "string" then
    lines[#lines + 1] = ('Its arguments are those of help "%s".'):format(page.named)
  else
    add_rows(lines, pages.shown(page), "")
  end
  if page.more then add_text(lines, page.more) end
  lines[#lines + 1] = result_text(page)
  for _, code in ipairs(without_examples and {} or page_text.examples(page)) do
    lines[#lines + 1] = "Example: " .. code:gsub("\n", "\n         ")
  end
  return table.concat(lines, "\n")
end

return page_text
