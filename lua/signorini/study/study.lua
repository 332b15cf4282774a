-- sg.study: a function evaluated for many cases, its results saved in a folder, and methods to read them.

local check = require "signorini.call.check"
local core = require "signorini.core"
local execute = require "signorini.study.execute"
local result_names = require("signorini.study.values").result_names
local lists = require "signorini.call.lists"
local named = require "signorini.call.named"
local read_cases = require("signorini.study.cases").read
local store = require "signorini.study.store"
local methods = require "signorini.study.methods"
local watch = require "signorini.study.watch"

local where = "sg.study"

local Study = lists.merged({ execute = execute.method, __name = "study" }, methods, watch)
Study.__index = Study
core.types.study = Study

-- Fields that some studies lack: parts of a study have no cases but `whole`, and without a folder nothing is saved. All
-- other unknown names are misspelled.
named.strict_type(Study, "study", "cases inputs whole folder parts fresh on_record")

-- ── From records to rows ─────────────────────────────────────────────────────────────────────────────────────────────

--- The row of a case: its parameters and results by name, wall (s; the result of that name if run returned one), and
--- failed, outcome, reason of a failed case.
function Study:row_of(entry, record)
  local row = lists.merged({ wall = record.wall }, entry.case, record.results)
  if record.outcome ~= "done" then
    row.failed, row.outcome, row.reason = true, record.outcome, record.reason or record.outcome
  end
  return row
end

--- Rebuilds the rows from the records of the known cases.
function Study:gather()
  self.rows, self.results = {}, result_names(self.records)
  for i, entry in ipairs(self.cases) do
    if self.records[i] then self.rows[#self.rows + 1] = self:row_of(entry, self.records[i]) end
  end
end

function Study:read()
  if not self.cases then
    core.fail "study:read: this is a part of a study. Hint: read the study from which it was taken"
  end
  store.check("study:read", self)
  self.records = lists.map(self.cases, function(entry) return (store.read(self, entry)) end)
  self:gather()
  return self
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A study of checked arguments. In addition to those of sg.study: no folder (nothing is saved), `fresh` (the folder is
--- emptied first), `parts` (by name, what the results depend on, if that is not `run`), and on_record(), called when
--- records of cases were read or written.
local function make(study)
  study.records, study.unsaved, study.rows, study.results = {}, {}, {}, {}
  study.sequential, study.units = study.sequential or false, study.units or {}
  study.units.wall = study.units.wall or "s"
  study.cases, study.parameters = read_cases(study.cases)
  return setmetatable(study, Study)
end

local function folder_name(name)
  local stem = name:gsub("[^%w.=+()-]+", "_")
  if name:find "^%s*$" or stem == "." or stem == ".." then
    check.reject(where, "name", "a string that is valid as the name of a folder", name)
  end
  return stem
end

local function new(options)
  options.folder = options.folder or "out/" .. folder_name(options.name)
  if options.folder == "" then check.reject(where, "folder", "the name of a folder", "") end
  return make(options)
end

require("signorini.call.methods").guard("study",
  "by cancel chart column csv execute heatmap median read report row table watch where with")

return { new = new, make = make }
