-- Verbs that read a study. Those that choose, group or add return a study of their own, so that they can be chained; it
-- has results only and cannot be executed.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local counted = require "signorini.counted"
local csv = require "signorini.csv"
local cut = require "signorini.cut"
local filter = require "signorini.study.filter"
local in_name_of = require "signorini.in_name_of"
local format_table = require "signorini.table"
local median = require "signorini.median"
local outcomes = require "signorini.study.outcomes"
local pictures = require "signorini.study.pictures"
local values = require "signorini.study.values"

local widest = 60 -- characters of a cell that is printed

local verbs = { chart = pictures.chart, heatmap = pictures.heatmap }

--- A study of these rows; `more` replaces what else is not as in the old one.
local function part_of(study, rows, more)
  local part = { name = study.name, parameters = study.parameters, figures = study.figures, units = study.units,
                 rows = rows, whole = study.whole or study }
  for key, value in pairs(more or {}) do part[key] = value end
  return setmetatable(part, getmetatable(study))
end

-- ── Choosing ─────────────────────────────────────────────────────────────────────────────────────────────────────────

core.docs["study:where"] = [[
study:where{ order = "N2", mesh = {"m1", "m2"}, failed = false } or study:where(function(row) return row.wall < 1 end)
The part of a study with these values, as a study that has results only: for a list any of its values. A value that no
case has is an error; a function may ask for any.
Example: study:where{ order = "N2", mesh = {1, 2} }]]
function verbs:where(wanted) return part_of(self, filter.rows("study:where", self, wanted)) end

