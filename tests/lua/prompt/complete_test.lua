-- Completion at the prompt: names, methods, keywords, named arguments.

require "check"
local complete = require "signorini.prompt.complete"

sg = require "signorini" -- as at the prompt
help = sg.help

--- All completions of what follows the last blank, brace or comma of a text, or behind its last quotation mark
--- where their number is odd.
local function all(text)
  local before, word = text:match "^(.-)([%w_.:/]*)$"
  if select(2, text:gsub('"', "")) % 2 == 1 then before, word = text:match '^(.*")([^"]*)$' end
  return complete(word, before)
end

check.case("names of tables and methods", function()
  check.equal(all "sg.shapes.rec", { "sg.shapes.rectangle" })
  check.equal(all "x = whi", { "while" })
  patch = sg.shapes.rectangle { width = 1, height = 1 }
  check.equal(all "patch:de", { "patch:degrees", "patch:derivatives" })
  check.equal(all "nothing.at.all", {})
  check.equal(all "2/sg.shapes.rec", { "2/sg.shapes.rectangle" })
end)

check.case("help's words come in one list whose work does not grow with their number squared", function()
  local function work(text)
    local instructions = 0
    debug.sethook(function() instructions = instructions + 100 end, "", 100)
    local list = all(text)
    debug.sethook()
    return instructions, #list
  end
  work 'help "' -- loads what it needs
  local instructions, count = work 'help "'
  check.equal(count > 100, true)
  check.at_most("instructions for each word", instructions / count, 1000)
end)

check.case("methods of Lua's objects, without those for the library only", function()
  run = setmetatable({}, require("signorini.run.run_result"))
  check.equal(all "run:co", { "run:column", "run:columns" })
  check.equal(all "run:record", {})
  check.equal(all "run:", { "run:attempts", "run:budget", "run:column", "run:columns", "run:csv", "run:error",
    "run:hdf5", "run:report", "run:residuals", "run:states" })
end)

check.case("named arguments where they are possible, without those given", function()
  check.equal(all "sg.body{ m", { "material = " })
  check.equal(all "sg.body{ patch = sg.shapes.block{ size = {1, 2, 3} },\n  elements = {1, 1}, ",
    { "order = ", "contact = ", "layer = ", "layer_knots = ", "material = ", "thickness_degree = ", "volumetric = ",
      "density = ", "grading = " })
  check.equal(all "x = sg.body{ patch = sg.shapes.rectangle{ w", { "width = " })
  check.equal(all "sg.cheapest(study, { at", { "at_most = " })
  check.equal(all "patch:refine{ ele", { "elements = " })
  check.equal(all 'sg.picture{ file = "{.png", fi', { "fields = ", "field = " })
  check.equal(all "sg.chart{ f", { "file = " })
  check.equal(all "sg.rigid.plane{ point = {0, 0}, no", { "normal = " })
end)

slab = scenes.body{ size = {3, 1}, elements = { 1, 1 }, order = "N1", contact = "south" }
local ground = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } }
model = scenes.model{ bodies = { slab = slab }, supports = { grip = { on = "north", drive = "xy" } },
  contacts = { ground = { slave = "south", master = ground, penalty = 1 } } }

check.case("named arguments of nested tables, under any names", function()
  check.equal(all "sg.model{ contacts = { c = { friction = { m", { "mu = " })
  check.equal(all 'sg.model{ bodies = {}, supports = { interface = { on = slab:face "south", ',
    { "fix = ", "drive = ", "free = ", "rotate = ", "center = ", "angle = ", "spring = ", "shape = ", "symmetry = ",
      "traction = ", "pressure = ", "follower = ", "force = ", "moment = ", "factor = " })
  check.equal(all "sg.model{ loads = { a = {}, b = {\n",
    { "on = ", "traction = ", "pressure = ", "follower = ", "force = ", "moment = ", "factor = " })
  check.equal(all "model:run(stages, { newton = { l", { "line_search = " })
  check.equal(all "model:run(stages, { step = { min = 1/8, m", { "max = " })
  check.equal(all "model:run(stages, { checkpoint = { ", { "file = ", "every = ", "durable = " })
  check.equal(all "x = model:run(stages, sg.robust{ step = { gr", { "growth = " })
  check.equal(all 'sg.chart{ file = "a.png", { y = {1, 2}, ma', { "markers = ", "marker = ", "marks = " })
  check.equal(all "sg.picture{ marks = { { x = {0, 0}, ", { "text = " })
  check.equal(all "sg.picture{ camera = { ", { "from = ", "up = " })
  check.equal(all "sg.chart{ inset = { p", { "place = " })
end)

