-- What a report says about its origin: the script with its modules and arguments, the program, the machine, the time.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local html = require "signorini.output.report.html"
local lists = require "signorini.call.lists"
local quoted = require("signorini.call.text").quoted

local own_versions = lists.merged(core.versions, { signorini = require "signorini.call.release" })
local origin = {}

-- ── What was asked ───────────────────────────────────────────────────────────────────────────────────────────────────

--- Names and files of the modules that the script has loaded, except those of the library.
local function modules()
  local found, library = {}, core.home .. "/lua/"
  for _, name in ipairs(lists.sorted_names(package.loaded)) do
    local file = package.searchpath(name, package.path)
    if file and file:sub(1, #library) ~= library then found[#found + 1] = { name = name, file = file } end
  end
  return found
end

--- A word of a command line, in quotes where it needs them.
local function word(text)
  return text:find "^[%w%._/=,:+-]+$" and text or quoted(text)
end

--- The script, its arguments and its modules; the text of a script is that of its file now.
function origin.script()
  local parts, script = {}, core.script or ""
  if script == "" or not core.exists(script) then
    return html.element("p", "Typed at the prompt, or read from standard input: there is no script to show.")
  end
  local words = lists.map(lists.joined({ "signorini", script:match "[^/]*$" }, core.arguments or {}), word)
  parts[1] = ("<p>Command: <code>%s</code></p>"):format(html.escape(table.concat(words, " ")))
  parts[2] = html.listing(("Script %s"):format(script:match "[^/]*$"), core.read_file(script))
  for _, module in ipairs(modules()) do
    parts[#parts + 1] = html.listing(("Module %s"):format(module.name), core.read_file(module.file))
  end
  return table.concat(parts, "\n")
end

-- ── Program, machine and time ────────────────────────────────────────────────────────────────────────────────────────

--- "signorini 1.0, Lua 5.4.4": versions of the program and its libraries, without the paths of files.
local function versions_text(versions)
  local names = lists.unique(lists.joined({ "signorini", "Lua", "Eigen", "SuiteSparse", "BLAS" },
    lists.sorted_names(versions)))
  local known = lists.filter(names, function(name) return versions[name] and name ~= "kernel" end)
  return table.concat(lists.map(known, function(name)
    local version = tostring(versions[name]):gsub(",?%s*/%S*$", "")
    return version:find(name, 1, true) and version or ("%s %s"):format(name, version)
  end), ", ")
end

local function machine_text(host, processor, kernel)
  local parts = { host or "", processor or "", kernel and ("kernel %s"):format(kernel) or "" }
  return table.concat(lists.filter(parts, function(part) return part ~= "" end), ", ")
end

--- The signatures of a study's records, { versions, host, processor, time } each.
local function made_of(records)
  local made = {}
  for _, record in pairs(records or {}) do
    if type(record.made) == "table" then made[#made + 1] = record.made end
  end
  return made
end

local function distinct(made, text)
  local texts = lists.unique(lists.map(made, function(one) return text(one) end))
  table.sort(texts)
  return texts
end

local function made_on(one)
  return machine_text(one.host, one.processor, (one.versions or {}).kernel)
end

local function made_with(one) return versions_text(one.versions or {}) end

--- Sentences about records that are not comparable, because machines or versions differ.
function origin.warnings(records)
  local made, texts = made_of(records), {}
  local machines, programs = distinct(made, made_on), distinct(made, made_with)
  if #machines > 1 then
    texts[1] = ("the cases were solved on %s: their times are not comparable"):format(counted(#machines, "machine"))
  end
  if #programs > 1 then
    texts[#texts + 1] = ("the cases were solved with %s of the program or its libraries"):format(
      counted(#programs, "version"))
  end
  return texts
end

--- Facts on what solved and what writes the report: one if they are the same.
local function solved_and_written(solved, now, noun)
  if #solved == 0 or #solved == 1 and solved[1] == now then return { { noun, now } } end
  local facts = lists.map(solved, function(text) return { noun .. " of the solution", text } end)
  return lists.joined(facts, { { noun .. " of the report", now } })
end

--- The facts that differ between two reports of the same input: program, machine, time. `records`: of a study.
function origin.facts(records)
  local made = made_of(records)
  local facts = lists.joined(
    solved_and_written(distinct(made, made_with), versions_text(own_versions), "Program and libraries"),
    solved_and_written(distinct(made, made_on), machine_text(core.host, core.processor, core.versions.kernel),
      "Machine"),
    { { "Processors and threads", ("%s, %s"):format(counted(core.processors, "processor"),
      counted(core.threads, "thread")) } })
  local times = distinct(made, function(one) return one.time or "" end)
  if #times > 0 then
    facts[#facts + 1] = { "Solved", #times == 1 and times[1] or ("%s to %s"):format(times[1], times[#times]) }
  end
  facts[#facts + 1] = { "Report written", os.date "!%Y-%m-%dT%H:%M:%SZ" }
  return facts
end

return origin
