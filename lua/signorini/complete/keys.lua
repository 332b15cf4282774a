-- The named arguments that may stand at a place in a call, read off the help page: those of its head, and those of
-- tables in it, which the page shows as key = { a = …, b }. Where all entries of such a table are tables themselves,
-- their names are examples of the user's own, such as those of contacts; lists of tables are shown as { { a = … }, … }.

local core = require "signorini.core"
local keys_in = require "signorini.help.keys"

-- Functions that take what an argument of another one takes.
local same = { ["sg.robust"] = { "model:run", 2 }, ["sg.plain"] = { "model:run", 2 },
               ["model:iterate"] = { "model:solve_step", 1 } }

local function is_table(form) return form:find "^{ " ~= nil end

--- The tables behind a key anywhere in a text, as "key = { … }" or in the list of a page as "key: { … }".
local function tables_of(text, key, found)
  for _, pattern in ipairs { "%f[%w_]" .. key .. "%s*=%s*(%b{})", "\n" .. key .. ": +(%b{})" } do
    for form in text:gmatch(pattern) do
      if is_table(form) then found[#found + 1] = form end
    end
  end
end

--- The tables without a name in a list, or in lines of a page.
local function entries_of(text, found)
  local inside = is_table(text) and text:sub(2, -2) or text
  for before, form in ("\n" .. inside):gmatch "([{,\n]) *(%b{})" do
    if before and is_table(form) then found[#found + 1] = form end
  end
end

--- Whether all entries are tables with names.
local function names_are_examples(form)
  local flat = form:sub(2, -2):gsub("= *%b{}", "=")
  for entry in (flat .. ","):gmatch "([^,]*)," do
    if not entry:find "^%s*[%a_][%w_]*%s*=%s*$" then return false end
  end
  return form:find "= *{ " ~= nil
end

--- What stands for a key in some texts, or, for false, for the entries of a list.
local function step(texts, key)
  local found = {}
  for _, text in ipairs(texts) do
    if not key then
      entries_of(text, found)
    elseif is_table(text) and names_are_examples(text) then
      for form in text:sub(2, -2):gmatch "= *(%b{})" do
        if is_table(form) then found[#found + 1] = form end
      end
    else
      tables_of(text, key, found)
    end
  end
  return found
end

--- The arguments in a page's head, each as text.
local function arguments_of(page)
  local call = page:match "^[%w_.:]+(%b{})"
  if call then return { call } end
  local list, depth, from = {}, 0, 2
  local inside = page:match "^[%w_.:]+(%b())" or "()"
  for at = 2, #inside do
    local c = inside:sub(at, at)
    if c == "{" or c == "(" then depth = depth + 1 end
    if (c == "," or c == ")") and depth == 0 then
      list[#list + 1] = inside:sub(from, at - 1):match "^%s*(.-)%s*$"
      from = at + 1
    end
    if c == "}" or c == ")" then depth = depth - 1 end
  end
  return list
end

--- The names in order that a page's function knows for the table at a place: in its argument of this number, behind
--- these keys.
return function(name, argument, keys)
  if same[name] then name, argument = same[name][1], same[name][2] end
  local page = core.docs[name]
  local form = page and arguments_of(page)[argument]
  if not form then return {} end
  if #keys == 0 and is_table(form) then return keys_in.of_page(page) end
  local texts = is_table(form) and { form, page } or step({ page }, form:match "^[%w_]+$" or "")
  for _, key in ipairs(keys) do texts = step(texts, key) end
  local found = {}
  for _, text in ipairs(texts) do keys_in.add(found, text) end
  return found
end
