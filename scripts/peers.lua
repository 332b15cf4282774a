-- Other programs on the same scenes, one after the other on one processor: error over processor time.
--
-- Problem: ironing: a half ring (radii 0.3 and 0.5, E = 1000) is pressed by 0.075 into a slab of 3 × 1, E = 1, in 10
--          steps, and dragged by 2 along it in 100, with friction; plane strain, neo-Hookean, nu = 0.3, mu = 0.3. Drag
--          and pressing force are means over 30 to 80 % of the slide; oscillation is the peak-to-peak value without its
--          parabola. hertz: the scene of problems/hertz2d.lua under a given force; the error is the L2 one of the
--          pressure over x/a in [0, 1.2], relative, against Hertz's half-plane, from which this scene itself differs.
-- Source: share/peers/README.md: input files, versions.
-- Units: any consistent units.
-- Expected: GetFEM and this program approach the same limit of the ironing forces, Px = 0.0160 and Py =
--           0.0550, both ± 0.5 %: fine meshes of three programs.
-- Run: signorini peers.lua [problems=ironing,hertz] [programs=signorini,getfem,calculix] [effort=full]
--      [out=out/peers] [page=none]; effort=coarse: one short run of each; page: folder of collection.md, whose tables
--      of other programs are filled. Programs that are not installed are left out, with a message; scripts/peers
--      installs them in Debian.

local sg = require "signorini"
local page = require "page.tables"
local rows = require "formulations.rows"
local hertz2d = require "problems.hertz2d.problem"
local mean_and_oscillation = require("studies.accuracy.force").mean_and_oscillation

local options = sg.arguments{
  problems = { { "ironing", "hertz" }, choices = { "ironing", "hertz" } },
  programs = { { "signorini", "getfem", "calculix" }, choices = { "signorini", "getfem", "calculix" } },
  effort = { "full", choices = { "full", "coarse" } }, out = "out/peers",
  page = "none",
}
local files, full = sg.files(options.out), options.effort == "full"
local limit = { Px = 0.0160, Py = 0.0550, share = 0.005 }
local home = (arg and arg[0] or ""):match "^(.*)/scripts/[^/]*$" or os.getenv "SIGNORINI_HOME" or "."

-- ── This program ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- Own settings of ironing: { formulation, elements of slab and die, penalty }.
local own_ironing = {
  { "gpts", { 16, 4 }, { 12, 2 } }, { "gpts", { 16, 4 }, { 12, 2 }, 100 }, { "gpts", { 24, 6 }, { 18, 2 }, 500 },
  { "reduced-multipliers", { 24, 6 }, { 9, 2 } }, { "equal-multipliers", { 24, 6 }, { 18, 2 } },
  { "equal-multipliers", { 48, 12 }, { 36, 4 } },
}