check.case("arguments of a stage, and the supports that the model moves", function()
  check.equal(all "model:run{ { ", { "name = ", "steps = ", "duration = ", "growth = ", "contacts = ", "grip = " })
  check.equal(all "run = model:run({ { steps = 1, grip = {0, 0} }, { name = 'slide', ",
    { "steps = ", "duration = ", "growth = ", "contacts = ", "grip = " })
end)

check.case("strings of choices, and names of an object's parts", function()
  check.equal(all 'sg.body{ patch = p, order = "N2-', { "N2-N2.1", "N2-N2.2", "N2-N4" })
  check.equal(all 'sg.model{ supports = { bed = { on = slab:face "', { "west", "east", "south", "north" })
  check.equal(all 'sg.model{ supports = { bed = { on = slab:face "south", fix = "x', { "x", "xy", "xz", "xyz" })
  check.equal(all 'model:run(stages, { linear = "re', { "reuse" })
  check.equal(all 'sg.picture{ model = model, colormap = "v', { "viridis" })
  check.equal(all 'sg.picture{ model = model, fields = {"ux", "von', { "von_mises" })
  check.equal(all 'slab:corner("north', { "north-west", "north-east" })
  check.equal(all 'model:profile "', { "ground" })
  check.equal(all 'model:reaction "g', { "grip" })
  study = sg.study { name = "s", cases = sg.grid { order = { "N1" } }, run = function() return {} end }
  check.equal(all 'study:by "', { "order", "wall", "failed", "outcome", "reason" })
  help = sg.help
  check.equal(all 'help "patch:ref', { "patch:refine" })
  check.equal(all 'help "ord', { "orders" })
  study.rows = { { order = "N1", wall = 1 }, { order = "N2", wall = 1 }, { order = "N1", wall = 2 } }
  check.equal(all 'study:where{ ', { "order = ", "wall = ", "failed = ", "outcome = ", "reason = " })
  check.equal(all 'study:row{ wall = 1, order = "', { "N1", "N2" })
  check.equal(all 'sg.cheapest(study, { error = "or', { "order" })
  for _, free in ipairs { 'sg.picture{ file = "', 'io.open("', 'x = "', 'nothing "', 'slab:edge "' } do
    check.equal(all(free), {})
  end
end)

check.case("of a run and a study only the documented fields", function()
  run = model:run { { name = "hold", steps = 1, grip = { 0, 0 } } }
  check.equal(all "run:", { "run:attempts", "run:budget", "run:column", "run:columns", "run:csv", "run:error",
    "run:hdf5", "run:report", "run:residuals", "run:states" })
  check.equal(all "run.re", { "run.reason", "run.report", "run.residuals" })
  for _, hidden in ipairs { "run.__", "run.rows", "run.ex", "run.wary", "run.stored", "study:run", "study:row_of" } do
    check.equal({ hidden, all(hidden) }, { hidden, {} })
  end
  check.equal(all "study.f", { "study.folder" })
  check.equal(all "study:ro", { "study:row" })
  check.equal(all "study.ro", { "study.row", "study.rows" })
  check.equal(all "run.timings.b", { "run.timings.bulk" })
end)

check.case("values, lists and unknown calls take none", function()
  check.equal(all "sg.body{ patch = pat", { "patch" })
  check.equal(all "sg.rigid.plane{ point = { nor", {})
  check.equal(all "{ mate", {})
  check.equal(all "sg.body{ order = 'N2' } mate", {})
end)
