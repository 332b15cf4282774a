-- A strip that adheres to a rigid plane by van der Waals forces and is peeled by rotating its end: R. A. Sauer, Int. J.
-- Numer. Meth. Engng 87 (2011). Lengths in nm, forces in nN (per nm of depth).

local sg = require("signorini.core").sg
local steps = require "signorini.scene.scenes.steps"

local height, young, poisson = 10, 2, 0.2
local hamaker, r0 = 0.1, 0.4
local free = 10          -- length of the strip beyond the bond
local per_element = 2.5  -- nm

--- Distance at which the traction is zero, T(r) = 0.
local rest = 15 ^ (-1 / 6) * r0

--- Work of adhesion W, the integral of |T| from `rest` to infinity, and the moment of steady peeling of a thin strip at
--- small strains: M k = E I k²/(2(1 − ν²)) + W with M = E I k/(1 − ν²) gives M = √(2 E I W/(1 − ν²)).
local function steady()
  local work = 15 ^ (1 / 3) * hamaker / (16 * math.pi * r0 ^ 2)
  return { work = work, moment = math.sqrt(2 * young * height ^ 3 / 12 * work / (1 - poisson ^ 2)) }
end

return function(o)
  local length, n = o.bonded + free, o.refinement
  local function count(size) return math.max(1, math.floor(size / per_element + 0.5)) * n end
  local strip = sg.body {
    patch = sg.shapes.rectangle { width = length, height = height }, elements = { count(length), count(height) },
    order = o.order, contact = "south", material = sg.neo_hookean { E = young, nu = poisson } }
  -- The plane transmits no shear, and the end is free to move, so one point of the strip is fixed in x.
  local model = sg.model {
    bodies = { strip = strip },
    supports = { edge = { on = strip:face "east", rotate = true },
                 pin = { on = strip:corner "south-west", fix = "x" } },
    contacts = { film = { slave = strip:face "south", adhesion = { hamaker = hamaker, r0 = r0 },
                          master = sg.rigid.plane { point = { 0, -rest }, normal = { 0, 1 } },
                          where = function(X) return X[1] <= o.bonded end } } }
  return model, { { name = "peel", steps = steps(o.angle, 1), edge = o.angle } }, steady()
end
