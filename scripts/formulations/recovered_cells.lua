-- Convergence maps by formulation: cells that fail with Gauss points and converge with others, and the other way round.
--
-- Problem: the convergence maps of stability/: deep ironing (order and step), ironing back and forth (friction and
--          step), Hertz over the penalty, first touch of an unconstrained ring on a slab (gap and load). Each
--          formulation is compared with Gauss points, both with plain Newton, cell by cell.
--
--          outcome with Gauss points:  x . x      another formulation:  x x .    recovered 1, lost 1
--                                      x x .                            x x .
-- Source: the scripts of stability/ and theirs.
-- Units: cells.
-- Expected: with a high penalty in Hertz's contact mortar recovers all cells that Gauss points lose. Elsewhere each
--           formulation recovers some cells and loses others. The default controls converge with each formulation in
--           nearly all cells.
-- Run: signorini -q formulations/recovered_cells.lua
--      [maps=deep_ironing,friction_steps,penalty_hertz,first_touch] [formulations=…] [coarse=no] [jobs=2]
--      [out=out/formulations/recovered_cells]; coarse=yes: few cells of each map. Maps are written to `out`, with a
--      picture of each next to that of Gauss points, and a second call continues with their cells.

local sg = require "signorini"
local formulations = require "formulations.rows"

local names = { "deep_ironing", "friction_steps", "penalty_hertz", "first_touch" }
local others = formulations.where(function(row) return row.name ~= "gpts" end)
local options = sg.arguments{
  maps = { names, choices = names }, formulations = { others, choices = others }, coarse = false,
  jobs = { 2, at_least = 1 }, out = "out/formulations/recovered_cells",
}

--- Arguments of the scripts: those of all cells, and of a few.
local words = {
  deep_ironing = { { "points=p+1,3(p+1)", "orders=N2,N4,N2-N2.2", "coarser=2,4,8,16", "places=none" },
                   { "points=p+1", "orders=N2", "coarser=4,16", "places=none" } },
  friction_steps = { { "orders=N2,N2-N2.2", "coarser=2,4,8,16" }, { "orders=N2", "coarser=8,16", "friction=0,0.4" } },
  penalty_hertz = { { "orders=N2,N4,N2-N2.2" }, { "orders=N2-N2.2", "mesh=m2", "penalties=1e4,1e6" } },
  first_touch = { { "under=slab" }, { "under=slab", "friction=0", "gaps=-1e-3,1e-3", "loads=1e-3" } },
}

--- The list of maps { plain, robust } of a script with a formulation, in a fixed order.
local function maps_of(name, formulation)
  local script = assert(loadfile(assert(package.searchpath("stability." .. name, package.path))))
  local arguments = table.move(words[name][options.coarse and 2 or 1], 1, 4, 4, {
    "formulation=" .. formulation, ("jobs=%d"):format(options.jobs),
    ("out=%s/%s_%s"):format(options.out, name, formulation) })
  arguments[#arguments + 1] = "keep=yes"
  local maps = script(table.unpack(arguments)).maps
  if maps.plain then return { maps } end
  local keys, list = {}, {}
  for key in pairs(maps) do keys[#keys + 1] = key end
  table.sort(keys)
  for i, key in ipairs(keys) do list[i] = maps[key] end
  return list
end

local files = sg.files(options.out)

--- A row: cells, cells that converge with Gauss points and with a formulation, recovered, lost, and with all controls.
--- Draws the maps of both.
local function compare(name, points, formulation)
  local row = { map = name, formulation = formulation, cells = 0, gpts = 0, converged = 0, recovered = 0, lost = 0,
                controls = 0 }
  for i, pair in ipairs(maps_of(name, formulation)) do
    local comparison = points[i].plain:compare(pair.plain)
    points[i].plain:picture{
      other = pair.plain, titles = { formulations.gpts.label, formulations[formulation].label },
      title = points[i].plain.name .. ", plain Newton", file = files(("%s_%d_%s.png"):format(name, i, formulation)) }
    row.cells, row.gpts = row.cells + #pair.plain.cells, row.gpts + points[i].plain:converged()
    row.converged, row.controls = row.converged + pair.plain:converged(), row.controls + pair.robust:converged()
    row.recovered, row.lost = row.recovered + #comparison.recovered, row.lost + #comparison.lost
  end
  return row
end

local found, rows = {}, {}
for _, name in ipairs(options.maps) do
  local points = maps_of(name, "gpts")
  for _, formulation in ipairs(options.formulations) do
    if not (name == "penalty_hertz" and formulations[formulation].two_faces) then -- its master is a plane
      local row = compare(name, points, formulation)
      found[#found + 1], found[name .. " " .. formulation] = row, row
      rows[#rows + 1] = { name, formulations[formulation].label, row.cells, row.gpts, row.converged, row.recovered,
                          row.lost, row.controls }
    end
  end
end
local columns = { "map", "formulation", "cells", "GPTS", "converged", "recovered", "lost", "with controls" }
print "\nCells that converge with plain Newton, compared with Gauss points, and with the default controls"
print(sg.table{ columns = columns, rows = rows })
sg.csv.write(files "cells.csv", { columns = columns, rows = rows })
files:report()

return { rows = found, files = files }
