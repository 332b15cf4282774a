-- The definitions for editors: they are complete, their annotations have the form that language servers read, right
-- calls conform to them, and wrong ones are marked. All other tests check the calls that they make, help_test those of
-- the examples with their results.

require "check"
local annotations = require "annotations"
local calls = require "calls"
local conformity = require "conformity"
local library = require "signorini.prompt.editor.library"
local names = require "signorini.prompt.help.names"
local pages = require "signorini.pages"

check.case("every file is valid Lua that defines no function with a body", function()
  for name, text in pairs(library()) do
    assert(load(text, "=" .. name))
    check.holds(text, "---@meta ")
  end
end)

check.case("every function and every type has a definition, every file its annotations in the known form", function()
  local db, count = annotations.read(library()), 0
  for _, name in ipairs(pages.names()) do
    local value = names.value(name)
    if type(value) == "function" and not db.functions[name] then error(name .. " has no definition") end
    if type(value) == "table" and not db.classes["sg." .. name] then error(name .. " has no class") end
    count = count + 1
  end
  check.equal(count > 150, true)
  check.equal({ db.functions.help ~= nil, db.functions.traceback ~= nil, #db.functions["sg.cheapest"].gives },
    { true, true, 2 })
  local options = db.classes["sg.model.run.options"].fields
  for _, key in ipairs(pages.keys "model:run") do
    if not options[key] then error("no field " .. key) end
  end
end)

check.case("a line of another form, an unknown name and a second definition are errors", function()
  local wrong = {
    ["---@class"] = "a text that begins like an annotation", ["---@clas sg.a"] = "unknown tag clas",
    ["---@field a number"] = "a field without a class", ["---| a"] = "a text that begins like an annotation",
    ["---@alias a \"x\"|"] = "a type expected", ["---@alias a number b"] = "not the end of the line: ",
    ["---@alias a b"] = "b is used and not defined", ["---@alias a table<string>"] = "a comma expected",
    ["---@alias a [number"] = "] expected", ["---@alias a fun(x number)"] = "a colon expected",
    ["---@class (exact) a\n---@class (exact) a"] = "", ["---@alias a any\n---@alias a any"] = "a is defined twice",
    ["---@class a\n---@field b any\n---@field b any"] = "a.b is defined twice",
    ["function f(a) end"] = "the parameters differ", ["function f() end\nfunction f() end"] = "f is defined twice",
    ["---@return a[]\nfunction f() end"] = "a is used and not defined", ["f()"] = "not part of the form",
  }
  for text, message in pairs(wrong) do
    check.fails(function() annotations.read { ["a.lua"] = text .. "\n" } end, message)
  end
end)

check.case("values of each form of type", function()
  local right = {
    { "number|\"x\"", 1, "x", 0 / 0 }, { "integer", 1, 2.0 }, { "\"x\"|\"y\"", "y" }, { "any", nil, print },
    { "number[]", {}, { 1, 2 } }, { "(number|string)[][]", { { 1, "x" } } }, { "[number, number]", { 1, 2 } },
    { "table<string, boolean>", {}, { a = true } }, { "fun(x: number): any, string", print }, { "true|nil", true, nil },
    { "sg.patch", sg.nurbs.circle { radius = 1 } }, { "table", {}, sg.csv },
  }
  local wrong = {
    { "number|\"x\"", "y", true }, { "integer", 1.5, "1" }, { "\"x\"|\"y\"", "z", 1 }, { "boolean", nil },
    { "number[]", 1, { "x" }, { a = 1 } }, { "[number, number]", { 1 }, { 1, 2, 3 }, { 1, 2, a = 1 } },
    { "table<string, boolean>", { 1 }, { a = 1 } }, { "fun()", {} }, { "true", false }, { "sg.patch", {}, 1 },
    { "sg.unknown_argument", 1, {}, false }, { "sg.body", sg.nurbs.circle { radius = 1 } },
  }
  for fits, list in pairs { [true] = right, [false] = wrong } do
    for _, case in ipairs(list) do
      for i = 2, math.max(#case, 2) do
        local ok = conformity.is(case[1], case[i])
        if ok ~= fits then error(("%s: %s gives %s"):format(case[1], core.describe(case[i]), ok)) end
      end
    end
  end
end)

check.case("right calls conform, wrong keys and values of another type are marked", function()
  local faults, marked, keys = {}, 0, 0
  local function conforms(call)
    local arguments = call.arguments
    arguments.n = calls.count(arguments)
    return conformity.of_call(call.page.name, arguments)
  end
  for _, call in ipairs(calls.right()) do
    local fits, place = conforms(call)
    if not fits then faults[#faults + 1] = ("%s: a right call is marked at %s"):format(call.page.name, place) end
  end
  for _, call in ipairs(calls.wrong()) do
    if not conforms(call) then
      marked, keys = marked + 1, keys + (call.what == "a misspelt key" and 1 or 0)
    elseif not (call.by_limit or call.by_object) then -- the definitions have neither limits nor sizes of objects
      faults[#faults + 1] = ("%s, argument %s: %s is not marked"):format(call.page.name, call.place, call.what)
    end
  end
  print(("%d wrong calls, of which %d with a misspelt key"):format(marked, keys))
  check.equal(marked > 4000 and keys > 500, true)
  if #faults > 0 then error(("%d faults\n%s"):format(#faults, table.concat(faults, "\n"))) end
end)
