-- sg.study: a function solved for many cases, its results kept in a folder, and verbs that read them.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local execute = require "signorini.study.execute"
local figure_names = require("signorini.study.values").figure_names
local read_cases = require("signorini.study.cases").read
local store = require "signorini.study.store"
local verbs = require "signorini.study.verbs"

local where = "sg.study"

local Study = { execute = execute.verb }
Study.__index = Study
Study.__name = "study"
core.types.study = Study
for name, verb in pairs(verbs) do Study[name] = verb end

-- A part of a study has no cases but the whole that it was taken from, what it is not given has no inputs, and one that
-- keeps nothing has no folder. All else that is not there is misspelt.
local may_be_missing = { cases = true, inputs = true, whole = true, folder = true, parts = true, fresh = true,
                         on_record = true }
setmetatable(Study, { __index = function(_, name)
  if may_be_missing[name] or type(name) ~= "string" or name:find "^__" then return nil end
  local known = { "rows", "parameters", "figures", "units", "name", "folder" }
  for method in next, Study do
    if not method:find "^__" and core.names[Study[method]] then known[#known + 1] = method end -- those with a page
  end
  table.sort(known)
  local meant = core.nearest(name, known)
  core.fail(("a study has no '%s'%s: it has %s"):format(name, meant and ("; did you mean '%s'?"):format(meant) or "",
    table.concat(known, ", ")))
end })

-- ── From records to rows ─────────────────────────────────────────────────────────────────────────────────────────────

--- The row of a case: its parameters and figures by name, wall (s; the figure of that name where run returned one), and
--- failed, outcome, reason of a case that did not come out.
function Study:row_of(entry, record)
  local row = { wall = record.wall }
  for _, source in ipairs { entry.case, record.figures } do
    for name, value in pairs(source) do row[name] = value end
  end
  if record.outcome ~= "done" then
    row.failed, row.outcome, row.reason = true, record.outcome, record.reason or record.outcome
  end
  return row
end

--- Makes the rows anew from the records of the cases that are known.
function Study:gather()
  self.rows, self.figures = {}, figure_names(self.records)
  for i, entry in ipairs(self.cases) do
    if self.records[i] then self.rows[#self.rows + 1] = self:row_of(entry, self.records[i]) end
  end
end

core.docs["study:read"] = [[
study:read()
Reads what the study's folder holds of its cases, without running any, and returns the study. It may be called while
another process executes it; changed inputs are not looked for.
Example: print(study:read())]]
function Study:read()
  if not self.cases then core.fail "study:read: this is a part of a study: read the study that it was taken from" end
  store.check("study:read", self)
  self.records = {}
  for i, entry in ipairs(self.cases) do self.records[i] = (store.read(self, entry)) end
  self:gather()
  return self
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A study of what is read already. Besides what sg.study takes: no folder (nothing is kept), `fresh` (what the folder
--- holds goes first), `parts` (by name, what the results depend on, where that is not `run`), and on_record(), called
--- when records of cases were read or written.
local function make(study)
  study.records, study.unsaved, study.rows, study.figures = {}, {}, {}, {}
  study.alone, study.units = study.alone or false, study.units or {}
  study.units.wall = study.units.wall or "s"
  study.cases, study.parameters = read_cases(study.cases)
  return setmetatable(study, Study)
end

local function read_units(units)
  if units == nil then return {} end
  if type(units) ~= "table" then arguments.reject(where, "units", "a table such as { dPx = \"N/mm\" }", units) end
  local copy = {}
  for name, unit in pairs(units) do
    copy[name] = arguments.string(where, ("units.%s"):format(tostring(name)), unit)
  end
  return copy
end

--- The name of a study's folder below out/, from its own name.
local function folder_name(name)
  local stem = name:gsub("[^%w.=+()-]+", "_")
  if name:find "^%s*$" or stem == "." or stem == ".." then
    arguments.reject(where, "name", "a text that can name a folder", name)
  end
  return stem
end

core.docs["study"] = [[
study
What sg.study returns: #study rows, study.rows, a list of tables of parameters and figures by name; their names are in
study.parameters and study.figures; study.units, study.name, study.folder as they were given. print(study) shows how
many cases are done, and the table. Verbs that choose, group or add return a study of their own that has rows only.
study.records[i].made tells how case i was computed, once it is done: host, processor, versions (of libraries), time.]]

core.docs["sg.study"] = [[
sg.study{ name, cases = sg.grid{ … }, run = function(case) … return { dPx = …, wall = run.wall } end, folder, units,
          alone = false, inputs }
A function that is solved for many cases, side by side, and whose results are kept. study:execute{ jobs = 2 } does it.
cases:  a list of tables of parameters, or of such lists: grids may stand side by side.
run:    returns figures by name: numbers, texts, true or false, and lists of these, which tables leave out. A case that
        did not come out returns failed = true and a reason: that is a result, too. A figure that is nan or infinite
        makes the case an error. Each case is a process of its own: what it changes is lost with it.
folder: where each finished case is written at once as a JSON file: out/<name> by default.
units:  of figures and parameters by name, for heads of tables and labels of axes.
alone:  true, or a function of a case: such cases run last and one by one, with nothing beside them, to be timed.
inputs: plain data. A case counts as done as long as its parameters, the text of run, all that run refers to
        (functions, numbers, tables, all that bodies and models hold) and the program's version stay as they are; with
        inputs only its parameters and these count.
Beside its figures each row has wall, the seconds that run took, unless it returned a figure of that name. A case that
did not come out has failed = true, outcome ("failed", "error", "crashed", or "time" beyond a limit) and reason.
study.rows: a list of tables; #study; print(study); see help "study:where", "study:table", "study:chart".
Example: study = sg.study{ name = "steps", cases = sg.grid{ steps = {5, 10} },
           run = function(case)
             local run = press("N2", 1):run{ { name = "press", steps = case.steps, grip = {0, -0.1} } }
             return { force = run:column "grip.fy"[run.steps] }
           end }]]
local function new(options)
  if type(options) ~= "table" then arguments.reject(where, "its argument", "a table of named arguments", options) end
  arguments.table(where, "its argument", options, { "name", "cases", "run", "folder", "units", "alone", "inputs" })
  local name = arguments.string(where, "name", options.name)
  local folder = arguments.string(where, "folder", options.folder, "out/" .. folder_name(name))
  if folder == "" then arguments.reject(where, "folder", "the name of a folder", folder) end
  if options.run == nil then arguments.reject(where, "run", "a function that takes a case and returns figures", nil) end
  local alone = options.alone
  if type(alone) ~= "function" then alone = arguments.flag(where, "alone", alone, false) end
  return make{ name = name, cases = options.cases, run = arguments.callback(where, "run", options.run), alone = alone,
               inputs = options.inputs, folder = folder, units = read_units(options.units) }
end

return { new = new, make = make }
