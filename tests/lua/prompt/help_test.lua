-- Help: every public name has a page, and heads list the arguments that functions take, their examples run, and
-- share/doc/reference contains all pages; terms of other programs lead to pages.

require "check"
local examples_of = require("signorini.prompt.help.page_text").examples
local names = require "signorini.prompt.help.names"
local pages = require "signorini.pages"
local scripts = require "signorini.prompt.help.scripts"

-- Methods of Lua's types that the library calls; users read about the others.
local private = {
  run = "new account begin_stage begin_step record_attempt record_probe record_cutback add_extra record_extra "
    .. "record_measured drop_step record_step record_arc record_control record_failure store_state info finish",
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
  local page = core.names[value] and pages.find(core.names[value])
  if not page then error(name .. " has no help page") end
  if #page.text < 20 then error(name .. " has a page that says nothing") end
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
    if type_name ~= "lock" and type_name ~= "HDF5 file" then
      if not pages.find(type_name) then error(type_name .. " has no help page") end
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

check.case("help finds the installed scripts, and shows their problems", function()
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
  check.holds(output, "Scripts with 'hertz':\n  hertz2d.lua ",
    "/scripts/problems/hertz2d.lua\n\nHertz line contact: effect",
    "\nRun: signorini",
    "Tables, files, scripts:\n", "did you mean 'hertz_sphere.lua'?")
end)

check.case("lists give each page a line with its first sentence", function()
  local checked = 0
  for _, group in ipairs(pages.groups()) do
    local output = check.program({}, ("help %q\n"):format(group.word))
    check.holds(output, group.title .. ":\n")
    for line in output:gmatch "\n(  %S[^\n]*)" do
      local summary = line:match "%S  +(%S.*)$"
      if utf8.len(line) > 118 or not summary or #summary < 8 then error("a page is listed as " .. line) end
      checked = checked + 1
    end
  end
  check.equal(checked > 130, true)
  check.equal({ pages.short_head(pages.find "sg.picture", 46), pages.short_head(pages.find "study:with", 46) },
    { "sg.picture{ model, state, patch, states, … }", "study:with(name, make, unit)" })
end)

check.case("every page has a subject", function()
  for _, group in ipairs(pages.groups()) do
    for _, page in ipairs(group) do
      if not page.head and not names.value(page.name) then error(page.name .. " is not a name of the language") end
    end
  end
end)

check.case("every argument of a table is read by the code, and no key occurs twice", function()
  local code = {}
  local found = check.shell(("find '%s/src/bind' '%s/lua/signorini' -name '*.[chl]*' -type f | grep -v /pages")
    :format(core.home, core.home))
  for file in found:gmatch "[^\n]+" do code[#code + 1] = core.read_file(file) end
  code = table.concat(code)
  for _, name in ipairs(pages.names()) do
    local seen = {}
    for _, key in ipairs(pages.keys(pages.find(name).named or {})) do
      if seen[key] then error(("%s has two rows of the key '%s'"):format(name, key)) end
      seen[key] = true
      local is_read = code:find('"' .. key .. '"', 1, true) or code:find("%." .. key .. "%f[^%w_]")
      if not is_read then error(("%s: nothing reads the argument '%s'"):format(name, key)) end
    end
  end
end)

check.case("every example runs on the scene of the examples, with the stated results", function()
  local folder = check.folder()
  local lines = { "sg = require 'signorini' help = sg.help",
    ("package.path = %q .. package.path"):format(core.home .. "/tests/lua/?.lua;"),
    -- Small pictures, because the time of drawing grows with the number of pixels.
    "for _, name in ipairs { 'picture', 'sheet' } do local draw = sg[name] rawset(sg, name, function(options)",
    "  options.size = options.size or 700 return draw(options) end) end",
    "require('conformity').watch_calls() require('conformity').watch_results()",
    "local text = require('signorini.prompt.show').text",
    require("signorini.prompt.help.texts").scene, [[
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
  for _, group in ipairs(pages.groups()) do
    for _, page in ipairs(group) do
      for _, code in ipairs(examples_of(page)) do
        local name = page.name
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

check.case("every function has an example", function()
  local without = { ["model:diagnose"] = true, ["traceback"] = true }
  for _, name in ipairs(pages.names()) do
    local page = pages.find(name)
    if (page.named or page.arguments) and names.value(name) and not without[name] and #examples_of(page) == 0 then
      error(name .. " has no example")
    end
  end
end)

check.case("a search finds only pages of the library", function()
  local output = check.program({}, 'help "core"\nhelp "hash"\nhelp "_"\nhelp "jobs"\n')
  check.equal(output:find("core.", 1, true), nil)
  check.holds(output, "At the prompt:", "no page on 'hash'", "study:execute{ jobs, limit, rerun, on, … }")
end)

check.case("terms of other programs lead to pages, none of which has the term as its name", function()
  local seen, count = {}, 0
  local names = {}
  for _, name in ipairs(pages.names()) do names[name], names[name:match "[^.:]+$"] = true, true end
  for _, group in ipairs(pages.groups()) do names[group.word] = true end
  for name in pairs(require "signorini.prompt.help.texts") do names[name] = true end
  for _, entry in ipairs(require "signorini.prompt.help.synonyms") do
    if #entry < 3 or not entry[2]:find "%.$" then error(entry[1] .. " has no answer or no page") end
    for i = 3, #entry do
      if not pages.find(entry[i]) then error(("%s leads to '%s', which is not a page"):format(entry[1], entry[i])) end
    end
    for term in entry[1]:gmatch "[^,]+" do
      term = term:match "^%s*(.*)$"
      if term ~= term:lower() or seen[term] then error(term .. " occurs twice or with capitals") end
      if names[term] or scripts.of(term) then error(term .. " has a page of its own") end
      seen[term], count = true, count + 1
    end
  end
  check.equal(count > 100, true)
  for _, term in ipairs { "dirichlet", "neumann", "gravity", "tied", "hyperelasticity", "rubber", "plot", "export",
    "output", "python", "restart", "plane stress", "mortar", "convergence", "progress", "verbose",
    "boundary condition", "pressure load", "pretension", "delamination", "wear", "mesh import", "load curve",
    "history output", "incompressible", "plastic" } do
    if not seen[term] then error("help has no answer to " .. term) end
  end
  local output = check.program({}, 'help "Boundary-Conditions"\nhelp "body force"\nhelp "mortar"\n?restart\n')
  check.holds(output, "Displacements are prescribed by supports", "See:\n  support{ on, fix",
    "acts on bodies per reference volume", "Contact is Gauss-point-to-surface",
    "Scripts with 'mortar':", "  model:save(path) ")
end)

check.case("share/doc/reference agrees with the pages", function()
  local files, folder = require "signorini.prompt.help.markdown"(), core.home .. "/share/doc/reference/"
  for name, text in pairs(files) do
    if not core.exists(folder .. name) or core.read_file(folder .. name) ~= text then
      error(folder .. name .. " is not what the help pages say: run scripts/reference")
    end
  end
  for _, name in ipairs(core.list_folder(folder)) do
    if not files[name] and name ~= "theory.md" and name ~= "glossary.md" and name ~= "theory" then
      error(folder .. name .. " is not written by scripts/reference")
    end
  end
end)
