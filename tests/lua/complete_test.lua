-- Completion at the prompt: names, methods, keywords, named arguments.

local check = require "check"
local complete = require "signorini.complete"

sg = require "signorini" -- as at the prompt

--- All completions of what stands behind the last blank, brace or comma of a text.
local function all(text)
  local before, word = text:match "^(.-)([%w_.:/]*)$"
  local list = {}
  repeat
    list[#list + 1] = complete(word, before, #list + 1)
  until not complete(word, before, #list + 1)
  return list
end

check.case("names of tables and methods", function()
  check.equal(all "sg.shapes.rec", { "sg.shapes.rectangle" })
  check.equal(all "x = whi", { "while" })
  patch = sg.shapes.rectangle { width = 1, height = 1 }
  check.equal(all "patch:de", { "patch:degrees", "patch:derivatives" })
  check.equal(all "nothing.at.all", {})
  check.equal(all "2/sg.shapes.rec", { "2/sg.shapes.rectangle" })
end)

check.case("methods of Lua's objects, without those that only the library calls", function()
  run = setmetatable({}, require("signorini.run_result"))
  check.equal(all "run:co", { "run:column", "run:columns" })
  check.equal(all "run:record", {})
  check.equal(all "run:", { "run:attempts", "run:column", "run:columns", "run:csv", "run:residuals", "run:states" })
end)

check.case("named arguments where they may stand, without those that are there", function()
  check.equal(all "sg.body{ m", { "material = " })
  check.equal(all "sg.body{ patch = sg.shapes.block{ size = {1, 2, 3} },\n  elements = {1, 1}, ",
    { "order = ", "contact = ", "material = ", "through = ", "grading = " })
  check.equal(all "x = sg.body{ patch = sg.shapes.rectangle{ w", { "width = " })
  check.equal(all "sg.cheapest(study, { at", { "at_most = " })
  check.equal(all "patch:refine{ ele", { "elements = " })
  check.equal(all 'sg.picture{ file = "{.png", fi', { "field = ", "fields = " })
  check.equal(all "sg.chart{ f", { "file = " })
  check.equal(all "sg.rigid.plane{ point = {0, 0}, no", { "normal = " })
end)

check.case("values, lists and unknown calls take none", function()
  check.equal(all "sg.body{ patch = pat", { "patch" })
  check.equal(all "sg.rigid.plane{ point = { nor", {})
  check.equal(all "{ mate", {})
  check.equal(all "sg.body{ order = 'N2' } mate", {})
end)

check.done()
