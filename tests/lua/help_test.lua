-- Help: every public name has a page, and heads list the arguments that functions take, their examples run, and
-- share/doc/reference.md holds them all.

local check = require "check"
local core = require "signorini.core"
local sg = require "signorini"
local examples_of = require "signorini.help.examples"
local keys_of = require("signorini.help.keys").of_page
local names = require "signorini.help.names"
local pages = require "signorini.help.pages"
local scripts = require "signorini.help.scripts"
local subjects = require "signorini.help.subjects"

-- Methods of Lua's types that the library calls; users read about the others.
local private = {
  run = "new begin_stage begin_step record_attempt record_probe record_cutback add_extra record_extra drop_step "
    .. "record_step record_arc record_control record_failure keep_state info finish",
  study = "row_of gather",
}

local function lines_of(text)
  local list = {}
  for line in text:gmatch "[^\n]+" do list[#list + 1] = line end
  return list
end

local function is_private(type_name, key)
  return key:find "^__" or (" " .. (private[type_name] or "") .. " "):find(" " .. key .. " ", 1, true)
end

local function check_page(value, name)
  local page = core.names[value] and core.docs[core.names[value]]
  if not page then error(name .. " has no help page") end
  if not page:find "\n" then error(name .. " has a page of one line only") end
  if not subjects.is_public(core.names[value]) then error(name .. " is in none of help's groups") end
end

check.case("every public name has a page", function()
  local count = 0
  local function visit(entries, path)
    for key, value in pairs(entries) do
      local name = path .. "." .. key
      if type(value) == "table" then visit(value, name) else check_page(value, name) end
      count = count + 1
    end
  end
  visit(sg, "sg")
  for type_name, methods in pairs(core.types) do
    if type_name ~= "lock" then
      if not core.docs[type_name] then error(type_name .. " has no help page") end
      for key, value in pairs(methods) do
        if type(value) == "function" and not is_private(type_name, key) then
          check_page(value, type_name .. ":" .. key)
          count = count + 1
        end
      end
    end
  end
  check.equal(count > 130, true)
end)

check.case("help finds the scripts that come along, and shows what they solve", function()
  local all = {}
  for i, script in ipairs(scripts.all()) do
    all[i] = script.name
    if #script.title < 20 then error(script.name .. " has no title") end
  end
  check.equal(#all > 20, true)
  check.equal({ scripts.of "hertz2d".name, scripts.of "scripts/stability/peeling.lua".name, scripts.of "problem" },
    { "hertz2d.lua", "stability/peeling.lua", nil })
  local output = check.program({},
    'help "gallery"\nhelp "hertz"\nhelp "hertz2d"\nhelp "scripts"\nhelp "hertz_sphere.lau"\n')
  for _, name in ipairs(all) do check.holds(output, "\n  " .. name .. " ") end
  check.holds(output, "Scripts with 'hertz':\n  hertz2d.lua ", "/scripts/hertz2d.lua\n\nHertz's line contact: what",
    "\nRun: signorini",
    "Tables, files, scripts:\n", "did you mean 'hertz_sphere.lua'?")
end)

check.case("lists give each page a line with its first sentence", function()
  local names = {}
  for name in pairs(core.docs) do
    if subjects.is_public(name) then names[#names + 1] = name end
  end
  check.equal(#names > 130, true)
  for i, line in ipairs(lines_of(pages.list(names))) do
    local summary = line:match "%S  +(%S.*)$"
    if utf8.len(line) > 118 or not summary or #summary < 8 then error(names[i] .. " is listed as " .. line) end
  end
  check.equal(pages.list { "study:with" },
    "  study:with(name, …)  The study with one figure more, made from each row; nil where it is not known")
  check.equal({ pages.head "help", pages.head "sg.picture" },
    { "help(…)", "sg.picture{ model, file, field, fields, … }" })
end)

check.case("internal pages are in no list", function()
  local output = check.program({}, 'help "_"\nhelp "core"\nhelp "jobs"\n')
  check.equal(output:find("core.", 1, true), nil)
  check.holds(output, "At the prompt:", "no page on 'core'", "study:execute{ jobs, limit, again }")
end)

check.case("every page is about something, and is internal or in a group", function()
  for name in pairs(core.docs) do
    if not name:find "^core%." and not name:find "^lock" then
      if not subjects.is_public(name) then error(name .. " is in none of help's groups") end
      if name ~= "traceback" and not names.value(name) and not rawget(core.types, name) then
        error(name .. " is no name of the language")
      end
    end
  end
end)

check.case("the page shows the named arguments that the function takes", function()
  local checked = 0
  local function message_of(name, call)
    local ok, message = pcall(call)
    if ok then error(name .. " takes an argument that does not exist") end
    return message:match "[Kk]nown: ([%w_, ]+)"
  end
  local body = sg.body { patch = sg.shapes.rectangle { width = 1, height = 1 }, elements = { 1, 1 }, order = "N1",
    material = sg.linear_elastic { E = 1, nu = 0.3 } }
  local study = sg.study { name = "a", cases = sg.grid { a = { 1 } }, run = function() return {} end }
  local selves = { patch = sg.shapes.block { size = { 1, 1, 1 } }, study = study,
    map = setmetatable({}, core.types.map), series = setmetatable({}, core.types.series),
    model = sg.model { bodies = { a = body }, supports = { s = { on = body:face "south", fix = "xy" } } } }
  local free = { ["sg.grid"] = true, ["sg.arguments"] = true, ["study:where"] = true, ["study:row"] = true,
    ["sg.table"] = true,
    ["sg.csv.write"] = true, ["model:iterate"] = true, ["sg.robust"] = true, ["study:execute"] = false }
  for name, page in pairs(core.docs) do
    local keys = keys_of(page)
    if #keys > 0 and not free[name] and subjects.is_public(name) then
      local value, type_name = names.value(name), name:match "^([%w_]+):"
      local arguments = { { no_such_argument = 1 } }
      local first = page:match "^[%w_.:]+%((%w+)"
      if first then table.insert(arguments, 1, ({ study = study, stages = { { steps = 1 } } })[first] or "a.pvd") end
      if type_name then table.insert(arguments, 1, (assert(selves[type_name], name))) end
      local known, shown = message_of(name, function() value(table.unpack(arguments)) end), {}
      if not known then error(name .. " does not say which arguments it knows") end
      for key in known:gmatch "[%w_]+" do
        shown[key] = true
        if not keys[key] then error(("the head of the page of %s lacks '%s'"):format(name, key)) end
      end
      for _, key in ipairs(keys) do
        if not shown[key] then
          error(("the head of the page of %s has '%s', which is no argument"):format(name, key))
        end
      end
      checked = checked + 1
    end
  end
  check.equal(checked > 40, true)
end)

check.case("the parts of a scene and its path have pages", function()
  local texts = require "signorini.help.texts"
  check.holds(texts.contact, "friction: { mu, penalty }", "points:", "3 (p + 1)", "adhesion:", "where:", "Source:")
  check.holds(texts.support, "fix:", "drive:", "free:", "rotate:", "symmetry:")
  check.holds(texts.load, "traction:", "pressure:")
  check.holds(texts.stage, "steps:", "Values count from the reference state")
end)

check.case("every example runs on the scene of the examples, and gives what it says", function()
  local folder = check.folder()
  local lines = { "sg = require 'signorini' help = sg.help", "local text = require('signorini.show').text",
    require("signorini.help.texts").scene, [[
    local function example(name, code, expected)
      local own = setmetatable({}, { __index = _G })
      local chunk, message = load("return " .. code, "=" .. name, "t", own)
      if not chunk then chunk, message = load(code, "=" .. name, "t", own) end
      if not chunk then return print("FAILED " .. message) end
      local results = table.pack(pcall(chunk))
      if not results[1] then return print("FAILED " .. tostring(results[2])) end
      local got = results.n > 1 and text(results[2]) or ""
      if expected and got ~= expected then print(("FAILED %s: %s instead of %s"):format(name, got, expected)) end
    end]] }
  local count = 0
  for _, group in ipairs(subjects.groups) do
    for _, name in ipairs(subjects.pages(group)) do
      for _, code in ipairs(select(2, examples_of(core.docs[name]))) do
        count = count + 1
        local expected = code:match "%-%->%s*(.-)%s*$"
        lines[#lines + 1] = ("example(%q, %q, %s)"):format(name, code, expected and ("%q"):format(expected) or "nil")
      end
    end
  end
  core.write_file(folder .. "/examples.lua", table.concat(lines, "\n"))
  local output, status = check.shell(("cd %s && SIGNORINI_HOME=%s %s -q examples.lua 2>&1"):format(folder, core.home,
    arg[-1]))
  local failed = output:match "FAILED[^\n]*" or output:match "signorini: [^\n]*"
  if failed then
    error((output:gsub("[^\n]*\n?", function(line) return line:find "FAILED" and line or "" end)) .. failed)
  end
  check.equal(status, 0)
  check.equal(count > 60, true)
end)

check.case("every function that is not internal has an example", function()
  local without = { ["model:cost_figures"] = true, ["model:diagnose"] = true, ["traceback"] = true }
  for name, page in pairs(core.docs) do
    local is_type = rawget(core.types, name)
    if subjects.is_public(name) and not is_type and not without[name] and not page:find "\nExample: " then
      error(name .. " has no example")
    end
  end
end)

check.case("a word finds pages of the language only", function()
  local found, said = 0, nil
  local print_as_ever = print
  print = function(text) said = text end
  for name, page in pairs(core.docs) do
    local last = name:match "^core%.([%w_]+)$"
    if last then
      found = found + 1
      require("signorini.help").show(last)
      if said:find("core." .. last, 1, true) then print_as_ever(said) error("help finds core." .. last) end
    end
  end
  print = print_as_ever
  check.equal(found > 10, true)
end)

check.case("share/doc/reference.md holds what is on the pages", function()
  if core.read_file(core.home .. "/share/doc/reference.md") ~= require "signorini.help.markdown"() then
    error "share/doc/reference.md is not what the help pages say: run scripts/reference"
  end
end)

check.done()
