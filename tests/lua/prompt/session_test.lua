-- A first session at the prompt, on a terminal that util-linux' `script` provides: a scene of two bodies is typed line
-- by line, with completion and help, two mistakes and their cure, a solve and a picture.

require "check"

local folder = check.folder()

--- What the terminal shows when the lines are typed one after the other, each when the program has answered the one
--- before.
local function session(lines)
  for i, line in ipairs(lines) do lines[i] = line .. "\n" end
  lines[#lines + 1] = "\4"
  return check.terminal(("stty cols 300; cd %s && exec %s"):format(folder, arg[-1]), lines,
    ("XDG_STATE_HOME=%s TERM=dumb NO_COLOR=1"):format(folder))
end

check.case("a scene of two bodies, typed", function()
  check.ended({ session {
    "?half_annulus",
    "die = sg.body{ patch = sg.shapes.half_an\t{ inner = 0.3, outer = 0.5, center = {0.75, 1.5} }, elements = {6, 2},",
    [[order = "N2-N2.2", contact = "south", material = sg.neo_hookean{ E = 1000, nu = 0.3 } }]],
    [[slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, hieght = 1 }, elements = {8, 3} }]], -- a misspelt key
    [[slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = {8, 3}, order = "N2-N2.2",]],
    [[contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }]],
    "model = sg.model{ bodies = { die = die, slab = slab },",
    [[supports = { bed = { on = slab:face "south", fix = "xy" },]],
    [[grip = { on = {die:face "west", die:face "east"}, drive = "xy" } },]],
    [[contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100 } } }]],
    [[run = modle:run{ { name = "press", steps = 20, grip = {0, -0.1} } }]], -- a misspelt variable
    'run = model:ru\t{ { name = "press", steps = 20, grip = {0, -0.1} } }',
    "run",
    "run.failed, #run:column 'grip.fy'",
    [[sg.picture{ model = model, field = "uy", file = "die.png" }]],
    "io.open('die.png', 'rb'):read(4):sub(2)",
  } }, 0, "sg.shapes.half_annulus{ inner, outer, center = {0, 0} }", "sg.shapes.half_annulus{ inner = 0.3",
    "..> order = ", "prompt:1: sg.shapes.rectangle: unknown argument 'hieght' (the number 1); did you mean 'height'?",
    "undefined variable 'modle'; did you mean 'model'?", "model:run{ { name", "sg> run\nstage  steps  iterations",
    "\npress     20 ", "false\n20\n", '"PNG"\n')
end)
