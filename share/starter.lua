-- A study as a starting point: a half ring is pressed into a slab and dragged along it. Edit it, then run
--     signorini <this file>             writes pictures and tables to out/starter
--     signorini <this file> help        lists the arguments below
-- At the prompt (start signorini without a script), help() lists topics, and ?sg.body describes one function.
-- Any consistent units can be used: here lengths in mm, forces in N per mm of depth, pressures in N/mm².

local sg = require "signorini"

-- Arguments that can follow the file's name, such as orders=N2,N2-N2.2 steps=20; the defaults determine the types.
local options = sg.arguments{
  orders  = { "N2", "N2-N2.2" },     -- discretizations: degree 2 throughout; degree 4 on the contact faces
  meshes  = { 1, 2 },                -- 1 is coarse; 2 has twice as many elements in each direction
  steps   = 10,                      -- steps of each stage
  out     = "out/starter",
}

-- The scene: bodies, supports that fix or drive them, and contacts.
local function scene(order, mesh)
  local die = sg.body{
    patch    = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {0.75, 1.5} },
    elements = {6 * mesh, mesh},     -- along the arc, across the wall
    order    = order,
    contact  = "south",              -- face that carries the layer: the outer arc
    material = sg.neo_hookean{ E = 1000, nu = 0.3 },
  }
  local slab = sg.body{
    patch    = sg.shapes.rectangle{ width = 3, height = 1 },
    elements = {12 * mesh, 3 * mesh}, order = order, contact = "north",
    material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  return sg.model{
    bodies   = { die = die, slab = slab },
    supports = { bed  = { on = slab:face "south", fix = "xy" },
                 grip = { on = {die:face "west", die:face "east"}, drive = "xy" } },
    contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100,
                               friction = { mu = 0.2, penalty = 100 } } },
  }
end

-- The path: displacements of the grip at the end of each stage.
local stages = {
  { name = "press", steps = options.steps, grip = {0, -0.1} },
  { name = "drag",  steps = options.steps, grip = {0.5, -0.1} },
}

local files = sg.files(options.out)

-- One case: solve it, write its forces and its picture, return the results to compare.
local function solve(case)
  local model = scene(case.order, case.mesh)
  local run = model:run(stages)
  if run.failed then return { failed = true, reason = run.failure } end
  local name = ("%s/%s_mesh%d"):format(options.out, case.order, case.mesh)
  run:csv(name .. ".csv")
  sg.picture{ model = model, field = "uy", file = name .. ".png" }
  local forces = run:column "grip.fx"
  return { force = forces[#forces], pressure = run:column "interface.max_pressure"[#forces],
           wall = run.wall }           -- seconds of the solution, without the picture
end

-- All combinations, in parallel processes. Finished cases are kept in the study's folder: a second call reuses them,
-- unless the scene above has changed.
local study = sg.study{
  name = "starter", folder = options.out .. "/cases", cases = sg.grid{ order = options.orders, mesh = options.meshes },
  run = solve, units = { force = "N/mm", pressure = "N/mm²" },
}
study:execute()
print(study)
study:csv(files "starter.csv")
study:chart{ x = "mesh", y = "force", series = "order", file = files "force.png" }
study:report(files "report.html")      -- a page for the browser, with charts, table and this script
files:report()

return study