local function iron(setting, slide)
  local began, formulation, nx, nd, penalty = os.clock(), table.unpack(setting)
  local function body(patch, elements, contact, E)
    return sg.body{ patch = patch, elements = elements, order = "N2-N2.2", contact = contact,
                    material = sg.neo_hookean{ E = E, nu = 0.3 } }
  end
  local die = body(sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 0.5, 1.5 } }, nd, "south", 1000)
  local slab = body(sg.shapes.rectangle{ width = 3, height = 1 }, nx, "north", 1)
  local model = sg.model{
    bodies = { die = die, slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" },
                 grip = { on = { die:face "west", die:face "east" }, drive = "xy" } },
    contacts = { touch = rows.contact(rows[formulation], { slave = die:face "south", master = slab:face "north",
      penalty = penalty, friction = { mu = 0.3, penalty = penalty } }, penalty) } }
  local run = model:run({ { name = "press", steps = 10, grip = { 0, -0.075 } },
                          { name = "slide", steps = slide, grip = { 2 * slide / 100, -0.075 } } }, { verbose = false })
  if run.failed then error(run.failure, 0) end
  local spent, forces = os.clock() - began, { {}, {} }
  for k, name in ipairs { "touch.fx", "touch.fy" } do
    local column = run:column(name)
    for step = 10 + slide * 3 // 10 + 1, 10 + slide * 8 // 10 do
      forces[k][#forces[k] + 1] = math.abs(column[step])
    end
  end
  local Px, ox = mean_and_oscillation(forces[1])
  local Py, oy = mean_and_oscillation(forces[2])
  local name = ("%s %d×%d/%d×%d%s"):format(formulation, nx[1], nx[2], nd[1], nd[2],
                                         penalty and (" penalty %g"):format(penalty) or "")
  return { name = name, unknowns = model:cost().unknowns, iterations = run.iterations, time = spent,
           Px = Px, Py = Py, ox = 100 * ox / Px, oy = 100 * oy / Py }
end

--- Own settings of Hertz: { formulation, mesh }.
local own_hertz = { { "gpts", "m1" }, { "gpts", "m2" }, { "gpts", "m3" }, { "gpts", "m4" },
                    { "equal-multipliers", "m1" }, { "equal-multipliers", "m2" }, { "equal-multipliers", "m3" },
                    { "equal-multipliers", "m4" } }

local function press(setting)
  local began, formulation, mesh = os.clock(), table.unpack(setting)
  local model, stage = hertz2d.scene{ order = "N2-N2.2", mesh = mesh, load = "force", thickness_degree = 2,
                                      formulation = rows[formulation] }
  stage.steps = 1
  local run = model:run({ stage }, { verbose = false })
  if run.failed then error(run.failure, 0) end
  local spent, profile = os.clock() - began, model:profile "ground"
  local a, p0 = hertz2d.hertz(2 * hertz2d.half_load)
  local points = {}
  for i, x in ipairs(profile.x) do points[i] = { x, profile.pressure[i] } end
  table.sort(points, function(one, other) return one[1] < other[1] end)
  local k, wrong, all, peak = 1, 0, 0, 0
  for i = 0, 3999 do
    local xi = 1.2 * i / 3999
    while k < #points - 1 and points[k + 1][1] < xi * a do k = k + 1 end
    local from, to = points[k], points[k + 1]
    local t = math.max(0, (xi * a - from[1]) / (to[1] - from[1]))
    local p, exact = (from[2] + t * (to[2] - from[2])) / p0, math.sqrt(math.max(0, 1 - xi ^ 2))
    wrong, all, peak = wrong + (p - exact) ^ 2, all + exact ^ 2, math.max(peak, p)
  end
  return { name = formulation .. " " .. mesh, unknowns = model:cost().unknowns, iterations = run.iterations,
           time = spent, error = math.sqrt(wrong / all), peak = peak - 1 }
end

-- ── Other programs ───────────────────────────────────────────────────────────────────────────────────────────────────

local python = "/usr/bin/python3.11"
local peers = {
  getfem = { check = python .. " -c 'import getfem'", ironing = { { "24" }, { "32" }, { "48" } },
             hertz = { { "0" }, { "1" }, { "2" }, { "3" } } },
  calculix = { check = "command -v ccx && " .. python .. " -c 'import numpy'", ironing = {},
               hertz = { { "0" }, { "1" }, { "2" }, { "3" } } }, -- with the best of its elements and contacts
}
local script_of = { ironing = "ironing2d.py", hertz = "hertz.py" }
local fields = { ironing = { "Px", "Py", "ox", "oy" }, hertz = { "error", "peak" } }

local function shell(command)
  local pipe = assert(io.popen(command))
  local output = pipe:read "a"
  return output, (pipe:close())
end

local function installed(program)
  local _, ok = shell(("{ %s; } >/dev/null 2>&1"):format(peers[program].check))
  if not ok then print(program .. " is not installed and is left out; scripts/peers installs it in Debian.") end
  return ok
end

--- Runs an input file in the output folder; its line RESULT as a table. An installed program has share/peers in peers.
local function ask(program, problem, words)
  local file = ("%s/share/peers/%s/%s"):format(home, program, script_of[problem])
  local known = io.open(file)
  if known then known:close() else file = ("%s/peers/%s/%s"):format(home, program, script_of[problem]) end
  local output = shell(("F=$(realpath '%s') && cd '%s' && OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 %s \"$F\" %s "
    .. "2>/dev/null | grep ^RESULT"):format(file, options.out, python, table.concat(words, " ")))
  local found = {}
  for word in output:gmatch "%S+" do found[#found + 1] = word end
  if not found[1] then
    print(("%s, %s, %s: no result"):format(program, problem, table.concat(words, " ")))
    return nil
  end
  local result = { name = found[2], unknowns = tonumber(found[3]), iterations = tonumber(found[4]),
                   time = tonumber(found[5]) }
  for i, field in ipairs(fields[problem]) do result[field] = tonumber(found[5 + i]) end
  return result
end

-- ── Comparison ───────────────────────────────────────────────────────────────────────────────────────────────────────

local all = {}
for _, program in ipairs(options.programs) do
  if program == "signorini" or installed(program) then
    for _, problem in ipairs(options.problems) do
      local settings = program ~= "signorini" and peers[program][problem]
        or problem == "ironing" and own_ironing or own_hertz
      for i = 1, full and #settings or math.min(1, #settings) do
        local result = program ~= "signorini" and ask(program, problem, settings[i])
          or problem == "ironing" and iron(settings[i], full and 100 or 10) or press(settings[i])
        if result then
          result.program, result.problem = program, problem
          if problem == "ironing" then
            result.error = math.max(math.abs(result.Px / limit.Px - 1), math.abs(result.Py / limit.Py - 1))
          end
          all[#all + 1] = result
        end
      end
    end
  end
end

local columns = { ironing = { "program", "name", "unknowns", "iterations", "time", "Px", "Py", "ox", "oy", "error" },
                  hertz = { "program", "name", "unknowns", "iterations", "time", "error", "peak" } }
local first = { "program", "formulation, mesh", "unknowns", "iterations", "time (s)" }
local heads = { ironing = { "Px", "Py", "oscillation of Px (%)", "of Py (%)", "error (%)" },
                hertz = { "error (%)", "peak (%)" } }
for problem, list in pairs(heads) do heads[problem] = table.move(list, 1, #list, 6, table.move(first, 1, 5, 1, {})) end
local tables = {}
for _, problem in ipairs(options.problems) do
  local list, curves, by_label = {}, {}, {}
  for _, result in ipairs(all) do
    if result.problem == problem then
      local row, label = {}, result.program
      for k, name in ipairs(columns[problem]) do
        row[k] = (name == "error" or name == "peak") and 100 * result[name] or result[name]
      end
      list[#list + 1] = row
      if result.program == "signorini" then label = ("%s %s"):format(label, result.name:match "%S+") end
      local curve = by_label[label]
      if not curve then
        curve = { x = {}, y = {}, label = label, markers = true, line = result.program ~= "signorini" }
        by_label[label], curves[#curves + 1] = curve, curve
      end
      curve.x[#curve.x + 1], curve.y[#curve.y + 1] = result.time, 100 * result.error
    end
  end
  local printed = { columns = columns[problem], rows = list,
    formats = { time = "%.2f", Px = "%.5f", Py = "%.5f", ox = "%.2f", oy = "%.2f", error = "%.2f", peak = "%+.2f" } }
  print(sg.table(printed))
  tables["peers_" .. problem] = page.pick(printed, { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 }, heads[problem])
  sg.csv.write(files(problem .. ".csv"), { columns = columns[problem], rows = list })
  curves.file, curves.log, curves.xlabel = files(problem .. ".png"), "xy", "processor time (s)"
  curves.title = problem == "ironing" and "Ironing: larger error of drag and pressing force"
    or "Hertz: error of the pressure"
  curves.ylabel = problem == "ironing" and "deviation from the limit (%)" or "L2 error against the half-plane (%)"
  if problem == "ironing" then curves.hlines = { { 100 * limit.share, "uncertainty of the limit" } } end
  sg.chart(curves)
  if options.page ~= "none" then
    curves.file = ("%s/peers_%s.png"):format(options.page, problem)
    sg.chart(curves)
  end
end
page.fill(options, "collection", "peers", tables)
files:report()

return { results = all }
