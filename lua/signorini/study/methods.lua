-- Methods that read a study. Those that select, group or add rows return a study, so that they can be chained; it has
-- results only and cannot be executed.

local cells = require "signorini.study.cells"
local check = require "signorini.call.check"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local csv = require "signorini.output.csv"
local cut = require("signorini.call.text").cut
local filter = require "signorini.study.filter"
local on_behalf_of = require "signorini.call.on_behalf_of"
local format_table = require("signorini.output.table").text
local lists = require "signorini.call.lists"
local outcomes = require "signorini.study.outcomes"
local pictures = require "signorini.study.pictures"
local types = require "signorini.call.types"
local values = require "signorini.study.values"

local map = lists.map
local widest = 60 -- characters of a printed cell

local methods = { chart = pictures.chart, heatmap = pictures.heatmap }

function methods:report(options) return require "signorini.output.report.study"(self, options) end

--- A study of these rows; `more` replaces other fields of the old one.
local function part_of(study, rows, more)
  return setmetatable(lists.merged({ name = study.name, parameters = study.parameters, results = study.results,
    units = study.units, rows = rows, whole = study.whole or study }, more), getmetatable(study))
end

-- ── Choosing ─────────────────────────────────────────────────────────────────────────────────────────────────────────

function methods:where(wanted) return part_of(self, filter.rows("study:where", self, wanted)) end

function methods:row(wanted)
  local rows = filter.rows("study:row", self, wanted)
  if #rows ~= 1 then
    core.fail(("study:row: %s rows have %s, not one: %s"):format(#rows == 0 and "no" or #rows, filter.text(wanted),
      #rows == 0 and "print the study to see its rows" or "name more parameters"))
  end
  return rows[1]
end

--- Lists of the rows with equal values of some columns, in the order in which these first occur.
local function grouped(rows, names)
  return lists.grouped(rows, function(row)
    return table.concat(map(names, function(name) return type(row[name]) .. values.text(row[name], true) end), "\0")
  end)
end

function methods:by(name)
  values.column("study:by", "name", name, self)
  local groups, i = grouped(self.rows, { name }), 0
  return function()
    i = i + 1
    if groups[i] then return groups[i][1][name], part_of(self, groups[i]) end
  end
end

-- ── Computing ────────────────────────────────────────────────────────────────────────────────────────────────────────

function methods:column(name)
  values.column("study:column", "name", name, self)
  return map(self.rows, function(row)
    if row[name] == nil then return 0 / 0 end
    return row[name]
  end)
end

function methods:with(name, make, unit)
  if lists.holds(self.parameters, name) then
    core.fail(("study:with: '%s' is a parameter. Hint: choose another name"):format(name))
  end
  local rows, units = {}, lists.merged(self.units)
  for i, row in ipairs(self.rows) do
    rows[i] = lists.merged(row)
    local value = make(row)
    if value ~= value then
      core.fail(("study:with: %s is nan in row %d. Hint: return nil for an unknown value"):format(name, i))
    end
    rows[i][name] = value
  end
  units[name] = unit
  local others = lists.filter(self.results, function(known) return known ~= name end)
  return part_of(self, rows, { results = lists.joined(others, { name }), units = units })
end

--- Merges rows that differ in one parameter only: medians of numbers, otherwise the value of the first row that has
--- one.
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
  for key, list in pairs(numbers) do merged[key] = lists.median(list) end
  for _, row in ipairs(rows) do
    if row.failed then merged.failed, merged.outcome, merged.reason = true, row.outcome, row.reason end
  end
  merged[name] = nil
  return merged
end

function methods:median(name)
  check.value(types.choice(self.parameters), name, "study:median", "name")
  local others = lists.filter(self.parameters, function(parameter) return parameter ~= name end)
  local rows = map(grouped(self.rows, others), function(group)
    local row = merge(group, name)
    -- A parameter that all rows of the group share stays bitwise the same.
    for _, parameter in ipairs(others) do row[parameter] = group[1][parameter] end
    return row
  end)
  return part_of(self, rows, { parameters = others })
end

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

function methods:table(options)
  local columns, units, rows = cells("study:table", self, options)
  for _, row in ipairs(rows) do
    for j = 1, #columns do row[j] = type(row[j]) == "string" and cut(row[j], widest) or row[j] end
  end
  return format_table{ columns = columns, units = units, rows = rows, formats = options.formats }
end

function methods:csv(file, options)
  local columns, units, rows = cells("study:csv", self, options)
  local comments = { ("study: %s"):format(self.name) }
  for j, name in ipairs(columns) do
    if units[j] ~= "" then comments[#comments + 1] = ("%s (%s)"):format(name, units[j]) end
  end
  on_behalf_of("study:csv", "sg.csv.write", csv.write, file, { columns = columns, rows = rows, comments = comments })
end

function methods:__len() return #self.rows end

--- The number of finished cases, the outcomes of those without results, and the table.
function methods:__tostring()
  local counts, all = outcomes.counts(self.rows), self.cases and #self.cases or #self.rows
  local head = ("%s: %s%s%s%s"):format(self.name, self.cases and ("%d of "):format(#self.rows) or "",
    counted(all, "case"), self.cases and (all == 1 and " is done" or " are done") or "",
    #counts > 0 and ", " .. table.concat(counts, ", ") or "")
  return #self.rows > 0 and head .. "\n" .. self:table() or head
end

return methods