core.docs["study:row"] = [[
study:row{ order = "N2", mesh = "m1" }
The one row with these values, a table of parameters and figures by name. None or several are an error.
Example: study:row{ order = "N2", mesh = 1 }.force]]
function verbs:row(wanted)
  local rows = filter.rows("study:row", self, wanted)
  if #rows ~= 1 then
    core.fail(("study:row: %s rows have %s, not one: %s"):format(#rows == 0 and "no" or #rows, filter.text(wanted),
      #rows == 0 and "print the study to see what it holds" or "name more parameters"))
  end
  return rows[1]
end

core.docs["study:by"] = [[
study:by "order"
Goes over the parts of a study that share a value.
Example: for order, part in study:by "order" do print(order, #part) end]]
function verbs:by(name)
  name = values.column("study:by", "its argument", name, self)
  local groups = {}
  for _, row in ipairs(self.rows) do
    local found
    for _, group in ipairs(groups) do
      if values.same(group.value, row[name]) then found = group end
    end
    if not found then
      found = { value = row[name], rows = {} }
      groups[#groups + 1] = found
    end
    found.rows[#found.rows + 1] = row
  end
  local i = 0
  return function()
    i = i + 1
    if groups[i] then return groups[i].value, part_of(self, groups[i].rows) end
  end
end

-- ── Reckoning ────────────────────────────────────────────────────────────────────────────────────────────────────────

core.docs["study:column"] = [[
study:column "dPx"
A parameter or figure as a list over the rows, nan where it is missing.
Example: study:column "force"]]
function verbs:column(name)
  name = values.column("study:column", "its argument", name, self)
  local list = {}
  for i, row in ipairs(self.rows) do
    list[i] = row[name]
    if list[i] == nil then list[i] = 0 / 0 end
  end
  return list
end

core.docs["study:with"] = [[
study:with(name, function(row) … return value end, unit)
The study with one figure more, made from each row; nil where it is not known.
Example: study:with("deviation", function(row) return math.abs(row.force / 0.08 - 1) end)]]
function verbs:with(name, make, unit)
  local where = "study:with"
  name = arguments.string(where, "name", name)
  if make == nil then arguments.reject(where, "make", "a function of a row", make) end
  arguments.callback(where, "make", make)
  for _, parameter in ipairs(self.parameters) do
    if parameter == name then core.fail(("%s: '%s' is a parameter: choose another name"):format(where, name)) end
  end
  local rows, figures, units = {}, { name }, { [name] = unit and arguments.string(where, "unit", unit) }
  for i, row in ipairs(self.rows) do
    local copy = {}
    for key, value in pairs(row) do copy[key] = value end
    copy[name] = make(row)
    if type(copy[name]) == "number" and copy[name] ~= copy[name] then
      core.fail(("%s: %s is nan in row %d: return nil for what is not known"):format(where, name, i))
    end
    rows[i] = copy
  end
  for _, known in ipairs(self.figures) do
    if known ~= name then table.insert(figures, #figures, known) end
  end
  for key, value in pairs(self.units) do
    if key ~= name then units[key] = value end
  end
  return part_of(self, rows, { figures = figures, units = units })
end

--- One row of several that differ in one parameter only: numbers by their median, all else as in the first row that
--- has it.
local function merge(rows, name)
  local merged, numbers = {}, {}
  for _, row in ipairs(rows) do
    for key, value in pairs(row) do
      if merged[key] == nil then merged[key] = value end
      if type(value) == "number" then
        numbers[key] = numbers[key] or {}
        table.insert(numbers[key], value)
      end
    end
  end
  for key, list in pairs(numbers) do merged[key] = median(list) end
  for _, row in ipairs(rows) do
    if row.failed then merged.failed, merged.outcome, merged.reason = true, row.outcome, row.reason end
  end
  merged[name] = nil
  return merged
end

core.docs["study:median"] = [[
study:median "round"
The study without this parameter: of rows that differ in nothing else one is left, with the medians of their numbers,
each over the rows that have it.
For figures that come out differently each time, above all times: cases = sg.grid{ …, round = {1, 2, 3} }.
Example: study:median "mesh"]]
function verbs:median(name)
  name = arguments.choice("study:median", "its argument", name, self.parameters)
  local kept, groups = {}, {}
  for _, parameter in ipairs(self.parameters) do
    if parameter ~= name then kept[#kept + 1] = parameter end
  end
  for _, row in ipairs(self.rows) do
    local words = {}
    for i, parameter in ipairs(kept) do words[i] = values.text(row[parameter], true) end
    local key = table.concat(words, "\0")
    if not groups[key] then groups[key], groups[#groups + 1] = {}, key end
    table.insert(groups[key], row)
  end
  local rows = {}
  for i, key in ipairs(groups) do
    rows[i] = merge(groups[key], name)
    -- A parameter is no measurement: what all rows of the group share stays the bits that it was.
    for _, parameter in ipairs(kept) do rows[i][parameter] = groups[key][1][parameter] end
  end
  return part_of(self, rows, { parameters = kept })
end

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Columns that tell something: outcome and reason only where there is one.
local function telling_columns(study)
  local names = {}
  for _, name in ipairs(values.columns(study)) do
    local told = name ~= "failed" and name ~= "outcome" and name ~= "reason"
    for _, row in ipairs(study.rows) do told = told or (name ~= "failed" and row[name] ~= nil) end
    if told then names[#names + 1] = name end
  end
  return names
end

--- Whether one value stands before another: numbers before texts, what is missing last.
local function before(a, b)
  if a == nil or b == nil then return a ~= nil end
  if type(a) == "number" and type(b) == "number" then return a < b end
  if type(a) == "number" or type(b) == "number" then return type(a) == "number" end
  return values.text(a) < values.text(b)
end

local function sorted_rows(where, study, sort)
  local rows = table.move(study.rows, 1, #study.rows, 1, {})
  if sort == nil then return rows end
  local names, place = type(sort) == "table" and sort or { sort }, {}
  for i, name in ipairs(names) do names[i] = values.column(where, "sort", name, study) end
  for i, row in ipairs(rows) do place[row] = i end
  table.sort(rows, function(a, b)
    for _, name in ipairs(names) do
      if not values.same(a[name], b[name]) then return before(a[name], b[name]) end
    end
    return place[a] < place[b]
  end)
  return rows
end

--- The columns and rows of a table, values as texts where a cell could not hold them.
local function read_table(where, study, options, known)
  options = arguments.table(where, "its argument", options, known)
  local columns = options.columns or telling_columns(study)
  if type(columns) ~= "table" then arguments.reject(where, "columns", "a list of names", columns) end
  local units, rows = {}, {}
  for j, name in ipairs(columns) do
    columns[j] = values.column(where, ("columns[%d]"):format(j), name, study)
    units[j] = study.units[name] or ""
  end
  for i, row in ipairs(sorted_rows(where, study, options.sort)) do
    rows[i] = {}
    for j, name in ipairs(columns) do
      local value = row[name]
      if type(value) == "table" or type(value) == "boolean" then value = values.text(value) end
      if name == "reason" and value then value = value:match "^[^\n]*" end
      rows[i][j] = value
    end
  end
  return columns, units, rows, options.formats or { wall = "%.3g" }
end

core.docs["study:table"] = [[
study:table{ columns, sort, formats }
The text of an aligned table, with units: all parameters and figures, or the columns named; sort is a column or a list
of columns, in rising order; formats are patterns of string.format by column name. Where a case did not come out,
outcome says failed, error, crashed or time, and reason why. Texts of more than 60 characters end with …; study.rows
and study:csv hold them whole.
Example: print(study:table{ columns = {"order", "mesh", "error"}, sort = "error" })]]
function verbs:table(options)
  local columns, units, rows, formats = read_table("study:table", self, options, { "columns", "sort", "formats" })
  for _, row in ipairs(rows) do
    for j = 1, #columns do row[j] = type(row[j]) == "string" and cut(row[j], widest) or row[j] end
  end
  return format_table{ columns = columns, units = units, rows = rows, formats = formats }
end

core.docs["study:csv"] = [[
study:csv(file, { columns, sort })
Writes the table to a CSV file, units in comments.
Example: study:csv "press.csv"]]
function verbs:csv(file, options)
  local columns, units, rows = read_table("study:csv", self, options, { "columns", "sort" })
  local comments = { ("study: %s"):format(self.name) }
  for j, name in ipairs(columns) do
    if units[j] ~= "" then comments[#comments + 1] = ("%s / %s"):format(name, units[j]) end
  end
  in_name_of("study:csv", "sg.csv.write", csv.write, arguments.string("study:csv", "file", file),
    { columns = columns, rows = rows, comments = comments })
end

function verbs:__len() return #self.rows end

--- How many cases are done, what became of those that did not come out, and the table.
function verbs:__tostring()
  local counts, all = outcomes.counts(self.rows), self.cases and #self.cases or #self.rows
  local head = ("%s: %s%s%s%s"):format(self.name, self.cases and ("%d of "):format(#self.rows) or "",
    counted(all, "case"), self.cases and (all == 1 and " is done" or " are done") or "",
    #counts > 0 and ", " .. table.concat(counts, ", ") or "")
  return #self.rows > 0 and head .. "\n" .. self:table() or head
end

return verbs
