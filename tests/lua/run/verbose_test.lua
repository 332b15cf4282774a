-- verbose = true: what a run and the low-level methods print of each Newton iteration.

require "check"

--- A block that is pressed into a slab; with friction, so that contact points have states.
local function scene(enforcement)
  return scenes.model{ bodies = { slab = { size = {3, 1}, elements = {6, 2}, contact = "north" },
      block = { corner = {1, 1}, contact = "south", E = 10 } },
    supports = { bed = { on = "slab.south", fix = "xy" }, grip = { on = "block.north", drive = "xy" } },
    contacts = { c = { slave = "block.south", master = "slab.north", penalty = 20,
        enforcement = enforcement or "penalty", friction = { mu = 0.3, penalty = 20 } } } }
end

local path = { { name = "press", steps = 2, grip = {0, -0.1} }, { name = "slide", steps = 1, grip = {0.1, -0.1} } }

--- What a function prints, a list of lines, and its result.
local function printed(body)
  local lines, plain = {}, print
  print = function(text) lines[#lines + 1] = text end
  local result = body()
  print = plain
  return lines, result
end

--- The lines of iterations, each { iteration, residual, relative, energy, active, slipping, changed, remarks }.
local function iterations(lines)
  local found = {}
  for _, line in ipairs(lines) do
    local words = {}
    for word in line:gmatch "%S+" do words[#words + 1] = word end
    if math.tointeger(tonumber(words[1])) then found[#found + 1] = words end
  end
  return found
end

check.case("a run prints title and header per attempt and a line per iteration, results do not change", function()
  local silent, plain = printed(function() return scene():run(path) end)
  check.equal(#silent, 0)
  local lines, run = printed(function() return scene():run(path, { verbose = true }) end)
  check.equal(run:column "grip.fy", plain:column "grip.fy")
  check.equal(run:column "iterations", plain:column "iterations")
  check.equal(lines[1], "press, step 1 of 2: grip.uy = -0.05")
  check.equal(lines[2], "iteration   residual   relative   |f·Δu|   active  slip  changed")
  check.holds(table.concat(lines, "\n"), "\npress, step 2 of 2: grip.uy = -0.1\n",
    "\nslide, step 1 of 1: grip.ux = 0.1\n")
  local residuals = {}
  for step = 1, run.steps do
    for _, attempt in ipairs(run:attempts(step)) do
      for _, residual in ipairs(attempt.residuals) do residuals[#residuals + 1] = ("%.3e"):format(residual) end
    end
  end
  local shown = {}
  for i, line in ipairs(iterations(lines)) do shown[i] = line[2] end
  check.equal(shown, residuals)
end)

check.case("the last line of a step is below the tolerance, has the active points, and says converged", function()
  local model = scene()
  model:set_target("grip", {0, -0.1})
  local lines, result = printed(function() return model:solve_step{ verbose = true, tolerance = 1e-9 } end)
  local all = iterations(lines)
  local last = all[#all]
  check.equal({ tonumber(last[1]), last[#last] }, { result.iterations, "converged" })
  check.at_most("relative residual", tonumber(last[3]), 1e-9)
  check.equal(tonumber(all[#all - 1][3]) > 1e-9, true)
  check.equal(tonumber(last[4]), model:contact_resultant "c".active)
  check.equal(tonumber(all[1][4]), result.energies[1] and tonumber(("%.2e"):format(result.energies[1])))
  check.holds(lines[2], ", factored")
  check.equal(select(2, table.concat(lines, "\n"):gsub("residual", "")), 1)
  check.equal(tonumber(all[1][7]) > 0, true) -- points have come into contact
end)

check.case("failed attempts tell the reason, further ones their fallback or part of the step", function()
  local far = { { name = "press", steps = 1, grip = {0, -0.4} } }
  local lines = table.concat((printed(function()
    return scene():run(far, { verbose = true, newton = { iterations = 3 }, step = { adaptive = true, min = 0.5 } })
  end)), "\n")
  check.holds(lines, "ends: iterations\n", "press, step 1 of 1, from 0 to 0.5: grip.uy = -0.2\n",
    "press, step 1 of 1, from 0 to 0.5, fallback: line search: grip.uy = -0.2\n", "factor 1\n")
end)

check.case("iterate prints one line per call, solve_arc those of its increment", function()
  local model = scene()
  model:run(path)
  model:set_target("grip", {0.1, -0.11})
  local lines = printed(function()
    repeat local now = model:iterate{ verbose = true } until now.reason ~= "iterating"
  end)
  check.equal(select(2, table.concat(lines, "\n"):gsub("residual", "")), 1)
  check.equal(#iterations(lines), #lines - 1)
  model:rollback()
  model:set_target("grip", {0.1, -0.11})
  local arc, result = printed(function() return model:solve_arc{ length = 0.001, verbose = true } end)
  check.equal(#iterations(arc), #result.residuals)
  check.holds(arc[#arc], "converged")
end)

check.case("arc length and the search for a turning point have titles", function()
  local model = scene()
  model:run(path)
  local lines = table.concat((printed(function()
    return model:run({ { name = "on", steps = 1, grip = {0.12, -0.11} } },
      { verbose = true, arc_length = true, newton = { iterations = 1 } })
  end)), "\n")
  check.holds(lines, "on, step 1 of 1: grip.ux = 0.12, grip.uy = -0.11\n", "ends: iterations\non, step 1 of 1, from 0, "
    .. "arc length ")
  check.holds(table.concat((printed(function()
    return model:run({ { name = "on", steps = 1, grip = {0.2, -0.12} } },
      sg.plain{ verbose = true, newton = { iterations = 1 } })
  end)), "\n"), ", step 1 of 1, from 0, search for a turning point: arc length ")
end)

check.case("on_iteration sees the line of its iteration already in the output", function()
  local folder = check.folder()
  core.write_file(folder .. "/study.lua", [[
local sg = require "signorini"
local b = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {1, 1}, order = "N1",
                   material = sg.neo_hookean{ E = 1, nu = 0.3 } }
local m = sg.model{ bodies = { b = b }, supports = { bed = { on = b:face "south", fix = "xy" },
                                                     grip = { on = b:face "north", drive = "xy" } } }
m:run({ { steps = 1, grip = {0, 0.1} } }, { verbose = true, on_iteration = function(info)
  local text = io.open(arg[1]):read "a"
  io.stderr:write(text:find(("%.3e"):format(info.residual), 1, true) and "seen\n" or "not seen\n")
end })]])
  local output = check.shell(("%s -q %s/study.lua %s/out >%s/out"):format(arg[-1], folder, folder, folder))
  check.equal(output:find "not seen", nil)
  check.holds(output, "seen\nseen\n")
  check.holds(core.read_file(folder .. "/out"), "iteration   residual   relative   |f·Δu|\n")
end)
