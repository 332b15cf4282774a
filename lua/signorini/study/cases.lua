-- The cases of a study: plain data by the names of parameters, each with a name for messages and files.

local check = require "signorini.call.check"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local values = require "signorini.study.values"

local cases = {}

local where = "sg.study"

--- All cases of a list that may contain lists, such as grids, with the parameters in the order of their occurrence.
local function flatten(list, into, names)
  for _, name in ipairs((getmetatable(list) or {}).parameters or {}) do names[#names + 1] = name end
  for i, entry in ipairs(list) do
    if type(entry) ~= "table" then
      check.reject(where, ("cases[%d]"):format(i), "a table of parameters, or a list of such tables", entry)
    end
    if #entry > 0 then flatten(entry, into, names) else into[#into + 1] = entry end
  end
  return into, names
end

--- The names of all parameters: first those of grids in their order, then the others, sorted.
local function parameter_names(list, ordered)
  local others = {}
  for i, case in ipairs(list) do
    for name in pairs(case) do
      if type(name) ~= "string" then
        core.fail(("%s: cases[%d] has a value without a name. Hint: write parameter = value"):format(where, i))
      end
      if lists.holds(values.accounts, name) then
        core.fail(("%s: cases[%d]: a parameter cannot be called '%s', a column of every case"):format(where, i, name))
      end
      others[name] = true
    end
  end
  return lists.unique(lists.joined(ordered, lists.sorted_names(others)))
end

--- Reads the argument `cases`: a list of { case, text, id }, and the names of the parameters. `text` is the case in
--- messages, `id` its file without ending. Cases with equal texts are errors.
function cases.read(list)
  local flat, ordered = flatten(list, {}, {})
  local names, result, seen = parameter_names(flat, ordered), {}, {}
  for i, case in ipairs(flat) do
    core.write_json(case, ("%s: cases[%d]"):format(where, i)) -- raises an error unless it is plain data
    local own = lists.filter(names, function(name) return case[name] ~= nil end)
    local text = table.concat(lists.map(own, function(name)
      return ("%s=%s"):format(name, values.text(case[name], true))
    end), " ")
    if seen[text] then
      core.fail(("%s: cases[%d] and cases[%d] are both called '%s'. Hint: leave one out, or give their values "
        .. "different names"):format(where, seen[text], i, text))
    end
    seen[text] = i
    -- The text is for readers; the digits distinguish texts that differ in characters not allowed in file names.
    local stem = text:gsub("[^%w.=+()-]+", "_"):sub(1, 120)
    result[i] = { case = case, text = text, id = ("%s-%s"):format(stem, core.hash(text):sub(1, 8)) }
  end
  return result, names
end

return cases
